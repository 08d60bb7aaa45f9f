// SPDX-License-Identifier: MIT
/// The damped vibration from rest by time stepping against the closed form.

#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/held_beam.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "support/testing.hpp"
#include "support/vibration.hpp"

namespace stickslip::testing {
namespace {

using analytic::TipSupport;

// f(t) of the bonded tip over 0.2 s. A quarter of the step with half the element leaves 1/16 of the error; twice the
// modes leave an eighth.
STICKSLIP_VERIFIES(DampedSteppedResponse, "X8");
TEST(DampedSteppedResponse, StartsAsTheClosedForm) {
  const auto stepped = [](const Vibration& v, int level) {
    data::NumericalChoices choices = paper_choices(0.2);
    choices.elements = 20 << level;
    choices.time_step = 1e-4 / (level == 0 ? 1.0 : 4.0);
    solver::BeamSimulation beam(
        with(paper_problem(v.hz, v.amplitude), v.beam(), data::NumericalSettings(choices), v.damping),
        {.is_bonded = true});
    std::vector<double> forces;
    for (int n = 0; n < 2000; ++n) {
      for (int i = 0; i < (level == 0 ? 1 : 4); ++i) beam.integrator().step();
      forces.push_back(beam.friction_force());
    }
    return forces;
  };
  const auto closed_form = [](const Vibration& v, int modes) {
    const analytic::DampedForce force(
        analytic::damped_reaction(analytic::HeldBeam(v.beam(), v.damping, modes).structure(),
                                  analytic::SteadyPart::exact),
        v.omega(), 0.2);
    std::vector<double> forces;
    for (int n = 1; n <= 2000; ++n) forces.push_back(Vibration::amplitude * force.value(1e-4 * n));
    return forces;
  };
  const auto distance = [](const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = largest_or_nan({largest, std::abs(a[i] - b[i])});
    return largest;
  };
  for (const Vibration& v : {Vibration{15.0, kelvin_voigt(6.4e-5), TipSupport::held},
                             Vibration{25.0, kelvin_voigt(6.4e-5), TipSupport::held},
                             Vibration{70.0, kelvin_voigt(6.4e-5), TipSupport::held},
                             Vibration{25.0, data::Damping({.ratio = 0.02}), TipSupport::held},
                             Vibration{70.0, data::Damping({.ratio = 0.02}), TipSupport::held}}) {
    const auto coarse = stepped(v, 0), fine = stepped(v, 1), exact = closed_form(v, 40);
    const double of_mesh_and_step = distance(coarse, fine) / 15.0;
    const double of_modes = distance(closed_form(v, 20), exact) / 7.0;
    EXPECT_TRUE(
        within(distance(fine, exact), 0.0,
               discretisation(of_mesh_and_step + of_modes, 1.2, "h^2 and l^4, by Richardson, and N^-3")))
        << v.name();
  }
}

}  // namespace
}  // namespace stickslip::testing
