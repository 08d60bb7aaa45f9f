// SPDX-License-Identifier: MIT
#include "studies/analyses/natural_frequencies.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"
#include "stickslip/solver/modal_analysis.hpp"

namespace stickslip::studies {

namespace {

using analytic::TipSupport;
using Shapes = std::vector<std::vector<double>>;

constexpr double wave_number_rounding = 4.0 * std::numeric_limits<double>::epsilon();

std::vector<EstimatedFrequency> frequencies_with_shear(const data::Beam& beam, TipSupport tip, int count) {
  std::vector<EstimatedFrequency> frequencies;
  const double load_share = std::max(0.0, beam.axial_force()) / analytic::stick_buckling_load(beam);
  for (const double omega : analytic::timoshenko_frequencies(beam, tip, count))
    frequencies.push_back({omega / (2.0 * std::numbers::pi), wave_number_rounding / (1.0 - load_share)});
  return frequencies;
}

// Rounding of the characteristic function C over its slope: the sum of the moduli of its terms, times eps, divided by |dC/d(ln ω)|.
double slip_root_error(const data::Beam& beam, const analytic::SlipMode& mode) {
  const double b = mode.hyperbolic_wave_number() * beam.length();
  const double bb = mode.trigonometric_wave_number() * beam.length();
  const double terms = (std::pow(b, 4) + std::pow(bb, 4)) / std::cosh(b) + 2.0 * b * b * bb * bb +
                       b * bb * std::abs(bb * bb - b * b);
  const double omega = mode.angular_frequency(), relative_step = 1e-6;
  const double slope = (analytic::slip_characteristic(beam, omega * (1.0 + relative_step)) -
                        analytic::slip_characteristic(beam, omega * (1.0 - relative_step))) /
                       (2.0 * relative_step);
  return wave_number_rounding * (1.0 + terms / std::abs(slope));
}

std::vector<solver::FiniteElementMode> mesh_modes(const solver::BeamModel& model, TipSupport tip, int count) {
  return tip == TipSupport::free ? solver::slip_modes(model, count) : solver::stick_modes(model, count);
}

Shapes normalised(Shapes values, std::size_t modes) {
  for (std::size_t n = 0; n < modes; ++n) {
    double largest = 0.0;
    for (const auto& row : values)
      if (std::abs(row[n]) > std::abs(largest)) largest = row[n];
    for (auto& row : values) row[n] /= largest;
  }
  return values;
}

Shapes shapes_at(const auto& modes, const std::vector<double>& points) {
  Shapes values(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const auto& mode : modes) values[i].push_back(mode.shape(points[i]));
  return normalised(std::move(values), modes.size());
}

}  // namespace

std::vector<EstimatedFrequency> closed_form_frequencies(const data::Beam& beam, TipSupport tip, int count) {
  if (beam.shear_stiffness() > 0.0) return frequencies_with_shear(beam, tip, count);
  std::vector<EstimatedFrequency> frequencies;
  if (tip == TipSupport::free)
    for (const auto& mode : analytic::slip_modes(beam, count))
      frequencies.push_back({mode.frequency_hz(), slip_root_error(beam, mode)});
  else
    for (const auto& mode : analytic::stick_modes(beam, count))
      frequencies.push_back({mode.frequency_hz(), wave_number_rounding * mode.condition_number()});
  return frequencies;
}

double mesh_frequency_error(const data::Beam& beam, double omega, double element_length) {
  const double mass = beam.density() * beam.area(), l = element_length;
  const double stiffness = beam.youngs_modulus() * beam.second_moment_of_area();
  const double shear = beam.shear_stiffness() > 0.0 ? 60.0 * stiffness / beam.shear_stiffness() : 0.0;  // m²
  return mass * omega * omega / stiffness * l * l * (l * l + shear) / 1440.0;
}

std::vector<EstimatedFrequency> mesh_frequencies(const data::Case& problem, TipSupport tip, int count) {
  const solver::BeamModel model(problem.beam, problem.numerics.elements());
  const double element_length = problem.beam.length() / model.elements();
  std::vector<EstimatedFrequency> frequencies;
  for (const auto& mode : mesh_modes(model, tip, count))
    frequencies.push_back({mode.angular_frequency / (2.0 * std::numbers::pi),
                           mesh_frequency_error(problem.beam, mode.angular_frequency, element_length)});
  return frequencies;
}

Shapes closed_form_shapes(const data::Beam& beam, TipSupport tip, int count,
                          const std::vector<double>& points) {
  return tip == TipSupport::free ? shapes_at(analytic::slip_modes(beam, count), points)
                                 : shapes_at(analytic::stick_modes(beam, count), points);
}

Shapes mesh_shapes(const data::Case& problem, TipSupport tip, int count, const std::vector<double>& points) {
  const solver::BeamModel model(problem.beam, problem.numerics.elements());
  const auto modes = mesh_modes(model, tip, count);
  Shapes values(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto weights = model.interpolation(points[i]);
    for (const auto& mode : modes) values[i].push_back(weights.dot(mode.shape));
  }
  return normalised(std::move(values), modes.size());
}

}  // namespace stickslip::studies
