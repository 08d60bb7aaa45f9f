// SPDX-License-Identifier: MIT
/// Numbers on the command line: the digits that hold, and no others.

#include "answer.hpp"
#include "support/testing.hpp"

namespace stickslip::cli {
namespace {

STICKSLIP_VERIFIES(NumberText, "U1");
TEST(NumberText, HasAsManyDigitsAsTheErrorLeaves) {
  EXPECT_EQ(digits_that_hold(1.1e-3), 2);
  EXPECT_EQ(digits_that_hold(0.9e-3), 3);
  EXPECT_EQ(digits_that_hold(0.5), 1);
  EXPECT_EQ(digits_that_hold(20.0), 1);
  EXPECT_EQ(digits_that_hold(0.0), 15);  // an epsilon is 2.2e-16
}

TEST(NumberText, KeepsTrailingZerosAndAddsNoPoint) {
  EXPECT_EQ(significant(25.0, 4), "25.00");
  EXPECT_EQ(significant(25.0, 3), "25.0");
  EXPECT_EQ(significant(25.0, 2), "25");
  EXPECT_EQ(significant(90.0, 2), "90");
  EXPECT_EQ(significant(25.0, 1), "2e+01");  // to even
  EXPECT_EQ(significant(0.00065856789, 5), "0.00065857");
  EXPECT_EQ(significant(1.5e-7, 3), "1.50e-07");
}

TEST(NumberText, OfBoundsIsWhatBothRoundTo) {
  EXPECT_EQ(common_digits({2.0, 2.0}), "2");
  EXPECT_EQ(common_digits({1.2344, 1.2346}), "1.23");  // 1.234 and 1.235
  EXPECT_EQ(common_digits({1.23441, 1.23449}), "1.234");
  EXPECT_EQ(common_digits({1.1, 1.3}), "1");
  EXPECT_EQ(common_digits({1.4, 1.6}), "1.4 ... 1.6");
}

}  // namespace
}  // namespace stickslip::cli
