// SPDX-License-Identifier: MIT
#include "stickslip/certified/criterion.hpp"

#include <stdexcept>

namespace stickslip::certified {

std::string_view to_string(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::stick:
      return "stick";
    case Verdict::stick_slip:
      return "stick-slip";
    case Verdict::undecided:
      break;
  }
  return "undecided";
}

Criterion evaluate_criterion(const Beam& beam, const Rational& static_coefficient,
                             const Excitation& excitation, const Rational& duration, int modes) {
  if (beam.data().axial_force.sign() <= 0)
    throw std::invalid_argument(error_message("beam.axial_force", beam.data().axial_force,
                                              "positive, to press the tip against the wall"));
  if (static_coefficient.sign() < 0)
    throw std::invalid_argument(
        error_message("friction.static_coefficient", static_coefficient, "0 or more"));
  if (excitation.amplitude.sign() <= 0)
    throw std::invalid_argument(error_message("excitation.amplitude", excitation.amplitude, "positive"));

  Criterion criterion;
  criterion.force_max = max_abs_friction_force(beam, excitation, duration, modes);
  criterion.friction_limit = Real(static_coefficient) * beam.axial_force();
  criterion.critical_amplitude =
      criterion.friction_limit * Real(excitation.amplitude) / criterion.force_max.value;
  criterion.verdict = criterion.force_max.value <= criterion.friction_limit  ? Verdict::stick
                      : criterion.force_max.value > criterion.friction_limit ? Verdict::stick_slip
                                                                             : Verdict::undecided;
  return criterion;
}

}  // namespace stickslip::certified
