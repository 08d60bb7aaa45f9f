// SPDX-License-Identifier: MIT
#include "studies/common/discretisation.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "stickslip/solver/decompositions.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

namespace {

using Complex = std::complex<double>;

// One time step of an oscillator by the equations of Chung & Hulbert (1993):
//
//     (q, h v, h² a)_(n+1) = map (q, h v, h² a)_n + load h² F(t_n + load_time h).
struct StepMap {
  Eigen::MatrixXd map;  // 3 x 3, of a type whose eigenvalues decompositions.hpp has
  Eigen::Vector3d load;
  double load_time;
};

StepMap step_map(double spectral_radius, double omega_times_step) {
  const auto [am, af, gamma, beta] = AlphaParameters(spectral_radius);
  const double k = omega_times_step * omega_times_step;
  const double divisor = (1.0 - am) + (1.0 - af) * beta * k;
  const Eigen::RowVector3d acceleration =
      -Eigen::RowVector3d(k, (1.0 - af) * k, am + (1.0 - af) * (0.5 - beta) * k) / divisor;
  Eigen::Matrix3d map;
  map.row(0) = Eigen::RowVector3d(1.0, 1.0, 0.5 - beta) + beta * acceleration;
  map.row(1) = Eigen::RowVector3d(0.0, 1.0, 1.0 - gamma) + gamma * acceleration;
  map.row(2) = acceleration;
  return {map, Eigen::Vector3d(beta, gamma, 1.0) / divisor, 1.0 - af};
}

Eigen::Vector3cd amplification_eigenvalues(double spectral_radius, double omega_times_step) {
  return step_map(spectral_radius, omega_times_step).map.eigenvalues();
}

// d = λ - 1 of the eigenvalue near `d`, by Newton's method on the characteristic equation of a step,
//
//     d² (1 + (1 - α_m) d) + k (1 + (1 - α_f) d) (1 + (1/2 + γ) d + β d²) = 0,   k = (ω h)².
//
// The eigenvalue of the matrix is known to eps/(ω h), which is more than the error of a short step.
Complex polished(double spectral_radius, double k, Complex d) {
  const AlphaParameters method(spectral_radius);
  const double m = 1.0 - method.alpha_m, f = 1.0 - method.alpha_f, g = 0.5 + method.gamma;
  for (int i = 0; i < 3; ++i) {
    const Complex inertia = 1.0 + m * d, force = 1.0 + f * d, newmark = 1.0 + g * d + method.beta * d * d;
    const Complex slope =
        d * (2.0 * inertia + m * d) + k * (f * newmark + force * (g + 2.0 * method.beta * d));
    if (slope == 0.0) break;
    d -= (d * d * inertia + k * force * newmark) / slope;
  }
  return d;
}

}  // namespace

double hermite_eigenvalue_error(const data::Beam& beam, const analytic::StickMode& mode,
                                double element_length) {
  // The eigenvalue problem gives U'''' = k U - p U''.
  const double p = beam.axial_force() / (beam.youngs_modulus() * beam.second_moment_of_area());
  const double k = std::pow(mode.hyperbolic_wave_number() * mode.trigonometric_wave_number(), 2);
  const auto bending_square = [&](double x) {
    return std::pow(k * mode.shape(x) - p * mode.curvature(x), 2);
  };
  const double ratio = simpson_integral(bending_square, beam.length(), mode) / mode.norm_squared();
  return std::pow(element_length, 4) / 720.0 * ratio / k;
}

Complex generalized_alpha_exponent(double spectral_radius, double angular_frequency, double time_step) {
  const double angle = angular_frequency * time_step;
  const Eigen::Vector3cd eigenvalues = amplification_eigenvalues(spectral_radius, angle);
  const Complex principal = *std::max_element(eigenvalues.begin(), eigenvalues.end(),
                                              [](Complex a, Complex b) { return a.imag() < b.imag(); });
  // In a very short step the matrix has a double eigenvalue but for rounding. The search then begins at exp(i ω h),
  // which is near the eigenvalue in short steps alone: from ω h = 0.3 on three steps of Newton's method are too few,
  // and from 2.2 on it ends at another eigenvalue (found by trial).
  const Complex start =
      angle < 1e-3 ? Complex(-2.0 * std::pow(std::sin(0.5 * angle), 2), std::sin(angle)) : principal - 1.0;
  const Complex d = polished(spectral_radius, angle * angle, start);
  return {0.5 * std::log1p(2.0 * d.real() + std::norm(d)) / time_step, std::arg(1.0 + d) / time_step};
}

std::vector<double> amplification_moduli(double spectral_radius, double omega_times_step) {
  const Eigen::Vector3d moduli = amplification_eigenvalues(spectral_radius, omega_times_step).cwiseAbs();
  std::vector<double> sorted(moduli.begin(), moduli.end());
  std::sort(sorted.rbegin(), sorted.rend());
  return sorted;
}

