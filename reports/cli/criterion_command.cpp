// SPDX-License-Identifier: MIT
#include "stickslip/analytic/criterion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "case_options.hpp"
#include "commands.hpp"
#include "number_text.hpp"
#include "render/interruption.hpp"

namespace stickslip::cli {

namespace {

struct CriterionOptions {
  CaseOptions problem;
  ExcitationOptions excitation;
};

analytic::Criterion with_paper_modes(const data::Case& problem) {
  return analytic::evaluate_criterion(problem.beam, problem.friction, problem.excitation,
                                      problem.numerics.duration(), problem.numerics.modes());
}

// The criterion without truncation: exact steady part, `kept` free vibrations, and the bound of what the
// others can add. Evaluated at an amplitude of 1 m and scaled, since the reaction is proportional to the
// amplitude.
analytic::Criterion with_all_modes(const data::Case& problem) {
  constexpr int kept = 200;
  const data::HarmonicExcitation unit({.frequency_hz = problem.excitation.frequency_hz(), .amplitude = 1.0});
  const auto criterion = analytic::evaluate_criterion(
      problem.beam, problem.friction, unit, problem.numerics.duration(), kept, analytic::SteadyPart::exact);
  const double omitted = analytic::StickResponse(problem.beam, unit, kept, analytic::SteadyPart::exact)
                             .omitted_transient_bound();
  const analytic::Bounds unit_force{std::max(0.0, criterion.force_max.lower - omitted),
                                    criterion.force_max.upper + omitted};
  const double limit = criterion.friction_limit, amplitude = problem.excitation.amplitude();
  const bool slips = amplitude * unit_force.lower > limit;
  return {.force_max = {amplitude * unit_force.lower, amplitude * unit_force.upper},
          .friction_limit = limit,
          .critical_amplitude = {limit / unit_force.upper, limit / unit_force.lower},
          .verdict = slips ? analytic::Verdict::stick_slip : analytic::Verdict::stick};
}

void print_table(const data::Case& problem, const analytic::Criterion& paper,
                 const analytic::Criterion& all) {
  const auto row = [](std::string_view name, std::string_view left, std::string_view right) {
    fmt::print("{:<28}{:<20}{}\n", name, left, right);
  };
  fmt::print(
      "{}: {} Hz, {} m, 0 to {} s\n\n", problem.name, data::shortest_text(problem.excitation.frequency_hz()),
      data::shortest_text(problem.excitation.amplitude()), data::shortest_text(problem.numerics.duration()));
  row("", fmt::format("N = {}", problem.numerics.modes()), "all modes");
  row("largest |f| / N", common_digits(paper.force_max), common_digits(all.force_max));
  row("friction limit mu_s P / N", data::shortest_text(paper.friction_limit),
      data::shortest_text(all.friction_limit));
  row("critical amplitude / m", common_digits(paper.critical_amplitude),
      common_digits(all.critical_amplitude));
  row("verdict", to_string(paper.verdict), to_string(all.verdict));
}

Json to_json(const analytic::Criterion& criterion) {
  return {{"force_max_N", bounds_json(criterion.force_max)},
          {"friction_limit_N", criterion.friction_limit},
          {"critical_amplitude_m", criterion.critical_amplitude.midpoint()},
          {"critical_amplitude_bounds_m", bounds_json(criterion.critical_amplitude)},
          {"verdict", to_string(criterion.verdict)}};
}

Json to_json(const data::Case& problem, const analytic::Criterion& paper, const analytic::Criterion& all,
             const std::vector<std::string>& warnings) {
  Json object{{"case", problem.name},
              {"frequency_hz", problem.excitation.frequency_hz()},
              {"amplitude_m", problem.excitation.amplitude()},
              {"duration_s", problem.numerics.duration()},
              {"modes", problem.numerics.modes()}};
  object.update(to_json(paper));
  object["all_modes"] = to_json(all);
  object["warnings"] = warnings;
  return object;
}

void run(const CriterionOptions& options) {
  const data::Case problem =
      data::load_case(options.problem.name, overrides_of(options.problem, options.excitation));
  require_undamped(problem, "the criterion");
  analytic::require_contact(problem.beam);
  studies::require_feasible(problem, studies::Inquiry::criterion);
  const report::Interruption interruption([] { return "interrupted before there was a result"; });
  const auto paper = with_paper_modes(problem);
  const auto all = with_all_modes(problem);
  const auto warnings = warnings_of(problem, studies::Inquiry::criterion);
  const Json answer = to_json(problem, paper, all, warnings);
  require_finite(answer);
  print_warnings(warnings);
  if (options.problem.json)
    print_json(answer);
  else
    print_table(problem, paper, all);
}

}  // namespace

void add_criterion_command(CLI::App& app) {
  auto* command =
      app.add_subcommand("criterion", "Whether stick-slip occurs, and from which amplitude on (closed form)");
  auto options = std::make_shared<CriterionOptions>();
  add_case_options(*command, options->problem);
  add_excitation_options(*command, options->excitation);
  add_examples(*command, {"stickslip criterion steel-strip --hz 30",
                          "stickslip criterion paper --set beam.length=1.8 --amplitude 0.5e-3 --json"});
  command->callback([options] { run(*options); });
}

}  // namespace stickslip::cli
