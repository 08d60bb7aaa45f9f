// SPDX-License-Identifier: MIT
/// The largest force of a start-up against the steady force, what duration, damping and shear change, and what both
/// implementations refuse.

#include "studies/verification/scope.hpp"

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/modal_reaction.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/analyses/problem_warnings.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/natural_frequencies.hpp"
#include "studies/verification/amplitude_limits.hpp"
#include "studies/verification/claimed_domain.hpp"
#include "studies/verification/further_uses.hpp"
#include "support/beams.hpp"
#include "support/paper_case.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

constexpr double half_millimetre = 0.5e-3;

data::Case paper_at(double hz, double amplitude = half_millimetre) {
  return with(paper(), excitation(hz, amplitude));
}

STICKSLIP_VERIFIES(SlenderForce, "X22");
// The error of a mesh is that of the frequency of mode 1, (beta l)^4/1440 + rho A omega^2 l^2/(24 k G A), over its distance to
// the excitation, 24.72 Hz to 25 Hz; half a beat of 3.6 s is inside the duration, so that the largest |f| follows the distance.
TEST(SlenderForce, NearResonanceIsThatOfAMesh) {
  const auto force = studies::slender_force(paper_at(25.0));
  const data::Case sheared = with(paper_at(25.0), studies::with_shear(paper().beam()));
  constexpr int elements = 80;
  const double finite_element =
      solver::max_abs_friction_force(with_value(sheared, "numerics.elements", elements));
  const double omega = analytic::modal_forces(sheared.beam(), 1).front().angular_frequency;
  const double excitation = studies::angular_frequency(sheared.excitation());
  const double mass = sheared.beam().density() * sheared.beam().area();
  const double stiffness = sheared.beam().youngs_modulus() * sheared.beam().second_moment_of_area();
  const double l = sheared.beam().length() / elements;
  const double mesh = mass * omega * omega *
                      (std::pow(l, 4) / stiffness / 1440.0 + l * l / sheared.beam().shear_stiffness() / 24.0);
  const double step =
      studies::step_error(sheared.numerics.spectral_radius(), omega, sheared.numerics.time_step());
  EXPECT_TRUE(within(force.shifted_force_max, finite_element,
                     discretisation((mesh + step) * omega / (excitation - omega) * finite_element, 3.0,
                                    "frequency of mode 1 over its distance to the excitation")));
  EXPECT_GT(force.force_max, 7.0 * force.shifted_force_max);
  EXPECT_NEAR(force.model_errors.front(), studies::stick_model_error(paper().beam(), 1),
              0.05 * force.model_errors.front());
}

STICKSLIP_VERIFIES(LateSlips, "X22");
TEST(LateSlips, BeginWhereAllLaterSamplesAgree) {
  const auto slips = studies::late_slips({0.0, 0.1, 0.2, 0.3, 0.4}, {0.0, 1.0, 0.06, 0.02, 0.04});
  EXPECT_EQ(slips.range, 1.0);
  EXPECT_EQ(slips.settled, 0.2);
  EXPECT_DOUBLE_EQ(slips.later_range, 0.04);
}

