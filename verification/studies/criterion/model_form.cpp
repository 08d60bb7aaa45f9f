// SPDX-License-Identifier: MIT
#include "studies/criterion/model_form.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "studies/common/parallel.hpp"
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

namespace {

// |f_max| per metre of amplitude, N/m, or nothing if no state of stick is stable.
std::optional<double> unit_force(const data::Case& problem, const ModelVariant& variant) {
  constexpr double width = 1e-6;
  const data::Beam& beam = problem.beam;
  const data::Damping damping({.ratio = variant.damping_ratio});
  const double omega = angular_frequency(problem.excitation), duration = problem.numerics.duration();
  const int modes = problem.numerics.modes();
  if (!std::isfinite(variant.stiffness_ratio))
    return analytic::largest_unit_force(beam, damping, problem.excitation.frequency_hz(), duration, modes,
                                        analytic::SteadyPart::exact, width)
        .midpoint();
  const double stiffness = variant.stiffness_ratio * 3.0 * beam.youngs_modulus() *
                           beam.second_moment_of_area() / std::pow(beam.length(), 3);
  try {
    return analytic::DampedForce(analytic::compliant_reaction(beam, damping, stiffness, modes), omega,
                                 duration)
        .refined_to(width)
        .midpoint();
  } catch (const data::FieldError& error) {
    if (error.field() == "contact.tangential_stiffness") return std::nullopt;
    throw;
  }
}

VariantPlane variant_plane(std::string figures, const ModelVariant& variant, const data::Case& problem,
                           const MapAxis& x, const MapAxis& y) {
  VariantPlane plane{.figures = std::move(figures),
                     .variant = variant,
                     .lowest_ratio = std::numeric_limits<double>::infinity()};
  const bool y_is_factor = y.parameter == Parameter::amplitude;
  const std::size_t rows = y_is_factor ? 1 : y.values.size(), columns = x.values.size();
  struct ForcePair {
    std::optional<double> without, with;
  };
  std::vector<ForcePair> forces(rows * columns);
  const auto case_at = [&](std::size_t i, std::size_t j) {
    return with_value(with_value(problem, x.parameter, x.values[i]), y.parameter, y.values[j]);
  };
  in_parallel(forces.size(), [&](std::size_t index) {
    const data::Case cell = case_at(index % columns, index / columns);
    if (cell.beam.axial_force() >= analytic::stick_buckling_load(cell.beam)) return;
    forces[index] = {unit_force(cell, {}), unit_force(cell, variant)};
  });
  for (std::size_t j = 0; j < y.values.size(); ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const auto& [without, with] = forces[(y_is_factor ? 0 : j) * columns + i];
      if (!without) continue;
      ++plane.cells;
      if (!with) {
        ++plane.unstable;
        continue;
      }
      const data::Case cell = case_at(i, j);
      const double limit =
          cell.friction.static_coefficient() * cell.beam.axial_force() / cell.excitation.amplitude();
      if (*without > limit && *with <= limit) ++plane.to_stick;
      if (*without <= limit && *with > limit) ++plane.to_slip;
      plane.lowest_ratio = std::min(plane.lowest_ratio, *with / *without);
      plane.highest_ratio = std::max(plane.highest_ratio, *with / *without);
    }
  return plane;
}

}  // namespace

std::vector<VariantPlane> variant_planes(const ModelVariant& variant, const data::Case& paper,
                                         const data::Case& half_stiffness, const data::Case& flat_section,
                                         int lengths, std::size_t stride) {
  const MapAxis frequencies = axis_of(Parameter::frequency, figure12_frequencies());
  const MapAxis amplitudes = axis_of(Parameter::amplitude, figure12_amplitudes());
  std::vector<double> axial_forces;
  for (std::size_t i = 0; i < figure14_axial_forces().size(); i += stride)
    axial_forces.push_back(figure14_axial_forces()[i]);
  return {variant_plane("10 to 12", variant, paper, frequencies, amplitudes),
          variant_plane("13", variant, half_stiffness, frequencies, amplitudes),
          variant_plane("14", variant, flat_section, map_axis(Parameter::length, 0.4, 2.0, lengths, false),
                        axis_of(Parameter::axial_force, axial_forces))};
}

}  // namespace stickslip::studies
