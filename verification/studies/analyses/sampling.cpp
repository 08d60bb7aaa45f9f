// SPDX-License-Identifier: MIT
#include "studies/analyses/sampling.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_qrng.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <stdexcept>

#include "studies/common/bisection.hpp"
#include "studies/common/parallel.hpp"

namespace stickslip::studies {

namespace {

constexpr double tail = 0.025;  // on either side of a 95 % interval
constexpr std::size_t replications = 16;
constexpr int sobol_bits = 30;  // of GSL's sequence
constexpr std::uint32_t sobol_mask = (std::uint32_t{1} << sobol_bits) - 1U;

// Steele, Lea and Flood's SplitMix64.
std::uint64_t mixed(std::uint64_t state) {
  state += 0x9e3779b97f4a7c15U;
  state = (state ^ (state >> 30U)) * 0xbf58476d1ce4e5b9U;
  state = (state ^ (state >> 27U)) * 0x94d049bb133111ebU;
  return state ^ (state >> 31U);
}

// x with P(x) = p for a P that increases from 0 to 1 on 0 ... 1.
double inverse(double p, const std::function<double(double)>& cumulative) {
  return bisected(0.0, 1.0, [&](double x) { return cumulative(x) < p; });
}

double triangular_quantile(const data::Distribution& d, double p) {
  const double width = d.upper - d.lower, at_mode = (d.mode - d.lower) / width;
  if (p < at_mode) return d.lower + std::sqrt(p * width * (d.mode - d.lower));
  return d.upper - std::sqrt((1.0 - p) * width * (d.upper - d.mode));
}

// The digits of Sobol's points in one dimension, mixed: digit k of the result is digit k of x plus a random
// combination of the digits before it.
class Scrambling {
 public:
  explicit Scrambling(std::mt19937_64& random) {
    for (int k = 0; k < sobol_bits; ++k) {
      const auto place = std::uint32_t{1} << static_cast<unsigned>(sobol_bits - 1 - k);
      const auto higher = sobol_mask & ~(2U * place - 1U);
      rows_[static_cast<std::size_t>(k)] = place | (static_cast<std::uint32_t>(random()) & higher);
    }
    shift_ = static_cast<std::uint32_t>(random()) & sobol_mask;
  }

  [[nodiscard]] double operator()(std::uint32_t digits) const {
    std::uint32_t result = 0;
    for (const std::uint32_t row : rows_)
      result = (result << 1U) | (static_cast<std::uint32_t>(std::popcount(digits & row)) & 1U);
    return std::ldexp(static_cast<double>(result ^ shift_) + 0.5, -sobol_bits);
  }

