// SPDX-License-Identifier: MIT
/// The command line, run as a program: exit status, streams, formats and files.

#include <sys/stat.h>
#include <nlohmann/json.hpp>

#include "stickslip/analytic/criterion.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/input_text.hpp"
#include "support/command_line.hpp"
#include "support/testing.hpp"
#include "support/vibration.hpp"

namespace stickslip::testing {
namespace {

// What is refused, and what the one sentence says of it: the key or option, its value, what is allowed.
struct Refusal {
  const char *arguments, *part;
};

constexpr Refusal refusals[] = {
    {"modes --set beam.axial_force=1e6", "beam.axial_force"},
    {"criterion --hz fast", "--hz: excitation.frequency_hz is fast, but must be a number (Hz) or a text of"},
    {"criterion --amplitude 1,5mm",
     "--amplitude: excitation.amplitude is 1,5mm, but must be written with a decimal point: 1.5"},
    {"criterion --set friction.static_coefficient=0,4",
     "is 0,4, but must be written with a decimal point: 0.4"},
    {"map --x length=60mm:1,5:3", "--x: TO is '1,5', but must be written with a decimal point: 1.5"},
    {"respond --from 1Hz", "--from is 1Hz, but must be a finite number of 0 or more (s)"},
    {"respond --json", "--output FILE"},
    {"respond --method event-driven --scheme located", "--method is event-driven, but must be fe where"},
    {"respond --method event-driven --set beam.axial_force=-10", "beam.axial_force is -10"},
    {"respond --method closed-form --events events.csv", "where --events is given"},
    {"respond --method closed-form --scheme paper", "--method is closed-form, but must be fe"},
    {"respond --scheme paper --set numerics.velocity_threshold=0", "must be above 0 (m/s)"},
    {"respond --initial-velocity zero --method closed-form", "quasi-static for --method closed-form, whose"},
    {"respond paper --hz 25 --output h.csv --spectrum s.csv --duration 0.0799",
     "excitation.duration is 0.0799, but must be at least two periods of the base motion, 0.08 s, "
     "where --spectrum is given\n"},
    {"respond paper --hz 25 --output h.csv --spectrum s.csv --duration 0.08 --every 267",
     "--every is 267, but must be small enough for two rows in a period of the base motion where --spectrum "
     "is given\n"},
    {"respond --method closed-form damped", "damping.kelvin_voigt is 6.4e-05, but must be 0 for the c"},
    {"uncertainty uncertain --band 1e-30:30", "--band: excitation.frequency_hz is 1e"},
    {"uncertainty paper", "uncertainty is missing, but the case must have a table [uncertainty]"},
    {"uncertainty uncertain --band 30:40 --set damping.ratio=0.01", "must have no damping with a band"},
    {"uncertainty uncertain --amplitude 0", "excitation.amplitude is 0, but must be above 0 (m)"},
    {"uncertainty uncertain --set beam.axial_force=0", "beam.axial_force is 0, but must be positive"},
    {"uncertainty uncertain --band 40:30", "--band: TO is '30', but must be a finite number not below"},
    {"design", "--band is required"},
    {"design --band 20:30 --amplitude 0", "--amplitude: excitation.amplitude is 0, but must be above 0"},
    {"design --band 20:30 --set beam.axial_force=0", "beam.axial_force is 0, but must be positive"},
    {"squeal paper", "wall.speed is 0, but must be other than 0"},
    {"squeal reed --speed 0", "--speed: wall.speed is 0, but must be other than 0"},
    {"periodic reed --set wall.speed=0", "excitation.amplitude is 0, but must be above 0"},
    {"squeal reed --set numerics.elements=201", "numerics.elements is 201, but must be at most 200 here"},
    {"squeal reed --map m.csv", "--map requires --speeds"},
    {"squeal reed --speeds 0.1:1", "--speeds requires --map"},
    {"squeal reed --figure m.png", "--figure draws the map, but --map FILE is missing"},
    {"uncertainty uncertain --band 30:31 --hz 40", "--hz excludes --band"},
    {"map damped --quantity work --method closed-form", "of the verdict, but --quantity is work"},
    {"periodic reed --periods 2", "--periods is 2, but must be 1 where excitation.amplitude is 0: the base"},
    {"report --only fig1 --tests .", "--tests excludes --only"},
    {"map paper --dry-run --x frequency=10:20:2 --y amplitude=1e-4:1e-3:2 --shard 5/50",
     "--shard is 5/50, but must be of at most 2 parts, the evaluations of this map"},
    {"compare stick-frequencies - --json a --junit a", "--junit is a, but must be another file than --json"},
    {"modes --state slipp", "--state is slipp (did you mean slip?), but must be one of stick, slip"},
    {"map --x frequncy=1:2:3", "(did you mean frequency?)"},
    {"modes paper damped", "the argument damped is one more than modes takes"},
    {"respond --duration 1e9",
     "--duration: excitation.duration is 1e+09, but must be at most a billion times"},
    {"criterion --set excitation.duration=1e5", "a hundred million periods of natural frequency 10"},
    {"map --quantity works", "(did you mean work?)"},
    {"map --quantity work,verdict", "--quantity is 'verdict', but must be one of"},
    {"map --quantity work --states-only",
     "--states-only is an option of the verdict, but --quantity is work"},
    {"map --quantity work --method fe", "--method is an option of the verdict, but --quantity is work"},
    {"map --transient 1", "--transient needs a --quantity of the motion, but it is verdict"},
    {"map --tolerance 0.1", "--tolerance needs a --quantity of the motion, but it is verdict"},
    {"map --quantity work,", "--quantity is '', but must be one of verdict, slip-share, "},
    {"map --quantity work --transient 0 --duration 0.01",
     "excitation.duration is 0.01, but must be long enough for the transient and two periods"},
    {"map --quantity work --transient 10",
     "excitation.duration is 10, but must be long enough for the transient and two periods of the base "
     "motion, 12 s"},
    {"sweep --parameter modes=1:2:3", "--parameter: PARAMETER is 'modes'"},
    {"map --x length=1e-300:1:2", "--x: beam.length is 1e-300, but must be from 1e-09 to 1e+06 (m)"},
    {"map --shard '' --output a", "--shard is '', but must be K/M"},
    {"map --quantity work --tolerance 0", "--tolerance is 0, but must be above 0 and below 1\n"},
    {"map --quantity work --tolerance 1", "--tolerance is 1, but must be above 0 and below 1\n"},
    {"map --x 15:35:3", "--x: the axis is '15:35:3', but must be PARAMETER=FROM:TO:COUNT"},
    {"map --x frequency=15:35", "--x: the axis is 'frequency=15:35', but must be"},
    {"map --x hight=15:35:3", "--x: PARAMETER is 'hight', but must be one of length, area, "},
    {"map --x hight=15:35:3", " (did you mean height?)"},
    {"map --x height=1e-3:2e-3:3",
     "section.height is 0.001, but must be left out: the case has no [section] with it"},
    {"map --x length=-1:2:3", "--x: FROM is '-1', but must be a finite number above 0"},
    {"map --x length=1:inf:3", "--x: TO is 'inf', but must be a finite number above FROM, 1"},
    {"map --x length=2:1:3", "--x: TO is '1', but must be a finite number above FROM, 2"},
    {"map --x length=1:2:1", "--x: COUNT is '1', but must be an integer from 2 to 2000"},
    {"map --x length=1:2:2 --y amplitude=0:1e-3:5:log",
     "--y: FROM is '0', but must be a finite number above 0"},
    {"map --x length=1:2:2 --y length=1:3:4",
     "both axes of the map are beam.length, but must be two parameters"},
    {"map --x frequency=15:35:3 --y amplitude=1e-4:2e-3:2 --figure map.jpg",
     "--figure is 'map.jpg', but must be a file whose name ends in .pdf, .png or .svg"},
    {"map --set beam.axial_force=0 --x frequency=15:35:3 --y amplitude=1e-4:2e-3:2",
     "beam.axial_force is 0, but must be positive"},
    {"map --set beam.axial_force=1e6 --x frequency=15:35:3 --y amplitude=1e-4:2e-3:2", "buckling load"},
    {"map paper-figure14 --duration 0.5 --output map.csv --x frequency=15:35:3 --y amplitude=1e-4:2e-3:2 "
     "--figure none/map.png",
     "none/map.png"},
    {"respond paper --json --output h.csv --events -", "--json and --events - both want standard output"},
    {"squeal reed --map a.csv --speeds 1e-16:1 --ratios 0.01:0.02",
     "--speeds: wall.speed is 1e-16, but must be from 1e-15 to 1e+09"},
    {"respond paper --method boundary-integral --output h.csv --set damping.ratio=0.01",
     "damping.ratio is 0.01, but must be 0 with the boundary"},
    {"respond paper --method boundary-integral --output h.csv --duration 0.1678 --set "
     "numerics.time_step=1e-8",
     "excitation.duration is 0.1678, but must be at most 0.168 s, 2^24 steps of 1e-08 s"},
    {"report --output report --only fig9,fig99",
     "--only names the figure 'fig99', but must name some of fig1, "},
    {"respond --duration 0.01 --output none/history.csv", "none/history.csv"},
    {"respond --duration 0.01 --output .", "Is a directory"},
    {"respond --duration 0.01 --output /dev/full", "No space left on device"},
};

STICKSLIP_VERIFIES(CommandLine, "U1");
TEST_F(CommandLine, TakesUnitsWhereverItTakesANumberOfACase) {
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
    const std::string wanted = run(without).output;
    EXPECT_NE(wanted, "") << without;
    EXPECT_EQ(run(with_units).output, wanted) << with_units;
  }
}

STICKSLIP_VERIFIES(CommandLine, "U1");
TEST_F(CommandLine, TellsAllMistakesOfACaseAtOnce) {
  std::ofstream(path("bar.toml"))
      << "[beam]\nlength = -2\ndensity = '5 s'\nmaterail = 1\n[friction]\nstatic_coefficient = -1\n";
  const Outcome outcome = run("criterion " + path("bar.toml") + " --set numerics.modes=2.5");
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
           {"a.csv", "beam.length\n" + digits + "\n", "criterion paper --plan a.csv",
            "of at most 1000 characters"},
           {"a.toml", dots + " = 1\n", "criterion a.toml",
            "a.toml: holds 40000 dots, but must hold at most 5000"},
           {"a.csv", std::string(10'000, ',') + "\n", "compare stick-frequencies a.csv", "10000 columns"}}) {
    std::ofstream(name, std::ios::binary) << text;
    expect_refused(arguments, part);
  }
  std::ofstream("a.toml") << keys;
  const Outcome outcome = run("criterion a.toml");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 21);
  EXPECT_TRUE(
      outcome.errors.ends_with("\nstickslip: after so many mistakes 8980 more entries are not read\n"));
}

STICKSLIP_VERIFIES(CommandLine, "U1");
TEST_F(CommandLine, JudgesSeveralCasesAndAPlanOfPointsInOneTable) {
  std::ofstream(path("plan.csv")) << "beam.length,excitation.amplitude\n400 mm,0.5 mm\n0.3,1e-3\n";
  ASSERT_EQ(run("criterion steel-strip paper --hz 30 --plan plan.csv --output table.csv").status, 0);
  const auto rows = csv(contents("table.csv"));
  ASSERT_EQ(rows.size(), 5U);
  EXPECT_EQ(rows[0][1], "beam.length");
  for (const auto& [row, arguments] : {std::pair{1U, "steel-strip --set beam.length=0.4 --amplitude 5e-4"},
                                       {4U, "paper --set beam.length=0.3 --amplitude 1e-3"}}) {
    const auto one = json(std::string("criterion --hz 30 ") + arguments);
    const auto cell = [&, row = row](const std::string& name) {
      return rows[row].at(static_cast<std::size_t>(std::ranges::find(rows[0], name) - rows[0].begin()));
    };
    EXPECT_EQ(cell("verdict"), one["all_modes"]["verdict"]);
    EXPECT_EQ(std::stod(cell("force_lower_N")), one["all_modes"]["force_max_N"]["lower"]);
    EXPECT_EQ(std::stod(cell("force_upper_N")), one["all_modes"]["force_max_N"]["upper"]);
    EXPECT_NEAR(std::stod(cell("steady_force_N")), one["steady"]["force_N"].get<double>(),
                1e-6 * one["steady"]["force_N"].get<double>());
    const double margin = std::stod(cell("margin"));
    EXPECT_GE(margin, one["margin"]["lower"]);
    EXPECT_LE(margin, one["margin"]["upper"]);
  }
  EXPECT_NE(run("criterion steel-strip --plan plan.csv").output, "");
}

STICKSLIP_VERIFIES(CommandLine, "U1");
TEST_F(CommandLine, RefusesWhatItCannotUseInOneSentence) {
  for (const auto& [arguments, part] : refusals) expect_refused(arguments, part);
  EXPECT_EQ(files().size(), 2u);  // stdout and stderr
}

TEST_F(CommandLine, AnswersItsVersionOnStandardOutput) {
  const Outcome version = run("--version");
  EXPECT_EQ(version.status, 0);
  EXPECT_TRUE(version.output.starts_with("stickslip ")) << version.output;
}

TEST_F(CommandLine, RespondFollowsTheSchemeAskedFor) {
  // Located inside the step of 1e-4 s the first slip has more digits than at its end.
  const auto first_slip = [&](const std::string& scheme) {
    const auto answer =
        json("respond --hz 25 --amplitude 1e-3 --duration 0.06 --output history.csv --scheme " + scheme);
    EXPECT_EQ(answer["scheme"], scheme);
    EXPECT_EQ(holds(answer["warnings"].dump(), "--scheme " + scheme + " is a comparison"),
              scheme != "located");
    return answer["first_slip_s"].get<double>();
  };
  EXPECT_LT(first_slip("located"), 0.0553);
  EXPECT_DOUBLE_EQ(first_slip("end-of-step"), 0.0553);
  EXPECT_DOUBLE_EQ(first_slip("paper"), 0.0553);
}

TEST_F(CommandLine, ContactThatYieldsIsForHistoriesAlone) {
  const std::string spring = " --set contact.tangential_stiffness=1e6 ",
                    smooth = " --set contact.regularisation_velocity=0.01 ";
  for (const char* command :
       {"criterion", "modes", "animate --output film", "design --band 20:30", "uncertainty uncertain",
        "map --x frequency=15:35:3 --y amplitude=1e-4:1e-3:3", "sweep --parameter amplitude=1e-4:1e-3:3",
        "squeal reed", "periodic damped", "respond --method closed-form", "respond --method event-driven",
        "respond --scheme paper"}) {
    expect_refused(command + spring,
                   "contact.tangential_stiffness is 1e+06, but must be inf (a rigid contact) for ");
    expect_refused(command + smooth,
                   "contact.regularisation_velocity is 0.01, but must be 0 (the set-valued law) for ");
  }
  for (const char* method : {"fe", "boundary-integral"})
    expect_refused("respond --set friction.decay=inf --method " + (method + spring),
                   "friction.decay is inf, but must be finite");
}

TEST_F(CommandLine, CriterionGivesSteadyAndStartUpForce) {
  const auto slow = json("criterion --hz 35 --amplitude 1e-3");
  EXPECT_EQ(slow["verdict"], "stick-slip");
  EXPECT_EQ(slow["steady"]["verdict"], "stick");
  EXPECT_NEAR(slow["steady"]["force_N"].get<double>(),
              finite_element_steady_force(data::load_case("paper", {{"excitation.frequency_hz", "35"},
                                                                    {"excitation.amplitude", "1e-3"}}),
                                          40),
              1e-4);  // the fourth power of the element length: 1.4e-7 of 224 N
  EXPECT_TRUE(
      holds(run("criterion --hz 35").output, "\nverdict, steady                                 stick\n"));
  EXPECT_EQ(slow["steady"]["reached"], false);
  EXPECT_TRUE(holds(run("criterion --hz 25").output, ", not reached within 10 s\n"));
  // Mode 1, 24.97 Hz, decays with 1.57 1/s at 1 %: to 5 % in 1.91 s.
  for (const auto& [duration, reached] : {std::pair("1.9", false), {"1.92", true}})
    EXPECT_EQ(json(fmt::format("criterion --set damping.ratio=0.01 --set excitation.duration={}",
                               duration))["steady"]["reached"],
              reached);
  const std::string resonance = fmt::format(
      "criterion --hz {}", analytic::stick_modes(data::load_case("paper").beam, 1).front().frequency_hz());
  EXPECT_TRUE(json(resonance)["steady"].is_null());
  EXPECT_TRUE(holds(run(resonance).output, "none at a natural frequency\n"));
}

TEST_F(CommandLine, CriterionOfADampedCase) {
  const auto answer = json("criterion damped");
  const double force = answer["steady"]["force_N"], critical = answer["steady"]["critical_amplitude_m"];
  EXPECT_NEAR(force, finite_element_steady_force(data::load_case("damped"), 40), 1e-5 * force);
  EXPECT_DOUBLE_EQ(critical * force, 1e-3 * 300.0);
  EXPECT_EQ(answer["steady"]["verdict"], "stick-slip");
  EXPECT_EQ(json(fmt::format("criterion damped --amplitude {}", 0.999 * critical))["steady"]["verdict"],
            "stick");
  EXPECT_EQ(answer["damping"]["kelvin_voigt_s"], 6.4e-5);
  const data::Case damped = data::load_case("damped");
  const auto expected = analytic::evaluate_criterion(damped.beam, damped.friction, damped.excitation, 0.5, 10,
                                                     analytic::SteadyPart::modal_sum, 1e-10, damped.damping);
  EXPECT_EQ(answer["force_max_N"]["lower"], expected.force_max.lower);
  EXPECT_NE(json("criterion damped --set numerics.modes=9")["force_max_N"]["lower"],
            expected.force_max.lower);
  EXPECT_EQ(answer["critical_amplitude_bounds_m"]["upper"], expected.critical_amplitude.upper);
  // Both columns, to the truncation after ten modes, and the steady part by modes, to rounding.
  const double of_ten = answer["force_max_N"]["lower"], of_all = answer["all_modes"]["force_max_N"]["lower"];
  EXPECT_NEAR(of_all, of_ten, 1e-3 * of_ten);
  EXPECT_TRUE(holds(run("criterion damped").output, "decay with the damping of the case"));
  EXPECT_LT(json("criterion --hz 35 --set damping.ratio=0.01")["force_max_N"]["upper"],
            json("criterion --hz 35")["force_max_N"]["lower"]);
}

TEST_F(CommandLine, ModesOfADampedCaseSayThatTheyAreUndamped) {
  const std::string sentence = "These are the undamped frequencies";
  EXPECT_TRUE(holds(run("modes damped").output, sentence));
  EXPECT_EQ(run("modes paper").output.find(sentence), std::string::npos);
  const auto damped = json("modes damped"), undamped = json("modes paper");
  EXPECT_EQ(damped["undamped"], true);
  EXPECT_FALSE(undamped.contains("undamped"));
  EXPECT_EQ(damped["frequencies_hz"], undamped["frequencies_hz"]);
}

TEST_F(CommandLine, WarnsWhenTheClosedFormLeavesItsGround) {
  const Outcome outcome = run("respond --method closed-form --hz 25 --amplitude 1e-3 --duration 0.1");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_TRUE(holds(outcome.errors, "|f| exceeds mu_s P = 300 N first at 0.0553 s"));
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
  EXPECT_EQ(names, (std::vector<std::string>{".g.csv.stickslip-1", ".h.csv.stickslip-2", ".h.csv.stickslip-3",
                                             "h.csv", "stderr", "stdout"}));
  EXPECT_EQ(std::filesystem::status("h.csv").permissions(), std::filesystem::perms{0644});
}

TEST_F(CommandLine, OutputKeepsTheModeOfTheFileThatItReplaces) {
  const std::filesystem::perms own{0600};
  std::ofstream("old.csv") << "old";
  std::filesystem::permissions("old.csv", own);
  EXPECT_EQ(run("respond --duration 0.001 --output old.csv").status, 0);
  EXPECT_NE(contents("old.csv"), "old");
  EXPECT_EQ(std::filesystem::status("old.csv").permissions(), own);
}

TEST_F(CommandLine, AnOutputFileThatIsASymbolicLinkStaysOne) {
  std::ofstream("real.csv") << "old";
  std::filesystem::create_symlink("real.csv", "link.csv");
  EXPECT_EQ(run("respond --duration 0.01 --output link.csv").status, 0);
  EXPECT_TRUE(std::filesystem::is_symlink("link.csv"));
  std::filesystem::create_symlink("new.csv", "dangling.csv");
  EXPECT_EQ(run("respond --duration 0.01 --output dangling.csv").status, 0);
  EXPECT_EQ(contents("new.csv"), contents("real.csv"));
  EXPECT_TRUE(std::filesystem::is_symlink("dangling.csv"));
  for (const std::string same : {"./real.csv", "link.csv"})
    expect_refused("respond --duration 0.01 --output real.csv --events " + same,
                   "another file than --output");
  EXPECT_EQ(csv(contents("real.csv")).size(), 102U);
}

class Animation : public Drawing {
 protected:
  [[nodiscard]] std::vector<std::string> frames() const {
    std::vector<std::string> names;
    for (const auto& file : std::filesystem::directory_iterator("film"))
      names.push_back(file.path().filename());
    std::ranges::sort(names);
    return names;
  }

