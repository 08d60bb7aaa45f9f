// SPDX-License-Identifier: MIT
/// The direction of the axial force, chi, in both implementations: 0 follows the tip, 1 keeps its direction.

#include <Eigen/Dense>

#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/modal_reaction.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"
#include "stickslip/analytic/tip_mobility.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/contact_mobility.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/analyses/criterion_map.hpp"
#include "studies/analyses/design_guide.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/verification/energy_audit.hpp"
#include "studies/verification/frequencies.hpp"
#include "studies/verification/model_form.hpp"
#include "support/damped_benchmark.hpp"
#include "support/order.hpp"
#include "support/random_beams.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

// P = factor EI/L^2.
data::Beam beam_with(double axial_direction, double factor) {
  data::BeamProperties properties = paper_beam_properties();
  properties.axial_force = factor * rigidity(paper_beam()) / (properties.length * properties.length);
  properties.axial_direction = axial_direction;
  return data::Beam(properties);
}

data::Case case_with_direction(const std::string& name, double axial_direction) {
  return data::with_value(data::load_case(name), "beam.axial_direction", axial_direction);
}

double critical_factor(double axial_direction) {
  const data::Beam beam = beam_with(axial_direction, 0.0);
  return analytic::slip_critical_load(beam) * beam.length() * beam.length() / rigidity(beam);
}

