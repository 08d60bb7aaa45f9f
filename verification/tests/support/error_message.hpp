// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <initializer_list>
#include <string>

namespace stickslip::testing {

/// The message of the Error that the action throws. Fails the test if it throws none.
template <class Error>
std::string error_message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "no exception";
  return "";
}

/// Expects that the action throws an Error whose message contains each of the parts.
template <class Error>
void expect_error_message(const std::function<void()>& action, std::initializer_list<const char*> parts) {
  const std::string message = error_message_of<Error>(action);
  for (const char* part : parts) EXPECT_NE(message.find(part), std::string::npos) << message;
}

}  // namespace stickslip::testing
