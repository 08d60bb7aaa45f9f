// SPDX-License-Identifier: MIT
/// Full disks, folders that cannot be written, pipes that close, programs that are missing, signals and runs
/// that diverge: a clear sentence, the right exit status, and no file that is not whole.

#include <signal.h>
#include <chrono>

#include "support/signalled_run.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

namespace fs = std::filesystem;

// One sentence that names the file.
void expect_failure(const Outcome& outcome, int status, const std::string& name, const std::string& reason) {
  EXPECT_EQ(outcome.status, status) << outcome.errors;
  EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1) << outcome.errors;
  EXPECT_TRUE(holds(outcome.errors, name));
  EXPECT_TRUE(holds(outcome.errors, reason));
}

class Fault : public SignalledRun {
 protected:
  static inline const std::string history =
      "respond paper --hz 25 --amplitude 1e-3 --duration 0.3";  // 400 kB
};

STICKSLIP_VERIFIES(Fault, "U12");
// A limit of 4 kB for each file stands for the disk.
TEST_F(Fault, DiskThatIsFullIsNamedAndLeavesTheOldFiles) {
  const auto limited = [&](const std::string& arguments) {
    return shell("ulimit -f 4; '" STICKSLIP_PROGRAM "' " + arguments);
  };
  std::ofstream("old.csv") << "old";
  expect_failure(limited(history + " --output old.csv"), 2, "old.csv", "File too large");
  EXPECT_EQ(contents("old.csv"), "old");
  expect_failure(limited("map paper --x frequency=1:50:50 --y amplitude=1e-4:1e-3:5 --output map.csv"), 2,
                 "map.csv", "File too large");
  expect_failure(limited("reference export stick-history --output table.csv"), 2, "table.csv",
                 "File too large");
  // What the map has finished is kept for the next run.
  EXPECT_EQ(all_files("."), (std::vector<std::string>{"map.csv.partial", "old.csv", "stderr", "stdout"}));
  expect_failure(limited("report --quiet --only fig2 --output report"), 2, "friction_curve.json",
                 "File too large");
  expect_failure(limited("animate --duration 0.1 --frames 5 --output film"), 2, "motion.csv",
                 "File too large");
  EXPECT_EQ(all_files("report"), std::vector<std::string>{});
  EXPECT_EQ(all_files("film"), std::vector<std::string>{});
}

TEST_F(Fault, StandardOutputThatIsFullIsNamed) {
  for (const std::string& arguments :
       std::vector<std::string>{"criterion --hz 10", "modes --count 1", "cases", "reference list",
                                "reference export stick-frequencies", "--help", "respond --duration 0.01",
                                "map --x frequency=1:9:3 --y amplitude=1e-4:1e-3:2"}) {
    const Outcome outcome = shell("'" STICKSLIP_PROGRAM "' " + arguments + " >/dev/full");
    expect_failure(outcome, 2, "standard output", "cannot be written");
  }
}

TEST_F(Fault, StandardErrorThatIsFullOrClosedChangesNothing) {
  std::ofstream("mine.csv") << "beam,mode,frequency\npaper,1,25\n";
  for (const std::string& arguments : std::vector<std::string>{
           "criterion nosuch", "--nosuch", "criterion --output out.csv", "compare stick-frequencies mine.csv",
           "respond --hz 2000 --duration 0.01 --output out.csv", "new out.toml --ask --quiet </dev/null"}) {
    const auto ended = [&](const std::string& errors) {
      const int status = run(arguments + errors).status;
      return std::pair(status, contents("out.csv"));
    };
    const auto usual = ended("");
    EXPECT_EQ(ended(" 2>/dev/full"), usual) << arguments;
    EXPECT_EQ(ended(" 2>&-"), usual) << arguments;
  }
}

// Each thread asks for 8 MB of addresses.
TEST_F(Fault, ThreadsThatCannotBeStartedAreDoneWithout) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "a sanitizer needs more addresses";
#endif
  const std::string map = "map --x length=1.9:2:20 --y force=400:500:20 --duration 0.1 --output - --threads ";
  const Outcome few = shell("ulimit -v 400000; '" STICKSLIP_PROGRAM "' " + map + "300");
  EXPECT_EQ(few.status, 0) << few.errors;
  EXPECT_EQ(few.output, run(map + "1").output);
}

// A file that is opened then has the number 0.
TEST_F(Fault, StandardInputThatIsClosedIsNoFault) {
  const Outcome outcome =
      shell("'" STICKSLIP_PROGRAM "' reference export stick-frequencies --output table.csv <&-");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_TRUE(holds(contents("table.csv"), "mode,"));
}

