// SPDX-License-Identifier: MIT
#include "root_finding.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "arguments.hpp"
#include "gsl_handles.hpp"

namespace stickslip::analytic {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr int kMaximumIterations = 500;

std::string located(const std::string& method, Bounds interval) {
  return method + " between " + data::shortest_text(interval.lower) + " and " +
         data::shortest_text(interval.upper);
}

[[noreturn]] void throw_not_converged(const std::string& where) {
  throw std::runtime_error(where + ": no convergence in " + std::to_string(kMaximumIterations) +
                           " iterations.");
}

}  // namespace

double brent_root(gsl_function function, Bounds bracket, double relative_tolerance) {
  const StatusInsteadOfAbort guard;
  const std::string where = located("Brent's root finder", bracket);
  const auto solver = owned(gsl_root_fsolver_alloc(gsl_root_fsolver_brent));
  require_success(gsl_root_fsolver_set(solver.get(), &function, bracket.lower, bracket.upper), where);
  for (int i = 0; i < kMaximumIterations; ++i) {
    require_success(gsl_root_fsolver_iterate(solver.get()), where);
    const double lower = gsl_root_fsolver_x_lower(solver.get());
    const double upper = gsl_root_fsolver_x_upper(solver.get());
    if (upper - lower <= relative_tolerance * std::abs(upper)) return gsl_root_fsolver_root(solver.get());
  }
  throw_not_converged(where);
}

double newton_polished_root(gsl_function_fdf function, Bounds bracket) {
  const gsl_function value_only{function.f, function.params};
  double root = brent_root(value_only, bracket, 1e-6);

  const StatusInsteadOfAbort guard;
  const std::string where = located("Newton's root finder", bracket);
  const auto solver = owned(gsl_root_fdfsolver_alloc(gsl_root_fdfsolver_newton));
  require_success(gsl_root_fdfsolver_set(solver.get(), &function, root), where);
  double last_step = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMaximumIterations; ++i) {
    require_success(gsl_root_fdfsolver_iterate(solver.get()), where);
    const double next = gsl_root_fdfsolver_root(solver.get());
    if (!(next >= bracket.lower && next <= bracket.upper))
      throw std::runtime_error(where + ": the iterate " + data::shortest_text(next) + " left the bracket.");
    const double step = std::abs(next - root);
    // Steps shrink quadratically until round-off makes them wander.
    if (step >= last_step) return root;
    if (step <= kEpsilon * std::abs(next)) return next;
    root = next;
    last_step = step;
  }
  throw_not_converged(where);
}

double brent_minimum(gsl_function function, Bounds interval, double guess) {
  const StatusInsteadOfAbort guard;
  const std::string where = located("Brent's minimiser", interval);
  const auto solver = owned(gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent));
  require_success(gsl_min_fminimizer_set(solver.get(), &function, guess, interval.lower, interval.upper),
                  where);
  for (int i = 0; i < kMaximumIterations; ++i) {
    require_success(gsl_min_fminimizer_iterate(solver.get()), where);
    const double lower = gsl_min_fminimizer_x_lower(solver.get());
    const double upper = gsl_min_fminimizer_x_upper(solver.get());
    // The method itself does not step closer than √(eps).
    if (upper - lower <= 8.0 * GSL_SQRT_DBL_EPSILON * std::abs(upper))
      return gsl_min_fminimizer_x_minimum(solver.get());
  }
  throw_not_converged(where);
}

}  // namespace stickslip::analytic
