#pragma once

#include <functional>
#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// One excitation of Fig. 12.
struct ClassifiedPoint {
  double frequency_hz{};
  double amplitude{};           ///< m
  bool closed_form_slips{};     ///< |f_max| > mu_s P by Eq. (28), N modes
  bool finite_element_slips{};  ///< the tip slipped in a run with contact
  bool in_guard_band{};         ///< amplitude within the predicted error of the critical one
};

/// One frequency of Fig. 12, with the errors that make the guard band.
struct ClassifiedFrequency {
  double frequency_hz{};
  double critical_amplitude{};         ///< closed form, N modes, m
  double relative_truncation_error{};  ///< |f_max| of N modes against the converged one
  /// Predicted: |f_max| of PredictedForce against the converged one, plus the uncertainty of that prediction.
  double relative_discretisation_error{};
  [[nodiscard]] double relative_guard() const {
    return relative_truncation_error + relative_discretisation_error;
  }
};

struct ClassificationStudy {
  std::vector<ClassifiedFrequency> frequencies;
  std::vector<ClassifiedPoint> points;
  int agreeing{};  ///< points on which both say the same
  int in_guard_band{};
  int disagreeing_outside{};  ///< must be zero
};

/// Runs both implementations on the grid; each finite-element point is a run of its own with the contact,
/// ended at its first slip. Uses thread_count() threads; the result does not depend on that. `progress`, if
/// given, is told the share done.
[[nodiscard]] ClassificationStudy classification_study(const data::Beam& beam,
                                                       const data::FrictionLaw& friction,
                                                       const data::NumericalSettings& numerics,
                                                       const std::vector<double>& frequencies_hz,
                                                       const std::vector<double>& amplitudes,
                                                       const std::function<void(double)>& progress = {});

/// The grid of Fig. 12: 5 to 120 Hz by 5 Hz, 0.05 to 1 mm by 0.05 mm.
[[nodiscard]] std::vector<double> figure12_frequencies();
[[nodiscard]] std::vector<double> figure12_amplitudes();

}  // namespace stickslip::studies
