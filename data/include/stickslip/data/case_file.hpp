// SPDX-License-Identifier: MIT
#pragma once

/// Cases as TOML files: the tables [beam], [friction], [excitation], [numerics] and [damping], whose keys are
/// the field names of problem.hpp. A file holds every key exactly once and no other; those of [damping],
/// friction.viscous and beam.axial_direction may be missing and are then 0.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/data/input_error.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::data {

/// Throws InputError for a result that is not finite, as "the answer comes out as inf, but must be finite":
/// quantities that are allowed one by one can overflow together.
[[noreturn]] void throw_overflow(std::string_view result);

/// One `table.key=value` that replaces what the file says, or supplies what it lacks.
struct Override {
  std::string key;      ///< "beam.length"
  std::string value;    ///< "1.8", as TOML
  std::string place{};  ///< where it was given, "--hz"; empty: "override beam.length=1.8"

  /// Splits "beam.length=1.8". Throws InputError if there is no '=' or either side is empty.
  static Override parse(std::string_view text);
};

/// The folder with cases/, paper/ and reference/: installed_folder() with the environment variable
/// STICKSLIP_DATA.
[[nodiscard]] std::filesystem::path data_directory();

/// A name of a case in data_directory()/cases (without .toml), or a path to a file, as a path.
/// Throws InputError, naming the cases there are, if neither exists.
[[nodiscard]] std::filesystem::path find_case(const std::string& name_or_path);

/// Throws InputError, naming the place, if no case may have a number of that magnitude at the key, as
/// "beam.length", which must be one of problem.hpp.
void require_magnitude(std::string_view key, double value, const std::string& place);

/// Reads and validates a case, of at most 1 MB; the last override of a key wins. An integer may stand where a
/// float is expected, but not the other way round. Throws InputError for a file that cannot be read, a syntax
/// error, an unknown, missing or mistyped key, a value that the problem types do not allow, or one that no
/// beam has: each quantity has a range of magnitudes, in SI units, that the problem types do not know.
[[nodiscard]] Case read_case(const std::filesystem::path& file, const std::vector<Override>& overrides = {});

/// find_case, then read_case.
[[nodiscard]] Case load_case(const std::string& name_or_path, const std::vector<Override>& overrides = {});

/// Every number of a case by its key, as "beam.length".
[[nodiscard]] std::map<std::string, double> numbers_of(const Case& problem);

/// The case that has these numbers, every key among them. Throws std::out_of_range for a key that is missing,
/// and FieldError.
[[nodiscard]] Case case_with(const std::string& name, const std::map<std::string, double>& numbers);

/// The names of the published cases, sorted, each with the first comment line of its file.
struct CaseListing {
  std::string name;
  std::string title;
};
[[nodiscard]] std::vector<CaseListing> list_cases();

}  // namespace stickslip::data
