// SPDX-License-Identifier: MIT
/// What the paper prints, as data: complete, consistent with its digits, and tied to the errata.

#include "stickslip/data/paper.hpp"
#include "stickslip/data/case_file.hpp"
#include "support/claims.hpp"
#include "support/input_folder.hpp"
#include "support/testing.hpp"

namespace stickslip {
namespace {

STICKSLIP_VERIFIES(PrintedNumbers, "P3");
TEST(PrintedNumbers, CarryHalfAUnitOfTheirLastDigitInSi) {
  for (const auto& [id, expected] : {std::pair{"frequency.stick.1", 0.05},
                                     {"force_max.15", 0.005},
                                     {"force_max.25", 50.0},
                                     {"friction_limit", 0.5},
                                     {"figure6.amplitude.increment", 0.005e-3},
                                     {"numerics.time_step", 0.5e-4}})
    EXPECT_TRUE(testing::within(data::printed_number(id).half_digit, expected,
                                testing::round_off(4.0, 1.0, expected)))
        << id;
}

TEST(PrintedNumbers, AFractionIsExact) {
  const auto number = data::printed_number("parameter.second_moment_of_area");
  EXPECT_EQ(number.half_digit, 0.0);
  EXPECT_EQ(number.value, 1e-6 / 12.0);
}

TEST(PrintedNumbers, AreInSiWithThePagesDigitsAndUnit) {
  const auto amplitude = data::printed_number("excitation.figure4.amplitude");
  EXPECT_EQ(amplitude.value, 0.5e-3);
  EXPECT_EQ(amplitude.unit, "m");
  EXPECT_EQ(amplitude.printed, "0.5");
  EXPECT_EQ(amplitude.printed_unit, "mm");
  EXPECT_EQ(data::printed_number("frequency.stick.1").printed_unit, "Hz");
}

TEST(PrintedNumbers, TellGivenInputsFromRoundedResults) {
  EXPECT_TRUE(data::printed_number("parameter.length").is_given);
  EXPECT_FALSE(data::printed_number("force_max.15").is_given);
}

TEST(PrintedNumbers, DifferFromTheCaseInSecondMomentOnly) {
  const auto problem = data::load_case("paper");
  const auto printed = [](const std::string& key) { return data::printed_number("parameter." + key).value; };
  EXPECT_EQ(printed("length"), problem.beam.length());
  EXPECT_EQ(printed("area"), problem.beam.area());
  EXPECT_TRUE(testing::within(100.0 * printed("second_moment_of_area"), problem.beam.second_moment_of_area(),
                              testing::round_off(2.0, 1.0, problem.beam.second_moment_of_area())));
  EXPECT_EQ(printed("density"), problem.beam.density());
  EXPECT_EQ(printed("youngs_modulus"), problem.beam.youngs_modulus());
  EXPECT_EQ(printed("axial_force"), problem.beam.axial_force());
  EXPECT_EQ(printed("static_coefficient"), problem.friction.static_coefficient());
  EXPECT_EQ(printed("kinetic_coefficient"), problem.friction.kinetic_coefficient());
  EXPECT_EQ(printed("decay"), problem.friction.decay());
  EXPECT_EQ(printed("velocity_threshold"), problem.numerics.velocity_threshold());
  EXPECT_EQ(data::printed_number("numerics.time_step").value, problem.numerics.time_step());
  EXPECT_EQ(data::printed_number("numerics.modes").value, problem.numerics.modes());
  EXPECT_EQ(data::printed_number("criterion.duration").value, problem.numerics.duration());
}

TEST(PrintedNumbers, ReferToErrataThatExist) {
  std::set<std::string> ids;
  for (const auto& erratum : testing::errata()) ids.insert(erratum.id);
  ids.insert("");  // most numbers need none
  for (const auto& number : data::printed_numbers())
    EXPECT_TRUE(ids.contains(number.erratum)) << number.id << " " << number.erratum;
}

TEST(PrintedNumbers, AnUnknownIdIsNamed) {
  EXPECT_EQ(testing::error_message_of<std::out_of_range>(
                [] { static_cast<void>(data::printed_number("frequency.stick.4")); }),
            "no printed number has the id frequency.stick.4");
}

STICKSLIP_VERIFIES(PrintedVerdicts, "P3");
TEST(PrintedVerdicts, AreTheEightOfFigures4And5) {
  const auto verdicts = data::printed_verdicts();
  ASSERT_EQ(verdicts.size(), 8U);
  std::set<std::string> sticking;
  for (const auto& row : verdicts) {
    EXPECT_EQ(row.amplitude, row.figure.starts_with('4') ? 0.5e-3 : 1e-3) << row.figure;
    EXPECT_TRUE(row.verdict == "stick" || row.verdict == "stick-slip") << row.verdict;
    if (row.verdict == "stick") sticking.insert(row.figure);
  }
  EXPECT_EQ(sticking, (std::set<std::string>{"4a", "4c", "5a"}));
  const double frequencies[] = {15.0, 25.0, 35.0, 70.0};
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_EQ(verdicts[i].frequency_hz, frequencies[i % 4]) << verdicts[i].figure;
}

STICKSLIP_VERIFIES(Errata, "V2");
TEST(Errata, AreNumberedFromE1WithoutAGapAndNoneHolds) {
  const auto rows = testing::errata();
  ASSERT_GE(rows.size(), 9U);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].id, std::string("E").append(std::to_string(i + 1)));
    EXPECT_NE(rows[i].verdict, data::ClaimVerdict::holds) << rows[i].id;
  }
}

