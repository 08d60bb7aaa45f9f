// SPDX-License-Identifier: MIT
/// What the paper prints, as data: complete, consistent with its digits, and tied to the errata. Its verdicts are judged in
/// tests/paper.

#include "stickslip/data/paper.hpp"
#include "stickslip/data/case_file.hpp"
#include "support/claims.hpp"
#include "support/input_folder.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

STICKSLIP_VERIFIES(PrintedNumbers, "P3");
TEST(PrintedNumbers, CarryHalfAUnitOfTheLastDigit) {
  for (const auto& [id, value, half_digit, is_given] :
       std::vector<std::tuple<std::string, double, double, bool>>{
           {"frequency.stick.1", 25.0, 0.05, false},
           {"force_max.15", 40.38, 0.005, false},
           {"force_max.25", 3.03e4, 50.0, false},
           {"friction_limit", 300.0, 0.5, false},
           {"figure6.amplitude.increment", 0.01e-3, 0.005e-3, true},
           {"numerics.time_step", 1e-4, 0.5e-4, true},
           {"parameter.second_moment_of_area", 1e-6 / 12.0, 0.0, true}}) {
    const data::PrintedNumber number = data::printed_number(id);
    EXPECT_TRUE(within(number.value, value, round_off(4, 1, value))) << id;
    EXPECT_TRUE(within(number.half_digit, half_digit, round_off(4, 1, half_digit))) << id;
    EXPECT_EQ(number.is_given, is_given) << id;
  }
  const auto amplitude = data::printed_number("excitation.figure4.amplitude");
  EXPECT_EQ(amplitude.value, 0.5e-3);
  EXPECT_EQ(amplitude.unit + ", " + amplitude.printed + " " + amplitude.printed_unit, "m, 0.5 mm");
  EXPECT_EQ(data::printed_number("frequency.stick.1").printed_unit, "Hz");
  expect_error_message<std::out_of_range>([] { (void)data::printed_number("frequency.stick.4"); },
                                          {"no printed number has the id frequency.stick.4"});
}

TEST(PrintedNumbers, AreThoseOfTheCaseAndItsErrata) {
  const data::Case problem = data::load_case("paper");
  int compared = 0;
  for (const data::PrintedNumber& number : data::printed_numbers()) {
    const std::string name = number.id.substr(number.id.find('.') + 1);
    for (const std::string table : {"beam.", "friction.", "numerics.", "excitation."}) {
      const auto key = std::ranges::find(data::case_keys(), table + name, &data::Key::path);
      const bool is_input = number.id.starts_with("parameter.") || number.id.starts_with("numerics.") ||
                            number.id == "criterion.duration";
      if (!is_input || key == data::case_keys().end() || key->member.get == nullptr) continue;
      const double factor = name == "second_moment_of_area" ? 100.0 : 1.0;  // E1
      EXPECT_TRUE(within(factor * number.value, data::value_of(problem, key->path),
                         round_off(2, 1, number.value * factor)))
          << number.id;
      ++compared;
    }
  }
  EXPECT_EQ(compared, 13);
  const auto choices = unstated_choices();
  for (const std::string& choice :
       {data::shortest_text(problem.numerics.spectral_radius()), std::to_string(problem.numerics.elements())})
    EXPECT_EQ(std::ranges::count(choices, choice), 1) << choice;
}

STICKSLIP_VERIFIES(Errata, "V2");
TEST(Errata, AreNumberedFromE1AndNoneHolds) {
  const auto rows = errata();
  ASSERT_GE(rows.size(), 9U);
  std::set<std::string> ids{""};  // most numbers need none
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].id, "E" + std::to_string(i + 1));
    EXPECT_NE(rows[i].verdict, data::ClaimVerdict::holds) << rows[i].id;
    ids.insert(rows[i].id);
  }
  for (const auto& number : data::printed_numbers())
    EXPECT_TRUE(ids.contains(number.erratum)) << number.id << " " << number.erratum;
}

STICKSLIP_VERIFIES(Claims, "V3");
TEST(Claims, HaveUniqueIdsCorrectionsAndTheirErrata) {
  std::map<std::string, std::string_view> verdicts;
  for (const auto& erratum : errata()) verdicts[erratum.id] = to_string(erratum.verdict);
  std::set<std::string> ids, named;
  for (const auto& row : claims()) {
    EXPECT_TRUE(ids.insert(row.id).second) << row.id;
    EXPECT_EQ(row.correction.empty(), row.verdict == data::ClaimVerdict::holds) << row.id;
    if (row.erratum.empty()) continue;
    named.insert(row.erratum);
    EXPECT_EQ(verdicts[row.erratum], to_string(row.verdict)) << row.id << " names " << row.erratum;
  }
  EXPECT_GE(ids.size(), 60U);
  EXPECT_EQ(named.size(), verdicts.size());
}

// The numbers of a data folder of its own.
class PrintedNumbersFile : public ::testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_.path() / "paper");
    ::setenv("STICKSLIP_DATA", folder_.path().c_str(), 1);
  }
  void TearDown() override { ::unsetenv("STICKSLIP_DATA"); }

  static std::string number(const std::string& value, const std::string& printed,
                            const std::string& more = "") {
    return "[[number]]\nid = 'a'\nvalue = " + value + "\nunit = 'm'\nprinted = '" + printed +
           "'\ngiven = true\nplace = 'p'\nmeaning = 'm'\n" + more;
  }

  const InputFolder folder_;
};

STICKSLIP_VERIFIES(PrintedNumbersFile, "P3");
TEST_F(PrintedNumbersFile, MayNotContradictItself) {
  for (const auto& [text, part] : std::vector<std::pair<std::string, std::string>>{
           {number("2.5", "2.5"), "accepted"},
           {number("2.5", "2.500000000000002"), "accepted"},  // to four roundings of 2.2e-16
           {number("2.5", "2.500000000000003"), ": a has the value 2.5, but its printed digits give 2.5"},
           {number("2.5", "2.6"), ": a has the value 2.5, but its printed digits give 2.6"},
           {number("2.5", "2.5", "scale = 1e-3\n"), "printed digits give 0.0025"},
           {number("2.5", "2.5") + number("3", "3"), "the id a stands twice"},
           {number("2.5", "two"), "a part of printed is 'two', but must be a number"},
           {number("2.5", "2.5 m"), "a part of printed is '2.5 m'"},
           {number("2.5", "(5/two)"), "a part of printed is 'two'"},
           {number("2.5", "2.5 x 10^y"), "a part of printed is 'y'"},
           {number("2.5", "2.5x10^0"),
            "printed is '2.5x10^0' (a string), but must be a number as in 3.03 x 10^4"},
           {number("2.5", "(2.5)"),
            "printed is '(2.5)' (a string), but must be a number, or a fraction in brackets"},
           {number("nan", "2.5"), "value is nan (a float), but must be a finite number"},
           {"[[number]]\nid = 'a'\nvalue = 2\n", "unit is missing, but must be a string that is not empty"},
           {"[[number]]\nid = ''\n", "id is '' (a string), but must be a string that is not empty"},
           {number("2.5", "2.5", "eratum = 'E1'\n"), "unknown key eratum (did you mean erratum?)"},
           {"[number]\nid = 'a'\n", "must hold tables [[number]]"},
           {"number = [1]\n", "must hold tables [[number]]"}}) {
    folder_.write("paper/printed-numbers.toml", text);
    EXPECT_TRUE(holds(folder_.error_message([] { (void)data::printed_numbers(); }), part));
  }
}

}  // namespace
}  // namespace stickslip::testing
