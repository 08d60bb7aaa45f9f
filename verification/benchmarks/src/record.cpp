// SPDX-License-Identifier: MIT
#include "record.hpp"

#include <fstream>
#include <stdexcept>

namespace stickslip::benchmarks {

namespace {

// A benchmark and the description of the method that it times.
struct Method {
  std::string benchmark, description;
};

// One comparison of the record.
struct RatioOfTimes {
  std::string work;
  Method plain, fast;
  double repetitions{1.0};  // number of times the plain work is contained in the fast work
};

std::vector<RatioOfTimes> comparisons() {
  const Method modal_stick{"stick_run/modal", "recurrence of each mode, in blocks"};
  const Method modal_slip{"stick_slip_run/modal", "held-tip modes and the contact"};
  const Method raised{"critical_amplitude/raised", "amplitude raised by 0.01 mm until it slips"};
  const std::string halving = "halving of intervals", search = "truncated sums, peaks closed";
  return {
      {"Stick run, 10 s in 100000 steps, 20 elements",
       {"eigen_loop/sparse_ldlt", "loop on Eigen's sparse LDLT"},
       modal_stick},
      {"the same", {"eigen_loop/dense_lu", "loop on Eigen's dense LU"}, modal_stick},
      {"the same", {"stick_run/nodal", "reference integrator"}, modal_stick},
      {"Stick-slip run, 25 Hz, 1 mm, 10 s, changes located",
       {"stick_slip_run/nodal", "reference integrator"},
       modal_slip},
      {"the same, against the stick run",
       {"eigen_loop/sparse_ldlt", "stick loop on sparse LDLT"},
       modal_slip},
      {"max |f| over 10 s at 35 Hz between bounds, 10 modes",
       {"force_maximum/halving/10", halving},
       {"force_maximum/search/10", search}},
      {"the same, 40 modes", {"force_maximum/halving/40", halving}, {"force_maximum/search/40", search}},
      {"Map of 1200 frequencies by 1000 amplitudes",
       {"force_maximum/halving/10", "1200 times halving"},
       {"criterion_map/frequency_amplitude", "one search a frequency, two threads"},
       1200.0},
      {"Map of 1000 lengths by 1000 axial forces, states only",
       {"length_force_point", "a million times criterion"},
       {"criterion_map/length_force", "table of modes, search to a verdict, two threads"},
       1e6},
      {"Critical amplitude at 35 Hz by finite elements",
       raised,
       {"critical_amplitude/linear", "one linear run"}},
      {"the same", raised, {"critical_amplitude/modal", "one linear run by modes"}},
  };
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
    const Shortest& fast = shortest(line.fast.benchmark);
    record.comparisons.push_back({.work = line.work,
                                  .plain = line.plain.description,
                                  .fast = line.fast.description,
                                  .plain_seconds = line.repetitions * shortest(line.plain.benchmark).seconds,
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
