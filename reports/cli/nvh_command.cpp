// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/analyses/slip_readouts.hpp"
#include "studies/history/method.hpp"

namespace stickslip::cli {

namespace {

struct NvhOptions {
  CaseOptions problem{.name = "squeak-stand"};
  std::optional<std::string> method;
  studies::ReadoutOptions readouts;
  std::string audio;
};

// The given one, else event-driven unless that refuses the case.
const studies::Method& method_for(const data::Case& problem, const NvhOptions& options) {
  const auto& chosen = options.method ? studies::method(*options.method) : studies::event_driven();
  try {
    chosen.require(data::Feature::slip, "--method", chosen.name);
    chosen.require(problem);
  } catch (const data::FieldError&) {
    if (options.method) throw;
    return studies::finite_elements();
  }
  studies::require_held_growth(problem, chosen);
  return chosen;
}

Value window_mean(const studies::Estimate& mean) {
  return estimated(mean, fmt::format("{:.6g} ({:.4g} ... {:.4g})", mean.value, mean.lower, mean.upper));
}

Value if_any(double value) { return std::isfinite(value) ? rounded(value, 6) : Value{nullptr, "none"}; }

Answer readouts_answer(const studies::SlipReadouts& readouts, const NvhOptions& options) {
  Answer answer(36);
  answer.add_members({{"transient_s", options.readouts.transient},
                      {"percentiles", {95, 99}},
                      {"least_rows_in_a_period", studies::least_rows_in_a_period},
                      {"audio", options.audio.empty() ? Json() : Json(options.audio)}});
  answer.add_line(
      fmt::format("at least {} rows in a period of the motion and of the first natural frequency\n",
                  studies::least_rows_in_a_period));
  for (const LabelledValue& row : std::initializer_list<LabelledValue>{
           {"rows", "rows", count(readouts.rows)},
           {"from row to row / s", "row_step_s", exact(readouts.row_step)},
           {"windows of the means", "windows", count(static_cast<std::size_t>(options.readouts.windows))},
           {"tip on wall, peak to peak / m", "peak_to_peak_m", window_mean(readouts.peak_to_peak)},
           {"95 % of |distance from mean| / m", "distance_95_m", rounded(readouts.distance_95, 6)},
           {"99 % of |distance from mean| / m", "distance_99_m", rounded(readouts.distance_99, 6)},
           {"travel / m", "travel_m", rounded(readouts.travel, 6)},
           {"travel / (m/s)", "travel_m_per_s", window_mean(readouts.travel_rate)},
           {"slips", "slips", count(readouts.slips)},
           {"slips / (1/s)", "slips_per_s", window_mean(readouts.slip_rate)},
           {"slips over travel / (1/m)", "slips_per_m", if_any(readouts.slips_per_travel)},
           {"share of slip", "slip_share", window_mean(readouts.slip_share)},
           {"spacing of slips / s", "spacing_s", if_any(readouts.spacing)},
           {"its coefficient of variation", "spacing_variation", if_any(readouts.spacing_variation)},
           {"sound, by the rule of this program", "sound", word(readouts.sound)},
           {"power of friction / W", "friction_power_W", window_mean(readouts.friction_power)},
           {"strongest line of force / Hz", "peak_hz", rounded(readouts.peak_hz, 6)},
           {"its amplitude / N", "peak_force_N", rounded(readouts.peak_force, 6)},
           {"levels up to / Hz", "highest_line_hz", rounded(0.5 / readouts.row_step, 6)},
           {"level of force / dB re 1 N", "force_level_dB", if_any(readouts.force_level)},
           {"A-weighted / dB re 1 N", "a_weighted_level_dB", if_any(readouts.a_weighted_level)}})
    answer.add_row(row);
  return answer;
}

Answer nvh(const NvhOptions& options, Outputs& outputs) {
  const data::Case problem = load_case(options.problem);
  const studies::Method& method = method_for(problem, options);
  const studies::Sampling sampling{.every = studies::readout_row_step(problem, options.readouts),
                                   .with_midspan = false};
  outputs.set_case(problem);
  outputs.open({{"--audio", options.audio}});
  report::Progress& progress = outputs.progress();
  std::vector<studies::HistoryRow> rows;
  studies::History history = method.run(problem, sampling, {}, [&](const studies::HistoryRow& row) {
    rows.push_back(row);
    progress(row.time / problem.numerics.duration());
  });
  history.rows = std::move(rows);
  Answer answer = readouts_answer(studies::slip_readouts(problem, history, options.readouts), options);
  answer.add_members({{"method", method.name}, {"duration_s", problem.numerics.duration()}});
  answer.warnings = studies::warnings_after(problem, method, history);
  outputs.write("--audio", [&] { return studies::force_as_wav(history, options.readouts.transient); });
  return answer;
}

void add_options(CLI::App& command, NvhOptions& options) {
  add_case_options(command, options.problem);
  options.problem.rigid_for.clear();
  add_excitation_options(command, options.problem);
  command
      .add_option("--method", options.method,
                  "As that of respond (default: event-driven where it takes the case, else fe)")
      ->check(one_of(studies::method_names()));
  add_duration_option(command, options.problem);
  command.add_option("--transient", options.readouts.transient, "Time to leave out from the start, s")
      ->transform(time())
      ->capture_default_str();
  add_integer_option(command, "--windows", options.readouts.windows, 2, 10'000,
                     "Windows of equal length over which means are taken");
  add_file_option(command, "--audio", options.audio,
                  "WAV file of the friction force less its mean, over its largest modulus, 44.1 kHz");
}

}  // namespace

void add_nvh_command(CLI::App& app) {
  add<NvhOptions>(app, {.name = "nvh",
                        .help = "What one measures and hears of stick-slip: travel, slips, work, levels",
                        .examples = {"stickslip nvh squeak-stand --transient 0.5 --audio squeak.wav",
                                     "stickslip nvh damped --hz 35 --amplitude 2e-3 --windows 5"},
                        .add_options = add_options,
                        .run = nvh});
}

}  // namespace stickslip::cli
