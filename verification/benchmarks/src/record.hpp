#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

#include "stickslip/benchmarks/speed_record.hpp"

namespace stickslip::benchmarks {

/// Prints as usual and keeps the shortest time of each benchmark, with its counters.
class Recorder final : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override;

  /// What has been measured. Throws std::runtime_error if a benchmark that it needs has not been run or
  /// failed.
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
