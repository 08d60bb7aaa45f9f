/// The ledger of claims and the tests that judge them belong together, one to one.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "stickslip/data/paper.hpp"
#include "support/claim.hpp"

namespace stickslip::testing {
namespace {

// The full names of all tests of this executable whose suite begins with "Claim".
std::set<std::string> claim_tests() {
  std::set<std::string> names;
  const ::testing::UnitTest& all = *::testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const ::testing::TestSuite& suite = *all.GetTestSuite(i);
    if (!std::string(suite.name()).starts_with("Claim")) continue;
    for (int k = 0; k < suite.total_test_count(); ++k) names.insert(full_name(*suite.GetTestInfo(k)));
  }
  return names;
}

TEST(LedgerOfClaims, EveryClaimHasItsTest) {
  const auto tests = claim_tests();
  for (const auto& claim : data::claims())
    EXPECT_TRUE(tests.contains(claim.test))
        << claim.id << " names the test " << claim.test << ", which is none";
}

TEST(LedgerOfClaims, EveryTestOfAClaimHasItsEntry) {
  std::set<std::string> named;
  for (const auto& claim : data::claims()) named.insert(claim.test);
  for (const auto& test : claim_tests()) EXPECT_TRUE(named.contains(test)) << test << " has no entry";
}

TEST(LedgerOfClaims, RefersToFiguresAndTablesThatTheReportHas) {
  std::string latex;
  for (const auto& file :
       std::filesystem::recursive_directory_iterator(STICKSLIP_SOURCE_DIRECTORY "/reports/latex"))
    if (file.path().extension() == ".tex") {
      std::ifstream stream(file.path());
      latex.append(std::istreambuf_iterator<char>(stream), {});
    }
  for (const auto& claim : data::claims())
    EXPECT_TRUE(claim.figure.empty() || latex.find("\\label{" + claim.figure + "}") != std::string::npos)
        << claim.id << " refers to " << claim.figure;
}

}  // namespace
}  // namespace stickslip::testing
