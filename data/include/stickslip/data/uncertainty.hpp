// SPDX-License-Identifier: MIT
#pragma once

/// The table [uncertainty] of a case file: distributions of keys of the case, and their correlation.
///
///     [uncertainty]
///     "friction.static_coefficient" = { distribution = "normal", mean = 0.55, standard_deviation = 0.05 }
///     "beam.length" = { distribution = "uniform", lower = 1.99, upper = 2.01 }
///     correlation = [["friction.static_coefficient", "beam.length", 0.5]]
///
/// normal and lognormal have the mean and the standard deviation of the quantity itself; uniform has lower and
/// upper, triangular also mode; these numbers may have a unit ("5 mm"). samples has the name of a CSV file, relative to
/// the case file, and a column in the unit that its name states ("E [GPa]"), or else in SI units.

#include <filesystem>
#include <string>
#include <vector>

namespace stickslip::data {

enum class DistributionKind { normal, lognormal, uniform, triangular, samples };

struct Distribution {
  DistributionKind kind{};
  double mean{}, standard_deviation{};  ///< of normal and lognormal, > 0
  double lower{}, mode{}, upper{};      ///< of uniform and triangular, lower <= mode <= upper, lower < upper
  std::vector<double> samples{};        ///< ascending, at least 2

  [[nodiscard]] double mean_value() const;
};

struct UncertainKey {
  std::string key;  ///< "friction.static_coefficient"
  Distribution distribution;
  std::string place;  ///< "bar.toml:21"
};

/// The correlation is that of the normal scores of the keys (Gaussian copula): a positive definite matrix with
/// ones on its diagonal, row by row.
struct Uncertainty {
  std::vector<UncertainKey> keys;
  std::vector<double> correlation;
};

/// What the case file says, without keys if it has no such table. Throws InputError as read_case() does: for a key
/// that is none, is an integer or stands twice, a distribution that is unknown or misses a number, numbers that it
/// cannot have, or correlations that no quantities have.
[[nodiscard]] Uncertainty read_uncertainty(const std::filesystem::path& file);

/// Factor L of A = L L^T, row by row, for a symmetric matrix of `size` rows; empty unless A is positive definite.
[[nodiscard]] std::vector<double> cholesky_factor(const std::vector<double>& matrix, std::size_t size);

}  // namespace stickslip::data
