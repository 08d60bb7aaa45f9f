// SPDX-License-Identifier: MIT
/// Full disks, folders that cannot be written, pipes that close, programs that are missing, signals and runs
/// that diverge: a clear sentence, the right exit status, and no file that is not whole.

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

// A command in a shell, and what its one sentence says.
struct Failure {
  std::string before, arguments, name, reason;
  int status = 2;
  std::vector<std::string> left{};  // files that are new
};

class Fault : public SignalledRun {
 protected:
  static inline const std::string history =
      "respond paper --hz 25 --amplitude 1e-3 --duration 0.3";  // 400 kB
};

// A limit of 4 kB for each file stands for the disk. A folder below a file can be written by nobody, root included. What would take
// hours ends at once.
const std::string full = "ulimit -f 4;", no_tools = "PATH=nothing", too_large = "File too large",
                  obstacle = "Not a directory", endless = "respond --duration 1e5 --output ",
                  no_gnuplot = "gnuplot is not installed or not on the search path";
const std::vector<Failure> failures{
    {full, "respond paper --duration 0.3 --output old.csv", "old.csv", too_large},
    {full, "map paper --x frequency=1:50:50 --y amplitude=1e-4:1e-3:5 --output map.csv", "map.csv",
     too_large},
    {full, "reference export stick-history --output table.csv", "table.csv", too_large},
    {full, "report --quiet --only fig2 --output new", "friction_curve.json", too_large},
    {full, "animate --duration 0.1 --frames 5 --output new", "motion.csv", too_large},
    {"", endless + "old.csv/new", "old.csv", obstacle},
    {"", endless + "new.csv --events old.csv/new", "old.csv", obstacle},
    {"", "map --method fe --x frequency=1:9:2000 --y length=1:2:2000 --output old.csv/new", "old.csv",
     obstacle},
    {"", "animate --duration 1e5 --frames 5 --output old.csv/new", "old.csv", obstacle},
    {"", "report --output old.csv/new", "old.csv", obstacle},
    {"", "reference export stick-frequencies --output old.csv/new", "old.csv", obstacle},
    {no_tools, endless + "new.csv --figure new.png", "stickslip", no_gnuplot, 1},
    {no_tools, "criterion --figure new.png", "stickslip", no_gnuplot, 1},
    {no_tools, "compare stick-frequencies old.csv --json new.json --figure new.png", "stickslip", no_gnuplot,
     1},
    {no_tools, "animate --duration 1e5 --frames 5 --output new", "stickslip", no_gnuplot, 1},
    {no_tools,
     "report --quiet --only fig2 --output new",
     "/new",
     no_gnuplot,
     1,
     {"new/fig2-values.csv", "new/fig2.csv", "new/studies/friction_curve.json"}},
    {"TMPDIR=/nowhere", "criterion --figure new.png", "the temporary folder /nowhere/", "No such file", 1},
    {"", "respond --hz 25 --amplitude 1e-3 --set friction.decay=1e4 --output old.csv", "at t = 0.05",
     "the friction law", 1}};

STICKSLIP_VERIFIES(Fault, "U12");
TEST_F(Fault, IsNamedAndLeavesTheOldFiles) {
  std::ofstream("old.csv") << "old";
  for (const auto& [before, arguments, name, reason, status, left] : failures) {
    SCOPED_TRACE(before + " " + arguments);
    expect_failure(shell(before + " '" STICKSLIP_PROGRAM "' " + arguments), status, name, reason);
    std::vector<std::string> files{"old.csv", "stderr", "stdout"};
    files.insert(files.begin(), left.begin(), left.end());
    EXPECT_EQ(all_files("."), files);
    EXPECT_EQ(contents("old.csv"), "old");
    for (const std::string& file : left) fs::remove(file);
  }
}

TEST_F(Fault, StandardOutputThatIsFullIsNamed) {
  for (const std::string arguments :
       {"criterion --hz 10", "modes --count 1", "cases", "reference list",
        "reference export stick-frequencies", "--help", "respond --duration 0.01",
        "map --x frequency=1:9:3 --y amplitude=1e-4:1e-3:2"})
    expect_failure(run(arguments + " >/dev/full"), 2, "standard output", "cannot be written");
}

