// SPDX-License-Identifier: MIT
#pragma once

#include <toml++/toml.h>

#include <filesystem>
#include <string>
#include <vector>

#include "stickslip/data/uncertainty.hpp"

namespace stickslip::data {

/// What the node at `uncertainty` of a case file says; `keys` are those of a case that are numbers and no integers.
[[nodiscard]] Uncertainty uncertainty_of(const std::filesystem::path& file, const toml::node& node,
                                         const std::vector<std::string>& keys);

}  // namespace stickslip::data
