// SPDX-License-Identifier: MIT
#include "separated_system.hpp"

#include <gsl/gsl_complex_math.h>
#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "gsl_handles.hpp"

namespace stickslip::analytic {
namespace {

using Complex = std::complex<double>;

Complex from_gsl(gsl_complex value) { return {GSL_REAL(value), GSL_IMAG(value)}; }

double error_of(const SeparatedSystem& system, const Matrix& matrix) {
  const std::size_t count = system.eigenvalue.size(), size = matrix.rows();
  double largest = 0.0, scale = 0.0;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) {
      double rebuilt = 0.0;
      for (std::size_t k = 0; k < count; ++k)
        rebuilt += (system.shape[i * count + k] * system.eigenvalue[k] * system.inverse[k * size + j]).real();
      if (!std::isfinite(rebuilt)) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, std::abs(rebuilt - matrix(i, j)));
      scale = std::max(scale, std::abs(matrix(i, j)));
    }
  return largest / scale;
}

}  // namespace

SeparatedSystem separated_system(const Matrix& matrix, const char* what) {
  const StatusInsteadOfAbort guard;
  const std::size_t size = matrix.rows();
  const auto work = gsl_copy_of(matrix);
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
  system.error = error_of(system, matrix);
  return system;
}

Matrix first_order_matrix(const ContactDynamics& dynamics, const std::vector<double>& scale, double unit,
                          double stiffness, double slope) {
  const std::size_t m = dynamics.modes(), half = m + 1, size = 2 * half;
  Matrix matrix(size, size);
  std::vector<double> state(size), accelerations(half);
  for (std::size_t j = 0; j < size; ++j) {
    state[j] = j < half ? 1.0 / scale[j] : 1.0;
    const double force = slope * state[size - 1] - stiffness * state[m];
    accelerations[m] =
        dynamics.accelerate(view(state.data(), m), {}, force, std::span(accelerations).first(m));
    for (std::size_t i = 0; i < half; ++i) matrix(half + i, j) = accelerations[i] / unit;
    if (j >= half) matrix(j - half, j) = scale[j - half] / unit;
    state[j] = 0.0;
  }
  return matrix;
}

}  // namespace stickslip::analytic
