// SPDX-License-Identifier: MIT
#pragma once

/// What a function says when it refuses its arguments.

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace stickslip::testing {

/// Expects `call` to throw an Exception whose message contains each of `parts`.
template <class Exception, class Call>
void expect_refusal(Call&& call, std::initializer_list<const char*> parts) {
  try {
    call();
  } catch (const Exception& error) {
    const std::string message = error.what();
    for (const char* part : parts) EXPECT_NE(message.find(part), std::string::npos) << message;
    return;
  }
  ADD_FAILURE() << "nothing was refused";
}

}  // namespace stickslip::testing
