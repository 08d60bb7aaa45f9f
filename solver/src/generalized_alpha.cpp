// SPDX-License-Identifier: MIT
#include "stickslip/solver/generalized_alpha.hpp"

#include "stickslip/data/input_error.hpp"

namespace stickslip::solver {

GeneralizedAlpha::GeneralizedAlpha(double spectral_radius) {
  if (!(spectral_radius >= 0.0 && spectral_radius <= 1.0))
    throw data::FieldError("spectral_radius", spectral_radius, "a number from 0 to 1");
  alpha_m_ = (2.0 * spectral_radius - 1.0) / (spectral_radius + 1.0);
  alpha_f_ = spectral_radius / (spectral_radius + 1.0);
  gamma_ = 0.5 - alpha_m_ + alpha_f_;
  beta_ = 0.25 * (1.0 - alpha_m_ + alpha_f_) * (1.0 - alpha_m_ + alpha_f_);
}

void GeneralizedAlpha::predict(const Kinematics& old, double h, Kinematics& alpha_level) const {
  const double share = 1.0 - alpha_f_;
  alpha_level.displacement.noalias() =
      old.displacement + (share * h) * old.velocity + (share * h * h * (0.5 - beta_)) * old.acceleration;
  alpha_level.velocity.noalias() = old.velocity + (share * h * (1.0 - gamma_)) * old.acceleration;
  alpha_level.acceleration.noalias() = alpha_m_ * old.acceleration;
}

void GeneralizedAlpha::update(Kinematics& state, double h, const Eigen::VectorXd& new_acceleration) const {
  state.displacement.noalias() +=
      h * state.velocity + (h * h * (0.5 - beta_)) * state.acceleration + (h * h * beta_) * new_acceleration;
  state.velocity.noalias() += (h * (1.0 - gamma_)) * state.acceleration + (h * gamma_) * new_acceleration;
  state.acceleration = new_acceleration;
}

}  // namespace stickslip::solver
