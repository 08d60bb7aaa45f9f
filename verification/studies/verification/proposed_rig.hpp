// SPDX-License-Identifier: MIT
#pragma once

/// What to measure on the rig of a case, and how accurately, to validate the beam in stick and in stick-slip.

#include <string>
#include <vector>

#include "studies/common/members.hpp"
#include "studies/verification/force_maximum.hpp"

namespace stickslip::studies {

struct ProposedRig {
  /// The first frequency with the tip free, if the axial force follows the tip and if it keeps its direction. Two intervals ± 2 u
  /// of them do not meet if the relative standard uncertainty u is below `accuracy`, |f_1 - f_2|/(2 (f_1 + f_2)).
  struct Frequency {
    double length{}, load{}, following_hz{}, fixed_hz{}, accuracy{};
    double held{};  ///< deflection up to which friction on the plate holds the tip, m: μ_s P L³/(3 E I)
  };
  std::vector<Frequency> frequencies;          ///< two lengths, five loads
  std::vector<CriticalAmplitudePoint> onsets;  ///< of slip, at eight excitation frequencies
};

/// Throws what data::load_case() and the criterion throw.
[[nodiscard]] ProposedRig proposed_rig(const std::string& name);

STICKSLIP_MEMBERS(ProposedRig::Frequency, (length, "m"), (load, "N"), (following_hz, "Hz"), (fixed_hz, "Hz"),
                  (accuracy, "1"), (held, "m"))
STICKSLIP_MEMBERS(ProposedRig, (frequencies), (onsets))

}  // namespace stickslip::studies
