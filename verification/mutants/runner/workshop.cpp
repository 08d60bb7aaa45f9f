#include "workshop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "external_tool.hpp"
#include "fingerprint.hpp"
#include "stickslip/mutants/mutant.hpp"
#include "stickslip/report/text_file.hpp"

namespace stickslip::mutants {

namespace fs = std::filesystem;

namespace {

std::string with_all_replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t place = 0; (place = text.find(from, place)) != std::string::npos; place += to.size())
    text.replace(place, from.size(), to);
  return text;
}

std::string word_after(const std::string& text, const std::string& mark) {
  const std::size_t begin = text.find(mark) + mark.size();
  return text.substr(begin, text.find(' ', begin) - begin);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

Workshop::Workshop(fs::path source_tree, fs::path build_tree)
    : source_tree_(std::move(source_tree)), build_tree_(std::move(build_tree)) {
  for (const char* name : {"solver", "analytic"}) components_.emplace(name, read_component(name));
}

std::string Workshop::ask_ninja(const std::vector<std::string>& arguments) const {
  const fs::path log = build_tree_ / "ninja-answer.txt";
  if (report::run_tool("ninja", arguments, build_tree_, log) != 0)
    throw std::runtime_error(
        fmt::format("ninja has no answer about {}: {}", build_tree_.string(), report::read_text(log)));
  return report::read_text(log);
}

Workshop::Component Workshop::read_component(const std::string& name) const {
  Component component;
  component.library = fmt::format("{0}/libstickslip_{0}.so", name);
  if (!fs::exists(build_tree_ / component.library))
    throw std::runtime_error(fmt::format("{} is missing; build the preset 'mutants' first",
                                         (build_tree_ / component.library).string()));
  const std::string folder = (source_tree_ / name).string() + "/";
  report::Fingerprint fingerprint;
  for (const auto& entry : nlohmann::json::parse(report::read_text(build_tree_ / "compile_commands.json"))) {
    const std::string source = entry.at("file");
    if (!source.starts_with(folder)) continue;
    const std::string command = entry.at("command");
    component.units.push_back(
        {.source = source, .command = command, .object = word_after(command, " -o "), .headers = {}});
    fingerprint.add(component.units.back().command);
  }
  read_headers(component);
  component.link_command = lines_of(ask_ninja({"-t", "commands", component.library})).back();
  fingerprint.add(component.link_command).add_folder(folder).add_folder(source_tree_ / "data/include");
  component.fingerprint = fingerprint.text();
  return component;
}

// "object: #deps 12, ...", then an indented line for each.
void Workshop::read_headers(Component& component) const {
  for (Unit& unit : component.units)
    for (const std::string& line : lines_of(ask_ninja({"-t", "deps", unit.object})))
      if (line.starts_with(' '))
        unit.headers.push_back((build_tree_ / line.substr(line.find_first_not_of(' '))).lexically_normal());
}

const std::string& Workshop::fingerprint(const std::string& component) const {
  return components_.at(component).fingerprint;
}

Workshop::Outcome Workshop::build(const ChangedFiles& changed, const fs::path& folder) const {
  const std::string name = component_of(changed.begin()->first);
  const Component& component = components_.at(name);
  const fs::path copy = folder / name;
  fs::remove_all(folder);
  fs::create_directories(folder / "lib");
  fs::copy(source_tree_ / name, copy, fs::copy_options::recursive);
  for (const auto& [file, text] : changed) report::write_text(folder / file, text);

  std::string link_command = component.link_command;
  bool same_code = true;
  int number = 0;
  for (const Unit& unit : component.units) {
    const auto is_changed = [&](const auto& file) {
      const std::string full = (source_tree_ / file.first).lexically_normal().string();
      return full == unit.source || std::ranges::find(unit.headers, full) != unit.headers.end();
    };
    if (std::ranges::none_of(changed, is_changed)) continue;
    const std::string object = (folder / fmt::format("{}.o", number++)).string();
    std::string command =
        with_all_replaced(unit.command, (source_tree_ / name).string() + "/", copy.string() + "/");
    command = with_all_replaced(command, " -o " + unit.object, " -o " + object) + " -w";
    if (report::run_tool("sh", {"-c", command}, build_tree_, folder / "compiler.log") != 0)
      return Outcome::not_compiling;
    same_code = same_code && report::read_text(object) == report::read_text(build_tree_ / unit.object);
    link_command = with_all_replaced(link_command, " " + unit.object, " " + object);
  }
  if (same_code) return Outcome::same_code;
  link_command =
      with_all_replaced(link_command, " -o " + component.library,
                        " -o " + (folder / "lib" / fs::path(component.library).filename()).string());
  if (report::run_tool("sh", {"-c", link_command}, build_tree_, folder / "linker.log") != 0)
    return Outcome::not_compiling;
  return Outcome::built;
}

}  // namespace stickslip::mutants
