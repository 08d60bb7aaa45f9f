// SPDX-License-Identifier: MIT
#include "render/interruption.hpp"

#include <fmt/format.h>
#include <semaphore.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "render/external_tool.hpp"
#include "render/progress.hpp"

namespace stickslip::report {

namespace {

constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};

// What a signal handler may change: the signal that has come, 0 for none, and what the watcher waits for.
std::atomic<int> arrived{0};
static_assert(std::atomic<int>::is_always_lock_free);
sem_t arrival;

void note(int signal) {
  arrived = signal;
  ::sem_post(&arrival);
}

}  // namespace

Interruption::Interruption(std::function<std::string()> interruption_message)
    : interruption_message_(std::move(interruption_message)) {
  arrived = 0;
  ::sem_init(&arrival, 0, 0);
  try {
    watcher_ = std::thread([this] { wait_for_signal(); });
  } catch (const std::system_error& error) {
    throw std::system_error(error.code(),
                            "a thread that waits for Ctrl-C cannot be started (ulimit -u, ulimit -v)");
  }
  for (std::size_t i = 0; i < signals.size(); ++i) {
    ::sigaction(signals[i], nullptr, &previous_[i]);
    if (previous_[i].sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);  // the next one ends the program
    ::sigaction(signals[i], &action, nullptr);
  }
}

Interruption::~Interruption() {
  for (std::size_t i = 0; i < signals.size(); ++i) ::sigaction(signals[i], &previous_[i], nullptr);
  ::sem_post(&arrival);
  watcher_.join();
  ::sem_destroy(&arrival);
}

void Interruption::wait_for_signal() {
  while (::sem_wait(&arrival) != 0 && errno == EINTR) continue;
  const int signal = arrived;
  if (signal == 0) return;  // the work is done
  end_tools();              // whoever waits for one may hold the lock
  const std::lock_guard lock(guard_);
  tell(::program_invocation_short_name, interruption_message_());
  std::_Exit(128 + signal);
}

}  // namespace stickslip::report
