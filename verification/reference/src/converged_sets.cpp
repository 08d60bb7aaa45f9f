// SPDX-License-Identifier: MIT
/// The data sets with converged values of the held beam: with all modes, and the map of Fig. 14; the undamped stick-slip histories as far as they have converged, and their converged stick phases.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "sets.hpp"
#include "stickslip/analytic/beam_boundary_integral.hpp"
#include "stickslip/analytic/free_mode_run.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/history_convergence.hpp"
#include "studies/history/method.hpp"

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
  const double midspan = 0.5 * problem.beam().length();
  const auto response = [&](int count) {
    return analytic::StickResponse(problem.beam(), problem.excitation(), count, analytic::SteadyPart::exact);
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
      const double length = tenths / 10.0;
      const data::Case point =
          data::with_value(data::with_value(problem, "beam.length", length), "beam.axial_force", axial_force);
      if (axial_force > 0.99 * analytic::stick_buckling_load(point.beam())) continue;
      const analytic::Criterion criterion = analytic::evaluate_criterion(point, width);
      const double ratio = criterion.force_max.midpoint() / criterion.friction_limit;
      add_row(set, {length, axial_force, converged(ratio, (0.5 * width + rounding) * ratio)});
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
      named.problem.beam(),
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
  resource.diagnosis = in_case("force maximum", "paper", "frequency", "friction_force");
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
  resource.diagnosis = for_each_beam("critical amplitude", "frequency", "amplitude");
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

struct Run {
  std::string_view set, file, title, beam, case_name;
  double frequency_hz{}, amplitude{}, duration{};
  int position{};
  int steps_per_sample{4096};
};

// Half a second for the beam of the paper, twelve periods of the excitation for the others.
constexpr std::array<Run, 5> runs{{
    {"undamped-history-25", "stick-slip/undamped-25.csv", "Undamped stick-slip of the paper's beam, 25 Hz",
     "The paper's beam", "paper", 25.0, 1e-3, 0.5, 280},
    {"undamped-history-35", "stick-slip/undamped-35.csv", "Undamped stick-slip of the paper's beam, 35 Hz",
     "The paper's beam", "paper", 35.0, 1e-3, 0.5, 290},
    {"undamped-history-70", "stick-slip/undamped-70.csv", "Undamped stick-slip of the paper's beam, 70 Hz",
     "The paper's beam", "paper", 70.0, 1e-3, 0.5, 300, 8192},
    {"undamped-history-steel-strip", "stick-slip/undamped-steel-strip.csv",
     "Undamped stick-slip of a steel strip, 60 Hz", "The beam steel-strip", "steel-strip", 60.0, 6e-3, 0.2,
     310},
    {"undamped-history-soft-short", "stick-slip/undamped-soft-short.csv",
     "Undamped stick-slip of a soft short beam, 400 Hz", "The beam soft-short", "soft-short", 400.0, 0.7e-3,
     0.03, 320},
}};

constexpr double tolerance = 5e-3;  // relative to the range
// Relative to the range: far above rounding errors and far below the tolerance.
constexpr double least_half_width = 1e-8;
constexpr double shortest_stick = 0.05;        // in periods of the excitation
constexpr double largest_stick_radius = 0.05;  // relative to the duration of the stick phase, at either end

studies::ConvergedEffort effort_of(const Run& run) {
  return {.duration = run.duration,
          .steps_per_sample = run.steps_per_sample,
          .shortest_stick = shortest_stick / run.frequency_hz};
}

data::Case case_of(const Run& run) {
  return with(data::load_case(std::string(run.case_name)),
              data::HarmonicExcitation({.frequency_hz = run.frequency_hz, .amplitude = run.amplitude}));
}

const studies::ConvergedHistory& history_of(const Run& run) {
  static std::map<std::string_view, studies::ConvergedHistory> known;
  if (const auto found = known.find(run.set); found != known.end()) return found->second;
  return known[run.set] = studies::converged_history(case_of(run), effort_of(run));
}

data::Provenance provenance_of(std::string settings) {
  return {
      .value_class = ValueClass::converged,
      .method = fmt::format(
          "the boundary integral of the tip by Runge-Kutta convolution quadrature, friction constant over "
          "a step. Half-width: twice the larger of the differences so far to twice the step and to the free "
          "modes of the beam, propagated exactly, with twice the step; at least {:g} of the range. An "
          "estimate, not a bound",
          least_half_width),
      .settings = std::move(settings),
      .software = software(),
      .checks = {"two methods that share neither kernel nor propagation, each on four steps",
                 "generalised-alpha on 160 elements with spectral radius 0, at 25 Hz, within the "
                 "tolerance"}};
}

// y by places and times.
using Fields = std::vector<std::vector<double>>;

// By free modes, at t = 0 and at ten equal times up to the end of the grid.
Fields free_mode_fields(const data::Case& problem, const analytic::TimeGrid& grid,
                        const std::vector<double>& points) {
  const std::size_t every = grid.steps / 10;
  const int modes = studies::free_modes_for(problem.beam(), grid.time_step);
  const auto shapes = analytic::slip_modes(problem.beam(), modes);
  const auto held = analytic::holding_force(problem.beam(), problem.excitation(), {}, grid);
  analytic::FreeModeRun beam(analytic::free_modes(problem.beam(), modes),
                             {problem.beam().axial_force(), problem.contact.friction}, grid.time_step);
  Fields fields;
  for (const double x : points)
    fields.push_back(analytic::held_displacement(problem.beam(), problem.excitation(), {}, grid, x, every));
  for (std::size_t n = 0; n < held.size(); ++n) {
    static_cast<void>(beam.step(held[n]));
    if ((n + 1) % every != 0) continue;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t k = 0; k < shapes.size(); ++k)
        fields[i][(n + 1) / every] += shapes[k].shape(points[i]) * beam.amplitudes()[k];
  }
  return fields;
}

