// SPDX-License-Identifier: MIT
#include "first_order_modes.hpp"

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gsl_handles.hpp"
#include "gsl_status.hpp"

namespace stickslip::analytic {
namespace {

using Complex = std::complex<double>;

Complex from_gsl(gsl_complex value) { return {GSL_REAL(value), GSL_IMAG(value)}; }

struct Eigensystem {
  OwnedHandle<gsl_vector_complex> values;
  OwnedHandle<gsl_matrix_complex> vectors, inverse;  // by columns, and by rows
};

Eigensystem eigensystem_of(const gsl_matrix& matrix) {
  const StatusInsteadOfAbort guard;
  const std::size_t size = matrix.size1;
  const auto work = owned(gsl_matrix_alloc(size, size));
  gsl_matrix_memcpy(work.get(), &matrix);
  Eigensystem result{owned(gsl_vector_complex_alloc(size)), owned(gsl_matrix_complex_alloc(size, size)),
                     owned(gsl_matrix_complex_alloc(size, size))};
  const auto workspace = owned(gsl_eigen_nonsymmv_alloc(size));
  gsl_eigen_nonsymmv_params(1, workspace.get());
  require_success(gsl_eigen_nonsymmv(work.get(), result.values.get(), result.vectors.get(), workspace.get()),
                  "eigenvalues of a damped structure");

  const auto factors = owned(gsl_matrix_complex_alloc(size, size));
  const auto permutation = owned(gsl_permutation_alloc(size));
  int sign = 0;
  gsl_matrix_complex_memcpy(factors.get(), result.vectors.get());
  require_success(gsl_linalg_complex_LU_decomp(factors.get(), permutation.get(), &sign), "eigenvectors");
  require_success(gsl_linalg_complex_LU_invert(factors.get(), permutation.get(), result.inverse.get()),
                  "eigenvectors of a damped structure");
  return result;
}

// Z lambda W must be the matrix again, to nine digits.
bool is_separated(const gsl_matrix& matrix, const std::vector<Complex>& eigenvalue,
                  const std::vector<Complex>& shape, const std::vector<Complex>& inverse) {
  const std::size_t size = matrix.size1, count = eigenvalue.size();
  double largest = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      double rebuilt = 0.0;
      for (std::size_t k = 0; k < count; ++k)
        rebuilt += (shape[i * count + k] * eigenvalue[k] * inverse[k * size + j]).real();
      const double entry = gsl_matrix_get(&matrix, i, j);
      largest = std::max(largest, std::abs(rebuilt - entry));
      scale = std::max(scale, std::abs(entry));
    }
  }
  return largest <= 1e-9 * scale;
}

}  // namespace

std::tuple<std::vector<Complex>, std::vector<Complex>, std::vector<Complex>> first_order_modes(
    const gsl_matrix& matrix, const std::string& structure) {
  const Eigensystem modes = eigensystem_of(matrix);
  const std::size_t size = matrix.size1;
  std::vector<Complex> eigenvalue, shape, inverse;
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < size; ++k)
    if (GSL_IMAG(gsl_vector_complex_get(modes.values.get(), k)) >= 0.0) kept.push_back(k);
  shape.resize(size * kept.size());
  for (std::size_t j = 0; j < kept.size(); ++j) {
    const Complex value = from_gsl(gsl_vector_complex_get(modes.values.get(), kept[j]));
    eigenvalue.push_back(value);
    const double weight = value.imag() > 0.0 ? 2.0 : 1.0;
    for (std::size_t i = 0; i < size; ++i) {
      shape[i * kept.size() + j] = weight * from_gsl(gsl_matrix_complex_get(modes.vectors.get(), i, kept[j]));
      inverse.push_back(from_gsl(gsl_matrix_complex_get(modes.inverse.get(), kept[j], i)));
    }
  }
  if (!is_separated(matrix, eigenvalue, shape, inverse))
    throw std::runtime_error("a mode of " + structure + " is too nearly critically damped to be separated.");
  return {eigenvalue, shape, inverse};
}

}  // namespace stickslip::analytic
