// SPDX-License-Identifier: MIT
#pragma once

/// The paper's case, and the verdicts of both implementations on an excitation.

#include <algorithm>
#include <cmath>
#include <string>

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/paper.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "support/beams.hpp"

namespace stickslip::testing {

inline const data::Case& paper() {
  static const data::Case instance = data::load_case("paper");
  return instance;
}

inline data::HarmonicExcitation excitation(double hz, double amplitude) { return shaking(hz, amplitude); }

inline double length() { return paper().beam().length(); }
inline double axial_force() { return paper().beam().axial_force(); }
inline double bending_stiffness() {
  return paper().beam().youngs_modulus() * paper().beam().second_moment_of_area();
}
inline double mass_per_length() { return paper().beam().density() * paper().beam().area(); }
inline double friction_limit() {
  return paper().contact.friction.static_coefficient() * axial_force();
}  ///< mu_s P
inline double mm(double metres) { return 1e3 * metres; }

/// A printed number, as far as its last digit tells.
inline bool is_printed(const std::string& id, double value) {
  const data::PrintedNumber printed = data::printed_number(id);
  return std::abs(value - printed.value) <= printed.half_digit;
}

/// Eqs. (29), (30), with Eq. (28).
inline bool criterion_slips(double hz, double amplitude) {
  return analytic::evaluate_criterion(with(paper(), excitation(hz, amplitude))).verdict ==
         analytic::Verdict::stick_slip;
}

/// A run of finite elements with the settings of the paper.
inline solver::BeamSimulation run_at(double hz, double amplitude, const solver::RunOptions& options = {}) {
  return solver::BeamSimulation(with(paper(), excitation(hz, amplitude)), options);
}

/// How often the tip has come to stick again.
inline int captures(const solver::BeamSimulation& run) {
  return static_cast<int>(std::ranges::count(run.integrator().events(), data::ContactChange::capture,
                                             &data::ContactEvent::change));
}

/// Finite elements with contact.
inline bool finite_elements_slip(double hz, double amplitude) {
  return solver::first_slip(with(paper(), excitation(hz, amplitude))).has_value();
}

inline bool both_slip(double hz, double amplitude) {
  return criterion_slips(hz, amplitude) && finite_elements_slip(hz, amplitude);
}
inline bool both_stick(double hz, double amplitude) {
  return !criterion_slips(hz, amplitude) && !finite_elements_slip(hz, amplitude);
}

}  // namespace stickslip::testing
