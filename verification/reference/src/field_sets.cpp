// SPDX-License-Identifier: MIT
/// The data sets of the damped steady state, and of runs without a mesh on modes of the continuous beam: events,
/// histories, whole fields and energies.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "sets.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/held_beam.hpp"
#include "studies/history/method.hpp"
#include "studies/verification/damped_benchmark.hpp"
#include "studies/verification/finite_element_contact_model.hpp"

namespace stickslip::reference {

namespace {

// The state of the beam at one time, with y and y_t at some points.
struct BeamState {
  bool is_stuck{};
  double friction_force{}, tip_displacement{};
  std::vector<double> displacement, velocity;
  analytic::EventDrivenEnergy energy;
};

std::vector<BeamState> beam_states(const data::Case& problem, int modes, const std::vector<double>& times,
                                   const std::vector<double>& points, bool has_energy = false) {
  const analytic::HeldBeam beam(problem.beam(), problem.damping, modes);
  analytic::EventDriven run(analytic::contact_model(beam.structure(), problem),
                            {.keep_energy_balance = has_energy});
  const double omega = 2.0 * std::numbers::pi * problem.excitation().frequency_hz();
  std::vector<BeamState> states;
  for (const double time : times) {
    run.advance_to(time);
    BeamState& state = states.emplace_back();
    state.is_stuck = run.state() == data::ContactState::stick;
    state.friction_force = -run.friction_force();
    state.tip_displacement = run.contact_position();
    if (has_energy) state.energy = run.energy_balance();
    for (const double x : points) {
      const std::vector<double> shape = beam.shapes(x);
      state.displacement.push_back(analytic::absolute_displacement(shape, run));
      double velocity = problem.excitation().amplitude() * omega * std::cos(omega * time) +
                        shape.back() * run.contact_velocity();
      for (std::size_t n = 0; n + 1 < shape.size(); ++n) velocity += shape[n] * run.rates()[n];
      state.velocity.push_back(velocity);
    }
  }
  return states;
}

std::vector<double> equal_times(double step, int count) {
  std::vector<double> times;
  for (int k = 1; k <= count; ++k) times.push_back(step * k);
  return times;
}

struct FieldQuantity {
  std::string name, unit, description;
  double tolerance{}, least{};  // of the largest value; the least half-width
  std::function<double(const BeamState&)> value;
};

constexpr int fine_modes = 40, coarse_modes = 28;
constexpr double slip_duration = 0.5;  // s

bool slips(const data::Case& problem) { return problem.name == "damped"; }

// The problem of a run, and how its values were found.
void state_run(data::Resource& resource, const data::Case& problem) {
  resource.problem =
      problem_of(problem, "paper", slips(problem) ? "friction" : "held",
                 {{"/duration", slips(problem) ? fmt::format("{}", slip_duration) : std::string("1")}});
  resource.provenance = converged_by(
      "event-driven integration on 40 modes of the continuous beam, held while it sticks, and the static "
      "shape: exact in stick, Runge-Kutta of order 8 in slip. The half-width is the largest difference to 28 "
      "modes, in the phase or at the time; the error falls faster than the third power of their number",
      R"({"modes": 40, "fewer_modes": 28, "tolerance": 1e-12})",
      {"finite elements, to their order, in fields"});
}

// The largest difference of a quantity in a phase from `first` to `end`, without samples in different states.
double phase_half_width(const FieldQuantity& quantity, const std::vector<BeamState>& fine,
                        const std::vector<BeamState>& coarse, std::size_t first, std::size_t end) {
  double radius = quantity.least;
  for (std::size_t i = first; i < end; ++i)
    if (coarse[i].is_stuck == fine[i].is_stuck)
      radius = std::max(radius, std::abs(quantity.value(fine[i]) - quantity.value(coarse[i])));
  return radius;
}

struct Sampling {
  double step{};  // s
  int count{};
  int decimals{3};  // of the times
};

// A history at equal times. The half-width is the difference between 40 and 28 modes, the largest in the phase of
// stick or slip. Samples at which they are in different phases are left out.
DataSet history_of(DataSet set, const data::Case& problem, const Sampling& sampling,
                   const std::vector<FieldQuantity>& quantities, bool has_energy = false) {
  data::Resource& resource = set.resource;
  state_run(resource, problem);
  set_key(resource, {exact_number("time", "s", "since the start")});
  if (slips(problem)) resource.fields.push_back(word("phase", "of the contact", {"stick", "slip"}));
  std::vector<Value> values;
  for (const FieldQuantity& quantity : quantities)
    values.push_back({quantity.name, quantity.unit, quantity.description, Norm::scale, quantity.tolerance});
  add_values(resource, ValueClass::converged, values);
  compare_along(resource, "time");
  if (slips(problem)) {
    resource.comparison->kind = data::ComparisonKind::phases;
    resource.comparison->events = "stick-slip-events";
    resource.comparison->horizon = slip_duration;
  }
  const std::vector<double> times = equal_times(sampling.step, sampling.count),
                            points{0.5 * problem.beam().length(), problem.beam().length()};
  const auto fine = beam_states(problem, fine_modes, times, points, has_energy);
  const auto coarse = beam_states(problem, coarse_modes, times, points, has_energy);
  for (std::size_t first = 0, end = 0; first < fine.size(); first = end) {
    while (end < fine.size() && fine[end].is_stuck == fine[first].is_stuck) ++end;
    std::vector<double> radii;
    for (const FieldQuantity& quantity : quantities)
      radii.push_back(phase_half_width(quantity, fine, coarse, first, end));
    for (std::size_t k = first; k < end; ++k) {
      if (coarse[k].is_stuck != fine[k].is_stuck) continue;
      std::vector<Cell> row{fmt::format("{:.{}f}", times[k], sampling.decimals)};
      if (slips(problem)) row.emplace_back(fine[k].is_stuck ? "stick" : "slip");
      for (std::size_t q = 0; q < quantities.size(); ++q)
        row.push_back(converged(quantities[q].value(fine[k]), radii[q]));
      add_row(set, row);
    }
  }
  return set;
}

data::Case held_problem(double kelvin_voigt) {
  return with_value(data::load_case("paper-figure9"), "damping.kelvin_voigt", kelvin_voigt);
}

constexpr double eta = 6.4e-5;
constexpr double velocity_rounding = 1e-11;

double midspan_velocity(const BeamState& state) { return state.velocity.front(); }
double wall_force(const BeamState& state) { return state.friction_force; }

// y and y_t at 21 points and ten times, at which 40 and 28 modes must be in the same phase.
DataSet fields_of(DataSet set, const data::Case& problem, double step) {
  data::Resource& resource = set.resource;
  state_run(resource, problem);
  set_key(resource,
          {exact_number("time", "s", "since the start"), exact_number("x", "m", "distance from the clamp")});
  add_values(resource, ValueClass::converged,
             {{"displacement", "m", "y(x, t), absolute", Norm::scale, 1e-2},
              {"velocity", "m/s", "y_t(x, t), absolute", Norm::scale, 1e-2}});
  std::vector<double> points;
  for (int k = 0; k <= 20; ++k) points.push_back(problem.beam().length() * k / 20.0);
  const std::vector<double> times = equal_times(step, 10);
  const auto fine = beam_states(problem, fine_modes, times, points);
  const auto coarse = beam_states(problem, coarse_modes, times, points);
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (fine[k].is_stuck != coarse[k].is_stuck) throw std::runtime_error("the runs are in different phases");
    double displacement = 1e-13, velocity = velocity_rounding;
    for (std::size_t i = 0; i < points.size(); ++i) {
      displacement = std::max(displacement, std::abs(fine[k].displacement[i] - coarse[k].displacement[i]));
      velocity = std::max(velocity, std::abs(fine[k].velocity[i] - coarse[k].velocity[i]));
    }
    for (std::size_t i = 0; i < points.size(); ++i)
      add_row(set,
              {fmt::format("{:.3f}", times[k]), points[i], converged(fine[k].displacement[i], displacement),
               converged(fine[k].velocity[i], velocity)});
  }
  return set;
}

DataSet stick_velocities() {
  return history_of(
      data_set("stick-velocities", "stick/velocities.csv", "Velocities of the held beam",
               "The velocity at the middle of the beam of stick-history, every 5 ms."),
      held_problem(0.0), {5e-3, 200},
      {{"midspan_velocity", "m/s", "y_t(L/2, t), absolute", 1e-3, velocity_rounding, midspan_velocity}});
}

DataSet damped_stick_history() {
  return history_of(
      data_set("damped-stick-history", "stick/damped.csv", "The held beam with damping",
               "stick-history with Kelvin-Voigt damping of 0.5 % of critical in the first mode, every 5 ms."),
      held_problem(eta), {5e-3, 200},
      {{"midspan_displacement", "m", "y(L/2, t), absolute", 1e-3, 1e-16,
        [](const BeamState& state) { return state.displacement.front(); }},
       {"friction_force", "N", "f(t), of the tip on the wall", 2e-2, 1e-9, wall_force}});
}

// The events of the case damped, and their half-widths.
const studies::DampedBenchmark& benchmark() {
  static const studies::DampedBenchmark known = [] {
    auto made = studies::damped_benchmark(data::load_case("damped"), {.duration = slip_duration,
                                                                      .modes = fine_modes,
                                                                      .other_modes = {},
                                                                      .event_driven_elements = {},
                                                                      .elements = {},
                                                                      .time_steps = {}});
    if (made.tolerance_effect > 1e-9)
      throw std::runtime_error("the events of the damped benchmark depend on the integrator's tolerance");
    return made;
  }();
  return known;
}

data::Provenance benchmark_provenance() {
  return converged_by(
      "event-driven integration on the modes of the continuous beam, held while it sticks: exact in stick, "
      "Runge-Kutta of order 8 in slip. The error falls faster than the third power of the number of modes; "
      "the half-width is the difference to 28 modes, of which at most 0.55 are left",
      R"({"modes": 40, "fewer_modes": 28, "tolerance": 1e-12, "shortest_stick": 2e-5})",
      {"finite elements with generalised-alpha converge to it in mesh and step",
       "the same method on finite elements converges to it",
       "a hundred times the tolerance changes no event by 1e-9 s"});
}

DataSet stick_slip_events() {
  DataSet set = data_set(
      "stick-slip-events", "stick-slip/events.csv", "Onsets and captures of the damped stick-slip vibration",
      "The paper's beam at 25 Hz and 1 mm with Kelvin-Voigt damping of 0.5 % of critical in the first mode "
      "(case damped), with the tip at rest at the start. Stick phases shorter than 2e-5 s count as part of "
      "the slip round them.");
  data::Resource& resource = set.resource;
  resource.fields = {integer("index", "number of the event, from 1"),
                     word("change", "onset of slip, or capture", {"onset", "capture"})};
  resource.primary_key = {"index"};
  add_values(resource, ValueClass::converged,
             {{"time", "s", "of the event", Norm::absolute, 8e-5},
              {"position", "m", "y(L), of the tip in the fixed frame", Norm::absolute, 1e-5}});
  resource.comparison->kind = data::ComparisonKind::events;
  resource.comparison->horizon = slip_duration;
  resource.comparison->shortest_phase = 2e-5;
  resource.diagnosis = in_case("contact event", "damped", "index", "time");
  state_run(resource, data::load_case("damped"));
  resource.provenance = benchmark_provenance();
  int index = 0;
  for (const data::ContactEvent& event : benchmark().events) {
    const auto& [time, position] = benchmark().uncertainties[static_cast<std::size_t>(index)];
    add_row(set, {++index, std::string(data::to_string(event.change)),
                  converged(event.time, time + benchmark().tolerance_effect),
                  converged(event.position, position + 1e-13)});
  }
  return set;
}

DataSet stick_slip_history() {
  DataSet set = history_of(
      data_set("stick-slip-history", "stick-slip/history.csv", "The damped stick-slip vibration in time",
               "The tip and the friction force of stick-slip-events, phase by phase: between an event here "
               "and the same one elsewhere the two are in different states, and nothing can be compared. "
               "Samples at which 28 and 40 modes are in different states are left out."),
      data::load_case("damped"), {2e-4, 2500, 4},
      {{"tip_displacement", "m", "y(L, t), in the fixed frame", 1e-2, 1e-13,
        [](const BeamState& state) { return state.tip_displacement; }},
       {"friction_force", "N", "f(t), of the tip on the wall", 5e-2, 1e-9, wall_force}});
  set.resource.diagnosis = in_case("tip displacement", "damped", "time", "tip_displacement");
  set.resource.provenance = benchmark_provenance();
  set.resource.fields.push_back(exact_number("event_distance", "s", "to the nearest event"));
  for (std::vector<std::string>& row : set.rows) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const data::ContactEvent& event : benchmark().events)
      nearest = std::min(nearest, std::abs(event.time - std::stod(row.front())));
    row.push_back(fmt::format("{:.3e}", nearest));
  }
  return set;
}

