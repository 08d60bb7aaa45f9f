// SPDX-License-Identifier: MIT
#include "stickslip/solver/base_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

namespace stickslip::solver {

namespace {

double angular_frequency(const data::HarmonicExcitation& excitation) {
  return 2.0 * std::numbers::pi * excitation.frequency_hz();
}

// A0 sin(Ω t + phase).
PrescribedMotion harmonic_motion(const data::HarmonicExcitation& excitation, double phase = 0.0) {
  const double amplitude = excitation.amplitude(), omega = angular_frequency(excitation);
  return {.displacement = [=](double t) { return amplitude * std::sin(omega * t + phase); },
          .velocity = [=](double t) { return amplitude * omega * std::cos(omega * t + phase); },
          .acceleration = [=](double t) { return -amplitude * omega * omega * std::sin(omega * t + phase); }};
}

PrescribedMotion general_motion(const data::GeneralMotion& motion) {
  return {.displacement = [motion](double t) { return motion.displacement(t); },
          .velocity = [motion](double t) { return motion.velocity(t); },
          .acceleration = [motion](double t) { return motion.acceleration(t); }};
}

}  // namespace

PrescribedMotion base_motion(const data::Motion& motion) {
  if (const auto* general = std::get_if<data::GeneralMotion>(&motion)) return general_motion(*general);
  return harmonic_motion(std::get<data::HarmonicExcitation>(motion));
}

PrescribedMotion wall_motion(const data::Case& problem, const PrescribedMotion& base) {
  const double speed = problem.contact.wall.speed();
  PrescribedMotion wall{.displacement = [speed](double t) { return speed * t; },
                        .velocity = [speed](double) { return speed; }};
  if (problem.contact.wall_motion) wall = general_motion(*problem.contact.wall_motion);
  if (problem.contact.wall.moves_with_base() || problem.is_force()) return wall;
  return {.displacement = [base, wall](double t) { return wall.displacement(t) - base.displacement(t); },
          .velocity = [base, wall](double t) { return wall.velocity(t) - base.velocity(t); },
          .acceleration = [base, wall](double t) { return wall.acceleration(t) - base.acceleration(t); }};
}

double largest_displacement(const data::Motion& motion) {
  if (const auto* harmonic = std::get_if<data::HarmonicExcitation>(&motion)) return harmonic->amplitude();
  const auto& general = std::get<data::GeneralMotion>(motion);
  double largest = 0.0;
  for (std::size_t i = 0; i < general.pieces(); ++i)
    largest = std::max(largest, std::abs(general.piece(i).displacement));
  return largest;
}

std::vector<ShiftedMotion> shifted_motion(const data::Motion& motion) {
  const auto* harmonic = std::get_if<data::HarmonicExcitation>(&motion);
  if (harmonic == nullptr) {
    const auto& general = std::get<data::GeneralMotion>(motion);
    throw data::FieldError(general.key(), "given",
                           "left out: this needs one sine, by excitation.frequency_hz");
  }
  const double omega = angular_frequency(*harmonic);
  return {{[=](double t) { return std::sin(omega * t); }, harmonic_motion(*harmonic, 0.5 * std::numbers::pi)},
          {[=](double t) { return std::cos(omega * t); }, harmonic_motion(*harmonic)}};
}

}  // namespace stickslip::solver
