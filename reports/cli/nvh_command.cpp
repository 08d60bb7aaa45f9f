// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "render/history_drawing.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/analyses/slip_readouts.hpp"
#include "studies/history/method.hpp"

namespace stickslip::cli {

namespace {

struct NvhOptions {
  CaseOptions problem{.name = "squeak-stand"};
  std::optional<std::string> method;
  studies::ReadoutOptions readouts;
  int average{1};
  std::string audio, figure;
};

Value shown(double value) { return std::isfinite(value) ? rounded(value, 6) : Value{nullptr, "none"}; }
Value shown(std::size_t number) { return count(number); }
Value shown(const studies::Estimate& mean) {
  if (!std::isfinite(mean.value)) return {nullptr, "none"};
  return estimated(mean, fmt::format("{:.6g} ({:.4g} ... {:.4g})", mean.value, mean.lower, mean.upper));
}

double middle_of(const studies::Estimate& mean) { return mean.value; }
double middle_of(double value) { return value; }
double middle_of(std::size_t number) { return static_cast<double>(number); }

using Runs = std::vector<studies::SlipReadouts>;

// Of one motion, or the mean over several.
template <class Number>
Value number_of(const Runs& runs, Number studies::SlipReadouts::*number) {
  if (runs.size() == 1) return shown(runs.front().*number);
  return shown(studies::mean_over(runs, [&](const auto& run) { return middle_of(run.*number); }));
}

// That of the most.
std::string_view sound_of(const Runs& runs) {
  constexpr std::array<std::string_view, 3> sounds{"none", "tick", "squeal"};
  return *std::ranges::max_element(sounds, {}, [&](std::string_view sound) {
    return std::ranges::count(runs, sound, &studies::SlipReadouts::sound);
  });
}

Answer readouts_answer(const Runs& runs, const NvhOptions& options, const studies::MethodChoice& choice) {
  using studies::SlipReadouts;
  const SlipReadouts& first = runs.front();
  Answer answer(36);
  add_method(answer, choice);
  answer.add_members({{"transient_s", options.readouts.transient},
                      {"percentiles", {95, 99}},
                      {"realisations", runs.size()},
                      {"least_rows_in_a_period", studies::least_rows_in_a_period},
                      {"audio", options.audio.empty() ? Json() : Json(options.audio)}});
  if (runs.size() > 1)
    answer.add_line(fmt::format(
        "means over {} realisations, with an interval of 95 % by Student's t from one value of each",
        runs.size()));
  answer.add_line(
      fmt::format("at least {} rows in a period of the motion and of the first natural frequency\n",
                  studies::least_rows_in_a_period));
  for (const LabelledValue& row : std::initializer_list<LabelledValue>{
           {"rows", "rows", count(first.rows)},
           {"from row to row / s", "row_step_s", exact(first.row_step)},
           {runs.size() == 1 ? "windows of the means" : "windows of the ranges", "windows",
            count(static_cast<std::size_t>(options.readouts.windows))},
           {"tip on wall, peak to peak / m", "peak_to_peak_m", number_of(runs, &SlipReadouts::peak_to_peak)},
           {"95 % of |distance from mean| / m", "distance_95_m", number_of(runs, &SlipReadouts::distance_95)},
           {"99 % of |distance from mean| / m", "distance_99_m", number_of(runs, &SlipReadouts::distance_99)},
           {"travel / m", "travel_m", number_of(runs, &SlipReadouts::travel)},
           {"travel / (m/s)", "travel_m_per_s", number_of(runs, &SlipReadouts::travel_rate)},
           {"slips", "slips", number_of(runs, &SlipReadouts::slips)},
           {"slips / (1/s)", "slips_per_s", number_of(runs, &SlipReadouts::slip_rate)},
           {"slips over travel / (1/m)", "slips_per_m", number_of(runs, &SlipReadouts::slips_per_travel)},
           {"share of slip", "slip_share", number_of(runs, &SlipReadouts::slip_share)},
           {"spacing of slips / s", "spacing_s", number_of(runs, &SlipReadouts::spacing)},
           {"its coefficient of variation", "spacing_variation",
            number_of(runs, &SlipReadouts::spacing_variation)},
           {"sound, by the rule of this program", "sound", word(sound_of(runs))},
           {"power of friction / W", "friction_power_W", number_of(runs, &SlipReadouts::friction_power)},
           {"strongest line of force / Hz", "peak_hz", number_of(runs, &SlipReadouts::peak_hz)},
           {"its amplitude / N", "peak_force_N", number_of(runs, &SlipReadouts::peak_force)},
           {"levels up to / Hz", "highest_line_hz", shown(0.5 / first.row_step)},
           {"level of force / dB re 1 N", "force_level_dB", number_of(runs, &SlipReadouts::force_level)},
           {"A-weighted / dB re 1 N", "a_weighted_level_dB",
            number_of(runs, &SlipReadouts::a_weighted_level)}})
    answer.add_row(row);
  return answer;
}

Answer nvh(const NvhOptions& options, Outputs& outputs) {
  const data::Case problem = load_case(options.problem);
  const studies::MethodChoice choice =
      studies::method_for(problem, {.method = options.method,
                                    .features = {data::Feature::slip},
                                    .of_elements = mesh_key_of(options.problem)});
  const studies::Method& method = *choice.method;
  const studies::Sampling sampling{.every = studies::readout_row_step(problem, options.readouts),
                                   .with_midspan = false};
  outputs.set_case(problem);
  if (options.average > 1) (void)studies::realisation(problem, 0);
  outputs.open({{"--audio", options.audio}, {"--figure", options.figure}});
  report::Progress& progress = outputs.progress();
  Runs runs;
  const auto motion_of = [&](const data::Case& of) {
    std::vector<studies::HistoryRow> rows;
    studies::History history = method.run(of, sampling, {}, [&](const studies::HistoryRow& row) {
      rows.push_back(row);
      progress((static_cast<double>(runs.size()) + row.time / of.numerics.duration()) / options.average);
    });
    history.rows = std::move(rows);
    runs.push_back(studies::slip_readouts(of, history, options.readouts));
    return history;
  };
  const studies::History history = motion_of(problem);
  for (int i = 1; i < options.average; ++i)
    (void)motion_of(studies::realisation(problem, static_cast<std::uint64_t>(i)));
  Answer answer = readouts_answer(runs, options, choice);
  answer.add_members({{"duration_s", problem.numerics.duration()}});
  answer.warnings = studies::warnings_after(problem, method, history);
  outputs.write("--audio", [&] { return studies::force_as_wav(history, options.readouts.transient); });
  outputs.draw(problem.name, [&](const report::Look& look) {
    return report::readouts_drawing(problem, history, runs.front(), look);
  });
  return answer;
}

void add_options(CLI::App& command, NvhOptions& options) {
  add_case_options(command, options.problem);
  options.problem.rigid_for.clear();
  add_excitation_options(command, options.problem);
  command.add_option("--method", options.method, "As that of respond")
      ->check(one_of(studies::method_names()));
  add_duration_option(command, options.problem);
  command.add_option("--transient", options.readouts.transient, "Time to leave out from the start, s")
      ->transform(time())
      ->capture_default_str();
  add_integer_option(command, "--windows", options.readouts.windows, 2, 10'000,
                     "Windows of equal length over which means are taken");
  add_integer_option(
      command, "--average", options.average, 1, 100'000,
      "With a spectrum: realisations, of its seed and those after it. Above 1, all numbers are "
      "means over realisations, with an interval of 95 % by Student's t from one value of "
      "each, not from windows; warnings and files are those of the first");
  add_figure_option(command, options.figure,
                    "Motion and friction force in the window with the most slips, and range over time "
                    "between slips of all windows");
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
