// SPDX-License-Identifier: MIT
/// Shear and rotary inertia by both implementations: frequencies, reactions, verdicts; and what they change in the paper.

#include <Eigen/Dense>

#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"
#include "stickslip/analytic/tip_mobility.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/analyses/criterion_map.hpp"
#include "studies/analyses/design_guide.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/common/problem_parameter.hpp"
#include "support/error_message.hpp"
#include "support/order.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

// The square section of the paper with k = 5/6 and Poisson's ratio 0.3.
data::Case sheared_case(const std::vector<data::Override>& overrides = {}) {
  data::Case problem = data::load_case("paper", overrides);
  problem.beam = studies::with_shear(problem.beam);
  return problem;
}

data::Beam sheared_beam(double length, double axial_force, double axial_direction = 0.0) {
  data::BeamProperties beam = data::load_case("paper").beam.properties();
  beam.length = length;
  beam.axial_force = axial_force;
  beam.axial_direction = axial_direction;
  return studies::with_shear(data::Beam(beam));
}

// Relative errors of a frequency: (beta l)^4/1440 and rho A omega^2 l^2/(24 k G A), the energy of an element whose nodes are
// held under the inertia rho A omega^2 w over that of the motion.
struct FrequencyErrors {
  double bending{}, shear{};
};

FrequencyErrors frequency_errors(const data::Beam& beam, double omega, double l) {
  const double inertia = beam.density() * beam.area() * omega * omega;
  return {inertia * std::pow(l, 4) / (1440.0 * beam.youngs_modulus() * beam.second_moment_of_area()),
          inertia * l * l / (24.0 * beam.shear_stiffness())};
}

STICKSLIP_VERIFIES(ShearOrder, "X24");
// Elements shorter than the section is high: of second order, with the bending error as next term, and rotary inertia,
// 2 (beta r)^2 (k G A)/EI r^2 = 0.64 (beta r)^2 of the leading term.
TEST(ShearOrder, IsTwoForElementsShorterThanTheSection) {
  for (const auto& [tip_is_held, length] : {std::pair{true, 2.0}, {true, 0.5}, {false, 2.0}}) {
    const data::Beam beam = sheared_beam(length, 0.0);
    const double omega = analytic::timoshenko_frequencies(
                             beam, tip_is_held ? analytic::TipSupport::held : analytic::TipSupport::free, 2)
                             .back();
    std::vector<OrderLevel> levels;
    const double r2 = beam.second_moment_of_area() / beam.area();
    const double beta2 = omega * std::sqrt(beam.density() * beam.area() /
                                           (beam.youngs_modulus() * beam.second_moment_of_area()));
    for (const int elements : {40, 60, 80, 120}) {
      const double l = length / elements;
      const solver::BeamModel model(beam, elements);
      const auto modes = tip_is_held ? solver::stick_modes(model, 2) : solver::slip_modes(model, 2);
      const FrequencyErrors predicted = frequency_errors(beam, omega, l);
      levels.push_back({l, modes.back().angular_frequency / omega - 1.0,
                        predicted.bending / predicted.shear + beta2 * r2, 1e-12});
    }
    EXPECT_TRUE(order_is(levels, 2.0, frequency_errors(beam, omega, 1.0).shear)) << length;
  }
}

STICKSLIP_VERIFIES(ShearReaction, "X24");
// Frequencies, shares, quasi-static part and buckling load with axial force of either sign and both directions. Of second
// order in the element length: two meshes give the error of the finer, and what they leave is the fourth order.
TEST(ShearReaction, OfMeshesConvergesToTheClosedForm) {
  const auto share = [](const solver::BeamModel& model, const solver::FiniteElementMode& mode) {
    const Eigen::VectorXd row = model.slip_stiffness() * mode.shape -
                                std::pow(mode.angular_frequency, 2) * (model.mass() * mode.shape);
    const Eigen::VectorXd shape = model.unit_tip_deflection();
    return row[model.tip_deflection()] * mode.shape.dot(model.base_load() - model.mass() * shape);
  };
  for (const auto& beam : {sheared_beam(2.0, 500.0), sheared_beam(2.0, 5e4, 1.0), sheared_beam(0.5, 3e5, 0.4),
                           sheared_beam(0.5, -2e5, 1.0)}) {
    const auto exact = analytic::timoshenko_reaction(beam, 4);
    const auto extrapolated = [&](auto&& value) {
      const double coarse = value(solver::BeamModel(beam, 100)), fine = value(solver::BeamModel(beam, 200));
      return std::pair{fine + (fine - coarse) / 3.0, std::abs(fine - coarse)};
    };
    const auto expect = [&](auto&& value, double closed_form) {
      const auto [found, change] = extrapolated(value);
      EXPECT_TRUE(within(found, closed_form,
                         discretisation(0.01 * change + 1e-8 * std::abs(closed_form), 1.0,
                                        "the fourth order, and rounding")));
    };
    for (std::size_t n = 0; n < 4; ++n) {
      const auto mode = [n](const solver::BeamModel& model) { return solver::stick_modes(model, 4)[n]; };
      expect([&](const auto& model) { return mode(model).angular_frequency; },
             exact.modes[n].angular_frequency);
      expect([&](const auto& model) { return share(model, mode(model)); }, exact.modes[n].coefficient);
    }
    expect(
        [](const auto& model) {
          return (model.slip_stiffness() * model.unit_tip_deflection())[model.tip_deflection()];
        },
        exact.quasi_static);
    expect([](const auto& model) { return solver::stick_buckling_load(model); },
           analytic::stick_buckling_load(beam));
  }
}

