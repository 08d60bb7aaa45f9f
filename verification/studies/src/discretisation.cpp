#include "stickslip/studies/discretisation.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

#include "simpson.hpp"

namespace stickslip::studies {

namespace {

using Complex = std::complex<double>;

// Eigenvalues of the map (q, h v, h^2 a)_n -> (q, h v, h^2 a)_(n+1) for a free vibration, written from the
// equations of Chung & Hulbert (1993).
Eigen::Vector3cd amplification_eigenvalues(double spectral_radius, double omega_times_step) {
  const double r = spectral_radius, k = omega_times_step * omega_times_step;
  const double am = (2.0 * r - 1.0) / (r + 1.0), af = r / (r + 1.0);
  const double gamma = 0.5 - am + af, beta = 0.25 * (1.0 - am + af) * (1.0 - am + af);
  const double divisor = (1.0 - am) + (1.0 - af) * beta * k;
  const Eigen::RowVector3d acceleration =
      -Eigen::RowVector3d(k, (1.0 - af) * k, am + (1.0 - af) * (0.5 - beta) * k) / divisor;
  Eigen::Matrix3d map;
  map.row(0) = Eigen::RowVector3d(1.0, 1.0, 0.5 - beta) + beta * acceleration;
  map.row(1) = Eigen::RowVector3d(0.0, 1.0, 1.0 - gamma) + gamma * acceleration;
  map.row(2) = acceleration;
  return map.eigenvalues();
}

}  // namespace

double hermite_eigenvalue_error(const data::Beam& beam, const analytic::StickMode& mode,
                                double element_length) {
  // U'''' = k U - p U'' from the eigenvalue problem.
  const double p = beam.axial_force() / (beam.youngs_modulus() * beam.second_moment_of_area());
  const double k = std::pow(mode.hyperbolic_wave_number() * mode.trigonometric_wave_number(), 2);
  const auto bending_square = [&](double x) {
    return std::pow(k * mode.shape(x) - p * mode.curvature(x), 2);
  };
  const double ratio = simpson_integral(bending_square, beam.length(), mode) / mode.norm_squared();
  return std::pow(element_length, 4) / 720.0 * ratio / k;
}

NumericalOscillation generalized_alpha_oscillation(double spectral_radius, double angular_frequency,
                                                   double time_step) {
  const Eigen::Vector3cd eigenvalues =
      amplification_eigenvalues(spectral_radius, angular_frequency * time_step);
  const Complex principal = *std::max_element(eigenvalues.begin(), eigenvalues.end(),
                                              [](Complex a, Complex b) { return a.imag() < b.imag(); });
  const Complex exponent = std::log(principal) / time_step;
  return {exponent.imag(), -exponent.real()};
}

std::vector<double> amplification_moduli(double spectral_radius, double omega_times_step) {
  const Eigen::Vector3d moduli = amplification_eigenvalues(spectral_radius, omega_times_step).cwiseAbs();
  std::vector<double> sorted(moduli.begin(), moduli.end());
  std::sort(sorted.rbegin(), sorted.rend());
  return sorted;
}

ForcedOscillation forced_from_rest(double omega, const NumericalOscillation& oscillation) {
  const double w = oscillation.angular_frequency, d = oscillation.decay_rate;
  const Complex steady = -1.0 / Complex(w * w + d * d - omega * omega, 2.0 * d * omega);
  const double initial = -steady.imag();
  const double initial_rate = -omega * steady.real();
  return {steady.real(), steady.imag(), (initial_rate + d * initial) / w, initial};
}

NumericalOscillation discrete_oscillation(const data::Beam& beam, const analytic::StickMode& mode,
                                          const data::NumericalSettings& numerics) {
  const double element_length = beam.length() / numerics.elements();
  const double on_mesh =
      mode.angular_frequency() * std::sqrt(1.0 + hermite_eigenvalue_error(beam, mode, element_length));
  return generalized_alpha_oscillation(numerics.spectral_radius(), on_mesh, numerics.time_step());
}

double drift_bound(const data::Beam& beam, const std::vector<analytic::StickMode>& modes,
                   const std::vector<analytic::Sinusoid>& transient, const data::NumericalSettings& numerics,
                   double duration) {
  double bound = 0.0;
  for (std::size_t n = 0; n < modes.size(); ++n) {
    const NumericalOscillation discrete = discrete_oscillation(beam, modes[n], numerics);
    const double phase = std::abs(discrete.angular_frequency - modes[n].angular_frequency()) * duration;
    const double decay = -std::expm1(-discrete.decay_rate * duration);
    bound += std::abs(transient[n].amplitude) * std::min(2.0, phase + decay);
  }
  return bound;
}

PredictedForce::PredictedForce(const data::Beam& beam, const data::HarmonicExcitation& excitation,
                               const data::NumericalSettings& numerics, int modes)
    : omega_(2.0 * std::numbers::pi * excitation.frequency_hz()),
      time_step_(numerics.time_step()),
      steps_(std::lround(numerics.duration() / numerics.time_step())) {
  const double stiffness = beam.youngs_modulus() * beam.second_moment_of_area();
  const double scale = stiffness * excitation.amplitude();
  const double element_length = beam.length() / numerics.elements();
  const analytic::StickResponse exact(beam, excitation, 3 * modes, analytic::SteadyPart::exact);
  const std::vector<analytic::Sinusoid> transient = exact.transient_force();
  static_amplitude_ = exact.steady_force_amplitude();
  for (std::size_t n = 0; n < transient.size(); ++n) {
    const double amplitude = std::abs(transient[n].amplitude);
    if (n >= static_cast<std::size_t>(modes)) {
      phase_uncertainty_ += 2.0 * amplitude;
      continue;
    }
    const analytic::StickMode& mode = exact.modes()[n];
    const double natural = mode.angular_frequency();
    const double weight =
        scale * mode.third_derivative(beam.length()) * omega_ * omega_ * mode.participation();
    const NumericalOscillation oscillation = discrete_oscillation(beam, mode, numerics);
    terms_.push_back({weight, forced_from_rest(omega_, oscillation), oscillation});
    // The exact steady amplitude holds this mode's undamped, exact share already.
    static_amplitude_ -= weight / (omega_ * omega_ - natural * natural);

    const double error = hermite_eigenvalue_error(beam, mode, element_length);
    const double next_term = std::pow(mode.trigonometric_wave_number() * element_length, 2) / 40.0;
    const double phase = 0.5 * natural * numerics.duration() * error * next_term;
    phase_uncertainty_ += amplitude * std::min(2.0, phase + error);
  }
  phase_uncertainty_ += exact.omitted_transient_bound();
}

double PredictedForce::uncertainty() const {
  const double step_angle = omega_ * time_step_;
  return phase_uncertainty_ + max_abs() * 0.25 * step_angle * step_angle;
}

double PredictedForce::max_abs() const {
  // Every sinusoid is advanced by one complex multiplication a step.
  struct Phasor {
    Complex value, factor;
  };
  // a sin + b cos is the real part of (b - i a) exp(i w t).
  Complex steady(0.0, -static_amplitude_);
  std::vector<Phasor> free;
  for (const Term& term : terms_) {
    const ForcedOscillation& forced = term.forced;
    steady += term.weight * Complex(forced.steady_cosine, -forced.steady_sine);
    const Complex exponent(-term.oscillation.decay_rate, term.oscillation.angular_frequency);
    free.push_back(
        {term.weight * Complex(forced.free_cosine, -forced.free_sine), std::exp(exponent * time_step_)});
  }
  const Complex turn = std::polar(1.0, omega_ * time_step_);
  double largest = 0.0;
  for (long n = 0; n <= steps_; ++n) {
    double force = steady.real();
    for (const Phasor& phasor : free) force += phasor.value.real();
    largest = std::max(largest, std::abs(force));
    steady *= turn;
    for (Phasor& phasor : free) phasor.value *= phasor.factor;
  }
  return largest;
}

}  // namespace stickslip::studies
