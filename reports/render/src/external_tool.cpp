#include "external_tool.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <functional>
#include <mutex>
#include <set>
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

// What is started leads a process group of its own, so that it can be ended with all that it starts, and gets
// all signals, whichever this thread leaves to another.
class OwnGroup {
 public:
  OwnGroup() {
    sigset_t none;
    ::sigemptyset(&none);
    ::posix_spawnattr_init(&attributes_);
    ::posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    ::posix_spawnattr_setpgroup(&attributes_, 0);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
  }
  ~OwnGroup() { ::posix_spawnattr_destroy(&attributes_); }
  OwnGroup(const OwnGroup&) = delete;
  OwnGroup& operator=(const OwnGroup&) = delete;

  [[nodiscard]] const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_{};
};

// The programs at work, each the leader of its process group.
class RunningTools {
 public:
  pid_t start(const std::function<pid_t()>& spawn) {
    const std::lock_guard lock(guard_);
    require_not_ended();
    return *running_.insert(spawn()).first;
  }

  // Waits for the end of a program. It stays a zombie, and its number its own, until nobody would kill it.
  int exit_status(pid_t process) {
    siginfo_t ignored{};
    while (::waitid(P_PID, static_cast<id_t>(process), &ignored, WEXITED | WNOWAIT) < 0)
      if (errno != EINTR) throw std::system_error(errno, std::generic_category(), "waitid");
    const std::lock_guard lock(guard_);
    running_.erase(process);
    int status = 0;
    ::waitpid(process, &status, 0);
    require_not_ended();
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }

  void end() {
    const std::lock_guard lock(guard_);
    ended_ = true;
    for (const pid_t process : running_) ::kill(-process, SIGKILL);
  }

 private:
  void require_not_ended() const {
    if (ended_) throw std::runtime_error("other programs have been ended");
  }

  std::mutex guard_;
  std::set<pid_t> running_;
  bool ended_{};
};

RunningTools& running_tools() {
  static RunningTools tools;
  return tools;
}

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
  const OwnGroup group;
  const pid_t process = running_tools().start([&] {
    pid_t started{};
    const int error = ::posix_spawnp(&started, program.c_str(), actions.get(), group.get(),
                                     pointers_to(words).data(), pointers_to(variables).data());
    if (error == ENOENT)
      throw ToolMissing(fmt::format("{} is not installed or not on the search path", program));
    if (error != 0)
      throw std::runtime_error(
          fmt::format("{} cannot be started: {}", program, std::generic_category().message(error)));
    return started;
  });
  return running_tools().exit_status(process);
}

void end_tools() noexcept { running_tools().end(); }

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
