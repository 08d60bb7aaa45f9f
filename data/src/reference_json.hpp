// SPDX-License-Identifier: MIT
#pragma once

#include "json_file.hpp"
#include "stickslip/data/reference.hpp"

namespace stickslip::data {

/// A data set as its object in datapackage.json describes it: the members that must be there, each of its type. What
/// they mean is not checked.
[[nodiscard]] Resource read_description(const JsonNode& node);

}  // namespace stickslip::data
