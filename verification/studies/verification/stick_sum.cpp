// SPDX-License-Identifier: MIT
#include "studies/verification/stick_sum.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/solver/stick_slip_integrator.hpp"
#include "studies/common/bisection.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

namespace {

double square(double x) { return x * x; }

// f_S h + f_a h_tt, or y_S h, for h of unit amplitude.
double driven_part(const StickSum& sum, StickReading reading, double omega) {
  return reading == StickReading::force ? sum.force - square(omega) * sum.force_per_acceleration
                                        : sum.displacement;
}

double weight_of(const StickSum::Mode& mode, StickReading reading) {
  return reading == StickReading::force ? mode.force : mode.displacement;
}

// ∫_0^L U dx from U'''' + p U'' = k U integrated once, with U'(0) = 0 and k = β² betabar².
double shape_integral(const analytic::StickMode& mode, double length, double p) {
  const double k = square(mode.hyperbolic_wave_number() * mode.trigonometric_wave_number());
  return (mode.third_derivative(length) - mode.third_derivative(0.0) + p * mode.slope(length)) / k;
}

std::vector<double> event_times(const std::vector<data::ContactEvent>& events) {
  std::vector<double> times;
  for (const auto& event : events)
    if (event.change == data::ContactChange::onset || event.change == data::ContactChange::capture)
      times.push_back(event.time);
  return times;
}

// The quasi-static shape of the system's own matrices, 1 at the contact.
Eigen::VectorXd quasi_static_shape(const solver::ContactSystem& system) {
  const Eigen::Index c = system.contact;
  Eigen::MatrixXd held(system.stick_stiffness);
  Eigen::VectorXd right_side = -held.col(c);
  held.row(c).setZero();
  held.col(c).setZero();
  held(c, c) = right_side[c] = 1.0;
  return held.ldlt().solve(right_side);
}

// The v in [v_free - reach, v_free + reach] at which v + strength c(v) changes its sign about v_free.
double sliding_velocity(const FrictionRule& law, const data::FrictionLaw& friction, double strength,
                        double free_velocity) {
  const double reach = 2.0 * strength * friction.static_coefficient();
  return bisected(free_velocity - reach, free_velocity + reach,
                  [&](double v) { return v + strength * law.coefficient(friction, v) <= free_velocity; });
}

void add_sample(TipRun& run, Eigen::Index contact, const solver::PrescribedMotion& base, double t,
                const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity, double force) {
  const Eigen::Index middle = std::max<Eigen::Index>(contact / 2 - 1, 0);
  // With an odd number of elements the index is that of a rotation: no node is in the middle.
  const double at_node = middle % 2 == 0 || contact % 2 != 0 ? 1.0 : std::nan("");
  const double h = base.displacement(t), rate = base.velocity(t);
  run.tip_displacement.push_back(h + displacement[contact]);
  run.midspan_displacement.push_back(h + at_node * displacement[middle]);
  run.tip_velocity.push_back(rate + velocity[contact]);
  run.midspan_velocity.push_back(rate + at_node * velocity[middle]);
  run.friction_force.push_back(-force);
}

}  // namespace

StickSum stick_sum(const data::Beam& beam, int modes) {
  const double length = beam.length(), rigidity = beam.youngs_modulus() * beam.second_moment_of_area();
  const double axial_force = beam.axial_force();
  const double fixed = beam.axial_direction() * axial_force, follower = axial_force - fixed;
  const analytic::QuasiStaticShape shape(beam);
  StickSum sum{.force = rigidity * shape.third_derivative(length) + fixed * shape.slope(length),
               .follower_force = follower * shape.slope(length),
               .displacement = 1.0 + shape.value(0.5 * length),
               .modes = {}};
  for (const analytic::StickMode& mode : analytic::stick_modes(beam, modes))
    sum.modes.push_back(
        {.natural_frequency = mode.angular_frequency(),
         .oscillator_frequency = mode.angular_frequency(),
         .participation = mode.participation(),
         .rigid_participation = -shape_integral(mode, length, axial_force / rigidity) / mode.norm_squared(),
         .force = rigidity * mode.third_derivative(length) + fixed * mode.slope(length),
         .follower_force = follower * mode.slope(length),
         .displacement = mode.shape(0.5 * length)});
  return sum;
}

