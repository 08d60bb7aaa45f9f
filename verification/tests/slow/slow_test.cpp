/// What takes minutes: finer grids and longer refinements of tests that run by default.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/studies/classification.hpp"
#include "stickslip/studies/stick_history.hpp"
#include "support/beams.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

TEST(Figure9RefinedOnceMore, ForceErrorFallsOnAsPredicted) {
  const auto study = studies::stick_history_study(paper_beam(), data::HarmonicExcitation({15.0, 0.5e-3}),
                                                  data::NumericalSettings(paper_choices(0.25)), 5);
  // The bound falls as h; over a quarter of a second fewer modes have lost their phase, and the error itself
  // falls somewhat faster, towards h^2.
  EXPECT_GT(study.force_order, study.predicted_force_order - 0.05);
  EXPECT_LT(study.force_order, 1.3);
  for (const auto& level : study.levels)
    EXPECT_TRUE(
        within(level.force_error, 0.0,
               discretisation(level.predicted_force_error, 1.35, "phase drift, 12/(omega T) left out")));
}

TEST(Figure12Finer, BothImplementationsClassifyAlikeOutsideTheGuardBand) {
  std::vector<double> frequencies, amplitudes;
  for (int i = 2; i <= 48; ++i) frequencies.push_back(2.5 * i);
  for (int i = 1; i <= 40; ++i) amplitudes.push_back(0.025e-3 * i);
  const auto study = studies::classification_study(
      paper_beam(), paper_friction(), data::NumericalSettings(paper_choices(10.0)), frequencies, amplitudes);
  EXPECT_EQ(study.disagreeing_outside, 0);
  EXPECT_LT(study.in_guard_band, 30);
}

TEST(StickSlipBeamLong, StaysBoundedOnAnyMeshAndStep) {
  for (const double radius : {0.0, 0.5, 0.9, 1.0})
    for (const int elements : {5, 20, 80})
      for (const double time_step : {1e-3, 1e-4, 1e-5})
        for (const double hz : {25.0, 70.0}) {
          data::NumericalChoices c = paper_choices(0.5);
          c.elements = elements;
          c.spectral_radius = radius;
          c.time_step = time_step;
          solver::BeamSimulation s(paper_beam(), paper_friction(), data::HarmonicExcitation({hz, 1e-3}),
                                   data::NumericalSettings(c));
          for (long n = solver::step_count(0.5, time_step); n > 0; --n) {
            s.step();
            ASSERT_LT(std::abs(s.tip_displacement()), 7e-3)
                << radius << " " << elements << " " << time_step << " " << hz << " " << s.time();
          }
        }
}

}  // namespace
}  // namespace stickslip::testing
