// SPDX-License-Identifier: MIT
/// The models behind the predictions, and the record of predictions.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <tuple>

#include "support/requirements.hpp"
#include "validation/models.hpp"
#include "validation/study.hpp"

namespace stickslip::testing {
namespace {

using validation::Prediction;

// The rows hold six digits of a value and two of an uncertainty.
bool agree(const Prediction& made, const Prediction& recorded) {
  const auto near = [](double a, double b, double relative) {
    return std::abs(a - b) <= relative * std::abs(b) + 1e-12;
  };
  return near(made.value, recorded.value, 2e-5) &&
         near(made.input_uncertainty, recorded.input_uncertainty, 0.06) &&
         near(made.numerical_uncertainty, recorded.numerical_uncertainty, 0.06);
}

STICKSLIP_VERIFIES(Predictions, "K2");
TEST(Predictions, LatestEntriesAreWhatTheCodeMakes) {
  std::map<std::tuple<std::string, std::string, std::string>, Prediction> latest;
  for (const Prediction& one : validation::recorded_predictions()) {  // throws where a row has changed
    Prediction& last = latest[{one.record, one.quantity, one.form}];
    EXPECT_LE(last.entry, one.entry);
    last = one;
  }
  const auto made = validation::predictions();
  EXPECT_EQ(made.size(), latest.size());
  for (const Prediction& one : made) {
    const auto found = latest.find({one.record, one.quantity, one.form});
    ASSERT_NE(found, latest.end()) << one.record << " " << one.quantity << " " << one.form
                                   << " is not recorded";
    EXPECT_TRUE(agree(one, found->second))
        << one.record << " " << one.quantity << " " << one.form << " is " << one.value << " +- "
        << one.input_uncertainty << ", but was recorded as " << found->second.value << " +- "
        << found->second.input_uncertainty << ": a new prediction needs a new entry with its reason";
  }
}

}  // namespace
}  // namespace stickslip::testing
