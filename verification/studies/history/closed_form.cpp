// SPDX-License-Identifier: MIT
#include <cmath>
#include <utility>

#include "studies/common/problem_parameter.hpp"
#include "studies/history/runs.hpp"

namespace stickslip::studies {

History closed_form_history(const data::Case& problem, const Sampling& sampling,
                            analytic::SteadyPart steady_part, const RowSink& sink) {
  const analytic::StickResponse response(problem.beam, problem.excitation, problem.numerics.modes(),
                                         steady_part);
  const double length = problem.beam.length(), limit = friction_limit(problem);
  History history;
  for_each_row(problem, sampling, [&](long, double time) {
    HistoryRow row{.time = time,
                   .base_displacement = response.base_displacement(time),
                   .tip_displacement = response.absolute_displacement(length, time),
                   .midspan_displacement = response.absolute_displacement(0.5 * length, time),
                   .friction_force = response.friction_force(time)};
    for (const double x : sampling.positions)
      row.displacement.push_back(response.absolute_displacement(x, time));
    if (!history.first_slip && std::abs(row.friction_force) > limit) history.first_slip = time;
    add_row(history, sink, std::move(row));
  });
  return history;
}

}  // namespace stickslip::studies
