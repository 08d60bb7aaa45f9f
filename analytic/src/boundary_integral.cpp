// SPDX-License-Identifier: MIT
#include "stickslip/analytic/boundary_integral.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>

#include "arguments.hpp"
#include "friction_in_slip.hpp"
#include "stickslip/data/fourier_transform.hpp"

namespace stickslip::analytic {
namespace {

using Complex = std::complex<double>;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// R = (E + O)/(E - O), the Pade approximant (k, k) of exp, with E even and O odd.
class GaussMethod {
 public:
  explicit GaussMethod(int stages) : stages_(stages) {
    if (stages < 1 || stages > most_stages)
      throw wrong_argument("stages", stages, "1 ... " + std::to_string(most_stages));
    coefficients_[0] = 1.0;
    for (int i = 1; i <= stages; ++i)
      coefficients_[at(i)] =
          coefficients_[at(i - 1)] * (stages - i + 1) / (static_cast<double>(2 * stages - i + 1) * i);
  }

  /// Σ_i Y(x_i/h)/(x_i² R'(x_i)) over the solutions of R(x) = 1/ζ.
  template <class Function>
  [[nodiscard]] Complex sum_over_solutions(Complex zeta, const Function& weighted) {
    find_solutions((1.0 - zeta) / (1.0 + zeta));
    Complex sum = 0.0;
    for (const Complex x : roots_) sum += weighted(x) / (x * x * derivative(x));
    return sum;
  }

 private:
  [[nodiscard]] static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  /// R'(x).
  [[nodiscard]] Complex derivative(Complex x) const {
    Complex plus = 0.0, minus = 0.0, plus_rate = 0.0, minus_rate = 0.0;  // E + O, E - O
    for (int i = stages_; i >= 0; --i) {
      plus_rate = plus_rate * x + plus;
      minus_rate = minus_rate * x + minus;
      plus = plus * x + coefficients_[at(i)];
      minus = minus * x + (i % 2 == 0 ? 1.0 : -1.0) * coefficients_[at(i)];
    }
    return (plus_rate * minus - plus * minus_rate) / (minus * minus);
  }

  /// The roots of τ E(x) - O(x), τ = (1 - ζ)/(1 + ζ), all at once by the method of Durand and Kerner, from those of the
  /// last ζ.
  void find_solutions(Complex tau) {
    std::array<Complex, most_stages + 1> monic{};
    for (int i = 0; i <= stages_; ++i)
      monic[at(i)] = coefficients_[at(i)] * (i % 2 == 0 ? tau : Complex(-1.0));
    const Complex leading = monic[at(stages_)];
    for (int i = 0; i <= stages_; ++i) monic[at(i)] /= leading;
    if (roots_.empty()) {
      double radius = 0.0;
      for (int i = 0; i < stages_; ++i)
        radius = std::max(radius, std::pow(std::abs(monic[at(i)]), 1.0 / (stages_ - i)));
      for (int i = 0; i < stages_; ++i)
        roots_.push_back(std::polar(radius, 0.4 + 2.0 * std::numbers::pi * i / stages_));
    }
    constexpr int most_iterations = 200;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      double change = 0.0;
      for (Complex& root : roots_) {
        Complex value = 0.0, others = 1.0;
        for (int i = stages_; i >= 0; --i) value = value * root + monic[at(i)];
        for (const Complex& other : roots_)
          if (&other != &root) others *= root - other;
        const Complex step = value / others;
        root -= step;
        change = std::max(change, std::norm(step) / std::norm(root));
      }
      if (change < 256.0 * epsilon * epsilon) break;
    }
  }

  int stages_;
  std::array<double, most_stages + 1> coefficients_{};
  std::vector<Complex> roots_;
};

Complex discrete_mobility(GaussMethod& method, const Mobility& mobility, double time_step, Complex zeta) {
  const Complex factor = (1.0 - zeta) / zeta;
  return factor * factor *
         method.sum_over_solutions(zeta, [&](Complex x) { return mobility(x / time_step); });
}

}  // namespace

Complex discrete_mobility(const Mobility& mobility, double time_step, int stages, Complex zeta) {
  require_positive("time_step", time_step);
  GaussMethod method(stages);
  return discrete_mobility(method, mobility, time_step, zeta);
}

std::vector<double> mobility_weights(const Mobility& mobility, double time_step, std::size_t count,
                                     int stages) {
  require_positive("time_step", time_step);
  if (count < 1) throw wrong_argument("count", 0.0, "1 or more");
  GaussMethod method(stages);
  // On a circle of radius r the weights beyond n come back with r^n, and rounding grows by r^-count: with n
  // at least twice the count both are eps^(2/3) at r^count = eps^(1/3).
  const std::size_t n = std::bit_ceil(2 * count);
  const double radius = std::pow(epsilon, 1.0 / (3.0 * static_cast<double>(count)));
  data::FourierTransform transform(n);
  const auto spectrum = transform.spectrum();
  for (std::size_t k = 0; k < spectrum.size(); ++k) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
    spectrum[k] = discrete_mobility(method, mobility, time_step, std::polar(radius, -angle));
  }
  transform.backward();
  std::vector<double> weights(count);
  for (std::size_t j = 0; j < count; ++j)
    weights[j] = transform.values()[j] / static_cast<double>(n) * std::pow(radius, -static_cast<double>(j));
  return weights;
}

