// SPDX-License-Identifier: MIT
/// What takes minutes: finer grids and longer refinements of tests that run by default.

#include "comparison/comparison.hpp"
#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "studies/history/history_convergence.hpp"
#include "studies/verification/finite_element_contact_model.hpp"
#include "support/order.hpp"
#include "support/published_data.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

class EventDrivenBeamFiner : public ::testing::TestWithParam<double> {};

STICKSLIP_VERIFIES(EventDrivenBeamFiner, "X9");
TEST_P(EventDrivenBeamFiner, EventTimesConvergeWithTheFourthOrderOfTheMesh) {
  // 40 modes stand for the beam, off by 4e-10 s at 25 Hz.
  const data::Case problem = damped_problem(GetParam());
  const auto event_times = [](const analytic::ContactModel& model) {
    analytic::EventDriven run(model);
    run.advance_to(0.1);
    std::vector<double> times;
    for (const auto& event : run.events()) times.push_back(event.time);
    return times;
  };
  const auto exact = event_times(
      analytic::BeamContactModel(problem.beam, problem.friction, problem.excitation, problem.damping, 40)
          .model());
  ASSERT_EQ(exact.size(), GetParam() < 50.0 ? 5u : 23u);
  std::vector<double> lengths, errors;
  for (const int elements : {10, 14, 20, 28, 40}) {
    const auto times = event_times(studies::finite_element_contact_model(problem, elements));
    ASSERT_EQ(times.size(), exact.size()) << elements;
    lengths.push_back(2.0 / elements);
    errors.push_back(studies::largest_difference(times, exact));
  }
  // The next term is (beta l)^2/10 or so of the first, for mode 4 with beta L = 13.35.
  EXPECT_TRUE(order_is(
      order_levels(
          lengths, errors, [](double length) { return std::pow(13.35 / 2.0 * length, 2) / 10.0; }, 4e-10),
      4.0));
}

INSTANTIATE_TEST_SUITE_P(Hz, EventDrivenBeamFiner, ::testing::Values(25.0, 70.0), NameOfDouble());

struct GridRun {
  int elements{};
  double time_step{}, duration{};
  data::Damping damping;
};

// Steps a run at spectral radius 1 and checks it as it goes; what it throws is for the caller.
void expect_bounded(const GridRun& grid) {
  data::NumericalChoices c = paper_choices(grid.duration);
  c.elements = grid.elements;
  c.spectral_radius = 1.0;
  c.time_step = grid.time_step;
  solver::BeamSimulation s(paper_beam(), paper_friction(), data::HarmonicExcitation({25.0, 1e-3}),
                           data::NumericalSettings(c), {.damping = grid.damping});
  solver::EnergyRecorder recorder(s.integrator());
  s.observe([&recorder](const solver::StickSlipIntegrator& now) { recorder.record(now); });
  // Resonance in the stick state builds up energy until the tip slips; later the energy stays near that value. A
  // step of 1 ms, a third of the second mode's period over 2 pi, may be off by its (omega h)^2/12 = 2 %, and
  // notices the onset up to a fortieth of a period late.
  double energy_at_first_slip = 0.0;
  for (long n = solver::step_count(grid.duration, grid.time_step); n > 0; --n) {
    s.step();
    const solver::EnergyBalance& balance = recorder.balance();
    if (energy_at_first_slip == 0.0 && !s.integrator().events().empty())
      energy_at_first_slip = balance.energy();
    ASSERT_LT(std::abs(s.tip_displacement()), 7e-3) << s.time();
    if (energy_at_first_slip > 0.0) {
      ASSERT_LT(balance.energy(), 1.5 * energy_at_first_slip) << s.time();
    }
  }
  EXPECT_GT(energy_at_first_slip, 0.0);
  EXPECT_LT(std::abs(recorder.balance().residual()),
            (grid.time_step > 5e-4 ? 0.03 : 0.003) * recorder.balance().base_work);
}

STICKSLIP_VERIFIES(StickSlipBeamLong, "X10");
TEST(StickSlipBeamLong, StaysBoundedOrSaysWhyItStops) {
  for (const data::Damping& damping : {data::Damping(), light_damping()})
    for (const int elements : {5, 10, 20, 40, 80, 160})
      for (const auto& [time_step, duration] :
           {std::pair{1e-3, 0.5}, {1e-4, 0.3}, {1e-5, 0.2}, {1e-6, 0.12}}) {
        SCOPED_TRACE(::testing::Message()
                     << elements << " elements, " << time_step << " s, " << damping.kelvin_voigt());
        try {
          expect_bounded({elements, time_step, duration, damping});
        } catch (const std::runtime_error& error) {
          // Damped modes that relax within a step ring on at spectral radius 1 and shake the contact.
          EXPECT_NE(std::string(error.what()).find("the contact chatters"), std::string::npos)
              << error.what();
          EXPECT_TRUE(damping.kelvin_voigt() > 0.0 && elements == 160 && time_step == 1e-3) << error.what();
        }
      }
}

