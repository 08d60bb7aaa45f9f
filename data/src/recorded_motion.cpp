// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <functional>
#include <span>

#include "motion_shape.hpp"
#include "stickslip/data/fourier_transform.hpp"
#include "stickslip/data/input_error.hpp"

namespace stickslip::data {

namespace {

// The numbers at the knots of a cubic spline, every `stride`-th of the samples.
struct Knots {
  const MotionRecord& record;
  std::size_t stride{1};

  [[nodiscard]] std::size_t count() const { return (record.samples.size() - 1) / stride + 1; }
  [[nodiscard]] double value(std::size_t i) const { return record.samples[i * stride]; }
  [[nodiscard]] double time(std::size_t i) const {
    return record.times.empty() ? record.step * static_cast<double>(i * stride) : record.times[i * stride];
  }
  [[nodiscard]] double interval(std::size_t i) const {
    return record.times.empty() ? record.step * static_cast<double>(stride) : time(i + 1) - time(i);
  }
  [[nodiscard]] double slope(std::size_t i) const { return (value(i + 1) - value(i)) / interval(i); }
};

// The second derivatives at the knots of the not-a-knot spline (de Boor, A Practical Guide to Splines, Chapter IV), by Thomas'
// elimination: the equations of the inner knots, in which the ends are those of a cubic over two intervals.
std::vector<double> moments_of(const Knots& knots) {
  const std::size_t n = knots.count();
  std::vector<double> moments(n), above(n);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = knots.interval(i - 1), right = knots.interval(i);
    double lower = left, diagonal = 2.0 * (left + right), upper = right;
    if (i == 1) diagonal += left * (left + right) / right, upper -= left * left / right, lower = 0.0;
    if (i + 2 == n) diagonal += right * (left + right) / left, lower -= right * right / left, upper = 0.0;
    const double pivot = diagonal - lower * above[i - 1];
    above[i] = upper / pivot;
    moments[i] = (6.0 * (knots.slope(i) - knots.slope(i - 1)) - lower * moments[i - 1]) / pivot;
  }
  for (std::size_t i = n - 2; i > 1; --i) moments[i - 1] -= above[i - 1] * moments[i];
  const auto beyond = [&](std::size_t near, std::size_t next, double outer, double inner) {
    return moments[near] + outer / inner * (moments[near] - moments[next]);
  };
  moments[0] = beyond(1, 2, knots.interval(0), knots.interval(1));
  moments[n - 1] = beyond(n - 2, n - 3, knots.interval(n - 2), knots.interval(n - 3));
  return moments;
}

// The coefficients of the cubic behind a knot.
std::array<double, 4> cubic(const Knots& knots, const std::vector<double>& moments, std::size_t i) {
  const double length = knots.interval(i);
  return {knots.value(i), knots.slope(i) - length * (2.0 * moments[i] + moments[i + 1]) / 6.0,
          0.5 * moments[i], (moments[i + 1] - moments[i]) / (6.0 * length)};
}

// The power at the frequencies from 0 to half the rate, by Hann windows that overlap by half (Welch).
std::vector<double> power_of(std::size_t count, const std::function<double(std::size_t)>& value) {
  const std::size_t n = std::min(std::bit_floor(count), std::size_t{1} << 16U);
  std::vector<double> power(n / 2 + 1);
  FourierTransform transform(n);
  const auto window = transform.values();
  const auto add = [&](std::size_t begin) {
    double mean = 0.0;
    for (std::size_t i = 0; i < n; ++i) mean += (window[i] = value(begin + i)) / static_cast<double>(n);
    for (std::size_t i = 0; i < n; ++i)
      window[i] =
          (window[i] - mean) * (0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * (static_cast<double>(i) + 0.5) /
                                                     static_cast<double>(n)));
    transform.forward();
    for (std::size_t k = 0; k < power.size(); ++k) power[k] += std::norm(transform.spectrum()[k]);
  };
  for (std::size_t begin = 0; begin + n < count; begin += n / 2) add(begin);
  add(count - n);
  return power;
}

