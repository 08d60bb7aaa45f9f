// SPDX-License-Identifier: MIT
/// The bound of the growth of a disturbance: closed forms, meshes, modes, steps, and runs that obey it; and a friction law that
/// jumps.

#include "studies/history/contact_growth.hpp"
#include "stickslip/analytic/boundary_integral.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/history/history_convergence.hpp"
#include "studies/history/method.hpp"
#include "support/contact_models.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using studies::growth_bound;

constexpr double kappa = 150.0;                            // N s/m, of the paper: (0.6 - 0.3) 1 s/m 500 N
constexpr double beam_bound = 4.0 * kappa / (10.0 * 2.0);  // 4 kappa/(rho A L) = 30/s

// growth_bound() is from above, and to 1e-4.
Tolerance searched(double expected) { return discretisation(1e-4 * expected, 1.01, "the search"); }

data::Case paper_case() { return with(data::load_case("paper"), data::HarmonicExcitation({25.0, 1e-3})); }

data::Case with_beam(const data::Beam& beam, const data::Damping& damping = {}) {
  return with(paper_case(), beam, paper_friction(), damping);
}

solver::ContactSystem mesh_system(int elements) {
  return solver::beam_contact_system(solver::BeamModel(paper_beam(), elements), paper_problem(25.0, 1e-3));
}

solver::ContactMobility mesh(int elements) { return solver::ContactMobility(mesh_system(elements)); }

double stepped_bound(const solver::ContactMobility& mobility, double angle, double radius) {
  const double h = angle / mobility.angular_frequencies().maxCoeff();
  return growth_bound(studies::stepped_contact(mobility, h, radius), kappa);
}

studies::LinearContact without_limit(studies::LinearContact contact) {
  contact.limiting_mass = std::numeric_limits<double>::infinity();
  return contact;
}

STICKSLIP_VERIFIES(Weakening, "X12");
TEST(Weakening, IsTheSteepestFallOfTheFrictionForce) {
  const data::FrictionLaw law({.static_coefficient = 0.5, .kinetic_coefficient = 0.25, .decay = 3.0});
  EXPECT_DOUBLE_EQ(studies::weakening(law, 8.0), 6.0);
}

STICKSLIP_VERIFIES(ContactGrowth, "X12");
TEST(ContactGrowth, OfAMassIsKappaOverIt) {
  for (const double stiffness : {50.0, 5e4}) {
    const SingleMass mass{.mass = 2.0, .stiffness = stiffness, .normal_force = 1.0};
    const auto contact = studies::continuous_contact(solver::ContactMobility(contact_system(mass)));
    const auto model = contact_model(SingleMass{.mass = 2.0, .stiffness = stiffness, .normal_force = 1.0});
    EXPECT_TRUE(within(growth_bound(contact, 3.0), 1.5, searched(1.5)));
    EXPECT_TRUE(within(growth_bound(studies::continuous_contact(model), 3.0), 1.5, searched(1.5)));
    // Re Z = sigma (m + k/|s|^2) falls up to the last frequency searched, where |s|^2 = 9 k/m + sigma^2.
    const double at_the_end = 3.0 / (2.0 + 2.0 / 9.0);
    EXPECT_TRUE(within(growth_bound(without_limit(contact), 3.0), at_the_end,
                       discretisation(2e-3 * at_the_end, 1.0, "sigma^2 against 9 k/m, and the search")));
  }
}

TEST(ContactGrowth, OfADampedMassIsLess) {
  for (const auto& [damping, expected] : {std::pair{1.0, 1.0}, {3.5, 0.0}}) {
    const SingleMass mass{.mass = 2.0, .stiffness = 50.0, .damping = damping, .normal_force = 1.0};
    EXPECT_TRUE(
        within(growth_bound(studies::continuous_contact(solver::ContactMobility(contact_system(mass))), 3.0),
               expected, searched(expected)));
  }
}

