// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

#include "case_options.hpp"
#include "commands.hpp"
#include "long_work.hpp"
#include "range_text.hpp"
#include "render/interruption.hpp"
#include "render/progress.hpp"
#include "studies/uncertainty/slip_probability.hpp"

namespace stickslip::cli {

namespace {

struct UncertaintyOptions {
  CaseOptions problem;
  ExcitationOptions excitation;
  std::optional<std::string> band;
  studies::SlipSampling sampling;
};

constexpr long most_samples = 100'000'000;
constexpr int digits = 4;

studies::SlipUncertainty result_of(const data::Case& problem, const data::Uncertainty& uncertainty,
                                   const studies::SlipSampling& sampling) {
  report::Progress progress("stickslip uncertainty", progress_surroundings());
  const report::Interruption interruption([&] {
    progress.finish();
    return fmt::format("interrupted after {:.0f} % of the samples; nothing is kept",
                       100.0 * progress.share());
  });
  return studies::slip_uncertainty(problem, uncertainty, sampling, [&](double share) { progress(share); });
}

std::string with_interval(const studies::Estimate& estimate, int decimals) {
  return fmt::format("{0:.{3}f} ({1:.{3}f} ... {2:.{3}f})", estimate.value, estimate.lower, estimate.upper,
                     decimals);
}

std::string margin_text(const std::optional<double>& margin) {
  return margin ? significant(*margin, digits) : "no beam";
}

void print_table(const data::Case& problem, const data::Uncertainty& uncertainty,
                 const UncertaintyOptions& options, const studies::SlipUncertainty& result) {
  const auto row = [](std::string_view name, std::string_view value) {
    fmt::print("{:<28}{}\n", name, value);
  };
  fmt::print("{}: {} Hz, {} m, 0 to {} s, N = {}; {} samples, seed {}\n\n", problem.name,
             options.band ? *options.band : data::shortest_text(problem.excitation.frequency_hz()),
             data::shortest_text(problem.excitation.amplitude()),
             data::shortest_text(problem.numerics.duration()), problem.numerics.modes(),
             options.sampling.samples, options.sampling.seed);
  row("probability of slip",
      fmt::format("{}: {} of {}", with_interval(result.probability_of_slip, 5), result.slips, result.valid));
  for (const auto& [reason, count] : result.invalid)
    row("samples that are no beam", fmt::format("{}: {}", count, reason));
  row("margin of the case",
      significant(result.nominal_margin, digits) + (result.nominal_margin < 1.0 ? ": slips" : ": sticks"));
  std::string probabilities, amplitudes, margins;
  for (const auto& [probability, amplitude, margin] : result.quantiles) {
    probabilities += fmt::format("{:<12}", fmt::format("{:.0f} %", 100.0 * probability));
    amplitudes += fmt::format("{:<12}", significant(amplitude.value, digits));
    margins += fmt::format("{:<12}", significant(margin.value, digits));
  }
  fmt::print("\n");
  row("quantile", probabilities);
  row("critical amplitude / m", amplitudes);
  row("margin mu_s P/|f_max|", margins);

  fmt::print("\n{:<28}{:<26}{:<22}{:<28}{}\n", "key", "5 % ... 95 %", "margin",
             result.sensitivity ? "first index" : "", result.sensitivity ? "total index" : "");
  for (std::size_t i = 0; i < uncertainty.keys.size(); ++i) {
    const auto& tornado = result.tornado[i];
    fmt::print("{:<28}{:<26}{:<22}", tornado.key,
               significant(tornado.low, digits) + " ... " + significant(tornado.high, digits),
               margin_text(tornado.margin_low) + " ... " + margin_text(tornado.margin_high));
    if (result.sensitivity)
      fmt::print("{:<28}{}", with_interval(result.sensitivity->indices[i].first, 3),
                 with_interval(result.sensitivity->indices[i].total, 3));
    fmt::print("\n");
  }
  fmt::print(
      "\nThe tolerance to tighten is that of {}: with half its spread the probability of slip is {}.\n",
      uncertainty.keys[result.decisive].key, with_interval(result.probability_with_half_spread, 5));
  fmt::print("All intervals are those of 95 % confidence. {}\n",
             result.sensitivity ? "The indices are shares in the variance of log(margin)."
                                : "There are no indices: keys are correlated, or more than 20.");
}

// null for an end that too few samples leave open.
Json to_json(const studies::Estimate& estimate) {
  return {{"value", finite_json(estimate.value)},
          {"lower", finite_json(estimate.lower)},
          {"upper", finite_json(estimate.upper)}};
}

Json keys_json(const data::Uncertainty& uncertainty, const studies::SlipUncertainty& result) {
  Json keys = Json::array();
  for (std::size_t i = 0; i < uncertainty.keys.size(); ++i) {
    const auto& [key, low, high, margin_low, margin_high] = result.tornado[i];
    Json row{{"key", key},
             {"quantile_5", low},
             {"quantile_95", high},
             {"margin_at_quantile_5", optional_json(margin_low)},
             {"margin_at_quantile_95", optional_json(margin_high)}};
    if (result.sensitivity) {
      row["first_index"] = to_json(result.sensitivity->indices[i].first);
      row["total_index"] = to_json(result.sensitivity->indices[i].total);
    }
    keys.push_back(row);
  }
  return keys;
}

Json to_json(const data::Case& problem, const data::Uncertainty& uncertainty,
             const UncertaintyOptions& options, const studies::SlipUncertainty& result,
             const std::vector<std::string>& warnings) {
  Json object{{"case", problem.name}};
  if (const auto& band = options.sampling.band)
    object["band_hz"] = {band->from_hz, band->to_hz};
  else
    object["frequency_hz"] = problem.excitation.frequency_hz();
  object["samples"] = options.sampling.samples;
  object["seed"] = options.sampling.seed;
  object["valid_samples"] = result.valid;
  object["invalid_samples"] = Json::object();
  for (const auto& [reason, count] : result.invalid) object["invalid_samples"][reason] = count;
  object["probability_of_slip"] = result.probability_of_slip.value;
  object["probability_lower"] = result.probability_of_slip.lower;
  object["probability_upper"] = result.probability_of_slip.upper;
  object["margin_of_case"] = result.nominal_margin;
  object["quantiles"] = Json::array();
  for (const auto& [probability, amplitude, margin] : result.quantiles)
    object["quantiles"].push_back({{"probability", probability},
                                   {"critical_amplitude_m", to_json(amplitude)},
                                   {"margin", to_json(margin)}});
  object["keys"] = keys_json(uncertainty, result);
  if (result.sensitivity) object["index_rows_dropped"] = result.sensitivity->dropped;
  object["tighten"] = uncertainty.keys[result.decisive].key;
  object["probability_with_half_spread"] = to_json(result.probability_with_half_spread);
  object["warnings"] = warnings;
  return object;
}

void run(UncertaintyOptions options) {
  const auto overrides = overrides_of(options.problem, options.excitation);
  const auto file = data::find_case(options.problem.name);
  data::Case problem = data::read_case(file, overrides);
  data::require_rigid(problem.contact, "the probability of slip, whose tip is held; respond takes it");
  std::vector<std::string> fixed;
  for (const auto& replacement : overrides) fixed.push_back(replacement.key);
  const data::Uncertainty uncertainty = studies::without(data::read_uncertainty(file), fixed);
  for (const auto& key : uncertainty.keys)
    if (key.key.starts_with("contact."))
      throw data::FieldError("[uncertainty]", key.key,
                             "a key of another table: here the tip is held or slides");
  if (options.band) {
    const auto band = parse_band("--band", *options.band);
    options.sampling.band = analytic::FrequencyBand{band.from, band.to};
    for (const double end : {band.from, band.to})
      data::require_magnitude("excitation.frequency_hz", end, "--band");
    problem.numerics = numerics_up_to(band.to, options.problem, options.excitation, std::nullopt);
    problem.excitation =
        data::HarmonicExcitation({.frequency_hz = band.to, .amplitude = problem.excitation.amplitude()});
  }
  const auto inquiry = options.band ? studies::Inquiry::design : studies::Inquiry::criterion;
  studies::require_feasible(problem, inquiry);
  const auto result = result_of(problem, uncertainty, options.sampling);
  const auto warnings = warnings_of(problem, inquiry);
  const Json answer = to_json(problem, uncertainty, options, result, warnings);
  require_finite(answer);
  print_warnings(warnings);
  if (options.problem.json)
    print_json(answer);
  else
    print_table(problem, uncertainty, options, result);
}

}  // namespace

void add_uncertainty_command(CLI::App& app) {
  auto* command = app.add_subcommand(
      "uncertainty", "Probability of slip of a case with uncertain keys, and which of them it hangs on");
  auto options = std::make_shared<UncertaintyOptions>();
  options->problem.name = "uncertain";
  add_case_options(*command, options->problem);
  add_excitation_options(*command, options->excitation);
  command
      ->add_option(
          "--band", options->band,
          "The worst of these excitation frequencies, Hz, between rigorous bounds, instead of that of the "
          "case; undamped")
      ->type_name("FROM:TO")
      ->excludes("--hz");
  command->add_option("--samples", options->sampling.samples, "Independent samples of the uncertain keys")
      ->check(integer_between(1, most_samples))
      ->capture_default_str();
  command
      ->add_option("--seed", options->sampling.seed, "Of the random numbers: the same seed, the same answer")
      ->check(integer_between(0, 1'000'000'000))
      ->capture_default_str();
  add_threads_option(*command);
  add_examples(*command, {"stickslip uncertainty uncertain --samples 1000",
                          "stickslip uncertainty uncertain --band 30:35 --samples 50 --json"});
  command->callback([options] { run(*options); });
}

}  // namespace stickslip::cli
