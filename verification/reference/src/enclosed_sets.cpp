// SPDX-License-Identifier: MIT
/// The data sets with values enclosed by ball arithmetic: the stick state, the frequencies of the slip state and of
/// Timoshenko beams, and the criterion.

#include <fmt/format.h>

#include <map>
#include <stdexcept>

#include "sets.hpp"
#include "stickslip/certified/force_maximum.hpp"
#include "stickslip/certified/roots.hpp"
#include "stickslip/certified/stick_modes.hpp"

namespace stickslip::reference {

using certified::Dual;
using certified::PrecisionScope;
using certified::Rational;
using certified::Real;

namespace {

constexpr long bits = 384;
constexpr int mode_count = 10;
const std::string digits_and_bits = fmt::format(R"({{"bits": {}, "digits": 30}})", bits);

// k/20 of the length.
double point_of(const NamedBeam& named, int k) { return named.problem.beam().length() * k / 20.0; }

// The problem of each beam in the column beam.
void set_problem(data::Resource& resource, std::string_view tip) {
  resource.problem = problem_of_each_beam(tip);
  resource.foreign_keys = {beam_key()};
}

DataSet beam_table() {
  DataSet set = data_set("beams", "beams.csv", "Beams",
                         "Uniform beams, clamped at x = 0 and pressed against a wall at x = L by the axial "
                         "force P (compression positive; in tension, where there is no contact, the tip is "
                         "held). All numbers are exact: everything else is computed from these decimals.");
  set.resource.fields = {word("beam", "name"),
                         exact_number("length", "m", "L"),
                         exact_number("area", "m^2", "A"),
                         exact_number("second_moment_of_area", "m^4", "I"),
                         exact_number("density", "kg/m^3", "rho"),
                         exact_number("youngs_modulus", "Pa", "E"),
                         exact_number("axial_force", "N", "P, compression positive")};
  set.resource.primary_key = {"beam"};
  set.resource.provenance = {.value_class = ValueClass::exact,
                             .method =
                                 "chosen: the beam of the paper, the same with half of E I, that of its Fig. "
                                 "14, and four that stress an implementation elsewhere",
                             .settings = "{}",
                             .software = software(),
                             .checks = {"each is a case file of the same name that the program runs"}};
  std::vector<NamedBeam> all = beams();
  for (const char* name : {"paper-half-stiffness", "paper-figure14"}) all.push_back(named_beam(name));
  for (const NamedBeam& named : all) {
    const data::BeamProperties& p = named.problem.beam().properties();
    add_row(set, {named.name, p.length, p.area, p.second_moment_of_area, p.density, p.youngs_modulus,
                  p.axial_force});
  }
  return set;
}

DataSet stick_frequencies() {
  DataSet set =
      data_set("stick-frequencies", "frequencies/stick.csv", "Natural frequencies of the stick state",
               "Clamped-pinned under the axial force P: roots of beta tan(betabar L) = betabar "
               "tanh(beta L), beta^2 = -p/2 + sqrt(p^2/4 + k), betabar^2 = p/2 + sqrt(p^2/4 + k), p "
               "= P/EI, k = rho A omega^2/EI.");
  set_key(set.resource, {beam_column(), mode_column()});
  add_values(set.resource, ValueClass::enclosed,
             {{"frequency", "Hz", "omega_n/(2 pi)", Norm::relative, 1e-6},
              {"hyperbolic_wave_number", "1/m", "beta_n", Norm::relative, 1e-6},
              {"trigonometric_wave_number", "1/m", "betabar_n", Norm::relative, 1e-6}});
  set.resource.diagnosis = for_each_beam("stick frequency", "mode", "frequency");
  set_problem(set.resource, "held");
  set.resource.provenance =
      enclosed_by("every root of the characteristic equation from the first on is isolated", digits_and_bits,
                  {"no interval between the roots holds another one: the function or its derivative has a "
                   "certain sign on every piece"});
  const PrecisionScope scope(bits);
  for (const NamedBeam& named : beams())
    for (const certified::StickMode& mode : certified::stick_modes(named.beam, mode_count))
      add_row(set, {named.name, mode.number, enclosed(mode.frequency_hz),
                    enclosed(mode.hyperbolic_wave_number), enclosed(mode.trigonometric_wave_number)});
  return set;
}

DataSet slip_frequencies() {
  DataSet set =
      data_set("slip-frequencies", "frequencies/slip.csv", "Natural frequencies of the slip state",
               "Clamped-free under the follower force P (Beck's column), kappa = omega L^2 sqrt(rho "
               "A/EI), z = P L^2/EI: z^2 + 2 kappa^2 (1 + cosh(b) cos(bb)) + z kappa sinh(b) sin(bb) "
               "= 0. Beams beyond the flutter load are left out.");
  set_key(set.resource, {beam_column(), mode_column()});
  add_values(set.resource, ValueClass::enclosed,
             {{"frequency", "Hz", "omega_n/(2 pi)", Norm::relative, 1e-6}});
  set.resource.diagnosis = for_each_beam("slip frequency", "mode", "frequency");
  set_problem(set.resource, "free");
  set.resource.provenance = enclosed_by("every root of the frequency equation is isolated", digits_and_bits,
                                        {"their number is that of the cantilever without axial force"});
  const PrecisionScope scope(bits);
  for (const NamedBeam& named : beams()) {
    if (!(named.beam.load_factor() < certified::flutter_factor())) continue;
    int mode = 0;
    for (const Real& omega : certified::slip_frequencies(named.beam, mode_count))
      add_row(set, {named.name, ++mode, enclosed(omega / (2 * certified::pi()))});
  }
  return set;
}

DataSet critical_loads() {
  DataSet set =
      data_set("critical-loads", "static/loads.csv", "Buckling and flutter loads, stiffness of the tip",
               "Buckling of the stick state, P_cr = y^2 EI/L^2 with tan y = y; flutter of the slip state "
               "(Beck's column); and the force that holds the tip, per deflection of it, at rest: EI S'''(L) "
               "of the static shape, under the axial force of the beam.");
  set_key(set.resource, {beam_column()});
  add_values(set.resource, ValueClass::enclosed,
             {{"buckling_load", "N", "of the stick state", Norm::relative, 1e-6},
              {"flutter_load", "N", "of the slip state", Norm::relative, 1e-6},
              {"holding_stiffness", "N/m", "EI S'''(L), the shear force of S", Norm::relative, 1e-6}});
  set_problem(set.resource, "held");
  set.resource.provenance =
      enclosed_by("the root of tan y = y, and the double root of the frequency equation", digits_and_bits,
                  {"Beck's 20.05 EI/L^2"});
  const PrecisionScope scope(bits);
  for (const NamedBeam& named : beams()) {
    const Real unit = named.beam.bending_stiffness() / pow(named.beam.length(), 2);
    add_row(set, {named.name, enclosed(certified::buckling_load(named.beam)),
                  enclosed(certified::flutter_factor() * unit),
                  enclosed(named.beam.bending_stiffness() *
                           certified::QuasiStaticShape(named.beam).at(named.beam.length())[3])});
  }
  return set;
}

DataSet participation() {
  DataSet set = data_set("participation", "shapes/participation.csv", "Participation factors",
                         "C_n = -int U_n (1 + S) dx/int U_n^2 dx of Eq. (25), U_n in the scale of Eq. (22): "
                         "U_n''(0) = beta^2 + betabar^2.");
  set_key(set.resource, {beam_column(), mode_column()});
  add_values(set.resource, ValueClass::enclosed, {{"participation", "", "C_n", Norm::relative, 1e-6}});
  set.resource.diagnosis = for_each_beam("participation", "mode", "participation");
  set_problem(set.resource, "held");
  set.resource.provenance =
      enclosed_by("the integrals in closed form", digits_and_bits, {"the integrals by rigorous quadrature"});
  const PrecisionScope scope(bits);
  for (const NamedBeam& named : beams())
    for (const certified::StickMode& mode : certified::stick_modes(named.beam, mode_count))
      add_row(set, {named.name, mode.number, enclosed(mode.participation)});
  return set;
}

DataSet static_shapes() {
  DataSet set =
      data_set("static-shapes", "shapes/static.csv", "Static shapes",
               "S(x) of Eq. (18): S'''' + (P/EI) S'' = 0, S(0) = S'(0) = S''(L) = 0, S(L) = -1; with "
               "hyperbolic functions in tension.");
  set_key(set.resource, {beam_column(), exact_number("x", "m", "distance from the clamp")});
  add_values(set.resource, ValueClass::enclosed,
             {{"shape", "", "S(x)", Norm::scale, 1e-6}, {"slope", "1/m", "S'(x)", Norm::scale, 1e-6}});
  set.resource.diagnosis = for_each_beam("quasi-static shape", "x", "shape");
  set_problem(set.resource, "held");
  set.resource.provenance = enclosed_by("Eq. (18)", digits_and_bits, {"the boundary values hold"});
  const PrecisionScope scope(bits);
  for (const NamedBeam& named : beams()) {
    const certified::QuasiStaticShape shape(named.beam);
    for (int k = 1; k <= 20; ++k) {
      const double x = point_of(named, k);
      const certified::Derivatives at = shape.at(Real(exact(x)));
      add_row(set, {named.name, x, enclosed(at[0]), enclosed(at[1], 1.0 / named.problem.beam().length())});
    }
  }
  return set;
}

DataSet mode_shapes() {
  DataSet set = data_set("mode-shapes", "shapes/stick-modes.csv", "Mode shapes of the stick state",
                         "U_n(x) of Eq. (22), with U_n''(0) = beta^2 + betabar^2.");
  set_key(set.resource, {beam_column(), mode_column(), exact_number("x", "m", "distance from the clamp")});
  add_values(set.resource, ValueClass::enclosed, {{"shape", "", "U_n(x)", Norm::scale, 1e-4}});
  set_problem(set.resource, "held");
  set.resource.provenance = enclosed_by(
      "Eq. (22)", digits_and_bits, {"value and slope vanish at the clamp, value and curvature at the tip"});
  const PrecisionScope scope(bits);
  for (const NamedBeam& named : beams())
    for (const certified::StickMode& mode : certified::stick_modes(named.beam, mode_count))
      for (int k = 1; k < 20; ++k) {
        const double x = point_of(named, k);
        const Real value = mode.shape(Real(exact(x)))[0];
        add_row(set, {named.name, mode.number, x, enclosed(value, 1.0)});
      }
  return set;
}

DataSet stick_history_of_ten_modes() {
  DataSet set =
      data_set("stick-history-ten-modes", "stick/ten-modes.csv", "The held beam by the paper's ten modes",
               "Fig. 9: the paper's beam at 15 Hz and 0.5 mm, tip held, by Eqs. (27) and (28) with N = 10: "
               "for another evaluation of these sums. The force is that of the displacements, EI u_xxx(L) of "
               "u = S h + sum U_n q_n term by term; the balance of momentum with ten modes gives another "
               "one, by 0.3 %. Finite elements are nearer to stick-history, which has all modes.");
  set_key(set.resource, {exact_number("time", "s", "since the start")});
  add_values(set.resource, ValueClass::enclosed,
             {{"midspan_displacement", "m", "y(L/2, t), absolute", Norm::scale, 1e-6},
              {"friction_force", "N", "f(t), of the tip on the wall", Norm::scale, 1e-6}});
  compare_along(set.resource, "time");
  set.resource.problem =
      problem_of(data::load_case("paper-figure9"), "paper", "held", {{"/modes", "10"}, {"/duration", "1"}});
  set.resource.diagnosis = in_case("stick displacement", "paper-figure9", "time", "midspan_displacement");
  set.resource.provenance = enclosed_by(
      "Eqs. (27), (28) with omega_n^2 in Eq. (24)",
      fmt::format(R"({{"bits": {}, "digits": 30, "modes": 10, "frequency_hz": 15, "amplitude": 0.0005}})",
                  bits),
      {"y vanishes at t = 0, and y_t is (1 + S) h_t"});
  const PrecisionScope scope(bits);
  const NamedBeam& paper = beams().front();
  const certified::StickResponse response(paper.beam, {"15", "0.0005"}, 10);
  const Real midspan = paper.beam.length() / 2;
  for (int k = 1; k <= 1000; ++k) {
    const double t = k / 1000.0;
    const Real time(exact(t));
    add_row(set, {t, enclosed(response.absolute_displacement(midspan, time), 1e-3),
                  enclosed(response.friction_force(time), 100.0)});
  }
  return set;
}

const Rational ten_seconds("10");

// 5 to 120 Hz in steps of 5 Hz.
std::vector<int> frequencies() {
  std::vector<int> list;
  for (int hz = 5; hz <= 120; hz += 5) list.push_back(hz);
  return list;
}

// The force maximum per metre of amplitude for a case and a frequency. It is stored, because it is expensive
// and used several times.
const certified::ForceMaximum& force_maximum(const NamedBeam& named, int hz) {
  static std::map<std::pair<std::string, int>, certified::ForceMaximum> known;
  const auto key = std::pair(named.name, hz);
  if (const auto found = known.find(key); found != known.end()) return found->second;
  return known.emplace(key, certified::max_abs_friction_force(named.beam, {exact(hz), "1"}, ten_seconds, 10))
      .first->second;
}

// |f|_max over 10 s by ten modes.
std::string criterion_problem(std::map<std::string, std::string> others) {
  others.insert({{"/modes", "10"}, {"/duration", "10"}});
  return problem_of(beams().front().problem, "paper", "held", others);
}

const NamedBeam& half_stiffness() {
  static const NamedBeam named = named_beam("paper-half-stiffness");
  return named;
}

DataSet friction_maxima() {
  DataSet set =
      data_set("friction-maxima", "criterion/friction-maxima.csv", "Largest static friction force",
               "|f|_max of Eq. (28) over 0 <= t <= 10 s with N = 10 (Fig. 10), the paper's beam at 0.5 mm.");
  set_key(set.resource, {exact_number("frequency", "Hz", "of the base")});
  add_values(set.resource, ValueClass::enclosed, {{"friction_force", "N", "|f|_max", Norm::relative, 1e-3}});
  set.resource.diagnosis = in_case("force maximum", "paper", "frequency", "friction_force");
  set.resource.problem = criterion_problem({{"/excitation/frequency_hz", in_column("frequency")}});
  set.resource.provenance = enclosed_by(
      "times are dropped where a bound of f'' keeps |f| below the largest value found; in what is left every "
      "root of f' is isolated",
      R"({"modes": 10, "duration": 10, "amplitude": 0.0005, "digits": 30})",
      {"the rigorous bounds of the double-precision search overlap"});
  const PrecisionScope scope(bits);
  for (int hz = 1; hz <= 120; ++hz)
    add_row(set, {hz, enclosed(force_maximum(beams().front(), hz).value * Real(Rational("0.0005")))});
  return set;
}

DataSet critical_amplitudes() {
  DataSet set =
      data_set("critical-amplitudes", "criterion/critical-amplitudes.csv", "Critical amplitudes",
               "The base amplitude at which |f|_max over 10 s reaches mu_s P = 300 N, N = 10: Figs. "
               "6, 11 (case paper) and 13 (case paper-half-stiffness).");
  set_key(set.resource, {beam_column(), exact_number("frequency", "Hz", "of the base")});
  add_values(set.resource, ValueClass::enclosed, {{"amplitude", "m", "A_c", Norm::relative, 1e-3}});
  set.resource.diagnosis = for_each_beam("critical amplitude", "frequency", "amplitude");
  set.resource.problem = criterion_problem({{"/beam", in_column("beam")},
                                            {"/excitation/frequency_hz", in_column("frequency")},
                                            {"/excitation/amplitude", in_column("amplitude")}});
  set.resource.foreign_keys = {beam_key()};
  set.resource.provenance = enclosed_by("mu_s P over the largest force per metre, as in friction-maxima",
                                        R"({"modes": 10, "duration": 10, "digits": 30})",
                                        {"one linear run of finite elements per frequency"});
  const PrecisionScope scope(bits);
  const Real limit(Rational("300"));
  for (const NamedBeam* named : {&beams().front(), &half_stiffness()})
    for (const int hz : frequencies())
      add_row(set, {named->name, hz, enclosed(limit / force_maximum(*named, hz).value)});
  return set;
}

DataSet classification() {
  DataSet set =
      data_set("classification", "criterion/classification.csv", "Stick or stick-slip",
               "Fig. 12: the criterion |f|_max > mu_s P over 10 s with N = 10, the paper's beam. The "
               "ratio |f|_max/(mu_s P) says how near a point is to the boundary, where a mesh may "
               "decide otherwise.");
  set.resource.fields = {exact_number("frequency", "Hz", "of the base"),
                         exact_number("amplitude", "m", "of the base"),
                         word("verdict", "of the criterion", {"stick", "stick-slip"})};
  add_value(set.resource.fields, "force_ratio", "", "|f|_max/(mu_s P)", ValueClass::enclosed);
  set.resource.primary_key = {"frequency", "amplitude"};
  set.resource.problem = criterion_problem({{"/excitation/frequency_hz", in_column("frequency")},
                                            {"/excitation/amplitude", in_column("amplitude")}});
  set.resource.comparison = by_rows({{"force_ratio", Norm::relative, 1e-3},
                                     {"verdict", Norm::word, 0.0, data::DecidingValue{"force_ratio", 1.0}}});
  set.resource.diagnosis = in_case("force ratio", "paper", "amplitude", "force_ratio");
  set.resource.provenance =
      enclosed_by("as in friction-maxima", R"({"modes": 10, "duration": 10, "digits": 30})",
                  {"every verdict is certain", "the grid of Fig. 12 by finite elements"});
  const PrecisionScope scope(bits);
  const Real limit(Rational("300"));
  for (const int hz : frequencies())
    for (int k = 1; k <= 20; ++k) {
      const double amplitude = k * 5 / 1e5;
      const Real ratio = Real(exact(amplitude)) * force_maximum(beams().front(), hz).value / limit;
      const int side = (ratio - Real(1)).certain_sign();
      if (side == 0)
        throw std::runtime_error(fmt::format("the verdict at {} Hz, {} m is undecided", hz, amplitude));
      add_row(set, {hz, amplitude, side > 0 ? "stick-slip" : "stick", enclosed(ratio)});
    }
  return set;
}

// The natural frequencies of Timoshenko beams, by the equations of analytic/timoshenko_modes.hpp in ball arithmetic.

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
                                    fmt::format(R"({{"bits": {}, "digits": 30}})", bits),
                                    {"a spectral Ritz method has the same ones below the cut-off frequency",
                                     "without rotary inertia and shear those of Euler and Bernoulli"});
  const certified::PrecisionScope scope(bits);
  for (const char* name : {"paper", "steel-strip"}) {
    const NamedBeam named = named_beam(name);
    const certified::BeamData& data = named.beam.data();
    const Real r2 = Real(data.second_moment_of_area) / (Real(data.area) * pow(named.beam.length(), 2));
    const TimoshenkoBeam beam{r2, r2 * Real(Rational("3.12")), is_held};  // E/(k G) = 2 (1 + 0.3) 6/5
    const Real upper = certified::pi() * (is_held ? 2 * mode_count + 1 : 2 * mode_count) / 2;
    const auto roots =
        certified::isolate_roots([&](const Real& n) { return beam.equation(n); }, Real(1), upper.midpoint());
    if (roots.size() != mode_count) throw std::runtime_error("a mode of a Timoshenko beam is missing");
    for (int mode = 1; mode <= mode_count; ++mode)
      add_row(set, {name, mode,
                    enclosed(named.beam.frequency_unit() *
                             sqrt(beam.squared_frequency(roots[static_cast<std::size_t>(mode - 1)])) /
                             (2 * certified::pi()))});
  }
  return set;
}

}  // namespace

std::vector<Recipe> enclosed_sets() {
  return {
      {"beams", beam_table, true, 10},
      {"stick-frequencies", stick_frequencies, true, 20},
      {"slip-frequencies", slip_frequencies, true, 30},
      {"timoshenko-stick-frequencies", [] { return timoshenko_frequencies(true); }, true, 40},
      {"timoshenko-slip-frequencies", [] { return timoshenko_frequencies(false); }, true, 50},
      {"critical-loads", critical_loads, true, 60},
      {"participation", participation, true, 70},
      {"static-shapes", static_shapes, true, 80},
      {"mode-shapes", mode_shapes, true, 90},
      {"stick-history-ten-modes", stick_history_of_ten_modes, true, 100},
      {"friction-maxima", friction_maxima, true, 120},
      {"critical-amplitudes", critical_amplitudes, true, 130},
      {"classification", classification, true, 140},
  };
}

}  // namespace stickslip::reference
