#include "support/trace.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "support/requirements.hpp"

namespace stickslip::testing {

namespace {

double margin(const Comparison& comparison) {
  if (std::isnan(comparison.error)) return INFINITY;
  return comparison.error == 0.0 ? 0.0 : comparison.error / comparison.tolerance;
}

// The comparisons of the running test.
struct Notes {
  int comparisons{};
  Comparison worst;
  std::map<std::string, Comparison> named;

  void add(const Comparison& comparison) {
    if (comparisons++ == 0 || margin(comparison) > margin(worst)) worst = comparison;
    if (comparison.name.empty()) return;
    const auto [entry, is_new] = named.try_emplace(comparison.name, comparison);
    if (!is_new && margin(comparison) > margin(entry->second)) entry->second = comparison;
  }
};

Notes& notes() {
  static Notes instance;
  return instance;
}

class Recorder : public ::testing::EmptyTestEventListener {
  void OnTestStart(const ::testing::TestInfo&) override { notes() = {}; }

  void OnTestEnd(const ::testing::TestInfo& test) override {
    const auto record = [](const std::string& key, const std::string& value) {
      ::testing::Test::RecordProperty(key, value);
    };
    if (const Requirement* requirement = requirement_of(test.test_suite_name())) {
      record("requirement", std::string(requirement->id));
      record("requirement_position", std::to_string(requirement - requirements().data()));
      record("requirement_text", std::string(requirement->text));
      record("source", std::string(requirement->source));
    }
    const Notes& all = notes();
    record("comparisons", std::to_string(all.comparisons));
    if (all.comparisons == 0) return;
    record("computed", fmt::format("{}", all.worst.computed));
    record("expected", fmt::format("{}", all.worst.expected));
    record("error", fmt::format("{}", all.worst.error));
    record("tolerance", fmt::format("{}", all.worst.tolerance));
    record("margin", fmt::format("{}", margin(all.worst)));
    record("class", all.worst.tolerance_class);
    record("derivation", all.worst.derivation);
    for (const auto& [name, comparison] : all.named)
      record("compared." + name,
             fmt::format("{}; {}; {}; {}; {}; {}; {}", comparison.computed, comparison.expected,
                         comparison.error, comparison.tolerance, margin(comparison),
                         comparison.tolerance_class, comparison.derivation));
  }
};

const bool is_recording = [] {
  ::testing::UnitTest::GetInstance()->listeners().Append(new Recorder);  // owned by GoogleTest
  return true;
}();

}  // namespace

void note(const Comparison& comparison) { notes().add(comparison); }

}  // namespace stickslip::testing
