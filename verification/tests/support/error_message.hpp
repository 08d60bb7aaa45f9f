// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>

namespace stickslip::testing {

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

}  // namespace stickslip::testing
