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

#include "render/text_file.hpp"
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

STICKSLIP_VERIFIES(PublishedData, "P6");
TEST(PublishedData, IsWhatTheCodeMakes) {
  const data::ReferencePackage package = data::load_reference();
  for (const reference::DataSet& set : quick_sets())
    expect_same_data(data::read_table(package, set.resource.name), set);
}

TEST(PublishedData, IsDescribedAsTheCodeDescribesIt) {
  // But for the size, and for the version of the library for ball arithmetic.
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
  const auto sets = quick_sets();
  const auto published = resources(report::read_text(data::reference_directory() / "datapackage.json"));
  const auto made = resources(reference::package_files(sets).at("datapackage.json"));
  EXPECT_EQ(made.size(), sets.size());
  for (const auto& [name, resource] : made) EXPECT_EQ(published.at(name), resource);
}

TEST(PublishedData, HoldsTheDataSetsThatAreMadeAndNothingElse) {
  const data::ReferencePackage package = data::load_reference();
  std::vector<std::string> made, published;
  for (const reference::Recipe& recipe : reference::recipes()) made.emplace_back(recipe.name);
  std::set<fs::path> files{"datapackage.json", "README.md"};
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

TEST(PublishedData, IsTheSamePackageByteForByteWhenMadeTwice) {
  EXPECT_EQ(reference::package_files(quick_sets()), reference::package_files(quick_sets()));
}

}  // namespace
}  // namespace stickslip::testing
