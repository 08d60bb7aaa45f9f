// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// The criterion of Eqs. (29), (30) over beam length and axial force, Fig. 14: closed form, N modes.
struct LengthForceMap {
  /// One axial force. The lengths ascend and are closest together near the resonances.
  struct Line {
    double axial_force{};               ///< P, N
    double buckling_length{};           ///< √(20.19 EI/P), m; no stick state from this length on
    std::optional<double> resonance_1;  ///< resonance_length of modes 1 and 2 at the excitation, m
    std::optional<double> resonance_2;
    std::vector<double> length;       ///< L, m
    std::vector<double> force_ratio;  ///< |f_max| / (μ_s P), to 0.1 %; stick-slip above 1
  };
  std::vector<Line> lines;                   ///< all lines have the same number of lengths
  double frequency_hz{};                     ///< of the excitation
  double buckling_coefficient{};             ///< buckling load of the stick state over EI/L²
  double section_height{}, section_width{};  ///< of the rectangular section, m
  std::vector<double> resonance_lengths;     ///< of modes 1 and 2 under the axial force of the case, m
};
STICKSLIP_MEMBERS(LengthForceMap::Line, (axial_force, "N"), (buckling_length, "m"), (resonance_1, "m"),
                  (resonance_2, "m"), (length, "m"), (force_ratio, "1"))
STICKSLIP_MEMBERS(LengthForceMap, (lines), (frequency_hz, "Hz"), (buckling_coefficient, "1"),
                  (section_height, "m"), (section_width, "m"), (resonance_lengths, "m"))

/// Evaluates lengths from `shortest` to `longest` (m), or to 0.999 of the buckling length if that is smaller,
/// at each axial force (N, above 0 and below the buckling load of `shortest`). Cross section, excitation,
/// friction, modes and duration are those of `problem`. Uses thread_count() threads; the result does not
/// depend on their number.
[[nodiscard]] LengthForceMap length_force_map(const data::Case& problem, double shortest, double longest,
                                              const std::vector<double>& axial_forces);

/// The buckling length √(20.19 EI/P) (m) of the cross section of `beam` under its axial force P > 0. From
/// this length on there is no stick state.
[[nodiscard]] double buckling_length(const data::Beam& beam);

/// The length L_n (m) at which natural frequency number n = `mode` of the stick state is `hz`, for the cross
/// section and the axial force P ≥ 0 of `beam`. Accuracy 1e-12 m. Empty if the beam buckles at a smaller
/// length. With betabar of Eq. (23) at ω = 2 π hz, n π < betabar L_n < (n + 1/2) π.
[[nodiscard]] std::optional<double> resonance_length(const data::Beam& beam, int mode, double hz);

/// The axial forces of Fig. 14 in N: 100 values in equal ratios from 5 to 33000 N.
[[nodiscard]] std::vector<double> figure14_axial_forces();

}  // namespace stickslip::studies
