// SPDX-License-Identifier: MIT
#pragma once

/// What a function says when it refuses its arguments.

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace stickslip::testing {

/// The message of the Exception that `call` throws.
template <class Exception, class Call>
std::string refusal_of(Call&& call) {
  try {
    call();
  } catch (const Exception& error) {
    return error.what();
  }
  return "nothing was refused";
}

/// Expects `call` to throw an Exception whose message contains each of `parts`.
template <class Exception, class Call>
void expect_refusal(Call&& call, std::initializer_list<const char*> parts) {
  const std::string message = refusal_of<Exception>(call);
  for (const char* part : parts) EXPECT_NE(message.find(part), std::string::npos) << message;
}

}  // namespace stickslip::testing
