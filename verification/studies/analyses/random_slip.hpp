// SPDX-License-Identifier: MIT
#pragma once

/// Whether a contact slips under stationary random motions.

#include <cstddef>
#include <functional>

#include "stickslip/analytic/random_reaction.hpp"
#include "studies/analyses/sampling.hpp"

namespace stickslip::studies {

struct RandomSlip {
  analytic::RandomReaction reaction;  ///< with numerics.modes
  double deviation_of_more_modes{};   ///< N, with twice as many, or all there are
  std::size_t samples{}, slips{};  ///< realisations, and those whose |f| exceeds μ_s P within the duration
  Estimate probability;            ///< of slip, from them
};

/// Realisations have the seeds of the case and the numbers from 0 on more. `samples` = 0: as many as have 10⁸ instants together, 10 to 1000.
/// On thread_count() threads; the result does not depend on their number. Throws what analytic::random_reaction() throws.
[[nodiscard]] RandomSlip random_slip(const data::Case& problem, std::size_t samples,
                                     const std::function<void(double)>& progress = {});

}  // namespace stickslip::studies
