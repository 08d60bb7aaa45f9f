// SPDX-License-Identifier: MIT
#include "studies/history/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

#include "stickslip/analytic/amplitude_spectrum.hpp"
#include "stickslip/analytic/stick_reaction.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/key.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/contact_system.hpp"
#include "studies/common/convergence.hpp"

namespace stickslip::studies {

using data::ContactChange;
using data::ContactEvent;

std::vector<double> Bending::positions(double length) {
  constexpr int intervals = 16;
  std::vector<double> positions;
  for (int i = 0; i <= intervals; ++i) positions.push_back(length * i / intervals);
  return positions;
}

void Bending::include(const HistoryRow& row, double length) {
  const std::vector<double>& y = row.displacement;
  double fine = 0.0, coarse = 0.0;
  for (std::size_t i = 1; i < y.size(); ++i) {
    deflection = std::max(deflection, std::abs(y[i] - row.base_displacement));
    fine += std::pow(y[i] - y[i - 1], 2);
    if (i % 2 == 0) coarse += std::pow(y[i] - y[i - 2], 2);
  }
  const double interval = length / static_cast<double>(y.size() - 1);
  draw_back = std::max(draw_back, (8.0 * fine - coarse) / (12.0 * interval));
}

void require_bounded(const data::Case& problem, double deflection, double time, const std::string& motion) {
  if (!std::isfinite(deflection))
    data::throw_overflow(fmt::format("{} is not finite at {:.6g} s", motion, time));
  // A model has no length to measure its deflection by, and a general motion may go anywhere.
  if (problem.model() != nullptr || problem.general_motion() != nullptr ||
      std::abs(deflection) <= most_deflection * (problem.beam().length() + problem.excitation().amplitude()))
    return;
  throw data::InputError(fmt::format(
      "{} is stopped at {:.6g} s: the tip is deflected by {:.3g} m, more than {:.0f} times the length of "
      "the beam: it grows without end, as beyond flutter or buckling once the tip slips",
      motion, time, std::abs(deflection), most_deflection));
}

void add_row(const data::Case& problem, History& history, const RowSink& sink, HistoryRow row) {
  require_bounded(problem, row.tip_displacement - row.base_displacement, row.time);
  if (sink)
    sink(row);
  else
    history.rows.push_back(std::move(row));
}

void hold_to_law(const data::Case& problem, History& history, const HistoryRow& row) {
  constexpr double rounding = 1e-9;
  const double force = problem.normal_force(), limit = problem.contact.friction.static_coefficient() * force,
               speed = std::abs(row.sliding_velocity);
  const bool is_rigid = problem.contact.compliance.is_rigid(),
             sticks = row.state == data::ContactState::stick;
  const double sliding = solver::friction_coefficient(problem.contact.friction.in_slip(), speed) * force;
  const double largest = sticks && is_rigid ? limit : std::max(sliding, is_rigid ? 0.0 : limit);
  bool holds = std::abs(row.friction_force) <= largest + rounding * limit;
  if (is_rigid && sticks) holds = holds && speed == 0.0;
  if (is_rigid && !sticks && speed > 0.0)
    holds = std::abs(row.friction_force - std::copysign(sliding, row.sliding_velocity)) <= rounding * limit;
  if (holds) return;
  ++history.rows_off_law;
  if (!history.off_law) history.off_law = row;
}

long for_each_row(const data::Case& problem, const Sampling& sampling,
                  const std::function<void(long step, double time)>& row) {
  const double time_step = problem.numerics.time_step();
  if (sampling.times.empty()) {
    const long last = solver::step_count(problem.numerics.duration(), time_step);
    for (long step = 0; step <= last; step += sampling.every)
      row(step, static_cast<double>(step) * time_step);
    return last;
  }
  long step = 0;
  for (const double time : sampling.times) row(step = std::lround(time / time_step), time);
  return step;
}

void set_events(History& history, std::vector<ContactEvent> events) {
  history.events = std::move(events);
  if (!history.events.empty()) history.first_slip = history.events.front().time;
}

std::vector<double> sample_times(double duration, double sample) {
  std::vector<double> times;
  for (long n = 0; n <= std::lround(duration / sample); ++n) times.push_back(static_cast<double>(n) * sample);
  return times;
}

std::vector<double> tip_displacements(const History& history) {
  std::vector<double> tip;
  for (const HistoryRow& row : history.rows) tip.push_back(row.tip_displacement);
  return tip;
}

std::vector<ContactEvent> onsets_and_captures(const std::vector<ContactEvent>& events) {
  std::vector<ContactEvent> kept;
  std::ranges::copy_if(events, std::back_inserter(kept), [](const ContactEvent& event) {
    return event.change == ContactChange::onset || event.change == ContactChange::capture;
  });
  return kept;
}

std::vector<ContactEvent> without_micro_sticks(const std::vector<ContactEvent>& events,
                                               double shortest_stick) {
  std::vector<ContactEvent> kept;
  for (const ContactEvent& event : onsets_and_captures(events)) {
    const bool ends_micro_stick = event.change == ContactChange::onset && !kept.empty() &&
                                  kept.back().change == ContactChange::capture &&
                                  event.time - kept.back().time < shortest_stick;
    if (ends_micro_stick)
      kept.pop_back();
    else
      kept.push_back(event);
  }
  return kept;
}

std::optional<ContactEvent> first_capture(const std::vector<ContactEvent>& events) {
  const auto found = std::ranges::find(events, ContactChange::capture, &ContactEvent::change);
  return found == events.end() ? std::nullopt : std::optional(*found);
}

EventDifference largest_difference(const std::vector<ContactEvent>& a, const std::vector<ContactEvent>& b,
                                   std::size_t count) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (std::min(a.size(), b.size()) < count) return {infinity, infinity};
  EventDifference largest;
  for (std::size_t i = 0; i < count; ++i) {
    if (a[i].change != b[i].change) return {infinity, infinity};
    largest.time = largest_or_nan({largest.time, std::abs(a[i].time - b[i].time)});
    largest.position = largest_or_nan({largest.position, std::abs(a[i].position - b[i].position)});
  }
  return largest;
}

