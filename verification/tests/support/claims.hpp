// SPDX-License-Identifier: MIT
#pragma once

/// The ledgers data/paper/claims.toml and data/paper/errata.toml, and how a test judges a claim. The verdict follows from what was
/// measured; the ledger's must be the same. The results of the test run hold what was found, for the report.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "stickslip/data/paper.hpp"
#include "support/requirements.hpp"

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

/// What a test measured.
struct Evidence {
  bool as_printed{};  ///< the statement passed as it is printed
  /// It passed the same test once a slip of the pen is put right: a symbol, sign, unit, word or reference.
  std::optional<bool> corrected{};
  /// It passed with one choice of what the paper leaves open, and failed with another.
  std::optional<bool> with_a_choice{};
  std::optional<bool> instead{};  ///< what `correction` puts in the place of a wrong statement passed
};

inline data::ClaimVerdict verdict(const Evidence& evidence) {
  if (evidence.as_printed) return data::ClaimVerdict::holds;
  if (evidence.corrected.value_or(false)) return data::ClaimVerdict::holds_with_correction;
  return evidence.with_a_choice.value_or(false) ? data::ClaimVerdict::not_determined
                                                : data::ClaimVerdict::does_not_hold;
}

/// Judges the claim with this id in the running test. `finding` is one sentence with the numbers measured, in
/// plain ASCII. Fails if the ledger has no such claim or another verdict, or if a claim does not hold and
/// nothing was shown to hold instead.
inline void judge(const std::string& id, const Evidence& evidence, const std::string& finding) {
  record_requirement("V3");
  const auto ledger = claims();
  const auto entry = std::ranges::find(ledger, id, &Claim::id);
  const data::ClaimVerdict found = verdict(evidence);
  ASSERT_TRUE(entry != ledger.end()) << "data/paper/claims.toml has no claim " << id << ": " << finding;
  EXPECT_EQ(data::to_string(found), data::to_string(entry->verdict)) << entry->id << ": " << finding;
  EXPECT_TRUE(found != data::ClaimVerdict::does_not_hold || evidence.instead.value_or(false))
      << entry->id << ": nothing was shown to hold instead";
  EXPECT_TRUE(std::ranges::all_of(finding, [](char c) { return c >= ' ' && c <= '~'; })) << finding;
  ::testing::Test::RecordProperty("claim", id);
  ::testing::Test::RecordProperty("verdict", std::string(data::to_string(found)));
  ::testing::Test::RecordProperty("finding", finding);
}

}  // namespace stickslip::testing
