// SPDX-License-Identifier: MIT
#pragma once

#include <signal.h>

#include <array>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace stickslip::report {

/// While it lives, Ctrl-C (SIGINT), SIGTERM and SIGHUP end the program in good order, and first the one that it runs
/// (run_tool()): `interruption_message` removes what is not finished and returns one sentence on what is, which is printed on standard error after the program's name.
/// Then the program ends with the exit status 128 + n for signal n. A second signal ends it at once. A signal
/// that is ignored stays ignored. Only one may live at a time.
///
/// A thread of its own waits for the signal: a signal handler may neither print nor remove files, and the
/// computations, some of which take minutes in one call, need not ask whether a signal has come.
class Interruption {
 public:
  /// `interruption_message` is called on the thread that waits. Throws std::system_error if there is no thread to be
  /// had.
  explicit Interruption(std::function<std::string()> interruption_message);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// `interruption_message` is not called while the result lives.
  [[nodiscard]] std::unique_lock<std::mutex> block_interruption() { return std::unique_lock(guard_); }

 private:
  void wait_for_signal();

  std::function<std::string()> interruption_message_;
  std::array<struct sigaction, 3> previous_{};  // of SIGINT, SIGTERM and SIGHUP
  std::mutex guard_;
  std::thread watcher_;
};

}  // namespace stickslip::report