data::Case refined(const data::Case& problem, int elements, double time_step, double duration,
                   const std::optional<double>& spectral_radius) {
  return with_values(
      problem, {{"numerics.elements", elements},
                {"numerics.time_step", time_step},
                {"excitation.duration", duration},
                {"numerics.velocity_threshold", 0.0},
                {"numerics.spectral_radius", spectral_radius.value_or(problem.numerics.spectral_radius())}});
}

long usual_row_step(const data::Case& problem, double span) {
  constexpr double in_a_base_period = 100.0, in_a_natural_period = 20.0, in_all = 2000.0;
  constexpr long longest = 1'000'000'000;
  const auto modes = analytic::held_modes(problem, 1);
  const double natural = modes.empty() ? 0.0 : modes.front().angular_frequency / (2.0 * std::numbers::pi);
  const double rows_per_second = std::max(
      {in_a_base_period * data::highest_frequency_hz(problem), in_a_natural_period * natural, in_all / span});
  const double most = (1.0 + 1e-9) / (rows_per_second * problem.numerics.time_step());
  long usual = 1;
  for (long power = 1; power < longest; power *= 10)
    for (const long step : {power, 2 * power, 5 * power})
      if (static_cast<double>(step) <= most) usual = step;
  return usual;
}

SpectrumWindow spectrum_window(const data::Case& problem, long every) {
  constexpr double rounding = 1e-9;
  constexpr long long most_rows = 4'000'000;
  const bool rests = problem.general_motion() == nullptr && problem.excitation().amplitude() == 0.0;
  const double row_step = static_cast<double>(every) * problem.numerics.time_step(),
               half = 0.5 * problem.numerics.duration(),
               period = rests ? half : 1.0 / data::highest_frequency_hz(problem);
  const double periods = std::floor(half / period + rounding);
  const auto rows = std::llround(periods * period / row_step);
  if (periods < 1.0)
    throw data::FieldError(
        "excitation.duration", problem.numerics.duration(),
        fmt::format("at least two periods of the base motion, {} s, where --spectrum is given",
                    data::shortest_text(2.0 * period)));
  if (static_cast<double>(rows) < 2.0 * periods)
    throw data::FieldError("--every", static_cast<double>(every),
                           fmt::format("small enough for two rows in {} where --spectrum is given",
                                       rests ? "half of the duration" : "a period of the base motion"));
  if (rows > most_rows)
    throw data::FieldError("--every", static_cast<double>(every),
                           fmt::format("large enough for at most {} rows in a spectrum", most_rows));
  return {static_cast<std::size_t>(rows), rests ? 0 : std::lround(periods)};
}

namespace {

// The share of the amplitude, but for the mean value, that is in no multiple of line `periods`.
double leak_of(const std::vector<double>& amplitudes, std::size_t periods) {
  double all = 0.0, others = 0.0;
  for (std::size_t k = 1; k < amplitudes.size(); ++k) {
    const double square = amplitudes[k] * amplitudes[k];
    all += square;
    if (k % periods != 0) others += square;
  }
  return others > 0.0 ? std::sqrt(others / all) : 0.0;
}

std::vector<double> flat_top_spectrum(std::vector<double> values) {
  constexpr std::array terms{1.0, -1.90796, 1.07349, -0.18199};
  const auto count = static_cast<double>(values.size());
  std::vector<double> weights(values.size());
  double mean = 0.0;
  for (std::size_t n = 0; n < values.size(); ++n) {
    const double z = 2.0 * std::numbers::pi * static_cast<double>(n) / count;
    for (std::size_t k = 0; k < terms.size(); ++k)
      weights[n] += terms[k] * std::cos(static_cast<double>(k) * z);
    mean += weights[n] * values[n] / count;  // that of the weights is 1
  }
  for (std::size_t n = 0; n < values.size(); ++n) values[n] = weights[n] * (values[n] - mean);
  auto amplitudes = analytic::amplitude_spectrum(values);
  amplitudes.front() = std::abs(mean);
  return amplitudes;
}

}  // namespace

Spectrum spectrum_of(const std::vector<double>& tip_displacements, const std::vector<double>& friction_forces,
                     const SpectrumWindow& window, double row_step) {
  constexpr long least_periods = 8;
  const auto last = [&](const std::vector<double>& values) {
    return std::vector<double>(values.end() - static_cast<std::ptrdiff_t>(window.rows), values.end());
  };
  auto tip = analytic::amplitude_spectrum(last(tip_displacements)),
       force = analytic::amplitude_spectrum(last(friction_forces));
  Spectrum spectrum{.is_flat_top = window.periods == 0, .leak = 0.0, .lines = {}};
  if (window.periods > 0) {
    const auto periods = static_cast<std::size_t>(window.periods);
    spectrum.leak = std::max(leak_of(tip, periods), leak_of(force, periods));
    spectrum.is_flat_top = spectrum.leak > allowed_leak && window.periods >= least_periods;
  }
  if (spectrum.is_flat_top) {
    tip = flat_top_spectrum(last(tip_displacements));
    force = flat_top_spectrum(last(friction_forces));
  }
  for (std::size_t k = 0; k < tip.size(); ++k)
    spectrum.lines.push_back(
        {static_cast<double>(k) / (static_cast<double>(window.rows) * row_step), tip[k], force[k]});
  return spectrum;
}

}  // namespace stickslip::studies
