// SPDX-License-Identifier: MIT
/// The ledger of claims and the report.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "support/ledgers.hpp"
#include "support/requirements.hpp"

namespace stickslip::testing {
namespace {

STICKSLIP_VERIFIES(LedgerOfClaims, "V3");
TEST(LedgerOfClaims, RefersToFiguresAndTablesThatTheReportHas) {
  std::string latex;
  for (const auto& file :
       std::filesystem::recursive_directory_iterator(STICKSLIP_SOURCE_DIRECTORY "/reports/report"))
    if (file.path().extension() == ".tex") {
      std::ifstream stream(file.path());
      latex.append(std::istreambuf_iterator<char>(stream), {});
    }
  for (const auto& claim : claims())
    EXPECT_TRUE(claim.figure.empty() || latex.find("\\label{" + claim.figure + "}") != std::string::npos)
        << claim.id << " refers to " << claim.figure;
}

}  // namespace
}  // namespace stickslip::testing
