// SPDX-License-Identifier: MIT
#include "support/vibration.hpp"

#include <Eigen/LU>
#include <cmath>

#include "stickslip/solver/beam_simulation.hpp"

namespace stickslip::testing {

double finite_element_steady_force(const data::Case& problem, int elements) {
  const solver::BeamModel model(problem.beam, elements);
  const double omega = 2.0 * std::numbers::pi * problem.excitation.frequency_hz();
  const double amplitude = problem.excitation.amplitude();
  const auto complex = [](const auto& matrix) {
    return Eigen::MatrixXcd(Eigen::MatrixXd(matrix).cast<std::complex<double>>());
  };
  const Eigen::MatrixXcd dynamic =
      complex(model.slip_stiffness()) +
      std::complex<double>(0.0, omega) * complex(solver::damping_matrix(model, problem.damping)) -
      omega * omega * complex(model.mass());
  const Eigen::Index tip = model.tip_deflection();
  const Eigen::VectorXcd load = (omega * omega * amplitude * model.base_load()).cast<std::complex<double>>();
  Eigen::MatrixXcd held = dynamic;
  Eigen::VectorXcd right = load + amplitude * dynamic.col(tip);
  held.row(tip).setZero();
  held.col(tip).setZero();
  held(tip, tip) = 1.0;
  right[tip] = -amplitude;
  const Eigen::VectorXcd u = held.partialPivLu().solve(right);
  return std::abs((dynamic.row(tip) * u)(0) - load[tip]);
}

MeshError::MeshError(const Vibration& v)
    : solution_(v.solution()), rigidity_(solution_.rigidity()), axial_force_(v.axial_force) {
  const Complex half = 0.5 * axial_force_ / rigidity_;
  const Complex root = std::sqrt(half * half + 10.0 * v.omega() * v.omega() / rigidity_);
  exponents_ << std::sqrt(-half + root), -std::sqrt(-half + root), std::sqrt(-half - root),
      -std::sqrt(-half - root);
  held_ = v.tip == analytic::TipSupport::held;
}

MeshError::Prediction MeshError::predicted(int elements) const {
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

MeshError::Coefficients MeshError::dual(double midspan, double tip) const {
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

MeshError::Products MeshError::products(const Coefficients& g) const {
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

}  // namespace stickslip::testing
