// SPDX-License-Identifier: MIT
#include "stickslip/analytic/force_maximum.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "arguments.hpp"
#include "special_functions.hpp"

namespace stickslip::analytic {
namespace {

constexpr double kUnitRoundoff = 0.5 * std::numeric_limits<double>::epsilon();
constexpr double kMostGridPoints = 1e9;
// The chord bound of the grid may leave this share of the largest value seen: less makes the grid finer, more
// leaves more pieces to the search behind it. Measured: 0.08 and 0.1 are fastest, 0.2 costs a sixth more.
constexpr double kGridExcess = 0.1;
constexpr std::size_t kBlock = 128;  // grid points that share their sines; a power of 2
// A phase is turned from block to block, and from piece to smaller piece, this many times before it is computed again. Seven
// turns go before, in tabulate() and from the start of a block: 22 in all.
constexpr std::size_t kMostTurns = 8;
constexpr std::size_t kLooks = 24;         // turns of the first look, the most of all
constexpr double kTurning = 4.0 * kLooks;  // in units of kUnitRoundoff, at 4 a turn

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
  double steady = reaction.quasi_static + reaction.inertia * omega * omega;
  double cancelled = std::abs(steady);  // the sum of the absolute values of what makes the steady amplitude
  sinusoids_.reserve(reaction.modes.size() + 1);
  sinusoids_.push_back({0.0, omega});
  for (const ModalForce& mode : reaction.modes) {
    const double natural = mode.angular_frequency;
    const double sum = omega + natural, difference = omega - natural;
    const double shared = mode.coefficient * omega * omega / sum;
    if (std::abs(difference) * duration < 2.0) {
      near_resonant_terms_.push_back({shared, 0.5 * sum, 0.5 * difference});
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
  const auto operations = static_cast<double>(sinusoids_.size() + near_resonant_terms_.size()) + 10.0;
  for (const NearResonantTerm& beat : near_resonant_terms_) {
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
  for (const NearResonantTerm& beat : near_resonant_terms_)
    sum += beat.amplitude * t * sinc(beat.detuning * t) * std::cos(beat.mean * t);
  return sum;
}

TaylorCoefficients ForceMaximum::jet(double t) const {
  std::vector<Phase> phases;
  phases.reserve(sinusoids_.size());
  for (const auto& [a, w] : sinusoids_) phases.push_back({std::sin(w * t), std::cos(w * t)});
  return jet(t, phases.data(), phases.size());
}

TaylorCoefficients ForceMaximum::jet(double t, const Phase* phases, std::size_t terms) const {
  TaylorCoefficients sum;
  for (const NearResonantTerm& beat : near_resonant_terms_) {
    const double sigma = beat.mean, delta = beat.detuning;
    const double c = std::cos(sigma * t), s = std::sin(sigma * t);
    const double e = t * sinc(delta * t), e_slope = std::cos(delta * t);
    sum.value += beat.amplitude * e * c;
    sum.slope += beat.amplitude * (e_slope * c - sigma * e * s);
    sum.curvature -= beat.amplitude * ((delta * delta + sigma * sigma) * e * c + 2.0 * sigma * e_slope * s);
  }
  for (std::size_t n = 0; n < terms; ++n) {
    const auto& [a, w] = sinusoids_[n];
    const double s = a * phases[n].sine, c = a * phases[n].cosine;
    sum.value += s;
    sum.slope += w * c;
    sum.curvature -= w * w * s;
  }
  return sum;
}

double ForceMaximum::value(double t) const { return jet(t).value; }

/// One search. A piece of time whose upper bound does not exceed the larger of `enough_` and
/// lower (1 + relative width) is done with; a lower bound above `too_much_` ends it.
class ForceMaximum::Search {
 public:
  Search(const ForceMaximum& force, double relative_width, double enough, double too_much)
      : force_(force), relative_width_(relative_width), enough_(enough), too_much_(too_much) {
    for (const auto& [a, w] : force.sinusoids_)
      turning_ += kUnitRoundoff * kTurning * std::abs(a) * std::min(1.0, w * force.duration_);
    on_a_grid();
  }

  [[nodiscard]] Bounds bounds() const { return {lower_, std::max(lower_, upper_)}; }

 private:
  // The pieces of one half-width r = h/2^(1 + depth).
  struct Depth {
    double radius{}, excess{}, uncertainty{};
    std::size_t terms{};
    std::vector<Phase> half_radius;  // of w_n r/2
  };

  [[nodiscard]] const Truncation& truncation(std::size_t terms) const {
    return force_.truncations_[terms - 1];
  }

  void see(double value, double uncertainty) { lower_ = std::max(lower_, std::abs(value) - uncertainty); }

  [[nodiscard]] double most_to_drop() const {
    return std::max(enough_, (1.0 + relative_width_) * lower_ + 2.0 * force_.rounding_);
  }

  /// Whether a piece is done with, which it then is.
  bool drop(double upper) {
    if (upper > most_to_drop()) return false;
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

  /// Drops most pieces of a grid by their chords and divides the others.
  void on_a_grid() {
    const double scale = std::max(first_look(), enough_);
    if (lower_ > too_much_) return;
    const double excess = kGridExcess * scale;
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
    tabulate_to(terms, h);

    const double chord = truncation(terms).curvature * h * h / 8.0;
    const double uncertainty = truncation(terms).rest + force_.rounding_ + turning_;
    sample(h, intervals + 1, terms);
    if (lower_ > too_much_) return;
    const auto highest = std::max_element(tops_.begin(), tops_.end()) - tops_.begin();
    const auto block = ends_.begin() + highest * static_cast<std::ptrdiff_t>(kBlock);
    const auto best = std::find(block, ends_.end(), tops_[static_cast<std::size_t>(highest)]);
    see(force_.value(h * static_cast<double>(best - ends_.begin())), force_.rounding_);
    if (lower_ > too_much_) return;

    double dropped = 0.0;
    for (std::size_t first = 0; first < intervals; first += kBlock) {
      const std::size_t last = std::min(first + kBlock, intervals);
      if (drop(std::max(tops_[first / kBlock], ends_[last]) + chord + uncertainty)) {
        turns_ = 0;
        continue;
      }
      dropped = std::max(dropped, divide_block(first, last, h, chord, uncertainty));
      if (lower_ > too_much_) return;
    }
    upper_ = std::max(upper_, dropped + chord + uncertainty);
  }

  /// Divides the pieces of a block that their chords do not drop; returns the highest end of the others.
  double divide_block(std::size_t first, std::size_t last, double h, double chord, double uncertainty) {
    if (depths_.empty()) deepen();
    tabulate_to(force_.sinusoids_.size(), h);
    to_block((static_cast<double>(first) + 0.5) * h);
    double low = most_to_drop() - chord - uncertainty, dropped = 0.0;
    for (std::size_t i = first; i < last; ++i) {
      double top = 0.0;
      for (; i < last && (top = std::max(ends_[i], ends_[i + 1])) <= low; ++i)
        dropped = std::max(dropped, top);
      if (i == last) break;
      column_ = i - first;
      turn_from_start(0, depths_.front().terms);
      settle((static_cast<double>(i) + 0.5) * h, 0);
      if (lower_ > too_much_) break;
      low = most_to_drop() - chord - uncertainty;
    }
    return dropped;
  }

  /// The phases of a piece of the grid, from those at the start of its block.
  void turn_from_start(std::size_t from, std::size_t to) {
    for (std::size_t n = from; n < to; ++n)
      phases_[n] = turned(start_[n], {sines_[n][column_], cosines_[n][column_]});
  }

  /// Of the first sinusoids, what is not tabulated yet.
  void tabulate_to(std::size_t terms, double h) {
    sines_.reserve(force_.sinusoids_.size());
    cosines_.reserve(force_.sinusoids_.size());
    start_.resize(terms);
    for (std::size_t n = sines_.size(); n < terms; ++n) {
      const double angle = force_.sinusoids_[n].angular_frequency * h;
      tabulate(angle, sines_.emplace_back(), cosines_.emplace_back());
      const double whole = static_cast<double>(kBlock) * angle;
      block_turns_.push_back({std::sin(whole), std::cos(whole)});
    }
  }

  /// Sets start_ for a block that begins at t: turned from the block before unless turns_ is 0 or there were too many turns.
  void to_block(double t) {
    if (turns_++ % kMostTurns == 0) return phases_at(t, start_);
    for (std::size_t n = 0; n < start_.size(); ++n) start_[n] = turned(start_[n], block_turns_[n]);
  }

  /// sin(w t) and cos(w t) of as many sinusoids as there are phases.
  void phases_at(double t, std::span<Phase> phases) const {
    for (std::size_t n = 0; n < phases.size(); ++n) {
      const double angle = force_.sinusoids_[n].angular_frequency * t;
      phases[n] = {std::sin(angle), std::cos(angle)};
    }
  }

  /// The largest of a few values, as the scale of the grid and often all but the maximum: where the excitation is at its
  /// peaks and, in turn, where it passes zero, as it does at the peaks in resonance.
  double first_look() {
    const double half_period = std::numbers::pi / force_.sinusoids_.front().angular_frequency;
    const double start = std::min(0.5 * half_period, force_.duration_);
    const double rest = force_.duration_ - start;
    const double step = half_period * (0.5 + std::floor(rest / (half_period * static_cast<double>(kLooks))));
    std::vector<Phase> turns(force_.sinusoids_.size()), phases(turns.size());
    phases_at(step, turns);
    phases_at(start, phases);
    const double last = std::min(rest / step, static_cast<double>(kLooks) - 1.0);
    for (double i = 0.0; i <= last; ++i) {
      double value = force_.beats(start + i * step);
      for (std::size_t n = 0; n < turns.size(); ++n) {
        value += force_.sinusoids_[n].amplitude * phases[n].sine;
        phases[n] = turned(phases[n], turns[n]);
      }
      see(value, force_.rounding_ + turning_);
    }
    return lower_;
  }

  /// |f_k| at 0, h, ... into ends_ and the largest of each block into tops_, `count` of them or until there is too much.
  void sample(double h, std::size_t count, std::size_t terms) {
    const double uncertainty = truncation(terms).rest + force_.rounding_ + turning_;
    const std::size_t blocks = (count + kBlock - 1) / kBlock;
    ends_.resize(blocks * kBlock);
    for (std::size_t first = 0; first < count && lower_ <= too_much_; first += kBlock) {
      double* const block = &ends_[first];
      to_block(h * static_cast<double>(first));
      for (std::size_t n = 0; n < terms; ++n) {
        const double a = force_.sinusoids_[n].amplitude;
        const double s = a * start_[n].sine, c = a * start_[n].cosine;
        for (std::size_t i = 0; i < kBlock; ++i) block[i] += s * cosines_[n][i] + c * sines_[n][i];
      }
      if (!force_.near_resonant_terms_.empty())
        for (std::size_t i = 0; i < kBlock; ++i) block[i] += force_.beats(h * static_cast<double>(first + i));
      std::fill(block + std::min(kBlock, count - first), block + kBlock, 0.0);
      constexpr std::size_t lanes = 8;  // which do not wait for each other
      std::array<double, lanes> largest{};
      for (std::size_t i = 0; i < kBlock; i += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane) {
          const double value = block[i + lane] = std::abs(block[i + lane]);
          largest[lane] = largest[lane] < value ? value : largest[lane];
        }
      tops_.push_back(*std::max_element(largest.begin(), largest.end()));
      see(tops_.back(), uncertainty);
    }
    turns_ = 0;
  }

  /// Adds the next depth.
  void deepen() {
    Depth next;
    next.radius = depths_.empty() ? radius_ : 0.5 * depths_.back().radius;
    next.terms = sufficient_terms(next.radius);
    const Truncation& kept = truncation(next.terms);
    const bool is_exact = !depths_.empty() && depths_.size() % kMostTurns == 0;
    next.uncertainty = kept.rest + force_.rounding_ + (is_exact ? 0.0 : turning_);
    next.excess = kept.third * next.radius * next.radius * next.radius / 6.0 + next.uncertainty;
    next.half_radius.resize(force_.sinusoids_.size());
    phases_at(0.5 * next.radius, next.half_radius);
    depths_.push_back(std::move(next));
    phases_.resize((depths_.size() + 1) * force_.sinusoids_.size());
  }

  /// Judges a piece by its parabola; if it is not done with, it is closed by its peak or divided. Its phases are those
  /// of its depth in phases_.
  void settle(double t, std::size_t depth) {
    const std::size_t all = force_.sinusoids_.size(), terms = depths_[depth].terms;
    const double radius = depths_[depth].radius;
    const TaylorCoefficients at = force_.jet(t, &phases_[depth * all], terms);
    see(at.value, depths_[depth].uncertainty);
    if (lower_ > too_much_) return;
    if (drop(largest_parabola(at.value, at.slope, at.curvature, radius) + depths_[depth].excess)) return;
    if (terms == all && close_by_peak(t, radius, at)) return;
    if (depth == 0) turn_from_start(terms, all);
    if (depth + 1 == depths_.size()) deepen();
    for (const double side : {-1.0, 1.0}) {
      const Phase* const from = &phases_[depth * all];
      Phase* const to = &phases_[(depth + 1) * all];
      const double middle = t + side * 0.5 * radius;
      if ((depth + 1) % kMostTurns == 0)
        phases_at(middle, {to, all});
      else
        for (std::size_t n = 0; n < all; ++n) {
          const auto& [sine, cosine] = depths_[depth].half_radius[n];
          to[n] = turned(from[n], {side * sine, cosine});
        }
      settle(middle, depth + 1);
      if (lower_ > too_much_) return;
    }
  }

  /// Newton's method for the largest |f| of a piece on which f is concave away from zero.
  bool close_by_peak(double centre, double radius, TaylorCoefficients at) {
    const double third = truncation(force_.sinusoids_.size()).third;
    const double bend = std::abs(at.curvature) - third * radius;  // m
    const double lowest = std::abs(at.value) - std::abs(at.slope) * radius -
                          0.5 * (std::abs(at.curvature) + third * radius) * radius * radius;
    if (!(at.value * at.curvature < 0.0 && bend > 0.25 * std::abs(at.curvature) && lowest > 0.0))
      return false;
    double t = centre;
    for (int iteration = 0; iteration < 6; ++iteration) {
      const double next = std::clamp(t - at.slope / at.curvature, centre - radius, centre + radius);
      const double outward = next > centre ? centre + radius : centre - radius;
      t = std::clamp(next, 0.0, force_.duration_);
      at = force_.jet(t);
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
  double turning_{};                  // bound of the rounding of phases that are turned and not computed
  double radius_{};                   // of the pieces of the grid
  std::vector<double> ends_, tops_;   // |f_k| on the grid, and the largest of each block
  std::vector<Row> sines_, cosines_;  // by sinusoid, of w i h
  std::vector<Phase> start_;          // of a block: at its first point, or half a step after it
  std::vector<Phase> block_turns_;    // from there to the next block
  std::size_t turns_{};               // since start_ was computed
  std::size_t column_{};              // of a piece in its block
  std::vector<Depth> depths_;
  std::vector<Phase> phases_;  // by depth and sinusoid
};

Bounds ForceMaximum::refined_to(double relative_width) const {
  return refined_to(relative_width, 0.0, std::numeric_limits<double>::infinity());
}

Bounds ForceMaximum::refined_to(double relative_width, double enough, double too_much) const {
  require_relative_width(relative_width);
  if (const double most = upper_bound(); most <= enough) return {0.0, most};
  return Search(*this, relative_width, enough, too_much).bounds();
}

double ForceMaximum::upper_bound() const {
  if (!near_resonant_terms_.empty()) return std::numeric_limits<double>::infinity();
  return truncations_.front().rest + std::abs(sinusoids_.front().amplitude) + rounding_;
}

bool ForceMaximum::exceeds(double limit) const { return refined_to(1e-10, limit, limit).lower > limit; }

}  // namespace stickslip::analytic
