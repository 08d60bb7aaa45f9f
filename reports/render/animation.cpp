// SPDX-License-Identifier: MIT
#include "render/animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "render/csv_table.hpp"
#include "render/drawing.hpp"
#include "render/external_tool.hpp"
#include "render/interruption.hpp"
#include "render/output_folder.hpp"
#include "render/progress.hpp"
#include "render/report.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/case_file.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/verification/contact_histories.hpp"

namespace stickslip::report {

namespace fs = std::filesystem;

namespace {

constexpr int positions = 81;
constexpr std::size_t batch = 50;  // frames that one gnuplot process draws

std::string frame_name(std::size_t frame) { return fmt::format("frame-{:04}.png", frame + 1); }

void refuse_later_frames(const OutputFolder& output, int frames) {
  const fs::path next = output.folder() / frame_name(static_cast<std::size_t>(frames));
  if (fs::exists(next))
    throw data::InputError(
        fmt::format("output folder {} holds {} of a longer animation; remove it or name another folder",
                    output.folder().string(), next.filename().string()));
}

studies::History motion_of(const data::Case& problem, const AnimationOptions& options,
                           const studies::Sampling& sampling) {
  const auto require_finite = [](const studies::HistoryRow& row) {
    const auto is_finite = [](double value) { return std::isfinite(value); };
    if (!is_finite(row.friction_force) || !std::ranges::all_of(row.displacement, is_finite))
      data::throw_overflow(fmt::format("the motion is not finite at {} s", data::shortest_text(row.time)));
  };
  studies::History motion = options.method->run(problem, sampling, {}, {});
  std::ranges::for_each(motion.rows, require_finite);
  return motion;
}

// Frames first ... last - 1, `positions` rows each.
CsvTable table_of(const std::string& title, const studies::History& motion,
                  const std::vector<double>& position, std::size_t first, std::size_t last) {
  CsvTable table(
      title,
      "frame [1], time_s [s], tip_sticks [1], friction_force_N [N], position_m [m], displacement_m [m]");
  for (std::size_t i = first; i < last; ++i) {
    const studies::HistoryRow& row = motion.rows[i];
    const double sticks = row.state == data::ContactState::stick ? 1.0 : 0.0;
    for (std::size_t k = 0; k < position.size(); ++k)
      table.add_numbers({static_cast<double>(i + 1), row.time, sticks, row.friction_force, position[k],
                         row.displacement[k]});
  }
  return table;
}

// What the script needs to keep the axes of all frames alike.
std::vector<FigureData::Value> values_of(const data::Case& problem, const studies::History& motion,
                                         const std::string& caption) {
  const double limit = studies::friction_limit(problem);
  double largest_force = limit;
  for (const auto& row : motion.rows) largest_force = std::max(largest_force, std::abs(row.friction_force));
  return {{"points", positions, "1"},
          {"length", problem.beam().length(), "m"},
          {"caption", 0.0, "-", "\"" + caption + "\""},
          {"force_limit", limit, "N"},
          {"largest_force", largest_force, "N"},
          {"largest_displacement", studies::peak(motion), "m"}};
}

// The drawings, in the scratch folder.
std::vector<fs::path> drawn_frames(const data::Case& problem, const studies::History& motion,
                                   const std::vector<double>& position, const std::string& caption,
                                   Progress& progress, OutputFolder& output) {
  const std::size_t frames = motion.rows.size();
  std::vector<fs::path> drawn;
  for (std::size_t first = 0; first < frames; first += batch) {
    const std::size_t last = std::min(first + batch, frames);
    progress(static_cast<double>(first) / static_cast<double>(frames));
    progress.stage(fmt::format("drawing frames {} to {} of {}", first + 1, last, frames));
    data::write_text(output.scratch() / "frames.csv",
                     table_of("Motion of the beam", motion, position, first, last).text());
    auto values = values_of(problem, motion, caption);
    values.push_back({"first_frame", static_cast<double>(first + 1), "1"});
    values.push_back({"last_frame", static_cast<double>(last), "1"});
    data::write_text(output.scratch() / "animation-values.csv", values_table(values).text());
    std::vector<std::string> names;
    for (std::size_t i = first; i < last; ++i) names.push_back(frame_name(i));
    for (fs::path& file :
         draw_in_scratch("animation", {.format = "png", .title = problem.name}, "../", names, output))
      drawn.push_back(std::move(file));
  }
  return drawn;
}

}  // namespace

void write_animation(const data::Case& problem, const AnimationOptions& options) {
  (void)templates_directory();  // refused now rather than after the run
  require_tool("gnuplot");
  std::optional<data::AtomicFile> film;
  std::optional<data::TemporaryFolder> temporary;
  if (options.output.extension() == ".gif") {
    film.emplace(options.output.string());
    temporary.emplace();
  }
  OutputFolder output(temporary ? temporary->path() : options.output);
  refuse_later_frames(output, options.frames);
  Progress progress("stickslip animate", Progress::standard_error(options.quiet),
                    static_cast<std::size_t>(options.frames));
  const std::string table = (output.folder() / "motion.csv").string();
  std::atomic<bool> has_motion{false};
  Interruption interruption([&] {
    progress.finish();
    output.clear_scratch();
    if (film) {
      film->discard();
      remove_all(temporary->path());
    }
    return fmt::format("interrupted after {:.0f} % of the frames, none of which is kept{}",
                       100.0 * progress.share(), has_motion ? "; the motion is in " + table : "");
  });
  progress.stage("following the beam");
  const studies::Sampling sampling = studies::snapshots_of(
      problem, options.from, problem.numerics.duration() - options.from, options.frames, positions);
  const studies::History motion = motion_of(problem, options, sampling);
  output.write("motion.csv",
               table_of(options.title, motion, sampling.positions, 0, motion.rows.size()).text());
  has_motion = !film;
  const std::vector<fs::path> frames =
      drawn_frames(problem, motion, sampling.positions, options.caption, progress, output);
  if (film) {
    progress.stage("drawing " + options.output.string());
    film->write(
        data::read_text(draw_in_scratch("film", {.format = "gif"}, "../", {"film.gif"}, output).front()));
  }
  const auto lock = interruption.block_interruption();
  if (film) return film->commit();
  for (const fs::path& frame : frames) output.publish(frame);
}

}  // namespace stickslip::report
