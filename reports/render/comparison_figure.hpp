// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "comparison/comparison.hpp"
#include "render/drawing.hpp"

namespace stickslip::report {

/// A comparison drawn by gnuplot (figures/comparison.gp), as the bytes of a file: for each quantity with
/// points the reference with its band and theirs, and below them the difference with what is allowed.
/// Throws std::runtime_error if gnuplot is missing or fails.
[[nodiscard]] std::string draw(const comparison::Comparison& comparison, const Look& look);

}  // namespace stickslip::report
