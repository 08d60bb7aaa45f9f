// SPDX-License-Identifier: MIT
#include "stickslip/analytic/band_maximum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "arguments.hpp"

namespace stickslip::analytic {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
// The bounds of |f_max| at one frequency are narrower than those of the band by this, but not below the least width.
constexpr double kShareOfWidth = 0.01, kLeastWidth = 1e-9;
constexpr double kWidthOfADampedValue = 1e-8;
// Of the bounds that decide whether a limit is exceeded: first wide ones, which mostly do, then narrow ones.
constexpr std::array kWidthsOfAnAnswer{1e-3, 1e-10};

}  // namespace

BandMaximum::BandMaximum(const ModalReaction& reaction, const FrequencyBand& band, double duration)
    : reaction_(reaction), duration_(duration) {
  std::vector<double> natural;
  for (const ModalForce& mode : reaction_.modes) natural.push_back(mode.angular_frequency);
  divide(band, natural);
}

BandMaximum::BandMaximum(const DampedReaction& reaction, const FrequencyBand& band, double duration,
                         DampedForcePart part)
    : damped_(reaction), part_(part), duration_(duration) {
  std::vector<double> natural;
  for (const auto& share : damped_->shares) natural.push_back(std::abs(share.eigenvalue));
  std::ranges::sort(natural);
  divide(band, natural);
}

void BandMaximum::divide(const FrequencyBand& band, const std::vector<double>& natural) {
  require(band.from_hz > 0.0, "band.from_hz", band.from_hz, "positive");
  require(band.to_hz >= band.from_hz && std::isfinite(band.to_hz), "band.to_hz", band.to_hz,
          "finite and not below band.from_hz");
  require_positive("excitation.duration", duration_);
  const double from = best_omega_ = kTwoPi * band.from_hz, to = kTwoPi * band.to_hz;
  order_ = data::derivatives(band.held);
  marks_.push_back(from);
  for (const double omega : natural)
    if (from < omega && omega < to) marks_.push_back(omega);
  marks_.push_back(to);
  for (std::size_t i = 1; i < marks_.size(); ++i) add(marks_[i - 1], marks_[i]);
}

double BandMaximum::weight(double omega) const { return std::pow(marks_.front() / omega, order_); }

// A frequency, and what is known of the largest w |f| there.
struct BandMaximum::Decided {
  double omega{}, weight{};  // rad/s
  // Of |f|: refined_to() of a ForceMaximum or DampedForce; nothing where `known` is all there is to know.
  std::function<Bounds(double relative_width, double enough, double too_much)> search;
  Bounds known{0.0, std::numeric_limits<double>::infinity()};
  /// Bounds that are found on the way to the answer are kept, up to an upper one of `enough`.
  [[nodiscard]] bool exceeds(double limit, double enough);
};

BandMaximum::Decided BandMaximum::force_at(double omega) const {
  Decided at{.omega = omega, .weight = weight(omega), .search = {}};
  const auto search_in = [&](auto force) {
    at.known.upper = at.weight * force.upper_bound();
    at.search = [force = std::move(force)](double width, double enough, double too_much) {
      return force.refined_to(width, enough, too_much);
    };
  };
  if (!damped_) {
    search_in(ForceMaximum(reaction_, omega, duration_));
    return at;
  }
  DampedForce force(*damped_, omega, duration_ * marks_.back() / omega);
  if (part_ == DampedForcePart::steady)
    at.known = at.weight * Bounds{force.steady_amplitude(), force.steady_amplitude()};
  else
    search_in(std::move(force));
  return at;
}

bool BandMaximum::Decided::exceeds(double limit, double enough) {
  for (const double width : kWidthsOfAnAnswer) {
    if (limit < known.lower || limit >= known.upper || !search) break;
    const Bounds found = weight * search(width, enough / weight, limit / weight);
    known.lower = std::max(known.lower, found.lower);
    if (found.lower <= limit) known.upper = std::min(known.upper, found.upper);
    enough = limit;
  }
  return search ? known.lower > limit : known.upper > limit;
}