// Spectral radius 1 is the trapezoidal rule: Re Z = m (2/h) Re tanh((sigma + i omega) h/2), least at omega =
// 0. The spring is too soft to matter, (omega_0/sigma)^2 = 1e-8.
TEST(ContactGrowth, OfAMassInStepsIsOfItsTransfer) {
  const solver::ContactMobility mobility(
      contact_system({.mass = 2.0, .stiffness = 4.5e-8, .normal_force = 1.0}));
  for (const double h : {0.1, 0.5, 1.0}) {
    const double expected = 2.0 / h * std::atanh(3.0 * h / 4.0);
    EXPECT_TRUE(
        within(growth_bound(studies::stepped_contact(mobility, h, 1.0), 3.0), expected, searched(expected)));
  }
  // kappa W_0 = 3 h/4 >= 1: no step has one solution.
  EXPECT_TRUE(std::isinf(growth_bound(studies::stepped_contact(mobility, 1.4, 1.0), 3.0)));
}

// No mode asks for more than the limit of the high ones, and those searched come near to it. Damping takes from it.
TEST(ContactGrowth, OfTheBeamIsFourKappaOverItsMass) {
  EXPECT_TRUE(within(studies::beam_growth_bound(with_beam(paper_beam())), beam_bound, searched(beam_bound)));
  const auto contact = studies::continuous_contact(with_beam(paper_beam()));
  const double low_modes = growth_bound(without_limit(contact), kappa);
  EXPECT_LE(low_modes, beam_bound * (1.0 + 1e-4));
  EXPECT_GT(low_modes, 0.98 * beam_bound);
  for (const double share : {0.999, 1.001})
    EXPECT_EQ(studies::grows_at_most(contact, kappa, share * beam_bound), share > 1.0);
  double before = beam_bound;
  for (const double eta : {1e-7, 1e-6, 1e-5, 1e-4}) {
    const double bound = studies::beam_growth_bound(with_beam(paper_beam(), kelvin_voigt(eta)));
    EXPECT_LT(bound, before);
    before = bound;
  }
}

// cos b cosh b = -1 at b = (n - 1/2) pi + e with |e| = 2 exp(-b), and omega is that of b^2. In steps of h none is above pi/h.
TEST(ContactGrowth, IsSearchedFromTheModes) {
  const data::Beam beam = paper_beam_with_axial_force(0.0);
  auto frequencies = studies::continuous_contact(with_beam(beam)).frequencies;
  ASSERT_EQ(frequencies.size(), 41u);  // 0 and 40 modes
  const auto modes = analytic::slip_modes(beam, 4);
  for (std::size_t n = 2; n <= 4; ++n) {
    const double b = (static_cast<double>(n) - 0.5) * std::numbers::pi,
                 omega = modes[n - 1].angular_frequency();
    EXPECT_TRUE(within(frequencies[n], omega, discretisation(omega * 4.0 * std::exp(-b) / b, 1.1, "e")));
  }
  constexpr double h = 1e-4, highest = std::numbers::pi / h;
  std::erase_if(frequencies, [](double omega) { return omega >= highest; });
  frequencies.push_back(highest);
  EXPECT_EQ(studies::stepped_contact(beam, h, 2).frequencies, frequencies);
}

TEST(ContactGrowth, OfAMeshDoubles) {
  double before = 0.0;
  for (const int elements : {5, 10, 20, 40}) {
    const auto mobility = mesh(elements);
    const auto contact = studies::continuous_contact(mobility);
    const double bound = growth_bound(contact, kappa), closed_form = kappa / mobility.contact_mass();
    EXPECT_TRUE(within(bound, closed_form, searched(closed_form)));
    EXPECT_LE(growth_bound(without_limit(contact), kappa), closed_form * (1.0 + 1e-4));
    // What the mesh far from the tip adds to the contact mass falls tenfold and more from element to element.
    if (before > 0.0) {
      EXPECT_TRUE(within(bound, 2.0 * before, searched(2.0 * before)));
    }
    before = bound;
  }
  EXPECT_GT(before, 100.0 * beam_bound);
}

TEST(ContactGrowth, OfARadiatingTipIsTheBeams) {
  // 0.03 rho A l of the 0.0722 rho A l that the tip opposes to an impulse, behind a dashpot of kappa. Without
  // the dashpot it is kappa/(0.0422 rho A l), which doubles with the mesh.
  for (const int elements : {5, 10, 20}) {
    const double mass = 0.03 * 10.0 * 2.0 / elements;
    const auto bound = [&](double dashpot) {
      return growth_bound(studies::continuous_contact(solver::ContactMobility(
                              studies::with_radiating_contact(mesh_system(elements), mass, dashpot))),
                          kappa);
    };
    EXPECT_LE(bound(kappa), beam_bound * (1.0 + 1e-4)) << elements;
    EXPECT_GT(bound(0.0), 20.0 * beam_bound) << elements;
  }
}

