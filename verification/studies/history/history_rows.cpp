// SPDX-License-Identifier: MIT
#include "studies/history/history_rows.hpp"

#include <algorithm>
#include <numbers>

#include "stickslip/analytic/modal_reaction.hpp"

namespace stickslip::studies {

long usual_row_step(const data::Case& problem, double span) {
  constexpr double in_a_base_period = 100.0, in_a_natural_period = 20.0, in_all = 2000.0;
  constexpr long longest = 1'000'000'000;
  const double natural =
      analytic::modal_forces(problem.beam, 1).front().angular_frequency / (2.0 * std::numbers::pi);
  const double rows_per_second = std::max(
      {in_a_base_period * problem.excitation.frequency_hz(), in_a_natural_period * natural, in_all / span});
  const double most = (1.0 + 1e-9) / (rows_per_second * problem.numerics.time_step());
  long usual = 1;
  for (long power = 1; power < longest; power *= 10)
    for (const long step : {power, 2 * power, 5 * power})
      if (static_cast<double>(step) <= most) usual = step;
  return usual;
}

}  // namespace stickslip::studies
