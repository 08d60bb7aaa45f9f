// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::cli {

namespace {

struct PeriodicOptions {
  CaseOptions problem{.name = "reed"};
  int periods = 1;
  int settle = 200;
};

// In the order of analytic::NoMotion.
constexpr std::array<std::string_view, 3> reasons{
    "the contact sticks", "the contact slides steadily",
    "no periodic motion is found; a longer --settle may help, for one that is unstable a shorter one"};

std::string reason_of(const studies::Cycle& cycle) {
  std::string reason(reasons.at(static_cast<std::size_t>(cycle.search.reason)));
  if (cycle.forced && cycle.search.reason == analytic::NoMotion::unsettled) reason += ", or more --periods";
  return reason;
}

std::vector<LabelledValue> rows_of(const studies::Cycle& cycle) {
  const auto& motion = *cycle.search.motion;
  Json multipliers = Json::array(), events = Json::array();
  for (const auto multiplier : motion.multipliers)
    multipliers.push_back({{"real", multiplier.real()}, {"imaginary", multiplier.imag()}});
  std::vector<std::string> names, moduli;
  for (const auto& event : motion.events) {
    events.push_back({{"time_s", event.time}, {"change", data::to_string(event.change)}});
    names.emplace_back(data::to_string(event.change));
  }
  for (std::size_t i = 0; i < motion.multipliers.size() && i < 4; ++i)
    moduli.push_back(fmt::format("{:.6g}", std::abs(motion.multipliers[i])));
  return {{"period / s", "period_s", rounded(motion.period, 10)},
          {"frequency / Hz", "frequency_hz", rounded(1.0 / motion.period, 10)},
          {"contact, peak to peak / m", "tip_peak_to_peak_m", rounded(cycle.peak_to_peak, 7)},
          {"largest sliding velocity / (m/s)", "largest_sliding_velocity_m_per_s",
           rounded(cycle.largest_sliding, 7)},
          {"share of stick", "stick_share", rounded(cycle.stick_share, 4)},
          {"changes of contact",
           "changes_of_contact",
           {events, fmt::format("{}{}{}", names.size(), names.empty() ? "" : ": ", data::joined(names))}},
          {"largest Floquet multipliers", "multipliers", {multipliers, data::joined(moduli)}},
          {"verdict", "verdict", word(studies::is_stable(cycle) ? "stable" : "unstable")},
          {"", "residual", exact(motion.residual)},
          {"", "iterations", count(static_cast<std::size_t>(motion.iterations))}};
}

Answer periodic_motion(const PeriodicOptions& options, Outputs& outputs) {
  const data::Case problem = load_case(options.problem);
  if (options.periods > 1 && problem.excitation().amplitude() == 0.0)
    throw data::FieldError("--periods", options.periods, "1 where excitation.amplitude is 0: the base rests");
  const studies::Method& method = studies::event_driven();
  method.require_feasible(problem);
  outputs.set_case(problem);
  outputs.open({});
  outputs.progress().stage("following the motion until it settles");
  Answer answer(34);
  add_cycle(answer, studies::cycle_of(problem, options.periods, options.settle));
  answer.warnings = sentences_of(studies::history_warnings(problem, method));
  return answer;
}

void add_options(CLI::App& command, PeriodicOptions& options) {
  add_case_options(command, options.problem);
  add_excitation_options(command, options.problem);
  add_integer_option(command, "--periods", options.periods, 1, 1000,
                     "Periods of the base that the motion takes");
  add_integer_option(
      command, "--settle", options.settle, 1, 100'000,
      "Periods of the base, or of the first mode where it does not move, before the motion is looked for");
}

}  // namespace

void add_cycle(Answer& answer, const studies::Cycle& cycle, const std::string& key) {
  Answer part(answer.label_width);
  part.add_members({{"forced", cycle.forced}, {"found", cycle.search.motion.has_value()}});
  if (cycle.search.motion) {
    part.add_line(fmt::format("{}, {}\n", cycle.forced ? "a periodic motion" : "a limit cycle",
                              cycle.stick_share > 0.0 ? "with stick and slip" : "without stick"));
    for (const LabelledValue& row : rows_of(cycle)) part.add_row(row);
  } else {
    part.add_line(reason_of(cycle));
    part.add_members({{"reason", reason_of(cycle)}});
  }
  answer.text += part.text;
  answer.add_members(key.empty() ? part.json : Json{{key, part.json}});
}

void add_periodic_command(CLI::App& app) {
  add<PeriodicOptions>(
      app,
      {.name = "periodic",
       .help =
           "A periodic motion by shooting, with its Floquet multipliers: forced by the base or self-excited",
       .examples = {"stickslip periodic reed --json", "stickslip periodic damped --settle 50"},
       .add_options = add_options,
       .run = periodic_motion});
}

}  // namespace stickslip::cli