SteppedResponse stepped_from_rest(double spectral_radius, double natural_frequency, double omega,
                                  double time_step) {
  const StepMap step = step_map(spectral_radius, natural_frequency * time_step);
  const Complex rotation = std::polar(1.0, omega * time_step);
  const Complex load = -time_step * time_step * std::polar(1.0, omega * time_step * step.load_time);
  const Eigen::Vector3cd steady = (rotation * Eigen::Matrix3cd::Identity() - step.map.cast<Complex>())
                                      .partialPivLu()
                                      .solve(load * step.load);
  const Eigen::EigenSolver<Eigen::MatrixXd> eigen(step.map);
  const Eigen::Matrix3cd vectors = eigen.eigenvectors();
  const Eigen::Vector3cd start = -steady.imag().cast<Complex>();
  const Eigen::Vector3cd shares = vectors.partialPivLu().solve(start);
  SteppedResponse response{steady[0], {}};
  for (Eigen::Index j = 0; j < 3; ++j) {
    const Complex factor = eigen.eigenvalues()[j];
    if (factor.imag() < 0.0) continue;
    const double pair = factor.imag() > 0.0 ? 2.0 : 1.0;
    response.free.push_back({pair * shares[j] * vectors(0, j), factor});
  }
  return response;
}

double SteppedResponse::at(long n, double step_angle) const {
  const auto steps = static_cast<double>(n);
  double sum = (steady * std::polar(1.0, step_angle * steps)).imag();
  for (const Term& term : free) sum += (term.amplitude * std::pow(term.factor, steps)).real();
  return sum;
}

double frequency_on_mesh(const data::Beam& beam, const analytic::StickMode& mode, int elements) {
  return mode.angular_frequency() *
         std::sqrt(1.0 + hermite_eigenvalue_error(beam, mode, beam.length() / elements));
}

Complex discrete_exponent(const data::Beam& beam, const analytic::StickMode& mode,
                          const data::NumericalSettings& numerics) {
  return generalized_alpha_exponent(numerics.spectral_radius(),
                                    frequency_on_mesh(beam, mode, numerics.elements()), numerics.time_step());
}

double drift_bound(const data::Beam& beam, const std::vector<analytic::StickMode>& modes,
                   const std::vector<analytic::Sinusoid>& transient, const data::NumericalSettings& numerics,
                   double duration) {
  double bound = 0.0;
  for (std::size_t n = 0; n < modes.size(); ++n) {
    const Complex discrete = discrete_exponent(beam, modes[n], numerics);
    const double phase = std::abs(discrete.imag() - modes[n].angular_frequency()) * duration;
    const double decay = -std::expm1(discrete.real() * duration);
    bound += std::abs(transient[n].amplitude) * std::min(2.0, phase + decay);
  }
  return bound;
}

PredictedForce::PredictedForce(const data::Case& problem, int modes)
    : omega_(angular_frequency(problem.excitation())),
      time_step_(problem.numerics.time_step()),
      steps_(std::lround(problem.numerics.duration() / problem.numerics.time_step())) {
  const data::Beam& beam = problem.beam();
  const data::NumericalSettings& numerics = problem.numerics;
  const double element_length = beam.length() / numerics.elements();
  const analytic::StickResponse exact(beam, problem.excitation(), 3 * modes, analytic::SteadyPart::exact);
  const std::vector<analytic::Sinusoid> transient = exact.transient_force();
  const analytic::ModalReaction reaction = exact.reaction();
  rest_amplitude_ = exact.steady_force_amplitude();
  for (std::size_t n = 0; n < transient.size(); ++n) {
    const double amplitude = std::abs(transient[n].amplitude);
    if (n >= static_cast<std::size_t>(modes)) {
      phase_uncertainty_ += 2.0 * amplitude;
      continue;
    }
    const analytic::StickMode& mode = exact.modes()[n];
    const double natural = mode.angular_frequency();
    const double weight = problem.excitation().amplitude() * reaction.modes[n].coefficient * omega_ * omega_;
    terms_.push_back({weight, stepped_from_rest(numerics.spectral_radius(),
                                                frequency_on_mesh(beam, mode, numerics.elements()), omega_,
                                                numerics.time_step())});
    // The exact steady amplitude includes the undamped share of this mode. The term above replaces it.
    rest_amplitude_ -= weight / (omega_ * omega_ - natural * natural);

    const double error = hermite_eigenvalue_error(beam, mode, element_length);
    const double next_term = std::pow(mode.trigonometric_wave_number() * element_length, 2) / 40.0;
    const double phase = 0.5 * natural * numerics.duration() * error * next_term;
    phase_uncertainty_ += amplitude * std::min(2.0, phase + error);
  }
  phase_uncertainty_ += exact.omitted_transient_bound();
}

double PredictedForce::uncertainty() const {
  const double step_angle = omega_ * time_step_;
  return phase_uncertainty_ + std::abs(rest_amplitude_) * 0.125 * step_angle * step_angle;
}

double PredictedForce::max_abs() const {
  // Each sinusoid is advanced by one complex multiplication per step.
  Complex steady = rest_amplitude_;
  std::vector<SteppedResponse::Term> free;
  for (const Term& term : terms_) {
    steady += term.weight * term.response.steady;
    for (const SteppedResponse::Term& vibration : term.response.free)
      free.push_back({term.weight * vibration.amplitude, vibration.factor});
  }
  const Complex rotation = std::polar(1.0, omega_ * time_step_);
  double largest = 0.0;
  for (long n = 0; n <= steps_; ++n) {
    double force = steady.imag();
    for (const SteppedResponse::Term& vibration : free) force += vibration.amplitude.real();
    largest = std::max(largest, std::abs(force));
    steady *= rotation;
    for (SteppedResponse::Term& vibration : free) vibration.amplitude *= vibration.factor;
  }
  return largest;
}

}  // namespace stickslip::studies
