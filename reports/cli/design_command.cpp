// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "case_options.hpp"
#include "commands.hpp"
#include "long_work.hpp"
#include "range_text.hpp"
#include "render/interruption.hpp"
#include "render/progress.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "studies/criterion/design_guide.hpp"

namespace stickslip::cli {

namespace {

struct DesignOptions {
  CaseOptions problem;
  std::optional<double> amplitude;
  std::optional<double> duration;
  std::string band;
  std::optional<std::string> length, force;
};

constexpr std::string_view guarantee =
    "The margin is between rigorous bounds over the whole band, natural frequencies included, for the modes "
    "kept. Lengths and forces\nare sampled 1 % apart, at every resonance, and closer where they come near to "
    "slipping; what slips at two neighbours\ncounts as slipping in between.";

// The range asked for, or else `below` to `above` times the value of the case, under the buckling load.
studies::ParameterRange range_of(const data::Case& problem, std::string_view parameter,
                                 std::string_view option, const std::optional<std::string>& text,
                                 double below, double above) {
  if (text) return parse_range(option, *text);
  const double value = data::value_of(problem, parameter);
  return studies::range_below_buckling(problem, parameter, below * value, above * value);
}

// What is looked at.
struct Ranges {
  studies::ParameterRange band, lengths, forces;
};

Ranges ranges_of(const data::Case& problem, const DesignOptions& options) {
  const Ranges ranges{parse_band("--band", options.band),
                      range_of(problem, "beam.length", "--length", options.length, 0.5, 2.0),
                      range_of(problem, "beam.axial_force", "--force", options.force, 0.1, 10.0)};
  const auto require_allowed = [&](const studies::ParameterRange& range, const std::string& key,
                                   const std::string& option) {
    for (const double end : {range.from, range.to}) {
      auto overrides = overrides_of(options.problem);
      overrides.push_back(override_with(key, end, option));
      (void)data::load_case(options.problem.name, overrides);  // throws for what --set would refuse
    }
  };
  require_allowed(ranges.band, "excitation.frequency_hz", "--band");
  require_allowed(ranges.lengths, "beam.length", "--length");
  require_allowed(ranges.forces, "beam.axial_force", "--force");
  return ranges;
}

// The case at the highest frequency of the band and that length.
data::Case at_the_end_of(const data::Case& problem, const studies::ParameterRange& band, double length) {
  data::Case end = problem;
  end.excitation =
      data::HarmonicExcitation({.frequency_hz = band.to, .amplitude = problem.excitation.amplitude()});
  data::BeamProperties properties = problem.beam.properties();
  properties.length = length;
  end.beam = data::Beam(properties);
  return end;
}

studies::Design design_of(const data::Case& problem, const Ranges& ranges) {
  studies::Design design{
      .band = {ranges.band.from, ranges.band.to}, .margin = {}, .lengths = {}, .forces = {}};
  report::Progress progress("stickslip design", progress_surroundings());
  const report::Interruption interruption([&] {
    progress.finish();
    return fmt::format("interrupted after {:.0f} % of the design; nothing is kept", 100.0 * progress.share());
  });
  const auto half_from = [&progress](double start) {
    return [&progress, start](double share) { progress(start + 0.5 * share); };
  };
  progress.stage("margin");
  design.margin = studies::band_margin(problem, design.band);
  progress.stage("lengths");
  design.lengths = studies::design_scan(problem, "beam.length", ranges.lengths, design.band, half_from(0.0));
  progress.stage("axial forces");
  design.forces =
      studies::design_scan(problem, "beam.axial_force", ranges.forces, design.band, half_from(0.5));
  return design;
}

std::string reason_for(const studies::DesignInterval& interval) {
  if (interval.buckled) return "no stick state: P is at the buckling load 20.19 EI/L^2 or over it";
  if (interval.sticks) return "sticks";
  if (interval.resonances.empty()) return "slips, without a natural frequency in the band";
  return fmt::format("slips: natural frequency {} in the band", fmt::join(interval.resonances, ", "));
}

void print_scan(const std::string& title, const studies::DesignScan& scan) {
  fmt::print("\n{}, ends to {}\n", title, significant(scan.accuracy, 2));
  const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(scan.accuracy))));
  const auto end = [&](double value) { return fmt::format("{:.{}f}", value, decimals); };
  for (const auto& interval : scan.intervals)
    fmt::print("{:<28}{}\n", fmt::format("{} ... {}", end(interval.from), end(interval.to)),
               reason_for(interval));
}

std::string resonance_text(const std::vector<studies::Resonance>& resonances) {
  if (resonances.empty()) return "none";
  std::vector<std::string> texts;
  for (const auto& resonance : resonances)
    texts.push_back(fmt::format("{} at {}", resonance.mode, significant(resonance.frequency_hz, 7)));
  return fmt::format("{}", fmt::join(texts, ", "));
}

