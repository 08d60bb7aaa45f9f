// SPDX-License-Identifier: MIT
/// Both implementations refuse the same cases.

#include <gtest/gtest.h>

#include <stdexcept>

#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "support/beams.hpp"
#include "support/requirements.hpp"

namespace stickslip::testing {
namespace {

constexpr int ten_elements = 10;

data::HarmonicExcitation shaking() {
  return data::HarmonicExcitation({.frequency_hz = 25.0, .amplitude = 1e-3});
}

template <class Exception, class Action>
bool refuses(Action&& action) {
  try {
    action();
  } catch (const Exception&) {
    return true;
  }
  return false;
}

STICKSLIP_VERIFIES(Refusals, "X18");
// Where the tip is not pressed against the wall, and from the buckling load on. Ten elements buckle later than the beam
// by (y l/L)^4/720 of the load, y = 4.49: 6e-5.
TEST(Refusals, OfARunAreForForcesWithoutAStickState) {
  auto choices = paper_choices(1e-3);
  choices.elements = ten_elements;
  const data::NumericalSettings numerics(choices);
  const double buckling = analytic::stick_buckling_load(paper_beam());
  for (const double axial_force : {-1e4, -1e-3, 0.0, 1e-3, 0.999 * buckling, 1.001 * buckling, 1.5 * buckling,
                                   3.99 * buckling, 8.0 * buckling}) {
    const data::Beam beam = paper_beam_with_axial_force(axial_force);
    const bool refused = axial_force <= 0.0 || axial_force > buckling;
    EXPECT_EQ(refuses<data::InputError>(
                  [&] { (void)solver::first_slip(beam, paper_friction(), shaking(), numerics); }),
              refused)
        << axial_force;
    EXPECT_EQ(refuses<data::InputError>(
                  [&] { (void)analytic::evaluate_criterion(beam, paper_friction(), shaking(), 1e-3); }),
              refused)
        << axial_force;
  }
}

TEST(Refusals, OfStickModesAndStaticShapesBeginAtTheBucklingLoad) {
  const double buckling = analytic::stick_buckling_load(paper_beam());
  for (const double share : {-3.0, 0.0, 0.999, 1.001, 2.5, 8.0}) {
    const data::Beam beam = paper_beam_with_axial_force(share * buckling);
    const solver::BeamModel model(beam, ten_elements);
    EXPECT_EQ(refuses<data::InputError>([&] { (void)solver::stick_modes(model, 1); }), share > 1.0) << share;
    EXPECT_EQ(refuses<data::InputError>([&] { (void)analytic::stick_modes(beam, 1); }), share > 1.0) << share;
    EXPECT_EQ(refuses<data::InputError>([&] { (void)model.unit_tip_deflection(); }), share > 1.0) << share;
    EXPECT_EQ(refuses<data::InputError>([&] { (void)analytic::QuasiStaticShape{beam}; }), share > 1.0)
        << share;
  }
}

TEST(Refusals, OfModesAreForCountsWithoutAny) {
  const solver::BeamModel model(paper_beam(), ten_elements);
  for (const int count : {-1, 0, 1}) {
    EXPECT_EQ(refuses<std::invalid_argument>([&] { (void)solver::stick_modes(model, count); }), count < 1);
    EXPECT_EQ(refuses<std::invalid_argument>([&] { (void)analytic::stick_modes(paper_beam(), count); }),
              count < 1);
    EXPECT_EQ(refuses<std::invalid_argument>([&] { (void)solver::slip_modes(model, count); }), count < 1);
    EXPECT_EQ(refuses<std::invalid_argument>([&] { (void)analytic::slip_modes(paper_beam(), count); }),
              count < 1);
  }
}

}  // namespace
}  // namespace stickslip::testing
