// SPDX-License-Identifier: MIT
#pragma once

/// Compares the paper with the two implementations: the printed numbers that can be computed, and the numbers
/// that establish each erratum.

#include <cmath>
#include <string>
#include <vector>

#include "stickslip/data/paper.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// A printed number and its computed value.
struct PrintedCheck {
  data::PrintedNumber printed;
  double computed{};    ///< in the unit of printed.value
  std::string method;   ///< such as "closed form, N = 10" or "finite elements, 20 elements"
  double allowed{};     ///< largest |computed - printed| that counts as agreement, same unit
  std::string because;  ///< the reason for `allowed`
  [[nodiscard]] double error() const { return computed - printed.value; }
  [[nodiscard]] bool agrees() const { return error() <= allowed && -error() <= allowed; }
};

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

/// At least one row per erratum that contains a number (all except E7 and E12, which concern wording).
[[nodiscard]] std::vector<ErratumEvidence> errata_evidence(const data::Case& paper);

}  // namespace stickslip::studies
