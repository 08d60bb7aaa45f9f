// SPDX-License-Identifier: MIT
#include "studies/analyses/length_force_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "stickslip/analytic/stick_modes.hpp"
#include "studies/common/bisection.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

namespace {

double force_ratio(const data::Case& problem) {
  constexpr double width = 1e-3;
  const analytic::Criterion criterion = analytic::evaluate_criterion(problem, width);
  return criterion.force_max.midpoint() / criterion.friction_limit;
}

// Appends `count` lengths after `first` up to `last`. `share` maps 0 ... 1 onto itself; the lengths are close
// together where its slope is small.
void append_graded(double first, double last, int count, double (*share)(double),
                   std::vector<double>& lengths) {
  for (int i = 1; i <= count; ++i)
    lengths.push_back(std::lerp(first, last, share(static_cast<double>(i) / count)));
}

double dense_at_first(double t) { return t * t; }
double dense_at_last(double t) { return 1.0 - dense_at_first(1.0 - t); }
double dense_at_both(double t) {
  return t < 0.5 ? 0.5 * dense_at_first(2.0 * t) : 1.0 - 0.5 * dense_at_first(2.0 - 2.0 * t);
}

// A resonance that does not exist, or that is outside the interval, is placed at the end of the interval, so
// that the lines of neighbouring forces stay similar.
std::vector<double> graded_lengths(const LengthForceMap::Line& line, double shortest, double longest) {
  const double last = std::min(longest, 0.999 * line.buckling_length);
  const double first_resonance = std::clamp(line.resonance_1.value_or(last), shortest, last);
  const double second_resonance = std::clamp(line.resonance_2.value_or(last), shortest, last);
  std::vector<double> lengths{shortest};
  append_graded(shortest, first_resonance, 40, dense_at_last, lengths);
  append_graded(first_resonance, second_resonance, 60, dense_at_both, lengths);
  append_graded(second_resonance, last, 30, dense_at_first, lengths);
  return lengths;
}

LengthForceMap::Line line_of(const data::Case& problem, double shortest, double longest, double axial_force) {
  const data::Case at_force =
      data::with_value(data::with_value(problem, "beam.length", shortest), "beam.axial_force", axial_force);
  const data::Beam& beam = at_force.beam();
  const double hz = problem.excitation().frequency_hz();
  LengthForceMap::Line line;
  line.axial_force = axial_force;
  line.buckling_length = buckling_length(beam);
  line.resonance_1 = resonance_length(beam, 1, hz);
  line.resonance_2 = resonance_length(beam, 2, hz);
  line.length = graded_lengths(line, shortest, longest);
  for (const double length : line.length)
    line.force_ratio.push_back(force_ratio(data::with_value(at_force, "beam.length", length)));
  return line;
}

}  // namespace

LengthForceMap length_force_map(const data::Case& problem, double shortest, double longest,
                                const std::vector<double>& axial_forces) {
  LengthForceMap map;
  map.lines.resize(axial_forces.size());
  in_parallel(axial_forces.size(),
              [&](std::size_t i) { map.lines[i] = line_of(problem, shortest, longest, axial_forces[i]); });
  const data::Beam& beam = problem.beam();
  const double rigidity = beam.youngs_modulus() * beam.second_moment_of_area();
  map.frequency_hz = problem.excitation().frequency_hz();
  map.buckling_coefficient = analytic::stick_buckling_load(beam) * beam.length() * beam.length() / rigidity;
  map.section_height = std::sqrt(12.0 * beam.second_moment_of_area() / beam.area());
  map.section_width = beam.area() / map.section_height;
  for (const int mode : {1, 2})
    if (const auto length = resonance_length(beam, mode, map.frequency_hz))
      map.resonance_lengths.push_back(*length);
  return map;
}

double buckling_length(const data::Beam& beam) {
  return beam.length() * std::sqrt(analytic::stick_buckling_load(beam) / beam.axial_force());
}

std::optional<double> resonance_length(const data::Beam& beam, int mode, double hz) {
  const double bending_stiffness = beam.youngs_modulus() * beam.second_moment_of_area();
  const double omega = two_pi * hz;
  const double half_load = 0.5 * beam.axial_force() / bending_stiffness;  // p/2, 1/m²
  const double k = beam.density() * beam.area() * omega * omega / bending_stiffness;
  const double wave_number = std::sqrt(half_load + std::sqrt(half_load * half_load + k));  // betabar, 1/m
  const auto hz_at = [&](double length) {
    data::BeamProperties properties = beam.properties();
    properties.length = length;
    return stick_hz(data::Beam(properties), mode);
  };
  const double low = mode * std::numbers::pi / wave_number;
  double high = (mode + 0.5) * std::numbers::pi / wave_number;
  if (beam.axial_force() > 0.0) high = std::min(high, buckling_length(beam) * (1.0 - 1e-12));
  if (low >= high || hz_at(high) > hz) return std::nullopt;
  return bisected(
      low, high, [&](double length) { return hz_at(length) > hz; }, 1e-12);
}

std::vector<double> figure14_axial_forces() {
  constexpr int last = 99;
  std::vector<double> forces;
  for (int i = 0; i <= last; ++i) forces.push_back(5.0 * std::pow(6600.0, static_cast<double>(i) / last));
  return forces;
}

}  // namespace stickslip::studies
