// SPDX-License-Identifier: MIT
#include "stickslip/solver/energy_balance.hpp"

#include <stdexcept>

namespace stickslip::solver {

namespace {

Eigen::VectorXd follower_row(const ContactSystem& system) {
  const SparseMatrix& stick = system.stick_stiffness;
  if (!stick.isApprox(SparseMatrix(stick.transpose())))
    throw std::invalid_argument("stick_stiffness: must be symmetric, or the system has no energy to balance");
  const SparseMatrix difference = system.slip_stiffness - stick;
  SparseMatrix elsewhere = difference;
  elsewhere.prune([&](Eigen::Index row, Eigen::Index, double) { return row != system.contact; });
  if (elsewhere.norm() > 0.0)
    throw std::invalid_argument("slip_stiffness: must equal stick_stiffness but for the row of the contact");
  return SparseMatrix(difference.transpose()).col(system.contact);
}

}  // namespace

EnergyRecorder::EnergyRecorder(const StickSlipIntegrator& start)
    : follower_row_(follower_row(start.system())) {
  set_state(start);
  balance_.initial_energy = balance_.energy();
}

void EnergyRecorder::record(const StickSlipIntegrator& now) {
  const double h = now.time() - time_;
  const Powers before = powers_;
  const Eigen::VectorXd velocity_before = velocity_;
  const bool is_captured =
      h == 0.0 && state_ == data::ContactState::slip && now.state() == data::ContactState::stick;
  if (is_captured && now.system().tangential.is_rigid()) {
    const double impulse = -now.contact_mass() * sliding_velocity_;
    balance_.base_work += impulse * now.system().wall.velocity(time_);
    balance_.capture_loss -= 0.5 * impulse * sliding_velocity_;
  }
  set_state(now);
  balance_.base_work += 0.5 * h * (before.base + powers_.base);
  balance_.follower_work += 0.5 * h * (before.follower + powers_.follower);
  const Eigen::VectorXd mean_velocity = 0.5 * (velocity_before + velocity_);
  balance_.damping_loss += h * mean_velocity.dot(now.system().damping * mean_velocity);
  balance_.friction_loss += 0.5 * h * (before.friction + powers_.friction);
}

double EnergyRecorder::sliding_velocity(const StickSlipIntegrator& now) const {
  const ContactSystem& system = now.system();
  return now.velocity()[system.contact] - system.wall.velocity(now.time());
}

EnergyRecorder::Powers EnergyRecorder::powers(const StickSlipIntegrator& now) const {
  const ContactSystem& system = now.system();
  const Eigen::VectorXd& v = now.velocity();
  const double friction_force = now.friction_force();
  Eigen::VectorXd load;
  system.set_load(now.time(), load);
  return {.base = load.dot(v) + friction_force * system.wall.velocity(now.time()),
          .follower = -v[system.contact] * follower_row_.dot(now.displacement()),
          .friction = -friction_force * sliding_velocity(now)};
}

void EnergyRecorder::set_state(const StickSlipIntegrator& now) {
  const ContactSystem& system = now.system();
  balance_.kinetic = 0.5 * now.velocity().dot(system.mass * now.velocity());
  balance_.elastic = 0.5 * now.displacement().dot(system.stick_stiffness * now.displacement());
  time_ = now.time();
  velocity_ = now.velocity();
  state_ = now.state();
  sliding_velocity_ = sliding_velocity(now);
  powers_ = powers(now);
}

}  // namespace stickslip::solver
