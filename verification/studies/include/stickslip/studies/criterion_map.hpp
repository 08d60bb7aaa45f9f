#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "stickslip/studies/problem_parameter.hpp"

namespace stickslip::studies {

enum class MapMethod {
  closed_form,     ///< Eq. (28) with numerics.modes() modes, |f_max| to 1e-10; of the undamped beam
  finite_elements  ///< one linear run with the tip glued, |f_max| over its time steps; with the damping
};

enum class CellState {
  stick,
  stick_slip,
  no_stick_state  ///< P is at or over the buckling load 20.19 EI/L^2 of the clamped-pinned beam
};

/// What one axis of a map varies, and over which values, ascending.
struct MapAxis {
  Parameter parameter{};
  std::vector<double> values;  ///< SI units
  bool logarithmic{};          ///< in equal ratios, not in equal steps
};

/// The criterion of Eqs. (29), (30) over two parameters of a case.
struct CriterionMap {
  struct Cell {
    double x{}, y{};
    std::optional<double> force_ratio;  ///< |f_max| / (mu_s P); none without stick state
    CellState state{};                  ///< stick_slip if the ratio is above 1
  };
  MapAxis x, y;
  std::vector<Cell> cells;  ///< x varies fastest
};

/// `count` values from `from` to `to`, in equal steps or, if `logarithmic`, in equal ratios; both ends are
/// exact.
[[nodiscard]] MapAxis map_axis(Parameter parameter, double from, double to, int count, bool logarithmic);

/// Evaluates every cell. |f_max| is proportional to the amplitude and does not depend on mu_s: an axis of
/// either costs nothing. Uses two threads; the result does not depend on that. `progress`, if given, is told
/// the share done.
///
/// Throws std::invalid_argument if both axes are the same parameter or mu_s is 0 somewhere, data::FieldError
/// for a value that its field refuses, and std::domain_error, naming beam.axial_force, if P <= 0 somewhere,
/// or if the beam is buckled and neither axis changes that.
[[nodiscard]] CriterionMap criterion_map(const data::Case& problem, const MapAxis& x, const MapAxis& y,
                                         MapMethod method, const std::function<void(double)>& progress = {});

}  // namespace stickslip::studies
