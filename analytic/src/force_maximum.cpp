// SPDX-License-Identifier: MIT
#include "stickslip/analytic/force_maximum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "arguments.hpp"
#include "special_functions.hpp"

namespace stickslip::analytic {
namespace {

constexpr double kUnitRoundoff = 0.5 * std::numeric_limits<double>::epsilon();
constexpr double kMostGridPoints = 1e9;
// The chord bound of the grid may leave this share of the largest value seen: less makes the grid finer, more
// leaves more pieces to the search behind it. Measured, flat between 0.1 and 0.3.
constexpr double kGridExcess = 0.2;
constexpr std::size_t kBlock = 64;  // grid points that share their sines; a power of 2

/// A value per grid point of a block.
using Row = std::array<double, kBlock>;

/// sin(w i h) and cos(w i h) for i = 0 ... kBlock - 1, by doubling the angle's multiples.
void tabulate(double angle, Row& sine, Row& cosine) {
  sine[0] = 0.0;
  cosine[0] = 1.0;
  for (std::size_t half = 1; half < kBlock; half *= 2) {
    const double s = std::sin(static_cast<double>(half) * angle);
    const double c = std::cos(static_cast<double>(half) * angle);
    for (std::size_t i = 0; i < half; ++i) {
      sine[half + i] = sine[i] * c + cosine[i] * s;
      cosine[half + i] = cosine[i] * c - sine[i] * s;
    }
  }
}

}  // namespace

ForceMaximum::ForceMaximum(const ModalReaction& reaction, double angular_frequency, double duration)
    : duration_(duration) {
  require_positive("excitation.frequency_hz", angular_frequency);
  require_positive("excitation.duration", duration);
  const double omega = angular_frequency;
  double steady = reaction.quasi_static;
  double cancelled = std::abs(steady);  // the sum of the absolute values of what makes the steady amplitude
  sinusoids_.reserve(reaction.modes.size() + 1);
  sinusoids_.push_back({0.0, omega});
  for (const ModalForce& mode : reaction.modes) {
    const double natural = mode.angular_frequency;
    const double sum = omega + natural, difference = omega - natural;
    const double shared = mode.coefficient * omega * omega / sum;
    if (std::abs(difference) * duration < 2.0) {
      beats_.push_back({shared, 0.5 * sum, 0.5 * difference});
      sinusoids_.push_back({-shared / natural, natural});
      continue;
    }
    steady += shared / difference;
    cancelled += std::abs(shared / difference);
    sinusoids_.push_back({-shared * omega / (difference * natural), natural});
  }
  sinusoids_.front().amplitude = steady;
  std::sort(sinusoids_.begin() + 1, sinusoids_.end(), [](const Sinusoid& one, const Sinusoid& other) {
    return std::abs(one.amplitude) > std::abs(other.amplitude);
  });

  Truncation kept;
  // In units of kUnitRoundoff. A phase w t is wrong by up to w T: twice on the grid, once in the slope and
  // the curvature of a parabola, once in where a piece of time ends.
  constexpr double phases = 4.0;
  double rounding = 0.0;
  const auto operations = static_cast<double>(sinusoids_.size() + beats_.size()) + 10.0;
  for (const Beat& beat : beats_) {
    // |e| ≤ E, |e'| ≤ 1, |e''| ≤ δ, |e'''| ≤ δ²
    const double b = std::abs(beat.amplitude), sigma = beat.mean, delta = std::abs(beat.detuning);
    const double largest = delta * duration > 1.0 ? 1.0 / delta : duration;
    kept.curvature += b * (delta + 2.0 * sigma + largest * sigma * sigma);
    kept.third += b * (delta * delta + 3.0 * sigma * (delta + sigma) + largest * sigma * sigma * sigma);
    rounding += b * largest * (phases * sigma * duration + operations);
  }
  for (const Sinusoid& term : sinusoids_) {
    const double a = std::abs(term.amplitude), w = term.angular_frequency;
    kept.curvature += a * w * w;
    kept.third += a * w * w * w;
    rounding += a * (phases * w * duration + operations * std::min(1.0, w * duration));
    truncations_.push_back(kept);
  }
  rounding_ = kUnitRoundoff * (rounding + operations * cancelled * std::min(1.0, omega * duration));
  double rest = 0.0;
  for (std::size_t k = sinusoids_.size(); k-- > 0;) {
    truncations_[k].rest = rest;
    rest += std::abs(sinusoids_[k].amplitude);
  }
}

double ForceMaximum::beats(double t) const {
  double sum = 0.0;
  for (const Beat& beat : beats_)
    sum += beat.amplitude * t * sinc(beat.detuning * t) * std::cos(beat.mean * t);
  return sum;
}

Jet ForceMaximum::jet(double t, std::size_t terms) const {
  Jet sum;
  for (const Beat& beat : beats_) {
    const double sigma = beat.mean, delta = beat.detuning;
    const double c = std::cos(sigma * t), s = std::sin(sigma * t);
    const double e = t * sinc(delta * t), e_slope = std::cos(delta * t);
    sum.value += beat.amplitude * e * c;
    sum.slope += beat.amplitude * (e_slope * c - sigma * e * s);
    sum.curvature -= beat.amplitude * ((delta * delta + sigma * sigma) * e * c + 2.0 * sigma * e_slope * s);
  }
  for (std::size_t n = 0; n < terms; ++n) {
    const auto& [a, w] = sinusoids_[n];
    const double s = a * std::sin(w * t), c = a * std::cos(w * t);
    sum.value += s;
    sum.slope += w * c;
    sum.curvature -= w * w * s;
  }
  return sum;
}

double ForceMaximum::value(double t) const { return jet(t, sinusoids_.size()).value; }

/// One search. A piece of time whose upper bound does not exceed the larger of `enough_` and
/// lower (1 + relative width) is done with; a lower bound above `too_much_` ends it.
class ForceMaximum::Search {
 public:
  Search(const ForceMaximum& force, double relative_width, double enough, double too_much)
      : force_(force), relative_width_(relative_width), enough_(enough), too_much_(too_much) {
    centres_ = on_a_grid();
    while (!centres_.empty() && lower_ <= too_much_) halve();
  }

