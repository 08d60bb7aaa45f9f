// SPDX-License-Identifier: MIT
#include "render/animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
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
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/verification/contact_histories.hpp"

namespace stickslip::report {

namespace fs = std::filesystem;

namespace {

constexpr int positions = 81;
constexpr double frame_time =
    0.04;  // s, that gnuplot takes for a frame, measured: what the shares of progress rest on

std::string frame_name(std::size_t frame) { return fmt::format("frame-{:04}.png", frame + 1); }

void refuse_later_frames(const OutputFolder& output, int frames) {
  const fs::path next = output.folder() / frame_name(static_cast<std::size_t>(frames));
  if (fs::exists(next))
    throw data::InputError(
        fmt::format("output folder {} holds {} of a longer animation; remove it or name another folder",
                    output.folder().string(), next.filename().string()));
}

double seconds_since(Progress::Clock::time_point begin) {
  return std::chrono::duration<double>(Progress::Clock::now() - begin).count();
}

// Its share of the progress is that of the time it takes, the drawing being expected to take so long.
studies::History motion_of(const data::Case& problem, const AnimationOptions& options,
                           const studies::Sampling& sampling, double drawing_time, Progress& progress) {
  progress.stage("following the beam");
  const auto begin = Progress::Clock::now();
  std::vector<studies::HistoryRow> rows;
  studies::History motion = options.method->run(problem, sampling, {}, [&](const studies::HistoryRow& row) {
    const auto is_finite = [](double value) { return std::isfinite(value); };
    if (!is_finite(row.friction_force) || !std::ranges::all_of(row.displacement, is_finite))
      data::throw_overflow(fmt::format("the motion is not finite at {} s", data::shortest_text(row.time)));
    rows.push_back(row);
    const double taken = seconds_since(begin), followed = row.time / problem.numerics.duration();
    if (followed > 0.0) progress(taken / (taken / followed + drawing_time));
  });
  motion.rows = std::move(rows);
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
std::vector<FigureData::Value> values_of(const data::Case& problem, const studies::History& motion) {
  const double limit = studies::friction_limit(problem);
  double largest_force = limit;
  for (const auto& row : motion.rows) largest_force = std::max(largest_force, std::abs(row.friction_force));
  return {{"tip", positions - 1.0, "1"},
          {"frames", static_cast<double>(motion.rows.size()), "1"},
          {"length", problem.beam().length(), "m"},
          {"force_limit", limit, "N"},
          {"largest_force", largest_force, "N"},
          {"largest_displacement", studies::peak(motion), "m"}};
}

// Tells how many frames the script says it has drawn, as long as it lives. The progress begins where it is.
class DrawingProgress {
 public:
  DrawingProgress(Progress& progress, fs::path drawn, std::size_t frames, double share_of_all)
      : thread_([&progress, drawn = std::move(drawn), frames, share_of_all,
                 from = progress.share()](const std::stop_token& stop) {
          for (std::size_t frame = 0; !stop.stop_requested();) {
            std::ifstream(drawn) >> frame;
            progress.stage(fmt::format("drawing frame {} of {}", frame, frames));
            progress(from + share_of_all * static_cast<double>(frame) / static_cast<double>(frames));
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
          }
        }) {}

 private:
  std::jthread thread_;
};

// The drawings, in the scratch folder: all frames, or a film of them where the format is gif.
std::vector<fs::path> drawn_frames(const studies::History& motion, const std::vector<double>& position,
                                   const Look& look, OutputFolder& output) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < motion.rows.size(); ++i) {
    names.push_back(frame_name(i));
    data::write_text(output.scratch() / (names.back() + ".csv"),
                     table_of("Motion of the beam", motion, position, i, i + 1).text());
  }
  if (look.format == "gif") names = {"film.gif"};
  return draw_in_scratch("animation", look, "../", names, output);
}

// The film that ffmpeg makes of the frames in a folder.
fs::path encoded_film(const fs::path& folder) {
  const fs::path film = folder / "film.mp4", log = folder / "ffmpeg.log";
  const int status = run_tool("ffmpeg",
                              {"-loglevel", "error", "-framerate", "25", "-i", "frame-%04d.png", "-pix_fmt",
                               "yuv420p", film.filename()},
                              folder, log);
  if (std::error_code error; status != 0 || !fs::exists(film, error))
    throw std::runtime_error(
        fmt::format("ffmpeg could not make the film (status {}): {}", status, data::read_text(log)));
  return film;
}

void require_ffmpeg(const fs::path& film) {
  try {
    require_tool("ffmpeg");
  } catch (const ToolMissing& missing) {
    throw data::FieldError("--output", data::printable(film.string()),
                           fmt::format("a folder or a .gif file: {}", missing.what()));
  }
}

}  // namespace

void write_animation(const data::Case& problem, const AnimationOptions& options) {
  (void)templates_directory();  // refused now rather than after the run
  require_tool("gnuplot");
  const bool is_gif = options.output.extension() == ".gif", is_mp4 = options.output.extension() == ".mp4";
  if (is_mp4) require_ffmpeg(options.output);
  std::optional<data::AtomicFile> film;
  std::optional<data::TemporaryFolder> temporary;
  if (is_gif || is_mp4) {
    film.emplace(options.output.string());
    temporary.emplace();
  }
  OutputFolder output(temporary ? temporary->path() : options.output);
  refuse_later_frames(output, options.frames);
  Progress progress("stickslip animate", Progress::standard_error(options.quiet));
  const std::string table = (output.folder() / "motion.csv").string();
  std::atomic<bool> has_motion{false};
  Interruption interruption([&] {
    progress.finish();
    output.clear_scratch();
    if (film) {
      film->discard();
      remove_all(temporary->path());
    }
    return "interrupted; " + (has_motion ? "no frame is kept; the motion is in " + table : "nothing is kept");
  });
  const studies::Sampling sampling = studies::snapshots_of(
      problem, options.from, problem.numerics.duration() - options.from, options.frames, positions);
  const studies::History motion =
      motion_of(problem, options, sampling, frame_time * options.frames, progress);
  output.write("motion.csv",
               table_of(options.title, motion, sampling.positions, 0, motion.rows.size()).text());
  has_motion = !film;
  data::write_text(output.scratch() / "animation-values.csv",
                   values_table(values_of(problem, motion)).text());
  const double left = 1.0 - progress.share();
  std::vector<fs::path> drawings;
  {
    const DrawingProgress drawing(progress, output.scratch() / "drawn", motion.rows.size(),
                                  (is_mp4 ? 0.8 : 1.0) * left);
    drawings = drawn_frames(
        motion, sampling.positions,
        {.format = is_gif ? "gif" : "png", .title = problem.name + ": " + options.caption}, output);
  }
  if (is_mp4) {
    progress.stage("drawing " + options.output.string());
    drawings = {encoded_film(drawings.front().parent_path())};
  }
  if (film) film->write(data::read_text(drawings.front()));
  const auto lock = interruption.block_interruption();
  if (film) return film->commit();
  for (const fs::path& frame : drawings) output.publish(frame);
}

}  // namespace stickslip::report
