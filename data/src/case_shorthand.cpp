// SPDX-License-Identifier: MIT
#include "case_shorthand.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::data {

namespace {

constexpr std::array<std::string_view, 10> shorthand{"section.shape",
                                                     "section.width",
                                                     "section.height",
                                                     "section.diameter",
                                                     "section.wall_thickness",
                                                     "beam.material",
                                                     "beam.poissons_ratio",
                                                     "excitation.velocity_amplitude",
                                                     "excitation.acceleration_amplitude",
                                                     "numerics.duration"};

constexpr std::array<std::string_view, 3> amplitudes{"excitation.amplitude", "excitation.velocity_amplitude",
                                                     "excitation.acceleration_amplitude"};

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

constexpr Magnitudes sides{1e-9, 1e6, "m"};

// A side of the section, above 0.
double side(const Entries& entries, std::string_view key, std::string_view shape) {
  const Entry* entry = find(entries, key);
  if (entry == nullptr)
    throw InputError(find(entries, "section.shape")->place + ": " + std::string(key) + " is missing, but a " +
                     std::string(shape) + " must have it");
  const double value = number_of(key, sides, *entry);
  if (!(value > 0.0) || !std::isfinite(value)) throw FieldError(key, value, "a finite number above 0 (m)");
  return value;
}

// Shear coefficients k of a Poisson's ratio nu: Cowper, J. Appl. Mech. 33, 335-340 (1966).
struct Section {
  double area{}, second_moment_of_area{};  // m^2, m^4
  std::function<double(double)> shear_coefficient;
};

Section rectangle(const Entries& entries) {
  const double width = side(entries, "section.width", "rectangle");
  const double height = side(entries, "section.height", "rectangle");
  return {width * height, width * height * height * height / 12.0,
          [](double nu) { return 10.0 * (1.0 + nu) / (12.0 + 11.0 * nu); }};
}

Section circle(const Entries& entries) {
  const double d = side(entries, "section.diameter", "circle");
  return {std::numbers::pi * d * d / 4.0, std::numbers::pi * d * d * d * d / 64.0,
          [](double nu) { return 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu); }};
}

// With the inner diameter b = d - 2 t: d^4 - b^4 = (d^2 - b^2) (d^2 + b^2), without a difference of near numbers.
Section tube(const Entries& entries) {
  const double d = side(entries, "section.diameter", "tube");
  const double t = side(entries, "section.wall_thickness", "tube");
  if (t > 0.5 * d)
    throw FieldError("section.wall_thickness", t,
                     "at most half of section.diameter, which is " + shortest_text(d));
  const double b = d - 2.0 * t;
  const double area = std::numbers::pi * t * (d - t), ratio = b * b / (d * d);
  return {area, area * (d * d + b * b) / 16.0, [ratio](double nu) {
            const double sum = (1.0 + ratio) * (1.0 + ratio);
            return 6.0 * (1.0 + nu) * sum / ((7.0 + 6.0 * nu) * sum + (20.0 + 12.0 * nu) * ratio);
          }};
}

struct Shape {
  std::string_view name;
  Section (*section)(const Entries&);
  std::vector<std::string_view> sides;
};

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all{{"rectangle", rectangle, {"section.width", "section.height"}},
                                      {"circle", circle, {"section.diameter"}},
                                      {"tube", tube, {"section.diameter", "section.wall_thickness"}}};
  return all;
}

// The section, if its shape is given.
std::optional<Section> expand_section(Entries& entries) {
  const auto first =
      std::ranges::find_if(entries, [](const auto& entry) { return entry.first.starts_with("section."); });
  if (first == entries.end()) return std::nullopt;
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
  Section section = shape.section(entries);
  supply(entries, "beam.area", section.area, "section.shape");
  supply(entries, "beam.second_moment_of_area", section.second_moment_of_area, "section.shape");
  return section;
}

