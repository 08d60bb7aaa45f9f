// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// The critical amplitude at one frequency of Fig. 6 by finite elements, computed in two ways.
struct CriticalAmplitudeSearch {
  double frequency_hz{};
  /// The paper's procedure: the first multiple of the increment at which a run with contact slips, m; empty
  /// if none slips up to the cap.
  std::optional<double> searched;
  int runs{};  ///< number of runs of that procedure
  /// From one linear run with a bonded tip: μ_s P over |f_max| per unit amplitude, m.
  double linear{};
  /// The first multiple of the increment above `linear`, m; empty if it is above the cap.
  std::optional<double> stepped_linear;

  double increment{}, cap{};  ///< of the search, m
  [[nodiscard]] bool agree() const { return searched == stepped_linear; }
  /// The cap if the search found nothing.
  [[nodiscard]] double searched_amplitude() const { return searched.value_or(cap); }
  [[nodiscard]] bool above_the_cap() const { return !searched; }
};
STICKSLIP_MEMBERS(CriticalAmplitudeSearch, (frequency_hz, "Hz"), (searched, "m"), (runs, "1"), (linear, "m"),
                  (stepped_linear, "m"), (increment, "m"), (cap, "m"), (agree(), "1"),
                  (searched_amplitude(), "m"), (above_the_cap(), "1"))

/// Raises the amplitude by `increment` (m) from zero until the tip slips within numerics.duration(), up to
/// `cap` (m), and compares with the linear run. Predicted: agree() at all frequencies, because the stick
/// state is linear in the amplitude and both runs integrate the same system with the same steps. They can
/// differ only if the critical amplitude is within round-off of a multiple of the increment. Uses
/// thread_count() threads; the result does not depend on their number.
[[nodiscard]] std::vector<CriticalAmplitudeSearch> critical_amplitude_searches(
    const data::Beam& beam, const data::FrictionLaw& friction, const data::NumericalSettings& numerics,
    const std::vector<double>& frequencies_hz, double increment, double cap);

/// The frequencies of Fig. 6: 5 to 100 Hz in steps of 5 Hz.
[[nodiscard]] std::vector<double> figure6_frequencies();

}  // namespace stickslip::studies
