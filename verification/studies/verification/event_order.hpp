// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// Errors of a stick-slip history by time integration, for each time step, against the event-driven history
/// of the same finite-element system.
struct EventOrder {
  std::vector<double> event_time_error;      ///< largest over all onsets and captures, s
  std::vector<double> event_position_error;  ///< largest over all onsets and captures, m
  std::vector<double> tip_error;             ///< largest of y(L) on a grid of 0.1 ms, m
  OrderEstimate event_time_order, event_position_order, tip_order;
};
STICKSLIP_MEMBERS(EventOrder, (event_time_error, "s"), (event_position_error, "m"), (tip_error, "m"),
                  (event_time_order), (event_position_order), (tip_order))

/// Predicted order with located events: 2. Without location, a change is detected at the end of a step, with
/// a delay of up to h and of h/2 on average. Event times then have order 1, and their error is below h.
struct EventOrderStudy {
  double spectral_radius{};
  int elements{};
  int events{};
  double duration{};              ///< s
  std::vector<double> time_step;  ///< s
  EventOrder located, at_end_of_step;
};
STICKSLIP_MEMBERS(EventOrderStudy, (spectral_radius, "1"), (elements, "1"), (events, "1"), (duration, "s"),
                  (time_step, "s"), (located), (at_end_of_step))

/// Runs the study with time steps of 0.1 ms divided by `divisors` and with the velocity threshold 0.
[[nodiscard]] EventOrderStudy event_order_study(const data::Case& problem, double duration, int elements,
                                                double spectral_radius, const std::vector<int>& divisors);

}  // namespace stickslip::studies
