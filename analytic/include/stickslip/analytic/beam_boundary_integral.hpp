// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "stickslip/analytic/boundary_integral.hpp"
#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// A grid of `steps` equal time steps from t = 0.
struct TimeGrid {
  double time_step{};   ///< h, s
  std::size_t steps{};  ///< at most 2²⁶, a GB of memory and more
};

/// f_h: the friction force on the beam that holds its tip, from the quasi-static start, N, for each step. Undamped it is
/// the mean over the step of minus Eq. (28), with the exact steady part and 200 free vibrations (StickResponse), whose
/// amplitudes fall as n⁻⁴. With Kelvin-Voigt damping it is that of a HeldBeam of 40 modes in the middle of the
/// step. Throws what these throw, and data::FieldError for other damping, unless time_step > 0 and steps is in
/// 1 ... 2²⁶.
[[nodiscard]] std::vector<double> holding_force(const data::Beam& beam,
                                                const data::HarmonicExcitation& excitation,
                                                const data::Damping& damping, const TimeGrid& grid);

/// The same under a general motion (HeldMotion), in the middle of each step.
[[nodiscard]] std::vector<double> holding_force(const ContactModel& model, const TimeGrid& grid);

/// y(x, t_n) of the beam with its tip held, m, at t_n = n every h ≤ h steps. Throws as holding_force().
[[nodiscard]] std::vector<double> held_displacement(const data::Beam& beam,
                                                    const data::HarmonicExcitation& excitation,
                                                    const data::Damping& damping, const TimeGrid& grid,
                                                    double x, std::size_t every);

/// The beam of the paper by the boundary integral of its tip (boundary_integral.hpp), with TipMobility. Under a general motion f_h is that of
/// HeldMotion in the middle of each step, with as many modes as holding_force().
///
/// Accuracy, without damping: the friction force is constant over a step, and contact changes fall on steps,
/// so that the events are known to a step at best; the motion converges at a rate between h^(1/2) and h
/// (measured).
class BeamBoundaryIntegral {
 public:
  /// Uses neither the numerics of the case nor its wall, which rests. Throws data::FieldError, naming beam.axial_force,
  /// unless 0 < P < P_cr, and what holding_force(), TipMobility, mobility_weights() and contact_steps() throw.
  BeamBoundaryIntegral(const data::Case& problem, const TimeGrid& grid, int stages = usual_stages);

  [[nodiscard]] const TimeGrid& grid() const noexcept { return grid_; }
  /// Sliding velocity y_t(L) (mean) and friction force f_d on the beam of each step; Eq. (28) has f = -f_d.
  [[nodiscard]] const std::vector<ContactStep>& steps() const noexcept { return steps_; }
  /// y(L, t_n), m, at t_n = n every h. The velocities are means, so that nothing but rounding is added.
  [[nodiscard]] std::vector<double> tip_displacement(std::size_t every = 1) const;
  /// y(x, t_n), m: the motion with the tip held, and what the forces f_d - f_h at the tip add to it by the
  /// transfer mobility.
  [[nodiscard]] std::vector<double> displacement(double x, std::size_t every = 1) const;

 private:
  data::Case problem_;
  TimeGrid grid_;
  int stages_;
  std::vector<double> holding_force_;
  std::vector<ContactStep> steps_;
};

}  // namespace stickslip::analytic
