// SPDX-License-Identifier: MIT
#include "stickslip/data/case_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <system_error>
#include <type_traits>
#include <utility>
#include <variant>

#include "stickslip/data/installation.hpp"
#include "stickslip/data/toml_file.hpp"

namespace stickslip::data {

namespace {

// What a case file fills in before the problem types check it.
struct Draft {
  BeamProperties beam;
  FrictionCoefficients friction;
  HarmonicMotion excitation;
  NumericalChoices numerics;
  DampingProperties damping;
};

using Target = std::variant<double*, int*>;

enum class Presence { required, optional };  // an optional key that is missing keeps the value of a Draft

// Magnitudes that a quantity may have unless it is 0: far wider than any beam, and so narrow that no product
// of powers of them leaves the range of a double.
struct Magnitudes {
  double smallest{}, largest{std::numeric_limits<double>::infinity()};
  std::string_view unit;
};

struct Key {
  std::string_view table;
  std::string_view name;
  Target (*target)(Draft&);
  Magnitudes magnitudes{};
  Presence presence{Presence::required};

  [[nodiscard]] std::string path() const { return std::string(table) + "." + std::string(name); }
};

template <auto Table, auto Field>
Target member(Draft& draft) {
  return &((draft.*Table).*Field);
}

// Every key of a case file; a further one is one more line here.
constexpr std::array keys{
    Key{"beam", "length", member<&Draft::beam, &BeamProperties::length>, Magnitudes{1e-9, 1e6, "m"}},
    Key{"beam", "area", member<&Draft::beam, &BeamProperties::area>, Magnitudes{1e-18, 1e12, "m^2"}},
    Key{"beam", "second_moment_of_area", member<&Draft::beam, &BeamProperties::second_moment_of_area>,
        Magnitudes{1e-36, 1e24, "m^4"}},
    Key{"beam", "density", member<&Draft::beam, &BeamProperties::density>, Magnitudes{1e-6, 1e9, "kg/m^3"}},
    Key{"beam", "youngs_modulus", member<&Draft::beam, &BeamProperties::youngs_modulus>,
        Magnitudes{1e-3, 1e18, "Pa"}},
    Key{"beam", "axial_force", member<&Draft::beam, &BeamProperties::axial_force>,
        Magnitudes{1e-18, 1e18, "N"}},
    Key{"beam", "axial_direction", member<&Draft::beam, &BeamProperties::axial_direction>,
        Magnitudes{1e-9, 1.0, ""}, Presence::optional},
    Key{"friction", "static_coefficient", member<&Draft::friction, &FrictionCoefficients::static_coefficient>,
        Magnitudes{1e-9, 1e6, ""}},
    Key{"friction", "kinetic_coefficient",
        member<&Draft::friction, &FrictionCoefficients::kinetic_coefficient>, Magnitudes{1e-9, 1e6, ""}},
    Key{"friction", "decay", member<&Draft::friction, &FrictionCoefficients::decay>,
        Magnitudes{1e-15, 1e15, "s/m"}},
    Key{"friction", "viscous", member<&Draft::friction, &FrictionCoefficients::viscous>,
        Magnitudes{1e-15, 1e15, "s/m"}, Presence::optional},
    Key{"excitation", "frequency_hz", member<&Draft::excitation, &HarmonicMotion::frequency_hz>,
        Magnitudes{1e-9, 1e12, "Hz"}},
    Key{"excitation", "amplitude", member<&Draft::excitation, &HarmonicMotion::amplitude>,
        Magnitudes{1e-18, 1e6, "m"}},
    Key{"numerics", "elements", member<&Draft::numerics, &NumericalChoices::elements>},
    Key{"numerics", "time_step", member<&Draft::numerics, &NumericalChoices::time_step>,
        Magnitudes{1e-15, 1e9, "s"}},
    Key{"numerics", "spectral_radius", member<&Draft::numerics, &NumericalChoices::spectral_radius>},
    Key{"numerics", "velocity_threshold", member<&Draft::numerics, &NumericalChoices::velocity_threshold>,
        Magnitudes{1e-18, 1e9, "m/s"}},
    Key{"numerics", "modes", member<&Draft::numerics, &NumericalChoices::modes>},
    Key{"numerics", "duration", member<&Draft::numerics, &NumericalChoices::duration>,
        Magnitudes{1e-15, 1e15, "s"}},
    Key{"damping", "kelvin_voigt", member<&Draft::damping, &DampingProperties::kelvin_voigt>,
        Magnitudes{1e-18, 1e6, "s"}, Presence::optional},
    Key{"damping", "ratio", member<&Draft::damping, &DampingProperties::ratio>, Magnitudes{1e-9, 1.0, ""},
        Presence::optional},
};

// A value as it was given, and where.
struct Entry {
  std::variant<std::int64_t, double, std::string> value;  // a string describes a value that is no number
  std::string place;                                      // "paper.toml:3" or "override beam.length=1.8"
};

using Entries = std::map<std::string, Entry>;  // by "table.key"

std::vector<std::string> key_paths() {
  std::vector<std::string> paths;
  paths.reserve(keys.size());
  for (const auto& key : keys) paths.push_back(key.path());
  return paths;
}

std::vector<std::string> table_names() {
  std::vector<std::string> names;
  for (const auto& key : keys)
    if (std::ranges::find(names, key.table) == names.end()) names.emplace_back(key.table);
  return names;
}

std::vector<std::string> key_names(std::string_view table) {
  std::vector<std::string> names;
  for (const auto& key : keys)
    if (key.table == table) names.emplace_back(key.name);
  return names;
}

[[noreturn]] void throw_unknown_table(const std::string& place, std::string_view name) {
  throw InputError(place + ": unknown table [" + printable(name) + "]" + suggestion(name, table_names()) +
                   ", but a case has the tables " + joined(table_names()));
}

[[noreturn]] void throw_unknown_key(const std::string& place, const std::string& path,
                                    const toml::node& value) {
  const std::string table = path.substr(0, path.find('.'));
  const auto names = key_names(table);
  const std::string allowed = names.empty() ? "a case has the tables " + joined(table_names())
                                            : "[" + table + "] has the keys " + joined(names);
  throw InputError(place + ": unknown key " + printable(path) + suggestion(path, key_paths()) +
                   " with the value " + describe(value) + ", but " + allowed);
}

void require_known_key(const std::string& place, const std::string& path, const toml::node& value) {
  if (std::ranges::find(keys, path, &Key::path) == keys.end()) throw_unknown_key(place, path, value);
}

Entry entry_of(const toml::node& node, std::string place) {
  if (const auto* integer = node.as_integer()) return {integer->get(), std::move(place)};
  if (const auto* floating = node.as_floating_point()) return {floating->get(), std::move(place)};
  return {describe(node), std::move(place)};
}

void collect_table(const std::filesystem::path& file, std::string_view name, const toml::table& table,
                   Entries& entries) {
  for (const auto& [key, value] : table) {
    const std::string path = std::string(name) + "." + std::string(key.str());
    const std::string place = place_of(file, value);
    require_known_key(place, path, value);
    entries.insert_or_assign(path, entry_of(value, place));
  }
}

Entries entries_of_file(const std::filesystem::path& file) {
  Entries entries;
  const toml::table document = read_toml(file);
  const auto tables = table_names();
  for (const auto& [key, value] : document) {
    const std::string name(key.str());
    const std::string place = place_of(file, value);
    const bool is_known = std::ranges::find(tables, name) != tables.end();
    if (const auto* table = value.as_table()) {
      if (!is_known) throw_unknown_table(place, name);
      collect_table(file, name, *table, entries);
    } else if (is_known) {
      throw InputError(place + ": " + name + " is " + describe(value) + ", but must be a table");
    } else {
      throw_unknown_key(place, name, value);
    }
  }
  return entries;
}

void apply(const Override& replacement, Entries& entries) {
  const std::string place = replacement.place.empty()
                                ? "override " + printable(replacement.key + "=" + replacement.value)
                                : replacement.place;
  if (replacement.value.find_first_of("\r\n") != std::string::npos)
    throw InputError(place + ": the value has several lines, but must be one TOML value on one line");
  try {
    const toml::table parsed = toml::parse("value = " + replacement.value);
    const toml::node& value = *parsed.get("value");
    require_known_key(place, replacement.key, value);
    entries.insert_or_assign(replacement.key, entry_of(value, place));
  } catch (const toml::parse_error& error) {
    throw InputError(place + ": the value is not valid TOML: " + description_of(error));
  }
}

std::string text_of(const Entry& entry) {
  if (const auto* integer = std::get_if<std::int64_t>(&entry.value)) return std::to_string(*integer);
  if (const auto* floating = std::get_if<double>(&entry.value)) return shortest_text(*floating);
  return std::get<std::string>(entry.value);
}

// What is not finite is left to the problem types.
void require_magnitude(const Key& key, double value) {
  const auto& [smallest, largest, unit] = key.magnitudes;
  const double magnitude = std::abs(value);
  if (value == 0.0 || !std::isfinite(value) || (smallest <= magnitude && magnitude <= largest)) return;
  throw FieldError(key.path(), shortest_text(value),
                   "from " + shortest_text(smallest) + " to " + shortest_text(largest) +
                       (unit.empty() ? "" : " (" + std::string(unit) + ")") + " in magnitude");
}

void assign(const Key& key, const Entry& entry, double& field) {
  if (const auto* floating = std::get_if<double>(&entry.value))
    field = *floating;
  else if (const auto* integer = std::get_if<std::int64_t>(&entry.value))
    field = static_cast<double>(*integer);
  else
    throw FieldError(key.path(), text_of(entry), "a number");
  require_magnitude(key, field);
}

void assign(const Key& key, const Entry& entry, int& field) {
  const auto* integer = std::get_if<std::int64_t>(&entry.value);
  if (std::holds_alternative<double>(entry.value))
    throw FieldError(key.path(), text_of(entry) + " (a float)", "an integer");
  if (integer == nullptr) throw FieldError(key.path(), text_of(entry), "an integer");
  if (!std::in_range<int>(*integer))
    throw FieldError(
        key.path(), text_of(entry),
        "an integer of at most " + std::to_string(std::numeric_limits<int>::max()) + " in magnitude");
  field = static_cast<int>(*integer);
}

[[noreturn]] void throw_missing_key(const std::filesystem::path& file, const Key& key,
                                    const Entries& entries) {
  const std::string table(key.table);
  const bool has_table =
      std::ranges::any_of(entries, [&](const auto& entry) { return entry.first.starts_with(table + "."); });
  throw InputError(file.string() + ": " + (has_table ? key.path() : "the table [" + table + "]") +
                   " is missing, but [" + table + "] must hold " + joined(key_names(key.table)));
}

Draft draft_of(const std::filesystem::path& file, const Entries& entries) {
  Draft draft;
  for (const auto& key : keys) {
    const auto found = entries.find(key.path());
    if (found != entries.end())
      std::visit([&](auto* field) { assign(key, found->second, *field); }, key.target(draft));
    else if (key.presence == Presence::required)
      throw_missing_key(file, key, entries);
  }
  return draft;
}

Case case_of(const std::string& name, const Draft& draft) {
  return {.name = name,
          .beam = Beam(draft.beam),
          .friction = FrictionLaw(draft.friction),
          .excitation = HarmonicExcitation(draft.excitation),
          .numerics = NumericalSettings(draft.numerics),
          .damping = Damping(draft.damping)};
}

Case case_of(const std::filesystem::path& file, const Entries& entries) {
  try {
    return case_of(file.stem().string(), draft_of(file, entries));
  } catch (const FieldError& error) {
    throw InputError(entries.at(error.field()).place + ": " + error.what());
  }
}

std::filesystem::path cases_directory() { return data_directory() / "cases"; }

std::filesystem::path published_case(const std::string& name) { return cases_directory() / (name + ".toml"); }

// The text of the first comment line, without the '#'.
std::string title_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with('#')) continue;
    const auto begin = line.find_first_not_of("# \t");
    return begin == std::string::npos ? "" : line.substr(begin);
  }
  return "";
}

