// SPDX-License-Identifier: MIT
#include "studies/analyses/problem_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stickslip/analytic/stick_reaction.hpp"
#include "stickslip/solver/base_motion.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/analyses/squeal.hpp"
#include "studies/common/bisection.hpp"
#include "studies/common/discretisation.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/contact_growth.hpp"
#include "studies/history/history_convergence.hpp"

namespace stickslip::studies {

namespace {

using std::numbers::pi;

// The largest relative error of the frequency, and of the amplitude per period, that a time step may cause.
constexpr double allowed_step_error = 0.01;
// A resonant response gives a warning from this multiple of the quasi-static response on.
constexpr double grown_response = 10.0;
constexpr double allowed_growth = 36.0;  // of σ* T
// The largest number of elements or modes for which growth_warning() computes σ*.
constexpr int most_undamped_for_growth = 200, most_damped_for_growth = 50;

std::string percent(double share) { return fmt::format("{:.2g} %", 100.0 * share); }

// The value rounded down to two significant digits.
double two_digits(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::floor(value / unit * (1.0 + 1e-12)) * unit;
}

// The largest time step at which step_error() is not above allowed_step_error.
double allowed_step(double spectral_radius, double omega) {
  const auto is_allowed = [&](double angle) {  // ω h
    return step_error(spectral_radius, 1.0, angle) <= allowed_step_error;
  };
  return two_digits(bracketed(0.0, 2.0 * pi, is_allowed).first / omega);
}

}  // namespace

std::optional<Warning> resonance_warning(const data::Case& problem) {
  const double omega = angular_frequency(problem.excitation()), duration = problem.numerics.duration();
  if (problem.is_damped() || problem.excitation().amplitude() == 0.0 ||
      0.5 * omega * duration < grown_response)
    return std::nullopt;
  int count = problem.numerics.modes();  // also those that are left out
  auto modes = analytic::held_modes(problem, count);
  if (modes.empty()) return std::nullopt;
  while (modes.back().angular_frequency < 2.0 * omega && count < 500)
    modes = analytic::held_modes(problem, count *= 2);
  const auto nearest = std::ranges::min_element(
      modes, {}, [&](const auto& mode) { return std::abs(mode.angular_frequency - omega); });
  const double difference = std::abs(nearest->angular_frequency - omega);
  const double nearest_hz = nearest->angular_frequency / (2.0 * pi);
  if (difference * duration > pi) return std::nullopt;
  const std::string end =
      difference * duration < 1e-6 ? "without end" : fmt::format("until {:.3g} s", pi / difference);
  return Warning{Concern::resonance, problem.excitation().frequency_hz(), nearest_hz,
                 fmt::format("excitation.frequency_hz is {}, next to natural frequency {} of the stick "
                             "state, {:.7g} Hz: the reaction of the undamped beam grows with t, {}, so that "
                             "its maximum depends on excitation.duration, {} s",
                             data::shortest_text(problem.excitation().frequency_hz()),
                             nearest - modes.begin() + 1, nearest_hz, end, data::shortest_text(duration))};
}

namespace {

void warn_of_distance(const data::Case& problem, std::vector<Warning>& warnings) {
  const double omega = angular_frequency(problem.excitation());
  const auto distance = [&](const analytic::ModalForce& mode) {
    return std::hypot(mode.angular_frequency / omega - 1.0, problem.damping.ratio_at(mode.angular_frequency));
  };
  const auto modes = analytic::held_modes(problem, problem.numerics.modes());
  const auto nearest = std::ranges::min_element(modes, {}, distance);
  if (modes.empty() || problem.excitation().amplitude() == 0.0 ||
      distance(*nearest) >= least_resonance_distance)
    return;
  const double share = nearest->angular_frequency / omega - 1.0;
  warnings.push_back({Concern::near_resonance, std::abs(share), least_resonance_distance,
                      fmt::format("natural frequency {} is only {} from excitation.frequency_hz: 1 % of "
                                  "error in it changes the force by up to {:.2g} %; keep {} away",
                                  nearest - modes.begin() + 1, percent(std::abs(share)),
                                  1.0 / distance(*nearest), percent(least_resonance_distance))});
}

void warn_of_thickness(const data::Case& problem, bool slip, int mode, std::vector<Warning>& warnings) {
  if (problem.model() != nullptr || problem.has(data::Feature::shear)) return;
  const data::Beam& beam = problem.beam();
  const double error = slip ? slip_model_error(beam, mode) : stick_model_error(beam, mode);
  if (error <= allowed_model_error) return;
  const double radius = std::sqrt(beam.second_moment_of_area() / beam.area());
  warnings.push_back(
      {Concern::thick_beam, error, allowed_model_error,
       fmt::format("the beam is thick for Euler-Bernoulli, sqrt(I/A)/L = {:.3g}: without shear and rotary "
                   "inertia its natural frequency {} comes out about {} too high",
                   radius / beam.length(), mode, percent(error))});
}

// Of that mode of the held contact, rad/s; 0 if there is none.
double natural_frequency(const data::Case& problem, int mode) {
  const auto modes = analytic::held_modes(problem, mode);
  return modes.empty() ? 0.0 : modes.back().angular_frequency;
}

void warn_of_step(const data::Case& problem, int mode, std::vector<Warning>& warnings) {
  const double natural = natural_frequency(problem, mode);
  const double excitation = angular_frequency(problem.excitation());
  const double omega = std::max(natural, excitation), step = problem.numerics.time_step();
  const double error = step_error(problem.numerics.spectral_radius(), omega, step);
  if (error <= allowed_step_error) return;
  const double suggested = allowed_step(problem.numerics.spectral_radius(), omega);
  const std::string what =
      natural > excitation ? fmt::format("natural frequency {}", mode) : "the excitation";
  warnings.push_back(
      {Concern::long_step, step, suggested,
       fmt::format("numerics.time_step is {} s, too long for {} at {:.4g} Hz: it changes the frequency or "
                   "the amplitude per period by {}; a step of {:.2g} s changes them by {}",
                   data::shortest_text(step), what, omega / (2.0 * pi), percent(error), suggested,
                   percent(allowed_step_error))});
}

}  // namespace

double step_error(double spectral_radius, double omega, double time_step) {
  const auto exponent = generalized_alpha_exponent(spectral_radius, omega, time_step);
  return std::max(std::abs(exponent.imag() / omega - 1.0), -std::expm1(2.0 * pi * exponent.real() / omega));
}

int highest_mode_that_matters(const data::Case& problem) {
  const auto vibrations = analytic::free_vibrations(problem);
  for (std::size_t n = vibrations.size(); n > 1; --n)
    if (vibrations[n - 1].share > share_that_matters) return static_cast<int>(n);
  return 1;
}

namespace {

double row_effect(const data::Case& problem, const std::vector<analytic::FreeVibration>& vibrations,
                  double apart) {
  const auto lost = [&](double omega) { return 1.0 - std::cos(std::min(pi, 0.5 * omega * apart)); };
  double effect = lost(angular_frequency(problem.excitation()));
  for (const auto& [omega, share] : vibrations) effect += share * lost(omega);
  return effect;
}

// The sum of coarse_mesh_warning().
double mesh_effect(const data::Case& problem, const std::vector<analytic::FreeVibration>& vibrations,
                   int elements) {
  const double element = problem.beam().length() / elements;
  double effect = mesh_frequency_error(problem.beam(), angular_frequency(problem.excitation()), element);
  effect += hermite_stick_error(problem.beam(), element);
  effect = std::min(1.0, effect);
  for (const auto& [omega, share] : vibrations) {
    const double decay = omega * problem.damping.ratio_at(omega);
    const double error = mesh_frequency_error(problem.beam(), omega, element),
                 time = std::min(problem.numerics.duration(), 1.0 / decay);
    effect += share * std::min(2.0, error * (1.0 + omega * time));
  }
  return effect;
}

void add_warning(std::optional<Warning> warning, std::vector<Warning>& warnings) {
  if (warning) warnings.push_back(std::move(*warning));
}

void warn_of_resonance_or_distance(const data::Case& problem, std::vector<Warning>& warnings) {
  const std::size_t before = warnings.size();
  add_warning(resonance_warning(problem), warnings);
  if (warnings.size() == before) warn_of_distance(problem, warnings);
}

}  // namespace

double row_effect(const data::Case& problem, double spacing) {
  return row_effect(problem, analytic::free_vibrations(problem), spacing);
}

std::optional<Warning> instability_warning(const data::Case& problem) {
  const auto found = slip_instability(problem);
  if (!found) return std::nullopt;
  const data::Beam& beam = problem.beam();
  const bool buckles = found->root.imag() == 0.0, is_sheared = beam.shear_stiffness() > 0.0,
             has_loss = problem.is_damped() || problem.contact.friction.viscous() > 0.0;
  const double unit = beam.youngs_modulus() * beam.second_moment_of_area() / (beam.length() * beam.length());
  return Warning{
      buckles ? Concern::buckling : Concern::flutter, beam.axial_force(), found->load,
      fmt::format(
          "beam.axial_force is {} N: from {:.4g} N on, {:.4g} E I/L^2, the sliding beam {}, {}damping and "
          "{}shear; once the tip slips, the motion grows without end, by a factor of e in {:.2g} s",
          data::shortest_text(beam.axial_force()), found->load, found->load / unit,
          buckles ? "buckles" : "flutters", has_loss ? "with its " : "without ",
          is_sheared ? "with its " : "without ", 1.0 / found->root.real())};
}

std::optional<Warning> few_modes_warning(const data::Case& problem) {
  if (problem.has(data::Feature::general_motion) || !(problem.normal_force() > 0.0) ||
      analytic::is_buckled(problem))
    return std::nullopt;
  const auto truncated = analytic::evaluate_criterion(problem, 1e-4),
             all = analytic::criterion_with_all_modes(problem, 1e-4);
  if (!too_few_modes(truncated, all)) return std::nullopt;
  const double mine = truncated.force_max.midpoint(), whole = all.force_max.midpoint();
  return Warning{
      Concern::few_modes, mine, whole,
      fmt::format("numerics.modes is {}, too few at {} Hz: the largest |f| is {:.3g} N with them, "
                  "and with all modes {:.3g} N, where the verdict is {}",
                  problem.numerics.modes(), data::shortest_text(problem.excitation().frequency_hz()), mine,
                  whole, to_string(all.verdict))};
}

std::optional<Warning> coarse_mesh_warning(const data::Case& problem) {
  constexpr int most_elements = 10'000;
  if (problem.model() != nullptr || problem.has(data::Feature::general_motion) ||
      analytic::is_buckled(problem))
    return std::nullopt;
  const auto vibrations = analytic::free_vibrations(problem);
  const double effect = mesh_effect(problem, vibrations, problem.numerics.elements());
  if (effect <= allowed_model_error) return std::nullopt;
  int enough = problem.numerics.elements() + 1;
  while (enough < most_elements && mesh_effect(problem, vibrations, enough) > allowed_model_error)
    enough += 1 + enough / 10;
  return Warning{
      Concern::coarse_mesh, effect, allowed_model_error,
      fmt::format("numerics.elements is {}, too few: the frequencies of the mesh may change the largest |f| "
                  "by up to {}; {} elements change it by {} at most",
                  problem.numerics.elements(), percent(effect), enough, percent(allowed_model_error))};
}

std::string shear_effect(const data::Case& problem) {
  const data::Case sheared = data::with(problem, with_shear(problem.beam()));
  const std::string choice =
      fmt::format("with beam.shear_stiffness = {:.3g} (k = 5/6, nu = 0.3)", sheared.beam().shear_stiffness());
  if (analytic::is_buckled(sheared)) return choice + " the beam buckles";
  const auto without = analytic::criterion_with_all_modes(problem, 1e-4),
             with = analytic::criterion_with_all_modes(sheared, 1e-4);
  return fmt::format("{} |f_max| with all modes is {:.4g} N instead of {:.4g} N, and the verdict is {}{}",
                     choice, with.force_max.midpoint(), without.force_max.midpoint(), to_string(with.verdict),
                     with.verdict == without.verdict
                         ? " as well"
                         : fmt::format(" instead of {}", to_string(without.verdict)));
}

std::vector<Warning> structure_warnings(const data::Case& problem) {
  std::vector<Warning> warnings;
  if (problem.model() == nullptr || problem.model()->is_mass()) return warnings;
  constexpr double lightest = 1e-3, heaviest = 1e4, rounding = 1e-6;
  const analytic::HeldStructure structure = analytic::held_structure(problem, 1);
  const double mass = structure.moved_mass, share = structure.base_stiffness / structure.contact_stiffness;
  if (mass < lightest || mass > heaviest)
    warnings.push_back({Concern::structure_mass, mass, mass < lightest ? lightest : heaviest,
                        fmt::format("{:.3g} kg move with base and contact: model.units tells whether the "
                                    "files are in m, kg, s or in mm, t, s",
                                    mass)});
  if (!problem.is_force() && std::abs(share) > rounding)
    warnings.push_back(
        {Concern::base_alone, share, rounding,
         fmt::format("moved with its base by 1 m the structure pulls by {:.3g} N at the contact, "
                     "{:.2g} times its stiffness there: more holds it than model.base",
                     structure.base_stiffness, share)});
  return warnings;
}

std::vector<Warning> criterion_warnings(const data::Case& problem) {
  std::vector<Warning> warnings = structure_warnings(problem);
  if (problem.has(data::Feature::general_motion)) return warnings;
  warn_of_resonance_or_distance(problem, warnings);
  add_warning(few_modes_warning(problem), warnings);
  warn_of_thickness(problem, false, highest_mode_that_matters(problem), warnings);
  const auto thick = std::ranges::find(warnings, Concern::thick_beam, &Warning::concern);
  if (thick != warnings.end() && !problem.is_damped()) thick->sentence += "; " + shear_effect(problem);
  return warnings;
}

std::vector<Warning> design_warnings(const data::Case& problem) {
  std::vector<Warning> warnings;
  add_warning(few_modes_warning(problem), warnings);
  warn_of_thickness(problem, false, highest_mode_that_matters(problem), warnings);
  return warnings;
}

std::vector<Warning> frequency_warnings(const data::Case& problem, analytic::TipSupport tip, int count) {
  std::vector<Warning> warnings;
  warn_of_thickness(problem, tip == analytic::TipSupport::free, count, warnings);
  return warnings;
}

std::vector<Warning> history_warnings(const data::Case& problem, const Method& method) {
  std::vector<Warning> warnings;
  if (method.follows_slip()) {
    add_warning(instability_warning(problem), warnings);
  } else if (!problem.has(data::Feature::general_motion)) {
    add_warning(resonance_warning(problem), warnings);
    add_warning(few_modes_warning(problem), warnings);
  }
  if (problem.has(data::Feature::general_motion)) return warnings;
  const int mode = highest_mode_that_matters(problem);
  warn_of_thickness(problem, false, mode, warnings);
  if (method.basis == Basis::elements) {
    add_warning(coarse_mesh_warning(problem), warnings);
    warn_of_step(problem, mode, warnings);
  }
  return warnings;
}

namespace {

// The contact of a run as the search for σ* sees it; nothing if it has no mass.
std::optional<LinearContact> contact_of_run(const data::Case& problem, bool stepped) {
  const data::NumericalSettings& numerics = problem.numerics;
  if (!stepped) return continuous_contact(analytic::contact_model(problem, numerics.modes()));
  const auto system = solver::contact_system(problem, solver::base_motion(problem.motion));
  if (system.mass.diagonal().minCoeff() <= 0.0) return std::nullopt;
  return stepped_contact(solver::ContactMobility(system), numerics.time_step(), numerics.spectral_radius());
}

std::string growth_rate(double value) {
  return value < 100.0 ? fmt::format("{:.3g} 1/s", value) : fmt::format("{:.0f} 1/s", value);
}

// What the beam itself has of that growth.
std::string growth_of_beam(const data::Case& problem, double run_bound, double allowed) {
  if (problem.model() != nullptr) return "";
  const double beam_bound =
      beam_growth_bound(with(problem, without_shear(problem.beam()),
                             data::Damping({.kelvin_voigt = problem.damping.kelvin_voigt()})));
  const bool is_beam_known = problem.damping.is_kelvin_voigt();
  std::string sentence = fmt::format("; for the {} sigma* is {}", is_beam_known ? "beam" : "undamped beam",
                                     growth_rate(beam_bound));
  if (run_bound > 1.1 * beam_bound)
    sentence += fmt::format(
        ", about as with numerics.spectral_radius = 0, time_step = {:.2g} s, elements = {}",
        two_digits(time_step_of({.angle = filtering_angle}, problem.beam(), problem.numerics.elements())),
        problem.numerics.elements());
  if (beam_bound > allowed && is_beam_known)
    sentence += fmt::format("; beyond {:.2g} s the bound is of no use for any discretisation",
                            allowed_growth / beam_bound);
  return sentence;
}

}  // namespace

std::optional<Warning> growth_warning(const data::Case& problem, const Method& method) {
  const data::NumericalSettings& numerics = problem.numerics;
  const bool stepped = method.basis == Basis::elements;
  if (!method.follows_slip() || method.basis == Basis::whole_beam) return std::nullopt;
  if (problem.contact.compliance.has_spring()) return std::nullopt;  // σ* is that of a law without memory
  const int elements =
      problem.model() != nullptr ? problem.model()->matrices().rows / 2 : numerics.elements();
  if ((stepped ? elements : numerics.modes()) >
      (!problem.is_damped() ? most_undamped_for_growth : most_damped_for_growth))
    return std::nullopt;
  const auto contact = contact_of_run(problem, stepped);
  if (!contact) return std::nullopt;
  const double kappa = weakening(problem.contact.friction, problem.normal_force());
  const double allowed = allowed_growth / numerics.duration();
  if (grows_at_most(*contact, kappa, allowed)) return std::nullopt;
  const double run_bound = growth_bound(*contact, kappa);
  return Warning{
      Concern::growth, run_bound, allowed,
      fmt::format("once the contact changes, single slips cannot be foretold for long: a rounding error may "
                  "grow to the "
                  "size of the motion within {:.2g} s, by the bound exp(sigma* t) with sigma* = {}{}",
                  allowed_growth / run_bound, growth_rate(run_bound),
                  growth_of_beam(problem, run_bound, allowed))};
}

namespace {

void warn_of_law(const data::Case& problem, const History& history, std::vector<std::string>& sentences) {
  if (!history.off_law) return;
  const HistoryRow& row = *history.off_law;
  sentences.push_back(fmt::format(
      "at t = {} s the contact is in {} with |f| = {:.4g} N and v_s = {:.3g} m/s, off its law of friction "
      "(mu_s P = {:.4g} N), and at {} times in all: a shorter numerics.time_step may help",
      data::shortest_text(row.time), data::to_string(row.state), std::abs(row.friction_force),
      row.sliding_velocity, friction_limit(problem), history.rows_off_law));
}

// The root of a mode in slip and stick changes its sign where η ω² h = 2, to 1 % for radii from 0.9 to 1.
void warn_of_alternation(const data::Case& problem, std::vector<std::string>& sentences) {
  const data::NumericalSettings& numerics = problem.numerics;
  const double eta = problem.damping.kelvin_voigt(), radius = numerics.spectral_radius();
  if (problem.model() != nullptr) return;
  const double omega = 1.0 / time_step_of({.angle = 1.0}, problem.beam(), numerics.elements());
  const double allowed = 2.0 / (eta * omega * omega);
  if (radius == 0.0 || eta == 0.0 || numerics.time_step() <= allowed) return;
  sentences.push_back(
      fmt::format("numerics.spectral_radius is {}: with damping.kelvin_voigt the velocity of the stiffest "
                  "modes of the mesh is multiplied by -{} in each step longer than {:.2g} s, and the holding "
                  "force with it, so that the run may invent changes of contact; the radius 0 ends it",
                  data::shortest_text(radius), data::shortest_text(radius), allowed));
}

// From when on the changes of contact are others; nothing if they are the same.
std::optional<double> first_difference(const std::vector<data::ContactEvent>& events,
                                       const std::vector<data::ContactEvent>& other) {
  const auto [here, there] =
      std::ranges::mismatch(events, other, {}, &data::ContactEvent::change, &data::ContactEvent::change);
  if (here == events.end() && there == other.end()) return std::nullopt;
  if (here == events.end()) return there->time;
  return there == other.end() ? here->time : std::min(here->time, there->time);
}

void warn_of_long_steps(const data::Case& problem, const solver::RunOptions& options, const History& history,
                        std::vector<std::string>& sentences) {
  const double step = problem.numerics.time_step(), duration = problem.numerics.duration();
  if (2.0 * step > duration) return;
  std::optional<double> time;
  try {
    const auto other = finite_element_history(with_value(problem, "numerics.time_step", 2.0 * step),
                                              {.every = solver::step_count(duration, step)}, options);
    time = first_difference(history.events, other.events);
  } catch (const std::runtime_error&) {  // so long a step cannot follow the law of friction
    time = history.events.front().time;
  }
  if (!time) return;
  sentences.push_back(
      fmt::format("numerics.time_step is {} s: with twice the step the changes of contact are others from t "
                  "= {:.6g} s on; a shorter step tells which ones the beam has",
                  data::shortest_text(step), *time));
}

// Next to a turn the boundary integral may have a single step of slip between two of stick.
void warn_of_single_steps(const data::Case& problem, const History& history,
                          std::vector<std::string>& sentences) {
  const double step = boundary_integral_step(problem);
  const auto close = std::ranges::adjacent_find(
      history.events, [step](const auto& a, const auto& b) { return b.time - a.time < 1.5 * step; });
  if (close == history.events.end()) return;
  sentences.push_back(
      fmt::format("from t = {:.6g} s on changes of contact follow each other within a step of {:.3g} s, and "
                  "need not be those of "
                  "the beam; a shorter numerics.time_step tells which ones it has",
                  close->time, step));
}

void warn_of_few_modes(const data::Case& problem, const History& history,
                       std::vector<std::string>& sentences) {
  constexpr int most_modes = 40;  // more take long
  const int modes = problem.numerics.modes(), more = (3 * modes + 1) / 2;
  if (modes > most_modes) return;
  const auto other = event_driven_history(with_value(problem, "numerics.modes", more),
                                          {.times = {problem.numerics.duration()}});
  const auto time = first_difference(history.events, other.events);
  if (!time) return;
  sentences.push_back(
      fmt::format("{} modes: with {} modes the changes of contact are others from t = {:.6g} s on; more "
                  "numerics.modes tell which ones the beam has",
                  modes, more, *time));
}

}  // namespace

void require_held_growth(const data::Case& problem, const Method& method) {
  constexpr double held = 7.4;  // exp(2 (held - 12.01)) = 1e-4
  if (method.basis != Basis::whole_beam) return;
  const auto unstable = slip_instability(problem);
  if (!unstable || unstable->root.real() * problem.numerics.duration() <= held) return;
  throw data::FieldError("excitation.duration", problem.numerics.duration(),
                         fmt::format("at most {:.3g} s for --method boundary-integral, which holds no motion "
                                     "that grows for longer, as slip does from "
                                     "beam.axial_force = {:.4g} N on; fe and event-driven take it",
                                     held / unstable->root.real(), unstable->load));
}

std::vector<std::string> warnings_after(const data::Case& problem, const Method& method,
                                        const History& history, const solver::RunOptions& options) {
  std::vector<std::string> sentences;
  for (const Warning& warning : history_warnings(problem, method)) sentences.push_back(warning.sentence);
  if (!method.follows_slip() && history.first_slip)
    sentences.push_back(
        fmt::format("the closed form holds while the tip sticks, but |f| exceeds mu_s P = {} N first at {} "
                    "s; --method fe and --method event-driven follow the slip",
                    data::shortest_text(friction_limit(problem)), data::shortest_text(*history.first_slip)));
  warn_of_law(problem, history, sentences);
  if (history.events.empty()) return sentences;
  const bool stepped_to_rest =
      method.basis == Basis::elements && !problem.has(data::Feature::yielding_contact);
  if (stepped_to_rest) warn_of_alternation(problem, sentences);
  if (const auto growth = growth_warning(problem, method)) {
    sentences.push_back(growth->sentence);
  } else {
    if (stepped_to_rest) warn_of_long_steps(problem, options, history, sentences);
    if (method.basis == Basis::whole_beam) warn_of_single_steps(problem, history, sentences);
    if (method.basis == Basis::modes) warn_of_few_modes(problem, history, sentences);
  }
  return sentences;
}

long look_step(const data::Case& problem, long row_step) {
  constexpr double allowed_loss = 0.01;
  if (row_step <= 1) return row_step;
  if (problem.has(data::Feature::general_motion)) return 1;
  const auto vibrations = analytic::free_vibrations(problem);
  long step = row_step;
  while (step > 1 && row_effect(problem, vibrations,
                                static_cast<double>(step) * problem.numerics.time_step()) > allowed_loss)
    step /= step % 2 == 0 ? 2 : step % 5 == 0 ? 5 : step;
  return step;
}

std::optional<std::string> row_warning(const data::Case& problem, const Method& method, long look_step,
                                       long row_step) {
  const double step = problem.numerics.time_step(), spacing = static_cast<double>(row_step) * step,
               half_period = 0.5 / data::highest_frequency_hz(problem);
  const bool is_general = problem.has(data::Feature::general_motion);
  if ((is_general || problem.excitation().amplitude() > 0.0) && spacing > half_period)
    return fmt::format(
        "the rows are {:.3g} s apart, more than half a period of the base, {:.3g} s: they do not show the "
        "motion",
        spacing, half_period);
  if (is_general) return std::nullopt;
  const double effect = row_effect(problem, static_cast<double>(look_step) * step);
  if (method.in_time_steps || effect <= allowed_model_error) return std::nullopt;
  return fmt::format(
      "the largest |f|, the largest deflection{} are those of instants {:.3g} s apart, which may miss {} of "
      "them: a shorter numerics.time_step misses less",
      method.follows_slip() ? "" : " and the first slip", static_cast<double>(look_step) * step,
      percent(effect));
}

std::optional<std::string> fixed_step_warning(const data::Case& problem, double step) {
  const int mode = highest_mode_that_matters(problem);
  const double omega = natural_frequency(problem, mode),
               longest = std::sqrt(24.0 * allowed_step_error) / omega;
  if (!(step > longest)) return std::nullopt;
  return fmt::format(
      "the steps of {:.2g} s are too long for natural frequency {} at {:.4g} Hz; numerics.time_step = {:.2g} "
      "s follows it to {}",
      step, mode, omega / (2.0 * pi), two_digits(longest), percent(allowed_step_error));
}

double curvature_error(const data::Beam& beam, double deflection) {
  return 27.0 / 8.0 * std::pow(deflection / beam.length(), 2);
}

std::optional<std::string> deflection_warning(const data::Case& problem, double deflection) {
  if (problem.model() != nullptr) return std::nullopt;
  const data::Beam& beam = problem.beam();
  const double error = curvature_error(beam, deflection);
  if (!(error > allowed_model_error)) return std::nullopt;
  return fmt::format(
      "the tip is deflected by {:.3g} m, {:.2g} % of the length: the model is that of small slopes, and its "
      "curvature is then wrong by about {:.2g} %",
      std::abs(deflection), 100.0 * std::abs(deflection) / beam.length(), 100.0 * error);
}

double spring_that_keeps(const data::Beam& beam, double draw_back) {
  return 0.1 * beam.axial_force() / draw_back;
}

std::optional<std::string> draw_back_warning(const data::Case& problem, double draw_back) {
  if (!(draw_back > allowed_draw_back)) return std::nullopt;
  const data::Beam& beam = problem.beam();
  return fmt::format(
      "the tip draws back from the wall by {:.3g} mm as the beam bends: P = {:.6g} N stays within 10 % only "
      "if a spring softer than {:.3g} N/mm presses the tip, with little mass",
      1e3 * draw_back, beam.axial_force(), 1e-3 * spring_that_keeps(beam, draw_back));
}

std::vector<Warning> warnings_common_to(const data::Case& problem,
                                        const std::vector<std::string_view>& varied) {
  if (problem.has(data::Feature::general_motion) || analytic::is_buckled(problem)) return {};
  const auto all_of = [&](auto property) {
    return std::ranges::all_of(varied,
                               [&](std::string_view key) { return property(data::key_named(key).effects); });
  };
  std::vector<Warning> warnings;
  if (all_of([](const data::KeyEffects& one) { return one.keeps_frequencies; }))
    warn_of_resonance_or_distance(problem, warnings);
  if (all_of([](const data::KeyEffects& one) { return !one.has_proportions; }))
    warn_of_thickness(problem, false, highest_mode_that_matters(problem), warnings);
  return warnings;
}

void require_feasible(const data::Case& problem) {
  require_resting_wall(problem);
  require_start_at_rest(problem);
  require_periods(problem, most_periods_in_closed_form);
}

}  // namespace stickslip::studies