STICKSLIP_VERIFIES(FilteringStep, "X12");
// A long step with spectral radius 0 has about the growth of the beam on every mesh, a step that resolves the mesh nearly that of
// the mesh. The step follows from the length of the elements alone.
TEST(FilteringStep, KeepsTheGrowthOfTheBeam) {
  std::vector<double> bounds;
  for (const int elements : {5, 20, 80}) {
    const auto mobility = mesh(elements);
    bounds.push_back(stepped_bound(mobility, studies::filtering_angle, 0.0));
    EXPECT_TRUE(
        within(bounds.back(), beam_bound, discretisation(beam_bound * 0.15, 1.0, "as the manual says")))
        << elements;
    EXPECT_GT(stepped_bound(mobility, 0.3, 0.9), bounds.back()) << elements;
    EXPECT_LT(stepped_bound(mobility, 0.3, 0.9), kappa / mobility.contact_mass()) << elements;
    const double h = studies::time_step_of({.angle = studies::filtering_angle}, paper_beam(), elements);
    const double angle = mobility.angular_frequencies().maxCoeff() * h;
    EXPECT_TRUE(within(angle, studies::filtering_angle,
                       discretisation(2e-3 * angle, 1.0, "the constant of 5 elements against 20")));
  }
}

STICKSLIP_VERIFIES(BoundaryIntegralGrowth, "X12");
TEST(BoundaryIntegralGrowth, IsThatOfTheBeamOrLess) {
  for (const int stages : {1, 2, 3, 4})
    for (const double h : {1e-4, 1e-5}) {
      const double bound = growth_bound(studies::stepped_contact(paper_beam(), h, stages), kappa);
      EXPECT_LE(bound, beam_bound * (1.0 + 1e-4)) << stages;
      EXPECT_GT(bound, 0.9 * beam_bound) << stages;
    }
}

// A stand-in for the converged history, which takes minutes: only its times and its range matter here.
studies::ConvergedHistory grid(double duration) {
  studies::ConvergedHistory history;
  for (int n = 0; n <= std::lround(duration / 5e-4); ++n) history.time.push_back(5e-4 * n);
  history.tip.assign(history.time.size(), 0.0);
  history.tip_range = 6e-3;
  return history;
}

STICKSLIP_VERIFIES(HistoryConvergence, "X12");
// A difference exp(sigma t) sin(omega t) whose largest values in periods of the sine are in the ratio exp(sigma T). The
// last period is cut off before its largest value.
TEST(HistoryConvergence, ObservesTheGrowth) {
  const double sigma = 30.0, period = 0.04, start = 0.06, step = 1e-4;
  studies::History a, b;
  for (int n = 0; n <= 2800; ++n) {
    const double t = step * n;
    const double apart = 1e-8 * std::exp(sigma * t) * std::sin(2.0 * std::numbers::pi * t / period);
    a.rows.push_back({.time = t, .tip_displacement = 1e-3});
    b.rows.push_back({.time = t, .tip_displacement = 1e-3 + apart});
  }
  EXPECT_FALSE(growth_rate(a, b, period, 1.0).has_value());  // no event
  a.events = {{data::ContactChange::onset, start, 1e-3}, {data::ContactChange::capture, 0.2, 1e-3}};
  // 1e-8 exp(sigma t) beside 1e-3: rounding by eps 1e-3/1e-8 of the first values.
  const Tolerance rounding = round_off(10, 1e5, 1.0 / period);
  EXPECT_TRUE(within(growth_rate(a, b, period, 1.0).value(), sigma, rounding));
  // The third period reaches 1.7e-6 near t = 0.17, the fourth 5.5e-6.
  EXPECT_TRUE(within(growth_rate(a, b, period, 2e-6).value(), sigma, rounding));
  EXPECT_FALSE(growth_rate(a, b, period, 1e-6).has_value());
}

TEST(HistoryConvergence, ObservesNoMoreThanItsBound) {
  for (const int elements : {5, 10}) {
    for (const auto& [angle, radius] : {std::pair{0.3, 0.9}, {studies::filtering_angle, 0.0}}) {
      const auto run =
          studies::history_run(paper_case(), grid(0.3), elements,
                               studies::time_step_of({.angle = angle}, paper_beam(), elements), radius, true);
      EXPECT_LE(run.highest_angle, angle * 1.001);
      EXPECT_LT(run.observed_growth.value(), run.growth_bound);
    }
  }
}

