// SPDX-License-Identifier: MIT
/// Transformations of a problem that must change the answers of every engine in a known way, and theorems, whatever the beam is.

#include <Eigen/Dense>

#include "stickslip/analytic/band_maximum.hpp"
#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/key.hpp"
#include "stickslip/solver/base_motion.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "support/random_beams.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::ContactModel;
using analytic::EventDriven;
using data::ContactEvent;
using std::numbers::pi;

// What the engines answer about a random beam, as numbers with dimensions: one list, to which each transformation is applied.

/// Exponents of the units of length, mass and time.
struct Dimension {
  double length{}, mass{}, time{};
};

struct Quantity {
  double value{};
  Dimension dimension{};
  /// How far it may be off for a similar beam; none: compared bit for bit only.
  std::optional<Tolerance> of_similar{};
  bool is_odd{};  ///< changes its sign with the motion of the base
  double
      condition{};  ///< above 0, of what is proportional to the amplitude: round-off at an amplitude that is no power of two
};

/// A problem, and where and when to look at it.
struct Scene {
  data::Case problem;
  double x{}, t{};     ///< shares of the length and of the duration
  double periods{};    ///< of the excitation, the duration of a history
  bool is_mirrored{};  ///< the base moves the other way
  bool
      has_threshold{};  ///< a time stepper captures a tip that still slides at a hundredth of the base's speed
  bool measures_errors{};  ///< Quantity::of_similar is wanted
};

struct Measurement {
  std::string name;
  ForceRange force{};
  bool slips{};                    ///< needs an excitation beyond the critical amplitude
  int beams{}, similar_beams{};    ///< how many are tried in other units, and for similarity
  std::size_t least_quantities{};  ///< of all beams in other units together
  std::function<std::vector<Quantity>(const Scene&)> measure;
  bool is_exact_in_mass{true};
  bool is_history{};  ///< has a mirror image
  bool is_linear{};   ///< proportional to the amplitude
};

/// For the messages of GoogleTest.
void PrintTo(const Measurement& row, std::ostream* stream) { *stream << row.name; }

/// On the mesh of the stepped histories, a hundred steps to the shorter of both periods, of the excitation and of the first mode.
constexpr int mesh_elements = 6;

/// How far two runs of one problem may differ.
struct Sensitivity {
  std::vector<data::ContactEvent>
      perturbed{};            ///< of the expected run with an amplitude that is larger by a share
  double perturbation{1e-8};  ///< this share
  double error{};             ///< relative error of the data or the steps
  double amplitude{};         ///< measure of positions, m
};

/// The tolerances of the time and the position of each event: `error` times the time plus its slope, and `error` times the slope
/// of the position; slopes are the largest change per share so far in the perturbed run, of positions at least the amplitude.
struct EventTolerances {
  Tolerance time, position;
};

/// Relative errors of stepped histories: round-off in the data of the mesh, n^4 times the last digit, and events located to 1e-11
/// of a step; and of event-driven ones: the integrator's tolerance in each of its steps, whose errors have either sign.
constexpr double stepped_error = 4.0 * 6 * 6 * 6 * 6 * 0x1p-52 + 1e-11;

constexpr double event_driven_error = 1e-12;

constexpr int kModes = 4;

/// Of the closed forms, rad/s.
std::vector<double> stick_frequencies(const data::Beam& beam, int count) {
  std::vector<double> frequencies;
  for (const auto& mode : analytic::stick_modes(beam, count)) frequencies.push_back(mode.angular_frequency());
  return frequencies;
}

data::Case with_duration(const data::Case& problem, double duration, int modes) {
  return data::with_values(problem, {{"excitation.duration", duration},
                                     {"numerics.time_step", 1e-3 * duration},
                                     {"numerics.modes", modes}});
}

/// A beam whose tip slips: 1.2 to 3 times the critical amplitude over one period, damped by half a percent of critical in its
/// first mode.
data::Case slipping(const data::Beam& beam, RandomNumbers& numbers) {
  const std::vector<double> natural = stick_frequencies(beam, kModes);
  const double hz = random_frequency_hz(numbers, natural, 0.05);
  const double friction = numbers.uniform(0.1, 1.0);
  const data::Case still = with(with_duration(paper_problem(hz, 0.0), 1.0 / hz, kModes), beam,
                                data::FrictionLaw({.static_coefficient = friction}));
  const auto criterion = analytic::evaluate_criterion(still);
  const double amplitude = numbers.uniform(1.2, 3.0) * criterion.critical_amplitude.midpoint();
  return random_problem(numbers, beam, friction, {.frequency_hz = hz, .amplitude = amplitude},
                        0.01 / natural.front());
}

