// SPDX-License-Identifier: MIT
#include "inverse_modes.hpp"

#include <lapacke.h>

#include <algorithm>
#include <arpack.hpp>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

namespace stickslip::analytic {
namespace {

struct Eigenpairs {
  std::vector<double> values, vectors;  // from the largest; one vector after the other
};

std::vector<double> transposed(const std::vector<double>& matrix, std::size_t size) {
  std::vector<double> result(matrix.size());
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) result[i * size + j] = matrix[j * size + i];
  return result;
}

Eigenpairs all_eigenpairs(const SparseMatrix& mass, const SparseCholesky& stiffness) {
  const auto size = static_cast<std::size_t>(mass.rows());
  std::vector<double> matrix(size * size);
  for (std::size_t i = 0; i < size; ++i) matrix[i * (size + 1)] = 1.0;
  matrix = stiffness.to_factor(transposed(stiffness.to_factor(mass * matrix), size));
  Eigenpairs pairs{std::vector<double>(size), {}};
  if (LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'L', mass.rows(), matrix.data(), mass.rows(),
                     pairs.values.data()) != 0)
    throw std::runtime_error("LAPACK finds no modes of the matrices.");
  std::ranges::reverse(pairs.values);
  for (std::size_t n = size; n-- > 0;)
    pairs.vectors.insert(pairs.vectors.end(), matrix.begin() + static_cast<std::ptrdiff_t>(n * size),
                         matrix.begin() + static_cast<std::ptrdiff_t>((n + 1) * size));
  return pairs;
}

Eigenpairs largest_eigenpairs(const SparseMatrix& mass, const SparseCholesky& stiffness, int count) {
  const int size = mass.rows(), basis = std::min(size, 2 * count + 20);
  const auto rows = static_cast<std::size_t>(size);
  std::vector<double> start(rows), vectors(rows * static_cast<std::size_t>(basis)), work(3 * rows),
      small(static_cast<std::size_t>(basis) * static_cast<std::size_t>(basis + 8));
  std::mt19937 random;  // a start of our own, so that each call has the same
  for (double& value : start) value = static_cast<double>(random()) / std::mt19937::max() - 0.5;
  std::array<int, 11> parameters{1, 0, 1000, 1, 0, 0, 1}, pointers{};
  const auto workspace = static_cast<int>(small.size());
  int task = 0, status = 1;
  for (;;) {
    arpack::saupd(task, arpack::bmat::identity, size, arpack::which::largest_algebraic, count, 0.0,
                  start.data(), basis, vectors.data(), size, parameters.data(), pointers.data(), work.data(),
                  small.data(), workspace, status);
    if (std::abs(task) != 1) break;
    const std::span from(&work[static_cast<std::size_t>(pointers[0] - 1)], rows);
    std::ranges::copy(stiffness.to_factor(mass * stiffness.from_factor(from)),
                      work.begin() + pointers[1] - 1);
  }
  if (status < 0 || parameters[4] < count) throw std::runtime_error("ARPACK finds no modes of the matrices.");
  std::vector<int> select(static_cast<std::size_t>(basis));
  Eigenpairs pairs{std::vector<double>(static_cast<std::size_t>(count)), {}};
  arpack::seupd(1, arpack::howmny::ritz_vectors, select.data(), pairs.values.data(), vectors.data(), size,
                0.0, arpack::bmat::identity, size, arpack::which::largest_algebraic, count, 0.0, start.data(),
                basis, vectors.data(), size, parameters.data(), pointers.data(), work.data(), small.data(),
                workspace, status);
  if (status != 0) throw std::runtime_error("ARPACK finds no modes of the matrices.");
  std::ranges::reverse(pairs.values);
  for (std::size_t n = pairs.values.size(); n-- > 0;)
    pairs.vectors.insert(pairs.vectors.end(), vectors.begin() + static_cast<std::ptrdiff_t>(n * rows),
                         vectors.begin() + static_cast<std::ptrdiff_t>((n + 1) * rows));
  return pairs;
}

}  // namespace

data::FieldError indefinite_mass() {
  return {"model.mass_matrix", "indefinite", "positive definite, but for rows without mass"};
}

InverseModes inverse_modes(const SparseMatrix& mass, const SparseCholesky& stiffness, std::size_t count) {
  const bool is_small = mass.rows() <= most_dense_rows;
  auto [values, vectors] = is_small ? all_eigenpairs(mass, stiffness)
                                    : largest_eigenpairs(mass, stiffness, static_cast<int>(count));
  const double zero = least_inverse_square * std::abs(values.front());
  if (values.back() < -zero || !(values.front() > 0.0)) throw indefinite_mass();
  InverseModes modes;
  const auto rows = static_cast<std::size_t>(mass.rows());
  for (const double value : values) {
    if (!(value > zero)) break;
    modes.angular_frequency.push_back(1.0 / std::sqrt(value));
  }
  modes.are_all = is_small || modes.angular_frequency.size() < values.size();
  vectors.resize(rows * modes.angular_frequency.size());
  if (!vectors.empty()) modes.shapes = stiffness.from_factor(vectors);
  for (std::size_t i = 0; i < modes.shapes.size(); ++i) modes.shapes[i] *= modes.angular_frequency[i / rows];
  return modes;
}

}  // namespace stickslip::analytic