 private:
  std::array<std::uint32_t, sobol_bits> rows_{};
  std::uint32_t shift_{};
};

}  // namespace

Estimate mean_with_interval(std::span<const double> values) {
  const auto count = static_cast<double>(values.size());
  const double mean = gsl_stats_mean(values.data(), 1, values.size());
  const double half = gsl_cdf_tdist_Pinv(1.0 - tail, count - 1.0) *
                      gsl_stats_sd_m(values.data(), 1, values.size(), mean) / std::sqrt(count);
  return {mean, mean - half, mean + half};
}

namespace {

struct PlainIndex {
  double first{}, total{};
};

// From rows f(A), f(B), f(AB_1), ...: of first order and total, by Jansen's estimates; 0 without variance.
std::vector<PlainIndex> jansen_indices(const std::vector<std::vector<double>>& rows, std::size_t inputs) {
  const auto count = static_cast<double>(rows.size());
  double mean = 0.0, variance = 0.0;
  for (const auto& row : rows) mean += 0.5 * (row[0] + row[1]) / count;
  for (const auto& row : rows)
    variance += 0.5 * ((row[0] - mean) * (row[0] - mean) + (row[1] - mean) * (row[1] - mean)) / count;
  std::vector<PlainIndex> indices(inputs);
  if (!(variance > 0.0)) return indices;
  for (std::size_t i = 0; i < inputs; ++i) {
    double first = 0.0, total = 0.0;
    for (const auto& row : rows) {
      first += (row[1] - row[i + 2]) * (row[1] - row[i + 2]) / count;
      total += (row[0] - row[i + 2]) * (row[0] - row[i + 2]) / count;
    }
    indices[i] = {1.0 - 0.5 * first / variance, 0.5 * total / variance};
  }
  return indices;
}

}  // namespace

double quantile(const data::Distribution& d, double p) {
  switch (d.kind) {
    case data::DistributionKind::normal:
      return d.mean + d.standard_deviation * gsl_cdf_ugaussian_Pinv(p);
    case data::DistributionKind::lognormal: {
      const double ratio = d.standard_deviation / d.mean, variance = std::log1p(ratio * ratio);
      return d.mean * std::exp(std::sqrt(variance) * gsl_cdf_ugaussian_Pinv(p) - 0.5 * variance);
    }
    case data::DistributionKind::uniform:
      return std::lerp(d.lower, d.upper, p);
    case data::DistributionKind::triangular:
      return triangular_quantile(d, p);
    case data::DistributionKind::samples:
      break;
  }
  const auto rank = static_cast<std::size_t>(p * static_cast<double>(d.samples.size()));
  return d.samples[std::min(rank, d.samples.size() - 1)];
}

JointDistribution::JointDistribution(const data::Uncertainty& uncertainty) {
  for (const auto& key : uncertainty.keys) distributions_.push_back(key.distribution);
  const std::size_t count = size();
  bool is_unit_matrix = true;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < i; ++j) is_unit_matrix &= uncertainty.correlation[i * count + j] == 0.0;
  if (!is_unit_matrix) factor_ = data::cholesky_factor(uncertainty.correlation, count);
}

std::vector<double> JointDistribution::at(std::span<const double> u, std::span<const double> spreads) const {
  std::vector<double> x(size());
  if (is_independent() && spreads.empty()) {
    for (std::size_t i = 0; i < size(); ++i) x[i] = quantile(distributions_[i], u[i]);
    return x;
  }
  std::vector<double> z(size());
  for (std::size_t i = 0; i < size(); ++i) z[i] = gsl_cdf_ugaussian_Pinv(u[i]);
  for (std::size_t i = 0; i < size(); ++i) {
    double score = z[i];
    if (!is_independent()) {
      score = 0.0;
      for (std::size_t j = 0; j <= i; ++j) score += factor_[i * size() + j] * z[j];
    }
    if (!spreads.empty()) score *= spreads[i];
    x[i] = quantile(distributions_[i], gsl_cdf_ugaussian_P(score));
  }
  return x;
}

std::vector<double> independent_point(std::uint64_t seed, std::uint64_t index, std::size_t dimensions) {
  std::vector<double> point(dimensions);
  const std::uint64_t stream = mixed(mixed(seed) ^ index);
  for (std::size_t i = 0; i < dimensions; ++i)
    point[i] = (static_cast<double>(mixed(stream + i) >> 11U) + 0.5) * 0x1p-53;
  return point;
}

std::vector<double> scrambled_sobol_points(std::size_t dimensions, std::size_t count, std::uint64_t seed) {
  if (dimensions < 1 || dimensions > 40 || !std::has_single_bit(count) || count > (std::size_t{1} << 20U))
    throw std::invalid_argument("Sobol's points need 1 to 40 dimensions and a power of two up to 2^20");
  std::mt19937_64 random(mixed(seed));
  std::vector<Scrambling> scramblings;
  for (std::size_t i = 0; i < dimensions; ++i) scramblings.emplace_back(random);
  const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> sequence(
      gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(dimensions)), &gsl_qrng_free);
  std::vector<double> points, point(dimensions, 0.0);  // GSL leaves out the first point, the origin
  for (std::size_t j = 0; j < count; ++j) {
    for (std::size_t i = 0; i < dimensions; ++i)
      points.push_back(scramblings[i](static_cast<std::uint32_t>(std::ldexp(point[i], sobol_bits))));
    gsl_qrng_get(sequence.get(), point.data());
  }
  return points;
}

