// SPDX-License-Identifier: MIT
#pragma once

/// The output files, the progress and the end by Ctrl-C of a running subcommand.

#include <CLI/CLI.hpp>
#include <functional>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "answer.hpp"
#include "render/drawing.hpp"
#include "render/interruption.hpp"
#include "render/progress.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::cli {

/// The output files of a running subcommand. Each appears under its name when it is whole, and is removed if it does not come to
/// that.
class Outputs {
 public:
  /// The option that names a file, and the name, empty for none.
  struct Named {
    std::string option, path;
  };

  explicit Outputs(const CLI::App& command);
  ~Outputs();
  Outputs(const Outputs&) = delete;
  Outputs& operator=(const Outputs&) = delete;

  /// The case that the answer is of: the text begins with its beam, and JSON has all its numbers.
  void set_case(const data::Case& problem);

  /// Opens the files that have a name, before the work whose results they are to hold. From here on Ctrl-C and SIGTERM end the
  /// program in good order. Throws data::InputError if two options name the same file, if --json and a file both want standard
  /// output, or if --figure has a name that no figure can have; OutputError if a file cannot be written; report::ToolMissing without
  /// the gnuplot that --figure needs.
  void open(const std::vector<Named>& files);

  /// One sentence in place of the one that says how far the work is and what is written; it is made when a signal comes.
  void on_interrupt(std::function<std::string()> sentence);

  /// Shows the progress of the work on standard error, unless --quiet, as that of "stickslip COMMAND" or a part of it.
  report::Progress& progress(std::string_view part = "", std::size_t items = 0);

  [[nodiscard]] bool has(std::string_view option) { return find(option) != nullptr; }

  /// The name of the file of an option; empty if it has none.
  [[nodiscard]] std::string path(std::string_view option);

  /// The file of an option that is given, to write in parts; commit() puts it in place.
  [[nodiscard]] data::AtomicFile& file(std::string_view option);
  void commit(std::string_view option);

  /// The title that a table has in a file: with program and subcommand, and the numbers of the case if there is one.
  [[nodiscard]] std::string heading(std::string_view title) const;

  /// Writes the whole file of an option and puts it in place; without the option `text` is not called.
  void write(std::string_view option, const std::function<std::string()>& text);

  /// The same for a table that begins with its title, "# TITLE", which becomes heading(TITLE).
  void write_table(std::string_view option, const std::function<std::string()>& text);

  /// The same for --json FILE, with program, command and the case before the members of the answer.
  void write_json(const Json& answer);

  /// The same for --figure; `drawing` is given what --figure, --size and --title ask for, and else that title.
  void draw(const std::string& title, const std::function<std::string(const report::Look&)>& drawing);

  /// No signal ends the program while the result lives. Nothing is there to be left half-written before open().
  [[nodiscard]] std::unique_lock<std::mutex> block_interruption() {
    return interruption_ ? interruption_->block_interruption() : std::unique_lock<std::mutex>();
  }

  /// What --size, --font and --title ask for.
  [[nodiscard]] const report::Look& look() const noexcept { return look_; }
  [[nodiscard]] bool is_json() const noexcept { return is_json_; }
  [[nodiscard]] bool is_quiet() const noexcept { return is_quiet_; }

  /// "a.csv and b.csv", what is in place; empty for nothing.
  [[nodiscard]] std::string written() const;

  /// The warnings on standard error and, unless a file has taken standard output, the answer on it.
  void print(Answer answer);

 private:
  struct Open;

  [[nodiscard]] Open* find(std::string_view option);
  [[nodiscard]] bool takes_standard_output() const;
  [[nodiscard]] std::string interruption_message();

  std::string command_;
  bool is_json_{}, is_quiet_{};
  std::string case_line_;
  Json head_;  // of the answer in JSON
  report::Look look_;
  std::list<Open> files_;
  std::optional<report::Progress> progress_;
  std::function<std::string()> sentence_;
  std::optional<report::Interruption> interruption_;  // ends before the rest
};

}  // namespace stickslip::cli
