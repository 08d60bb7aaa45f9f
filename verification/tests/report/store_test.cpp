/// What a report keeps for the next one: results of studies, and what each figure was made from.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "stickslip/data/case_file.hpp"
#include "stickslip/report/report.hpp"
#include "stickslip/report/text_file.hpp"
#include "study_store.hpp"
#include "support/requirements.hpp"

namespace stickslip {
namespace {

namespace fs = std::filesystem;

enum class Colour { red, green };

struct Part {
  std::string name;
  std::vector<double> values;
};

struct Result {
  int count{};
  bool holds{};
  Colour colour{};
  double value{};
  std::optional<double> present, absent;
  std::string text;
  std::vector<Part> parts;
  Part part;
};

Result example() {
  return {.count = -7,
          .holds = true,
          .colour = Colour::green,
          .value = std::numeric_limits<double>::infinity(),
          .present = 0.1,
          .absent = std::nullopt,
          .text = std::string("a\0b", 3),
          .parts = {{"x", {1.0, -0.0}}, {"", {}}},
          .part = {"y", {5e-324}}};
}

class ReportStore : public ::testing::Test {
 protected:
  void SetUp() override { fs::remove_all(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  const fs::path folder_ =
      fs::temp_directory_path() / ("stickslip-report-store-" + std::to_string(::getpid()));
};

STICKSLIP_VERIFIES(ReportStore, "U3");
TEST_F(ReportStore, ReturnsEveryFieldOfAResultBitForBit) {
  const report::StudyStore store(folder_, "code");
  store.save("example", example());
  const auto loaded = store.load<Result>("example");
  ASSERT_TRUE(loaded.has_value());
  EXPECT_EQ(loaded->count, -7);
  EXPECT_TRUE(loaded->holds);
  EXPECT_EQ(loaded->colour, Colour::green);
  EXPECT_EQ(loaded->value, std::numeric_limits<double>::infinity());
  EXPECT_EQ(loaded->present, std::optional(0.1));
  EXPECT_EQ(loaded->absent, std::nullopt);
  EXPECT_EQ(loaded->text, std::string("a\0b", 3));
  ASSERT_EQ(loaded->parts.size(), 2U);
  EXPECT_EQ(loaded->parts[0].name, "x");
  EXPECT_EQ(loaded->parts[0].values, (std::vector<double>{1.0, 0.0}));
  EXPECT_TRUE(std::signbit(loaded->parts[0].values[1]));
  EXPECT_TRUE(loaded->parts[1].values.empty());
  EXPECT_EQ(loaded->part.values, std::vector<double>{5e-324});
}

TEST_F(ReportStore, ForgetsAResultOfOtherCode) {
  report::StudyStore(folder_, "old code").save("example", example());
  EXPECT_FALSE(report::StudyStore(folder_, "new code").load<Result>("example").has_value());
  EXPECT_FALSE(report::StudyStore(folder_, "old code").load<Result>("another").has_value());
}

TEST_F(ReportStore, ForgetsAResultThatIsCutShortOrTooLong) {
  const report::StudyStore store(folder_, "code");
  store.save("example", example());
  const std::string whole = report::read_text(folder_ / "example");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    report::write_text(folder_ / "example", whole.substr(0, size));
    EXPECT_FALSE(store.load<Result>("example").has_value()) << size << " bytes of " << whole.size();
  }
  report::write_text(folder_ / "example", whole + "x");
  EXPECT_FALSE(store.load<Result>("example").has_value());
}

TEST_F(ReportStore, KeepsNothingWithoutAFolder) {
  const report::StudyStore store("", "code");
  store.save("example", example());
  EXPECT_FALSE(store.load<Result>("example").has_value());
}

// Figures of a copy of the templates; the drawings are those of gnuplot.
class DrawnFigures : public ReportStore {
 protected:
  void SetUp() override {
    ReportStore::SetUp();
    fs::create_directories(folder_);
    fs::copy(report::templates_directory(), templates_, fs::copy_options::recursive);
    ::setenv("STICKSLIP_REPORTS", templates_.c_str(), 1);
    draw();
  }
  void TearDown() override {
    ::unsetenv("STICKSLIP_REPORTS");
    ReportStore::TearDown();
  }

  void draw() const {
    report::write_report(
        {.output = output_, .only = {"fig1", "fig2", "fig7"}, .quiet = true, .version = "", .commit = ""});
  }

