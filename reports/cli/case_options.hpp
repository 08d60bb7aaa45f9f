// SPDX-License-Identifier: MIT
#pragma once

/// What the subcommands have in common: which problem, and in which form to answer.

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "answer.hpp"
#include "command.hpp"
#include "stickslip/data/case_file.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::cli {

/// [CASE] --set table.key=value ... --json
struct CaseOptions {
  std::string name = "paper";
  std::vector<std::string> overrides{};
};

/// --hz F --amplitude M, short for --set excitation.frequency_hz=F --set excitation.amplitude=M
struct ExcitationOptions {
  std::optional<double> frequency_hz;
  std::optional<double> amplitude;
};

void add_package_option(CLI::App& command, std::string& package);
void add_set_option(CLI::App& command, std::vector<std::string>& overrides, const std::string& help);
void add_case_options(CLI::App& command, CaseOptions& options);
void add_excitation_options(CLI::App& command, ExcitationOptions& options);

/// The number that the whole text is, if it is one.
template <class Number>
[[nodiscard]] std::optional<Number> parse(std::string_view text) {
  Number value{};
  const auto* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end) return std::nullopt;
  return value;
}

/// Accept integers from lowest to highest, numbers, finite times of 0 or more, one of some names, or the name
/// of a file: so that an error message says what is allowed.
[[nodiscard]] CLI::Validator integer_between(long lowest, long highest);
[[nodiscard]] CLI::Validator number();
[[nodiscard]] CLI::Validator time();
[[nodiscard]] CLI::Validator one_of(const std::vector<std::string>& names);
[[nodiscard]] CLI::Validator file_name();

/// The overrides of --set, then those of the options with a name of their own, which win.
/// Throws data::InputError.
[[nodiscard]] std::vector<data::Override> overrides_of(const CaseOptions& options,
                                                       const ExcitationOptions& excitation = {});

/// The case with those overrides and, if given, another duration, s. Throws data::InputError.
[[nodiscard]] data::Case load_case(const CaseOptions& options, const ExcitationOptions& excitation,
                                   const std::optional<double>& duration);

/// The settings of that case for excitations up to a frequency, which decides those that the case does not state.
[[nodiscard]] data::NumericalSettings numerics_up_to(double frequency_hz, const CaseOptions& options,
                                                     ExcitationOptions excitation,
                                                     const std::optional<double>& duration);

/// Throws data::InputError if --hz or --amplitude gives what the option varies, such as --x.
void require_no_fixed_value(const ExcitationOptions& excitation, std::string_view varied,
                            std::string_view option);

/// What an option of its own sets a key to.
[[nodiscard]] data::Override override_with(const std::string& key, double value, const std::string& option);

[[nodiscard]] std::vector<std::string> sentences_of(const std::vector<studies::Warning>& warnings);

/// The sentences of studies::problem_warnings().
[[nodiscard]] std::vector<std::string> warnings_of(const data::Case& problem, studies::Inquiry inquiry,
                                                   int frequencies = 0);

/// The members of a change of a key, or null.
[[nodiscard]] Json change_json(const std::optional<studies::Change>& change);

/// "NAME: 30 Hz, 0.001 m, 0 to 2 s", with another text for the frequency if it is given.
[[nodiscard]] std::string conditions_of(const data::Case& problem, const std::string& hz = "");

/// The settings that the case states or default_numerics() has chosen, by their keys.
[[nodiscard]] Json numerics_json(const data::Case& problem);

}  // namespace stickslip::cli
