// SPDX-License-Identifier: MIT
#pragma once

/// The critical amplitude of the base over its frequency by each reading of the criterion and in each model, how far
/// the first reading may be trusted between the resonances, and what its uncertainty is made of.

#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "stickslip/data/uncertainty.hpp"
#include "studies/common/members.hpp"
#include "studies/verification/force_maximum.hpp"

namespace stickslip::studies {

/// μ_s P over the largest |f| per unit amplitude, m. The start-ups last numerics.duration() and have numerics.modes().
struct AmplitudeLimit {
  double frequency_hz{};
  double start_up{}, steady{};                ///< without damping
  double damped_start_up{}, damped_steady{};  ///< with the damping of the damped case
  double shear{};            ///< start-up of the beam with shear and rotary inertia (with_shear())
  double fixed_direction{};  ///< start-up under an axial force that keeps its direction
  double compliant{};        ///< start-up on a contact with k_t = AmplitudeLimits::contact_stiffness 3 EI/L³
};
STICKSLIP_MEMBERS(AmplitudeLimit, (frequency_hz, "Hz"), (start_up, "m"), (steady, "m"),
                  (damped_start_up, "m"), (damped_steady, "m"), (shear, "m"), (fixed_direction, "m"),
                  (compliant, "m"))

struct AmplitudeLimits {
  std::vector<AmplitudeLimit> limits;
  double contact_stiffness{};  ///< as above
};
STICKSLIP_MEMBERS(AmplitudeLimits, (limits), (contact_stiffness, "1"))

/// `damped` gives the damping. Uses thread_count() threads; the result does not depend on their number.
[[nodiscard]] AmplitudeLimits amplitude_limits(const data::Case& paper, const data::Case& damped,
                                               const std::vector<double>& frequencies_hz);

/// What one cause does to the critical amplitude of a start-up at one frequency, relative: the most that it takes away,
/// and the most that it adds.
struct AmplitudeChange {
  std::string cause, kind;  ///< kind: "numerical", "input", "model" or "sum"
  double frequency_hz{};
  double fall{}, rise{};
};
STICKSLIP_MEMBERS(AmplitudeChange, (cause, "-"), (kind, "-"), (frequency_hz, "Hz"), (fall, "1"), (rise, "1"))

/// The uncertainty budget at the frequencies of `forces`, which `limits` must have: what finite elements and the truncation to
/// numerics.modes() do to |f_max|, the inputs from their 5 % to their 95 % quantile, together and one by one (slip_uncertainty()
/// with so many samples), each other model, and all together: the falls one on top of the other, and the rises.
[[nodiscard]] std::vector<AmplitudeChange> amplitude_budget(const AmplitudeLimits& limits,
                                                            const std::vector<ForceMaximumStudy>& forces,
                                                            const data::Case& problem,
                                                            const data::Uncertainty& uncertainty,
                                                            std::size_t samples);

}  // namespace stickslip::studies
