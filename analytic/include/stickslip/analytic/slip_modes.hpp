// SPDX-License-Identifier: MIT
#pragma once

/// The slip state in closed form: clamped at x = 0, free at x = L under the axial force P: u(0) = u'(0) = 0,
/// u''(L) = 0, EI u'''(L) + chi P u'(L) = 0. The wave numbers are those of stick_modes.hpp; the characteristic
/// equation, with b = beta L, bb = betabar L and z = bb^2 - b^2 = P L^2/EI, is
///
///     2 b^2 bb^2 (1 + cosh(b) cos(bb)) + z^2 (1 - chi + chi cosh(b) cos(bb))
///                                      + (1 - 2 chi) z b bb sinh(b) sin(bb) = 0.
///
/// A follower force (chi = 0, Beck's column with distributed mass) and every chi < 1/2 make the two lowest
/// frequencies coalesce at the flutter load (20.05 EI/L^2 at chi = 0), beyond which they are complex. From chi
/// = 1/2 on the lowest frequency falls to 0 first, at the buckling load z = y^2, cos(y) = -(1 - chi)/chi:
/// pi^2 at chi = 1/2, pi^2/4 at chi = 1 (Euler), where the problem is self-adjoint.

#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// The left side of the characteristic equation divided by cosh(b), at angular frequency omega (rad/s) > 0.
/// Dimensionless; its sign changes are the natural frequencies.
[[nodiscard]] double slip_characteristic(const data::Beam& beam, double omega);

/// Whether chi >= 1/2: the sliding beam loses its stability by buckling, else by flutter.
[[nodiscard]] bool buckles_in_slip(const data::Beam& beam);

/// The axial force, N, at which the slip state loses its stability. Flutter (Beck 1952: 20.05 EI/L^2 at chi = 0):
/// minimises the characteristic function over the frequency and finds the force at which that minimum is zero,
/// relative accuracy 1e-12; buckling: the formula above, to round-off. The beam's own axial_force does not enter.
[[nodiscard]] double slip_critical_load(const data::Beam& beam);

/// One clamped-free mode.
class SlipMode {
 public:
  [[nodiscard]] int number() const noexcept { return number_; }
  [[nodiscard]] double hyperbolic_wave_number() const noexcept { return b_ / length_; }      ///< beta, 1/m
  [[nodiscard]] double trigonometric_wave_number() const noexcept { return bb_ / length_; }  ///< betabar, 1/m
  [[nodiscard]] double angular_frequency() const noexcept { return angular_frequency_; }     ///< rad/s
  [[nodiscard]] double frequency_hz() const noexcept;
  /// psi(x), scaled to 1 at x = L; by decaying exponentials only.
  [[nodiscard]] double shape(double x) const { return value(direct_, x); }
  [[nodiscard]] double curvature(double x) const;  ///< psi''(x), 1/m^2
  /// psi*(x), scaled to 1 at x = L: the mode of the adjoint problem, which has the same frequency, with psi*
  /// = psi*' = 0 at x = 0 and psi*'' + (1 - chi) (P/EI) psi* = psi*''' + (P/EI) psi*' = 0 at x = L. The integral of
  /// psi*_m psi_n vanishes for m != n.
  [[nodiscard]] double adjoint_shape(double x) const { return value(adjoint_, x); }

 private:
  friend std::vector<SlipMode> slip_modes(const data::Beam& beam, int count);
  SlipMode(const data::Beam& beam, int number, double b, double bb);

  int number_{};
  double length_{};
  double b_{};   // beta L
  double bb_{};  // betabar L
  // left exp(-b xi) + right exp(-b (1 - xi)) + cos cos(bb xi) + sin sin(bb xi), xi = x/L
  struct Weights {
    double left{}, right{}, cos{}, sin{};
  };
  [[nodiscard]] double value(const Weights& weights, double x) const;
  // Zero with its slope at x = 0, for any ratio of the exponential parts; 1 at x = L.
  [[nodiscard]] Weights clamped(double left, double right) const;

  Weights direct_, adjoint_;
  double angular_frequency_{};
};

/// The first `count` slip modes, ascending. Modes 2m-1 and 2m lie in (2m-2) pi < bb < 2m pi. The characteristic function
/// is positive at both ends of this interval, and its minimum separates the two roots. Throws data::FieldError, naming
/// numerics.modes unless 1 <= count <= 1000, and beam.axial_force unless -1e5 EI/L^2 <= P < slip_critical_load(). In
/// tension and at chi = 0 the first frequency falls as exp(-sqrt(-P L^2/EI)/2), because a follower force does not
/// straighten the beam: below the lower end no double represents it.
[[nodiscard]] std::vector<SlipMode> slip_modes(const data::Beam& beam, int count);

}  // namespace stickslip::analytic
