// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "stickslip/data/case_file.hpp"

namespace stickslip::testing {

/// A published case with the mesh, the step and the threshold of the paper, with which `compare` runs wrong models
/// of damped cases.
inline data::Case with_the_settings_of_the_paper(const std::string& name) {
  data::Case problem = data::load_case(name);
  data::NumericalChoices choices = data::load_case("paper").numerics.choices();
  choices.duration = problem.numerics.duration();
  problem.numerics = data::NumericalSettings(choices);
  return problem;
}

}  // namespace stickslip::testing