// A folder below a file can be written by nobody, root included.
TEST_F(Fault, FolderThatCannotBeWrittenIsNamedAtOnce) {
  std::ofstream("obstacle") << "in the way";
  for (const std::string& command : std::vector<std::string>{
           "respond --duration 1e5 --output ", "respond --duration 1e5 --output new.csv --events ",
           "map --method fe --x frequency=1:9:2000 --y length=1:2:2000 --output ",
           "animate --duration 1e5 --frames 5 --output ", "report --output ",
           "reference export stick-frequencies --output "}) {
    const Outcome outcome = run(command + "obstacle/below");
    expect_failure(outcome, 2, "obstacle", "Not a directory");
  }
  EXPECT_EQ(all_files("."), (std::vector<std::string>{"obstacle", "stderr", "stdout"}));
}

// As any other tool: the shell sees 141, a person nothing.
TEST_F(Fault, PipeThatClosesEndsTheProgramWithoutAWord) {
  const Outcome outcome = shell("{ '" STICKSLIP_PROGRAM "' " + history + "; echo $? >status; } | head -n 1");
  EXPECT_EQ(contents("status"), "141\n");
  EXPECT_EQ(outcome.errors, "");
  EXPECT_TRUE(outcome.output.starts_with("# Motion of the tip")) << outcome.output;
}

TEST_F(Fault, ProgramThatIsMissingCostsWhatItDrawsAlone) {
  const auto without_tools = [&](const std::string& arguments) {
    return shell("PATH=nothing '" STICKSLIP_PROGRAM "' " + arguments);
  };
  expect_failure(without_tools("report --quiet --only fig2 --output drawings"), 1, path("drawings"),
                 "gnuplot is not installed or not on the search path");
  EXPECT_EQ(all_files("drawings"),
            (std::vector<std::string>{"fig2-values.csv", "fig2.csv", "studies/friction_curve.json"}));
}

// At once: the histories would take hours.
TEST_F(Fault, GnuplotThatIsMissingIsToldBeforeTheWork) {
  ASSERT_EQ(run("reference export stick-frequencies --output mine.csv").status, 0);
  for (const std::string& command : std::vector<std::string>{
           "respond --duration 1e5 --output out.csv --figure out.png", "criterion --figure out.png",
           "compare stick-frequencies mine.csv --json out.json --figure out.png",
           "animate --duration 1e5 --frames 5 --output out"})
    expect_failure(shell("PATH=nothing '" STICKSLIP_PROGRAM "' " + command), 1, "gnuplot",
                   "is not installed or not on the search path");
  EXPECT_EQ(all_files("."), (std::vector<std::string>{"mine.csv", "stderr", "stdout"}));
  expect_failure(shell("TMPDIR=/nowhere '" STICKSLIP_PROGRAM "' criterion --figure out.png"), 1,
                 "the temporary folder /nowhere/stickslip-", "No such file or directory");
}

TEST_F(Fault, CtrlCEndsLongWorkAtOnceAndSaysHowFarItCame) {
  struct Work {
    std::string arguments, beginning, end;
  };
  const std::string output = " --output history.csv",
                    others = " --events events.csv --spectrum spectrum.csv --figure history.png";
  for (const auto& [arguments, beginning, end] : std::vector<Work>{
           {"respond --duration 1e5 --every 200" + output + others, "interrupted at ",
            " s of 1e+05 s; nothing is kept\n"},
           {"respond --method event-driven --duration 300" + output, "interrupted at ",
            " s of 300 s; nothing is kept\n"},
           {"respond --duration 1e5", "interrupted at ",
            "standard output holds the history up to there at most\n"},
           {"map --method fe --set damping.kelvin_voigt=1e-5 --duration 1e4 --x length=1:2:2" + output,
            "interrupted; no evaluation is kept", "\n"},
           {"criterion --set excitation.duration=2e4 --figure curve.png",
            "interrupted before there was a result", "\n"},
           {"periodic reed --settle 100000", "interrupted after 0 ", "% of the work; nothing is kept\n"},
           {"squeal reed --settle 100000 --map map.csv --speeds 0.1:1 --ratios 0.01:0.02 --figure map.png",
            "interrupted after 0 ", "% of the work; nothing is kept\n"},
           {"sweep --settle 1000000" + output + " --figure sweep.png", "interrupted after 0 ",
            "% of the work; nothing is kept\n"},
           {"design paper --band 1:100 --duration 1e4", "interrupted after ",
            " % of the work; nothing is kept\n"},
           {"report --only fig12 --output out", "interrupted after ",
            " % of the report; what is finished is in " + path("out") + "\n"},
           {"uncertainty --samples 100000000", "interrupted after ", " % of the work; nothing is kept\n"}}) {
    const Ending ending = signalled(arguments, SIGINT, std::chrono::milliseconds(150));
    EXPECT_EQ(ending.status, 130) << arguments;
    EXPECT_LT(ending.seconds, 1.0) << arguments;
    EXPECT_TRUE(ending.errors.starts_with("stickslip: " + beginning)) << ending.errors;
    EXPECT_TRUE(ending.errors.ends_with(end)) << ending.errors;
    EXPECT_EQ(std::ranges::count(ending.errors, '\n'), 1) << ending.errors;
  }
  EXPECT_EQ(all_files("."), (std::vector<std::string>{"stderr", "stdout"}));
}

