// SPDX-License-Identifier: MIT
#include "studies/analyses/design_guide.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/stick_reaction.hpp"
#include "studies/analyses/length_force_map.hpp"
#include "studies/common/bisection.hpp"
#include "studies/common/parallel.hpp"

namespace stickslip::studies {

namespace {

// Relative width of the bounds below which an undecided force counts as above the limit.
constexpr double undecided = 1e-6;
constexpr double spacing = 0.01;  // relative distance of neighbouring values
// Of the ends of intervals, relative to the upper end of the range.
constexpr double relative_accuracy = 1e-5;
constexpr double last_share = 1.0 / 16.0;  // of that accuracy, at which the bisection of intervals ends
constexpr double below_buckling = 1.0 - 1e-6;

bool is_one_frequency(const analytic::FrequencyBand& band) { return band.from_hz == band.to_hz; }

void require_margin(const data::Case& problem) {
  require_friction(problem);
  if (problem.has(data::Feature::shear))
    throw data::FieldError("beam.shear_stiffness", problem.beam().shear_stiffness(),
                           "0 for a design over a band of frequencies; map and criterion have shear");
  if (problem.excitation().amplitude() > 0.0) return;
  throw data::FieldError("excitation.amplitude", "0", "above 0 (m): without excitation nothing slips");
}

// A0 at the lower end of the band, m: what BandMaximum counts in.
double amplitude_at_start(const data::Case& problem, const analytic::FrequencyBand& band) {
  return with_value(problem, "excitation.frequency_hz", band.from_hz).excitation().amplitude();
}

// The band of the amplitude that the case states.
analytic::FrequencyBand stated_by(const data::Case& problem, analytic::FrequencyBand band) {
  band.held = problem.excitation().motion().amplitude_of;
  return band;
}

// The case with one value of the parameter, and the bounds of the force that are known there.
class Candidate {
 public:
  Candidate(const data::Case& problem, double value, const analytic::FrequencyBand& band,
            const analytic::StickReaction& reaction)
      : value_(value),
        limit_(friction_limit(problem) / amplitude_at_start(problem, band)),
        modes_(analytic::held_modes(problem, problem.numerics.modes())),
        search_(reaction.over(stated_by(problem, band))) {
    for (const auto& mode : modes_) decays_.push_back(reaction.decay_near(mode.angular_frequency));
  }

  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] const std::vector<analytic::ModalForce>& modes() const { return modes_; }
  [[nodiscard]] double decay(std::size_t mode) const { return decays_[mode]; }

  // Whether |f_max| per metre of amplitude at the lower end is at least `reserve` (N/m) below the limit over the whole band.
  [[nodiscard]] bool sticks(double reserve = 0.0) {
    const double target = limit_ - reserve;
    return target > 0.0 && search_.refined_against(target, undecided).upper <= target;
  }

 private:
  double value_;
  double limit_;  // μ_s P/A0 at the lower end of the band, N/m
  std::vector<analytic::ModalForce> modes_;
  std::vector<double> decays_;  // 1/s, by mode
  analytic::BandMaximum search_;
};

// The scan of one range of the parameter for one band of frequencies.
class Scan {
 public:
  Scan(const data::Case& problem, std::string_view parameter, const analytic::FrequencyBand& band,
       double resolution)
      : problem_(problem), parameter_(parameter), band_(band), resolution_(resolution), reactions_(problem) {}

  // From now on the modes of candidates in the range are interpolated.
  void tabulate(const analytic::Bounds& range, std::size_t candidates) {
    const std::array ends{with_value(problem_, parameter_, range.lower),
                          with_value(problem_, parameter_, range.upper)};
    reactions_.tabulate(ends, candidates);
  }

  [[nodiscard]] Candidate at(double value) const {
    const data::Case problem = with_value(problem_, parameter_, value);
    return {problem, value, band_, reactions_.of(problem)};
  }

  // Appends the intervals from `left` to `right` in ascending order. What a candidate has found out serves both sides of it.
  void divide(Candidate& left, Candidate& right, std::vector<DesignInterval>& intervals) const {
    const bool left_sticks = left.sticks(), right_sticks = right.sticks();
    if (!left_sticks && !right_sticks) return append(left, right, false, intervals);
    if (left_sticks && right_sticks) {
      const double reserve = rise_between(left, right);
      if (left.sticks(reserve) && right.sticks(reserve)) return append(left, right, true, intervals);
    }
    if (right.value() - left.value() <= resolution_) return append(left, right, false, intervals);
    Candidate middle = at(0.5 * (left.value() + right.value()));
    divide(left, middle, intervals);
    divide(middle, right, intervals);
  }

