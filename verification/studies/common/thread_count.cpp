// SPDX-License-Identifier: MIT
#include "studies/common/thread_count.hpp"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>

namespace stickslip::studies {

namespace {

std::atomic<unsigned>& chosen() {
  static std::atomic<unsigned> count{std::max(1U, std::thread::hardware_concurrency())};
  return count;
}

}  // namespace

unsigned thread_count() noexcept { return chosen(); }

void set_thread_count(unsigned count) {
  if (count == 0) throw std::invalid_argument("the number of threads is 0, but must be 1 or more");
  chosen() = count;
}

}  // namespace stickslip::studies