// In the coordinates of the mesh (frame of the base) the tip moves by -h under the load p h_tt: q = S h + sum
// φ_n T_n with S_c = -1 and K_ff S_f + K_fc S_c = 0. The contact row of the slip-state balance gives f_d =
// -f.
StickSum stick_sum(const solver::BeamModel& mesh, const solver::ContactSystem& system,
                   const Eigen::RowVectorXd& force_row) {
  const Eigen::Index size = system.mass.rows(), c = system.contact;
  std::vector<Eigen::Index> others;
  for (Eigen::Index i = 0; i < size; ++i)
    if (i != c) others.push_back(i);
  const Eigen::MatrixXd mass(system.mass), stiffness(system.stick_stiffness), slip(system.slip_stiffness);
  const Eigen::MatrixXd held_mass = mass(others, others), held_stiffness = stiffness(others, others);

  const Eigen::LLT<Eigen::MatrixXd> factors(held_stiffness);
  if (factors.info() != Eigen::Success)
    throw data::FieldError("beam.axial_force", mesh.beam().axial_force(),
                           "below the buckling load of the mesh (N)");
  Eigen::VectorXd shape(size);
  shape[c] = -1.0;
  shape(others) = Eigen::VectorXd(factors.solve(stiffness(others, c)));

  const Eigen::RowVectorXd midspan = mesh.interpolation(0.5 * mesh.beam().length()).transpose();
  const bool from_balance = force_row.size() == 0;
  const Eigen::VectorXd unbalanced = system.load_shape - mass * shape;
  StickSum sum{.force = from_balance ? -slip.row(c).dot(shape) : force_row.dot(shape),
               .force_per_acceleration = from_balance ? unbalanced[c] : 0.0,
               .displacement = 1.0 + midspan.dot(shape),
               .modes = {}};

  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(held_stiffness, held_mass);
  if (eigen.info() != Eigen::Success)
    throw std::runtime_error("the natural frequencies of the mesh cannot be found");
  for (Eigen::Index n = 0; n < eigen.eigenvalues().size(); ++n) {
    const Eigen::VectorXd phi = eigen.eigenvectors().col(n);
    const double square_frequency = eigen.eigenvalues()[n], frequency = std::sqrt(square_frequency);
    const double participation = phi.dot(unbalanced(others));
    const double inertia = mass.row(c)(others).dot(phi);
    if (from_balance) sum.force_per_acceleration -= inertia * participation;
    sum.modes.push_back({.natural_frequency = frequency,
                         .oscillator_frequency = frequency,
                         .participation = participation,
                         .force = from_balance ? square_frequency * inertia - slip.row(c)(others).dot(phi)
                                               : force_row(others).dot(phi),
                         .displacement = midspan(others).dot(phi)});
  }
  return sum;
}

// T_n/A0 = Ω² C_n (w sin(Ω t) - Ω sin(w t)) / ((Ω² - w²) w) + V_n Ω sin(w t)/w.
std::vector<analytic::Sinusoid> sinusoids(const StickSum& sum, const data::HarmonicExcitation& excitation,
                                          StickReading reading) {
  constexpr double off_resonance = 1e-8;
  const double omega = angular_frequency(excitation), amplitude = excitation.amplitude();
  std::vector<analytic::Sinusoid> terms{{amplitude * driven_part(sum, reading, omega), omega}};
  for (const StickSum::Mode& mode : sum.modes) {
    double w = mode.oscillator_frequency;
    if (std::abs(w - omega) < off_resonance * omega) w = omega * (1.0 + off_resonance);
    const double weight = amplitude * weight_of(mode, reading);
    const double steady = square(omega) * mode.participation / (square(omega) - square(w));
    terms.front().amplitude += weight * steady;
    const double free = sum.cosine ? -steady : (mode.initial_rate - steady) * omega / w;
    if (sum.free_vibrations) terms.push_back({weight * free, w});
  }
  return terms;
}

