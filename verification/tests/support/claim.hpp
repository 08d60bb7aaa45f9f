#pragma once

/// How a test judges a claim of the paper (data/paper/claims.toml). The verdict follows from what was
/// measured; the ledger's must be the same. What was found is recorded for the report.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

#include "stickslip/data/paper.hpp"

namespace stickslip::testing {

inline std::string full_name(const ::testing::TestInfo& test) {
  return std::string(test.test_suite_name()) + "." + test.name();
}

/// What a test measured.
struct Evidence {
  bool as_printed{};  ///< the statement passed as it is printed
  std::optional<bool>
      corrected{};  ///< it passed the same test once a symbol, a sign, a number or its range is put right
  std::optional<bool> instead{};  ///< what `correction` puts in the place of a wrong statement passed
};

inline data::ClaimVerdict verdict(const Evidence& evidence) {
  if (evidence.as_printed) return data::ClaimVerdict::holds;
  return evidence.corrected.value_or(false) ? data::ClaimVerdict::holds_with_correction
                                            : data::ClaimVerdict::does_not_hold;
}

/// Judges the claim that the running test belongs to. `finding` is one sentence with the numbers measured, in
/// plain ASCII. Fails if the ledger has no such claim or another verdict, or if a claim does not hold and
/// nothing was shown to hold instead.
inline void judge(const Evidence& evidence, const std::string& finding) {
  const std::string test = full_name(*::testing::UnitTest::GetInstance()->current_test_info());
  const auto claims = data::claims();
  const auto entry = std::ranges::find(claims, test, &data::Claim::test);
  const data::ClaimVerdict found = verdict(evidence);
  ASSERT_TRUE(entry != claims.end()) << "data/paper/claims.toml has no claim with the test " << test << ": "
                                     << finding;
  EXPECT_EQ(data::to_string(found), data::to_string(entry->verdict)) << entry->id << ": " << finding;
  EXPECT_TRUE(found != data::ClaimVerdict::does_not_hold || evidence.instead.value_or(false))
      << entry->id << ": nothing was shown to hold instead";
  EXPECT_TRUE(std::ranges::all_of(finding, [](char c) { return c >= ' ' && c <= '~'; })) << finding;
  ::testing::Test::RecordProperty("claim", entry->id);
  ::testing::Test::RecordProperty("verdict", std::string(data::to_string(found)));
  ::testing::Test::RecordProperty("finding", finding);
}

}  // namespace stickslip::testing
