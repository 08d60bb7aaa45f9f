// SPDX-License-Identifier: MIT
#pragma once

/// The command line, ended by a signal while it works.

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "support/command_line.hpp"

namespace stickslip::testing {

class SignalledRun : public Drawing {
 protected:
  /// The outputs of a test, where they are all in one folder.
  [[nodiscard]] static std::string out(const std::string& name = "") { return "out/" + name; }

  /// All files below a folder, those that begin with a dot as well.
  [[nodiscard]] static std::vector<std::string> all_files(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    if (!std::filesystem::exists(folder)) return names;
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder))
      if (!file.is_directory()) names.push_back(std::filesystem::relative(file.path(), folder).string());
    std::ranges::sort(names);
    return names;
  }

  struct Ending {
    int status{};      // as a shell would give it
    double seconds{};  // from the signal to the end
    std::string errors;
  };

  /// Runs the program, waits until it catches the signal, if it can, and then as asked, and sends the signal to it and to
  /// all that it has started, as a terminal does.
  [[nodiscard]] Ending signalled(const std::string& arguments, int signal,
                                 const std::function<void()>& wait) const {
    const std::string command = std::string("exec '") + STICKSLIP_PROGRAM + "' " + arguments + " >'" +
                                path("stdout") + "' 2>'" + path("stderr") + "'";
    const pid_t process = ::fork();
    if (process == 0) {
      ::setpgid(0, 0);
      ::signal(signal, SIG_DFL);  // a shell that starts the tests in the background has them ignore Ctrl-C
      ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      ::_exit(127);
    }
    ::setpgid(process, process);  // whoever comes first
    if (signal != SIGKILL) wait_until([&] { return catches(process, signal); });
    wait();
    const auto begin = std::chrono::steady_clock::now();
    ::kill(-process, signal);
    int status = 0;
    ::waitpid(process, &status, 0);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), took.count(),
            contents(path("stderr"))};
  }

  [[nodiscard]] Ending signalled(const std::string& arguments, int signal,
                                 std::chrono::duration<double> after) const {
    return signalled(arguments, signal, [after] { std::this_thread::sleep_for(after); });
  }

  /// Whether a process has a handler of a signal.
  static bool catches(pid_t process, int signal) {
    std::istringstream status(contents("/proc/" + std::to_string(process) + "/status"));
    for (std::string line; std::getline(status, line);)
      if (line.starts_with("SigCgt:"))
        return (std::stoull(line.substr(7), nullptr, 16) >> static_cast<unsigned>(signal - 1) & 1U) != 0U;
    return false;
  }

  /// Waits until something is so, which must come in time.
  static void wait_until(const std::function<bool()>& is_so,
                         std::chrono::seconds at_most = std::chrono::minutes(1)) {
    const auto limit = std::chrono::steady_clock::now() + at_most;
    while (!is_so() && std::chrono::steady_clock::now() < limit)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    EXPECT_TRUE(is_so());
  }
};

}  // namespace stickslip::testing
