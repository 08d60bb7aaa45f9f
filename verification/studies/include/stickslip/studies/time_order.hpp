#pragma once

#include <vector>

#include "stickslip/studies/convergence.hpp"

namespace stickslip::studies {

/// Order of generalised-alpha on a damped two-mass chain under a harmonic load, whose second mass is the
/// contact: free (slip without friction) for displacement and velocity, held by a moving wall (stick) for the
/// reaction. Errors are sup-norm differences from the exact steady state over the last period.
struct TimeOrderStudy {
  double spectral_radius{};
  std::vector<double> time_step;  ///< s
  std::vector<double> displacement_error, velocity_error, reaction_error;
  OrderEstimate displacement_order, velocity_order, reaction_order;
};

[[nodiscard]] TimeOrderStudy time_order_study(double spectral_radius,
                                              const std::vector<int>& steps_per_period);

}  // namespace stickslip::studies