DataSet undamped_history(const Run& run) {
  const studies::ConvergedEffort effort = effort_of(run);
  DataSet set = data_set(
      std::string(run.set), std::string(run.file), std::string(run.title),
      fmt::format(
          "{} without damping at {:g} Hz and {:g} mm, from the quasi-static start (erratum E4): y = 0 and "
          "y_t = (1 + S(x)) h_t(0), so that the tip is at rest. {} equal samples from 0 to {:g} s. "
          "Stick and slip alternate without a countable sequence of events; the motion converges.",
          run.beam, run.frequency_hz, 1e3 * run.amplitude, effort.samples + 1, run.duration));
  data::Resource& resource = set.resource;
  set_key(resource, {exact_number("time", "s", "since the start")});
  add_values(resource, ValueClass::converged,
             {{"tip_displacement", "m", "y(L, t), in the fixed frame", Norm::range, tolerance},
              {"midspan_displacement", "m", "y(L/2, t), in the fixed frame", Norm::range, tolerance}});
  compare_along(resource, "time");
  resource.comparison->horizon = run.duration;
  resource.diagnosis = in_case("tip displacement", std::string(run.case_name), "time", "tip_displacement");
  resource.problem =
      problem_of(case_of(run), run.case_name, "friction", {{"/duration", fmt::format("{}", run.duration)}});
  resource.provenance = provenance_of(fmt::format(
      R"({{"case": "{}", "frequency_hz": {}, "amplitude": {}, "duration": {}, "samples": {}, )"
      R"("steps_per_sample": {}}})",
      run.case_name, run.frequency_hz, run.amplitude, run.duration, effort.samples, effort.steps_per_sample));
  const studies::ConvergedHistory& history = history_of(run);
  for (std::size_t i = 0; i < history.time.size(); ++i)
    add_row(
        set,
        {fmt::format("{:.9g}", history.time[i]),
         converged(history.tip[i], std::max(history.tip_half_width[i], least_half_width * history.tip_range)),
         converged(history.midspan[i],
                   std::max(history.midspan_half_width[i], least_half_width * history.midspan_range))});
  return set;
}