TEST_F(Fault, OfStandardErrorChangesNothing) {
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
TEST_F(Fault, OfThreadsIsDoneWithout) {
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

// As any other tool: the shell sees 141, a person nothing.
TEST_F(Fault, OfAClosedPipeIsSilent) {
  const Outcome outcome = shell("{ '" STICKSLIP_PROGRAM "' " + history + "; echo $? >status; } | head -n 1");
  EXPECT_EQ(contents("status"), "141\n");
  EXPECT_EQ(outcome.errors, "");
  EXPECT_TRUE(outcome.output.starts_with("# Motion of the contact")) << outcome.output;
}

// The sentence behind the bar, which is erased.
TEST_F(Fault, CtrlCEndsLongWorkAndSaysHowFarItCame) {
  const std::string output = " --output history.csv", kept = " of the work; nothing is kept",
                    others = " --events events.csv --spectrum spectrum.csv --figure history.png";
  for (const auto& [arguments, beginning, end] : std::vector<std::array<std::string, 3>>{
           {"respond --duration 1e5 --every 200" + output + others, "at ", " s of 1e+05 s; nothing is kept"},
           {"respond --method event-driven --duration 300" + output, "at ", " s of 300 s; nothing is kept"},
           {"respond --duration 1e5 >stdout", "at ", "standard output holds the history up to there at most"},
           {"map --method fe --duration 3 --x frequency=10:50:9 --y length=1:2:10 --output /dev/null",
            "after ", kept},
           {"periodic reed --settle 100000", "after 0 %", kept},
           {"squeal reed --settle 100000 --map map.csv --speeds 0.1:1 --ratios 0.01:0.02", "after 0 %", kept},
           {"sweep --settle 5000" + output + " --figure sweep.png", "after ", kept},
           {"design paper --band 1:100 --duration 1e4", "after ", kept},
           {"report --only fig12 --output out", "after ",
            " of the report; what is finished is in " + path("out")},
           {"uncertainty --samples 100000000", "after ", kept}}) {
    const auto ended = on_terminal(arguments, " %");
    if (!ended) GTEST_SKIP() << "the system gives no pseudo-terminal";
    EXPECT_EQ(ended->status, 130) << arguments;
    const std::size_t sentence = ended->output.find("\r\033[Kstickslip: interrupted");
    ASSERT_NE(sentence, std::string::npos) << ended->output;
    const std::string said = ended->output.substr(sentence);
    EXPECT_EQ(std::ranges::count(said, '\n'), 1) << said;
    EXPECT_TRUE(said.find(beginning) != std::string::npos && said.ends_with(end + "\r\n")) << said;
  }
  fs::remove("stdout");
  EXPECT_EQ(all_files("."), std::vector<std::string>{});
}

STICKSLIP_VERIFIES(KilledRun, "U12");
TEST_F(KilledRun, LeavesOnlyWhatIsWhole) {
  kill("respond --hz 25 --amplitude 1e-3 --duration 0.01 --output out/history.csv --events out/events.csv",
       {"events.csv", "history.csv"});
}

// A figure that is drawn when a signal comes, to all that works, as on a terminal, or to the program alone: one sentence about what is
// there, which is what a gnuplot that fails leaves, and no other program left behind.
struct Drawn {
  std::string arguments, sentence;
  std::vector<std::string> left;
};

class Interrupted : public SignalledRun {};

STICKSLIP_VERIFIES(Interrupted, "U12");
TEST_F(Interrupted, DrawingLeavesWhatIsWritten) {
  const std::string map = "map paper --x frequency=1:9:3 --y amplitude=1e-4:1e-3:2 ",
                    files = "--output out/map.csv --figure out/map.png",
                    written = "interrupted; nothing is written but ";
  ASSERT_EQ(run("reference export stick-frequencies --output mine.csv").status, 0);
  ASSERT_EQ(run(map + "--output whole").status, 0);
  for (const auto& [arguments, sentence, left] : std::vector<Drawn>{
           {"criterion --figure out/curve.png", "interrupted before there was a result", {}},
           {"report --only fig2 --output out",
            "interrupted after 33 % of the report; what is finished is in " + path("out"),
            {"fig2-values.csv", "fig2.csv", "studies/friction_curve.json"}},
           {"animate --duration 0.1 --frames 5 --output out",
            "interrupted; no frame is kept; the motion is in " + path("out/motion.csv"),
            {"motion.csv"}},
           {"compare stick-frequencies mine.csv --figure out/verdict.png --json out/verdict.json",
            written + "standard output and out/verdict.json",
            {"verdict.json"}},
           {map + files, written + "out/map.csv", {"map.csv"}},
           {"map --from whole --figure out/map.png", "interrupted before there was a result", {}},
           {"respond --duration 0.1 --events out/events.csv --output out/history.csv --figure "
            "out/history.png",
            written + "out/history.csv and out/events.csv",
            {"events.csv", "history.csv"}}}) {
    SCOPED_TRACE(arguments);
    fs::remove_all("out");
    fs::create_directory("out");
    install_tool("gnuplot", "exit 1\n");
    EXPECT_EQ(run(arguments).status, 1);
    const Contents whole = contents_of("out");
    for (const int signal : {SIGHUP, SIGINT, SIGTERM}) {
      fs::remove_all("out");
      fs::create_directory("out");
      EXPECT_EQ(said_after(signal, signal != SIGINT, "gnuplot", arguments), sentence + "\n");
      EXPECT_EQ(all_files("out"), left);
      EXPECT_TRUE(contents_of("out") == whole);
    }
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