double value_at(const std::vector<analytic::Sinusoid>& terms, double t) {
  double value = 0.0;
  for (const auto& term : terms) value += term.amplitude * std::sin(term.angular_frequency * t);
  return value;
}

double max_abs(const std::vector<analytic::Sinusoid>& terms, double duration, double sampling_step) {
  // Each term a exp(i w t) is advanced to the next sample by one complex multiplication.
  const auto size = static_cast<Eigen::Index>(terms.size());
  Eigen::ArrayXd sine = Eigen::ArrayXd::Zero(size), cosine(size), turn_sine(size), turn_cosine(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto& term = terms[static_cast<std::size_t>(i)];
    cosine[i] = term.amplitude;
    turn_sine[i] = std::sin(term.angular_frequency * sampling_step);
    turn_cosine[i] = std::cos(term.angular_frequency * sampling_step);
  }
  double before = 0.0, here = 0.0, largest = 0.0;
  Eigen::ArrayXd turned(size);
  const long samples = std::lround(duration / sampling_step);
  for (long n = 1; n <= samples; ++n) {
    turned = sine * turn_cosine + cosine * turn_sine;
    cosine = cosine * turn_cosine - sine * turn_sine;
    sine.swap(turned);
    const double next = sine.sum();
    const double bend = next - 2.0 * here + before;
    const bool is_peak = (here - before) * (next - here) < 0.0;
    if (is_peak) largest = std::max(largest, std::abs(here - square(next - before) / (8.0 * bend)));
    largest = std::max(largest, std::abs(next));
    before = here;
    here = next;
  }
  return largest;
}

std::vector<double> stepped(const StickSum& sum, const ModalScheme& scheme,
                            const data::HarmonicExcitation& excitation, StickReading reading, long count) {
  const double omega = angular_frequency(excitation), amplitude = excitation.amplitude();
  const double h = scheme.step, new_share = 1.0 - scheme.alpha_f;
  struct Oscillator {
    double load, damping, stiffness, inertia, weight, q, v, a;
  };
  std::vector<Oscillator> oscillators;
  for (const StickSum::Mode& mode : sum.modes) {
    const double w = mode.oscillator_frequency, damping = 2.0 * scheme.damping_ratio * w;
    const double v = mode.initial_rate * amplitude * omega;
    const double inertia =
        1.0 - scheme.alpha_m + new_share * h * (damping * scheme.gamma + square(w) * scheme.beta * h);
    oscillators.push_back({-mode.participation * amplitude * square(omega), damping, square(w), inertia,
                           weight_of(mode, reading), 0.0, v, -damping * v});
  }
  const double driven = amplitude * driven_part(sum, reading, omega);
  std::vector<double> history;
  for (long n = 0; n <= count; ++n) {
    const double time = static_cast<double>(n) * h, sine = std::sin(omega * (time + scheme.load_delay));
    double value = driven * std::sin(omega * time);
    for (auto& [load, damping, stiffness, inertia, weight, q, v, a] : oscillators) {
      value += weight * q;
      const double free_q = q + h * v + h * h * (0.5 - scheme.beta) * a;
      const double free_v = v + h * (1.0 - scheme.gamma) * a;
      const double next =
          (load * sine - scheme.alpha_m * a - damping * (new_share * free_v + scheme.alpha_f * v) -
           stiffness * (new_share * free_q + scheme.alpha_f * q)) /
          inertia;
      q = free_q + h * h * scheme.beta * next;
      v = free_v + h * scheme.gamma * next;
      a = next;
    }
    history.push_back(value);
  }
  return history;
}

