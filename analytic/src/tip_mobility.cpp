// SPDX-License-Identifier: MIT
#include "stickslip/analytic/tip_mobility.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beam_constants.hpp"

namespace stickslip::analytic {
namespace {

using Complex = std::complex<double>;

/// exp(-decay) Φ(q) and exp(-decay) c(q), where decay ≥ Re √q.
struct ScaledFunctions {
  Complex sinh;  // Φ(q) = sinh(√q)/√q
  Complex cosh;  // c(q) = (cosh(√q) - 1)/q
};

ScaledFunctions scaled_functions(Complex q, double decay) {
  const Complex root = std::sqrt(q);
  if (std::abs(root) < 0.5) {  // the series, to round-off
    Complex sinh = 1.0, cosh = 1.0;
    for (int n = 8; n >= 1; --n) {
      sinh = 1.0 + sinh * q / ((2.0 * n) * (2.0 * n + 1.0));
      cosh = 1.0 + cosh * q / ((2.0 * n + 1.0) * (2.0 * n + 2.0));
    }
    return {std::exp(-decay) * sinh, 0.5 * std::exp(-decay) * cosh};
  }
  const Complex growing = std::exp(root - decay), falling = std::exp(-root - decay);
  return {0.5 * (growing - falling) / root, (0.5 * (growing + falling) - std::exp(-decay)) / q};
}

/// The mean over a circle round k of an analytic function of k, which is its value at k, in a form that loses
/// digits near some points. 32 nodes: the functions below are entire of order 1/2, so that what is left is
/// below round-off.
template <class Function>
Complex mean_over_circle(const Function& function, Complex centre, double radius) {
  constexpr int nodes = 32;
  Complex sum = 0.0;
  for (int j = 0; j < nodes; ++j)
    sum += function(centre + std::polar(radius, 2.0 * std::numbers::pi * (j + 0.5) / nodes));
  return sum / static_cast<double>(nodes);
}

/// Both functions at a and at b, times exp(-decay) with the least decay that keeps all from growing.
struct Both {
  double decay;
  ScaledFunctions a, b;
};

Both both(Complex k, Complex z) {
  const Complex a = -z + 2.0 * k, b = -z - 2.0 * k;
  const double decay = std::max(std::sqrt(a).real(), std::sqrt(b).real());
  return {decay, scaled_functions(a, decay), scaled_functions(b, decay)};
}

/// exp(-decay) [Φ(a) - Φ(b)]/(4 k), an even entire function of k.
Complex numerator(Complex k, Complex z, const Both& at) {
  if (std::abs(k) >= 0.5) return (at.a.sinh - at.b.sinh) / (4.0 * k);
  const auto quotient = [&](Complex node) {
    return (scaled_functions(-z + 2.0 * node, at.decay).sinh -
            scaled_functions(-z - 2.0 * node, at.decay).sinh) /
           (4.0 * node);
  };
  return mean_over_circle(quotient, k, 1.0);
}

/// exp(-decay) [1 + (k/2) (c(a) - c(b)) - (χ z/2) (c(a) + c(b))]; fixed_load = χ z.
Complex denominator(Complex k, Complex fixed_load, const Both& at) {
  return std::exp(-at.decay) + 0.5 * (k * (at.a.cosh - at.b.cosh) - fixed_load * (at.a.cosh + at.b.cosh));
}

/// The exponents of exp(±l_i x/L), in the right half plane.
struct Exponents {
  Complex first, second;
};

Exponents exponents(Complex k, Complex z) {
  const Complex sum = std::sqrt(-z + 2.0 * k), difference = std::sqrt(-z - 2.0 * k);
  const auto right = [](Complex l) { return l.real() < 0.0 ? -l : l; };
  return {right(0.5 * (sum + difference)), right(0.5 * (sum - difference))};
}

/// exp(-decay) u(ξ)/[F L³/D] without its denominator, where the exponents are apart:
///
///     [(C_1x - C_2x)(l_1 S_1 - l_2 S_2) - (S_1x/l_1 - S_2x/l_2)(l_1² C_1 - l_2² C_2)]/(l_1² - l_2²)².
Complex deflection(double xi, Complex k, Complex z, double decay) {
  const auto [l1, l2] = exponents(k, z);
  // Products of two waves, times exp(-decay), where decay ≥ Re(l_1 + l_2).
  const auto product = [decay](Complex p, Complex q, double p_sign, double q_sign) {
    return 0.25 * (std::exp(p + q - decay) + q_sign * std::exp(p - q - decay) +
                   p_sign * std::exp(q - p - decay) + p_sign * q_sign * std::exp(-p - q - decay));
  };
  const auto cosh_sinh = [&](Complex p, Complex q) { return product(p, q, 1.0, -1.0); };
  const auto sinh_cosh = [&](Complex p, Complex q) { return product(p, q, -1.0, 1.0); };
  const auto sinh = [decay](Complex p) { return 0.5 * (std::exp(p - decay) - std::exp(-p - decay)); };
  const Complex x1 = l1 * xi, x2 = l2 * xi;
  // Of the products with the same exponent twice, which would grow as exp(l (1 + ξ)), sinh(l (1 - ξ)) is
  // left.
  const Complex alike = l1 * sinh(l1 - x1) + l2 * sinh(l2 - x2);
  const Complex mixed = l2 * l2 / l1 * sinh_cosh(x1, l2) - l2 * cosh_sinh(x1, l2) +
                        l1 * l1 / l2 * sinh_cosh(x2, l1) - l1 * cosh_sinh(x2, l1);
  const Complex difference = l1 * l1 - l2 * l2;
  return (alike + mixed) / (difference * difference);
}

}  // namespace

TipMobility::TipMobility(const data::Beam& beam, const data::Damping& damping)
    : beam_(beam), kelvin_voigt_(damping.kelvin_voigt()) {
  require_rigid_in_shear(beam);
  require_kelvin_voigt(damping);
}

struct TipMobility::Scaled {
  Complex rigidity;   // D
  Complex frequency;  // k
  Complex load;       // z
};

TipMobility::Scaled TipMobility::scaled(Complex s) const {
  const double length = beam_.length();
  const Complex rigidity = bending_stiffness(beam_) * (1.0 + kelvin_voigt_ * s);
  return {rigidity, s * length * length * std::sqrt(mass_per_length(beam_) / rigidity),
          beam_.axial_force() * length * length / rigidity};
}

Complex TipMobility::operator()(Complex s) const {
  const auto [rigidity, k, z] = scaled(s);
  const double length = beam_.length();
  const Both at = both(k, z);
  return s * length * length * length / rigidity * 2.0 * numerator(k, z, at) /
         denominator(k, beam_.axial_direction() * z, at);
}

Complex TipMobility::transfer(double x, Complex s) const {
  const auto [rigidity, k, z] = scaled(s);
  const double length = beam_.length();
  const Both at = both(k, z);
  const double xi = x / length;
  // The exponents meet at k = ±z/2, and both vanish with k and z.
  const bool close = std::abs(z * z - 4.0 * k * k) < 1.0 || std::abs(k) < 0.5;
  const auto value = [&, load = z](Complex node) { return deflection(xi, node, load, at.decay); };
  const Complex shape = close ? mean_over_circle(value, k, std::abs(z) < 4.0 ? 6.0 : 1.0) : value(k);
  return s * length * length * length / rigidity * shape / denominator(k, beam_.axial_direction() * z, at);
}

}  // namespace stickslip::analytic
