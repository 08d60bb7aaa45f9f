// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <random>

#include "motion_shape.hpp"
#include "stickslip/data/fourier_transform.hpp"
#include "stickslip/data/input_error.hpp"

namespace stickslip::data {

namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double samples_per_period = 6.0;  // of the highest line
constexpr double most_samples = 1 << 24;

// Two independent normal numbers of mean 0 and variance 1 (Box and Muller), the same with every library.
std::complex<double> normal_pair(std::mt19937_64& engine) {
  const auto uniform = [&] { return (static_cast<double>(engine() >> 11U) + 0.5) * 0x1.0p-53; };
  const double radius = std::sqrt(-2.0 * std::log(uniform()));
  return std::polar(radius, two_pi * uniform());
}

// The realisation on a grid: displacement and three derivatives, from which each interval has the polynomial of degree 7 with these
// values at both ends.
class RandomMotion : public MotionShape {
 public:
  RandomMotion(PowerSpectrum stated, double duration, std::string_view table)
      : MotionShape(std::move(stated), duration, table) {
    const auto& spectrum = std::get<PowerSpectrum>(statement);
    const std::string key = key_in(table, "spectrum");
    require_usable(spectrum, key);
    highest_hz = spectrum.points.back().frequency_hz;
    if (const double most = most_samples / (samples_per_period * highest_hz); duration > most)
      throw FieldError(
          "excitation.duration", duration,
          "at most " + short_text(most) + " s with a spectrum up to " + short_text(highest_hz) + " Hz");
    auto lines = spectrum.lines(duration);
    if (spectrum.quantity == AmplitudeOf::force)
      for (auto& line : lines) line = -line;
    if (std::ranges::all_of(lines, [](const auto& line) { return line == 0.0; }))
      throw FieldError("excitation.duration", duration,
                       "so long that lines 1/duration apart, Hz, are in the spectrum");
    const auto size = fast_size(std::max<std::size_t>(
        2 * lines.size(), static_cast<std::size_t>(samples_per_period * highest_hz * duration)));
    step_ = duration / static_cast<double>(size);
    FourierTransform transform(size);
    for (std::size_t order = 0; order < 4; ++order) {
      std::ranges::fill(transform.spectrum(), 0.0);
      for (std::size_t k = 1; k < lines.size(); ++k) {
        const std::complex<double> rate(0.0, two_pi * static_cast<double>(k) / duration);
        transform.spectrum()[k] = 0.5 * lines[k] * std::pow(rate, static_cast<int>(order) - 2);
      }
      transform.backward();
      values_[order].assign(transform.values().begin(), transform.values().end());
    }
    for (std::size_t k = 1; k < lines.size(); ++k)
      piece_error +=
          std::abs(lines[k]) * std::pow(two_pi * static_cast<double>(k) / duration * step_, 6) / 322560.0;
  }

  [[nodiscard]] MotionState at(double t) const override {
    const auto index = static_cast<std::size_t>(std::max(0.0, std::floor(t / step_)));
    return state_in(piece(std::min(index, pieces() - 1)), t);
  }
  [[nodiscard]] std::size_t pieces() const override { return values_[0].size(); }

  // With x = τ/step the displacement is Σ v_k x^k/k! + Σ c_k x^k, and what the first four terms leave at x = 1 determines the c_k.
  [[nodiscard]] MotionPiece piece(std::size_t index) const override {
    const std::size_t next = (index + 1) % pieces();
    std::array<double, 4> from{}, rest{};
    double power = 1.0;
    for (std::size_t k = 0; k < 4; ++k, power *= step_) {
      from[k] = power * values_[k][index];
      rest[k] = power * values_[k][next];
    }
    rest[0] -= from[0] + from[1] + from[2] / 2.0 + from[3] / 6.0;
    rest[1] -= from[1] + from[2] + from[3] / 2.0;
    rest[2] -= from[2] + from[3];
    rest[3] -= from[3];
    const std::array<double, 4> made{35.0 * rest[0] - 15.0 * rest[1] + 2.5 * rest[2] - rest[3] / 6.0,
                                     -84.0 * rest[0] + 39.0 * rest[1] - 7.0 * rest[2] + 0.5 * rest[3],
                                     70.0 * rest[0] - 34.0 * rest[1] + 6.5 * rest[2] - 0.5 * rest[3],
                                     -20.0 * rest[0] + 10.0 * rest[1] - 2.0 * rest[2] + rest[3] / 6.0};
    MotionPiece piece{.begin = step_ * static_cast<double>(index),
                      .length = step_,
                      .acceleration = {values_[2][index], values_[3][index]},
                      .velocity = values_[1][index],
                      .displacement = values_[0][index]};
    double unit = 1.0 / (step_ * step_);
    for (std::size_t k = 4; k < 8; ++k) {
      unit /= step_;
      piece.acceleration[k - 2] = static_cast<double>(k * (k - 1)) * made[k - 4] * unit / step_;
    }
    return piece;
  }

 private:
  static void require_usable(const PowerSpectrum& spectrum, const std::string& key) {
    if (spectrum.points.size() < 2)
      throw FieldError(key, static_cast<double>(spectrum.points.size()), "of two points or more");
    double before = 0.0;
    for (const auto& [hz, density] : spectrum.points) {
      if (!(hz > before) || !std::isfinite(hz))
        throw FieldError(key, hz, "of frequencies above 0 (Hz) that increase");
      if (!(density > 0.0) || !std::isfinite(density)) throw FieldError(key, density, "of densities above 0");
      before = hz;
    }
  }

  double step_{};
  std::array<std::vector<double>, 4> values_;  // h, h_t, h_tt, h_ttt
};

}  // namespace

double PowerSpectrum::density(double frequency_hz) const {
  if (points.empty() || frequency_hz < points.front().frequency_hz ||
      frequency_hz > points.back().frequency_hz)
    return 0.0;
  auto right = std::ranges::upper_bound(points, frequency_hz, {}, &Point::frequency_hz);
  if (right == points.end()) --right;
  const Point &a = *std::prev(right), &b = *right;
  const double slope = std::log(b.density / a.density) / std::log(b.frequency_hz / a.frequency_hz);
  const int to_acceleration = 2 * (2 - derivatives(quantity));
  return a.density * std::pow(frequency_hz / a.frequency_hz, slope) *
         std::pow(two_pi * frequency_hz, to_acceleration);
}

std::vector<std::complex<double>> PowerSpectrum::lines(double duration) const {
  std::seed_seq seeds{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U),
                      is_of_wall ? 1U : 0U};
  std::mt19937_64 engine(seeds);
  const auto count = static_cast<std::size_t>(points.back().frequency_hz * duration * (1.0 + 1e-12)) + 1;
  std::vector<std::complex<double>> lines(count);
  const auto below = static_cast<std::size_t>(points.front().frequency_hz * duration * (1.0 + 1e-12));
  for (std::size_t k = below + 1; k < count; ++k) {
    const double hz = std::clamp(static_cast<double>(k) / duration, points.front().frequency_hz,
                                 points.back().frequency_hz);
    lines[k] = std::sqrt(density(hz) / duration) * std::conj(normal_pair(engine));
  }
  return lines;
}

std::unique_ptr<MotionShape> random_motion(PowerSpectrum spectrum, double duration, std::string_view table) {
  spectrum.is_of_wall = table == "wall";
  return std::make_unique<RandomMotion>(std::move(spectrum), duration, table);
}

}  // namespace stickslip::data