TipRun tip_run(const solver::ContactSystem& system, const solver::PrescribedMotion& base,
               const data::NumericalSettings& numerics, Start start, double end, std::size_t events) {
  solver::StickSlipIntegrator run(system, {.time_step = numerics.time_step(),
                                           .spectral_radius = numerics.spectral_radius(),
                                           .velocity_threshold = numerics.velocity_threshold()});
  const Eigen::VectorXd shape = quasi_static_shape(system);
  Eigen::VectorXd velocity = Eigen::VectorXd::Zero(shape.size());
  if (start == Start::quasi_static) velocity = system.wall.velocity(0.0) * shape;
  if (start == Start::at_rest)  // all deflections move against the base, as the wall does
    for (Eigen::Index i = system.contact % 2; i < shape.size(); i += 2)
      velocity[i] = system.wall.velocity(0.0);
  run.start_stuck(system.wall.displacement(0.0) * shape, velocity);
  TipRun result{.step = numerics.time_step()};
  const long steps = std::lround(std::ceil(end / result.step - 1e-6));
  for (long n = 0; n <= steps; ++n) {
    if (n > 0) run.step();
    add_sample(result, system.contact, base, run.time(), run.displacement(), run.velocity(),
               run.friction_force());
    if (run.events().size() >= events && event_times(run.events()).size() >= events) break;
  }
  result.events = event_times(run.events());
  return result;
}

TipRun tip_run(const solver::ContactSystem& system, const solver::PrescribedMotion& base,
               const data::NumericalSettings& numerics, const FrictionRule& law, double end,
               std::size_t events) {
  constexpr int substeps = 10;
  const double h = numerics.time_step() / substeps;
  const Eigen::Index c = system.contact;
  const Eigen::MatrixXd mass(system.mass), damping(system.damping), stiffness(system.slip_stiffness);
  const Eigen::PartialPivLU<Eigen::MatrixXd> step_matrix(mass + 0.5 * h * damping + 0.25 * h * h * stiffness);
  const Eigen::MatrixXd from_velocity =
      step_matrix.solve(mass - 0.5 * h * damping - 0.25 * h * h * stiffness);
  const Eigen::MatrixXd from_displacement = -h * step_matrix.solve(stiffness);
  const Eigen::VectorXd from_load = h * step_matrix.solve(system.load_shape);
  const Eigen::VectorXd from_force = h * step_matrix.solve(Eigen::VectorXd::Unit(system.mass.rows(), c));
  const double limit = system.friction.static_coefficient() * system.normal_force;
  const double strength = from_force[c] * system.normal_force;

  const Eigen::VectorXd shape = quasi_static_shape(system);
  Eigen::VectorXd q = system.wall.displacement(0.0) * shape;
  Eigen::VectorXd v = system.wall.velocity(0.0) * shape, free(q.size());
  TipRun result{.step = numerics.time_step()};
  add_sample(result, c, base, 0.0, q, v, 0.0);
  bool sliding = false;
  const long steps = substeps * std::lround(std::ceil(end / result.step - 1e-6));
  for (long n = 0; n < steps && result.events.size() < events; ++n) {
    const double now = static_cast<double>(n) * h, next = static_cast<double>(n + 1) * h;
    free.noalias() =
        from_velocity * v + from_displacement * q + system.load_history(0.5 * (now + next)) * from_load;
    const double wall = system.wall.velocity(next), free_velocity = free[c] - wall;
    const double holding = -free_velocity / from_force[c];
    const bool held = law.holds && std::abs(holding) <= limit;
    const double force =
        held ? holding
             : (sliding_velocity(law, system.friction, strength, free_velocity) - free_velocity) /
                   from_force[c];
    if (held == sliding) result.events.push_back(next);
    sliding = !held;
    free += force * from_force;
    q += 0.5 * h * (v + free);
    v.swap(free);
    if ((n + 1) % substeps != 0) continue;
    add_sample(result, c, base, next, q, v, force);
  }
  return result;
}

}  // namespace stickslip::studies
