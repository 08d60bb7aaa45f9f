// SPDX-License-Identifier: MIT
#include "stickslip/analytic/damped_steady_state.hpp"

#include <cmath>
#include <numbers>

#include "beam_constants.hpp"
#include "special_functions.hpp"

namespace stickslip::analytic {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

struct Exponents {
  Complex b, c;
};

Complex in_right_half_plane(Complex r) { return r.real() < 0.0 ? -r : r; }

/// b and c, the larger one first and the other from b² c² = -s², so that neither loses digits. Nothing
/// cancels in the larger one: z and the root differ in argument by less than a right angle.
Exponents exponents(Complex z, Complex s_squared) {
  const Complex root = std::sqrt(0.25 * z * z + s_squared);
  const bool compressed = z.real() > 0.0;
  const Complex larger_squared = compressed ? -(0.5 * z + root) : root - 0.5 * z;
  const Complex larger = in_right_half_plane(std::sqrt(larger_squared));
  const Complex smaller = in_right_half_plane(std::sqrt(-s_squared / larger_squared));
  return compressed ? Exponents{smaller, larger} : Exponents{larger, smaller};
}

/// Weights of exp(-r ξ) and exp(-r (1 - ξ)), ξ = x/L.
struct Weights {
  Complex from_clamp, from_tip;
};

/// With the tip held, Y ~ q cosh(q) sinh(r η) - r cosh(r) sinh(q η), η = 1 - ξ: its curvature vanishes
/// with it at the tip, its slope at the clamp. The share of r = ±b here, q = c being the other exponent;
/// that of c has the opposite sign. Times 4 exp(-b - c).
Weights held_tip(Complex r, Complex q) {
  const Complex factor = q * (1.0 + std::exp(-2.0 * q));
  return {factor, -std::exp(-r) * factor};
}

/// With a free tip and y = χ z, Y ~ ((c² + y)/b²) cosh(b ξ) - ((b² + y)/b²) cosh(b η) cosh(c) +
/// ((c² + y)/(b c)) sinh(b η) sinh(c) and the same with b and c exchanged: cosh(r η)/r² and
/// sinh(r η)/(r (r² + y)) of both exponents, subtracted, have neither curvature nor force at the tip, and their
/// combination without slope at the clamp is this one. The share of r, times 4 exp(-b - c).
Weights free_tip(Complex r, Complex q, Complex y) {
  const Complex at_tip = std::exp(-r), other = std::exp(-q), ratio = q / r, shift = y / (r * r);
  const Complex cosh = (1.0 + shift) * (1.0 + other * other);
  const Complex sinh = (ratio + shift / ratio) * (1.0 - other * other);
  const Complex near = 2.0 * (ratio * ratio + shift) * other;
  return {near * at_tip - cosh + sinh, near - at_tip * (cosh + sinh)};
}

/// int_0¹ exp(-r ξ - q (1 - ξ)) d(ξ).
Complex mean_of_exponential(Complex r, Complex q) { return exponential_difference(-q, -r, 1.0); }

}  // namespace

DampedSteadyState::DampedSteadyState(const data::Beam& beam, const data::HarmonicExcitation& excitation,
                                     const data::Damping& damping, TipSupport tip)
    : beam_(beam), length_(beam.length()) {
  require_rigid_in_shear(beam);
  require_kelvin_voigt(damping);
  const double omega = 2.0 * pi * excitation.frequency_hz();
  const double loss_factor = omega * damping.kelvin_voigt();
  loss_ = pi * loss_factor * bending_stiffness(beam);
  rigidity_ = bending_stiffness(beam) * Complex(1.0, loss_factor);

  const double length_squared = length_ * length_;
  const double inertia = mass_per_length(beam) * omega * omega * length_squared * length_squared;
  const Complex z = beam.axial_force() * length_squared / rigidity_, y = beam.axial_direction() * z;
  const auto [b, c] = exponents(z, inertia / rigidity_);
  const bool held = tip == TipSupport::held;
  const Weights of_b = held ? held_tip(b, c) : free_tip(b, c, y);
  const Weights of_c = held ? held_tip(c, b) : free_tip(c, b, y);
  const double sign = held ? -1.0 : 1.0;
  waves_ = {BoundaryWave{b, of_b.from_clamp, true}, BoundaryWave{b, of_b.from_tip, false},
            BoundaryWave{c, sign * of_c.from_clamp, true}, BoundaryWave{c, sign * of_c.from_tip, false}};
  const Complex at_clamp = displacement(0.0);
  for (BoundaryWave& wave : waves_) wave.weight *= excitation.amplitude() / at_clamp;
}

Complex DampedSteadyState::derivative(int order, double x) const {
  const double xi = x / length_;
  Complex sum = 0.0;
  for (const BoundaryWave& wave : waves_) {
    const Complex exponent = wave.from_clamp ? -wave.exponent : wave.exponent;
    const double distance = wave.from_clamp ? xi : 1.0 - xi;
    sum += wave.weight * std::pow(exponent / length_, order) * std::exp(-wave.exponent * distance);
  }
  return sum;
}

Complex DampedSteadyState::friction_force() const {
  return tip_reaction(beam_, rigidity_ * derivative(3, length_), derivative(1, length_));
}

double DampedSteadyState::dissipated_energy() const {
  double integral = 0.0;  // of |L² Y''|² over x/L
  for (const BoundaryWave& left : waves_)
    for (const BoundaryWave& right : waves_) {
      const Complex r = left.exponent, q = std::conj(right.exponent);
      const Complex mean =
          left.from_clamp == right.from_clamp ? mean_of_exponential(r + q, 0.0) : mean_of_exponential(r, q);
      integral += (left.weight * r * r * std::conj(right.weight) * q * q * mean).real();
    }
  return loss_ * integral / (length_ * length_ * length_);
}

}  // namespace stickslip::analytic
