// SPDX-License-Identifier: MIT
#include "stickslip/solver/base_motion.hpp"

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

}  // namespace

PrescribedMotion base_motion(const data::Motion& motion) {
  return std::visit([](const data::HarmonicExcitation& harmonic) { return harmonic_motion(harmonic); },
                    motion);
}

PrescribedMotion wall_motion(const data::Case& problem, const PrescribedMotion& base) {
  const double speed = problem.contact.wall.speed();
  if (problem.contact.wall.moves_with_base() || problem.excitation().is_force())
    return {.displacement = [speed](double t) { return speed * t; },
            .velocity = [speed](double) { return speed; }};
  return {.displacement = [base, speed](double t) { return speed * t - base.displacement(t); },
          .velocity = [base, speed](double t) { return speed - base.velocity(t); },
          .acceleration = [base](double t) { return -base.acceleration(t); }};
}

double largest_displacement(const data::Motion& motion) {
  return std::visit([](const data::HarmonicExcitation& harmonic) { return harmonic.amplitude(); }, motion);
}

std::vector<ShiftedMotion> shifted_motion(const data::Motion& motion) {
  return std::visit(
      [](const data::HarmonicExcitation& harmonic) -> std::vector<ShiftedMotion> {
        const double omega = angular_frequency(harmonic);
        return {{[=](double t) { return std::sin(omega * t); },
                 harmonic_motion(harmonic, 0.5 * std::numbers::pi)},
                {[=](double t) { return std::cos(omega * t); }, harmonic_motion(harmonic)}};
      },
      motion);
}

}  // namespace stickslip::solver
