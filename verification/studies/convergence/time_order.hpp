#pragma once

#include <vector>

#include "studies/convergence/convergence.hpp"

namespace stickslip::studies {

/// Order of generalised-alpha on a damped two-mass chain under a harmonic load, whose second mass is the
/// contact: free (slip without friction) for displacement and velocity, held by a moving wall (stick) for the
/// reaction. Errors are sup-norm differences from the exact steady state over a period, when free vibrations
/// have decayed by e^16; steps_per_period samples miss at most (pi/steps_per_period)^2/2 of the largest.
/// Predicted are those of the method's own steady state, exactly (its equations solved at one frequency), and
/// their leading terms constant * h^2.
struct TimeOrderStudy {
  double spectral_radius{};
  std::vector<double> time_step;  ///< s
  std::vector<double> displacement_error, velocity_error, reaction_error;
  std::vector<double> predicted_displacement_error, predicted_velocity_error, predicted_reaction_error;
  double displacement_constant{}, velocity_constant{}, reaction_constant{};  ///< per s^2
  OrderEstimate displacement_order, velocity_order, reaction_order;
};

[[nodiscard]] TimeOrderStudy time_order_study(double spectral_radius,
                                              const std::vector<int>& steps_per_period);

}  // namespace stickslip::studies
