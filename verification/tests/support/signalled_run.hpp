// SPDX-License-Identifier: MIT
#pragma once

/// The command line, ended by a signal while it works: by Ctrl-C on a terminal, by a tool that it runs, or before a system call.
/// Each moment is one of the work, none of a clock.

#include <pty.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>

#include "support/command_line.hpp"

namespace stickslip::testing {

class SignalledRun : public Drawing {
 protected:
  using Contents = std::map<std::string, std::string>;  // of files, by name

  void SetUp() override {
    Drawing::SetUp();
    ::signal(SIGINT, SIG_DFL);  // a shell that starts the tests in the background has them ignore Ctrl-C
  }

  /// All files below a folder, those that begin with a dot as well.
  [[nodiscard]] static Contents contents_of(const std::filesystem::path& folder) {
    Contents files;
    if (!std::filesystem::exists(folder)) return files;
    for (const auto& file : std::filesystem::recursive_directory_iterator(folder))
      if (!file.is_directory())
        files[std::filesystem::relative(file.path(), folder).string()] = contents(file.path());
    return files;
  }
  [[nodiscard]] static std::vector<std::string> all_files(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& [name, text] : contents_of(folder)) names.push_back(name);
    return names;
  }

  /// What the command says on a terminal, where Ctrl-C is typed once it has said `then`; nothing where the system has no
  /// pseudo-terminal.
  [[nodiscard]] static std::optional<Outcome> on_terminal(const std::string& arguments,
                                                          const std::string& then = "") {
    int terminal = -1;
    const pid_t process = ::forkpty(&terminal, nullptr, nullptr, nullptr);
    if (process < 0) return std::nullopt;
    if (process == 0) become(arguments);
    std::string said;
    bool is_typed = then.empty();
    std::array<char, 4096> bytes{};
    for (ssize_t count = 0; (count = ::read(terminal, bytes.data(), bytes.size())) > 0;) {
      said.append(bytes.data(), static_cast<std::size_t>(count));
      if (!is_typed && said.find(then) != std::string::npos) is_typed = ::write(terminal, "\x03", 1) == 1;
    }
    int status = -1;
    ::waitpid(process, &status, 0);
    ::close(terminal);
    return Outcome{shell_status(status), said, ""};
  }

  /// Kills a command before the n-th of its system calls that change a file. Returns its status as a shell gives it: 0 where it makes
  /// fewer.
  [[nodiscard]] static int killed_before(int n, const std::string& arguments) {
    const pid_t process = ::fork();
    if (process == 0) {
      ::setenv("ASAN_OPTIONS", "detect_leaks=0", 1);  // it would trace the process as well
      ::ptrace(PTRACE_TRACEME);
      become(arguments + " >/dev/null 2>&1");
    }
    int status = 0;
    ::waitpid(process, &status, 0);
    ::ptrace(PTRACE_SETOPTIONS, process, 0L, long{PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL});
    for (; WIFSTOPPED(status); ::waitpid(process, &status, 0)) {
      const int signal = WSTOPSIG(status);
      __ptrace_syscall_info call{};
      if (signal == (SIGTRAP | 0x80)) ::ptrace(PTRACE_GET_SYSCALL_INFO, process, sizeof call, &call);
      if (changes_a_file(call) && --n == 0) ::kill(process, SIGKILL);
      ::ptrace(PTRACE_SYSCALL, process, 0L, (signal & ~0x80) == SIGTRAP ? 0L : long{signal});
    }
    return shell_status(status);
  }

