// SPDX-License-Identifier: MIT
#pragma once

/// The command line, run as a program. STICKSLIP_PROGRAM is its path.

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "stickslip/data/atomic_file.hpp"
#include "support/input_folder.hpp"
#include "support/testing.hpp"

namespace stickslip::cli {  // of program.hpp and answer.hpp, which not every test has
int run_program(int argc, const char* const* argv);
void set_most_digits(int digits);
}  // namespace stickslip::cli

namespace stickslip::testing {

struct Outcome {
  int status{};
  std::string output, errors;
};

inline std::string contents(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

using Words = std::vector<std::string>;

/// The words of a command line as a shell splits it at blanks, with quotes of both kinds and nothing else.
inline Words words_of(const std::string& line) {
  Words words;
  char quote = ' ';
  bool is_open = false;
  for (const char c : line) {
    if (quote == ' ' && c == ' ') {
      is_open = false;
      continue;
    }
    if (!is_open) words.emplace_back();
    is_open = true;
    if (quote == ' ' && (c == '\'' || c == '"'))
      quote = c;
    else if (c == quote)
      quote = ' ';
    else
      words.back() += c;
  }
  return words;
}

/// Each test works in an empty folder of its own, so that a file needs no path.
class CommandLine : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::current_path(folder_.path()); }
  void TearDown() override { std::filesystem::current_path(old_folder_); }

  /// Runs `stickslip <arguments>` through the shell.
  [[nodiscard]] Outcome run(const std::string& arguments) const {
    return shell(fmt::format("'{}' {}", STICKSLIP_PROGRAM, arguments));
  }

  /// Runs `stickslip` with these words in this process: another one costs more than most runs.
  [[nodiscard]] Outcome run_here(const Words& words) const {
    cli::set_most_digits(6);  // another run may have changed it
    std::vector<const char*> arguments{"stickslip"};
    for (const std::string& word : words) arguments.push_back(word.c_str());
    std::fflush(nullptr);  // what GoogleTest has said is not the program's
    const int streams[] = {::dup(STDOUT_FILENO), ::dup(STDERR_FILENO)};
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
      const int file = ::open(path(stream == STDOUT_FILENO ? "stdout" : "stderr").c_str(),
                              O_WRONLY | O_CREAT | O_TRUNC, 0644);
      ::dup2(file, stream);
      ::close(file);
    }
    const int status = cli::run_program(static_cast<int>(arguments.size()), arguments.data());
    std::cout.flush();
    std::fflush(nullptr);
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
      ::dup2(streams[stream - STDOUT_FILENO], stream);
      ::close(streams[stream - STDOUT_FILENO]);
    }
    return {status, contents(path("stdout")), contents(path("stderr"))};
  }

  [[nodiscard]] Outcome run_line(const std::string& arguments) const { return run_here(words_of(arguments)); }

  /// Runs any command through the shell.
  [[nodiscard]] Outcome shell(const std::string& command) const {
    const int status =
        std::system(("{ " + command + "\n} >'" + path("stdout") + "' 2>'" + path("stderr") + "'").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(path("stdout")), contents(path("stderr"))};
  }

  [[nodiscard]] nlohmann::json json(const std::string& arguments) const {
    const Outcome outcome = run_line(arguments + " --json");
    EXPECT_EQ(outcome.status, 0) << arguments << '\n' << outcome.errors;
    return nlohmann::json::parse(outcome.output, nullptr, false);
  }

  /// With the folder, for what works elsewhere.
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& file : std::filesystem::directory_iterator(folder_.path()))
      names.push_back(file.path().filename());
    return names;
  }

  void expect_refused(const std::string& arguments, const std::string& part) const {
    const Outcome outcome = run_line(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments;
    EXPECT_EQ(outcome.output, "") << arguments;
    EXPECT_TRUE(outcome.errors.starts_with("stickslip: ")) << arguments << ": " << outcome.errors;
    EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1) << outcome.errors;
    EXPECT_TRUE(holds(outcome.errors, part)) << arguments;
  }

 private:
  const std::filesystem::path old_folder_ = std::filesystem::current_path();
  const InputFolder folder_;
};

/// The cells of a table, without its comments.
inline std::vector<std::vector<std::string>> csv(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

/// The columns of a table by their names, without empty lines.
inline std::map<std::string, std::vector<std::string>> columns_of(const std::string& text) {
  std::map<std::string, std::vector<std::string>> columns;
  const auto rows = csv(text);
  for (std::size_t i = 1; i < rows.size(); ++i)
    for (std::size_t k = 0; k < rows[i].size(); ++k) columns[rows[0].at(k)].push_back(rows[i][k]);
  return columns;
}

/// Commands that draw, with the gnuplot that the test provides, or the one that is installed.
class Drawing : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    ::setenv("PATH", (path("tools") + ":/usr/bin:/bin").c_str(), 1);
    std::filesystem::create_directory(path("tools"));
  }
  void TearDown() override {
    ::setenv("PATH", old_path_.c_str(), 1);
    CommandLine::TearDown();
  }

  /// Draws the frames of an animation: a frame is its table, a film all of them.
  static constexpr const char* draw_all =
      "for table in \"${folder}\"frame-*.csv; do\n"
      "  name=${table##*/}\n"
      "  if [ $format = gif ]; then cat $table >> $output; else cp $table ${name%.csv}; fi\n"
      "done\n";

  /// A shell script that is called as gnuplot is: -d -e 'name=value; ...' script.
  void install_gnuplot(const std::string& body) const {
    install_tool("gnuplot", "eval \"$3\"\n[ -f \"$4\" ] || exit 1\n" + body);
  }

  /// A shell script that stands before a program of that name.
  void install_tool(const std::string& name, const std::string& body) const {
    const std::string program = path("tools/" + name);
    std::ofstream(program) << "#!/bin/sh\n" << body;
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  }

 private:
  const std::string old_path_ = std::getenv("PATH");
};

}  // namespace stickslip::testing
