// SPDX-License-Identifier: MIT
#pragma once

/// Stumpff functions, entire functions of z that join trigonometric (z > 0), polynomial (z = 0) and
/// hyperbolic (z < 0) formulas into one:
///
///     c0 = cos y,  c1 = sin(y)/y,  c2 = (1 - cos y)/y^2,  c3 = (y - sin y)/y^3,      y = sqrt(z),
///
/// and d/ds [s^k c_k(z s^2)] = s^(k-1) c_(k-1)(z s^2).

namespace stickslip::analytic {

/// exp(-decay) c_k(z) for k = 0 ... 3. With decay >= sqrt(-z) nothing overflows, however large -z is.
/// Relative accuracy: a few eps away from the zeros of c0 and c1.
[[nodiscard]] double scaled_stumpff(int k, double z, double decay);

/// c_k(z), k = 0 ... 3.
[[nodiscard]] inline double stumpff(int k, double z) { return scaled_stumpff(k, z, 0.0); }

}  // namespace stickslip::analytic
