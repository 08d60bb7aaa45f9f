// SPDX-License-Identifier: MIT
#pragma once

/// What the criterion |f_max| > μ_s P over 0 ... T, Eqs. (29) and (30), is: that of a start-up without
/// damping. The free vibrations of the start never decay in |f_max|. This study shows what they add to the
/// steady vibration, and how |f_max| depends on T, on damping and on the slenderness of the beam.

#include <string>
#include <vector>

#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"
#include "studies/history/history_convergence.hpp"

namespace stickslip::studies {

struct ForceHorizon {
  double duration{};           ///< T, s
  analytic::Bounds force_max;  ///< all modes, N
};
STICKSLIP_MEMBERS(ForceHorizon, (duration, "s"), (force_max, "N"))

/// The force of the undamped held beam at one frequency.
struct SteadyForce {
  double frequency_hz{}, amplitude{};  ///< Hz, m
  double steady{};  ///< amplitude of f at Ω in closed form, N; infinite at a natural frequency
  bool grows{};     ///< |f| grows over all of numerics.duration() (Concern::resonance)
  std::vector<ForceHorizon> horizons;
};
STICKSLIP_MEMBERS(SteadyForce, (frequency_hz, "Hz"), (amplitude, "m"), (steady, "N"), (grows, "1"),
                  (horizons))

/// Steady force of a beam with Kelvin-Voigt damping and its tip held.
struct SteadyDampedForce {
  double frequency_hz{}, amplitude{};  ///< Hz, m
  double ratio{};                      ///< fraction of critical damping of stick mode 1, η ω_1/2
  double steady{};                     ///< closed form (analytic::DampedSteadyState), N
};
STICKSLIP_MEMBERS(SteadyDampedForce, (frequency_hz, "Hz"), (amplitude, "m"), (ratio, "1"), (steady, "N"))

/// |f_max| of Euler-Bernoulli theory and with rotary inertia and shear (with_shear()).
struct SlenderForce {
  double frequency_hz{};
  /// Relative, of Euler-Bernoulli theory in each natural frequency that is kept.
  std::vector<double> model_errors;
  double force_max{}, shifted_force_max{};  ///< N
};
STICKSLIP_MEMBERS(SlenderForce, (frequency_hz, "Hz"), (model_errors, "1"), (force_max, "N"),
                  (shifted_force_max, "N"))

/// The critical amplitude with half of E I against that with E I, at the same frequency in Hz.
struct SofterBeam {
  int larger{}, all{};             ///< frequencies at which it is larger, of how many
  double lowest_ratio{}, at_hz{};  ///< softer over stiffer
};
STICKSLIP_MEMBERS(SofterBeam, (larger, "1"), (all, "1"), (lowest_ratio, "1"), (at_hz, "Hz"))

/// What is left of a history after its large slips.
struct LateSlips {
  double range{};        ///< of y(L), m
  double settled{};      ///< from here on y(L) is within settled_share of the range from its last value, s
  double later_range{};  ///< of y(L) from then on, m
};
STICKSLIP_MEMBERS(LateSlips, (range, "m"), (settled, "s"), (later_range, "m"))
inline constexpr double settled_share = 0.05;

/// A case in dimensionless groups, and the evidence for its beam: |f_max| of finite elements over numerics.duration(), held tip,
/// no damping.
struct DimensionlessCase {
  std::string name;
  double load{};         ///< P over the buckling load of the stick state
  double slenderness{};  ///< L √(A/I)
  double frequency{};    ///< Ω/ω_1 of the stick state
  double friction{};     ///< μ_s
  double decay{};        ///< α A_0 Ω
  double damping{};      ///< of stick mode 1, as a fraction of critical: ratio + η ω_1/2
  double force_error{};  ///< relative, of |f_max| from all modes
  double unpredicted{};  ///< error of the prediction of |f_max| (PredictedForce) over its uncertainty
};
STICKSLIP_MEMBERS(DimensionlessCase, (name, "-"), (load, "1"), (slenderness, "1"), (frequency, "1"),
                  (friction, "1"), (decay, "1"), (damping, "1"), (force_error, "1"), (unpredicted, "1"))
[[nodiscard]] DimensionlessCase dimensionless(const data::Case& problem);

struct Scope {
  double friction_limit{};  ///< μ_s P, N
  std::vector<SteadyForce> steady;
  std::vector<SteadyDampedForce> damped;
  std::vector<SlenderForce> slender;
  SofterBeam softer;
  LateSlips late_slips;
};
STICKSLIP_MEMBERS(Scope, (friction_limit, "N"), (steady), (damped), (slender), (softer), (late_slips))

/// The parts of the study, for the case of data/cases/paper.toml at its frequency and amplitude.
[[nodiscard]] SteadyForce steady_force(const data::Case& paper, const std::vector<double>& durations);
[[nodiscard]] SteadyDampedForce damped_force(const data::Case& damped);
[[nodiscard]] SlenderForce slender_force(const data::Case& paper);
/// 1 to `last_hz` by 1 Hz, closed form.
[[nodiscard]] SofterBeam softer_beam(const data::Case& paper, int last_hz);
/// Of times (s) and y(L) (m) of a history.
[[nodiscard]] LateSlips late_slips(const std::vector<double>& time, const std::vector<double>& tip);

/// Steady forces and slenderness at these frequencies and the first amplitude, damping at 25 Hz and all amplitudes.
struct ScopeRange {
  std::vector<double> frequencies_hz{15.0, 25.0, 35.0, 70.0};
  std::vector<double> durations{0.1, 1.0, 10.0, 100.0, 1000.0};  ///< of the horizons, s
  std::vector<double> amplitudes{0.5e-3, 1e-3};                  ///< m
  int last_hz{120};                                              ///< of softer_beam()
};

/// All parts, with the late slips of `converged`. `damped` gives the damping. Uses thread_count() threads; the
/// result does not depend on their number.
[[nodiscard]] Scope scope(const data::Case& paper, const data::Case& damped,
                          const ConvergedHistory& converged, const ScopeRange& range = {});

}  // namespace stickslip::studies
