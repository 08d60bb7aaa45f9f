// SPDX-License-Identifier: MIT
#pragma once

/// Ranges as the command line takes them. All functions throw data::InputError, naming the option, the part
/// that is wrong and what is allowed.

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "studies/analyses/criterion_map.hpp"

namespace stickslip::cli {

/// The parts between the separators, also empty ones: one more than there are separators.
[[nodiscard]] std::vector<std::string_view> split(std::string_view text, char separator);

/// "FROM:TO", two finite numbers above 0 with FROM below TO or, if they may be `equal`, not above it; of the magnitude that a case may
/// have at the key, in SI units unless with a unit.
[[nodiscard]] analytic::Bounds parse_range(std::string_view option, std::string_view key,
                                           std::string_view text, bool equal = false);

/// So many values in equal steps from end to end of such a range.
[[nodiscard]] std::vector<double> parse_values(std::string_view option, std::string_view key,
                                               std::string_view text, int count);

/// "PARAMETER=FROM:TO:COUNT" in equal steps, or "PARAMETER=FROM:TO:COUNT:log" in equal ratios; FROM may be 0
/// in equal steps if the key may be. Throws data::InputError, too, for ends that no case may have.
[[nodiscard]] studies::MapAxis parse_axis(std::string_view option, std::string_view text);

/// What parse_axis() makes the same axis from.
[[nodiscard]] std::string axis_text(const studies::MapAxis& axis);

/// The parameters that an axis may have: "length (beam.length, m), ...".
[[nodiscard]] std::string axis_help();

/// --tolerance "QUANTITY=VALUE", or "VALUE" for all, whose name is empty; the last of a quantity counts.
[[nodiscard]] std::map<std::string, double> parse_tolerances(const std::vector<std::string>& texts);

/// --rows "1:12,15".
[[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> parse_rows(const std::string& text);

}  // namespace stickslip::cli
