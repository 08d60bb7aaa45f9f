// SPDX-License-Identifier: MIT
#include "studies/analyses/random_slip.hpp"

#include <algorithm>
#include <atomic>

#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

RandomSlip random_slip(const data::Case& problem, std::size_t samples,
                       const std::function<void(double)>& progress) {
  const int modes = problem.numerics.modes();
  const double limit = friction_limit(problem);
  RandomSlip slip{.reaction = analytic::random_reaction(problem, modes),
                  .deviation_of_more_modes = analytic::random_reaction(problem, 2 * modes).deviation,
                  .samples = samples,
                  .probability = {}};
  const analytic::RandomRealisations realisations(problem, modes);
  if (samples == 0) slip.samples = std::clamp<std::size_t>(100'000'000 / realisations.instants(), 10, 1000);
  std::atomic<std::size_t> slips{};
  in_parallel(
      slip.samples, [&](std::size_t i) { slips += realisations.largest(i) > limit ? 1 : 0; }, progress);
  slip.slips = slips;
  slip.probability = probability_of(slip.slips, slip.samples);
  return slip;
}

}  // namespace stickslip::studies
