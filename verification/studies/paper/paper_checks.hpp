#pragma once

/// The paper against the two implementations: each printed number that can be recomputed, and each erratum
/// with the numbers that establish it.

#include <string>
#include <vector>

#include "stickslip/data/paper.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// A printed number recomputed.
struct PrintedCheck {
  data::PrintedNumber printed;
  double computed{};    ///< in the unit of printed.value
  std::string method;   ///< "closed form, N = 10", "finite elements, 20 elements", ...
  double allowed{};     ///< largest |computed - printed| that counts as agreement, same unit
  std::string because;  ///< where `allowed` comes from
  [[nodiscard]] double error() const { return computed - printed.value; }
  [[nodiscard]] bool agrees() const { return error() <= allowed && -error() <= allowed; }
};

/// Every printed result (not the inputs) of data/paper/printed-numbers.toml that a computation can return.
/// `paper` is the case of data/cases/paper.toml.
[[nodiscard]] std::vector<PrintedCheck> printed_checks(const data::Case& paper);

/// One number that establishes an erratum: what the text as printed gives, what the corrected text gives, and
/// what both are held against.
struct ErratumEvidence {
  std::string erratum;   ///< "E1"
  std::string quantity;  ///< "first stick frequency"
  std::string unit;      ///< "Hz"; "1" if dimensionless
  double as_printed{};
  double corrected{};
  double reference{};  ///< the printed result, or an independent computation
  double tolerance{};  ///< |corrected - reference| must not exceed it; |as_printed - reference| must
};

/// At least one row per erratum that has a number in it (all but E7 and E12, which are wording).
[[nodiscard]] std::vector<ErratumEvidence> errata_evidence(const data::Case& paper);

}  // namespace stickslip::studies
