// SPDX-License-Identifier: MIT
#pragma once

/// What the claims of the paper are measured with.

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "support/claims.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {

/// judge() with a finding that is formatted from what was measured.
template <class... Values>
void judge(const std::string& claim, const Evidence& evidence, fmt::format_string<Values...> finding,
           Values&&... values) {
  judge(claim, evidence, fmt::format(finding, std::forward<Values>(values)...));
}

/// first, first + step, ..., last.
inline std::vector<double> evenly_spaced(double first, double last, double step) {
  std::vector<double> values;
  for (int i = 0; first + i * step <= last + 1e-9; ++i) values.push_back(first + i * step);
  return values;
}

/// The name of an instance in a table of claims: its id, with what GoogleTest allows.
template <class Row>
std::string claim_name(const ::testing::TestParamInfo<Row>& row) {
  std::string name = row.param.claim;
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

}  // namespace stickslip::testing
