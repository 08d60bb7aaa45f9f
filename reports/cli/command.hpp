// SPDX-License-Identifier: MIT
#pragma once

/// The frame of a subcommand. A subcommand is a name, a help text, options and a function that returns an Answer; the frame prints
/// the answer as text or as JSON, with its warnings.

#include <CLI/CLI.hpp>
#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "answer.hpp"
#include "outputs.hpp"
#include "stickslip/data/case_file.hpp"

namespace stickslip::cli {

/// A subcommand with options of its own, which are as their type makes them until the arguments are read.
template <class Options>
struct Command {
  std::string name, help;
  std::vector<std::string> examples;  ///< command lines that end the help, which a test runs in this order
  void (*add_options)(CLI::App& command, Options& options) = nullptr;
  Answer (*run)(const Options& options, Outputs& outputs) = nullptr;
};

void add_examples(CLI::App& command, const std::vector<std::string>& lines);

/// Prints the answer. Throws CLI::RuntimeError with the status of the answer if that is not 0.
void finish(Answer answer, Outputs& outputs);

/// Where the error is caught: throws it again, beginning with the option that gave its field if it is one of these.
[[noreturn]] void throw_naming_option(const data::FieldError& error,
                                      const std::vector<data::Override>& given);

/// Adds the subcommand, which runs when it is found among the arguments.
template <class Options>
void add(CLI::App& app, const Command<Options>& command) {
  auto* const added = app.add_subcommand(command.name, command.help);
  const auto options = std::make_shared<Options>();
  command.add_options(*added, *options);
  add_examples(*added, command.examples);
  added->callback([added, options, run = command.run] {
    Outputs outputs(*added);
    try {
      finish(run(*options, outputs), outputs);
    } catch (const data::FieldError& error) {
      if constexpr (requires { options->problem.keys; }) throw_naming_option(error, options->problem.keys);
      throw;
    }
  });
}

void add_warning(Answer& answer, const std::optional<std::string>& warning);

/// "stickslip 1.0.0 (commit ...)", and the words that it was called with.
[[nodiscard]] std::string program();
[[nodiscard]] std::string command_line();

/// The width and the height in WIDTHxHEIGHT, cm; no other text has them.
[[nodiscard]] std::optional<std::pair<double, double>> size_in(const std::string& text);

/// The number that the whole text is, if it is one.
template <class Number>
[[nodiscard]] std::optional<Number> parse(std::string_view text) {
  Number value{};
  const auto* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end) return std::nullopt;
  return value;
}

// Validators whose message says what is allowed.
/// An integer in this range; a transform hands it on in decimal digits without leading zeros.
[[nodiscard]] CLI::Validator integer_between(long lowest, long highest);
/// A number with a unit as in a case file; a transform hands it on in SI units.
[[nodiscard]] CLI::Validator number(const std::string& unit = "", bool is_time = false);
/// A finite number of 0 or more seconds, with a unit or without.
[[nodiscard]] CLI::Validator time();
[[nodiscard]] CLI::Validator one_of(const std::vector<std::string>& names);
[[nodiscard]] CLI::Validator file_name();
/// A folder that exists.
[[nodiscard]] CLI::Validator folder();

/// Options whose default --help shows, unless it is empty: the name of a file, an integer, one of some names.
CLI::Option* add_file_option(CLI::App& command, const std::string& name, std::string& value,
                             const std::string& help);
CLI::Option* add_choice_option(CLI::App& command, const std::string& name, std::string& value,
                               const std::vector<std::string>& names, const std::string& help);
template <class Integer>
CLI::Option* add_integer_option(CLI::App& command, const std::string& name, Integer& value, long lowest,
                                long highest, const std::string& help) {
  return command.add_option(name, value, help)
      ->transform(integer_between(lowest, highest))
      ->capture_default_str();
}

void add_package_option(CLI::App& command, std::string& package);

/// --json, for an answer with members for it.
void add_json_option(CLI::App& command);

/// --quiet, before or after the subcommand: no progress on standard error.
void add_quiet_option(CLI::App& app);

/// --threads N, which sets studies::thread_count().
void add_threads_option(CLI::App& command);

/// --size and --font, which need another option.
void add_look_options(CLI::App& command, const std::string& needed);

/// The option --figure, and --size, --font and --title.
void add_figure_option(CLI::App& command, std::string& figure, const std::string& what = "Figure to draw");

}  // namespace stickslip::cli
