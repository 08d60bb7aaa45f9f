// SPDX-License-Identifier: MIT
/// Files of the report appear whole or not at all, and what is asked for is known before anything is
/// computed.

#include "render/document.hpp"
#include "render/drawing.hpp"
#include "render/output_folder.hpp"
#include "render/report.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "support/command_line.hpp"
#include "support/input_folder.hpp"
#include "support/testing.hpp"

namespace stickslip {
namespace {

namespace fs = std::filesystem;

class ReportOutput : public ::testing::Test {
 protected:
  const testing::InputFolder temporary_;
  const fs::path folder_ = temporary_.path() / "output";
};

STICKSLIP_VERIFIES(ReportOutput, "U3");
TEST_F(ReportOutput, HoldsWhatIsPublishedAlone) {
  const auto files = [&] { return std::distance(fs::directory_iterator(folder_), fs::directory_iterator{}); };
  fs::create_directories(folder_ / ".stickslip-unfinished");  // of an interrupted run
  data::write_text(folder_ / ".stickslip-unfinished" / "stale", "x");
  {
    report::OutputFolder output(folder_);
    EXPECT_TRUE(fs::is_empty(output.scratch()));
    output.write("a.csv", "1,2\n");
    data::write_text(output.scratch() / "a.pdf", "half");
    EXPECT_FALSE(fs::exists(folder_ / "a.pdf"));
    output.publish(output.scratch() / "a.pdf");
    EXPECT_EQ(data::read_text(folder_ / "a.pdf"), "half");
    fs::create_directory(output.scratch() / "a.csv");  // in the way of the new one
    EXPECT_THROW(output.write("a.csv", "new"), std::runtime_error);
  }
  EXPECT_EQ(data::read_text(folder_ / "a.csv"), "1,2\n");
  EXPECT_EQ(files(), 2);
  fs::create_directories(folder_ / "a" / "in the way");
  EXPECT_THROW(data::write_text(folder_ / "a", "text"), std::runtime_error);
  EXPECT_EQ(files(), 3);
}

TEST_F(ReportOutput, BelongsToOneReportAtATime) {
  {
    const report::OutputFolder output(folder_);
    EXPECT_THROW(const report::OutputFolder second(folder_), data::InputError);
  }
  fs::remove_all(folder_);
  data::write_text(folder_, "a file");
  EXPECT_THROW(const report::OutputFolder output(folder_), data::InputError);
}

// Figures of a copy of the templates; the drawings are those of gnuplot.
class DrawnFigures : public ReportOutput {
 protected:
  void SetUp() override {
    ReportOutput::SetUp();
    fs::create_directories(folder_);
    fs::copy(report::templates_directory(), templates_, fs::copy_options::recursive);
    ::setenv("STICKSLIP_REPORTS", templates_.c_str(), 1);
    draw();
  }
  void TearDown() override {
    ::unsetenv("STICKSLIP_REPORTS");
    ReportOutput::TearDown();
  }

  void draw() const {
    report::write_report({.output = output_, .only = {"fig1"}, .quiet = true, .version = "", .commit = ""});
  }