// Each part at the frequency, the amplitude and with the damping that it says; at 25 Hz |f| grows to the end.
TEST(LateSlips, ArePartOfTheStudy) {
  const data::Case damped = data::load_case("damped");
  studies::ConvergedHistory converged;
  converged.time = {0.0, 0.1};
  converged.tip = {1.0, 3.0};
  const studies::ScopeRange range{{25.0, 70.0}, {0.1, 10.0}, {0.5e-3, 1e-3}, 2};
  const auto study = studies::scope(paper(), damped, converged, range);
  for (std::size_t i = 0; i < 2; ++i) {
    const data::Case problem = paper_at(range.frequencies_hz[i]);
    const auto& steady = study.steady.at(i);
    EXPECT_EQ(steady.frequency_hz, range.frequencies_hz[i]);
    EXPECT_EQ(steady.grows, i == 0);
    const double force = studies::steady_state(problem)->force.midpoint();
    EXPECT_TRUE(within(steady.steady, force, reference(1e-9 * force, "the exact steady part")));
    for (std::size_t k = 0; k < 2; ++k) {
      const auto [lower, upper] = analytic::criterion_with_all_modes(
                                      with_value(problem, "excitation.duration", range.durations[k]), 1e-8)
                                      .force_max;
      EXPECT_LE(steady.horizons.at(k).force_max.lower, upper);
      EXPECT_GE(steady.horizons.at(k).force_max.upper, lower);
    }
    const auto& slender = study.slender.at(i);
    EXPECT_EQ(slender.frequency_hz, range.frequencies_hz[i]);
    EXPECT_TRUE(within(slender.force_max, analytic::evaluate_criterion(problem).force_max.midpoint(),
                       reference(1e-7 * slender.force_max, "bounds of both")));
    const auto& of_damping = study.damped.at(i);
    EXPECT_EQ(of_damping.amplitude, range.amplitudes[i]);
    EXPECT_TRUE(within(of_damping.ratio, 0.005, reference(5e-5, "the comment of damped.toml, one digit")));
    const data::Case shaken = with(damped, excitation(of_damping.frequency_hz, range.amplitudes[i]));
    const double decaying = studies::steady_state(shaken)->force.midpoint();
    EXPECT_TRUE(within(of_damping.steady, decaying, reference(1e-9 * decaying, "the closed form")));
  }
  EXPECT_EQ(study.friction_limit, friction_limit());
  EXPECT_EQ(study.softer.all, 2);
  EXPECT_EQ(study.late_slips.range, 2.0);
}

STICKSLIP_VERIFIES(Refusals, "X18");
// Where the tip is not pressed against the wall, and from the buckling load on. Ten elements buckle later than the beam
// by (y l/L)^4/720 of the load, y = 4.49: 6e-5.
TEST(Refusals, AreForForcesWithoutAStickState) {
  auto choices = paper_choices(1e-3);
  choices.elements = 10;
  const data::NumericalSettings numerics(choices);
  for (const double share : {-3.0, -1e-8, 0.0, 1e-8, 0.999, 1.001, 3.99, 8.0}) {
    SCOPED_TRACE(share);
    const data::Beam beam = paper_beam_with_axial_force(share * analytic::stick_buckling_load(paper_beam()));
    const solver::BeamModel model(beam, 10);
    const auto expect_refused = [](bool refused, const std::function<void()>& action) {
      EXPECT_EQ(error_message_if_any<data::InputError>(action).has_value(), refused);
    };
    const bool buckled = share > 1.0, has_no_contact = share <= 0.0;
    expect_refused(buckled || has_no_contact,
                   [&] { (void)solver::first_slip(with(paper_problem(25.0, 1e-3), beam, numerics)); });
    expect_refused(buckled || has_no_contact,
                   [&] { (void)analytic::evaluate_criterion(with(paper_problem(25.0, 1e-3, 1e-3), beam)); });
    expect_refused(buckled, [&] { (void)solver::stick_modes(model, 1); });
    expect_refused(buckled, [&] { (void)analytic::stick_modes(beam, 1); });
    expect_refused(buckled, [&] { (void)model.unit_tip_deflection(); });
    expect_refused(buckled, [&] { (void)analytic::QuasiStaticShape{beam}; });
  }
}

STICKSLIP_VERIFIES(AmplitudeLimits, "X22");
TEST(AmplitudeLimits, AreThoseOfTheCommand) {
  const data::Case damped = data::load_case("damped");
  const auto study = studies::amplitude_limits(paper(), damped, {20.0, 25.0, 70.0});
  const auto critical = [](const data::Case& problem) {
    return analytic::evaluate_criterion(problem, 1e-6).critical_amplitude.midpoint();
  };
  for (const auto& limit : study.limits) {
    data::Case problem = paper_at(limit.frequency_hz);
    EXPECT_NEAR(limit.start_up, critical(problem), 2e-6 * limit.start_up);
    EXPECT_NEAR(limit.steady, 300.0 * half_millimetre / studies::steady_force(problem, {}).steady,
                1e-5 * limit.steady);
    problem.damping = damped.damping;
    EXPECT_NEAR(limit.damped_steady, 300.0 * half_millimetre / studies::damped_force(problem).steady,
                1e-9 * limit.damped_steady);
    EXPECT_LE(limit.damped_start_up, 1.001 * limit.damped_steady);
    EXPECT_NEAR(limit.shear / limit.start_up,
                studies::slender_force(problem).force_max / studies::slender_force(problem).shifted_force_max,
                1e-5);
  }
}

