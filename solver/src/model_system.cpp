// SPDX-License-Identifier: MIT
#include "stickslip/solver/model_system.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "constrained.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/solver/decompositions.hpp"

namespace stickslip::solver {

namespace {

using Complex = std::complex<double>;
using Rows = std::vector<data::WeightedRow>;

SparseMatrix matrix_of(const std::vector<data::MatrixEntry>& entries, int rows) {
  std::vector<Eigen::Triplet<double>> triplets;
  triplets.reserve(entries.size());
  for (const auto& [row, column, value] : entries) triplets.emplace_back(row, column, value);
  SparseMatrix matrix(rows, rows);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

int row_of_contact(const Rows& contact) {
  return std::ranges::max_element(contact, {}, [](const auto& one) { return std::abs(one.weight); })->row;
}

// q = T q', where q' has u_c in place of q_j: q_j = (u_c - Σ w_i q_i)/w_j.
SparseMatrix to_contact(const Rows& contact, int rows) {
  const int j = row_of_contact(contact);
  const auto at_j = std::ranges::find(contact, j, &data::WeightedRow::row)->weight;
  SparseMatrix transformation(rows, rows);
  transformation.setIdentity();
  for (const auto& [row, weight] : contact)
    transformation.coeffRef(j, row) = row == j ? 1.0 / at_j : -weight / at_j;
  return transformation;
}

// The rows that are neither of the base nor fixed, in an order that keeps a factorisation sparse.
std::vector<int> free_rows(const data::StructureMatrices& model, const SparseMatrix& stiffness) {
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(stiffness, order);
  std::vector<bool> is_held(static_cast<std::size_t>(model.rows), false);
  for (const auto& held : {model.base, model.fixed})
    for (const int row : held) is_held[static_cast<std::size_t>(row)] = true;
  std::vector<int> rows;
  for (const int row : order.indices())
    if (!is_held[static_cast<std::size_t>(row)]) rows.push_back(row);
  return rows;
}

// A column for each of these rows.
SparseMatrix selection_of(const std::vector<int>& rows, int all) {
  SparseMatrix selection(all, static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) selection.insert(rows[i], static_cast<Eigen::Index>(i)) = 1.0;
  return selection;
}

}  // namespace

ModelMatrices model_matrices(const data::Model& model) {
  const data::StructureMatrices& given = model.matrices();
  const SparseMatrix transformation = to_contact(given.contact, given.rows);
  const auto changed = [&](const std::vector<data::MatrixEntry>& entries) {
    return SparseMatrix(transformation.transpose() * matrix_of(entries, given.rows) * transformation);
  };
  const SparseMatrix mass = changed(given.mass), stiffness = changed(given.stiffness),
                     damping = changed(given.damping);
  const std::vector<int> rows = free_rows(given, stiffness);
  const SparseMatrix free = selection_of(rows, given.rows);
  const auto reduced = [&](const SparseMatrix& matrix) {
    return SparseMatrix(free.transpose() * matrix * free);
  };
  Eigen::VectorXd base = Eigen::VectorXd::Zero(given.rows), load = base;
  for (const int row : given.base) base[row] = 1.0;
  for (const auto& [row, weight] : given.load) load[row] += weight;

  ModelMatrices matrices{.mass = reduced(mass),
                         .stiffness = reduced(stiffness),
                         .own_damping = reduced(damping),
                         .rigid_shape = {},
                         .inertia = {},
                         .drag = {},
                         .static_shape = {},
                         .load = free.transpose() * (transformation.transpose() * load),
                         .base = {}};
  const Eigen::Index c = std::ranges::find(rows, row_of_contact(given.contact)) - rows.begin();
  matrices.contact = c;
  const SparseCholesky held(constrained(matrices.stiffness, c));
  if (!is_positive_definite(held))
    throw data::FieldError(model.is_mass() ? "model.stiffness" : "model.stiffness_matrix",
                           "not positive definite with the contact held",
                           "that of a structure that its base, its fixed rows and its contact hold, without "
                           "negative eigenvalues");
  const auto shape_under = [&](Eigen::VectorXd forces) {
    forces -= matrices.stiffness.col(c);
    forces[c] = 1.0;
    return Eigen::VectorXd(held.solve(forces));
  };
  const Eigen::VectorXd from_base = free.transpose() * (stiffness * base);
  matrices.static_shape = shape_under(Eigen::VectorXd::Zero(from_base.size()));
  matrices.rigid_shape = shape_under(-from_base);
  const Eigen::VectorXd whole = free * matrices.rigid_shape + base;
  matrices.inertia = free.transpose() * (mass * whole);
  matrices.drag = free.transpose() * (damping * whole);
  // What rounding leaves of a rigid translation is no stiffness.
  constexpr double rounding = 1e-9;
  const Eigen::VectorXd balance = free.transpose() * (stiffness * whole);
  if (std::abs(balance[c]) > rounding * matrices.stiffness.coeff(c, c)) matrices.base_stiffness = balance[c];
  const double own = base.dot(stiffness * base), support = base.dot(stiffness * whole);
  matrices.base = {free.transpose() * (mass * base),
                   free.transpose() * (damping * base),
                   from_base,
                   {base.dot(mass * whole), base.dot(damping * whole),
                    std::abs(support) > rounding * own ? support : 0.0}};
  return matrices;
}

std::vector<ModelMode> model_modes(const ModelMatrices& matrices, bool contact_is_held) {
  constexpr Eigen::Index most_rows = 1000;
  const Eigen::Index rows = matrices.mass.rows();
  if (rows > most_rows)
    throw data::FieldError("damping.ratio", "given for " + std::to_string(rows) + " rows",
                           "left out with more than 1000 rows in time steps, whose matrix would be full");
  std::vector<Eigen::Index> kept;
  for (Eigen::Index row = 0; row < rows; ++row)
    if (!contact_is_held || row != matrices.contact) kept.push_back(row);
  if (kept.empty()) return {};
  const Eigen::MatrixXd mass = Eigen::MatrixXd(matrices.mass)(kept, kept),
                        stiffness = Eigen::MatrixXd(matrices.stiffness)(kept, kept);
  // A free contact may leave a rigid motion: the shift s gives μ = 1/(ω² + s).
  const double shift = contact_is_held ? 0.0 : std::max(1.0, 1e-3 * stiffness.trace() / mass.trace());
  const Eigen::MatrixXd shifted = stiffness + shift * mass;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solved(mass, shifted);
  constexpr double massless = 1e-13;  // of the largest 1/ω²
  std::vector<ModelMode> modes;
  const Eigen::VectorXd& inverse = solved.eigenvalues();
  for (Eigen::Index n = inverse.size() - 1; n >= 0 && inverse[n] > massless * inverse[inverse.size() - 1];
       --n) {
    ModelMode mode{.angular_frequency = std::sqrt(std::max(0.0, 1.0 / inverse[n] - shift)),
                   .shape = Eigen::VectorXd::Zero(rows)};
    const Eigen::VectorXd shape = solved.eigenvectors().col(n) / std::sqrt(inverse[n]);  // φᵀ K φ = 1 before
    for (std::size_t i = 0; i < kept.size(); ++i) mode.shape[kept[i]] = shape[static_cast<Eigen::Index>(i)];
    modes.push_back(std::move(mode));
  }
  return modes;
}

SparseMatrix relative_damping(const ModelMatrices& matrices, const data::Damping& damping) {
  const Eigen::Index rows = matrices.mass.rows();
  SparseMatrix matrix =
      damping.kelvin_voigt() * matrices.stiffness + damping.mass_proportional() * matrices.mass;
  if (!damping.has_ratio()) return matrix;
  Eigen::MatrixXd modal = Eigen::MatrixXd::Zero(rows, rows);
  std::size_t number = 0;
  for (const ModelMode& mode : model_modes(matrices, true)) {
    Eigen::VectorXd v = matrices.mass * mode.shape;
    v[matrices.contact] = 0.0;
    v[matrices.contact] = -matrices.static_shape.dot(v);
    modal += 2.0 * damping.ratio_of(++number) * mode.angular_frequency * v * v.transpose();
  }
  return matrix + SparseMatrix(modal.sparseView());
}

ContactSystem model_contact_system(const data::Case& problem, const PrescribedMotion& base) {
  return model_contact_system(problem, model_matrices(*problem.model()), base);
}

ContactSystem model_contact_system(const data::Case& problem, const ModelMatrices& matrices,
                                   const PrescribedMotion& base) {
  const bool is_force = problem.is_force();
  const Eigen::Index rows = matrices.mass.rows(), c = matrices.contact;
  ContactSystem system{.mass = matrices.mass,
                       .damping = matrices.own_damping + relative_damping(matrices, problem.damping),
                       .stick_stiffness = matrices.stiffness,
                       .slip_stiffness = matrices.stiffness,
                       .load_shape = -(is_force ? matrices.load : matrices.inertia),
                       .load_history = base.acceleration,
                       .contact = c,
                       .wall = wall_motion(problem, base),
                       .normal_force = problem.normal_force(),
                       .friction = problem.contact.friction,
                       .tangential = problem.contact.compliance,
                       .further_loads = {}};
  const Eigen::VectorXd contact = Eigen::VectorXd::Unit(rows, c);
  if (!is_force && !matrices.drag.isZero(0.0))
    system.further_loads.push_back({-matrices.drag, base.velocity});
  if (!is_force && matrices.base_stiffness != 0.0)
    system.further_loads.push_back({-matrices.base_stiffness * contact, base.displacement});
  if (const double force = problem.constant_force; force != 0.0)
    system.further_loads.push_back({force * contact, [](double) { return 1.0; }});
  return system;
}

double steady_reaction_of(const data::Case& problem) {
  const ModelMatrices matrices = model_matrices(*problem.model());
  const double omega = 2.0 * std::numbers::pi * problem.excitation().frequency_hz();
  const bool is_force = problem.is_force();
  const Eigen::Index c = matrices.contact;
  const SparseMatrix damping = matrices.own_damping + relative_damping(matrices, problem.damping);
  using ComplexMatrix = Eigen::SparseMatrix<Complex>;
  const ComplexMatrix dynamic = matrices.stiffness.cast<Complex>() +
                                Complex(0.0, omega) * damping.cast<Complex>() -
                                Complex(omega * omega) * matrices.mass.cast<Complex>();
  Eigen::VectorXcd load = omega * omega * (is_force ? matrices.load : matrices.inertia);
  if (!is_force) load -= Complex(0.0, omega) * matrices.drag;
  const double held_at = is_force || problem.contact.wall.moves_with_base() ? 0.0 : -1.0;
  Eigen::VectorXcd right = load - held_at * Eigen::VectorXcd(dynamic.col(c));
  right[c] = held_at;
  ComplexMatrix held = dynamic;
  held.prune([c](Eigen::Index row, Eigen::Index column, Complex) { return row != c && column != c; });
  held.coeffRef(c, c) = 1.0;
  held.makeCompressed();
  const Eigen::SparseLU<ComplexMatrix> factorisation(held);
  const Eigen::VectorXcd u = factorisation.solve(right);
  const Complex row = Eigen::VectorXcd(dynamic.transpose().col(c)).cwiseProduct(u).sum();
  return std::abs(row - load[c] + (is_force ? 0.0 : matrices.base_stiffness));
}

}  // namespace stickslip::solver
