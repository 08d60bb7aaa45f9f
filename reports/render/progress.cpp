// SPDX-License-Identifier: MIT
#include "render/progress.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <utility>

#include "stickslip/data/input_text.hpp"

namespace stickslip::report {

namespace {

using namespace std::chrono_literals;

constexpr auto between_bars = 100ms;
constexpr auto between_lines = 5s;
constexpr int bar_cells = 20;
constexpr std::size_t columns = 79;  // of a terminal, so that no bar breaks into two lines
constexpr std::string_view erased_line = "\r\033[K";

std::string time_text(double seconds) {
  const auto whole = static_cast<long>(std::min(seconds, 1e9) + 0.5);
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

// All of it is done only when it is.
int per_cent(double share) { return static_cast<int>(100.0 * share + 1e-9); }

}  // namespace

void tell(std::string_view who, std::string_view sentence) {
  constexpr std::size_t longest = 2000;
  std::cerr << fmt::format("{}: {}\n", who, data::printable(sentence, longest));  // throws nothing
}

ProgressStyle progress_style_of(int descriptor) {
  if (::isatty(descriptor) == 1) return ProgressStyle::bar;
  struct stat status {};
  const bool in_a_file = ::fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
  return in_a_file ? ProgressStyle::lines : ProgressStyle::silent;
}

Progress::ProgressSink Progress::standard_error(bool quiet) {
  return {.style = quiet ? ProgressStyle::silent : progress_style_of(STDERR_FILENO),
          .write =
              [](std::string_view text) {
                std::fwrite(text.data(), 1, text.size(), stderr);
                std::fflush(stderr);
              },
          .now = Clock::now};
}

Progress::Progress(std::string job, ProgressSink sink, std::size_t items)
    : job_(std::move(job)),
      sink_(std::move(sink)),
      items_(items),
      begin_(sink_.now()),
      shown_(begin_ -
             (sink_.style == ProgressStyle::bar ? Clock::duration(between_bars) : Clock::duration::zero())) {}

Progress::~Progress() { finish(); }

void Progress::operator()(double share) {
  const std::lock_guard lock(guard_);
  share_ = share;
  const auto now = sink_.now();
  const bool is_bar = sink_.style == ProgressStyle::bar;
  if (now - shown_ >= (is_bar ? Clock::duration(between_bars) : Clock::duration(between_lines))) show(now);
}

void Progress::stage(std::string_view what) {
  const std::lock_guard lock(guard_);
  stage_ = what;
  const auto now = sink_.now();
  if (sink_.style == ProgressStyle::bar || now - shown_ >= between_lines) show(now);
}

void Progress::finish() {
  const std::lock_guard lock(guard_);
  if (on_screen_) sink_.write(erased_line);
  on_screen_ = false;
  sink_.style = ProgressStyle::silent;
}

double Progress::share() const {
  const std::lock_guard lock(guard_);
  return share_;
}

void Progress::show(Clock::time_point now) {
  if (sink_.style == ProgressStyle::silent) return;
  shown_ = now;
  on_screen_ = sink_.style == ProgressStyle::bar;
  sink_.write(on_screen_ ? bar(now) : line(now));
}

std::string Progress::bar(Clock::time_point now) const {
  const int filled = std::clamp(static_cast<int>(bar_cells * share_ + 1e-9), 0, bar_cells);
  std::string text =
      fmt::format("{}  [{:-<{}}]  {} %{}", job_, std::string(static_cast<std::size_t>(filled), '#'),
                  bar_cells, per_cent(share_), pace(now, "  "));
  if (!stage_.empty()) text += "  " + stage_;
  return std::string(erased_line) + text.substr(0, columns);
}

std::string Progress::line(Clock::time_point now) const {
  return fmt::format("{}: {} %{}{}{}\n", job_, per_cent(share_), pace(now, ", "), stage_.empty() ? "" : ", ",
                     stage_);
}

// Rate and time left, once there is something to go by.
std::string Progress::pace(Clock::time_point now, std::string_view separator) const {
  const double seconds = std::chrono::duration<double>(now - begin_).count();
  if (seconds <= 0.0 || share_ <= 0.0) return "";
  const double rate = share_ / seconds;
  const std::string speed = items_ > 0 ? fmt::format("{:.3g}/s", rate * static_cast<double>(items_))
                                       : fmt::format("{:.2g} %/s", 100.0 * rate);
  return fmt::format("{0}{1}{0}{2} left", separator, speed, time_text((1.0 - share_) / rate));
}

}  // namespace stickslip::report
