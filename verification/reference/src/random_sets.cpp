// SPDX-License-Identifier: MIT
/// The data set of the held beam under random motions, in ball arithmetic: the force is that of the displacements, EI u_xxx(L), where the
/// code that it judges has the balance of momentum of its static shape.

#include <acb_calc.h>
#include <fmt/format.h>

#include <array>
#include <map>
#include <stdexcept>

#include "sets.hpp"
#include "stickslip/certified/complex.hpp"
#include "stickslip/certified/stick_modes.hpp"

namespace stickslip::reference {

using certified::Complex;
using certified::PrecisionScope;
using certified::Rational;
using certified::Real;

namespace {

constexpr long random_bits = 384;
constexpr int held_modes = 20;

enum class Moved { base, wall, both };  // both: as one

// The density of the acceleration, (m/s^2)^2/Hz, at frequencies, Hz.
using Spectrum = std::vector<std::pair<Rational, Rational>>;
const Spectrum flat{{"5", "1"}, {"200", "1"}},
    sloping{{"5", "0.2"}, {"20", "2"}, {"60", "1"}, {"200", "0.05"}};

Real log(const Real& x) {
  Real result;
  arb_log(result.data(), x.data(), certified::precision());
  return result;
}

// For P > 0: rho A times the integrals of s and s^2 over the beam, s = -S, the static shape of a tip at 1: with y = L sqrt(P/EI), z = x y/L,
// S = (sin y - z cos y - sin(y - z))/(y cos y - sin y).
std::array<Real, 2> masses_of_static_shape(const certified::Beam& beam) {
  const Real y = sqrt(beam.load_factor()), s = sin(y), c = cos(y), d = y * c - s;
  const Real line = s * y - c * pow(y, 2) / 2, sine = 1 - c,
             squares = pow(s, 2) * y - s * c * pow(y, 2) + pow(c, 2) * pow(y, 3) / 3 + (y - s * c) / 2,
             product = (s - c * y) * (1 - c) + c * (s - y * c);
  const Real unit = beam.mass_per_length() * beam.length() / y;
  return {-unit * (line - sine) / d, unit * (squares - 2 * product) / pow(d, 2)};
}

// f_d = -f of the held beam for an acceleration exp(iwt), N/(m/s^2). With D_n = w_n^2 - w^2 + 2 i zeta w_n w, modal masses m_n and
//
//     l_n = -EI U_n'''(0)/w_n^2 (base), a_n = (P U_n'(L) + EI U_n'''(L))/w_n^2 (wall), l_n + a_n (both),
//
// the displacements give EI S'''(L)/w^2 (wall: minus that; both: none) + sum EI U_n'''(L) l_n/(m_n D_n), and the modes that are left out
// follow at once, with int rho A s (1 - s) dx - sum a_n l_n/m_n (wall: s^2; both: s).
class HeldForce {
 public:
  HeldForce(const certified::Beam& beam, Moved moved, bool damps_contact) {
    const auto [once, twice] = masses_of_static_shape(beam);
    const Real length = beam.length(), rigidity = beam.bending_stiffness();
    mass_ = moved == Moved::base ? once - twice : moved == Moved::wall ? twice : once;
    if (moved != Moved::both) {
      const Real held = rigidity * certified::QuasiStaticShape(beam).at(length)[3];
      stiffness_ = moved == Moved::base ? held : -held;
    }
    for (const certified::StickMode& mode : certified::stick_modes(beam, held_modes)) {
      const Real square = pow(mode.angular_frequency, 2);
      const certified::Derivatives tip = mode.shape(length);
      const Real of_base = -rigidity * mode.shape(0)[3] / square,
                 of_wall = (beam.axial_force() * tip[1] + rigidity * tip[3]) / square,
                 load = moved == Moved::base   ? of_base
                        : moved == Moved::wall ? of_wall
                                               : of_base + of_wall,
                 modal_mass = -of_base / mode.participation, inertia = of_wall * load / modal_mass;
      mass_ -= inertia;
      const Real drag = Real(Rational("0.04")) * mode.angular_frequency;
      modes_.push_back(
          {square, drag, rigidity * tip[3] * load / modal_mass, damps_contact ? Real(0) : inertia * drag});
    }
  }

  // |f|^2 in a form that is analytic in w^2.
  [[nodiscard]] Complex squared(const Complex& square) const {
    Complex real = Complex(mass_) + Complex(stiffness_) / square, imaginary = 0;  // over w
    const auto add = [](Complex& sum, const Complex& term) {
      acb_add(sum.data(), sum.data(), term.data(), certified::precision());
    };
    for (const Mode& mode : modes_) {
      const Complex left = mode.square - square, share = 1 / (left * left + mode.drag * mode.drag * square);
      add(real, (mode.force * left + mode.lost * mode.drag * square) * share);
      add(imaginary, (mode.lost * left - mode.force * mode.drag) * share);
    }
    return real * real + square * imaginary * imaginary;
  }

 private:
  struct Mode {
    Real square, drag, force, lost;
  };

