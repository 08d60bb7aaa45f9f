// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

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

/// Runs the study for each number of steps per period.
[[nodiscard]] TimeOrderStudy time_order_study(double spectral_radius,
                                              const std::vector<int>& steps_per_period);

}  // namespace stickslip::studies
