// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>

#include "case_options.hpp"
#include "commands.hpp"
#include "figure_format.hpp"
#include "output_file.hpp"
#include "render/drawing.hpp"
#include "render/figures.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"
#include "stickslip/solver/modal_analysis.hpp"

namespace stickslip::cli {

namespace {

struct ModesOptions {
  CaseOptions problem;
  std::string state = "stick";
  std::string method = "closed-form";
  int count = 3;
  std::string figure;
};

// A natural frequency and how far to trust it.
struct Frequency {
  double hz{};
  double relative_error{};  // estimate
};

constexpr int most_drawn = 8;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

std::vector<Frequency> closed_form_with_shear(const data::Beam& beam, analytic::TipSupport tip, int count) {
  std::vector<Frequency> frequencies;
  const auto found = analytic::timoshenko_frequencies(beam, tip, count);
  const double load_share = std::max(0.0, beam.axial_force()) / analytic::stick_buckling_load(beam);
  for (const double omega : found)
    frequencies.push_back({omega / (2.0 * std::numbers::pi), 4.0 * epsilon / (1.0 - load_share)});
  return frequencies;
}

std::vector<Frequency> closed_form_stick(const data::Beam& beam, int count) {
  std::vector<Frequency> frequencies;
  for (const auto& mode : analytic::stick_modes(beam, count))
    frequencies.push_back({mode.frequency_hz(), 4.0 * epsilon * mode.condition_number()});
  return frequencies;
}

// Round-off of the characteristic function C over its slope: the sum of the moduli of its terms, times eps,
// divided by |dC/d(ln omega)|, which vanishes where two frequencies coalesce.
double slip_root_error(const data::Beam& beam, const analytic::SlipMode& mode) {
  const double b = mode.hyperbolic_wave_number() * beam.length();
  const double bb = mode.trigonometric_wave_number() * beam.length();
  const double terms = (std::pow(b, 4) + std::pow(bb, 4)) / std::cosh(b) + 2.0 * b * b * bb * bb +
                       b * bb * std::abs(bb * bb - b * b);
  const double omega = mode.angular_frequency(), relative_step = 1e-6;
  const double slope = (analytic::slip_characteristic(beam, omega * (1.0 + relative_step)) -
                        analytic::slip_characteristic(beam, omega * (1.0 - relative_step))) /
                       (2.0 * relative_step);
  return 4.0 * epsilon * (1.0 + terms / std::abs(slope));
}

std::vector<Frequency> closed_form_slip(const data::Beam& beam, int count) {
  std::vector<Frequency> frequencies;
  for (const auto& mode : analytic::slip_modes(beam, count))
    frequencies.push_back({mode.frequency_hz(), slip_root_error(beam, mode)});
  return frequencies;
}

// Leading discretisation error of a frequency on elements of length l, (beta l)^4/1440 with beta^4 = rho A omega^2/EI,
// and with shear rho A omega^2 l^2/(24 k G A), which leaves the axial force out.
double hermite_error(const data::Beam& beam, double omega, double l) {
  const double mass = beam.density() * beam.area();
  const double stiffness = beam.youngs_modulus() * beam.second_moment_of_area();
  const double shear = beam.shear_stiffness() > 0.0 ? 60.0 * stiffness / beam.shear_stiffness() : 0.0;  // m^2
  return mass * omega * omega / stiffness * l * l * (l * l + shear) / 1440.0;
}

std::vector<Frequency> finite_element(const data::Case& problem, bool slip, int count) {
  const solver::BeamModel model(problem.beam, problem.numerics.elements());
  const double element_length = problem.beam.length() / model.elements();
  std::vector<Frequency> frequencies;
  for (const auto& mode : slip ? solver::slip_modes(model, count) : solver::stick_modes(model, count))
    frequencies.push_back({mode.angular_frequency / (2.0 * std::numbers::pi),
                           hermite_error(problem.beam, mode.angular_frequency, element_length)});
  return frequencies;
}

std::vector<Frequency> frequencies_of(const data::Case& problem, const ModesOptions& options) {
  const bool slip = options.state == "slip";
  if (options.method == "fe") return finite_element(problem, slip, options.count);
  if (problem.beam.shear_stiffness() > 0.0)
    return closed_form_with_shear(
        problem.beam, slip ? analytic::TipSupport::free : analytic::TipSupport::held, options.count);
  return slip ? closed_form_slip(problem.beam, options.count)
              : closed_form_stick(problem.beam, options.count);
}

// Value of each mode at equally spaced points of the beam, [point][mode].
std::vector<std::vector<double>> shapes_of(const data::Case& problem, const ModesOptions& options,
                                           const std::vector<double>& points) {
  std::vector<std::vector<double>> values(points.size());
  const auto evaluate = [&](const auto& modes) {
    for (std::size_t i = 0; i < points.size(); ++i)
      for (const auto& mode : modes) values[i].push_back(mode.shape(points[i]));
  };
  if (options.method == "fe") {
    const solver::BeamModel model(problem.beam, problem.numerics.elements());
    const auto modes = options.state == "slip" ? solver::slip_modes(model, options.count)
                                               : solver::stick_modes(model, options.count);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto weights = model.interpolation(points[i]);
      for (const auto& mode : modes) values[i].push_back(weights.dot(mode.shape));
    }
  } else if (options.state == "slip") {
    evaluate(analytic::slip_modes(problem.beam, options.count));
  } else {
    evaluate(analytic::stick_modes(problem.beam, options.count));
  }
  return values;
}

// The shapes, a column each with its frequency as name, divided by their value of largest modulus.
void write_figure(const data::Case& problem, const ModesOptions& options,
                  const std::vector<Frequency>& frequencies, OutputFile& file) {
  constexpr int intervals = 400;
  std::vector<double> points;
  for (int i = 0; i <= intervals; ++i) points.push_back(problem.beam.length() * i / intervals);
  auto values = shapes_of(problem, options, points);
  std::vector<report::CsvColumn> columns{{"x", "m"}};
  for (std::size_t n = 0; n < frequencies.size(); ++n) {
    columns.push_back({fmt::format("{}: {:.6g} Hz", n + 1, frequencies[n].hz), "1"});
    double largest = 0.0;
    for (const auto& row : values)
      if (std::abs(row[n]) > std::abs(largest)) largest = row[n];
    for (auto& row : values) row[n] /= largest;
  }
  report::CsvTable table("Modes of the case " + problem.name, columns);
  for (std::size_t i = 0; i < points.size(); ++i) {
    values[i].insert(values[i].begin(), points[i]);
    table.add_numbers(values[i]);
  }
  file.write(report::drawing_of("modes", figure_format(options.figure), {{"modes.csv", table.text()}}));
  file.commit();
}

void print_table(const data::Case& problem, const ModesOptions& options,
                 const std::vector<Frequency>& frequencies) {
  const std::string method =
      options.method == "fe" ? fmt::format("{} finite elements", problem.numerics.elements()) : "closed form";
  fmt::print("{}: {} state, {}\n\nmode  frequency / Hz\n", problem.name, options.state, method);
  int number = 0;
  for (const auto& frequency : frequencies)
    fmt::print("{:>4}  {}\n", ++number,
               significant(frequency.hz, digits_that_hold(frequency.relative_error)));
  if (studies::is_damped(problem))
    fmt::print("\nThese are the undamped frequencies; the damping of the case is left out.\n");
}

Json to_json(const data::Case& problem, const ModesOptions& options,
             const std::vector<Frequency>& frequencies, const std::vector<std::string>& warnings) {
  Json hz = Json::array(), errors = Json::array();
  for (const auto& frequency : frequencies) {
    hz.push_back(frequency.hz);
    errors.push_back(frequency.relative_error);
  }
  Json object{{"case", problem.name}, {"state", options.state}, {"method", options.method}};
  if (options.method == "fe") object["elements"] = problem.numerics.elements();
  object["frequencies_hz"] = hz;
  object["relative_error_estimates"] = errors;
  if (studies::is_damped(problem)) object["undamped"] = true;
  object["warnings"] = warnings;
  return object;
}

void run(const ModesOptions& options) {
  const data::Case problem = data::load_case(options.problem.name, overrides_of(options.problem));
  data::require_rigid(problem.contact, "the modes, whose tip is held or free; respond takes it");
  std::optional<OutputFile> figure;
  open_figure(figure, options.figure);
  if (figure && options.count > most_drawn)
    throw data::FieldError("--count", options.count, fmt::format("at most {} with --figure", most_drawn));
  const auto frequencies = frequencies_of(problem, options);
  const auto warnings = warnings_of(
      problem,
      options.state == "slip" ? studies::Inquiry::slip_frequencies : studies::Inquiry::stick_frequencies,
      options.count);
  const Json answer = to_json(problem, options, frequencies, warnings);
  require_finite(answer);
  if (figure) write_figure(problem, options, frequencies, *figure);
  print_warnings(warnings);
  if (options.problem.json)
    print_json(answer);
  else
    print_table(problem, options, frequencies);
}

}  // namespace

void add_modes_command(CLI::App& app) {
  auto* command = app.add_subcommand("modes", "Natural frequencies of the stick or the slip state");
  auto options = std::make_shared<ModesOptions>();
  add_case_options(*command, options->problem);
  command->add_option("--state", options->state, "Tip pinned to the wall, or sliding under the axial force")
      ->check(one_of({"stick", "slip"}))
      ->capture_default_str();
  command->add_option("--method", options->method, "Of the continuous beam, or of its finite elements")
      ->check(one_of({"closed-form", "fe"}))
      ->capture_default_str();
  command->add_option("--count", options->count, "How many, from the lowest")
      ->check(integer_between(1, 1000))
      ->capture_default_str();
  add_figure_option(*command, options->figure);
  add_examples(*command, {"stickslip modes steel-strip --state slip --count 5 --figure modes.png",
                          "stickslip modes paper --method fe --set numerics.elements=40"});
  command->callback([options] { run(*options); });
}

}  // namespace stickslip::cli
