#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// The critical amplitude at one frequency of Fig. 6, by finite elements in two ways.
struct CriticalAmplitudeSearch {
  double frequency_hz{};
  /// The paper's procedure: the first multiple of the increment whose run with contact slips, m; nothing up
  /// to the cap.
  std::optional<double> searched;
  int runs{};  ///< that the procedure took
  /// One linear run with the tip bonded: mu_s P over |f_max| per unit amplitude, m.
  double linear{};
  /// The first multiple of the increment above `linear`, m; nothing if it is above the cap.
  std::optional<double> stepped_linear;

  [[nodiscard]] bool agree() const { return searched == stepped_linear; }
};

/// Raises the amplitude by `increment` from zero until the tip slips within numerics.duration(), up to `cap`,
/// both in m. Predicted: agree() everywhere, for the stick state is linear in the amplitude and both runs
/// step the same system over the same grid; only a critical amplitude within round-off of a multiple could
/// differ. Uses thread_count() threads; the result does not depend on that.
[[nodiscard]] std::vector<CriticalAmplitudeSearch> critical_amplitude_searches(
    const data::Beam& beam, const data::FrictionLaw& friction, const data::NumericalSettings& numerics,
    const std::vector<double>& frequencies_hz, double increment, double cap,
    const std::function<void(double)>& progress = {});

/// The frequencies of Fig. 6: 5 to 100 Hz by 5 Hz.
[[nodiscard]] std::vector<double> figure6_frequencies();

}  // namespace stickslip::studies
