// SPDX-License-Identifier: MIT
#pragma once

/// Steady sliding on a wall that moves, its stability by both implementations, and the vibration that follows from rest:
/// friction-induced vibration, or squeal.

#include <complex>
#include <optional>
#include <vector>

#include "stickslip/analytic/periodic_motion.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// One mode of the sliding beam.
struct SquealMode {
  double frequency_hz{};                     ///< without falling friction
  double damping_ratio{};                    ///< of critical, without falling friction
  double one_mode_slope{};                   ///< κ_k that the mode alone holds, N s/m (steady_sliding.hpp)
  std::optional<double> critical_slope;      ///< κ at the Hopf point, N s/m; nothing if there is none
  std::optional<double> critical_speed;      ///< above it the mode is stable, m/s; infinite if it never is
  std::optional<std::complex<double>> root;  ///< s at the speed of the wall, 1/s, characteristic equation
  /// The eigenvalue of the mesh next to it, 1/s; of a first mode without such a root the largest real one.
  std::optional<std::complex<double>> finite_element_root;
};

/// Whether a disturbance exp(s t) grows, up to what rounding leaves of Re s, 1e-9 of the modulus.
[[nodiscard]] inline bool grows(std::complex<double> s) { return s.real() > 1e-9 * std::abs(s); }

/// A disturbance of slip that grows though nothing shakes the beam: flutter, or buckling if s is real.
struct SlipInstability {
  std::complex<double> root;  ///< s, 1/s, the one that grows most in a period
  double load{};              ///< the axial force from which on slip grows, up to that of the case, N
};

/// The sliding beam as it is computed, with shear, any damping and viscous friction (κ = -β P), on ten elements: their critical load
/// is too high by 1e-4 of it, with shear by 1e-3 for beams ten times as long as high. A falling friction coefficient is left out.
/// Nothing if P ≤ 0 or no disturbance grows.
[[nodiscard]] std::optional<SlipInstability> slip_instability(const data::Case& problem);

/// Steady sliding of a case.
struct Squeal {
  double speed{};                        ///< V, m/s
  double slope{};                        ///< κ(V), N s/m
  double friction_force{};               ///< on the beam, N
  double tip_displacement{};             ///< relative to the base, closed form, m
  double finite_element_displacement{};  ///< the same by the mesh, m
  bool all_modes{};  ///< the characteristic equation is that of the continuous beam; else of numerics.modes
  std::vector<SquealMode> modes;
  int resolved_modes{};  ///< that the mesh resolves; only these are judged
  double resolved_hz{};  ///< up to which it does: resolved_frequency(); of a Model that of its highest mode
  std::complex<double> fastest;  ///< of their eigenvalues the one with the largest real part, 1/s
  bool
      unresolved_mode_grows{};  ///< an eigenvalue of the mesh above resolved_hz, which says nothing of the beam

  [[nodiscard]] bool is_stable() const { return !grows(fastest); }
  /// The fastest one is real: no vibration grows, the tip runs away from steady sliding.
  [[nodiscard]] bool diverges() const { return !is_stable() && fastest.imag() == 0.0; }
};

/// The frequency (Hz) up to which the mesh has natural frequencies to 1 %, mesh_frequency_error(). Above it the modes of the mesh are
/// not those of the beam: the highest has its motion in the element at the tip, which falling friction drives more the finer it is.
[[nodiscard]] double resolved_frequency(const data::Case& problem);

/// Throws data::FieldError if wall.speed is 0, if there are more than 200 elements, if P ≤ 0, or if the
/// sliding beam has no `modes` natural frequencies (flutter or buckling).
[[nodiscard]] Squeal squeal_of(const data::Case& problem, int modes);

/// The largest real part of the eigenvalues of sliding with numerics.modes modes and a damping ratio, 1/s, at each speed of the
/// wall (m/s).
[[nodiscard]] std::vector<double> sliding_growths(const data::Case& problem,
                                                  const std::vector<double>& speeds, double damping_ratio);

/// A periodic motion of a case by shooting, with numerics.modes modes.
struct Cycle {
  analytic::PeriodicSearch search;
  bool forced{};             ///< by the base; else self-excited by the wall
  double peak_to_peak{};     ///< of the tip, absolute, m; as largest_sliding to 1e-9 of the motion
  double largest_sliding{};  ///< max |v_s|, m/s
  double stick_share{};      ///< of the period, from the times of the changes of contact
};

/// The motion after `settle` periods of the base or, if that does not move, of the first mode of the sliding beam; of `periods`
/// periods of the base. Throws data::FieldError if neither base nor wall moves, and what EventDriven throws.
[[nodiscard]] Cycle cycle_of(const data::Case& problem, int periods, int settle);

/// cycle_of() with a base that rests: what the wall alone excites.
[[nodiscard]] Cycle limit_cycle_of(const data::Case& problem, int settle);

/// No multiplier but the one of a shift in time is outside of the unit circle.
[[nodiscard]] bool is_stable(const Cycle& cycle);

}  // namespace stickslip::studies
