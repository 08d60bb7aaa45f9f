// SPDX-License-Identifier: MIT
#include "studies/verification/proposed_rig.hpp"

#include <cmath>

#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/data/case_file.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

ProposedRig proposed_rig(const std::string& name) {
  ProposedRig rig;
  const data::Case problem = data::load_case(name);
  data::BeamProperties beam = problem.beam().properties();
  for (const double length : {0.3, 0.4})
    for (const double load : {0.5, 1.0, 2.0, 3.0, 4.0}) {
      beam.length = length;
      beam.axial_force = load;
      const auto first_hz = [&](double direction) {
        beam.axial_direction = direction;
        return analytic::slip_modes(data::Beam(beam), 1).front().frequency_hz();
      };
      const double following = first_hz(0.0), fixed = first_hz(1.0);
      rig.frequencies.push_back(
          {length, load, following, fixed, std::abs(following - fixed) / (2.0 * (following + fixed)),
           problem.contact.friction.static_coefficient() * load / tip_stiffness(data::Beam(beam))});
    }
  for (const double hz : {10.0, 15.0, 20.0, 25.0, 30.0, 35.0, 60.0, 80.0}) {
    const data::Case at_hz = with_value(problem, "excitation.frequency_hz", hz);
    rig.onsets.push_back({hz, analytic::evaluate_criterion(at_hz, 1e-6).critical_amplitude.midpoint()});
  }
  return rig;
}

}  // namespace stickslip::studies
