// SPDX-License-Identifier: MIT
/// The same input gives the same bytes: twice, in any locale, on standard output and in files.

#include <locale>

#include "render/csv_table.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/user_table.hpp"
#include "support/command_line.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

namespace fs = std::filesystem;

class Reproducible : public CommandLine {
 protected:
  static inline const std::vector<std::string> commands{
      "cases",
      "modes paper --state stick --count 3",
      "modes paper --state slip --count 3 --json",
      "criterion paper",
      "criterion steel-strip --hz 30 --json",
      "respond paper --hz 25 --amplitude 1e-3 --duration 0.05",
      "respond paper --method event-driven --hz 25 --amplitude 1e-3 --duration 0.05",
      "respond paper --method closed-form --duration 0.05",
      "map paper --x frequency=1:50:10 --y amplitude=1e-4:1e-3:3",
      "map paper --method fe --x frequency=24:26:2 --y amplitude=1e-4:1e-3:3 --set excitation.duration=0.1",
      "uncertainty uncertain --samples 100 --json",
      "reference list",
      "reference show stick-frequencies",
      "reference export stick-frequencies"};
};

STICKSLIP_VERIFIES(Reproducible, "U13");
TEST_F(Reproducible, CommandsSayTheSameTwice) {
  for (const std::string& command : commands) {
    const Outcome first = run(command), second = run(command);
    ASSERT_EQ(first.status, 0) << first.errors;
    EXPECT_EQ(first.output, second.output) << command;
  }
}

// The drawings of gnuplot, a PDF among them, which would say when it was made.
TEST_F(Reproducible, FiguresDoNotSayWhenTheyWereMade) {
  const auto figures = [&](const std::string& folder) {
    EXPECT_EQ(run("report --quiet --only fig2 --output '" + folder + "'").status, 0);
    return folder;
  };
  const fs::path first = figures("first"), second = figures("second");
  for (const char* name : {"fig2.csv", "fig2-values.csv", "fig2.png", "fig2.pdf"}) {
    EXPECT_FALSE(contents(first / name).empty()) << name;
    EXPECT_TRUE(contents(first / name) == contents(second / name)) << name;
  }
  EXPECT_EQ(contents(first / "fig2.pdf").find("/CreationDate"), std::string::npos);
}

// A decimal comma and points between thousands, whatever locales are installed.
class Comma : public std::numpunct<char> {
  [[nodiscard]] char do_decimal_point() const override { return ','; }
  [[nodiscard]] char do_thousands_sep() const override { return '.'; }
  [[nodiscard]] std::string do_grouping() const override { return "\3"; }
};

class LocaleWithAComma : public CommandLine {
 protected:
  void SetUp() override {
    CommandLine::SetUp();
    previous_ = std::locale::global(std::locale(std::locale::classic(), new Comma));
  }
  void TearDown() override {
    std::locale::global(previous_);
    CommandLine::TearDown();
  }

 private:
  std::locale previous_;
};

STICKSLIP_VERIFIES(LocaleWithAComma, "U13");
TEST_F(LocaleWithAComma, ChangesNothingThatIsReadOrWritten) {
  const data::Case paper =
      data::load_case("paper", {{"beam.length", "1234.5"}, {"numerics.elements", "1234"}});
  EXPECT_EQ(paper.beam.length(), 1234.5);
  EXPECT_EQ(paper.numerics.elements(), 1234);
  EXPECT_EQ(data::shortest_text(1234.5), "1234.5");
  report::CsvTable table("A table", "x [m]");
  table.add_numbers({1234.5});
  EXPECT_TRUE(table.text().ends_with("1234.5\n")) << table.text();

  const auto reference = data::read_table(data::load_reference(), "stick-frequencies");
  std::ofstream("mine.csv", std::ios::binary) << reference.csv;
  const data::UserTable mine = data::read_user_table("mine.csv", reference);
  EXPECT_EQ(mine.column("frequency")->values, reference.column("frequency").values);
}

TEST_F(LocaleWithAComma, RefusesWithTheSameSentence) {
  const auto sentence = [](const std::string& key, const std::string& value) {
    return error_message_of<data::InputError>([&] { (void)data::load_case("paper", {{key, value}}); });
  };
  for (const auto& [key, value] : std::vector<std::pair<std::string, std::string>>{
           {"beam.length", "-1234.5"}, {"numerics.elements", "1234567"}, {"numerics.modes", "1234.5"}}) {
    const std::string here = sentence(key, value);
    const std::locale comma = std::locale::global(std::locale::classic());
    EXPECT_EQ(here, sentence(key, value));
    std::locale::global(comma);
    EXPECT_NE(here, "");
  }
}

}  // namespace
}  // namespace stickslip::testing
