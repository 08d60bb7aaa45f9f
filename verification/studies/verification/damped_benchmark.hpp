// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"
#include "studies/history/history.hpp"

namespace stickslip::studies {

/// The same history by another method or discretisation.
struct BenchmarkRun {
  std::string method;
  int size{};                 ///< number of finite elements, or of modes of the continuous beam
  double time_step{};         ///< s; 0 for event-driven runs
  EventDifference first_ten;  ///< largest differences of the first ten events from the reference
  EventDifference all;        ///< the same for all events; infinite if the sequences differ
  /// For each event of the reference: the difference of the event with the same number in the run.
  std::vector<EventDifference> each;
};
STICKSLIP_MEMBERS(BenchmarkRun, (method, "-"), (size, "1"), (time_step, "s"), (first_ten), (all), (each))

/// A damped stick-slip history whose events all converge, by the event-driven method on the modes of the
/// continuous beam.
///
/// Uncertainty of an event: its difference from a run with 1/√(2) of the modes. The error decreases faster
/// than N⁻³, so that it is at most 1/(2^(3/2) - 1) = 0.55 of this difference. The rest covers the effect of
/// the integrator's tolerance, which is measured by a run with a hundred times that tolerance.
struct DampedBenchmark {
  double frequency_hz{}, amplitude{}, kelvin_voigt{}, duration{};
  double shortest_stick{};                 ///< s; shorter stick phases are merged (without_micro_sticks())
  int modes{};                             ///< of the reference
  std::vector<data::ContactEvent> events;  ///< onsets and captures
  std::vector<EventDifference> uncertainties;  ///< of the events
  double tolerance_effect{};  ///< largest time difference at a hundred times the tolerance, s
  History history;            ///< of the reference, every 0.1 ms
  std::vector<BenchmarkRun> runs;
  double damping_ratio{};  ///< fraction of critical damping of stick mode 1
  double tolerance{};      ///< of the reference: relative error allowed per step of the slip phases
  /// Sticks of the reference that are too short to be among `events`.
  [[nodiscard]] std::size_t merged_sticks() const {
    return (onsets_and_captures(history.events).size() - events.size()) / 2;
  }
  /// The time stepper's run on the most elements, of these the one with the shortest step.
  [[nodiscard]] const BenchmarkRun& finest_stepped() const;
};
STICKSLIP_MEMBERS(DampedBenchmark, (frequency_hz, "Hz"), (amplitude, "m"), (kelvin_voigt, "s"),
                  (duration, "s"), (shortest_stick, "s"), (modes, "1"), (events), (uncertainties),
                  (tolerance_effect, "s"), (history), (runs), (damping_ratio, "1"), (tolerance, "1"),
                  (merged_sticks(), "1"), (finest_stepped()))

/// The settings of the benchmark.
struct BenchmarkEffort {
  double duration{0.5};
  int modes{40};
  std::vector<int> other_modes{10, 20};
  std::vector<int> event_driven_elements{10, 20};
  std::vector<int> elements{10, 20, 40};  ///< of the time integration, with the last of time_steps
  std::vector<double> time_steps{2e-5, 1e-5, 5e-6, 2.5e-6};  ///< s, with the last of elements
};

/// Computes the reference history and the other runs. Throws std::runtime_error if the events of the
/// reference depend on the number of modes.
[[nodiscard]] DampedBenchmark damped_benchmark(const data::Case& problem, const BenchmarkEffort& effort = {});

}  // namespace stickslip::studies
