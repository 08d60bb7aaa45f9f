// SPDX-License-Identifier: MIT
#include "studies/analyses/contact_response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/data/input_error.hpp"
#include "studies/analyses/slip_readouts.hpp"

namespace stickslip::studies {

namespace {

using Sample = std::vector<std::complex<double>>;

constexpr double rounding = 1e-9;  // of a number of periods or steps

double squared_distance(const Sample& a, const Sample& b) {
  double sum = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += std::norm(a[k] - b[k]);
  return sum;
}

// The largest squared distance of a sample from the one so many later.
double squared_return(std::span<const Sample> samples, std::size_t period) {
  double largest = 0.0;
  for (std::size_t n = 0; n + period < samples.size(); ++n)
    largest = std::max(largest, squared_distance(samples[n], samples[n + period]));
  return largest;
}

// What adds up over steps, or is the largest.
struct Sums {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  std::size_t slip_steps{}, onsets{}, captures{}, doubtful{};
  double peak_speed{}, squares{}, travel{}, work{}, largest_force{};
  double least{infinity}, largest{-infinity};  // z
  std::vector<double> places{};                // z of the rows

  void add(const Sums& other) {
    slip_steps += other.slip_steps;
    onsets += other.onsets;
    captures += other.captures;
    doubtful += other.doubtful;
    peak_speed = std::max(peak_speed, other.peak_speed);
    squares += other.squares;
    travel += other.travel;
    work += other.work;
    largest_force = std::max(largest_force, other.largest_force);
    least = std::min(least, other.least);
    largest = std::max(largest, other.largest);
    places.insert(places.end(), other.places.begin(), other.places.end());
  }
};

// One period of the base motion, in which the tip moves from `place`, with a row each so many steps.
Sums period_of_motion(analytic::ModalContactRun& run, int steps, int row_step, double& place) {
  Sums sums;
  double before = run.sliding_velocity();
  bool slipped = run.slips();
  for (int n = 0; n < steps; ++n) {
    run.step();
    const double after = run.sliding_velocity(), mean = 0.5 * (before + after), force = run.friction_force();
    sums.slip_steps += run.slips() ? 1 : 0;
    sums.onsets += !slipped && run.slips() ? 1 : 0;
    sums.captures += slipped && !run.slips() ? 1 : 0;
    sums.doubtful += run.may_hide_stick() ? 1 : 0;
    sums.peak_speed = std::max(sums.peak_speed, std::abs(after));
    sums.squares += after * after;
    sums.travel += std::abs(mean);
    sums.work -= force * mean;
    sums.largest_force = std::max(sums.largest_force, std::abs(force));
    place += mean * run.time_step();
    sums.least = std::min(sums.least, place);
    sums.largest = std::max(sums.largest, place);
    if (n % row_step == 0) sums.places.push_back(place);
    before = after;
    slipped = run.slips();
  }
  sums.travel *= run.time_step();
  sums.work *= run.time_step();
  return sums;
}

// What sums are over.
struct Extent {
  double periods{}, steps{}, time_step{};
};

MotionValues values_of(Sums sums, std::span<const Sample> samples, const Extent& extent) {
  const auto [periods, steps, time_step] = extent;
  const double duration = steps * time_step;
  const auto [distance_95, distance_99] = distance_percentiles(std::move(sums.places));
  return {.slip_share = static_cast<double>(sums.slip_steps) / steps,
          .peak_speed = sums.peak_speed,
          .rms_speed = std::sqrt(sums.squares / steps),
          .travel = sums.travel / periods,
          .work = sums.work / periods,
          .largest_force = sums.largest_force,
          .sticks = static_cast<double>(sums.captures) / periods,
          .period = samples.empty() ? 0.0 : static_cast<double>(period_of(samples)),
          .travel_rate = sums.travel / duration,
          .power = sums.work / duration,
          .slip_rate = static_cast<double>(sums.onsets) / duration,
          .slips_per_travel = sums.travel > 0.0 ? static_cast<double>(sums.onsets) / sums.travel : 0.0,
          .peak_to_peak = sums.largest - sums.least,
          .distance_95 = distance_95,
          .distance_99 = distance_99};
}

struct Record {
  bool slips{};
  MotionValues whole{}, first{}, second{};
  double hidden_sticks{};  // in a period, that may be shorter than a step
};

Record record_of(analytic::ModalContactRun& run, const ResponseGrid& grid, bool is_sine) {
  constexpr long most_rows = 1 << 21;
  const int steps = grid.steps_per_period, half = grid.recorded / 2;
  const int row_step = static_cast<int>(std::min<long>(
      steps, std::max({1L, steps / 32L, static_cast<long>(grid.recorded) * steps / most_rows})));
  run.start_stuck();
  for (long n = 0; n < static_cast<long>(grid.transient) * steps; ++n) run.step();
  std::vector<Sample> samples;
  if (is_sine) samples.push_back(run.amplitudes());
  std::array<Sums, 2> halves;
  double place = 0.0;
  for (int period = 0; period < grid.recorded; ++period) {
    halves[period < half ? 0 : 1].add(period_of_motion(run, steps, row_step, place));
    if (is_sine) samples.push_back(run.amplitudes());
  }
  const auto of = [&](const Sums& sums, int periods, std::size_t from) {
    const std::span all(samples);
    return values_of(sums, is_sine ? all.subspan(from, static_cast<std::size_t>(periods) + 1) : all,
                     {static_cast<double>(periods), static_cast<double>(periods) * steps, run.time_step()});
  };
  Record record{.first = of(halves[0], half, 0),
                .second = of(halves[1], half, static_cast<std::size_t>(half))};
  halves[0].add(halves[1]);
  record.slips = halves[0].slip_steps > 0;
  record.whole = of(halves[0], grid.recorded, 0);
  record.hidden_sticks = static_cast<double>(halves[0].doubtful) / grid.recorded;
  return record;
}

// What whole steps leave open: each slip begins and ends somewhere in a step, and a short stick may be missed.
double resolution_of(const MotionQuantity& quantity, const Record& record, const ResponseGrid& grid,
                     double period) {
  if (quantity.value == &MotionValues::sticks) return record.hidden_sticks;
  if (quantity.value == &MotionValues::slip_rate) return record.hidden_sticks / period;
  if (quantity.value == &MotionValues::slips_per_travel)
    return record.whole.travel > 0.0 ? record.hidden_sticks / record.whole.travel : 0.0;
  if (quantity.value != &MotionValues::slip_share) return 0.0;
  return (record.whole.sticks + record.hidden_sticks) / grid.steps_per_period;
}

ResponseValue checked(const MotionQuantity& quantity, const std::array<double, 4>& values,
                      double resolution) {
  if (!std::ranges::all_of(values, [](double value) { return std::isfinite(value); }))
    return {.value = 0.0, .change = 1.0};
  const auto [least, largest] = std::ranges::minmax(values);
  const double spread = largest - least + resolution;
  if (quantity.value == &MotionValues::period) return {values[0], spread > 0.0 || least == 0.0 ? 1.0 : 0.0};
  // The work is not negative but for rounding.
  return {values[0], spread > 0.0 ? std::min(spread / std::max({largest, -least, spread}), 1.0) : 0.0};
}

double wall_velocity(const analytic::ContactModel& model) {
  return model.wall_amplitude * model.load_angular_frequency;
}

// Runs one value from `last`, and leaves its end there for the next one, with the velocity relative to the wall.
SweepPoint point_at(const SweepTask& task, double value, bool up,
                    std::optional<analytic::ContactKinematics>& last) {
  const data::Case problem = with_value(task.problem, task.parameter, value);
  const analytic::ContactModel model = response_model(problem);
  const analytic::ContactModes modes(model);
  const int steps = steps_per_period(problem);
  analytic::ModalContactRun run(modes, model, steps);
  if (last) {
    last->velocity += wall_velocity(model);
    run.start(*last);
  } else {
    run.start_stuck();
  }
  bool slips = false;
  const auto pass_period = [&] {
    slips = false;
    for (int n = 0; n < steps; ++n) {
      run.step();
      slips = slips || run.slips();
    }
    require_bounded(problem, run.contact_position(), run.time(),
                    fmt::format("the motion at {} = {}", task.parameter, data::shortest_text(value)));
  };
  for (int period = 0; period < task.settle; ++period) pass_period();
  SweepPoint point{.up = up, .value = value, .section = {}, .period = 0, .slips = false};
  std::vector<std::vector<std::complex<double>>> samples;
  for (int period = 0; period < task.periods; ++period) {
    pass_period();
    point.slips = point.slips || slips;
    point.section.push_back({.tip_displacement = run.contact_position(),
                             .sliding_velocity = run.sliding_velocity(),
                             .friction_force = -run.friction_force()});
    samples.push_back(run.amplitudes());
  }
  point.period = period_of(samples);
  last = run.state();
  last->velocity = run.sliding_velocity();
  return point;
}

}  // namespace

const MotionQuantity& motion_quantity(std::string_view name) {
  const auto* const found = std::ranges::find(motion_quantities, name, &MotionQuantity::name);
  if (found == motion_quantities.end())
    throw std::invalid_argument("there is no quantity " + std::string(name));
  return *found;
}

int period_of(std::span<const Sample> samples) {
  constexpr std::size_t longest = 16;
  constexpr double of_the_size = 1e-3, of_the_difference = 1e-2;
  double size = 0.0;
  for (const Sample& z : samples) size = std::max(size, squared_distance(z, Sample(z.size())));
  double allowed = of_the_size * of_the_size * size;
  for (std::size_t period = 1; period <= longest && 2 * period <= samples.size(); ++period) {
    const double distance = squared_return(samples, period);
    if (distance <= allowed) return static_cast<int>(period);
    if (period == 1) allowed = std::min(allowed, of_the_difference * of_the_difference * distance);
  }
  return 0;
}

int steps_per_period(const data::Case& problem) {
  constexpr double least_pairs = 16.0, most_pairs = 1e8;
  const double period = 1.0 / data::highest_frequency_hz(problem);
  const double pairs = std::ceil(0.5 * period / problem.numerics.time_step() - rounding);
  if (pairs > most_pairs)
    throw data::FieldError("numerics.time_step", problem.numerics.time_step(),
                           "at least " + data::shortest_text(0.5 * period / most_pairs) +
                               " (s), 2e8 steps in a period of the base motion");
  return 2 * static_cast<int>(std::max(pairs, least_pairs));
}

ResponseGrid response_grid(const data::Case& problem, double transient) {
  const double period = 1.0 / data::highest_frequency_hz(problem), duration = problem.numerics.duration();
  const double left_out = std::ceil(transient / period - rounding);
  const double recorded = std::floor(duration / period + rounding) - left_out;
  if (!(recorded >= 2.0))
    throw data::FieldError("excitation.duration", duration,
                           "long enough for the transient and two periods of the base motion, " +
                               data::shortest_text((left_out + 2.0) * period) + " s");
  return {.steps_per_period = steps_per_period(problem),
          .transient = static_cast<int>(left_out),
          .recorded = 2 * static_cast<int>(0.5 * recorded)};
}

analytic::ContactModel response_model(const data::Case& problem) {
  return analytic::contact_model(problem, problem.numerics.modes());
}

ContactResponse contact_response(const data::Case& problem, double transient,
                                 const analytic::ContactModes* modes) {
  const ResponseGrid grid = response_grid(problem, transient);
  const analytic::ContactModel model = response_model(problem);
  std::optional<analytic::ContactModes> own;
  if (modes == nullptr) modes = &own.emplace(model);
  analytic::ModalContactRun fine(*modes, model, grid.steps_per_period),
      coarse(*modes, model, grid.steps_per_period / 2);
  const bool is_sine = !problem.has(data::Feature::general_motion);
  const double period = fine.time_step() * grid.steps_per_period;
  const Record record = record_of(fine, grid, is_sine);
  ResponseGrid coarser = grid;
  coarser.steps_per_period /= 2;
  const Record check = record_of(coarse, coarser, is_sine);
  ContactResponse response{.slips = record.slips, .values = {}, .changes = {}};
  for (const MotionQuantity& quantity : motion_quantities) {
    const auto of = quantity.value;
    const auto [value, change] =
        checked(quantity, {record.whole.*of, record.first.*of, record.second.*of, check.whole.*of},
                resolution_of(quantity, record, grid, period));
    response.values.*of = value;
    response.changes.*of = change;
  }
  return response;
}

std::vector<SweepPoint> parameter_sweep(const SweepTask& task, const std::function<void(double)>& progress) {
  for (const double value : task.values) (void)with_value(task.problem, task.parameter, value);
  std::vector<std::pair<double, bool>> way;
  if (task.direction != SweepDirection::down)
    for (const double value : task.values) way.emplace_back(value, true);
  if (task.direction != SweepDirection::up)
    for (auto value = task.values.rbegin(); value != task.values.rend(); ++value)
      way.emplace_back(*value, false);
  std::optional<analytic::ContactKinematics> last;
  std::vector<SweepPoint> points;
  for (const auto& [value, up] : way) {
    points.push_back(point_at(task, value, up, last));
    if (progress) progress(static_cast<double>(points.size()) / static_cast<double>(way.size()));
  }
  return points;
}

Hysteresis hysteresis_of(const std::vector<SweepPoint>& points) {
  const auto extent = [](const SweepPoint& point) {
    return std::ranges::minmax(point.section, {}, &HistoryRow::friction_force);
  };
  constexpr double apart = 0.01;  // of the larger force
  Hysteresis count;
  for (std::size_t i = 0; i < points.size() / 2; ++i) {
    const auto up = extent(points[i]), down = extent(points[points.size() - 1 - i]);
    const double scale = std::max({std::abs(up.min.friction_force), std::abs(up.max.friction_force),
                                   std::abs(down.min.friction_force), std::abs(down.max.friction_force)});
    if (std::abs(up.min.friction_force - down.min.friction_force) > apart * scale ||
        std::abs(up.max.friction_force - down.max.friction_force) > apart * scale)
      ++(points[i].slips || points[points.size() - 1 - i].slips ? count.moving : count.resting);
  }
  return count;
}

}  // namespace stickslip::studies
