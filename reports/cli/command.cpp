// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "stickslip/data/input_text.hpp"
#include "stickslip/data/units.hpp"
#include "stickslip/version.hpp"
#include "studies/common/parallel.hpp"

namespace stickslip::cli {

void add_examples(CLI::App& command, const std::vector<std::string>& lines) {
  if (!lines.empty()) command.footer(fmt::format("Examples:\n  {}", fmt::join(lines, "\n  ")));
}

void finish(Answer answer, Outputs& outputs) {
  require_finite(answer.json);  // JSON has no infinity: what is infinite by intent is null already
  const int status = answer.status;
  outputs.print(std::move(answer));
  if (status != 0) throw CLI::RuntimeError(status);
}

void throw_naming_option(const data::FieldError& error, const std::vector<data::Override>& given) {
  const auto option = std::ranges::find(given, error.field(), &data::Override::key);
  if (option == given.end()) throw;  // of the case file, which the sentence names
  throw data::InputError(fmt::format("{}: {}", option->place, error.what()));
}

void add_warning(Answer& answer, const std::optional<std::string>& warning) {
  if (!answer.warnings) answer.warnings.emplace();
  if (warning) answer.warnings->push_back(*warning);
}

std::optional<std::pair<double, double>> size_in(const std::string& text) {
  constexpr double least = 4.0, most = 100.0;
  const std::size_t cross = text.find('x');
  if (cross == std::string::npos) return std::nullopt;
  const auto width = parse<double>(text.substr(0, cross)), height = parse<double>(text.substr(cross + 1));
  if (!width || !height || !(std::min(*width, *height) >= least && std::max(*width, *height) <= most))
    return std::nullopt;
  return std::pair(*width, *height);
}

std::string program() { return fmt::format("stickslip {} (commit {})", version, commit); }

std::string command_line() {
  std::string words = data::read_text("/proc/self/cmdline");
  if (!words.empty()) words.pop_back();  // the last word, too, ends with a zero byte
  std::ranges::replace(words, '\0', ' ');
  return words;
}

namespace {

// What follows the name of an option in an error message.
std::string is_not(const std::string& text, std::string_view allowed) {
  return fmt::format("is {}, but must be {}", text.empty() ? "''" : data::printable(text), allowed);
}

}  // namespace

CLI::Validator integer_between(long lowest, long highest) {
  const auto check = [lowest, highest](std::string& text) -> std::string {
    const auto value = parse<long>(text);
    if (!value || *value < lowest || *value > highest)
      return is_not(text, fmt::format("an integer from {} to {}", lowest, highest));
    text = std::to_string(*value);  // CLI11 reads 010 as 8
    return "";
  };
  return {check, fmt::format("{} ... {}", lowest, highest)};
}

CLI::Validator number(const std::string& unit, bool is_time) {
  const auto check = [unit, is_time](std::string& text) -> std::string {
    const auto value = data::quantity_in(text, unit);
    if (is_time && (!value || !std::isfinite(*value) || *value < 0.0))
      return is_not(text, "a finite number of 0 or more (s)");
    if (!value) return is_not(text, data::quantity_allowed(text, unit));
    text = data::shortest_text(*value);
    return "";
  };
  return {check, ""};
}

CLI::Validator time() { return number("s", true); }

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

CLI::Validator folder() {
  return {[](const std::string& text) {
            std::error_code error;
            return std::filesystem::is_directory(text, error) ? "" : is_not(text, "a folder that exists");
          },
          ""};
}

CLI::Option* add_file_option(CLI::App& command, const std::string& name, std::string& value,
                             const std::string& help) {
  auto* const option = command.add_option(name, value, help)->check(file_name());
  return value.empty() ? option : option->capture_default_str();
}

CLI::Option* add_choice_option(CLI::App& command, const std::string& name, std::string& value,
                               const std::vector<std::string>& names, const std::string& help) {
  return command.add_option(name, value, help)->check(one_of(names))->capture_default_str();
}

void add_package_option(CLI::App& command, std::string& package) {
  command.add_option("--package", package, "Folder with another data package (else that of stickslip)")
      ->check(folder());
}

void add_json_option(CLI::App& command) {
  command.add_flag("--json")->description("Print one JSON object, numbers with all digits");
}

void add_quiet_option(CLI::App& app) {
  if (app.get_option_no_throw("--quiet") == nullptr)  // a subcommand may have one that says more
    app.add_flag("--quiet")->description("No progress on standard error");
  for (CLI::App* command : app.get_subcommands(nullptr)) add_quiet_option(*command);
}

void add_threads_option(CLI::App& command) {
  command
      .add_option_function<unsigned>(
          "--threads", [](const unsigned& count) { studies::set_thread_count(count); },
          "Threads to work on, of which no result depends (default: as many as the machine runs at once)")
      ->transform(integer_between(1, 1024));
}

void add_look_options(CLI::App& command, const std::string& needed) {
  const auto is_size = [](const std::string& text) {
    return size_in(text)
               ? ""
               : fmt::format("is {}, but must be WIDTHxHEIGHT, each 4 to 100 cm", data::printable(text));
  };
  const auto is_font = [](const std::string& text) {
    const auto size = parse<double>(text.substr(text.rfind(',') + 1));
    return text.find(',', 1) != std::string::npos && size && *size >= 4.0 && *size <= 40.0
               ? ""
               : fmt::format("is {}, but must be NAME,SIZE, a size of 4 to 40 points", data::printable(text));
  };
  for (CLI::Option* option :
       {command.add_option("--size")
            ->description("Of the figure, cm")
            ->type_name("WIDTHxHEIGHT")
            ->check(CLI::Validator(is_size, "")),
        command.add_option("--font")
            ->description("Of the figure, as in 'Times,9'; a .tex file has that of its document in this size")
            ->type_name("NAME,SIZE")
            ->check(CLI::Validator(is_font, ""))})
    option->needs(needed);
}

void add_figure_option(CLI::App& command, std::string& figure, const std::string& what) {
  add_file_option(command, "--figure", figure,
                  what + ", a .png, .pdf, .svg or .tex file (TikZ; needs gnuplot)");
  add_look_options(command, "--figure");
  command.add_option("--title")
      ->description("Of the figure (else the name of the case)")
      ->type_name("TEXT")
      ->needs("--figure");
}

}  // namespace stickslip::cli
