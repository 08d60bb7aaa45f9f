// SPDX-License-Identifier: MIT
#include "stickslip/analytic/modal_reaction.hpp"

#include "beam_constants.hpp"
#include "stickslip/analytic/stick_modes.hpp"

namespace stickslip::analytic {

std::vector<ModalForce> modal_forces(const data::Beam& beam, int modes) {
  std::vector<ModalForce> forces;
  for (const StickMode& mode : stick_modes(beam, modes))
    forces.push_back({mode.angular_frequency(), tip_reaction(beam, mode) * mode.participation()});
  return forces;
}

ModalReaction modal_reaction(const data::Beam& beam, int modes) {
  return {.quasi_static = tip_reaction(beam, QuasiStaticShape(beam)), .modes = modal_forces(beam, modes)};
}

}  // namespace stickslip::analytic
