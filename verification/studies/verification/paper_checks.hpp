// SPDX-License-Identifier: MIT
#pragma once

/// Compares the paper with the two implementations: the printed numbers that can be computed, and the numbers
/// that establish each erratum.

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/data/paper.hpp"
#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// The verdict on a printed number of which both ends of `found`, and what is between them, are possible
/// results: holds if both are within `allowed` of it, not determined if it is between them to `allowed`, else
/// does not hold.
[[nodiscard]] data::ClaimVerdict verdict_on(double printed, const analytic::Bounds& found, double allowed);

struct PrintedCheck {
  data::PrintedNumber printed;
  double computed{};    ///< in the unit of printed.value
  std::string method;   ///< such as "closed form, N = 10" or "finite elements, 20 elements"
  double allowed{};     ///< largest |computed - printed| that counts as agreement, same unit
  std::string because;  ///< the reason for `allowed`
  /// Between these lies what the choices give that the paper leaves open; empty if it leaves none.
  std::optional<analytic::Bounds> left_open;
  [[nodiscard]] double error() const { return computed - printed.value; }
  [[nodiscard]] data::ClaimVerdict verdict() const {
    return verdict_on(printed.value, left_open.value_or(analytic::Bounds{computed, computed}), allowed);
  }
  [[nodiscard]] bool agrees() const { return verdict() == data::ClaimVerdict::holds; }
};
STICKSLIP_MEMBERS(PrintedCheck, (printed), (computed), (method, "-"), (allowed), (because, "-"), (left_open),
                  (error()), (verdict(), "-"), (agrees(), "1"))

/// |f_max| as the paper states it, Eq. (28) with N = 10 over 0 to 10 s, in all samplings that were tried: it does not
/// state its own. They are continuous time and the multiples of 1e-4 s up to 1e-2 s.
struct SampledForces {
  analytic::Bounds range;              ///< smallest and largest, N
  std::optional<double> printed_step;  ///< s, the shortest that returns every printed digit, if one does
};
[[nodiscard]] SampledForces sampled_forces(const data::Case& paper, double hz);

/// Computes the printed results (not the inputs) of data/paper/printed-numbers.toml that a computation can
/// reproduce. `paper` is the case of data/cases/paper.toml.
[[nodiscard]] std::vector<PrintedCheck> printed_checks(const data::Case& paper);

/// One number that establishes an erratum: its value from the text as printed, its value from the corrected
/// text, and the reference for both.
struct ErratumEvidence {
  std::string erratum;   ///< such as "E1"
  std::string quantity;  ///< such as "first stick frequency"
  std::string unit;      ///< such as "Hz"; "1" if dimensionless
  double as_printed{};
  double corrected{};
  double reference{};  ///< the printed result, or an independent computation
  double tolerance{};  ///< |corrected - reference| is at most this, and |as_printed - reference| is larger
  [[nodiscard]] bool confirmed() const {
    return std::abs(corrected - reference) <= tolerance && std::abs(as_printed - reference) > tolerance;
  }
};
STICKSLIP_MEMBERS(ErratumEvidence, (erratum, "-"), (quantity, "-"), (unit, "-"), (as_printed), (corrected),
                  (reference), (tolerance), (confirmed(), "1"))

/// At least one row per erratum that contains a number, except E7 and E12, which concern wording, and E6, which
/// is a number that the paper's text does not determine (printed_checks()).
[[nodiscard]] std::vector<ErratumEvidence> errata_evidence(const data::Case& paper);

/// The frequencies (Hz) of the four |f_max| printed in Sect. 5.
inline constexpr double printed_frequencies[] = {15.0, 25.0, 35.0, 70.0};

/// The excitation of a printed |f_max|, with an amplitude of 0.5 mm.
inline data::HarmonicExcitation printed_excitation(double hz) {
  return data::HarmonicExcitation({.frequency_hz = hz, .amplitude = 0.5e-3});
}

/// The printed |f_max| at one of these frequencies, N.
inline data::PrintedNumber printed_force(double hz) {
  return data::printed_number(fmt::format("force_max.{}", std::lround(hz)));
}

inline data::Beam with(const data::Beam& beam, double data::BeamProperties::*field, double value) {
  data::BeamProperties properties = beam.properties();
  properties.*field = value;
  return data::Beam(properties);
}

/// The beam of Fig. 13, with half of E.
inline data::Beam half_stiff(const data::Beam& beam) {
  return with(beam, &data::BeamProperties::youngs_modulus, 0.5 * beam.youngs_modulus());
}

}  // namespace stickslip::studies