  /// What a command says that is ended by a signal of a tool, without the program's name: sent to it alone, as by a scheduler, or to
  /// all that it has started, as by a terminal. The tool would go on for longer than the run may take, and must have ended.
  [[nodiscard]] std::string said_after(int signal, bool alone, const std::string& tool,
                                       const std::string& arguments) const {
    const std::string temporary = path("temporary"), sleeper = path("sleeper");
    const int limit = tool == "gnuplot" ? 60 : 3600;  // s: LaTeX comes after all studies
    install_tool(tool,
                 fmt::format("[ \"$1\" = --version ] && exit\necho $$ >'{}'\nkill -{} {}\nexec sleep {}\n",
                             sleeper, signal, alone ? "$PPID" : "0", 2 * limit));
    std::filesystem::create_directory(temporary);
    const Outcome outcome = shell(fmt::format("TMPDIR='{}' timeout -k 5 {} setsid --wait '{}' {}", temporary,
                                              limit, STICKSLIP_PROGRAM, arguments));
    EXPECT_EQ(outcome.status, 128 + signal) << outcome.errors;
    const std::string stat = "/proc/" + std::to_string(std::stoi(contents(sleeper))) + "/stat";
    const auto is_running = [&] {
      const std::string state = contents(stat);
      return !state.empty() && state.substr(state.rfind(')') + 2, 1) != "Z";
    };
    for (int looks = 0; looks < 1000 && is_running(); ++looks) ::usleep(10'000);
    EXPECT_FALSE(is_running()) << tool;
    EXPECT_EQ(all_files(temporary), std::vector<std::string>{}) << arguments;
    for (const std::string& name : {temporary, sleeper}) std::filesystem::remove_all(name);
    const std::string name = "stickslip: ";
    EXPECT_TRUE(outcome.errors.starts_with(name) && std::ranges::count(outcome.errors, '\n') == 1)
        << outcome.errors;
    return outcome.errors.substr(std::min(name.size(), outcome.errors.size()));
  }

 private:
  /// Becomes the program, which an alarm ends in a minute, so that no test waits for ever.
  [[noreturn]] static void become(const std::string& arguments) {
    ::alarm(60);
    ::execl("/bin/sh", "sh", "-c", ("exec '" STICKSLIP_PROGRAM "' " + arguments).c_str(), nullptr);
    ::_exit(127);
  }

  [[nodiscard]] static int shell_status(int status) {
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  [[nodiscard]] static bool changes_a_file(const __ptrace_syscall_info& call) {
    static const std::set<std::uint64_t> changing{
        SYS_write,  SYS_ftruncate, SYS_unlinkat, SYS_mkdirat, SYS_renameat2,
#ifdef SYS_rename
        SYS_rename, SYS_unlink,    SYS_mkdir,    SYS_rmdir,
#endif
    };
    if (call.op != PTRACE_SYSCALL_INFO_ENTRY) return false;
    const bool creates = call.entry.nr == SYS_openat && (call.entry.args[2] & O_CREAT) != 0;
    return creates || changing.contains(call.entry.nr);
  }
};

/// Commands that are killed at any moment.
class KilledRun : public SignalledRun {
 protected:
  /// Kills a command, whose outputs are in the folder out, before every `stride`-th change of a file, each time from the start. What is
  /// there under the name of an output has the bytes of the undisturbed run, and the same command completes and leaves nothing else.
  void kill(const std::string& command, const std::vector<std::string>& outputs, int stride = 1) const {
    const auto run_from_nothing = [&](int n) {
      std::filesystem::remove_all("out");
      std::filesystem::create_directory("out");
      return killed_before(n, command);
    };
    ASSERT_EQ(run_from_nothing(std::numeric_limits<int>::max()), 0);
    const Contents undisturbed = contents_of("out");
    EXPECT_EQ(all_files("out"), outputs);
    int n = stride;
    for (int status = 0; (status = run_from_nothing(n)) != 0; n += stride) {
      ASSERT_EQ(status, 128 + SIGKILL) << n;
      for (const auto& [name, text] : contents_of("out")) {
        const bool is_unfinished = name.starts_with('.') || name.find("/.") != std::string::npos;
        ASSERT_TRUE(is_unfinished || (undisturbed.contains(name) && undisturbed.at(name) == text))
            << name << n;
      }
      ASSERT_EQ(run(command).status, 0);
      ASSERT_TRUE(contents_of("out") == undisturbed) << n;
    }
    EXPECT_GT(n, 10);
  }
};

}  // namespace stickslip::testing
