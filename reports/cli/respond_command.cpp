// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <optional>
#include <string>

#include "case_options.hpp"
#include "command.hpp"
#include "commands.hpp"
#include "history_output.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/history/method.hpp"

namespace stickslip::cli {

namespace {

struct RespondOptions {
  CaseOptions problem;
  std::optional<std::string> method;
  std::string initial_velocity = "quasi-static";
  std::optional<std::string> scheme;
  HistoryOptions history;
};

Answer respond_answer(const data::Case& problem, const RespondOptions& options,
                      const studies::MethodChoice& choice, const studies::History& history,
                      const HistoryOutput& output) {
  const studies::Method& method = *choice.method;
  Answer answer;
  add_method(answer, choice);
  add_excitation(answer, problem);
  answer.add_members({{"duration_s", problem.numerics.duration()},
                      {"output", options.history.output},
                      {"rows", output.rows()},
                      {"time_steps_in_a_row", output.row_step()},
                      {"largest_friction_force_N", output.largest_force()},
                      {"largest_deflection_m", output.largest_deflection()},
                      {"first_slip_s", optional_json(history.first_slip)},
                      {"changes_of_contact", history.events.size()}});
  if (method.basis == studies::Basis::whole_beam)
    answer.add_members({{"integration_step_s", studies::boundary_integral_step(problem)},
                        {"largest_change_on_twice_the_step_m", optional_json(history.step_effect)}});
  if (method.basis == studies::Basis::elements)
    answer.add_members({{"scheme", options.scheme.value_or("located")}});
  if (output.window())
    answer.add_members({{"spectrum_window", output.spectrum().is_flat_top ? "flat-top" : "whole periods"},
                        {"spectrum_rows", output.window()->rows}});
  if (problem.has(data::Feature::general_motion)) answer.add_line(conditions_of(problem));
  answer.add_line(
      fmt::format("{} rows written to {}{}", output.rows(), options.history.output,
                  output.row_step() > 1 ? fmt::format(", one in {} time steps", output.row_step()) : ""));
  answer.add_line(fmt::format("largest |f| {:.4g} N, largest deflection of the contact {:.4g} m; {}",
                              output.largest_force(), output.largest_deflection(),
                              problem.contact.compliance.is_smooth() ? "a smooth law slips all the time"
                              : history.first_slip
                                  ? fmt::format("first slip at {:.6g} s", *history.first_slip)
                                  : "no slip"));
  if (output.bending().deflection > 0.0) add_bending(answer, problem.beam(), output.bending());
  return answer;
}

Answer respond(const RespondOptions& options, Outputs& outputs) {
  const data::Case problem = load_case(options.problem);
  studies::MotionRequest request{.method = options.method,
                                 .run = {.starts_with_the_base = options.initial_velocity == "zero"},
                                 .of_elements = options.scheme ? "--scheme" : mesh_key_of(options.problem)};
  solver::RunOptions& run = request.run;
  if (options.scheme) run.scheme = studies::contact_schemes().at(*options.scheme);
  if (!options.history.columns.empty()) request.features.insert(data::Feature::further_columns);
  if (!options.history.events.empty()) request.features.insert(data::Feature::slip);
  const studies::MethodChoice choice = studies::method_for(problem, request);
  const studies::Method& method = *choice.method;
  outputs.set_case(problem);
  HistoryOutput output(problem, options.history, !method.follows_slip(), outputs);
  outputs.on_interrupt([&] {
    return fmt::format("interrupted at {} s of {} s; {}", data::shortest_text(output.time()),
                       data::shortest_text(problem.numerics.duration()),
                       options.history.output == "-" ? "standard output holds the history up to there at most"
                                                     : "nothing is kept");
  });
  // The largest values are those of all that is looked at: all time steps of a method in steps, else as many as it takes.
  const long step = method.in_time_steps ? 1 : studies::look_step(problem, output.row_step());
  studies::Sampling sampling{.every = step, .with_reactions = !options.history.columns.empty()};
  if (method.basis != studies::Basis::whole_beam &&
      problem.model() == nullptr) {  // each position would take it half of its time again
    sampling.positions = studies::Bending::positions(problem.beam().length());
    sampling.positions_every = studies::usual_row_step(problem, problem.numerics.duration());
  }
  const auto history =
      method.run(problem, sampling, run, [&](const studies::HistoryRow& row) { output.add(row, step); });
  output.finish(history);
  Answer answer = respond_answer(problem, options, choice, history, output);
  answer.warnings = studies::warnings_after(problem, method, history, run);
  add_warning(answer, studies::row_warning(problem, method, step, output.row_step()));
  if (options.scheme && *options.scheme != "located")
    add_warning(answer,
                fmt::format("--scheme {} is a comparison: changes of contact come up to a step late, and "
                            "forces and changes may be far off; located is the scheme for results",
                            *options.scheme));
  add_warning(answer, studies::deflection_warning(problem, output.largest_deflection()));
  add_warning(answer, studies::draw_back_warning(problem, output.bending().draw_back));
  if (run.starts_with_the_base)
    add_warning(answer, std::string("--initial-velocity zero starts with a blow of the base: the largest |f| "
                                    "just after it grows with the modes or elements without a limit, so that "
                                    "it and a slip, or none, that follows from it are no results"));
  if (output.window() && !output.spectrum().is_flat_top && output.spectrum().leak > studies::allowed_leak)
    add_warning(answer, fmt::format("{:.2g} % of the amplitude in the spectrum is no harmonic of the base, "
                                    "and leaks into all lines: the window has {} periods of the base; from 8 "
                                    "on, a duration of {} s, a flat-top window takes its place",
                                    100.0 * output.spectrum().leak, output.window()->periods,
                                    data::shortest_text(16.0 / data::highest_frequency_hz(problem))));
  return answer;
}

void add_columns_option(CLI::App& command, std::vector<std::string>& columns) {
  std::vector<std::string> names;
  for (const auto& column : studies::further_columns) names.emplace_back(column.name);
  command
      .add_option(
          "--columns", columns,
          "Further columns of the CSV file, a list with commas: the absolute acceleration of the tip, "
          "the force and the moment that the base must apply")
      ->delimiter(',')
      ->check(one_of(names));
}

void add_options(CLI::App& command, RespondOptions& options) {
  add_case_options(command, options.problem);
  options.problem.rigid_for.clear();
  add_excitation_options(command, options.problem);
  command
      .add_option("--method", options.method,
                  "Finite elements with contact, event by event in the modes of the continuous beam, the "
                  "boundary integral of the tip (all modes, no mesh; the one that converges without "
                  "damping), or the closed form of the stick state (default: the first line of the answer "
                  "says which and why)")
      ->check(one_of(studies::method_names()));
  add_choice_option(command, "--initial-velocity", options.initial_velocity, {"quasi-static", "zero"},
                    "u_t(x,0): S(x) h_t(0), or the zero of the paper's text (an impulsive start)");
  command
      .add_option(
          "--scheme", options.scheme,
          "When the contact changes: located inside the step, at the end of the step, or as printed in "
          "the paper (threshold, no impulse); the last two show what the first is worth (default: located)")
      ->check(one_of({"end-of-step", "located", "paper"}));
  add_duration_option(command, options.problem);
  add_file_option(command, "--output", options.history.output, "CSV file, '-' for standard output");
  add_columns_option(command, options.history.columns);
  add_file_option(command, "--events", options.history.events, "CSV file for the changes of contact");
  add_file_option(command, "--spectrum", options.history.spectrum,
                  "CSV file for the amplitude spectra of tip and friction force, over the whole periods of "
                  "the base motion in the second half of the duration");
  add_figure_option(command, options.history.figure);
  auto* every = command
                    .add_option("--every", options.history.every,
                                "Write every N-th time step (default: as few as leave 100 rows in a period "
                                "of the base, 20 in one of the first natural frequency and 2000 in all)")
                    ->transform(integer_between(1, 1'000'000'000));
  command.add_option("--rate", options.history.rate, "Write at least so many rows a second")
      ->transform(number("Hz"))
      ->excludes(every);
  command.add_option("--from", options.history.from, "Write and draw rows from this time on, s")
      ->transform(time())
      ->capture_default_str();
  command.add_option("--to", options.history.to, "Write and draw rows up to this time, s (else all)")
      ->transform(time());
}

}  // namespace

void add_respond_command(CLI::App& app) {
  add<RespondOptions>(
      app, {.name = "respond",
            .help = "Displacements and friction force in time, as CSV",
            .examples = {"stickslip respond paper --hz 25 --amplitude 1e-3 --duration 1 --output history.csv",
                         "stickslip respond steel-strip --method event-driven --duration 0.2 --events "
                         "events.csv --output history.csv"},
            .add_options = add_options,
            .run = respond});
}

}  // namespace stickslip::cli
