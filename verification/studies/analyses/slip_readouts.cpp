// SPDX-License-Identifier: MIT
#include "studies/analyses/slip_readouts.hpp"

#include <fmt/format.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "stickslip/analytic/stick_reaction.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/solver/contact_system.hpp"
#include "studies/history/natural_frequencies.hpp"

namespace stickslip::studies {

namespace {

template <class Member>
Estimate mean_of(const std::vector<ReadoutWindow>& windows, Member member, double scale = 1.0) {
  std::vector<double> values;
  for (const ReadoutWindow& each : windows) values.push_back(scale * std::invoke(member, each));
  return mean_with_interval(values);
}

double base_displacement(const data::Case& problem, double time) {
  if (problem.is_force()) return 0.0;
  if (const auto* motion = problem.general_motion()) return motion->displacement(time);
  const auto& sine = problem.excitation();
  return sine.amplitude() * std::sin(2.0 * std::numbers::pi * sine.frequency_hz() * time);
}

double wall_displacement(const data::Case& problem, double time) {
  const auto& [friction, compliance, wall, motion] = problem.contact;
  return wall.speed() * time + (wall.moves_with_base() ? base_displacement(problem, time) : 0.0) +
         (motion ? motion->displacement(time) : 0.0);
}

// The motion at a row or an event, and whether the tip slips from there to the next one.
struct Point {
  double time{}, distance{}, force{};
  bool is_row{}, slips{};
};

// A rigid contact turns at the events, where slip begins and ends; of the force there the modulus is used.
std::vector<Point> points_of(const data::Case& problem, const History& history) {
  const bool is_rigid = problem.contact.compliance.is_rigid();
  const double sliding =
      solver::friction_coefficient(problem.contact.friction.in_slip(), 0.0) * problem.normal_force();
  std::vector<Point> points;
  auto event = history.events.begin();
  bool slips = history.rows.front().state == data::ContactState::slip;
  for (const HistoryRow& row : history.rows) {
    for (; is_rigid && event != history.events.end() && event->time <= row.time; ++event) {
      slips = event->change != data::ContactChange::capture;
      points.push_back(
          {event->time, event->position - wall_displacement(problem, event->time), sliding, false, slips});
    }
    points.push_back({row.time, row.tip_displacement - wall_displacement(problem, row.time),
                      row.friction_force, true, is_rigid ? slips : row.state == data::ContactState::slip});
  }
  return points;
}

// The first row from that time on; a row in time steps may be rounded.
std::size_t first_row(const History& history, double time) {
  const auto found = std::ranges::find_if(
      history.rows, [&](const HistoryRow& row) { return row.time >= time * (1.0 - 1e-12); });
  return static_cast<std::size_t>(found - history.rows.begin());
}

std::vector<double> forces_of(const History& history, double transient) {
  std::vector<double> forces;
  for (std::size_t i = first_row(history, transient); i < history.rows.size(); ++i)
    forces.push_back(history.rows[i].friction_force);
  const double mean = gsl_stats_mean(forces.data(), 1, forces.size());
  for (double& force : forces) force -= mean;
  return forces;
}

void add_spectrum(const std::vector<double>& forces, SlipReadouts& readouts) {
  double squares = 0.0, lines = 0.0, weighted = 0.0;
  for (const double force : forces) squares += force * force / static_cast<double>(forces.size());
  const Spectrum spectrum = spectrum_of(forces, forces, {forces.size(), 0}, readouts.row_step);
  for (std::size_t k = 1; k < spectrum.lines.size(); ++k) {
    const auto& [hz, tip, force] = spectrum.lines[k];
    if (force > readouts.peak_force) readouts.peak_hz = hz, readouts.peak_force = force;
    lines += force * force;
    weighted += force * force * std::pow(10.0, a_weighting(hz) / 10.0);
  }
  readouts.force_level = 10.0 * std::log10(squares);
  readouts.a_weighted_level = readouts.force_level + 10.0 * std::log10(weighted / lines);
}

void add_slips(const std::vector<double>& onsets, SlipReadouts& readouts) {
  std::vector<double> spacings;
  for (std::size_t i = 1; i < onsets.size(); ++i) spacings.push_back(onsets[i] - onsets[i - 1]);
  const std::size_t count = spacings.size();
  readouts.slips = onsets.size();
  if (readouts.travel > 0.0)
    readouts.slips_per_travel = static_cast<double>(readouts.slips) / readouts.travel;
  if (count > 0) readouts.spacing = gsl_stats_mean(spacings.data(), 1, count);
  if (count > 1) readouts.spacing_variation = gsl_stats_sd(spacings.data(), 1, count) / readouts.spacing;
  if (readouts.slips > 0)
    readouts.sound = readouts.spacing_variation < 0.2 && readouts.slip_rate.value > 20.0 ? "squeal" : "tick";
}

}  // namespace

// As gsl_stats_quantile_from_sorted_data() of all, without sorting them.
std::pair<double, double> distance_percentiles(std::vector<double> values) {
  const double mean = gsl_stats_mean(values.data(), 1, values.size());
  for (double& value : values) value = std::abs(value - mean);
  const auto at = [&](double share) {
    const double index = share * static_cast<double>(values.size() - 1), below = std::floor(index);
    const auto found = values.begin() + static_cast<std::ptrdiff_t>(below);
    std::ranges::nth_element(values, found);
    if (found + 1 == values.end()) return *found;
    return (1.0 - (index - below)) * *found + (index - below) * *std::min_element(found + 1, values.end());
  };
  const double of_95 = at(0.95);
  return {of_95, at(0.99)};
}

double a_weighting(double hz) {
  const double f = hz * hz;
  constexpr std::array poles{20.60 * 20.60, 107.7 * 107.7, 737.9 * 737.9, 12194.0 * 12194.0};
  return 20.0 * std::log10(poles[3] * f * f /
                           ((f + poles[0]) * std::sqrt((f + poles[1]) * (f + poles[2])) * (f + poles[3]))) +
         2.000;
}

long readout_row_step(const data::Case& problem, const ReadoutOptions& options) {
  constexpr double of_sound = 11025.0, usual_rows = 1e6, most_rows = 4e6;
  const double duration = problem.numerics.duration(), time_step = problem.numerics.time_step();
  if (options.transient >= duration)
    throw data::FieldError("--transient", options.transient,
                           fmt::format("below the duration of {} s", data::shortest_text(duration)));
  const auto modes = analytic::held_modes(problem, 1);
  const double natural = modes.empty()
                             ? closed_form_frequencies(problem, analytic::TipSupport::free, 1).front().hz
                             : modes.front().angular_frequency / (2.0 * std::numbers::pi);
  const double least = least_rows_in_a_period * std::max({data::highest_frequency_hz(problem), natural,
                                                          options.windows / (duration - options.transient)});
  if (least * time_step > 1.0 + 1e-9)
    throw data::FieldError(
        "numerics.time_step", time_step,
        fmt::format("at most {:.3g} here, for 20 rows in a period of the motion and of the "
                    "first natural frequency, and in a window",
                    1.0 / least));
  if (least * duration > most_rows)
    throw data::FieldError(
        "excitation.duration", duration,
        fmt::format("at most {:.4g} here, for four million rows; map --quantity takes longer ones",
                    most_rows / least));
  const double rate = std::max(least, std::min({of_sound, 1.0 / time_step, usual_rows / duration}));
  return static_cast<long>((1.0 + 1e-9) / (rate * time_step));
}

SlipReadouts slip_readouts(const data::Case& problem, const History& history, const ReadoutOptions& options) {
  const std::size_t first = first_row(history, options.transient);
  const double begin = history.rows.at(first).time, end = history.rows.back().time,
               length = (end - begin) / options.windows;
  SlipReadouts readouts{.windows = {}, .window = length, .rows = history.rows.size() - first};
  readouts.row_step = (end - begin) / static_cast<double>(readouts.rows - 1);
  std::vector<ReadoutWindow>& windows = readouts.windows;
  for (int i = 0; i < options.windows; ++i) windows.push_back({.begin = begin + i * length});
  const auto window_at = [&](double time) -> ReadoutWindow& {
    return windows[std::min(static_cast<std::size_t>((time - begin) / length), windows.size() - 1)];
  };
  std::vector<double> onsets, distances;
  for (const auto& [change, time, position, residual] : history.events)
    if (change == data::ContactChange::onset && time >= begin && time <= end) {
      onsets.push_back(time);
      window_at(time).slips += 1.0;
    }
  const bool is_rigid = problem.contact.compliance.is_rigid();
  std::optional<Point> last;
  for (const Point& at : points_of(problem, history)) {
    if (at.time < begin) continue;
    if (at.is_row) {
      ReadoutWindow& window = window_at(at.time);
      distances.push_back(at.distance);
      window.least = std::min(window.least, at.distance);
      window.largest = std::max(window.largest, at.distance);
    }
    if (last) {
      ReadoutWindow& window = window_at(0.5 * (last->time + at.time));
      const double step = at.distance - last->distance;
      window.travel += std::abs(step);
      readouts.travel += std::abs(step);
      if (last->slips) window.slipping += at.time - last->time;
      window.work += 0.5 * (is_rigid ? (std::abs(last->force) + std::abs(at.force)) * std::abs(step)
                                     : (last->force + at.force) * step);
    }
    last = at;
  }
  readouts.peak_to_peak = mean_of(windows, &ReadoutWindow::range);
  readouts.travel_rate = mean_of(windows, &ReadoutWindow::travel, 1.0 / length);
  readouts.slip_rate = mean_of(windows, &ReadoutWindow::slips, 1.0 / length);
  readouts.slip_share = mean_of(windows, &ReadoutWindow::slipping, 1.0 / length);
  readouts.friction_power = mean_of(windows, &ReadoutWindow::work, 1.0 / length);
  std::tie(readouts.distance_95, readouts.distance_99) = distance_percentiles(std::move(distances));
  add_slips(onsets, readouts);
  add_spectrum(forces_of(history, options.transient), readouts);
  return readouts;
}

data::Case realisation(const data::Case& problem, std::uint64_t number) {
  data::Case next = problem;
  bool is_random = false;
  const auto other = [&](const data::GeneralMotion& motion, std::string_view table) {
    const auto* spectrum = std::get_if<data::PowerSpectrum>(&motion.statement());
    if (spectrum == nullptr) return motion;
    is_random = true;
    data::PowerSpectrum with_seed = *spectrum;
    with_seed.seed += number;
    return data::GeneralMotion(with_seed, motion.duration(), table).scaled(motion.scale());
  };
  if (const auto* base = problem.general_motion()) next.motion = other(*base, "excitation");
  if (const auto& wall = problem.contact.wall_motion) next.contact.wall_motion = other(*wall, "wall");
  if (is_random) return next;
  throw data::FieldError("--average", std::string("given"),
                         "left out of a case without a spectrum, whose realisations are all the same");
}

Estimate mean_over(const std::vector<SlipReadouts>& realisations,
                   const std::function<double(const SlipReadouts&)>& number) {
  std::vector<double> values;
  for (const SlipReadouts& each : realisations)
    if (const double value = number(each); std::isfinite(value)) values.push_back(value);
  constexpr double none = SlipReadouts::none;
  return values.size() < 2 ? Estimate{none, none, none} : mean_with_interval(values);
}

std::string force_as_wav(const History& history, double transient) {
  constexpr std::uint32_t rate = 44100, bytes = 2, header = 36;
  const std::vector<double> forces = forces_of(history, transient);
  const double step =
      (history.rows.back().time - history.rows.front().time) / static_cast<double>(history.rows.size() - 1);
  double peak = 0.0;
  for (const double force : forces) peak = std::max(peak, std::abs(force));
  const auto count =
      static_cast<std::uint32_t>(static_cast<double>(forces.size() - 1) * step * rate + 1e-6) + 1;
  std::string wav;
  const auto put = [&](std::uint32_t value, int size) {
    for (int i = 0; i < size; ++i) wav += static_cast<char>(value >> (8 * i) & 0xffU);
  };
  wav += "RIFF", put(header + bytes * count, 4), wav += "WAVEfmt ", put(16, 4);
  put(1, 2), put(1, 2), put(rate, 4), put(rate * bytes, 4), put(bytes, 2), put(8 * bytes, 2);
  wav += "data", put(bytes * count, 4);
  for (std::uint32_t n = 0; n < count; ++n) {
    const double at = n / (rate * step);
    const std::size_t below = std::min(static_cast<std::size_t>(at), forces.size() - 1),
                      above = std::min(below + 1, forces.size() - 1);
    const double force = std::lerp(forces[below], forces[above], at - static_cast<double>(below));
    put(static_cast<std::uint32_t>(peak > 0.0 ? std::lround(32767.0 * force / peak) : 0), 2);
  }
  return wav;
}

}  // namespace stickslip::studies
