// SPDX-License-Identifier: MIT
#pragma once

/// The stick state in closed form: clamped at x = 0, pinned at x = L, axial force P (compression positive).
///
/// With p = P/EI and k = ρ A ω² / EI the eigenvalue problem U'''' + p U'' = k U has the wave numbers
///
///     β² = -p/2 + √(p²/4 + k),     β̄² = +p/2 + √(p²/4 + k)
///
/// (Eq. 23 with its signs corrected, erratum E2) and, with b = β L, bb = β̄ L, η = 1 - x/L, the
/// eigenfunctions and the characteristic equation
///
///     U(x) = sinh(b η)/sinh(b) - sin(bb η)/sin(bb),        tan(bb)/bb = tanh(b)/b
///
/// (Eqs. 22 and 23 rearranged). U(L) = U''(L) = U(0) = 0 hold by construction; U'(0) = 0 is the characteristic equation.
/// U''(0) = β² + β̄² is the scale of the paper. No exponential grows with the mode number. All functions but
/// the buckling load refuse a beam with shear, for which there is timoshenko_modes.hpp.
///
/// The n-th root lies in n π < bb < (n + 1/2) π, and it is the only one there: tan(bb)/bb rises from 0 to
/// infinity, while tanh(b)/b, with b² = bb² - p L², falls. In compression the bracket starts at b = 0 when
/// that comes later; the first bracket then holds a root as long as P < P_cr = 20.1907 EI/L², where bb =
/// tan(bb) and b = 0.

#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// Buckling load of the clamped-pinned beam, N: P_cr = (z/L)² EI with z the first positive root of tan z = z
/// (z² = 20.190728556426629). With a shear stiffness, z is that of tan z = z/(1 + s² z²) and P_cr = EI/L²
/// z²/(1 + s² z²), s² = EI/(k G A L²). Accurate to round-off.
[[nodiscard]] double stick_buckling_load(const data::Beam& beam);

/// Throws data::FieldError, naming beam.axial_force, its value and the buckling load, if P ≥ P_cr.
void require_unbuckled(const data::Beam& beam);

/// S(x) of Eqs. (15)-(18): the deflection per unit base displacement of the massless beam whose tip stays at
/// rest, S'''' + (P/EI) S'' = 0, S(0) = S'(0) = 0, S(L) = -1, S''(L) = 0. With z = P L²/EI, ξ = x/L,
/// η = 1 - ξ,
///
///     S = -[ξ c2(z) - c3(z) + η³ c3(z η²)]/(c2(z) - c3(z)),
///     c2(z) = (1 - cos y)/y²,  c3(z) = (y - sin y)/y³,  y = √(z),
///
/// which is Eq. (18) in Stumpff functions: one formula for compression, P = 0 and tension, good for any P
/// below the buckling load, where c2 = c3. Relative accuracy: round-off times P_cr/(P_cr - P).
class QuasiStaticShape {
 public:
  /// Throws data::FieldError, naming beam.axial_force, its value and the buckling load, if P ≥ P_cr.
  explicit QuasiStaticShape(const data::Beam& beam);

  [[nodiscard]] double value(double x) const;             ///< S(x), dimensionless; 0 ≤ x ≤ L in m
  [[nodiscard]] double slope(double x) const;             ///< S'(x), 1/m
  [[nodiscard]] double curvature(double x) const;         ///< S''(x), 1/m²
  [[nodiscard]] double third_derivative(double x) const;  ///< S'''(x), 1/m³

 private:
  [[nodiscard]] double scaled(int k, double eta) const;  // exp(-decay_) c_k(z η²)

  double length_;
  double load_factor_;    // z = (P/EI) L², dimensionless, of either sign
  double decay_;          // √(-z) in tension, so that no exponential grows; else 0
  double determinant_{};  // exp(-decay_) (c2 - c3) at z; vanishes at the buckling load
};

/// One clamped-pinned mode.
class StickMode {
 public:
  [[nodiscard]] int number() const noexcept { return number_; }                          ///< n = 1, 2, ...
  [[nodiscard]] double hyperbolic_wave_number() const noexcept { return b_ / length_; }  ///< β, 1/m
  [[nodiscard]] double trigonometric_wave_number() const noexcept { return bb_ / length_; }  ///< β̄, 1/m
  /// ω = √(EI/(ρ A)) β β̄, rad/s. Relative error: a few eps times condition_number().
  [[nodiscard]] double angular_frequency() const noexcept { return angular_frequency_; }
  [[nodiscard]] double frequency_hz() const noexcept;  ///< ω / (2 π)
  /// Relative change of ω per relative change of the data, 1 + |P| int U'² / (2 |EI int U''² - P int
  /// U'²|): grows as 1/(P_cr - P) at the buckling load.
  [[nodiscard]] double condition_number() const;

  [[nodiscard]] double shape(double x) const;             ///< U(x), dimensionless; 0 ≤ x ≤ L in m
  [[nodiscard]] double slope(double x) const;             ///< U'(x), 1/m
  [[nodiscard]] double curvature(double x) const;         ///< U''(x), 1/m²
  [[nodiscard]] double third_derivative(double x) const;  ///< U'''(x), 1/m³

  /// ∫_0^L U² dx, m, in closed form. (The hyperbolic and the trigonometric part are orthogonal.)
  [[nodiscard]] double norm_squared() const;
  [[nodiscard]] double slope_norm_squared() const;      ///< ∫_0^L U'² dx, 1/m, in closed form
  [[nodiscard]] double curvature_norm_squared() const;  ///< ∫_0^L U''² dx, 1/m³, in closed form
  /// ∫_0^L U (1 + S) dx, m, in closed form: -U'''(0)/k by two integrations by parts.
  [[nodiscard]] double load_integral() const;
  /// C_n = -∫ U (1 + S) dx / ∫ U² dx of Eq. (25), dimensionless.
  [[nodiscard]] double participation() const { return -load_integral() / norm_squared(); }

 private:
  friend std::vector<StickMode> stick_modes(const data::Beam& beam, int count);
  StickMode(const data::Beam& beam, int number, double b, double bb);

  [[nodiscard]] double trigonometric_norm() const;  // int_0¹ sin(bb η)²/sin(bb)² d(η)

  int number_{};
  double length_{};
  double bending_stiffness_{};
  double mass_per_length_{};
  double axial_force_{};
  double b_{};   // β L
  double bb_{};  // β̄ L
  // sin(bb), cos(bb) by way of the characteristic equation, so that U'(0) = 0 holds to round-off.
  double sin_bb_{};
  double cos_bb_{};
  double angular_frequency_{};
};

/// The first `count` modes, ascending. Each root is bracketed alone and polished until the step is below round-off.
/// Throws data::FieldError, naming numerics.modes unless 1 ≤ count ≤ 1000, and beam.axial_force if P ≥ P_cr.
[[nodiscard]] std::vector<StickMode> stick_modes(const data::Beam& beam, int count);

}  // namespace stickslip::analytic