  // Replaces each drawing by a word; true afterwards means that it was not drawn again.
  void mark() const {
    for (const char* name : {"fig1.png", "fig2.png", "fig7.png", "fig7.pdf"})
      report::write_text(output_ / name, "kept");
  }
  [[nodiscard]] bool is_kept(const std::string& name) const {
    return report::read_text(output_ / name) == "kept";
  }

  const fs::path templates_ = folder_ / "templates", output_ = folder_ / "output";
};

STICKSLIP_VERIFIES(DrawnFigures, "U3");
TEST_F(DrawnFigures, AreKeptWhenNothingHasChanged) {
  mark();
  draw();
  for (const char* name : {"fig1.png", "fig2.png", "fig7.png", "fig7.pdf"})
    EXPECT_TRUE(is_kept(name)) << name;
}

TEST_F(DrawnFigures, AreDrawnAgainOneByOneWhenTheirScriptChanges) {
  mark();
  const fs::path script = templates_ / "figures" / "fig7.gp";
  report::write_text(script, report::read_text(script) + "# a change\n");
  draw();
  EXPECT_TRUE(is_kept("fig1.png"));
  EXPECT_TRUE(is_kept("fig2.png"));
  EXPECT_FALSE(is_kept("fig7.png"));
  EXPECT_FALSE(is_kept("fig7.pdf"));
}

TEST_F(DrawnFigures, AreAllDrawnAgainWhenTheStyleChanges) {
  mark();
  const fs::path style = templates_ / "figures" / "style.gp";
  report::write_text(style, report::read_text(style) + "# a change\n");
  draw();
  for (const char* name : {"fig1.png", "fig2.png", "fig7.png"}) EXPECT_FALSE(is_kept(name)) << name;
}

TEST_F(DrawnFigures, AppearInAllFormatsOrInNone) {
  mark();
  const fs::path script = templates_ / "figures" / "fig7.gp";
  const std::string before = report::read_text(script);
  report::write_text(script, before + "if (format eq 'png') exit error 'no colours'\n");
  EXPECT_THROW(draw(), std::runtime_error);
  report::write_text(script, before);
  draw();
  EXPECT_TRUE(is_kept("fig7.pdf"));
  EXPECT_TRUE(is_kept("fig7.png"));
}

TEST_F(DrawnFigures, FollowTheCaseTheyAreDrawnFrom) {
  const fs::path data = folder_ / "data";
  fs::copy(data::data_directory(), data, fs::copy_options::recursive);
  const auto draw_with = [&](const std::string& before, const std::string& after) {
    const fs::path file = data / "cases" / "paper.toml";
    std::string text = report::read_text(file);
    ASSERT_NE(text.find(before), std::string::npos);
    report::write_text(file, text.replace(text.find(before), before.size(), after));
    mark();
    ::setenv("STICKSLIP_DATA", data.c_str(), 1);
    draw();
    ::unsetenv("STICKSLIP_DATA");
  };
  draw_with("static_coefficient = 0.6", "static_coefficient = 0.7");
  EXPECT_TRUE(is_kept("fig1.png"));
  EXPECT_FALSE(is_kept("fig2.png"));
  EXPECT_TRUE(is_kept("fig7.png")) << "mode shapes do not depend on friction";
  draw_with("youngs_modulus = 2.0e9", "youngs_modulus = 3.0e9");
  EXPECT_TRUE(is_kept("fig2.png"));
  EXPECT_FALSE(is_kept("fig7.png")) << "the study behind it must be repeated";
}

TEST_F(DrawnFigures, AreDrawnAgainWhenADrawingIsMissing) {
  mark();
  fs::remove(output_ / "fig2.pdf");
  draw();
  EXPECT_TRUE(is_kept("fig1.png"));
  EXPECT_FALSE(is_kept("fig2.png"));
}

TEST_F(DrawnFigures, ComeFromTheirScriptsAndCsvFilesAlone) {
  const fs::path tables = folder_ / "tables";
  fs::create_directory(tables);
  for (const auto& file : fs::directory_iterator(output_))
    if (file.path().extension() == ".csv") fs::copy(file.path(), tables);
  for (const std::string name : {"fig1", "fig2", "fig7"}) {
    const std::string drawing = (tables / (name + ".png")).string();
    const std::string command = "cd '" + (templates_ / "figures").string() +
                                "' && LC_ALL=C.UTF-8 gnuplot -e \"folder='" + tables.string() +
                                "/'; format='png'; output='" + drawing + "'\" " + name + ".gp";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    EXPECT_EQ(report::read_text(drawing), report::read_text(output_ / (name + ".png"))) << name;
  }
}

}  // namespace
}  // namespace stickslip
