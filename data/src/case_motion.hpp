// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

#include "case_entry.hpp"
#include "stickslip/data/general_motion.hpp"

namespace stickslip::data {

/// Whether keys of the table, "excitation" or "wall", ask for a general motion.
[[nodiscard]] bool states_general_motion(std::string_view table, const Entries& entries);

/// The general motion of a table until `duration`, or as long as its record; nothing if it has none. With reads_files false a record
/// is at rest. Throws FieldError or InputError for anything else, and for keys that do not go together.
[[nodiscard]] std::optional<GeneralMotion> general_motion_of(std::string_view table,
                                                             const std::filesystem::path& case_file,
                                                             const Entries& entries, double duration,
                                                             bool reads_files);

}  // namespace stickslip::data
