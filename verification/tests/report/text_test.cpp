/// Numbers and words of the report as LaTeX and as CSV.

#include <gtest/gtest.h>

#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "latex_table.hpp"
#include "stickslip/report/csv_table.hpp"
#include "stickslip/report/latex_text.hpp"
#include "support/requirements.hpp"

namespace stickslip {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

STICKSLIP_VERIFIES(FixedNumber, "U4");
TEST(FixedNumber, HasItsDecimalsAndAMathematicalMinusSign) {
  EXPECT_EQ(report::fixed(0.5, 2), "0.50");
  EXPECT_EQ(report::fixed(-0.5, 2), "\\ensuremath{-0.50}");
  EXPECT_EQ(report::fixed(1999.5, 0), "2000");
}

TEST(FixedNumber, HasNoSignWhenItRoundsToZero) { EXPECT_EQ(report::fixed(-0.004, 2), "0.00"); }

STICKSLIP_VERIFIES(SignificantNumber, "U4");
TEST(SignificantNumber, KeepsTrailingZerosAndAllDigitsBeforeThePoint) {
  EXPECT_EQ(report::significant(0.012345, 3), "0.0123");
  EXPECT_EQ(report::significant(2.0, 3), "2.00");
  EXPECT_EQ(report::significant(30465.4, 3), "30465");
  EXPECT_EQ(report::significant(0.0, 3), "0");
}

TEST(SignificantNumber, DoesNotGainADigitByRoundingUp) {
  EXPECT_EQ(report::significant(0.09996, 3), "0.100");
  EXPECT_EQ(report::significant(9.996, 3), "10.0");
}

STICKSLIP_VERIFIES(ScientificNumber, "U4");
TEST(ScientificNumber, IsMantissaTimesPowerOfTen) {
  EXPECT_EQ(report::scientific(0.4276, 2), "\\ensuremath{4.3\\times10^{-1}}");
  EXPECT_EQ(report::scientific(-9.96e5, 2), "\\ensuremath{-1.0\\times10^{6}}");
  EXPECT_EQ(report::scientific(1e-4, 1), "\\ensuremath{1\\times10^{-4}}");
  EXPECT_EQ(report::scientific(0.0, 2), "0");
}

STICKSLIP_VERIFIES(ReportNumber, "U4");
TEST(ReportNumber, IsRefusedUnlessFinite) {
  for (const double value : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW((void)report::fixed(value, 2), std::invalid_argument);
    EXPECT_THROW((void)report::significant(value, 2), std::invalid_argument);
    EXPECT_THROW((void)report::scientific(value, 2), std::invalid_argument);
  }
}

STICKSLIP_VERIFIES(LatexEscape, "U4");
TEST(LatexEscape, CoversAllTenReservedCharacters) {
  EXPECT_EQ(report::escape("#$%&_{}"), "\\#\\$\\%\\&\\_\\{\\}");
  EXPECT_EQ(report::escape("a~b^c\\d"), "a\\textasciitilde{}b\\textasciicircum{}c\\textbackslash{}d");
  EXPECT_EQ(report::escape("plain text, 1.5"), "plain text, 1.5");
}

STICKSLIP_VERIFIES(LatexNotation, "U4");
TEST(LatexNotation, JoinsSubscripts) {
  EXPECT_EQ(report::typeset("T_n_tt"), "\\ensuremath{T_{n,\\mathrm{tt}}}");
}

TEST(LatexNotation, ReadsPowersOfTenInPrintedNumbers) {
  EXPECT_EQ(report::with_powers_of_ten("1e-05 s, -8.5e-16 and 3e+04"),
            "1 x 10^-5 s, -8.5 x 10^-16 and 3 x 10^4");
  EXPECT_EQ(report::with_powers_of_ten("0e+00 N"), "0 N");
  EXPECT_EQ(report::with_powers_of_ten("2e9e"), "2e9e");
}

TEST(LatexNotation, RaisesExponents) {
  EXPECT_EQ(report::typeset("10^-6 m^4"), "10\\ensuremath{^{-6}} m\\ensuremath{^{4}}");
}

TEST(LatexNotation, KnowsGreekLettersAndSubscripts) {
  EXPECT_EQ(report::typeset("omega_n^2 T_n"), "\\ensuremath{\\omega_{n}^{2}} \\ensuremath{T_{n}}");
  EXPECT_EQ(report::typeset("|f_max| <= mu_s P"),
            "|\\ensuremath{f_{\\max}}| \\ensuremath{\\le} \\ensuremath{\\mu_{s}} \\ensuremath{P}");
}

TEST(LatexNotation, TellsQuantitiesFromUnits) {
  EXPECT_EQ(report::typeset("P = 500 N"), "\\ensuremath{P} = 500 N");
  EXPECT_EQ(report::typeset("N = 10, N"), "\\ensuremath{N} = 10, N");
  EXPECT_EQ(report::typeset("u_t(x,0)"), "\\ensuremath{u_{t}(x,0)}");
  EXPECT_EQ(report::typeset("E I u'''"), "\\ensuremath{EI} \\ensuremath{u'''}");
}

TEST(LatexNotation, TurnsAnXBetweenNumbersIntoAProduct) {
  EXPECT_EQ(report::typeset("(1/12) x 10^-6"), "(1/12) \\ensuremath{\\times} 10\\ensuremath{^{-6}}");
  EXPECT_EQ(report::typeset("3 x 4"), "3 \\ensuremath{\\times} 4");
  EXPECT_EQ(report::typeset("a box 10 high"), "a box 10 high");
}

TEST(LatexNotation, LeavesProseAndEscapesTheRest) {
  EXPECT_EQ(report::typeset("Half of 5 % & more: E4, stick-slip"), "Half of 5 \\% \\& more: E4, stick-slip");
}

STICKSLIP_VERIFIES(CsvTable, "U3");
TEST(CsvTable, HasTitleUnitsNamesAndRows) {
  report::CsvTable table("Tip", {{"time_s", "s"}, {"tip_m", "m"}});
  table.add_numbers({0.1, -2e-7});
  EXPECT_EQ(table.text(), "# Tip\n# units: s,m\ntime_s,tip_m\n0.1,-2e-07\n");
}

TEST(CsvTable, EndsALineOfAGridWithAnEmptyLine) {
  report::CsvTable table("Map", {{"length_m", "m"}});
  table.add_numbers({1.0});
  table.end_grid_line();
  table.add_numbers({2.0});
  EXPECT_EQ(table.text(), "# Map\n# units: m\nlength_m\n1\n\n2\n");
}

TEST(CsvTable, WritesNumbersThatReadBackExactly) {
  for (const double value : {std::numbers::pi, 1.0 / 3.0, 2.2250738585072014e-308, -1.7976931348623157e308})
    EXPECT_EQ(std::stod(report::csv_number(value)), value);
  EXPECT_EQ(report::csv_number(std::nullopt), "");
}

TEST(CsvTable, IsTheSameWrittenCellByCell) {
  const std::vector<report::CsvColumn> columns{{"time_s", "s"}, {"tip_m", "m"}, {"state", "-"}};
  report::CsvTable rows("Tip", columns), cells("Tip", columns);
  const report::CsvText stick("stick");
  rows.add_row({"0.1", "", "stick"});
  cells.add(0.1).add(std::nullopt).add(stick).end_row();
  rows.add_row({"1e-05", "-2", "stick"});
  cells.add(1e-5).add(-2.0).add(stick).end_row();
  EXPECT_EQ(cells.text(), rows.text());
  EXPECT_THROW(cells.add(1.0).end_row(), std::invalid_argument);
  EXPECT_THROW(report::CsvText("a,b"), std::invalid_argument);
}

TEST(CsvTable, RefusesARowOfTheWrongLengthAndACellThatWouldSplit) {
  report::CsvTable table("Tip", {{"time_s", "s"}, {"tip_m", "m"}});
  EXPECT_THROW(table.add_numbers({1.0}), std::invalid_argument);
  EXPECT_THROW(table.add_row({std::string("a,b"), std::string("c")}), std::invalid_argument);
}

}  // namespace
}  // namespace stickslip
