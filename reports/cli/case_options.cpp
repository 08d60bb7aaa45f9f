// SPDX-License-Identifier: MIT
#include "case_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "stickslip/data/input_text.hpp"

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

CLI::Validator number() {
  return {[](const std::string& text) { return parse<double>(text) ? "" : is_not(text, "a number"); }, ""};
}

CLI::Validator time() {
  const auto check = [](const std::string& text) -> std::string {
    const auto value = parse<double>(text);
    if (value && std::isfinite(*value) && *value >= 0.0) return "";
    return is_not(text, "a finite number of 0 or more (s)");
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

void add_excitation_options(CLI::App& command, ExcitationOptions& options) {
  command.add_option("--hz", options.frequency_hz, "Excitation frequency, Hz (else that of the case)")
      ->check(number());
  command.add_option("--amplitude", options.amplitude, "Excitation amplitude, m (else that of the case)")
      ->check(number());
}

std::vector<data::Override> overrides_of(const CaseOptions& options, const ExcitationOptions& excitation) {
  std::vector<data::Override> overrides;
  for (const auto& text : options.overrides) overrides.push_back(data::Override::parse(text));
  if (excitation.frequency_hz)
    overrides.push_back(override_with("excitation.frequency_hz", *excitation.frequency_hz, "--hz"));
  if (excitation.amplitude)
    overrides.push_back(override_with("excitation.amplitude", *excitation.amplitude, "--amplitude"));
  return overrides;
}

data::Case load_case(const CaseOptions& options, const ExcitationOptions& excitation,
                     const std::optional<double>& duration) {
  auto overrides = overrides_of(options, excitation);
  if (duration) overrides.push_back(override_with("excitation.duration", *duration, "--duration"));
  return data::load_case(options.name, overrides);
}

data::NumericalSettings numerics_up_to(double frequency_hz, const CaseOptions& options,
                                       ExcitationOptions excitation, const std::optional<double>& duration) {
  excitation.frequency_hz = frequency_hz;
  return load_case(options, excitation, duration).numerics;
}

void require_no_fixed_value(const ExcitationOptions& excitation, std::string_view varied,
                            std::string_view option) {
  const auto require_none = [&](const std::optional<double>& value, std::string_view fixed) {
    if (value) throw data::InputError(fmt::format("{} is given, but {} varies {}", fixed, option, varied));
  };
  if (varied == "excitation.frequency_hz") require_none(excitation.frequency_hz, "--hz");
  if (varied == "excitation.amplitude") require_none(excitation.amplitude, "--amplitude");
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