// The load factor up to which all slip frequencies of a mesh are real, to 1e-11.
double critical_factor_of_the_mesh(double axial_direction, int elements) {
  const auto is_stable = [&](double factor) {
    const solver::BeamModel mesh(beam_with(axial_direction, factor), elements);
    return std::ranges::all_of(solver::slip_eigenvalues(mesh, 2), [](const std::complex<double>& square) {
      return square.imag() == 0.0 && square.real() > 0.0;
    });
  };
  double low = 0.0, high = 0.5;
  while (is_stable(high)) low = high, high += 0.5;
  while (high - low > 1e-11) {
    const double middle = 0.5 * (low + high);
    (is_stable(middle) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

STICKSLIP_VERIFIES(SlipCriticalLoad, "X23");
TEST(SlipCriticalLoad, IsBecksFlutterLoadAndEulersBucklingLoad) {
  EXPECT_TRUE(within(critical_factor(0.0), 20.050953618973761, reference(4e-11, "1e-12 of it")));
  const double euler = std::pow(std::numbers::pi, 2) / 4.0;
  EXPECT_TRUE(within(critical_factor(1.0), euler, round_off(8, 2, euler)));
}

// Where it buckles, the static shapes of the mesh are those of the beam with another wave number: y^2 (1 + y^4/(720 n^4)
// [1 - 11 y^2/(210 n^2)]), y^2 the load factor, whatever the condition at the tip. (The strain energy of the interpolant lacks
// y^4/(720 n^4) [1 - y^2/(35 n^2)], the work of P has y^6/(30240 n^6) too little.) Where it flutters, beta_bar L = 5.0 where the
// modes meet, four times (beta_bar l)^2/40 at a free tip, as in FlutterLoadOrder.
TEST(SlipCriticalLoad, OfTheMeshHasOrderFour) {
  for (const double chi : {0.2, 0.45, 0.501, 0.8, 1.0}) {
    const double exact = critical_factor(chi);
    const bool buckles = chi > 0.5;
    std::vector<OrderLevel> levels;
    for (const int n : buckles ? std::vector{3, 4, 6, 8} : std::vector{4, 6, 8, 12, 16})
      levels.push_back({.step = 1.0 / n,
                        .error = critical_factor_of_the_mesh(chi, n) - exact,
                        .next_term = (buckles ? 1.2 * 11.0 / 210.0 * exact : 2.5) / (n * n),
                        .floor = buckles ? 1e-10 : 1e-9});
    const auto constant = buckles ? std::optional(std::pow(exact, 3) / 720.0) : std::nullopt;
    EXPECT_TRUE(order_is(levels, 4.0, constant)) << chi;
  }
}

// The beam below is stable up to its flutter load, and the one above it is not at pi^2.
TEST(SlipCriticalLoad, ChangesFromFlutterToBucklingAtOneHalf) {
  for (const double chi : {0.499, 0.501}) {
    const bool buckles = chi > 0.5;
    const data::Beam beam = beam_with(chi, 9.87);
    EXPECT_EQ(
        error_message_if_any<data::FieldError>([&] { (void)analytic::slip_modes(beam, 2); }).has_value(),
        buckles);
    EXPECT_EQ(error_message_if_any<data::FieldError>([&] {
                (void)solver::slip_modes(solver::BeamModel(beam, 20), 2);
              }).has_value(),
              buckles);
    EXPECT_EQ(analytic::buckles_in_slip(beam_with(chi, 0.0)), buckles);
  }
}

class AxialDirection : public ::testing::TestWithParam<double> {};

STICKSLIP_VERIFIES(AxialDirection, "X23");
TEST_P(AxialDirection, SlipFrequenciesOfTheMeshHaveOrderFour) {
  // As SlipFrequencyOrder; the axial force changes the constants, which are left out here, and lengthens the
  // trigonometric wave number, whose square is that of the hyperbolic one and the load factor, 2.
  const auto study = studies::slip_frequency_study(beam_with(GetParam(), 2.0), 3, {8, 12, 16, 24, 32});
  EXPECT_EQ(study.modes.size(), 3u);
  for (const auto& mode : study.modes) {
    std::vector<OrderLevel> levels;
    for (std::size_t i = 0; i < study.elements.size(); ++i) {
      const double length = 1.0 / study.elements[i];
      const double beta_length = (mode.mode - 0.4) * std::numbers::pi;
      levels.push_back({.step = length,
                        .error = std::abs(mode.relative_error[i]),
                        .next_term = 0.1 * (std::pow(beta_length, 2) + 2.0) * length * length,
                        .floor = 1e-11});
    }
    EXPECT_TRUE(order_is(levels, 4.0)) << "mode " << mode.mode;
  }
}

TEST_P(AxialDirection, MobilityHasItsPolesZerosAndStaticLimit) {
  const double factor = 2.0, y = std::sqrt(factor), chi = GetParam();
  const data::Beam beam = beam_with(chi, factor);
  const analytic::TipMobility mobility(beam);
  // The shape 1 - cos(y xi) - tan(y) (y xi - sin(y xi)) has no moment at the tip.
  const double flexibility = (std::tan(y) - y) / (1.0 - (1.0 - chi) * (1.0 - 1.0 / std::cos(y))) /
                             std::pow(y, 3) * std::pow(beam.length(), 3) / rigidity(beam);
  const double small = 1e-6;
  EXPECT_TRUE(within(mobility(small) / small, flexibility, round_off(30, 10, flexibility)));
  const auto impedance = [&](std::complex<double> s) { return 1.0 / mobility(s); };
  const auto expect_zero = [](const auto& function, const auto& mode) {
    const auto at = [&](double share) { return function({0.0, mode.angular_frequency() * share}); };
    EXPECT_TRUE(within(2e-6 * at(1.0) / (at(1.0 + 1e-6) - at(1.0 - 1e-6)), 0.0, round_off(10, 5, 1.0)))
        << mode.number();
  };
  for (const auto& mode : analytic::slip_modes(beam, 4)) expect_zero(impedance, mode);
  for (const auto& mode : analytic::stick_modes(beam, 4)) expect_zero(mobility, mode);
  const data::Damping damping({.kelvin_voigt = 1e-4});
  const std::complex<double> s(60.0, 150.0);
  const auto damped = analytic::TipMobility(beam, damping)(s);
  const auto base = solver::harmonic_motion(data::HarmonicExcitation({25.0, 1e-3}));
  std::vector<OrderLevel> levels;
  for (const int n : {8, 12, 16, 24}) {
    const auto system =
        solver::beam_contact_system(solver::BeamModel(beam, n), paper_friction(), base, damping);
    levels.push_back({.step = 1.0 / n,
                      .error = std::abs(solver::ContactMobility(system)(s) - damped),
                      .next_term = std::pow(6.0 / n, 2) / 10.0,
                      .floor = round_off(1, std::pow(n, 4), std::abs(damped)).value});
  }
  EXPECT_TRUE(order_is(levels, 4.0));
}

TEST_P(AxialDirection, DampedFreeTipIsFreeOfForce) {
  const data::Beam beam = beam_with(GetParam(), 2.0);
  for (const double hz : {1.0, 25.0, 400.0})
    for (const double eta : {0.0, 6.4e-5}) {
      const data::HarmonicExcitation excitation({.frequency_hz = hz, .amplitude = 1e-3});
      const analytic::DampedSteadyState free(beam, excitation, data::Damping({.kelvin_voigt = eta}),
                                             analytic::TipSupport::free);
      double largest = 0.0;
      for (int i = 0; i <= 100; ++i)
        largest = std::max(largest, std::abs(free.rigidity() * free.derivative(3, 0.02 * i)));
      EXPECT_TRUE(within(free.friction_force(), 0.0, round_off(50, 45, largest))) << hz;
      EXPECT_TRUE(within(free.derivative(1, 0.0), 0.0, round_off(50, 45, 1.0))) << hz;
      // What the base and the follower part of P put in is what becomes heat.
      const auto tip = free.displacement(2.0), slope = free.derivative(1, 2.0);
      const double follower = (1.0 - GetParam()) * beam.axial_force();
      const double put_in =
          std::numbers::pi *
          (1e-3 * free.rigidity() * free.derivative(3, 0.0) - follower * slope * std::conj(tip)).imag();
      const double scale = std::abs(1e-3 * free.rigidity() * free.derivative(3, 0.0));
      EXPECT_TRUE(within(put_in, free.dissipated_energy(), round_off(200, 45, scale))) << hz;
    }
}

TEST_P(AxialDirection, IsInTheStaticReactionAndInTheTableOfReactions) {
  // S'''(L) + chi p S'(L) = S'''(L) [1 - chi (1 - cos y)], which vanishes at chi = 1, y = pi/2.
  const analytic::ModalReactionTable table(0.0, 10.0, 6, GetParam());
  for (const double factor : {0.0, 0.12, 2.4674, 5.0, 9.9}) {
    const data::Beam beam = beam_with(GetParam(), factor);
    const auto direct = analytic::modal_reaction(beam, 6),
               follower = analytic::modal_reaction(beam_with(0.0, factor), 6);
    const double share = 1.0 - GetParam() * (1.0 - std::cos(std::sqrt(factor)));
    EXPECT_TRUE(
        within(direct.quasi_static, share * follower.quasi_static, round_off(20, 5, follower.quasi_static)));
    const auto tabulated = table.at(beam);
    EXPECT_TRUE(
        within(tabulated.quasi_static, direct.quasi_static, round_off(20, 20, follower.quasi_static)));
    for (std::size_t n = 0; n < direct.modes.size(); ++n)
      EXPECT_TRUE(within(tabulated.modes[n].coefficient, direct.modes[n].coefficient,
                         round_off(20, 100, follower.modes[n].coefficient)))
          << n;
    EXPECT_FALSE(table.holds(beam_with(0.5 * (1.0 + GetParam()) - 0.1, factor)));
  }
}

TEST_P(AxialDirection, EnergyOfADampedHistoryBalances) {
  const auto audit = studies::energy_audit(case_with_direction("damped", GetParam()), 0.09, {6}, 10,
                                           {1e-5, 5e-6, 2.5e-6, 1.25e-6});
  const double work = audit.event_driven.base_work;
  // The integrator keeps 1e-12 of the state a step, in some thousand steps.
  EXPECT_TRUE(within(audit.event_driven_residual(), 0.0, reference(1e-8 * work, "the integrator")));
  std::vector<double> residuals;
  for (const auto& balance : audit.meshes.front().stepped) residuals.push_back(std::abs(balance.residual()));
  EXPECT_TRUE(order_is(
      order_levels(
          audit.time_step, residuals, [](double h) { return 1770.0 * h; }, round_off(1e5, 1, 1.0).value),
      2.0));
  const auto& stepped = audit.meshes.front().stepped.back();
  EXPECT_EQ(audit.event_driven.follower_work == 0.0, GetParam() == 1.0);
  EXPECT_EQ(stepped.follower_work == 0.0, GetParam() == 1.0);
  // What six elements cost: as in EnergyAudit.
  const double cost = std::pow(10.2 / 6.0, 4) / 720.0;
  for (const auto& [on_mesh, exact] : {std::pair{stepped.damping_loss, audit.event_driven.damping_loss},
                                       {stepped.follower_work, audit.event_driven.follower_work}})
    EXPECT_TRUE(within(on_mesh, exact, discretisation(cost * exact, 2.0, "mode 3 on the mesh")));
}

INSTANTIATE_TEST_SUITE_P(Chi, AxialDirection, ::testing::Values(0.3, 1.0));

STICKSLIP_VERIFIES(DeadLoadHistory, "X23");
TEST(DeadLoadHistory, IsTheSameInBothImplementations) {
  const auto benchmark =
      studies::damped_benchmark(case_with_direction("damped", 1.0), {.duration = 0.1,
                                                                     .modes = 28,
                                                                     .other_modes = {10},
                                                                     .event_driven_elements = {10},
                                                                     .elements = {20, 40},
                                                                     .time_steps = {1e-5, 5e-6}});
  ASSERT_GE(benchmark.events.size(), 5u);
  expect_events_of_reference(benchmark, 40, 5e-6);
}

STICKSLIP_VERIFIES(ModelForm, "X23");
TEST(ModelForm, OfTheAxialForceBucklesTheFlatSection) {
  const data::Case flat = data::load_case("paper-figure14");
  const auto form =
      studies::model_form(data::load_case("paper"), data::load_case("paper-half-stiffness"), flat, 5);
  ASSERT_EQ(form.planes.size(), 3u);
  const double euler = std::pow(std::numbers::pi / flat.beam.length(), 2) / 4.0 * rigidity(flat.beam);
  EXPECT_LT(euler, flat.beam.axial_force());
  // Over 5 lengths and 100 forces: 20.19 EI/L^2 ends the stick state, pi^2 EI/(4 L^2) the stability of the slip state.
  std::size_t cells = 0, buckled = 0;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 100; ++j) {
      const double factor =
          5.0 * std::pow(6600.0, j / 99.0) * std::pow(0.4 + 0.4 * i, 2) / rigidity(flat.beam);
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

STICKSLIP_VERIFIES(ShearScope, "X24");
TEST(ShearScope, IsRefusedByNameWhereThereIsNoShear) {
  data::Case problem = data::load_case("paper");
  problem.beam = studies::with_shear(problem.beam);
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
      [&] { (void)analytic::BeamContactModel(with(problem, damping), 5); },
      [&] {
        (void)studies::band_margin(problem, {10.0, 20.0});
      }};
  for (const auto& attempt : attempts) {
    const std::string message = error_message_of<data::FieldError>(attempt);
    EXPECT_TRUE(message.starts_with("beam.shear_stiffness is ")) << message;
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
  EXPECT_TRUE(holds(sentence, studies::shear_effect(thick)));
  const data::Case sheared = with(thick, studies::with_shear(thick.beam));
  const auto criterion = studies::criterion_with_all_modes(sheared, 1e-6),
             slender = studies::criterion_with_all_modes(thick, 1e-6);
  EXPECT_EQ(studies::shear_effect(thick),
            fmt::format("with beam.shear_stiffness = 6.41e+06 (k = 5/6, nu = 0.3) |f_max| with all modes is "
                        "{:.4g} N instead of "
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
