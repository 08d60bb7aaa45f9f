// SPDX-License-Identifier: MIT
#pragma once

/// What most tests need: GoogleTest, the standard library, the paper's beam, requirements, tolerances, messages and names.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "support/beams.hpp"
#include "support/error_message.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {

/// What GoogleTest allows in the name of a parametrised test: "0_9" for 0.9, "minus5" for -5.
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
