// SPDX-License-Identifier: MIT
#include "stickslip/certified/slip_modes.hpp"

#include <stdexcept>

#include "stickslip/certified/roots.hpp"
#include "wave_numbers.hpp"

namespace stickslip::certified {
namespace {

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

std::vector<SlipFrequency> slip_frequencies(const Beam& beam, int count) {
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
  const std::vector<Real> roots =
      isolate_roots(function, sign == 0 ? 1 : 0, (last * sqrt(pow(last, 2) - z)).midpoint());
  if (roots.size() != 2 * static_cast<std::size_t>(pairs))
    throw std::domain_error(error_message("beam.axial_force", beam.data().axial_force,
                                          "such that the slip frequencies are real; of the first " +
                                              std::to_string(2 * pairs) + " only " +
                                              std::to_string(roots.size()) + " are"));

  std::vector<SlipFrequency> frequencies;
  for (int n = 1; n <= count; ++n) {
    const Real omega = roots[static_cast<std::size_t>(n) - 1] * beam.frequency_unit();
    frequencies.push_back({n, omega, omega / (2 * pi())});
  }
  return frequencies;
}

}  // namespace stickslip::certified
