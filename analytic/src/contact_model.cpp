// SPDX-License-Identifier: MIT
#include "stickslip/analytic/contact_model.hpp"

#include <numbers>
#include <utility>

#include "stickslip/analytic/held_beam.hpp"

namespace stickslip::analytic {

HeldStructure held_structure(const data::Case& problem, int modes) {
  return HeldBeam(problem.beam(), problem.damping, modes).structure();
}

ContactModel contact_model(HeldStructure structure, const data::HarmonicExcitation& base) {
  const double omega = 2.0 * std::numbers::pi * base.frequency_hz();
  ContactModel model;
  static_cast<HeldStructure&>(model) = std::move(structure);
  for (const double participation : model.participation)
    model.load.push_back(base.amplitude() * omega * omega * participation);
  model.load_angular_frequency = omega;
  model.wall_amplitude = -base.amplitude();
  return model;
}

ContactModel contact_model(HeldStructure structure, const data::Case& problem) {
  ContactModel model = contact_model(std::move(structure), problem.excitation());
  model.wall_speed = problem.contact.wall.speed();
  model.normal_force = problem.normal_force();
  model.friction = problem.contact.friction;
  return model;
}

ContactModel contact_model(const data::Case& problem, int modes) {
  return contact_model(held_structure(problem, modes), problem);
}

}  // namespace stickslip::analytic
