// SPDX-License-Identifier: MIT
#pragma once

/// What the subcommands have in common: which problem, and in which form to answer.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "answer.hpp"
#include "command.hpp"
#include "stickslip/analytic/stick_reaction.hpp"
#include "stickslip/data/case_file.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/analyses/method_choice.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/analyses/squeal.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::cli {

/// [CASE] --set table.key=value ... --json
struct CaseOptions {
  std::string name = "paper";
  std::vector<std::string> overrides{};
  std::vector<data::Override> keys{};  ///< of options with a name of their own, which win
  std::string rigid_for{};  ///< the command, unless it takes a spring or a smooth law of the contact
};

void add_set_option(CLI::App& command, std::vector<std::string>& overrides, const std::string& help);
void add_case_options(CLI::App& command, CaseOptions& options);
/// An option that is short for --set KEY=VALUE.
CLI::Option* add_key_option(CLI::App& command, CaseOptions& options, const std::string& name,
                            const std::string& key, const std::string& help);
/// --hz, --amplitude; --duration.
void add_excitation_options(CLI::App& command, CaseOptions& options);
void add_duration_option(CLI::App& command, CaseOptions& options,
                         const std::string& otherwise = "else that of the case");

/// The overrides of --set, then those of the options with a name of their own. Throws data::InputError.
[[nodiscard]] std::vector<data::Override> overrides_of(const CaseOptions& options);

/// The cells of each row of a CSV file as overrides of its columns. Throws data::InputError, also without a row, naming what it is.
[[nodiscard]] std::vector<std::vector<data::Override>> read_rows(const std::string& file,
                                                                 std::string_view what);

/// The case with those overrides and some more. Throws data::InputError, also for a contact that the command does not take.
[[nodiscard]] data::Case load_case(const CaseOptions& options, const std::vector<data::Override>& more = {});

/// The key of the mesh that --set gives and finite elements alone have, or "".
[[nodiscard]] std::string mesh_key_of(const CaseOptions& options);

/// Members, and a line unless --method names it: the method and why it was chosen.
void add_method(Answer& answer, const studies::MethodChoice& choice);

/// The settings of a case for excitations up to a frequency, which decides those that the case does not state.
[[nodiscard]] data::NumericalSettings numerics_up_to(double frequency_hz, const data::Case& problem);

/// Throws data::InputError if an option of its own gives what another one, such as --x, varies.
void require_no_fixed_value(const CaseOptions& options, std::string_view varied, std::string_view option);

/// What an option of its own sets a key to.
[[nodiscard]] data::Override override_with(const std::string& key, double value, const std::string& option);

[[nodiscard]] std::vector<std::string> sentences_of(const std::vector<studies::Warning>& warnings);

/// The members of a change of a key, or null.
[[nodiscard]] Json change_json(const std::optional<studies::Change>& change);

/// How what the case states is shown: an amplitude in m, m/s or g, that times the SI value, and its column in SI units. Of a general motion
/// the scale or, where |f_max| is not proportional to it alone, a factor of all that acts.
struct ShownAmplitude {
  std::string_view unit;
  double scale{};
  std::string_view column;
  std::string_view name = "amplitude";
};
[[nodiscard]] ShownAmplitude shown_amplitude(const data::Case& problem);

/// Adds members: the frequency or band, the amplitude in metres (null where it falls over the band), by which key it is stated, and that
/// number.
void add_excitation(Answer& answer, const data::Case& problem,
                    const std::optional<analytic::FrequencyBand>& band = {});

/// The line "NAME: 80 mm x 10 mm x 2 mm, abs, P = 5 N (12 % of buckling), mu 0.4/0.3": what the program has understood.
[[nodiscard]] std::string case_line(const data::Case& problem);

/// "30 Hz, 0.001 m, 0 to 2 s", "30 Hz, 0.5 g (0.000138004 m), 0 to 2 s", or with the frequencies of a band.
[[nodiscard]] std::string conditions_of(const data::Case& problem,
                                        const std::optional<analytic::FrequencyBand>& band = {});

/// Rows with the largest bending of the beam, and with the spring that keeps P.
void add_bending(Answer& answer, const data::Beam& beam, const studies::Bending& bending,
                 const std::optional<double>& steady_draw_back = {});

/// All numbers of the case in SI units, those of default_numerics() among them, by tables and keys; null for one that is infinite. A
/// structure that is no beam is told in `structure`, its rows from 1.
[[nodiscard]] Json problem_json(const data::Case& problem);

/// Adds a periodic motion, or the reason why there is none; its members stand in an object with the key, if there is one.
void add_cycle(Answer& answer, const studies::Cycle& cycle, const std::string& key = "");

}  // namespace stickslip::cli
