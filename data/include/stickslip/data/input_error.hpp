// SPDX-License-Identifier: MIT
#pragma once

/// @file
/// The one kind of error that a user can mend. Every other exception is a mistake of this project.

#include <stdexcept>
#include <string>
#include <string_view>

namespace stickslip::data {

/// An input that cannot be used: a field of a case, an argument, a file. The message is one sentence that
/// names the input, its value and what is allowed. The command line ends with exit code 2 on it, and on no
/// other kind.
class InputError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Some input errors at once: a sentence in each line.
class InputErrors : public InputError {
 public:
  using InputError::InputError;
};

/// The shortest decimal text that reads back as the same double: "0.1", "-2", "1e-05", "nan", "inf".
[[nodiscard]] std::string shortest_text(double value);

/// An input error about one field: "beam.length is -2, but must be a finite number above 0 (m)".
class FieldError : public InputError {
 public:
  /// `field` is the name of the field ("table.key" of a case file), `value` the text of what was given,
  /// `allowed` what may stand there.
  FieldError(std::string_view field, std::string_view value, std::string_view allowed);
  FieldError(std::string_view field, double value, std::string_view allowed)
      : FieldError(field, shortest_text(value), allowed) {}

  [[nodiscard]] const std::string& field() const noexcept { return field_; }

 private:
  std::string field_;
};

}  // namespace stickslip::data
