// SPDX-License-Identifier: MIT
#pragma once

/// Where the files are that the program reads but does not contain.

#include <filesystem>
#include <string_view>

namespace stickslip::data {

/// A folder of files that come with the program: the one that the environment variable `variable` names; else
/// `folder` in share/stickslip of the installation that the running program belongs to, wherever that has
/// been moved; else `source`, its place in the source tree. It need not exist.
[[nodiscard]] std::filesystem::path installed_folder(const char* variable, std::string_view folder,
                                                     std::string_view source);

}  // namespace stickslip::data