STICKSLIP_VERIFIES(DomainCases, "X22");
TEST(DomainCases, AreKeptAndRefusedIfTheyDiffer) {
  const auto kept = studies::read_domain(studies::domain_file());
  EXPECT_EQ(studies::domain_text(kept), data::read_text(studies::domain_file()));  // with its column names
  const std::size_t corner = std::size_t{2} * studies::domain_cases;               // the first
  for (const std::size_t i : {std::size_t{0}, std::size_t{99}, corner}) {
    studies::DomainCase computed = studies::domain_case(paper(), static_cast<int>(i) + 1);
    EXPECT_NO_THROW(studies::require_same(kept.at(i), computed));
    computed.shear += 1e-3;
    EXPECT_THROW(studies::require_same(kept.at(i), computed), std::runtime_error);
  }
  const auto one = studies::drawn_rows(kept, 20, "one"), other = studies::drawn_rows(kept, 20, "other");
  EXPECT_EQ(one.size(), 20u);
  EXPECT_NE(one.front().index, other.front().index);
}

TEST(DomainCases, HaveTheMarginOfThePapersBeam) {
  const studies::ClaimedDomain domain = studies::claimed_domain(paper(), 0, "");
  // Of the paper's beam at 72.9 Hz, in the domain, and at 150 Hz, outside.
  const auto fall = [](double hz) {
    const data::Case problem = paper_at(hz);
    return 1.0 - analytic::evaluate_criterion(with(problem, studies::with_shear(problem.beam())), 1e-6)
                         .critical_amplitude.midpoint() /
                     analytic::evaluate_criterion(problem, 1e-6).critical_amplitude.midpoint();
  };
  EXPECT_NEAR(fall(72.9), 0.218, 1e-3);
  EXPECT_GT(domain.margin.at(1).worst, fall(72.9));
  EXPECT_GT(domain.box.at(1).worst, fall(150.0));
  EXPECT_GE(domain.margin.back().worst, domain.margin.at(1).worst);
  // Finite elements with the mesh and step of the paper, and damping: empirical.
  EXPECT_LT(domain.margin.at(0).worst, 0.03);
  EXPECT_LT(domain.margin.at(5).worst, 0.01);
}

// Time steps against events, eigenvalues against roots, samples against a quantile: 3.3 standard errors of 200 000 samples, else empirical.
STICKSLIP_VERIFIES(FurtherUses, "W4");
TEST(FurtherUses, AgreeByTheirTwoWays) {
  const auto uses = studies::further_uses();
  EXPECT_EQ(uses.size(), 6U);
  for (const auto& use : uses) {
    EXPECT_LT(use.difference, use.name == "probability" ? 3.3 * std::sqrt(0.25 / 200000) : 2e-4) << use.name;
    EXPECT_GT(std::abs(use.value), 0.0) << use.name;
  }
}

// The leaf is in the domain of the margin, and the factor of its amplitude is one over the lognormal one of all models.
TEST(DomainCases, AreTheErrorOfTheWorkedUse) {
  const data::Case leaf = data::load_case("contact-leaf");
  const studies::DimensionlessCase groups = studies::dimensionless(leaf);
  studies::DomainCase one = studies::read_domain(studies::domain_file()).at(600);
  one.load = groups.load, one.frequency = groups.frequency, one.slenderness = groups.slenderness;
  one.periods = leaf.numerics.duration() * studies::stick_hz(leaf.beam(), 1);
  EXPECT_TRUE(studies::is_in_margin(one));
  const auto all = studies::claimed_domain(paper(), 0, "").margin.back();
  const double square = 1.0 + std::pow(all.spread / (1.0 + all.bias), 2);
  const auto keys = data::read_uncertainty(data::find_case("contact-leaf")).keys;
  const auto factor = std::ranges::find(keys, "excitation.amplitude", &data::UncertainKey::key)->distribution;
  EXPECT_NEAR(factor.mean / leaf.excitation().amplitude(), square / (1.0 + all.bias), 2e-4);
  EXPECT_NEAR(factor.standard_deviation / factor.mean, std::sqrt(square - 1.0), 1e-4);
}

