#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/stick_slip/converged_history.hpp"

namespace stickslip::studies {

/// One panel of Figs. 4 and 5: the motion as far as it has converged, and the verdicts of both
/// implementations.
struct ContactHistory {
  double frequency_hz{};
  double amplitude{};  ///< m
  std::optional<ConvergedHistory>
      converged;  ///< sampled every 2e-4 s; nothing where the criterion says stick
  std::optional<double> finite_element_slip;  ///< time of the first slip, s
  std::optional<double> closed_form_slip;     ///< first time |f| > mu_s P in the closed form, s
  bool criterion_slips{};                     ///< Eqs. (29), (30) over numerics.duration()
};

/// Runs to `shown` seconds for the history (the verdicts use numerics.duration()).
[[nodiscard]] ContactHistory contact_history(const data::Beam& beam, const data::FrictionLaw& friction,
                                             const data::HarmonicExcitation& excitation,
                                             const data::NumericalSettings& numerics, double shown);

/// An undamped history as it is usually computed, against the converged one.
struct PracticeRun {
  std::string method{};
  int elements{};
  double time_step{};        ///< s; 0 for event-driven runs
  double spectral_radius{};  ///< of generalised-alpha
  int changes{};             ///< of contact
  double largest_error{};    ///< of y(L) at the times of the history, as a fraction of its range
  std::vector<double> tip_displacement{};  ///< y(L) at the times of the history, m
};

/// The scheme by the letter of the paper; changes located inside the step with spectral radii of 0.5, 0.9 and
/// 1; all with mesh and step of numerics; and event-driven runs on as many elements and on twice as many.
[[nodiscard]] std::vector<PracticeRun> usual_practice(const data::Beam& beam,
                                                      const data::FrictionLaw& friction,
                                                      const data::NumericalSettings& numerics,
                                                      const ConvergedHistory& converged);

/// The first time at which |f| of the closed form (exact steady part) exceeds the limit, or nothing within
/// the duration: looked for on a grid of 1/2000 of the shorter period, of the excitation and of the first
/// mode, and located to 1/20000 of that.
[[nodiscard]] std::optional<double> closed_form_first_slip(const data::Beam& beam,
                                                           const data::FrictionLaw& friction,
                                                           const data::HarmonicExcitation& excitation,
                                                           double duration);

}  // namespace stickslip::studies