bool is_file(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::exists(path, error) && !std::filesystem::is_directory(path, error);
}

}  // namespace

void throw_overflow(std::string_view result) {
  throw InputError(std::string(result) +
                   ": quantities of this case are too large or too small for each other");
}

Override Override::parse(std::string_view text) {
  const auto equals = text.find('=');
  const std::string_view key = trimmed(text.substr(0, equals));
  const std::string_view value =
      equals == std::string_view::npos ? std::string_view{} : trimmed(text.substr(equals + 1));
  if (key.empty() || value.empty())
    throw FieldError("override", printable(text), "table.key=value, as in beam.length=1.8");
  return {std::string(key), std::string(value), ""};
}

std::filesystem::path data_directory() {
  return installed_folder("STICKSLIP_DATA", "data", STICKSLIP_DATA_DIRECTORY);
}

std::filesystem::path find_case(const std::string& name_or_path) {
  const bool is_name = name_or_path.find('/') == std::string::npos && !name_or_path.empty();
  if (is_name && is_file(published_case(name_or_path))) return published_case(name_or_path);
  if (is_file(name_or_path)) return name_or_path;
  std::vector<std::string> names;
  for (const auto& listing : list_cases()) names.push_back(listing.name);
  throw InputError("case " + (name_or_path.empty() ? "\"\"" : printable(name_or_path)) + " is unknown" +
                   suggestion(name_or_path, names) + ", but must be a file or one of " + joined(names));
}

