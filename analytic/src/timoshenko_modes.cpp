// SPDX-License-Identifier: MIT
#include "stickslip/analytic/timoshenko_modes.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>

#include "arguments.hpp"
#include "beam_constants.hpp"
#include "exact_steady_part.hpp"
#include "root_finding.hpp"
#include "special_functions.hpp"
#include "stickslip/analytic/stick_modes.hpp"

namespace stickslip::analytic {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

constexpr double root_tolerance = 4.0 * std::numeric_limits<double>::epsilon();

/// C = cosh(√q) and T = sinh(√q)/√(q), both times `scale`, with which neither overflows.
struct Functions {
  Complex scale, cosh, sinh_over_root;
};

Functions functions_of(Complex q) {
  const Complex root = std::sqrt(q);
  if (q.real() > 1.0) {
    const Complex scale = std::exp(-root);
    return {scale, 0.5 * (1.0 + scale * scale), 0.5 * (1.0 - scale * scale) / root};
  }
  return {1.0, std::cosh(root), root == 0.0 ? 1.0 : std::sinh(root) / root};
}

/// The numbers of the header, and its formulas over B.
class TimoshenkoBeam {
 public:
  explicit TimoshenkoBeam(const data::Beam& beam)
      : r2_(beam.second_moment_of_area() / (beam.area() * beam.length() * beam.length())),
        s2_(shear_flexibility(beam)),
        z_(axial_load_factor(beam)),
        e_(1.0 - z_ * s2_),
        follower_(1.0 - beam.axial_direction()) {}

  [[nodiscard]] double cutoff() const { return 1.0 / (r2_ * s2_); }

  /// f L³/EI as numerator over determinant, for a complex B.
  struct Force {
    Complex numerator, determinant;
  };

  [[nodiscard]] Force force(Complex b) const {
    const Complex half = 0.5 * (b * s2_ + z_ + b * r2_ * e_) / e_, product = b * (1.0 - b * r2_ * s2_) / e_;
    const Complex root = std::sqrt(half * half + product);
    const bool negative_is_larger = half.real() > 0.0;
    const Complex larger = negative_is_larger ? half + root : root - half;
    const Complex q1 = negative_is_larger ? product / larger : larger;
    const Complex q2 = negative_is_larger ? -larger : -product / larger;
    Complex a1 = e_ * q1 + b * s2_, a2 = e_ * q2 + b * s2_;
    // The smaller one by the product, without a difference.
    std::abs(a1) > std::abs(a2) ? a2 = -b / a1 : a1 = -b / a2;
    const Functions first = functions_of(q1), second = functions_of(q2);
    const Complex c1 = first.cosh * second.scale, c2 = second.cosh * first.scale;
    return {b * ((a1 + follower_ * z_) * c1 - (a2 + follower_ * z_) * c2),
            q1 * first.sinh_over_root * a2 * second.cosh - q2 * second.sinh_over_root * a1 * first.cosh};
  }

  [[nodiscard]] double static_force() const {
    const double q = z_ / e_, c0 = stumpff(0, q);
    return e_ * e_ * (1.0 - (1.0 - follower_) * (1.0 - c0)) / (stumpff(2, q) - stumpff(3, q) + s2_ * e_ * c0);
  }

  /// Residue of the force at a root B of the determinant, over B.
  [[nodiscard]] double share(double b) const {
    const double step = 1e-30 * b;
    const double slope = force(Complex(b, step)).determinant.imag() / step;
    return force(b).numerator.real() / (b * slope);
  }

  /// The first `count` values of B with the tip held.
  [[nodiscard]] std::vector<double> held(int count) const {
    std::vector<double> pinned{cutoff()}, found;
    for (int j = 1; j <= count + 1; ++j) {
      const double n2 = j * pi * j * pi, sum = 1.0 + n2 * (s2_ + r2_ * e_);
      const double root = std::sqrt(sum * sum - 4.0 * r2_ * s2_ * n2 * (e_ * n2 - z_));
      pinned.push_back(2.0 * n2 * (e_ * n2 - z_) / (sum + root));
      pinned.push_back(0.5 * (sum + root) / (r2_ * s2_));
    }
    std::ranges::sort(pinned);
    pinned.front() =
        std::max(pinned.front(), 1e-12 * pinned[1]);  // below 0 over the buckling load of that beam
    const auto determinant = [this](double b) { return force(b).determinant.real(); };
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const double lower = pinned[i], upper = pinned[i + 1] * (1.0 - 1e-12);
      // D is positive at the first end and changes its sign from end to end, once each. Where it has not yet the other sign
      // short of the upper end, the root is within rounding of the lower one: where s² is large, the clamp holds next to
      // nothing.
      const bool is_even = i % 2 == 0;
      if ((determinant(lower) > 0.0) == is_even && (determinant(upper) < 0.0) == is_even)
        found.push_back(brent_root(as_gsl_function(determinant), {lower, upper}, root_tolerance));
      else
        found.push_back(lower);
    }
    return found;
  }

