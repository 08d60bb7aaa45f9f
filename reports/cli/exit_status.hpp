// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

namespace stickslip::cli {

/// With what the program ends.
enum ExitStatus : int {
  done = 0,
  failed = 1,   ///< a check, a run or the program itself
  unusable = 2  ///< an input or an output that the user can mend
};

/// What `work` returns or, if it throws, the status for the kind of the exception, which is told in one
/// sentence on standard error: `unusable` for data::InputError and OutputError, else `failed`.
/// std::logic_error is told as a mistake of the program.
[[nodiscard]] int exit_status_of(const std::function<int()>& work);

}  // namespace stickslip::cli
