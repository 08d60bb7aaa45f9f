// SPDX-License-Identifier: MIT
/// What takes minutes: data sets that are made again, and a fine mesh against the undamped histories.

#include <cstdlib>

#include "comparison/comparison.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/common/parallel.hpp"
#include "studies/verification/claimed_domain.hpp"
#include "support/published_data.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

STICKSLIP_VERIFIES(PublishedDataLong, "P6");
TEST(PublishedDataLong, IsWhatTheCodeMakes) {
  const data::ReferencePackage package = data::load_reference();
  for (const reference::Recipe& recipe : reference::recipes())
    if (!recipe.is_quick)
      expect_same_data(data::read_table(package, std::string(recipe.name)), recipe.make());
}

STICKSLIP_VERIFIES(ClaimedDomain, "X22");
TEST(ClaimedDomain, IsWhatTheCodeMakes) {
  // With STICKSLIP_WRITE_DOMAIN=1 the file is made anew.
  const auto file = studies::domain_file();
  std::vector<studies::DomainCase> cases(2 * studies::domain_cases + studies::domain_corners);
  studies::in_parallel(cases.size(), [&](std::size_t i) {
    cases[i] = studies::domain_case(data::load_case("paper"), static_cast<int>(i) + 1);
  });
  if (std::getenv("STICKSLIP_WRITE_DOMAIN") != nullptr) data::write_text(file, studies::domain_text(cases));
  const std::vector<studies::DomainCase> kept = studies::read_domain(file);
  ASSERT_EQ(kept.size(), cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) EXPECT_NO_THROW(studies::require_same(kept[i], cases[i]));
}

class ComparedUndampedLong : public ::testing::TestWithParam<int> {};

STICKSLIP_VERIFIES(ComparedUndampedLong, "X20");
TEST_P(ComparedUndampedLong, FineMeshAgrees) {
  // 160 elements at omega_max h = 2.4: the error, of the mesh, is empirical: 0.38, 0.003 and 0.32 % of the
  // range of the tip at 25, 35 and 70 Hz.
  const data::ReferencePackage package = data::load_reference();
  const std::string set = "undamped-history-" + std::to_string(GetParam());
  const data::ReferenceTable table = data::read_table(package, set);
  data::NumericalChoices choices = paper_choices(0.5);
  choices.elements = 160;
  choices.spectral_radius = 0.0;
  choices.time_step = 1.5625e-7;
  solver::BeamSimulation run(with(paper_problem(GetParam(), 1e-3), data::NumericalSettings(choices)),
                             {.coordinates = solver::Coordinates::modal});
  data::UserTable mine{.file = "mesh",
                       .columns = {table.column("time"), table.column("tip_displacement"),
                                   table.column("midspan_displacement")},
                       .lines = std::vector<std::size_t>(table.rows())};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const long steps = solver::step_count(mine.columns[0].values[row], choices.time_step);
    for (long n = solver::step_count(run.integrator().time(), choices.time_step); n < steps; ++n)
      run.integrator().step();
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
