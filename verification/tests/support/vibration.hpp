#pragma once

/// The steady vibration of the beam on a moving base, and what a mesh makes of it.

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>

#include "stickslip/analytic/damped_steady_state.hpp"
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
    return std::to_string(hz) + " Hz, eta = " + std::to_string(damping.kelvin_voigt()) +
           " s, zeta = " + std::to_string(damping.ratio()) +
           (tip == analytic::TipSupport::held ? ", held" : ", free");
  }
};

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
///     B = D l^4/720 [int G'''' u'''' - l^2 int ((G^(6) u'''' + G'''' u^(6))/42 + 8 G^(5) u^(5)/105 + P G''''
///     u''''/(42 D))].
class MeshError {
  using Complex = std::complex<double>;

 public:
  explicit MeshError(const Vibration& v)
      : solution_(v.solution()), rigidity_(solution_.rigidity()), axial_force_(v.axial_force) {
    const Complex half = 0.5 * axial_force_ / rigidity_;
    const Complex root = std::sqrt(half * half + 10.0 * v.omega() * v.omega() / rigidity_);
    exponents_ << std::sqrt(-half + root), -std::sqrt(-half + root), std::sqrt(-half - root),
        -std::sqrt(-half - root);
    held_ = v.tip == analytic::TipSupport::held;
  }

  /// The leading term of u_h - u, and the modulus of what stands behind it, for l^8 with (|r| l)^2/8 more.
  struct Prediction {
    Amplitudes leading, next;
  };

  [[nodiscard]] Prediction predicted(int elements) const {
    const double l = 2.0 / elements;
    const Complex factor = -rigidity_ * std::pow(l, 4) / 720.0;
    const double scaled = std::pow(exponents_.cwiseAbs().maxCoeff() * l, 2);
    const double behind = std::abs(factor) * l * l * (1.0 + scaled / 8.0);
    const Products at_midspan = products(dual(1.0, 0.0)), at_tip = products(dual(0.0, 1.0));
    // f - f_h = B(G - G_h, e) for the G that moves the tip by 1; in B(G, e) the follower term belongs to the
    // row of the tip, which makes D G''(L) + P G(L) = 0 of the moment-free tip.
    const Amplitudes leading{factor * at_midspan.leading, held_ ? 0.0 : factor * at_tip.leading,
                             held_ ? factor * at_tip.leading : 0.0};
    const Amplitudes next{behind * at_midspan.next, behind * at_tip.next, behind * at_tip.next};
    return {leading, next};
  }

 private:
  using Coefficients = Eigen::Matrix<Complex, 8, 1>;  // of exp(r x) in the left, then in the right half

  // With a unit force at midspan, and at the tip a unit force (free) or a unit deflection (held).
  [[nodiscard]] Coefficients dual(double midspan, double tip) const {
    Eigen::Matrix<Complex, 8, 8> matrix = Eigen::Matrix<Complex, 8, 8>::Zero();
    Coefficients right_side = Coefficients::Zero();
    for (int j = 0; j < 4; ++j) {
      const Complex r = exponents_[j];
      matrix(0, j) = 1.0;
      matrix(1, j) = r;
      for (int order = 0; order < 4; ++order) {
        matrix(2 + order, j) = -std::pow(r, order) * std::exp(r);
        matrix(2 + order, 4 + j) = std::pow(r, order) * std::exp(r);
      }
      const Complex at_tip = std::exp(2.0 * r);
      matrix(6, 4 + j) = (rigidity_ * r * r + axial_force_) * at_tip;
      matrix(7, 4 + j) = held_ ? at_tip : -r * (rigidity_ * r * r + axial_force_) * at_tip;
    }
    right_side[5] = midspan / rigidity_;
    right_side[7] = tip;
    return matrix.partialPivLu().solve(right_side);
  }

  // int G'''' Y'''' dx, and the sum of the moduli of the three terms of order l^2 more.
  struct Products {
    Complex leading;
    double next{};
  };

  // By Simpson's rule.
  [[nodiscard]] Products products(const Coefficients& g) const {
    constexpr int n = 400;  // intervals in each half
    Products sum;
    for (int half = 0; half < 2; ++half)
      for (int i = 0; i <= n; ++i) {
        const double x = half + static_cast<double>(i) / n;
        const double weight = simpson_weight(i, n) / (3.0 * n);
        const auto dual_derivative = [&](int order) {
          Complex value = 0.0;
          for (int j = 0; j < 4; ++j)
            value += g[4 * half + j] * std::pow(exponents_[j], order) * std::exp(exponents_[j] * x);
          return value;
        };
        const auto product = [&](int of_dual, int of_solution) {
          return dual_derivative(of_dual) * solution_.derivative(of_solution, x);
        };
        sum.leading += weight * product(4, 4);
        sum.next +=
            weight * (std::abs(product(6, 4) + product(4, 6)) / 42.0 + std::abs(product(5, 5)) * 8.0 / 105.0 +
                      std::abs(axial_force_ / rigidity_ * product(4, 4)) / 42.0);
      }
    return sum;
  }

  analytic::DampedSteadyState solution_;
  Complex rigidity_;
  double axial_force_;
  bool held_{};
  Eigen::Vector4cd exponents_;
};

}  // namespace stickslip::testing