STICKSLIP_VERIFIES(AmplitudeBudget, "X22");
TEST(AmplitudeBudget, HasTheChangeByEachCause) {
  studies::AmplitudeLimits limits;
  limits.limits = {{.frequency_hz = 35.0,
                    .start_up = 4.0,
                    .damped_start_up = 7.0,
                    .shear = 2.0,
                    .fixed_direction = 5.0,
                    .compliant = 4.0}};
  studies::ForceMaximumStudy force;
  force.frequency_hz = 35.0;
  force.converged = {2.0, 2.0};
  force.truncated = {1.6, 1.6};
  force.finite_element = 2.5;
  const auto file = data::find_case("uncertain");
  const auto budget =
      studies::amplitude_budget(limits, {force}, data::read_case(file), data::read_uncertainty(file), 200);
  const auto expect_change = [&](const std::string& cause, double fall, double rise) {
    const auto found = std::ranges::find(budget, cause, &studies::AmplitudeChange::cause);
    ASSERT_NE(found, budget.end()) << cause;
    EXPECT_NEAR(found->fall, fall, 1e-6) << cause;
    EXPECT_NEAR(found->rise, rise, 1e-6) << cause;
  };
  EXPECT_EQ(budget.size(), 12u);
  expect_change("finite elements", 0.2, 0.0);
  expect_change("truncation to the modes kept", 0.0, 0.25);
  expect_change("shear and rotary inertia", 0.5, 0.0);
  expect_change("axial force of fixed direction", 0.0, 0.25);
  expect_change("contact that yields", 0.0, 0.0);
  expect_change("damping", 0.0, 0.75);
  // The 5 % quantile of a normal distribution is 1.644854 standard deviations below the mean.
  const double spread = 1.644853627 * 0.05 / 0.6;
  expect_change("static friction coefficient μ_s", spread, spread);
  expect_change("all together", 1.0 - 0.8 * 0.5 * (1.0 - budget[2].fall),
                1.25 * 1.25 * 1.75 * (1.0 + budget[2].rise) - 1.0);
  // Together the inputs do at least as much as that, but for the scatter of a quantile of 200 samples.
  EXPECT_GT(budget[2].fall, 0.7 * spread);
  EXPECT_GT(budget[2].rise, 0.7 * spread);
}

STICKSLIP_VERIFIES(DimensionlessCase, "U5");
TEST(DimensionlessCase, OfThePaperHasItsGroups) {
  const auto groups = studies::dimensionless(data::load_case("damped"));
  EXPECT_EQ(groups.name, "damped");
  EXPECT_NEAR(groups.load, 500.0 * 4.0 / (2e9 * 0.1e-3 / 12.0) / 20.19, 1e-6);
  EXPECT_NEAR(groups.slenderness, 20.0 * std::sqrt(12.0), 1e-9);
  EXPECT_NEAR(groups.frequency, 25.0 / 24.97196, 1e-6);
  EXPECT_NEAR(groups.decay, 1e-3 * 50.0 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(groups.damping, 0.005, 3e-5);
  const data::Case strip = data::load_case("steel-strip");
  const double exact =
      analytic::StickResponse(strip.beam(), strip.excitation(), 100, analytic::SteadyPart::exact)
          .max_abs_friction_force(10.0)
          .midpoint();
  const double error = solver::max_abs_friction_force(with(strip, data::Damping())) / exact - 1.0;
  EXPECT_NEAR(studies::dimensionless(strip).force_error, std::abs(error), 1e-8);
  EXPECT_LE(studies::dimensionless(strip).unpredicted, 1.0);
}

}  // namespace
}  // namespace stickslip::testing
