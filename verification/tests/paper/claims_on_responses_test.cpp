/// Claims of Sect. 3 on Figs. 3 to 5: where the tip sticks, where it slips, and how.

#include <gtest/gtest.h>

#include "support/claim.hpp"
#include "support/paper_case.hpp"

namespace stickslip::testing {
namespace {

TEST(ClaimOnFigure5, StickSlipAdditionallyOccursAt35Hz) {
  bool unchanged_elsewhere = true;
  for (const double hz : {15.0, 25.0, 70.0})
    unchanged_elsewhere &=
        (both_stick(hz, 0.5e-3) && both_stick(hz, 1e-3)) || (both_slip(hz, 0.5e-3) && both_slip(hz, 1e-3));
  judge({.as_printed = unchanged_elsewhere && both_stick(35.0, 0.5e-3) && both_slip(35.0, 1e-3)},
        "35 Hz sticks at 0.5 mm and slips at 1 mm by both implementations; no other verdict changes");
}

}  // namespace
}  // namespace stickslip::testing
