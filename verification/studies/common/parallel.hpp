// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

namespace stickslip::studies {

namespace detail {

inline std::atomic<unsigned> thread_count{std::max(1U, std::thread::hardware_concurrency())};

}  // namespace detail

/// The number of threads that a study uses: the number that the machine runs concurrently, unless
/// set_thread_count() has changed it. The results do not depend on it.
[[nodiscard]] inline unsigned thread_count() noexcept { return detail::thread_count; }

/// Sets the number of threads. Throws std::invalid_argument if `count` is 0.
inline void set_thread_count(unsigned count) {
  if (count == 0) throw std::invalid_argument("the number of threads is 0, but must be 1 or more");
  detail::thread_count = count;
}

/// Sets the number of threads until the end of a block.
class ScopedThreadCount {
 public:
  explicit ScopedThreadCount(unsigned count) : before_(thread_count()) { set_thread_count(count); }
  ~ScopedThreadCount() { set_thread_count(before_); }
  ScopedThreadCount(const ScopedThreadCount&) = delete;
  ScopedThreadCount& operator=(const ScopedThreadCount&) = delete;

 private:
  unsigned before_;
};

/// Calls work(0) ... work(count - 1) on `threads` threads, each index once, and reports the completed fraction of the work (0 to 1) to
/// `progress`, one call at a time. The first exception of `work` or `progress` ends the work and is thrown again. `work` must not depend
/// on the order of the calls.
///
/// These are threads of the standard library and not tasks of oneTBB, because the thread sanitizer
/// sees how these wait for each other. It reports false races in the tasks of a library that was built without
/// it.
inline void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work,
                        const std::function<void(double)>& progress = {}, unsigned threads = thread_count()) {
  // A 64th of a thread's share evens out items of unequal cost; 16 cheap ones pay for the lock.
  const std::size_t block = std::clamp<std::size_t>(count / (std::size_t{64} * threads), 1, 16);
  std::atomic<std::size_t> next{0};
  std::size_t done = 0;
  std::mutex guard;
  std::exception_ptr failure;

  const auto take_turns = [&] {
    try {
      for (std::size_t first = next.fetch_add(block); first < count; first = next.fetch_add(block)) {
        const std::size_t last = std::min(first + block, count);
        for (std::size_t index = first; index < last; ++index) work(index);
        const std::lock_guard lock(guard);
        done += last - first;
        if (progress && !failure) progress(static_cast<double>(done) / static_cast<double>(count));
      }
    } catch (...) {
      next = count;
      const std::lock_guard lock(guard);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    try {
      while (others.size() + 1 < std::min<std::size_t>(threads, count)) others.emplace_back(take_turns);
    } catch (const std::system_error&) {
      // The machine gives no more threads: those that there are do the work.
    }
    take_turns();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace stickslip::studies
