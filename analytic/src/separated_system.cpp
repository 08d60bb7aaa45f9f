// SPDX-License-Identifier: MIT
#include "separated_system.hpp"

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gsl_handles.hpp"
#include "gsl_status.hpp"
#include "root_finding.hpp"

namespace stickslip::analytic {
namespace {

using Complex = std::complex<double>;

Complex from_gsl(gsl_complex value) { return {GSL_REAL(value), GSL_IMAG(value)}; }

double error_of(const SeparatedSystem& system, const std::vector<double>& matrix, std::size_t size) {
  const std::size_t count = system.eigenvalue.size();
  double largest = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) {
      double rebuilt = 0.0;
      for (std::size_t k = 0; k < count; ++k)
        rebuilt += (system.shape[i * count + k] * system.eigenvalue[k] * system.inverse[k * size + j]).real();
      if (!std::isfinite(rebuilt)) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, std::abs(rebuilt - matrix[i * size + j]));
      scale = std::max(scale, std::abs(matrix[i * size + j]));
    }
  return largest / scale;
}

}  // namespace

SeparatedSystem separated_system(const std::vector<double>& matrix, std::size_t size, const char* what) {
  const StatusInsteadOfAbort guard;
  const auto work = owned(gsl_matrix_alloc(size, size));
  std::ranges::copy(matrix, work->data);
  const auto values = owned(gsl_vector_complex_alloc(size));
  const auto vectors = owned(gsl_matrix_complex_alloc(size, size)),
             factors = owned(gsl_matrix_complex_alloc(size, size)),
             inverse = owned(gsl_matrix_complex_alloc(size, size));
  const auto workspace = owned(gsl_eigen_nonsymmv_alloc(size));
  gsl_eigen_nonsymmv_params(1, workspace.get());
  require_success(gsl_eigen_nonsymmv(work.get(), values.get(), vectors.get(), workspace.get()), what);

  SeparatedSystem system;
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < size; ++k)
    if (GSL_IMAG(gsl_vector_complex_get(values.get(), k)) >= 0.0) kept.push_back(k);
  for (const std::size_t k : kept)
    system.eigenvalue.push_back(from_gsl(gsl_vector_complex_get(values.get(), k)));
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t k = 0; k < kept.size(); ++k)
      system.shape.push_back((system.eigenvalue[k].imag() > 0.0 ? 2.0 : 1.0) *
                             from_gsl(gsl_matrix_complex_get(vectors.get(), i, kept[k])));

  const auto permutation = owned(gsl_permutation_alloc(size));
  int sign = 0;
  gsl_matrix_complex_memcpy(factors.get(), vectors.get());
  require_success(gsl_linalg_complex_LU_decomp(factors.get(), permutation.get(), &sign), what);
  if (gsl_linalg_complex_LU_invert(factors.get(), permutation.get(), inverse.get()) != GSL_SUCCESS) {
    system.error = std::numeric_limits<double>::infinity();
    return system;
  }
  for (const std::size_t k : kept)
    for (std::size_t i = 0; i < size; ++i)
      system.inverse.push_back(from_gsl(gsl_matrix_complex_get(inverse.get(), k, i)));
  system.error = error_of(system, matrix, size);
  return system;
}

}  // namespace stickslip::analytic
