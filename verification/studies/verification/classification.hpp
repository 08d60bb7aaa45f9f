// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// One excitation (frequency and amplitude) of Fig. 12.
struct ClassifiedPoint {
  double frequency_hz{};
  double amplitude{};           ///< m
  bool closed_form_slips{};     ///< |f_max| > μ_s P by Eq. (28), N modes
  bool finite_element_slips{};  ///< the tip slipped in a run with contact
  bool in_guard_band{};         ///< the amplitude is within the predicted error of the critical one
  double distance{};            ///< of the amplitude from the critical one, relative and signed
  double relative_guard{};      ///< of its frequency
  /// "stick-slip" or "stick".
  [[nodiscard]] const char* closed_form() const { return closed_form_slips ? "stick-slip" : "stick"; }
  [[nodiscard]] const char* finite_element() const { return finite_element_slips ? "stick-slip" : "stick"; }
};
STICKSLIP_MEMBERS(ClassifiedPoint, (frequency_hz, "Hz"), (amplitude, "m"), (closed_form_slips, "1"),
                  (finite_element_slips, "1"), (in_guard_band, "1"), (distance, "1"), (relative_guard, "1"),
                  (closed_form(), "-"), (finite_element(), "-"))

/// One frequency of Fig. 12 with the predicted errors that define the guard band.
struct ClassifiedFrequency {
  double frequency_hz{};
  double critical_amplitude{};         ///< closed form, N modes, m
  double relative_truncation_error{};  ///< of |f_max| with N modes, against the converged one
  /// Predicted error of |f_max| by finite elements against the converged value, plus the uncertainty of that
  /// prediction.
  double relative_discretisation_error{};
  [[nodiscard]] double relative_guard() const {
    return relative_truncation_error + relative_discretisation_error;
  }
};
STICKSLIP_MEMBERS(ClassifiedFrequency, (frequency_hz, "Hz"), (critical_amplitude, "m"),
                  (relative_truncation_error, "1"), (relative_discretisation_error, "1"),
                  (relative_guard(), "1"))

/// The classification of a grid of excitations by both implementations.
struct ClassificationStudy {
  std::vector<ClassifiedFrequency> frequencies;
  std::vector<ClassifiedPoint> points;
  int agreeing{};  ///< number of points on which both implementations agree
  int in_guard_band{};
  int disagreeing_outside{};  ///< disagreeing points outside the guard band; must be 0
  [[nodiscard]] int disagreeing_inside() const {
    return static_cast<int>(points.size()) - agreeing - disagreeing_outside;
  }

  /// Sets the three numbers from the points.
  void count_points();
};
STICKSLIP_MEMBERS(ClassificationStudy, (frequencies), (points), (agreeing, "1"), (in_guard_band, "1"),
                  (disagreeing_outside, "1"), (disagreeing_inside(), "1"))

/// Classifies each point of the grid by both implementations. For finite elements each point is a separate
/// run with contact, which ends at its first slip. Uses thread_count() threads; the result does not depend on
/// their number.
[[nodiscard]] ClassificationStudy classification_study(const data::Case& problem,
                                                       const std::vector<double>& frequencies_hz,
                                                       const std::vector<double>& amplitudes);

/// The frequencies (Hz) and amplitudes (m) of Fig. 12: 5 to 120 Hz in steps of 5 Hz, 0.05 to 1 mm in steps of
/// 0.05 mm.
[[nodiscard]] std::vector<double> figure12_frequencies();
[[nodiscard]] std::vector<double> figure12_amplitudes();

}  // namespace stickslip::studies
