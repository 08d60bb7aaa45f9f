// SPDX-License-Identifier: MIT
#pragma once

/// What the criterion of stick-slip occurrence says of a case, and what an engineer asks next.

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"
#include "studies/history/history.hpp"

namespace stickslip::studies {

/// The amplitude of f in the steady vibration of the held beam, the excitation amplitude at which it is μₛ P, and the verdict on it.
struct SteadyState {
  analytic::Bounds force;               ///< N; wide only with a damping ratio, whose modes are coupled
  analytic::Bounds critical_amplitude;  ///< m
  analytic::Verdict verdict{};
  bool
      reached{};  ///< damping leaves at most 5 % of the slowest free vibration at the end of the duration; false without damping
};

struct StickFrequency {
  int mode{};
  double hz{};
  double distance{};  ///< from the excitation frequency, over that; below 0 if it is below
};

/// One key of the case times a factor, and the margin μₛ P/max|f| that it gives.
struct Change {
  std::string_view key;
  double factor{}, margin{};
};

/// The held modes of a model, and what its residual mass is of the mass that couples base and contact.
struct ModesUsed {
  std::size_t modes{};
  double moved_mass{};  ///< HeldStructure::moved_mass, kg
  double residual_share{};
};

struct CriterionAnswer {
  analytic::Criterion truncated;      ///< with numerics.modes, as in the paper
  analytic::Criterion all_modes;      ///< without truncation
  std::optional<SteadyState> steady;  ///< nothing for an undamped beam at a natural frequency, to rounding
  std::optional<StickFrequency>
      nearest;  ///< the natural frequency nearest to that of the excitation; one mass has none
  std::optional<Bending> bending;          ///< held_bending()
  std::optional<double> steady_draw_back;  ///< of the steady vibration, m
  std::optional<ModesUsed> modes_used;     ///< of a model that is no single mass
  std::optional<Change> best_change;       ///< by a tenth; nothing for an excitation amplitude of 0
};

/// The bending of the beam with its tip held, in the modes of the continuous beam, over the duration of the case: the largest of 4096
/// instants, which are dense at the start and not commensurate with any period; about 1 % low at most. Nothing for a beam with shear.
[[nodiscard]] std::optional<Bending> held_bending(const data::Case& problem);

/// The criterion of a case with a rigid contact by all routes, and best_change() of the margin with numerics.modes, unless these are
/// too_few_modes(). A changed case is restated(). Throws what evaluate_criterion() throws.
[[nodiscard]] CriterionAnswer criterion_answer(const data::Case& problem);
/// By the criterion with numerics.modes.
[[nodiscard]] std::optional<Change> best_change(const data::Case& problem);

/// CriterionAnswer::steady.
[[nodiscard]] std::optional<SteadyState> steady_state(const data::Case& problem);

/// Whether |f_max| with numerics.modes may differ from that of all modes by 5 % or more.
[[nodiscard]] bool too_few_modes(const analytic::Criterion& truncated, const analytic::Criterion& all_modes);

/// The change with the largest margin of those of one key by a tenth that can be built: length, sides of the section, axial force or
/// static coefficient. `margin_with` gives the margin with a key at a value, nothing where there is no stick state.
[[nodiscard]] std::optional<Change> best_change(
    const data::Case& problem,
    const std::function<std::optional<double>(std::string_view key, double value)>& margin_with);

/// μₛ P over the largest |f|: below 1 the tip slips.
[[nodiscard]] analytic::Bounds margin_of(const analytic::Criterion& criterion);

/// The amplitude of the base from which on the tip slips at one frequency.
struct CriticalAmplitudePoint {
  double frequency_hz{};
  double critical_amplitude{};  ///< m
};
STICKSLIP_MEMBERS(CriticalAmplitudePoint, (frequency_hz, "Hz"), (critical_amplitude, "m"))

/// By analytic::evaluate_criterion() at each frequency (Hz), the middle of bounds of that width, Figs. 11 and 13. Uses thread_count() threads.
[[nodiscard]] std::vector<CriticalAmplitudePoint> critical_amplitude_curve(
    const data::Case& problem, const std::vector<double>& frequencies_hz, double relative_width = 1e-6);

/// From a quarter of the excitation frequency of the case to four times it and beyond the first natural frequency, in equal ratios
/// and at the natural frequencies; to a relative 1e-3.
struct CriticalAmplitudeCurve {
  std::vector<double> natural_hz;  ///< of the modes, ascending
  std::vector<CriticalAmplitudePoint> points;
};
[[nodiscard]] CriticalAmplitudeCurve critical_amplitude_curve(const data::Case& problem);

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
    const data::Case& problem, const std::vector<double>& frequencies_hz, double increment, double cap);

/// The frequencies of Fig. 6: 5 to 100 Hz in steps of 5 Hz.
[[nodiscard]] std::vector<double> figure6_frequencies();

}  // namespace stickslip::studies
