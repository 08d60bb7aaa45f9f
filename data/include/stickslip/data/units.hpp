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

/// The number in SI units that a text states, "0.2 mm", "0.2mm" or, where a unit may be missing, "2e-4"; nothing if it is none, or
/// its unit is of another kind.
[[nodiscard]] std::optional<double> quantity_in(std::string_view text, std::string_view si,
                                                bool may_lack_unit = true);

/// What must stand in place of a text that is no quantity: "a number (m) or a text of a number and a unit: m, cm, ...", or how
/// a decimal comma is written.
[[nodiscard]] std::string quantity_allowed(std::string_view text, std::string_view si);

/// "1.5" for a text that begins with a number with a decimal comma, "1,5 mm"; else empty.
[[nodiscard]] std::string with_decimal_point(std::string_view text);

/// "Hz, kHz, rad/s": those that can be converted to this one; itself alone if it is unknown.
[[nodiscard]] std::string units_convertible_to(std::string_view si);

}  // namespace stickslip::data
