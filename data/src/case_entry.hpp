// SPDX-License-Identifier: MIT
#pragma once

/// The values of a case file as they were given: numbers, or texts such as "1.5 mm"; and what becomes of them.

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <variant>

#include "stickslip/data/key.hpp"
#include "stickslip/data/toml_file.hpp"
#include "stickslip/data/uncertainty.hpp"

namespace stickslip::data {

/// A value as it was given, and where.
struct Entry {
  std::variant<std::monostate, bool, std::int64_t, double, std::string, toml::array, toml::table>
      value;                // monostate: none of these
  std::string description;  // for messages
  std::string place;        // "paper.toml:3" or "override beam.length=1.8"
  bool is_mean{};           // of a distribution of the key, which has no other value
};

using Entries = std::map<std::string, Entry>;  // by "table.key"

[[nodiscard]] Entry entry_of(const toml::node& node, std::string place);

/// The value of an override: TOML, as 0.04 or "40 mm"; what is not TOML is a text, as 40 mm. Throws InputError,
/// beginning with the place, if it has several lines.
[[nodiscard]] Entry entry_of(const std::string& text, const std::string& place);

/// The text in small letters. Throws FieldError unless it is one of the names.
[[nodiscard]] std::string name_of(std::string_view path, const Entry& entry,
                                  const std::vector<std::string>& names);

/// The number in SI units. Throws FieldError if it is neither a number nor a number with a unit of this kind,
/// or has no magnitude that is allowed. What is not finite is left to the problem types.
[[nodiscard]] double number_of(std::string_view path, const Magnitudes& magnitudes, const Entry& entry);

/// Throws FieldError unless it is an integer that an int holds.
[[nodiscard]] int integer_of(std::string_view path, const Entry& entry);

/// 1 for true, 0 for false. Throws FieldError for anything else.
[[nodiscard]] int flag_of(std::string_view path, const Entry& entry);

/// The numbers of a list, each as number_of() takes it. Throws FieldError, naming `path`, for anything else.
[[nodiscard]] std::vector<double> numbers_of(std::string_view path, const Magnitudes& magnitudes,
                                             const Entry& entry);

/// Throws FieldError.
void require_magnitude(std::string_view path, const Magnitudes& magnitudes, double value);

/// Adds what the shorthand stands for: a section by its shape, a material by its name, a shear stiffness by Poisson's ratio,
/// the motion of the base by the amplitude of its velocity or acceleration. Throws FieldError, naming the shorthand, for a
/// value that it does not allow, InputError if a quantity is given in two ways or a key of a shape is missing.
void expand_shorthand(Entries& entries);

/// Takes out of the entries what the key replaces: of the amplitudes of displacement, velocity and
/// acceleration one alone is given, and the duration and the shear stiffness once.
void erase_alternatives(std::string_view key, Entries& entries);

/// What the node at `uncertainty` of a case file says.
[[nodiscard]] Uncertainty uncertainty_of(const std::filesystem::path& file, const toml::node& node);

}  // namespace stickslip::data
