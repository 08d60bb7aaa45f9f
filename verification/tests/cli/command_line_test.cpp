// SPDX-License-Identifier: MIT
/// The command line: exit status, streams and files. Refusals are in refusals_test.cpp, the texts of answers in text_is_json_test.cpp.

#include <sys/stat.h>
#include <nlohmann/json.hpp>

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/input_text.hpp"
#include "support/command_line.hpp"
#include "support/testing.hpp"
#include "support/vibration.hpp"

namespace stickslip::testing {
namespace {

STICKSLIP_VERIFIES(CommandLine, "U1");
TEST_F(CommandLine, TakesUnitsWhereverItTakesANumber) {
  for (const auto& [with_units, without] :
       {std::pair{"criterion --hz 0.025kHz --amplitude 0.2mm", "criterion --hz 25 --amplitude 2e-4"},
        {"criterion --set 'beam.density=1.2 g/cm3' --set 'beam.youngs_modulus=2000 N/mm^2'",
         "criterion --set beam.density=1200 --set beam.youngs_modulus=2e9"},
        {"modes reed --set beam.length=.3e0 --set beam.material=ABS",
         "modes reed --set beam.length=0.3 --set beam.material=abs"},
        {"map --x length=600mm:1m:3 --y 'damping=0:2 %:2' --duration 10ms --output -",
         "map --x length=0.6:1:3 --y damping=0:0.02:2 --duration 0.01 --output -"},
        {"design uncertain --band '30 Hz:31 1/s' --length 1990mm:2m --force 0.499kN:500 --duration 100ms",
         "design uncertain --band 30:31 --length 1.99:2 --force 499:500 --duration 0.1"},
        {"respond --from 10ms --duration 20ms --rate 1kHz",
         "respond --from 0.01 --duration 0.02 --rate 1000"}}) {
    const std::string wanted = run_line(without).output;
    EXPECT_NE(wanted, "") << without;
    EXPECT_EQ(run_line(with_units).output, wanted) << with_units;
  }
}

TEST_F(CommandLine, TellsAllMistakesOfACaseAtOnce) {
  std::ofstream("bar.toml")
      << "[beam]\nlength = -2\ndensity = '5 s'\nmaterail = 1\n[friction]\nstatic_coefficient = -1\n";
  const Outcome outcome = run_line("criterion bar.toml --set numerics.modes=2.5");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 5) << outcome.errors;
  for (const std::string part :
       {":2: beam.length is -2,", ":3: beam.density is '5 s'", ":4: unknown key beam.materail",
        ":6: friction.static_coefficient is -1,", "numerics.modes is 2.5"})
    EXPECT_TRUE(holds(outcome.errors, part));
}

STICKSLIP_VERIFIES(LimitsOfInput, "U2");
class LimitsOfInput : public CommandLine {};

TEST_F(LimitsOfInput, AreTheTableOfTheUserGuide) {
  std::string table;
  for (const auto& [of, most] : data::limit::all) table += fmt::format("| {} | {} |\n", of, most);
  EXPECT_TRUE(holds(contents(STICKSLIP_SOURCE_DIRECTORY "/reports/manual/user-guide.md"), table));
}

// Digits of options, bytes and levels are in input_matrix_test.cpp.
TEST_F(LimitsOfInput, AreToldInASentence) {
  const std::string digits(40'000, '9');
  std::string keys = "[beam]\n", dots = "a";
  for (int i = 0; i < 40'000; ++i) dots += ".a";
  for (int i = 0; i < 9'000; ++i) keys += fmt::format("lengtN{} = 1\n", i);
  for (const auto& [name, text, arguments, part] : std::vector<std::array<std::string, 4>>{
           {"a.toml", "[beam]\nlength = " + digits + ".0\n", "criterion a.toml", "a.toml:2: "},
           {"a.csv", "beam.length\n" + digits + "\n", "criterion paper --plan a.csv", "at most 1000 char"},
           {"a.toml", dots + " = 1\n", "criterion a.toml", "40000 dots, but must hold at most 5000"},
           {"a.csv", std::string(10'000, ',') + "\n", "compare stick-frequencies a.csv", "10000 columns"}}) {
    std::ofstream(name, std::ios::binary) << text;
    expect_refused(arguments, part);
  }
  std::ofstream("a.toml") << keys;
  const std::string errors = run_line("criterion a.toml").errors;
  EXPECT_EQ(std::ranges::count(errors, '\n'), 21);
  EXPECT_TRUE(errors.ends_with("\nstickslip: after so many mistakes 8980 more entries are not read\n"));
}

TEST_F(CommandLine, AnswersItsVersion) { EXPECT_TRUE(run("--version").output.starts_with("stickslip ")); }

// The schemes that look at the end of a step see the first slip there; it lies inside that step.
TEST_F(CommandLine, RespondFollowsTheSchemeAskedFor) {
  const auto steps = [&](const std::string& scheme) {
    const auto answer =
        json("respond --hz 25 --amplitude 1e-3 --duration 0.06 --output history.csv --scheme " + scheme);
    EXPECT_EQ(answer["scheme"], scheme);
    EXPECT_EQ(holds(answer["warnings"].dump(), "--scheme " + scheme + " is a comparison"),
              scheme != "located");
    return answer["first_slip_s"].get<double>() / answer["problem"]["numerics"]["time_step"].get<double>();
  };
  const double located = steps("located");
  EXPECT_LT(located, std::ceil(located));
  for (const char* scheme : {"end-of-step", "paper"})
    EXPECT_TRUE(within(steps(scheme), std::ceil(located), round_off(10, 1, located)));
}

// The mesh is wrong by the fourth power of the length of its 40 elements: 1.4e-7 of 224 N at 35 Hz.
TEST_F(CommandLine, CriterionHasTheSteadyForce) {
  for (const auto& [name, keys] :
       {std::pair{"paper", "excitation.frequency_hz=35"}, {"damped", "numerics.modes=9"}}) {
    const std::string run = fmt::format("criterion {} --set {}", name, keys);
    const auto answer = json(run), steady = answer["steady"];
    const data::Case problem = data::load_case(name, {data::Override::parse(keys)});
    const double force = steady["force_N"], critical = steady["critical_amplitude_m"];
    EXPECT_TRUE(
        within(finite_element_steady_force(problem, 40), force, discretisation(5e-6 * force, 2, "h^4")));
    EXPECT_TRUE(
        within(critical * force, answer["amplitude_m"].get<double>() * 300.0, round_off(10, 1, 300.0)));
    for (const double share : {0.999, 1.001})
      EXPECT_EQ(json(fmt::format("{} --amplitude {}", run, share * critical))["steady"]["verdict"],
                share > 1.0 ? "stick-slip" : "stick");
  }
  // Mode 1, 24.97 Hz, decays with 1.57 1/s at 1 %: to 5 % in 1.91 s.
  for (const auto& [duration, reached] : {std::pair("1.9", false), {"1.92", true}})
    EXPECT_EQ(json(fmt::format("criterion --set damping.ratio=0.01 --set excitation.duration={}",
                               duration))["steady"]["reached"],
              reached);
}

TEST_F(CommandLine, OutputReplacesWhatKilledRunsLeft) {
  // Beside a name without a folder; .h.csv.stickslip-NUMBER alone is a file of such a run, if it is one of this user.
  for (const char* name : {".h.csv.stickslip-1", ".h.csv.stickslip-4", ".g.csv.stickslip-1"})
    std::ofstream(path(name)) << "left";
  ::mkfifo(".h.csv.stickslip-2", 0600);  // opening it would wait
  std::filesystem::create_symlink(".g.csv.stickslip-1", ".h.csv.stickslip-3");
  const bool is_root = ::geteuid() == 0;
  EXPECT_EQ(::chown(".h.csv.stickslip-4", is_root ? 65534 : ::geteuid(), ::getegid()), 0);
  EXPECT_EQ(shell("umask 022 && '" STICKSLIP_PROGRAM "' respond --duration 0.001 --output h.csv").status, 0);
  auto names = files();
  std::ranges::sort(names);
  EXPECT_EQ(std::erase(names, ".h.csv.stickslip-4"), is_root ? 1u : 0u);
  EXPECT_EQ(names, (Words{".g.csv.stickslip-1", ".h.csv.stickslip-2", ".h.csv.stickslip-3", "h.csv", "stderr",
                          "stdout"}));
  EXPECT_EQ(std::filesystem::status("h.csv").permissions(), std::filesystem::perms{0644});
}

TEST_F(CommandLine, OutputKeepsModeAndLink) {
  const std::filesystem::perms own{0600};
  std::ofstream("real.csv") << "old";
  std::filesystem::permissions("real.csv", own);
  std::filesystem::create_symlink("real.csv", "link.csv");
  std::filesystem::create_symlink("new.csv", "dangling.csv");
  for (const char* link : {"link.csv", "dangling.csv"}) {
    EXPECT_EQ(run_line(std::string("respond --duration 0.01 --output ") + link).status, 0);
    EXPECT_TRUE(std::filesystem::is_symlink(link));
  }
  EXPECT_EQ(std::filesystem::status("real.csv").permissions(), own);
  EXPECT_EQ(csv(contents("real.csv")).size(), 102U);
  EXPECT_EQ(csv(contents("new.csv")), csv(contents("real.csv")));
  for (const std::string same : {"./real.csv", "link.csv"})
    expect_refused("respond --duration 0.01 --output real.csv --events " + same,
                   "another file than --output");
}

class Animation : public Drawing {
 protected:
  [[nodiscard]] std::string command(const std::string& options) const {
    return "animate --hz 25 --amplitude 1e-3 --output film " + options;
  }
};

STICKSLIP_VERIFIES(Animation, "U1");
TEST_F(Animation, LastsTenPeriodsUnlessTold) {
  install_gnuplot(draw_all);
  for (const auto& [options, duration] : {std::pair{"", 0.4},
                                          {"--set excitation.duration=0.1", 0.1},
                                          {"--set numerics.duration=0.1", 0.1},
                                          {"--set excitation.duration=0.1 --duration 0.2", 0.2}})
    EXPECT_EQ(json(command("--frames 2 ") + options)["duration_s"], duration) << options;
}

TEST_F(Animation, DrawsTheMotionThatItsTableHolds) {
  for (const std::string method : {"fe", "event-driven"}) {
    install_gnuplot(draw_all);
    EXPECT_EQ(run_line(command("--duration 0.08 --frames 9 --method " + method)).status, 0);
    const auto last_frame = csv(contents("film/frame-0009.png")), all = csv(contents("film/motion.csv"));
    EXPECT_TRUE(std::equal(last_frame.begin() + 1, last_frame.end(), all.end() - 81));
    auto motion = columns_of(contents("film/motion.csv")),
         history = columns_of(
             run_line("respond --hz 25 --amplitude 1e-3 --duration 0.08 --method " + method).output);
    ASSERT_EQ(motion["frame"].size(), 9U * 81U);
    for (const auto& [name, of_tip] : {std::pair{"time_s", "time_s"},
                                       {"friction_force_N", "friction_force_N"},
                                       {"displacement_m", "tip_displacement_m"}}) {
      // An event-driven run searches for events between the times that are asked for, which decide the last digit.
      const double last = std::stod(history[of_tip].back());
      EXPECT_TRUE(within(std::stod(motion[name].back()), last, round_off(1000, 1, last))) << name;
    }
    EXPECT_EQ(motion["tip_sticks"].back(), history["state"].back() == "stick" ? "1" : "0");
  }
}

TEST_F(Animation, ShowsNoFrameUnlessAllAreDrawn) {
  install_gnuplot(draw_all + std::string("echo out of paint; exit 1\n"));
  const Outcome outcome = run_line(command("--duration 0.12 --frames 61"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(holds(outcome.errors, "out of paint"));
  const std::filesystem::directory_iterator film("film");
  EXPECT_EQ(film->path().filename(), "motion.csv");
  EXPECT_EQ(std::distance(begin(film), end(film)), 1);
}

TEST_F(Animation, IsOneFilmWhereItsNameEndsInGif) {
  install_gnuplot(draw_all + std::string("echo 55 frames in animation sequence >&2\n"));
  const Outcome outcome =
      run_line("animate --hz 25 --amplitude 1e-3 --duration 0.11 --frames 55 --output film.gif");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  const auto rows = csv(contents("film.gif"));
  EXPECT_EQ(rows.front().front(), "frame");
  EXPECT_EQ(rows.size(), 55U * (1U + 81U));
  EXPECT_EQ(rows.back().front(), "55");
  EXPECT_EQ(files().size(), 4U);  // with stdout, stderr and tools
}

TEST_F(Animation, IsMadeAnMp4ByFfmpeg) {
  const std::string film = "animate --hz 25 --amplitude 1e-3 --duration 0.11 --frames 3 --output film.mp4";
  install_gnuplot(draw_all);
  const auto expect_nothing = [&](int status, const std::string& sentence) {
    const Outcome outcome = run_line(film);
    EXPECT_EQ(outcome.status, status);
    EXPECT_TRUE(holds(outcome.errors, sentence)) << outcome.errors;
    EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1);
    EXPECT_EQ(files().size(), 3U);  // stdout, stderr and tools
  };
  ::setenv("PATH", path("tools").c_str(), 1);
  expect_nothing(
      2,
      "--output is film.mp4, but must be a folder or a .gif file: ffmpeg is not installed or not on "
      "the search path");
  ::setenv("PATH", (path("tools") + ":/usr/bin:/bin").c_str(), 1);
  install_tool("ffmpeg", "echo no codec; echo half > film.mp4; exit 1\n");
  expect_nothing(1, "ffmpeg could not make the film (status 1): no codec");
  install_tool("ffmpeg", "for last; do :; done; { echo \"$@\"; tail -n 1 frame-0003.png; } > $last\n");
  EXPECT_EQ(run_line(film).status, 0);
  EXPECT_TRUE(
      contents("film.mp4")
          .starts_with("-loglevel error -framerate 25 -i frame-%04d.png -pix_fmt yuv420p film.mp4\n3,0.11,"));
  EXPECT_EQ(files().size(), 4U);
}

// By the gnuplot that is installed: the stand-ins of other tests read no script.
TEST_F(Animation, IsDrawnByGnuplotItself) {
  for (const std::string name : {"damped", "road", "rough-road"})
    for (const std::string output : {"film.gif", "film"}) {
      const Outcome outcome = run_line("animate " + name + " --frames 2 --duration 0.01 --output " + output);
      EXPECT_EQ(outcome.status, 0) << outcome.errors;
    }
  EXPECT_TRUE(contents("film.gif").starts_with("GIF89a"));
  EXPECT_TRUE(contents("film/frame-0002.png").starts_with("\x89PNG"));
}

using Figures = Drawing;
STICKSLIP_VERIFIES(Figures, "U1");
// The first case of each shape of figure.
TEST_F(Figures, AreDrawnByGnuplotItself) {
  for (const std::string command :
       {"criterion paper", "criterion road", "modes steel-strip",
        "respond paper --duration 0.1 --output h.csv", "respond road --duration 0.1 --output h.csv",
        "nvh squeak-stand --duration 1", "uncertainty uncertain --samples 50",
        "map paper --x frequency=1:9:3 --y amplitude=1e-4:1e-3:2 --output m.csv",
        "map paper --duration 0.2 --quantity power,peak-to-peak --x frequency=20:25:2 --y "
        "amplitude=1e-4:1e-3:2 --output "
        "m.csv",
        "map damped --duration 0.2 --quantity peak-to-peak --x frequency=20:25:2 --y amplitude=1e-4:1e-3:2 "
        "--output m.csv",
        "sweep damped --set numerics.time_step=1e-4 --hz 35 --parameter amplitude=1e-4:2e-4:2 --settle 2 "
        "--periods 2 --output s.csv",
        "squeal reed --map s.csv --speeds 0.05:1 --ratios 0.001:0.05 --count 3"}) {
    const Outcome outcome = run_line(command + " --figure f.svg");
    EXPECT_EQ(outcome.status, 0) << command << outcome.errors;
    EXPECT_TRUE(contents("f.svg").ends_with("</svg>\n\n")) << command;
  }
}

TEST_F(Animation, LeavesALongerOneAlone) {
  install_gnuplot(draw_all);
  ASSERT_EQ(run_line(command("--duration 1e-3 --frames 11")).status, 0);
  expect_refused(command("--duration 1e-3 --frames 12"),
                 "--frames is 12, but must be at most one per time step");
  expect_refused(command("--duration 1e-3 --frames 10"), "holds frame-0011.png of a longer animation");
}

class MapCommand : public Drawing {
 protected:
  static inline const std::string figure =
      "map paper-figure14 --duration 0.5 --output map.csv --x frequency=15:35:3 --y amplitude=1e-4:2e-3:2 "
      "--figure map.";
};

STICKSLIP_VERIFIES(MapCommand, "U1");
TEST_F(MapCommand, CountsItsStates) {
  const std::string map =
      "map paper-figure14 --duration 0.5 --output map.csv --x length=0.8:2.8:3 --y force=200:800:2:log --hz "
      "20";
  const auto answer = json(map);
  const std::string text = run_line(map).output;
  auto columns = columns_of(contents("map.csv"));
  for (std::size_t i = 0; i < 6; ++i)  // beyond buckling there is no stick state, and no force
    EXPECT_EQ(columns["force_ratio"].at(i).empty(), columns["state"].at(i) == "no stick state");
  for (const char* state : {"stick", "stick-slip", "no stick state"}) {
    EXPECT_EQ(answer["states"][state], std::ranges::count(columns["state"], state));
    EXPECT_GT(answer["states"][state], 0);
    EXPECT_TRUE(holds(text, fmt::format(" {} {}", answer["states"][state].get<int>(), state)));
  }
}

TEST_F(MapCommand, IsDrawnFromItsTableAlone) {
  install_gnuplot("cat \"${folder}map.csv\" > $output\n");
  for (const std::string format : {"png", "pdf"}) {
    const Outcome outcome = run_line(figure + format);
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "");
    EXPECT_TRUE(outcome.output.ends_with("\nDrawn in map." + format + "\n")) << outcome.output;
    EXPECT_EQ(csv(contents("map.csv")), csv(contents("map." + format)));
  }
  EXPECT_EQ(files().size(), 6u);  // the table, two figures, stdout, stderr, tools
}

TEST_F(MapCommand, StaysWhereItsFigureCannotBeDrawn) {
  install_gnuplot("echo out of paint; exit 1\n");
  for (const char* sentence : {"out of paint", "stickslip: gnuplot is not installed"}) {
    const Outcome outcome = run_line(figure + "png");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(holds(outcome.errors, sentence));
    EXPECT_TRUE(std::filesystem::exists("map.csv"));
    EXPECT_EQ(files().size(), 4u);  // the table, stdout, stderr, tools
    ::setenv("PATH", path("tools").c_str(), 1);
    std::filesystem::remove("tools/gnuplot");
  }
}

// Most of these forces are above the buckling load, and so is their 95 % quantile.
TEST_F(CommandLine, UncertaintyOfInvalidKeys) {
  std::string text = contents(data::find_case("uncertain"));
  text.replace(text.find("530.0"), 5, "500e3");
  std::ofstream("wild.toml") << text << "correlation = [['beam.length', 'beam.axial_force', 0.5]]\n";
  const auto answer = json("uncertainty wild.toml --samples 50");
  const int invalid = 50 - answer["valid_samples"].get<int>();
  EXPECT_GT(invalid, 25);
  EXPECT_EQ(answer["invalid_samples"], nlohmann::json({{"beam.axial_force", invalid}}));
  EXPECT_TRUE(answer["keys"][0]["margin_at_quantile_95"].is_null());
  EXPECT_FALSE(answer["keys"][0].contains("first_index"));
  const std::string table = run_line("uncertainty wild.toml --samples 50").output;
  for (const char* part : {": beam.axial_force\n", " ... inadmissible\n", "There are no indices: keys are"})
    EXPECT_TRUE(holds(table, part));
}

TEST_F(CommandLine, IsTheSameInAnyNumberOfThreads) {
  for (const std::string command :
       {"uncertainty uncertain --samples 300 ", "design paper --band 10:12 --length 1.9:2 "}) {
    const Outcome one = run_line(command + "--threads 1 --digits 17");
    EXPECT_NE(one.output, "");
    EXPECT_EQ(one.output, run_line(command + "--threads 3 --digits 17").output);
  }
}

TEST_F(CommandLine, UncertaintyTakesSetKeysAsCertain) {
  const auto answer = json(
      "uncertainty uncertain --samples 40 --seed 3 --set beam.length=2 --set "
      "friction.static_coefficient=0.5");
  EXPECT_EQ(answer["keys"].size(), 2u);
  EXPECT_EQ(answer["samples"], 40);
  EXPECT_EQ(answer["seed"], 3);
}

// taskset and schedulers of jobs give a process some of the processors only.
TEST_F(CommandLine, UsesTheProcessorsThatItIsAllowed) {
  const std::string map = " map paper --x frequency=20:21:2 --y amplitude=1e-3:2e-3:2 --dry-run --json";
  const Outcome one = shell(std::string("taskset -c 0 '") + STICKSLIP_PROGRAM + "'" + map);
  ASSERT_EQ(one.status, 0) << one.errors;
  EXPECT_EQ(nlohmann::json::parse(one.output)["threads"], 1);
}

}  // namespace
}  // namespace stickslip::testing