TEST_F(Fault, RunThatFailsSaysWhenAndLeavesTheOldFile) {
  std::ofstream("old.csv") << "old";
  const Outcome outcome =
      run("respond --duration 0.1 --hz 25 --amplitude 1e-3 --set friction.decay=1e4 --output old.csv");
  expect_failure(outcome, 1, "at t = 0.0552467 s", "the friction law falls faster than a step can follow");
  EXPECT_EQ(contents("old.csv"), "old");
  EXPECT_EQ(all_files("."), (std::vector<std::string>{"old.csv", "stderr", "stdout"}));
}

STICKSLIP_VERIFIES(KilledRun, "U12");
TEST_F(KilledRun, OfRespondLeavesOnlyWhatIsWhole) {
  kill(8,
       "respond paper --hz 25 --amplitude 1e-3 --duration 0.3 --output out/history.csv --events "
       "out/events.csv",
       {"history.csv", "events.csv"});
}

// --- Ctrl-C while a figure is drawn: the end within a second, one sentence about what is there, no file that is not whole, and no other program left behind.

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

// The two commands of the README in a folder "tree", with programs that do nothing in place of those that install, build and test.
class Scripts : public Drawing {
 protected:
  void SetUp() override {
    Drawing::SetUp();
    for (const std::string tool : {"cmake", "apt-get", "ctest"}) install_tool(tool, "");
    install_tool("dpkg-query", "echo installed\n");
    for (const fs::path file : {".ci/setup.sh", "verification/run", "reports/generate"}) {
      fs::create_directories(("tree" / file).parent_path());
      fs::copy_file(STICKSLIP_SOURCE_DIRECTORY / file, "tree" / file);
    }
  }

  void expect_refused_in(const std::string& tree, const std::string& reason) const {
    for (const std::string script : {"/verification/run", "/reports/generate --quick"})
      expect_failure(shell("'" + tree + "'" + script), 2, tree, reason);
  }
};

STICKSLIP_VERIFIES(Scripts, "U12");
TEST_F(Scripts, AskGitOfTheirOwnTreeAlone) {
  if (shell("git --version").status != 0) GTEST_SKIP() << "git is not installed";
  const std::string commit = "git init -q && git add . && git -c user.name=a -c user.email=a commit -qm x ";
  ASSERT_EQ(shell(commit + "&& git config core.fsmonitor 'touch " + path("executed") + "; false'").status, 0);
  EXPECT_EQ(shell("tree/verification/run --label unit").errors, "");
  EXPECT_EQ(contents("tree/build/release/test-results/commit"), "unknown\n");
  EXPECT_FALSE(fs::exists("executed"));
  const std::string own = shell("cd tree && { " + commit + "; } && git rev-parse --short=12 HEAD").output;
  EXPECT_EQ(shell("tree/verification/run").status, 0);
  EXPECT_EQ(contents("tree/build/release/test-results/commit"), own);
}

TEST_F(Scripts, WaitForAnotherRunInTheirBuildFolder) {
  install_tool("cmake", "echo second >>" + path("order") + "\n");
  EXPECT_EQ(shell("mkdir -p tree/build/release; exec 9>>tree/build/release/.lock; flock 9\n"
                  "tree/verification/run >said 9>&- & for i in $(seq 200); do grep -qs waits said && break; "
                  "sleep 0.05; done; echo first >>order; exec 9>&-; wait; grep -q waits said")
                .status,
            0);
  EXPECT_TRUE(contents("order").starts_with("first\nsecond\n"));
}

TEST_F(Scripts, RefuseAPlaceThatCannotBeBuilt) {
  EXPECT_TRUE(holds(shell("tree/reports/generate --quick extra").errors, "unknown argument 'extra'"));
  std::ofstream("tree/build") << "in the way";
  expect_refused_in("tree", "cannot be written");
  fs::remove("tree/build");
  fs::create_directories("tree/build/release");
  std::ofstream("tree/build/release/CMakeCache.txt") << "CMAKE_HOME_DIRECTORY:INTERNAL=/elsewhere\n";
  expect_refused_in("tree", "rm -r");
  std::string old = "tree";
  for (const std::string name : {"a\"", "a#", "a;", "a\\", "a["}) {
    fs::rename(std::exchange(old, name), name);
    expect_refused_in(name, "must hold none of them");
  }
}

}  // namespace
}  // namespace stickslip::testing