class RecordedMotion : public MotionShape {
 public:
  RecordedMotion(MotionRecord stated, std::string_view table)
      : MotionShape(std::move(stated), 0.0, table),
        record_(std::get<MotionRecord>(statement)),
        knots_{record_} {
    require_usable();
    moments_ = moments_of(knots_);
    lasts = knots_.time(knots_.count() - 1);
    const Knots half{record_, 2};
    estimate_error(half, moments_of(half));
    if (record_.high_pass_hz)
      filter();
    else
      integrate();
    require_no_drift();
    find_highest();
  }

  [[nodiscard]] std::size_t pieces() const override { return (knots_.count() - 1) * parts_; }

  [[nodiscard]] MotionPiece piece(std::size_t index) const override {
    const std::size_t knot = index / parts_;
    const double length = knots_.interval(knot) / static_cast<double>(parts_);
    if (states_.empty()) {
      MotionPiece made{knots_.time(knot), length, stated_acceleration(knot)};
      made.velocity = derivatives_ == 1   ? record_.samples[knot]
                      : derivatives_ == 0 ? cubic(knots_, moments_, knot)[1]
                                          : velocities_[knot];
      made.displacement = derivatives_ == 0 ? record_.samples[knot] : displacements_[knot];
      return made;
    }
    FilterState state = states_[knot];
    std::size_t part = 0;
    for (; part < index % parts_; ++part) state = filtered(knot, part, state).second;
    MotionPiece made = filtered(knot, part, state).first;
    made.begin = knots_.time(knot) + static_cast<double>(part) * length;
    made.length = length;
    return made;
  }

  [[nodiscard]] MotionState at(double t) const override {
    const auto last = static_cast<double>(knots_.count() - 2);
    auto knot = static_cast<std::size_t>(std::clamp(std::floor(t / record_.step), 0.0, last));
    if (!record_.times.empty())
      knot = static_cast<std::size_t>(
                 std::distance(record_.times.begin(),
                               std::upper_bound(record_.times.begin() + 1, record_.times.end() - 1, t))) -
             1;
    const double part =
        std::floor((t - knots_.time(knot)) / knots_.interval(knot) * static_cast<double>(parts_));
    const auto within = static_cast<std::size_t>(std::clamp(part, 0.0, static_cast<double>(parts_ - 1)));
    return state_in(piece(knot * parts_ + within), t);
  }

 private:
  using FilterState = std::array<double, 4>;  // x_1 and x_2, each with its velocity

  [[nodiscard]] std::string key(std::string_view name) const { return key_in(table_name, name); }

  [[noreturn]] void refuse(const std::string& value, std::string_view allowed) const {
    throw FieldError(key("file"), value, allowed);
  }

