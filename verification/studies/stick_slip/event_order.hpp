#pragma once

#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/convergence/convergence.hpp"

namespace stickslip::studies {

/// Errors of a stick-slip history by the time stepper, per step, against the event-driven history of the very
/// same finite-element system.
struct EventOrder {
  std::vector<double> event_time_error;      ///< largest over all onsets and captures, s
  std::vector<double> event_position_error;  ///< largest over all onsets and captures, m
  std::vector<double> tip_error;             ///< largest of y(L) on a grid of 0.1 ms, m
  OrderEstimate event_time_order, event_position_order, tip_order;
};

/// Predicted: with location 2. Without it a change is noticed at the end of a step, late by up to h and by
/// h/2 on average, so that event times are of order 1 and their error stays below h.
struct EventOrderStudy {
  double spectral_radius{};
  int elements{};
  int events{};
  double duration{};              ///< s
  std::vector<double> time_step;  ///< s
  EventOrder located, at_end_of_step;
};

/// Steps of 0.1 ms divided by `divisors`, without a velocity threshold.
[[nodiscard]] EventOrderStudy event_order_study(const data::Case& problem, double duration, int elements,
                                                double spectral_radius, const std::vector<int>& divisors);

}  // namespace stickslip::studies
