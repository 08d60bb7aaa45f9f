// SPDX-License-Identifier: MIT
#include "studies/history/method.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "stickslip/analytic/stick_reaction.hpp"
#include "stickslip/data/input_error.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

namespace {

using data::Feature;

const std::vector<std::pair<Feature, std::string_view>> features{
    {Feature::slip, "slip, and changes of contact (`--events`)"},
    {Feature::kelvin_voigt, "`damping.kelvin_voigt`"},
    {Feature::other_damping, "`damping.ratio`, `damping.mass_proportional`"},
    {Feature::yielding_contact, "a spring or a smooth law (`[contact]`)"},
    {Feature::moving_wall, "`wall.speed`"},
    {Feature::shear, "`beam.shear_stiffness`"},
    {Feature::fixed_axial_force, "`beam.axial_direction`"},
    {Feature::own_structure, "`[model]`"},
    {Feature::wall_with_base, "`wall.with_base` of a beam"},
    {Feature::force, "`excitation.force`"},
    {Feature::constant_force, "`excitation.constant_force`"},
    {Feature::initial_state, "`[initial]`"},
    {Feature::general_motion, "`sines`, `sweep`, `shock`, `file`, `spectrum` (`[excitation]`, `[wall]`)"},
    {Feature::start_at_rest, "`--initial-velocity zero`"},
    {Feature::contact_scheme, "`--scheme`"},
    {Feature::further_columns, "`--columns`"}};

const std::string undamped =
    "0 for the closed form: Eq. (26) is that of the undamped beam; respond --method fe follows the damped "
    "one";
const std::string quasi_static = "quasi-static for --method {}, whose equation assumes it";
const std::string rigid =
    "--method {}; fe and boundary-integral take it";  // after "inf (a rigid contact) for"
const std::string resting = std::string(resting_wall);
const std::string no_shear = "0 for --method {}, whose beam is rigid in shear; --method fe has shear";
const std::string wall_apart = "false for --method {} of a beam; fe and event-driven take it";
const std::string from_rest =
    "0 for --method {}, which starts at rest on the wall; fe and event-driven take it";
const std::string with_reactions = "fe or event-driven where --columns is given";
const std::string elements_only = "fe where --scheme is given";

// All of them feasible: a run in time steps says how far it is.
void require_nothing(const data::Case&) {}

void require_start_and_steps(const data::Case& problem) {
  // Of a law that jumps no step has one solution, however short it is.
  analytic::require_unique_step({problem.normal_force(), problem.contact.friction, problem.contact.compliance,
                                 problem.numerics.time_step()},
                                0.0);
  if (problem.is_damped() && problem.is_random())
    throw data::FieldError("damping.kelvin_voigt", problem.damping.kelvin_voigt(),
                           "0 with the boundary integral under a spectrum: the response of a damped beam "
                           "begins stationary, which event-driven "
                           "and fe take");
  const double most_steps = std::ldexp(1.0, 24), step = boundary_integral_step(problem);
  if (problem.numerics.duration() <= most_steps * step) return;
  throw data::FieldError("excitation.duration", data::shortest_text(problem.numerics.duration()),
                         fmt::format("at most {:.3g} s, 2^24 steps of {:.3g} s", most_steps * step, step));
}

}  // namespace

const std::vector<Method>& methods() {
  static const std::vector<Method> all{
      {"boundary-integral",
       Basis::whole_beam,
       {{Feature::other_damping, "0 with the boundary integral, which allows Kelvin-Voigt damping only"},
        {Feature::moving_wall, resting},
        {Feature::shear, no_shear},
        {Feature::wall_with_base, wall_apart},
        {Feature::initial_state, from_rest},
        {Feature::start_at_rest, quasi_static},
        {Feature::contact_scheme, elements_only},
        {Feature::further_columns, with_reactions}},
       require_start_and_steps,
       boundary_integral_history,
       true,
       {Feature::other_damping, Feature::wall_with_base}},
      {"closed-form",
       Basis::modes,
       {{Feature::slip,
         "one that follows the slip (fe, event-driven or boundary-integral) where --events is given"},
        {Feature::kelvin_voigt, undamped},
        {Feature::other_damping, undamped},
        {Feature::yielding_contact, rigid},
        {Feature::moving_wall, resting},
        {Feature::shear, no_shear},
        {Feature::wall_with_base, wall_apart},
        {Feature::initial_state, from_rest},
        {Feature::start_at_rest, quasi_static},
        {Feature::contact_scheme, elements_only},
        {Feature::further_columns, with_reactions}},
       [](const data::Case& problem) { require_periods(problem, most_periods_in_closed_form); },
       [](const data::Case& problem, const Sampling& sampling, const solver::RunOptions&,
          const RowSink& sink) {
         return closed_form_history(problem, sampling, analytic::SteadyPart::modal_sum, sink);
       },
       false,
       {Feature::kelvin_voigt, Feature::other_damping, Feature::wall_with_base}},
      {"event-driven",
       Basis::modes,
       {{Feature::yielding_contact, rigid},
        {Feature::shear, no_shear},
        {Feature::contact_scheme, elements_only}},
       [](const data::Case& problem) { require_periods(problem, most_periods_by_events); },
       event_driven_history},
      {"fe", Basis::elements, {}, require_nothing, finite_element_history, true}};
  return all;
}

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const Method& each : methods()) names.push_back(each.name);
  return names;
}