DataSet stick_slip_velocities() {
  return history_of(
      data_set("stick-slip-velocities", "stick-slip/velocities.csv",
               "Velocities in damped stick-slip vibration",
               "The tip and the middle of the beam of stick-slip-history, every 2 ms, phase by phase."),
      data::load_case("damped"), {2e-3, 250},
      {{"tip_velocity", "m/s", "y_t(L, t), the sliding velocity", 2e-2, velocity_rounding,
        [](const BeamState& state) { return state.is_stuck ? 0.0 : state.velocity.back(); }},
       {"midspan_velocity", "m/s", "y_t(L/2, t), absolute", 2e-2, velocity_rounding, midspan_velocity}});
}

DataSet stick_slip_energy() {
  using Energy = analytic::EventDrivenEnergy;
  const auto quantity = [](std::string name, std::string description, double Energy::*member) {
    return FieldQuantity{
        std::move(name), "J", std::move(description), 2e-2, 1e-12, [member](const BeamState& state) {
          return state.energy.*member;
        }};
  };
  return history_of(
      data_set("stick-slip-energy", "stick-slip/energy.csv", "Energies of the damped stick-slip vibration",
               "Of the beam of stick-slip-history, every 10 ms, in the frame of the base. Kinetic and "
               "potential energy change by the two works less the two losses. At t = 0 the kinetic energy is "
               "0.0580633362 J, and all others are 0."),
      data::load_case("damped"), {1e-2, 50},
      {quantity("kinetic_energy", "integral of rho A u_t^2/2", &Energy::kinetic),
       quantity("potential_energy", "integral of (EI u_xx^2 - P u_x^2)/2", &Energy::potential),
       quantity("base_work", "of -rho A h_tt on u_t and of f on h_t, since the start", &Energy::base_work),
       quantity("follower_work", "of -P u_x(L) on u_t(L), since the start", &Energy::follower_work),
       quantity("damping_loss", "integral of EI eta u_xxt^2, since the start", &Energy::damping_loss),
       quantity("friction_loss", "of f on y_t(L), since the start", &Energy::friction_loss)},
      true);
}

