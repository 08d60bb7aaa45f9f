// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace stickslip::data {

/// The SHA-256 digest (FIPS 180-4) of some bytes, as 64 hexadecimal digits in lower case.
[[nodiscard]] std::string sha256(std::string_view bytes);

}  // namespace stickslip::data
