#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace stickslip::studies {

/// Calls work(0) ... work(count - 1) on so many threads, each index once, and `progress` with the share done.
/// The first exception ends it and is thrown on. `work` must not depend on the order.
inline void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work,
                        const std::function<void(double)>& progress = {}, unsigned threads = 2) {
  std::atomic<std::size_t> next{0};
  std::size_t done = 0;
  std::mutex guard;
  std::exception_ptr failure;
  const auto take_turns = [&] {
    try {
      for (std::size_t index = next++; index < count; index = next++) {
        work(index);
        const std::lock_guard lock(guard);
        ++done;
        if (progress) progress(static_cast<double>(done) / static_cast<double>(count));
      }
    } catch (...) {
      const std::lock_guard lock(guard);
      failure = std::current_exception();
      next = count;
    }
  };
  {
    std::vector<std::jthread> others;
    while (others.size() + 1 < threads) others.emplace_back(take_turns);
    take_turns();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace stickslip::studies
