// SPDX-License-Identifier: MIT
#pragma once

/// The steady vibration of the beam on a moving base.

#include <complex>
#include <numbers>
#include <string>

#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "support/beams.hpp"

namespace stickslip::testing {

/// A steady vibration of the paper's beam, tip held or free.
struct Vibration {
  static constexpr double amplitude = 1e-3;  ///< A0, m

  double hz;
  data::Damping damping;
  analytic::TipSupport tip;
  double axial_force{500.0};

  [[nodiscard]] double omega() const { return 2.0 * std::numbers::pi * hz; }
  [[nodiscard]] data::Beam beam() const { return paper_beam_with_axial_force(axial_force); }
  [[nodiscard]] data::HarmonicExcitation excitation() const {
    return data::HarmonicExcitation({hz, amplitude});
  }
  [[nodiscard]] analytic::DampedSteadyState solution() const { return {beam(), excitation(), damping, tip}; }
  [[nodiscard]] std::string name() const {
    return "P = " + std::to_string(axial_force) + " N, " + std::to_string(hz) +
           " Hz, eta = " + std::to_string(damping.kelvin_voigt()) +
           " s, zeta = " + std::to_string(damping.ratio()) +
           (tip == analytic::TipSupport::held ? ", held" : ", free");
  }
};

/// f (N) by finite elements in the steady vibration with the tip held, with its phase against the base: less the row of the tip
/// of (K + i Omega C - Omega^2 M) u = Omega^2 A0 b with u(L) = -A0.
[[nodiscard]] std::complex<double> finite_element_steady_reaction(const data::Case& problem, int elements);
/// Its amplitude.
[[nodiscard]] double finite_element_steady_force(const data::Case& problem, int elements);

}  // namespace stickslip::testing
