// SPDX-License-Identifier: MIT
#include "studies/analyses/criterion_map.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "stickslip/analytic/stick_reaction.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/common/parallel.hpp"

namespace stickslip::studies {

using analytic::Verdict;

namespace {

// Whether the force of a cell is that of another one times the number on this axis.
bool is_load(const data::Case& problem, std::string_view parameter) {
  return analytic::is_proportional_to_scale(problem)
             ? parameter == "excitation.scale"
             : data::state_the_same(parameter, data::amplitude_keys.front());
}

bool either(const MapTask& task, bool data::KeyEffects::*effect) {
  return data::key_named(task.x.parameter).effects.*effect ||
         data::key_named(task.y.parameter).effects.*effect;
}

// Whether the cells have different beams, but for the direction of P. Some of them may be buckled and others not.
bool varies_beam(const MapTask& task) { return either(task, &data::KeyEffects::varies_beam); }

// Whether the modes depend on more than the load factor, or a cell may be damped and another one not.
bool couples_modes(const MapTask& task) { return either(task, &data::KeyEffects::couples_modes); }

// How many values of an axis need separate evaluations of the force.
std::size_t evaluations_along(const MapTask& task, const MapAxis& axis) {
  return is_a_factor(task.problem, axis.parameter) && task.quantities.empty() ? 1 : axis.values.size();
}

data::Case case_at(const MapTask& task, std::size_t i, std::size_t j) {
  return with_value(with_value(task.problem, task.x.parameter, task.x.values[i]), task.y.parameter,
                    task.y.values[j]);
}

// The result of one evaluation of the force, for all cells that share it.
struct MapEvaluation {
  std::optional<analytic::Bounds> unit_force;  // |f_max| per unit of Factors::load
  CellState state{};                           // of the single cell, if the force is not computed
  std::vector<ResponseValue> response{};       // of the quantities
};

// |f_max| at the points of one map. The modes do not depend on which points are evaluated.
class Forces {
 public:
  explicit Forces(const MapTask& task)
      : by_elements_(task.method->basis == Basis::elements), reactions_(task.problem) {
    if (by_elements_) return;
    const auto structures_along = [&](const MapAxis& axis) {
      const auto& effects = data::key_named(axis.parameter).effects;
      return effects.varies_beam || effects.couples_modes ? axis.values.size() : 1;
    };
    const std::size_t structures = structures_along(task.x) * structures_along(task.y);
    if (structures == 1) return;
    std::vector<data::Case> corners;
    for (const std::size_t j : ends_of(task.y))
      for (const std::size_t i : ends_of(task.x)) corners.push_back(case_at(task, i, j));
    reactions_.tabulate(corners, structures);
  }

  // |f_max| per unit of Factors::load.
  [[nodiscard]] analytic::Bounds unit_force(const data::Case& problem) const {
    const bool is_sine = !problem.has(data::Feature::general_motion);
    return (is_sine ? problem.excitation().unit_amplitude() : 1.0) * force_per_load(problem);
  }

  // Whether the tip slips. Far from the friction limit this needs less work than the force itself.
  [[nodiscard]] bool slips(const data::Case& problem) const {
    const double limit = friction_limit(problem), load = analytic::load(problem);
    if (!by_elements_) return load > 0.0 && reactions_.of(problem).exceeds(limit / load);
    return analytic::verdict_of(load * force_per_load(problem), limit) == Verdict::stick_slip;
  }

 private:
  // Per unit of analytic::load().
  [[nodiscard]] analytic::Bounds force_per_load(const data::Case& problem) const {
    if (!by_elements_) return reactions_.of(problem).largest();
    const double force = solver::max_abs_friction_force(analytic::of_unit_load(problem));
    return {force, force};
  }

  static std::array<std::size_t, 2> ends_of(const MapAxis& axis) { return {0, axis.values.size() - 1}; }

  bool by_elements_;
  analytic::StickReactions reactions_;
};

// The quantities of the motion at the points of one map. The modes are computed once if all points have the same beam.
class Responses {
 public:
  explicit Responses(const MapTask& task) : task_(task) {
    if (!varies_beam(task) && !couples_modes(task)) common_.emplace(response_model(case_at(task, 0, 0)));
  }

  [[nodiscard]] MapEvaluation at(const data::Case& point) const {
    MapEvaluation evaluation{.unit_force = {}, .state = Verdict::stick};
    try {
      const ContactResponse response =
          contact_response(point, task_.transient, common_ ? &*common_ : nullptr);
      if (response.slips) evaluation.state = Verdict::stick_slip;
      for (const MotionQuantity* quantity : task_.quantities)
        evaluation.response.push_back(response[*quantity]);
    } catch (const analytic::InseparableModes&) {
      evaluation.response.assign(task_.quantities.size(), {.value = 0.0, .change = 1.0});
    }
    return evaluation;
  }

