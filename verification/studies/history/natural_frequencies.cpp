// SPDX-License-Identifier: MIT
#include "studies/history/natural_frequencies.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/steady_sliding.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_reaction.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "stickslip/solver/model_system.hpp"
#include "studies/common/discretisation.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

namespace {

using analytic::TipSupport;
using Shapes = std::vector<std::vector<double>>;

constexpr double wave_number_rounding = 4.0 * std::numeric_limits<double>::epsilon();
constexpr double stiffness_rounding = 12.0 * std::numeric_limits<double>::epsilon();

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

double model_error(const data::Beam& beam, double slopes, double third_derivatives) {
  const double radius_squared = beam.second_moment_of_area() / beam.area();
  return std::sqrt(1.0 + radius_squared * (slopes + shear_flexibility * third_derivatives)) - 1.0;
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

namespace {

constexpr double model_rounding = 1e-9;  // of a frequency; empirical

std::vector<EstimatedFrequency> model_frequencies(const data::Case& problem, TipSupport tip, int count) {
  std::vector<EstimatedFrequency> frequencies;
  if (tip == TipSupport::held) {
    for (const auto& mode : analytic::held_modes(problem, count))
      frequencies.push_back({mode.angular_frequency / two_pi, model_rounding});
    return frequencies;
  }
  const analytic::HeldStructure structure = analytic::held_structure(problem, std::max(60, 2 * count));
  const analytic::HeldStructure::Omitted& rest = structure.omitted;
  for (const double omega : analytic::free_angular_frequencies(structure))
    if (static_cast<int>(frequencies.size()) < count)
      frequencies.push_back(
          {omega / two_pi, model_rounding + 0.5 * rest.contact / structure.contact_mass *
                                                std::pow(omega / rest.angular_frequency, 2)});
  return frequencies;
}

}  // namespace

std::vector<EstimatedFrequency> closed_form_frequencies(const data::Case& problem, TipSupport tip,
                                                        int count) {
  if (problem.model() != nullptr) return model_frequencies(problem, tip, count);
  return closed_form_frequencies(problem.beam(), tip, count);
}

double mesh_frequency_error(const data::Beam& beam, double omega, double element_length) {
  const double mass = beam.density() * beam.area(), l = element_length;
  const double stiffness = beam.youngs_modulus() * beam.second_moment_of_area();
  const double shear = beam.shear_stiffness() > 0.0 ? 60.0 * stiffness / beam.shear_stiffness() : 0.0;  // m²
  return mass * omega * omega / stiffness * l * l * (l * l + shear) / 1440.0;
}

double hermite_stick_error(const data::Beam& beam, double element_length) {
  if (beam.shear_stiffness() > 0.0) return 0.0;
  return hermite_eigenvalue_error(beam, analytic::stick_modes(beam, 1).front(), element_length);
}

double stick_model_error(const data::Beam& beam, int mode) {
  const auto modes = analytic::stick_modes(beam, mode);
  const auto& u = modes.back();
  const auto integral = [&](auto derivative) {
    return simpson_integral([&](double x) { return std::pow((u.*derivative)(x), 2); }, beam.length(), u);
  };
  return model_error(
      beam, integral(&analytic::StickMode::slope) / u.norm_squared(),
      integral(&analytic::StickMode::third_derivative) / integral(&analytic::StickMode::curvature));
}

// Slope and third derivative by partial integration, with U'''' = k U - p U'', U''(L) = 0 and U'''(L) = -χ p U'(L):
//
//     U'(L) = int U'',                    int U'² = U(L) U'(L) - int U U'',
//     U'''(0) = U'''(L) - int U'''',      int U'''² = -U''(0) U'''(0) - int U'' U''''.
double slip_model_error(const data::Beam& beam, int mode) {
  const auto modes = analytic::slip_modes(beam, mode);
  const auto& u = modes.back();
  const double p = beam.axial_force() / (beam.youngs_modulus() * beam.second_moment_of_area());
  const double k = std::pow(u.hyperbolic_wave_number() * u.trigonometric_wave_number(), 2);
  const auto fourth = [&](double x) { return k * u.shape(x) - p * u.curvature(x); };
  const auto integral = [&](auto&& function) { return simpson_integral(function, beam.length(), u); };
  const double tip_slope = integral([&](double x) { return u.curvature(x); });
  const double slopes =
      u.shape(beam.length()) * tip_slope - integral([&](double x) { return u.shape(x) * u.curvature(x); });
  const double third_derivatives =
      u.curvature(0.0) * (beam.axial_direction() * p * tip_slope + integral(fourth)) -
      integral([&](double x) { return u.curvature(x) * fourth(x); });
  return model_error(beam, slopes / integral([&](double x) { return std::pow(u.shape(x), 2); }),
                     third_derivatives / integral([&](double x) { return std::pow(u.curvature(x), 2); }));
}

namespace {

// What the axial force makes of mesh_frequency_error(), a factor: by partial integration, with ∫ w' w*' dx = φ*ᵀ K_G φ and
// EI ∫ w'' w*'' dx = φ*ᵀ K φ, which takes the energy of shear for one of bending.
double factor_of_axial_force(const solver::BeamModel& model, const solver::FiniteElementMode& mode,
                             const Eigen::VectorXd& adjoint) {
  const data::Beam& beam = model.beam();
  const Eigen::VectorXd& shape = mode.shape;
  const Eigen::Index w = model.tip_deflection(), rotation = model.tip_rotation();
  const double modal_mass = adjoint.dot(model.mass() * shape);
  const double slopes = adjoint.dot(model.geometric_stiffness() * shape) / modal_mass;
  const double bending = adjoint.dot(model.elastic_stiffness() * shape) / modal_mass;
  const double end = (shape[w] * adjoint[rotation] + shape[rotation] * adjoint[w]) / modal_mass;
  const double load = beam.axial_force() / std::pow(mode.angular_frequency, 2);
  const double rigidity = beam.youngs_modulus() * beam.second_moment_of_area();
  return 1.0 + load * (2.0 * slopes - end) +
         load * load * bending / (beam.density() * beam.area() * rigidity);
}

}  // namespace

std::vector<EstimatedFrequency> mesh_frequencies(const data::Case& problem, TipSupport tip, int count) {
  if (problem.model() != nullptr) {
    std::vector<EstimatedFrequency> frequencies;
    const auto matrices = solver::model_matrices(*problem.model());
    for (const auto& mode : solver::model_modes(matrices, tip == TipSupport::held))
      if (static_cast<int>(frequencies.size()) < count)
        frequencies.push_back({mode.angular_frequency / two_pi, model_rounding});
    return frequencies;
  }
  const data::Beam& beam = problem.beam();
  const int elements = problem.numerics.elements();
  const solver::BeamModel model(beam, elements);
  const auto modes = mesh_modes(model, tip, count);
  const auto adjoint =
      tip == TipSupport::free ? solver::adjoint_slip_shapes(model, count) : std::vector<Eigen::VectorXd>();
  std::vector<EstimatedFrequency> frequencies;
  for (std::size_t n = 0; n < modes.size(); ++n) {
    const double omega = modes[n].angular_frequency, length = beam.length();
    const double factor = adjoint.empty()
                              ? factor_of_axial_force(model, modes[n], modes[n].shape)
                              : std::max(1.0, std::abs(factor_of_axial_force(model, modes[n], adjoint[n])));
    const double rounding = stiffness_rounding * std::pow(elements, 3.5) * beam.youngs_modulus() *
                            beam.second_moment_of_area() /
                            (beam.density() * beam.area() * omega * omega * std::pow(length, 4));
    frequencies.push_back({omega / (2.0 * std::numbers::pi),
                           factor * mesh_frequency_error(beam, omega, length / elements) + rounding});
  }
  return frequencies;
}

Shapes closed_form_shapes(const data::Beam& beam, TipSupport tip, int count,
                          const std::vector<double>& points) {
  return tip == TipSupport::free ? shapes_at(analytic::slip_modes(beam, count), points)
                                 : shapes_at(analytic::stick_modes(beam, count), points);
}

Shapes mesh_shapes(const data::Case& problem, TipSupport tip, int count, const std::vector<double>& points) {
  const solver::BeamModel model(problem.beam(), problem.numerics.elements());
  const auto modes = mesh_modes(model, tip, count);
  Shapes values(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto weights = model.interpolation(points[i]);
    for (const auto& mode : modes) values[i].push_back(weights.dot(mode.shape));
  }
  return normalised(std::move(values), modes.size());
}

}  // namespace stickslip::studies
