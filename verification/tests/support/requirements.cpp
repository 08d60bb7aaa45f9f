// SPDX-License-Identifier: MIT
#include "support/requirements.hpp"

#include <gtest/gtest.h>

#include <toml++/toml.h>
#include <algorithm>
#include <functional>
#include <map>

namespace stickslip::testing {

namespace {

std::map<std::string, std::string, std::less<>>& ids_of_suites() {
  static std::map<std::string, std::string, std::less<>> ids;
  return ids;
}

std::vector<Requirement> read_requirements() {
  const toml::table file = toml::parse_file(STICKSLIP_SOURCE_DIRECTORY "/verification/requirements.toml");
  std::vector<Requirement> rows;
  for (const toml::node& row : file.at("requirements").ref<toml::array>()) {
    const auto& cells = row.ref<toml::array>();
    const auto text = [&](std::size_t i) { return cells.at(i).ref<std::string>(); };
    rows.push_back({text(0), text(1), text(2)});
  }
  return rows;
}

}  // namespace

const std::vector<Requirement>& requirements() {
  static const std::vector<Requirement> rows = read_requirements();
  return rows;
}

bool add_suite(const std::string& suite, const std::string& id) {
  const auto [stated, is_first] = ids_of_suites().emplace(suite, id);
  if (stated->second != id) stated->second += " and " + id;  // is no requirement, so that the tests fail
  return is_first;
}

std::string requirement_of(std::string_view suite) {
  suite.remove_prefix(suite.find('/') == std::string_view::npos ? 0 : suite.find('/') + 1);
  const auto stated = ids_of_suites().find(suite);
  return stated == ids_of_suites().end() ? "" : stated->second;
}

void record_requirement(const std::string& id) {
  const auto& rows = requirements();
  const auto row = std::ranges::find(rows, id, &Requirement::id);
  if (row == rows.end()) {
    ADD_FAILURE() << (id.empty() ? "the suite states no requirement: STICKSLIP_VERIFIES is missing"
                                 : "verification/requirements.toml has no requirement " + id);
    return;
  }
  ::testing::Test::RecordProperty("requirement", row->id);
  ::testing::Test::RecordProperty("requirement_position", std::to_string(row - rows.begin()));
  ::testing::Test::RecordProperty("requirement_text", row->text);
  ::testing::Test::RecordProperty("source", row->source);
}

}  // namespace stickslip::testing