TEST(HistoryConvergence, MeasuresTheErrorOfTheTip) {
  auto reference = grid(0.1);
  const auto problem = paper_case();
  const auto history = studies::finite_element_history(studies::refined(problem, 10, 1e-4, 0.1), {.every = 5},
                                                       {.coordinates = solver::Coordinates::modal});
  reference.tip = studies::tip_displacements(history);
  reference.tip[60] += 6e-4;
  const auto run = studies::history_run(problem, reference, 10, 1e-4, 0.9, false);
  EXPECT_TRUE(within(run.error, 0.1, round_off(10, 10.0, 0.1)));
  EXPECT_EQ(run.changes, history.events.size());
  EXPECT_FALSE(run.observed_growth.has_value());
  EXPECT_DOUBLE_EQ(run.time_step, 1e-4);
  EXPECT_EQ(run.highest_angle, mesh(10).angular_frequencies().maxCoeff() * run.time_step);
  EXPECT_EQ(run.growth_bound, growth_bound(studies::stepped_contact(mesh(10), run.time_step, 0.9), kappa));
  // Rows are 5e-4 s apart.
  EXPECT_DOUBLE_EQ(studies::history_run(problem, grid(0.01), 10, 1.3e-4, 0.9, false).time_step, 1.25e-4);
}

TEST(HistoryConvergence, ObservesOnSmallMeshes) {
  const auto study = studies::history_refinement(
      paper_case(), grid(0.3), {"filtering step", studies::filtering_angle, 0.0, 0.0}, {5, 10}, 5);
  ASSERT_EQ(study.runs.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const double longest = studies::time_step_of(study.rule, paper_beam(), study.runs[i].elements);
    EXPECT_EQ(study.runs[i].elements, i == 0 ? 5 : 10);
    EXPECT_DOUBLE_EQ(study.runs[i].time_step, 5e-4 / std::ceil(5e-4 / longest));
    EXPECT_EQ(study.runs[i].spectral_radius, 0.0);
    EXPECT_EQ(study.runs[i].observed_growth.has_value(), i == 0);
  }
  EXPECT_DOUBLE_EQ(std::exp2(study.order.order), study.runs[0].error / study.runs[1].error);
}

TEST(HistoryConvergence, OfARadiatingTip) {
  const studies::StepRule rule{"radiating tip", 0.0, 1e-4, 1.0, 0.01};
  ASSERT_EQ(studies::time_step_of(rule, paper_beam(), 5), 1e-4);  // a fixed step
  const auto run = [](double share) {
    return studies::history_run(paper_case(), grid(0.1), 5, 1e-4, 1.0, false, share);
  };
  EXPECT_EQ(studies::history_refinement(paper_case(), grid(0.1), rule, {5, 6}, 0).runs[0].error,
            run(0.01).error);
  // A share of 1e-9 changes the motion by about as much, times what its growth by 30/s makes of that in 0.1 s.
  EXPECT_TRUE(within(run(1e-9).error, run(0.0).error, discretisation(1e-9 * std::exp(3.0), 5.0, "growth")));
  const solver::ContactMobility radiating(
      studies::with_radiating_contact(mesh_system(5), 0.01 * 10.0 * 2.0 / 5, kappa));
  EXPECT_EQ(run(0.01).growth_bound, growth_bound(studies::stepped_contact(radiating, 1e-4, 1.0), kappa));
}

// --- The warning

std::optional<studies::Warning> warning(const std::vector<data::Override>& overrides,
                                        const studies::Method& method = studies::finite_elements()) {
  return studies::growth_warning(data::load_case("paper", overrides), method);
}

STICKSLIP_VERIFIES(GrowthWarning, "X21");
TEST(GrowthWarning, BeginsAtTheSizeOfTheMotion) {
  const auto bound = growth_bound(studies::stepped_contact(mesh(20), 1e-5, 1.0), kappa);
  for (const double share : {0.99, 1.01}) {
    const auto found = warning({{"numerics.time_step", "1e-5"},
                                {"numerics.spectral_radius", "1"},
                                {"excitation.duration", data::shortest_text(share * 36.0 / bound)}});
    EXPECT_EQ(found.has_value(), share > 1.0);
    if (!found) continue;
    EXPECT_EQ(found->value, bound);
    EXPECT_DOUBLE_EQ(found->limit, bound / share);
  }
}

