// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "case_options.hpp"
#include "commands.hpp"
#include "figure_format.hpp"
#include "output_file.hpp"
#include "render/drawing.hpp"
#include "render/figures.hpp"
#include "render/interruption.hpp"
#include "stickslip/analytic/amplitude_spectrum.hpp"
#include "stickslip/analytic/beam_boundary_integral.hpp"
#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/beam_simulation.hpp"

namespace stickslip::cli {

namespace {

struct RespondOptions {
  CaseOptions problem;
  ExcitationOptions excitation;
  std::string method = "fe";
  std::string initial_velocity = "quasi-static";
  std::optional<std::string> scheme;
  std::optional<double> duration;
  std::string output = "-";
  std::string events;
  std::string spectrum;
  std::string figure;
  long every = 1;
};

struct Row {
  double time{};                  // s
  double base_displacement{};     // h, m
  double tip_displacement{};      // y(L), m
  double midspan_displacement{};  // y(L/2), m
  double sliding_velocity{};      // m/s
  double friction_force{};        // f of Eq. (28), N
  std::string_view state = "stick";
};

constexpr std::string_view header =
    "time_s,base_displacement_m,tip_displacement_m,midspan_displacement_m,"
    "sliding_velocity_m_per_s,friction_force_N,state\n";

void require_finite_row(const Row& row) {
  for (const double value : {row.base_displacement, row.tip_displacement, row.midspan_displacement,
                             row.sliding_velocity, row.friction_force})
    if (!std::isfinite(value))
      data::throw_overflow(fmt::format("the history is not finite at {} s", data::shortest_text(row.time)));
}

std::string csv_line(const Row& row) {
  const auto text = [](double value) { return data::shortest_text(value + 0.0); };  // -0 becomes 0
  return fmt::format("{},{},{},{},{},{},{}\n", text(row.time), text(row.base_displacement),
                     text(row.tip_displacement), text(row.midspan_displacement), text(row.sliding_velocity),
                     text(row.friction_force), row.state);
}

// A change of contact, as --events writes it.
struct EventRow {
  double time{};  // s
  std::string_view change;
  double tip_displacement{};  // y(L), m
};

constexpr std::string_view events_header = "time_s,change,tip_displacement_m\n";

// What a history says in one glance.
struct Summary {
  long rows{};
  double largest_force{};            // max |f| over the rows, N
  std::optional<double> first_slip;  // s; closed form: of the first row with |f| > mu_s P
  std::vector<EventRow> events;
  std::vector<double> tip_displacements, friction_forces;  // of the rows, if there is to be a spectrum
  std::optional<double> step_effect;  // boundary integral: largest change of y(L) on twice the step, m
};

class Writer {
 public:
  Writer(const std::string& path, bool keeps_text, bool keeps_values)
      : file_(path), keeps_text_(keeps_text), keeps_values_(keeps_values) {}

  // The header goes before the first row, so that an error in the problem writes nothing.
  void write(const Row& row) {
    require_finite_row(row);
    if (summary_.rows == 0) put(header);
    put(csv_line(row));
    if (keeps_values_) {
      summary_.tip_displacements.push_back(row.tip_displacement);
      summary_.friction_forces.push_back(row.friction_force);
    }
    time_ = row.time;
    ++summary_.rows;
    summary_.largest_force = std::max(summary_.largest_force, std::abs(row.friction_force));
  }

  [[nodiscard]] Summary& summary() { return summary_; }

  /// What was written, if it is kept.
  [[nodiscard]] const std::string& text() const { return text_; }

  /// Of the last row, s; any thread may ask.
  [[nodiscard]] double time() const { return time_; }

  void discard() const noexcept { file_.discard(); }

  void finish() {
    file_.commit();
    if (!summary_.events.empty()) summary_.first_slip = summary_.events.front().time;
  }

 private:
  void put(std::string_view text) {
    file_.write(text);
    if (keeps_text_) text_ += text;
  }

