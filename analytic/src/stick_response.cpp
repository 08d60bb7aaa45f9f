// SPDX-License-Identifier: MIT
#include "stickslip/analytic/stick_response.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

#include "arguments.hpp"
#include "beam_constants.hpp"
#include "exact_steady_part.hpp"
#include "special_functions.hpp"

namespace stickslip::analytic {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// sinh(b η)/sinh(b), 0 ≤ η ≤ 1, for complex b with a real part that is not negative.
Complex sinh_ratio(Complex b, double eta) {
  if (std::abs(b) < 1.0) return std::sinh(b * eta) / std::sinh(b);
  return std::exp(-b * (1.0 - eta)) * (1.0 - std::exp(-2.0 * b * eta)) / (1.0 - std::exp(-2.0 * b));
}

/// The absolute steady shape Y of SteadyPart::exact at one complex frequency. Numerator and denominator are
/// divided by bb, and the larger wave number comes first, as in wave_numbers_at(), so that neither k -> 0 in
/// compression nor in tension divides 0 by 0.
class SteadyShape {
 public:
  /// scaled_frequency = ω L² √(ρ A/EI), not 0; load_factor = P L²/EI.
  SteadyShape(Complex scaled_frequency, double load_factor) {
    const double half = 0.5 * load_factor;
    const Complex root = std::sqrt(half * half + scaled_frequency * scaled_frequency);
    const Complex larger = std::sqrt(std::abs(half) + root), smaller = scaled_frequency / larger;
    b_ = load_factor > 0.0 ? smaller : larger;
    bb_ = load_factor > 0.0 ? larger : smaller;
    if (b_.real() < 0.0) b_ = -b_;
    q_ = b_ / std::tanh(b_);
    determinant_ = std::cos(bb_) - q_ * std::sin(bb_) / bb_;
  }

  /// Y, dimensionless.
  [[nodiscard]] Complex value(double eta) const {
    return (std::cos(bb_) * sinh_ratio(b_, eta) - q_ * std::sin(bb_ * eta) / bb_) / determinant_;
  }

  /// L Y'(L), dimensionless.
  [[nodiscard]] Complex slope_at_tip() const {
    return -(std::cos(bb_) * b_ * inverse_sinh() - q_) / determinant_;
  }

  /// L³ Y'''(L), dimensionless.
  [[nodiscard]] Complex third_derivative_at_tip() const {
    return -(std::cos(bb_) * b_ * b_ * b_ * inverse_sinh() + q_ * bb_ * bb_) / determinant_;
  }

 private:
  [[nodiscard]] Complex inverse_sinh() const {  // 1/sinh(b)
    return 2.0 * std::exp(-b_) / (1.0 - std::exp(-2.0 * b_));
  }

  Complex b_, bb_, q_, determinant_;  // q = b coth(b)
};

/// How many equal intervals a history is divided into, refused where that would never end.
std::int64_t interval_count(double duration, double step) {
  constexpr double kMost = 1e9;
  const double count = std::ceil(duration / step);
  if (!(count <= kMost))
    throw data::FieldError("excitation.duration", duration,
                           "at most " + data::shortest_text(kMost * step) + " s, a billion samples");
  return std::max<std::int64_t>(1, static_cast<std::int64_t>(count));
}

/// A0 times an amplitude per unit A0, which may be infinite at resonance; A0 = 0 moves nothing even there.
double scaled_by(double amplitude, double per_unit) { return amplitude == 0.0 ? 0.0 : amplitude * per_unit; }

}  // namespace

StickResponse::StickResponse(const data::Beam& beam, const data::HarmonicExcitation& excitation, int modes,
                             SteadyPart steady_part)
    : beam_(beam),
      amplitude_(excitation.amplitude()),
      omega_(2.0 * pi * excitation.frequency_hz()),
      steady_part_(steady_part),
      quasi_static_(beam),
      modes_(stick_modes(beam, modes)) {
  if (steady_part == SteadyPart::exact && modes_.back().angular_frequency() < 2.0 * omega_)
    throw data::FieldError("numerics.modes", modes,
                           "so large that the exact steady part at " +
                               data::shortest_text(excitation.frequency_hz()) +
                               " Hz has a mode at twice that frequency or above; the highest kept is at " +
                               data::shortest_text(modes_.back().frequency_hz()) + " Hz");
  force_.quasi_static = tip_reaction(beam, quasi_static_);
  for (const StickMode& mode : modes_)
    force_.modes.push_back({mode.angular_frequency(), tip_reaction(beam, mode) * mode.participation()});
  const double length = beam.length();
  complete(force_, [&](const SteadyShape& steady) {
    const Complex shear =
        bending_stiffness(beam) * steady.third_derivative_at_tip() / (length * length * length);
    return tip_reaction(beam, shear, steady.slope_at_tip() / length);
  });
}

