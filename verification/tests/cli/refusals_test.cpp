// SPDX-License-Identifier: MIT
/// What a command takes is what the user guide says. A refusal is one sentence that names what is refused, its value and what is
/// allowed; what it allows or advises is run, and is taken. Every whole number is read alike.

#include <regex>

#include "stickslip/data/input_text.hpp"
#include "studies/history/method.hpp"
#include "support/command_line.hpp"
#include "support/random_cases.hpp"

namespace stickslip::testing {
namespace {

using data::Feature;

// What not every command takes: a key of a case, or an option of `respond`.
struct Refusable {
  Feature feature{};
  std::string key;         // that the case states, or the option
  std::size_t column{};    // of the user guide
  std::string named{key};  // in the sentence
};

const std::vector<Refusable> keys{{Feature::kelvin_voigt, "damping.kelvin_voigt", 1},
                                  {Feature::other_damping, "damping.ratio", 1},
                                  {Feature::other_damping, "damping.mass_proportional", 1},
                                  {Feature::shear, "beam.poissons_ratio", 2, "beam.shear_stiffness"},
                                  {Feature::moving_wall, "wall.speed", 3},
                                  {Feature::yielding_contact, "contact.tangential_stiffness", 4},
                                  {Feature::yielding_contact, "contact.regularisation_velocity", 4},
                                  {Feature::fixed_axial_force, "beam.axial_direction"}};
const std::vector<Refusable> options{{Feature::slip, "--events events.csv", 0, "--method"},
                                     {Feature::start_at_rest, "--initial-velocity zero"},
                                     {Feature::contact_scheme, "--scheme located", 0, "--method"},
                                     {Feature::further_columns, "--columns tip-acceleration", 0, "--method"}};

// A command with the arguments that make it fast, with its row of the user guide, or the method that decides.
struct Row {
  std::string guide, arguments;
  const studies::Method* method{};
};

// The cells of the rows below a line of a Markdown text that begins so, by the names in the first one.
std::map<std::string, Words> table_below(const std::string& text, const std::string& head) {
  std::map<std::string, Words> rows;
  std::istringstream lines(text.substr(text.find("\n" + head) + 1));
  std::string line;
  for (int n = 0; std::getline(lines, line) && line.starts_with('|'); ++n) {
    if (n < 2) continue;
    Words cells;
    std::istringstream row(line.substr(1));
    for (std::string cell; std::getline(row, cell, '|');) cells.push_back(cell.substr(1, cell.size() - 2));
    std::istringstream names(cells.front());
    for (std::string name; std::getline(names >> std::ws, name, ',');)
      rows[name.substr(1, name.size() - 2)] = cells;
  }
  return rows;
}

class Refusals : public Drawing {
 protected:
  void SetUp() override {
    Drawing::SetUp();
    install_gnuplot(draw_all);
  }

  // Every row of the guide, and every method of `respond` and `animate`.
  [[nodiscard]] static std::vector<Row> rows_for(const CaseText& text) {
    const auto range = [&](const std::string& key) {
      return fmt::format("{}:{}", text.number(key), 1.001 * text.number(key));
    };
    const std::string hz = data::shortest_text(text.number("excitation.frequency_hz"));
    const std::string map = fmt::format("map CASE --x length={}:2 --y friction={}:2", range("beam.length"),
                                        range("friction.static_coefficient"));
    std::vector<Row> rows{{"modes", "modes CASE"},
                          {"modes", "modes CASE --method fe"},
                          {"criterion", "criterion CASE"},
                          {"map", map},
                          {"map --method fe", map + " --method fe"},
                          {"map --quantity", map + " --quantity travel --transient 0"},
                          {"uncertainty", "uncertainty CASE --samples 5"},
                          {"sweep", "sweep CASE --settle 0 --periods 1 --parameter friction=" +
                                        range("friction.static_coefficient") + ":2"},
                          {"design", fmt::format("design CASE --band {0}:{0} --length {1} --force {2}", hz,
                                                 range("beam.length"), range("beam.axial_force"))},
                          {"squeal", "squeal CASE --speed 0.1 --modes 2 --settle 1"},
                          {"nvh", "nvh CASE --windows 2"},
                          {"periodic", "periodic CASE --settle 1"}};
    for (const studies::Method& method : studies::methods()) {
      const std::string run = fmt::format(" CASE --method {} --duration {}", method.name,
                                          0.1 / text.number("excitation.frequency_hz"));
      rows.push_back({"respond", "respond" + run, &method});
      if (method.name == "fe" || method.name == "event-driven")
        rows.push_back({"animate", "animate" + run + " --frames 2", &method});
    }
    return rows;
  }

