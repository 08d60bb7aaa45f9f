// SPDX-License-Identifier: MIT
#include "stickslip/certified/force_maximum.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "stickslip/certified/roots.hpp"

namespace stickslip::certified {
namespace {

/// f in doubles, with a bound of the evaluation error.
///
/// With u = 2^-53, the argument w t of a sinusoid has the error w t 2u (rounding of w and of the product),
/// and its sine has an additional error of 2u. The amplitude, the product and the sum of n terms add (n + 2)
/// u. The error of f is therefore below u sum |a_i| (2 |w_i| t + n + 4), and that of f' is the same with |a_i
/// w_i| and one more rounding. Both bounds are doubled. This covers the rounding of the bounds themselves,
/// the radii of the balls, which are below u/64, and the middle of the last cell, which may lie past the end.
class DoubleForce {
 public:
  DoubleForce(const std::vector<Sinusoid>& sinusoids, double duration) {
    constexpr double kEpsilon = std::numeric_limits<double>::epsilon();  // 2u
    const auto terms = static_cast<double>(sinusoids.size());
    for (const Sinusoid& sinusoid : sinusoids) {
      const double a = sinusoid.amplitude.nearest_double(), w = sinusoid.angular_frequency.nearest_double();
      terms_.push_back({a, w});
      const double error = kEpsilon * std::abs(a) * (2.0 * std::abs(w) * duration + terms + 5.0);
      value_error_ += error;
      slope_error_ += error * std::abs(w);
      curvature_ += std::abs(a) * w * w * (1.0 + 1e-12);
    }
  }

  struct Values {
    double force{}, slope{};
  };

  [[nodiscard]] Values at(double t) const {
    Values sum;
    for (const auto& [a, w] : terms_) {
      const double phase = w * t;
      sum.force += a * std::sin(phase);
      sum.slope += a * w * std::cos(phase);
    }
    return {std::abs(sum.force), std::abs(sum.slope)};
  }

  [[nodiscard]] double value_error() const { return value_error_; }
  [[nodiscard]] double curvature() const { return curvature_; }

  /// Upper bound of |f| within the distance r of the time of `values`.
  [[nodiscard]] double bound(const Values& values, double r) const {
    return (values.force + values.slope * r + 0.5 * curvature_ * r * r) * (1.0 + 1e-14) + value_error_ +
           slope_error_ * r;
  }

 private:
  struct Term {
    double amplitude, angular_frequency;
  };
  std::vector<Term> terms_;
  double value_error_{}, slope_error_{}, curvature_{};
};

/// Time intervals index * width ... (index + 1) * width. The width is a power of two, so that their ends are
/// exact.
struct Cells {
  double width{};
  std::vector<std::int64_t> indices;
};

/// The cells that may contain the maximum. The end of the time interval is between `sampled` and `duration`.
/// Empty if the accuracy of doubles is not sufficient.
std::optional<Cells> promising_cells(const DoubleForce& force, double sampled, double duration) {
  constexpr double kFinest = 1e-10;   // relative to the maximum: final excess of the bound of a cell over |f|
  constexpr double kCoarsest = 1e-8;  // relative to the maximum: largest accepted evaluation error
  constexpr std::size_t kMostCells = 1000000;
  double largest = 0.0;
  for (int i = 1; i <= 1024; ++i) largest = std::max(largest, force.at(sampled * i / 1025.0).force);
  if (!(force.value_error() < kCoarsest * largest)) return std::nullopt;
  largest -= force.value_error();

  Cells kept{std::exp2(std::floor(std::log2(std::sqrt(largest / force.curvature())))), {}};
  const auto count = static_cast<std::int64_t>(std::ceil(duration / kept.width));
  const auto keep_promising = [&](Cells& cells, std::int64_t index) {
    const double r = 0.5 * cells.width, middle = (static_cast<double>(index) + 0.5) * cells.width;
    if (middle - r >= duration) return;
    const DoubleForce::Values values = force.at(middle);
    if (middle <= sampled) largest = std::max(largest, values.force - force.value_error());
    if (force.bound(values, r) >= largest) cells.indices.push_back(index);
  };
  for (std::int64_t i = 0; i < count; ++i) keep_promising(kept, i);
  while (force.curvature() * kept.width * kept.width > kFinest * largest) {
    if (kept.indices.size() > kMostCells) return std::nullopt;
    Cells halves{0.5 * kept.width, {}};
    for (const std::int64_t index : kept.indices)
      for (const std::int64_t half : {2 * index, 2 * index + 1}) keep_promising(halves, half);
    kept = std::move(halves);
  }
  return kept;
}

/// f and its derivatives in ball arithmetic.
class BallForce {
 public:
  explicit BallForce(const std::vector<Sinusoid>& sinusoids) : sinusoids_(sinusoids) {}

