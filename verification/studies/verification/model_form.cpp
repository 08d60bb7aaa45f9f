// SPDX-License-Identifier: MIT
#include "studies/verification/model_form.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/held_beam.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "studies/analyses/criterion_map.hpp"
#include "studies/analyses/length_force_map.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/verification/classification.hpp"

namespace stickslip::studies {

namespace {

// Counts a cell by |f_max|/(μ_s P) in the model of the paper and in the other one.
void count_cell(ModelPlane& plane, const std::optional<double>& paper, const std::optional<double>& other) {
  if (!paper) return;
  if (!other) {
    ++plane.lost;
    return;
  }
  ++plane.cells;
  if (*paper > 1.0 && *other <= 1.0) ++plane.to_stick;
  if (*paper <= 1.0 && *other > 1.0) ++plane.to_slip;
  plane.lowest_ratio = std::min(plane.lowest_ratio, *other / *paper);
  plane.highest_ratio = std::max(plane.highest_ratio, *other / *paper);
}

void count_cells(ModelPlane& plane, const CriterionMap& paper, const CriterionMap& other) {
  for (std::size_t i = 0; i < paper.cells.size(); ++i)
    count_cell(plane, paper.cells[i].force_ratio, other.cells[i].force_ratio);
}

MapAxis axis_of(std::string_view parameter, std::vector<double> values) {
  return {.parameter = parameter, .values = std::move(values)};
}

// The plane of a figure of the paper.
struct FigurePlane {
  std::string figures;
  data::Case problem;
  MapAxis x, y;
};

// Of Fig. 14 every `stride`-th axial force.
std::vector<FigurePlane> figure_planes(const data::Case& paper, const data::Case& half_stiffness,
                                       const data::Case& flat_section, int lengths, std::size_t stride) {
  const MapAxis frequencies = axis_of("excitation.frequency_hz", figure12_frequencies());
  const MapAxis amplitudes = axis_of("excitation.amplitude", figure12_amplitudes());
  const std::vector<double> all = figure14_axial_forces();
  std::vector<double> axial_forces;
  for (std::size_t i = 0; i < all.size(); i += stride) axial_forces.push_back(all[i]);
  return {{"10 to 12", paper, frequencies, amplitudes},
          {"13", half_stiffness, frequencies, amplitudes},
          {"14", flat_section, map_axis("beam.length", 0.4, 2.0, lengths, false),
           axis_of("beam.axial_force", axial_forces)}};
}

data::Case with_dead_load(const data::Case& problem) {
  return with_value(problem, "beam.axial_direction", 1.0);
}

ModelPlane direction_plane(const FigurePlane& figure, const CriterionMap& follower) {
  const data::Case dead = with_dead_load(figure.problem);
  ModelPlane plane{.figures = figure.figures};
  count_cells(plane, follower, criterion_map({.problem = dead, .x = figure.x, .y = figure.y}));
  for (const CriterionMap::Cell& cell : follower.cells) {
    const data::Beam beam =
        with_value(with_value(dead, figure.x.parameter, cell.x), figure.y.parameter, cell.y).beam();
    if (cell.force_ratio && beam.axial_force() >= analytic::slip_critical_load(beam)) ++plane.buckled;
  }
  return plane;
}

// |f_max| per metre of amplitude, N/m, or nothing if no state of stick is stable.
std::optional<double> unit_force(const data::Case& problem, const ModelVariant& variant) {
  constexpr double bound_width = 1e-6;
  const data::Beam& beam = problem.beam();
  const data::Damping damping({.ratio = variant.damping_ratio});
  const double omega = angular_frequency(problem.excitation()), duration = problem.numerics.duration();
  const int modes = problem.numerics.modes();
  if (!std::isfinite(variant.stiffness_ratio) && damping.is_none()) {
    const data::HarmonicExcitation unit(
        {.frequency_hz = problem.excitation().frequency_hz(), .amplitude = 1.0});
    return analytic::StickResponse(beam, unit, modes, analytic::SteadyPart::exact)
        .max_abs_friction_force(duration, bound_width)
        .midpoint();
  }
  const double stiffness = variant.stiffness_ratio * tip_stiffness(beam);
  try {
    const analytic::DampedReaction reaction =
        std::isfinite(stiffness)
            ? analytic::compliant_reaction(analytic::HeldBeam(beam, damping, modes).structure(), stiffness)
            : analytic::damped_reaction(analytic::HeldBeam(beam, damping, modes).structure(),
                                        analytic::SteadyPart::exact);
    return analytic::DampedForce(reaction, omega, duration).refined_to(bound_width).midpoint();
  } catch (const data::FieldError& error) {
    if (error.field() == "contact.tangential_stiffness") return std::nullopt;
    throw;
  }
}

ModelPlane variant_plane(const FigurePlane& figure, const ModelVariant& variant) {
  const MapAxis &x = figure.x, &y = figure.y;
  ModelPlane plane{.figures = figure.figures, .variant = variant};
  const bool y_is_factor = y.parameter == "excitation.amplitude";
  const std::size_t rows = y_is_factor ? 1 : y.values.size(), columns = x.values.size();
  const auto case_at = [&](std::size_t i, std::size_t j) {
    return with_value(with_value(figure.problem, x.parameter, x.values[i]), y.parameter, y.values[j]);
  };
  struct ForcePair {
    std::optional<double> paper, other;
  };
  std::vector<ForcePair> forces(rows * columns);
  in_parallel(forces.size(), [&](std::size_t index) {
    const data::Case cell = case_at(index % columns, index / columns);
    if (cell.beam().axial_force() >= analytic::stick_buckling_load(cell.beam())) return;
    forces[index] = {unit_force(cell, {}), unit_force(cell, variant)};
  });
  for (std::size_t j = 0; j < y.values.size(); ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      auto [without, with] = forces[(y_is_factor ? 0 : j) * columns + i];
      const data::Case cell = case_at(i, j);
      const double unit_ratio = cell.excitation().amplitude() / friction_limit(cell);
      if (without) *without *= unit_ratio;
      if (with) *with *= unit_ratio;
      count_cell(plane, without, with);
    }
  return plane;
}

}  // namespace

ModelForm model_form(const data::Case& paper, const data::Case& half_stiffness,
                     const data::Case& flat_section, int lengths) {
  ModelForm result;
  for (const FigurePlane& figure : figure_planes(paper, half_stiffness, flat_section, lengths, 1)) {
    const CriterionMap slender = criterion_map({.problem = figure.problem, .x = figure.x, .y = figure.y});
    result.planes.push_back(direction_plane(figure, slender));
    const data::Case sheared = with(figure.problem, with_shear(figure.problem.beam()));
    count_cells(result.shear.emplace_back(ModelPlane{.figures = figure.figures}), slender,
                criterion_map({.problem = sheared, .x = figure.x, .y = figure.y}));
  }
  const auto over_frequencies = [](const data::Case& problem) {
    return criterion_map({.problem = problem,
                          .x = axis_of("excitation.frequency_hz", figure12_frequencies()),
                          .y = axis_of("excitation.amplitude", {1e-3})});
  };
  const CriterionMap follower = over_frequencies(paper), dead = over_frequencies(with_dead_load(paper));
  for (std::size_t i = 0; i < follower.cells.size(); ++i)
    result.forces.push_back(
        {follower.cells[i].x, *dead.cells[i].force_ratio / *follower.cells[i].force_ratio});
  return result;
}

std::vector<ModelPlane> variant_planes(const ModelVariant& variant, const data::Case& paper,
                                       const data::Case& half_stiffness, const data::Case& flat_section,
                                       int lengths, std::size_t stride) {
  std::vector<ModelPlane> planes;
  for (const FigurePlane& figure : figure_planes(paper, half_stiffness, flat_section, lengths, stride))
    planes.push_back(variant_plane(figure, variant));
  return planes;
}

}  // namespace stickslip::studies
