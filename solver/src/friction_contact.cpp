// SPDX-License-Identifier: MIT
#include "friction_contact.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "bracketed_root.hpp"

namespace stickslip::solver {

namespace {

// The steepest fall of μ by the exponential term, s/m.
double weakening(const data::FrictionLaw& law) {
  return (law.static_coefficient() - law.kinetic_coefficient()) * law.decay();
}

}  // namespace

double friction_coefficient(const data::FrictionLaw& law, double sliding_velocity) {
  const double speed = std::abs(sliding_velocity);
  return law.kinetic_coefficient() +
         (law.static_coefficient() - law.kinetic_coefficient()) * std::exp(-law.decay() * speed) +
         law.viscous() * speed;
}

double friction_coefficient_slope(const data::FrictionLaw& law, double sliding_velocity) {
  return law.viscous() - weakening(law) * std::exp(-law.decay() * std::abs(sliding_velocity));
}

FrictionContact::FrictionContact(const ContactSystem& system)
    : law_(system.friction.in_slip()),
      tangential_(system.tangential),
      normal_force_(system.normal_force),
      limit_(normal_force_ == bonding_force ? bonding_force
                                            : system.friction.static_coefficient() * normal_force_) {
  data::require_usable(system.friction, tangential_);
}

double FrictionContact::force(double direction, double sliding_velocity) const {
  return -direction * friction_coefficient(law_, sliding_velocity) * normal_force_;
}

// f_d = -d μ(v) N, with v = free_velocity + mobility f_d the sliding velocity at the α level. With w = d v
// this is w + mobility N μ(w) = d free_velocity. For w < 0, where a trial step has overshot the end of the phase, μ
// is μ_s. (For a law that jumps, μ_s is μ_m here.) The left side is convex, and it rises as long as
// mobility N (μ_s - μ_m) α < 1. Newton's method from above then converges and stays above the root.
double FrictionContact::alpha_level_force(double direction, double free_velocity, double mobility) const {
  const double forward = direction * free_velocity;
  const double strength = mobility * normal_force_;
  double w = forward - strength * law_.kinetic_coefficient();
  if (forward <= strength * law_.static_coefficient())
    return -direction * law_.static_coefficient() * normal_force_;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const double residual = w + strength * friction_coefficient(law_, w) - forward;
    const double slope = 1.0 + strength * friction_coefficient_slope(law_, w);
    const double next = std::max(w - residual / slope, 0.0);
    if (std::abs(next - w) <= 1e-15 * std::max(w, forward)) break;
    w = next;
  }
  return force(direction, w);
}

double FrictionContact::yielding_force(double slider, double position, double sliding_velocity) const {
  if (tangential_.is_smooth())
    return force(std::tanh(sliding_velocity / tangential_.regularisation_velocity()), sliding_velocity);
  return bounded(tangential_.tangential_stiffness() * (slider - position), sliding_velocity);
}

double FrictionContact::bounded(double elastic, double sliding_velocity) const {
  const double direction = -sign(elastic);
  const double bound = force(direction, std::max(direction * sliding_velocity, 0.0));
  return std::abs(elastic) <= std::abs(bound) ? elastic : bound;
}

// v = v_free + mobility f(v) has one root: f falls with v, but for the weakening of the law. It is sought in v, and
// the force follows from the motion: a stiff law would multiply the rounding of v.
double FrictionContact::solve_yielding_force(double slider, const Response& response) const {
  const double reach = response.flexibility / response.mobility;
  const auto residual = [&](double v) {
    const double position = response.position + reach * (v - response.velocity);
    return v - response.velocity - response.mobility * yielding_force(slider, position, v);
  };
  double width = response.mobility * (limit_ + law_.viscous() * normal_force_ * std::abs(response.velocity));
  if (width == 0.0) return 0.0;
  while (residual(response.velocity - width) >= 0.0 || residual(response.velocity + width) < 0.0)
    width *= 2.0;
  const double low = response.velocity - width, high = response.velocity + width;
  const double v = bracketed_root(residual, low, residual(low), high, residual(high), 1e-15 * width);
  return (v - response.velocity) / response.mobility;
}

FrictionContact::Slider FrictionContact::advance_slider(double slider, double position,
                                                        double sliding_velocity) const {
  if (tangential_.is_smooth()) return {position, sign(sliding_velocity)};
  const double f = yielding_force(slider, position, sliding_velocity);
  const bool moves = f != tangential_.tangential_stiffness() * (slider - position);
  return moves ? Slider{position + f / tangential_.tangential_stiffness(), -sign(f)} : Slider{slider, 0.0};
}

void FrictionContact::require_unique_force(double mobility, double time, double time_step) const {
  const double fall = mobility * normal_force_ * weakening(law_);
  if (fall < 1.0) return;
  std::ostringstream text;
  text << "time_step = " << time_step << " s: at t = " << time
       << " s the friction law falls faster than a step can follow; the step must be shorter than about "
       << time_step / fall << " s";
  throw std::runtime_error(text.str());
}

}  // namespace stickslip::solver
