// SPDX-License-Identifier: MIT
#pragma once

/// Other forms of the model of the slider, by simulation.

#include "validation/experiments.hpp"

namespace stickslip::validation {

/// Friction that falls with the sliding speed, mu_k + excess exp(-decay |v|), decay in s/m; a contact spring k_t in N/m,
/// infinite for a rigid contact.
struct FrictionForm {
  double kinetic{};
  double excess{};
  double decay{};
  double contact_stiffness{};
};

/// The force of the spring in parts of the weight over 40 periods 2 pi/omega after 20, 200 samples each: event-driven without
/// a time step. The contact must be rigid.
[[nodiscard]] Record event_driven_record(const Slider& slider, const FrictionForm& form);

/// The same by generalised-alpha, 2000 steps for each 2 pi/omega.
[[nodiscard]] Record time_stepped_record(const Slider& slider, const FrictionForm& form);

/// The mean period of such a record, s; not a number if it moves by less than a thousandth of the weight.
[[nodiscard]] double period_of(const Record& record);

}  // namespace stickslip::validation
