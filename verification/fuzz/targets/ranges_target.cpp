// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "range_text.hpp"
#include "stickslip/data/case_file.hpp"
#include "target.hpp"

namespace stickslip::fuzz {

namespace {

void require_ascending(std::span<const double> values, std::string_view text) {
  const bool holds =
      std::ranges::all_of(values, [](double value) { return std::isfinite(value) && value >= 0.0; }) &&
      std::ranges::is_sorted(values);
  if (!holds) throw Violation("the numbers are not ascending, finite and at least 0: " + std::string(text));
}

}  // namespace

void parse_ranges(Bytes bytes) {
  const std::string text(bytes.begin(), bytes.end());
  allow_input_errors([&] {
    const auto axis = cli::parse_axis("--x", text);
    if (axis.values.size() < 2) throw Violation("an axis of fewer than two values: " + text);
    require_ascending(axis.values, text);
    if (axis.values.front() == axis.values.back()) throw Violation("an axis with equal ends: " + text);
  });
  for (const bool equal : {false, true})
    allow_input_errors([&] {
      const auto [from, to] = cli::parse_range("--band", "excitation.frequency_hz", text, equal);
      require_ascending(std::array{from, to}, text);
    });
}

}  // namespace stickslip::fuzz
