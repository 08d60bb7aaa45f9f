// SPDX-License-Identifier: MIT
#include "stickslip/analytic/stick_modes.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "arguments.hpp"
#include "beam_constants.hpp"
#include "root_finding.hpp"
#include "special_functions.hpp"

namespace stickslip::analytic {
namespace {

using std::numbers::pi;

/// z_cr = P_cr L²/EI = y²/(1 + s² y²), with y the first positive root of tan y = y/(1 + s² y²).
double buckling_load_factor(double s2) {
  const auto function = [s2](double y) { return (1.0 + s2 * y * y) * std::sin(y) - y * std::cos(y); };
  const double y =
      brent_root(as_gsl_function(function), {pi, 1.5 * pi}, 2.0 * std::numeric_limits<double>::epsilon());
  return y * y / (1.0 + s2 * y * y);
}

[[noreturn]] void throw_buckled(const data::Beam& beam) {
  throw data::FieldError(
      "beam.axial_force", beam.axial_force(),
      "below the buckling load of the stick state, " + data::shortest_text(stick_buckling_load(beam)) + " N");
}

/// tanh(b)/b, even and entire near the real axis.
double tanh_ratio(double b) { return b > 0.0 ? std::tanh(b) / b : 1.0; }

/// d/db tanh(b)/b = -(sinh 2b - 2b)/(2 b² cosh² b), without the cancellation at small b.
double tanh_ratio_derivative(double b) {
  const double sech = 1.0 / std::cosh(b);
  if (b < 1.0) return -4.0 * b * stumpff(3, -4.0 * b * b) * sech * sech;
  return (sech * sech - std::tanh(b) / b) / b;
}

/// The characteristic equation without poles, sin(bb) - bb cos(bb) tanh(b)/b, over the smaller wave number.
class StickCharacteristic {
 public:
  explicit StickCharacteristic(double z) : z_(z) {}

  [[nodiscard]] double value(double smaller) const {
    const auto [b, bb] = wave_numbers_from_smaller(smaller, z_);
    return std::sin(bb) - bb * std::cos(bb) * tanh_ratio(b);
  }

  [[nodiscard]] double derivative(double smaller) const {
    const auto [b, bb] = wave_numbers_from_smaller(smaller, z_);
    const double ratio = tanh_ratio(b);
    const double by_b = -bb * std::cos(bb) * tanh_ratio_derivative(b);
    const double by_bb = (1.0 - ratio) * std::cos(bb) + bb * std::sin(bb) * ratio;
    return z_ > 0.0 ? by_b + by_bb * b / bb : by_bb + by_b * bb / b;
  }

