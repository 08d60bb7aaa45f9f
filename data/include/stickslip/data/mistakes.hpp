// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "stickslip/data/input_error.hpp"

namespace stickslip::data {

/// Some input errors at once: a sentence in each line.
class InputErrors : public InputError {
 public:
  using InputError::InputError;
};

/// The mistakes of an input that is read to its end in spite of them.
class Mistakes {
 public:
  /// Does the work, and keeps the message of an InputError; a FieldError is told with what `place` says of its field.
  void collect(const std::function<void()>& work,
               const std::function<std::string(const FieldError&)>& place = {});

  [[nodiscard]] bool any() const noexcept { return !sentences_.empty(); }

  /// Throws InputError for one mistake, InputErrors for more.
  void throw_if_any() const;

 private:
  std::vector<std::string> sentences_;
};

}  // namespace stickslip::data
