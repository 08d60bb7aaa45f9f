// SPDX-License-Identifier: MIT
#include "render/external_tool.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <sstream>
#include <string_view>
#include <system_error>

namespace stickslip::report {

namespace fs = std::filesystem;

namespace {

// The program that runs, 0 for none, and whether no other may start.
std::mutex guard;
pid_t running{};
bool has_ended{};

[[noreturn]] void fail_without(const std::string& program) {
  throw ToolMissing(fmt::format("{} is not installed or not on the search path", program));
}

class FileActions {
 public:
  FileActions(const fs::path& folder, const fs::path& log) {
    ::posix_spawn_file_actions_init(&actions_);
    ::posix_spawn_file_actions_addopen(&actions_, 0, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions_, 1, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ::posix_spawn_file_actions_adddup2(&actions_, 1, 2);
    ::posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
  }
  ~FileActions() { ::posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;

  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

// This process's environment with the one locale that every tool gets: gnuplot needs UTF-8, and neither
// decimal commas nor translated messages may reach a document.
std::vector<std::string> tool_environment() {
  constexpr std::string_view locale = "LC_ALL=";
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable)
    if (!std::string_view(*variable).starts_with(locale)) variables.emplace_back(*variable);
  variables.push_back(std::string(locale) + "C.UTF-8");
  return variables;
}

// As posix_spawn takes them: ended by a null pointer.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

void require_tool(const std::string& program) {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "/bin:/usr/bin" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder.empty() ? "." : folder) / program;
    if (std::error_code error; ::access(file.c_str(), X_OK) == 0 && !fs::is_directory(file, error)) return;
  }
  fail_without(program);
}

void end_tools() {
  const std::lock_guard lock(guard);
  has_ended = true;
  if (running != 0) ::kill(running, SIGKILL);
}

int run_tool(const std::string& program, const std::vector<std::string>& arguments, const fs::path& folder,
             const fs::path& log) {
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = tool_environment();
  const FileActions actions(folder, log);
  pid_t process{};
  {
    const std::lock_guard lock(guard);
    const int error = has_ended ? ECANCELED
                                : ::posix_spawnp(&process, program.c_str(), actions.get(), nullptr,
                                                 pointers_to(words).data(), pointers_to(variables).data());
    if (error == ENOENT) fail_without(program);
    if (error != 0)
      throw std::runtime_error(
          fmt::format("{} cannot be started: {}", program, std::generic_category().message(error)));
    running = process;
  }
  siginfo_t end{};  // end_tools() needs the process until it is known to have ended
  while (::waitid(P_PID, static_cast<id_t>(process), &end, WEXITED | WNOWAIT) < 0)
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitid");
  const std::lock_guard lock(guard);
  running = 0;
  int status = 0;
  ::waitpid(process, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

std::string tool_version(const std::string& program, const fs::path& scratch) {
  const fs::path log = scratch / (program + "-version.log");
  try {
    if (run_tool(program, {"--version"}, scratch, log) != 0) return "unknown";
  } catch (const ToolMissing&) {
    return "not found";
  }
  std::ifstream stream(log);
  std::string line;
  std::getline(stream, line);
  return line;
}

}  // namespace stickslip::report
