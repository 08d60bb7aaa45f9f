// SPDX-License-Identifier: MIT
#include "stickslip/certified/stick_modes.hpp"

#include <stdexcept>

#include "stickslip/certified/roots.hpp"

namespace stickslip::certified {

namespace {

// The dimensionless wave numbers b = β L and bb = betabar L.
template <class T>
struct WaveNumbers {
  T hyperbolic, trigonometric;
};

// Both wave numbers at κ = ω L² √(ρ A/EI): b² = -z/2 + s, bb² = z/2 + s, s = √(z²/4 +
// κ²).
template <class T>
WaveNumbers<T> wave_numbers(const T& kappa, const T& load_factor) {
  const T half = load_factor / 2;
  const T s = sqrt(half * half + kappa * kappa);
  return {sqrt(s - half), sqrt(s + half)};
}

void require_below_buckling(const Beam& beam) {
  if (beam.axial_force() < buckling_load(beam)) return;
  throw std::domain_error(error_message("beam.axial_force", beam.data().axial_force,
                                        "below the buckling load of the stick state, " +
                                            enclosure(buckling_load(beam), 17).value +
                                            " N, by more than the radius of the precision"));
}

/// Eq. (23) multiplied by its denominators, over kappa = omega L^2 sqrt(rho A/EI).
Dual<Real> characteristic(const Real& kappa, const Real& load_factor) {
  const auto [b, bb] = wave_numbers(Dual<Real>(kappa, 1), Dual<Real>(load_factor));
  return b * sin(bb) * cosh(b) - bb * cos(bb) * sinh(b);
}

/// An exact number below the lower bound of the first frequency that stick_modes.hpp gives.
Real below_first_frequency(const Beam& beam) {
  const Real share = beam.data().axial_force.sign() > 0 ? beam.axial_force() / buckling_load(beam) : Real(0);
  return (pow(pi(), 2) * sqrt(1 - share) * 15 / 16).lower();
}

/// The function phi = c C(x) + s D(x) that satisfies phi'' = mu phi, with its first three derivatives.
Derivatives part(const Real& value, const Real& slope, const Real& mu) {
  return {value, slope, mu * value, mu * slope};
}

/// An antiderivative of phi w at one x, for phi'' = mu phi and w'''' = -p w'':
///
///     int phi w = [phi' w - phi w' + int phi w'']/mu,   int phi w'' = [phi' w'' - phi w''']/(mu + p).
Real antiderivative(const Derivatives& phi, const Derivatives& w, const Real& mu, const Real& p) {
  return (phi[1] * w[0] - phi[0] * w[1] + (phi[1] * w[2] - phi[0] * w[3]) / (mu + p)) / mu;
}

/// An antiderivative of phi^2 at one x, for phi'' = mu phi. Since phi'^2 - mu phi^2 is constant,
///
///     int phi^2 = [phi phi' - x (phi'^2 - mu phi^2)]/(2 mu).
Real antiderivative_of_square(const Derivatives& phi, const Real& mu, const Real& x) {
  return (phi[0] * phi[1] - x * (pow(phi[1], 2) - mu * pow(phi[0], 2))) / (2 * mu);
}

/// The hyperbolic and the trigonometric part of a mode, U = phi + psi.
struct Parts {
  Real mu, nu;  ///< phi'' = mu phi, psi'' = nu psi
  Derivatives phi, psi;
};

Parts parts(const StickMode& mode, const Real& x) {
  const Real &beta = mode.hyperbolic_wave_number, &betabar = mode.trigonometric_wave_number;
  const Real &r = mode.shape_ratio, mu = pow(beta, 2), nu = -pow(betabar, 2);
  const Real ch = cosh(beta * x), sh = sinh(beta * x), c = cos(betabar * x), s = sin(betabar * x);
  return {mu, nu, part(ch - r * betabar * sh, beta * (sh - r * betabar * ch), mu),
          part(-c + r * beta * s, betabar * (s + r * beta * c), nu)};
}

/// Antiderivatives of U^2 and of U (1 + S) at one x; int phi psi = (phi' psi - phi psi')/(mu - nu).
struct Integrals {
  Real of_square, of_load;
};

Integrals integrals(const Beam& beam, const QuasiStaticShape& quasi_static, const StickMode& mode,
                    const Real& x) {
  const auto [mu, nu, phi, psi] = parts(mode, x);
  const Real p = beam.axial_force() / beam.bending_stiffness();
  Derivatives w = quasi_static.at(x);
  w[0] += 1;
  return {antiderivative_of_square(phi, mu, x) + antiderivative_of_square(psi, nu, x) +
              2 * (phi[1] * psi[0] - phi[0] * psi[1]) / (mu - nu),
          antiderivative(phi, w, mu, p) + antiderivative(psi, w, nu, p)};
}

StickMode mode_at(const Beam& beam, const QuasiStaticShape& quasi_static, int number, const Real& kappa) {
  const Real length = beam.length();
  const auto [b, bb] = wave_numbers(kappa, beam.load_factor());
  StickMode mode;
  mode.number = number;
  mode.angular_frequency = kappa * beam.frequency_unit();
  mode.frequency_hz = mode.angular_frequency / (2 * pi());
  mode.hyperbolic_wave_number = b / length;
  mode.trigonometric_wave_number = bb / length;
  mode.shape_ratio = length * (cosh(b) - cos(bb)) / (bb * sinh(b) - b * sin(bb));
  const Integrals at_tip = integrals(beam, quasi_static, mode, length),
                  at_base = integrals(beam, quasi_static, mode, 0);
  mode.participation = -(at_tip.of_load - at_base.of_load) / (at_tip.of_square - at_base.of_square);
  return mode;
}

template <class T>
T characteristic(const T& kappa, const T& load_factor, const WaveNumbers<T>& wave_numbers) {
  const auto& [b, bb] = wave_numbers;
  return load_factor * load_factor + 2 * kappa * kappa * (1 + cosh(b) * cos(bb)) +
         load_factor * kappa * sinh(b) * sin(bb);
}

/// Like wave_numbers(), but the smaller one is computed as kappa over the larger one, so that the ball may
/// contain kappa = 0.
WaveNumbers<Dual<Real>> wave_numbers_down_to_zero(const Dual<Real>& kappa, const Dual<Real>& load_factor,
                                                  int sign) {
  const Dual<Real> half = load_factor / 2, s = sqrt(half * half + kappa * kappa);
  const Dual<Real> larger = sqrt(s + sign * half), smaller = kappa / larger;
  return sign > 0 ? WaveNumbers<Dual<Real>>{smaller, larger} : WaveNumbers<Dual<Real>>{larger, smaller};
}

/// The two unknowns of the flutter load, or a Newton step of both.
struct FlutterPoint {
  Real kappa, load_factor;
};

/// The interval Newton step J(box)^-1 G(middle) for G = (F, dF/dkappa), which is subtracted from `middle`.
FlutterPoint newton_step(const FlutterPoint& box, const FlutterPoint& middle) {
  using Second = Dual<Dual<Real>>;  // inner slope: by kappa; outer slope: by kappa or by the load
  const auto derivatives = [](const FlutterPoint& at, int outer_kappa, int outer_load) {
    const Second kappa({at.kappa, 1}, Dual<Real>(outer_kappa)),
        z(Dual<Real>(at.load_factor), Dual<Real>(outer_load));
    return characteristic(kappa, z, wave_numbers(kappa, z));
  };
  const Second value = derivatives(middle, 1, 0);
  const Second by_kappa = derivatives(box, 1, 0), by_load = derivatives(box, 0, 1);
  const Real &f = value.value.value, &g = value.value.slope;
  const Real &f_kappa = by_kappa.value.slope, &g_kappa = by_kappa.slope.slope;
  const Real &f_load = by_load.slope.value, &g_load = by_load.slope.slope;
  const Real determinant = f_kappa * g_load - f_load * g_kappa;
  return {(g_load * f - f_load * g) / determinant, (f_kappa * g - g_kappa * f) / determinant};
}

Real ball(const char* middle, const char* radius) {
  const Real m = Rational(middle), r = Rational(radius);
  return hull(m - r, m + r);
}

}  // namespace

QuasiStaticShape::QuasiStaticShape(const Beam& beam)
    : sign_(beam.data().axial_force.sign()),
      length_(beam.length()),
      sigma_(sqrt(abs(beam.axial_force()) / beam.bending_stiffness())) {
  require_below_buckling(beam);
}

Derivatives QuasiStaticShape::at(const Real& x) const {
  const Real rest = length_ - x;
  if (sign_ == 0) {
    const Real cube = 2 * pow(length_, 3);
    return {-(3 * length_ - x) * pow(x, 2) / cube, -3 * (2 * length_ - x) * x / cube, -6 * rest / cube,
            6 / cube};
  }
  const auto sine = [this](const Real& y) { return sign_ > 0 ? sin(y) : sinh(y); };
  const auto cosine = [this](const Real& y) { return sign_ > 0 ? cos(y) : cosh(y); };
  const Real y = sigma_ * length_, denominator = y * cosine(y) - sine(y);
  const Real s = sine(sigma_ * rest), c = cosine(sigma_ * rest), square = sign_ * pow(sigma_, 2);
  return {(-sigma_ * x * cosine(y) + sine(y) - s) / denominator, sigma_ * (c - cosine(y)) / denominator,
          square * s / denominator, -square * sigma_ * c / denominator};
}

Derivatives StickMode::shape(const Real& x) const {
  const auto [mu, nu, phi, psi] = parts(*this, x);
  return {phi[0] + psi[0], phi[1] + psi[1], phi[2] + psi[2], phi[3] + psi[3]};
}

std::vector<StickMode> stick_modes(const Beam& beam, int count) {
  if (count < 1 || count > 1000)
    throw std::invalid_argument("numerics.modes is " + std::to_string(count) + "; it must be 1 ... 1000.");
  const QuasiStaticShape quasi_static(beam);
  const Real z = beam.load_factor();
  // At bb = (count + 1/2) pi the cosine vanishes and the sine does not.
  const Real last = (count + Real(0.5)) * pi();
  const Real above = (last * sqrt(pow(last, 2) - z)).midpoint();
  const std::vector<Real> roots = isolate_roots([&](const Real& kappa) { return characteristic(kappa, z); },
                                                below_first_frequency(beam), above);
  if (roots.size() < static_cast<std::size_t>(count))
    throw std::logic_error(std::to_string(roots.size()) +
                           " stick modes were found in the expected range instead of " +
                           std::to_string(count) + ".");
  std::vector<StickMode> modes;
  for (int n = 1; n <= count; ++n)
    modes.push_back(mode_at(beam, quasi_static, n, roots[static_cast<std::size_t>(n) - 1]));
  return modes;
}

Real flutter_factor() {
  FlutterPoint box{ball("11.0155", "1e-3"), ball("20.0510", "1e-3")};
  for (bool is_proven = false;;) {
    const FlutterPoint middle{box.kappa.midpoint(), box.load_factor.midpoint()};
    const FlutterPoint step = newton_step(box, middle);
    const FlutterPoint next{middle.kappa - step.kappa, middle.load_factor - step.load_factor};
    // A box that is mapped into itself contains exactly one solution.
    is_proven = is_proven || (box.kappa.contains(next.kappa) && box.load_factor.contains(next.load_factor));
    if (!is_proven) throw std::logic_error("The initial box of the flutter load is not confirmed.");
    const Real load_factor = intersection(next.load_factor, box.load_factor);
    if (!(load_factor.radius() * 2 < box.load_factor.radius())) return load_factor;
    box = {intersection(next.kappa, box.kappa), load_factor};
  }
}

std::vector<Real> slip_frequencies(const Beam& beam, int count) {
  if (count < 1 || count > 1000)
    throw std::invalid_argument("numerics.modes is " + std::to_string(count) + "; it must be 1 ... 1000.");
  const Real z = beam.load_factor(), flutter = flutter_factor();
  if (!(z < flutter)) {
    const Real load = flutter * beam.bending_stiffness() / pow(beam.length(), 2);
    throw std::domain_error(
        error_message("beam.axial_force", beam.data().axial_force,
                      "below the flutter load of the slip state, " + enclosure(load, 17).value +
                          " N, by more than the radius of the precision; beyond it the two "
                          "lowest frequencies are complex"));
  }

  const int sign = beam.data().axial_force.sign(), pairs = (count + 1) / 2;
  // Without axial force the left side has a root at 0. There is no other root up to b = bb = 1, where cos(bb)
  // > 0.
  const auto function = [&](const Real& kappa) {
    const Dual<Real> x{kappa, 1}, load(z);
    return characteristic(x, load,
                          sign == 0 ? wave_numbers(x, load) : wave_numbers_down_to_zero(x, load, sign));
  };
  const Real last = 2 * pairs * pi();
  std::vector<Real> frequencies =
      isolate_roots(function, sign == 0 ? 1 : 0, (last * sqrt(pow(last, 2) - z)).midpoint());
  if (frequencies.size() != 2 * static_cast<std::size_t>(pairs))
    throw std::domain_error(error_message("beam.axial_force", beam.data().axial_force,
                                          "such that the slip frequencies are real; of the first " +
                                              std::to_string(2 * pairs) + " only " +
                                              std::to_string(frequencies.size()) + " are"));

  frequencies.resize(static_cast<std::size_t>(count));
  for (Real& frequency : frequencies) frequency *= beam.frequency_unit();
  return frequencies;
}

}  // namespace stickslip::certified