// y(L), y(L/2) and f at 64 equal times per period of the base.
constexpr int per_period = 64, first_period = 250, last_period = 500;
using Samples = std::array<std::vector<double>, 3>;

Samples samples_of(const studies::History& motion, const studies::History& forces) {
  Samples samples;
  for (const studies::HistoryRow& row : motion.rows) {
    samples[0].push_back(row.displacement.front());
    samples[1].push_back(row.midspan_displacement);
  }
  for (const studies::HistoryRow& row : forces.rows) samples[2].push_back(row.friction_force);
  return samples;
}

studies::Sampling at_samples(const data::Case& problem, const std::function<double(int)>& time) {
  studies::Sampling sampling{.positions = {problem.beam().length()}};
  for (int i = first_period * per_period; i < last_period * per_period; ++i)
    sampling.times.push_back(time(i));
  return sampling;
}

Samples event_driven_samples(const data::Case& problem, int modes) {
  const double rate = per_period * problem.excitation().frequency_hz();
  const studies::History history =
      studies::event_driven_history(data::with_value(problem, "numerics.modes", modes),
                                    at_samples(problem, [rate](int i) { return i / rate; }));
  return samples_of(history, history);
}

// By generalised-alpha; the force, which has peaks far above mu_s P in its steps, from event to event.
Samples finite_element_samples(data::Case problem, int elements, int steps, int force_elements) {
  const double step = 1.0 / (steps * per_period * problem.excitation().frequency_hz());
  problem = with_value(with_value(problem, "numerics.elements", elements), "numerics.time_step", step);
  const studies::Sampling sampling = at_samples(problem, [&](int i) { return i * steps * step; });
  return samples_of(studies::finite_element_history(problem, sampling),
                    studies::event_driven_history(
                        studies::finite_element_contact_model(problem, force_elements), sampling.times));
}

