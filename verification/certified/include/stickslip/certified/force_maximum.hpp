// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "stickslip/certified/beam.hpp"
#include "stickslip/certified/stick_response.hpp"

namespace stickslip::certified {

struct ForceMaximum {
  Real value;               ///< N
  std::vector<Real> times;  ///< s: balls of which one contains the time of the maximum
};

/// Encloses max |a_1 sin(w_1 t) + a_2 sin(w_2 t) + ...| over 0 ≤ t ≤ duration.
///
/// The first part works in doubles. Let m be the midpoint of a time interval and r its half-width. With M =
/// sum |a_i| w_i² ≥ |f''| and the error bound E of the evaluation, the interval is removed if |f(m)| +
/// |f'(m)| r + M r²/2 + E is below the largest |f| - E found so far; otherwise it is halved. The second part
/// isolates all roots of f' in the remaining intervals by ball arithmetic and evaluates f there.
///
/// The enclosure is proven under one assumption: the error of sin and cos of the C library is at most 2⁻⁵²,
/// twice the value that glibc states. It is used when intervals are removed.
///
/// Throws std::invalid_argument, naming excitation.duration, unless it is positive, or if a sinusoid is known
/// to less than 60 bits. Throws std::domain_error if the evaluation in doubles is too inaccurate, which
/// happens near a resonance (relative distance below about 1e-7), where large amplitudes cancel, or if more
/// than a million intervals remain. Throws what isolate_roots() throws if f is stationary at the very end.
[[nodiscard]] ForceMaximum max_abs_of_sinusoids(const std::vector<Sinusoid>& sinusoids,
                                                const Rational& duration);

/// Encloses the maximum of |f|, N, of the friction force of the stick state, Eq. (28), with N = `modes`
/// modes. Also throws what StickResponse::force_sinusoids() throws.
[[nodiscard]] ForceMaximum max_abs_friction_force(const Beam& beam, const Excitation& excitation,
                                                  const Rational& duration, int modes = 10);

}  // namespace stickslip::certified
