// SPDX-License-Identifier: MIT
#pragma once

/// The design guideline of Sect. 5 in closed form: the margin against slipping over a band of excitation
/// frequencies, and the lengths and axial forces at which the beam does not slip. Amplitude, modes and
/// duration are those of a case. The excitation frequency of the case is not used.

#include <functional>
#include <string_view>
#include <vector>

#include "stickslip/analytic/stick_reaction.hpp"
#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

struct Resonance {
  int mode{};
  double frequency_hz{};
};
STICKSLIP_MEMBERS(Resonance, (mode, "1"), (frequency_hz, "Hz"))

/// The margin against slipping at the worst frequency of the band.
struct BandMargin {
  /// Largest |f_max| over the band, N; bounds for the modes that are kept.
  analytic::Bounds force_max;
  double friction_limit{};  ///< μ_s P, N
  /// μ_s P / |f_max| = critical amplitude / amplitude; the beam slips below 1.
  analytic::Bounds margin;
  double frequency_hz{};              ///< frequency at which force_max.lower occurs
  int evaluations{};                  ///< number of frequencies at which |f_max| was computed
  std::vector<Resonance> resonances;  ///< ascending
  /// The margin of the steady vibration at its worst frequency, of a damped beam; else 0.
  analytic::Bounds steady_margin{};
};
STICKSLIP_MEMBERS(BandMargin, (force_max, "N"), (friction_limit, "N"), (margin, "1"), (frequency_hz, "Hz"),
                  (evaluations, "1"), (resonances), (steady_margin, "1"))

/// Searches the whole band, resonances included (analytic::BandMaximum), until the bounds of the force are
/// `relative_width` apart. Throws data::InputError, naming beam.axial_force, unless 0 < P < P_cr,
/// data::FieldError for a case without amplitude or friction, and what BandMaximum throws.
[[nodiscard]] BandMargin band_margin(const data::Case& problem, const analytic::FrequencyBand& band,
                                     double relative_width = 1e-6);

/// An interval of a parameter in which the beam sticks over the whole band, or does not.
struct DesignInterval {
  double from{}, to{};
  bool sticks{};
  bool buckled{};  ///< no stick state
  /// Modes with a natural frequency inside the band in all of the interval or, if the band is one frequency, somewhere in it.
  std::vector<int> resonances{};
};
STICKSLIP_MEMBERS(DesignInterval, (from), (to), (sticks, "1"), (buckled, "1"), (resonances, "1"))

/// Consecutive intervals that cover the whole range.
struct DesignScan {
  std::string_view parameter;  ///< beam.length or beam.axial_force
  double accuracy{};           ///< of the ends of intervals
  std::vector<DesignInterval> intervals;
};
STICKSLIP_MEMBERS(DesignScan, (accuracy), (intervals))

/// Divides a range of lengths (m) or axial forces (N) into intervals that avoid slipping over the whole band
/// and intervals that do not. At each tested value the result holds for the whole band, as in band_margin().
/// The tested values are at most 1 % apart and include those at which a natural frequency is at an end of the
/// band. If the beam sticks at both neighbouring values, the interval between them is halved until |f_max|/A0
/// ≤ μ_s P/A0 - R holds at both, with the reserve
///
///     R = Σ_n |c_n| min((change of ω_n)²/8 min(T² q_n, b² T³/(3 ω_n)), 2 q_n).
///
/// The symbols are those of BandMaximum. R is the leading estimate of the rise of |f_max| between the two
/// values, caused by the change of the phases ω_n T over the duration T; with damping T is at most 2/d_n, d_n the decay
/// of that mode, 1/s. An interval that is still undecided at 1/16 of `accuracy`, or within 1e-6 of the force, counts as slipping. So does an interval
/// between two neighbours that slip. The errors of the intervals that stick are therefore on the safe side.
///
/// Uses thread_count() threads; the result does not depend on their number. `progress`, if given, receives
/// the completed fraction. Throws what band_margin() throws, data::FieldError unless 0 < from < to, and
/// std::invalid_argument for another parameter.
[[nodiscard]] DesignScan design_scan(const data::Case& problem, std::string_view parameter,
                                     const analytic::Bounds& range, const analytic::FrequencyBand& band,
                                     const std::function<void(double)>& progress = {});

/// The result of the guideline for a beam: the margin over a band, and the scans of lengths and forces.
struct Design {
  analytic::FrequencyBand band;
  BandMargin margin;
  DesignScan lengths, forces;  ///< of a beam
};
STICKSLIP_MEMBERS(Design, (band, "Hz"), (margin), (lengths), (forces))

/// `stage` and `progress` receive what is being done and the completed fraction. Throws what band_margin() and design_scan()
/// throw.
[[nodiscard]] Design design(const data::Case& problem, const analytic::FrequencyBand& band,
                            const analytic::Bounds& lengths, const analytic::Bounds& forces,
                            const std::function<void(std::string_view)>& stage,
                            const std::function<void(double)>& progress);

/// The range from `from` to `to`, or to just below the buckling value of the case if that is smaller. Throws
/// what buckling_value() throws.
[[nodiscard]] analytic::Bounds range_below_buckling(const data::Case& problem, std::string_view parameter,
                                                    double from, double to);

/// The length or the axial force at which the beam of the case, the other being as it is, has no stick state
/// any more. Throws std::invalid_argument for another parameter, data::InputError, naming beam.axial_force,
/// for a length without compression.
[[nodiscard]] double buckling_value(const data::Case& problem, std::string_view parameter);

}  // namespace stickslip::studies
