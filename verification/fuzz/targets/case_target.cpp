// SPDX-License-Identifier: MIT
#include <map>

#include "stickslip/data/case_file.hpp"
#include "target.hpp"

namespace stickslip::fuzz {

namespace {

// The numbers of a case as overrides of a file without any.
std::vector<data::Override> overrides_of(const std::map<std::string, double>& numbers) {
  std::vector<data::Override> overrides;
  for (const auto& [key, value] : numbers) {
    // In TOML an integer is no float: 2 and 2.0 differ, and 1e+05 is none.
    const bool is_integer = data::key_named(key).member.is_integer;
    std::string text = is_integer ? std::to_string(static_cast<int>(value)) : data::shortest_text(value);
    if (!is_integer && text.find_first_of(".en") == std::string::npos) text += ".0";
    overrides.push_back({key, text});
  }
  return overrides;
}

void require_the_same_again(const data::Case& problem, MemoryFile& file) {
  auto numbers = data::numbers_of(problem);
  // Of a section only its area, second moment and shear stiffness.
  std::erase_if(numbers, [](const auto& number) {
    return number.first.starts_with("section.") || number.first == "beam.poissons_ratio";
  });
  const auto again =
      data::numbers_of(data::read_case(file.with("# all of it in overrides\n"), overrides_of(numbers)));
  for (const auto& [key, value] : numbers)
    if (again.at(key) != value)
      throw Violation(key + " = " + data::shortest_text(value) + " is read as " +
                      data::shortest_text(again.at(key)));
}

}  // namespace

void read_case_file(Bytes bytes) {
  static MemoryFile file;
  const auto parts = split(bytes);
  allow_input_errors([&] {
    std::vector<data::Override> overrides;
    for (std::size_t i = 1; i < parts.size(); ++i) overrides.push_back(data::Override::parse(parts[i]));
    require_the_same_again(data::read_case(file.with(parts.front()), overrides), file);
  });
}

}  // namespace stickslip::fuzz
