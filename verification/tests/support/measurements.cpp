// SPDX-License-Identifier: MIT
#include "support/measurements.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "stickslip/analytic/band_maximum.hpp"
#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/modal_analysis.hpp"

namespace stickslip::testing {

using data::ContactEvent;
using std::numbers::pi;

namespace {

constexpr Dimension number{}, length{1, 0, 0}, per_length{-1, 0, 0}, per_time{0, 0, -1}, velocity{1, 0, -1},
    force{1, 1, -2}, time_unit{0, 0, 1};

constexpr int kModes = 4;

// Modes and shapes. What is rounded differently for a similar beam: E I, rho A, P L^2/EI and the unit of the frequency, some ten
// operations.

void add_stick_modes(const Scene& scene, std::vector<Quantity>& quantities) {
  const data::Beam& beam = scene.problem.beam;
  const double x = beam.length() * scene.x;
  for (const analytic::StickMode& mode : analytic::stick_modes(beam, 8)) {
    const double condition = mode.condition_number();
    quantities.insert(
        quantities.end(),
        {{mode.angular_frequency(), per_time, round_off(3, condition, mode.angular_frequency())},
         {mode.frequency_hz(), per_time},
         {mode.slope_norm_squared(), per_length},
         {mode.curvature_norm_squared(), {-3, 0, 0}},
         {condition, number},
         {mode.participation(), number, round_off(3, condition, mode.participation())},
         {mode.shape(x), number},
         {mode.third_derivative(x), {-3, 0, 0}}});
  }
}

/// The frequencies of the free tip depend on the axial force with a slope, taken from a difference.
void add_slip_modes(const Scene& scene, std::vector<Quantity>& quantities) {
  constexpr double share = 1e-6;
  const data::Beam& beam = scene.problem.beam;
  const double x = beam.length() * scene.x;
  data::BeamProperties other = beam.properties();
  other.axial_force *= 1.0 + share;
  const auto modes = analytic::slip_modes(beam, 6), changed = analytic::slip_modes(data::Beam(other), 6);
  for (std::size_t n = 0; n < modes.size(); ++n) {
    const double omega = modes[n].angular_frequency();
    const double slope = std::abs(changed[n].angular_frequency() / omega - 1.0) / share;
    quantities.insert(quantities.end(), {{omega, per_time, round_off(3, 1.0 + slope, omega)},
                                         {modes[n].shape(x), number},
                                         {modes[n].adjoint_shape(x), number},
                                         {modes[n].curvature(x), {-2, 0, 0}}});
  }
}

std::vector<Quantity> closed_form_modes(const Scene& scene) {
  const data::Beam& beam = scene.problem.beam;
  const analytic::QuasiStaticShape shape(beam);
  const double x = beam.length() * scene.x;
  std::vector<Quantity> quantities{{analytic::stick_buckling_load(beam), force},
                                   {analytic::slip_critical_load(beam), force},
                                   {shape.value(x), number, round_off(3, nearness_of_buckling(beam), 1.0)},
                                   {shape.slope(x), per_length},
                                   {shape.curvature(x), {-2, 0, 0}},
                                   {shape.third_derivative(x), {-3, 0, 0}}};
  add_stick_modes(scene, quantities);
  add_slip_modes(scene, quantities);
  return quantities;
}

/// An eigenvalue of the mesh is known to the round-off of its largest stiffness, n^4 times that of the lowest mode, and to that of
/// P L^2/EI.
std::vector<Quantity> mesh_modes(const Scene& scene) {
  const data::Beam& beam = scene.problem.beam;
  const int n = scene.elements;
  const solver::BeamModel model(beam, n);
  const double condition = std::pow(n, 4) * nearness_of_buckling(beam),
               load = solver::stick_buckling_load(model);
  std::vector<Quantity> quantities{{load, force, round_off(1, std::pow(n, 4), load)}};
  const auto add = [&](const auto& modes, const auto& tolerance_of) {
    for (std::size_t k = 0; k < modes.size(); ++k) {
      const double omega = modes[k].angular_frequency;
      quantities.push_back({omega, per_time, static_cast<int>(k) < n ? tolerance_of(omega) : std::nullopt});
      for (Eigen::Index i = 0; i < modes[k].shape.size(); i += 2)
        quantities.push_back({modes[k].shape[i], {0, -0.5, 0}});
    }
  };
  using Allowed = std::optional<Tolerance>;
  const auto stick = solver::stick_modes(model, 2 * n - 1);
  add(stick, [=](double omega) -> Allowed { return round_off(1, condition, omega); });
  // Unsymmetric: absolutely in 1/omega^2. In tension, which a follower force does not turn into stiffness, the first mode is softer
  // than that of the unloaded mesh, 12.4 units of omega^2.
  const auto slip = solver::slip_modes(model, n);
  const double first = slip.front().angular_frequency;
  const double softness = 1.0 + 12.4 * std::pow(frequency_unit(beam) / first, 2);
  add(slip, [=](double omega) -> Allowed {
    return round_off(2, condition * softness * std::pow(omega / first, 2), omega);
  });
  const Eigen::VectorXd shape = model.unit_tip_deflection();
  for (Eigen::Index i = 0; i < shape.size(); i += 2) {
    quantities.push_back({shape[i], number, round_off(1, condition, 1.0)});
    quantities.push_back({shape[i + 1], per_length});
  }
  const data::Damping damping({.kelvin_voigt = 0.01 / stick.front().angular_frequency, .ratio = 0.02});
  const Eigen::MatrixXd dashpots = solver::damping_matrix(model, damping);
  for (Eigen::Index i = 0; i < dashpots.rows(); i += 2)
    for (Eigen::Index j = 0; j < dashpots.cols(); j += 2) quantities.push_back({dashpots(i, j), {0, 1, -1}});
  return quantities;
}

// Forces and verdicts.

/// Off resonance by 2 %, an error of a natural frequency counts fiftyfold, and in the phase with omega_n t.
std::vector<Quantity> stick_response(const Scene& scene) {
  const auto& [beam, law, excitation, damping] = scene.problem;
  const double x = beam.length() * scene.x, duration = 2.0 * period(excitation), t = duration * scene.t;
  std::vector<Quantity> quantities;
  for (const auto part : {analytic::SteadyPart::modal_sum, analytic::SteadyPart::exact}) {
    const analytic::StickResponse response(beam, excitation, 10, part);
    double scale = std::abs(response.steady_force_amplitude());
    for (const auto& [amplitude, omega] : response.transient_force())
      scale += std::abs(amplitude) * (1.0 + omega * t);
    const auto sampled = response.sampled_max_abs_friction_force(duration, 0.01 * duration);
    quantities.insert(quantities.end(),
                      {{response.friction_force(t), force,
                        round_off(3, 50.0 * response.modes().front().condition_number(), scale), false, 1.0},
                       {response.steady_force_amplitude(), force, {}, false, 1.0},
                       {response.omitted_transient_bound(), force},
                       {response.absolute_displacement(x, t), length},
                       {sampled.lower, force},
                       {sampled.upper, force}});
  }
  return quantities;
}

std::vector<Quantity> criterion(const Scene& scene) {
  const auto& [beam, law, excitation, damping] = scene.problem;
  const auto found = analytic::evaluate_criterion(beam, law, excitation, 2.0 * period(excitation));
  const auto width = [](double value) {
    return discretisation(1e-10 * value, 1.0, "relative width of the enclosures");
  };
  const double largest = found.force_max.midpoint(), critical = found.critical_amplitude.midpoint();
  return {{static_cast<double>(found.verdict), number, Tolerance{}},
          {found.force_max.lower, force},
          {found.force_max.upper, force},
          {largest, force, width(found.force_max.upper)},
          {found.critical_amplitude.lower, length},
          {critical, length, width(critical)},
          {found.friction_limit, force}};
}

/// 2 % off resonance, and what the closed form loses to min(|b|, |c|)^-3 at low frequencies.
std::vector<Quantity> damped_steady_state(const Scene& scene) {
  const auto& [beam, law, excitation, no_damping] = scene.problem;
  const data::Damping damping({.kelvin_voigt = std::pow(1e-3, scene.t) * period(excitation)});
  const analytic::DampedSteadyState state(beam, excitation, damping, analytic::TipSupport::held);
  const double z = beam.axial_force() * beam.length() * beam.length() / rigidity(beam);
  const double s = 2.0 * pi * excitation.frequency_hz() / frequency_unit(beam);
  const double smaller = s / std::sqrt(0.5 * std::abs(z) + std::hypot(0.5 * z, s));
  const double condition = 50.0 * nearness_of_buckling(beam) * std::max(1.0, std::pow(smaller, -3));
  const auto reaction = state.friction_force();
  const Tolerance tolerance = round_off(3, condition, std::abs(reaction));
  return {{reaction.real(), force, tolerance},
          {reaction.imag(), force, tolerance},
          {state.dissipated_energy(), {2, 1, -2}, round_off(3, condition, state.dissipated_energy())}};
}

std::vector<Quantity> band_maximum(const Scene& scene) {
  const data::Beam& beam = scene.problem.beam;
  const double first = stick_frequencies(beam, 1).front() / (2.0 * pi);
  analytic::BandMaximum band(beam, {0.5 * first, 1.5 * first}, 4.0 / first, 4);
  const auto found = band.refined_to(1e-2);
  return {{found.lower, {0, 1, -2}},
          {found.upper, {0, 1, -2}},
          {band.frequency_hz(), per_time},
          {static_cast<double>(band.evaluations()), number}};
}

/// A bonded tip: the reaction, the displacements of the mesh and the largest reaction. Each step rounds the reaction, a difference
/// of forces of stiff elements, by n^4 eps; a random walk.
std::vector<Quantity> stepped_reaction(const Scene& scene) {
  const auto numerics = settings(scene.problem, 0.7);
  const auto run =
      started(scene.problem, solver::harmonic_motion(scene.problem.excitation),
              {.time_step = numerics.time_step(), .spectral_radius = 0.9}, solver::TipContact::bonded);
  for (long n = solver::step_count(numerics.duration(), numerics.time_step()); n > 0; --n) run->step();
  std::vector<Quantity> quantities{{run->friction_force(), force}};
  for (Eigen::Index i = 0; i < run->displacement().size(); i += 2)
    quantities.push_back({run->displacement()[i], length});
  const double walk = std::sqrt(numerics.duration() / numerics.time_step());
  quantities.push_back(
      {solver::max_abs_friction_force(scene.problem.beam, scene.problem.excitation, numerics),
       force,
       {},
       false,
       walk * std::pow(mesh_elements, 4) * nearness_of_buckling(scene.problem.beam)});
  return quantities;
}

// Histories.

/// The contact at eight times, and the changes until then.
struct History {
  std::vector<Quantity> samples;
  std::vector<ContactEvent> events;
};

template <class Engine>
void add_sample(const Engine& engine, double position, History& history) {
  history.samples.insert(history.samples.end(), {{static_cast<double>(engine.state()), number},
                                                 {position, length, {}, true},
                                                 {engine.sliding_velocity(), velocity, {}, true},
                                                 {engine.friction_force(), force, {}, true}});
}

History stepped_history(const Scene& scene) {
  const StickSlipProblem& problem = scene.problem;
  const auto numerics = settings(problem, scene.periods);
  const double time_step =
      0.25 * numerics.time_step();  // as long as the law of friction of every beam allows
  const double speed = 2.0 * pi * problem.excitation.frequency_hz() * problem.excitation.amplitude();
  const auto run = started(
      problem, transformed(solver::harmonic_motion(problem.excitation), scene.is_mirrored ? -1.0 : 1.0),
      {.time_step = time_step,
       .spectral_radius = 0.9,
       .velocity_threshold = scene.has_threshold ? 0.01 * speed : 0.0});
  const solver::BeamModel model(problem.beam, mesh_elements);
  const long steps = solver::step_count(numerics.duration(), time_step);
  History history;
  for (int eighth = 1; eighth <= 8; ++eighth) {
    while (run->steps() < eighth * steps / 8) run->step();
    add_sample(*run, run->displacement()[run->system().contact], history);
    history.samples.push_back(
        {model.interpolation(0.5 * problem.beam.length()).dot(run->displacement()), length, {}, true});
  }
  history.events = run->events();
  return history;
}

analytic::ContactModel mirrored(analytic::ContactModel model) {
  for (double& load : model.load) load = -load;
  model.wall_amplitude = -model.wall_amplitude;
  return model;
}

History event_driven_history(const Scene& scene) {
  const analytic::ContactModel model = modal_model(scene.problem);
  analytic::EventDriven run(scene.is_mirrored ? mirrored(model) : model);
  History history;
  for (int eighth = 1; eighth <= 8; ++eighth) {
    run.advance_to(0.125 * eighth * scene.periods * period(scene.problem.excitation));
    add_sample(run, run.contact_position(), history);
  }
  history.events = run.events();
  return history;
}

/// The beam let go from a bent shape, without any load: nothing but its own motion says what is small.
History free_motion(const Scene& scene) {
  StickSlipProblem problem = scene.problem;
  problem.excitation =
      data::HarmonicExcitation({.frequency_hz = problem.excitation.frequency_hz(), .amplitude = 0.0});
  const analytic::ContactModel model = modal_model(problem);
  const double first = model.angular_frequency.front();
  const double bent = 10.0 * problem.friction.static_coefficient() * problem.beam.axial_force() /
                      (first * first * model.contact_mass);
  analytic::EventDriven run(model);
  run.start_slipping({}, {}, scene.is_mirrored ? -bent : bent, 0.0);
  run.advance_to(20.0 / first);
  History history{{}, run.events()};
  add_sample(run, run.contact_position(), history);
  return history;
}

History modally_damped_history(const Scene& scene) {
  Scene damped = scene;
  damped.problem.damping = data::Damping({.ratio = 0.01});
  return event_driven_history(damped);
}

/// A history as numbers, with tolerances for a similar beam if it has an error.
std::function<std::vector<Quantity>(const Scene&)> quantities_of(History (*run)(const Scene&),
                                                                 double error = 0.0) {
  return [=](const Scene& scene) {
    const History history = run(scene);
    std::vector<EventTolerances> allowed;
    if (scene.measures_errors && error > 0.0) {
      Sensitivity sensitivity{.error = error, .amplitude = scene.problem.excitation.amplitude()};
      Scene changed = scene;
      changed.problem = with_amplitude(scene.problem, 1.0 + sensitivity.perturbation);
      sensitivity.perturbed = run(changed).events;
      allowed = tolerances(history.events, sensitivity);
    }
    std::vector<Quantity> quantities = history.samples;
    for (std::size_t i = 0; i < history.events.size(); ++i) {
      const ContactEvent& event = history.events[i];
      Quantity time{event.time, time_unit}, position{event.position, length, {}, true};
      if (!allowed.empty()) time.of_similar = allowed[i].time, position.of_similar = allowed[i].position;
      quantities.insert(quantities.end(), {{static_cast<double>(event.change), number, Tolerance{}},
                                           time,
                                           position,
                                           {event.residual_velocity, velocity, {}, true}});
    }
    return quantities;
  };
}

}  // namespace

std::vector<double> stick_frequencies(const data::Beam& beam, int count) {
  std::vector<double> frequencies;
  for (const auto& mode : analytic::stick_modes(beam, count)) frequencies.push_back(mode.angular_frequency());
  return frequencies;
}

StickSlipProblem slipping(const data::Beam& beam, RandomNumbers& numbers) {
  const std::vector<double> natural = stick_frequencies(beam, kModes);
  const double hz = random_frequency_hz(numbers, natural, 0.05);
  const double friction = numbers.uniform(0.1, 1.0);
  const auto criterion = analytic::evaluate_criterion(
      beam, data::FrictionLaw({.static_coefficient = friction}),
      data::HarmonicExcitation({.frequency_hz = hz, .amplitude = 0.0}), 1.0 / hz, kModes);
  const double amplitude = numbers.uniform(1.2, 3.0) * criterion.critical_amplitude.midpoint();
  return random_problem(numbers, beam, friction, {.frequency_hz = hz, .amplitude = amplitude},
                        0.01 / natural.front());
}

StickSlipProblem off_resonance(const data::Beam& beam, RandomNumbers& numbers) {
  const double hz = random_frequency_hz(numbers, stick_frequencies(beam, 6), 0.02);
  return {beam,
          data::FrictionLaw({.static_coefficient = numbers.uniform(0.1, 1.0)}),
          data::HarmonicExcitation(
              {.frequency_hz = hz, .amplitude = beam.length() * numbers.log_uniform(1e-6, 1e-2)}),
          {}};
}

data::NumericalSettings settings(const StickSlipProblem& problem, double periods) {
  const double of_excitation = period(problem.excitation);
  const double shorter = std::min(of_excitation, 2.0 * pi / stick_frequencies(problem.beam, 1).front());
  return data::NumericalSettings({.elements = mesh_elements,
                                  .time_step = 0.01 * shorter,
                                  .spectral_radius = 0.9,
                                  .velocity_threshold = 0.0,
                                  .modes = 1,
                                  .duration = periods * of_excitation});
}

std::unique_ptr<solver::StickSlipIntegrator> started(const StickSlipProblem& problem,
                                                     const solver::PrescribedMotion& base,
                                                     const solver::IntegratorSettings& settings,
                                                     solver::TipContact contact) {
  const solver::BeamModel model(problem.beam, mesh_elements);
  solver::ContactSystem system = solver::beam_contact_system(model, problem.friction, base, problem.damping);
  if (contact == solver::TipContact::bonded) system.normal_force = solver::bonding_force;
  auto integrator = std::make_unique<solver::StickSlipIntegrator>(system, settings);
  integrator->start_stuck(Eigen::VectorXd::Zero(model.degrees_of_freedom()),
                          -base.velocity(0.0) * model.unit_tip_deflection());
  return integrator;
}

solver::PrescribedMotion transformed(const solver::PrescribedMotion& motion, double factor, double delay) {
  const auto changed = [factor, delay](const std::function<double(double)>& f) {
    return [=](double t) { return factor * f(t - delay); };
  };
  return {changed(motion.displacement), changed(motion.velocity), changed(motion.acceleration)};
}

analytic::ContactModel modal_model(const StickSlipProblem& problem) {
  return analytic::BeamContactModel(problem.beam, problem.friction, problem.excitation, problem.damping,
                                    kModes)
      .model();
}

std::vector<EventTolerances> tolerances(const std::vector<ContactEvent>& events,
                                        const Sensitivity& sensitivity) {
  EXPECT_EQ(sensitivity.perturbed.size(), events.size()) << "the perturbation is too large to measure with";
  std::vector<EventTolerances> allowed;
  double of_time = 0.0, of_position = sensitivity.amplitude;
  for (std::size_t i = 0; i < std::min(events.size(), sensitivity.perturbed.size()); ++i) {
    const ContactEvent& moved = sensitivity.perturbed[i];
    of_time = std::max(of_time, std::abs(moved.time - events[i].time) / sensitivity.perturbation);
    of_position =
        std::max(of_position, std::abs(moved.position - events[i].position) / sensitivity.perturbation);
    allowed.push_back(
        {discretisation(sensitivity.error * (events[i].time + of_time), 1.0, "error times slope"),
         discretisation(sensitivity.error * of_position, 1.0, "error times slope")});
  }
  return allowed;
}

void expect_same_events(const std::vector<ContactEvent>& computed, const std::vector<ContactEvent>& expected,
                        const Sensitivity& sensitivity) {
  ASSERT_EQ(computed.size(), expected.size());
  const auto allowed = tolerances(expected, sensitivity);
  ASSERT_EQ(allowed.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_TRUE(within(computed[i].time, expected[i].time, allowed[i].time)) << "event " << i;
    EXPECT_TRUE(within(computed[i].position, expected[i].position, allowed[i].position)) << "event " << i;
  }
}

const std::vector<Measurement>& measurements() {
  static const std::vector<Measurement> rows{
      {"ClosedFormModes", any_force, false, 100, 60, 0, closed_form_modes},
      {"MeshModes", any_force, false, 60, 60, 0, mesh_modes},
      {"StickResponse", compression, false, 20, 25, 0, stick_response, true, true, false, true},
      {"Criterion", compression, false, 20, 25, 0, criterion},
      {"DampedSteadyState", any_force, false, 0, 50, 0, damped_steady_state, false},
      {"BandMaximum", any_force, false, 4, 0, 0, band_maximum},
      {"SteppedReaction", any_force, false, 30, 0, 0, stepped_reaction, true, true, false, true},
      {"SteppedHistory", compression, true, 40, 25, 200, quantities_of(stepped_history, stepped_error), true,
       true, true},
      {"EventDrivenHistory", compression, true, 30, 20, 150,
       quantities_of(event_driven_history, event_driven_error), true, true, true},
      {"FreeMotion", compression, true, 20, 0, 100, quantities_of(free_motion), true, true, true},
      // GSL normalises modes of the free tip in kg^(1/2) m and m together, which rounds.
      {"ModallyDampedHistory", compression, true, 10, 0, 0, quantities_of(modally_damped_history), true,
       false, true}};
  return rows;
}

}  // namespace stickslip::testing
