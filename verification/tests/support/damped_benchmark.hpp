// SPDX-License-Identifier: MIT
#pragma once

/// The runs of a damped benchmark against its reference.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "studies/verification/damped_benchmark.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {

inline studies::BenchmarkRun benchmark_run(const studies::DampedBenchmark& benchmark,
                                           const std::string& method, int size, double time_step) {
  const auto found = std::ranges::find_if(benchmark.runs, [&](const studies::BenchmarkRun& run) {
    return run.method == method && run.size == size && run.time_step == time_step;
  });
  if (found == benchmark.runs.end()) throw std::out_of_range("no run of " + method);
  return *found;
}

/// Generalised-alpha finds each event at the time and position of the reference. The mesh error is of order 4:
/// at most a fifteenth of the error on half the elements. The error of the step is of order 2: a third of what
/// twice the step changes. Margin 3 for both, since an event may feel more of them than the worst event of the
/// coarser run.
inline void expect_events_of_reference(const studies::DampedBenchmark& benchmark, int elements,
                                       double time_step) {
  const auto error = [&](int size, double h) {
    return benchmark_run(benchmark, "generalised-alpha", size, h).all;
  };
  const auto coarse = error(elements / 2, time_step), fine = error(elements, time_step),
             longer = error(elements, 2.0 * time_step);
  for (const auto entry : {&studies::EventDifference::time, &studies::EventDifference::position})
    EXPECT_TRUE(within(fine.*entry, 0.0,
                       discretisation(coarse.*entry / 15.0 + std::abs(longer.*entry - fine.*entry) / 3.0, 3.0,
                                      "Richardson")));
}

}  // namespace stickslip::testing
