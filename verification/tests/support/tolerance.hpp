// SPDX-License-Identifier: MIT
#pragma once

/// How a test compares two numbers. A tolerance is derived or called empirical, and belongs to one of three classes,
/// each built by a helper below; a failing comparison prints expected, computed, error, tolerance and
/// margin.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <limits>
#include <sstream>
#include <string>

#include "studies/common/convergence.hpp"
#include "support/trace.hpp"

namespace stickslip::testing {

using studies::largest_or_nan;
using studies::observed_order;

/// An allowed absolute error, with its class and where it comes from.
struct Tolerance {
  double value{};
  std::string tolerance_class;
  std::string derivation;
};

/// Round-off: c * n * eps * kappa * scale. `operations` is the length of the longest dependent chain of
/// operations, `condition` the condition number, `scale` the magnitude of the result.
inline Tolerance round_off(double operations, double condition, double scale) {
  std::ostringstream text;
  text << "4 * " << operations << " operations * eps * condition " << condition << " * scale " << scale;
  return {4.0 * operations * std::numeric_limits<double>::epsilon() * condition * std::abs(scale),
          "round-off", text.str()};
}

/// Discretisation: the predicted error times a stated margin for the terms behind the leading one.
inline Tolerance discretisation(double predicted_error, double margin, const std::string& law) {
  std::ostringstream text;
  text << law << " predicts " << predicted_error << ", margin " << margin;
  return {std::abs(predicted_error) * margin, "discretisation", text.str()};
}

/// Reference: the accuracy that is recorded with the datum.
inline Tolerance reference(double accuracy, const std::string& source) {
  return {accuracy, "reference", "accuracy of " + source};
}

/// The largest |item|, or |function(item)|, or NaN if one of them is. The function may be a member.
template <class Range, class Function = std::identity>
double largest(const Range& items, const Function& function = {}) {
  double found = 0.0;
  for (const auto& item : items) found = largest_or_nan({found, std::abs(std::invoke(function, item))});
  return found;
}

/// |computed - expected| <= tolerance, and neither is NaN. The comparison is recorded for the traceability matrix; a failure says the
/// name.
inline ::testing::AssertionResult within(double computed, double expected, const Tolerance& tolerance,
                                         const std::string& name = "") {
  const double error = std::abs(computed - expected);
  note({computed, expected, error, tolerance.value, tolerance.tolerance_class, tolerance.derivation});
  if (error <= tolerance.value) return ::testing::AssertionSuccess();
  std::ostringstream text;
  text.precision(17);
  text << name << "\n  expected  " << expected << "\n  computed  " << computed << "\n  error     " << error
       << "\n  tolerance " << tolerance.value << "  (" << tolerance.tolerance_class << ": "
       << tolerance.derivation << ")\n  margin    " << error / tolerance.value
       << " (error / tolerance, allowed up to 1)";
  return ::testing::AssertionFailure() << text.str();
}

/// The same of complex numbers: |computed - expected| <= tolerance.
inline ::testing::AssertionResult within(std::complex<double> computed, std::complex<double> expected,
                                         const Tolerance& tolerance) {
  return within(std::abs(computed - expected), 0.0, tolerance) << "\n"
                                                               << computed << " instead of " << expected;
}

}  // namespace stickslip::testing
