#pragma once

#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "stickslip/studies/event_history.hpp"

namespace stickslip::studies {

/// Differences of y(L), as fractions of its range, up to which two histories count as alike.
inline constexpr double fine_agreement = 0.01, coarse_agreement = 0.1;

/// The relative change of the amplitude in the study of perturbations.
inline constexpr double perturbation = 1e-9;

/// Two histories of one problem that differ in one respect.
struct Separation {
  std::string what;            ///< "20 against 40 elements"
  double one_percent_until{};  ///< time until which y(L) agrees to 1 % of its range, s
  double ten_percent_until{};  ///< the same for 10 %
  double largest{};            ///< largest difference, as a fraction of the range
  double growth_rate{};        ///< of the separation, 1/s: slope of the logarithm of its largest value per
                               ///< period of the load, from the first slip to 10 %
  int changes{}, other_changes{};  ///< changes of contact in each
  std::vector<double> time;        ///< middle of each period of the load from the first slip on, s
  std::vector<double> separation;  ///< largest difference within it, m
};

/// How far an undamped history can be trusted.
///
/// Weakening friction pumps mode k of the free beam at (mu_s - mu_m) alpha N psi_k(L)^2/(2 m_k), alike for
/// all modes (m_k = rho A L/4 at P = 0): two histories separate by at most that rate while both slip.
struct PredictabilityStudy {
  double frequency_hz{}, amplitude{}, duration{};
  double range{};           ///< of y(L), m
  double slip_share{};      ///< share of the time in slip, event-driven reference
  double predicted_rate{};  ///< 2 (mu_s - mu_m) alpha N/(rho A L), 1/s
  std::vector<Separation> separations;
};

/// Runs to `duration`; numerics gives mesh and step of the time stepper, `modes` those of the continuous beam
/// (halved and doubled). No damping.
[[nodiscard]] PredictabilityStudy predictability_study(const data::Beam& beam,
                                                       const data::FrictionLaw& friction,
                                                       const data::HarmonicExcitation& excitation,
                                                       const data::NumericalSettings& numerics,
                                                       double duration, int modes = 20);

/// Time until which two histories on the same grid differ by no more than `allowed`, m; the end if they never
/// do.
[[nodiscard]] double agreeing_until(const TipHistory& a, const TipHistory& b, double allowed);

}  // namespace stickslip::studies