  [[nodiscard]] Bounds bounds() const { return {lower_, std::max(lower_, upper_)}; }

 private:
  [[nodiscard]] const Truncation& truncation(std::size_t terms) const {
    return force_.truncations_[terms - 1];
  }

  void see(double value, double uncertainty) { lower_ = std::max(lower_, std::abs(value) - uncertainty); }

  /// Whether a piece is done with, which it then is.
  bool drop(double upper) {
    if (upper > std::max(enough_, (1.0 + relative_width_) * lower_ + 2.0 * force_.rounding_)) return false;
    upper_ = std::max(upper_, upper);
    return true;
  }

  /// How many terms make a grid cheapest whose chord bound leaves `excess`.
  [[nodiscard]] std::size_t cheapest_terms(double excess) const {
    std::size_t best = force_.sinusoids_.size();
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k <= force_.sinusoids_.size(); ++k) {
      const double left = excess - truncation(k).rest;
      if (left <= 0.0) continue;
      const double cost = static_cast<double>(k) * std::sqrt(truncation(k).curvature / left);
      if (cost < lowest) lowest = cost, best = k;
    }
    return best;
  }

  /// How many terms bound a piece of half-width r about as well as any number does.
  [[nodiscard]] std::size_t sufficient_terms(double r) const {
    const auto excess = [&](std::size_t k) {
      return truncation(k).third * r * r * r / 6.0 + truncation(k).rest;
    };
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k <= force_.sinusoids_.size(); ++k) least = std::min(least, excess(k));
    std::size_t terms = 1;
    while (excess(terms) > 1.25 * least) ++terms;
    return terms;
  }

  /// Centres of the pieces that a grid leaves; radius_ is their half-width.
  std::vector<double> on_a_grid() {
    const double excess = kGridExcess * std::max(first_look(), enough_);
    const std::size_t terms = cheapest_terms(excess);
    const double step = std::sqrt(8.0 * (excess - truncation(terms).rest) / truncation(terms).curvature);
    const double count = std::ceil(force_.duration_ / step);
    if (!(count <= kMostGridPoints))
      throw data::FieldError(
          "excitation.duration", force_.duration_,
          "at most " + data::shortest_text(kMostGridPoints * step) + " s, a billion points");
    const auto intervals = std::max<std::size_t>(1, static_cast<std::size_t>(count));
    const double h = force_.duration_ / static_cast<double>(intervals);
    radius_ = 0.5 * h;

    const double chord = truncation(terms).curvature * h * h / 8.0;
    const double uncertainty = truncation(terms).rest + force_.rounding_;
    std::vector<double> ends;  // |f_k| at the grid points
    ends.reserve(intervals + kBlock);
    sample(h, intervals + 1, terms, ends);
    if (lower_ > too_much_) return {};
    see(force_.value(h * static_cast<double>(std::max_element(ends.begin(), ends.end()) - ends.begin())),
        force_.rounding_);

    std::vector<double> left;
    for (std::size_t i = 0; i < intervals; ++i)
      if (!drop(std::max(ends[i], ends[i + 1]) + chord + uncertainty))
        left.push_back((static_cast<double>(i) + 0.5) * h);
    return left;
  }

  /// The largest of a few values, as a scale.
  double first_look() {
    constexpr int looks = 24;
    for (int i = 1; i <= looks && lower_ <= too_much_; ++i)
      see(force_.value(force_.duration_ * i / looks), force_.rounding_);
    return lower_;
  }

  /// |f_k| at 0, h, ... into `values`, `count` of them or until there is too much.
  void sample(double h, std::size_t count, std::size_t terms, std::vector<double>& values) {
    std::vector<Row> sines(terms), cosines(terms);
    for (std::size_t n = 0; n < terms; ++n)
      tabulate(force_.sinusoids_[n].angular_frequency * h, sines[n], cosines[n]);
    const double uncertainty = truncation(terms).rest + force_.rounding_;
    Row block;
    while (values.size() < count && lower_ <= too_much_) {
      const auto first = static_cast<double>(values.size());
      block.fill(0.0);
      for (std::size_t n = 0; n < terms; ++n) {
        const auto& [a, w] = force_.sinusoids_[n];
        const double s = a * std::sin(w * h * first), c = a * std::cos(w * h * first);
        for (std::size_t i = 0; i < kBlock; ++i) block[i] += s * cosines[n][i] + c * sines[n][i];
      }
      if (!force_.beats_.empty())
        for (std::size_t i = 0; i < kBlock; ++i)
          block[i] += force_.beats(h * (first + static_cast<double>(i)));
      double largest = 0.0;
      const std::size_t used = std::min(kBlock, count - values.size());
      for (std::size_t i = 0; i < used; ++i) largest = std::max(largest, std::abs(block[i]));
      for (std::size_t i = 0; i < used; ++i) values.push_back(std::abs(block[i]));
      see(largest, uncertainty);
    }
  }

  /// Judges every piece by its parabola; what is not done with is closed by its peak or divided.
  void halve() {
    const std::size_t terms = sufficient_terms(radius_);
    const Truncation& kept = truncation(terms);
    const double uncertainty = kept.rest + force_.rounding_;
    const double excess = kept.third * radius_ * radius_ * radius_ / 6.0 + uncertainty;
    std::vector<double> left;
    for (const double t : centres_) {
      const Jet at = force_.jet(t, terms);
      see(at.value, uncertainty);
      if (lower_ > too_much_) return;
      const double upper = largest_parabola(at.value, at.slope, at.curvature, radius_) + excess;
      if (drop(upper)) continue;
      if (terms == force_.sinusoids_.size() && close_by_peak(t, at)) continue;
      left.push_back(t - 0.5 * radius_);
      left.push_back(t + 0.5 * radius_);
    }
    centres_ = std::move(left);
    radius_ *= 0.5;
  }

  /// Newton's method for the largest |f| of a piece on which f is concave away from zero.
  bool close_by_peak(double centre, Jet at) {
    const double third = truncation(force_.sinusoids_.size()).third;
    const double bend = std::abs(at.curvature) - third * radius_;  // m
    const double lowest = std::abs(at.value) - std::abs(at.slope) * radius_ -
                          0.5 * (std::abs(at.curvature) + third * radius_) * radius_ * radius_;
    if (!(at.value * at.curvature < 0.0 && bend > 0.25 * std::abs(at.curvature) && lowest > 0.0))
      return false;
    double t = centre;
    for (int iteration = 0; iteration < 6; ++iteration) {
      const double next = std::clamp(t - at.slope / at.curvature, centre - radius_, centre + radius_);
      const double outward = next > centre ? centre + radius_ : centre - radius_;
      t = std::clamp(next, 0.0, force_.duration_);
      at = force_.jet(t, force_.sinusoids_.size());
      see(at.value, force_.rounding_);
      const bool rises_outward = t == outward && (t - centre) * at.slope * at.value > 0.0;
      const double gap = rises_outward ? 0.0 : 0.5 * at.slope * at.slope / bend;
      if (drop(std::abs(at.value) + gap + force_.rounding_)) return true;
    }
    return false;
  }

  const ForceMaximum& force_;
  double relative_width_, enough_, too_much_;
  double lower_{}, upper_{};
  double radius_{};
  std::vector<double> centres_;
};

Bounds ForceMaximum::refined_to(double relative_width) const {
  require_relative_width(relative_width);
  return Search(*this, relative_width, 0.0, std::numeric_limits<double>::infinity()).bounds();
}

bool ForceMaximum::exceeds(double limit) const {
  const double sum = truncations_.front().rest + std::abs(sinusoids_.front().amplitude);
  if (beats_.empty() && sum + rounding_ <= limit) return false;
  return Search(*this, 1e-10, limit, limit).bounds().lower > limit;
}

}  // namespace stickslip::analytic
