// SPDX-License-Identifier: MIT
#pragma once

namespace stickslip::solver {

/// A point with f(x) ≥ 0 at most `tolerance` from a root of f in [low, high], where f(low) < 0 ≤ f(high),
/// by the Illinois variant of regula falsi (Dowell & Jarratt, BIT 11, 1971), which keeps the root bracketed
/// and converges superlinearly. Falls back to bisection every fourth step, so that it always ends.
template <typename Function>
double bracketed_root(Function&& f, double low, double f_low, double high, double f_high, double tolerance) {
  double result = high;
  bool last_moved_low = false, moved_before = false;
  for (int iteration = 1; high - low > tolerance && f_high > 0.0 && iteration <= 200; ++iteration) {
    const double secant = high - f_high * (high - low) / (f_high - f_low);
    const bool usable = iteration % 4 != 0 && secant > low && secant < high;
    const double x = usable ? secant : low + 0.5 * (high - low);
    if (x <= low || x >= high) break;
    const double value = f(x);
    if (value < 0.0) {
      low = x, f_low = value;
      if (moved_before && last_moved_low) f_high *= 0.5;
      last_moved_low = true;
    } else {
      high = result = x, f_high = value;
      if (moved_before && !last_moved_low) f_low *= 0.5;
      last_moved_low = false;
    }
    moved_before = true;
  }
  return result;
}

}  // namespace stickslip::solver
