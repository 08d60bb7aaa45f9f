// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "stickslip/data/problem.hpp"
#include "studies/history/method.hpp"

namespace stickslip::report {

struct AnimationOptions {
  const studies::Method* method{};
  int frames{};   ///< 2 ... most_frames, evenly from `from` to numerics.duration(), both included
  double from{};  ///< s
  std::filesystem::path output;  ///< folder of the frames, made if missing, or a film, a .gif or .mp4 file
  std::string caption;           ///< of each frame, after the name of the case
  std::string title;             ///< of motion.csv
  bool quiet{};                  ///< no progress on standard error
};

inline constexpr int most_frames = 9999;

/// Writes motion.csv, the motion of the beam, and draws it as frame-0001.png, frame-0002.png, ..., all with
/// the same size and axes. The frames appear when the last one is drawn, or not at all. A film shows them at 25 a second,
/// as GIF again and again, and is all that is left. MP4 is made of the PNG files by ffmpeg.
///
/// Throws data::InputError for MP4 without ffmpeg and for an output folder that cannot be used or holds later frames of a longer
/// animation, what studies::snapshots_of() and the method throw, ToolMissing without gnuplot,
/// data::OutputError for a film that cannot be written, and std::runtime_error if it fails (motion.csv is in the folder by
/// then).
void write_animation(const data::Case& problem, const AnimationOptions& options);

}  // namespace stickslip::report
