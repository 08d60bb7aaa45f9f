#include "stickslip/studies/criterion_map.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>

#include "parallel.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/solver/beam_simulation.hpp"

namespace stickslip::studies {

namespace {

// |f_max| is proportional to the amplitude, mu_s P to the static coefficient.
bool is_a_factor(Parameter parameter) {
  return parameter == Parameter::amplitude || parameter == Parameter::static_coefficient;
}

bool moves_the_buckling_load_ratio(Parameter parameter) {
  return parameter == Parameter::length || parameter == Parameter::axial_force ||
         parameter == Parameter::youngs_modulus;
}

// How many values of an axis need an evaluation of their own.
std::size_t evaluations_along(const MapAxis& axis) {
  return is_a_factor(axis.parameter) ? 1 : axis.values.size();
}

// |f_max| per metre of amplitude, N/m.
analytic::Bounds unit_force(const data::Case& problem, MapMethod method) {
  const data::HarmonicExcitation unit({.frequency_hz = problem.excitation.frequency_hz(), .amplitude = 1.0});
  if (method == MapMethod::closed_form)
    return analytic::StickResponse(problem.beam, unit, problem.numerics.modes())
        .max_abs_friction_force(problem.numerics.duration());
  const double force = solver::max_abs_friction_force(problem.beam, unit, problem.numerics, problem.damping);
  return {force, force};
}

CriterionMap::Cell cell_of(const data::Case& problem, const std::optional<analytic::Bounds>& force) {
  CriterionMap::Cell cell;
  if (!force) {
    cell.state = CellState::no_stick_state;
    return cell;
  }
  const double limit = problem.friction.static_coefficient() * problem.beam.axial_force();
  const double amplitude = problem.excitation.amplitude();
  cell.force_ratio = amplitude * force->midpoint() / limit;
  cell.state = amplitude * force->lower > limit ? CellState::stick_slip : CellState::stick;
  return cell;
}

}  // namespace

MapAxis map_axis(Parameter parameter, double from, double to, int count, bool logarithmic) {
  MapAxis axis{.parameter = parameter, .values = {}, .logarithmic = logarithmic};
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / (count - 1);
    axis.values.push_back(logarithmic ? from * std::pow(to / from, share) : std::lerp(from, to, share));
  }
  axis.values.back() = to;
  return axis;
}

CriterionMap criterion_map(const data::Case& problem, const MapAxis& x, const MapAxis& y, MapMethod method,
                           const std::function<void(double)>& progress) {
  if (x.parameter == y.parameter)
    throw std::invalid_argument("both axes of the map are " + std::string(field_of(x.parameter)) +
                                ", but must be two parameters");
  const bool may_buckle =
      moves_the_buckling_load_ratio(x.parameter) || moves_the_buckling_load_ratio(y.parameter);
  const auto case_at = [&](std::size_t i, std::size_t j) {
    return with_value(with_value(problem, x.parameter, x.values[i]), y.parameter, y.values[j]);
  };

  require_friction(case_at(0, 0));

  const std::size_t columns = evaluations_along(x), rows = evaluations_along(y);
  std::vector<std::optional<analytic::Bounds>> forces(columns * rows);
  in_parallel(
      forces.size(),
      [&](std::size_t n) {
        const data::Case point = case_at(n % columns, n / columns);
        if (may_buckle && point.beam.axial_force() >= analytic::stick_buckling_load(point.beam)) return;
        analytic::require_contact(point.beam);
        forces[n] = unit_force(point, method);
      },
      progress);

  CriterionMap map{.x = x, .y = y, .cells = {}};
  map.cells.reserve(x.values.size() * y.values.size());
  for (std::size_t j = 0; j < y.values.size(); ++j)
    for (std::size_t i = 0; i < x.values.size(); ++i) {
      map.cells.push_back(
          cell_of(case_at(i, j), forces[(columns > 1 ? i : 0) + columns * (rows > 1 ? j : 0)]));
      map.cells.back().x = x.values[i];
      map.cells.back().y = y.values[j];
    }
  return map;
}

}  // namespace stickslip::studies
