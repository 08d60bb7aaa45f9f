#pragma once

#include <optional>
#include <vector>

#include "stickslip/data/case_file.hpp"

namespace stickslip::studies {

/// The criterion of Eqs. (29), (30) over beam length and axial force, Fig. 14: closed form, N modes.
struct LengthForceMap {
  /// One axial force; lengths ascend and lie closest together around the resonances.
  struct Line {
    double axial_force{};               ///< P, N
    double buckling_length{};           ///< sqrt(20.19 EI/P): no stick state from there on, m
    std::optional<double> resonance_1;  ///< resonance_length of modes 1 and 2 at the excitation, m
    std::optional<double> resonance_2;
    std::vector<double> length;       ///< L, m
    std::vector<double> force_ratio;  ///< |f_max| / (mu_s P), to 0.1 %: stick-slip above 1
  };
  std::vector<Line> lines;  ///< all with as many lengths
};

/// Evaluates lengths from `shortest` to `longest` (m), or to 0.999 of the buckling length if that comes
/// first, at each axial force (N, above 0 and under the buckling load of `shortest`). Section, excitation,
/// friction, modes and duration are those of `problem`. Uses thread_count() threads; the result does not
/// depend on that.
[[nodiscard]] LengthForceMap length_force_map(const data::Case& problem, double shortest, double longest,
                                              const std::vector<double>& axial_forces);

/// The length (m) from which on the section of `beam` has no stick state under its axial force P > 0,
/// sqrt(20.19 EI/P).
[[nodiscard]] double buckling_length(const data::Beam& beam);

/// The length L_n (m) at which natural frequency `mode` = n of the stick state is `hz`, for the section and
/// the axial force P >= 0 of `beam`; to 1e-12 m. None if the beam buckles before it is that long. With
/// betabar of Eq. (23) at omega = 2 pi hz, n pi < betabar L_n < (n + 1/2) pi.
[[nodiscard]] std::optional<double> resonance_length(const data::Beam& beam, int mode, double hz);

/// The axial forces of Fig. 14: 100 in equal ratios from 5 to 33000 N.
[[nodiscard]] std::vector<double> figure14_axial_forces();

}  // namespace stickslip::studies
