// SPDX-License-Identifier: MIT
#pragma once

/// Owners of GSL's handles, and matrices for GSL.

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_matrix.h>
#include <gsl/gsl_min.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_permutation.h>
#include <gsl/gsl_roots.h>
#include <gsl/gsl_spline.h>
#include <gsl/gsl_vector.h>

#include <algorithm>
#include <memory>

#include "stickslip/analytic/contact_model.hpp"

namespace stickslip::analytic {

struct ReleaseHandle {
  void operator()(gsl_matrix* handle) const { gsl_matrix_free(handle); }
  void operator()(gsl_vector* handle) const { gsl_vector_free(handle); }
  void operator()(gsl_matrix_complex* handle) const { gsl_matrix_complex_free(handle); }
  void operator()(gsl_vector_complex* handle) const { gsl_vector_complex_free(handle); }
  void operator()(gsl_permutation* handle) const { gsl_permutation_free(handle); }
  void operator()(gsl_eigen_nonsymm_workspace* handle) const { gsl_eigen_nonsymm_free(handle); }
  void operator()(gsl_eigen_nonsymmv_workspace* handle) const { gsl_eigen_nonsymmv_free(handle); }
  void operator()(gsl_eigen_gensymmv_workspace* handle) const { gsl_eigen_gensymmv_free(handle); }
  void operator()(gsl_integration_glfixed_table* handle) const { gsl_integration_glfixed_table_free(handle); }
  void operator()(gsl_spline* handle) const { gsl_spline_free(handle); }
  void operator()(gsl_odeiv2_step* handle) const { gsl_odeiv2_step_free(handle); }
  void operator()(gsl_odeiv2_driver* handle) const { gsl_odeiv2_driver_free(handle); }
  void operator()(gsl_root_fsolver* handle) const { gsl_root_fsolver_free(handle); }
  void operator()(gsl_root_fdfsolver* handle) const { gsl_root_fdfsolver_free(handle); }
  void operator()(gsl_min_fminimizer* handle) const { gsl_min_fminimizer_free(handle); }
  void operator()(gsl_odeiv2_control* handle) const { gsl_odeiv2_control_free(handle); }
};

template <class Handle>
using OwnedHandle = std::unique_ptr<Handle, ReleaseHandle>;

template <class Handle>
[[nodiscard]] OwnedHandle<Handle> owned(Handle* handle) {
  return OwnedHandle<Handle>(handle);
}

[[nodiscard]] inline OwnedHandle<gsl_matrix> gsl_copy_of(const Matrix& matrix) {
  auto result = owned(gsl_matrix_alloc(matrix.rows(), matrix.columns()));
  std::ranges::copy(matrix.values(), result->data);
  return result;
}

}  // namespace stickslip::analytic