  [[nodiscard]] Real value(const Real& t) const {
    Real sum;
    for (const auto& [a, w] : sinusoids_) sum += a * sin(w * t);
    return sum;
  }

  /// f' and f''.
  [[nodiscard]] Dual<Real> slope(const Real& t) const {
    Dual<Real> sum(0);
    for (const auto& [a, w] : sinusoids_) sum = sum + Dual<Real>(a * w) * cos(Dual<Real>(w * t, w));
    return sum;
  }

 private:
  const std::vector<Sinusoid>& sinusoids_;
};

struct Candidate {
  Real time, magnitude;
};

/// The stationary points of f in groups of neighbouring cells, and the end of the time interval if a group
/// reaches it or begins there. (At t = 0 the force is 0.) The maximum is not at the border of a group, because
/// the cells on both sides of it are kept.
std::vector<Candidate> candidates(const BallForce& force, const Cells& cells, const Real& duration) {
  const Real width(cells.width), end = duration.lower();
  const auto time = [&](std::int64_t index) { return Real(static_cast<double>(index)) * width; };
  std::vector<Candidate> found;
  const auto add = [&](const Real& t) { found.push_back({t, abs(force.value(t))}); };
  for (std::size_t i = 0; i < cells.indices.size();) {
    std::size_t next = i + 1;
    while (next < cells.indices.size() && cells.indices[next] == cells.indices[next - 1] + 1) ++next;
    const Real first = time(cells.indices[i]), past = time(cells.indices[next - 1] + 1);
    const bool reaches_end = !(past < end);
    if (first < end)
      for (const Real& t :
           isolate_roots([&](const Real& at) { return force.slope(at); }, first, reaches_end ? end : past))
        add(t);
    if (reaches_end) add(duration);
    i = next;
  }
  return found;
}

}  // namespace

ForceMaximum max_abs_of_sinusoids(const std::vector<Sinusoid>& sinusoids, const Rational& duration) {
  if (duration.sign() <= 0)
    throw std::invalid_argument(error_message("excitation.duration", duration, "positive"));
  if (std::ranges::any_of(sinusoids, [](const Sinusoid& s) {
        return s.amplitude.accurate_bits() < 60 || s.angular_frequency.accurate_bits() < 60;
      }))
    throw std::invalid_argument(
        "The sinusoids of a force are accurate to less than 60 bits; raise the precision.");
  if (std::ranges::all_of(sinusoids, [](const Sinusoid& s) { return abs(s.amplitude) <= 0; }))
    return {0, {0}};
  const double nearest = duration.approximately();
  const double end = std::nextafter(nearest, std::numeric_limits<double>::infinity());
  const std::optional<Cells> cells =
      promising_cells(DoubleForce(sinusoids, end), std::nextafter(nearest, 0.0), end);
  if (!cells)
    throw std::domain_error(
        error_message("excitation.duration", duration,
                      "so short, and the excitation so far from a natural frequency, that "
                      "doubles give the friction force to 1e-8 of its maximum"));
  const std::vector<Candidate> all = candidates(BallForce(sinusoids), *cells, duration);
  if (all.empty()) throw std::logic_error("No cell contains the largest friction force.");

  ForceMaximum maximum{all.front().magnitude, {}};
  for (const Candidate& candidate : all) maximum.value = max(maximum.value, candidate.magnitude);
  for (const Candidate& candidate : all)
    if (!(candidate.magnitude < maximum.value)) maximum.times.push_back(candidate.time);
  return maximum;
}

ForceMaximum max_abs_friction_force(const Beam& beam, const Excitation& excitation, const Rational& duration,
                                    int modes) {
  return max_abs_of_sinusoids(StickResponse(beam, excitation, modes).force_sinusoids(), duration);
}

}  // namespace stickslip::certified
