// SPDX-License-Identifier: MIT
#pragma once

/// The command line, ended by a signal while it works.

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
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
    double seconds{};  // of processor time from the signal to the end, which a busy machine does not lengthen
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
    const double before = processor_time(process);
    ::kill(-process, signal);
    int status = 0;
    rusage usage{};
    ::wait4(process, &status, 0, &usage);
    const double after = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), after - before,
            contents(path("stderr"))};
  }

  [[nodiscard]] Ending signalled(const std::string& arguments, int signal,
                                 std::chrono::duration<double> after) const {
    return signalled(arguments, signal, [after] { std::this_thread::sleep_for(after); });
  }

  static double seconds_of(const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  }

  /// The processor time of a running process in seconds.
  static double processor_time(pid_t process) {
    clockid_t clock{};
    timespec t{};
    EXPECT_EQ(::clock_getcpuclockid(process, &clock), 0);
    EXPECT_EQ(::clock_gettime(clock, &t), 0);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }

  /// Whether a process is the program, no longer the shell that starts it, and has a handler of a signal.
  static bool catches(pid_t process, int signal) {
    std::error_code error;
    const std::string folder = "/proc/" + std::to_string(process);
    if (!std::filesystem::equivalent(folder + "/exe", STICKSLIP_PROGRAM, error)) return false;
    std::istringstream status(contents(folder + "/status"));
    for (std::string line; std::getline(status, line);)
      if (line.starts_with("SigCgt:"))
        return (std::stoull(line.substr(7), nullptr, 16) >> static_cast<unsigned>(signal - 1) & 1U) != 0U;
    return false;
  }

  /// Waits until something is so, a minute at most.
  static void wait_until(const std::function<bool()>& is_so) {
    const auto limit = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (!is_so() && std::chrono::steady_clock::now() < limit)
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    EXPECT_TRUE(is_so());
  }
};

}  // namespace stickslip::testing
