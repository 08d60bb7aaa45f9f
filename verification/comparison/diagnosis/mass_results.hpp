// SPDX-License-Identifier: MIT
#pragma once

/// The problems of masses with friction in the reference data, as functions of the numbers that state them.

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace stickslip::comparison {

/// By the keys of the problem, such as "force.amplitude"; data/reference/README.md has the equations.
using Numbers = std::map<std::string, double>;

/// Changes of contact, or states at given times.
struct MassRows {
  std::vector<std::string> changes;
  std::vector<double> times, positions;
};

/// As many changes as there are in `seen`, or the states at its times. Empty if they are others or too few up to twice
/// its last time.
[[nodiscard]] std::optional<MassRows> mass_rows(const Numbers& numbers, const MassRows& seen);

/// The value of a row with its own numbers: "power" or "stops"; empty for another name.
[[nodiscard]] std::optional<double> mass_value(const Numbers& numbers, const std::string& name);

}  // namespace stickslip::comparison
