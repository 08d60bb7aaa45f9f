// SPDX-License-Identifier: MIT
#pragma once

/// Stick-slip runs of the tip for arbitrary matrices, loads and contact laws. They also compute wrong models.

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/contact_system.hpp"

namespace stickslip::studies {

/// The end of a run: at `time`, or at the change of contact number `events`, whichever is first.
struct RunEnd {
  double time{};  ///< s
  std::size_t events{std::numeric_limits<std::size_t>::max()};
};

/// The history of the tip, sampled at the time step, and its events.
struct TipRun {
  double step{};                           ///< time between samples, s
  std::vector<double> tip_displacement{};  ///< y(L), m
  std::vector<double> friction_force{};    ///< f, N, sign of Eq. (28)
  std::vector<double> events{};            ///< times of onsets and captures, s
};

/// A run by the integrator of the solver with located changes. The beam starts with the quasi-static shape to the
/// displacement of the base, and that to its velocity unless `start` is zero.
[[nodiscard]] TipRun tip_run(const solver::ContactSystem& system, const solver::PrescribedMotion& base,
                             const data::NumericalSettings& numerics, solver::InitialVelocity start,
                             const RunEnd& end);

/// A contact law of one's own: the coefficient of friction against a sliding velocity v, f_d = -c(v) N, odd
/// or not, and whether a tip at rest is held by up to μ_s N.
struct FrictionRule {
  std::function<double(const data::FrictionLaw&, double)> coefficient;
  bool holds{true};
};

/// A run by the implicit midpoint rule. The friction force f of a step is determined by the velocity at its
/// end (Moreau's scheme): v_s = v_free + m f with the mobility m of the contact. The tip is held if v_s = 0
/// is possible with |f| ≤ μ_s N. Otherwise v_s is the root of v + m N c(v) = v_free, by bisection. The
/// method has first order in the step, which is a tenth of the time step of the case.
[[nodiscard]] TipRun tip_run(const solver::ContactSystem& system, const solver::PrescribedMotion& base,
                             const data::NumericalSettings& numerics, const FrictionRule& law,
                             const RunEnd& end);

}  // namespace stickslip::studies
