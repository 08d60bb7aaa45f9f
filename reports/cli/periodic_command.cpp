// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <memory>
#include <string_view>

#include "case_options.hpp"
#include "commands.hpp"
#include "periodic_output.hpp"
#include "render/interruption.hpp"

namespace stickslip::cli {

namespace {

struct PeriodicOptions {
  CaseOptions problem;
  ExcitationOptions excitation;
  int periods = 1;
  int settle = 200;
};

// In the order of analytic::NoMotion.
constexpr std::array<std::string_view, 3> reasons{
    "the tip sticks", "the tip slides steadily",
    "no periodic motion is found; a longer --settle or more --periods may help"};

std::string_view reason_of(const studies::Cycle& cycle) {
  return reasons.at(static_cast<std::size_t>(cycle.search.reason));
}

void run(const PeriodicOptions& options) {
  const data::Case problem = load_case(options.problem, options.excitation, std::nullopt);
  data::require_rigid(problem.contact, "a periodic motion; respond takes it");
  if (options.periods > 1 && problem.excitation.amplitude() == 0.0)
    throw data::FieldError("--periods", options.periods, "1 where excitation.amplitude is 0: the base rests");
  const auto inquiry = studies::Inquiry::event_driven_history;
  studies::require_feasible(problem, inquiry);
  const report::Interruption interruption([] { return "interrupted before there was a result"; });
  const studies::Cycle cycle = studies::cycle_of(problem, options.periods, options.settle);
  const auto warnings = warnings_of(problem, inquiry);
  Json answer{{"case", problem.name}};
  answer.update(cycle_json(cycle));
  answer["numerics"] = numerics_json(problem);
  answer["warnings"] = warnings;
  require_finite(answer);
  print_warnings(warnings);
  if (options.problem.json) return print_json(answer);
  fmt::print("{}: ", problem.name);
  print_cycle(cycle);
}

}  // namespace

void print_cycle(const studies::Cycle& cycle) {
  if (!cycle.search.motion) return fmt::print("{}\n", reason_of(cycle));
  const auto& motion = *cycle.search.motion;
  const auto row = [](std::string_view name, const std::string& value) {
    fmt::print("{:<34}{}\n", name, value);
  };
  fmt::print("{}, {}\n\n", cycle.forced ? "a periodic motion" : "a limit cycle",
             cycle.stick_share > 0.0 ? "with stick and slip" : "without stick");
  row("period / s", fmt::format("{:.10g}", motion.period));
  row("frequency / Hz", fmt::format("{:.10g}", 1.0 / motion.period));
  row("tip, peak to peak / m", fmt::format("{:.7g}", cycle.peak_to_peak));
  row("largest sliding velocity / (m/s)", fmt::format("{:.7g}", cycle.largest_sliding));
  row("share of stick", fmt::format("{:.4g}", cycle.stick_share));
  std::string names;
  for (const auto& event : motion.events)
    names += fmt::format("{}{}", names.empty() ? "" : ", ", data::name_of(event.change));
  row("changes of contact", fmt::format("{}{}{}", motion.events.size(), names.empty() ? "" : ": ", names));
  std::string moduli;
  for (std::size_t i = 0; i < motion.multipliers.size() && i < 4; ++i)
    moduli += fmt::format("{}{:.6g}", i == 0 ? "" : ", ", std::abs(motion.multipliers[i]));
  row("largest Floquet multipliers", moduli);
  row("verdict", studies::is_stable(cycle) ? "stable" : "unstable");
}

Json cycle_json(const studies::Cycle& cycle) {
  Json object{{"forced", cycle.forced}, {"found", cycle.search.motion.has_value()}};
  if (!cycle.search.motion) {
    object["reason"] = reason_of(cycle);
    return object;
  }
  const auto& motion = *cycle.search.motion;
  Json multipliers = Json::array(), events = Json::array();
  for (const auto multiplier : motion.multipliers)
    multipliers.push_back({{"real", multiplier.real()}, {"imaginary", multiplier.imag()}});
  for (const auto& event : motion.events)
    events.push_back({{"time_s", event.time}, {"change", data::name_of(event.change)}});
  object.update({{"period_s", motion.period},
                 {"frequency_hz", 1.0 / motion.period},
                 {"tip_peak_to_peak_m", cycle.peak_to_peak},
                 {"largest_sliding_velocity_m_per_s", cycle.largest_sliding},
                 {"stick_share", cycle.stick_share},
                 {"changes_of_contact", events},
                 {"multipliers", multipliers},
                 {"verdict", studies::is_stable(cycle) ? "stable" : "unstable"},
                 {"residual", motion.residual},
                 {"iterations", motion.iterations}});
  return object;
}

void add_periodic_command(CLI::App& app) {
  auto* command = app.add_subcommand(
      "periodic",
      "A periodic motion by shooting, with its Floquet multipliers: forced by the base or self-excited");
  auto options = std::make_shared<PeriodicOptions>();
  options->problem.name = "reed";
  add_case_options(*command, options->problem);
  add_excitation_options(*command, options->excitation);
  command->add_option("--periods", options->periods, "Periods of the base that the motion takes")
      ->check(integer_between(1, 1000))
      ->capture_default_str();
  command
      ->add_option(
          "--settle", options->settle,
          "Periods of the base, or of the first mode where it does not move, before the motion is looked for")
      ->check(integer_between(1, 100'000))
      ->capture_default_str();
  add_examples(*command, {"stickslip periodic reed --json", "stickslip periodic damped --settle 50"});
  command->callback([options] { run(*options); });
}

}  // namespace stickslip::cli