  /// The first values of B with the tip free and P = 0, up to the cut-off, by m² = q_1 and n² = -q_2: a root of
  /// 2 + (a/c + c/a) cosh(m) cos(n) + (m/n - n/m) sinh(m) sin(n) = 0, a = a_1, c = -a_2 = B/a, in each
  /// (j - 1) π < n < j π.
  [[nodiscard]] std::vector<double> free(int count) const {
    const auto squared = [this](double n) {
      const double n2 = n * n, sum = 1.0 + (r2_ + s2_) * n2;
      return 2.0 * n2 * n2 / (sum + std::sqrt(1.0 + 2.0 * (r2_ + s2_) * n2 + std::pow((r2_ - s2_) * n2, 2)));
    };
    const auto equation = [&](double n) {  // over cosh(m)
      const double b = squared(n), m = std::sqrt(std::max(b * (1.0 - b * r2_ * s2_), 0.0)) / n;
      const double a = m * m + b * s2_, c = b / a;
      const double decaying = std::exp(-m), inverse_cosh = 2.0 * decaying / (1.0 + decaying * decaying);
      const double tanh_over_m = m == 0.0 ? 1.0 : std::tanh(m) / m;
      return 2.0 * inverse_cosh + (a / c + c / a) * std::cos(n) + (m * m / n - n) * tanh_over_m * std::sin(n);
    };
    const double last = std::sqrt((r2_ + s2_) / (r2_ * s2_));  // n at the cut-off
    std::vector<double> found;
    for (int j = 1; j <= count; ++j) {
      const double lower = std::max(j - 1.0, 1e-3) * pi, upper = std::min(j * pi, last);
      if (lower >= upper || equation(lower) * equation(upper) > 0.0) break;
      found.push_back(squared(brent_root(as_gsl_function(equation), {lower, upper}, root_tolerance)));
    }
    return found;
  }

 private:
  double r2_, s2_, z_, e_, follower_;
};

/// ω² at B = 1.
double squared_unit(const data::Beam& beam) {
  return bending_stiffness(beam) / (mass_per_length(beam) * std::pow(beam.length(), 4));
}

/// EI/L³.
double force_unit(const data::Beam& beam) { return bending_stiffness(beam) / std::pow(beam.length(), 3); }

TimoshenkoBeam checked(const data::Beam& beam) {
  require_positive("beam.shear_stiffness", beam.shear_stiffness());
  require_unbuckled(beam);
  return TimoshenkoBeam(beam);
}

}  // namespace

std::vector<double> timoshenko_frequencies(const data::Beam& beam, TipSupport tip, int count) {
  require_mode_count(count);
  const TimoshenkoBeam timoshenko = checked(beam);
  if (tip == TipSupport::free && beam.axial_force() != 0.0)
    throw data::FieldError("beam.axial_force", beam.axial_force(),
                           "0 for the closed form of a tip that slides, with a beam.shear_stiffness; finite "
                           "elements (--method fe) have both");
  std::vector<double> frequencies = tip == TipSupport::held ? timoshenko.held(count) : timoshenko.free(count);
  if (static_cast<int>(frequencies.size()) < count)
    throw data::FieldError("numerics.modes", count,
                           "at most " + std::to_string(frequencies.size()) +
                               ", the number of modes below the cut-off frequency");
  for (double& value : frequencies) value = std::sqrt(value * squared_unit(beam));
  return frequencies;
}

ModalReaction timoshenko_reaction(const data::Beam& beam, int modes) {
  const TimoshenkoBeam timoshenko = checked(beam);
  require_mode_count(modes);
  ModalReaction reaction{.quasi_static = force_unit(beam) * timoshenko.static_force(), .modes = {}};
  for (const double b : timoshenko.held(modes))
    reaction.modes.push_back({std::sqrt(b * squared_unit(beam)), force_unit(beam) * timoshenko.share(b)});
  return reaction;
}

ModalReaction timoshenko_reaction(const data::Beam& beam, int modes, double omega) {
  ModalReaction reaction = timoshenko_reaction(beam, modes);
  if (reaction.modes.back().angular_frequency < 2.0 * omega)
    throw data::FieldError("numerics.modes", modes,
                           "so large that one of them has twice the excitation frequency or more");
  const TimoshenkoBeam timoshenko(beam);
  complete_steady_part(reaction, omega, [&](Complex frequency) {
    const auto exact = timoshenko.force(frequency * frequency / squared_unit(beam));
    return force_unit(beam) * exact.numerator / exact.determinant;
  });
  return reaction;
}

double timoshenko_steady_force(const data::Beam& beam, double omega) {
  const auto force = checked(beam).force(omega * omega / squared_unit(beam));
  return force_unit(beam) * (force.numerator / force.determinant).real();
}

double timoshenko_omitted_transient(const ModalReaction& reaction, double omega) {
  const std::size_t count = reaction.modes.size();
  double largest = 0.0;
  for (std::size_t i = count - std::min<std::size_t>(count, 4); i < count; ++i) {
    const auto& [natural, coefficient] = reaction.modes[i];
    if (natural <= omega) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, std::abs(coefficient * std::pow(omega, 3) /
                                         ((natural - omega) * (natural + omega) * natural)));
  }
  return largest * static_cast<double>(count);
}

}  // namespace stickslip::analytic
