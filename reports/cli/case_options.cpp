// SPDX-License-Identifier: MIT
#include "case_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "stickslip/data/input_text.hpp"
#include "stickslip/data/units.hpp"

namespace stickslip::cli {

void add_package_option(CLI::App& command, std::string& package) {
  command.add_option("--package", package, "Folder with another data package (else that of stickslip)")
      ->check(file_name());
}

void add_set_option(CLI::App& command, std::vector<std::string>& overrides, const std::string& help) {
  command.add_option("--set", overrides, help)->type_name("TABLE.KEY=VALUE")->allow_extra_args(false);
}

void add_case_options(CLI::App& command, CaseOptions& options) {
  command.add_option("CASE", options.name, "A name that 'stickslip cases' lists, or the path of a TOML file")
      ->capture_default_str();
  add_set_option(command, options.overrides, "Replace a key of the case, as in beam.length=1.8; repeatable");
  add_json_option(command);
}

namespace {

// What follows the name of an option in an error message.
std::string is_not(const std::string& text, std::string_view allowed) {
  return fmt::format("is {}, but must be {}", text.empty() ? "''" : data::printable(text), allowed);
}

}  // namespace

CLI::Validator integer_between(long lowest, long highest) {
  const auto check = [lowest, highest](const std::string& text) -> std::string {
    const auto value = parse<long>(text);
    if (value && lowest <= *value && *value <= highest) return "";
    return is_not(text, fmt::format("an integer from {} to {}", lowest, highest));
  };
  return {check, fmt::format("{} ... {}", lowest, highest)};
}

CLI::Validator number(const std::string& unit) {
  const auto check = [unit](std::string& text) -> std::string {
    const auto value = data::quantity_in(text, unit);
    if (!value) return is_not(text, data::quantity_allowed(text, unit));
    text = data::shortest_text(*value);
    return "";
  };
  return {check, ""};
}

CLI::Validator time() {
  const auto check = [](std::string& text) -> std::string {
    const auto value = data::quantity_in(text, "s");
    if (!value || !std::isfinite(*value) || *value < 0.0)
      return is_not(text, "a finite number of 0 or more (s)");
    text = data::shortest_text(*value);
    return "";
  };
  return {check, ""};
}

CLI::Validator one_of(const std::vector<std::string>& names) {
  const auto check = [names](const std::string& text) -> std::string {
    if (std::ranges::find(names, text) != names.end()) return "";
    return is_not(text + data::suggestion(text, names), "one of " + data::joined(names));
  };
  return {check, fmt::format("{{{}}}", fmt::join(names, ","))};
}

CLI::Validator file_name() {
  return {[](const std::string& text) { return text.empty() ? is_not(text, "the name of a file") : ""; }, ""};
}

CLI::Option* add_key_option(CLI::App& command, CaseOptions& options, const std::string& name,
                            const std::string& key, const std::string& help) {
  const auto take = [&options, key, name](const std::string& text) {
    options.keys.push_back({key, text, name});
  };
  return command.add_option_function<std::string>(name, take, help)->type_name("NUMBER[UNIT]");
}

void add_excitation_options(CLI::App& command, CaseOptions& options) {
  add_key_option(command, options, "--hz", "excitation.frequency_hz",
                 "Excitation frequency, Hz (else that of the case)");
  add_key_option(command, options, "--amplitude", "excitation.amplitude",
                 "Excitation amplitude, m or with its unit, as 0.2mm (else that of the case)");
}

void add_duration_option(CLI::App& command, CaseOptions& options, const std::string& otherwise) {
  add_key_option(command, options, "--duration", "excitation.duration", "Duration, s (" + otherwise + ")");
}

std::vector<data::Override> overrides_of(const CaseOptions& options) {
  std::vector<data::Override> overrides;
  for (const auto& text : options.overrides) overrides.push_back(data::Override::parse(text));
  overrides.insert(overrides.end(), options.keys.begin(), options.keys.end());
  return overrides;
}

data::Case load_case(const CaseOptions& options, const std::vector<data::Override>& more) {
  auto overrides = overrides_of(options);
  overrides.insert(overrides.end(), more.begin(), more.end());
  return data::load_case(options.name, overrides);
}

data::NumericalSettings numerics_up_to(double frequency_hz, const CaseOptions& options) {
  return load_case(options, {override_with("excitation.frequency_hz", frequency_hz, "")}).numerics;
}

void require_no_fixed_value(const CaseOptions& options, std::string_view varied, std::string_view option) {
  for (const data::Override& fixed : options.keys)
    if (fixed.key == varied)
      throw data::InputError(fmt::format("{} is given, but {} varies {}", fixed.place, option, varied));
}

data::Override override_with(const std::string& key, double value, const std::string& option) {
  return {key, data::shortest_text(value), option};
}

std::vector<std::string> sentences_of(const std::vector<studies::Warning>& warnings) {
  std::vector<std::string> sentences;
  for (const auto& warning : warnings) sentences.push_back(warning.sentence);
  return sentences;
}

std::vector<std::string> warnings_of(const data::Case& problem, studies::Inquiry inquiry, int frequencies) {
  return sentences_of(studies::problem_warnings(problem, inquiry, frequencies));
}

Json change_json(const std::optional<studies::Change>& change) {
  if (!change) return nullptr;
  return {{"key", change->key}, {"factor", change->factor}, {"margin", change->margin}};
}

std::string conditions_of(const data::Case& problem, const std::string& hz) {
  return fmt::format("{}: {} Hz, {} m, 0 to {} s", problem.name,
                     hz.empty() ? data::shortest_text(problem.excitation.frequency_hz()) : hz,
                     data::shortest_text(problem.excitation.amplitude()),
                     data::shortest_text(problem.numerics.duration()));
}

Json numerics_json(const data::Case& problem) {
  Json settings;
  for (const data::Key& key : data::case_keys()) {
    if (key.table() != "numerics" || key.presence == data::Presence::shorthand) continue;
    const double value = data::value_of(problem, key.path);
    settings[std::string(key.name())] = key.member.is_integer ? Json(static_cast<int>(value)) : Json(value);
  }
  return settings;
}

}  // namespace stickslip::cli
