// SPDX-License-Identifier: MIT
/// The direction of the axial force, chi, in both implementations: 0 follows the tip, 1 keeps its direction.

#include <Eigen/Dense>

#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/held_beam.hpp"
#include "stickslip/analytic/modal_reaction.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"
#include "stickslip/analytic/tip_mobility.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/analyses/criterion_map.hpp"
#include "studies/analyses/design_guide.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/verification/model_form.hpp"
#include "support/testing.hpp"
#include "support/waves.hpp"

namespace stickslip::testing {
namespace {

STICKSLIP_VERIFIES(AxialDirection, "X23");
// With a free tip the beam moves as with a held one and under the force that held it, and the heat is what the base and the
// follower part of P put in.
TEST(AxialDirection, FreeTipIsHeldLessReaction) {
  on_random_beams(30, any_force, [](const data::Beam& any, RandomNumbers& numbers) {
    const data::Beam beam = directed(any, random_direction(numbers), any.axial_force());
    const double unit = frequency_unit(beam), follower = (1.0 - beam.axial_direction()) * beam.axial_force();
    const data::Damping damping = kelvin_voigt(numbers.log_uniform(1e-4, 0.1) / unit);
    const auto excitation = shaking(unit * numbers.log_uniform(0.3, 100.0), 1e-3);
    const std::complex<double> s(0.0, 2.0 * std::numbers::pi * excitation.frequency_hz());
    const analytic::DampedSteadyState held(beam, excitation, damping, analytic::TipSupport::held),
        free(beam, excitation, damping, analytic::TipSupport::free);
    const auto tip = free.displacement(beam.length()), slope = free.derivative(1, beam.length());
    const auto from_base = 1e-3 * free.rigidity() * free.derivative(3, 0.0),
               from_load = follower * slope * std::conj(tip);
    EXPECT_TRUE(within(tip, held.friction_force() * analytic::TipMobility(beam, damping)(s) / s,
                       round_off(200, 45 * nearness_of_buckling(beam), std::abs(tip))));
    EXPECT_TRUE(within(std::numbers::pi * (from_base - from_load).imag(), free.dissipated_energy(),
                       round_off(200, 45, std::abs(from_base) + std::abs(from_load))));
  });
}

// S'''(L) + chi p S'(L) = S'''(L) [1 - chi (1 - cos y)], which vanishes at chi = 1, y = pi/2.
TEST(AxialDirection, IsInReactionAtRestAndTable) {
  for (const double chi : {0.3, 1.0}) {
    const analytic::ModalReactionTable table(0.0, 10.0, 6, chi);
    for (const double factor : {0.0, 0.12, 2.4674, 5.0, 9.9}) {
      const data::Beam beam = loaded_paper_beam(factor, chi);
      const auto direct = analytic::modal_reaction(beam, 6), tabulated = table.at(beam),
                 follower = analytic::modal_reaction(paper_beam_with_load_factor(factor), 6);
      const double share = 1.0 - chi * (1.0 - std::cos(std::sqrt(factor))), scale = follower.quasi_static;
      EXPECT_TRUE(within(direct.quasi_static, share * scale, round_off(20, 5, scale)));
      EXPECT_TRUE(within(tabulated.quasi_static, direct.quasi_static, round_off(20, 20, scale)));
      for (std::size_t n = 0; n < direct.modes.size(); ++n)
        EXPECT_TRUE(within(tabulated.modes[n].coefficient, direct.modes[n].coefficient,
                           round_off(20, 100, follower.modes[n].coefficient)))
            << n;
      EXPECT_FALSE(table.holds(loaded_paper_beam(factor, 0.5 * (1.0 + chi) - 0.1)));
    }
  }
}

STICKSLIP_VERIFIES(ModelForm, "X23");
TEST(ModelForm, OfADeadLoadBuckles) {
  const data::Case flat = data::load_case("paper-figure14");
  const auto form =
      studies::model_form(data::load_case("paper"), data::load_case("paper-half-stiffness"), flat, 5);
  ASSERT_EQ(form.planes.size(), 3u);
  const double euler = std::pow(std::numbers::pi / flat.beam().length(), 2) / 4.0 * rigidity(flat.beam());
  EXPECT_LT(euler, flat.beam().axial_force());
  // Over 5 lengths and 100 forces: 20.19 EI/L^2 ends the stick state, pi^2 EI/(4 L^2) the stability of the slip state.
  std::size_t cells = 0, buckled = 0;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 100; ++j) {
      const double factor =
          5.0 * std::pow(6600.0, j / 99.0) * std::pow(0.4 + 0.4 * i, 2) / rigidity(flat.beam());
      cells += factor < 20.1907 ? 1u : 0u;
      buckled += factor >= std::pow(std::numbers::pi, 2) / 4.0 && factor < 20.1907 ? 1u : 0u;
    }
  EXPECT_EQ(form.planes[2].cells, cells);
  EXPECT_EQ(form.planes[2].buckled, buckled);
  EXPECT_DOUBLE_EQ(form.planes[2].buckled_share() * static_cast<double>(cells), static_cast<double>(buckled));
  EXPECT_EQ(form.planes[0].buckled + form.planes[1].buckled, 0u);  // their 500 N are far below 10 kN and 5 kN
  for (const auto& plane : form.planes) {
    EXPECT_LE(plane.to_stick + plane.to_slip, plane.cells);
    EXPECT_LT(plane.highest_ratio, 1.0) << plane.figures;
    EXPECT_EQ(plane.to_slip, 0u) << plane.figures;
  }
  ASSERT_EQ(form.shear.size(), form.planes.size());
  for (std::size_t i = 0; i < form.shear.size(); ++i) {
    const auto& plane = form.shear[i];
    EXPECT_EQ(plane.cells + plane.lost, form.planes[i].cells);
    EXPECT_GT(plane.to_stick + plane.to_slip, 0u);
    EXPECT_LT(plane.flipped_share(), 0.2) << plane.figures;
    EXPECT_LT(plane.lowest_ratio, 1.0);
    EXPECT_GT(plane.highest_ratio, 1.0);
  }
  // The less, the faster: the force tends to cos(y) of itself where the beam is massless.
  const double massless = std::cos(std::sqrt(paper_beam().axial_force() * 4.0 / rigidity(paper_beam())));
  EXPECT_EQ(form.forces.size(), 24u);
  EXPECT_GT(form.forces.front().ratio, massless);
  EXPECT_LT(form.forces.front().ratio, form.forces.back().ratio);
  // Over the direction itself, by the map: neither by the table nor by one reaction for all cells.
  const auto map = studies::criterion_map(
      {.problem = data::load_case("paper"),
       .x = studies::map_axis("beam.axial_direction", 0.0, 1.0, 2, false),
       .y = {.parameter = "excitation.frequency_hz", .values = {form.forces.front().frequency_hz}}});
  EXPECT_TRUE(within(*map.cells[1].force_ratio / *map.cells[0].force_ratio, form.forces.front().ratio,
                     reference(2e-10, "the width of the bounds")));
}

// --- Shear and rotary inertia by both implementations: frequencies, reactions, verdicts; and what they change in the paper.

// The square section of the paper with k = 5/6 and Poisson's ratio 0.3.
data::Beam sheared_beam(double length, double axial_force, double axial_direction = 0.0) {
  data::BeamProperties beam = data::load_case("paper").beam().properties();
  beam.length = length;
  beam.axial_force = axial_force;
  beam.axial_direction = axial_direction;
  return studies::with_shear(data::Beam(beam));
}

STICKSLIP_VERIFIES(ShearReaction, "X24");
// Frequencies, shares, quasi-static part and buckling load with axial force of either sign and both directions. Of second
// order in the element length: two meshes give the error of the finer, and what they leave is the fourth order.
TEST(ShearReaction, OfMeshesConverges) {
  const auto of_mesh = [](const data::Beam& beam, int elements) {
    const solver::BeamModel model(beam, elements);
    const Eigen::VectorXd shape = model.unit_tip_deflection(),
                          load = model.base_load() - model.mass() * shape;
    std::vector<double> values{(model.slip_stiffness() * shape)[model.tip_deflection()],
                               solver::stick_buckling_load(model)};
    for (const auto& mode : solver::stick_modes(model, 4)) {
      const Eigen::VectorXd row = model.slip_stiffness() * mode.shape -
                                  std::pow(mode.angular_frequency, 2) * (model.mass() * mode.shape);
      values.insert(values.end(),
                    {mode.angular_frequency, row[model.tip_deflection()] * mode.shape.dot(load)});
    }
    return values;
  };
  for (const auto& beam : {sheared_beam(2.0, 500.0), sheared_beam(2.0, 5e4, 1.0), sheared_beam(0.5, 3e5, 0.4),
                           sheared_beam(0.5, -2e5, 1.0)}) {
    const auto exact = analytic::timoshenko_reaction(beam, 4);
    std::vector<double> expected{exact.quasi_static, analytic::stick_buckling_load(beam)};
    for (const auto& mode : exact.modes)
      expected.insert(expected.end(), {mode.angular_frequency, mode.coefficient});
    const std::vector<double> coarse = of_mesh(beam, 100), fine = of_mesh(beam, 200);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const double change = fine[i] - coarse[i];
      EXPECT_TRUE(within(fine[i] + change / 3.0, expected[i],
                         discretisation(0.01 * std::abs(change) + 1e-8 * std::abs(expected[i]), 1.0,
                                        "the fourth order, and rounding")))
          << i;
    }
  }
}

