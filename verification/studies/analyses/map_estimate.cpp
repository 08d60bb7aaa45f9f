// SPDX-License-Identifier: MIT
#include "studies/analyses/map_estimate.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

#include "studies/common/parallel.hpp"

namespace stickslip::studies {

namespace {

struct Seconds {
  double processor{}, wall{};
};

Seconds seconds_for(const MapTask& task, std::span<const std::size_t> numbers, unsigned threads) {
  const ThreadsForNow threads_for_now(threads);
  MapEvaluations evaluations(evaluation_count(task));
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t processor = std::clock();
  evaluate(task, numbers, evaluations);
  return {static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC,
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()};
}

std::vector<std::size_t> sample_of(std::span<const std::size_t> numbers, std::size_t count) {
  std::vector<std::size_t> sample;
  for (const std::size_t index : share_of(numbers.size(), 1, numbers.size() / count))
    sample.push_back(numbers[index]);
  return sample;
}

}  // namespace

MapEstimate map_estimate(const MapTask& task, std::span<const std::size_t> numbers) {
  constexpr double enough = 0.5, least = 1e-6;  // s
  const Seconds preparation = seconds_for(task, {}, 1);
  MapEstimate estimate{.evaluations = numbers.size(), .threads = thread_count(), .speedup = 1.0};
  for (std::size_t count = std::min<std::size_t>(numbers.size(), std::size_t{4} * thread_count());;
       count = std::min(2 * count, numbers.size())) {
    const auto sample = sample_of(numbers, count);
    const Seconds one = seconds_for(task, sample, 1);
    if (one.processor < enough && sample.size() < numbers.size()) continue;
    const auto net = [&](double seconds, double prepared) { return std::max(seconds - prepared, least); };
    estimate.sample = sample.size();
    estimate.seconds_each = net(one.processor, preparation.processor) / static_cast<double>(sample.size());
    if (thread_count() > 1)
      estimate.speedup = net(one.wall, preparation.wall) /
                         net(seconds_for(task, sample, thread_count()).wall, preparation.wall);
    return estimate;
  }
}

}  // namespace stickslip::studies
