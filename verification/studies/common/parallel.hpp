#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <span>
#include <thread>
#include <vector>

#include "studies/common/thread_count.hpp"

namespace stickslip::studies {

/// Calls work(0) ... work(count - 1) on `threads` threads, each index once. Calls `settled` with the indices
/// that are done: each index once, and one call at a time. An index waits for this call for at most 50 ms and
/// the duration of one item. The first exception of `work` or `settled` ends the work and is thrown again.
/// `work` must not depend on the order of the calls.
///
/// A thread takes up to 16 indices at a time, but at most 1/64 of its share. Items of unequal cost are thus
/// distributed evenly, and cheap items do not need one access to the shared counter each.
inline void in_parallel_settling(std::size_t count, const std::function<void(std::size_t)>& work,
                                 const std::function<void(std::span<const std::size_t>)>& settled,
                                 unsigned threads = thread_count()) {
  using Clock = std::chrono::steady_clock;
  constexpr auto longest_delay = std::chrono::milliseconds(50);
  const std::size_t taken_at_once = std::clamp<std::size_t>(count / (std::size_t{64} * threads), 1, 16);
  std::atomic<std::size_t> next{0};
  std::atomic<bool> failed{false};
  std::mutex guard;
  std::exception_ptr failure;

  const auto work_on_indices = [&] {
    std::vector<std::size_t> done;
    auto last = Clock::now();
    const auto settle = [&] {
      const std::lock_guard lock(guard);
      if (!failed && !done.empty()) settled(done);
      done.clear();
      last = Clock::now();
    };
    try {
      for (std::size_t first = next.fetch_add(taken_at_once); first < count && !failed;
           first = next.fetch_add(taken_at_once))
        for (std::size_t index = first; index < std::min(first + taken_at_once, count) && !failed; ++index) {
          work(index);
          done.push_back(index);
          if (Clock::now() - last >= longest_delay) settle();
        }
      settle();
    } catch (...) {
      const std::lock_guard lock(guard);
      if (!failed.exchange(true)) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    while (others.size() + 1 < std::min<std::size_t>(threads, count)) others.emplace_back(work_on_indices);
    work_on_indices();
  }
  if (failure) std::rethrow_exception(failure);
}

/// The same, but only reports the completed fraction of the work (0 to 1) to `progress`.
inline void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work,
                        const std::function<void(double)>& progress = {}, unsigned threads = thread_count()) {
  std::size_t done = 0;
  in_parallel_settling(
      count, work,
      [&](std::span<const std::size_t> indices) {
        done += indices.size();
        if (progress) progress(static_cast<double>(done) / static_cast<double>(count));
      },
      threads);
}

}  // namespace stickslip::studies