  // Values at which a natural frequency is at an end of the band, and values at most 1 % apart.
  [[nodiscard]] std::vector<double> grid(const analytic::Bounds& range) const {
    std::vector<double> values{range.lower};
    const int steps = static_cast<int>(std::ceil(std::log(range.upper / range.lower) / spacing));
    for (int i = 1; i < steps; ++i)
      values.push_back(range.lower * std::pow(range.upper / range.lower, static_cast<double>(i) / steps));
    values.push_back(range.upper);
    for (int mode = 1; mode <= problem_.numerics.modes(); ++mode)
      for (const double hz : {band_.from_hz, band_.to_hz})
        if (const auto value = value_at_resonance(range, mode, hz)) values.push_back(*value);
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
  }

 private:
  // Natural frequencies decrease with increasing length and with increasing axial force.
  [[nodiscard]] std::optional<double> value_at_resonance(const analytic::Bounds& range, int mode,
                                                         double hz) const {
    const auto natural_hz = [&](double value) {
      return stick_hz(with_value(problem_, parameter_, value).beam(), mode);
    };
    if (natural_hz(range.lower) < hz || natural_hz(range.upper) > hz) return std::nullopt;
    return bisected(
        range.lower, range.upper, [&](double value) { return natural_hz(value) > hz; }, 1e-14 * range.lower);
  }

  // The estimate R of design_scan(): how far |f_max| per metre of amplitude rises above its larger end value, N/m. As b³, b² times
  // the weight of BandMaximum is largest at the end of the band.
  [[nodiscard]] double rise_between(const Candidate& left, const Candidate& right) const {
    const double a = two_pi * band_.from_hz, b = two_pi * band_.to_hz;
    double rise = 0.0;
    for (std::size_t n = 0; n < left.modes().size(); ++n) {
      const auto &upper = left.modes()[n], &lower = right.modes()[n];
      const double w = lower.angular_frequency, change = upper.angular_frequency - w;
      const double duration = problem_.numerics.duration();
      const double t = std::min(duration, 2.0 / std::min(left.decay(n), right.decay(n)));
      const double c = std::max(std::abs(upper.coefficient), std::abs(lower.coefficient));
      const double apart = std::max({0.0, a - upper.angular_frequency, w - b}) * (a + w);
      const double q = b * b * b / (apart * w);  // infinite in resonance
      const double bend = std::min(t * t * q, b * b * t * t * t / (3.0 * w));
      rise += c * std::min(change * change * bend / 8.0, 2.0 * q);
    }
    return rise * std::pow(a / b, static_cast<double>(problem_.excitation().motion().amplitude_of));
  }

  void append(const Candidate& left, const Candidate& right, bool sticks,
              std::vector<DesignInterval>& intervals) const {
    intervals.push_back({.from = left.value(), .to = right.value(), .sticks = sticks});
    // The grid has the values at which a natural frequency is at an end of the band: it does not enter between two of them.
    const double inside = is_one_frequency(band_) ? -1e-12 : 1e-12;
    for (std::size_t n = 0; n < left.modes().size(); ++n)
      if (left.modes()[n].angular_frequency >= two_pi * band_.from_hz * (1.0 + inside) &&
          right.modes()[n].angular_frequency <= two_pi * band_.to_hz * (1.0 - inside))
        intervals.back().resonances.push_back(static_cast<int>(n) + 1);
  }

  const data::Case& problem_;
  std::string_view parameter_;
  analytic::FrequencyBand band_;
  double resolution_;
  analytic::StickReactions reactions_;
};

// Joins neighbouring intervals with the same result and, where they slip, the same resonances.
std::vector<DesignInterval> joined(const std::vector<std::vector<DesignInterval>>& parts,
                                   bool whatever_resonances) {
  std::vector<DesignInterval> intervals;
  for (const auto& part : parts)
    for (const DesignInterval& next : part) {
      if (intervals.empty() || intervals.back().sticks != next.sticks ||
          (!next.sticks && !whatever_resonances && intervals.back().resonances != next.resonances)) {
        intervals.push_back(next);
        continue;
      }
      DesignInterval& last = intervals.back();
      last.to = next.to;
      std::vector<int> both;
      std::ranges::set_union(last.resonances, next.resonances, std::back_inserter(both));
      last.resonances = std::move(both);
    }
  return intervals;
}

}  // namespace

