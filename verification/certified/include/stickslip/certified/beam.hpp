// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "stickslip/certified/real.hpp"

namespace stickslip::certified {

/// The exact data of a uniform beam, in SI units.
struct BeamData {
  Rational length;                 ///< L, m, > 0
  Rational area;                   ///< A, m², > 0
  Rational second_moment_of_area;  ///< I, m⁴, > 0
  Rational density;                ///< ρ, kg/m³, > 0
  Rational youngs_modulus;         ///< E, Pa, > 0
  Rational axial_force;            ///< P, N, compression positive
};

/// A uniform beam. Its derived quantities are evaluated at the current precision.
class Beam {
 public:
  /// Throws std::invalid_argument, naming the field, unless all but axial_force are positive.
  explicit Beam(const BeamData& data);

  [[nodiscard]] const BeamData& data() const noexcept { return data_; }
  [[nodiscard]] Real length() const { return data_.length; }            ///< L, m
  [[nodiscard]] Real axial_force() const { return data_.axial_force; }  ///< P, N
  [[nodiscard]] Real bending_stiffness() const;                         ///< EI, N m²
  [[nodiscard]] Real mass_per_length() const;                           ///< ρ A, kg/m
  [[nodiscard]] Real load_factor() const;                               ///< z = P L²/EI
  /// ω L² √(ρ A/EI) = 1, as an angular frequency, rad/s.
  [[nodiscard]] Real frequency_unit() const;

 private:
  BeamData data_;
};

/// The buckling factor z_cr = P_cr L²/EI of the clamped-pinned beam: the square of the first positive root
/// of tan y = y.
[[nodiscard]] Real buckling_factor();

/// The buckling load P_cr = z_cr EI/L², N.
[[nodiscard]] Real buckling_load(const Beam& beam);

/// The message "<field> is <value>; it must be <allowed>.", with the value as the shortest decimal of its
/// double.
[[nodiscard]] std::string error_message(std::string_view field, const Rational& value,
                                        std::string_view allowed);

}  // namespace stickslip::certified
