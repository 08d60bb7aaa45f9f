// SPDX-License-Identifier: MIT
#include "support/vibration.hpp"

#include <Eigen/LU>
#include <cmath>
#include <complex>

namespace stickslip::testing {

std::complex<double> finite_element_steady_reaction(const data::Case& problem, int elements) {
  const solver::BeamModel model(problem.beam(), elements);
  const double omega = 2.0 * std::numbers::pi * problem.excitation().frequency_hz();
  const double amplitude = problem.excitation().amplitude();
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
  return load[tip] - (dynamic.row(tip) * u)(0);
}

double finite_element_steady_force(const data::Case& problem, int elements) {
  return std::abs(finite_element_steady_reaction(problem, elements));
}

}  // namespace stickslip::testing
