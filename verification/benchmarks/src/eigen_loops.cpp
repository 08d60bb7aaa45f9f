// SPDX-License-Identifier: MIT
#include "eigen_loops.hpp"

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "stickslip/solver/beam_model.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/generalized_alpha.hpp"

namespace stickslip::benchmarks {

namespace {

using solver::SparseMatrix;

// Removes the row and column of the tip deflection, which is the last but one degree of freedom.
SparseMatrix without_tip(const SparseMatrix& matrix) {
  const Eigen::Index tip = matrix.rows() - 2;
  SparseMatrix selection(tip + 2, tip + 1);
  for (Eigen::Index i = 0; i < tip; ++i) selection.insert(i, i) = 1.0;
  selection.insert(tip + 1, tip) = 1.0;
  return (selection.transpose() * matrix * selection).pruned();
}

Eigen::VectorXd without_tip(const Eigen::VectorXd& vector) {
  Eigen::VectorXd rest(vector.size() - 1);
  rest << vector.head(vector.size() - 2), vector[vector.size() - 1];
  return rest;
}

template <class Matrix, class Solver>
EigenLoop loop(const solver::BeamModel& model, const data::HarmonicExcitation& excitation,
               const data::NumericalSettings& numerics, const Matrix& mass, const Matrix& stiffness,
               const Solver& solver) {
  const solver::GeneralizedAlpha method(numerics.spectral_radius());
  const double h = numerics.time_step(), share = 1.0 - method.alpha_f();
  const Eigen::Index tip = model.tip_deflection();
  const auto base = solver::harmonic_motion(excitation);
  const Eigen::VectorXd of_displacement = without_tip(Eigen::VectorXd(model.stick_stiffness().col(tip)));
  const Eigen::VectorXd of_acceleration =
      without_tip(Eigen::VectorXd(model.mass().col(tip) - model.base_load()));
  const Eigen::VectorXd mass_row = without_tip(Eigen::VectorXd(model.mass().col(tip)));
  const Eigen::VectorXd stiffness_row =
      without_tip(Eigen::VectorXd(SparseMatrix(model.slip_stiffness().transpose()).col(tip)));
  const double mass_corner = model.mass().coeff(tip, tip) - model.base_load()[tip];
  const double stiffness_corner = model.slip_stiffness().coeff(tip, tip);

  const Eigen::Index n = mass.rows();
  Eigen::VectorXd q = Eigen::VectorXd::Zero(n), a = q, alpha_q(n), alpha_a(n), new_a(n), residual(n);
  Eigen::VectorXd v = -base.velocity(0.0) * without_tip(model.unit_tip_deflection());
  EigenLoop result;
  const long steps = solver::step_count(numerics.duration(), h);
  for (long step = 0; step < steps; ++step) {
    const double t = static_cast<double>(step) * h, load_time = t + share * h, end = t + h;
    alpha_q = q + (share * h) * v + (share * h * h * (0.5 - method.beta())) * a;
    alpha_a = method.alpha_m() * a;
    residual =
        base.acceleration(load_time) * of_acceleration + base.displacement(load_time) * of_displacement;
    residual.noalias() -= mass * alpha_a;
    residual.noalias() -= stiffness * alpha_q;
    new_a = solver.solve(residual);
    q += h * v + (h * h * (0.5 - method.beta())) * a + (h * h * method.beta()) * new_a;
    v += (h * (1.0 - method.gamma())) * a + (h * method.gamma()) * new_a;
    a = new_a;
    const double force = -(mass_row.dot(a) + stiffness_row.dot(q)) + mass_corner * base.acceleration(end) +
                         stiffness_corner * base.displacement(end);
    result.largest_force = std::max(result.largest_force, std::abs(force));
  }
  // Operations: 5 n for alpha_q, n for alpha_a, 4 n for the load and its residual, 6 n and 4 n for q and v, 4
  // n for the force.
  const auto size = static_cast<double>(n);
  result.flops_per_step = 24.0 * size;
  result.bytes_per_step = 8.0 * 26.0 * size;
  return result;
}

}  // namespace

EigenLoop eigen_stick_loop(const data::Beam& beam, const data::HarmonicExcitation& excitation,
                           const data::NumericalSettings& numerics, Factorisation factorisation) {
  const solver::BeamModel model(beam, numerics.elements());
  const solver::GeneralizedAlpha method(numerics.spectral_radius());
  const SparseMatrix mass = without_tip(model.mass()), stiffness = without_tip(model.stick_stiffness());
  const SparseMatrix matrix =
      method.mass_factor() * mass + method.stiffness_factor(numerics.time_step()) * stiffness;
  if (factorisation == Factorisation::dense_lu) {
    const Eigen::MatrixXd dense_mass = mass, dense_stiffness = stiffness;
    const Eigen::PartialPivLU<Eigen::MatrixXd> lu{Eigen::MatrixXd(matrix)};
    EigenLoop result = loop(model, excitation, numerics, dense_mass, dense_stiffness, lu);
    const auto entries = static_cast<double>(dense_mass.size());
    result.flops_per_step += 6.0 * entries;
    result.bytes_per_step += 24.0 * entries;
    return result;
  }
  const Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<int>> ldlt(matrix);
  EigenLoop result = loop(model, excitation, numerics, mass, stiffness, ldlt);
  const auto entries = static_cast<double>(mass.nonZeros() + stiffness.nonZeros());
  const auto factor = static_cast<double>(SparseMatrix(ldlt.matrixL()).nonZeros());
  result.flops_per_step += 2.0 * entries + 4.0 * factor;
  result.bytes_per_step += 12.0 * (entries + 2.0 * factor);
  return result;
}

}  // namespace stickslip::benchmarks