void require_unique_step(const ContactLaw& law, double first_weight) {
  if (std::isinf(law.friction.decay()))
    throw data::FieldError("friction.decay", law.friction.decay(),
                           "finite (s/m) here: with a jump a step can both stick and slip");
  const double weakening = (law.friction.static_coefficient() - law.friction.kinetic_coefficient()) *
                           law.friction.decay() * law.normal_force;
  if (law.tangential.has_spring()) require_positive("time_step", law.time_step);
  if (!(weakening * first_weight < 1.0))
    throw data::InputError(
        "time_step is too long: the sliding velocity of a step has one solution only if (mu_s - mu_m) alpha "
        "N "
        "W_0 is below 1, but it is " +
        data::shortest_text(weakening * first_weight));
}

namespace {

SlipResistance resistance(const ContactLaw& law, double speed) {
  return slip_resistance(law.friction, law.normal_force, speed);
}

// The largest friction force at rest, N.
double limit(const ContactLaw& law) { return law.friction.static_coefficient() * law.normal_force; }

// w + W N μ(w) = p for p > W N μ(0): convex, rising, and negative at zero, so that Newton's method comes down to
// the root after its first step.
double sliding_speed(const ContactLaw& law, double free_speed, double weight) {
  double speed = 0.0;
  constexpr int most_iterations = 100;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const auto [force, slope] = resistance(law, speed);
    const double change = (speed - free_speed + weight * force) / (1.0 + weight * slope);
    speed -= change;
    if (std::abs(change) <= 4.0 * epsilon * speed) break;
  }
  return speed;
}

}  // namespace

ContactStep solve_contact(const ContactLaw& law, double free_velocity, double weight) {
  if (std::abs(free_velocity) <= weight * limit(law)) return {0.0, -free_velocity / weight, false};
  const double speed = sliding_speed(law, std::abs(free_velocity), weight);
  return {std::copysign(speed, free_velocity), -std::copysign(resistance(law, speed).force, free_velocity),
          true};
}

ContactStep ContactElement::step(double free_velocity, double weight) {
  if (law_.tangential.has_spring()) return spring_step(free_velocity, weight);
  if (law_.tangential.is_smooth()) return smooth_step(free_velocity, weight);
  return solve_contact(law_, free_velocity, weight);
}

// |v| + W N μ(|v|) tanh(|v|/v_r) = |p|: rising if κ W < 1, so that the root stays bracketed.
ContactStep ContactElement::smooth_step(double free_velocity, double weight) const {
  const double width = law_.tangential.regularisation_velocity(), free_speed = std::abs(free_velocity);
  double low = 0.0, high = free_speed, speed = 0.0;
  constexpr int most_iterations = 200;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const double share = std::tanh(speed / width);
    const auto [force, slope] = resistance(law_, speed);
    const double residual = speed + weight * force * share - free_speed;
    (residual < 0.0 ? low : high) = speed;
    double next = speed - residual / (1.0 + weight * (force * (1.0 - share * share) / width + slope * share));
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    const bool is_done = std::abs(next - speed) <= 4.0 * epsilon * next;
    speed = next;
    if (is_done) break;
  }
  // Not from the law, which would multiply the rounding of the speed.
  return {std::copysign(speed, free_velocity), (std::copysign(speed, free_velocity) - free_velocity) / weight,
          true};
}

ContactStep ContactElement::spring_step(double free_velocity, double weight) {
  const double half_step = 0.5 * law_.tangential.tangential_stiffness() * law_.time_step;
  ContactStep result{.sliding_velocity =
                         (free_velocity + weight * spring_force_) / (1.0 + weight * half_step)};
  result.friction_force = spring_force_ - half_step * result.sliding_velocity;
  const double direction = -std::copysign(1.0, result.friction_force);
  const double forward = std::max(direction * result.sliding_velocity, 0.0);
  result.slides = std::abs(result.friction_force) > resistance(law_, forward).force;
  if (result.slides) {
    const double held = weight * limit(law_), free_speed = direction * free_velocity;
    const double speed = free_speed > held ? sliding_speed(law_, free_speed, weight) : free_speed - held;
    result.sliding_velocity = direction * speed;
    result.friction_force = -direction * resistance(law_, std::max(speed, 0.0)).force;
  }
  spring_force_ = result.friction_force - half_step * result.sliding_velocity;
  return result;
}

