#pragma once

/// The design guideline of Sect. 5: how far a beam is from slipping over a band of excitation frequencies,
/// and which lengths and axial forces keep it from slipping. In closed form, with the amplitude, the modes
/// and the duration of a case; its excitation frequency plays no part.

#include <functional>
#include <vector>

#include "stickslip/analytic/band_maximum.hpp"
#include "stickslip/analytic/bounds.hpp"
#include "stickslip/data/problem.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

/// A natural frequency of the stick state inside the band.
struct Resonance {
  int mode{};
  double frequency_hz{};
};

/// How far the beam is from slipping in the worst place of the band.
struct BandMargin {
  analytic::Bounds force_max;         ///< largest |f_max| over the band, N; rigorous for the modes kept
  double friction_limit{};            ///< mu_s P, N
  analytic::Bounds margin;            ///< mu_s P / |f_max| = critical amplitude / amplitude; it slips below 1
  double frequency_hz{};              ///< where force_max.lower is attained
  int evaluations{};                  ///< frequencies at which |f_max| was computed
  std::vector<Resonance> resonances;  ///< ascending
};

/// Searches the whole band, resonances included (analytic::BandMaximum), until the bounds of the force are
/// `relative_width` apart. Throws std::domain_error, naming beam.axial_force, unless 0 < P < P_cr,
/// data::FieldError for a case without amplitude or friction, and what BandMaximum throws.
[[nodiscard]] BandMargin band_margin(const data::Case& problem, const analytic::FrequencyBand& band,
                                     double relative_width = 1e-6);

struct ParameterRange {
  double from{}, to{};
};

/// Values of a parameter over which the beam sticks throughout the band, or does not.
struct DesignInterval {
  double from{}, to{};
  bool sticks{};
  bool buckled{};                 ///< no stick state
  std::vector<int> resonances{};  ///< modes whose natural frequency is inside the band somewhere here
};

/// The intervals of a range one after the other, first to last without a gap.
struct DesignScan {
  Parameter parameter{};  ///< length or axial_force
  double accuracy{};      ///< of the ends of intervals
  std::vector<DesignInterval> intervals;
};

/// Divides a range of lengths or axial forces into what avoids slipping over the whole band and what does
/// not. At each value looked at the verdict holds for the whole band, as that of band_margin(). Values looked
/// at are 1 % apart, and are those at which a natural frequency is at an end of the band. Where both
/// neighbours stick they are halved until each has |f_max|/A0 <= mu_s P/A0 - R in reserve, with
///
///     R = sum_n |c_n| min((change of omega_n)^2/8 min(T^2 q_n, b^2 T^3/(3 omega_n)), 2 q_n),
///
/// symbols as in BandMaximum: the leading estimate of how far |f_max| rises in between, by the phases that
/// the natural frequencies turn in the duration T. What is undecided at a sixteenth of `accuracy`, or by 1e-4
/// of the force, counts as slipping, and so does what lies between two neighbours that slip: intervals that
/// stick err on the safe side.
///
/// Uses thread_count() threads; the result does not depend on that. `progress`, if given, is told the share
/// done. Throws as band_margin(), and std::invalid_argument for another parameter or unless 0 < from < to.
[[nodiscard]] DesignScan design_scan(const data::Case& problem, Parameter parameter,
                                     const ParameterRange& range, const analytic::FrequencyBand& band,
                                     const std::function<void(double)>& progress = {});

/// What the guideline says of a beam: the margin over a band, and which lengths and forces keep it.
struct Design {
  analytic::FrequencyBand band;
  BandMargin margin;
  DesignScan lengths, forces;
};

/// `from` to `to`, or to just under the buckling value of the case if that is less. Throws as
/// buckling_value().
[[nodiscard]] ParameterRange range_below_buckling(const data::Case& problem, Parameter parameter, double from,
                                                  double to);

/// The length or the axial force at which the beam of the case, the other being as it is, has no stick state
/// any more. Throws std::invalid_argument for another parameter, std::domain_error, naming beam.axial_force,
/// for a length without compression.
[[nodiscard]] double buckling_value(const data::Case& problem, Parameter parameter);

}  // namespace stickslip::studies
