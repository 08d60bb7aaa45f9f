#pragma once

#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/stick_slip/event_history.hpp"

namespace stickslip::studies {

/// An event of the reference history with its uncertainty.
struct BenchmarkEvent {
  HistoryEvent event;
  double time_uncertainty{};      ///< s
  double position_uncertainty{};  ///< m
};

/// Another route to the same history.
struct BenchmarkRun {
  std::string method;
  int size{};                         ///< finite elements, or modes of the continuous beam
  double time_step{};                 ///< s; 0 for event-driven runs
  EventDifference first_ten;          ///< against the reference
  EventDifference all;                ///< the same over all events; infinite if the sequences differ
  std::vector<EventDifference> each;  ///< of each event of the reference that the run has in its place
};

/// A damped stick-slip history of which each change of contact converges: by the event-driven method on the
/// modes of the continuous beam.
///
/// Uncertainty: the difference to a run with 1/sqrt(2) of the modes. The error falls faster than N^-3, so
/// that it is at most 1/(2^(3/2) - 1) = 0.55 of that difference; what is left covers the tolerance of the
/// integrator, which a run at a hundred times that tolerance shows.
struct DampedBenchmark {
  double frequency_hz{}, amplitude{}, kelvin_voigt{}, duration{};
  double shortest_stick{};  ///< s: micro-sticks below it are merged (without_micro_sticks)
  int modes{};              ///< of the reference
  std::vector<BenchmarkEvent> events;
  double tolerance_effect{};  ///< largest time difference at a hundred times the tolerance, s
  TipHistory history;         ///< of the reference, every 0.1 ms
  std::vector<BenchmarkRun> runs;
};

/// What a benchmark is run with.
struct BenchmarkEffort {
  double duration{0.5};
  double shortest_stick{2e-5};
  int modes{40};
  std::vector<int> other_modes{10, 20};
  std::vector<int> free_modes{10, 20};
  std::vector<int> event_driven_elements{10, 20};
  std::vector<int> elements{10, 20, 40};  ///< of the time stepper, at the last of time_steps
  std::vector<double> time_steps{2e-5, 1e-5, 5e-6, 2.5e-6};  ///< on the last of elements
};

[[nodiscard]] DampedBenchmark damped_benchmark(const data::Case& problem, const BenchmarkEffort& effort = {});

}  // namespace stickslip::studies
