// SPDX-License-Identifier: MIT
#include "stickslip/solver/base_reaction.hpp"

#include <utility>

#include "constrained.hpp"
#include "stickslip/solver/model_system.hpp"

namespace stickslip::solver {

BaseReaction::BaseReaction(const data::Case& problem, const BeamSimulation& simulation)
    : simulation_(simulation) {
  if (problem.model() != nullptr) {
    const SparseMatrix& damping = simulation.integrator().system().damping;
    ModelMatrices matrices = model_matrices(*problem.model());
    add(std::move(matrices.base), (damping - matrices.own_damping).transpose() * matrices.rigid_shape);
    return;
  }
  const BeamModel& model = simulation.model();
  const Eigen::Index rows = model.degrees_of_freedom();
  Eigen::VectorXd shift = Eigen::VectorXd::Zero(rows), turn = Eigen::VectorXd::Ones(rows);
  for (Eigen::Index node = 0; node < rows / 2; ++node) {
    shift[2 * node] = 1.0;
    turn[2 * node] = problem.beam().length() * static_cast<double>(node + 1) / model.elements();
  }
  const SparseMatrix damping = damping_matrix(model, problem.damping);
  add(model.clamp_force(), damping * shift);
  add(model.clamp_moment(), damping * turn);
}

void BaseReaction::add(MotionRow row, const Eigen::VectorXd& relative_drag) {
  const ContactSystem& system = simulation_.integrator().system();
  const Eigen::VectorXd influence =
      SparseCholesky(filled(system.mass)).solve(simulation_.on_coordinates(row.acceleration));
  row.displacement =
      simulation_.on_coordinates(row.displacement) - system.slip_stiffness.transpose() * influence;
  row.velocity = simulation_.on_coordinates(row.velocity) - system.damping.transpose() * influence;
  row.velocity -= simulation_.on_coordinates(relative_drag);
  Row result{std::move(row), influence.dot(system.load_shape), influence[system.contact]};
  for (const ContactSystem::Load& load : system.further_loads)
    result.further.push_back(influence.dot(load.shape));
  rows_.push_back(std::move(result));
}

double BaseReaction::value(const Row& row) const {
  const StickSlipIntegrator& run = simulation_.integrator();
  const PrescribedMotion& base = simulation_.base();
  const double t = run.time();
  const auto& [inertia, drag, support] = row.motion.base;
  double sum = row.motion.displacement.dot(run.displacement()) + row.motion.velocity.dot(run.velocity()) +
               inertia * base.acceleration(t) + drag * base.velocity(t) + support * base.displacement(t) +
               row.load * run.system().load_history(t) + row.contact * run.friction_force();
  for (std::size_t i = 0; i < row.further.size(); ++i)
    sum += row.further[i] * run.system().further_loads[i].history(t);
  return sum;
}

}  // namespace stickslip::solver
