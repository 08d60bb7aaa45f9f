// SPDX-License-Identifier: MIT
#include "stickslip/certified/beam.hpp"

#include <array>
#include <charconv>
#include <stdexcept>
#include <utility>

#include "stickslip/certified/roots.hpp"

namespace stickslip::certified {

Beam::Beam(const BeamData& data) : data_(data) {
  for (const auto& [field, value] : {std::pair{"beam.length", &data_.length},
                                     {"beam.area", &data_.area},
                                     {"beam.second_moment_of_area", &data_.second_moment_of_area},
                                     {"beam.density", &data_.density},
                                     {"beam.youngs_modulus", &data_.youngs_modulus}})
    if (value->sign() <= 0) throw std::invalid_argument(error_message(field, *value, "positive"));
}

Real Beam::bending_stiffness() const { return Real(data_.youngs_modulus) * data_.second_moment_of_area; }

Real Beam::mass_per_length() const { return Real(data_.density) * data_.area; }

Real Beam::load_factor() const { return axial_force() * pow(length(), 2) / bending_stiffness(); }

Real Beam::frequency_unit() const { return sqrt(bending_stiffness() / mass_per_length()) / pow(length(), 2); }

Real buckling_factor() {
  // sin y - y cos y is y^3/3 near 0. Its derivative y sin y first changes sign at pi, so there is no root up
  // to pi. The function is positive at 3 and negative at 5.
  const auto function = [](const Real& y) {
    const Dual<Real> x{y, 1};
    return sin(x) - x * cos(x);
  };
  return pow(isolate_root(function, 3, 5), 2);
}

Real buckling_load(const Beam& beam) {
  return buckling_factor() * beam.bending_stiffness() / pow(beam.length(), 2);
}

std::string error_message(std::string_view field, const Rational& value, std::string_view allowed) {
  std::array<char, 32> shortest{};
  const auto end =
      std::to_chars(shortest.data(), shortest.data() + shortest.size(), value.approximately()).ptr;
  return std::string(field) + " is " + std::string(shortest.data(), end) + "; it must be " +
         std::string(allowed) + ".";
}

}  // namespace stickslip::certified
