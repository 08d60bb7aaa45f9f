// SPDX-License-Identifier: MIT
#include "record.hpp"

#include <fstream>
#include <stdexcept>

namespace stickslip::benchmarks {

namespace {

// One comparison of the record.
struct RatioOfTimes {
  std::string work;
  std::string plain_name, plain;  // name of the benchmark, and description
  std::string fast_name, fast;
  double repetitions{1.0};  // number of times the plain work is contained in the fast work
};

const std::vector<RatioOfTimes>& comparisons() {
  static const std::vector<RatioOfTimes> table{
      {.work = "Stick run, 10 s in 100000 steps, 20 elements",
       .plain_name = "eigen_loop/sparse_ldlt",
       .plain = "loop on Eigen's sparse LDLT",
       .fast_name = "stick_run/modal",
       .fast = "recurrence of each mode, in blocks"},
      {.work = "the same",
       .plain_name = "eigen_loop/dense_lu",
       .plain = "loop on Eigen's dense LU",
       .fast_name = "stick_run/modal",
       .fast = "recurrence of each mode, in blocks"},
      {.work = "the same",
       .plain_name = "stick_run/nodal",
       .plain = "reference integrator",
       .fast_name = "stick_run/modal",
       .fast = "recurrence of each mode, in blocks"},
      {.work = "Stick-slip run, 25 Hz, 1 mm, 10 s, changes located",
       .plain_name = "stick_slip_run/nodal",
       .plain = "reference integrator",
       .fast_name = "stick_slip_run/modal",
       .fast = "held-tip modes and the contact"},
      {.work = "the same, against the stick run",
       .plain_name = "eigen_loop/sparse_ldlt",
       .plain = "stick loop on sparse LDLT",
       .fast_name = "stick_slip_run/modal",
       .fast = "held-tip modes and the contact"},
      {.work = "max |f| over 10 s at 35 Hz between bounds, 10 modes",
       .plain_name = "force_maximum/halving/10",
       .plain = "halving of intervals",
       .fast_name = "force_maximum/search/10",
       .fast = "truncated sums, peaks closed"},
      {.work = "the same, 40 modes",
       .plain_name = "force_maximum/halving/40",
       .plain = "halving of intervals",
       .fast_name = "force_maximum/search/40",
       .fast = "truncated sums, peaks closed"},
      {.work = "Map of 1200 frequencies by 1000 amplitudes",
       .plain_name = "force_maximum/halving/10",
       .plain = "1200 times halving",
       .fast_name = "criterion_map/frequency_amplitude",
       .fast = "one search a frequency, two threads",
       .repetitions = 1200.0},
      {.work = "Map of 1000 lengths by 1000 axial forces, states only",
       .plain_name = "length_force_point",
       .plain = "a million times criterion",
       .fast_name = "criterion_map/length_force",
       .fast = "table of modes, search to a verdict, two threads",
       .repetitions = 1e6},
      {.work = "Critical amplitude at 35 Hz by finite elements",
       .plain_name = "critical_amplitude/raised",
       .plain = "amplitude raised by 0.01 mm until it slips",
       .fast_name = "critical_amplitude/linear",
       .fast = "one linear run"},
      {.work = "the same",
       .plain_name = "critical_amplitude/raised",
       .plain = "amplitude raised by 0.01 mm until it slips",
       .fast_name = "critical_amplitude/modal",
       .fast = "one linear run by modes"},
  };
  return table;
}

std::string processor() {
  std::ifstream stream("/proc/cpuinfo");
  const std::string key = "model name";
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with(key)) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

}  // namespace

void Recorder::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
    const double seconds = run.real_accumulated_time / static_cast<double>(run.iterations);
    auto& kept =
        shortest_[run.run_name.function_name + (run.run_name.args.empty() ? "" : "/" + run.run_name.args)];
    if (kept.seconds > 0.0 && kept.seconds <= seconds) continue;
    kept.seconds = seconds;
    for (const auto& [name, counter] : run.counters) kept.counters[name] = counter.value;
  }
  ConsoleReporter::ReportRuns(runs);
}

const Recorder::Shortest& Recorder::shortest(const std::string& name) const {
  const auto found = shortest_.find(name);
  if (found == shortest_.end())
    throw std::runtime_error("the record needs the benchmark " + name + ", which has not been run");
  return found->second;
}

SpeedRecord Recorder::record() const {
  const double peak_flops = shortest("peak/flops").counters.at("flops") / shortest("peak/flops").seconds;
  const double peak_bytes = shortest("peak/cache").counters.at("bytes") / shortest("peak/cache").seconds;
  SpeedRecord record;
  record.processor = processor();
  for (const RatioOfTimes& line : comparisons()) {
    const Shortest& fast = shortest(line.fast_name);
    record.comparisons.push_back({.work = line.work,
                                  .plain = line.plain,
                                  .fast = line.fast,
                                  .plain_seconds = line.repetitions * shortest(line.plain_name).seconds,
                                  .fast_seconds = fast.seconds,
                                  .load = {}});
    const auto flops = fast.counters.find("flops_per_step");
    if (flops == fast.counters.end()) continue;
    const double bytes = fast.counters.at("bytes_per_step");
    const double steps_per_second = fast.counters.at("steps") / fast.seconds;
    record.comparisons.back().load = {.flops_per_step = flops->second,
                                      .bytes_per_step = bytes,
                                      .share_of_flops = flops->second * steps_per_second / peak_flops,
                                      .share_of_bytes = bytes * steps_per_second / peak_bytes};
  }
  for (const int elements : {20, 100, 500, 2000, 20000}) {
    record.elements.push_back(elements);
    record.seconds_per_element.push_back(shortest("elements/" + std::to_string(elements)).seconds /
                                         (100.0 * elements));
  }
  return record;
}

}  // namespace stickslip::benchmarks
