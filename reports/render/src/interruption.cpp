#include "stickslip/report/interruption.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <system_error>
#include <utility>

#include "external_tool.hpp"

namespace stickslip::report {

namespace {

constexpr char no_signal = 0;

std::atomic<int> pipe_of_the_handler{-1};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not lock");

void send(int descriptor, char byte) {
  while (::write(descriptor, &byte, 1) < 0 && errno == EINTR) {
  }
}

void handle(int signal) {
  const int error = errno;
  send(pipe_of_the_handler, static_cast<char>(signal));
  errno = error;
}

}  // namespace

Interruption::Interruption(std::function<std::string()> last_words) : last_words_(std::move(last_words)) {
  if (::pipe2(pipe_.data(), O_CLOEXEC) != 0)
    throw std::system_error(errno, std::generic_category(), "no pipe for signals");
  pipe_of_the_handler = pipe_[1];
  watcher_ = std::thread([this] { wait_for_signal(); });
  struct sigaction once {};
  once.sa_handler = handle;
  once.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
  for (std::size_t i = 0; i < signals_.size(); ++i) {
    ::sigaction(signals_[i], nullptr, &previous_[i]);
    if (previous_[i].sa_handler != SIG_IGN) ::sigaction(signals_[i], &once, nullptr);
  }
}

Interruption::~Interruption() {
  for (std::size_t i = 0; i < signals_.size(); ++i) ::sigaction(signals_[i], &previous_[i], nullptr);
  send(pipe_[1], no_signal);
  watcher_.join();
  for (const int descriptor : pipe_) ::close(descriptor);
}

void Interruption::wait_for_signal() {
  char signal = no_signal;
  while (::read(pipe_[0], &signal, 1) < 0 && errno == EINTR) {
  }
  if (signal == no_signal) return;
  end_tools();  // who holds waits for none of them
  const std::lock_guard lock(guard_);
  fmt::print(stderr, "{}: {}\n", ::program_invocation_short_name, last_words_());
  std::fflush(stderr);
  std::_Exit(128 + signal);
}

}  // namespace stickslip::report
