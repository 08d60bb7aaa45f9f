#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "studies/convergence/convergence.hpp"

namespace stickslip::report {

/// The rows of a LaTeX table, one line each.
class Rows {
 public:
  void add(const std::vector<std::string>& cells);
  /// A row of one cell over this many columns.
  void add_heading(const std::string& text, int columns);
  void space() { text_ += "\\addlinespace\n"; }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// The shortest text of a number, typeset.
[[nodiscard]] std::string plain_number(double value);

/// At most this many digits, trailing zeros left out; with a power of ten below 1e-3 and from 1e5 on.
[[nodiscard]] std::string compact_number(double value, int digits);

/// An observed order and the half width of its interval.
[[nodiscard]] std::string order_text(const studies::OrderEstimate& estimate);

/// Nothing for the unit 1.
[[nodiscard]] std::string unit_text(const std::string& unit);

[[nodiscard]] std::string yes_or_no(bool holds);

/// "1e-05 s" as "1 x 10^-5 s", plain text for typeset().
[[nodiscard]] std::string with_powers_of_ten(const std::string& text);

/// The name of a test, escaped, which may be broken before its capitals.
[[nodiscard]] std::string breakable(std::string_view name);

}  // namespace stickslip::report
