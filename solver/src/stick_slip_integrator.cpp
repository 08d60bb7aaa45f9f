// SPDX-License-Identifier: MIT
#include "stickslip/solver/stick_slip_integrator.hpp"

#include <utility>

#include "contact_motion.hpp"

namespace stickslip::solver {

StickSlipIntegrator::StickSlipIntegrator(ContactSystem system, const IntegratorSettings& settings)
    : motion_(std::make_unique<ContactMotion>(std::move(system), settings)), advance_(driver_of(*motion_)) {}

StickSlipIntegrator::~StickSlipIntegrator() = default;

void StickSlipIntegrator::start_stuck(const Eigen::VectorXd& displacement, const Eigen::VectorXd& velocity) {
  motion_->start_stuck(displacement, velocity);
}

void StickSlipIntegrator::start_slipping(const Eigen::VectorXd& displacement,
                                         const Eigen::VectorXd& velocity) {
  motion_->start_slipping(displacement, velocity);
}

void StickSlipIntegrator::step() {
  const double end_time = motion_->begin_step();
  while (motion_->time() < end_time) advance_(*motion_, end_time);
  motion_->end_step();
}

void StickSlipIntegrator::observe(Observer observer) {
  if (!observer) return motion_->observe({});
  motion_->observe([this, observer = std::move(observer)] { observer(*this); });
}

double StickSlipIntegrator::time() const noexcept { return motion_->time(); }
long StickSlipIntegrator::steps() const noexcept { return motion_->steps(); }
data::ContactState StickSlipIntegrator::state() const noexcept { return motion_->phase().state; }
const Eigen::VectorXd& StickSlipIntegrator::displacement() const noexcept {
  return motion_->now().displacement;
}
const Eigen::VectorXd& StickSlipIntegrator::velocity() const noexcept { return motion_->now().velocity; }
double StickSlipIntegrator::sliding_velocity() const {
  return motion_->is_stuck() && !motion_->yields() ? 0.0 : motion_->sliding_velocity();
}
double StickSlipIntegrator::friction_force() const { return motion_->friction_force(); }
double StickSlipIntegrator::holding_force() const { return motion_->holding_force(); }
double StickSlipIntegrator::contact_mass() const noexcept { return motion_->held_contact().mass(); }
const std::vector<data::ContactEvent>& StickSlipIntegrator::events() const noexcept {
  return motion_->events();
}
const ContactSystem& StickSlipIntegrator::system() const noexcept { return motion_->system(); }

}  // namespace stickslip::solver
