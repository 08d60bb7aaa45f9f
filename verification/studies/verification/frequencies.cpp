// SPDX-License-Identifier: MIT
#include "studies/verification/frequencies.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/common/bisection.hpp"
#include "studies/common/discretisation.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

namespace {

using FiniteElementModes = std::vector<solver::FiniteElementMode>;

// `predicted_error` is a function of the exact mode and the length of an element.
template <typename AnalyticMode, typename PredictedError>
FrequencyStudy frequency_study(const char* state, const data::Beam& beam, const std::vector<int>& elements,
                               const std::vector<AnalyticMode>& exact,
                               FiniteElementModes (*finite_element_modes)(const solver::BeamModel&, int),
                               const PredictedError& predicted_error) {
  FrequencyStudy study{.state = state,
                       .elements = elements,
                       .element_length = {},
                       .modes = std::vector<FrequencyConvergence>(exact.size())};
  for (const int n : elements) {
    study.element_length.push_back(beam.length() / n);
    const FiniteElementModes computed =
        finite_element_modes(solver::BeamModel(beam, n), static_cast<int>(exact.size()));
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const double hz = computed[i].angular_frequency / two_pi;
      const double ratio = hz / exact[i].frequency_hz();
      study.modes[i].finite_element_hz.push_back(hz);
      study.modes[i].relative_error.push_back((ratio - 1.0) * (ratio + 1.0));
      study.modes[i].predicted_error.push_back(predicted_error(exact[i], study.element_length.back()));
    }
  }
  for (std::size_t i = 0; i < exact.size(); ++i) {
    FrequencyConvergence& mode = study.modes[i];
    mode.mode = exact[i].number();
    mode.closed_form_hz = exact[i].frequency_hz();
    std::vector<double> magnitudes;
    for (const double error : mode.relative_error) magnitudes.push_back(std::abs(error));
    mode.observed_order = order_estimate(study.element_length, magnitudes);
    mode.leading_constant_ratio = mode.relative_error.back() / mode.predicted_error.back();
  }
  return study;
}

// EI/L², N.
double load_unit(const data::Beam& beam) {
  return beam.youngs_modulus() * beam.second_moment_of_area() / (beam.length() * beam.length());
}

// The largest load factor P L²/EI at which the two lowest slip eigenvalues of a mesh are real.
double finite_element_flutter(const data::Beam& beam, int elements) {
  const auto flutters = [&](double factor) {
    data::BeamProperties properties = beam.properties();
    properties.axial_force = factor * load_unit(beam);
    return solver::slip_eigenvalues(solver::BeamModel(data::Beam(properties), elements), 1).front().imag() !=
           0.0;
  };
  return bisected(
      15.0, 25.0, [&](double factor) { return !flutters(factor); }, 1e-9);
}

// Scales the shape to a largest magnitude of 1 and a positive sign next to the clamp.
void normalise(std::vector<double>& shape) {
  const auto [least, most] = std::ranges::minmax(shape);
  const double scale = (shape[1] < 0.0 ? -1.0 : 1.0) / std::max(-least, most);
  for (double& value : shape) value *= scale;
}

template <typename AnalyticMode>
ModeShapeStudy::Curve shape_curve(const AnalyticMode& exact, const solver::FiniteElementMode& computed,
                                  const solver::BeamModel& model, bool slip,
                                  const std::vector<double>& position) {
  ModeShapeStudy::Curve curve;
  curve.mode = exact.number();
  curve.slip = slip;
  curve.closed_form_hz = exact.frequency_hz();
  curve.finite_element_hz = computed.angular_frequency / two_pi;
  for (const double s : position) {
    const double x = std::min(s * model.beam().length(), model.beam().length());
    curve.closed_form.push_back(exact.shape(x));
    curve.finite_element.push_back(model.interpolation(x).dot(computed.shape));
  }
  normalise(curve.closed_form);
  normalise(curve.finite_element);
  curve.largest_difference = largest_difference(curve.closed_form, curve.finite_element);
  return curve;
}

}  // namespace

FrequencyStudy stick_frequency_study(const data::Beam& beam, int modes, const std::vector<int>& elements) {
  return frequency_study("stick", beam, elements, analytic::stick_modes(beam, modes), solver::stick_modes,
                         [&beam](const analytic::StickMode& mode, double length) {
                           return hermite_eigenvalue_error(beam, mode, length);
                         });
}

FrequencyStudy slip_frequency_study(const data::Beam& beam, int modes, const std::vector<int>& elements) {
  return frequency_study("slip", beam, elements, analytic::slip_modes(beam, modes), solver::slip_modes,
                         [](const analytic::SlipMode& mode, double length) {
                           const double wave_number_squared =
                               mode.hyperbolic_wave_number() * mode.trigonometric_wave_number();
                           return std::pow(length, 4) / 720.0 * wave_number_squared * wave_number_squared;
                         });
}

std::vector<double> FlutterStudy::relative_error() const {
  std::vector<double> errors;
  for (const double load : finite_element) errors.push_back(load / closed_form - 1.0);
  return errors;
}

FlutterStudy flutter_study(const data::Beam& beam, const std::vector<int>& elements) {
  FlutterStudy study{analytic::slip_critical_load(beam) / load_unit(beam), elements, {}, {}};
  std::vector<double> steps, errors;
  for (const int n : elements) {
    study.finite_element.push_back(finite_element_flutter(beam, n));
    steps.push_back(1.0 / n);
    errors.push_back(std::abs(study.finite_element.back() - study.closed_form));
  }
  study.observed_order = order_estimate(steps, errors);
  return study;
}

ModeShapeStudy mode_shape_study(const data::Beam& beam, int modes, int elements, int points) {
  ModeShapeStudy study;
  for (int i = 0; i < points; ++i) study.position.push_back(static_cast<double>(i) / (points - 1));
  const solver::BeamModel model(beam, elements);
  const auto stick = analytic::stick_modes(beam, modes);
  const auto slip = analytic::slip_modes(beam, modes);
  const FiniteElementModes stick_computed = solver::stick_modes(model, modes);
  const FiniteElementModes slip_computed = solver::slip_modes(model, modes);
  for (std::size_t i = 0; i < stick.size(); ++i) {
    study.curves.push_back(shape_curve(stick[i], stick_computed[i], model, false, study.position));
    study.curves.push_back(shape_curve(slip[i], slip_computed[i], model, true, study.position));
  }
  return study;
}

}  // namespace stickslip::studies
