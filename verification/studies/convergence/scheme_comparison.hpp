#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/energy_balance.hpp"

namespace stickslip::studies {

/// The shortest stick phase that counts as a plateau, s.
inline constexpr double shortest_plateau = 2e-3;

/// A stick phase after a slip.
struct Plateau {
  double begin{}, end{};      ///< s
  double tip_displacement{};  ///< y(L), m
};

/// What one contact scheme makes of a beam.
struct SchemeRun {
  solver::ContactScheme scheme{};
  std::optional<double> first_slip;                ///< s
  std::size_t events{};                            ///< changes of the contact
  std::vector<Plateau> plateaus;                   ///< of at least shortest_plateau that begin within 0.2 s
  double largest_tip_displacement{};               ///< max |y(L)| over the steps, m
  solver::EnergyBalance energy;                    ///< at the end
  [[nodiscard]] double relative_residual() const;  ///< energy.residual() over the base work
};

/// The same beam over numerics.duration() by the scheme with located changes, by that without location and by
/// the letter of the paper's Sects. 2 and 3 (its reference [18], Won & Chung, J. Sound Vib. 419, 42-62, 2018,
/// which explains the rule of switching, is not at hand), in this order, each with its energy balance. Throws
/// what BeamSimulation throws.
[[nodiscard]] std::vector<SchemeRun> compare_schemes(const data::Beam& beam,
                                                     const data::FrictionLaw& friction,
                                                     const data::HarmonicExcitation& excitation,
                                                     const data::NumericalSettings& numerics,
                                                     const data::Damping& damping);

}  // namespace stickslip::studies
