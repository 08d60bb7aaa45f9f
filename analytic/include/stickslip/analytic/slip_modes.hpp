// SPDX-License-Identifier: MIT
#pragma once

/// The slip state in closed form: clamped at x = 0, free at x = L under a tangential (follower) axial force
/// P: u(0) = u'(0) = 0, u''(L) = 0, EI u'''(L) = 0. The wave numbers are those of stick_modes.hpp; the
/// characteristic equation (Beck's column with distributed mass), with b = beta L, bb = betabar L, is
///
///     b^4 + bb^4 + 2 b^2 bb^2 cosh(b) cos(bb) + b bb (bb^2 - b^2) sinh(b) sin(bb) = 0.
///
/// The problem is not self-adjoint: the two lowest frequencies coalesce at the flutter load 20.05 EI/L^2,
/// beyond which they are complex.

#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// The left side of the characteristic equation divided by cosh(b), at angular frequency omega (rad/s) > 0.
/// Dimensionless; its sign changes are the natural frequencies.
[[nodiscard]] double slip_characteristic(const data::Beam& beam, double omega);

/// The axial force, N, at which the two lowest slip frequencies coalesce (Beck 1952: 20.05 EI/L^2), by
/// minimising the characteristic function over the frequency and finding the force at which that minimum is
/// zero. The beam's own axial_force does not enter. Relative accuracy 1e-12.
[[nodiscard]] double flutter_load(const data::Beam& beam);

/// One clamped-free mode under follower load.
class SlipMode {
 public:
  [[nodiscard]] int number() const noexcept { return number_; }
  [[nodiscard]] double hyperbolic_wave_number() const noexcept;
  [[nodiscard]] double trigonometric_wave_number() const noexcept;
  [[nodiscard]] double angular_frequency() const noexcept { return angular_frequency_; }  ///< rad/s
  [[nodiscard]] double frequency_hz() const noexcept;
  /// psi(x), scaled to 1 at x = L; written with decaying exponentials only.
  [[nodiscard]] double shape(double x) const { return value(direct_, x); }
  [[nodiscard]] double curvature(double x) const;  ///< psi''(x), 1/m^2
  /// psi*(x), scaled to 1 at x = L: the mode of the adjoint problem, which has the same frequency, with psi*
  /// = psi*' = 0 at x = 0 and psi*'' + (P/EI) psi* = psi*''' + (P/EI) psi*' = 0 at x = L. The integral of
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

/// The first `count` slip modes, ascending. Modes 2m-1 and 2m lie in (2m-2) pi < bb < 2m pi, at whose ends
/// the characteristic function is positive; between them its minimum is located and each root is bracketed
/// alone. Precondition 1 <= count <= 1000 (data::FieldError). Throws data::FieldError, naming
/// beam.axial_force, its value and what is allowed, unless -1e5 EI/L^2 <= P < flutter_load(): at the upper
/// end the two lowest frequencies become complex; in tension the first one falls as exp(-sqrt(-P L^2/EI)/2),
/// because a follower force does not straighten the beam, and below the lower end it cannot be represented.
[[nodiscard]] std::vector<SlipMode> slip_modes(const data::Beam& beam, int count);

}  // namespace stickslip::analytic