Estimate probability_of(std::size_t hits, std::size_t count) {
  const auto k = static_cast<double>(hits), n = static_cast<double>(count);
  Estimate result{k / n, 0.0, 1.0};
  if (hits > 0) result.lower = inverse(tail, [&](double p) { return gsl_cdf_beta_P(p, k, n - k + 1.0); });
  if (hits < count)
    result.upper = inverse(1.0 - tail, [&](double p) { return gsl_cdf_beta_P(p, k + 1.0, n - k); });
  return result;
}

Estimate quantile_of(std::span<const double> sorted, double p) {
  const std::size_t count = sorted.size();
  const auto n = static_cast<unsigned>(count);
  const auto rank = static_cast<std::size_t>(p * static_cast<double>(count));
  // The number B of samples below the quantile is binomial. x_(l) ≤ q ≤ x_(u) holds if l ≤ B < u, counted from
  // 1: l the largest with P(B < l) ≤ 2.5 %, u the smallest with P(B ≥ u) ≤ 2.5 %.
  std::size_t low = 0, high = count + 1;
  for (std::size_t step = std::bit_ceil(count); step > 0; step /= 2) {
    if (low + step <= count && gsl_cdf_binomial_P(static_cast<unsigned>(low + step - 1), p, n) <= tail)
      low += step;
    if (high >= step + 1 && gsl_cdf_binomial_Q(static_cast<unsigned>(high - step - 1), p, n) <= tail)
      high -= step;
  }
  const double infinity = std::numeric_limits<double>::infinity();
  return {sorted[rank], low == 0 ? -infinity : sorted[low - 1], high > count ? infinity : sorted[high - 1]};
}

Sensitivity sobol_indices(const Model& model, std::size_t inputs, std::size_t rows, std::uint64_t seed,
                          const std::function<void(double)>& progress) {
  if (inputs < 1 || inputs > 20) throw std::invalid_argument("indices need 1 to 20 inputs");
  const std::size_t count = std::bit_ceil(std::max<std::size_t>(rows / replications, 4)),
                    columns = inputs + 2;
  std::vector<std::vector<double>> firsts(inputs), totals(inputs);
  Sensitivity result;
  for (std::size_t replication = 0; replication < replications; ++replication) {
    const auto points = scrambled_sobol_points(2 * inputs, count, mixed(seed) + replication);
    // f(A), f(B), f(AB_1), ...
    std::vector<std::vector<double>> values(count);
    in_parallel(
        count,
        [&](std::size_t row) {
          const std::span a(&points[row * 2 * inputs], inputs), b(&points[(row * 2 + 1) * inputs], inputs);
          for (std::size_t column = 0; column < columns; ++column) {
            std::vector<double> u(column == 1 ? b.begin() : a.begin(), column == 1 ? b.end() : a.end());
            if (column >= 2) u[column - 2] = b[column - 2];
            const auto value = model(u);
            if (!value || !std::isfinite(*value)) return;
            values[row].push_back(*value);
          }
        },
        [&](double share) {
          if (progress) progress((static_cast<double>(replication) + share) / replications);
        });
    result.evaluations += count * columns;
    result.dropped += std::erase_if(values, [&](const auto& row) { return row.size() < columns; });
    const auto indices = jansen_indices(values, inputs);
    for (std::size_t i = 0; i < inputs; ++i) {
      firsts[i].push_back(indices[i].first);
      totals[i].push_back(indices[i].total);
    }
  }
  for (std::size_t i = 0; i < inputs; ++i)
    result.indices.push_back({mean_with_interval(firsts[i]), mean_with_interval(totals[i])});
  return result;
}

}  // namespace stickslip::studies