// The amplitude at `cycles` per period of the base, with the weights 1 - cos of Hann.
double amplitude_at(const std::vector<double>& samples, double cycles) {
  std::complex<double> sum;
  const auto count = static_cast<double>(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double at = static_cast<double>(i);
    sum += (1.0 - std::cos(2.0 * std::numbers::pi * at / count)) * samples[i] *
           std::polar(1.0, -2.0 * std::numbers::pi * cycles * at / per_period);
  }
  return 2.0 * std::abs(sum) / count;
}

// The parts in the order of their words.
std::vector<double> parts_of(const std::vector<double>& samples) {
  std::vector<double> squares;
  for (const double value : samples) squares.push_back(value * value);
  std::vector<double> parts{std::sqrt(0.5 * amplitude_at(squares, 0.0))};
  double largest = 0.0;
  for (int i = 3600; i <= 4000; ++i)  // 9 to 10 Hz
    largest = std::max(largest, amplitude_at(samples, 1e-4 * i));
  parts.push_back(largest);
  for (const int harmonic : {1, 3, 5, 7}) parts.push_back(amplitude_at(samples, harmonic));
  return parts;
}

DataSet stick_slip_spectrum() {
  const std::vector<std::string> words{"rms",        "self-excited", "harmonic-1",
                                       "harmonic-3", "harmonic-5",   "harmonic-7"};
  DataSet set =
      data_set("stick-slip-spectrum", "stick-slip/spectrum.csv", "The steady damped stick-slip vibration",
               "The beam of stick-slip-history from 10 to 20 s. Its motion is steady, but not periodic: "
               "beside the odd harmonics of 25 Hz it has a self-excited vibration of 9.5 Hz. Of the 64 "
               "samples per period z_i at t_i = 10 s + i/(64 f0), with the weights w_i = 1 - cos(2 pi "
               "i/16000): rms is the root of the weighted mean sum w_i z_i^2/sum w_i, an amplitude |2 sum "
               "w_i z_i exp(-2 pi sqrt(-1) f t_i)|/sum w_i, at f = n f0 for harmonic-n, and its largest over "
               "9 to 10 Hz for self-excited.");
  data::Resource& resource = set.resource;
  const data::Case problem = data::load_case("damped");
  set_key(resource, {word("part", "of the spectrum", words)});
  add_values(resource, ValueClass::converged,
             {{"tip_amplitude", "m", "of y(L)", Norm::scale, 5e-3},
              {"midspan_amplitude", "m", "of y(L/2)", Norm::scale, 5e-3},
              {"force_amplitude", "N", "of f", Norm::scale, 5e-3}});
  resource.problem = problem_of(problem, "paper", "friction", {{"/duration", "20"}});
  resource.provenance = converged_by(
      "event-driven integration on 28 modes of the continuous beam. The half-width is twice the larger of "
      "the differences to 20 modes and to finite elements: displacements with generalised-alpha, forces from "
      "event to event",
      R"({"modes": 28, "fewer_modes": 20, "elements": 40, "time_step": 2.5e-5, "event_driven_elements": 16})",
      {"two implementations that share nothing", "the same from 20 to 30 and from 30 to 40 s, to 1e-4"});
  const Samples fine = event_driven_samples(problem, 28), coarse = event_driven_samples(problem, 20),
                mesh = finite_element_samples(problem, 40, 25, 16);
  std::array<std::vector<double>, 3> values, half_widths;
  for (std::size_t q = 0; q < 3; ++q) {
    values[q] = parts_of(fine[q]);
    const auto fewer = parts_of(coarse[q]), other = parts_of(mesh[q]);
    for (std::size_t i = 0; i < words.size(); ++i)
      half_widths[q].push_back(
          2.0 * std::max(std::abs(values[q][i] - fewer[i]), std::abs(values[q][i] - other[i])));
  }
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::vector<Cell> row{words[i]};
    for (std::size_t q = 0; q < 3; ++q) row.push_back(converged(values[q][i], half_widths[q][i]));
    add_row(set, row);
  }
  return set;
}

