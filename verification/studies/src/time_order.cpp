#include "stickslip/studies/time_order.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "stickslip/data/problem.hpp"
#include "stickslip/solver/stick_slip_integrator.hpp"

namespace stickslip::studies {

namespace {

using Complex = std::complex<double>;

// Two masses in a chain from a fixed point, damped, m = diag(2, 1) kg; load on both; excitation at 3 rad/s.
// The wall of the held contact moves by 0.1 sin(3 t) m.
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

solver::ContactSystem contact_system(const Chain& chain) {
  return {.mass = sparse(chain.mass),
          .damping = sparse(chain.damping),
          .stick_stiffness = sparse(chain.stiffness),
          .slip_stiffness = sparse(chain.stiffness),
          .load_shape = chain.load,
          .load_history = [](double t) { return std::sin(omega * t); },
          .contact = 1,
          .wall = {
              .displacement = [](double t) { return wall_amplitude * std::sin(omega * t); },
              .velocity = [](double t) { return wall_amplitude * omega * std::cos(omega * t); },
              .acceleration = [](double t) { return -wall_amplitude * omega * omega * std::sin(omega * t); }},
          .normal_force = 0.0,
          .friction = data::FrictionLaw({})};
}

// Complex amplitudes: a quantity is the imaginary part of amplitude * exp(i omega t).
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

double at_time(Complex amplitude, double t) { return (amplitude * std::polar(1.0, omega * t)).imag(); }

struct Errors {
  double displacement{}, velocity{}, reaction{};
};

// Starts on the steady state and compares over the third period, when the method's own start has decayed.
Errors errors_over_a_period(const Chain& chain, bool held, double spectral_radius, int steps_per_period) {
  const double h = 2.0 * std::numbers::pi / omega / steps_per_period;
  solver::StickSlipIntegrator integrator(contact_system(chain),
                                         {.time_step = h, .spectral_radius = spectral_radius, .glued = held});
  const ExactSteadyState exact = held ? held_steady_state(chain) : free_steady_state(chain);
  const Eigen::VectorXd displacement = exact.displacement.imag();
  const Eigen::VectorXd velocity = (Complex(0.0, omega) * exact.displacement).imag();
  if (held) {
    integrator.start_stuck(displacement, velocity);
  } else {
    integrator.start_slipping(displacement, velocity);
  }
  Errors errors;
  for (int n = 1; n <= 3 * steps_per_period; ++n) {
    integrator.step();
    if (n < 2 * steps_per_period) continue;
    const double t = integrator.time();
    for (Eigen::Index i = 0; i < 2; ++i) {
      const Complex amplitude = exact.displacement[i];
      errors.displacement =
          std::max(errors.displacement, std::abs(integrator.displacement()[i] - at_time(amplitude, t)));
      errors.velocity = std::max(
          errors.velocity, std::abs(integrator.velocity()[i] - at_time(Complex(0.0, omega) * amplitude, t)));
    }
    errors.reaction =
        std::max(errors.reaction, std::abs(integrator.friction_force() - at_time(exact.reaction, t)));
  }
  return errors;
}

}  // namespace

TimeOrderStudy time_order_study(double spectral_radius, const std::vector<int>& steps_per_period) {
  const Chain chain;
  TimeOrderStudy study;
  study.spectral_radius = spectral_radius;
  for (const int steps : steps_per_period) {
    study.time_step.push_back(2.0 * std::numbers::pi / omega / steps);
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

}  // namespace stickslip::studies
