// SPDX-License-Identifier: MIT
#pragma once

/// The ledgers data/paper/claims.toml and data/paper/errata.toml as the tests read them.

#include <string>
#include <vector>

#include "stickslip/data/paper.hpp"

namespace stickslip::testing {

/// A statement of the paper that can be true or false.
struct Claim {
  std::string id;  ///< "fig6.generally-decreases"
  data::ClaimVerdict verdict{};
  std::string correction;  ///< what holds instead; empty if the claim holds
  std::string figure;      ///< the label of the report's figure or table that shows it, or empty
  std::string erratum;     ///< id of the erratum about it ("E10"), or empty
};

struct Erratum {
  std::string id;              ///< "E1"
  data::ClaimVerdict verdict;  ///< of the printed text
};

/// In the order of the files. Throw data::InputError, naming file, line and key, for a key that is missing, empty or unknown
/// and for a verdict that is none of data::ClaimVerdict.
[[nodiscard]] std::vector<Claim> claims();
[[nodiscard]] std::vector<Erratum> errata();

/// What is used where the paper does not say.
[[nodiscard]] std::vector<std::string> unstated_choices();

}  // namespace stickslip::testing
