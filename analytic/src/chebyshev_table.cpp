// SPDX-License-Identifier: MIT
#include "chebyshev_table.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace stickslip::analytic {
namespace {

double node(std::size_t j, std::size_t count) {
  return std::cos(std::numbers::pi * (static_cast<double>(j) + 0.5) / static_cast<double>(count));
}

// Of a value at a node in the coefficient of this degree.
double weight(std::size_t degree, std::size_t j, std::size_t count) {
  const double angle = std::numbers::pi * (static_cast<double>(j) + 0.5) / static_cast<double>(count);
  return (degree == 0 ? 1.0 : 2.0) / static_cast<double>(count) *
         std::cos(static_cast<double>(degree) * angle);
}

double in_range(const Bounds& side, double share) { return std::lerp(side.lower, side.upper, share); }

// T_0 ... T_(count - 1) at a value of this side.
std::vector<double> polynomials(const Bounds& side, double value, std::size_t count) {
  const double width = side.upper - side.lower;
  const double x = width > 0.0 ? (2.0 * value - side.lower - side.upper) / width : 0.0;
  std::vector<double> result{1.0, x};
  while (result.size() < count) result.push_back(2.0 * x * result.back() - result[result.size() - 2]);
  return result;
}

}  // namespace

std::optional<ChebyshevTable> ChebyshevTable::of(
    const std::function<std::optional<Values>(double, double)>& values, const Bounds& x, const Bounds& y,
    const std::function<Values(const Values&)>& allowed, std::size_t most_points) {
  constexpr std::size_t first = 8, most = 128;
  std::array<std::size_t, 2> counts{x.upper > x.lower ? first : 1, y.upper > y.lower ? first : 1};
  while (counts[0] <= most && counts[1] <= most && counts[0] * counts[1] <= most_points) {
    ChebyshevTable table(x, y, counts);
    if (!table.fill(values)) return std::nullopt;
    const auto converged = table.has_converged(allowed(table.largest_));
    if (converged[0] && converged[1]) return table;
    if (!converged[0]) counts[0] *= 2;
    if (!converged[1]) counts[1] *= 2;
  }
  return std::nullopt;
}

bool ChebyshevTable::fill(const std::function<std::optional<Values>(double, double)>& values) {
  for (std::size_t i = 0; i < counts_[0]; ++i)
    for (std::size_t j = 0; j < counts_[1]; ++j) {
      const auto found = values(in_range(sides_[0], 0.5 + 0.5 * node(i, counts_[0])),
                                in_range(sides_[1], 0.5 + 0.5 * node(j, counts_[1])));
      if (!found || (!largest_.empty() && found->size() != largest_.size())) return false;
      if (coefficients_.empty()) {
        largest_.assign(found->size(), 0.0);
        coefficients_.assign(counts_[0] * counts_[1], Values(found->size(), 0.0));
      }
      for (std::size_t f = 0; f < found->size(); ++f)
        largest_[f] = std::max(largest_[f], std::abs((*found)[f]));
      for (std::size_t k = 0; k < counts_[0]; ++k)
        for (std::size_t l = 0; l < counts_[1]; ++l) {
          const double share = weight(k, i, counts_[0]) * weight(l, j, counts_[1]);
          Values& sum = coefficients_[k * counts_[1] + l];
          for (std::size_t f = 0; f < found->size(); ++f) sum[f] += share * (*found)[f];
        }
    }
  return true;
}

std::array<bool, 2> ChebyshevTable::has_converged(const Values& allowed) const {
  std::array<bool, 2> converged{true, true};
  const auto ends_small = [&](std::size_t last, std::size_t before) {
    for (std::size_t f = 0; f < allowed.size(); ++f)
      if (!(std::abs(coefficients_[last][f]) + std::abs(coefficients_[before][f]) <= allowed[f]))
        return false;
    return true;
  };
  const auto [rows, columns] = counts_;
  for (std::size_t l = 0; l < columns && rows > 1; ++l)
    converged[0] = converged[0] && ends_small((rows - 1) * columns + l, (rows - 2) * columns + l);
  for (std::size_t k = 0; k < rows && columns > 1; ++k)
    converged[1] = converged[1] && ends_small(k * columns + columns - 1, k * columns + columns - 2);
  return converged;
}

ChebyshevTable::Values ChebyshevTable::at(double x, double y) const {
  const auto along_x = polynomials(sides_[0], x, counts_[0]), along_y = polynomials(sides_[1], y, counts_[1]);
  Values sum(largest_.size(), 0.0);
  for (std::size_t k = 0; k < counts_[0]; ++k)
    for (std::size_t l = 0; l < counts_[1]; ++l) {
      const double factor = along_x[k] * along_y[l];
      const Values& coefficient = coefficients_[k * counts_[1] + l];
      for (std::size_t f = 0; f < sum.size(); ++f) sum[f] += factor * coefficient[f];
    }
  return sum;
}

}  // namespace stickslip::analytic
