#pragma once

#include <string>
#include <string_view>

#include "command_tree.hpp"

namespace stickslip::cli {

/// The manual page of section 1, in roff with the macros of man(7).
[[nodiscard]] std::string manual_page(const Command& program, std::string_view version);

}  // namespace stickslip::cli
