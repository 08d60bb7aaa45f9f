// SPDX-License-Identifier: MIT
/// With what the program ends, by the kind of the exception: what the user can mend, and what not.

#include <new>

#include "program.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "support/testing.hpp"

namespace stickslip::cli {
namespace {

template <class Error>
std::string errors_after(const Error& error, int status) {
  ::testing::internal::CaptureStderr();
  EXPECT_EQ(exit_status_of([&]() -> int { throw error; }), status);
  return ::testing::internal::GetCapturedStderr();
}

STICKSLIP_VERIFIES(ExitStatus, "U2");
TEST(ExitStatus, IsTwoForWhatTheUserCanMend) {
  EXPECT_EQ(errors_after(data::FieldError("beam.length", -2.0, "above 0"), 2),
            "stickslip: beam.length is -2, but must be above 0\n");
  EXPECT_EQ(errors_after(data::OutputError("a.csv cannot be written"), 2),
            "stickslip: a.csv cannot be written\n");
  const std::string longest(2000, 'a');
  EXPECT_EQ(errors_after(data::InputError(longest), 2), "stickslip: " + longest + "\n");
  EXPECT_EQ(errors_after(data::InputError(longest + "a"), 2), "stickslip: " + longest + "...\n");
}

TEST(ExitStatus, IsOneForAMistakeOfTheProgram) {
  const std::string sentence =
      "stickslip: this is a mistake in stickslip itself, not in the input: index 7\n";
  EXPECT_EQ(errors_after(std::logic_error("index 7"), 1), sentence);
  EXPECT_EQ(errors_after(std::invalid_argument("index 7"), 1), sentence);
}

TEST(ExitStatus, IsOneWhereARunFails) {
  EXPECT_EQ(errors_after(std::runtime_error("no convergence"), 1), "stickslip: no convergence\n");
  EXPECT_EQ(errors_after(std::bad_alloc(), 1), "stickslip: the memory does not suffice for this problem\n");
}

}  // namespace
}  // namespace stickslip::cli