DataSet undamped_fields() {
  constexpr int times = 10, steps = 1 << 17;  // between two of the times
  constexpr double interval = 0.03;
  const Run& run = runs.front();
  const data::Case problem = case_of(run);
  DataSet set =
      data_set("undamped-fields", "stick-slip/undamped-fields.csv", "The whole undamped beam in stick-slip",
               "The displacement of the beam of undamped-history-25 at 21 points and ten times.");
  data::Resource& resource = set.resource;
  set_key(resource,
          {exact_number("time", "s", "since the start"), exact_number("x", "m", "distance from the clamp")});
  add_values(resource, ValueClass::converged,
             {{"displacement", "m", "y(x, t), absolute", Norm::scale, tolerance}});
  resource.problem =
      problem_of(problem, run.case_name, "friction", {{"/duration", fmt::format("{}", times * interval)}});
  resource.provenance = converged_by(
      "free modes of the beam, propagated exactly, friction constant over a step. Half-width: twice the "
      "larger of the differences so far to twice the step, at all points, and to the boundary integral of "
      "the tip, at the quarters of the length. An estimate, not a bound",
      fmt::format(R"({{"case": "paper", "steps_per_interval": {}}})", steps),
      {"finite elements, to the tolerance; the middle and the tip are those of undamped-history-25"});
  std::vector<double> points;
  for (int k = 0; k <= 20; ++k) points.push_back(problem.beam().length() * k / 20.0);
  const auto grid_of = [&](int count) {
    return analytic::TimeGrid{interval / count,
                              static_cast<std::size_t>(times) * static_cast<std::size_t>(count)};
  };
  const Fields fine = free_mode_fields(problem, grid_of(steps), points),
               coarse = free_mode_fields(problem, grid_of(steps / 2), points);
  const analytic::BeamBoundaryIntegral integral(problem, grid_of(steps));
  Fields other(points.size());
  for (const std::size_t k : {5U, 10U, 15U}) other[k] = integral.displacement(points[k], steps);
  other[20] = integral.tip_displacement(steps);
  double half_width = least_half_width * 1e-3;
  for (std::size_t i = 1; i <= times; ++i) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      half_width = std::max(half_width, 2.0 * std::abs(fine[k][i] - coarse[k][i]));
      if (!other[k].empty()) half_width = std::max(half_width, 2.0 * std::abs(fine[k][i] - other[k][i]));
    }
    for (std::size_t k = 0; k < points.size(); ++k)
      add_row(set, {fmt::format("{:.2f}", interval * static_cast<double>(i)), points[k],
                    converged(fine[k][i], half_width)});
  }
  return set;
}

DataSet undamped_sticks() {
  DataSet set = data_set(
      "undamped-sticks", "stick-slip/undamped-sticks.csv", "Sticks of the undamped histories",
      fmt::format("In each undamped-history: the first stick, which ends with the first slip, and the later "
                  "ones that last {:g} of a period of the excitation or longer and whose ends are known to "
                  "{:g} of their length. Shorter ones cannot be counted. Look yours up by their times: the "
                  "index is of this file.",
                  shortest_stick, largest_stick_radius));
  data::Resource& resource = set.resource;
  std::vector<std::string> histories;
  for (const Run& run : runs) histories.emplace_back(run.set);
  resource.problem = fmt::format(R"({{"history": {}}})", in_column("history"));
  resource.fields = {word("history", "the data set with the history", histories),
                     integer("index", "number of the stick, from 1")};
  add_value(resource.fields, "begin", "s", "capture, or the start", ValueClass::converged);
  add_value(resource.fields, "end", "s", "onset of slip", ValueClass::converged);
  add_value(resource.fields, "position", "m", "y(L), of the tip in the fixed frame", ValueClass::converged);
  resource.primary_key = {"history", "index"};
  resource.provenance = provenance_of(
      fmt::format(R"({{"shortest_stick": {}, "largest_radius": {}}})", shortest_stick, largest_stick_radius));
  for (const Run& run : runs) {
    const studies::ConvergedHistory& history = history_of(run);
    int index = 0;
    const auto add = [&](const studies::ConvergedStick& stick) {
      add_row(set, {std::string(run.set), ++index, converged(stick.begin, stick.begin_half_width),
                    converged(stick.end, stick.end_half_width),
                    converged(stick.position,
                              std::max(stick.position_half_width, least_half_width * history.tip_range))});
    };
    add(history.first_stick);
    for (const studies::ConvergedStick& stick : history.sticks)
      if (std::max(stick.begin_half_width, stick.end_half_width) <=
          largest_stick_radius * (stick.end - stick.begin))
        add(stick);
  }
  return set;
}

}  // namespace

std::vector<Recipe> converged_sets() {
  std::vector<Recipe> recipes{
      {"stick-history", stick_history, true, 110},
      {"length-force", length_force_ratios, true, 150},
      {"friction-maxima-all-modes", all_modes_maxima, false, 200},
      {"critical-amplitudes-all-modes", all_modes_amplitudes, false, 210},
      {"undamped-sticks", undamped_sticks, false, 330},
      {"undamped-fields", undamped_fields, false, 340},
  };
  for (const Run& run : runs)
    recipes.push_back({run.set, [&run] { return undamped_history(run); }, false, run.position});
  return recipes;
}

}  // namespace stickslip::reference
