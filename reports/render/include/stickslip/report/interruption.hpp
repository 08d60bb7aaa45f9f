#pragma once

#include <atomic>
#include <csignal>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace stickslip::report {

/// While it lives, Ctrl-C (SIGINT) and SIGTERM end the program in good order: other programs that it runs are
/// killed (end_tools()); `last_words` puts away what is not finished and says what was completed, in one
/// sentence, which is printed on standard error after the program's name; then the program ends with the exit
/// status 128 + n for signal n, whatever its threads are doing. A second signal ends it at once. A signal
/// that is ignored stays so. One at a time may live, on one thread: the signals are blocked there and on the
/// threads that it starts, and taken by one that does nothing else.
class Interruption {
 public:
  /// `last_words` is called on a thread of its own. Throws std::system_error if there is none to be had.
  explicit Interruption(std::function<std::string()> last_words);
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// A signal that comes while the result lives waits until it is gone.
  [[nodiscard]] std::unique_lock<std::mutex> hold() { return std::unique_lock(guard_); }

 private:
  void wait_for_signal();

  std::function<std::string()> last_words_;
  sigset_t watched_{}, previous_mask_{};
  std::atomic<bool> is_over_{false};
  std::mutex guard_;
  std::thread watcher_;
};

}  // namespace stickslip::report
