#include "stickslip/analytic/tip_mobility.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "beam_constants.hpp"
#include "messages.hpp"

namespace stickslip::analytic {
namespace {

using Complex = std::complex<double>;

/// sqrt(q) in the right half plane: a length that exponentials decay over.
Complex decaying_root(Complex q) { return std::sqrt(q); }

/// exp(-decay) Phi(q), Phi(q) = sinh(sqrt q)/sqrt q, with decay >= Re sqrt q.
Complex scaled_sinh(Complex q, double decay) {
  const Complex root = decaying_root(q);
  if (std::abs(root) < 0.5) {  // the series, to round-off
    Complex sum = 1.0;
    for (int n = 8; n >= 1; --n) sum = 1.0 + sum * q / ((2.0 * n) * (2.0 * n + 1.0));
    return std::exp(-decay) * sum;
  }
  return 0.5 * (std::exp(root - decay) - std::exp(-root - decay)) / root;
}

/// exp(-decay) c(q), c(q) = (cosh(sqrt q) - 1)/q.
Complex scaled_cosh(Complex q, double decay) {
  const Complex half = scaled_sinh(0.25 * q, 0.5 * decay);
  return 0.5 * half * half;
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

/// The least factor by which all that follows is scaled: the larger of Re sqrt a and Re sqrt b.
double decay_of(Complex k, Complex z) {
  return std::max(decaying_root(-z + 2.0 * k).real(), decaying_root(-z - 2.0 * k).real());
}

/// exp(-decay) [Phi(a) - Phi(b)]/(4 k), an even entire function of k.
Complex numerator(Complex k, Complex z, double decay) {
  const auto quotient = [&](Complex at) {
    return (scaled_sinh(-z + 2.0 * at, decay) - scaled_sinh(-z - 2.0 * at, decay)) / (4.0 * at);
  };
  return std::abs(k) < 0.5 ? mean_over_circle(quotient, k, 1.0) : quotient(k);
}

/// exp(-decay) [1 + (k/2) (c(a) - c(b))].
Complex denominator(Complex k, Complex z, double decay) {
  return std::exp(-decay) + 0.5 * k * (scaled_cosh(-z + 2.0 * k, decay) - scaled_cosh(-z - 2.0 * k, decay));
}

/// The exponents of exp(+-l_i x/L), in the right half plane.
struct Exponents {
  Complex first, second;
};

Exponents exponents(Complex k, Complex z) {
  const Complex sum = decaying_root(-z + 2.0 * k), difference = decaying_root(-z - 2.0 * k);
  const auto right = [](Complex l) { return l.real() < 0.0 ? -l : l; };
  return {right(0.5 * (sum + difference)), right(0.5 * (sum - difference))};
}

/// exp(-decay) u(xi)/[F L^3/D] without its denominator, where the exponents are apart:
///
///     [(C_1x - C_2x)(l_1 S_1 - l_2 S_2) - (S_1x/l_1 - S_2x/l_2)(l_1^2 C_1 - l_2^2 C_2)]/(l_1^2 - l_2^2)^2.
Complex deflection(double xi, Complex k, Complex z, double decay) {
  const auto [l1, l2] = exponents(k, z);
  // Products of two waves, times exp(-decay), where decay >= Re(l_1 + l_2).
  const auto product = [decay](Complex p, Complex q, double p_sign, double q_sign) {
    return 0.25 * (std::exp(p + q - decay) + q_sign * std::exp(p - q - decay) +
                   p_sign * std::exp(q - p - decay) + p_sign * q_sign * std::exp(-p - q - decay));
  };
  const auto cosh_sinh = [&](Complex p, Complex q) { return product(p, q, 1.0, -1.0); };
  const auto sinh_cosh = [&](Complex p, Complex q) { return product(p, q, -1.0, 1.0); };
  const auto sinh = [decay](Complex p) { return 0.5 * (std::exp(p - decay) - std::exp(-p - decay)); };
  const Complex x1 = l1 * xi, x2 = l2 * xi;
  // Of the products with the same exponent twice, which would grow as exp(l (1 + xi)), sinh(l (1 - xi)) is
  // left.
  const Complex alike = l1 * sinh(l1 - x1) + l2 * sinh(l2 - x2);
  const Complex mixed = l2 * l2 / l1 * sinh_cosh(x1, l2) - l2 * cosh_sinh(x1, l2) +
                        l1 * l1 / l2 * sinh_cosh(x2, l1) - l1 * cosh_sinh(x2, l1);
  const Complex difference = l1 * l1 - l2 * l2;
  return (alike + mixed) / (difference * difference);
}

}  // namespace

TipMobility::TipMobility(const data::Beam& beam, const data::Damping& damping)
    : length_(beam.length()),
      bending_stiffness_(analytic::bending_stiffness(beam)),
      mass_per_length_(analytic::mass_per_length(beam)),
      axial_force_(beam.axial_force()),
      kelvin_voigt_(damping.kelvin_voigt()) {
  if (damping.ratio() != 0.0)
    throw std::invalid_argument(
        refusal("damping.ratio", damping.ratio(), "0: the closed form knows Kelvin-Voigt damping alone"));
}

TipMobility::Scaled TipMobility::scaled(Complex s) const {
  const Complex rigidity = bending_stiffness_ * (1.0 + kelvin_voigt_ * s);
  return {rigidity, s * length_ * length_ * std::sqrt(mass_per_length_ / rigidity),
          axial_force_ * length_ * length_ / rigidity};
}

Complex TipMobility::operator()(Complex s) const {
  const auto [rigidity, k, z] = scaled(s);
  const double decay = decay_of(k, z);
  return s * length_ * length_ * length_ / rigidity * 2.0 * numerator(k, z, decay) / denominator(k, z, decay);
}

Complex TipMobility::transfer(double x, Complex s) const {
  const auto [rigidity, k, z] = scaled(s);
  const double decay = decay_of(k, z), xi = x / length_;
  // The exponents meet at k = +-z/2, and both vanish with k and z.
  const bool close = std::abs(z * z - 4.0 * k * k) < 1.0 || std::abs(k) < 0.5;
  const auto value = [&, load = z](Complex at) { return deflection(xi, at, load, decay); };
  const Complex shape = close ? mean_over_circle(value, k, std::abs(z) < 4.0 ? 6.0 : 1.0) : value(k);
  return s * length_ * length_ * length_ / rigidity * shape / denominator(k, z, decay);
}

}  // namespace stickslip::analytic
