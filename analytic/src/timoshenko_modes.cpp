// SPDX-License-Identifier: MIT
#include "stickslip/analytic/timoshenko_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "arguments.hpp"
#include "beam_constants.hpp"
#include "root_finding.hpp"

namespace stickslip::analytic {
namespace {

using std::numbers::pi;

double squared_slenderness(const data::Beam& beam) {
  return beam.second_moment_of_area() / (beam.area() * beam.length() * beam.length());
}

/// The left sides divided by cosh(m), up to the cut-off frequency.
class TimoshenkoEquation {
 public:
  TimoshenkoEquation(double r2, double s2, TipSupport tip) : r2_(r2), s2_(s2), tip_(tip) {}

  /// B, the smaller root of r^2 s^2 B^2 - (1 + (r^2 + s^2) n^2) B + n^4 = 0.
  [[nodiscard]] double squared_frequency(double n) const {
    const double n2 = n * n, sum = 1.0 + (r2_ + s2_) * n2;
    return 2.0 * n2 * n2 / (sum + std::sqrt(1.0 + 2.0 * (r2_ + s2_) * n2 + std::pow((r2_ - s2_) * n2, 2)));
  }

  /// n at the cut-off frequency, where B r^2 s^2 = 1.
  [[nodiscard]] double cutoff() const { return std::sqrt((r2_ + s2_) / (r2_ * s2_)); }

  double operator()(double n) const {
    const double b = squared_frequency(n), m = std::sqrt(std::max(b * (1.0 - b * r2_ * s2_), 0.0)) / n;
    const double a = m * m + b * s2_, c = b / a;
    if (tip_ == TipSupport::held) return a * std::sin(n) - c * m / n * std::cos(n) * std::tanh(m);
    const double decaying = std::exp(-m), inverse_cosh = 2.0 * decaying / (1.0 + decaying * decaying);
    const double tanh_over_m = m == 0.0 ? 1.0 : std::tanh(m) / m;
    return 2.0 * inverse_cosh + (a / c + c / a) * std::cos(n) + (m * m / n - n) * tanh_over_m * std::sin(n);
  }

 private:
  double r2_, s2_;
  TipSupport tip_;
};

}  // namespace

double shear_flexibility(const data::Beam& beam, const ShearProperties& shear) {
  require_positive("shear.shear_coefficient", shear.shear_coefficient);
  if (!(shear.poisson_ratio > -1.0 && shear.poisson_ratio < 0.5))
    throw data::FieldError("shear.poisson_ratio", shear.poisson_ratio, "above -1 and below 0.5");
  return squared_slenderness(beam) * 2.0 * (1.0 + shear.poisson_ratio) / shear.shear_coefficient;
}

double timoshenko_cutoff(const data::Beam& beam, const ShearProperties& shear) {
  const double length = beam.length();
  return std::sqrt(bending_stiffness(beam) /
                   (mass_per_length(beam) * squared_slenderness(beam) * shear_flexibility(beam, shear))) /
         (length * length);
}

std::vector<double> timoshenko_frequencies(const data::Beam& beam, const ShearProperties& shear,
                                           TipSupport tip, int count) {
  constexpr double tolerance = 4.0 * std::numeric_limits<double>::epsilon();
  if (beam.axial_force() != 0.0) throw data::FieldError("beam.axial_force", beam.axial_force(), "0");
  const TimoshenkoEquation equation(squared_slenderness(beam), shear_flexibility(beam, shear), tip);
  const double unit =
      std::sqrt(bending_stiffness(beam) / mass_per_length(beam)) / (beam.length() * beam.length());
  std::vector<double> frequencies;
  for (int mode = 1; mode <= count; ++mode) {
    const double lower = (tip == TipSupport::held ? mode : std::max(mode - 1.0, 1e-3)) * pi;
    const double upper = std::min((tip == TipSupport::held ? mode + 0.5 : mode) * pi, equation.cutoff());
    if (lower >= upper || equation(lower) * equation(upper) > 0.0) break;
    const double n = brent_root(as_gsl_function(equation), {lower, upper}, tolerance);
    frequencies.push_back(unit * std::sqrt(equation.squared_frequency(n)));
  }
  if (count < 1 || static_cast<int>(frequencies.size()) < count)
    throw data::FieldError("numerics.modes", count,
                           count < 1 ? std::string("1 or more")
                                     : "at most " + std::to_string(frequencies.size()) +
                                           ", the number of modes below the cut-off frequency");
  return frequencies;
}

}  // namespace stickslip::analytic