analytic::Criterion criterion_of(const data::Case& problem) {
  return analytic::evaluate_criterion(problem.beam, problem.friction, problem.excitation,
                                      problem.numerics.duration(), problem.numerics.modes());
}

STICKSLIP_VERIFIES(ShearScope, "X24");
TEST(ShearScope, IsRefusedByNameWhereThereIsNoShear) {
  const data::Case problem = sheared_case();
  const data::Damping damping({.kelvin_voigt = 1e-5});
  const data::Beam& beam = problem.beam;
  const data::HarmonicExcitation& excitation = problem.excitation;
  const std::function<void()> attempts[] = {
      [&] { (void)analytic::stick_modes(beam, 1); },
      [&] { (void)analytic::slip_modes(beam, 1); },
      [&] { (void)analytic::StickResponse(beam, excitation); },
      [&] { (void)analytic::TipMobility(beam, damping); },
      [&] { (void)analytic::damped_reaction(beam, damping, 5); },
      [&] { (void)analytic::DampedSteadyState(beam, excitation, damping, analytic::TipSupport::free); },
      [&] { (void)analytic::BeamContactModel(beam, problem.friction, excitation, damping, 5); },
      [&] {
        (void)studies::band_margin(problem, {10.0, 20.0});
      }};
  for (const auto& attempt : attempts) {
    const std::string message = error_message_of<data::FieldError>(attempt);
    EXPECT_TRUE(message.starts_with("beam.shear_stiffness is ")) << message;
  }
}

// A map over the frequency shares one reaction, one over the length does not; each cell is the criterion of its case.
TEST(ShearScope, HoldsTheMapsOfTheCriterion) {
  const data::Case problem = sheared_case();
  for (const auto parameter : {"excitation.frequency_hz", "beam.length"}) {
    const double value = data::value_of(problem, parameter);
    const auto map =
        studies::criterion_map({.problem = problem,
                                .x = studies::map_axis(parameter, 0.7 * value, 0.8 * value, 2, false),
                                .y = studies::map_axis("excitation.amplitude", 1e-4, 1e-3, 2, false)});
    EXPECT_EQ(map.cells.size(), 4u);
    for (const auto& cell : map.cells) {
      const data::Case at =
          data::with_value(data::with_value(problem, parameter, cell.x), "excitation.amplitude", cell.y);
      const auto criterion = criterion_of(at);
      EXPECT_TRUE(within(*cell.force_ratio, criterion.force_max.midpoint() / criterion.friction_limit,
                         reference(2e-10 * *cell.force_ratio, "the width of the bounds")));
    }
  }
}

STICKSLIP_VERIFIES(ShearEffect, "X24");
// The sentence of a thick beam is about the criterion with shear; a beam with shear is not thick.
TEST(ShearEffect, IsInTheWarningOfAThickBeam) {
  data::Case thick = data::load_case("paper", {{"beam.length", "0.8"}, {"excitation.frequency_hz", "120"}});
  const auto thick_beam = [](const std::vector<studies::Warning>& warnings) {
    const auto found = std::ranges::find(warnings, studies::Concern::thick_beam, &studies::Warning::concern);
    return found == warnings.end() ? std::string() : found->sentence;
  };
  const std::string sentence = thick_beam(studies::problem_warnings(thick, studies::Inquiry::criterion));
  EXPECT_NE(sentence.find(studies::shear_effect(thick)), std::string::npos) << sentence;
  data::Case sheared = thick;
  sheared.beam = studies::with_shear(thick.beam);
  const auto criterion = criterion_of(sheared), slender = criterion_of(thick);
  EXPECT_EQ(
      studies::shear_effect(thick),
      fmt::format("with beam.shear_stiffness = 6.41e+06 (k = 5/6, nu = 0.3) |f_max| is {:.4g} N instead of "
                  "{:.4g} N, and the verdict is stick-slip as well",
                  criterion.force_max.midpoint(), slender.force_max.midpoint()));
  // An amplitude between the critical ones of the two, and a load between their buckling loads.
  const double amplitude =
      0.5 * (criterion.critical_amplitude.midpoint() + slender.critical_amplitude.midpoint());
  EXPECT_TRUE(studies::shear_effect(data::with_value(thick, "excitation.amplitude", amplitude))
                  .ends_with(", and the verdict is stick-slip instead of stick"));
  const double load = analytic::stick_buckling_load(thick.beam);
  EXPECT_EQ(studies::shear_effect(data::with_value(thick, "beam.axial_force", 0.99 * load)),
            "with beam.shear_stiffness = 6.41e+06 (k = 5/6, nu = 0.3) the beam buckles");
  EXPECT_EQ(thick_beam(studies::problem_warnings(sheared, studies::Inquiry::criterion)), "");
  thick.damping = data::Damping({.ratio = 0.01});
  EXPECT_EQ(thick_beam(studies::problem_warnings(thick, studies::Inquiry::criterion)).find("shear_stiffness"),
            std::string::npos);
}

}  // namespace
}  // namespace stickslip::testing
