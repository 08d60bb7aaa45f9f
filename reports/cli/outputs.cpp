// SPDX-License-Identifier: MIT
#include "outputs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "case_options.hpp"
#include "command.hpp"
#include "render/external_tool.hpp"
#include "render/report.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::cli {

namespace {

bool has_flag(const CLI::App& command, const std::string& name) {
  const CLI::Option* const option = command.get_option_no_throw(name);
  return option != nullptr && option->get_items_expected_max() == 0 && option->count() > 0;
}

// The value of an option that is given.
std::optional<std::string> option_text(const CLI::App& command, const std::string& name) {
  const CLI::Option* const option = command.get_option_no_throw(name);
  if (option == nullptr || option->count() == 0) return std::nullopt;
  return option->results().back();
}

// Throws data::InputError if two options cannot both have their file.
void require_compatible(const std::vector<Outputs::Named>& files, bool is_json) {
  for (auto file = files.begin(); file != files.end(); ++file) {
    const auto& [option, path] = *file;
    if (is_json && path == "-")
      throw data::InputError(
          fmt::format("--json and {0} - both want standard output, but --json needs {0} FILE", option));
    const auto other = std::find_if(files.begin(), file, [&path = path](const auto& before) {
      return data::are_one_file(before.path, path);
    });
    if (!path.empty() && other != file)
      throw data::FieldError(option, data::printable(path), "another file than " + other->option);
  }
}

}  // namespace

struct Outputs::Open {
  explicit Open(const Named& named) : name(named), file(named.path) {}
  Named name;
  data::AtomicFile file;
  bool is_written{};
};

Outputs::Outputs(const CLI::App& command)
    : command_(command.get_name()),
      is_json_(has_flag(command, "--json")),
      head_{{"program", program()}, {"command", command_line()}} {
  for (const CLI::App* app = &command; app != nullptr; app = app->get_parent())
    is_quiet_ = is_quiet_ || has_flag(*app, "--quiet");
  look_.font = option_text(command, "--font").value_or("");
  look_.title = option_text(command, "--title").value_or("");
  if (const auto size = option_text(command, "--size")) look_.size_cm = size_in(*size);
}

Outputs::~Outputs() = default;

void Outputs::set_case(const data::Case& problem) {
  case_line_ = case_line(problem);
  head_.update({{"case", problem.name}, {"problem", problem_json(problem)}});
}

void Outputs::open(const std::vector<Named>& files) {
  require_compatible(files, is_json_);
  interruption_.emplace([this] { return interruption_message(); });
  for (const Named& name : files) {
    if (name.path.empty()) continue;
    if (name.option == "--figure") {
      look_.format = report::figure_format(name.path);
      (void)report::templates_directory();  // throws now rather than after the work
      report::require_tool("gnuplot");
    }
    // A signal finds a file in the list, or none; what waits for the reader of a pipe leaves none.
    auto lock = block_interruption();
    if (data::is_no_regular_file(name.path)) lock.unlock();
    std::list<Open> opened;
    opened.emplace_back(name);
    if (!lock) lock.lock();
    files_.splice(files_.end(), opened);
  }
}

void Outputs::on_interrupt(std::function<std::string()> sentence) {
  const auto lock = block_interruption();
  sentence_ = std::move(sentence);
}

report::Progress& Outputs::progress(std::string_view part, std::size_t items) {
  const auto lock = block_interruption();
  const bool shares_terminal = takes_standard_output() && ::isatty(STDOUT_FILENO) == 1;
  return progress_.emplace(fmt::format("stickslip {}{}", command_, part),
                           report::Progress::standard_error(is_quiet_ || shares_terminal), items);
}

Outputs::Open* Outputs::find(std::string_view option) {
  const auto found = std::ranges::find(files_, option, [](const Open& open) { return open.name.option; });
  return found == files_.end() ? nullptr : &*found;
}

std::string Outputs::path(std::string_view option) {
  const Open* const open = find(option);
  return open == nullptr ? "" : open->name.path;
}

data::AtomicFile& Outputs::file(std::string_view option) {
  if (Open* const open = find(option); open != nullptr) return open->file;
  throw std::logic_error(fmt::format("{} names no file", option));
}

void Outputs::commit(std::string_view option) {
  const auto lock = block_interruption();
  file(option).commit();
  find(option)->is_written = true;
}

std::string Outputs::heading(std::string_view title) const {
  return fmt::format("{}; {}, {}{}", title, program(), command_,
                     head_.contains("problem") ? ", " + head_["problem"].dump() : "");
}

void Outputs::write(std::string_view option, const std::function<std::string()>& text) {
  Open* const open = find(option);
  if (open == nullptr) return;
  if (progress_ && open->name.path == "-") progress_->finish();
  const auto lock = block_interruption();
  open->file.write(text());
  open->file.commit();
  open->is_written = true;
}

void Outputs::write_table(std::string_view option, const std::function<std::string()>& text) {
  write(option, [&] {
    std::string whole = text();
    constexpr std::size_t begin = 2;  // of the title
    const std::size_t length = whole.find('\n') - begin;
    return whole.replace(begin, length, heading(whole.substr(begin, length)));
  });
}

void Outputs::write_json(const Json& answer) {
  head_.update(answer);
  write("--json", [&] { return json_text(head_); });
}

void Outputs::draw(const std::string& title, const std::function<std::string(const report::Look&)>& drawing) {
  if (look_.title.empty()) look_.title = title;
  write("--figure", [&] {
    if (progress_) progress_->stage("drawing " + find("--figure")->name.path);
    try {
      return drawing(look_);
    } catch (const std::runtime_error& error) {
      if (written().empty()) throw;
      throw std::runtime_error(fmt::format("{}; the rest is in {}", error.what(), written()));
    }
  });
}

std::string Outputs::written() const {
  std::vector<std::string> paths;
  for (const Open& open : files_)
    if (open.is_written) paths.push_back(open.name.path == "-" ? "standard output" : open.name.path);
  return fmt::format("{}", fmt::join(paths, " and "));
}

bool Outputs::takes_standard_output() const {
  return std::ranges::any_of(files_, [](const Open& open) { return open.name.path == "-"; });
}

std::string Outputs::interruption_message() {
  if (progress_) progress_->finish();
  for (const Open& open : files_) open.file.discard();
  if (const std::string paths = written(); !paths.empty())
    return fmt::format("interrupted; nothing is written but {}", paths);
  if (sentence_) return sentence_();
  return progress_ ? fmt::format("interrupted after {:.0f} % of the work; nothing is kept",
                                 100.0 * progress_->share())
                   : "interrupted before there was a result";
}

void Outputs::print(Answer answer) {
  if (progress_) progress_->finish();
  if (answer.warnings) {
    for (const std::string& warning : *answer.warnings) report::tell("stickslip: warning", warning);
    answer.add_members({{"warnings", *answer.warnings}});
  }
  head_.update(answer.json);
  std::vector<std::string> unnamed;  // files that the answer does not name
  for (const Open& open : files_)
    if (open.is_written && answer.text.find(open.name.path) == std::string::npos)
      unnamed.push_back(open.name.path);
  if (!unnamed.empty() && !is_quiet_) answer.add_line(fmt::format("Written: {}", fmt::join(unnamed, ", ")));
  std::string text;
  if (is_json_)
    text = json_text(head_);
  else if (!takes_standard_output())
    text = data::plain_text(case_line_ + answer.text);
  std::fputs(text.c_str(), stdout);  // the end of the program tells whether it could be written
}

}  // namespace stickslip::cli
