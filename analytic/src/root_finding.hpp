// SPDX-License-Identifier: MIT
#pragma once

/// GSL's one-dimensional root finders and minimiser for C++ callables: handles are released by their owners,
/// and a GSL status other than success becomes a std::runtime_error instead of an abort.

#include <gsl/gsl_math.h>

#include <memory>

#include "stickslip/analytic/force_maximum.hpp"

namespace stickslip::analytic {

/// Root in a bracket whose ends have different signs, by Brent's method, until the bracket is shorter than
/// relative_tolerance times the root.
[[nodiscard]] double brent_root(gsl_function function, Bounds bracket, double relative_tolerance);

/// Root by Brent's method to six digits, then by Newton's until its step is below round-off.
[[nodiscard]] double newton_polished_root(gsl_function_fdf function, Bounds bracket);

/// Where the minimum inside an interval is taken, by Brent's method; `guess` lies inside and has a smaller value than both
/// ends. The argument is good to about the square root of round-off, hence the value to round-off.
[[nodiscard]] double brent_minimum(gsl_function function, Bounds interval, double guess);

/// A callable double -> double as GSL sees it. The callable must outlive what is returned.
template <class Callable>
[[nodiscard]] gsl_function as_gsl_function(const Callable& callable) {
  return {[](double x, void* self) { return (*static_cast<const Callable*>(self))(x); },
          const_cast<Callable*>(std::addressof(callable))};
}

/// A class with value(x) and derivative(x) as GSL sees it. The object must outlive what is returned.
template <class Differentiable>
[[nodiscard]] gsl_function_fdf as_gsl_function_with_derivative(const Differentiable& function) {
  gsl_function_fdf wrapped;
  wrapped.f = [](double x, void* self) { return static_cast<const Differentiable*>(self)->value(x); };
  wrapped.df = [](double x, void* self) { return static_cast<const Differentiable*>(self)->derivative(x); };
  wrapped.fdf = [](double x, void* self, double* value, double* derivative) {
    *value = static_cast<const Differentiable*>(self)->value(x);
    *derivative = static_cast<const Differentiable*>(self)->derivative(x);
  };
  wrapped.params = const_cast<Differentiable*>(std::addressof(function));
  return wrapped;
}

}  // namespace stickslip::analytic