const Method& method(std::string_view name) {
  const auto found = std::ranges::find(methods(), name, &Method::name);
  if (found == methods().end()) throw std::out_of_range(fmt::format("no method has the name {}", name));
  return *found;
}

const Method& boundary_integral() { return method("boundary-integral"); }
const Method& closed_form() { return method("closed-form"); }
const Method& event_driven() { return method("event-driven"); }
const Method& finite_elements() { return method("fe"); }

const std::map<std::string, solver::ContactScheme>& contact_schemes() {
  static const std::map<std::string, solver::ContactScheme> schemes{
      {"located", solver::ContactScheme::located},
      {"end-of-step", solver::ContactScheme::end_of_step},
      {"paper", solver::ContactScheme::paper}};
  return schemes;
}

void Method::require(Feature feature, std::string_view field, const std::string& value) const {
  if (refused.contains(feature))
    throw data::FieldError(std::string(field), value, fmt::format(fmt::runtime(refused.at(feature)), name));
}

void Method::require(const data::Case& problem, const solver::RunOptions& options) const {
  if (options.starts_with_the_base) require(Feature::start_at_rest, "--initial-velocity", "zero");
  if (options.scheme) require(Feature::contact_scheme, "--method", name);
  for (const data::FeatureKey& key : data::feature_keys()) {
    const double value = key.value(problem);
    if (value == key.plain || !refused.contains(key.feature)) continue;
    if (problem.model() != nullptr && done_for_models.contains(key.feature)) continue;
    if (key.feature == Feature::yielding_contact)
      data::require_rigid(problem.contact.compliance,
                          fmt::format(fmt::runtime(refused.at(key.feature)), name));
    require(key.feature, key.path, key.word.empty() ? data::shortest_text(value) : std::string(key.word));
  }
  for (const auto& [scheme, value] : contact_schemes())
    if (options.scheme == value && value != solver::ContactScheme::located)
      data::require_rigid(problem.contact.compliance, "--scheme " + scheme);
  require_feasible(problem);
}

std::string table_of_methods() {
  std::string table = "| |", rule = "\n| --- |";
  for (const Method& each : methods()) {
    table += fmt::format(" `{}` |", each.name);
    rule += " --- |";
  }
  table += rule;
  for (const auto& [feature, name] : features) {
    table += fmt::format("\n| {} |", name);
    for (const Method& each : methods()) table += each.refused.contains(feature) ? " no |" : " yes |";
  }
  return table + "\n";
}

void require_periods(const data::Case& problem, double most_periods) {
  const auto modes = analytic::held_modes(problem, problem.numerics.modes());
  const double natural = modes.empty() ? 0.0 : modes.back().angular_frequency / (2.0 * std::numbers::pi);
  const double highest = std::max(natural, data::highest_frequency_hz(problem));
  if (problem.numerics.duration() * highest <= most_periods) return;
  throw data::FieldError(
      "excitation.duration", data::shortest_text(problem.numerics.duration()),
      fmt::format("at most {:.3g} s, {} periods of {}, {:.3g} Hz", most_periods / highest,
                  most_periods == most_periods_by_events ? "a million" : "a hundred million",
                  natural > data::highest_frequency_hz(problem)
                      ? fmt::format("natural frequency {}", problem.numerics.modes())
                      : "the excitation",
                  highest));
}

}  // namespace stickslip::studies
