// SPDX-License-Identifier: MIT
#include "render/external_tool.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>

namespace stickslip::report {

namespace fs = std::filesystem;

namespace {

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

int run_tool(const std::string& program, const std::vector<std::string>& arguments, const fs::path& folder,
             const fs::path& log) {
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = tool_environment();
  const FileActions actions(folder, log);
  pid_t process{};
  const int error = ::posix_spawnp(&process, program.c_str(), actions.get(), nullptr,
                                   pointers_to(words).data(), pointers_to(variables).data());
  if (error == ENOENT)
    throw ToolMissing(fmt::format("{} is not installed or not on the search path", program));
  if (error != 0)
    throw std::runtime_error(
        fmt::format("{} cannot be started: {}", program, std::generic_category().message(error)));
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitpid");
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
