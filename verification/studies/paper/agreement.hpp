// SPDX-License-Identifier: MIT
#pragma once

/// How well computed values agree with what they are held against.

#include <cstddef>
#include <string>
#include <vector>

#include "studies/common/members.hpp"
#include "studies/paper/paper_checks.hpp"
#include "studies/paper/solution_verification.hpp"

namespace stickslip::studies {

/// A computed value beside its reference.
struct CheckedResult {
  std::string what;       ///< "frequency.stick.1 by closed form"
  std::string reference;  ///< "printed" or "mesh-free"
  bool known_erratum{};   ///< a printed number that does not hold or is not determined
  double computed{}, expected{};
  [[nodiscard]] double relative_difference() const { return computed / expected - 1.0; }
};
STICKSLIP_MEMBERS(CheckedResult, (what, "-"), (reference, "-"), (known_erratum, "1"), (computed, "SI"),
                  (expected, "SI"), (relative_difference(), "1"))

/// Of the relative differences, errata apart.
struct Differences {
  std::size_t count{};
  double bias{};    ///< mean
  double spread{};  ///< standard deviation
};
STICKSLIP_MEMBERS(Differences, (count, "1"), (bias, "1"), (spread, "1"))

/// The differences of those results that are held against `reference`.
[[nodiscard]] Differences differences_from(const std::vector<CheckedResult>& results,
                                           const std::string& reference);

struct Agreement {
  std::vector<CheckedResult> results;
  Differences printed, exact;  ///< from printed numbers, and from results without a mesh
};
STICKSLIP_MEMBERS(Agreement, (results), (printed), (exact))

/// Each recomputed number against the printed one, and each result of the solution verification, at the published settings,
/// against the closed form, or the boundary integral after a first slip.
[[nodiscard]] Agreement agreement(const std::vector<PrintedCheck>& printed,
                                  const SolutionVerification& verification);

}  // namespace stickslip::studies
