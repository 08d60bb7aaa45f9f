// SPDX-License-Identifier: MIT
#include "stickslip/analytic/band_maximum.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "arguments.hpp"
#include "stickslip/analytic/force_maximum.hpp"

namespace stickslip::analytic {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kWidthOfAValue = 1e-9;  // relative, of the bounds of |f_max| at one frequency

}  // namespace

BandMaximum::BandMaximum(const data::Beam& beam, const FrequencyBand& band, double duration, int modes)
    : BandMaximum(modal_reaction(beam, modes), band, duration) {}

BandMaximum::BandMaximum(const ModalReaction& reaction, const FrequencyBand& band, double duration)
    : reaction_(reaction), duration_(duration), best_omega_(kTwoPi * band.from_hz) {
  require(band.from_hz > 0.0, "band.from_hz", band.from_hz, "positive");
  require(band.to_hz >= band.from_hz && std::isfinite(band.to_hz), "band.to_hz", band.to_hz,
          "finite and not below band.from_hz");
  require_positive("excitation.duration", duration);
  const double from = kTwoPi * band.from_hz, to = kTwoPi * band.to_hz;
  marks_.push_back(from);
  for (const ModalForce& mode : reaction_.modes)
    if (from < mode.angular_frequency && mode.angular_frequency < to)
      marks_.push_back(mode.angular_frequency);
  marks_.push_back(to);
  for (std::size_t i = 1; i < marks_.size(); ++i) add(marks_[i - 1], marks_[i]);
}

/// A frequency, and what is known of the largest |f| there.
struct BandMaximum::Decided {
  double omega{};
  ForceMaximum force;
  double exceeded = 0.0;                                  // the largest limit that it is known to exceed
  double kept = std::numeric_limits<double>::infinity();  // the smallest that it is known not to
  [[nodiscard]] bool exceeds(double limit) {
    if (limit <= exceeded || limit >= kept) return limit <= exceeded;
    const bool above = force.exceeds(limit);
    (above ? exceeded : kept) = limit;
    return above;
  }
};

bool BandMaximum::exceeds(double limit) {
  constexpr int most_halvings = 8;
  bool sticks = true;
  for (std::size_t i = 1; sticks && i < marks_.size(); ++i)
    sticks = stays_below(marks_[i - 1], marks_[i], limit, most_halvings);
  if (sticks) return false;
  std::vector<Decided> ends;
  for (const double omega : marks_) {
    ends.push_back({omega, ForceMaximum(reaction_, omega, duration_)});
    if (ends.back().exceeds(limit)) return true;
  }
  for (std::size_t i = 1; i < ends.size(); ++i)
    if (rises_above(ends[i - 1], ends[i], limit)) return true;
  return false;
}

/// Whether |f| exceeds the limit between two frequencies where it does not.
bool BandMaximum::rises_above(Decided& from, Decided& to, double limit) const {
  constexpr double undecided = 1e-4;
  const Suprema most = between(from.omega, to.omega);
  if (most.force <= limit) return false;
  const double width = to.omega - from.omega, excess = width * width / 8.0 * most.curvature;
  const double enough = limit - excess;
  if (enough > 0.0 && !from.exceeds(enough) && !to.exceeds(enough)) return false;
  if (excess <= undecided * limit) return true;
  const double omega = from.omega + 0.5 * width;
  Decided middle{omega, ForceMaximum(reaction_, omega, duration_)};
  return middle.exceeds(limit) || rises_above(from, middle, limit) || rises_above(middle, to, limit);
}

/// Whether the bounds of between() say so on an interval or on its parts.
bool BandMaximum::stays_below(double from, double to, double limit, int halvings) const {
  if (between(from, to).force <= limit) return true;
  const double middle = from + 0.5 * (to - from);
  return halvings > 0 && between(middle, middle).force <= limit &&
         stays_below(from, middle, limit, halvings - 1) && stays_below(middle, to, limit, halvings - 1);
}

Bounds BandMaximum::refined_to(double relative_width) {
  return refined_against(std::numeric_limits<double>::quiet_NaN(), relative_width);
}

Bounds BandMaximum::refined_against(double limit, double relative_width) {
  require_relative_width(relative_width, 1e-7);
  Bounds now = bounds();
  while (now.upper - now.lower > relative_width * now.lower && !(now.lower > limit) &&
         !(now.upper <= limit)) {
    const Interval largest = intervals_.top();
    intervals_.pop();
    sharpen(largest);
    now = bounds();
  }
  return now;
}

double BandMaximum::frequency_hz() const { return best_omega_ / kTwoPi; }

Bounds BandMaximum::bounds() const { return {lower_, std::max(lower_, intervals_.top().upper)}; }

void BandMaximum::add(double from, double to) {
  intervals_.push({.from = from, .to = to, .ends_known = false, .upper = between(from, to).force});
}

/// Evaluates the ends of an interval or, if they are known, divides it.
void BandMaximum::sharpen(const Interval& interval) {
  const double from = interval.from, to = interval.to;
  if (interval.ends_known) {
    const double middle = from + 0.5 * (to - from);
    add(from, middle);
    add(middle, to);
    return;
  }
  const double excess = (to - from) * (to - from) / 8.0 * between(from, to).curvature;
  const double upper = std::max(upper_value(from), upper_value(to)) + excess;
  intervals_.push({from, to, true, std::min(interval.upper, upper)});
}

double BandMaximum::upper_value(double omega) {
  if (const auto known = values_.find(omega); known != values_.end()) return known->second;
  const Bounds value = ForceMaximum(reaction_, omega, duration_).refined_to(kWidthOfAValue);
  if (value.lower > lower_) {
    lower_ = value.lower;
    best_omega_ = omega;
  }
  return values_[omega] = value.upper;
}

BandMaximum::Suprema BandMaximum::between(double from, double to) const {
  const double t = duration_, a = from, b = to, middle = 0.5 * (a + b);
  double steady = reaction_.quasi_static;        // amplitude at Ω in the middle, of the modes apart
  double steady_slope = 0.0, steady_bend = 0.0;  // sums of |c p'| and |c p''|
  Suprema sum;
  for (const ModalForce& mode : reaction_.modes) {
    const double w = mode.angular_frequency, c = std::abs(mode.coefficient);
    const double near = (2.0 * t + 2.0 * b * t * t + b * b * t * t * t / 3.0) / w;
    const double x = std::max({0.0, a - w, w - b}) * (a + w);  // ≤ |Ω² - ω_n²|
    const double p1 = 2.0 * b * w * w / (x * x);
    const double p2 = 2.0 * w * w * (3.0 * b * b + w * w) / (x * x * x);
    const double q2 = 2.0 * w * b * (b * b + 3.0 * w * w) / (x * x * x);
    if (x > 0.0 && t * t * b * b / x + 2.0 * t * p1 + p2 + q2 < near) {
      steady += mode.coefficient * middle * middle / ((middle - w) * (middle + w));
      steady_slope += c * p1;
      steady_bend += c * p2;
      sum.force += c * b * b * b / (x * w);
      sum.curvature += c * q2;
    } else {
      sum.force += c * b * b * t / w;
      sum.curvature += c * near;
    }
  }
  const double amplitude = std::abs(steady) + 0.5 * (b - a) * steady_slope;
  sum.force += amplitude;
  sum.curvature += t * t * amplitude + 2.0 * t * steady_slope + steady_bend;
  return sum;
}

}  // namespace stickslip::analytic
