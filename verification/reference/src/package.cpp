// SPDX-License-Identifier: MIT
#include "stickslip/reference/package.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "sets.hpp"
#include "stickslip/data/input_text.hpp"

namespace stickslip::reference {

namespace {

using Json = nlohmann::ordered_json;

// The text of a JSON value. An object or array of at most 120 characters stands on one line. In a longer object the
// members share lines of that length, in a longer array each element has a line of its own.
std::string text_of(const Json& json, std::size_t indent = 0) {
  if (!json.is_structured()) return json.dump();
  constexpr std::size_t width = 120;
  const auto is_broken = [](const std::string& text) { return text.find('\n') != std::string::npos; };
  std::vector<std::string> members;
  for (const auto& [key, value] : json.items())
    members.push_back((json.is_object() ? Json(key).dump() + ": " : "") + text_of(value, indent + 1));
  const auto [open, close] = json.is_object() ? std::pair('{', '}') : std::pair('[', ']');
  std::string text = fmt::format("{}{}{}", open, fmt::join(members, ", "), close);
  if (text.size() <= width && !is_broken(text)) return text;
  text = open + members.front();
  std::size_t column = indent + text.size();
  for (std::size_t i = 1; i < members.size(); ++i) {
    const bool stays = json.is_object() && !is_broken(members[i - 1]) && !is_broken(members[i]) &&
                       column + 2 + members[i].size() < width;
    text += stays ? ", " : ",\n" + std::string(indent + 1, ' ');
    text += members[i];
    column = (stays ? column + 2 : indent + 1) + members[i].size();
  }
  return text + close;
}

// The text of the CSV file of a data set.
std::string csv_of(const DataSet& set) {
  std::string text;
  for (const data::Field& field : set.resource.fields) text += (text.empty() ? "" : ",") + field.name;
  text += '\n';
  for (const auto& row : set.rows) {
    if (row.size() != set.resource.fields.size())
      throw std::logic_error(fmt::format("{}: a row of {} cells for {} fields", set.resource.name, row.size(),
                                         set.resource.fields.size()));
    text += fmt::format("{}\n", fmt::join(row, ","));
  }
  return text;
}

// Version and date at the head of the newest entry of the changelog of the data, "## 1.1.0, 2026-11-25".
std::pair<std::string, std::string> newest_version() {
  std::ifstream changelog(data::reference_directory() / "CHANGELOG.md");
  for (std::string line; std::getline(changelog, line);)
    if (const std::size_t comma = line.find(", "); line.starts_with("## ") && comma != std::string::npos)
      return {line.substr(3, comma - 3), line.substr(comma + 2)};
  throw std::runtime_error("data/reference/CHANGELOG.md has no entry");
}

}  // namespace

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all = [] {
    std::vector<Recipe> list;
    for (const auto& group : {enclosed_sets(), converged_sets(), field_sets(), exact_sets(), published_sets(),
                              random_sets(), record_sets()})
      list.insert(list.end(), group.begin(), group.end());
    std::ranges::sort(list, {}, &Recipe::position);
    return list;
  }();
  return all;
}

std::map<std::string, std::string> package_files(const std::vector<DataSet>& sets,
                                                 const std::string& before) {
  std::map<std::string, std::string> files;
  std::map<std::string, Json> by_name;
  const Json kept = before.empty() ? Json::array() : Json::parse(before).at("resources");
  for (const Json& resource : kept) by_name[resource.at("name")] = resource;
  for (const DataSet& set : sets) {
    const std::string csv = csv_of(set);
    data::Resource resource = set.resource;
    resource.bytes = csv.size();
    resource.sha256 = data::sha256(csv);
    by_name[resource.name] = Json::parse(data::json_text(resource));
    files[resource.path.generic_string()] = csv;
  }
  Json resources = Json::array();
  for (const Recipe& recipe : recipes())
    if (const auto made = by_name.find(std::string(recipe.name)); made != by_name.end())
      resources.push_back(made->second);
  const auto [version, date] = newest_version();
  const Json package{
      {"profile", "tabular-data-package"},
      {"name", "stickslip-reference"},
      {"id", "urn:uuid:4b0f6a1e-2c53-4d0e-9a67-7f3b5a2d91c8"},
      {"title", "Reference data for the stick-slip vibration of beams"},
      {"description",
       "The problem of Won, Lee and Chung, Stick-slip vibration of a cantilever beam subjected to harmonic "
       "base excitation, Nonlinear Dynamics (2018), and its parts: numbers with the half-widths of their "
       "uncertainties, for checking other implementations. README.md explains the files."},
      {"version", version},
      {"created", date + "T00:00:00Z"},
      {"keywords", {"stick-slip", "friction", "vibration", "beam", "verification", "benchmark"}},
      {"sources",
       {{{"title",
          "Won, Lee and Chung, Nonlinear Dynamics, 2018: stick-slip vibration of a cantilever beam"}},
        {{"title", "code_aster, manual of validation: SDND100, SDND104 and SDND106"}},
        {{"title", "Den Hartog, Trans. ASME 53, 1931: forced vibration with Coulomb friction"}},
        {{"title", "Hong and Liu, J. Sound Vib. 229, 2000: stops of a forced mass with friction"}}}},
      {"licenses",
       {{{"name", "MIT"}, {"path", "https://opensource.org/licenses/MIT"}, {"title", "MIT License"}}}},
      {"resources", resources}};
  files["datapackage.json"] = text_of(package) + '\n';
  return files;
}

}  // namespace stickslip::reference
