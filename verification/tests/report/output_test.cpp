/// Files of the report appear whole or not at all, and what is asked for is known before anything is
/// computed.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>

#include "stickslip/data/case_file.hpp"
#include "stickslip/report/output_folder.hpp"
#include "stickslip/report/report.hpp"
#include "stickslip/report/text_file.hpp"
#include "support/requirements.hpp"

namespace stickslip {
namespace {

namespace fs = std::filesystem;

class ReportOutput : public ::testing::Test {
 protected:
  void SetUp() override { fs::remove_all(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  const fs::path folder_ =
      fs::temp_directory_path() / ("stickslip-report-output-" + std::to_string(::getpid()));
};

STICKSLIP_VERIFIES(ReportOutput, "U3");
TEST_F(ReportOutput, WritesAFileUnderItsNameAndLeavesNothingElse) {
  {
    report::OutputFolder output(folder_);
    output.write("a.csv", "1,2\n");
  }
  EXPECT_EQ(report::read_text(folder_ / "a.csv"), "1,2\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator{}), 1);
}

TEST_F(ReportOutput, ShowsNothingOfAFileThatIsNotPublished) {
  report::OutputFolder output(folder_);
  report::write_text(output.scratch() / "a.pdf", "half");
  EXPECT_FALSE(fs::exists(folder_ / "a.pdf"));
  output.publish(output.scratch() / "a.pdf");
  EXPECT_EQ(report::read_text(folder_ / "a.pdf"), "half");
}

TEST_F(ReportOutput, KeepsTheOldFileWhenTheNewOneCannotBeWritten) {
  report::OutputFolder output(folder_);
  output.write("a.csv", "old");
  fs::create_directory(output.scratch() / "a.csv");  // in the way of the new one
  EXPECT_THROW(output.write("a.csv", "new"), std::runtime_error);
  EXPECT_EQ(report::read_text(folder_ / "a.csv"), "old");
}

TEST_F(ReportOutput, ClearsWhatAnInterruptedRunHasLeft) {
  fs::create_directories(folder_ / ".unfinished");
  report::write_text(folder_ / ".unfinished" / "stale", "x");
  const report::OutputFolder output(folder_);
  EXPECT_TRUE(fs::is_empty(output.scratch()));
}

TEST_F(ReportOutput, IsNotCurrentWhileItsFilesAreReplaced) {
  report::OutputFolder output(folder_);
  output.write("a.csv", "1,2\n");
  output.record("a", "made from this");
  EXPECT_TRUE(output.is_current("a", {"a.csv"}, "made from this"));
  EXPECT_FALSE(output.is_current("a", {"a.csv"}, "made from that"));
  EXPECT_FALSE(output.is_current("a", {"a.csv", "a.png"}, "made from this"));
  output.forget("a");
  EXPECT_FALSE(output.is_current("a", {"a.csv"}, "made from this"));
}

TEST_F(ReportOutput, KeepsTheOldRecordWhenTheNewOneCannotBeWritten) {
  report::OutputFolder output(folder_);
  output.record("a", "old");
  fs::create_directory(output.scratch() / "a");  // in the way of the new one
  EXPECT_THROW(output.record("a", "new"), std::runtime_error);
  EXPECT_EQ(report::read_text(folder_ / ".made" / "a"), "old");
}

TEST_F(ReportOutput, LeavesNothingOfATextThatCannotBePutInPlace) {
  fs::create_directories(folder_ / "a" / "in the way");
  EXPECT_THROW(report::replace_text(folder_ / "a", "text"), std::runtime_error);
  EXPECT_FALSE(fs::exists(folder_ / "a.unfinished"));
}

TEST_F(ReportOutput, BelongsToOneReportAtATime) {
  const report::OutputFolder output(folder_);
  EXPECT_THROW(const report::OutputFolder second(folder_), data::InputError);
}

TEST_F(ReportOutput, IsRefusedWhereAFileStands) {
  report::write_text(folder_, "a file");
  EXPECT_THROW(const report::OutputFolder output(folder_), data::InputError);
}

TEST_F(ReportOutput, RefusesAnUnknownFigureByNamingTheKnownOnes) {
  try {
    report::write_report(
        {.output = folder_, .only = {"fig9", "fig99"}, .quiet = true, .version = "", .commit = ""});
    FAIL() << "fig99 was accepted";
  } catch (const data::InputError& error) {
    const std::string sentence = error.what();
    EXPECT_NE(sentence.find("'fig99'"), std::string::npos) << sentence;
    for (const std::string& name : report::figure_names())
      EXPECT_NE(sentence.find(name), std::string::npos) << sentence;
  }
  EXPECT_FALSE(fs::exists(folder_));
}

TEST_F(ReportOutput, KeepsTheDataOfAFigureWhenGnuplotIsMissing) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", folder_.c_str(), 1);
  std::string sentence;
  try {
    report::write_report({.output = folder_, .only = {"fig7"}, .quiet = true, .version = "", .commit = ""});
  } catch (const std::runtime_error& error) {
    sentence = error.what();
  }
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_TRUE(sentence.starts_with("gnuplot is not installed")) << sentence;
  EXPECT_TRUE(fs::exists(folder_ / "fig7.csv"));
  EXPECT_FALSE(fs::exists(folder_ / "fig7.pdf"));
}

STICKSLIP_VERIFIES(ReportFigures, "U3");
TEST(ReportFigures, HaveAScriptEach) {
  for (const std::string& name : report::figure_names())
    EXPECT_TRUE(fs::exists(report::templates_directory() / "figures" / (name + ".gp"))) << name;
  for (const std::string script : {"animation.gp", "map.gp"})
    EXPECT_TRUE(fs::exists(report::templates_directory() / "figures" / script)) << script;
}

TEST(ReportFigures, HaveDifferentNames) {
  auto names = report::figure_names();
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

}  // namespace
}  // namespace stickslip
