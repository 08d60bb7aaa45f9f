// SPDX-License-Identifier: MIT
#pragma once

/// The structure that files hold, as the table [model] names them.

#include <filesystem>
#include <memory>

#include "case_entry.hpp"
#include "stickslip/data/model.hpp"

namespace stickslip::data {

/// Whether a key asks for matrices.
[[nodiscard]] bool is_of_matrices(const Key& key);

/// The matrices in SI units, or, unless files are read, nothing but whether there is a load. Two calls with the same keys and files
/// give the same object while it is in use. Throws FieldError for a key, InputError for a missing one or a file.
[[nodiscard]] std::shared_ptr<const StructureMatrices> matrices_of(const std::filesystem::path& case_file,
                                                                   const Entries& entries, bool reads_files);

}  // namespace stickslip::data
