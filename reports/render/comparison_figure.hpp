// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "comparison/comparison.hpp"

namespace stickslip::report {

/// A comparison drawn by gnuplot (figures/comparison.gp), as the bytes of a file: for each quantity with
/// points the reference with its band and theirs, and below them the difference with what is allowed.
/// `format` is "pdf", "png" or "svg". Throws std::runtime_error if gnuplot is missing or fails.
[[nodiscard]] std::string draw(const comparison::Comparison& comparison, const std::string& format);

}  // namespace stickslip::report
