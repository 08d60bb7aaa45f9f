// SPDX-License-Identifier: MIT
#pragma once

/// The response of the stick state to h(t) = A0 sin(Ω t) by the sums of the paper with N modes. The beam
/// starts with u = 0, u_t = S h_t (Eqs. 26 to 28; with ω_n² in Eq. 24):
///
///     u(x,t) = A0 { S(x) sin(Ω t) + Σ_n U_n(x) Ω² C_n g_n(t) },     y = A0 sin(Ω t) + u,
///     g_n(t) = [ω_n sin(Ω t) - Ω sin(ω_n t)]/[(Ω² - ω_n²) ω_n],
///     f(t) = EI u'''(L,t), in the sign of Eq. (28).

#include <vector>

#include "stickslip/certified/beam.hpp"
#include "stickslip/certified/stick_modes.hpp"

namespace stickslip::certified {

/// The base motion h(t) = A0 sin(2 π hz t).
struct Excitation {
  Rational frequency_hz;  ///< Hz, > 0
  Rational amplitude;     ///< A0, m, ≥ 0
};

struct Sinusoid {
  Real amplitude;          ///< a
  Real angular_frequency;  ///< w, rad/s
};

class StickResponse {
 public:
  /// Computes the modes at the current precision. Throws what stick_modes() throws, and
  /// std::invalid_argument, naming the field, unless the frequency is positive and the amplitude is not
  /// negative.
  StickResponse(const Beam& beam, const Excitation& excitation, int modes = 10);

  [[nodiscard]] Real relative_displacement(const Real& x, const Real& t) const;  ///< u, m
  [[nodiscard]] Real absolute_displacement(const Real& x, const Real& t) const;  ///< y = h + u, m
  [[nodiscard]] Real friction_force(const Real& t) const;                        ///< f, N

  /// f as a sum of sinusoids: first the one at Ω, then the free vibrations. Throws std::domain_error,
  /// naming excitation.frequency_hz, if the ball of Ω overlaps with that of a natural frequency.
  [[nodiscard]] std::vector<Sinusoid> force_sinusoids() const;

  [[nodiscard]] const std::vector<StickMode>& modes() const noexcept { return modes_; }

 private:
  /// A time function per unit A0: base sin(Ω t) + Σ_n weights[n] g_n(t).
  struct History {
    Real base;
    std::vector<Real> weights;
  };

  /// The time function of the derivative of u of this order at x.
  [[nodiscard]] History history(const Real& x, std::size_t derivative) const;
  [[nodiscard]] Real evaluate(const History& history, const Real& t) const;
  [[nodiscard]] Real modal_coordinate(const StickMode& mode, const Real& t) const;

  QuasiStaticShape quasi_static_;
  Rational frequency_hz_;
  Real amplitude_;  // A0
  Real omega_;      // Ω
  std::vector<StickMode> modes_;
  History force_;
};

}  // namespace stickslip::certified
