// SPDX-License-Identifier: MIT
#include "stickslip/analytic/criterion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include "case_options.hpp"
#include "commands.hpp"
#include "figure_format.hpp"
#include "output_file.hpp"
#include "render/drawing.hpp"
#include "render/figures.hpp"
#include "render/interruption.hpp"
#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"
#include "studies/common/parallel.hpp"

namespace stickslip::cli {

namespace {

struct CriterionOptions {
  CaseOptions problem;
  ExcitationOptions excitation;
  std::string figure;
};

constexpr double width = 1e-10;  // relative, of the bounds

// The free vibrations that are kept where no truncation is asked for. Damping couples them.
int kept_modes(const data::Case& problem) { return studies::is_damped(problem) ? 40 : 200; }

data::HarmonicExcitation unit_excitation(const data::Case& problem) {
  return data::HarmonicExcitation({.frequency_hz = problem.excitation.frequency_hz(), .amplitude = 1.0});
}

analytic::Criterion criterion_of(const data::Case& problem, const data::HarmonicExcitation& excitation,
                                 int modes, analytic::SteadyPart steady_part, double relative_width = width) {
  return analytic::evaluate_criterion(problem.beam, problem.friction, excitation, problem.numerics.duration(),
                                      modes, steady_part, relative_width, problem.damping);
}

// The bound of what the modes that are not kept can add to the undamped reaction.
double omitted_transient_bound(const data::Case& problem, const data::HarmonicExcitation& unit) {
  const int modes = kept_modes(problem);
  if (problem.beam.shear_stiffness() > 0.0)
    return analytic::timoshenko_omitted_transient(analytic::timoshenko_reaction(problem.beam, modes),
                                                  studies::angular_frequency(unit));
  return analytic::StickResponse(problem.beam, unit, modes, analytic::SteadyPart::exact)
      .omitted_transient_bound();
}

// The criterion without truncation: exact steady part, kept_modes() free vibrations, and omitted_transient_bound().
// Evaluated at an amplitude of 1 m and scaled, since the reaction is proportional to the amplitude.
analytic::Criterion with_all_modes(const data::Case& problem) {
  const data::HarmonicExcitation unit = unit_excitation(problem);
  const int modes = kept_modes(problem);
  const double omitted = omitted_transient_bound(problem, unit);
  const auto criterion = criterion_of(problem, unit, modes, analytic::SteadyPart::exact);
  const analytic::Bounds unit_force{std::max(0.0, criterion.force_max.lower - omitted),
                                    criterion.force_max.upper + omitted};
  const double limit = criterion.friction_limit, amplitude = problem.excitation.amplitude();
  const bool slips = amplitude * unit_force.lower > limit;
  return {.force_max = {amplitude * unit_force.lower, amplitude * unit_force.upper},
          .friction_limit = limit,
          .critical_amplitude = {limit / unit_force.upper, limit / unit_force.lower},
          .verdict = slips ? analytic::Verdict::stick_slip : analytic::Verdict::stick};
}

// The amplitude of f in the steady vibration of the held beam, N, the excitation amplitude at which it is
// mu_s P, m, and the verdict on it.
struct SteadyState {
  double force{}, critical_amplitude{};
  analytic::Verdict verdict{};
};

// By a damping ratio, with the modes kept; otherwise exact.
double unit_steady_force(const data::Case& problem) {
  const data::HarmonicExcitation unit = unit_excitation(problem);
  if (problem.damping.ratio() > 0.0)
    return analytic::DampedForce(analytic::damped_reaction(problem.beam, problem.damping, kept_modes(problem),
                                                           analytic::SteadyPart::exact),
                                 studies::angular_frequency(unit), problem.numerics.duration())
        .steady_amplitude();
  if (problem.beam.shear_stiffness() > 0.0 && problem.damping.kelvin_voigt() == 0.0)
    return std::abs(analytic::timoshenko_steady_force(problem.beam, studies::angular_frequency(unit)));
  if (problem.damping.kelvin_voigt() == 0.0)
    return std::abs(
        analytic::StickResponse(problem.beam, unit, kept_modes(problem), analytic::SteadyPart::exact)
            .steady_force_amplitude());
  const analytic::DampedSteadyState state(problem.beam, unit, problem.damping, analytic::TipSupport::held);
  return std::abs(state.friction_force());
}

SteadyState steady_state(const data::Case& problem) {
  const double unit_force = unit_steady_force(problem);
  const double force = problem.excitation.amplitude() * unit_force;
  const double limit = problem.friction.static_coefficient() * problem.beam.axial_force();
  return {.force = force,
          .critical_amplitude = limit / unit_force,
          .verdict = force > limit ? analytic::Verdict::stick_slip : analytic::Verdict::stick};
}

// Nothing where the undamped force grows over all of the duration.
std::optional<SteadyState> steady_state_if_any(const data::Case& problem) {
  const auto warnings = studies::problem_warnings(problem, studies::Inquiry::criterion);
  if (std::ranges::find(warnings, studies::Concern::resonance, &studies::Warning::concern) != warnings.end())
    return std::nullopt;
  return steady_state(problem);
}

// mu_s P over the largest |f|: below 1 the tip slips.
analytic::Bounds margin_of(const analytic::Criterion& criterion) {
  return {criterion.friction_limit / criterion.force_max.upper,
          criterion.friction_limit / criterion.force_max.lower};
}

// The first natural frequency of the stick state above that of the excitation. with_all_modes() refuses a case whose
// kept_modes() have none.
struct NaturalFrequency {
  int mode{};
  double hz{};
};

NaturalFrequency next_natural_frequency(const data::Case& problem) {
  const auto shares = analytic::modal_forces(problem.beam, kept_modes(problem));
  const auto next = std::ranges::upper_bound(shares, studies::angular_frequency(problem.excitation), {},
                                             &analytic::ModalForce::angular_frequency);
  return {static_cast<int>(next - shares.begin()) + 1, next->angular_frequency / (2.0 * std::numbers::pi)};
}

// One key changed by a tenth, and the margin that it gives.
struct Change {
  std::string_view key;
  double factor{}, margin{};
};

// Of changes of one key by a tenth, the one with the largest margin. Those after which there is no stick state are
// left out.
Change best_change(const data::Case& problem) {
  Change best;
  for (const std::string_view key :
       {"excitation.amplitude", "excitation.frequency_hz", "beam.length", "beam.axial_force",
        "beam.youngs_modulus", "beam.density", "friction.static_coefficient"})
    for (const double factor : {0.9, 1.1}) {
      auto numbers = data::numbers_of(problem);
      numbers.at(std::string(key)) *= factor;
      if (key == "beam.youngs_modulus") numbers.at("beam.shear_stiffness") *= factor;
      numbers.at("friction.kinetic_coefficient") = 0.0;  // which has no part in the criterion
      const data::Case changed = data::case_with(problem.name, numbers);
      if (changed.beam.axial_force() >= analytic::stick_buckling_load(changed.beam)) continue;
      const double margin = margin_of(criterion_of(changed, changed.excitation, changed.numerics.modes(),
                                                   analytic::SteadyPart::modal_sum))
                                .lower;
      if (margin > best.margin) best = {key, factor, margin};
    }
  return best;
}

// What an engineer asks next.
struct Outlook {
  NaturalFrequency next;
  Change change;
};

Outlook outlook_of(const data::Case& problem) {
  return {next_natural_frequency(problem),
          problem.excitation.amplitude() > 0.0 ? best_change(problem) : Change{}};
}

// Critical amplitude with the N modes of the case against the excitation frequency, from a quarter of that of the case
// to four times it: in equal ratios and at the natural frequencies.
report::CsvTable critical_amplitudes(const data::Case& problem, const std::vector<double>& natural) {
  constexpr int steps = 240;
  constexpr double reach = 4.0, drawn_width = 1e-3;
  const double here = problem.excitation.frequency_hz();
  std::vector<double> frequencies;
  for (int i = 0; i <= steps; ++i) frequencies.push_back(here * std::pow(reach, 2.0 * i / steps - 1.0));
  for (const double hz : natural)
    if (hz > frequencies.front() && hz < here * reach) frequencies.push_back(hz);
  std::ranges::sort(frequencies);
  std::vector<double> amplitudes(frequencies.size());
  studies::in_parallel(frequencies.size(), [&](std::size_t i) {
    const data::HarmonicExcitation unit({.frequency_hz = frequencies[i], .amplitude = 1.0});
    amplitudes[i] =
        criterion_of(problem, unit, problem.numerics.modes(), analytic::SteadyPart::modal_sum, drawn_width)
            .critical_amplitude.midpoint();
  });
  report::CsvTable table("Critical amplitude of the case " + problem.name,
                         {{"frequency", "Hz"}, {"critical_amplitude", "m"}});
  for (std::size_t i = 0; i < frequencies.size(); ++i) table.add_numbers({frequencies[i], amplitudes[i]});
  return table;
}

void write_figure(const data::Case& problem, const std::string& figure, OutputFile& file) {
  std::vector<double> natural;
  report::CsvTable marks("Natural frequencies of the stick state", {{"frequency", "Hz"}});
  for (const auto& share : analytic::modal_forces(problem.beam, problem.numerics.modes())) {
    natural.push_back(share.angular_frequency / (2.0 * std::numbers::pi));
    marks.add_numbers({natural.back()});
  }
  const auto values = report::values_table({{"excitation_frequency", problem.excitation.frequency_hz(), "Hz"},
                                            {"excitation_amplitude", problem.excitation.amplitude(), "m"}});
  file.write(report::drawing_of("criterion", figure_format(figure),
                                {{"criterion.csv", critical_amplitudes(problem, natural).text()},
                                 {"criterion-natural.csv", marks.text()},
                                 {"criterion-values.csv", values.text()}}));
  file.commit();
}

std::string seven_digits(double value) { return fmt::format("{:.7g}", value); }

void print_row(std::string_view name, std::string_view left, std::string_view right = "") {
  fmt::print("{:<28}{:<{}}{}\n", name, left, right.empty() ? 0 : 20, right);
}

void print_table(const data::Case& problem, const analytic::Criterion& paper, const analytic::Criterion& all,
                 const std::optional<SteadyState>& steady, const Outlook& outlook) {
  fmt::print("{}: {} Hz, {} m, 0 to {} s{}\n\n", problem.name,
             data::shortest_text(problem.excitation.frequency_hz()),
             data::shortest_text(problem.excitation.amplitude()),
             data::shortest_text(problem.numerics.duration()),
             studies::is_damped(problem) ? ", with damping" : "");
  print_row("", fmt::format("N = {}", problem.numerics.modes()), "all modes");
  print_row("largest |f| / N", common_digits(paper.force_max), common_digits(all.force_max));
  print_row("friction limit mu_s P / N", data::shortest_text(paper.friction_limit),
            data::shortest_text(all.friction_limit));
  print_row("critical amplitude / m", common_digits(paper.critical_amplitude),
            common_digits(all.critical_amplitude));
  if (problem.excitation.amplitude() > 0.0)
    print_row("margin mu_s P / |f|", common_digits(margin_of(paper)), common_digits(margin_of(all)));
  print_row("verdict", to_string(paper.verdict), to_string(all.verdict));
  if (steady) {
    print_row("steady |f| / N", "", seven_digits(steady->force));
    print_row("verdict, steady", "", to_string(steady->verdict));
  } else {
    print_row("steady |f| / N", "", "none, it grows all the time");
  }
  print_row("next natural frequency / Hz",
            fmt::format("{} (mode {})", seven_digits(outlook.next.hz), outlook.next.mode));
  if (!outlook.change.key.empty())
    print_row("best change by a tenth", fmt::format("{} times {}: margin {:.4g}", outlook.change.key,
                                                    outlook.change.factor, outlook.change.margin));
  fmt::print("\nThe largest |f| is that of a start-up {}.\n",
             studies::is_damped(problem) ? "whose free vibrations decay with the damping of the case"
                                         : "without damping: its free vibrations do not decay");
}

Json to_json(const analytic::Criterion& criterion) {
  return {{"force_max_N", bounds_json(criterion.force_max)},
          {"friction_limit_N", criterion.friction_limit},
          {"critical_amplitude_m", criterion.critical_amplitude.midpoint()},
          {"critical_amplitude_bounds_m", bounds_json(criterion.critical_amplitude)},
          {"verdict", to_string(criterion.verdict)}};
}

Json to_json(const SteadyState& steady) {
  return {{"force_N", steady.force},
          {"critical_amplitude_m", steady.critical_amplitude},
          {"verdict", to_string(steady.verdict)}};
}

Json to_json(const data::Case& problem, const analytic::Criterion& paper, const analytic::Criterion& all,
             const std::optional<SteadyState>& steady, const Outlook& outlook,
             const std::vector<std::string>& warnings) {
  Json object{{"case", problem.name},
              {"frequency_hz", problem.excitation.frequency_hz()},
              {"amplitude_m", problem.excitation.amplitude()},
              {"duration_s", problem.numerics.duration()},
              {"modes", problem.numerics.modes()}};
  if (studies::is_damped(problem))
    object["damping"] = {{"kelvin_voigt_s", problem.damping.kelvin_voigt()},
                         {"ratio", problem.damping.ratio()}};
  object.update(to_json(paper));
  object["all_modes"] = to_json(all);
  object["margin"] = problem.excitation.amplitude() > 0.0 ? bounds_json(margin_of(all)) : Json();
  object["steady"] = steady ? to_json(*steady) : Json();
  object["next_natural_frequency"] = {{"mode", outlook.next.mode}, {"frequency_hz", outlook.next.hz}};
  object["best_change"] = nullptr;
  if (!outlook.change.key.empty())
    object["best_change"] = {
        {"key", outlook.change.key}, {"factor", outlook.change.factor}, {"margin", outlook.change.margin}};
  object["warnings"] = warnings;
  return object;
}

void run(const CriterionOptions& options) {
  const data::Case problem =
      data::load_case(options.problem.name, overrides_of(options.problem, options.excitation));
  data::require_rigid(problem.contact, "the criterion, whose tip is held; respond takes it");
  analytic::require_contact(problem.beam);
  studies::require_feasible(problem, studies::Inquiry::criterion);
  std::optional<OutputFile> figure;
  open_figure(figure, options.figure);
  const report::Interruption interruption([&] {
    if (figure) figure->discard();
    return "interrupted before there was a result";
  });
  const auto paper =
      criterion_of(problem, problem.excitation, problem.numerics.modes(), analytic::SteadyPart::modal_sum);
  const auto all = with_all_modes(problem);
  const auto warnings = warnings_of(problem, studies::Inquiry::criterion);
  const auto steady = steady_state_if_any(problem);
  const Outlook outlook = outlook_of(problem);
  const Json answer = to_json(problem, paper, all, steady, outlook, warnings);
  require_finite(answer);
  if (figure) write_figure(problem, options.figure, *figure);
  print_warnings(warnings);
  if (options.problem.json)
    print_json(answer);
  else
    print_table(problem, paper, all, steady, outlook);
}

}  // namespace

void add_criterion_command(CLI::App& app) {
  auto* command =
      app.add_subcommand("criterion", "Whether stick-slip occurs, and from which amplitude on (closed form)");
  auto options = std::make_shared<CriterionOptions>();
  add_case_options(*command, options->problem);
  add_excitation_options(*command, options->excitation);
  add_figure_option(*command, options->figure);
  add_examples(*command, {"stickslip criterion steel-strip --hz 30 --figure criterion.png",
                          "stickslip criterion paper --set beam.length=1.8 --amplitude 0.5e-3 --json"});
  command->callback([options] { run(*options); });
}

}  // namespace stickslip::cli