  const fs::path templates_ = folder_ / "templates", output_ = folder_ / "output";
};

STICKSLIP_VERIFIES(DrawnTitles, "U3");
// Drawn by gnuplot itself, whatever its user has it do at its start.
TEST(DrawnTitles, AreThoseThatAreAskedFor) {
  const testing::InputFolder home;
  data::write_text(home.path() / ".gnuplot", "print 'hello'\nset label 1 'mine' at screen 0.5,0.5\n");
  const std::string old = std::getenv("HOME");
  ::setenv("HOME", home.path().c_str(), 1);
  for (const auto& [title, drawn] : std::vector<std::pair<std::string, std::string>>{
           {"'quoted' beam", "'quoted' beam"},
           {"the '' beam", "the '' beam"},
           {"a^\\", "a^\\ "},
           {"\"`echo no`\" \\n @a $x", "\"`echo no`\" \\n @a $x"}}) {
    const std::string svg = report::drawing_of("modes", {.format = "svg", .title = title},
                                               {{"modes.csv", "# t\n# units\nx,mode_1\n0,0\n1,1\n2,1\n"}});
    EXPECT_TRUE(testing::holds(svg, ">" + drawn + "<"));
    EXPECT_EQ(svg.find("mine"), std::string::npos);
  }
  ::setenv("HOME", old.c_str(), 1);
}

// gnuplot ends a text of a CSV file there, quoted or not.
TEST(DrawnTitles, HaveNoCommaInATable) {
  for (const std::string text : {"base, wall", "a \"base\""})
    EXPECT_THROW((void)report::values_table({{"label", 0.0, "-", text}}), std::logic_error) << text;
}

STICKSLIP_VERIFIES(DrawnFigures, "U3");
TEST_F(DrawnFigures, AppearInAllFormatsOrInNone) {
  for (const char* name : {"fig1.png", "fig1.pdf"}) data::write_text(output_ / name, "old");
  const fs::path script = templates_ / "figures" / "fig1.gp";
  data::write_text(script, data::read_text(script) + "if (format eq 'png') exit error 'no colours'\n");
  EXPECT_THROW(draw(), std::runtime_error);
  for (const char* name : {"fig1.png", "fig1.pdf"}) EXPECT_EQ(data::read_text(output_ / name), "old");
}

TEST_F(DrawnFigures, ComeFromScriptsAndTables) {
  const fs::path tables = folder_ / "tables", drawing = tables / "fig1.png";
  fs::create_directory(tables);
  for (const auto& file : fs::directory_iterator(output_))
    if (file.path().extension() == ".csv") fs::copy(file.path(), tables);
  const std::string command =
      fmt::format("cd '{}' && LC_ALL=C.UTF-8 gnuplot -e \"folder='{}/'; format='png'; output='{}'\" fig1.gp",
                  (templates_ / "figures").string(), tables.string(), drawing.string());
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  EXPECT_EQ(data::read_text(drawing), data::read_text(output_ / "fig1.png"));
}

STICKSLIP_VERIFIES(ReportFigures, "U3");
TEST(ReportFigures, HaveAScriptEach) {
  std::set<std::string> names;
  for (const std::string& name : report::figure_names()) {
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_TRUE(fs::exists(report::templates_directory() / "figures" / (name + ".gp"))) << name;
  }
}

TEST(ReportFigures, NameOnlyTheSlidingThatOccurs) {
  const auto names = [](const std::string& first, const std::string& second) {
    const std::string text = report::drawing_of(
        "squeal", {.format = "svg"},
        {{"squeal.csv", "speed,damping_ratio,growth,state\n1,0," + first + ",-\n2,0," + first + ",-\n\n1,1," +
                            second + ",-\n2,1," + second + ",-\n\n"}});
    std::string found;
    for (const std::string name : {"steady", "squeal", "limit of stability"})
      if (text.find(">" + name + "</tspan>") != std::string::npos) found += name + ", ";
    return found;
  };
  EXPECT_EQ(names("-1", "-2"), "steady, ");
  EXPECT_EQ(names("1", "2"), "squeal, ");
  EXPECT_EQ(names("1", "-1"), "steady, squeal, limit of stability, ");
}

// LaTeX that is missing, or cannot typeset the report: a sentence that says so, and every file that was there.
class Typesetting : public testing::Drawing {
 protected:
  /// What is said of a report whose folder holds a figure and an older PDF, both of which stay.
  [[nodiscard]] std::string complaint() const {
    report::OutputFolder output(folder());
    output.write("fig2.png", "figure");
    output.write("vv-report.pdf", "old");
    const std::string sentence =
        testing::error_message_of<std::runtime_error>([&] { report::typeset(output.scratch(), output); });
    EXPECT_EQ(testing::contents(folder() + "/fig2.png"), "figure");
    EXPECT_EQ(testing::contents(folder() + "/vv-report.pdf"), "old");
    return sentence;
  }

  [[nodiscard]] std::string folder() const {
    return std::filesystem::canonical(path("")).string() + "/report";
  }
};

STICKSLIP_VERIFIES(Typesetting, "U12");
TEST_F(Typesetting, SaysThatLatexIsMissing) {
  ::setenv("PATH", path("tools").c_str(), 1);
  EXPECT_EQ(
      complaint(),
      "lualatex is not installed or not on the search path, so that there is no PDF report; the figures "
      "are in " +
          folder());
}

TEST_F(Typesetting, SaysWhatLatexLacks) {
  install_tool("lualatex",
               "printf \"! LaTeX Error: File \\`lmodern.sty' not found.\\n\\n\" >vv-report.log\nexit 1\n");
  EXPECT_EQ(complaint(),
            "lualatex could not typeset the report (status 1): LaTeX Error: File `lmodern.sty' not found. ");
}

}  // namespace
}  // namespace stickslip
