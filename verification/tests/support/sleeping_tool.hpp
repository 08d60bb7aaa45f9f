// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "support/signalled_run.hpp"

namespace stickslip::testing {

/// The command line, ended by a signal while it waits for another program.
class SleepingTool : public SignalledRun {
 protected:
  void SetUp() override {
    SignalledRun::SetUp();
    std::filesystem::create_directory(temporary_);
    ::setenv("TMPDIR", temporary_.c_str(), 1);
  }
  void TearDown() override {
    ::unsetenv("TMPDIR");
    SignalledRun::TearDown();
  }

  /// A program that would take two minutes, most of it in a program that it starts.
  void install_sleeper(const std::string& name) const {
    install_tool(name, "[ \"$1\" = --version ] && exit\nparent=$$ sh -c 'echo $parent $$ >" +
                           path("unfinished") + "; mv " + path("unfinished") + " " + path("processes") +
                           "; exec sleep 120'\n");
  }

  [[nodiscard]] static bool is_running(const std::string& process) {
    const std::string status = contents("/proc/" + process + "/stat");
    return !status.empty() && status.substr(status.rfind(')') + 2, 1) != "Z";
  }

  [[nodiscard]] bool sleeps() const { return std::filesystem::exists(path("processes")); }

  /// Runs until the sleeper sleeps, sends the signal and returns what is said, without the program's name.
  [[nodiscard]] std::string said_after(int signal, const std::string& arguments) const {
    const Ending ending = signalled(arguments, signal, [&] { wait_until([&] { return sleeps(); }); });
    EXPECT_EQ(ending.status, 128 + signal) << arguments;
    std::istringstream processes(contents(path("processes")));
    for (std::string process; processes >> process;) wait_until([&] { return !is_running(process); });
    std::filesystem::remove(path("processes"));
    EXPECT_EQ(all_files(temporary_), std::vector<std::string>{}) << arguments;
    return one_sentence(ending);
  }

  [[nodiscard]] static std::string one_sentence(const Ending& ending) {
    const std::string name = "stickslip: ";
    EXPECT_TRUE(ending.errors.starts_with(name)) << ending.errors;
    EXPECT_EQ(std::ranges::count(ending.errors, '\n'), 1) << ending.errors;
    return ending.errors.substr(std::min(name.size(), ending.errors.size()));
  }

 private:
  const std::filesystem::path temporary_ = path("temporary");
};

}  // namespace stickslip::testing
