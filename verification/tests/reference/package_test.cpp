// SPDX-License-Identifier: MIT
/// The published data: what is in the repository is what the code makes, and every file says where it is
/// from.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/reference.hpp"
#include "stickslip/reference/package.hpp"
#include "support/published_data.hpp"
#include "support/requirements.hpp"

namespace stickslip::testing {
namespace {

namespace fs = std::filesystem;

std::vector<reference::DataSet> quick_sets() {
  std::vector<reference::DataSet> sets;
  for (const reference::Recipe& recipe : reference::recipes())
    if (recipe.is_quick) sets.push_back(recipe.make());
  return sets;
}

// To a quarter: they have two printed digits, and some are differences, with the rounding of both sides.
void expect_same_half_widths(const data::ReferencePackage& package,
                             const std::vector<reference::DataSet>& sets) {
  int compared = 0;
  for (const reference::DataSet& set : sets) {
    if (set.resource.provenance.value_class != data::ValueClass::converged) continue;
    const data::ReferenceTable published = data::read_table(package, set.resource.name);
    for (std::size_t column = 0; column < set.resource.fields.size(); ++column) {
      const std::string& name = set.resource.fields[column].name;
      if (!name.ends_with("_radius")) continue;
      for (std::size_t row = 0; row < set.rows.size(); ++row) {
        const double before = published.columns[column].values[row], now = std::stod(set.rows[row][column]);
        ASSERT_LT(std::abs(now - before), 0.25 * before)
            << set.resource.name << ", " << name << ", row " << row + 1;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 1000);
}

// But for the size, and for the version of the library for ball arithmetic.
void expect_same_description(const std::vector<reference::DataSet>& sets) {
  const auto resources = [](const std::string& text) {
    std::map<std::string, nlohmann::json> by_name;
    const auto package = nlohmann::json::parse(text);
    for (nlohmann::json resource : package.at("resources")) {
      for (const char* key : {"bytes", "hash"}) resource.erase(key);
      resource.at("provenance").erase("software");
      by_name[resource.at("name")] = resource;
    }
    return by_name;
  };
  const auto published = resources(data::read_text(data::reference_directory() / "datapackage.json"));
  const auto made = resources(reference::package_files(sets).at("datapackage.json"));
  EXPECT_EQ(made.size(), sets.size());
  for (const auto& [name, resource] : made) EXPECT_EQ(published.at(name), resource);
}

STICKSLIP_VERIFIES(PublishedData, "P6");
TEST(PublishedData, IsWhatTheCodeMakes) {
  const data::ReferencePackage package = data::load_reference();
  const auto sets = quick_sets();
  for (const reference::DataSet& set : sets)
    expect_same_data(data::read_table(package, set.resource.name), set);
  expect_same_half_widths(package, sets);
  expect_same_description(sets);
}

TEST(PublishedData, HoldsTheDataSetsThatAreMadeAndNothingElse) {
  const data::ReferencePackage package = data::load_reference();
  std::vector<std::string> made, published;
  for (const reference::Recipe& recipe : reference::recipes()) made.emplace_back(recipe.name);
  std::set<fs::path> files{"datapackage.json", "datapackage.schema.json", "README.md", "CHANGELOG.md",
                           "example.py"};
  for (const data::Resource& resource : package.resources) {
    published.push_back(resource.name);
    files.insert(resource.path);
  }
  EXPECT_EQ(published, made);
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(package.folder)) {
    if (!entry.is_regular_file()) continue;
    bytes += entry.file_size();
    EXPECT_TRUE(files.contains(fs::relative(entry.path(), package.folder))) << entry.path();
  }
  EXPECT_LT(bytes, 5'000'000U);
}

TEST(PublishedData, SaysOfEveryNumberHowFarItCanBeTrusted) {
  // Values that are not exact have a radius that is not negative and, but for a zero, is below 1e-3 of the
  // largest value of the column or, where the range measures the error, of the range; enclosed ones have
  // thirty digits, but for an exact zero.
  const data::ReferencePackage package = data::load_reference();
  for (const data::Resource& resource : package.resources) {
    const data::ReferenceTable table = data::read_table(package, resource.name);
    for (const data::Column& column : table.columns) {
      if (!column.field.value_class || *column.field.value_class == data::ValueClass::exact) continue;
      double largest = 0.0;
      for (const double value : column.values) largest = std::max(largest, std::abs(value));
      double allowed = 1e-3 * largest;
      if (resource.comparison)
        for (const data::ComparedValue& value : resource.comparison->values)
          if (value.field == column.field.name && value.norm == data::Norm::range) {
            const auto [least, greatest] = std::ranges::minmax(column.values);
            allowed = 1e-3 * (greatest - least);
          }
      const std::vector<double> radius = table.radius_of(column.field.name);
      for (std::size_t row = 0; row < table.rows(); ++row) {
        ASSERT_GE(radius[row], 0.0) << resource.name << ", " << column.field.name;
        ASSERT_LT(radius[row], allowed) << resource.name << ", " << column.field.name;
        if (*column.field.value_class != data::ValueClass::enclosed) continue;
        if (radius[row] == 0.0 && column.text[row] == "0") continue;  // an exact zero has no digits
        const auto digits = std::ranges::count_if(column.text[row].substr(0, column.text[row].find('e')),
                                                  [](char c) { return c >= '0' && c <= '9'; });
        ASSERT_GE(digits, 30) << resource.name << ", " << column.field.name << ": " << column.text[row];
      }
    }
  }
}

TEST(PublishedData, ResolvesEveryReferenceOfItsRowsAndProblems) {
  const data::ReferencePackage package = data::load_reference();
  const auto cells_of = [&](const std::string& resource, const std::string& column) {
    const auto cells = data::read_table(package, resource).column(column).text;
    return std::set(cells.begin(), cells.end());
  };
  const auto beams = cells_of("beams", "beam");
  for (const data::Resource& resource : package.resources) {
    SCOPED_TRACE(resource.name);
    for (const data::ForeignKey& key : resource.foreign_keys) {
      const auto known = cells_of(key.resource, key.reference_column);
      for (const std::string& cell : cells_of(resource.name, key.column))
        EXPECT_TRUE(known.contains(cell)) << cell;
    }
    const bool has_beam = resource.name != "beams" && resource.field("beam") != nullptr;
    EXPECT_EQ(has_beam, !resource.foreign_keys.empty());
    if (resource.problem.empty()) continue;
    const auto problem = nlohmann::json::parse(resource.problem);
    if (const auto beam = problem.find("beam"); beam != problem.end() && beam->is_string()) {
      EXPECT_TRUE(beams.contains(beam->get<std::string>())) << *beam;
    }
    if (problem.contains("history"))
      for (const std::string& history : resource.field("history")->allowed) {
        EXPECT_NO_THROW((void)package.resource(history));
      }
  }
}

TEST(PublishedData, StatesTheProblemsAndTheWordsOfColumns) {
  const data::ReferencePackage package = data::load_reference();
  const std::set<fs::path> folders{"frequencies", "static", "shapes", "stick", "criterion", "stick-slip"};
  for (const data::Resource& resource : package.resources) {
    SCOPED_TRACE(resource.name);
    for (const char* word : {"phase", "change", "verdict"})
      if (const data::Field* field = resource.field(word)) {
        EXPECT_FALSE(field->allowed.empty()) << word;
      }
    if (!folders.contains(resource.path.parent_path())) continue;
    ASSERT_FALSE(resource.problem.empty());
    const auto problem = nlohmann::json::parse(resource.problem);
    if (problem.contains("history")) continue;
    std::vector<std::string> members{"beam", "tip", "damping"};
    if (problem.contains("excitation"))
      for (const char* member : {"friction", "initial_state", "modes"}) members.emplace_back(member);
    for (const std::string& member : members) EXPECT_TRUE(problem.contains(member)) << member;
  }
}

TEST(PublishedData, IsTheSamePackageByteForByteWhenMadeTwice) {
  EXPECT_EQ(reference::package_files(quick_sets()), reference::package_files(quick_sets()));
}

}  // namespace
}  // namespace stickslip::testing
