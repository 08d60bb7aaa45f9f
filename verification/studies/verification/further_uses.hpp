// SPDX-License-Identifier: MIT
#pragma once

/// One number of evidence for each use of the programs that the paper does not have: two ways to the same result.

#include <string>
#include <vector>

#include "studies/common/members.hpp"

namespace stickslip::studies {

struct FurtherUse {
  std::string name;           ///< squeal, periodic, probability, structures, records, spectra
  std::string problem;        ///< the case
  std::string result;         ///< what both ways return
  std::string first, second;  ///< the two ways
  double value{};             ///< of the result by the second, in its unit
  std::string unit;
  double difference{};  ///< |first - second|, relative to the second; of a probability absolute
};

/// About 4 s of processor time. Throws what the commands of these uses throw, and std::runtime_error where a motion does not slip.
[[nodiscard]] std::vector<FurtherUse> further_uses();

STICKSLIP_MEMBERS(FurtherUse, (name, "-"), (problem, "-"), (result, "-"), (first, "-"), (second, "-"),
                  (value), (unit, "-"), (difference, "1"))

}  // namespace stickslip::studies