  OutputFile file_;
  bool keeps_text_, keeps_values_;
  std::string text_;
  Summary summary_;
  std::atomic<double> time_{};
};

long steps_of(const data::Case& problem) {
  return solver::step_count(problem.numerics.duration(), problem.numerics.time_step());
}

Row row_of(const analytic::StickResponse& response, double length, double t) {
  return {.time = t,
          .base_displacement = response.base_displacement(t),
          .tip_displacement = response.absolute_displacement(length, t),
          .midspan_displacement = response.absolute_displacement(length / 2.0, t),
          .friction_force = response.friction_force(t)};
}

Row row_of(const solver::BeamSimulation& simulation) {
  return {.time = simulation.time(),
          .base_displacement = simulation.base_displacement(),
          .tip_displacement = simulation.tip_displacement(),
          .midspan_displacement = simulation.midspan_displacement(),
          .sliding_velocity = simulation.sliding_velocity(),
          .friction_force = simulation.friction_force(),
          .state = simulation.state() == data::ContactState::stick ? "stick" : "slip"};
}

void write_closed_form(const data::Case& problem, const RespondOptions& options, Writer& writer) {
  const analytic::StickResponse response(problem.beam, problem.excitation, problem.numerics.modes());
  const double limit = problem.friction.static_coefficient() * problem.beam.axial_force();
  const long steps = steps_of(problem);
  for (long n = 0; n <= steps; n += options.every) {
    const Row row =
        row_of(response, problem.beam.length(), static_cast<double>(n) * problem.numerics.time_step());
    writer.write(row);
    auto& first_slip = writer.summary().first_slip;
    if (!first_slip && std::abs(row.friction_force) > limit) first_slip = row.time;
  }
}

const std::map<std::string, solver::ContactScheme> schemes{
    {"located", solver::ContactScheme::located},
    {"end-of-step", solver::ContactScheme::end_of_step},
    {"paper", solver::ContactScheme::paper}};

void write_finite_element(const data::Case& problem, const RespondOptions& options, Writer& writer) {
  const auto initial_velocity = options.initial_velocity == "zero" ? solver::InitialVelocity::zero
                                                                   : solver::InitialVelocity::quasi_static;
  solver::BeamSimulation simulation(problem.beam, problem.friction, problem.excitation, problem.numerics,
                                    {.initial_velocity = initial_velocity,
                                     .damping = problem.damping,
                                     .scheme = schemes.at(options.scheme.value_or("located")),
                                     .coordinates = solver::Coordinates::fastest,
                                     .tangential = problem.contact,
                                     .wall = problem.wall});
  const long steps = steps_of(problem);
  for (long n = 0; n <= steps; ++n) {
    if (n > 0) simulation.step();
    if (n % options.every == 0) writer.write(row_of(simulation));
  }
  for (const auto& event : simulation.integrator().events())
    writer.summary().events.push_back(
        {event.time, data::name_of(event.change), event.position + problem.wall.speed() * event.time});
}

void write_event_driven(const data::Case& problem, const RespondOptions& options, Writer& writer) {
  const double length = problem.beam.length();
  const analytic::BeamContactModel beam(problem.beam, problem.friction, problem.excitation, problem.damping,
                                        problem.numerics.modes(), problem.wall);
  const analytic::ContactModel& model = beam.model();
  analytic::EventDriven run(model);
  // u_t = sigma w_t + sum U_n T_n_t: zero rates are the quasi-static start, and -a_n w_t a beam at rest.
  std::vector<double> rates;
  if (options.initial_velocity == "zero")
    for (const double coupling : model.mass_coupling)
      rates.push_back(-coupling * (model.wall_amplitude * model.load_angular_frequency + model.wall_speed));
  run.start_stuck({}, rates);

  const std::vector<double> midspan = beam.shapes(length / 2.0);
  const long steps = steps_of(problem);
  for (long n = 0; n <= steps; n += options.every) {
    run.advance_to(static_cast<double>(n) * problem.numerics.time_step());
    writer.write({.time = run.time(),
                  .base_displacement = -run.drive_displacement(),
                  .tip_displacement = run.contact_displacement() - run.drive_displacement(),
                  .midspan_displacement = analytic::absolute_displacement(midspan, run),
                  .sliding_velocity = run.sliding_velocity(),
                  .friction_force = -run.friction_force(),
                  .state = run.state() == data::ContactState::stick ? "stick" : "slip"});
  }
  for (const auto& event : run.events())
    writer.summary().events.push_back(
        {event.time, data::name_of(event.change), event.position + model.wall_speed * event.time});
}

// A run of the boundary integral with so many steps for each row of the output.
analytic::BeamBoundaryIntegral boundary_integral_of(const data::Case& problem, std::size_t steps_per_row) {
  const auto rows = static_cast<std::size_t>(steps_of(problem));
  return {problem.beam,
          problem.friction,
          problem.excitation,
          problem.damping,
          {problem.numerics.time_step() / static_cast<double>(steps_per_row), rows * steps_per_row},
          3,
          problem.contact};
}

// Velocity and force are means over steps; at a row, the mean of the steps before and after it. The force of
// the start is extrapolated: the tip sticks there.
Row contact_at(const std::vector<analytic::ContactStep>& steps, std::size_t step) {
  const auto& before = steps[step == 0 ? 0 : step - 1];
  const auto& after = steps[step == steps.size() ? steps.size() - 1 : step];
  const bool sticks = !before.slides;
  const double force = step == 0 && steps.size() > 1
                           ? 1.5 * steps[0].friction_force - 0.5 * steps[1].friction_force
                           : 0.5 * (before.friction_force + after.friction_force);
  return {.sliding_velocity =
              before.sliding_velocity == 0.0 ? 0.0 : 0.5 * (before.sliding_velocity + after.sliding_velocity),
          .friction_force = -force,
          .state = sticks ? "stick" : "slip"};
}

// Where the direction of sliding changes from one step to the next; 0 is none.
std::vector<EventRow> events_of(const analytic::BeamBoundaryIntegral& run) {
  std::vector<EventRow> events;
  double position = 0.0, direction = 0.0;
  for (std::size_t n = 0; n < run.steps().size(); ++n) {
    const double velocity = run.steps()[n].sliding_velocity;
    const double next = run.steps()[n].slides ? std::copysign(1.0, velocity) : 0.0;
    if (next != direction)
      events.push_back({static_cast<double>(n) * run.grid().time_step,
                        direction == 0.0 ? "onset"
                        : next == 0.0    ? "capture"
                                         : "reversal",
                        position});
    direction = next;
    position += run.grid().time_step * velocity;
  }
  return events;
}

// Rows are numerics.time_step apart; the method steps by studies::boundary_integral_step().
void write_boundary_integral(const data::Case& problem, const RespondOptions& options, Writer& writer) {
  const double row_step = problem.numerics.time_step();
  const auto every =
      static_cast<std::size_t>(std::lround(row_step / studies::boundary_integral_step(problem)));
  const analytic::BeamBoundaryIntegral run = boundary_integral_of(problem, every);
  const std::vector<double> tip = run.tip_displacement(every),
                            midspan = run.displacement(problem.beam.length() / 2.0, every);
  const double omega = 2.0 * std::numbers::pi * problem.excitation.frequency_hz();
  for (std::size_t n = 0; n < tip.size(); n += static_cast<std::size_t>(options.every)) {
    Row row = contact_at(run.steps(), n * every);
    row.time = static_cast<double>(n) * row_step;
    row.base_displacement = problem.excitation.amplitude() * std::sin(omega * row.time);
    row.tip_displacement = tip[n];
    row.midspan_displacement = midspan[n];
    writer.write(row);
  }
  Summary& summary = writer.summary();
  if (!problem.contact.is_smooth()) summary.events = events_of(run);  // a smooth law has no stick
  if (every == 1) return;
  const std::vector<double> coarser = boundary_integral_of(problem, every / 2).tip_displacement(every / 2);
  summary.step_effect = 0.0;
  for (std::size_t n = 0; n < tip.size(); ++n)
    summary.step_effect = std::max(*summary.step_effect, std::abs(tip[n] - coarser[n]));
}

struct Method {
  studies::Inquiry inquiry{};
  void (*write)(const data::Case&, const RespondOptions&, Writer&){};
};

const std::map<std::string, Method> methods{
    {"boundary-integral", {studies::Inquiry::boundary_integral_history, write_boundary_integral}},
    {"closed-form", {studies::Inquiry::closed_form_history, write_closed_form}},
    {"event-driven", {studies::Inquiry::event_driven_history, write_event_driven}},
    {"fe", {studies::Inquiry::stepped_history, write_finite_element}}};

template <class Value>
std::vector<std::string> names_of(const std::map<std::string, Value>& table) {
  std::vector<std::string> names;
  for (const auto& [name, value] : table) names.push_back(name);
  return names;
}

void write_events(OutputFile& file, const std::vector<EventRow>& events) {
  file.write(events_header);
  for (const EventRow& event : events)
    file.write(fmt::format("{},{},{}\n", data::shortest_text(event.time), event.change,
                           data::shortest_text(event.tip_displacement)));
  file.commit();
}

// The last rows that the spectrum is that of: as many whole periods of the base motion as the second half of the duration has.
struct SpectrumWindow {
  std::size_t rows{};
  double length{};  // s
};

SpectrumWindow spectrum_window(const data::Case& problem, long every) {
  constexpr double rounding = 1e-9;
  const double row_step = static_cast<double>(every) * problem.numerics.time_step(),
               period = 1.0 / problem.excitation.frequency_hz();
  const double periods = std::floor(0.5 * problem.numerics.duration() / period + rounding);
  const auto rows = std::llround(periods * period / row_step);
  if (periods < 1.0)
    throw data::FieldError(
        "excitation.duration", problem.numerics.duration(),
        fmt::format("at least two periods of the base motion, {} s, where --spectrum is given",
                    data::shortest_text(2.0 * period)));
  if (static_cast<double>(rows) < 2.0 * periods)
    throw data::FieldError(
        "--every", static_cast<double>(every),
        "small enough for two rows in a period of the base motion where --spectrum is given");
  return {static_cast<std::size_t>(rows), static_cast<double>(rows) * row_step};
}

void write_spectrum(OutputFile& file, const SpectrumWindow& window, const Summary& summary) {
  const auto spectrum = [&](const std::vector<double>& values) {
    return analytic::amplitude_spectrum(
        {values.end() - static_cast<std::ptrdiff_t>(window.rows), values.end()});
  };
  const auto tip = spectrum(summary.tip_displacements), force = spectrum(summary.friction_forces);
  file.write("frequency_Hz,tip_displacement_m,friction_force_N\n");
  for (std::size_t k = 0; k < tip.size(); ++k)
    file.write(fmt::format("{},{},{}\n", data::shortest_text(static_cast<double>(k) / window.length),
                           data::shortest_text(tip[k]), data::shortest_text(force[k])));
  file.commit();
}

std::string warning_of_slip(const data::Case& problem, double time) {
  return fmt::format(
      "the closed form holds while the tip sticks, but |f| exceeds mu_s P = {} N first at {} s; --method fe "
      "and --method event-driven follow the slip",
      data::shortest_text(problem.friction.static_coefficient() * problem.beam.axial_force()),
      data::shortest_text(time));
}

Json to_json(const data::Case& problem, const RespondOptions& options, const Summary& summary,
             const std::vector<std::string>& warnings) {
  Json object{{"case", problem.name},
              {"method", options.method},
              {"frequency_hz", problem.excitation.frequency_hz()},
              {"amplitude_m", problem.excitation.amplitude()},
              {"duration_s", problem.numerics.duration()},
              {"output", options.output},
              {"rows", summary.rows},
              {"largest_friction_force_N", summary.largest_force},
              {"first_slip_s", optional_json(summary.first_slip)},
              {"changes_of_contact", summary.events.size()}};
  if (options.method == "boundary-integral") {
    object["integration_step_s"] = studies::boundary_integral_step(problem);
    object["largest_change_on_twice_the_step_m"] = optional_json(summary.step_effect);
  }
  if (options.method == "fe") object["scheme"] = options.scheme.value_or("located");
  object["numerics"] = numerics_json(problem);
  object["warnings"] = warnings;
  return object;
}

// What one option rules out of another.
void require_consistent(const RespondOptions& options) {
  require_json_alone(options.problem.json, "--output", options.output);
  require_json_alone(options.problem.json, "--events", options.events);
  require_json_alone(options.problem.json, "--spectrum", options.spectrum);
  require_different_files({{"--output", options.output},
                           {"--events", options.events},
                           {"--spectrum", options.spectrum},
                           {"--figure", options.figure}});
  if (options.initial_velocity == "zero" && options.method != "fe" && options.method != "event-driven")
    throw data::FieldError(
        "--initial-velocity", "zero",
        fmt::format("quasi-static for --method {}, whose equation assumes it", options.method));
  if (options.scheme && options.method != "fe")
    throw data::FieldError("--method", options.method, "fe where --scheme is given");
  if (!options.events.empty() && options.method == "closed-form")
    throw data::FieldError("--method", "closed-form",
                           "one that follows the slip (fe, event-driven or boundary-integral) where --events "
                           "is given");
}

// The history is in place by then.
void write_figure(const data::Case& problem, const RespondOptions& options, const std::string& history,
                  OutputFile& file) {
  const double limit = problem.friction.static_coefficient() * problem.beam.axial_force();
  file.write(
      report::drawing_of("history", figure_format(options.figure),
                         {{"history.csv", history},
                          {"history-values.csv", report::values_table({{"limit", limit, "N"}}).text()}}));
  file.commit();
}

// Of the history that has been written.
std::vector<std::string> warnings_after(const data::Case& problem, const RespondOptions& options,
                                        const Summary& summary) {
  const auto inquiry = methods.at(options.method).inquiry;
  auto warnings = warnings_of(problem, inquiry);
  if (options.method == "closed-form" && summary.first_slip)
    warnings.push_back(warning_of_slip(problem, *summary.first_slip));
  if (!summary.events.empty())
    if (const auto growth = studies::growth_warning(problem, inquiry)) warnings.push_back(growth->sentence);
  return warnings;
}

// What the method or scheme cannot do.
void require_supported(const data::Case& problem, const RespondOptions& options) {
  if (options.method == "closed-form") require_undamped(problem, "the closed form");
  if (options.method == "closed-form" || options.method == "event-driven")
    data::require_rigid(problem.contact, "--method " + options.method + "; fe and boundary-integral take it");
  if (options.scheme && *options.scheme != "located")
    data::require_rigid(problem.contact, "--scheme " + *options.scheme);
  studies::require_feasible(problem, methods.at(options.method).inquiry);
}

void run(const RespondOptions& options) {
  const data::Case problem = load_case(options.problem, options.excitation, options.duration);
  require_consistent(options);
  require_supported(problem, options);
  const bool has_spectrum = !options.spectrum.empty();
  const SpectrumWindow window = has_spectrum ? spectrum_window(problem, options.every) : SpectrumWindow{};
  Writer writer(options.output, !options.figure.empty(), has_spectrum);
  std::optional<OutputFile> events, figure, spectrum;
  open_if_named(spectrum, options.spectrum);
  open_if_named(events, options.events);
  open_figure(figure, options.figure);
  const report::Interruption interruption([&] {
    writer.discard();
    if (events) events->discard();
    if (figure) figure->discard();
    if (spectrum) spectrum->discard();
    return fmt::format(
        "interrupted at {} s of {} s; {}", data::shortest_text(writer.time()),
        data::shortest_text(problem.numerics.duration()),
        options.output == "-" ? "standard output holds the history up to there at most" : "nothing is kept");
  });
  methods.at(options.method).write(problem, options, writer);
  writer.finish();
  const Summary& summary = writer.summary();
  if (events) write_events(*events, summary.events);
  if (spectrum) write_spectrum(*spectrum, window, summary);
  if (figure) write_figure(problem, options, writer.text(), *figure);
  const auto warnings = warnings_after(problem, options, summary);
  print_warnings(warnings);
  if (options.problem.json)
    print_json(to_json(problem, options, summary, warnings));
  else if (options.output != "-" && options.events != "-" && options.spectrum != "-")
    fmt::print("{} rows written to {}\n", summary.rows, options.output);
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
      ->check(one_of(names_of(methods)))
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
      ->check(one_of(names_of(schemes)));
  command->add_option("--duration", options->duration, "Duration, s (else that of the case)")
      ->check(number());
  command->add_option("--output", options->output, "CSV file, '-' for standard output")
      ->check(file_name())
      ->capture_default_str();
  command->add_option("--events", options->events, "CSV file for the changes of contact")->check(file_name());
  command
      ->add_option(
          "--spectrum", options->spectrum,
          "CSV file for the amplitude spectra of tip and friction force, over the whole periods of the base "
          "motion in the second half of the duration")
      ->check(file_name());
  add_figure_option(*command, options->figure);
  command->add_option("--every", options->every, "Write every N-th time step only")
      ->check(integer_between(1, 1'000'000'000))
      ->capture_default_str();
  add_examples(*command,
               {"stickslip respond paper --hz 25 --amplitude 1e-3 --duration 1 --output history.csv",
                "stickslip respond steel-strip --method event-driven --duration 0.2 --events events.csv "
                "--output history.csv"});
  command->callback([options] { run(*options); });
}

}  // namespace stickslip::cli
