// SPDX-License-Identifier: MIT
/// The natural frequencies of Timoshenko beams, by the equations of analytic/timoshenko_modes.hpp in ball arithmetic.

#include <fmt/format.h>

#include <stdexcept>

#include "sets.hpp"
#include "stickslip/certified/roots.hpp"

namespace stickslip::reference {

using certified::Dual;
using certified::Rational;
using certified::Real;

namespace {

constexpr int timoshenko_modes = 10;
constexpr long timoshenko_bits = 384;

struct TimoshenkoBeam {
  Real r2, s2;  // r^2, s^2
  bool is_held{};

  template <class T>
  [[nodiscard]] T squared_frequency(const T& n) const {
    const T n2 = n * n, sum = r2 + s2, difference = r2 - s2;
    return 2 * n2 * n2 / (1 + sum * n2 + sqrt(1 + 2 * sum * n2 + difference * difference * n2 * n2));
  }

  [[nodiscard]] Dual<Real> equation(const Real& at) const {
    const Dual<Real> n{at, 1}, b = squared_frequency(n), m = sqrt(b * (1 - b * Dual<Real>(r2 * s2))) / n;
    const Dual<Real> a = m * m + b * Dual<Real>(s2), c = b / a;
    if (is_held) return a * sin(n) * cosh(m) - c * m / n * cos(n) * sinh(m);
    return 2 + (a / c + c / a) * cosh(m) * cos(n) + (m / n - n / m) * sinh(m) * sin(n);
  }
};

DataSet timoshenko_frequencies(bool is_held) {
  const std::string tip = is_held ? "held" : "free", state = is_held ? "stick" : "slip";
  DataSet set = data_set(fmt::format("timoshenko-{}-frequencies", state),
                         fmt::format("frequencies/timoshenko-{}.csv", state),
                         fmt::format("Natural frequencies of Timoshenko beams, tip {}", tip),
                         fmt::format("Clamped-{} beams with rotary inertia and shear, shear coefficient 5/6 "
                                     "and Poisson's ratio 0.3, so that G = E/2.6, without axial force.",
                                     is_held ? "pinned" : "free"));
  data::Resource& resource = set.resource;
  set_key(resource, {beam_column(), mode_column()});
  add_values(resource, ValueClass::enclosed, {{"frequency", "Hz", "omega_n/(2 pi)", Norm::relative, 1e-6}});
  resource.foreign_keys = {beam_key()};
  resource.problem =
      fmt::format(R"({{"beam": {}, "axial_force": 0, "tip": "{}", "damping": {{"kelvin_voigt": 0}}, )"
                  R"("shear_coefficient": 0.8333333333333334, "poisson_ratio": 0.3}})",
                  in_column("beam"), tip);
  resource.provenance = enclosed_by("every root of the frequency equation is isolated",
                                    fmt::format(R"({{"bits": {}, "digits": 30}})", timoshenko_bits),
                                    {"a spectral Ritz method has the same ones below the cut-off frequency",
                                     "without rotary inertia and shear those of Euler and Bernoulli"});
  const certified::PrecisionScope scope(timoshenko_bits);
  for (const char* name : {"paper", "steel-strip"}) {
    const NamedBeam named = named_beam(name);
    const certified::BeamData& data = named.beam.data();
    const Real r2 = Real(data.second_moment_of_area) / (Real(data.area) * pow(named.beam.length(), 2));
    const TimoshenkoBeam beam{r2, r2 * Real(Rational("3.12")), is_held};  // E/(k G) = 2 (1 + 0.3) 6/5
    const Real upper = certified::pi() * (is_held ? 2 * timoshenko_modes + 1 : 2 * timoshenko_modes) / 2;
    const auto roots =
        certified::isolate_roots([&](const Real& n) { return beam.equation(n); }, Real(1), upper.midpoint());
    if (roots.size() != timoshenko_modes) throw std::runtime_error("a mode of a Timoshenko beam is missing");
    for (int mode = 1; mode <= timoshenko_modes; ++mode)
      add_row(set, {name, mode,
                    enclosed(named.beam.frequency_unit() *
                             sqrt(beam.squared_frequency(roots[static_cast<std::size_t>(mode - 1)])) /
                             (2 * certified::pi()))});
  }
  return set;
}

}  // namespace

std::vector<Recipe> timoshenko_sets() {
  return {
      {"timoshenko-stick-frequencies", [] { return timoshenko_frequencies(true); }, true, 40},
      {"timoshenko-slip-frequencies", [] { return timoshenko_frequencies(false); }, true, 50},
  };
}

}  // namespace stickslip::reference
