// SPDX-License-Identifier: MIT
#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

#include "stickslip/benchmarks/speed_record.hpp"

namespace stickslip::benchmarks {

/// Prints the usual output, and stores the shortest time of each benchmark with its counters.
class Recorder final : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override;

  /// The record of the run. Throws std::runtime_error if a required benchmark has not been run or has failed.
  [[nodiscard]] SpeedRecord record() const;

 private:
  struct Shortest {
    double seconds{};
    std::map<std::string, double> counters;
  };
  [[nodiscard]] const Shortest& shortest(const std::string& name) const;

  std::map<std::string, Shortest> shortest_;
};

}  // namespace stickslip::benchmarks
