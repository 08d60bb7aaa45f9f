#include "interruption.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <cstddef>
#include <cstdio>
#include <utility>

namespace stickslip::cli {

namespace {

std::atomic<int> received{0};
std::atomic<bool> told{false};  // every thread that works asks for progress
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may not lock");

}  // namespace

Interruption::Interruption() {
  struct sigaction once {};
  once.sa_handler = [](int signal) { received = signal; };
  once.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
  for (std::size_t i = 0; i < signals_.size(); ++i) {
    ::sigaction(signals_[i], nullptr, &previous_[i]);
    if (previous_[i].sa_handler != SIG_IGN) ::sigaction(signals_[i], &once, nullptr);
  }
}

Interruption::~Interruption() {
  for (std::size_t i = 0; i < signals_.size(); ++i) ::sigaction(signals_[i], &previous_[i], nullptr);
}

std::function<void(double)> Interruption::progress(std::function<void(double)> report) const {
  return [report = std::move(report)](double share) {
    if (const int signal = received; signal != 0) {
      if (!told.exchange(true)) fmt::print(stderr, "stickslip: interrupted\n");
      throw CLI::RuntimeError(128 + signal);
    }
    report(share);
  };
}

}  // namespace stickslip::cli