  [[nodiscard]] std::string command(const std::string& options) const {
    return "animate --hz 25 --amplitude 1e-3 --output film " + options;
  }
};

STICKSLIP_VERIFIES(Animation, "U1");
TEST_F(Animation, LastsTenPeriodsUnlessADurationIsGiven) {
  install_gnuplot(draw_all);
  const auto answer = json(command("--frames 2"));
  EXPECT_EQ(answer["duration_s"], 0.4);
  EXPECT_EQ(answer["frames"], 2);
  EXPECT_EQ(answer["output"], "film");
  for (const std::string key : {"excitation", "numerics"})
    EXPECT_EQ(json(command("--frames 2 --set " + key + ".duration=0.1"))["duration_s"], 0.1);
  EXPECT_EQ(json(command("--frames 2 --set excitation.duration=0.1 --duration 0.2"))["duration_s"], 0.2);
}

TEST_F(Animation, DrawsTheMotionThatItsTableHolds) {
  for (const std::string method : {"fe", "event-driven"}) {
    install_gnuplot(draw_all);
    EXPECT_TRUE(holds(run(command("--duration 0.08 --frames 9 --method " + method)).output,
                      "\n9 frames written to film\n"));
    EXPECT_EQ(csv(contents("film/frame-0009.png")), csv(contents("film/motion.csv")));
    EXPECT_TRUE(contents("film/motion.csv").starts_with("# Motion of the beam; stickslip "));
    const auto rows = csv(contents("film/motion.csv"));
    ASSERT_EQ(rows.size(), 1U + 9U * 81U);
    EXPECT_EQ(rows[0], (std::vector<std::string>{"frame", "time_s", "tip_sticks", "friction_force_N",
                                                 "position_m", "displacement_m"}));
    // The tip in the last frame, as `respond` has it.
    const auto history =
        csv(run("respond --hz 25 --amplitude 1e-3 --duration 0.08 --method " + method).output);
    EXPECT_EQ(std::stod(rows.back()[1]), std::stod(history.back()[0]));
    // An event-driven run searches for events between the times that are asked for, which decide the last digit.
    EXPECT_NEAR(std::stod(rows.back()[3]), std::stod(history.back()[5]),
                method == "fe" ? 0.0 : 1e-12 * 300.0);
    EXPECT_NEAR(std::stod(rows.back()[5]), std::stod(history.back()[2]), 1e-15);
    EXPECT_EQ(rows.back()[2], history.back()[6] == "stick" ? "1" : "0");
  }
}

TEST_F(Animation, ShowsNoFrameUnlessAllAreDrawn) {
  install_gnuplot(
      "grep -q '^first_frame,1,' \"${folder}animation-values.csv\" || { echo out of paint; exit 1; }\n" +
      std::string(draw_all));
  const Outcome outcome = run(command("--duration 0.12 --frames 61"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(holds(outcome.errors, "out of paint"));
  EXPECT_EQ(frames(), (std::vector<std::string>{"motion.csv"}));
}

TEST_F(Animation, IsOneFilmWhereItsNameEndsInGif) {
  install_gnuplot(
      "case $4 in\nfilm.gp) cat frame-*.png > \"$output\"; echo 55 frames in animation sequence >&2;;\n*)\n" +
      std::string(draw_all) + ";;\nesac\n");
  const std::string options = "animate --hz 25 --amplitude 1e-3 --duration 0.11 --frames 55 --output film.";
  const Outcome outcome = run(options + "gif");
  EXPECT_EQ(outcome.status, 0) << outcome.errors;
  EXPECT_TRUE(holds(outcome.output, "\n55 frames written to film.gif\n"));
  // A frame is what its batch of fifty was drawn from: the first frame of the second one has number 51.
  const auto rows = csv(contents("film.gif"));
  EXPECT_EQ(rows.front().front(), "frame");
  EXPECT_EQ(rows.size(), 50U * (1U + 50U * 81U) + 5U * (1U + 5U * 81U));
  EXPECT_EQ(rows.back().front(), "55");
  EXPECT_EQ(files().size(), 4U);  // with stdout, stderr and tools
  expect_refused(options + "mp4", "--output is film.mp4, but must be a folder or a .gif file");
}

TEST_F(Animation, RefusesWhatCannotBecomeAFilm) {
  install_gnuplot(draw_all);
  expect_refused(command("--frames 1"), "--frames is 1, but must be an integer from 2 to 9999");
  expect_refused(command("--duration 1e-3 --frames 12"),
                 "at most one per time step of 1e-04 s, of which 0.001 s have 11");
  expect_refused(command("--method closed-form"), "closed-form");
  expect_refused(command("--set beam.axial_force=-5"), "beam.axial_force");
  ASSERT_EQ(run(command("--duration 1e-3 --frames 11")).status, 0);
  expect_refused(command("--duration 1e-3 --frames 10"), "holds frame-0011.png of a longer animation");
}

class MapCommand : public Drawing {
 protected:
  [[nodiscard]] std::string command(const std::string& options) const {
    return "map paper-figure14 --duration 0.5 --output map.csv " + options;
  }

  static inline const std::string two_axes = "--x frequency=15:35:3 --y amplitude=1e-4:2e-3:2 ";
};

STICKSLIP_VERIFIES(MapCommand, "U1");
TEST_F(MapCommand, HoldsWhatCriterionSaysOfEveryCell) {
  const auto answer = json(command("--x length=0.8:2.8:3 --y force=200:800:2:log --hz 20"));
  EXPECT_EQ(answer["cells"], 6);
  const auto rows = csv(contents("map.csv"));
  ASSERT_EQ(rows.size(), 1u + 2u * 4u);  // the names, and an empty line after each force
  EXPECT_EQ(rows[0], (std::vector<std::string>{"length_m", "axial_force_N", "force_ratio", "state"}));
  int buckled = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (rows[i].empty()) continue;
    const std::string place = "--set excitation.duration=0.5 --hz 20 --set beam.length=" + rows[i][0] +
                              " --set beam.axial_force=" + rows[i][1];
    if (rows[i][3] == "no stick state") {
      ++buckled;
      EXPECT_EQ(rows[i][2], "");
      expect_refused("criterion paper-figure14 " + place, "below the buckling load");
      continue;
    }
    const auto criterion = json("criterion paper-figure14 " + place);
    const double ratio =
        criterion["force_max_N"]["lower"].get<double>() / criterion["friction_limit_N"].get<double>();
    EXPECT_NEAR(std::stod(rows[i][2]), ratio, 2e-10 * ratio);  // the bounds are 1e-10 apart
    EXPECT_EQ(rows[i][3], criterion["verdict"]);
  }
  EXPECT_EQ(buckled, 1);
  EXPECT_EQ(answer["states"]["no stick state"], 1);
  EXPECT_TRUE(
      holds(run(command("--x length=0.8:2.8:3 --y force=200:800:2:log --hz 20")).output,
            fmt::format("\n6 cells written to map.csv: {} stick, {} stick-slip, 1 no stick state\n",
                        answer["states"]["stick"].get<int>(), answer["states"]["stick-slip"].get<int>())));
}

TEST_F(CommandLine, UncertaintyGivesTheProbabilityOfSlip) {
  const auto answer = json("uncertainty uncertain --samples 400 --seed 3");
  const double p = answer["probability_of_slip"];
  EXPECT_EQ(answer["samples"], 400);
  EXPECT_EQ(answer["seed"], 3);
  EXPECT_EQ(answer["frequency_hz"], 35.0);
  EXPECT_EQ(answer["valid_samples"], 400);
  EXPECT_EQ(answer["invalid_samples"], nlohmann::json::object());
  EXPECT_LT(answer["probability_lower"], p);
  EXPECT_GT(answer["probability_upper"], p);
  EXPECT_EQ(answer["tighten"], "friction.static_coefficient");
  EXPECT_EQ(answer["keys"].size(), 4u);
  const double critical = json("criterion uncertain")["critical_amplitude_m"];
  EXPECT_NEAR(answer["margin_of_case"], critical / 0.5e-3, 1e-6);
  const std::string table = run("uncertainty uncertain --samples 400 --seed 3").output;
  EXPECT_TRUE(holds(table, fmt::format("probability of slip         {:.5f} (", p)));
  const auto with_interval = [](const nlohmann::json& estimate, int decimals) {
    return fmt::format("{0:.{3}f} ({1:.{3}f} ... {2:.{3}f})", estimate["value"].get<double>(),
                       estimate["lower"].get<double>(), estimate["upper"].get<double>(), decimals);
  };
  std::vector<std::string> lines{
      "A tighter tolerance helps: with half the spread of friction.static_coefficient the probability of "
      "slip is " +
      with_interval(answer["probability_with_half_spread"], 5) + "."};
  const auto range = [](const nlohmann::json& low, const nlohmann::json& high) {
    return fmt::format("{:#.4g} ... {:#.4g}", low.get<double>(), high.get<double>());
  };
  for (const auto& key : answer["keys"])
    lines.push_back(fmt::format("{:<29}{:<26}{:<22}{:<28}{}", key["key"].get<std::string>(),
                                range(key["quantile_5"], key["quantile_95"]),
                                range(key["margin_at_quantile_5"], key["margin_at_quantile_95"]),
                                with_interval(key["first_index"], 3), with_interval(key["total_index"], 3)));
  for (const auto& quantile : answer["quantiles"])
    lines.push_back(fmt::format(
        "{:<28}{:<26}{:#.4g}", fmt::format("{:.0f} %", 100.0 * quantile["probability"].get<double>()),
        fmt::format("{:#.4g}", quantile["critical_amplitude_m"]["value"].get<double>()),
        quantile["margin"]["value"].get<double>()));
  EXPECT_EQ(answer["quantiles"].size(), 5u);
  for (const std::string& line : lines) EXPECT_TRUE(holds(table, "\n" + line + "\n"));
  for (const char* head : {"quantile ", "key "}) EXPECT_TRUE(holds(table, fmt::format("\n\n{}", head)));
}

// Most of these forces are above the buckling load, and so is their 95 % quantile.
TEST_F(CommandLine, UncertaintyOfInvalidBeamsAndCorrelatedKeys) {
  std::string text = contents(data::find_case("uncertain"));
  text.replace(text.find("530.0"), 5, "500e3");
  std::ofstream("wild.toml") << text << "correlation = [['beam.length', 'beam.axial_force', 0.5]]\n";
  const std::string command = "uncertainty wild.toml --samples 50";
  const auto answer = json(command);
  const int invalid = 50 - answer["valid_samples"].get<int>();
  EXPECT_EQ(answer["invalid_samples"], nlohmann::json({{"beam.axial_force", invalid}}));
  EXPECT_TRUE(answer["keys"][0]["margin_at_quantile_95"].is_null());
  EXPECT_FALSE(answer["keys"][0].contains("first_index"));
  const std::string table = run(command).output;
  for (const std::string& part :
       {fmt::format("\nsamples that are no beam    {}: beam.axial_force\n", invalid),
        std::string(" ... no beam\n"), std::string("There are no indices: keys are")})
    EXPECT_TRUE(holds(table, part));
}

TEST_F(CommandLine, LongWorkIsTheSameInAnyNumberOfThreads) {
  for (const std::string command :
       {"uncertainty uncertain --samples 300 --json", "design paper --band 10:12 --length 1.9:2 --json"}) {
    auto one = nlohmann::json::parse(run(command + " --threads 1").output),
         three = nlohmann::json::parse(run(command + " --threads 3").output);
    EXPECT_NE(one["command"], three["command"]);
    for (auto* answer : {&one, &three}) answer->erase("command");
    EXPECT_EQ(one.dump(), three.dump());
  }
}

TEST_F(CommandLine, UncertaintyTakesWhatIsSetAsCertain) {
  const auto answer =
      json("uncertainty uncertain --samples 40 --set beam.length=2 --set friction.static_coefficient=0.5");
  EXPECT_EQ(answer["keys"].size(), 2u);
  EXPECT_EQ(json("uncertainty uncertain --samples 20 --band 34:35")["band_hz"], nlohmann::json({34.0, 35.0}));
}

TEST_F(MapCommand, IsDrawnFromItsTableAlone) {
  install_gnuplot("cat \"${folder}map.csv\" > $output\n");
  for (const std::string format : {"png", "pdf"}) {
    const Outcome outcome = run(command(two_axes + "--figure map." + format));
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "");
    EXPECT_TRUE(outcome.output.ends_with("\nDrawn in map." + format + "\n")) << outcome.output;
    EXPECT_TRUE(contents("map.csv").ends_with(
        contents("map." + format).substr(contents("map." + format).find('\n'))));
  }
  EXPECT_EQ(files().size(), 6u);  // the table, two figures, stdout, stderr, tools
}

TEST_F(MapCommand, KeepsTheMapWhenItsFigureCannotBeDrawn) {
  install_gnuplot("echo out of paint; exit 1\n");
  const std::string figure = two_axes + "--figure map.png";
  Outcome outcome = run(command(figure));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(holds(outcome.errors, "out of paint"));
  ::setenv("PATH", path("tools").c_str(), 1);
  std::filesystem::remove("tools/gnuplot");
  outcome = run(command(figure));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(outcome.errors.starts_with("stickslip: gnuplot is not installed")) << outcome.errors;
  EXPECT_TRUE(std::filesystem::exists("map.csv"));
  EXPECT_EQ(files().size(), 4u);  // the table, stdout, stderr, tools
}

TEST_F(CommandLine, OfADampedCaseHasAMarginForTheSteadyVibrationToo) {
  const std::string command = "design damped --band 35:36 --length 1.99:2 --force 499:500 --duration 1";
  const auto design = json(command);
  EXPECT_GT(design["steady_margin"]["lower"], design["margin"]["lower"]);
  EXPECT_TRUE(holds(run(command).output, "\nsmallest margin, steady           "));
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
