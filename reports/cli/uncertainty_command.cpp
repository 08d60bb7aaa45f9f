// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "range_text.hpp"
#include "render/criterion_map.hpp"
#include "studies/analyses/slip_probability.hpp"

namespace stickslip::cli {

namespace {

struct UncertaintyOptions {
  CaseOptions problem{.name = "uncertain"};
  std::optional<std::string> band;
  studies::SlipSampling sampling;
  std::string figure;
};

constexpr int digits = 4;

Value margin_of(const std::optional<double>& margin) {
  return {optional_json(margin), margin ? significant(*margin, digits) : "inadmissible"};
}

// Settings and counts of the sampling.
void add_samples(Answer& answer, const data::Case& problem, const UncertaintyOptions& options,
                 const studies::SlipUncertainty& result) {
  const auto& band = options.sampling.band;
  add_excitation(answer, problem, band);
  answer.add_line(fmt::format("{}, {} modes; {} samples, seed {}\n", conditions_of(problem, band),
                              problem.numerics.modes(), options.sampling.samples, options.sampling.seed));
  answer.add_row("probability of slip",
                 {fmt::format("{}: {} of {}", estimated(result.probability_of_slip, 5).text, result.slips,
                              result.valid)});
  if (const auto& all = result.all_modes) {
    const Value probability = estimated(all->probability_of_slip, 5);
    answer.add_row("the same, all modes",
                   {fmt::format("{}: {} of the first {}, of which {} with {} modes{}", probability.text,
                                all->slips, all->valid, all->slips_truncated, problem.numerics.modes(),
                                all->undecided > 0 ? fmt::format("; {} undecided", all->undecided) : "")});
    answer.add_members({{"all_modes",
                         {{"valid_samples", all->valid},
                          {"slips", all->slips},
                          {"undecided", all->undecided},
                          {"slips_with_modes", all->slips_truncated},
                          {"probability_of_slip", probability.json}}}});
  }
  for (const auto& [reason, count] : result.invalid)
    answer.add_row("inadmissible samples", {fmt::format("{}: {}", count, reason)});
  answer.add_members({{"samples", options.sampling.samples},
                      {"seed", options.sampling.seed},
                      {"valid_samples", result.valid},
                      {"invalid_samples", result.invalid},
                      {"probability_of_slip", result.probability_of_slip.value},
                      {"probability_lower", result.probability_of_slip.lower},
                      {"probability_upper", result.probability_of_slip.upper}});
}

Table quantile_table(const data::Case& problem,
                     const std::vector<studies::SlipUncertainty::Quantile>& quantiles) {
  const auto [unit, scale, column, name] = shown_amplitude(problem);
  Table table{
      .columns = {{"quantile", "probability", 28},
                  {fmt::format("critical {} / {}", name, unit), fmt::format("critical_{}", column), 26},
                  {"margin mu_s P/|f_max|", "margin"}},
      .rows = {}};
  for (const auto& [probability, amplitude, margin] : quantiles)
    table.rows.push_back({{probability, fmt::format("{:.0f} %", 100.0 * probability)},
                          estimated(amplitude, significant(scale * amplitude.value, digits)),
                          estimated(margin, significant(margin.value, digits))});
  return table;
}

Table key_table(const studies::SlipUncertainty& result) {
  const auto& sensitivity = result.sensitivity;
  std::size_t longest = 26;
  for (const auto& row : result.tornado) longest = std::max(longest, row.key.size());
  Table table{.columns = {{"key", "key", longest + 2},
                          {"5 % ... 95 %", "", 26},
                          {"margin", "", 22},
                          {"", "quantile_5"},
                          {"", "quantile_95"},
                          {"", "margin_at_quantile_5"},
                          {"", "margin_at_quantile_95"}},
              .rows = {}};
  if (sensitivity)
    table.columns.insert(table.columns.end(),
                         {{"first index", "first_index", 28}, {"total index", "total_index"}});
  for (std::size_t i = 0; i < result.tornado.size(); ++i) {
    const auto& [key, low, high, margin_low, margin_high] = result.tornado[i];
    const Value from{low, significant(low, digits)}, to{high, significant(high, digits)},
        worst = margin_of(margin_low), best = margin_of(margin_high);
    table.rows.push_back({word(key), word(from.text + " ... " + to.text),
                          word(worst.text + " ... " + best.text), from, to, worst, best});
    if (!sensitivity) continue;
    const auto& [first, total] = sensitivity->indices[i];
    table.rows.back().insert(table.rows.back().end(), {estimated(first, 3), estimated(total, 3)});
  }
  return table;
}

// Which tolerance to tighten or, where that does not help, which mean to move.
std::string advice(Answer& answer, const studies::SlipUncertainty& result) {
  const std::string& decisive = result.tornado[result.decisive].key;
  const Value halved = estimated(result.probability_with_half_spread, 5);
  const auto& best = result.best_change;
  answer.add_members({{"decisive", decisive},
                      {"tighten", result.tightening_helps ? Json(decisive) : Json()},
                      {"probability_with_half_spread", halved.json},
                      {"best_change", change_json(best)}});
  if (result.slips == 0) return "No sample slips.";
  const std::string text =
      fmt::format("{}: with half the spread of {} the probability of slip is {}.",
                  result.tightening_helps ? "A tighter tolerance helps" : "No tighter tolerance helps",
                  decisive, halved.text);
  if (result.tightening_helps || !best) return text;
  return fmt::format("{} Move the mean:\n{} times {} gives the case the margin {:.4g}.", text, best->key,
                     best->factor, best->margin);
}

Answer uncertainty_answer(const data::Case& problem, const UncertaintyOptions& options,
                          const studies::SlipUncertainty& result) {
  Answer answer;
  add_samples(answer, problem, options, result);
  const double margin = result.nominal_margin;
  answer.add_row({"margin of the case",
                  "margin_of_case",
                  {margin, significant(margin, digits) + (margin < 1.0 ? ": slips" : ": sticks")}});
  answer.add_line();
  answer.add_table("quantiles", quantile_table(problem, result.quantiles));
  answer.add_line();
  answer.add_table("keys", key_table(result));
  if (result.sensitivity) answer.add_members({{"index_rows_dropped", result.sensitivity->dropped}});
  answer.add_line("\n" + advice(answer, result));
  const char* indices = result.sensitivity ? "The indices are shares in the variance of log(margin)."
                                           : "There are no indices: keys are correlated, or more than 20.";
  answer.add_line(
      fmt::format("Numbers are those of {} modes unless said, intervals those of 95 % confidence. {}",
                  problem.numerics.modes(), indices));
  return answer;
}

Answer slip_probability(const UncertaintyOptions& given, Outputs& outputs) {
  UncertaintyOptions options = given;
  data::Case problem = load_case(options.problem);
  const data::Uncertainty uncertainty = studies::without(
      data::read_uncertainty(data::find_case(options.problem.name)), overrides_of(options.problem));
  if (options.band) {
    const auto band = parse_range("--band", "excitation.frequency_hz", *options.band, true);
    options.sampling.band = analytic::FrequencyBand{band.lower, band.upper};
    problem = restated(problem, {{"excitation.frequency_hz", band.upper}});
  }
  problem = studies::stated_as(problem, uncertainty);
  studies::require_feasible(problem);
  outputs.set_case(problem);
  outputs.open({{"--figure", options.figure}});
  const studies::SlipUncertainty result =
      studies::slip_uncertainty(problem, uncertainty, options.sampling, std::ref(outputs.progress()));
  Answer answer = uncertainty_answer(problem, options, result);
  answer.warnings =
      sentences_of(options.band ? studies::design_warnings(problem) : studies::criterion_warnings(problem));
  outputs.draw(problem.name, [&](const report::Look& look) { return report::draw(result, look); });
  return answer;
}

void add_options(CLI::App& command, UncertaintyOptions& options) {
  add_case_options(command, options.problem);
  add_excitation_options(command, options.problem);
  command
      .add_option(
          "--band", options.band,
          "The worst of these excitation frequencies, Hz, between rigorous bounds, instead of that of the "
          "case; undamped")
      ->type_name("FROM:TO")
      ->excludes("--hz");
  add_integer_option(command, "--samples", options.sampling.samples, 1, 100'000'000,
                     "Independent samples of the uncertain keys");
  add_integer_option(command, "--seed", options.sampling.seed, 0, 1'000'000'000,
                     "Of the random numbers: the same seed, the same answer");
  add_threads_option(command);
  add_figure_option(command, options.figure, "Histogram of the margins");
}

}  // namespace

void add_uncertainty_command(CLI::App& app) {
  add<UncertaintyOptions>(
      app, {.name = "uncertainty",
            .help = "Probability of slip of a case with uncertain keys, and which of them it hangs on",
            .examples = {"stickslip uncertainty uncertain --samples 1000 --figure margins.svg",
                         "stickslip uncertainty uncertain --band 30:35 --samples 50 --json"},
            .add_options = add_options,
            .run = slip_probability});
}

}  // namespace stickslip::cli
