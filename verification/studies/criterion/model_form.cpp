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

// The cells with another verdict, the range of the ratio of |f_max|, and the cells that lose their stick state.
ShearPlane change(std::string figures, const CriterionMap& before, const CriterionMap& after) {
  ShearPlane plane{.figures = std::move(figures), .lowest_ratio = std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < before.cells.size(); ++i) {
    if (!before.cells[i].force_ratio) continue;
    if (!after.cells[i].force_ratio) {
      ++plane.buckled;
      continue;
    }
    ++plane.cells;
    if (before.cells[i].state != after.cells[i].state) ++plane.flipped;
    const double ratio = *after.cells[i].force_ratio / *before.cells[i].force_ratio;
    plane.lowest_ratio = std::min(plane.lowest_ratio, ratio);
    plane.highest_ratio = std::max(plane.highest_ratio, ratio);
  }
  return plane;
}

CriterionMap map_of(const data::Case& problem, const MapAxis& x, const MapAxis& y) {
  return criterion_map(problem, x, y, MapMethod::closed_form);
}

AxialDirectionPlane direction_plane(const std::string& figures, const data::Case& problem,
                                    const CriterionMap& follower) {
  const data::Case dead_case = with_value(problem, Parameter::axial_direction, dead_load);
  const MapAxis &x = follower.x, &y = follower.y;
  const ShearPlane compared = change(figures, follower, map_of(dead_case, x, y));
  AxialDirectionPlane plane{.figures = figures,
                            .problem = problem,
                            .cells = compared.cells,
                            .flipped = compared.flipped,
                            .lowest_ratio = compared.lowest_ratio,
                            .highest_ratio = compared.highest_ratio,
                            .slip_buckling_load = analytic::slip_critical_load(dead_case.beam)};
  for (const CriterionMap::Cell& cell : follower.cells) {
    const data::Beam beam = with_value(with_value(dead_case, x.parameter, cell.x), y.parameter, cell.y).beam;
    if (cell.force_ratio && beam.axial_force() >= analytic::slip_critical_load(beam)) ++plane.buckled;
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
  ModelForm result;
  const auto add_plane = [&](const std::string& figures, const data::Case& problem, const MapAxis& x,
                             const MapAxis& y) {
    const CriterionMap slender = map_of(problem, x, y);
    result.planes.push_back(direction_plane(figures, problem, slender));
    data::Case sheared = problem;
    sheared.beam = with_shear(problem.beam);
    result.shear.push_back(change(figures, slender, map_of(sheared, x, y)));
  };
  add_plane("10 to 12", paper, frequencies, amplitudes);
  add_plane("13", half_stiffness, frequencies, amplitudes);
  add_plane("14", flat_section, map_axis(Parameter::length, 0.4, 2.0, lengths, false),
            axis_of(Parameter::axial_force, figure14_axial_forces()));
  const MapAxis one = axis_of(Parameter::amplitude, {1e-3});
  const CriterionMap follower = map_of(paper, frequencies, one);
  const CriterionMap dead =
      map_of(with_value(paper, Parameter::axial_direction, dead_load), frequencies, one);
  for (std::size_t i = 0; i < follower.cells.size(); ++i)
    result.forces.push_back(
        {follower.cells[i].x, *dead.cells[i].force_ratio / *follower.cells[i].force_ratio});
  return result;
}

}  // namespace stickslip::studies
