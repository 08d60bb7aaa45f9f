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
#include <initializer_list>
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
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {

inline ::testing::AssertionResult holds(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "'" << part << "' is not in\n" << text;
}

/// The message of the Error that the action throws, if it throws one.
template <class Error>
std::optional<std::string> error_message_if_any(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return std::nullopt;
}

/// The message of the Error that the action throws. Fails the test if it throws none.
template <class Error>
std::string error_message_of(const std::function<void()>& action) {
  const auto message = error_message_if_any<Error>(action);
  EXPECT_TRUE(message) << "no exception";
  return message.value_or("");
}

/// Expects that the action throws an Error whose message contains each of the parts.
template <class Error>
void expect_error_message(const std::function<void()>& action, std::initializer_list<const char*> parts) {
  const std::string message = error_message_of<Error>(action);
  for (const char* part : parts) EXPECT_NE(message.find(part), std::string::npos) << message;
}

/// What GoogleTest allows in the name of a parametrised test: "0_9" for 0.9, "minus5" for -5.
inline std::string parameter_name(double value) {
  std::string name = fmt::format("{}", value);
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (name[i] == '.') name[i] = '_';
    if (name[i] == '-') name.replace(i, 1, "minus");
  }
  return name;
}

}  // namespace stickslip::testing