 private:
  double z_;
};

/// Where the smaller wave number of mode n lies alone: n π < bb < (n + 1/2) π.
Bounds stick_bracket(int n, double z) {
  return {smaller_wave_number(n * pi, z), smaller_wave_number((n + 0.5) * pi, z)};
}

/// sinh(b η)/sinh(b), 0 ≤ η ≤ 1, by decaying exponentials.
double sinh_ratio(double b, double eta) {
  return std::exp(-b * (1.0 - eta)) * std::expm1(-2.0 * b * eta) / std::expm1(-2.0 * b);
}

/// cosh(b η)/sinh(b), 0 ≤ η ≤ 1, by decaying exponentials.
double cosh_over_sinh(double b, double eta) {
  return -std::exp(-b * (1.0 - eta)) * (1.0 + std::exp(-2.0 * b * eta)) / std::expm1(-2.0 * b);
}

/// 1/sinh(b)².
double inverse_sinh_squared(double b) {
  const double inverse_sinh = cosh_over_sinh(b, 0.0);
  return inverse_sinh * inverse_sinh;
}

/// int_0¹ sinh(b η)² d(η)/sinh(b)² = (sinh 2b - 2b)/(4 b sinh² b), without the cancellation at small
/// b.
double hyperbolic_norm(double b) {
  if (b < 1.0) return 2.0 * b * b * stumpff(3, -4.0 * b * b) * inverse_sinh_squared(b);
  return 0.5 / (b * std::tanh(b)) - 0.5 * inverse_sinh_squared(b);
}

}  // namespace

double stick_buckling_load(const data::Beam& beam) {
  static const double rigid = buckling_load_factor(0.0);
  const double s2 = shear_flexibility(beam);
  return (s2 == 0.0 ? rigid : buckling_load_factor(s2)) * bending_stiffness(beam) /
         (beam.length() * beam.length());
}

void require_unbuckled(const data::Beam& beam) {
  if (beam.axial_force() >= stick_buckling_load(beam)) throw_buckled(beam);
}

QuasiStaticShape::QuasiStaticShape(const data::Beam& beam)
    : length_(beam.length()),
      load_factor_(axial_load_factor(beam)),
      decay_(std::sqrt(std::max(0.0, -load_factor_))) {
  require_rigid_in_shear(beam);
  require_unbuckled(beam);
  determinant_ = scaled(2, 1.0) - scaled(3, 1.0);
  if (!(determinant_ > 0.0)) throw_buckled(beam);
}

double QuasiStaticShape::scaled(int k, double eta) const {
  return scaled_stumpff(k, load_factor_ * eta * eta, decay_);
}

double QuasiStaticShape::value(double x) const {
  const double xi = x / length_, eta = 1.0 - xi;
  return -(xi * scaled(2, 1.0) - scaled(3, 1.0) + eta * eta * eta * scaled(3, eta)) / determinant_;
}

double QuasiStaticShape::slope(double x) const {
  const double eta = 1.0 - x / length_;
  return -(scaled(2, 1.0) - eta * eta * scaled(2, eta)) / (determinant_ * length_);
}

double QuasiStaticShape::curvature(double x) const {
  const double eta = 1.0 - x / length_;
  return -eta * scaled(1, eta) / (determinant_ * length_ * length_);
}

double QuasiStaticShape::third_derivative(double x) const {
  const double eta = 1.0 - x / length_;
  return scaled(0, eta) / (determinant_ * length_ * length_ * length_);
}

StickMode::StickMode(const data::Beam& beam, int number, double b, double bb)
    : number_(number),
      length_(beam.length()),
      bending_stiffness_(analytic::bending_stiffness(beam)),
      mass_per_length_(analytic::mass_per_length(beam)),
      axial_force_(beam.axial_force()),
      b_(b),
      bb_(bb),
      angular_frequency_(std::sqrt(bending_stiffness_ / mass_per_length_) * b * bb / (length_ * length_)) {
  const double tangent = bb * tanh_ratio(b);
  const double sign = number % 2 == 0 ? 1.0 : -1.0;
  cos_bb_ = sign / std::sqrt(1.0 + tangent * tangent);
  sin_bb_ = tangent * cos_bb_;
}

double StickMode::frequency_hz() const noexcept { return angular_frequency_ / (2.0 * pi); }

double StickMode::shape(double x) const {
  const double eta = 1.0 - x / length_;
  return sinh_ratio(b_, eta) - std::sin(bb_ * eta) / sin_bb_;
}

double StickMode::slope(double x) const {
  const double eta = 1.0 - x / length_;
  return (bb_ * std::cos(bb_ * eta) / sin_bb_ - b_ * cosh_over_sinh(b_, eta)) / length_;
}

double StickMode::curvature(double x) const {
  const double eta = 1.0 - x / length_;
  return (b_ * b_ * sinh_ratio(b_, eta) + bb_ * bb_ * std::sin(bb_ * eta) / sin_bb_) / (length_ * length_);
}

double StickMode::third_derivative(double x) const {
  const double eta = 1.0 - x / length_;
  const double hyperbolic = b_ * b_ * b_ * cosh_over_sinh(b_, eta);
  const double trigonometric = bb_ * bb_ * bb_ * std::cos(bb_ * eta) / sin_bb_;
  return -(hyperbolic + trigonometric) / (length_ * length_ * length_);
}

double StickMode::trigonometric_norm() const {
  return 0.5 / (sin_bb_ * sin_bb_) - 0.5 * cos_bb_ / (sin_bb_ * bb_);
}

double StickMode::norm_squared() const { return length_ * (hyperbolic_norm(b_) + trigonometric_norm()); }

double StickMode::slope_norm_squared() const {
  const double halves = b_ * b_ * inverse_sinh_squared(b_) + bb_ * bb_ / (sin_bb_ * sin_bb_);
  return (0.5 * halves - 1.0 / tanh_ratio(b_)) / length_;
}

double StickMode::curvature_norm_squared() const {
  const double b2 = b_ * b_, bb2 = bb_ * bb_;
  return (b2 * b2 * hyperbolic_norm(b_) + bb2 * bb2 * trigonometric_norm()) / (length_ * length_ * length_);
}

double StickMode::load_integral() const {
  return length_ * (1.0 / (b_ * b_) + 1.0 / (bb_ * bb_)) / tanh_ratio(b_);
}

double StickMode::condition_number() const {
  const double geometric = axial_force_ * slope_norm_squared();
  const double stiffness = bending_stiffness_ * curvature_norm_squared() - geometric;
  return 1.0 + 0.5 * std::abs(geometric / stiffness);
}

std::vector<StickMode> stick_modes(const data::Beam& beam, int count) {
  require_mode_count(count);
  require_rigid_in_shear(beam);
  require_unbuckled(beam);
  const double z = axial_load_factor(beam);
  const StickCharacteristic characteristic(z);
  // Positive at the start of the first bracket by theory; not so within round-off of the buckling load.
  if (!(characteristic.value(stick_bracket(1, z).lower) > 0.0)) throw_buckled(beam);

  std::vector<StickMode> modes;
  modes.reserve(static_cast<std::size_t>(count));
  for (int n = 1; n <= count; ++n) {
    const double smaller =
        newton_polished_root(as_gsl_function_with_derivative(characteristic), stick_bracket(n, z));
    const auto [b, bb] = wave_numbers_from_smaller(smaller, z);
    modes.push_back(StickMode(beam, n, b, bb));
  }
  return modes;
}

}  // namespace stickslip::analytic
