// SPDX-License-Identifier: MIT
#pragma once

/// The steady vibration of the beam on a moving base, and its error on a mesh.

#include <Eigen/Dense>
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

/// The amplitude of f (N) by finite elements in the steady vibration with the tip held: the row of the tip of
/// (K + i Omega C - Omega^2 M) u = Omega^2 A0 b with u(L) = -A0. The error falls with the fourth power of the
/// element length.
[[nodiscard]] double finite_element_steady_force(const data::Case& problem, int elements);

/// Of point i of n + 1 in Simpson's rule, to be multiplied by a third of the distance.
inline double simpson_weight(int i, int n) {
  if (i == 0 || i == n) return 1.0;
  return i % 2 == 1 ? 4.0 : 2.0;
}

/// Complex amplitudes of what is compared: the displacements at midspan and tip, absolute, and f of Eq. (28).
struct Amplitudes {
  std::complex<double> midspan, tip, force;
};

/// Predicts what a mesh does to a linear functional J of the deflection: J(u) - J(u_h) = B(G - I G, u - I u)
/// + O(l^8), where G is the dual solution, B(G, e) = J(e) for every e, of the same equation in both halves of
/// the beam, and I interpolates. (I u)'' is the projection of u'' on straight lines in every element, so that
/// by Legendre polynomials
///
///     B = D l^4/720 [int G'''' u''''
///                    - l^2 int ((G^(6) u'''' + G'''' u^(6))/42 + 8 G^(5) u^(5)/105 + P G'''' u''''/(42 D))].
class MeshError {
  using Complex = std::complex<double>;

 public:
  explicit MeshError(const Vibration& v);

  /// The leading term of u_h - u, and the modulus of what stands behind it, for l^8 with (|r| l)^2/8 more.
  struct Prediction {
    Amplitudes leading, next;
  };

  [[nodiscard]] Prediction predicted(int elements) const;

 private:
  using Coefficients = Eigen::Matrix<Complex, 8, 1>;  // of exp(r x) in the left, then in the right half

  // With a unit force at midspan, and at the tip a unit force (free) or a unit deflection (held).
  [[nodiscard]] Coefficients dual(double midspan, double tip) const;

  // int G'''' Y'''' dx, and the sum of the moduli of the three terms of order l^2 more.
  struct Products {
    Complex leading;
    double next{};
  };

  // By Simpson's rule.
  [[nodiscard]] Products products(const Coefficients& g) const;

  analytic::DampedSteadyState solution_;
  Complex rigidity_;
  double axial_force_;
  bool held_{};
  Eigen::Vector4cd exponents_;
};

/// A stiffness with the deflection of the tip held at zero.
inline Eigen::MatrixXd with_held_tip(const solver::BeamModel& model, const solver::SparseMatrix& stiffness) {
  Eigen::MatrixXd held = stiffness;
  const Eigen::Index tip = model.tip_deflection();
  held.row(tip).setZero();
  held.col(tip).setZero();
  held(tip, tip) = 1.0;
  return held;
}

}  // namespace stickslip::testing