STICKSLIP_VERIFIES(ShearScope, "X24");
TEST(ShearScope, IsRefusedByNameWhereThereIsNoShear) {
  data::Case problem = data::load_case("paper");
  problem.structure = studies::with_shear(problem.beam());
  const data::Damping damping({.kelvin_voigt = 1e-5});
  const data::Beam& beam = problem.beam();
  const data::HarmonicExcitation& excitation = problem.excitation();
  const std::function<void()> attempts[] = {
      [&] { (void)analytic::stick_modes(beam, 1); },
      [&] { (void)analytic::slip_modes(beam, 1); },
      [&] { (void)analytic::StickResponse(beam, excitation); },
      [&] { (void)analytic::TipMobility(beam, damping); },
      [&] { (void)analytic::damped_reaction(analytic::HeldBeam(beam, damping, 5).structure()); },
      [&] { (void)analytic::DampedSteadyState(beam, excitation, damping, analytic::TipSupport::free); },
      [&] { (void)analytic::contact_model(with(problem, damping), 5); },
      [&] {
        (void)studies::band_margin(problem, {10.0, 20.0});
      }};
  for (const auto& attempt : attempts) {
    const std::string message = error_message_of<data::FieldError>(attempt);
    EXPECT_TRUE(message.starts_with("beam.shear_stiffness is ")) << message;
  }
}

