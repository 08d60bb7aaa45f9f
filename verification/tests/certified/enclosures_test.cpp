// SPDX-License-Identifier: MIT
/// Enclosures of the closed form hold what finite elements find, to their predicted error.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "support/beams.hpp"
#include "support/mesh.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"
#include "support/vibration.hpp"

namespace stickslip::testing {
namespace {

using analytic::Bounds;

data::HarmonicExcitation shaken_at(double hz) {
  return data::HarmonicExcitation({.frequency_hz = hz, .amplitude = 1e-3});
}

double finite_element_maximum(double hz, double duration) {
  return solver::max_abs_friction_force(paper_beam(), shaken_at(hz),
                                        data::NumericalSettings(paper_choices(duration)));
}

// What 20 elements and 0.1 ms miss in so short a run: half a per cent, most of it modes that the closed form
// leaves out.
constexpr double share_missed = 0.005;

solver::BeamSimulation bonded_beam(double hz, double duration) {
  return solver::BeamSimulation(paper_beam(), paper_friction(), shaken_at(hz),
                                data::NumericalSettings(paper_choices(duration)),
                                {.contact = solver::TipContact::bonded});
}

void expect_finite_elements_to_have(const std::function<double(double)>& force, double hz, double margin) {
  solver::BeamSimulation beam = bonded_beam(hz, 0.3);
  double difference = 0.0, peak = 0.0;
  for (int n = 0; n < 3000; ++n) {
    beam.step();
    const double expected = force(beam.time());
    difference = largest_or_nan({difference, std::abs(beam.friction_force() - expected)});
    peak = std::max(peak, std::abs(expected));
  }
  EXPECT_TRUE(
      within(difference, 0.0, discretisation(share_missed * peak, margin, "20 elements in a short run")));
}

STICKSLIP_VERIFIES(Enclosures, "A5");
TEST(Enclosures, OfCoarseSamplesHoldTheMaximumOfFiniteElements) {
  for (const double hz : {10.0, 200.0}) {
    const double duration = 3.0 / hz;
    const double maximum = finite_element_maximum(hz, duration);
    const analytic::StickResponse response(paper_beam(), shaken_at(hz), 20, analytic::SteadyPart::exact);
    for (const double share : {0.13, 0.29, 0.41}) {
      const Bounds bounds = response.sampled_max_abs_friction_force(duration, share / hz);
      EXPECT_LE(bounds.lower, maximum * (1.0 + share_missed)) << hz << " Hz, " << share;
      EXPECT_GE(bounds.upper, maximum * (1.0 - share_missed)) << hz << " Hz, " << share;
    }
  }
}

TEST(Enclosures, OfARisingForceEndWithThatOfFiniteElements) {
  const double maximum = finite_element_maximum(5.0, 3e-3);
  const analytic::StickResponse response(paper_beam(), shaken_at(5.0), 20, analytic::SteadyPart::exact);
  EXPECT_TRUE(within(response.sampled_max_abs_friction_force(3e-3, 2e-3).lower, maximum,
                     discretisation(share_missed * maximum, 2.0, "20 elements in a short run")));
}

TEST(Enclosures, OfTheCriticalAmplitudeHoldThatOfFiniteElements) {
  const double limit = paper_friction().static_coefficient() * paper_beam().axial_force();
  for (const double hz : {15.0, 35.0}) {
    const double critical = 1e-3 * limit / finite_element_maximum(hz, 0.5);
    for (const double width : {0.3, 0.05}) {
      const Bounds bounds = analytic::evaluate_criterion(paper_beam(), paper_friction(), shaken_at(hz), 0.5,
                                                         20, analytic::SteadyPart::exact, width)
                                .critical_amplitude;
      EXPECT_LT(bounds.lower, critical * (1.0 + share_missed)) << hz << " Hz, " << width;
      EXPECT_GT(bounds.upper, critical * (1.0 - share_missed)) << hz << " Hz, " << width;
    }
  }
}

TEST(Enclosures, NextToResonanceHoldTheForceOfFiniteElements) {
  // A relative distance of 4e-15 leaves one digit to a difference of sines that is divided by it.
  const double natural = analytic::stick_modes(paper_beam(), 1).front().frequency_hz() * (1.0 + 4e-15);
  const analytic::StickResponse response(paper_beam(), shaken_at(natural), 20, analytic::SteadyPart::exact);
  expect_finite_elements_to_have([&](double t) { return response.friction_force(t); }, natural, 1.0);
}

TEST(Enclosures, OfAGrowingForceHoldItsMaximumWheneverItIsAskedFor) {
  // In resonance f grows with every half cycle, and its maximum changes sign: one run up to 1 s and a bit,
  // asked at 20 times in a cycle. The bounds are left wide, so that they rest on the bend of f alone.
  const double natural = analytic::stick_modes(paper_beam(), 1).front().frequency_hz();
  solver::BeamSimulation beam = bonded_beam(natural, 1.0);
  const analytic::StickResponse response(paper_beam(), shaken_at(natural), 2);
  double maximum = 0.0;
  for (int k = 0; k < 20; ++k) {
    while (beam.time() < 1.0 + k / (20.0 * natural)) {
      beam.step();
      maximum = std::max(maximum, std::abs(beam.friction_force()));
    }
    for (const double width : {0.9, 0.1}) {
      const Bounds bounds = response.max_abs_friction_force(beam.time(), width);
      EXPECT_LE(bounds.lower, maximum * (1.0 + share_missed)) << k << ", " << width;
      EXPECT_GE(bounds.upper, maximum * (1.0 - share_missed)) << k << ", " << width;
    }
  }
}

TEST(Enclosures, ListTheFreeVibrationsOfFiniteElements) {
  const analytic::StickResponse response(paper_beam(), shaken_at(15.0), 20, analytic::SteadyPart::exact);
  const auto free_vibrations = response.transient_force();
  const auto sum = [&](double t) {
    double force = response.steady_force_amplitude() * std::sin(2.0 * std::numbers::pi * 15.0 * t);
    for (const auto& [amplitude, angular_frequency] : free_vibrations)
      force += amplitude * std::sin(angular_frequency * t);
    return force;
  };
  expect_finite_elements_to_have(sum, 15.0, 2.0);
}

STICKSLIP_VERIFIES(GeometricEnergy, "F8");
// -P/2 int S'^2 dx by the closed form, Simpson's rule of 400 intervals; the cubic elements' own shape, 30 of
// them, is off by (y l/L)^4/720 of it, y^2 = P L^2/EI.
TEST(GeometricEnergy, OfTheStaticShapeIsThatOfTheClosedForm) {
  for (const double axial_force : {-4e4, -300.0, 500.0, 3e4}) {
    const data::Beam beam = paper_beam_with_axial_force(axial_force);
    const analytic::QuasiStaticShape shape(beam);
    const double h = beam.length() / 400.0;
    double integral = 0.0;
    for (int i = 0; i <= 400; ++i)
      integral += simpson_weight(i, 400) * std::pow(shape.slope(h * i), 2) * h / 3.0;
    const double expected = -0.5 * axial_force * integral;
    const solver::BeamModel model(beam, 30);
    EXPECT_TRUE(within(geometric_energy(model, model.unit_tip_deflection()), expected,
                       discretisation(1e-6 * expected, 1.0, "(y l/L)^4/720 and Simpson's rule")))
        << axial_force;
  }
}

STICKSLIP_VERIFIES(NormalForce, "F7");
TEST(NormalForce, IsTheCompressionAndNothingInTension) {
  const auto of_finite_elements = [](const data::Beam& beam) {
    return solver::beam_contact_system(solver::BeamModel(beam, 4), paper_friction(),
                                       solver::harmonic_motion(shaken_at(10.0)))
        .normal_force;
  };
  for (const double axial_force : {250.0, 500.0}) {
    const data::Beam beam = paper_beam_with_axial_force(axial_force);
    EXPECT_EQ(
        of_finite_elements(beam),
        analytic::BeamContactModel(beam, paper_friction(), shaken_at(10.0), {}, 2).model().normal_force);
  }
  const data::Beam tensioned = paper_beam_with_axial_force(-400.0);
  EXPECT_EQ(of_finite_elements(tensioned), 0.0);
  EXPECT_THROW(analytic::BeamContactModel(tensioned, paper_friction(), shaken_at(10.0), {}, 2),
               data::InputError);
}

}  // namespace
}  // namespace stickslip::testing