  [[nodiscard]] Outcome run_on(std::string arguments, const CaseText& text) const {
    std::ofstream("case.toml")
        << text.text()
        << "[uncertainty]\n\"beam.density\" = { distribution = 'normal', mean = 1000.0, "
           "standard_deviation = 1.0 }\n";
    arguments.replace(arguments.find("CASE"), 4, "case.toml");
    return run_line(arguments + " --quiet");
  }

  static bool refuses(const Row& row, const std::vector<Refusable>& present) {
    static const auto guide = table_below(
        contents(STICKSLIP_SOURCE_DIRECTORY "/reports/manual/user-guide.md"), "| command | `[damping]`");
    std::string said;
    for (const auto& [feature, key, column, named] : present) {
      std::string cell = column == 0 ? "yes" : guide.at(row.guide).at(column);
      if (row.guide == "animate" && feature == Feature::yielding_contact) cell = "no";
      if (row.method != nullptr && cell != "no") cell = row.method->refused.contains(feature) ? "no" : "yes";
      if (cell == "no") return true;
      said += cell + ";";
    }
    return holds(said, "without shear") && holds(said, "without damping");
  }

  // The sentence, which is of one line and names one of these with its value; nothing is written.
  void expect_form(const Outcome& outcome, const CaseText& text, const std::vector<Refusable>& present,
                   const Row& row) const {
    EXPECT_EQ(outcome.status, 2);
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(std::ranges::count(outcome.errors, '\n'), 1);
    EXPECT_TRUE(std::ranges::any_of(present, [&](const Refusable& one) {
      const std::string value = one.named == "--method"       ? row.method->name
                                : one.named.starts_with("--") ? one.named.substr(one.named.find(' ') + 1)
                                                              : data::shortest_text(text.number(one.named));
      return outcome.errors.starts_with(
          fmt::format("stickslip: {} is {}, but must be ", one.named.substr(0, one.named.find(' ')), value));
    })) << outcome.errors;
  }