BandMargin band_margin(const data::Case& problem, const analytic::FrequencyBand& band,
                       double relative_width) {
  analytic::require_contact(problem);
  require_margin(problem);
  const analytic::StickReaction reaction(problem);
  analytic::BandMaximum search = reaction.over(stated_by(problem, band));
  const analytic::Bounds unit = search.refined_to(relative_width);
  const double amplitude = amplitude_at_start(problem, band), limit = friction_limit(problem);
  BandMargin margin{.force_max = amplitude * unit,
                    .friction_limit = limit,
                    .margin = limit / (amplitude * unit),
                    .frequency_hz = search.frequency_hz(),
                    .evaluations = static_cast<int>(search.evaluations()),
                    .resonances = {},
                    .steady_margin = {}};
  if (problem.is_damped()) {
    const analytic::Bounds steady =
        reaction.over(stated_by(problem, band), analytic::DampedForcePart::steady).refined_to(relative_width);
    margin.steady_margin = limit / (amplitude * steady);
  }
  int number = 0;
  for (const auto& mode : analytic::held_modes(problem, problem.numerics.modes())) {
    ++number;
    const double hz = mode.angular_frequency / two_pi;
    if (band.from_hz <= hz && hz <= band.to_hz) margin.resonances.push_back({number, hz});
  }
  return margin;
}

DesignScan design_scan(const data::Case& problem, std::string_view parameter, const analytic::Bounds& range,
                       const analytic::FrequencyBand& band, const std::function<void(double)>& progress) {
  if (!(range.lower > 0.0 && range.lower < range.upper))
    throw data::FieldError("the range of " + std::string(parameter),
                           data::shortest_text(range.lower) + " to " + data::shortest_text(range.upper),
                           "from a number above 0 to a larger one");
  require_margin(problem);
  const double buckling = buckling_value(problem, parameter);
  const double last = std::min(range.upper, below_buckling * buckling);
  DesignScan result{.parameter = parameter, .accuracy = relative_accuracy * range.upper, .intervals = {}};
  if (range.lower < last) {
    Scan scan(problem, parameter, band, last_share * result.accuracy);
    const std::vector<double> values = scan.grid({range.lower, last});
    scan.tabulate({range.lower, last}, values.size());
    std::vector<std::optional<Candidate>> candidates(values.size());
    in_parallel(
        values.size(),
        [&](std::size_t i) {
          candidates[i] = scan.at(values[i]);
          static_cast<void>(candidates[i]->sticks());  // both neighbours ask for it
        },
        [&](double share) {
          if (progress) progress(0.5 * share);
        });
    std::vector<std::vector<DesignInterval>> parts(values.size() - 1);
    in_parallel(
        parts.size(),
        [&](std::size_t i) {
          Candidate left = *candidates[i], right = *candidates[i + 1];  // another thread has them, too
          scan.divide(left, right, parts[i]);
        },
        [&](double share) {
          if (progress) progress(0.5 + 0.5 * share);
        });
    result.intervals = joined(parts, is_one_frequency(band));
  }
  if (range.upper > last)
    result.intervals.push_back({.from = std::max(range.lower, last), .to = range.upper, .buckled = true});
  return result;
}

Design design(const data::Case& problem, const analytic::FrequencyBand& band, const analytic::Bounds& lengths,
              const analytic::Bounds& forces, const std::function<void(std::string_view)>& stage,
              const std::function<void(double)>& progress) {
  Design result{.band = band, .margin = {}, .lengths = {}, .forces = {}};
  stage("margin");
  result.margin = band_margin(problem, band);
  if (problem.model() != nullptr) return result;
  stage("lengths");
  result.lengths =
      design_scan(problem, "beam.length", lengths, band, [&](double share) { progress(0.5 * share); });
  stage("axial forces");
  result.forces = design_scan(problem, "beam.axial_force", forces, band,
                              [&](double share) { progress(0.5 + 0.5 * share); });
  return result;
}

analytic::Bounds range_below_buckling(const data::Case& problem, std::string_view parameter, double from,
                                      double to) {
  return {from, std::min(to, 0.999 * buckling_value(problem, parameter))};
}

double buckling_value(const data::Case& problem, std::string_view parameter) {
  if (parameter == "beam.axial_force") return analytic::buckling_load(problem);
  if (parameter != "beam.length")
    throw std::invalid_argument(std::string(parameter) +
                                " is varied in a design, but must be beam.length or beam.axial_force");
  // Throws with a message about the axial force.
  if (problem.normal_force() <= 0.0) analytic::require_contact(problem);
  return buckling_length(problem.beam());
}

}  // namespace stickslip::studies
