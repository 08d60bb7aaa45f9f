// SPDX-License-Identifier: MIT
#include "studies/criterion/model_form.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "stickslip/analytic/slip_modes.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/criterion/classification.hpp"
#include "studies/criterion/criterion_map.hpp"
#include "studies/criterion/length_force_map.hpp"

namespace stickslip::studies {

namespace {

constexpr double dead_load = 1.0;

struct Maps {
  CriterionMap follower, dead;
};

Maps maps(const data::Case& problem, const MapAxis& x, const MapAxis& y) {
  return {criterion_map(problem, x, y, MapMethod::closed_form),
          criterion_map(with_value(problem, Parameter::axial_direction, dead_load), x, y,
                        MapMethod::closed_form)};
}

AxialDirectionPlane plane(std::string figures, const data::Case& problem, const MapAxis& x,
                          const MapAxis& y) {
  const data::Case dead_case = with_value(problem, Parameter::axial_direction, dead_load);
  const auto [follower, dead] = maps(problem, x, y);
  AxialDirectionPlane plane{.figures = std::move(figures),
                            .problem = problem,
                            .lowest_ratio = std::numeric_limits<double>::infinity(),
                            .slip_buckling_load = analytic::slip_critical_load(dead_case.beam)};
  for (std::size_t i = 0; i < follower.cells.size(); ++i) {
    const CriterionMap::Cell &before = follower.cells[i], &after = dead.cells[i];
    if (!before.force_ratio) continue;
    ++plane.cells;
    if (before.state != after.state) ++plane.flipped;
    const double ratio = *after.force_ratio / *before.force_ratio;
    plane.lowest_ratio = std::min(plane.lowest_ratio, ratio);
    plane.highest_ratio = std::max(plane.highest_ratio, ratio);
    const data::Beam beam =
        with_value(with_value(dead_case, x.parameter, before.x), y.parameter, before.y).beam;
    if (beam.axial_force() >= analytic::slip_critical_load(beam)) ++plane.buckled;
  }
  return plane;
}

MapAxis axis_of(Parameter parameter, std::vector<double> values) {
  return {.parameter = parameter, .values = std::move(values)};
}

}  // namespace

ModelForm model_form(const data::Case& paper, const data::Case& half_stiffness,
                     const data::Case& flat_section, int lengths) {
  const MapAxis frequencies = axis_of(Parameter::frequency, figure12_frequencies());
  const MapAxis amplitudes = axis_of(Parameter::amplitude, figure12_amplitudes());
  ModelForm result{.forces = {},
                   .planes = {plane("10 to 12", paper, frequencies, amplitudes),
                              plane("13", half_stiffness, frequencies, amplitudes),
                              plane("14", flat_section, map_axis(Parameter::length, 0.4, 2.0, lengths, false),
                                    axis_of(Parameter::axial_force, figure14_axial_forces()))}};
  const auto [follower, dead] = maps(paper, frequencies, axis_of(Parameter::amplitude, {1e-3}));
  for (std::size_t i = 0; i < follower.cells.size(); ++i)
    result.forces.push_back(
        {follower.cells[i].x, *dead.cells[i].force_ratio / *follower.cells[i].force_ratio});
  return result;
}

}  // namespace stickslip::studies
