// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "range_text.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "studies/analyses/design_guide.hpp"

namespace stickslip::cli {

namespace {

struct DesignOptions {
  CaseOptions problem;
  std::string band;
  std::optional<std::string> length, force;
};

constexpr std::string_view guarantee =
    "The margin is between rigorous bounds over the whole band, natural frequencies included, for the modes "
    "kept. Lengths and forces\nare sampled 1 % apart, at every resonance, and closer where they come near to "
    "slipping; what slips at two neighbours\ncounts as slipping in between.";

// The range asked for, or else `below` to `above` times the value of the case, under the buckling load.
analytic::Bounds range_of(const data::Case& problem, std::string_view parameter, std::string_view option,
                          const std::optional<std::string>& text, double below, double above) {
  if (text) return parse_range(option, parameter, *text);
  const double value = data::value_of(problem, parameter);
  return studies::range_below_buckling(problem, parameter, below * value, above * value);
}

// What is looked at.
struct Ranges {
  analytic::Bounds band, lengths, forces;
};

Ranges ranges_of(const data::Case& problem, const DesignOptions& options) {
  if (problem.model() != nullptr) {
    for (const auto& [option, value] : {std::pair{"--length", options.length}, {"--force", options.force}})
      if (value) throw data::FieldError(option, *value, "left out for a [model], which has no such range");
    return {parse_range("--band", "excitation.frequency_hz", options.band, true), {}, {}};
  }
  return {parse_range("--band", "excitation.frequency_hz", options.band, true),
          range_of(problem, "beam.length", "--length", options.length, 0.5, 2.0),
          range_of(problem, "beam.axial_force", "--force", options.force, 0.1, 10.0)};
}

// The case at the highest frequency of the band and that length.
data::Case at_the_end_of(const data::Case& problem, const analytic::Bounds& band,
                         const std::optional<double>& length = {}) {
  const data::Case at_end = with_value(problem, "excitation.frequency_hz", band.upper);
  return length ? with_value(at_end, "beam.length", *length) : at_end;
}

std::string reason_for(const studies::DesignInterval& interval, bool is_one_frequency) {
  if (interval.buckled) return "no stick state: P is at the buckling load 20.19 EI/L^2 or over it";
  if (interval.sticks) return "sticks";
  if (interval.resonances.empty()) return "slips, without a natural frequency in the band";
  return fmt::format("slips: natural frequency {} {}", fmt::join(interval.resonances, ", "),
                     is_one_frequency ? "passes" : "in the band");
}

void add_scan(Answer& answer, const std::string& title, const std::string& key,
              const studies::DesignScan& scan, bool is_one_frequency) {
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(scan.accuracy))));
  answer.add_line(fmt::format("\n{}, ends to {}", title, significant(scan.accuracy, 2)));
  Json intervals = Json::array();
  for (const auto& interval : scan.intervals) {
    answer.add_line(fmt::format("{:<28}{}",
                                fmt::format("{1:.{0}f} ... {2:.{0}f}", decimals, interval.from, interval.to),
                                reason_for(interval, is_one_frequency)));
    intervals.push_back({{"from", interval.from},
                         {"to", interval.to},
                         {"state", interval.buckled  ? "no stick state"
                                   : interval.sticks ? "stick"
                                                     : "stick-slip"},
                         {"natural_frequencies_in_band", interval.resonances}});
  }
  answer.add_members({{key, {{"accuracy", scan.accuracy}, {"intervals", intervals}}}});
}

Value resonances_of(const std::vector<studies::Resonance>& resonances) {
  Value value{Json::array(), resonances.empty() ? "none" : ""};
  for (const auto& [mode, hz] : resonances) {
    value.json.push_back({{"mode", mode}, {"frequency_hz", hz}});
    value.text += fmt::format("{}{} at {}", value.text.empty() ? "" : ", ", mode, significant(hz, 7));
  }
  return value;
}

