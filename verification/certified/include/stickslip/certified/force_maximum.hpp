#pragma once

#include <vector>

#include "stickslip/certified/beam.hpp"
#include "stickslip/certified/stick_response.hpp"

namespace stickslip::certified {

/// The maximum of |f| over a span of time.
struct ForceMaximum {
  Real value;               ///< N
  std::vector<Real> times;  ///< s: one ball if it is known where the maximum is, else those it is in one of
};

/// max |a_1 sin(w_1 t) + a_2 sin(w_2 t) + ...| over 0 <= t <= duration: a proof that no time was overlooked.
///
/// First in doubles: an interval of half width r round m is dropped if |f(m)| + |f'(m)| r + M r^2/2 + E, with
/// M = sum |a_i| w_i^2 >= |f''| and E the error bound of the evaluation, is below the largest |f| - E found
/// so far; else it is halved. In what is left all roots of f' are isolated in ball arithmetic, and f is
/// evaluated there. sin and cos of the C library are trusted to 2^-52, twice what glibc states, when
/// intervals are dropped.
///
/// Throws std::invalid_argument, naming numerics.duration, unless it is positive, or if a sinusoid is known
/// to less than 60 bits, and std::domain_error if the evaluation in doubles is too coarse: next to a
/// resonance (relative distance below about 1e-7), where large amplitudes cancel.
[[nodiscard]] ForceMaximum max_abs_of_sinusoids(const std::vector<Sinusoid>& sinusoids,
                                                const Rational& duration);

/// The same for the friction force of the stick state, Eq. (28), N modes. Throws also as
/// StickResponse::force_sinusoids().
[[nodiscard]] ForceMaximum max_abs_friction_force(const Beam& beam, const Excitation& excitation,
                                                  const Rational& duration, int modes = 10);

}  // namespace stickslip::certified
