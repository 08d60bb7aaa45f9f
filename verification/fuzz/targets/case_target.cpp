// SPDX-License-Identifier: MIT
#include <cmath>

#include "memory_file.hpp"
#include "stickslip/data/case_file.hpp"
#include "target.hpp"

namespace stickslip::fuzz {

namespace {

// The values of a case as overrides. Reading the case with them must return the same values.
std::vector<data::Override> overrides_of(const data::Case& problem) {
  const auto number = [](const char* key, double value) {
    std::string text = data::shortest_text(value);
    // TOML distinguishes floats from integers by these.
    if (text.find_first_of(".en") == std::string::npos) text += ".0";  // but "inf" is one
    return data::Override{key, text};
  };
  const auto integer = [](const char* key, int value) { return data::Override{key, std::to_string(value)}; };
  const auto& [name, beam, friction, excitation, numerics, damping, contact, wall] = problem;
  return {number("beam.length", beam.length()),
          number("beam.area", beam.area()),
          number("beam.second_moment_of_area", beam.second_moment_of_area()),
          number("beam.density", beam.density()),
          number("beam.youngs_modulus", beam.youngs_modulus()),
          number("beam.axial_force", beam.axial_force()),
          number("beam.axial_direction", beam.axial_direction()),
          number("beam.shear_stiffness", beam.shear_stiffness()),
          number("friction.static_coefficient", friction.static_coefficient()),
          number("friction.kinetic_coefficient", friction.kinetic_coefficient()),
          number("friction.decay", friction.decay()),
          number("excitation.frequency_hz", excitation.frequency_hz()),
          number("excitation.amplitude", excitation.amplitude()),
          integer("numerics.elements", numerics.elements()),
          number("numerics.time_step", numerics.time_step()),
          number("numerics.spectral_radius", numerics.spectral_radius()),
          number("numerics.velocity_threshold", numerics.velocity_threshold()),
          integer("numerics.modes", numerics.modes()),
          number("excitation.duration", numerics.duration()),
          number("damping.kelvin_voigt", damping.kelvin_voigt()),
          number("damping.ratio", damping.ratio()),
          number("contact.tangential_stiffness", contact.tangential_stiffness()),
          number("contact.regularisation_velocity", contact.regularisation_velocity()),
          number("wall.speed", wall.speed())};
}

void require_the_same_again(const data::Case& problem, MemoryFile& file) {
  const auto overrides = overrides_of(problem);
  const auto again = overrides_of(data::read_case(file.with("# all of it in overrides\n"), overrides));
  for (std::size_t i = 0; i < overrides.size(); ++i)
    if (again[i].value != overrides[i].value)
      throw Violation(overrides[i].key + " = " + overrides[i].value + " is read as " + again[i].value);
}

}  // namespace

void read_case_file(Bytes bytes) {
  static MemoryFile file;
  const auto parts = split(bytes);
  try {
    std::vector<data::Override> overrides;
    for (std::size_t i = 1; i < parts.size(); ++i) overrides.push_back(data::Override::parse(parts[i]));
    require_the_same_again(data::read_case(file.with(parts.front()), overrides), file);
  } catch (const data::InputError& error) {
    require_sentence(error);
  }
}

}  // namespace stickslip::fuzz
