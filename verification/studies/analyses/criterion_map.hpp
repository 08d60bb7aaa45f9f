// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/data/problem.hpp"
#include "studies/analyses/contact_response.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// The state of a cell of the map; nothing if P is not below the buckling load 20.19 EI/L² of the clamped-pinned beam.
using CellState = std::optional<analytic::Verdict>;
/// "stick", "stick-slip" or "no stick state".
[[nodiscard]] inline std::string_view name_of(const CellState& state) noexcept {
  return state ? to_string(*state) : "no stick state";
}

/// The key that an axis of a map varies, "beam.length", and its values in ascending order.
struct MapAxis {
  std::string_view parameter;
  std::vector<double> values;  ///< SI units
  bool logarithmic{};          ///< in equal ratios; otherwise in equal steps
};

/// Part `part` of `parts` of a sequence: so many elements one after another. The parts in their order make the whole.
struct MapPart {
  std::size_t part{1}, parts{1};

  /// Its first element and the one behind its last, of `count` in all.
  [[nodiscard]] std::pair<std::size_t, std::size_t> of(std::size_t count) const {
    return {count * (part - 1) / parts, count * part / parts};
  }
};

/// The criterion of Eqs. (29), (30) over two parameters of a case.
struct CriterionMap {
  struct Cell {
    double x{}, y{};
    /// |f_max| / (μ_s P); empty without a stick state or if not asked for.
    std::optional<double> force_ratio;
    /// Stick-slip if the ratio is above 1 or, with quantities, if the tip slips after the transient.
    CellState state{};
    std::vector<ResponseValue> response;  ///< of the quantities; empty without a stick state
  };
  MapAxis x, y;
  bool states_only{};
  std::vector<const MotionQuantity*> quantities;
  double tolerance{};
  MapPart part;
  std::vector<Cell> cells;  ///< of the part; x varies fastest
};
STICKSLIP_MEMBERS(CriterionMap::Cell, (x), (y), (force_ratio, "1"), (state, "-"))
STICKSLIP_MEMBERS(CriterionMap, (cells))

struct MapTask {
  data::Case problem;
  MapAxis x, y;
  /// Of |f_max|: closed_form(), Eq. (28) with numerics.modes() modes and the damping of the case, to 1e-10; or
  /// finite_elements(), one linear run with a bonded tip, over its time steps.
  const Method* method{&closed_form()};
  bool states_only{};  ///< compute the states only, without the force ratio
  /// What to map in place of the criterion; empty for the criterion.
  std::vector<const MotionQuantity*> quantities{};
  double transient{};  ///< that the quantities leave out, s
  double tolerance{};  ///< the largest ResponseValue::change of a value that counts as converged
  MapPart part{};      ///< of the cells
};

/// An axis of `count` values from `from` to `to`, in equal steps or, if `logarithmic`, in equal ratios. The
/// first and the last value are exact.
[[nodiscard]] MapAxis map_axis(std::string_view parameter, double from, double to, int count,
                               bool logarithmic);

/// The number of evaluations that a part needs. |f_max| is proportional to the amplitude and does not depend
/// on μ_s, so that the cells along an axis of either parameter share one evaluation; a quantity of the motion has one
/// for each cell. Throws what criterion_map() throws for axes that are not allowed.
[[nodiscard]] std::size_t evaluation_count(const MapTask& task);

/// Makes the cells of the part on thread_count() threads; they do not depend on the number of threads. `progress`, if given, receives
/// the fraction of the evaluations that is done.
///
/// Throws std::invalid_argument if both axes are the same parameter or μ_s is 0 somewhere, data::FieldError
/// for a value that its field refuses, and data::InputError, naming beam.axial_force, if P ≤ 0 somewhere,
/// or if the beam is buckled and neither axis is a number of it.
[[nodiscard]] CriterionMap criterion_map(const MapTask& task,
                                         const std::function<void(double)>& progress = {});

/// warnings_common_to() all cells, and few_modes_warning() of a closed form, coarse_mesh_warning() of finite elements, of the
/// first corner that has it, the one with the highest values before the others.
[[nodiscard]] std::vector<Warning> map_warnings(const MapTask& task);

/// What evaluations of a map cost, from a sample that was timed.
struct MapEstimate {
  std::size_t evaluations{}, sample{};
  double seconds_each{};  ///< processor time on one thread, without the preparation that all share
  unsigned threads{};     ///< thread_count()
  double speedup{};       ///< of the sample on that many threads over one, by the clock on the wall

  [[nodiscard]] double core_hours() const { return static_cast<double>(evaluations) * seconds_each / 3600.0; }
  [[nodiscard]] double hours() const { return core_hours() / speedup; }
};

/// Times a sample of the evaluations of the part, evenly distributed, on one thread and then on thread_count(). On one thread
/// the sample takes half a second of processor time or more, unless it is all of them. Throws what criterion_map() throws, and
/// std::invalid_argument for a part without a cell.
[[nodiscard]] MapEstimate map_estimate(const MapTask& task);

}  // namespace stickslip::studies