  // Runs what the sentence allows, "but must be 0 for", and the methods that it names.
  void expect_true_advice(const std::string& sentence, const Row& row, const CaseText& text,
                          const std::string& more) const {
    const std::regex form("stickslip: (?:--[a-z]+: )?(\\S+) is \\S+, but must be (\\S+)(.*)\n");
    std::smatch parts;
    if (!std::regex_match(sentence, parts, form)) return;
    const std::string key = parts[1], allowed = parts[2], rest = parts[3];
    if (allowed == "0" || allowed == "inf") {
      CaseText other = text;
      other.set(key, allowed);
      if (key == "beam.shear_stiffness") other.erase("beam.poissons_ratio");
      EXPECT_EQ(run_on(row.arguments, other).status, 0) << key;
    }
    for (const studies::Method& method : studies::methods()) {
      if (&method == row.method ||
          !std::regex_search(allowed + rest, std::regex("\\b" + method.name + "\\b")))
        continue;
      const std::string run = fmt::format("respond CASE --duration 1e-4 --method {} {}", method.name, more);
      const Outcome outcome = run_on(run, text);
      EXPECT_EQ(outcome.status, 0) << sentence << run << outcome.errors;
    }
    if (holds(rest, "respond takes it")) {
      EXPECT_EQ(run_on("respond CASE --duration 1e-4", text).status, 0) << sentence;
    }
  }
};

STICKSLIP_VERIFIES(Refusals, "U2");
TEST_F(Refusals, AreThoseOfTheUserGuide) {
  const CaseDomain all{.highest_force = 0.1,  // a dead load buckles a free tip at an eighth of P_cr
                       .shortest = 4.0,
                       .longest = 4.0,
                       .lowest_frequency = 2.0,
                       .kelvin_voigt = 1.0,
                       .ratio = 1.0,
                       .shear = 1.0,
                       .fixed_direction = 1.0,
                       .moving_wall = 1.0,
                       .yielding = 1.0,
                       .jump = 0.0,
                       .viscous = 0.0};
  on_random_cases(1, all, [&](CaseText drawn, RandomNumbers& numbers) {
    CaseText plain = drawn;
    std::vector<Refusable> features;
    for (const Refusable& one : keys)
      if (drawn.has(one.key)) features.push_back(one), plain.erase(one.key);
    for (const auto& [key, value] : {std::pair{"elements", 8}, {"modes", 4}})
      plain.set(std::string("numerics.") + key, std::to_string(value));
    std::vector<std::vector<Refusable>> sets{{}};
    for (const Refusable& one : features) sets.push_back({one});
    for (int i = 0; i < 3; ++i) {
      auto& some = sets.emplace_back();
      for (const Refusable& one : features)
        if (numbers.uniform(0.0, 1.0) < 0.5) some.push_back(one);
    }
    for (const Row& row : rows_for(plain))
      for (const auto& present : sets) {
        CaseText text = plain;
        for (const Refusable& one : present) text.set(one.key, drawn.value(one.key));
        SCOPED_TRACE(row.arguments + "\n" + text.text());
        const Outcome outcome = run_on(row.arguments, text);
        EXPECT_EQ(outcome.status, refuses(row, present) ? 2 : 0) << outcome.errors;
        if (outcome.status != 2) continue;
        expect_form(outcome, text, present, row);
        if (present.size() == 1) expect_true_advice(outcome.errors, row, text, "");
      }
    for (const Row& row : rows_for(plain)) {
      if (row.guide != "respond") continue;
      for (const Refusable& option : options) {
        const std::string arguments = row.arguments + " " + option.key;
        SCOPED_TRACE(arguments);
        const Outcome outcome = run_on(arguments, plain);
        const bool is_refused = row.method->refused.contains(option.feature);
        EXPECT_EQ(outcome.status, is_refused ? 2 : 0) << outcome.errors;
        if (!is_refused) continue;
        expect_form(outcome, plain, {option}, row);
        expect_true_advice(outcome.errors, row, plain, option.key);
      }
    }
  });
}

// What options ask for together, or of a case: the key or option and its value, and what is meant where that is not told by the key.
constexpr std::pair<const char*, const char*> rows_of_options[] = {
    {"modes --set beam.axial_force=1e6", "beam.axial_force is 1e+06, but must be "},
    {"criterion --amplitude 1,5mm",
     "excitation.amplitude is 1,5mm, but must be written with a decimal point: 1.5"},
    {"criterion --set excitation.duration=1e5", "excitation.duration is 1e+05, but must be "},
    {"respond --from 1Hz", "--from is 1Hz, but must be "},
    {"respond --json", "--output FILE"},
    {"respond --json --output h.csv --events -", "--json and --events - both want standard output"},
    {"respond --method event-driven --set beam.axial_force=-10", "beam.axial_force is -10, but must be "},
    {"respond --scheme paper --set numerics.velocity_threshold=0", "must be above 0 (m/s)"},
    {"respond --scheme paper --set contact.tangential_stiffness=1e6",
     "tangential_stiffness is 1e+06, but must be inf "},
    {"respond --set friction.decay=inf --set contact.tangential_stiffness=1e6",
     "friction.decay is inf, but must be finite"},
    {"respond --method boundary-integral --set friction.decay=inf --set contact.regularisation_velocity=0.01",
     "friction.decay is inf, but must be finite"},
    {"respond --hz 25 --output h.csv --spectrum s.csv --duration 0.0799",
     "excitation.duration is 0.0799, but must be "},
    {"respond --hz 25 --output h.csv --spectrum s.csv --duration 0.08 --every 267",
     "--every is 267, but must be "},
    {"respond --duration 1e9", "--duration: excitation.duration is 1e+09, but must be "},
    {"respond --method boundary-integral --duration 0.1678 --set numerics.time_step=1e-8",
     "excitation.duration is 0.1678, but must be at most 0.168 s, 2^24 steps of 1e-08 s"},
    {"respond --figure a.jpg", "--figure is 'a.jpg', but must be "},
    {"respond --output b.png --figure b.png", "--figure is b.png, but must be another file than --output"},
    {"respond --events b.png --figure b.png", "--figure is b.png, but must be another file than --events"},
    {"respond --spectrum b.png --figure b.png",
     "--figure is b.png, but must be another file than --spectrum"},
    {"respond --duration 0.01 --output none/history.csv", "none/history.csv"},
    {"modes --count 9 --figure a.png", "--count is 9, but must be at most 8 with --figure"},
    {"modes --state slipp", "--state is slipp (did you mean slip?), but must be one of stick, slip"},
    {"modes paper damped", "the argument damped is one more than modes takes"},
    {"animate --output film.avi", "--output is film.avi, but must be a folder, a .gif or a .mp4 file"},
    {"animate --set beam.axial_force=-5", "beam.axial_force is -5, but must be "},
    {"animate --method closed-form", "--method is closed-form, but must be "},
    {"uncertainty uncertain --band 1e-30:30", "--band: excitation.frequency_hz is 1e-30, but must be "},
    {"uncertainty uncertain --band 40:30", "--band: TO is '30', but must be "},
    {"uncertainty uncertain --band 30:31 --hz 40", "--hz excludes --band"},
    {"uncertainty uncertain --band 30:40 --set damping.ratio=0.01", "must have no damping with a band"},
    {"uncertainty uncertain --amplitude 0", "excitation.amplitude is 0, but must be above 0 (m)"},
    {"uncertainty uncertain --set beam.axial_force=0", "beam.axial_force is 0, but must be positive"},
    {"uncertainty paper", "uncertainty is missing, but the case must have a table [uncertainty]"},
    {"design", "--band is required"},
    {"design --band 20:30 --amplitude 0", "--amplitude: excitation.amplitude is 0, but must be above 0"},
    {"design --band 20:30 --set beam.axial_force=0", "beam.axial_force is 0, but must be positive"},
    {"design rough-road --band 20:30",
     "excitation.spectrum is given, but must be left out: design takes a band of sines; for lengths"},
    {"nvh sdnd104 --average 2", "--average is given, but must be left out of a case without a spectrum"},
    {"design --band 20:30 --length 1e-3:2", "excitation.duration is 10, but must be at most "},
    {"nvh squeak-stand --transient 5", "--transient is 5, but must be below the duration of 5 s"},
    {"nvh squeak-stand --method closed-form", "--method is closed-form, but must be one that follows the"},
    {"nvh squeak-stand --method boundary-integral", "wall.speed is 0.004, but must be 0"},
    {"nvh squeak-stand --set numerics.time_step=1e-3",
     "numerics.time_step is 0.001, but must be at most 0.00081"},
    {"nvh squeak-stand --duration 1e5", "excitation.duration is 1e+05, but must be at most 3245 here"},
    {"squeal paper", "wall.speed is 0, but must be other than 0"},
    {"squeal reed --speed 0", "--speed: wall.speed is 0, but must be other than 0"},
    {"squeal reed --set numerics.elements=201", "numerics.elements is 201, but must be at most 200 here"},
    {"squeal reed --map m.csv", "--map requires --speeds"},
    {"squeal reed --speeds 0.1:1", "--speeds requires --ratios"},
    {"squeal reed --figure m.png", "--map FILE is missing"},
    {"squeal reed --map a.csv --speeds 1e-16:1 --ratios 0.01:0.02",
     "--speeds: wall.speed is 1e-16, but must be "},
    {"squeal reed --map a.csv --speeds 0.1:1 --ratios 0.01:2", "--ratios: damping.ratio is 2, but must be "},
    {"periodic reed --set wall.speed=0", "excitation.amplitude is 0, but must be above 0"},
    {"periodic reed --periods 2", "--periods is 2, but must be 1 where excitation.amplitude is 0"},
    {"report --only fig1 --tests .", "--tests excludes --only"},
    {"report --output report --only fig9,fig99",
     "--only names the figure 'fig99', but must name some of fig1, "},
    {"compare stick-frequencies - --json a --junit a", "--junit is a, but must be another file than --json"},
    {"sweep --parameter modes=1:2:3", "--parameter: PARAMETER is 'modes', but must be one of "},
    {"map --dry-run --x frequency=10:20:2 --y amplitude=1e-4:1e-3:2 --shard 5/50",
     "--shard is 5/50, but must be "},
    {"map --shard '' --output a", "--shard is '', but must be K/M"},
    {"map damped --quantity work --method closed-form", "of the verdict, but --quantity is work"},
    {"map --quantity work --states-only",
     "--states-only is an option of the verdict, but --quantity is work"},
    {"map --quantity works", "(did you mean work?)"},
    {"map --quantity work,verdict", "--quantity is 'verdict', but must be one of"},
    {"map --quantity work,", "--quantity is '', but must be one of verdict, slip-share, "},
    {"map --transient 1", "--transient needs a --quantity of the motion, but it is verdict"},
    {"map --tolerance 0.1", "--tolerance needs a --quantity of the motion, but it is verdict"},
    {"map --quantity work --tolerance 0", "--tolerance is 0, but must be above 0 and below 1\n"},
    {"map --quantity work --tolerance 1", "--tolerance is 1, but must be above 0 and below 1\n"},
    {"map --quantity work --transient 0 --duration 0.01",
     "excitation.duration is 0.01, but must be long enough"},
    {"map --quantity work --transient 10", "two periods of the base motion, 12 s"},
    {"map --set beam.axial_force=0 --x frequency=15:35:3", "beam.axial_force is 0, but must be positive"},
    {"map --set beam.axial_force=1e6 --x frequency=15:35:3", "buckling load"},
    {"map --duration 0.1 --output map.csv --x frequency=15:35:2 --figure none/map.png", "none/map.png"},
    {"map --x length=1:2:2 --y length=1:3:4",
     "both axes of the map are beam.length, but must be two parameters"},
    {"map --x frequency=15:35", "--x: the axis is 'frequency=15:35', but must be"},
    {"map --x frequncy=1:2:3", "--x: PARAMETER is 'frequncy', but must be one of length, area, "},
    {"map --x frequncy=1:2:3", "(did you mean frequency?)"},
    {"map --x height=1e-3:2e-3:3", "section.height is 0.001, but must be left out"},
    {"map --x length=1e-300:1:2", "--x: beam.length is 1e-300, but must be "},
    {"map --x length=-1:2:3", "--x: FROM is '-1', but must be a finite number above 0"},
    {"map --x length=1:2:2 --y amplitude=0:1e-3:5:log",
     "--y: FROM is '0', but must be a finite number above 0"},
    {"map --x length=1:inf:3", "--x: TO is 'inf', but must be a finite number above FROM, 1"},
    {"map --x length=2:1:3", "--x: TO is '1', but must be a finite number above FROM, 2"},
    {"map --x length=1:2:1", "--x: COUNT is '1', but must be an integer from 2 to 2000"},
    {"map --x length=1:2:+2", "--x: COUNT is '+2', but must be "},
    {"map --x length=1:2:2.0", "--x: COUNT is '2.0', but must be "},
};

TEST_F(Refusals, OfOptionsNameThemWithTheirValue) {
  for (const auto& [arguments, part] : rows_of_options) expect_refused(arguments, part);
  for (const std::string command :
       {"map --y length=1:2:2 --x ", "map --x length=1:2:2 --y ", "sweep --parameter "}) {
    const std::string option = command.substr(command.rfind("--"));
    expect_refused(command + "frequency=20:30:2 --hz 25",
                   "--hz is given, but " + option + "varies excitation.frequency_hz");
    expect_refused(command + "amplitude=1e-4:1e-3:2 --amplitude 1e-3",
                   "--amplitude is given, but " + option + "varies excitation.amplitude");
  }
  EXPECT_EQ(files().size(), 3u);  // stdout, stderr and tools
  EXPECT_EQ(run_line("map --states-only --duration 0.1 --x length=1:2:2000 --y amplitude=1e-4:1e-3:2").status,
            0);
}

}  // namespace
}  // namespace stickslip::testing