bool BandMaximum::exceeds(double limit) {
  constexpr int most_halvings = 8;
  bool sticks = true;
  for (std::size_t i = 1; sticks && i < marks_.size(); ++i)
    sticks = stays_below(marks_[i - 1], marks_[i], limit, most_halvings);
  if (sticks) return false;
  std::vector<std::pair<double, std::size_t>> likely_first;  // ends, by falling bound of the force
  for (std::size_t i = 0; i < marks_.size(); ++i)
    likely_first.emplace_back(-between(marks_[i], marks_[i]).force, i);
  std::ranges::sort(likely_first);
  std::vector<Decided> ends(marks_.size());
  for (const auto& [bound, i] : likely_first) {
    ends[i] = force_at(marks_[i]);
    if (ends[i].exceeds(limit, limit)) return true;
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
  const double width = to.omega - from.omega, fall = from.weight / to.weight - 1.0;
  const double excess = width * width / 8.0 * most.curvature + 0.25 * fall * std::min(limit, to.known.upper);
  const double enough = limit - excess;
  if (enough > 0.0 && !from.exceeds(enough, enough) && !to.exceeds(enough, enough)) return false;
  if (excess <= undecided * limit) return true;
  const double omega = from.omega + 0.5 * width;
  Decided middle = force_at(omega);
  const double next = limit - 0.25 * excess;  // the least that the halves ask for
  return middle.exceeds(limit, next > 0.0 ? next : limit) || rises_above(from, middle, limit) ||
         rises_above(middle, to, limit);
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
    sharpen(largest, limit, relative_width);
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
void BandMaximum::sharpen(const Interval& interval, double limit, double relative_width) {
  const double from = interval.from, to = interval.to;
  if (interval.ends_known) {
    const double middle = from + 0.5 * (to - from);
    add(from, middle);
    add(middle, to);
    return;
  }
  const double excess = (to - from) * (to - from) / 8.0 * between(from, to).curvature;
  const double first = upper_value(from, excess, limit, relative_width),
               second = upper_value(to, excess, limit, relative_width);
  double upper = std::max(first, second) + excess;
  if (const double w1 = weight(from), w2 = weight(to); w1 > w2 && std::isfinite(upper))
    upper += 0.25 * (w1 - w2) * std::max(0.0, second / w2 - first / w1);
  intervals_.push({from, to, true, std::min(interval.upper, upper)});
}

/// Of |f_max| at Ω: sharp, or so low that it closes an interval with that excess; infinite where |f_max| exceeds the
/// limit.
double BandMaximum::upper_value(double omega, double excess, double limit, double relative_width) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double far_below =
      0.8;  // of the lower bound: what this leaves to the excess is as good as all of it
  const double width = std::max(kLeastWidth, kShareOfWidth * relative_width);
  const double enough =
      std::max(far_below * lower_, std::max((1.0 + relative_width) * lower_, limit) - excess);
  const auto known = values_.find(omega);
  if (known != values_.end() && (known->second.upper <= enough || known->second.width <= width))
    return known->second.upper;
  const Decided at = force_at(omega);
  const double sharp = damped_ ? std::max(kWidthOfADampedValue, width) : width;
  const Bounds value = at.search ? at.weight * at.search(sharp, enough / at.weight,
                                                         std::isnan(limit) ? infinity : limit / at.weight)
                                 : at.known;
  if (value.lower > lower_) {
    lower_ = value.lower;
    best_omega_ = omega;
  }
  if (at.search && value.lower > limit) return infinity;
  values_[omega] = {value.upper, at.search && value.upper <= enough ? infinity : width};
  return value.upper;
}

BandMaximum::Suprema BandMaximum::between(double from, double to) const {
  const Suprema most = damped_ ? damped_between(from, to) : undamped_between(from, to);
  return {weight(from) * most.force, weight(from) * most.curvature};
}

BandMaximum::Suprema BandMaximum::undamped_between(double from, double to) const {
  const double t = duration_, a = from, b = to, middle = 0.5 * (a + b);
  double steady =
      reaction_.quasi_static + reaction_.inertia * middle * middle;  // at Ω in the middle, of the modes apart
  double steady_slope = 2.0 * std::abs(reaction_.inertia) * b;       // sums of |c p'| and |c p''|
  double steady_bend = 2.0 * std::abs(reaction_.inertia);
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

BandMaximum::Suprema BandMaximum::damped_between(double from, double to) const {
  using Complex = std::complex<double>;
  constexpr double e = std::numbers::e;
  const double b = to, middle = 0.5 * (from + to);
  const Complex i(0.0, 1.0);
  Complex steady = -i * (damped_->quasi_static + damped_->inertia * middle * middle) + damped_->rate * middle;
  double slope = 2.0 * std::abs(damped_->inertia) * b + std::abs(damped_->rate);
  double bend = 2.0 * std::abs(damped_->inertia);
  Suprema sum;
  for (const auto& [eigenvalue, sine, cosine, start] : damped_->shares) {
    const double u = std::abs(sine), v = std::abs(cosine), decay = -eigenvalue.real();
    const double p = 0.5 * b * (v + b * u), p1 = 0.5 * v + b * u, p2 = u;  // |P| and its derivatives
    double value = 0.0, value1 = 0.0, value2 = 0.0;                        // of P/(±i Ω - λ)
    for (const double sign : {1.0, -1.0}) {
      const double natural = sign * eigenvalue.imag();
      const double d = std::hypot(decay, std::max({0.0, from - natural, natural - to}));
      value += p / d;
      value1 += p1 / d + p / (d * d);
      value2 += p2 / d + 2.0 * p1 / (d * d) + 2.0 * p / (d * d * d);
      const Complex share =
          0.5 * middle * (cosine - sign * i * middle * sine) / (sign * i * middle - eigenvalue);
      steady += sign > 0.0 ? share : std::conj(share);
    }
    slope += value1;
    bend += value2;
    if (part_ == DampedForcePart::steady) continue;
    const double ratio = std::abs(eigenvalue) / decay;
    sum.force += value;
    sum.curvature += value2 + 2.0 * value1 * ratio / (e * from) +
                     value * (4.0 * ratio * ratio / e + 2.0 * ratio) / (e * from * from);
  }
  sum.force += std::abs(steady) + 0.5 * (to - from) * slope;
  sum.curvature += bend;
  return sum;
}

}  // namespace stickslip::analytic
