#pragma once

/// Stick-slip runs of the tip of a beam whose matrices, load or contact law need not be the right ones.

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "stickslip/solver/beam_model.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/contact_system.hpp"

namespace stickslip::studies {

/// A run ends at `time` or with the change of contact number `events`, whichever comes first.
struct RunEnd {
  double time{};  ///< s
  std::size_t events{std::numeric_limits<std::size_t>::max()};
};

struct TipRun {
  double step{};                           ///< s, of the samples
  std::vector<double> tip_displacement{};  ///< y(L), m
  std::vector<double> friction_force{};    ///< f, N, sign of Eq. (28)
  std::vector<double> events{};            ///< times of onsets and captures, s
};

/// By the solver's integrator, changes located.
[[nodiscard]] TipRun tip_run(const solver::BeamModel& mesh, const solver::ContactSystem& system,
                             const data::Case& problem, solver::InitialVelocity start, const RunEnd& end);

/// A contact law of one's own: the coefficient of friction against a sliding velocity v, f_d = -c(v) N, odd
/// or not, and whether a tip at rest is held by up to mu_s N.
struct ContactLaw {
  std::function<double(const data::FrictionLaw&, double)> coefficient;
  bool holds{true};
};

/// By the implicit midpoint rule for the beam with the friction force f over the step from the velocity at
/// its end (Moreau's scheme): v_s = v_free + m f with the mobility m of the contact; f holds the tip if |f|
/// <= mu_s N allows v_s = 0, else v_s is the root of v + m N c(v) = v_free by bisection. First order in the
/// step, a tenth of the case's.
[[nodiscard]] TipRun tip_run(const solver::BeamModel& mesh, const solver::ContactSystem& system,
                             const data::Case& problem, const ContactLaw& law, const RunEnd& end);

}  // namespace stickslip::studies
