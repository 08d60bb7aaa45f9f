// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "gsl_handles.hpp"

namespace stickslip::analytic {

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