// The settings that the sentence advises are run: they have about the growth of the beam, 30/s.
TEST(GrowthWarning, AdvisesTheGrowthOfTheBeam) {
  const auto found = warning({{"numerics.time_step", "1e-6"}, {"excitation.duration", "0.5"}});
  ASSERT_TRUE(found);
  const std::string before = "time_step = ";
  const auto place = found->sentence.find(before);
  ASSERT_NE(place, std::string::npos) << found->sentence;
  const auto with_it = [&](const std::string& duration) {
    return warning({{"numerics.time_step",
                     data::shortest_text(std::stod(found->sentence.substr(place + before.size())))},
                    {"numerics.spectral_radius", "0"},
                    {"excitation.duration", duration}});
  };
  EXPECT_FALSE(with_it("1.1"));  // 31/s for 1.16 s
  EXPECT_FALSE(holds(with_it("1.5").value().sentence, before));
  EXPECT_TRUE(holds(found->sentence, fmt::format("{:.0f} 1/s", found->value)));
}

TEST(GrowthWarning, SaysWhenNoDiscretisationHelps) {
  const std::vector<data::Override> damped{{"excitation.duration", "3"}, {"damping.ratio", "1e-4"}};
  EXPECT_TRUE(holds(warning({{"excitation.duration", "10"}}).value().sentence, "for any discretisation"));
  EXPECT_TRUE(holds(warning(damped).value().sentence, "for the undamped beam"));
  EXPECT_FALSE(holds(warning(damped).value().sentence, "any discretisation"));
}

TEST(GrowthWarning, CountsModes) {
  for (const auto& [modes, duration, warns] : {std::tuple{"5", "0.15", false},
                                               {"5", "0.2", true},
                                               {"10", "0.1", true}})  // 213/s, 398/s with 10 modes
    EXPECT_EQ(warning({{"numerics.modes", modes}, {"excitation.duration", duration}}, studies::event_driven())
                  .has_value(),
              warns)
        << modes << ' ' << duration;
}

TEST(GrowthWarning, IsSilentOnWhatItDoesNotCompute) {
  // A damping of 1e-12 s leaves the growth as it is.
  for (const auto& [damping, most] : {std::pair{"0", 200}, {"1e-12", 50}})
    for (const int elements : {most, most + 1})
      EXPECT_EQ(warning({{"numerics.elements", std::to_string(elements)}, {"damping.kelvin_voigt", damping}})
                    .has_value(),
                elements == most)
          << elements;
  for (const auto* method : {&studies::closed_form(), &studies::boundary_integral()})
    EXPECT_FALSE(warning({}, *method));
  EXPECT_FALSE(warning({{"contact.tangential_stiffness", "1e8"}}));
}

constexpr data::FrictionCoefficients jumping{
    .static_coefficient = 0.3, .kinetic_coefficient = 0.2, .decay = std::numeric_limits<double>::infinity()};

STICKSLIP_VERIFIES(JumpOfFriction, "P2");
TEST(JumpOfFriction, IsTheLimitOfEverFasterDecay) {
  const data::FrictionLaw law = data::FrictionLaw(jumping).in_slip();
  for (const double v : {0.0, 1e-300, 1.0}) EXPECT_EQ(solver::friction_coefficient(law, v), 0.2);
  data::FrictionCoefficients fast = jumping;
  fast.decay = 1e6;
  EXPECT_DOUBLE_EQ(solver::friction_coefficient(data::FrictionLaw(fast), 1.0), 0.2);
  EXPECT_EQ(data::FrictionLaw(fast).in_slip().decay(), 1e6);
  EXPECT_EQ(studies::weakening(data::FrictionLaw(jumping), 10.0), 0.0);  // nothing grows in slip
}

TEST(JumpOfFriction, IsRefusedByUniqueSteps) {
  EXPECT_THROW(analytic::require_unique_step({10.0, data::FrictionLaw(jumping)}, 1e-9), data::FieldError);
}

}  // namespace
}  // namespace stickslip::testing
