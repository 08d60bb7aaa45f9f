// SPDX-License-Identifier: MIT
/// The data sets from short closed forms: one mass with friction, and a manufactured motion.

#include <algorithm>
#include <array>
#include <utility>

#include "sets.hpp"

namespace stickslip::reference {

using certified::PrecisionScope;
using certified::Rational;
using certified::Real;

namespace {

constexpr long exact_bits = 256;

DataSet single_mass_events() {
  DataSet set = data_set(
      "single-mass-events", "single-mass/events.csv", "Stops and reversals of one mass with Coulomb friction",
      "slider: m = 2 kg, mu N = 3 N, starts at 0.25 m with 1.3 m/s and stops at v0/(mu N/m) after v0^2/(2 mu "
      "N/m). oscillator: m = 1 kg, a spring of 4 N/m to the fixed frame, mu N = 0.4 N, starts at rest at "
      "1.04 m: turning points at i pi/2 s, where it is (-1)^i (1.04 - 0.2 i) m; the fifth lies within the "
      "dead zone of 0.1 m, and it sticks.");
  data::Resource& resource = set.resource;
  resource.fields = {word("system", "slider or oscillator", {"slider", "oscillator"}),
                     integer("index", "number of the event, from 1"),
                     word("change", "reversal or capture", {"reversal", "capture"})};
  add_value(resource.fields, "time", "s", "of the event", ValueClass::enclosed);
  add_value(resource.fields, "position", "m", "of the mass", ValueClass::enclosed);
  resource.primary_key = {"system", "index"};
  resource.problem =
      R"({"system": {"column": "system"},
          "slider": {"mass": 2, "stiffness": 0, "friction_force": 3, "position": 0.25, "velocity": 1.3},
          "oscillator": {"mass": 1, "stiffness": 4, "friction_force": 0.4, "position": 1.04, "velocity": 0}})";
  resource.comparison = by_rows({{"time", Norm::scale, 1e-6}, {"position", Norm::scale, 1e-6}});
  resource.comparison->kind = data::ComparisonKind::events;
  resource.provenance = {
      .value_class = ValueClass::enclosed,
      .method = "the piecewise closed form, in ball arithmetic (Arb)",
      .settings = R"({"bits": 256, "digits": 30})",
      .software = software(),
      .checks = {"the event-driven engine and the time stepper, to round-off and to order two"}};
  const PrecisionScope scope(exact_bits);
  const Real deceleration = Real(3) / Real(2), v0(Rational("1.3"));
  add_row(set, {"slider", 1, "capture", enclosed(v0 / deceleration),
                enclosed(Real(Rational("0.25")) + v0 * v0 / (2 * deceleration))});
  for (int i = 1; i <= 5; ++i)
    add_row(set, {"oscillator", i, i < 5 ? "reversal" : "capture", enclosed(Real(i) * certified::pi() / 2),
                  enclosed(Real(i % 2 == 0 ? 1 : -1) *
                           (Real(Rational("1.04")) - Real(i) * Real(Rational("0.2"))))});
  return set;
}

DataSet friction_powers() {
  DataSet set = data_set(
      "friction-powers", "single-mass/friction-powers.csv", "Mean friction power of a mass on a shaken plane",
      "Case SDND104: 1 kg on a plane that moves by w, w_tt = a sin(2 pi t), with Coulomb friction mu N, mu = "
      "0.1, N = 10 N, from rest on the plane; the mean of N |v_s| over 4 <= t <= 12 s.");
  data::Resource& resource = set.resource;
  set_key(resource, {exact_number("amplitude", "m/s^2", "a")});
  add_values(resource, ValueClass::external, {{"power", "W", "mean", Norm::relative, 1e-6}});
  resource.problem =
      R"({"mass": 1, "normal_force": 10, "friction_force": 1, "initial_state": "at rest on the plane",
          "plane_acceleration": {"amplitude": {"column": "amplitude"}, "frequency_hz": 1},
          "mean_from": 4, "mean_to": 12})";
  resource.provenance = {.value_class = ValueClass::external,
                         .method =
                             "the test case SDND104 of the validation manual of code_aster, its piecewise "
                             "closed form evaluated with 40 digits",
                         .settings = R"({"digits": 40})",
                         .software = "none",
                         .checks = {"the event-driven engine, to ten digits"}};
  constexpr std::array<std::array<const char*, 3>, 4> rows{{{"0.99", "0", "0"},
                                                            {"1.01", "2.26164121279787e-4", "5e-19"},
                                                            {"1.5", "0.409062451015709", "5e-16"},
                                                            {"15", "15.2670995893716", "5e-14"}}};
  for (const auto& [amplitude, power, radius] : rows) add_row(set, {amplitude, power, radius});
  return set;
}

