#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "case_options.hpp"
#include "commands.hpp"
#include "completion.hpp"
#include "manual_page.hpp"
#include "output_file.hpp"
#include "stickslip/version.hpp"

namespace stickslip::cli {

namespace {

struct DocumentationOptions {
  std::string format;
  std::string output = "-";
};

const std::map<std::string, std::function<std::string(const Command&)>> formats{
    {"man", [](const Command& program) { return manual_page(program, version); }},
    {"bash", bash_completion},
    {"zsh", zsh_completion},
    {"fish", fish_completion}};

}  // namespace

void add_documentation_command(CLI::App& app) {
  auto* command = app.add_subcommand("documentation", "Manual page, or completion for a shell");
  command->group("");
  auto options = std::make_shared<DocumentationOptions>();
  std::vector<std::string> names;
  for (const auto& [name, text_of] : formats) names.push_back(name);
  command->add_option("FORMAT", options->format)->check(one_of(names))->required();
  command->add_option("--output", options->output, "File, '-' for standard output")
      ->check(file_name())
      ->capture_default_str();
  command->callback([&app, options] {
    OutputFile file(options->output);
    file.write(formats.at(options->format)(command_tree(app)));
    file.commit();
  });
}

}  // namespace stickslip::cli
