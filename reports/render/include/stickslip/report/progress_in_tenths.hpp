#pragma once

#include <functional>
#include <string>

namespace stickslip::report {

/// Says on standard error, if that is a terminal, each further tenth of a subcommand's work that is done.
[[nodiscard]] std::function<void(double)> progress_in_tenths(const std::string& command);

}  // namespace stickslip::report
