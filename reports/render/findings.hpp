// SPDX-License-Identifier: MIT
#pragma once

/// Numbers that several studies yield together, or that the figures need as well.

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "render/study_results.hpp"

namespace stickslip::report {

/// A computed value beside what it is held against.
struct CheckedResult {
  std::string what;       ///< "frequency.stick.1, closed form"
  std::string reference;  ///< what it is held against: "printed" or "closed form"
  double computed{}, expected{};
  bool known_erratum{};  ///< a printed number that does not hold
  [[nodiscard]] double relative_difference() const { return computed / expected - 1.0; }
};

/// Every printed result against its recomputation, and every finite-element result of the solution
/// verification against the closed form.
[[nodiscard]] std::vector<CheckedResult> checked_results(StudyResults& results);

/// Of the relative differences, errata apart.
struct Differences {
  std::size_t count{};
  double bias{};    ///< mean
  double spread{};  ///< standard deviation
};
[[nodiscard]] Differences differences_from(const std::vector<CheckedResult>& values,
                                           const std::string& reference);

/// Buckling load of the stick state in units of EI/L^2.
[[nodiscard]] double buckling_coefficient(const data::Beam& beam);

/// What the templates read as `findings`: settings of the studies, and numbers drawn from their results.
[[nodiscard]] nlohmann::json findings(StudyResults& results);

}  // namespace stickslip::report