  Real mass_, stiffness_;
  std::vector<Mode> modes_;
};

// (2 pi f)^power |f_d|^2 density (f/from)^slope.
struct Integrand {
  const HeldForce& force;
  Real from_hz, density, slope;
  int power;
};

int integrand(acb_ptr out, const acb_t hz, void* data, slong /*order*/, slong /*precision*/) {
  const auto& [force, from_hz, line_density, slope, power] = *static_cast<const Integrand*>(data);
  const long bits_here = certified::precision();
  if (!arb_is_positive(acb_realref(hz))) {  // there S is not analytic
    acb_indeterminate(out);
    return 0;
  }
  const Complex f(hz), omega = 2 * certified::pi() * f;
  Complex density = f / from_hz;
  acb_log(density.data(), density.data(), bits_here);
  acb_mul_arb(density.data(), density.data(), slope.data(), bits_here);
  acb_exp(density.data(), density.data(), bits_here);
  acb_pow_ui(out, omega.data(), static_cast<ulong>(power), bits_here);
  const Complex value = Complex(out) * line_density * density * force.squared(omega * omega);
  acb_set(out, value.data());
  return 0;
}

// The integrals of w^j |f_d|^2 S over the frequencies, j = 0, 1, 2.
std::array<Real, 3> moments(const HeldForce& force, const Spectrum& spectrum) {
  const PrecisionScope scope(160);
  std::array<Real, 3> sums;
  for (std::size_t i = 0; i + 1 < spectrum.size(); ++i) {
    const auto& [from, density] = spectrum[i];
    const auto& [to, next] = spectrum[i + 1];
    const Real slope = log(Real(next) / density) / log(Real(to) / from);
    for (int j = 0; j < 3; ++j) {
      Integrand parameters{force, from, density, slope, j};
      Complex part = 0;
      mag_t absolute;  // no absolute tolerance
      mag_init(absolute);
      acb_calc_integrate(part.data(), integrand, &parameters, Complex(Real(from)).data(),
                         Complex(Real(to)).data(), 104, absolute, nullptr, certified::precision());
      sums.at(static_cast<std::size_t>(j)) += part.real();
    }
  }
  return sums;
}

struct RandomMotion {
  const char* name;
  Moved moved;
  const Spectrum* spectrum;  // none: base-flat and wall-sloping at once, independent
};

void state_random(data::Resource& resource) {
  resource.problem =
      R"({"beam": "paper", "tip": "held", "modes": 20, "damping": {"ratio": 0.02},
          "spectra": {"flat": {"5": 1, "200": 1}, "sloping": {"5": 0.2, "20": 2, "60": 1, "200": 0.05}},
          "motion": {"base-flat": {"base": "flat"}, "base-sloping": {"base": "sloping"}, "wall-sloping": {"wall": "sloping"},
                     "base-and-wall": {"base": "flat", "wall": "sloping"}, "wall-with-base": {"base_and_wall": "flat"}}})";
  resource.provenance = {
      .value_class = ValueClass::enclosed,
      .method =
          "ball arithmetic (Arb): modes by isolated roots, their force EI u_xxx(L), its moments by rigorous "
          "quadrature",
      .settings = fmt::format(R"({{"bits": {}, "digits": 30, "modes": {}}})", random_bits, held_modes),
      .software = software(),
      .checks = {
          "the balance of momentum of the static shape, by Gauss and Legendre's rule in doubles, to 1e-11"}};
}

DataSet random_reaction() {
  DataSet set = data_set(
      "random-reaction", "stick/random-reaction.csv", "The held beam under random motions",
      "The stationary force f on the held tip of the paper's beam, with 20 held modes of 2 % of critical "
      "damping and the "
      "inertia of all others. contact_damping: whether the damping of the modes acts on the tip too, as in "
      "EI u_xxx of the "
      "displacements, or not, as with a diagonal matrix of held modes. README.md has the equations.");
  data::Resource& resource = set.resource;
  set_key(resource, {word("motion", "of base and wall",
                          {"base-flat", "base-sloping", "wall-sloping", "base-and-wall", "wall-with-base"}),
                     word("contact_damping", "whether it acts on the tip", {"yes", "no"})});
  std::vector<Value> values{
      {"deviation", "N", "sqrt(lambda_0) of f", Norm::relative, 1e-6},
      {"rate_deviation", "N/s", "sqrt(lambda_2) of f", Norm::relative, 1e-6},
      {"bandwidth", "", "sqrt(1 - lambda_1^2/(lambda_0 lambda_2))", Norm::relative, 1e-6}};
  const std::array levels{150, 300, 450};
  for (const int level : levels)
    values.push_back({fmt::format("crossings_{}", level), "1/s",
                      fmt::format("how often |f| grows beyond {} N, by Rice", level), Norm::relative, 1e-5});
  add_values(resource, ValueClass::enclosed, values);
  state_random(resource);
  const PrecisionScope scope(random_bits);
  const certified::Beam& beam = beams().front().beam;
  std::map<std::string, std::array<Real, 3>> known;
  for (const auto& [name, moved, spectrum] :
       std::vector<RandomMotion>{{"base-flat", Moved::base, &flat},
                                 {"base-sloping", Moved::base, &sloping},
                                 {"wall-sloping", Moved::wall, &sloping},
                                 {"base-and-wall", {}, nullptr},
                                 {"wall-with-base", Moved::both, &flat}})
    for (const std::string damping : {"yes", "no"}) {
      auto& lambda = known[name + damping];
      if (spectrum != nullptr)
        lambda = moments(HeldForce(beam, moved, damping == "yes"), *spectrum);
      else
        for (std::size_t j = 0; j < 3; ++j)
          lambda.at(j) = known["base-flat" + damping].at(j) + known["wall-sloping" + damping].at(j);
      std::vector<Cell> row{name, damping, enclosed(sqrt(lambda[0])), enclosed(sqrt(lambda[2])),
                            enclosed(sqrt(1 - pow(lambda[1], 2) / (lambda[0] * lambda[2])))};
      for (const int level : levels)
        row.push_back(enclosed(sqrt(lambda[2] / lambda[0]) / certified::pi() *
                               exp(-Real(level * level) / (2 * lambda[0]))));
      add_row(set, row);
    }
  return set;
}

}  // namespace

std::vector<Recipe> random_sets() { return {{"random-reaction", random_reaction, true, 115}}; }

}  // namespace stickslip::reference
