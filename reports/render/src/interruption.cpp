#include "stickslip/report/interruption.hpp"

#include <fmt/format.h>
#include <pthread.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "external_tool.hpp"

namespace stickslip::report {

namespace {

constexpr int end_of_watch = SIGURG;  // which nobody minds who has it from elsewhere

bool is_ignored(int signal) {
  struct sigaction present {};
  ::sigaction(signal, nullptr, &present);
  return present.sa_handler == SIG_IGN;
}

}  // namespace

Interruption::Interruption(std::function<std::string()> last_words) : last_words_(std::move(last_words)) {
  ::sigemptyset(&watched_);
  ::sigaddset(&watched_, end_of_watch);
  for (const int signal : {SIGINT, SIGTERM})
    if (!is_ignored(signal)) ::sigaddset(&watched_, signal);
  ::pthread_sigmask(SIG_BLOCK, &watched_, &previous_mask_);
  try {
    watcher_ = std::thread([this] { wait_for_signal(); });
  } catch (...) {
    ::pthread_sigmask(SIG_SETMASK, &previous_mask_, nullptr);
    throw;
  }
}

Interruption::~Interruption() {
  is_over_ = true;
  ::pthread_kill(watcher_.native_handle(), end_of_watch);
  watcher_.join();
  ::pthread_sigmask(SIG_SETMASK, &previous_mask_, nullptr);
}

void Interruption::wait_for_signal() {
  int signal{};
  do {
    ::sigwait(&watched_, &signal);
  } while (signal == end_of_watch && !is_over_);
  if (signal == end_of_watch) return;
  ::pthread_sigmask(SIG_UNBLOCK, &watched_, nullptr);  // the next one ends the program
  end_tools();                                         // who holds waits for none of them
  const std::lock_guard lock(guard_);
  fmt::print(stderr, "{}: {}\n", ::program_invocation_short_name, last_words_());
  std::fflush(stderr);
  std::_Exit(128 + signal);
}

}  // namespace stickslip::report
