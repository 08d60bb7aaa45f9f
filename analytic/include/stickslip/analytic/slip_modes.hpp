// SPDX-License-Identifier: MIT
#pragma once

/// The slip state in closed form: clamped at x = 0, free at x = L under the axial force P: u(0) = u'(0) = 0,
/// u''(L) = 0, EI u'''(L) + χ P u'(L) = 0. The wave numbers are those of stick_modes.hpp; the characteristic
/// equation, with b = β L, bb = β̄ L and z = bb² - b² = P L²/EI, is
///
///     2 b² bb² (1 + cosh(b) cos(bb)) + z² (1 - χ + χ cosh(b) cos(bb))
///                                      + (1 - 2 χ) z b bb sinh(b) sin(bb) = 0.
///
/// A follower force (χ = 0, Beck's column with distributed mass) and every χ < 1/2 make the two lowest
/// frequencies coalesce at the flutter load (20.05 EI/L² at χ = 0), beyond which they are complex. From
/// χ = 1/2 on the lowest frequency falls to 0 first, at the buckling load z = y², cos(y) = -(1 - χ)/χ:
/// π² at χ = 1/2, π²/4 at χ = 1 (Euler), where the problem is self-adjoint. For χ up to about 0.58 it is real again between
/// (2 π - y)² and flutter.

#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// The left side of the characteristic equation divided by cosh(b), at angular frequency ω (rad/s) > 0.
/// Dimensionless; its sign changes are the natural frequencies.
[[nodiscard]] double slip_characteristic(const data::Beam& beam, double omega);

/// Whether χ ≥ 1/2: the sliding beam loses its stability by buckling, else by flutter.
[[nodiscard]] bool buckles_in_slip(const data::Beam& beam);

/// The axial force, N, at which the slip state loses its stability. Flutter (Beck 1952: 20.05 EI/L² at χ = 0):
/// minimises the characteristic function over the frequency and finds the force at which that minimum is zero,
/// relative accuracy 1e-12; buckling: the formula above, to round-off. The beam's own axial_force does not enter.
[[nodiscard]] double slip_critical_load(const data::Beam& beam);

/// One clamped-free mode.
class SlipMode {
 public:
  [[nodiscard]] int number() const noexcept { return number_; }
  [[nodiscard]] double hyperbolic_wave_number() const noexcept { return b_ / length_; }      ///< β, 1/m
  [[nodiscard]] double trigonometric_wave_number() const noexcept { return bb_ / length_; }  ///< β̄, 1/m
  [[nodiscard]] double angular_frequency() const noexcept { return angular_frequency_; }     ///< rad/s
  [[nodiscard]] double frequency_hz() const noexcept;
  /// ψ(x), scaled to 1 at x = L; by decaying exponentials only.
  [[nodiscard]] double shape(double x) const { return value(direct_, x); }
  [[nodiscard]] double curvature(double x) const;  ///< ψ''(x), 1/m²
  /// ψ*(x), scaled to 1 at x = L: the mode of the adjoint problem, which has the same frequency, with ψ*
  /// = ψ*' = 0 at x = 0 and ψ*'' + (1 - χ) (P/EI) ψ* = ψ*''' + (P/EI) ψ*' = 0 at x = L. The integral of
  /// ψ*_m ψ_n vanishes for m != n.
  [[nodiscard]] double adjoint_shape(double x) const { return value(adjoint_, x); }

 private:
  friend std::vector<SlipMode> slip_modes(const data::Beam& beam, int count);
  SlipMode(const data::Beam& beam, int number, double b, double bb);

  int number_{};
  double length_{};
  double b_{};   // β L
  double bb_{};  // β̄ L
  // left exp(-b ξ) + right exp(-b (1 - ξ)) + cos cos(bb ξ) + sin sin(bb ξ), ξ = x/L
  struct Weights {
    double left{}, right{}, cos{}, sin{};
  };
  [[nodiscard]] double value(const Weights& weights, double x) const;
  // Zero with its slope at x = 0, for any ratio of the exponential parts; 1 at x = L.
  [[nodiscard]] Weights clamped(double left, double right) const;

  Weights direct_, adjoint_;
  double angular_frequency_{};
};

/// The first `count` slip modes, ascending. Modes 2m-1 and 2m lie in (2m-2) π < bb < 2m π. The characteristic function
/// is positive at both ends of this interval, and its minimum separates the two roots. Throws data::FieldError, naming
/// numerics.modes unless 1 ≤ count ≤ 1000, and beam.axial_force unless -1e5 EI/L² ≤ P and two real frequencies are in each interval, as for P < slip_critical_load(). In
/// tension and at χ = 0 the first frequency falls as exp(-√(-P L²/EI)/2), because a follower force does not
/// straighten the beam: below the lower end no double represents it.
[[nodiscard]] std::vector<SlipMode> slip_modes(const data::Beam& beam, int count);

}  // namespace stickslip::analytic
