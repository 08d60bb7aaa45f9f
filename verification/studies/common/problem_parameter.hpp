#pragma once

#include <array>
#include <string_view>

#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// A number of a case that a map or a design may vary.
enum class Parameter { frequency, amplitude, length, axial_force, youngs_modulus, static_coefficient };

inline constexpr std::array all_parameters{Parameter::frequency,      Parameter::amplitude,
                                           Parameter::length,         Parameter::axial_force,
                                           Parameter::youngs_modulus, Parameter::static_coefficient};

/// The field of a case file that the parameter is, as "beam.length".
[[nodiscard]] std::string_view field_of(Parameter parameter);

[[nodiscard]] double value_of(const data::Case& problem, Parameter parameter);

/// The case with another value there, and the section of the beam as it is. A static coefficient below the
/// kinetic one takes that down with it. Throws data::FieldError for a value that the field refuses.
[[nodiscard]] data::Case with_value(const data::Case& problem, Parameter parameter, double value);

/// Omega, rad/s.
[[nodiscard]] double angular_frequency(const data::HarmonicExcitation& excitation);

/// Whether the case has damping of either kind.
[[nodiscard]] bool is_damped(const data::Case& problem);

/// Throws data::FieldError if the static coefficient is 0: a force ratio or a margin needs one.
void require_friction(const data::Case& problem);

}  // namespace stickslip::studies
