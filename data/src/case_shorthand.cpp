// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "case_entry.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::data {

namespace {

const Entry* find(const Entries& entries, std::string_view key) {
  const auto found = entries.find(std::string(key));
  return found == entries.end() ? nullptr : &found->second;
}

// Puts a number under a key, at the place of the shorthand that it comes from.
void supply(Entries& entries, std::string_view key, double value, std::string_view shorthand_key) {
  const std::string place = find(entries, shorthand_key)->place;
  if (const Entry* given = find(entries, key); given != nullptr && !given->is_mean)
    throw InputError(given->place + ": " + std::string(key) + " is " + given->description +
                     ", but must be missing where " + std::string(shorthand_key) + " is given");
  entries.insert_or_assign(std::string(key), Entry{value, shortest_text(value), place});
}

double number_at(std::string_view key, const Entry& entry) {
  return number_of(key, key_named(key).magnitudes, entry);
}

struct Shape {
  std::string_view name;
  std::vector<std::string_view> sides;
};

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all{{"rectangle", {"section.width", "section.height"}},
                                      {"circle", {"section.diameter"}},
                                      {"tube", {"section.diameter", "section.wall_thickness"}}};
  return all;
}

// The number of a section, in which NaN stands for none.
void set(std::string_view key, const Entry& entry, std::string_view allowed, CaseNumbers& numbers) {
  const double value = number_at(key, entry);
  if (std::isnan(value)) throw FieldError(key, value, allowed);
  key_named(key).member.set(numbers, value);
}

// The section, if its shape is given.
Section expand_section(Entries& entries) {
  const auto first =
      std::ranges::find_if(entries, [](const auto& entry) { return entry.first.starts_with("section."); });
  if (first == entries.end()) return {};
  std::vector<std::string> names;
  for (const Shape& shape : shapes()) names.emplace_back(shape.name);
  const Entry* given = find(entries, "section.shape");
  if (given == nullptr)
    throw InputError(first->second.place + ": section.shape is missing, but must be one of " + joined(names));
  const Shape& shape = *std::ranges::find(shapes(), name_of("section.shape", *given, names), &Shape::name);
  for (const auto& [key, entry] : entries)
    if (key.starts_with("section.") && key != "section.shape" &&
        std::ranges::find(shape.sides, key) == shape.sides.end())
      throw InputError(entry.place + ": " + key + " is " + entry.description + ", but a " +
                       std::string(shape.name) + " does not have it");
  CaseNumbers numbers;
  for (const std::string_view side : shape.sides) {
    const Entry* entry = find(entries, side);
    if (entry == nullptr)
      throw InputError(given->place + ": " + std::string(side) + " is missing, but a " +
                       std::string(shape.name) + " must have it");
    set(side, *entry, "a finite number above 0 (m)", numbers);
  }
  numbers.section.require_valid();
  supply(entries, "beam.area", numbers.section.area(), "section.shape");
  supply(entries, "beam.second_moment_of_area", numbers.section.second_moment_of_area(), "section.shape");
  return numbers.section;
}

// k G A with G = E/(2 (1 + nu)).
void expand_poissons_ratio(CaseNumbers numbers, Entries& entries) {
  constexpr std::string_view key = "beam.poissons_ratio";
  const Entry* given = find(entries, key);
  if (given == nullptr) return;
  set(key, *given, "a number above -1 and below 0.5", numbers);
  numbers.section.require_valid();
  const Entry* modulus = find(entries, "beam.youngs_modulus");
  const bool has_section = numbers.section.is_given();
  if (!has_section || modulus == nullptr)
    throw InputError(given->place + ": beam.poissons_ratio is " + given->description + ", but needs " +
                     (has_section ? "beam.youngs_modulus or beam.material" : "section.shape") +
                     "; otherwise give beam.shear_stiffness");
  const double youngs_modulus = number_of("beam.youngs_modulus", {.unit = "Pa"}, *modulus);
  supply(entries, "beam.shear_stiffness",
         numbers.section.shear_coefficient() * numbers.section.area() * youngs_modulus /
             (2.0 * (1.0 + numbers.section.poissons_ratio)),
         key);
}

void expand_material(Entries& entries) {
  const Entry* given = find(entries, "beam.material");
  if (given == nullptr) return;
  const auto materials = list_materials();
  std::vector<std::string> names;
  for (const Material& material : materials) names.push_back(material.name);
  const auto material =
      *std::ranges::find(materials, name_of("beam.material", *given, names), &Material::name);
  supply(entries, "beam.density", material.density, "beam.material");
  supply(entries, "beam.youngs_modulus", material.youngs_modulus, "beam.material");
}

// One amplitude is given; that of a distribution gives way.
void expand_amplitude(Entries& entries) {
  const Entry* given = nullptr;
  std::string_view given_key;
  for (const std::string_view key : amplitude_keys) {
    const Entry* entry = find(entries, key);
    if (entry == nullptr || entry->is_mean) continue;
    if (given != nullptr)
      throw InputError(given->place + ": " + std::string(given_key) + " is " + given->description +
                       ", but must be missing where " + std::string(key) + " is given");
    given = entry;
    given_key = key;
  }
  if (given != nullptr) erase_alternatives(given_key, entries);
}

// Where cases of version 0.1 have it.
void expand_duration(Entries& entries) {
  const Entry* given = find(entries, "numerics.duration");
  if (given == nullptr) return;
  supply(entries, "excitation.duration", number_at("numerics.duration", *given), "numerics.duration");
}

// Without a kinetic coefficient the friction does not fall: Coulomb's law. The exponential then has no effect. With one
// and no decay it jumps.
void expand_friction(Entries& entries) {
  const Entry* holding = find(entries, "friction.static_coefficient");
  if (holding == nullptr) return;
  const bool falls = !entries.try_emplace("friction.kinetic_coefficient", *holding).second;
  const double decay = falls ? std::numeric_limits<double>::infinity() : 0.0;
  entries.try_emplace("friction.decay", Entry{decay, shortest_text(decay), holding->place});
}

}  // namespace

void erase_alternatives(std::string_view key, Entries& entries) {
  std::erase_if(entries,
                [key](const auto& entry) { return entry.first != key && state_the_same(entry.first, key); });
}

void expand_shorthand(Entries& entries) {
  CaseNumbers numbers;
  numbers.section = expand_section(entries);
  expand_material(entries);
  expand_poissons_ratio(numbers, entries);
  expand_amplitude(entries);
  expand_duration(entries);
  expand_friction(entries);
}

}  // namespace stickslip::data