DataSet beam_matrices() {
  DataSet set = data_set(
      "beam-matrices", "manufactured/matrices.csv", "Matrices of the paper's beam with four elements",
      "Four equal Hermite elements, clamped end left out: unknowns 1 to 8 are (w, w_x) of the nodes at 0.5, "
      "1, 1.5 and 2 m. mass: rho A int N N; stiffness: EI int N'' N''; geometric: int N' N', which enters as "
      "-P; follower: P in the row of w(L) and the column of w_x(L); load: rho A int N (column 1), which "
      "enters as -h_tt. Stick: stiffness - P geometric, without row and column 7. Slip: the same plus "
      "follower. Entries that are not here are 0.");
  data::Resource& resource = set.resource;
  set_key(resource, {word("matrix", "name", {"mass", "stiffness", "geometric", "follower", "load"}),
                     integer("row", "from 1"), integer("column", "from 1")});
  add_values(resource, ValueClass::enclosed,
             {{"value", "", "of the entry, in SI units (m, rad, kg, N)", Norm::relative, 1e-12}});
  resource.problem = R"({"beam": "paper", "damping": {"kelvin_voigt": 0}})";
  resource.provenance = {
      .value_class = ValueClass::enclosed,
      .method = "the integrals of the cubic shape functions in closed form, in ball arithmetic (Arb)",
      .settings = R"({"bits": 256, "digits": 30, "elements": 4})",
      .software = software(),
      .checks = {"the matrices of the finite-element solver, to rounding"}};
  const PrecisionScope scope(exact_bits);
  const certified::Beam& beam = beams().front().beam;
  const Real l = beam.length() / 4, mass = beam.mass_per_length();
  struct Matrix {
    const char* name;
    Real factor;
    std::array<std::array<int, 4>, 4> numbers;  // of an element, over `factor` and over l for each rotation
  };
  const std::array<Matrix, 3> matrices{
      {{"mass",
        mass * l / 420,
        {{{156, 22, 54, -13}, {22, 4, 13, -3}, {54, 13, 156, -22}, {-13, -3, -22, 4}}}},
       {"stiffness",
        beam.bending_stiffness() / pow(l, 3),
        {{{12, 6, -12, 6}, {6, 4, -6, 2}, {-12, -6, 12, -6}, {6, 2, -6, 4}}}},
       {"geometric",
        Real(1) / (30 * l),
        {{{36, 3, -36, 3}, {3, 4, -3, -1}, {-36, -3, 36, -3}, {3, -1, -3, 4}}}}}};
  for (const Matrix& matrix : matrices)
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 8; ++j) {
        int sum = 0;
        for (int first = -2; first < 6; first += 2)  // unknown of each element
          if (std::min(i, j) >= first && std::max(i, j) < first + 4)
            sum += matrix.numbers.at(static_cast<std::size_t>(i - first))
                       .at(static_cast<std::size_t>(j - first));
        if (sum == 0) continue;
        const Real value = matrix.factor * Real(sum) * pow(l, static_cast<unsigned>(i % 2 + j % 2));
        add_row(set, {matrix.name, i + 1, j + 1, enclosed(value)});
      }
  add_row(set, {"follower", 7, 8, enclosed(beam.axial_force())});
  for (int node = 1; node <= 4; ++node)
    add_row(set, {"load", 2 * node - 1, 1, enclosed(mass * l / (node < 4 ? 1 : 2))});
  add_row(set, {"load", 8, 1, enclosed(-(mass * l * l / 12))});
  return set;
}