namespace {

/// sum_(j < n) W_(n-j) x_j for n = 0, 1, ... while the x_j become known one by one.
///
/// Sums within a block of the latest values are direct. When the blocks of values up to n fill 2^i blocks, their
/// contribution to the next 2^i blocks is added by one transform of twice that length.
class OnlineConvolution {
 public:
  explicit OnlineConvolution(const std::vector<double>& weights)
      : weights_(weights), later_(weights_.size()) {
    values_.reserve(weights_.size());
    for (std::size_t size = block; size < weights_.size(); size *= 2) levels_.emplace_back(weights_, size);
  }

  /// The sum for the next n.
  [[nodiscard]] double history() const {
    const std::size_t n = values_.size();
    double sum = later_[n];
    for (std::size_t j = n - n % block; j < n; ++j) sum += weights_[n - j] * values_[j];
    return sum;
  }

  /// x_n, after which history() is that of n + 1.
  void append(double value) {
    values_.push_back(value);
    const std::size_t n = values_.size();
    if (n % block != 0 || n >= weights_.size()) return;
    auto level = levels_.begin() + std::countr_zero(n / block);
    if (level < levels_.end()) level->contribute(values_, later_);
  }

 private:
  static constexpr std::size_t block = 128;

  struct Level {
    std::size_t size;
    std::unique_ptr<data::FourierTransform> transform;
    std::vector<Complex> kernel;  // of weights 0 ... 2 size - 1

    Level(const std::vector<double>& weights, std::size_t values)
        : size(values), transform(std::make_unique<data::FourierTransform>(2 * values)) {
      const auto input = transform->values();
      std::ranges::fill(input, 0.0);
      std::copy_n(weights.begin(), std::min(weights.size(), input.size()), input.begin());
      transform->forward();
      kernel.assign(transform->spectrum().begin(), transform->spectrum().end());
    }

    // Of the last `size` values to the `size` sums after them; the first half of the circular convolution is
    // mixed.
    void contribute(const std::vector<double>& values, std::vector<double>& later) const {
      const auto data = transform->values();
      std::copy_n(values.end() - static_cast<std::ptrdiff_t>(size), size, data.begin());
      std::fill_n(data.begin() + static_cast<std::ptrdiff_t>(size), size, 0.0);
      transform->forward();
      const auto spectrum = transform->spectrum();
      for (std::size_t k = 0; k < spectrum.size(); ++k) spectrum[k] *= kernel[k];
      transform->backward();
      const std::size_t n = values.size();
      for (std::size_t i = 0; i < size && n + i < later.size(); ++i)
        later[n + i] += data[size + i] / static_cast<double>(2 * size);
    }
  };

  const std::vector<double>& weights_;
  std::vector<double> values_;
  std::vector<double> later_;  // what earlier blocks contribute to each sum
  std::vector<Level> levels_;
};

}  // namespace

std::vector<double> convolution(const std::vector<double>& weights, const std::vector<double>& x) {
  data::FourierTransform kernel(std::bit_ceil(2 * x.size())), data(std::bit_ceil(2 * x.size()));
  const auto padded = [&](data::FourierTransform& transform, const std::vector<double>& source) {
    std::ranges::fill(transform.values(), 0.0);
    std::copy_n(source.begin(), x.size(), transform.values().begin());
    transform.forward();
  };
  padded(kernel, weights);
  padded(data, x);
  for (std::size_t k = 0; k < data.spectrum().size(); ++k) data.spectrum()[k] *= kernel.spectrum()[k];
  data.backward();
  std::vector<double> sums(x.size());
  for (std::size_t n = 0; n < sums.size(); ++n)
    sums[n] = data.values()[n] / static_cast<double>(data.values().size());
  return sums;
}

std::vector<ContactStep> contact_steps(const std::vector<double>& weights, const ContactLaw& law,
                                       const std::vector<double>& holding_force) {
  if (holding_force.size() > weights.size())
    throw wrong_argument("the size of holding_force", static_cast<double>(holding_force.size()),
                         "at most that of weights, " + std::to_string(weights.size()));
  const double first = weights.front();
  require_unique_step(law, first);
  ContactElement contact(law);
  OnlineConvolution convolution(weights);
  std::vector<ContactStep> steps;
  steps.reserve(holding_force.size());
  for (const double held : holding_force) {
    steps.push_back(contact.step(convolution.history() - first * held, first));
    convolution.append(steps.back().friction_force - held);
  }
  return steps;
}

std::vector<double> contact_positions(const std::vector<ContactStep>& steps, double time_step,
                                      std::size_t every) {
  std::vector<double> values{0.0};
  double position = 0.0;
  for (std::size_t n = 1; n <= steps.size(); ++n) {
    position += time_step * steps[n - 1].sliding_velocity;
    if (n % every == 0) values.push_back(position);
  }
  return values;
}

}  // namespace stickslip::analytic
