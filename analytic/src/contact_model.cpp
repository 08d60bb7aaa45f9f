// SPDX-License-Identifier: MIT
#include "stickslip/analytic/contact_model.hpp"

#include <numbers>
#include <utility>

#include "stickslip/analytic/held_beam.hpp"
#include "stickslip/analytic/held_model.hpp"
#include "stickslip/analytic/stick_reaction.hpp"

namespace stickslip::analytic {

double wall_share(const data::Case& problem) {
  return problem.contact.wall.moves_with_base() || problem.is_force() ? 0.0 : 1.0;
}

HeldStructure held_structure(const data::Case& problem, int modes) {
  if (problem.model() != nullptr) return held_model(problem, modes);
  HeldStructure structure = HeldBeam(problem.beam(), problem.damping, modes).structure();
  structure.wall_share = wall_share(problem);
  structure.moved_mass = problem.beam().density() * problem.beam().area() * problem.beam().length();
  return structure;
}

ContactModel contact_model(HeldStructure structure, const data::HarmonicExcitation& base) {
  const double omega = 2.0 * std::numbers::pi * base.frequency_hz();
  ContactModel model;
  static_cast<HeldStructure&>(model) = std::move(structure);
  for (const double participation : model.participation)
    model.load.push_back(base.amplitude() * omega * omega * participation);
  model.load.back() -= base.amplitude() * model.base_stiffness;
  for (const double drag : model.drag) model.load_cosine.push_back(-base.amplitude() * omega * drag);
  // Of A0 sin(Ω t) as it is of a force.
  for (BaseBalance& balance : model.base_balances)
    balance.base = {base.amplitude() * (balance.base[2] - omega * omega * balance.base[0]),
                    base.amplitude() * omega * balance.base[1], 0.0};
  model.load_angular_frequency = omega;
  model.base_amplitude = base.is_force() ? 0.0 : base.amplitude();
  model.wall_amplitude = -model.wall_share * model.base_amplitude;
  return model;
}

namespace {

ContactModel driven_model(HeldStructure structure, const data::Case& problem) {
  ContactModel model;
  static_cast<HeldStructure&>(model) = std::move(structure);
  for (const double participation : model.participation) model.load.push_back(-participation);
  for (const double drag : model.drag) model.load_cosine.push_back(-drag);
  model.base_load = -model.base_stiffness;
  if (problem.model() == nullptr)
    model.omitted = {.angular_frequency =
                         held_modes(problem, static_cast<int>(model.modes()) + 1).back().angular_frequency,
                     .contact = model.free_mass()};
  model.drive = std::make_shared<const Drive>(problem);
  model.load_angular_frequency = model.drive->angular_frequency();
  return model;
}

}  // namespace

ContactModel contact_model(HeldStructure structure, const data::Case& problem) {
  structure.wall_share = wall_share(problem);
  const bool is_driven = problem.has(data::Feature::general_motion);
  ContactModel model = is_driven ? driven_model(std::move(structure), problem)
                                 : contact_model(std::move(structure), problem.excitation());
  model.contact_force = problem.constant_force;
  if (!is_driven) model.wall_speed = problem.contact.wall.speed();
  model.normal_force = problem.normal_force();
  model.friction = problem.contact.friction;
  return model;
}

ContactModel contact_model(const data::Case& problem, int modes) {
  return contact_model(held_structure(problem, modes), problem);
}

}  // namespace stickslip::analytic
