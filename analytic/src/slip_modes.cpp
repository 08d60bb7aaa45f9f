// SPDX-License-Identifier: MIT
#include "stickslip/analytic/slip_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "arguments.hpp"
#include "beam_constants.hpp"
#include "root_finding.hpp"

namespace stickslip::analytic {
namespace {

using std::numbers::pi;

/// P L²/EI of the strongest tension for which exp(-b) in the first mode can still be represented.
constexpr double kStrongestTension = -1e5;

/// P L²/EI above the flutter load of every direction; Beck's, 20.0510, is the highest.
constexpr double kStrongestCompression = 20.06;

/// Below the smaller wave number of every mode (about 1e-67 in the first one at the strongest tension), and
/// large enough for its fourth power: at P = 0 the characteristic function vanishes at 0 itself.
constexpr double kBelowEveryRoot = 1e-70;

/// z = P L²/EI and χ.
struct Load {
  double factor{}, direction{};
};

Load load_of(const data::Beam& beam) { return {axial_load_factor(beam), beam.axial_direction()}; }

/// Left side of the characteristic equation divided by cosh(b).
double characteristic(WaveNumbers wave_numbers, Load load) {
  const auto [b, bb] = wave_numbers;
  const auto [z, chi] = load;
  const double decaying = std::exp(-b), product = b * bb;
  const double sech = 2.0 * decaying / (1.0 + decaying * decaying);
  return z * z * ((1.0 - chi) * sech + chi * std::cos(bb)) +
         product *
             (2.0 * product * (sech + std::cos(bb)) + (1.0 - 2.0 * chi) * z * std::tanh(b) * std::sin(bb));
}

/// The characteristic function over the smaller wave number, where modes 2 pair - 1 and 2 pair lie:
/// (2 pair - 2) π < bb < 2 pair π.
class PairCharacteristic {
 public:
  PairCharacteristic(int pair, Load load)
      : load_(load),
        interval_{std::max(kBelowEveryRoot, smaller_wave_number((2.0 * pair - 2.0) * pi, load.factor)),
                  smaller_wave_number(2.0 * pair * pi, load.factor)} {}

  double operator()(double smaller) const {
    return characteristic(wave_numbers_from_smaller(smaller, load_.factor), load_);
  }

  /// Where the least value in the interval is: a scan finds its neighbourhood, Brent's method the rest.
  [[nodiscard]] double minimum() const {
    constexpr int kSteps = 64;
    const auto node = [this](int i) {
      return interval_.lower + (interval_.upper - interval_.lower) * i / kSteps;
    };
    int least = 0;
    for (int i = 1; i < kSteps; ++i)
      if ((*this)(node(i)) < (*this)(node(least))) least = i;
    if (least == 0) return interval_.lower;
    return brent_minimum(as_gsl_function(*this), {node(least - 1), node(least + 1)}, node(least));
  }

  /// The two roots, or nothing if they have become complex or the first imaginary.
  [[nodiscard]] std::optional<std::pair<double, double>> roots() const {
    constexpr double kTolerance = 4.0 * std::numeric_limits<double>::epsilon();
    if ((*this)(interval_.lower) <= 0.0) return std::nullopt;
    const double between = minimum();
    if ((*this)(between) >= 0.0) return std::nullopt;
    const gsl_function function = as_gsl_function(*this);
    return std::pair{brent_root(function, {interval_.lower, between}, kTolerance),
                     brent_root(function, {between, interval_.upper}, kTolerance)};
  }

