// SPDX-License-Identifier: MIT
/// The data sets with converged values of the held beam: with all modes, and the map of Fig. 14.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "sets.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"

namespace stickslip::reference {

namespace {

DataSet stick_history() {
  DataSet set =
      data_set("stick-history", "stick/history.csv", "The held beam with all its modes",
               "Fig. 9: the paper's beam at 15 Hz and 0.5 mm, tip held, for any converged implementation. "
               "The paper's ten modes leave 3e-6 of y and 0.3 % of f out.");
  data::Resource& resource = set.resource;
  set_key(resource, {exact_number("time", "s", "since the start")});
  add_values(resource, ValueClass::converged,
             {{"midspan_displacement", "m", "y(L/2, t), absolute", Norm::scale, 5e-4},
              {"friction_force", "N", "f(t), of the tip on the wall", Norm::scale, 3e-3}});
  compare_along(resource, "time");
  resource.diagnosis = in_case("stick displacement", "paper-figure9", "time", "midspan_displacement");
  const data::Case problem = data::load_case("paper-figure9");
  resource.problem = problem_of(problem, "paper", "held", {{"/duration", "1"}});
  constexpr int modes = 200;
  resource.provenance = converged_by(
      "Eqs. (27), (28) with the steady part in closed form and 200 free vibrations; the half-width is the "
      "largest difference to 100 of them, which leave out eight times as much of f, and more of y",
      fmt::format(R"({{"modes": {}, "frequency_hz": 15, "amplitude": 0.0005}})", modes),
      {"finite elements, to their predicted error", "the bound of the omitted free vibrations"});
  const double midspan = 0.5 * problem.beam.length();
  const auto response = [&](int count) {
    return analytic::StickResponse(problem.beam, problem.excitation, count, analytic::SteadyPart::exact);
  };
  const auto fine = response(modes), coarse = response(modes / 2);
  constexpr int samples = 1000;
  // At least the rounding error of sums of the size of A0 with phases omega t of relative error eps.
  double displacement_error = 1e-16, force_error = fine.omitted_transient_bound();
  for (int k = 1; k <= samples; ++k) {
    const double t = k / 1000.0;
    displacement_error = std::max(displacement_error, std::abs(fine.absolute_displacement(midspan, t) -
                                                               coarse.absolute_displacement(midspan, t)));
    force_error = std::max(force_error, std::abs(fine.friction_force(t) - coarse.friction_force(t)));
  }
  for (int k = 1; k <= samples; ++k) {
    const double t = k / 1000.0;
    add_row(set, {t, converged(fine.absolute_displacement(midspan, t), displacement_error),
                  converged(fine.friction_force(t), force_error)});
  }
  return set;
}

DataSet length_force_ratios() {
  DataSet set = data_set(
      "length-force", "criterion/length-force.csv", "The criterion over length and axial force",
      "Fig. 14: |f|_max/(mu_s P) over 10 s with N = 10 at 25 Hz and 1 mm for the section 0.2 m x 0.02 m "
      "(case paper-figure14); stick-slip above 1. Points beyond 0.99 of the buckling load are left out.");
  data::Resource& resource = set.resource;
  set_key(resource, {exact_number("length", "m", "L"), exact_number("axial_force", "N", "P")});
  add_values(resource, ValueClass::converged,
             {{"force_ratio", "", "|f|_max/(mu_s P)", Norm::relative, 1e-3}});
  resource.diagnosis = in_case("force ratio", "paper-figure14", "axial_force", "force_ratio");
  constexpr double width = 1e-10, rounding = 1e-9;
  resource.provenance = converged_by(
      "rigorous bounds of the maximum by interval halving in double precision, 1e-10 apart; the half-width "
      "adds 1e-9 for the rounding of the modes, whose phases turn by 1e5 rad",
      R"({"modes": 10, "duration": 10, "relative_width": 1e-10})",
      {"the same search is within its bounds of the enclosures in friction-maxima"});
  const data::Case problem = data::load_case("paper-figure14");
  resource.problem = problem_of(problem, problem.name, "held",
                                {{"/length", in_column("length")},
                                 {"/axial_force", in_column("axial_force")},
                                 {"/modes", "10"},
                                 {"/duration", "10"}});
  for (int tenths = 4; tenths <= 20; ++tenths)
    for (const double axial_force : {10.0, 30.0, 100.0, 300.0, 1000.0, 3000.0, 10000.0, 30000.0}) {
      data::BeamProperties properties = problem.beam.properties();
      properties.length = tenths / 10.0;
      properties.axial_force = axial_force;
      const data::Beam beam(properties);
      if (axial_force > 0.99 * analytic::stick_buckling_load(beam)) continue;
      const analytic::Criterion criterion = analytic::evaluate_criterion(
          beam, problem.friction, problem.excitation, problem.numerics.duration(), problem.numerics.modes(),
          analytic::SteadyPart::modal_sum, width);
      const double ratio = criterion.force_max.midpoint() / criterion.friction_limit;
      add_row(set, {properties.length, axial_force, converged(ratio, (0.5 * width + rounding) * ratio)});
    }
  return set;
}

// max |f| per metre of amplitude over 10 s with all modes, and its half-width.
std::pair<double, double> all_modes_maximum(const NamedBeam& named, int hz) {
  static std::map<std::pair<std::string, int>, std::pair<double, double>> known;
  const auto key = std::pair(named.name, hz);
  if (const auto found = known.find(key); found != known.end()) return found->second;
  constexpr int modes = 100;
  const analytic::StickResponse response(
      named.problem.beam,
      data::HarmonicExcitation({.frequency_hz = static_cast<double>(hz), .amplitude = 1.0}), modes,
      analytic::SteadyPart::exact);
  const analytic::Bounds bounds = response.max_abs_friction_force(10.0);
  constexpr double rounding = 1e-9;  // of the modes, whose phases turn by 1e5 rad and more
  return known[key] = {bounds.midpoint(), 0.5 * (bounds.upper - bounds.lower) +
                                              response.omitted_transient_bound() + rounding * bounds.upper};
}

data::Provenance all_modes_provenance() {
  return converged_by(
      "Eq. (28) with the steady part in closed form and 100 free vibrations; bounds of the maximum over "
      "time. The half-width is half the distance of the bounds, plus a bound of the omitted free "
      "vibrations, 2/3 N |a_N| with the last amplitude a_N and N = 100 (they fall as n^-4; a factor of 2 is "
      "for safety), plus 1e-9 for rounding",
      R"({"free_vibrations": 100, "duration": 10})",
      {"200 free vibrations change no value by more than its half-width",
       "finite elements with a held tip, to their predicted error"});
}

DataSet all_modes_maxima() {
  DataSet set =
      data_set("friction-maxima-all-modes", "criterion/friction-maxima-all-modes.csv",
               "Largest static friction force of the beam",
               "|f|_max over 0 <= t <= 10 s with all modes, the paper's beam at 0.5 mm: for finite elements "
               "and other converged methods, which cannot meet the ten modes of friction-maxima.");
  data::Resource& resource = set.resource;
  set_key(resource, {exact_number("frequency", "Hz", "of the base")});
  add_values(resource, ValueClass::converged, {{"friction_force", "N", "|f|_max", Norm::relative, 1e-2}});
  const NamedBeam& paper = beams().front();
  resource.problem = problem_of(paper.problem, paper.name, "held",
                                {{"/excitation/frequency_hz", in_column("frequency")}, {"/duration", "10"}});
  resource.provenance = all_modes_provenance();
  for (int hz = 1; hz <= 120; ++hz) {
    const auto [value, radius] = all_modes_maximum(paper, hz);
    add_row(set, {hz, converged(5e-4 * value, 5e-4 * radius)});
  }
  return set;
}

DataSet all_modes_amplitudes() {
  DataSet set =
      data_set("critical-amplitudes-all-modes", "criterion/critical-amplitudes-all-modes.csv",
               "Critical amplitudes of the beam",
               "The base amplitude at which |f|_max over 10 s reaches mu_s P = 300 N with all modes: "
               "critical-amplitudes for finite elements and other converged methods.");
  data::Resource& resource = set.resource;
  set_key(resource, {beam_column(), exact_number("frequency", "Hz", "of the base")});
  add_values(resource, ValueClass::converged, {{"amplitude", "m", "A_c", Norm::relative, 1e-2}});
  resource.foreign_keys = {beam_key()};
  resource.problem = problem_of(beams().front().problem, "paper", "held",
                                {{"/beam", in_column("beam")},
                                 {"/excitation/frequency_hz", in_column("frequency")},
                                 {"/excitation/amplitude", in_column("amplitude")},
                                 {"/duration", "10"}});
  resource.provenance = all_modes_provenance();
  for (const NamedBeam& named : {beams().front(), named_beam("paper-half-stiffness")})
    for (int hz = 5; hz <= 120; hz += 5) {
      const auto [value, radius] = all_modes_maximum(named, hz);
      add_row(set, {named.name, hz, converged(300.0 / value, 300.0 * radius / (value * (value - radius)))});
    }
  return set;
}

}  // namespace

std::vector<Recipe> converged_sets() {
  return {
      {"stick-history", stick_history, true, 110},
      {"length-force", length_force_ratios, true, 150},
      {"friction-maxima-all-modes", all_modes_maxima, false, 200},
      {"critical-amplitudes-all-modes", all_modes_amplitudes, false, 210},
  };
}

}  // namespace stickslip::reference
