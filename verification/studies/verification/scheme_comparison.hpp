// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// A stick phase after a slip phase.
struct Plateau {
  double begin{}, end{};      ///< s
  double tip_displacement{};  ///< y(L), m
};
STICKSLIP_MEMBERS(Plateau, (begin, "s"), (end, "s"), (tip_displacement, "m"))

/// The result of one contact scheme.
struct SchemeRun {
  /// The shortest stick phase that counts as a plateau, s.
  static constexpr double shortest_plateau = 2e-3;
  std::optional<double> first_slip;                ///< s
  std::size_t events{};                            ///< number of changes of the contact state
  std::vector<Plateau> plateaus;                   ///< at least shortest_plateau long, begin within 0.2 s
  double largest_tip_displacement{};               ///< max |y(L)| over the steps, m
  solver::EnergyBalance energy;                    ///< at the end
  [[nodiscard]] double relative_residual() const;  ///< energy.residual() over the work of the base
};
STICKSLIP_MEMBERS(SchemeRun, (shortest_plateau, "s"), (first_slip, "s"), (events, "1"), (plateaus),
                  (largest_tip_displacement, "m"), (energy), (relative_residual(), "1"))

/// Runs the same beam over numerics.duration() by three schemes in this order: with located changes, with
/// changes at the end of the step, and exactly as Sects. 2 and 3 of the paper describe. The rule of switching
/// in the paper's reference [18] (Won & Chung, J. Sound Vib. 419, 42-62, 2018) is not available. Each run has
/// its energy balance. Throws what BeamSimulation throws.
[[nodiscard]] std::vector<SchemeRun> compare_schemes(const data::Beam& beam,
                                                     const data::FrictionLaw& friction,
                                                     const data::HarmonicExcitation& excitation,
                                                     const data::NumericalSettings& numerics,
                                                     const data::Damping& damping);

}  // namespace stickslip::studies
