// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "stickslip/data/atomic_file.hpp"

namespace stickslip::cli {

using OutputFile = data::AtomicFile;
using data::OutputError;

/// Opens a file that has a name, before the work whose result it is to hold. Throws OutputError.
inline void open_if_named(std::optional<OutputFile>& file, const std::string& path) {
  if (!path.empty()) file.emplace(path);
}

}  // namespace stickslip::cli
