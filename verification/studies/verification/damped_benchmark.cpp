// SPDX-License-Identifier: MIT
#include "studies/verification/damped_benchmark.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "stickslip/analytic/contact_model.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/method.hpp"
#include "studies/verification/finite_element_contact_model.hpp"

namespace stickslip::studies {

namespace {

constexpr double history_step = 1e-4, least_stick = 2e-5;  // s
constexpr double reference_tolerance = 1e-12;

// Of the events with the same number, up to the first ones of different kinds.
std::vector<EventDifference> differences(const std::vector<data::ContactEvent>& a,
                                         const std::vector<data::ContactEvent>& b) {
  std::vector<EventDifference> each;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()) && a[i].change == b[i].change; ++i)
    each.push_back({std::abs(a[i].time - b[i].time), std::abs(a[i].position - b[i].position)});
  return each;
}

class Benchmark {
 public:
  Benchmark(const data::Case& problem, const BenchmarkEffort& effort) : problem_(problem), effort_(effort) {}

  [[nodiscard]] DampedBenchmark run() {
    result_.frequency_hz = problem_.excitation().frequency_hz();
    result_.amplitude = problem_.excitation().amplitude();
    result_.kelvin_voigt = problem_.damping.kelvin_voigt();
    result_.duration = effort_.duration;
    result_.damping_ratio = std::numbers::pi * result_.kelvin_voigt * stick_hz(problem_.beam(), 1);
    result_.tolerance = reference_tolerance;
    result_.shortest_stick = least_stick;
    result_.modes = effort_.modes;
    set_reference();
    for (const int modes : effort_.other_modes) compare("event-driven on held modes", modes, held(modes));
    for (const int elements : effort_.event_driven_elements)
      compare("event-driven on finite elements", elements,
              event_driven_history(finite_element_contact_model(problem_, elements), times_));
    for (const int elements : effort_.elements) step(elements, effort_.time_steps.back());
    for (const double time_step : effort_.time_steps)
      if (time_step != effort_.time_steps.back()) step(effort_.elements.back(), time_step);
    return result_;
  }

 private:
  [[nodiscard]] History held(int modes, double tolerance = reference_tolerance) const {
    return event_driven_history(analytic::contact_model(problem_, modes), times_, tolerance);
  }

  void set_reference() {
    result_.history = held(effort_.modes);
    reference_ = result_.events = events_of(result_.history);
    const int fewer_modes = static_cast<int>(std::lround(effort_.modes / std::numbers::sqrt2));
    const auto fewer = events_of(held(fewer_modes));
    const auto rougher = events_of(held(fewer_modes, 100.0 * reference_tolerance));
    if (fewer.size() != reference_.size() ||
        std::isinf(largest_difference(fewer, reference_, reference_.size()).time))
      throw std::runtime_error("the reference history has not converged: its events depend on the modes.");
    result_.uncertainties = differences(reference_, fewer);
    result_.tolerance_effect = largest_difference(fewer, rougher, fewer.size()).time;
  }

  [[nodiscard]] std::vector<data::ContactEvent> events_of(const History& history) const {
    return without_micro_sticks(history.events, least_stick);
  }

  void compare(const char* method, int size, const History& history, double time_step = 0.0) {
    const auto events = events_of(history);
    const std::size_t first = std::min<std::size_t>(10, reference_.size());
    EventDifference all = largest_difference(events, reference_, reference_.size());
    if (events.size() != reference_.size())
      all = {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    result_.runs.push_back({method, size, time_step, largest_difference(events, reference_, first), all,
                            differences(events, reference_)});
  }

  void step(int elements, double time_step) {
    compare("generalised-alpha", elements,
            finite_element_history(refined(problem_, elements, time_step, effort_.duration), {.every = 100}),
            time_step);
  }

  const data::Case& problem_;
  const BenchmarkEffort& effort_;
  std::vector<double> times_ = sample_times(effort_.duration, history_step);
  std::vector<data::ContactEvent> reference_;
  DampedBenchmark result_;
};

}  // namespace

const BenchmarkRun& DampedBenchmark::finest_stepped() const {
  const auto fineness = [](const BenchmarkRun& run) {
    return run.time_step > 0.0 ? std::pair(run.size, -run.time_step) : std::pair(0, 0.0);
  };
  return *std::ranges::max_element(runs, {}, fineness);
}

DampedBenchmark damped_benchmark(const data::Case& problem, const BenchmarkEffort& effort) {
  return Benchmark(problem, effort).run();
}

}  // namespace stickslip::studies
