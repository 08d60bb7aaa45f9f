// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <memory>
#include <string>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "history_output.hpp"
#include "render/interruption.hpp"
#include "studies/history/runs.hpp"
#include "studies/history/spectrum.hpp"

namespace stickslip::cli {

namespace {

struct RespondOptions {
  CaseOptions problem;
  ExcitationOptions excitation;
  std::string method = "fe";
  std::string initial_velocity = "quasi-static";
  std::optional<std::string> scheme;
  std::optional<double> duration;
  HistoryFiles files;
};

// What one option rules out of another.
void require_consistent(const RespondOptions& options) {
  const auto& [output, events, spectrum, figure, every] = options.files;
  require_json_alone(options.problem.json, "--output", output);
  require_json_alone(options.problem.json, "--events", events);
  require_json_alone(options.problem.json, "--spectrum", spectrum);
  require_different_files(
      {{"--output", output}, {"--events", events}, {"--spectrum", spectrum}, {"--figure", figure}});
}

Json to_json(const data::Case& problem, const RespondOptions& options, const studies::History& history,
             const HistoryOutput& output) {
  Json object{{"case", problem.name},
              {"method", options.method},
              {"frequency_hz", problem.excitation.frequency_hz()},
              {"amplitude_m", problem.excitation.amplitude()},
              {"duration_s", problem.numerics.duration()},
              {"output", options.files.output},
              {"rows", output.rows()},
              {"largest_friction_force_N", output.largest_force()},
              {"first_slip_s", optional_json(history.first_slip)},
              {"changes_of_contact", history.events.size()}};
  if (options.method == "boundary-integral") {
    object["integration_step_s"] = studies::boundary_integral_step(problem);
    object["largest_change_on_twice_the_step_m"] = optional_json(history.step_effect);
  }
  if (options.method == "fe") object["scheme"] = options.scheme.value_or("located");
  object["numerics"] = numerics_json(problem);
  return object;
}

void run(const RespondOptions& options) {
  const data::Case problem = load_case(options.problem, options.excitation, options.duration);
  require_consistent(options);
  const HistoryFiles& files = options.files;
  const studies::Method& method = studies::method(options.method);
  studies::RunChoices choices;
  if (options.initial_velocity == "zero") choices.initial_velocity = solver::InitialVelocity::zero;
  if (options.scheme) choices.scheme = studies::contact_schemes().at(*options.scheme);
  if (!files.events.empty()) method.require(studies::Feature::slip, "--method", method.name);
  method.require(problem, choices);
  if (!files.spectrum.empty()) (void)studies::spectrum_rows(problem, files.every);
  HistoryOutput output(problem, files);
  const report::Interruption interruption([&] {
    output.discard();
    return fmt::format(
        "interrupted at {} s of {} s; {}", data::shortest_text(output.time()),
        data::shortest_text(problem.numerics.duration()),
        files.output == "-" ? "standard output holds the history up to there at most" : "nothing is kept");
  });
  const auto history = method.run(problem, {.every = files.every}, choices,
                                  [&](const studies::HistoryRow& row) { output.add(row); });
  output.finish(history);
  const auto warnings = studies::warnings_after(problem, method.inquiry, history);
  print_warnings(warnings);
  if (options.problem.json) {
    Json object = to_json(problem, options, history, output);
    object["warnings"] = warnings;
    print_json(object);
  } else if (files.output != "-" && files.events != "-" && files.spectrum != "-") {
    fmt::print("{} rows written to {}\n", output.rows(), files.output);
  }
}

}  // namespace

void add_respond_command(CLI::App& app) {
  auto* command = app.add_subcommand("respond", "Displacements and friction force in time, as CSV");
  auto options = std::make_shared<RespondOptions>();
  add_case_options(*command, options->problem);
  add_excitation_options(*command, options->excitation);
  command
      ->add_option(
          "--method", options->method,
          "Finite elements with contact, event by event in the modes of the continuous beam, the boundary "
          "integral of the tip (all modes, no mesh; the one that converges without damping), or the closed "
          "form of the stick state")
      ->check(one_of(studies::method_names()))
      ->capture_default_str();
  command
      ->add_option("--initial-velocity", options->initial_velocity,
                   "u_t(x,0): S(x) h_t(0), or the zero of the paper's text (an impulsive start)")
      ->check(one_of({"quasi-static", "zero"}))
      ->capture_default_str();
  command
      ->add_option("--scheme", options->scheme,
                   "When the contact changes: located inside the step, at the end of the step, or by the "
                   "letter of the paper (threshold, no impulse); the last two show what the first is worth "
                   "(default: located)")
      ->check(one_of({"end-of-step", "located", "paper"}));
  command->add_option("--duration", options->duration, "Duration, s (else that of the case)")
      ->check(number());
  command->add_option("--output", options->files.output, "CSV file, '-' for standard output")
      ->check(file_name())
      ->capture_default_str();
  command->add_option("--events", options->files.events, "CSV file for the changes of contact")
      ->check(file_name());
  command
      ->add_option(
          "--spectrum", options->files.spectrum,
          "CSV file for the amplitude spectra of tip and friction force, over the whole periods of the base "
          "motion in the second half of the duration")
      ->check(file_name());
  add_figure_option(*command, options->files.figure);
  command->add_option("--every", options->files.every, "Write every N-th time step only")
      ->check(integer_between(1, 1'000'000'000))
      ->capture_default_str();
  add_examples(*command,
               {"stickslip respond paper --hz 25 --amplitude 1e-3 --duration 1 --output history.csv",
                "stickslip respond steel-strip --method event-driven --duration 0.2 --events events.csv "
                "--output history.csv"});
  command->callback([options] { run(*options); });
}

}  // namespace stickslip::cli