  void require_usable() const {
    const std::size_t rows = record_.samples.size();
    if (rows < 8) refuse(record_.file + " of " + std::to_string(rows) + " rows", "of at least 8");
    const auto& times = record_.times;
    const bool has_times = times.empty() || (times.size() == rows && times.front() == 0.0);
    if (!(record_.step > 0.0 && has_times &&
          std::ranges::all_of(record_.samples, [](double one) { return std::isfinite(one); }) &&
          std::ranges::adjacent_find(times, std::ranges::greater_equal()) == times.end()))
      refuse(record_.file + " with samples or times that are none", "of finite samples at increasing times");
    if (const auto& hz = record_.high_pass_hz; hz && !(*hz > 0.0 && *hz < 0.5 / record_.step))
      throw FieldError(key("high_pass"), *hz,
                       "above 0 and below half the rate, " + shortest_text(0.5 / record_.step) + " Hz");
    const bool takes_displacement = derivatives_ > 0 && !is_force_ && !record_.high_pass_hz;
    for (const auto& [name, value, may_be_given] :
         {std::tuple{"initial_displacement", record_.initial_displacement, takes_displacement},
          std::tuple{"initial_velocity", record_.initial_velocity, takes_displacement && derivatives_ == 2}})
      if (value && !(may_be_given && std::isfinite(*value)))
        throw FieldError(key(name), *value,
                         may_be_given ? "a finite number"
                                      : "left out: the record has it, or the high pass starts at rest");
    constexpr std::array<double, 4> largest{10.0, 100.0, 1e5, 1e9};
    constexpr std::array<std::string_view, 4> units{" m", " m/s", " m/s^2", " N"};
    const auto kind = static_cast<std::size_t>(record_.quantity);
    double peak = 0.0;
    for (const double sample : record_.samples) peak = std::max(peak, std::abs(sample));
    if (!(peak <= largest.at(kind)))
      refuse(record_.file + " with a peak of " + short_text(peak) + std::string(units.at(kind)),
             "of at most " + shortest_text(largest.at(kind)) + ": check the unit");
    const auto power = power_of(rows, [this](std::size_t i) { return record_.samples[i]; });
    double all = 0.0, high = 0.0;
    for (std::size_t k = 0; k < power.size(); ++k) {
      all += power[k];
      if (5 * k > 4 * (power.size() - 1)) high += power[k];
    }
    if (high > 0.01 * all)
      refuse(
          record_.file + " with " + short_text(100.0 * high / all) + " % of its power above 0.4 of its rate",
          "with at most 1 %, as such a record is aliased or noise: filter it before it is sampled");
  }

  // What the spline of every second sample misses.
  void estimate_error(const Knots& half, const std::vector<double>& moments) {
    // With the fourth derivative d, e = 16 h⁴ d/384 of the coarse spline; that of all misses the second derivative by h² d/12 and the
    // value by h⁴ d/384. At an end e is 9.9 times as large, and the first derivative is missed by 0.18 h³ d, which is 0.44 e/h.
    constexpr std::array factor{2.0, 0.45, 1.0 / 16.0};
    for (std::size_t i = 0; i + 1 < half.count(); ++i) {
      const double x = knots_.interval(2 * i);
      const auto c = cubic(half, moments, i);
      const double miss = std::abs(c[0] + (c[1] + (c[2] + c[3] * x) * x) * x - record_.samples[2 * i + 1]);
      interpolation_error = std::max(interpolation_error, factor.at(static_cast<std::size_t>(derivatives_)) *
                                                              miss * std::pow(x, derivatives_ - 2));
    }
  }

  // The acceleration behind a knot before the filter.
  [[nodiscard]] std::array<double, 8> stated_acceleration(std::size_t knot) const {
    const auto c = cubic(knots_, moments_, knot);
    const double sign = is_force_ ? -1.0 : 1.0;
    if (derivatives_ == 0) return {2.0 * c[2], 6.0 * c[3]};
    if (derivatives_ == 1) return {c[1], 2.0 * c[2], 3.0 * c[3]};
    return {sign * c[0], sign * c[1], sign * c[2], sign * c[3]};
  }

