// SPDX-License-Identifier: MIT
/// With what the program ends, by the kind of the exception: what the user can mend, and what not.

#include <new>

#include "map_part.hpp"
#include "program.hpp"
#include "stickslip/data/case_file.hpp"
#include "support/input_folder.hpp"
#include "support/testing.hpp"

namespace stickslip::cli {
namespace {

template <class Error>
std::string told_after(const Error& error, int status) {
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(exit_status_of([&]() -> int { throw error; }), status);
  return ::testing::internal::GetCapturedStderr();
}

STICKSLIP_VERIFIES(ExitStatus, "U2");
TEST(ExitStatus, IsTwoForWhatTheUserCanMend) {
  EXPECT_EQ(told_after(data::FieldError("beam.length", -2.0, "above 0"), 2),
            "stickslip: beam.length is -2, but must be above 0\n");
  EXPECT_EQ(told_after(data::OutputError("a.csv cannot be written"), 2),
            "stickslip: a.csv cannot be written\n");
  const std::string longest(2000, 'a');
  EXPECT_EQ(told_after(data::InputError(longest), 2), "stickslip: " + longest + "\n");
  EXPECT_EQ(told_after(data::InputError(longest + "a"), 2), "stickslip: " + longest + "...\n");
}

TEST(ExitStatus, IsOneForAMistakeOfTheProgram) {
  const std::string sentence =
      "stickslip: this is a mistake in stickslip itself, not in the input: index 7\n";
  EXPECT_EQ(told_after(std::logic_error("index 7"), 1), sentence);
  EXPECT_EQ(told_after(std::invalid_argument("index 7"), 1), sentence);
}

TEST(ExitStatus, IsOneWhereARunFails) {
  EXPECT_EQ(told_after(std::runtime_error("no convergence"), 1), "stickslip: no convergence\n");
  EXPECT_EQ(told_after(std::bad_alloc(), 1), "stickslip: the memory does not suffice for this problem\n");
}

// A map of which one evaluation is kept when the work throws.
template <class Error>
bool keeps_its_file(const Error& error) {
  const testing::InputFolder folder;
  const std::filesystem::path file = folder.path() / "map.csv.partial";
  const studies::MapTask task{.problem = data::load_case("paper"),
                              .x = studies::map_axis("excitation.frequency_hz", 1.0, 2.0, 2, false),
                              .y = studies::map_axis("beam.length", 1.0, 2.0, 2, false)};
  studies::MapEvaluations evaluations(studies::evaluation_count(task)), found(evaluations.size());
  evaluations[0] = studies::MapEvaluation{.unit_force = {}, .state = analytic::Verdict::stick};
  {
    UnfinishedMap unfinished(file, task, MapPart(), evaluations);
    EXPECT_THROW(unfinished.remove_if_impossible([&] {
      unfinished.keep(std::array<std::size_t, 1>{0});
      throw error;
    }),
                 Error);
  }
  if (!std::filesystem::exists(file)) return false;
  EXPECT_EQ(UnfinishedMap(file, task, MapPart(), found).found(), 1u);
  return true;
}

STICKSLIP_VERIFIES(UnfinishedMap, "U10");
TEST(UnfinishedMap, SurvivesAllButAnErrorInTheInput) {
  EXPECT_TRUE(keeps_its_file(std::logic_error("a mistake of our own")));
  EXPECT_TRUE(keeps_its_file(std::runtime_error("a run that fails")));
  EXPECT_TRUE(keeps_its_file(data::OutputError("a full disk")));
  EXPECT_FALSE(keeps_its_file(data::InputError("a map that cannot be")));
}

}  // namespace
}  // namespace stickslip::cli
