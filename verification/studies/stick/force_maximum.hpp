#pragma once

#include <vector>

#include "stickslip/analytic/bounds.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// |f_max| of Eqs. (29), (30) at one excitation, by every route there is.
struct ForceMaximum {
  double frequency_hz{};
  double amplitude{};          ///< m
  double sampled{};            ///< N modes, sampled at numerics.time_step(), N
  analytic::Bounds truncated;  ///< N modes, rigorous
  analytic::Bounds
      converged;  ///< exact steady part and `reference_modes` free vibrations, rigorous for those
  double omitted_transient{};         ///< bound of what the free vibrations beyond those can add, N
  double finite_element{};            ///< grid maximum of a bonded run
  double predicted_finite_element{};  ///< PredictedForce::max_abs
  double prediction_uncertainty{};    ///< PredictedForce::uncertainty
};

[[nodiscard]] ForceMaximum force_maximum_study(const data::Beam& beam,
                                               const data::HarmonicExcitation& excitation,
                                               const data::NumericalSettings& numerics,
                                               int reference_modes = 100);

/// Critical amplitude against frequency, Figs. 11 and 13: closed form, N modes.
struct CriticalAmplitudePoint {
  double frequency_hz{};
  double critical_amplitude{};  ///< m
};
[[nodiscard]] std::vector<CriticalAmplitudePoint> critical_amplitude_curve(
    const data::Beam& beam, const data::FrictionLaw& friction, const data::NumericalSettings& numerics,
    const std::vector<double>& frequencies_hz);

}  // namespace stickslip::studies