DataSet manufactured_motion() {
  DataSet set = data_set(
      "manufactured-motion", "manufactured/motion.csv", "A manufactured motion and the load that it takes",
      "The paper's beam is to move as u(x,t) = phi(x) cos(w t), phi = a sin^2(2 x/L) exp(x/(2 L)), a = 1 mm, "
      "w = 40 rad/s, which no cubic element holds. Under the axial force of the first column that takes the "
      "load q(x) cos(w t) per length, q = -rho A w^2 phi + EI phi'''' + P phi'', and at the tip (the last "
      "row of each force) the bending moment EI phi''(L) cos(w t) and, in slip, where the axial force "
      "follows the tip, the force -EI phi'''(L) cos(w t); in stick that force is the reaction.");
  data::Resource& resource = set.resource;
  set_key(resource, {exact_number("axial_force", "N", "P, compression positive"),
                     exact_number("x", "m", "distance from the clamp")});
  add_values(resource, ValueClass::enclosed,
             {{"displacement", "m", "phi(x)", Norm::scale, 1e-6},
              {"load", "N/m", "q(x)", Norm::scale, 1e-6},
              {"bending_moment", "N m", "EI phi''(x)", Norm::scale, 1e-6},
              {"shear_force", "N", "EI phi'''(x)", Norm::scale, 1e-6}});
  resource.problem =
      R"({"beam": "paper", "axial_force": {"column": "axial_force"}, "tip": "free",
          "damping": {"kelvin_voigt": 0}})";
  resource.provenance = {.value_class = ValueClass::enclosed,
                         .method = "the derivatives in closed form, in ball arithmetic (Arb)",
                         .settings = R"({"bits": 256, "digits": 30})",
                         .software = software(),
                         .checks = {"phi and phi' vanish at the clamp"}};
  const PrecisionScope scope(exact_bits);
  const NamedBeam& paper = beams().front();
  const Real length = paper.beam.length(), rigidity = paper.beam.bending_stiffness();
  const Real a(Rational("0.001")), squared_rate(1600);
  for (const char* axial_force : {"-40000", "0", "40000"})
    for (int k = 1; k <= 20; ++k) {
      const double x = paper.problem.beam().length() * k / 20.0;
      const Real xi = Real(exact(x)) / length;
      // phi = a/2 (exp(b xi) - Re exp((b + 4 i) xi)) with b = 1/2. Each derivative multiplies by b/L or (b +
      // 4 i)/L.
      const Real b = Real(1) / 2, growth = exp(b * xi), four(4);
      Real plain = growth, real = growth * cos(four * xi), imaginary = growth * sin(four * xi), scale = a / 2;
      std::array<Real, 5> phi;
      for (Real& derivative : phi) {
        derivative = scale * (plain - real);
        plain = b * plain;
        real = std::exchange(imaginary, b * imaginary + four * real) * Real(-4) + b * real;
        scale = scale / length;
      }
      const Real load = rigidity * phi[4] + Real(Rational(axial_force)) * phi[2] -
                        paper.beam.mass_per_length() * squared_rate * phi[0];
      add_row(set, {axial_force, x, enclosed(phi[0], 1e-3), enclosed(load, 10.0),
                    enclosed(rigidity * phi[2], 10.0), enclosed(rigidity * phi[3], 10.0)});
    }
  return set;
}

}  // namespace

std::vector<Recipe> exact_sets() {
  return {
      {"single-mass-events", single_mass_events, true, 350},
      {"friction-powers", friction_powers, true, 360},
      {"manufactured-motion", manufactured_motion, true, 370},
      {"beam-matrices", beam_matrices, true, 410},
  };
}

}  // namespace stickslip::reference
