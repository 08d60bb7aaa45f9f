// SPDX-License-Identifier: MIT
#include "stickslip/analytic/modal_reaction.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "arguments.hpp"
#include "beam_constants.hpp"
#include "chebyshev_table.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"

namespace stickslip::analytic {

namespace {

using Functions = std::vector<double>;

/// 1/(L³ S'''(L)), then Ω_n² and Ω_n² c_n L³/EI by mode, from the beam with L = EI = ρ A = 1.
Functions tabulated_functions(double load_factor, double axial_direction, int modes) {
  const data::Beam beam = dimensionless_beam(load_factor, axial_direction);
  Functions values{1.0 / QuasiStaticShape(beam).third_derivative(1.0)};
  for (const ModalForce& mode : modal_forces(beam, modes)) {
    const double squared = mode.angular_frequency * mode.angular_frequency;
    values.push_back(squared);
    values.push_back(squared * mode.coefficient);
  }
  return values;
}

}  // namespace

std::vector<ModalForce> modal_forces(const data::Beam& beam, int modes) {
  if (beam.shear_stiffness() > 0.0) return timoshenko_reaction(beam, modes).modes;
  std::vector<ModalForce> forces;
  for (const StickMode& mode : stick_modes(beam, modes))
    forces.push_back({mode.angular_frequency(), tip_reaction(beam, mode) * mode.participation()});
  return forces;
}

ModalReaction modal_reaction(const data::Beam& beam, int modes) {
  if (beam.shear_stiffness() > 0.0) return timoshenko_reaction(beam, modes);
  return {.quasi_static = tip_reaction(beam, QuasiStaticShape(beam)), .modes = modal_forces(beam, modes)};
}

ModalReactionTable::ModalReactionTable(double lowest_load_factor, double highest_load_factor, int modes,
                                       double axial_direction)
    : lowest_(lowest_load_factor), highest_(highest_load_factor), axial_direction_(axial_direction) {
  if (!(lowest_ >= 0.0 && lowest_ <= highest_))
    throw wrong_argument("the lowest load factor", lowest_,
                         "at least 0 and at most the highest, " + data::shortest_text(highest_));
  constexpr double rounding = 64.0 * std::numeric_limits<double>::epsilon();
  constexpr std::size_t most_points = 128;
  const auto table =
      ChebyshevTable::of([&](double z, double) { return tabulated_functions(z, axial_direction, modes); },
                         {lowest_, highest_}, {0.0, 0.0},
                         [](Functions largest) {
                           for (double& value : largest) value *= rounding;
                           return largest;
                         },
                         most_points);
  if (!table) throw std::runtime_error("the modes as functions of the load factor did not converge");
  table_ = std::make_shared<const ChebyshevTable>(*table);
}

bool ModalReactionTable::holds(const data::Beam& beam) const {
  const double z = axial_load_factor(beam);
  return z >= lowest_ && z <= highest_ && beam.axial_direction() == axial_direction_ &&
         beam.shear_stiffness() == 0.0;
}

ModalReaction ModalReactionTable::at(const data::Beam& beam) const {
  const double z = axial_load_factor(beam);
  if (!holds(beam))
    throw wrong_argument("the load factor P L^2/EI", z,
                         "in the range of the table, " + data::shortest_text(lowest_) + " ... " +
                             data::shortest_text(highest_) + ", at its axial_direction, " +
                             data::shortest_text(axial_direction_));
  const Functions values = table_->at(z, 0.0);
  const double length = beam.length();
  const double stiffness = bending_stiffness(beam) / (length * length * length);  // EI/L³
  const double frequency = frequency_unit(beam);
  const double slope_share =
      1.0 - axial_direction_ * (1.0 - std::cos(std::sqrt(z)));  // S''' + χ p S' over S'''
  ModalReaction reaction{.quasi_static = stiffness / values[0] * slope_share, .modes = {}};
  reaction.modes.reserve(values.size() / 2);
  for (std::size_t n = 0; n < values.size() / 2; ++n) {
    const double squared = values[1 + 2 * n];
    reaction.modes.push_back({frequency * std::sqrt(squared), stiffness * values[2 + 2 * n] / squared});
  }
  return reaction;
}

}  // namespace stickslip::analytic
