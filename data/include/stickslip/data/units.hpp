// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace stickslip::data {

/// A unit as a multiple of an SI unit: one of it is numerator/denominator of that.
struct Unit {
  std::string_view si;
  double numerator{1.0}, denominator{1.0};

  [[nodiscard]] double to_si(double value) const { return value * numerator / denominator; }
};

/// "kHz", "rad/s", "rad_per_s", "us", "mm", ...; nothing if it is unknown. Upper and lower case differ: mN,
/// MN.
[[nodiscard]] std::optional<Unit> unit_named(std::string_view name);

/// "Hz, kHz, rad/s": those that can be converted to this one; itself alone if it is unknown.
[[nodiscard]] std::string units_convertible_to(std::string_view si);

}  // namespace stickslip::data
