#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace stickslip::mutants {

/// Files of one component with a mistake in them, by name relative to the source tree.
using ChangedFiles = std::map<std::string, std::string>;

/// Builds shared libraries with a mistake in them, by the compiler's commands of a build tree whose models
/// are shared libraries (preset "mutants"). The build tree's own files stay as they are. Safe to use from
/// several threads for different folders.
class Workshop {
 public:
  /// Throws std::runtime_error if the build tree is not such a one, or not built.
  Workshop(std::filesystem::path source_tree, std::filesystem::path build_tree);

  enum class Outcome { built, not_compiling, same_code };

  /// Builds the component of the changed files into `folder`/lib.
  [[nodiscard]] Outcome build(const ChangedFiles& changed, const std::filesystem::path& folder) const;

  /// Changes with whatever a mutant of the component is built from but its changed files.
  [[nodiscard]] const std::string& fingerprint(const std::string& component) const;

 private:
  struct Unit {
    std::string source, command, object;
    std::vector<std::string> headers;
  };
  struct Component {
    std::vector<Unit> units;
    std::string link_command;
    std::string library;
    std::string fingerprint;
  };

  [[nodiscard]] Component read_component(const std::string& name) const;
  // The standard output of ninja with a tool (-t) of its own.
  [[nodiscard]] std::string ask_ninja(const std::vector<std::string>& arguments) const;
  void read_headers(Component& component) const;

  std::filesystem::path source_tree_, build_tree_;
  std::map<std::string, Component> components_;
};

}  // namespace stickslip::mutants