class HistoryConvergenceLong : public ::testing::TestWithParam<double> {};

STICKSLIP_VERIFIES(HistoryConvergenceLong, "X12");
// Empirical: the errors and their fall are measured, 0.96, 0.01 and 0.75 % of the range on 80 elements at 25,
// 35 and 70 Hz, and 3.3, 0.30 and 4.8 % on 20.
TEST_P(HistoryConvergenceLong, UndampedMeshesConvergeAtResolvedSteps) {
  const data::Case problem = paper_problem(GetParam(), 1e-3);
  const auto reference =
      studies::published_history(problem, fmt::format("undamped-history-{}", GetParam()), {.levels = 0});
  const auto filtered = studies::history_refinement(
      problem, reference, {"filtering step", studies::filtering_angle, 0.0, 0.0}, {10, 20, 40, 80}, 40);
  for (const auto& run : filtered.runs) {
    EXPECT_LT(run.growth_bound, 31.0);
    if (run.elements <= 40) {
      EXPECT_LT(run.observed_growth.value(), run.growth_bound);
    }
  }
  EXPECT_LT(filtered.runs[3].error, 0.015);
  EXPECT_LT(filtered.runs[3].error, filtered.runs[1].error / 2.0);
  const auto resolved = studies::history_run(problem, reference, 20, 1.2e-6, 0.9, true);
  EXPECT_LT(resolved.observed_growth.value(), resolved.growth_bound);
}

INSTANTIATE_TEST_SUITE_P(Hz, HistoryConvergenceLong, ::testing::Values(25.0, 35.0, 70.0), NameOfDouble());

STICKSLIP_VERIFIES(PublishedDataLong, "P6");
TEST(PublishedDataLong, IsWhatTheCodeMakes) {
  const data::ReferencePackage package = data::load_reference();
  for (const reference::Recipe& recipe : reference::recipes())
    if (!recipe.is_quick)
      expect_same_data(data::read_table(package, std::string(recipe.name)), recipe.make());
}

class ComparedUndampedLong : public ::testing::TestWithParam<int> {};

STICKSLIP_VERIFIES(ComparedUndampedLong, "X20");
TEST_P(ComparedUndampedLong, FineMeshWithSpectralRadiusZeroAgrees) {
  // 160 elements at omega_max h = 2.4: the error, of the mesh, is empirical: 0.38, 0.003 and 0.32 % of the
  // range of the tip at 25, 35 and 70 Hz.
  const data::ReferencePackage package = data::load_reference();
  const std::string set = "undamped-history-" + std::to_string(GetParam());
  const data::ReferenceTable table = data::read_table(package, set);
  data::NumericalChoices choices = paper_choices(0.5);
  choices.elements = 160;
  choices.spectral_radius = 0.0;
  choices.time_step = 1.5625e-7;
  solver::BeamSimulation run(paper_beam(), paper_friction(),
                             data::HarmonicExcitation({static_cast<double>(GetParam()), 1e-3}),
                             data::NumericalSettings(choices), {.coordinates = solver::Coordinates::modal});
  data::UserTable mine{.file = "mesh",
                       .columns = {table.column("time"), table.column("tip_displacement"),
                                   table.column("midspan_displacement")},
                       .lines = std::vector<std::size_t>(table.rows())};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const long steps = solver::step_count(mine.columns[0].values[row], choices.time_step);
    for (long n = solver::step_count(run.time(), choices.time_step); n < steps; ++n) run.step();
    mine.columns[1].values[row] = run.tip_displacement();
    mine.columns[2].values[row] = run.midspan_displacement();
  }
  const auto comparison = comparison::compare(comparison::read_reference(package, set), mine);
  EXPECT_EQ(comparison.quantities.size(), 2u);
  for (const auto& quantity : comparison.quantities) {
    EXPECT_EQ(quantity.compared, 1001u);
    EXPECT_EQ(quantity.agreement, comparison::Agreement::agrees)
        << quantity.name << ": " << 100.0 * *quantity.error << " % at " << quantity.where;
  }
}

INSTANTIATE_TEST_SUITE_P(Hz, ComparedUndampedLong, ::testing::Values(25, 35, 70));

}  // namespace
}  // namespace stickslip::testing
