#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>

#include "case_options.hpp"
#include "commands.hpp"
#include "output_file.hpp"
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

std::string csv_line(const Row& row) {
  const auto text = [](double value) { return data::shortest_text(value + 0.0); };  // -0 becomes 0
  return fmt::format("{},{},{},{},{},{},{}\n", text(row.time), text(row.base_displacement),
                     text(row.tip_displacement), text(row.midspan_displacement), text(row.sliding_velocity),
                     text(row.friction_force), row.state);
}

// What a history says in one glance.
struct Summary {
  long rows{};
  double largest_force{};            // max |f| over the rows, N
  std::optional<double> first_slip;  // s; closed form: of the first row with |f| > mu_s P
};

class Writer {
 public:
  explicit Writer(const std::string& path) : file_(path) {}

  // The header goes before the first row, so that a problem that is refused writes nothing.
  void write(const Row& row) {
    if (summary_.rows == 0) file_.write(header);
    file_.write(csv_line(row));
    ++summary_.rows;
    summary_.largest_force = std::max(summary_.largest_force, std::abs(row.friction_force));
  }

  [[nodiscard]] Summary& summary() { return summary_; }

  Summary finish() {
    file_.commit();
    return summary_;
  }

 private:
  OutputFile file_;
  Summary summary_;
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
          .state = simulation.state() == solver::ContactState::stick ? "stick" : "slip"};
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
                                     .scheme = schemes.at(options.scheme.value_or("located"))});
  const long steps = steps_of(problem);
  for (long n = 0; n <= steps; ++n) {
    if (n > 0) simulation.step();
    if (n % options.every == 0) writer.write(row_of(simulation));
  }
  const auto& events = simulation.integrator().events();
  if (!events.empty()) writer.summary().first_slip = events.front().time;
}

void warn_of_slip(const data::Case& problem, double time) {
  fmt::print(stderr,
             "stickslip: warning: the closed form holds while the tip sticks, but |f| exceeds mu_s P = {} N "
             "first at "
             "{} s; --method fe follows the slip\n",
             data::shortest_text(problem.friction.static_coefficient() * problem.beam.axial_force()),
             data::shortest_text(time));
}

Json to_json(const data::Case& problem, const RespondOptions& options, const Summary& summary) {
  Json object{{"case", problem.name},
              {"method", options.method},
              {"frequency_hz", problem.excitation.frequency_hz()},
              {"amplitude_m", problem.excitation.amplitude()},
              {"duration_s", problem.numerics.duration()},
              {"output", options.output},
              {"rows", summary.rows},
              {"largest_friction_force_N", summary.largest_force},
              {"first_slip_s", nullptr}};
  if (summary.first_slip) object["first_slip_s"] = *summary.first_slip;
  if (options.method == "fe") object["scheme"] = options.scheme.value_or("located");
  return object;
}

data::Case problem_of(const RespondOptions& options) {
  auto overrides = overrides_of(options.problem, options.excitation);
  if (options.duration) overrides.push_back(override_with("numerics.duration", *options.duration));
  return data::load_case(options.problem.name, overrides);
}

void run(const RespondOptions& options) {
  const bool to_standard_output = options.output == "-";
  if (options.problem.json && to_standard_output)
    throw data::InputError("--json and --output - both want standard output, but --json needs --output FILE");
  const data::Case problem = problem_of(options);
  const bool closed_form = options.method == "closed-form";
  if (closed_form && options.initial_velocity != "quasi-static")
    throw data::InputError(
        "--initial-velocity is zero, but the closed form starts quasi-static: Eq. (26) assumes it");
  if (closed_form && options.scheme)
    throw data::InputError(fmt::format(
        "--scheme is {}, but the closed form knows no slip: schemes belong to --method fe", *options.scheme));
  if (closed_form) require_undamped(problem, "the closed form");
  Writer writer(options.output);
  (closed_form ? write_closed_form : write_finite_element)(problem, options, writer);
  const Summary summary = writer.finish();
  if (closed_form && summary.first_slip) warn_of_slip(problem, *summary.first_slip);
  if (options.problem.json)
    print_json(to_json(problem, options, summary));
  else if (!to_standard_output)
    fmt::print("{} rows written to {}\n", summary.rows, options.output);
}

}  // namespace

void add_respond_command(CLI::App& app) {
  auto* command = app.add_subcommand("respond", "Displacements and friction force in time, as CSV");
  auto options = std::make_shared<RespondOptions>();
  add_case_options(*command, options->problem);
  add_excitation_options(*command, options->excitation);
  command
      ->add_option("--method", options->method,
                   "Finite elements with contact, or the closed form of the stick state")
      ->check(CLI::IsMember({"closed-form", "fe"}))
      ->capture_default_str();
  command
      ->add_option("--initial-velocity", options->initial_velocity,
                   "u_t(x,0): S(x) h_t(0), or the zero of the paper's text (an impulsive start)")
      ->check(CLI::IsMember({"quasi-static", "zero"}))
      ->capture_default_str();
  command
      ->add_option("--scheme", options->scheme,
                   "When the contact changes: located inside the step, at the end of the step, or by the "
                   "letter of the paper (threshold, no impulse); the last two show what the first is worth "
                   "(default: located)")
      ->check(CLI::IsMember(schemes));
  command->add_option("--duration", options->duration, "Duration, s (else that of the case)")
      ->check(number());
  command->add_option("--output", options->output, "CSV file, '-' for standard output")
      ->capture_default_str();
  command->add_option("--every", options->every, "Write every N-th time step only")
      ->check(integer_between(1, 1'000'000'000))
      ->capture_default_str();
  command->callback([options] { run(*options); });
}

}  // namespace stickslip::cli
