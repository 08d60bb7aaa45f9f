// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "case_options.hpp"
#include "render/report.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"
#include "studies/common/parallel.hpp"

namespace stickslip::cli {

namespace {

bool quiet = false;  // of the one command line there is

bool has_flag(const CLI::App& command, const std::string& name) {
  const CLI::Option* const option = command.get_option_no_throw(name);
  return option != nullptr && option->get_items_expected_max() == 0 && option->count() > 0;
}

// Throws data::InputError if two options cannot both have their file.
void require_compatible(const std::vector<Outputs::Named>& files, bool is_json) {
  for (auto file = files.begin(); file != files.end(); ++file) {
    const auto& [option, path] = *file;
    if (is_json && path == "-")
      throw data::InputError(
          fmt::format("--json and {0} - both want standard output, but --json needs {0} FILE", option));
    const auto other = std::ranges::find(files.begin(), file, path, &Outputs::Named::path);
    if (!path.empty() && other != file)
      throw data::FieldError(option, data::printable(path), "another file than " + other->option);
  }
}

}  // namespace

Outputs::Outputs(const CLI::App& command)
    : command_(command.get_name()),
      is_json_(has_flag(command, "--json")),
      is_quiet_(cli::is_quiet() || has_flag(command, "--quiet")) {}

void Outputs::open(const std::vector<Named>& files) {
  require_compatible(files, is_json_);
  for (const Named& name : files) {
    if (name.path.empty()) continue;
    if (name.option == "--figure") {
      (void)figure_format(name.path);
      (void)report::templates_directory();  // throws now rather than after the work
    }
    files_.emplace_back(name);
  }
  interruption_.emplace([this] { return last_words(); });
}

void Outputs::on_interrupt(std::function<std::string()> sentence) {
  std::unique_lock<std::mutex> undisturbed;
  if (interruption_) undisturbed = hold();
  sentence_ = std::move(sentence);
}

report::Progress& Outputs::progress(std::string_view part, std::size_t items) {
  std::unique_lock<std::mutex> undisturbed;
  if (interruption_) undisturbed = hold();
  return progress_.emplace(fmt::format("stickslip {}{}", command_, part),
                           report::Progress::standard_error(is_quiet_), items);
}

Outputs::Open* Outputs::find(std::string_view option) {
  const auto found = std::ranges::find(files_, option, [](const Open& open) { return open.name.option; });
  return found == files_.end() ? nullptr : &*found;
}

OutputFile& Outputs::file(std::string_view option) {
  if (Open* const open = find(option); open != nullptr) return open->file;
  throw std::logic_error(fmt::format("{} names no file", option));
}

void Outputs::commit(std::string_view option) {
  const auto undisturbed = hold();
  file(option).commit();
  find(option)->is_written = true;
}

void Outputs::write(std::string_view option, const std::function<std::string()>& text) {
  Open* const open = find(option);
  if (open == nullptr) return;
  if (progress_) progress_->finish();
  const auto undisturbed = hold();
  open->file.write(text());
  open->file.commit();
  open->is_written = true;
}

void Outputs::draw(const std::function<std::string(const std::string&)>& drawing) {
  write("--figure", [&] { return drawing(figure_format(find("--figure")->name.path)); });
}

std::string Outputs::written() const {
  std::vector<std::string> paths;
  for (const Open& open : files_)
    if (open.is_written) paths.push_back(open.name.path == "-" ? "standard output" : open.name.path);
  return fmt::format("{}", fmt::join(paths, " and "));
}

std::string Outputs::last_words() {
  if (progress_) progress_->finish();
  for (const Open& open : files_) open.file.discard();
  if (sentence_) return sentence_();
  if (const std::string paths = written(); !paths.empty())
    return fmt::format("interrupted; nothing is written but {}", paths);
  return progress_ ? fmt::format("interrupted after {:.0f} % of the work; nothing is kept",
                                 100.0 * progress_->share())
                   : "interrupted before there was a result";
}

void Outputs::print(Answer answer) {
  if (progress_) progress_->finish();
  if (answer.warnings) {
    for (const std::string& warning : *answer.warnings)
      fmt::print(stderr, "stickslip: warning: {}\n", warning);
    answer.add_members({{"warnings", *answer.warnings}});
  }
  const bool is_taken = std::ranges::any_of(files_, [](const Open& open) { return open.name.path == "-"; });
  if (is_json_)
    print_json(answer.json);
  else if (!is_taken)
    fmt::print("{}", answer.text);
}

void add_examples(CLI::App& command, const std::vector<std::string>& lines) {
  command.footer(fmt::format("Examples:\n  {}", fmt::join(lines, "\n  ")));
}

void finish(Answer answer, Outputs& outputs) {
  require_finite(answer.json);
  const int status = answer.status;
  outputs.print(std::move(answer));
  if (status != 0) throw CLI::RuntimeError(status);
}

void add_json_option(CLI::App& command) { command.add_flag("--json", json_help); }

void add_quiet_option(CLI::App& app) {
  if (app.get_option_no_throw("--quiet") == nullptr)  // a subcommand may have one that says more
    app.add_flag("--quiet", quiet, "No progress on standard error");
  for (CLI::App* command : app.get_subcommands(nullptr)) add_quiet_option(*command);
}

bool is_quiet() noexcept { return quiet; }

report::Progress::Surroundings progress_surroundings() { return report::Progress::standard_error(quiet); }

void add_threads_option(CLI::App& command) {
  command
      .add_option_function<unsigned>(
          "--threads", [](const unsigned& count) { studies::set_thread_count(count); },
          "Threads to work on, of which no result depends (default: as many as the machine runs at once)")
      ->check(integer_between(1, 1024));
}

std::string figure_format(const std::string& figure) {
  const std::string extension = std::filesystem::path(figure).extension().string();
  if (extension == ".pdf" || extension == ".png" || extension == ".svg") return extension.substr(1);
  throw data::FieldError("--figure", fmt::format("'{}'", data::printable(figure)),
                         "a file whose name ends in .pdf, .png or .svg");
}

void open_figure(std::optional<OutputFile>& file, const std::string& figure) {
  if (figure.empty()) return;
  (void)figure_format(figure);
  (void)report::templates_directory();  // throws now rather than after the work
  file.emplace(figure);
}

void add_figure_option(CLI::App& command, std::string& figure, const std::string& what) {
  command.add_option("--figure", figure, what + ", a .png, .pdf or .svg file (needs gnuplot)")
      ->check(file_name());
}

}  // namespace stickslip::cli
