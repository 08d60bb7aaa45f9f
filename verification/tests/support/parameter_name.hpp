// SPDX-License-Identifier: MIT
#pragma once

/// Names of parametrised tests: what GoogleTest allows in one, from the numbers that it stands for.

#include <fmt/format.h>

#include <string>

namespace stickslip::testing {

/// "0_9" for 0.9, "minus5" for -5.
inline std::string parameter_name(double value) {
  std::string name = fmt::format("{}", value);
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (name[i] == '.') name[i] = '_';
    if (name[i] == '-') name.replace(i, 1, "minus");
  }
  return name;
}

/// For INSTANTIATE_TEST_SUITE_P over doubles.
struct NameOfDouble {
  template <typename Info>
  std::string operator()(const Info& instance) const {
    return parameter_name(instance.param);
  }
};

}  // namespace stickslip::testing
