// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// Observed order of generalised-alpha for a damped chain of two masses under a harmonic load. The second
/// mass is the contact: it is free (slip without friction) for displacement and velocity, and held by a
/// moving wall (stick) for the reaction.
///
/// Errors are the largest differences from the exact steady state over one period, after free vibrations have
/// decayed by the factor e¹⁶. With n samples per period, sampling underestimates the maximum by at most the
/// fraction (π/n)²/2. The predicted errors follow from the equations of the method solved at the load
/// frequency. Their leading terms are constant * h².
struct TimeOrderStudy {
  double spectral_radius{};
  std::vector<double> time_step;  ///< s
  std::vector<double> displacement_error, velocity_error, reaction_error;
  std::vector<double> predicted_displacement_error, predicted_velocity_error, predicted_reaction_error;
  double displacement_constant{}, velocity_constant{}, reaction_constant{};  ///< per s²
  OrderEstimate displacement_order, velocity_order, reaction_order;
};
STICKSLIP_MEMBERS(TimeOrderStudy, (spectral_radius, "1"), (time_step, "s"), (displacement_error, "m"),
                  (velocity_error, "m/s"), (reaction_error, "N"), (displacement_order), (velocity_order),
                  (reaction_order))

[[nodiscard]] TimeOrderStudy time_order_study(double spectral_radius,
                                              const std::vector<int>& steps_per_period);

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
