// SPDX-License-Identifier: MIT
/// Ctrl-C while a figure is drawn: the end within a second, one sentence about what is there, no file that is
/// not whole, and no other program left behind.

#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <string>
#include <vector>

#include "support/requirements.hpp"
#include "support/signalled_run.hpp"

namespace stickslip::testing {
namespace {

namespace fs = std::filesystem;

class Interrupted : public SleepingTool {};

STICKSLIP_VERIFIES(Interrupted, "U12");
TEST_F(Interrupted, ReportThatIsDrawnKeepsItsTables) {
  install_sleeper("gnuplot");
  EXPECT_EQ(said_after(SIGINT, "report --only fig2 --output out/"),
            "interrupted after 33 % of the report; what is finished is in " + path("out") + "\n");
  EXPECT_EQ(all_files("out/"),
            (std::vector<std::string>{"fig2-values.csv", "fig2.csv", "studies/friction_curve.json"}));
}

TEST_F(Interrupted, AnimationThatIsDrawnKeepsTheMotion) {
  install_sleeper("gnuplot");
  EXPECT_EQ(said_after(SIGTERM, "animate --duration 0.1 --frames 5 --output out/"),
            "interrupted after 0 % of the frames, none of which is kept; the motion is in " +
                path("out/motion.csv") + "\n");
  EXPECT_EQ(all_files("out/"), std::vector<std::string>{"motion.csv"});
}

TEST_F(Interrupted, ComparisonThatIsDrawnSaysWhatIsWritten) {
  install_sleeper("gnuplot");
  ASSERT_EQ(run("reference export stick-frequencies --output mine.csv").status, 0);
  fs::create_directory("out/");
  const std::string compare =
      "compare stick-frequencies mine.csv --figure out/verdict.png --json out/verdict.json ";
  EXPECT_EQ(said_after(SIGINT, compare),
            "interrupted; nothing is written but standard output and out/verdict.json\n");
  EXPECT_TRUE(holds(contents("stdout"), "frequency"));
  EXPECT_TRUE(nlohmann::json::accept(contents("out/verdict.json")));
  EXPECT_EQ(all_files("out/"), std::vector<std::string>{"verdict.json"});
}

TEST_F(Interrupted, MapThatIsDrawnIsWritten) {
  install_sleeper("gnuplot");
  fs::create_directory("out/");
  const std::string files = "--output out/map.csv --figure out/map.png";
  const std::string map = "map paper --x frequency=1:9:3 --y amplitude=1e-4:1e-3:2 ";
  const std::string is_written = "interrupted; nothing is written but out/map.csv\n";
  EXPECT_EQ(said_after(SIGINT, map + files), is_written);
  const std::string whole = contents("out/map.csv");
  EXPECT_EQ(whole, run(map).output);
  EXPECT_EQ(all_files("out/"), std::vector<std::string>{"map.csv"});

  ASSERT_EQ(run(map + "--shard 1/1 --output shard").status, 0);
  fs::remove("out/map.csv");
  EXPECT_EQ(said_after(SIGINT, "map --merge shard " + files), is_written);
  EXPECT_EQ(contents("out/map.csv"), whole);
  EXPECT_EQ(all_files("out/"), std::vector<std::string>{"map.csv"});
}

// By the end of a session, a scheduler or Ctrl-C, which reach this program alone where it has no terminal.
TEST_F(Interrupted, HistoryThatIsDrawnIsWrittenAndEndsGnuplot) {
  install_tool("gnuplot", "echo $$ >" + path("unfinished") + "; mv " + path("unfinished") + " " +
                              path("processes") + "; exec sleep 120\n");
  fs::create_directory("out/");
  const std::string files = "--events out/events.csv --output out/history.csv --figure out/history.png";
  for (const int signal : {SIGHUP, SIGTERM, SIGINT}) {
    EXPECT_EQ(said_after(signal, "respond --duration 0.1 " + files, true),
              "interrupted; nothing is written but out/history.csv and out/events.csv\n");
    EXPECT_EQ(all_files("out/"), (std::vector<std::string>{"events.csv", "history.csv"}));
  }
}

}  // namespace
}  // namespace stickslip::testing