/// A frequency off resonance and an amplitude of 1e-6 to 1e-2 of the length.
data::Case off_resonance(const data::Beam& beam, RandomNumbers& numbers) {
  const double hz = random_frequency_hz(numbers, stick_frequencies(beam, 6), 0.02);
  const data::FrictionLaw friction({.static_coefficient = numbers.uniform(0.1, 1.0)});
  return with(paper_problem(hz, beam.length() * numbers.log_uniform(1e-6, 1e-2)), beam, friction);
}

data::NumericalSettings settings(const data::Case& problem, double periods) {
  const double of_excitation = period(problem.excitation());
  const double shorter = std::min(of_excitation, 2.0 * pi / stick_frequencies(problem.beam(), 1).front());
  return data::NumericalSettings({.elements = mesh_elements,
                                  .time_step = 0.01 * shorter,
                                  .spectral_radius = 0.9,
                                  .velocity_threshold = 0.0,
                                  .modes = 1,
                                  .duration = periods * of_excitation});
}

/// The time stepper on a base with any motion, started as a BeamSimulation is.
std::unique_ptr<solver::StickSlipIntegrator> started(const data::Case& problem,
                                                     const solver::PrescribedMotion& base,
                                                     const solver::IntegratorSettings& settings,
                                                     bool is_bonded = false) {
  const solver::BeamModel model(problem.beam(), mesh_elements);
  solver::ContactSystem system = solver::beam_contact_system(model, problem, base);
  if (is_bonded) system.normal_force = solver::bonding_force;
  auto integrator = std::make_unique<solver::StickSlipIntegrator>(system, settings);
  integrator->start_stuck(Eigen::VectorXd::Zero(model.degrees_of_freedom()),
                          -base.velocity(0.0) * model.unit_tip_deflection());
  return integrator;
}

/// The motion times a factor.
solver::PrescribedMotion multiplied(const solver::PrescribedMotion& motion, double factor) {
  const auto changed = [factor](const std::function<double(double)>& f) {
    return [=](double t) { return factor * f(t); };
  };
  return {changed(motion.displacement), changed(motion.velocity), changed(motion.acceleration)};
}