void require_magnitude(std::string_view key, double value, const std::string& place) {
  try {
    require_magnitude(*std::ranges::find(keys, key, &Key::path), value);
  } catch (const FieldError& error) {
    throw InputError(place + ": " + error.what());
  }
}

Case read_case(const std::filesystem::path& file, const std::vector<Override>& overrides) {
  Entries entries = entries_of_file(file);
  for (const auto& replacement : overrides) apply(replacement, entries);
  return case_of(file, entries);
}

Case load_case(const std::string& name_or_path, const std::vector<Override>& overrides) {
  return read_case(find_case(name_or_path), overrides);
}

std::map<std::string, double> numbers_of(const Case& problem) {
  const auto& [name, beam, friction, excitation, numerics, damping] = problem;
  Draft draft{.beam = beam.properties(),
              .friction = friction.coefficients(),
              .excitation = {excitation.frequency_hz(), excitation.amplitude()},
              .numerics = numerics.choices(),
              .damping = {damping.kelvin_voigt(), damping.ratio()}};
  std::map<std::string, double> numbers;
  for (const auto& key : keys)
    std::visit([&](const auto* field) { numbers[key.path()] = *field; }, key.target(draft));
  return numbers;
}

Case case_with(const std::string& name, const std::map<std::string, double>& numbers) {
  Draft draft;
  for (const auto& key : keys)
    std::visit(
        [&](auto* field) {
          *field = static_cast<std::remove_pointer_t<decltype(field)>>(numbers.at(key.path()));
        },
        key.target(draft));
  return case_of(name, draft);
}

std::vector<CaseListing> list_cases() {
  std::error_code error;
  std::vector<CaseListing> cases;
  for (const auto& file : std::filesystem::directory_iterator(cases_directory(), error))
    if (file.path().extension() == ".toml")
      cases.push_back({file.path().stem().string(), title_of(file.path())});
  if (error)
    throw InputError(cases_directory().string() + ": cannot be listed (" + error.message() +
                     "); STICKSLIP_DATA must name the folder that holds cases/");
  std::ranges::sort(cases, {}, &CaseListing::name);
  return cases;
}

}  // namespace stickslip::data
