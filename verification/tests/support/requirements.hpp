// SPDX-License-Identifier: MIT
#pragma once

/// The requirements of verification/requirements.toml, and which of them a test serves. Each test serves one.
/// The results of a test run say which (property `requirement`).

#include <string>
#include <string_view>
#include <vector>

namespace stickslip::testing {

struct Requirement {
  std::string id;      ///< "F2": a letter for the subject and a number
  std::string text;    ///< what must hold
  std::string source;  ///< equations, figures, errata
};

/// In the order of the file.
[[nodiscard]] const std::vector<Requirement>& requirements();

/// States that the tests of a suite serve the requirement with this id. Returns true.
bool add_suite(const std::string& suite, const std::string& id);

/// The id that a suite states; empty if it states none. `suite` may have the prefix of an instantiation
/// ("Figures4And5/Verdict").
[[nodiscard]] std::string requirement_of(std::string_view suite);

/// Records that the running test serves the requirement with this id, and fails it if there is none.
void record_requirement(const std::string& id);

}  // namespace stickslip::testing

#define STICKSLIP_JOIN_NAMES(first, second) first##second
#define STICKSLIP_JOIN(first, second) STICKSLIP_JOIN_NAMES(first, second)

/// Stands before the first test of a suite: STICKSLIP_VERIFIES(StickModes, "A2"). A test whose suite states
/// no requirement, or one that verification/requirements.toml does not have, fails.
#define STICKSLIP_VERIFIES(suite, id)                                                    \
  [[maybe_unused]] static const bool STICKSLIP_JOIN(suite##_is_added_as_, __COUNTER__) = \
      ::stickslip::testing::add_suite(#suite, id)
