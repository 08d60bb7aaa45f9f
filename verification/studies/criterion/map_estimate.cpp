// SPDX-License-Identifier: MIT
#include "studies/criterion/map_estimate.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

#include "studies/common/thread_count.hpp"

namespace stickslip::studies {

namespace {

// Sets the number of threads until the end of a block.
class ThreadsForNow {
 public:
  explicit ThreadsForNow(unsigned count) : before_(thread_count()) { set_thread_count(count); }
  ~ThreadsForNow() { set_thread_count(before_); }
  ThreadsForNow(const ThreadsForNow&) = delete;
  ThreadsForNow& operator=(const ThreadsForNow&) = delete;

 private:
  unsigned before_;
};

double seconds_for(const MapTask& task, std::span<const std::size_t> numbers, unsigned threads) {
  const ThreadsForNow threads_for_now(threads);
  MapEvaluations evaluations(evaluation_count(task));
  const auto start = std::chrono::steady_clock::now();
  evaluate(task, numbers, evaluations);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<std::size_t> sample_of(std::span<const std::size_t> numbers, std::size_t count) {
  std::vector<std::size_t> sample;
  for (const std::size_t index : share_of(numbers.size(), 1, numbers.size() / count))
    sample.push_back(numbers[index]);
  return sample;
}

}  // namespace

MapEstimate map_estimate(const MapTask& task, std::span<const std::size_t> numbers) {
  constexpr double enough = 0.5;  // s
  const double preparation = seconds_for(task, {}, 1);
  MapEstimate estimate{.evaluations = numbers.size(), .threads = thread_count()};
  for (std::size_t count = std::min<std::size_t>(numbers.size(), std::size_t{4} * thread_count());;
       count = std::min(2 * count, numbers.size())) {
    const auto sample = sample_of(numbers, count);
    const double one = std::max(seconds_for(task, sample, 1) - preparation, 1e-9);
    if (one < enough && sample.size() < numbers.size()) continue;
    estimate.sample = sample.size();
    estimate.seconds_each = one / static_cast<double>(sample.size());
    estimate.speedup = thread_count() == 1
                           ? 1.0
                           : one / std::max(seconds_for(task, sample, thread_count()) - preparation, 1e-9);
    return estimate;
  }
}

}  // namespace stickslip::studies
