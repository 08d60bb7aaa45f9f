// SPDX-License-Identifier: MIT
#include "stickslip/analytic/modal_reaction.hpp"

#include "beam_constants.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"

namespace stickslip::analytic {

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

}  // namespace stickslip::analytic