STICKSLIP_VERIFIES(Unstated, "P3");
TEST(Unstated, NamesWhatTheCaseFileChose) {
  const auto listed = testing::unstated_choices();
  const std::set<std::string> choices(listed.begin(), listed.end());
  const auto problem = data::load_case("paper");
  EXPECT_TRUE(choices.contains(data::shortest_text(problem.numerics.spectral_radius())));
  EXPECT_TRUE(choices.contains(std::to_string(problem.numerics.elements())));
}

STICKSLIP_VERIFIES(Claims, "V3");
TEST(Claims, HaveUniqueIdsAndCorrections) {
  std::set<std::string> ids;
  for (const auto& row : testing::claims()) {
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_EQ(row.correction.empty(), row.verdict == data::ClaimVerdict::holds) << row.id;
  }
  EXPECT_GE(ids.size(), 60U);
}

TEST(Claims, NameEveryErratumAndHaveItsVerdict) {
  std::map<std::string, std::string_view> verdicts;
  for (const auto& erratum : testing::errata()) verdicts[erratum.id] = to_string(erratum.verdict);
  std::set<std::string> named;
  for (const auto& row : testing::claims()) {
    if (row.erratum.empty()) continue;
    named.insert(row.erratum);
    EXPECT_EQ(verdicts[row.erratum], to_string(row.verdict)) << row.id << " names " << row.erratum;
  }
  EXPECT_EQ(named.size(), verdicts.size());
}

// A data folder of its own.
class MalformedPaperFile : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_.path() / "paper");
    ::setenv("STICKSLIP_DATA", folder_.path().c_str(), 1);
  }
  void TearDown() override { ::unsetenv("STICKSLIP_DATA"); }

  [[nodiscard]] std::string error_message(const std::string& text) const {
    folder_.write("paper/printed-numbers.toml", text);
    return folder_.error_message([] { static_cast<void>(data::printed_numbers()); });
  }

  void expect_refused(const std::string& text, const std::string& part) const {
    const std::string sentence = error_message(text);
    EXPECT_TRUE(testing::holds(sentence, part));
  }

  static std::string number(const std::string& value, const std::string& printed,
                            const std::string& more = "") {
    return "[[number]]\nid = 'a'\nvalue = " + value + "\nunit = 'm'\nprinted = '" + printed +
           "'\ngiven = true\nplace = 'p'\nmeaning = 'm'\n" + more;
  }

 private:
  const testing::InputFolder folder_;
};

STICKSLIP_VERIFIES(MalformedPaperFile, "P3");
TEST_F(MalformedPaperFile, IsDerivedFromAWellFormedOne) {
  EXPECT_EQ(error_message(number("2.5", "2.5")), "accepted");
}

TEST_F(MalformedPaperFile, MayNotContradictThePrintedDigits) {
  expect_refused(number("2.5", "2.6"), "a has the value 2.5, but its printed digits give 2.6");
  expect_refused(number("2.5", "2.5", "scale = 1e-3\n"), "printed digits give 0.0025");
  // Four roundings of 2.2e-16 are allowed.
  EXPECT_EQ(error_message(number("2.5", "2.500000000000002")), "accepted");
  expect_refused(number("2.5", "2.500000000000003"), "a has the value 2.5, but its printed digits give 2.5");
}

TEST_F(MalformedPaperFile, MayNotNameAnIdTwice) {
  expect_refused(number("2.5", "2.5") + number("3", "3"), "the id a stands twice");
}

TEST_F(MalformedPaperFile, MayNotHaveUnreadableDigits) {
  for (const std::string printed : {"two", "2.5 m", "2.5x10^0", "(2.5)", "(5/two)", "2.5 x 10^y"})
    EXPECT_NE(error_message(number("2.5", printed)), "accepted") << printed;
  expect_refused(number("nan", "2.5"), "value is nan (a float), but must be a finite number");
}

TEST_F(MalformedPaperFile, MayNotLackOrAddAKey) {
  expect_refused("[[number]]\nid = 'a'\nvalue = 2\n", "must be");
  expect_refused(number("2.5", "2.5", "eratum = 'E1'\n"), "unknown key eratum (did you mean erratum?)");
  expect_refused("[[number]]\nid = ''\n", "id is '' (a string), but must be a string that is not empty");
  expect_refused("[number]\nid = 'a'\n", "must hold tables [[number]]");
  expect_refused("number = [1]\n", "must hold tables [[number]]");
}

}  // namespace
}  // namespace stickslip