/// The exact steady part, unless it is the modal sum; its amplitude is a function of SteadyShape.
template <class ExactAmplitude>
void StickResponse::complete(ModalReaction& sum, const ExactAmplitude& exact_amplitude) const {
  if (steady_part_ == SteadyPart::modal_sum) return;
  const double scale =
      beam_.length() * beam_.length() * std::sqrt(mass_per_length(beam_) / bending_stiffness(beam_));
  complete_steady_part(sum, omega_, [&](Complex frequency) {
    return exact_amplitude(SteadyShape(scale * frequency, axial_load_factor(beam_)));
  });
}

ModalReaction StickResponse::displacement(double x) const {
  ModalReaction sum{.quasi_static = quasi_static_.value(x), .modes = {}};
  for (const StickMode& mode : modes_)
    sum.modes.push_back({mode.angular_frequency(), mode.shape(x) * mode.participation()});
  complete(sum,
           [eta = 1.0 - x / beam_.length()](const SteadyShape& steady) { return steady.value(eta) - 1.0; });
  return sum;
}

double StickResponse::evaluate(const ModalReaction& sum, double t) const {
  const double sine = std::sin(omega_ * t);
  double value = sum.quasi_static * sine;
  for (const auto& [natural, coefficient] : sum.modes)
    value += coefficient * omega_ * omega_ * modal_coordinate(omega_, natural, t, sine);
  return value;
}

double StickResponse::steady_amplitude(const ModalReaction& sum) const {
  double amplitude = sum.quasi_static;
  for (const auto& [natural, coefficient] : sum.modes)
    amplitude += coefficient * omega_ * omega_ / ((omega_ - natural) * (omega_ + natural));
  return scaled_by(amplitude_, amplitude);
}

std::vector<Sinusoid> StickResponse::transient(const ModalReaction& sum) const {
  std::vector<Sinusoid> sinusoids;
  for (const auto& [natural, coefficient] : sum.modes) {
    const double per_unit =
        -coefficient * omega_ * omega_ * omega_ / ((omega_ - natural) * (omega_ + natural) * natural);
    sinusoids.push_back({scaled_by(amplitude_, per_unit), natural});
  }
  return sinusoids;
}

double StickResponse::base_displacement(double t) const { return amplitude_ * std::sin(omega_ * t); }

double StickResponse::relative_displacement(double x, double t) const {
  return amplitude_ * evaluate(displacement(x), t);
}

double StickResponse::absolute_displacement(double x, double t) const { return absolute_displacement(x)(t); }

std::function<double(double)> StickResponse::absolute_displacement(double x) const {
  return [this, sum = displacement(x)](double t) {
    return base_displacement(t) + amplitude_ * evaluate(sum, t);
  };
}

/// max |f''|/A0 over 0 ≤ t ≤ duration. A mode counts with the smaller of two bounds: with its two sinusoids apart,
/// the one at Ω joined with those of the other modes, or with both as one g_n.
double StickResponse::curvature_bound(double duration) const {
  double at_omega = force_.quasi_static, bound = 0.0;
  for (const auto& [natural, coefficient] : force_.modes) {
    const double weight = coefficient * omega_ * omega_;
    const double sum = omega_ + natural, difference = omega_ - natural;
    const double together = omega_ * (omega_ * duration + 1.0) / sum;
    const double apart = omega_ / std::abs(difference);
    if (apart < together) {
      at_omega += weight / (sum * difference);
      bound += std::abs(weight) * omega_ * natural / (sum * std::abs(difference));
    } else {
      bound += std::abs(weight) * together;
    }
  }
  return bound + std::abs(at_omega) * omega_ * omega_;
}

Bounds StickResponse::max_abs_friction_force(double duration, double relative_width) const {
  const Bounds per_unit = ForceMaximum(force_, omega_, duration).refined_to(relative_width);
  return amplitude_ * per_unit;
}

Bounds StickResponse::sampled_max_abs_friction_force(double duration, double sampling_step) const {
  require_positive("excitation.duration", duration);
  require_positive("sampling_step", sampling_step);
  const std::int64_t intervals = interval_count(duration, sampling_step);
  double lower = std::abs(evaluate(force_, duration));
  for (std::int64_t i = 0; i < intervals; ++i)
    lower = std::max(lower, std::abs(evaluate(force_, static_cast<double>(i) * sampling_step)));
  const double excess = curvature_bound(duration) * sampling_step * sampling_step / 8.0;
  return {amplitude_ * lower, amplitude_ * (lower + excess)};
}

double StickResponse::omitted_transient_bound() const {
  const StickMode& last = modes_.back();
  const double bb = last.trigonometric_wave_number() * beam_.length();
  if (omega_ >= last.angular_frequency() || std::abs(axial_load_factor(beam_)) >= bb * bb)
    return std::numeric_limits<double>::infinity();
  return 2.0 * std::abs(transient_force().back().amplitude) * last.number() / 3.0;
}

}  // namespace stickslip::analytic