STICKSLIP_VERIFIES(ShearEffect, "X24");
// The sentence of a thick beam is about the criterion with shear: the forces of both, and the verdict where it changes, at an
// amplitude between the critical ones or a load between the buckling loads. A beam with shear is not thick.
TEST(ShearEffect, IsInTheWarningOfAThickBeam) {
  const data::Case thick =
      data::load_case("paper", {{"beam.length", "0.8"}, {"excitation.frequency_hz", "120"}});
  const data::Case sheared = with(thick, studies::with_shear(thick.beam()));
  const auto thick_beam = [](const data::Case& problem) {
    const auto warnings = studies::criterion_warnings(problem);
    const auto found = std::ranges::find(warnings, studies::Concern::thick_beam, &studies::Warning::concern);
    return found == warnings.end() ? std::string() : found->sentence;
  };
  const auto effect_at = [&](const char* key, double value) {
    return studies::shear_effect(data::with_value(thick, key, value));
  };
  EXPECT_TRUE(holds(thick_beam(thick), studies::shear_effect(thick)));
  EXPECT_EQ(thick_beam(sheared), "");
  const auto with_shear = analytic::criterion_with_all_modes(sheared, 1e-6),
             without = analytic::criterion_with_all_modes(thick, 1e-6);
  EXPECT_TRUE(holds(studies::shear_effect(thick),
                    fmt::format("{:.4g} N instead of {:.4g} N, and the verdict is stick-slip as well",
                                with_shear.force_max.midpoint(), without.force_max.midpoint())));
  EXPECT_TRUE(effect_at("excitation.amplitude", 0.5 * (with_shear.critical_amplitude.midpoint() +
                                                       without.critical_amplitude.midpoint()))
                  .ends_with(", and the verdict is stick-slip instead of stick"));
  EXPECT_TRUE(effect_at("beam.axial_force", 0.99 * analytic::stick_buckling_load(thick.beam()))
                  .ends_with("the beam buckles"));
  EXPECT_EQ(thick_beam(with(thick, data::Damping({.ratio = 0.01}))).find("shear_stiffness"),
            std::string::npos);
}

}  // namespace
}  // namespace stickslip::testing
