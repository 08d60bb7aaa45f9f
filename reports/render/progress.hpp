// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

namespace stickslip::report {

/// One line on standard error, "WHO: SENTENCE", of at most 2000 bytes of the sentence. Where standard error is closed or
/// full, nothing happens.
void tell(std::string_view who, std::string_view sentence);

/// How progress is shown: as a bar to a person at a terminal, as lines in a log, and not at all in a pipe,
/// whose reader did not ask for it.
enum class ProgressStyle { silent, lines, bar };

/// That of what a file descriptor leads to: a bar for a terminal, lines for a regular file, else silent.
[[nodiscard]] ProgressStyle progress_style_of(int descriptor);

/// How far long work is: the share done, the rate and the time left. A bar is redrawn at most ten times a
/// second and when a new stage begins, and erased in the end; lines come every five seconds, the first after
/// as many. May be called from any thread.
class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  /// What progress is told to and when; by default standard error, and now.
  struct ProgressSink {
    ProgressStyle style{};
    std::function<void(std::string_view)> write;
    std::function<Clock::time_point()> now;
  };
  [[nodiscard]] static ProgressSink standard_error(bool quiet);

  /// `job` is named in front; with a number of items the rate is items, else per cent, per second.
  Progress(std::string job, ProgressSink sink, std::size_t items = 0);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// The share done, 0 ... 1.
  void operator()(double share);

  /// What is being done now.
  void stage(std::string_view what);

  /// Takes the bar from the screen; further progress is not shown.
  void finish();

  [[nodiscard]] double share() const;

 private:
  void show(Clock::time_point now);
  [[nodiscard]] std::string bar(Clock::time_point now) const;
  [[nodiscard]] std::string line(Clock::time_point now) const;
  [[nodiscard]] std::string pace(Clock::time_point now, std::string_view separator) const;

  std::string job_;
  ProgressSink sink_;
  std::size_t items_;
  mutable std::mutex guard_;
  Clock::time_point begin_, shown_;
  double share_{};
  std::string stage_;
  bool on_screen_{};
};

}  // namespace stickslip::report