  void integrate() {
    if (derivatives_ == 0) return;
    const std::size_t n = knots_.count();
    long double velocity = record_.initial_velocity.value_or(0.0),
                displacement = record_.initial_displacement.value_or(0.0);
    if (derivatives_ == 2) velocities_.reserve(n);
    displacements_.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
      if (derivatives_ == 2) velocities_.push_back(static_cast<double>(velocity));
      displacements_.push_back(static_cast<double>(displacement));
      if (i + 1 == n) break;
      const long double h = knots_.interval(i);
      const auto c = cubic(knots_, moments_, i);
      const long double once = h * (c[0] + h * (c[1] / 2.0L + h * (c[2] / 3.0L + h * (c[3] / 4.0L))));
      if (derivatives_ == 1) {
        displacement += once;
        continue;
      }
      displacement +=
          h * (velocity + h * (c[0] / 2.0L + h * (c[1] / 6.0L + h * (c[2] / 12.0L + h * (c[3] / 20.0L)))));
      velocity += once;
    }
  }

  void filter() {
    double longest = 0.0;
    for (std::size_t i = 0; i + 1 < knots_.count(); ++i) longest = std::max(longest, knots_.interval(i));
    constexpr double resolved = 0.06;  // of an angle of ω: its powers from the eighth on leave 1e-12
    parts_ = static_cast<std::size_t>(
        std::ceil(2.0 * std::numbers::pi * *record_.high_pass_hz * longest / resolved));
    states_.reserve(knots_.count());
    FilterState state{};
    for (std::size_t i = 0; i + 1 < knots_.count(); ++i) {
      states_.push_back(state);
      for (std::size_t part = 0; part < parts_; ++part) state = filtered(i, part, state).second;
    }
  }

  // A part of an interval by the power series of both sections, and the state at its end.
  [[nodiscard]] std::pair<MotionPiece, FilterState> filtered(std::size_t knot, std::size_t part,
                                                             const FilterState& state) const {
    const double length = knots_.interval(knot) / static_cast<double>(parts_),
                 at = static_cast<double>(part) * length,
                 omega = 2.0 * std::numbers::pi * *record_.high_pass_hz;
    std::array<double, 8> input = stated_acceleration(knot);
    for (std::size_t k = 0; k < 3; ++k)  // about the begin of the part
      for (std::size_t j = 3; j-- > k;) input[j] += at * input[j + 1];
    FilterState end{};
    for (std::size_t section = 0; section < 2; ++section) {
      std::array<double, 10> x{state[2 * section], state[2 * section + 1]};
      for (std::size_t n = 0; n < 8; ++n) {
        const auto order = static_cast<double>(n);
        const double second =
            input[n] - std::numbers::sqrt2 * omega * (order + 1.0) * x[n + 1] - omega * omega * x[n];
        x[n + 2] = second / ((order + 1.0) * (order + 2.0));
        input[n] = second;
      }
      for (std::size_t n = 10; n-- > 0;) {
        end[2 * section + 1] = end[2 * section + 1] * length + end[2 * section];
        end[2 * section] = end[2 * section] * length + x[n];
      }
    }
    return {MotionPiece{0.0, length, input, state[3], state[2]}, end};
  }

  // Without a rule for it.
  void require_no_drift() const {
    if (derivatives_ == 0 || is_force_ || record_.high_pass_hz) return;
    const bool is_velocity = derivatives_ == 1;
    if (is_velocity ? record_.initial_displacement : record_.initial_velocity) return;
    double drift = 0.0;
    for (const double displacement : displacements_) drift = std::max(drift, std::abs(displacement));
    throw FieldError(key("high_pass"), "missing",
                     "given, or " + key(is_velocity ? "initial_displacement" : "initial_velocity") +
                         ": from " + (is_velocity ? "0" : "rest") + " the record would drift by up to " +
                         short_text(drift) + " m");
  }

  void find_highest() {
    const auto power =
        power_of(knots_.count() - 1, [this](std::size_t i) { return piece(i * parts_).acceleration[0]; });
    double all = 0.0, below = 0.0;
    for (const double one : power) all += one;
    std::size_t k = 0;
    while (k + 1 < power.size() && (k == 0 || below < 0.999 * all)) below += power[k++];
    highest_hz = static_cast<double>(k) / (2.0 * record_.step * static_cast<double>(power.size() - 1));
  }

  const MotionRecord& record_;
  Knots knots_;
  bool is_force_{record_.quantity == AmplitudeOf::force};
  int derivatives_{derivatives(record_.quantity)};
  std::vector<double> moments_, velocities_, displacements_;
  std::vector<FilterState> states_;  // at the begin of each interval
  std::size_t parts_{1};             // of an interval
};

}  // namespace

std::unique_ptr<MotionShape> recorded_motion(MotionRecord record, std::string_view table) {
  return std::make_unique<RecordedMotion>(std::move(record), table);
}

}  // namespace stickslip::data
