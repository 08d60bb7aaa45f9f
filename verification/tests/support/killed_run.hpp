// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "support/signalled_run.hpp"

namespace stickslip::testing {

/// Commands that are killed at any moment: what has a name of its own is whole each time, and the same command
/// completes.
class KilledRun : public SignalledRun {
 protected:
  using Contents = std::map<std::string, std::string>;  // of files, by name

  /// Kills a command `kills` times while it works, each at a random moment of the time that it takes
  /// undisturbed, and lets it go on from what is there; once its outputs are complete it begins anew. What is
  /// under the name of an output has the bytes of the undisturbed run, and nothing else is left in the end.
  void kill(int kills, const std::string& command, std::vector<std::string> outputs) {
    const double whole = seconds_of(command);
    Contents undisturbed;
    for (const std::string& name : outputs) {
      undisturbed[name] = contents(out(name));
      ASSERT_NE(undisturbed[name], "") << name;
    }
    std::ranges::sort(outputs);
    EXPECT_EQ(all_files(out()), outputs);
    ASSERT_NO_FATAL_FAILURE(kill_at_random(kills, command, undisturbed, whole));
    const Outcome again = run(command);
    EXPECT_EQ(again.status, 0) << again.errors;
    for (const auto& [name, text] : undisturbed) EXPECT_TRUE(contents(out(name)) == text) << name;
    EXPECT_EQ(all_files(out()), outputs);
  }

  /// The runs that are killed at moments up to `latest` seconds, and those that end before.
  void kill_at_random(int kills, const std::string& command, const Contents& undisturbed, double latest) {
    const auto is_complete = [&] {
      return std::ranges::all_of(undisturbed,
                                 [&](const auto& file) { return std::filesystem::exists(out(file.first)); });
    };
    std::uniform_real_distribution<double> moments(0.0, latest);
    for (int killed = 0, runs = 0; killed < kills; ++runs) {
      ASSERT_LT(runs, 6 * kills);
      if (is_complete()) clear();
      const Ending ending = signalled(command, SIGKILL, std::chrono::duration<double>(moments(generator_)));
      if (ending.status == 128 + SIGKILL) {
        ++killed;
      } else {
        ASSERT_EQ(ending.status, 0) << ending.errors;
      }
      ASSERT_NO_FATAL_FAILURE(expect_only_whole(undisturbed));
    }
  }

  /// The files that are there have the bytes of the undisturbed run, or the name of an unfinished one.
  void expect_only_whole(const Contents& undisturbed) const {
    for (const std::string& name : all_files(out()))
      EXPECT_TRUE(undisturbed.contains(name) || name.starts_with('.') || name.ends_with(".partial")) << name;
    for (const auto& [name, text] : undisturbed)
      if (std::filesystem::exists(out(name))) {
        ASSERT_TRUE(contents(out(name)) == text) << name;
      }
  }

  /// What a whole run takes: the shortest of three, since other work may delay one.
  [[nodiscard]] double seconds_of(const std::string& command) const {
    double shortest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      clear();
      const auto begin = std::chrono::steady_clock::now();
      const Outcome outcome = run(command);
      const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
      EXPECT_EQ(outcome.status, 0) << outcome.errors;
      shortest = std::min(shortest, took.count());
    }
    return shortest;
  }

  void clear() const {
    std::filesystem::remove_all(out());
    std::filesystem::create_directory(out());
  }

 private:
  std::mt19937 generator_{1};
};

}  // namespace stickslip::testing