void print_table(const data::Case& problem, const studies::Design& design) {
  const auto row = [](std::string_view name, std::string_view value) {
    fmt::print("{:<34}{}\n", name, value);
  };
  fmt::print("{}: {} to {} Hz, {} m, 0 to {} s, N = {}\n\n", problem.name,
             data::shortest_text(design.band.from_hz), data::shortest_text(design.band.to_hz),
             data::shortest_text(problem.excitation.amplitude()),
             data::shortest_text(problem.numerics.duration()), problem.numerics.modes());
  const auto& margin = design.margin;
  row("smallest margin mu_s P/|f_max|",
      common_digits(margin.margin) + (margin.margin.lower < 1.0 ? ": slips" : ": sticks"));
  row("at / Hz", significant(margin.frequency_hz, 7));
  row("largest |f| / N", common_digits(margin.force_max));
  row("friction limit mu_s P / N", data::shortest_text(margin.friction_limit));
  row("natural frequencies in the band", resonance_text(margin.resonances));
  print_scan(fmt::format("length / m at P = {} N", data::shortest_text(problem.beam.axial_force())),
             design.lengths);
  print_scan(fmt::format("axial force / N at L = {} m", data::shortest_text(problem.beam.length())),
             design.forces);
  fmt::print("\n{}\n", guarantee);
}

Json to_json(const studies::DesignScan& scan) {
  Json intervals = Json::array();
  for (const auto& interval : scan.intervals)
    intervals.push_back({{"from", interval.from},
                         {"to", interval.to},
                         {"state", interval.buckled  ? "no stick state"
                                   : interval.sticks ? "stick"
                                                     : "stick-slip"},
                         {"natural_frequencies_in_band", interval.resonances}});
  return {{"accuracy", scan.accuracy}, {"intervals", intervals}};
}

Json to_json(const data::Case& problem, const studies::Design& design,
             const std::vector<std::string>& warnings) {
  Json resonances = Json::array();
  for (const auto& resonance : design.margin.resonances)
    resonances.push_back({{"mode", resonance.mode}, {"frequency_hz", resonance.frequency_hz}});
  return {{"case", problem.name},
          {"band_hz", {design.band.from_hz, design.band.to_hz}},
          {"amplitude_m", problem.excitation.amplitude()},
          {"duration_s", problem.numerics.duration()},
          {"modes", problem.numerics.modes()},
          {"margin", bounds_json(design.margin.margin)},
          {"frequency_hz", design.margin.frequency_hz},
          {"force_max_N", bounds_json(design.margin.force_max)},
          {"friction_limit_N", design.margin.friction_limit},
          {"evaluations", design.margin.evaluations},
          {"natural_frequencies_in_band", resonances},
          {"lengths_m", to_json(design.lengths)},
          {"axial_forces_N", to_json(design.forces)},
          {"warnings", warnings}};
}

void run(const DesignOptions& options) {
  const ExcitationOptions excitation{.frequency_hz = {}, .amplitude = options.amplitude};
  data::Case problem = load_case(options.problem, excitation, options.duration);
  data::require_rigid(problem.contact, "the design guide, whose tip is held; respond takes it");
  require_undamped(problem, "the design guide");
  analytic::require_contact(problem.beam);
  const Ranges ranges = ranges_of(problem, options);
  problem.numerics = numerics_up_to(ranges.band.to, options.problem, excitation, options.duration);
  for (const double length : {problem.beam.length(), ranges.lengths.from})
    studies::require_feasible(at_the_end_of(problem, ranges.band, length), studies::Inquiry::design);
  const studies::Design design = design_of(problem, ranges);
  const auto warnings =
      warnings_of(at_the_end_of(problem, ranges.band, problem.beam.length()), studies::Inquiry::design);
  const Json answer = to_json(problem, design, warnings);
  require_finite(answer);
  print_warnings(warnings);
  if (options.problem.json)
    print_json(answer);
  else
    print_table(problem, design);
}

}  // namespace

void add_design_command(CLI::App& app) {
  auto* command = app.add_subcommand(
      "design", "Margin to slipping over a band of frequencies; lengths and axial forces that avoid it");
  auto options = std::make_shared<DesignOptions>();
  add_case_options(*command, options->problem);
  command->add_option("--band", options->band, "Excitation frequencies, Hz; both ends may be the same")
      ->type_name("FROM:TO")
      ->required();
  command
      ->add_option("--amplitude", options->amplitude, "Amplitude at all of them, m (else that of the case)")
      ->check(number());
  command
      ->add_option("--length", options->length,
                   "Lengths to look at, m (default: half to twice that of the case, below buckling)")
      ->type_name("FROM:TO");
  command
      ->add_option("--force", options->force,
                   "Axial forces to look at, N (default: a tenth to ten times that of the case, below "
                   "buckling)")
      ->type_name("FROM:TO");
  command->add_option("--duration", options->duration, "Duration, s (else that of the case)")
      ->check(number());
  add_threads_option(*command);
  add_examples(*command, {"stickslip design steel-strip --band 24:26 --length 0.25:0.35 --force 10:40"});
  command->callback([options] { run(*options); });
}

}  // namespace stickslip::cli