 private:
  Load load_;
  Bounds interval_;
};

[[noreturn]] void throw_outside_range(const data::Beam& beam) {
  const double unit = bending_stiffness(beam) / (beam.length() * beam.length());
  throw data::FieldError("beam.axial_force", beam.axial_force(),
                         "below the " + std::string(buckles_in_slip(beam) ? "buckling" : "flutter") +
                             " load of the slip state, " + data::shortest_text(slip_critical_load(beam)) +
                             " N, and not below " + data::shortest_text(kStrongestTension * unit) + " N");
}

}  // namespace

double slip_characteristic(const data::Beam& beam, double omega) {
  const double length = beam.length();
  const double scaled = omega * length * length * std::sqrt(mass_per_length(beam) / bending_stiffness(beam));
  return characteristic(wave_numbers_at(scaled, axial_load_factor(beam)), load_of(beam));
}

bool buckles_in_slip(const data::Beam& beam) { return beam.axial_direction() >= 0.5; }

double slip_critical_load(const data::Beam& beam) {
  const double chi = beam.axial_direction(), unit = bending_stiffness(beam) / (beam.length() * beam.length());
  if (buckles_in_slip(beam)) return unit * std::pow(2.0 * std::acos(std::sqrt(1.0 - 0.5 / chi)), 2);
  const auto least_value = [chi](double z) {
    const PairCharacteristic pair(1, {z, chi});
    return pair(pair.minimum());
  };
  return unit * brent_root(as_gsl_function(least_value), {15.0, 25.0}, 1e-13);
}

SlipMode::SlipMode(const data::Beam& beam, int number, double b, double bb)
    : number_(number),
      length_(beam.length()),
      b_(b),
      bb_(bb),
      angular_frequency_(std::sqrt(bending_stiffness(beam) / mass_per_length(beam)) * b * bb /
                         (length_ * length_)) {
  const double e = std::exp(-b), c = std::cos(bb), s = std::sin(bb);
  // ψ''(L) = 0, and ψ*'' + (1 - χ) z ψ* = 0, give the ratio of the exponential parts.
  direct_ = clamped(b * b + bb * (bb * c + b * s) * e, -(b * b * e + bb * (bb * c - b * s)));
  const double fixed = beam.axial_direction() * axial_load_factor(beam);
  const double hyperbolic = (bb * bb - fixed) * bb, trigonometric = b * b + fixed;
  adjoint_ = clamped(hyperbolic + trigonometric * (bb * c + b * s) * e,
                     -(hyperbolic * e + trigonometric * (bb * c - b * s)));
}

SlipMode::Weights SlipMode::clamped(double left, double right) const {
  const double e = std::exp(-b_);
  Weights weights{left, right, -(left + right * e), b_ / bb_ * (left - right * e)};
  const double tip = value(weights, length_);
  for (double* weight : {&weights.left, &weights.right, &weights.cos, &weights.sin}) *weight /= tip;
  return weights;
}

double SlipMode::frequency_hz() const noexcept { return angular_frequency_ / (2.0 * pi); }

double SlipMode::value(const Weights& weights, double x) const {
  const double xi = x / length_;
  return weights.left * std::exp(-b_ * xi) + weights.right * std::exp(-b_ * (1.0 - xi)) +
         weights.cos * std::cos(bb_ * xi) + weights.sin * std::sin(bb_ * xi);
}

double SlipMode::curvature(double x) const {
  const double b2 = b_ * b_ / (length_ * length_), bb2 = bb_ * bb_ / (length_ * length_);
  return value({b2 * direct_.left, b2 * direct_.right, -bb2 * direct_.cos, -bb2 * direct_.sin}, x);
}

std::vector<SlipMode> slip_modes(const data::Beam& beam, int count) {
  require_mode_count(count);
  require_rigid_in_shear(beam);
  const double z = axial_load_factor(beam);
  if (z < kStrongestTension || z >= kStrongestCompression) throw_outside_range(beam);

  std::vector<SlipMode> modes;
  modes.reserve(static_cast<std::size_t>(count) + 1);
  for (int pair = 1; 2 * pair - 1 <= count; ++pair) {
    const auto roots = PairCharacteristic(pair, load_of(beam)).roots();
    if (!roots) throw_outside_range(beam);
    for (const auto& [number, smaller] : {std::pair{2 * pair - 1, roots->first}, {2 * pair, roots->second}}) {
      const auto [b, bb] = wave_numbers_from_smaller(smaller, z);
      if (number <= count) modes.push_back(SlipMode(beam, number, b, bb));
    }
  }
  return modes;
}

}  // namespace stickslip::analytic
