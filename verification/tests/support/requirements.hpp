#pragma once

/// What the suite is for: each requirement with its source in the paper or elsewhere, and the test suites
/// that serve it. Every suite serves exactly one.

#include <span>
#include <string_view>
#include <vector>

namespace stickslip::testing {

struct Requirement {
  std::string_view id;      ///< "F2": a letter for the subject and a number
  std::string_view text;    ///< what is to hold
  std::string_view source;  ///< equations, figures, errata; plain text
  std::vector<std::string_view>
      suites;  ///< names of test suites; a name that ends with * stands for all that begin so
};

/// In the order of the report.
[[nodiscard]] std::span<const Requirement> requirements();

/// The requirement that a test suite serves, or null. `suite` may have the prefix of an instantiation
/// ("Figures4And5/Verdict").
[[nodiscard]] const Requirement* requirement_of(std::string_view suite);

/// Whether `pattern`, an entry of Requirement::suites, stands for this suite.
[[nodiscard]] bool stands_for(std::string_view pattern, std::string_view suite);

}  // namespace stickslip::testing
