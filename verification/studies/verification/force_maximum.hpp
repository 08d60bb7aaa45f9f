// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/data/problem.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// |f_max| of Eqs. (29), (30) at one excitation, by several methods.
struct ForceMaximumStudy {
  double frequency_hz{};
  double amplitude{};                 ///< m
  double sampled{};                   ///< N modes, sampled at numerics.time_step(), N
  analytic::Bounds truncated;         ///< N modes, bounds of the search over time
  analytic::Bounds converged;         ///< exact steady part and 100 free vibrations, bounds for these modes
  double finite_element{};            ///< largest |f| over the time steps of a run with a bonded tip
  double predicted_finite_element{};  ///< PredictedForce::max_abs
  double prediction_uncertainty{};    ///< PredictedForce::uncertainty

  /// Relative differences: of `sampled` from `truncated`, of that from `converged`, of `finite_element` from `converged`
  /// and from its prediction, and of `sampled` from the printed value, which must exist for the frequency.
  [[nodiscard]] double sampling_difference() const;
  [[nodiscard]] double truncation_difference() const;
  [[nodiscard]] double discretisation_difference() const;
  [[nodiscard]] double prediction_difference() const;
  [[nodiscard]] double printed_difference() const;
};
STICKSLIP_MEMBERS(ForceMaximumStudy, (frequency_hz, "Hz"), (amplitude, "m"), (sampled, "N"), (truncated, "N"),
                  (converged, "N"), (finite_element, "N"), (predicted_finite_element, "N"),
                  (prediction_uncertainty, "N"), (sampling_difference(), "1"), (truncation_difference(), "1"),
                  (discretisation_difference(), "1"), (prediction_difference(), "1"),
                  (printed_difference(), "1"))

/// Of an undamped case.
[[nodiscard]] ForceMaximumStudy force_maximum_study(const data::Case& problem);

/// The ratio of two curves of the critical amplitude, point by point: the values below which a tenth, half and nine tenths of all are.
struct AmplitudeRatio {
  double low_tenth{}, median{}, high_tenth{};
};
STICKSLIP_MEMBERS(AmplitudeRatio, (low_tenth, "1"), (median, "1"), (high_tenth, "1"))
/// Of `curve` over `reference`, which has as many points.
[[nodiscard]] AmplitudeRatio amplitude_ratio(const std::vector<CriticalAmplitudePoint>& curve,
                                             const std::vector<CriticalAmplitudePoint>& reference);

// What Figs. 2 and 10 of the paper draw.

/// The friction law of Eq. (7) at a sliding velocity.
struct FrictionPoint {
  double sliding_velocity{};  ///< m/s
  double coefficient{};       ///< μ(v)
  double friction_force{};    ///< f_d = -sgn(v) μ(v) P, N
};
STICKSLIP_MEMBERS(FrictionPoint, (sliding_velocity, "m/s"), (coefficient, "1"), (friction_force, "N"))

/// Fig. 2, from -5 to 5 m/s. The force jumps at v = 0, which stands there twice.
[[nodiscard]] std::vector<FrictionPoint> friction_curve(const data::FrictionLaw& law, double normal_force);

struct ForceLine {
  double frequency_hz{};
  std::vector<double> amplitude;  ///< m, ascending
  std::vector<double> force_max;  ///< |f_max|, N
};
STICKSLIP_MEMBERS(ForceLine, (frequency_hz, "Hz"), (amplitude, "m"), (force_max, "N"))

/// Fig. 10 up to 1 mm. |f_max| is proportional to the amplitude and reaches the friction limit μ_s P (N) at the critical
/// one, which `criterion` has: of its points every hertz, and every 0.25 Hz within 2 Hz of a natural frequency (Hz).
[[nodiscard]] std::vector<ForceLine> force_surface(double friction_limit,
                                                   const std::vector<CriticalAmplitudePoint>& criterion,
                                                   const std::vector<double>& natural_frequencies);

}  // namespace stickslip::studies
