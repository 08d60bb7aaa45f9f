// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <string>
#include <vector>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "render/drawing.hpp"
#include "studies/history/natural_frequencies.hpp"

namespace stickslip::cli {

namespace {

constexpr int most_drawn = 8;

struct ModesOptions {
  CaseOptions problem;
  std::string state = "stick";
  std::string method = studies::closed_form().name;
  int count = 3;
  std::string figure;

  [[nodiscard]] bool is_mesh() const { return studies::method(method).basis == studies::Basis::elements; }
  [[nodiscard]] analytic::TipSupport tip() const {
    return state == "slip" ? analytic::TipSupport::free : analytic::TipSupport::held;
  }
};

// The shapes, a column each with its frequency as name.
std::string drawing(const data::Case& problem, const ModesOptions& options,
                    const std::vector<studies::EstimatedFrequency>& frequencies, const report::Look& look) {
  constexpr int intervals = 400;
  std::vector<double> points;
  for (int i = 0; i <= intervals; ++i) points.push_back(problem.beam().length() * i / intervals);
  auto rows = options.is_mesh()
                  ? studies::mesh_shapes(problem, options.tip(), options.count, points)
                  : studies::closed_form_shapes(problem.beam(), options.tip(), options.count, points);
  std::string columns = "x [m]";
  for (std::size_t n = 0; n < frequencies.size(); ++n)
    columns += fmt::format(", {}: {:.6g} Hz [1]", n + 1, frequencies[n].hz);
  report::CsvTable table("Modes of the case " + problem.name, columns);
  for (std::size_t i = 0; i < points.size(); ++i) {
    rows[i].insert(rows[i].begin(), points[i]);
    table.add_numbers(rows[i]);
  }
  return report::drawing_of("modes", look, {{"modes.csv", table.text()}});
}

Answer modes_answer(const data::Case& problem, const ModesOptions& options,
                    const std::vector<studies::EstimatedFrequency>& frequencies) {
  Answer answer;
  answer.add_members({{"state", options.state}, {"method", options.method}});
  if (options.is_mesh() && problem.model() == nullptr)
    answer.add_members({{"elements", problem.numerics.elements()}});
  answer.add_line(fmt::format("{} state, {}\n\nmode  frequency / Hz", options.state,
                              !options.is_mesh() ? "closed form"
                              : problem.model() != nullptr
                                  ? "all rows of the matrices"
                                  : fmt::format("{} finite elements", problem.numerics.elements())));
  Json hz = Json::array(), errors = Json::array();
  for (const auto& frequency : frequencies) {
    hz.push_back(frequency.hz);
    errors.push_back(frequency.relative_error);
    answer.add_line(fmt::format("{:>4}  {}", hz.size(),
                                significant(frequency.hz, digits_that_hold(frequency.relative_error))));
  }
  answer.add_members({{"frequencies_hz", hz}, {"relative_error_estimates", errors}});
  if (problem.is_damped()) {
    answer.add_line("\nThese are the undamped frequencies; the damping of the case is left out.");
    answer.add_members({{"undamped", true}});
  }
  return answer;
}

Answer modes(const ModesOptions& options, Outputs& outputs) {
  const data::Case problem = load_case(options.problem);
  outputs.set_case(problem);
  outputs.open({{"--figure", options.figure}});
  if (outputs.has("--figure") && options.count > most_drawn)
    throw data::FieldError("--count", options.count, fmt::format("at most {} with --figure", most_drawn));
  const auto frequencies = options.is_mesh()
                               ? studies::mesh_frequencies(problem, options.tip(), options.count)
                               : studies::closed_form_frequencies(problem, options.tip(), options.count);
  Answer answer = modes_answer(problem, options, frequencies);
  answer.warnings = sentences_of(studies::frequency_warnings(problem, options.tip(), options.count));
  require_finite(answer.json);
  outputs.draw(problem.name,
               [&](const report::Look& look) { return drawing(problem, options, frequencies, look); });
  return answer;
}

void add_options(CLI::App& command, ModesOptions& options) {
  add_case_options(command, options.problem);
  add_choice_option(command, "--state", options.state, {"stick", "slip"},
                    "Tip pinned to the wall, or sliding under the axial force");
  add_choice_option(command, "--method", options.method,
                    {studies::closed_form().name, studies::finite_elements().name},
                    "Of the continuous beam, or of its finite elements");
  add_integer_option(command, "--count", options.count, 1, 1000, "How many, from the lowest");
  add_figure_option(command, options.figure);
}

}  // namespace

void add_modes_command(CLI::App& app) {
  add<ModesOptions>(app,
                    {.name = "modes",
                     .help = "Natural frequencies of the stick or the slip state",
                     .examples = {"stickslip modes steel-strip --state slip --count 5 --figure modes.png",
                                  "stickslip modes paper --method fe --set numerics.elements=40"},
                     .add_options = add_options,
                     .run = modes});
}

}  // namespace stickslip::cli
