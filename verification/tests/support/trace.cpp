// SPDX-License-Identifier: MIT
#include "support/trace.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

#include "support/requirements.hpp"

namespace stickslip::testing {

double ComparedNumber::margin() const {
  if (std::isnan(error)) return INFINITY;
  return error == 0.0 ? 0.0 : error / tolerance;
}

void Trace::note(const ComparedNumber& comparison) { by_margin_.emplace(comparison.margin(), comparison); }

std::map<std::string, std::string> Trace::properties(bool test_passed) const {
  std::map<std::string, std::string> properties;
  int comparisons = 0;
  std::map<std::string, int> of_class;
  for (const auto& [margin, comparison] : by_margin_) {  // ascending: the last one of a kind stays
    if (test_passed && margin > 1.0) break;
    ++comparisons;
    properties["computed"] = fmt::format("{}", comparison.computed);
    properties["expected"] = fmt::format("{}", comparison.expected);
    properties["error"] = fmt::format("{}", comparison.error);
    properties["tolerance"] = fmt::format("{}", comparison.tolerance);
    properties["margin"] = fmt::format("{}", margin);
    properties["class"] = comparison.tolerance_class;
    properties["derivation"] = comparison.derivation;
    properties["tolerances." + comparison.tolerance_class] =
        fmt::format("{}; {}; {}; {}; {}", ++of_class[comparison.tolerance_class], comparison.error,
                    comparison.tolerance, margin, comparison.derivation);
  }
  properties["comparisons"] = std::to_string(comparisons);
  return properties;
}

namespace {

Trace& running_trace() {
  static Trace trace;
  return trace;
}

bool has_requirement(const ::testing::TestResult& test) {
  for (int i = 0; i < test.test_property_count(); ++i)
    if (std::string_view(test.GetTestProperty(i).key()) == "requirement") return true;
  return false;
}

class Recorder : public ::testing::EmptyTestEventListener {
  void OnTestStart(const ::testing::TestInfo& /*test*/) override { running_trace() = {}; }

  void OnTestEnd(const ::testing::TestInfo& test) override {
    if (!has_requirement(*test.result())) record_requirement(requirement_of(test.test_suite_name()));
    for (const auto& [key, value] : running_trace().properties(test.result()->Passed()))
      ::testing::Test::RecordProperty(key, value);
  }
};

[[maybe_unused]] const bool is_recording = [] {
  ::testing::UnitTest::GetInstance()->listeners().Append(new Recorder);  // owned by GoogleTest
  return true;
}();

}  // namespace

void note(const ComparedNumber& comparison) { running_trace().note(comparison); }

}  // namespace stickslip::testing
