#pragma once

#include <string>

namespace stickslip::report {

/// Rows, one for each part of the sources: mutants, killed, equivalent, surviving, not compiling, of the same
/// code, seed, from verification/mutants/summary.csv. Throws data::InputError if the file cannot be used.
[[nodiscard]] std::string mutant_rows();

/// Rows, one for each mutant that changes no result: file and function, edit, reason, from
/// verification/mutants/survivors.toml. Throws data::InputError if the file cannot be used.
[[nodiscard]] std::string equivalent_mutant_rows();

}  // namespace stickslip::report
