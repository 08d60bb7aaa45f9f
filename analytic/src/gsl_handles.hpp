// SPDX-License-Identifier: MIT
#pragma once

/// Owners of GSL's handles, and matrices for GSL.

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_matrix.h>
#include <gsl/gsl_min.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_permutation.h>
#include <gsl/gsl_roots.h>
#include <gsl/gsl_spline.h>
#include <gsl/gsl_vector.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>

#include "stickslip/analytic/contact_model.hpp"

namespace stickslip::analytic {

// GSL's status codes as exceptions.

/// Turns off GSL's aborting error handler while at least one instance lives, in whatever thread, and then
/// puts back the handler that was there before the first.
class StatusInsteadOfAbort {
 public:
  StatusInsteadOfAbort() {
    const std::lock_guard lock(mutex_);
    if (instances_++ == 0) previous_ = gsl_set_error_handler_off();
  }
  ~StatusInsteadOfAbort() {
    const std::lock_guard lock(mutex_);
    if (--instances_ == 0) gsl_set_error_handler(previous_);
  }
  StatusInsteadOfAbort(const StatusInsteadOfAbort&) = delete;
  StatusInsteadOfAbort& operator=(const StatusInsteadOfAbort&) = delete;

 private:
  static inline std::mutex mutex_;
  static inline int instances_ = 0;
  static inline gsl_error_handler_t* previous_ = nullptr;
};

/// Throws std::runtime_error, "<where>: <GSL's reason>.", unless status is success.
inline void require_success(int status, const std::string& where) {
  if (status != GSL_SUCCESS) throw std::runtime_error(where + ": " + gsl_strerror(status) + ".");
}

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

/// Calls f(x, weight) at the 16 Gauss-Legendre points of each of `panels` equal parts of from ... to.
template <class Function>
void for_each_gauss_point(double from, double to, std::size_t panels, const Function& f) {
  constexpr std::size_t points = 16;
  const auto table = owned(gsl_integration_glfixed_table_alloc(points));
  const double width = (to - from) / static_cast<double>(panels);
  for (std::size_t panel = 0; panel < panels; ++panel) {
    const double left = from + width * static_cast<double>(panel);
    for (std::size_t i = 0; i < points; ++i) {
      double x = 0.0, weight = 0.0;
      gsl_integration_glfixed_point(left, left + width, i, &x, &weight, table.get());
      f(x, weight);
    }
  }
}

}  // namespace stickslip::analytic
