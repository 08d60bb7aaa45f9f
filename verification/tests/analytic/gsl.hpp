// SPDX-License-Identifier: MIT
#pragma once

/// GSL's quadrature and numerical differentiation with their own error estimates: the second opinion on the
/// closed forms.

#include <gsl/gsl_deriv.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <functional>
#include <memory>
#include <stdexcept>

namespace stickslip::testing {

/// A numerical value and GSL's estimate of its absolute error.
struct Estimate {
  double value{};
  double error{};
};

using RealFunction = std::function<double(double)>;

/// Keeps GSL from aborting while it lives; a status other than success is then thrown by require_success.
class NoAbort {
 public:
  NoAbort() : previous_(gsl_set_error_handler_off()) {}
  ~NoAbort() { gsl_set_error_handler(previous_); }
  NoAbort(const NoAbort&) = delete;
  NoAbort& operator=(const NoAbort&) = delete;

 private:
  gsl_error_handler_t* previous_;
};

inline void require_success(int status) {
  if (status != GSL_SUCCESS) throw std::runtime_error(gsl_strerror(status));
}

inline gsl_function as_gsl(const RealFunction& function) {
  return {[](double x, void* self) { return (*static_cast<const RealFunction*>(self))(x); },
          const_cast<RealFunction*>(&function)};
}

/// int_lower^upper f dx by adaptive 61-point Gauss-Kronrod rules. scale is the magnitude of int |f| dx, which
/// the absolute error is asked to stay below 1e-11 of.
inline Estimate integral(const RealFunction& function, double lower, double upper, double scale) {
  const NoAbort guard;
  constexpr std::size_t kLimit = 2000;
  const std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)> workspace(
      gsl_integration_workspace_alloc(kLimit), &gsl_integration_workspace_free);
  const gsl_function wrapped = as_gsl(function);
  Estimate estimate;
  require_success(gsl_integration_qag(&wrapped, lower, upper, 1e-11 * scale, 0.0, kLimit, GSL_INTEG_GAUSS61,
                                      workspace.get(), &estimate.value, &estimate.error));
  return estimate;
}

/// f'(x) by central differences of fourth order with step h.
inline Estimate derivative(const RealFunction& function, double x, double h) {
  const NoAbort guard;
  const gsl_function wrapped = as_gsl(function);
  Estimate estimate;
  require_success(gsl_deriv_central(&wrapped, x, h, &estimate.value, &estimate.error));
  return estimate;
}

}  // namespace stickslip::testing
