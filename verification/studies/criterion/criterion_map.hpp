#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "stickslip/analytic/bounds.hpp"
#include "stickslip/data/problem.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

enum class MapMethod {
  closed_form,     ///< Eq. (28) with numerics.modes() modes, |f_max| to 1e-10; of the undamped beam
  finite_elements  ///< one linear run with the tip bonded, |f_max| over its time steps; with the damping
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
    std::optional<double> force_ratio;  ///< |f_max| / (mu_s P); none without stick state or if not asked for
    CellState state{};                  ///< stick_slip if the ratio is above 1
  };
  MapAxis x, y;
  bool states_only{};
  std::vector<Cell> cells;  ///< x varies fastest
};

/// A map to be computed.
struct MapTask {
  data::Case problem;
  MapAxis x, y;
  MapMethod method{};
  bool states_only{};  ///< leave out the force ratio, and with it what the states do not need
};

/// What one evaluation of the force says of the cells that share it.
struct MapEvaluation {
  std::optional<analytic::Bounds> unit_force;  ///< |f_max| per metre of amplitude, N/m
  CellState state{};                           ///< of the one cell there is, where the force is left out
};

/// The evaluations of a map by their number; empty where none has been made yet.
using MapEvaluations = std::vector<std::optional<MapEvaluation>>;

/// `count` values from `from` to `to`, in equal steps or, if `logarithmic`, in equal ratios; both ends are
/// exact.
[[nodiscard]] MapAxis map_axis(Parameter parameter, double from, double to, int count, bool logarithmic);

/// How many evaluations a map needs. |f_max| is proportional to the amplitude and does not depend on mu_s: an
/// axis of either costs nothing. Throws as criterion_map() does for axes that are refused.
[[nodiscard]] std::size_t evaluation_count(const MapTask& task);

/// The evaluations, ascending, that fall to part 1 ... `parts`, each to one of them. Of as many successive
/// evaluations as there are parts each part gets one, at a place that changes from round to round, so that
/// the parts cost about the same whatever the cost depends on. Throws std::invalid_argument unless
/// 1 <= part <= parts.
[[nodiscard]] std::vector<std::size_t> share_of(std::size_t evaluations, std::size_t part, std::size_t parts);

/// Makes these evaluations on thread_count() threads; the result does not depend on that. `settled`, if
/// given, is told the numbers of those that are new in `evaluations`, one call at a time; what it throws ends
/// the work. `evaluations` has evaluation_count() elements. Throws as criterion_map().
void evaluate(const MapTask& task, std::span<const std::size_t> numbers, MapEvaluations& evaluations,
              const std::function<void(std::span<const std::size_t>)>& settled = {});

/// The map that all its evaluations make. Throws std::invalid_argument if one is missing.
[[nodiscard]] CriterionMap criterion_map(const MapTask& task, const MapEvaluations& evaluations);

/// Evaluates every cell. `progress`, if given, is told the share done.
///
/// Throws std::invalid_argument if both axes are the same parameter or mu_s is 0 somewhere, data::FieldError
/// for a value that its field refuses, and std::domain_error, naming beam.axial_force, if P <= 0 somewhere,
/// or if the beam is buckled and neither axis changes that.
[[nodiscard]] CriterionMap criterion_map(const data::Case& problem, const MapAxis& x, const MapAxis& y,
                                         MapMethod method, const std::function<void(double)>& progress = {});

}  // namespace stickslip::studies
