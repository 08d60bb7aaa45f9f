// SPDX-License-Identifier: MIT
/// The same input gives the same bytes: twice, in any locale, on standard output and in files.

#include <locale>

#include "support/command_line.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

// A decimal comma and points between thousands, whatever locales are installed.
class Comma : public std::numpunct<char> {
  [[nodiscard]] char do_decimal_point() const override { return ','; }
  [[nodiscard]] char do_thousands_sep() const override { return '.'; }
  [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

class Reproducible : public CommandLine {
 protected:
  [[nodiscard]] Outcome here(const std::string& command) const {
    std::istringstream words(command);
    return run_here({std::istream_iterator<std::string>(words), {}});
  }
};

STICKSLIP_VERIFIES(Reproducible, "U13");
TEST_F(Reproducible, CommandsInAnyLocale) {
  std::ofstream("mine.csv") << "beam,mode,frequency [kHz]\npaper,1,0.02497196\npaper,9,1234.5\n";
  for (const std::string command :
       {"cases", "modes paper --state stick --count 9", "modes paper --state slip --count 3 --json",
        "criterion paper", "criterion steel-strip --hz 30 --json",
        "respond paper --hz 25 --amplitude 1e-3 --duration 0.05",
        "respond paper --method event-driven --hz 25 --amplitude 1e-3 --duration 0.05",
        "respond paper --method closed-form --duration 0.05",
        "map paper --x frequency=1:50:10 --y amplitude=1e-4:1e-3:3",
        "map paper --method fe --x frequency=24:26:2 --y amplitude=1e-4:1e-3:3 --set excitation.duration=0.1",
        "uncertainty uncertain --samples 100 --json", "reference list", "reference show stick-frequencies",
        "reference export stick-frequencies", "compare stick-frequencies mine.csv --rows 1,9",
        "criterion --set beam.length=-1234.5", "criterion --set numerics.elements=1234567",
        "criterion --set numerics.modes=1234.5", "modes --set numerics.elements=1234"}) {
    const Outcome first = here(command);
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
    const Outcome second = here(command);
    std::locale::global(before);
    EXPECT_EQ(first.status, second.status) << command;
    EXPECT_EQ(first.output, second.output) << command;
    EXPECT_EQ(first.errors, second.errors) << command;
    EXPECT_NE(first.output + first.errors, "") << command;
  }
}

// The drawings of gnuplot, a PDF among them, which would say when it was made.
TEST_F(Reproducible, FiguresDoNotSayWhenTheyWereMade) {
  for (const std::string folder : {"first", "second"})
    EXPECT_EQ(run("report --quiet --only fig2 --output " + folder).status, 0);
  for (const std::string name : {"fig2.csv", "fig2-values.csv", "fig2.png", "fig2.pdf"}) {
    EXPECT_FALSE(contents("first/" + name).empty()) << name;
    EXPECT_TRUE(contents("first/" + name) == contents("second/" + name)) << name;
  }
  EXPECT_EQ(contents("first/fig2.pdf").find("/CreationDate"), std::string::npos);
}

}  // namespace
}  // namespace stickslip::testing
