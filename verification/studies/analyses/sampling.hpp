// SPDX-License-Identifier: MIT
#pragma once

/// Samples of quantities with given distributions, and what can be said from them.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "stickslip/data/uncertainty.hpp"

namespace stickslip::studies {

/// The value that a quantity stays below with probability p, 0 < p < 1. Of samples it is the one of rank floor(p
/// n) + 1.
[[nodiscard]] double quantile(const data::Distribution& distribution, double p);

/// Quantities that are correlated by a Gaussian copula: with independent standard normal z and the factor L of
/// the correlation, x_i = quantile_i(Φ((L z)_i)).
class JointDistribution {
 public:
  explicit JointDistribution(const data::Uncertainty& uncertainty);

  [[nodiscard]] std::size_t size() const noexcept { return distributions_.size(); }
  [[nodiscard]] bool is_independent() const noexcept { return factor_.empty(); }
  /// x from independent probabilities, 0 < u < 1. z_i is multiplied by spreads[i] (1 if there are none).
  [[nodiscard]] std::vector<double> at(std::span<const double> u, std::span<const double> spreads = {}) const;

 private:
  std::vector<data::Distribution> distributions_;
  std::vector<double> factor_;  // empty for the unit matrix
};

/// Point number `index` of independent points, uniform in 0 < u < 1. It depends on its arguments alone.
[[nodiscard]] std::vector<double> independent_point(std::uint64_t seed, std::uint64_t index,
                                                    std::size_t dimensions);

/// The first `count` points, a power of two up to 2²⁰, of Sobol's sequence, row by row, scrambled by random
/// lower triangular binary matrices and a random digital shift (Matousek, J. Complexity 14, 527-556, 1998): each
/// point is uniform in 0 < u < 1, and the points fill the cube evenly. At most 40 dimensions.
[[nodiscard]] std::vector<double> scrambled_sobol_points(std::size_t dimensions, std::size_t count,
                                                         std::uint64_t seed);

/// An estimate with its 95 % confidence interval.
struct Estimate {
  double value{}, lower{}, upper{};
};

/// The mean of at least two values, by Student's t: for values that are normal and independent.
[[nodiscard]] Estimate mean_with_interval(std::span<const double> values);

/// The probability of an event that `hits` of `count` > 0 independent samples had, with the interval of Clopper and
/// Pearson (Biometrika 26, 404-413, 1934), which has at least its nominal coverage for every probability.
[[nodiscard]] Estimate probability_of(std::size_t hits, std::size_t count);

/// The p-quantile, 0 < p < 1, of independent samples in ascending order, with the interval between two of them by the
/// binomial distribution of how many lie below it, which has at least its nominal coverage; an end for which
/// there are too few samples is infinite.
[[nodiscard]] Estimate quantile_of(std::span<const double> sorted, double p);

/// The shares of one input in the variance of a model: alone (first), and with all its interactions (total).
struct SobolIndex {
  Estimate first, total;
};

struct Sensitivity {
  std::vector<SobolIndex> indices;
  std::size_t evaluations{};
  std::size_t dropped{};  ///< rows in which the model had no value
};

/// A model of independent uniform inputs; empty where it has no value. Called from several threads.
using Model = std::function<std::optional<double>(std::span<const double>)>;

/// First and total indices by Jansen's estimators (Comput. Phys. Commun. 117, 35-43, 1999), with rows A and B of a
/// scrambled Sobol sequence in twice the dimensions, and AB_i, which is A but for input i of B:
///
///     S_i = 1 - mean (f(B) - f(AB_i))²/(2 V),     T_i = mean (f(A) - f(AB_i))²/(2 V),     V = var f.
///
/// The mean of 16 independent replications, each of a sixteenth of `rows` or the next power of two, at least 4, is the
/// estimate, and Student's t gives its interval. A row without a value somewhere counts nowhere. Where V is 0 all
/// indices are 0. At most 20 inputs (std::invalid_argument). The result does not depend on the number of threads.
[[nodiscard]] Sensitivity sobol_indices(const Model& model, std::size_t inputs, std::size_t rows,
                                        std::uint64_t seed, const std::function<void(double)>& progress = {});

}  // namespace stickslip::studies