DataSet stick_fields() {
  return fields_of(data_set("stick-fields", "stick/fields.csv", "The whole held beam at ten times",
                            "The displacement and the velocity of the beam of stick-history at 21 points."),
                   held_problem(0.0), 0.1);
}

DataSet stick_slip_fields() {
  return fields_of(
      data_set(
          "stick-slip-fields", "stick-slip/fields.csv", "The whole beam in damped stick-slip vibration",
          "The displacement and the velocity of the beam of stick-slip-history at 21 points and ten times."),
      data::load_case("damped"), 0.05);
}

DataSet damped_steady_state() {
  DataSet set = data_set(
      "damped-steady-state", "stick/damped-steady-state.csv", "Steady vibration of the held, damped beam",
      "The paper's beam with Kelvin-Voigt damping at 0.5 mm after its free vibrations have died out, tip "
      "held: y(L/2) = amplitude sin(2 pi f0 t + phase), f likewise, and the heat of a period.");
  data::Resource& resource = set.resource;
  set_key(resource, {exact_number("frequency", "Hz", "f0, of the base")});
  add_values(resource, ValueClass::converged,
             {{"midspan_amplitude", "m", "of y(L/2), absolute", Norm::relative, 1e-3},
              {"midspan_phase", "rad", "of y(L/2)", Norm::absolute, 1e-3},
              {"force_amplitude", "N", "of f, the force of the tip on the wall", Norm::relative, 1e-2},
              {"force_phase", "rad", "of f", Norm::absolute, 1e-2},
              {"heat", "J", "by damping, per period", Norm::relative, 1e-2}});
  const data::Case problem = held_problem(eta);
  resource.problem = problem_of(
      problem, "paper", "held",
      {{"/excitation/frequency_hz", in_column("frequency")}, {"/initial_state", R"("none: steady state")"}});
  constexpr double relative = 1e-10;
  resource.provenance = converged_by(
      "the closed form with a complex rigidity EI (1 + 2 pi i f0 eta), in double precision. The half-width "
      "is 1e-10 of the value (of 1 rad), far above the rounding error times the resonance factor, which is "
      "at most 200",
      R"({"relative_half_width": 1e-10})", {"the harmonic response of finite elements, to their order"});
  for (int hz = 1; hz <= 120; ++hz) {
    const analytic::DampedSteadyState steady(
        problem.beam(), data::HarmonicExcitation({.frequency_hz = hz + 0.0, .amplitude = 5e-4}),
        problem.damping, analytic::TipSupport::held);
    const auto middle = steady.displacement(0.5 * problem.beam().length()), force = steady.friction_force();
    const double heat = steady.dissipated_energy();
    add_row(set,
            {hz, converged(std::abs(middle), relative * std::abs(middle)),
             converged(std::arg(middle), relative), converged(std::abs(force), relative * std::abs(force)),
             converged(std::arg(force), relative), converged(heat, relative * heat)});
  }
  return set;
}

}  // namespace

std::vector<Recipe> field_sets() {
  return {
      {"stick-velocities", stick_velocities, true, 160},
      {"stick-fields", stick_fields, true, 170},
      {"damped-stick-history", damped_stick_history, true, 180},
      {"damped-steady-state", damped_steady_state, true, 190},
      {"stick-slip-events", stick_slip_events, false, 220},
      {"stick-slip-history", stick_slip_history, false, 230},
      {"stick-slip-velocities", stick_slip_velocities, false, 240},
      {"stick-slip-fields", stick_slip_fields, false, 250},
      {"stick-slip-energy", stick_slip_energy, false, 260},
      {"stick-slip-spectrum", stick_slip_spectrum, false, 270},
  };
}

}  // namespace stickslip::reference
