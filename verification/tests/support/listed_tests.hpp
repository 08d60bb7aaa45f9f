#pragma once

/// The tests that the programs of the suite hold, as they list them themselves. Needs the definition
/// STICKSLIP_TEST_PROGRAMS.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <set>
#include <string>

namespace stickslip::testing {

/// Full names, "Instantiation/Suite.Name/parameter".
inline std::set<std::string> listed_tests() {
  std::set<std::string> tests;
  for (const std::string program : {STICKSLIP_TEST_PROGRAMS}) {
    const std::string command = "'" + program + "' --gtest_list_tests";
    const auto close = [](std::FILE* stream) { ::pclose(stream); };
    const std::unique_ptr<std::FILE, decltype(close)> stream(::popen(command.c_str(), "r"), close);
    std::array<char, 1000> line{};
    std::string suite;
    const std::size_t before = tests.size();
    while (stream && std::fgets(line.data(), line.size(), stream.get()) != nullptr) {
      std::string text(line.data());
      text.erase(text.find_last_not_of(" \n") + 1);
      text.erase(std::min(text.find("  # "), text.size()));  // the value of a parameter
      if (text.starts_with("  ")) {
        tests.insert(suite + text.substr(2));
      } else if (text.ends_with('.')) {
        suite = text;
      }
    }
    EXPECT_GT(tests.size(), before) << program << " lists no tests";
  }
  return tests;
}

}  // namespace stickslip::testing