Answer design_answer(const data::Case& problem, const studies::Design& design) {
  const auto& [force, limit, margin_bounds, worst_hz, evaluations, resonances, steady_margin] = design.margin;
  Answer answer(34);
  add_excitation(answer, problem, design.band);
  answer.add_members({{"duration_s", problem.numerics.duration()}, {"modes", problem.numerics.modes()}});
  answer.add_line(
      fmt::format("{}, {} modes\n", conditions_of(problem, design.band), problem.numerics.modes()));
  const auto judged = [](const analytic::Bounds& bounds) {
    Value margin = between(bounds);
    margin.text += bounds.lower >= 1.0 ? ": sticks" : bounds.upper < 1.0 ? ": slips" : ": undecided";
    return margin;
  };
  answer.add_row({"smallest margin mu_s P/|f_max|", "margin", judged(margin_bounds)});
  if (problem.is_damped())
    answer.add_row({"smallest margin, steady", "steady_margin", judged(steady_margin)});
  answer.add_row({"at / Hz", "frequency_hz", {worst_hz, significant(worst_hz, 7)}});
  answer.add_row({"largest |f| / N", "force_max_N", between(force)});
  answer.add_row({"friction limit mu_s P / N", "friction_limit_N", exact(limit)});
  answer.add_members({{"evaluations", evaluations}});
  answer.add_row(
      {"natural frequencies in the band", "natural_frequencies_in_band", resonances_of(resonances)});
  if (problem.model() != nullptr) {  // it has neither
    answer.add_members({{"lengths_m", nullptr}, {"axial_forces_N", nullptr}});
    return answer;
  }
  const bool is_one_frequency = design.band.from_hz == design.band.to_hz;
  add_scan(answer, fmt::format("length / m at P = {} N", data::shortest_text(problem.beam().axial_force())),
           "lengths_m", design.lengths, is_one_frequency);
  add_scan(answer, fmt::format("axial force / N at L = {} m", data::shortest_text(problem.beam().length())),
           "axial_forces_N", design.forces, is_one_frequency);
  answer.add_line(fmt::format("\n{}", guarantee));
  return answer;
}

Answer design(const DesignOptions& options, Outputs& outputs) {
  data::Case problem = load_case(options.problem);
  if (const auto* motion = problem.general_motion())
    throw data::FieldError(
        motion->key(), std::string("given"),
        "left out: design takes a band of sines; for lengths and axial forces of a beam under this motion "
        "take "
        "'map CASE --x length=FROM:TO:COUNT --y force=FROM:TO:COUNT', or 'best change' of criterion");
  analytic::require_contact(problem);
  const Ranges ranges = ranges_of(problem, options);
  problem.numerics = numerics_up_to(ranges.band.upper, problem);
  studies::require_feasible(at_the_end_of(problem, ranges.band));
  if (problem.model() == nullptr)
    studies::require_feasible(at_the_end_of(problem, ranges.band, ranges.lengths.lower));
  outputs.set_case(problem);
  outputs.open({});
  report::Progress& progress = outputs.progress();
  const auto found = studies::design(
      problem, {ranges.band.lower, ranges.band.upper}, ranges.lengths, ranges.forces,
      [&](std::string_view stage) { progress.stage(stage); }, std::ref(progress));
  Answer answer = design_answer(problem, found);
  answer.warnings = sentences_of(studies::design_warnings(at_the_end_of(problem, ranges.band)));
  if (found.margin.margin.lower < 1.0)
    if (const auto unstable = studies::instability_warning(problem)) add_warning(answer, unstable->sentence);
  return answer;
}

void add_options(CLI::App& command, DesignOptions& options) {
  add_case_options(command, options.problem);
  command.add_option("--band", options.band, "Excitation frequencies, Hz; both ends may be the same")
      ->type_name("FROM:TO")
      ->required();
  add_key_option(command, options.problem, "--amplitude", "excitation.amplitude",
                 "Amplitude at all of them, m or with a unit of displacement, velocity or acceleration (else "
                 "that of the case)");
  command
      .add_option("--length", options.length,
                  "Lengths to look at, m (default: half to twice that of the case, below buckling)")
      ->type_name("FROM:TO");
  command
      .add_option("--force", options.force,
                  "Axial forces to look at, N (default: a tenth to ten times that of the case, below "
                  "buckling)")
      ->type_name("FROM:TO");
  add_duration_option(command, options.problem);
  add_threads_option(command);
}

}  // namespace

void add_design_command(CLI::App& app) {
  add<DesignOptions>(
      app, {.name = "design",
            .help = "Margin to slipping over a band of frequencies; lengths and axial forces that avoid it",
            .examples = {"stickslip design steel-strip --band 24:26 --length 0.25:0.35 --force 10:40"},
            .add_options = add_options,
            .run = design});
}

}  // namespace stickslip::cli