 private:
  const MapTask& task_;
  std::optional<analytic::ContactModes> common_;
};

// The numbers of a cell that |f_max| is proportional to, or that it is compared with.
struct Factors {
  explicit Factors(const data::Case& of_map)
      : problem(of_map),
        load(of_map.has(data::Feature::general_motion) ? analytic::load(of_map)
                                                       : of_map.excitation().stated()),
        static_coefficient(of_map.contact.friction.static_coefficient()),
        normal_force(of_map.normal_force()) {}

  void set(std::string_view parameter, double value) {
    if (is_load(problem, parameter)) load = value;
    if (parameter == "friction.static_coefficient") static_coefficient = value;
    if (parameter == "beam.axial_force" || parameter == "model.normal_force") normal_force = value;
  }

  const data::Case& problem;
  double load;  // the stated amplitude, or analytic::load()
  double static_coefficient, normal_force;
};

void complete(CriterionMap::Cell& cell, const MapEvaluation& evaluation, const Factors& factors,
              bool states_only) {
  cell.state = evaluation.state;
  cell.response = evaluation.response;
  if (!evaluation.unit_force) return;
  const double limit = factors.static_coefficient * factors.normal_force;
  const double ratio = factors.load * evaluation.unit_force->midpoint() / limit;
  if (!std::isfinite(ratio)) data::throw_overflow("a force ratio of the map is not finite");
  if (!states_only) cell.force_ratio = ratio;
  if (analytic::verdict_of(factors.load * *evaluation.unit_force, limit) == Verdict::stick_slip)
    cell.state = Verdict::stick_slip;
}

// Numbers the evaluations of a map; cells along an axis that needs one evaluation alone share it.
struct EvaluationGrid {
  explicit EvaluationGrid(const MapTask& task)
      : cells_along_x(task.x.values.size()),
        columns(evaluations_along(task, task.x)),
        rows(evaluations_along(task, task.y)) {}

  [[nodiscard]] std::size_t number(std::size_t cell) const {
    return (columns > 1 ? cell % cells_along_x : 0) + columns * (rows > 1 ? cell / cells_along_x : 0);
  }

  // Those that the cells of the part need, in ascending order.
  [[nodiscard]] std::vector<std::size_t> numbers(const MapTask& task) const {
    const auto [first, last] = task.part.of(cells_along_x * task.y.values.size());
    std::vector<bool> is_needed(columns * rows);
    for (std::size_t cell = first; cell < last; ++cell) is_needed[number(cell)] = true;
    std::vector<std::size_t> needed;
    for (std::size_t n = 0; n < is_needed.size(); ++n)
      if (is_needed[n]) needed.push_back(n);
    return needed;
  }

  std::size_t cells_along_x, columns, rows;
};

// These evaluations, each at its number, on thread_count() threads.
std::vector<MapEvaluation> evaluations_of(const MapTask& task, const std::vector<std::size_t>& numbers,
                                          const std::function<void(double)>& progress = {}) {
  const EvaluationGrid grid(task);
  const bool may_be_buckled = varies_beam(task);
  const bool decide_only = task.states_only && !is_a_factor(task.problem, task.x.parameter) &&
                           !is_a_factor(task.problem, task.y.parameter);
  std::optional<Forces> forces;
  std::optional<Responses> responses;
  if (task.quantities.empty())
    forces.emplace(task);
  else
    responses.emplace(task);
  const auto evaluation_at = [&](std::size_t number) -> MapEvaluation {
    const data::Case point = case_at(task, number % grid.columns, number / grid.columns);
    if (may_be_buckled && analytic::is_buckled(point)) return {.unit_force = {}, .state = std::nullopt};
    analytic::require_contact(point);
    if (responses) return responses->at(point);
    if (decide_only)
      return {.unit_force = {}, .state = forces->slips(point) ? Verdict::stick_slip : Verdict::stick};
    return {.unit_force = forces->unit_force(point), .state = Verdict::stick};
  };
  std::vector<MapEvaluation> evaluations(grid.columns * grid.rows);
  in_parallel(
      numbers.size(), [&](std::size_t i) { evaluations[numbers[i]] = evaluation_at(numbers[i]); }, progress);
  return evaluations;
}

void require_axes(const MapTask& task) {
  const data::Case& problem = task.problem;
  const MapAxis &x = task.x, &y = task.y;
  if (data::state_the_same(x.parameter, y.parameter))
    throw data::InputError("both axes of the map are " + std::string(x.parameter) +
                           ", but must be two parameters");
  for (const double value : x.values) (void)with_value(problem, x.parameter, value);
  for (const double value : y.values) (void)with_value(problem, y.parameter, value);
  for (const MotionQuantity* quantity : task.quantities)
    if (quantity->is_of_a_period && problem.has(data::Feature::general_motion)) {
      std::vector<std::string> others;
      for (const MotionQuantity& other : motion_quantities)
        if (!other.is_of_a_period) others.emplace_back(other.name);
      throw data::FieldError("--quantity", std::string(quantity->name),
                             "one of " + data::joined(others) + ": this motion has no period");
    }
  if (task.quantities.empty())
    require_friction(case_at(task, 0, 0));
  else  // the lowest frequency has the longest period
    (void)response_grid(case_at(task, 0, 0), task.transient);
}

struct Seconds {
  double processor{}, wall{};
};

Seconds seconds_for(const MapTask& task, const std::vector<std::size_t>& numbers, unsigned threads) {
  const ScopedThreadCount threads_for_now(threads);
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t processor = std::clock();
  (void)evaluations_of(task, numbers);
  return {static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC,
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()};
}

// Multiples of the golden ratio, modulo 1, are evenly distributed along both axes for any number of them.
std::vector<std::size_t> sample_of(const std::vector<std::size_t>& numbers, std::size_t count) {
  if (count == numbers.size()) return numbers;
  std::vector<std::size_t> sample;
  for (std::size_t i = 0; i < count; ++i)
    sample.push_back(numbers[static_cast<std::size_t>(
        std::fmod(static_cast<double>(i) * std::numbers::phi, 1.0) * static_cast<double>(numbers.size()))]);
  return sample;
}

}  // namespace

MapAxis map_axis(std::string_view parameter, double from, double to, int count, bool logarithmic) {
  MapAxis axis{.parameter = parameter, .values = {}, .logarithmic = logarithmic};
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / (count - 1);
    axis.values.push_back(logarithmic ? from * std::pow(to / from, share) : std::lerp(from, to, share));
  }
  axis.values.back() = to;
  return axis;
}

