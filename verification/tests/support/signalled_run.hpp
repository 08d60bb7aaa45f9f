// SPDX-License-Identifier: MIT
#pragma once

/// The command line, ended by a signal while it works.

#include <pty.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <random>
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

  /// Runs the program, waits until it catches the signal, if it can, and until the moment has come, and sends the signal to it and to
  /// all that it has started, as a terminal does, or to it alone, as `timeout` does.
  [[nodiscard]] Ending signalled(const std::string& arguments, int signal,
                                 const std::function<bool()>& is_time, bool alone = false) const {
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
    const auto ended = [&] { return !is_running(std::to_string(process)); };
    wait_until([&] { return ended() || ((signal == SIGKILL || catches(process, signal)) && is_time()); });
    EXPECT_TRUE(signal == SIGKILL || !ended()) << arguments;
    const double before = processor_time(process);
    ::kill(alone ? process : -process, signal);
    int status = 0;
    rusage usage{};
    ::wait4(process, &status, 0, &usage);
    const double after = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), after - before,
            contents(path("stderr"))};
  }

  [[nodiscard]] Ending signalled(const std::string& arguments, int signal,
                                 std::chrono::duration<double> after) const {
    return signalled(arguments, signal, [after] {
      std::this_thread::sleep_for(after);
      return true;
    });
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

  [[nodiscard]] static bool is_running(const std::string& process) {
    const std::string status = contents("/proc/" + process + "/stat");
    return !status.empty() && status.substr(status.rfind(')') + 2, 1) != "Z";
  }

  /// Waits until something is so, however long that takes on a busy machine.
  static void wait_until(const std::function<bool()>& is_so) {
    while (!is_so()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }

  /// What the command says on a terminal; nothing where the system has no pseudo-terminal.
  [[nodiscard]] static std::optional<std::string> on_terminal(const std::string& arguments) {
    int terminal = -1;
    const pid_t process = ::forkpty(&terminal, nullptr, nullptr, nullptr);
    if (process < 0) return std::nullopt;
    if (process == 0) {
      const std::string command = std::string("exec '") + STICKSLIP_PROGRAM + "' " + arguments;
      ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      ::_exit(127);
    }
    std::string said;
    std::array<char, 4096> bytes{};
    for (ssize_t count = 0; (count = ::read(terminal, bytes.data(), bytes.size())) > 0;)
      said.append(bytes.data(), static_cast<std::size_t>(count));
    int status = -1;
    ::waitpid(process, &status, 0);
    EXPECT_EQ(status, 0) << said;
    ::close(terminal);
    return said;
  }
};

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

  [[nodiscard]] bool sleeps() const { return std::filesystem::exists(path("processes")); }

  /// Runs until the sleeper sleeps, sends the signal and returns what is said, without the program's name.
  [[nodiscard]] std::string said_after(int signal, const std::string& arguments, bool alone = false) const {
    const Ending ending = signalled(
        arguments, signal, [&] { return sleeps(); }, alone);
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

/// Commands that are killed at any moment: what has a name of its own is whole each time, and the same command
/// completes.
class KilledRun : public SignalledRun {
 protected:
  using Contents = std::map<std::string, std::string>;  // of files, by name

  /// Kills a command `kills` times while it works, each at a random moment of the time that it takes
  /// undisturbed, and lets it go on from what is there; once its outputs are complete it begins anew. What is
  /// under the name of an output has the bytes of the undisturbed run, and nothing else is left in the end.
  void kill(int kills, const std::string& command, std::vector<std::string> outputs) {
    const double whole = seconds_of(command);
    Contents undisturbed;
    for (const std::string& name : outputs) {
      undisturbed[name] = contents(out(name));
      ASSERT_NE(undisturbed[name], "") << name;
    }
    std::ranges::sort(outputs);
    EXPECT_EQ(all_files(out()), outputs);
    ASSERT_NO_FATAL_FAILURE(kill_at_random(kills, command, undisturbed, whole));
    const Outcome again = run(command);
    EXPECT_EQ(again.status, 0) << again.errors;
    for (const auto& [name, text] : undisturbed) EXPECT_TRUE(contents(out(name)) == text) << name;
    EXPECT_EQ(all_files(out()), outputs);
  }

  /// The runs that are killed at moments up to `latest` seconds, and those that end before.
  void kill_at_random(int kills, const std::string& command, const Contents& undisturbed, double latest) {
    const auto is_complete = [&] {
      return std::ranges::all_of(undisturbed,
                                 [&](const auto& file) { return std::filesystem::exists(out(file.first)); });
    };
    std::uniform_real_distribution<double> moments(0.0, latest);
    for (int killed = 0, runs = 0; killed < kills; ++runs) {
      ASSERT_LT(runs, 6 * kills);
      if (is_complete()) clear();
      const Ending ending = signalled(command, SIGKILL, std::chrono::duration<double>(moments(generator_)));
      if (ending.status == 128 + SIGKILL) {
        ++killed;
      } else {
        ASSERT_EQ(ending.status, 0) << ending.errors;
      }
      ASSERT_NO_FATAL_FAILURE(expect_only_whole(undisturbed));
    }
  }

  /// The files that are there have the bytes of the undisturbed run, or the name of an unfinished one.
  void expect_only_whole(const Contents& undisturbed) const {
    for (const std::string& name : all_files(out()))
      EXPECT_TRUE(undisturbed.contains(name) || name.starts_with('.') ||
                  name.find("/.") != std::string::npos || name.ends_with(".partial"))
          << name;
    for (const auto& [name, text] : undisturbed)
      if (std::filesystem::exists(out(name))) {
        ASSERT_TRUE(contents(out(name)) == text) << name;
      }
  }

  /// What a whole run takes: the shortest of three, since other work may delay one.
  [[nodiscard]] double seconds_of(const std::string& command) const {
    double shortest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      clear();
      const auto begin = std::chrono::steady_clock::now();
      const Outcome outcome = run(command);
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
      EXPECT_EQ(outcome.status, 0) << outcome.errors;
      shortest = std::min(shortest, took.count());
    }
    return shortest;
  }

  void clear() const {
    std::filesystem::remove_all(out());
    std::filesystem::create_directory(out());
  }

 private:
  std::mt19937 generator_{1};
};

}  // namespace stickslip::testing