/// The model of the event-driven histories, of four modes.
analytic::ContactModel modal_model(const data::Case& problem) {
  return analytic::contact_model(problem, kModes);
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

constexpr Dimension number{}, length{1, 0, 0}, per_time{0, 0, -1}, velocity{1, 0, -1}, force{1, 1, -2},
    time_unit{0, 0, 1};

// Forces and verdicts.

/// Off resonance by 2 %, an error of a natural frequency counts fiftyfold, and in the phase with omega_n t.
std::vector<Quantity> stick_response(const Scene& scene) {
  const data::Beam& beam = scene.problem.beam();
  const data::HarmonicExcitation& excitation = scene.problem.excitation();
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
  const data::HarmonicExcitation& excitation = scene.problem.excitation();
  const auto found = analytic::evaluate_criterion(
      with_duration(with(scene.problem, data::Damping()), 2.0 * period(excitation), 10));
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

std::vector<Quantity> band_maximum(const Scene& scene) {
  const data::Beam& beam = scene.problem.beam();
  const double first = stick_frequencies(beam, 1).front() / (2.0 * pi);
  analytic::BandMaximum band(analytic::modal_reaction(beam, 4), {0.5 * first, 1.5 * first}, 4.0 / first);
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
  const auto run = started(scene.problem, solver::base_motion(scene.problem.motion),
                           {.time_step = numerics.time_step(), .spectral_radius = 0.9}, true);
  for (long n = solver::step_count(numerics.duration(), numerics.time_step()); n > 0; --n) run->step();
  std::vector<Quantity> quantities{{run->friction_force(), force}};
  for (Eigen::Index i = 0; i < run->displacement().size(); i += 2)
    quantities.push_back({run->displacement()[i], length});
  const double walk = std::sqrt(numerics.duration() / numerics.time_step());
  quantities.push_back({solver::max_abs_friction_force(with(scene.problem, numerics, data::Damping())),
                        force,
                        {},
                        false,
                        walk * std::pow(mesh_elements, 4) * nearness_of_buckling(scene.problem.beam())});
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
  const data::Case& problem = scene.problem;
  const auto numerics = settings(problem, scene.periods);
  const double time_step =
      0.25 * numerics.time_step();  // as long as the law of friction of every beam allows
  const double speed = 2.0 * pi * problem.excitation().frequency_hz() * problem.excitation().amplitude();
  const auto run =
      started(problem, multiplied(solver::base_motion(problem.motion), scene.is_mirrored ? -1.0 : 1.0),
              {.time_step = time_step,
               .spectral_radius = 0.9,
               .velocity_threshold = scene.has_threshold ? 0.01 * speed : 0.0});
  const solver::BeamModel model(problem.beam(), mesh_elements);
  const long steps = solver::step_count(numerics.duration(), time_step);
  History history;
  for (int eighth = 1; eighth <= 8; ++eighth) {
    while (run->steps() < eighth * steps / 8) run->step();
    add_sample(*run, run->displacement()[run->system().contact], history);
    history.samples.push_back(
        {model.interpolation(0.5 * problem.beam().length()).dot(run->displacement()), length, {}, true});
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
    run.advance_to(0.125 * eighth * scene.periods * period(scene.problem.excitation()));
    add_sample(run, run.contact_position(), history);
  }
  history.events = run.events();
  return history;
}

/// The beam let go from a bent shape, without any load: nothing but its own motion says what is small.
History free_motion(const Scene& scene) {
  data::Case problem = scene.problem;
  problem.motion =
      data::HarmonicExcitation({.frequency_hz = problem.excitation().frequency_hz(), .amplitude = 0.0});
  const analytic::ContactModel model = modal_model(problem);
  const double first = model.angular_frequency.front();
  const double bent = 10.0 * problem.contact.friction.static_coefficient() * problem.beam().axial_force() /
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
      Sensitivity sensitivity{.error = error, .amplitude = scene.problem.excitation().amplitude()};
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

const std::vector<Measurement>& measurements() {
  static const std::vector<Measurement> rows{
      {"StickResponse", compression, false, 20, 25, 0, stick_response, true, false, true},
      {"Criterion", compression, false, 20, 25, 0, criterion},
      {"BandMaximum", any_force, false, 4, 0, 0, band_maximum},
      {"SteppedReaction", any_force, false, 30, 0, 0, stepped_reaction, true, false, true},
      {"SteppedHistory", compression, true, 40, 25, 200, quantities_of(stepped_history, stepped_error), true,
       true},
      {"EventDrivenHistory", compression, true, 30, 20, 150,
       quantities_of(event_driven_history, event_driven_error), true, true},
      {"FreeMotion", compression, true, 20, 0, 100, quantities_of(free_motion), true, true},
      // GSL normalises modes of the free tip in kg^(1/2) m and m together, which rounds.
      {"ModallyDampedHistory", compression, true, 10, 0, 0, quantities_of(modally_damped_history), false,
       true}};
  return rows;
}

Scene scene_of(const Measurement& measurement, const data::Beam& beam, RandomNumbers& numbers) {
  Scene scene{.problem = measurement.slips ? slipping(beam, numbers) : off_resonance(beam, numbers)};
  scene.x = numbers.uniform(0.05, 0.95);
  scene.t = numbers.uniform(0.1, 1.0);
  scene.periods = 2.0;
  return scene;
}

class Transformation : public ::testing::TestWithParam<Measurement> {};

auto rows_where(bool (*holds)(const Measurement&)) {
  std::vector<Measurement> rows;
  std::ranges::copy_if(measurements(), std::back_inserter(rows), holds);
  return ::testing::ValuesIn(rows);
}

const auto name_of_row = [](const auto& instance) { return instance.param.name; };

// Mirrored base.

class Symmetry : public Transformation {};

STICKSLIP_VERIFIES(Symmetry, "M1");
TEST_P(Symmetry, OfTheBaseIsThatOfTheHistoryBitForBit) {
  on_random_beams(40, GetParam().force, [&](const data::Beam& beam, RandomNumbers& numbers) {
    Scene scene = scene_of(GetParam(), beam, numbers);
    scene.has_threshold = numbers.whole(0, 1) == 1;
    const auto plus = GetParam().measure(scene);
    scene.is_mirrored = true;
    const auto minus = GetParam().measure(scene);
    ASSERT_EQ(plus.size(), minus.size());
    for (std::size_t i = 0; i < plus.size(); ++i)
      ASSERT_EQ(plus[i].value, (plus[i].is_odd ? -1.0 : 1.0) * minus[i].value) << i;
  });
}

INSTANTIATE_TEST_SUITE_P(Engines, Symmetry, rows_where([](const Measurement& row) { return row.is_history; }),
                         name_of_row);

// Other units.

double factor(const Units& units, const Dimension& dimension) {
  return std::pow(units.length, dimension.length) * std::pow(units.mass, dimension.mass) *
         std::pow(units.time, dimension.time);
}

class UnitChange : public Transformation {};

STICKSLIP_VERIFIES(UnitChange, "M1");
TEST_P(UnitChange, ByPowersOfTwoChangesNoBit) {
  std::size_t quantities = 0;
  on_random_beams(GetParam().beams, GetParam().force, [&](const data::Beam& beam, RandomNumbers& numbers) {
    Units units = random_powers_of_two(numbers);
    if (!GetParam().is_exact_in_mass) units.mass = 1.0;
    Scene scene = scene_of(GetParam(), beam, numbers);
    scene.has_threshold = true;
    const auto here = GetParam().measure(scene);
    scene.problem = in_units(units, scene.problem);
    const auto there = GetParam().measure(scene);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t i = 0; i < here.size(); ++i)
      ASSERT_EQ(here[i].value * factor(units, here[i].dimension), there[i].value) << i;
    quantities += here.size();
  });
  EXPECT_GE(quantities, GetParam().least_quantities);
}

INSTANTIATE_TEST_SUITE_P(Engines, UnitChange, ::testing::ValuesIn(measurements()), name_of_row);

// In mm, t, s, or with another material, section and length.

class Similarity : public Transformation {};

STICKSLIP_VERIFIES(Similarity, "M1");
TEST_P(Similarity, FixesAllButTheUnits) {
  int compared = 0;
  on_random_beams(
      GetParam().similar_beams, GetParam().force, [&](const data::Beam& beam, RandomNumbers& numbers) {
        Scene scene = scene_of(GetParam(), beam, numbers);
        scene.periods = 1.5;
        scene.measures_errors = true;
        const auto here = GetParam().measure(scene);
        scene.measures_errors = false;
        for (const auto& [other, units] : similar_beams(numbers, beam)) {
          Scene similar = scene;
          similar.problem = in_units(units, scene.problem);
          similar.problem.structure = other;
          const auto there = GetParam().measure(similar);
          ASSERT_EQ(here.size(), there.size());
          for (std::size_t i = 0; i < here.size(); ++i) {
            if (!here[i].of_similar) continue;
            EXPECT_TRUE(
                within(there[i].value / factor(units, here[i].dimension), here[i].value, *here[i].of_similar))
                << i;
            ++compared;
          }
        }
      });
  EXPECT_GE(compared, 100);
}

INSTANTIATE_TEST_SUITE_P(Engines, Similarity,
                         rows_where([](const Measurement& row) { return row.similar_beams > 0; }),
                         name_of_row);

// Linearity in stick, and in slip without friction.

class Linearity : public Transformation {};

STICKSLIP_VERIFIES(Linearity, "M1");
TEST_P(Linearity, OfAmplitudeIsExact) {
  on_random_beams(GetParam().beams, GetParam().force, [&](const data::Beam& beam, RandomNumbers& numbers) {
    Scene scene = scene_of(GetParam(), beam, numbers);
    const auto once = GetParam().measure(scene);
    const data::Case problem = scene.problem;
    scene.problem = with_amplitude(problem, 2.0);
    const auto twice = GetParam().measure(scene);
    scene.problem = with_amplitude(problem, 3.0);
    const auto thrice = GetParam().measure(scene);
    for (std::size_t i = 0; i < once.size(); ++i) {
      ASSERT_EQ(twice.at(i).value, 2.0 * once[i].value) << i;
      if (once[i].condition == 0.0) continue;
      const double expected = 3.0 * once[i].value;
      EXPECT_TRUE(within(thrice.at(i).value, expected, round_off(1, once[i].condition, expected))) << i;
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Engines, Linearity, rows_where([](const Measurement& row) { return row.is_linear; }),
                         name_of_row);

EventDriven run(const ContactModel& model, double end) {
  EventDriven history(model);
  history.advance_to(end);
  return history;
}

// More friction, less amplitude or less time turns no stick into slip, and no slip comes earlier.

constexpr double never = std::numeric_limits<double>::infinity();

struct FirstSlip {
  std::string name;
  std::function<double(const data::Case&)> time;  ///< of the first slip within a period, s, or never
  /// The amplitude that takes the largest force to the friction limit, m.
  std::function<double(const data::Case&)> critical_amplitude;
};

data::Case over_a_period(const data::Case& problem) {
  return with_duration(with(problem, data::Damping()), period(problem.excitation()), 4);
}

double slip_by_criterion(const data::Case& problem) {
  const auto found = analytic::evaluate_criterion(over_a_period(problem));
  return found.verdict == analytic::Verdict::stick_slip ? 0.0 : never;
}

double critical_by_criterion(const data::Case& problem) {
  return analytic::evaluate_criterion(over_a_period(problem)).critical_amplitude.midpoint();
}

double stepped_slip(const data::Case& problem) {
  return solver::first_slip(with(problem, settings(problem, 1.0), data::Damping())).value_or(never);
}

double stepped_critical(const data::Case& problem) {
  const data::HarmonicExcitation unit(
      {.frequency_hz = problem.excitation().frequency_hz(), .amplitude = 1.0});
  return problem.contact.friction.static_coefficient() * problem.beam().axial_force() /
         solver::max_abs_friction_force(with(problem, unit, settings(problem, 1.0), data::Damping()));
}

double event_driven_slip(const data::Case& problem) {
  const EventDriven history = run(modal_model(problem), period(problem.excitation()));
  return history.events().empty() ? never : history.events().front().time;
}

const std::vector<FirstSlip> first_slips{{"Criterion", slip_by_criterion, critical_by_criterion},
                                         {"Stepped", stepped_slip, stepped_critical},
                                         {"EventDriven", event_driven_slip, {}}};

void PrintTo(const FirstSlip& row, std::ostream* stream) { *stream << row.name; }

class Monotonicity : public ::testing::TestWithParam<FirstSlip> {};

STICKSLIP_VERIFIES(Monotonicity, "M1");
TEST_P(Monotonicity, OfTheFirstSlip) {
  on_random_beams(15, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const data::Case problem = slipping(beam, numbers);
    const auto slip_at = [&](double friction, double share) {
      data::Case varied = with_amplitude(problem, share);
      varied.contact.friction =
          data::FrictionLaw({.static_coefficient = friction * problem.contact.friction.static_coefficient()});
      return GetParam().time(varied);
    };
    double by_friction = 0.0, by_amplitude = never;
    for (int i = -4; i <= 4; ++i) {
      const double factor = std::pow(2.0, 0.5 * i), friction = slip_at(factor, 1.0),
                   share = slip_at(1.0, factor);
      EXPECT_GE(friction, by_friction);
      EXPECT_LE(share, by_amplitude);
      by_friction = friction, by_amplitude = share;
    }
    EXPECT_EQ(by_friction, never);
    EXPECT_LT(by_amplitude, period(problem.excitation()));
  });
}

// Of the engines that know forces besides those of their own run.
class CriticalAmplitude : public Monotonicity {};

STICKSLIP_VERIFIES(CriticalAmplitude, "M1");
TEST_P(CriticalAmplitude, IsWhereSlipBegins) {
  on_random_beams(20, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const data::Case problem = off_resonance(beam, numbers);
    const double share = GetParam().critical_amplitude(problem) / problem.excitation().amplitude();
    EXPECT_EQ(GetParam().time(with_amplitude(problem, share * (1.0 - 1e-9))), never);
    EXPECT_LT(GetParam().time(with_amplitude(problem, share * (1.0 + 1e-9))), never);
  });
}

INSTANTIATE_TEST_SUITE_P(Engines, Monotonicity, ::testing::ValuesIn(first_slips), name_of_row);
INSTANTIATE_TEST_SUITE_P(Engines, CriticalAmplitude, ::testing::Values(first_slips[0], first_slips[1]),
                         name_of_row);

// Time shift: the load is periodic, and antiperiodic in half a period.

STICKSLIP_VERIFIES(TimeShift, "M1");
constexpr double amplitude_change = 1e-8;

/// The history of a model from the state that another run has reached, seen with a sign.
EventDriven continued(const ContactModel& model, const EventDriven& from, double sign, double end) {
  const auto seen = [sign](std::vector<double> values) {
    for (double& value : values) value *= sign;
    return values;
  };
  EventDriven rest(model);
  if (from.state() == data::ContactState::stick) {
    rest.start_stuck(seen(from.amplitudes()), seen(from.rates()), sign * from.contact_position());
  } else {
    rest.start_slipping(seen(from.amplitudes()), seen(from.rates()), sign * from.contact_position(),
                        sign * from.sliding_velocity());
  }
  rest.advance_to(end);
  return rest;
}

TEST(TimeShift, OfAPeriodRestartsTheHistory) {
  int events = 0;
  on_random_beams(20, compression, [&](const data::Beam& beam, RandomNumbers& numbers) {
    const data::Case problem = slipping(beam, numbers);
    const double cycle = period(problem.excitation());
    const ContactModel model = modal_model(problem);
    const auto whole = run(model, 2.5 * cycle).events();
    const auto perturbed =
        run(modal_model(with_amplitude(problem, 1.0 + amplitude_change)), 2.5 * cycle).events();
    for (const double sign : {1.0, -1.0}) {
      const double shift = sign > 0.0 ? cycle : 1.5 * cycle;
      const EventDriven before = run(model, shift);
      const EventDriven rest = continued(model, before, sign, 2.5 * cycle - shift);
      // The events of the whole run, those before the shift as they were.
      auto computed = before.events();
      for (const data::ContactEvent& event : rest.events())
        computed.push_back({event.change, event.time + shift, sign * event.position});
      expect_same_events(computed, whole,
                         {perturbed, amplitude_change, event_driven_error, problem.excitation().amplitude()});
      events += static_cast<int>(rest.events().size());
    }
  });
  EXPECT_GT(events, 100);
}

// At P = 0 the stick state is the slip state with one constraint (Cauchy): the frequencies of the beam interlace, and all of any
// mesh.

STICKSLIP_VERIFIES(Interlacing, "M2");
TEST(Interlacing, OfAllFrequenciesOfBeamAndMesh) {
  const auto expect_interlaced = [](const auto& stick, const auto& slip, auto frequency) {
    for (std::size_t n = 0; n < stick.size(); ++n) {
      EXPECT_LT(std::invoke(frequency, slip.at(n)), std::invoke(frequency, stick[n])) << n;
      EXPECT_LT(std::invoke(frequency, stick[n]), std::invoke(frequency, slip.at(n + 1))) << n;
    }
  };
  on_random_beams(50, no_force, [&](const data::Beam& beam, RandomNumbers& numbers) {
    expect_interlaced(analytic::stick_modes(beam, 30), analytic::slip_modes(beam, 31),
                      [](const auto& mode) { return mode.angular_frequency(); });
    const int elements = numbers.whole(2, 8);
    const solver::BeamModel model(beam, elements);
    expect_interlaced(solver::stick_modes(model, 2 * elements - 1), solver::slip_modes(model, 2 * elements),
                      &solver::FiniteElementMode::angular_frequency);
  });
}

// Betti: a force at a node, with the tip held, moves another as far as the same force there moves it.
STICKSLIP_VERIFIES(Reciprocity, "M2");
TEST(Reciprocity, HoldsInStickAtRestAndInVibration) {
  on_random_beams(60, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const solver::BeamModel model(beam, numbers.whole(3, 8));
    const double hz = random_frequency_hz(numbers, stick_frequencies(beam, 4), 0.05);
    for (const double omega : {0.0, 2.0 * pi * hz}) {
      Eigen::MatrixXd held = model.stick_stiffness() - omega * omega * model.mass();
      held.row(model.tip_deflection()).setZero();
      held.col(model.tip_deflection()).setZero();
      held(model.tip_deflection(), model.tip_deflection()) = 1.0;
      const Eigen::MatrixXd flexibility = held.inverse();
      for (Eigen::Index i = 0; i < model.tip_deflection(); i += 2)
        for (Eigen::Index j = 0; j < i; j += 2) {
          const double scale =
              std::sqrt(std::abs(flexibility(i, i) * flexibility(j, j))) + std::abs(flexibility(i, j));
          EXPECT_TRUE(
              within(flexibility(i, j), flexibility(j, i),
                     round_off(1, std::pow(model.elements(), 4) * nearness_of_buckling(beam), scale)));
        }
    }
  });
}

}  // namespace
}  // namespace stickslip::testing