std::size_t evaluation_count(const MapTask& task) {
  require_axes(task);
  return EvaluationGrid(task).numbers(task).size();
}

CriterionMap criterion_map(const MapTask& task, const std::function<void(double)>& progress) {
  require_axes(task);
  const EvaluationGrid grid(task);
  const std::vector<MapEvaluation> evaluations = evaluations_of(task, grid.numbers(task), progress);
  CriterionMap map{.x = task.x,
                   .y = task.y,
                   .states_only = task.states_only,
                   .quantities = task.quantities,
                   .tolerance = task.tolerance,
                   .part = task.part,
                   .cells = {}};
  const auto [first, last] = task.part.of(task.x.values.size() * task.y.values.size());
  map.cells.resize(last - first);
  Factors factors(task.problem);
  for (std::size_t n = first; n < last; ++n) {
    CriterionMap::Cell& cell = map.cells[n - first];
    cell.x = task.x.values[n % grid.cells_along_x];
    cell.y = task.y.values[n / grid.cells_along_x];
    factors.set(task.x.parameter, cell.x);
    factors.set(task.y.parameter, cell.y);
    complete(cell, evaluations[grid.number(n)], factors, task.states_only);
  }
  return map;
}

std::vector<Warning> map_warnings(const MapTask& task) {
  auto warnings = warnings_common_to(task.problem, {task.x.parameter, task.y.parameter});
  if (!task.quantities.empty()) return warnings;
  const auto warning_at = task.method->basis == Basis::elements ? coarse_mesh_warning : few_modes_warning;
  const std::size_t last_x = task.x.values.size() - 1, last_y = task.y.values.size() - 1;
  for (const auto& [i, j] : {std::pair(last_x, last_y), {last_x, 0}, {0, last_y}, {0, 0}})
    if (const auto warning = warning_at(case_at(task, i, j))) {
      warnings.push_back(*warning);
      break;
    }
  return warnings;
}

MapEstimate map_estimate(const MapTask& task) {
  require_axes(task);
  const std::vector<std::size_t> numbers = EvaluationGrid(task).numbers(task);
  if (numbers.empty()) throw std::invalid_argument("this part of the map has no cell");
  constexpr double enough = 0.5, least = 1e-6;  // s
  const Seconds preparation = seconds_for(task, {}, 1);
  MapEstimate estimate{.evaluations = numbers.size(), .threads = thread_count(), .speedup = 1.0};
  for (std::size_t count = std::min<std::size_t>(numbers.size(), std::size_t{4} * thread_count());;
       count = std::min(2 * count, numbers.size())) {
    const auto sample = sample_of(numbers, count);
    const Seconds one = seconds_for(task, sample, 1);
    if (one.processor < enough && sample.size() < numbers.size()) continue;
    const auto net = [&](double seconds, double prepared) { return std::max(seconds - prepared, least); };
    estimate.sample = sample.size();
    estimate.seconds_each = net(one.processor, preparation.processor) / static_cast<double>(sample.size());
    if (thread_count() > 1)
      estimate.speedup = net(one.wall, preparation.wall) /
                         net(seconds_for(task, sample, thread_count()).wall, preparation.wall);
    return estimate;
  }
}

}  // namespace stickslip::studies
