// SPDX-License-Identifier: MIT
#include "stickslip/analytic/free_mode_run.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "arguments.hpp"
#include "beam_constants.hpp"
#include "gsl_handles.hpp"
#include "special_functions.hpp"
#include "stickslip/analytic/slip_modes.hpp"

namespace stickslip::analytic {

std::vector<FreeMode> free_modes(const data::Beam& beam, int count) {
  // ψ* ψ has no more than 2 π in a panel, on which the points leave nothing.
  std::vector<FreeMode> modes;
  for (const SlipMode& mode : slip_modes(beam, count)) {
    double norm = 0.0;
    for_each_gauss_point(
        0.0, beam.length(), static_cast<std::size_t>(mode.number()) + 2,
        [&](double x, double weight) { norm += weight * mode.adjoint_shape(x) * mode.shape(x); });
    modes.push_back({mode.angular_frequency(), 1.0 / (mass_per_length(beam) * norm)});
  }
  return modes;
}

FreeModeRun::FreeModeRun(const std::vector<FreeMode>& modes, const ContactLaw& law, double time_step)
    : contact_(law), time_step_(time_step) {
  require_positive("time_step", time_step);
  for (const auto& [omega, input] : modes) {
    const double angle = omega * time_step, half = sinc(0.5 * angle);
    const double impulse = input * time_step * time_step;
    cosine_.push_back(std::cos(angle));
    to_displacement_.push_back(sinc(angle));
    to_velocity_.push_back(angle * std::sin(angle));
    displacement_input_.push_back(0.5 * impulse * half * half);  // g (1 - cos a)/ω²
    velocity_input_.push_back(impulse * sinc(angle));
  }
  displacement_.resize(modes.size());
  velocity_.resize(modes.size());
  first_weight_ = std::accumulate(displacement_input_.begin(), displacement_input_.end(), 0.0) / time_step;
  require_unique_step(law, first_weight_);
}

ContactStep FreeModeRun::step(double holding_force) {
  const ContactStep result =
      contact_.step(increment_ / time_step_ - first_weight_ * holding_force, first_weight_);
  const double force = result.friction_force - holding_force;
  // The increments of the next step are summed in four rows, which a compiler can take at once.
  std::array<double, 4> sums{};
  const std::size_t count = displacement_.size();
  const auto advance = [&](std::size_t k, double& sum) {
    const double q =
        cosine_[k] * displacement_[k] + to_displacement_[k] * velocity_[k] + displacement_input_[k] * force;
    const double r =
        cosine_[k] * velocity_[k] - to_velocity_[k] * displacement_[k] + velocity_input_[k] * force;
    displacement_[k] = q;
    velocity_[k] = r;
    sum += (cosine_[k] - 1.0) * q + to_displacement_[k] * r;
  };
  std::size_t k = 0;
  for (; k + 4 <= count; k += 4)
    for (std::size_t row = 0; row < 4; ++row) advance(k + row, sums[row]);
  for (; k < count; ++k) advance(k, sums[0]);
  increment_ = (sums[0] + sums[1]) + (sums[2] + sums[3]);
  return result;
}

}  // namespace stickslip::analytic