// k G A with G = E/(2 (1 + nu)).
void expand_poissons_ratio(const std::optional<Section>& section, Entries& entries) {
  constexpr std::string_view key = "beam.poissons_ratio";
  const Entry* given = find(entries, key);
  if (given == nullptr) return;
  const double nu = number_of(key, {1e-9, 1.0, ""}, *given);
  if (!(nu > -1.0 && nu < 0.5)) throw FieldError(key, nu, "a number above -1 and below 0.5");
  const Entry* modulus = find(entries, "beam.youngs_modulus");
  if (!section || modulus == nullptr)
    throw InputError(given->place + ": beam.poissons_ratio is " + given->description + ", but needs " +
                     (section ? "beam.youngs_modulus or beam.material" : "section.shape") +
                     "; otherwise give beam.shear_stiffness");
  const double youngs_modulus = number_of("beam.youngs_modulus", {.unit = "Pa"}, *modulus);
  supply(entries, "beam.shear_stiffness",
         section->shear_coefficient(nu) * section->area * youngs_modulus / (2.0 * (1.0 + nu)), key);
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

// h = A0 sin(Omega t) has the velocity amplitude A0 Omega and the acceleration amplitude A0 Omega^2.
void expand_amplitude(Entries& entries) {
  constexpr std::array units{"m", "m/s", "m/s^2"};
  for (std::size_t order = 1; order < amplitudes.size(); ++order) {
    const std::string_view key = amplitudes.at(order);
    const Entry* given = find(entries, key);
    const Entry* hz = find(entries, "excitation.frequency_hz");
    if (given == nullptr || hz == nullptr) continue;  // without a frequency: that is what is missing
    const double value = number_of(key, {1e-18, 1e18, units.at(order)}, *given);
    if (!(value >= 0.0) || !std::isfinite(value))
      throw FieldError(key, value, "a finite number of 0 or more (" + std::string(units.at(order)) + ")");
    const double omega = 2.0 * std::numbers::pi * number_of("excitation.frequency_hz", {.unit = "Hz"}, *hz);
    supply(entries, "excitation.amplitude", value / std::pow(omega, static_cast<double>(order)), key);
  }
}

// Where cases of version 0.1 have it.
void expand_duration(Entries& entries) {
  const Entry* given = find(entries, "numerics.duration");
  if (given == nullptr) return;
  const double duration = number_of("numerics.duration", {1e-15, 1e15, "s"}, *given);
  supply(entries, "excitation.duration", duration, "numerics.duration");
}

// Without a kinetic coefficient the friction does not fall: Coulomb's law. The exponential then has no
// effect.
void expand_friction(Entries& entries) {
  const Entry* holding = find(entries, "friction.static_coefficient");
  if (holding == nullptr || find(entries, "friction.kinetic_coefficient") != nullptr) return;
  entries.emplace("friction.kinetic_coefficient", *holding);
  entries.try_emplace("friction.decay", Entry{0.0, "0", holding->place});
}

}  // namespace

std::span<const std::string_view> shorthand_keys() { return shorthand; }

void erase_alternatives(std::string_view key, Entries& entries) {
  constexpr std::array<std::string_view, 2> durations{"excitation.duration", "numerics.duration"};
  constexpr std::array<std::string_view, 2> shears{"beam.shear_stiffness", "beam.poissons_ratio"};
  for (const std::span<const std::string_view> group :
       {std::span<const std::string_view>(amplitudes), std::span<const std::string_view>(durations),
        std::span<const std::string_view>(shears)})
    if (std::ranges::find(group, key) != group.end())
      for (const std::string_view other : group)
        if (other != key) entries.erase(std::string(other));
}

void expand_shorthand(Entries& entries) {
  const auto section = expand_section(entries);
  expand_material(entries);
  expand_poissons_ratio(section, entries);
  expand_amplitude(entries);
  expand_duration(entries);
  expand_friction(entries);
}

}  // namespace stickslip::data
