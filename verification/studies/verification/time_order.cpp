// SPDX-License-Identifier: MIT
#include "studies/verification/time_order.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <complex>
#include <numbers>

#include "stickslip/solver/stick_slip_integrator.hpp"
#include "studies/common/discretisation.hpp"
#include "studies/history/method.hpp"
#include "studies/verification/finite_element_contact_model.hpp"

namespace stickslip::studies {

namespace {

using Complex = std::complex<double>;

// A damped chain of two masses attached to a fixed point, with a harmonic load on both at 3 rad/s. The wall
// of the held contact moves by 0.1 sin(3 t) m.
constexpr double omega = 3.0;
constexpr double wall_amplitude = 0.1;

struct Chain {
  Eigen::Matrix2d mass{{2.0, 0.3}, {0.3, 1.0}};
  Eigen::Matrix2d damping{{0.7, -0.2}, {-0.2, 0.4}};
  Eigen::Matrix2d stiffness{{30.0, -12.0}, {-12.0, 14.0}};
  Eigen::Vector2d load{1.5, -0.8};

  [[nodiscard]] Eigen::Matrix2cd dynamic_stiffness() const {
    return stiffness.cast<Complex>() + Complex(0.0, omega) * damping.cast<Complex>() -
           omega * omega * mass.cast<Complex>();
  }
};

solver::SparseMatrix sparse(const Eigen::Matrix2d& matrix) { return Eigen::MatrixXd(matrix).sparseView(); }

// For a free contact the wall moves ahead of it, so that the sliding velocity never changes sign. The
// integrator would stop at a change of sign.
solver::PrescribedMotion wall_motion(bool held) {
  if (!held)
    return {.displacement = [](double t) { return 100.0 * t; },
            .velocity = [](double) { return 100.0; },
            .acceleration = [](double) { return 0.0; }};
  return {.displacement = [](double t) { return wall_amplitude * std::sin(omega * t); },
          .velocity = [](double t) { return wall_amplitude * omega * std::cos(omega * t); },
          .acceleration = [](double t) { return -wall_amplitude * omega * omega * std::sin(omega * t); }};
}

solver::ContactSystem contact_system(const Chain& chain, bool held) {
  return {.mass = sparse(chain.mass),
          .damping = sparse(chain.damping),
          .stick_stiffness = sparse(chain.stiffness),
          .slip_stiffness = sparse(chain.stiffness),
          .load_shape = chain.load,
          .load_history = [](double t) { return std::sin(omega * t); },
          .contact = 1,
          .wall = wall_motion(held),
          .normal_force = 0.0,
          .friction = data::FrictionLaw({})};
}

// Complex amplitudes: a quantity is the imaginary part of amplitude exp(i ω t).
struct ExactSteadyState {
  Eigen::Vector2cd displacement;
  Complex reaction;
};

ExactSteadyState free_steady_state(const Chain& chain) {
  return {chain.dynamic_stiffness().inverse() * chain.load.cast<Complex>(), 0.0};
}

ExactSteadyState held_steady_state(const Chain& chain) {
  const Eigen::Matrix2cd z = chain.dynamic_stiffness();
  const Complex first = (chain.load[0] - z(0, 1) * wall_amplitude) / z(0, 0);
  return {Eigen::Vector2cd(first, wall_amplitude),
          z(1, 0) * first + z(1, 1) * wall_amplitude - chain.load[1]};
}

// The steady state that generalised-alpha computes for M a + C v + K q = Im[F exp(i ω t)]: amplitudes Q
// and V.
struct Vibration {
  Eigen::VectorXcd displacement, velocity;
};

struct Oscillators {
  Eigen::MatrixXcd mass, damping, stiffness;
  Eigen::VectorXcd load;
};

// The steady state of the method at a finite step (Chung & Hulbert 1993). With E = exp(i ω h), q_n = Q
// E^n, and the same for v and a:
//
//     V (E - 1) = h A (1 - γ + γ E),
//     Q (E - 1) = h V + h² A (1/2 - β + β E).
//
// The balance holds at the α levels, with the load at t_n + (1 - α_f) h.
Vibration stepped(const Oscillators& system, double spectral_radius, double h) {
  const auto [am, af, gamma, beta] = AlphaParameters(spectral_radius);
  const Complex rotation = std::polar(1.0, omega * h);
  const Complex velocity = h * (1.0 - gamma + gamma * rotation) / (rotation - 1.0);
  const Complex displacement = (h * velocity + h * h * (0.5 - beta + beta * rotation)) / (rotation - 1.0);
  const Eigen::MatrixXcd balance =
      (am + (1.0 - am) * rotation) * system.mass +
      (af + (1.0 - af) * rotation) * (velocity * system.damping + displacement * system.stiffness);
  const Eigen::VectorXcd acceleration =
      balance.partialPivLu().solve(std::polar(1.0, omega * h * (1.0 - af)) * system.load);
  return {displacement * acceleration, velocity * acceleration};
}

// The limit of error/h² for h -> 0, from the equations that the method solves up to h⁴
// (discretisation.hpp):
//
//     V = i ω Q (1 + k_1 (ω h)²),
//     i ω M V (1 + k_2 (ω h)²) + C V + K Q = F (1 + k_3 (ω h)²).
Vibration leading_error(const Oscillators& system, double spectral_radius) {
  const AlphaParameters method(spectral_radius);
  const double af = method.alpha_f, d = af - method.alpha_m;
  const double k_1 = 1.0 / 12.0 + d * d / 4.0, k_2 = 1.0 / 12.0 + d * d / 2.0;
  const double k_3 = 0.5 * af * (1.0 - af);
  const Complex rate(0.0, omega);
  const auto dynamic =
      Eigen::MatrixXcd(system.stiffness + rate * system.damping + rate * rate * system.mass).partialPivLu();
  const Eigen::VectorXcd exact = dynamic.solve(system.load);
  const Eigen::VectorXcd displacement =
      omega * omega *
      dynamic.solve(k_3 * system.load - k_1 * rate * system.damping * exact -
                    (k_1 + k_2) * rate * rate * system.mass * exact);
  return {displacement, rate * (displacement + k_1 * omega * omega * exact)};
}

// The free chain has both masses as unknowns. The held chain has one unknown: the deviation of the first mass
// from its static shape under the motion of the wall. The inertia and damping of that shape are part of the
// load.
Oscillators free_oscillators(const Chain& chain) {
  return {chain.mass, chain.damping, chain.stiffness, chain.load};
}

Oscillators held_oscillator(const Chain& chain) {
  const Eigen::Vector2cd wall(-chain.stiffness(0, 1) / chain.stiffness(0, 0) * wall_amplitude,
                              wall_amplitude);
  const Eigen::Vector2cd load =
      chain.load + (omega * omega * chain.mass - Complex(0.0, omega) * chain.damping) * wall;
  return {chain.mass.topLeftCorner(1, 1), chain.damping.topLeftCorner(1, 1),
          chain.stiffness.topLeftCorner(1, 1), load.head(1)};
}

// Error of the reaction. The acceleration follows from the balance of the first mass with its q and v.
double reaction_error(const Chain& chain, Complex displacement, Complex velocity) {
  const Complex force = chain.damping(0, 0) * velocity + chain.stiffness(0, 0) * displacement;
  return std::abs(chain.damping(1, 0) * velocity + chain.stiffness(1, 0) * displacement -
                  chain.mass(1, 0) / chain.mass(0, 0) * force);
}

double at_time(Complex amplitude, double t) { return (amplitude * std::polar(1.0, omega * t)).imag(); }

struct Errors {
  double displacement{}, velocity{}, reaction{};
};

// Free vibrations decay at least as fast as exp(-0.0955 t); 0.0955 is half the smallest eigenvalue of M⁻¹ C.
constexpr int periods_of_decay = 80;

// The run starts on the exact steady state. The errors are taken over one period, after the initial
// difference from the steady state of the method has decayed by the factor e¹⁶.
Errors errors_over_a_period(const Chain& chain, bool held, double spectral_radius, int steps_per_period) {
  const double h = 2.0 * std::numbers::pi / omega / steps_per_period;
  solver::ContactSystem system = contact_system(chain, held);
  if (held) system.normal_force = solver::bonding_force;
  solver::StickSlipIntegrator integrator(system, {.time_step = h, .spectral_radius = spectral_radius});
  const ExactSteadyState exact = held ? held_steady_state(chain) : free_steady_state(chain);
  const Eigen::VectorXd displacement = exact.displacement.imag();
  const Eigen::VectorXd velocity = (Complex(0.0, omega) * exact.displacement).imag();
  if (held) {
    integrator.start_stuck(displacement, velocity);
  } else {
    integrator.start_slipping(displacement, velocity);
  }
  Errors errors;
  for (int n = 1; n <= (periods_of_decay + 1) * steps_per_period; ++n) {
    integrator.step();
    if (n <= periods_of_decay * steps_per_period) continue;
    const double t = integrator.time();
    for (Eigen::Index i = 0; i < 2; ++i) {
      const Complex amplitude = exact.displacement[i];
      errors.displacement = largest_or_nan(
          {errors.displacement, std::abs(integrator.displacement()[i] - at_time(amplitude, t))});
      errors.velocity =
          largest_or_nan({errors.velocity,
                          std::abs(integrator.velocity()[i] - at_time(Complex(0.0, omega) * amplitude, t))});
    }
    errors.reaction =
        largest_or_nan({errors.reaction, std::abs(integrator.friction_force() - at_time(exact.reaction, t))});
  }
  return errors;
}

}  // namespace

TimeOrderStudy time_order_study(double spectral_radius, const std::vector<int>& steps_per_period) {
  const Chain chain;
  const Oscillators free_masses = free_oscillators(chain), held_mass = held_oscillator(chain);
  TimeOrderStudy study;
  study.spectral_radius = spectral_radius;
  const Vibration leading = leading_error(free_masses, spectral_radius);
  const Vibration leading_held = leading_error(held_mass, spectral_radius);
  study.displacement_constant = leading.displacement.cwiseAbs().maxCoeff();
  study.velocity_constant = leading.velocity.cwiseAbs().maxCoeff();
  study.reaction_constant = reaction_error(chain, leading_held.displacement[0], leading_held.velocity[0]);
  for (const int steps : steps_per_period) {
    const double h = 2.0 * std::numbers::pi / omega / steps;
    study.time_step.push_back(h);
    const Complex rate(0.0, omega);
    const Vibration of_free = stepped(free_masses, spectral_radius, h);
    const Eigen::VectorXcd exact_free = free_steady_state(chain).displacement;
    study.predicted_displacement_error.push_back((of_free.displacement - exact_free).cwiseAbs().maxCoeff());
    study.predicted_velocity_error.push_back((of_free.velocity - rate * exact_free).cwiseAbs().maxCoeff());
    const Vibration of_held = stepped(held_mass, spectral_radius, h);
    const Complex exact_held =
        held_mass.load[0] /
        (held_mass.stiffness(0, 0) + rate * held_mass.damping(0, 0) + rate * rate * held_mass.mass(0, 0));
    study.predicted_reaction_error.push_back(
        reaction_error(chain, of_held.displacement[0] - exact_held, of_held.velocity[0] - rate * exact_held));
    const Errors free = errors_over_a_period(chain, false, spectral_radius, steps);
    const Errors held = errors_over_a_period(chain, true, spectral_radius, steps);
    study.displacement_error.push_back(free.displacement);
    study.velocity_error.push_back(free.velocity);
    study.reaction_error.push_back(held.reaction);
  }
  study.displacement_order = order_estimate(study.time_step, study.displacement_error);
  study.velocity_order = order_estimate(study.time_step, study.velocity_error);
  study.reaction_order = order_estimate(study.time_step, study.reaction_error);
  return study;
}

EventOrderStudy event_order_study(const data::Case& problem, double duration, int elements,
                                  double spectral_radius, const std::vector<int>& divisors) {
  constexpr double longest_step = 1e-4;
  const History exact = event_driven_history(finite_element_contact_model(problem, elements),
                                             sample_times(duration, longest_step));
  const auto events = onsets_and_captures(exact.events);
  EventOrderStudy study{.spectral_radius = spectral_radius,
                        .elements = elements,
                        .events = static_cast<int>(events.size()),
                        .duration = duration,
                        .time_step = {},
                        .located = {},
                        .at_end_of_step = {}};
  const auto add = [&](EventOrder& order, solver::ContactScheme scheme, int divisor) {
    const History history =
        finite_element_history(refined(problem, elements, longest_step / divisor, duration, spectral_radius),
                               {.every = divisor}, {.scheme = scheme});
    const EventDifference difference =
        largest_difference(onsets_and_captures(history.events), events, events.size());
    order.event_time_error.push_back(difference.time);
    order.event_position_error.push_back(difference.position);
    order.tip_error.push_back(largest_difference(tip_displacements(history), tip_displacements(exact)));
  };
  for (const int divisor : divisors) {
    study.time_step.push_back(longest_step / divisor);
    add(study.located, solver::ContactScheme::located, divisor);
    add(study.at_end_of_step, solver::ContactScheme::end_of_step, divisor);
  }
  for (EventOrder* order : {&study.located, &study.at_end_of_step}) {
    order->event_time_order = order_estimate(study.time_step, order->event_time_error);
    order->event_position_order = order_estimate(study.time_step, order->event_position_error);
    order->tip_order = order_estimate(study.time_step, order->tip_error);
  }
  return study;
}

}  // namespace stickslip::studies
