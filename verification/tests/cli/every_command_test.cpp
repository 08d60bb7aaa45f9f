// SPDX-License-Identifier: MIT
/// What every command says of one point of a case is what `criterion` says of it, however the case states the motion of its base.

#include <numbers>

#include "support/command_line.hpp"
#include "support/random_cases.hpp"
#include "support/requirements.hpp"
#include "support/structures.hpp"

namespace stickslip::testing {
namespace {

using Json = nlohmann::json;

// A number of a case, which is varied, and its unit.
struct Varied {
  std::string key, unit;
  double value{};

  [[nodiscard]] std::string text(double share = 1.0) const {
    return data::shortest_text(share * value) + unit;
  }
};

class EveryCommand : public CommandLine {
 protected:
  [[nodiscard]] Json ask(Words words) const {
    words.insert(words.end(), {"--json", "--quiet"});
    const Outcome outcome = run_here(words);
    EXPECT_EQ(outcome.status, 0) << fmt::format("{}\n", fmt::join(words, " ")) << outcome.errors;
    return outcome.status == 0 ? Json::parse(outcome.output) : Json();
  }

  void write(const std::string& file, const std::string& text) const { std::ofstream(path(file)) << text; }

  // By numerics.modes.
  [[nodiscard]] static double margin_in(const Json& answer) {
    return answer["friction_limit_N"].get<double>() / answer["force_max_N"]["upper"].get<double>();
  }

  [[nodiscard]] Json criterion(const Varied& at) const {
    return ask({"criterion", "case.toml", "--set", at.key + "=" + at.text()});
  }

  // A row for each case and point, in JSON and in the file, with all modes and the steady force.
  void expect_plan(const Varied& at, const Json& one) const {
    write("plan.csv", at.key + "\n" + at.text() + "\n" + at.text(1.1) + "\n");
    write("other.toml", contents("case.toml"));
    const Json rows =
        ask({"criterion", "other.toml", "case.toml", "--plan", "plan.csv", "--output", "table.csv"})["cases"];
    ASSERT_EQ(rows.size(), 4u);
    const Json& row = rows[2];
    EXPECT_EQ(rows[1]["case"], "other");
    EXPECT_EQ(row["case"], "case");
    EXPECT_EQ(row[at.key], at.text());
    const Json& all = one["all_modes"];
    for (const char* key : {"frequency_hz", "amplitude_m"}) EXPECT_EQ(row[key], one[key]);
    for (const char* key : {"friction_limit_N", "critical_amplitude_m", "verdict"})
      EXPECT_EQ(row[key], all.value(key, Json()));
    EXPECT_EQ(row["force_lower_N"], all["force_max_N"]["lower"]);
    EXPECT_EQ(row["force_upper_N"], all["force_max_N"]["upper"]);
    EXPECT_EQ(row["steady_force_N"], one["steady"]["force_N"]);
    const double margin = row["margin"];
    EXPECT_LE(one["margin"]["lower"], margin);
    EXPECT_GE(one["margin"]["upper"], margin);
    auto columns = columns_of(contents("table.csv"));
    EXPECT_EQ(columns["case"], (Words{"other", "other", "case", "case"}));
    EXPECT_EQ(std::stod(columns["force_lower_N"].at(2)), row["force_lower_N"]);
  }

  // The critical amplitude brings |f| to the limit, by some modes and by all.
  static void expect_consistent(const Json& answer) {
    const bool is_force = answer["amplitude_m"].is_null();
    const double amplitude = is_force ? 0.0 : answer["amplitude_m"].get<double>();
    for (const Json& one : {answer, answer["all_modes"]}) {
      const double lower = one["force_max_N"]["lower"], upper = one["force_max_N"]["upper"],
                   limit = one["friction_limit_N"];
      EXPECT_LE(lower, upper);
      EXPECT_EQ(one["verdict"], lower > limit ? "stick-slip" : "stick");
      if (is_force) continue;
      EXPECT_DOUBLE_EQ(one["critical_amplitude_bounds_m"]["lower"], amplitude * limit / upper);
      EXPECT_DOUBLE_EQ(one["critical_amplitude_bounds_m"]["upper"], amplitude * limit / lower);
      EXPECT_DOUBLE_EQ(one["critical_amplitude_m"], 0.5 * amplitude * limit * (1.0 / lower + 1.0 / upper));
    }
    const double limit = answer["friction_limit_N"];
    EXPECT_DOUBLE_EQ(answer["margin"]["lower"],
                     limit / answer["all_modes"]["force_max_N"]["upper"].get<double>());
    EXPECT_DOUBLE_EQ(answer["margin"]["upper"],
                     limit / answer["all_modes"]["force_max_N"]["lower"].get<double>());
  }

  [[nodiscard]] std::string axis(const Varied& at) const {
    return at.key + "=" + at.text() + ":" + at.text(1.0 + 1e-9) + ":2";
  }

  [[nodiscard]] double by_map(const Varied& at, const Json& one) const {
    (void)ask(
        {"map", "case.toml", "--x", axis(at), "--y", "friction.viscous=0:1e-9:2", "--output", "map.csv"});
    auto columns = columns_of(contents("map.csv"));
    EXPECT_EQ(columns["state"].at(0), one["verdict"]);
    return 1.0 / std::stod(columns["force_ratio"].at(0));
  }

  [[nodiscard]] double by_python(const Varied& at) const {
    const Outcome outcome = shell(fmt::format(
        "PYTHONPATH='{}/reports/python' STICKSLIP_PROGRAM='{}' /usr/bin/python3 -B -c \"import stickslip\n"
        "answer = stickslip.criterion('case.toml', **{{'{}': '{}'}})\n"
        "print(repr(answer['friction_limit_N'] / answer['force_max_N']['upper']))\"",
        STICKSLIP_SOURCE_DIRECTORY, STICKSLIP_PROGRAM, at.key, at.text()));
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return std::strtod(outcome.output.c_str(), nullptr);
  }

  [[nodiscard]] Json by_uncertainty(const std::string& case_text, const Varied& at,
                                    const Words& more = {}) const {
    const std::string quote = at.unit.empty() ? "" : "'";
    write("uncertain.toml", fmt::format("{0}[uncertainty]\n\"{1}\" = {{ distribution = 'uniform', lower = "
                                        "{2}{3}{2}, upper = {2}{4}{2} }}\n",
                                        case_text, at.key, quote, at.text(), at.text(1.0 + 1e-9)));
    Words words{"uncertainty", "uncertain.toml", "--samples", "4"};
    words.insert(words.end(), more.begin(), more.end());
    return ask(words);
  }

  [[nodiscard]] Json by_design(const CaseText& text, const std::string& band, Words words = {}) const {
    const auto narrow = [&](const char* key) {
      return fmt::format("{0}:{1}", text.number(key), 1.0001 * text.number(key));
    };
    words.insert(words.begin(), {"design", "case.toml", "--band", band});
    if (text.has("beam.length"))
      words.insert(words.end(), {"--length", narrow("beam.length"), "--force", narrow("beam.axial_force")});
    return ask(words);
  }

  void expect_points(const CaseText& text, const std::vector<Varied>& points) const;
  void expect_band(const CaseText& text) const;
  void expect_sweep(const Varied& at) const;
};

// Bounds of `design` are 1e-6 wide, of a band with uncertain keys 1e-3 in the middle; the others are sharper.
Tolerance bounds_of(double width, double margin) { return reference(width * margin, "the bounds"); }

void EveryCommand::expect_points(const CaseText& text, const std::vector<Varied>& points) const {
  for (const Varied& at : points) {
    SCOPED_TRACE("stickslip criterion case.toml --set '" + at.key + "=" + at.text() + "'");
    const Json one = criterion(at);
    expect_consistent(one);
    expect_plan(at, one);
    const double expected = margin_in(one);
    const Tolerance sharp = bounds_of(3e-6, expected);
    EXPECT_TRUE(within(by_map(at, one), expected, sharp));
    const Json uncertain = by_uncertainty(text.text(), at);
    EXPECT_TRUE(within(uncertain["quantiles"][2]["margin"]["value"], expected, sharp));
    EXPECT_EQ(uncertain["probability_of_slip"], expected < 1.0 ? 1.0 : 0.0);
    if (at.key != "excitation.frequency_hz") continue;
    EXPECT_TRUE(within(by_python(at), expected, round_off(1, 1, expected)));
    expect_sweep(at);
    const std::string band = at.text() + ":" + at.text();
    const Json design = by_design(text, band);
    EXPECT_TRUE(within(design["margin"]["lower"], expected, sharp));
    if (is_damped(text)) {
      // of all modes; what is left out falls at least as 1/modes, so that twice as many change more than they leave out
      const double steady = one["friction_limit_N"].get<double>() / one["steady"]["force_N"].get<double>(),
                   with_twelve = design["steady_margin"]["lower"],
                   with_more =
                       by_design(text, band, {"--set", "numerics.modes=24"})["steady_margin"]["lower"];
      EXPECT_TRUE(within(
          with_more, steady,
          discretisation(std::abs(with_twelve - with_more) + sharp.value, 1.0, "modes that are left out")));
      continue;
    }
    const Varied friction{"friction.static_coefficient", "", text.number("friction.static_coefficient")};
    EXPECT_TRUE(within(by_uncertainty(text.text(), friction, {"--band", band})["margin_of_case"], expected,
                       bounds_of(2e-3, expected)));
  }
}

// The first point of a sweep is a run of a period from the start, by other steps, which tell where a run does not warn of its own.
void EveryCommand::expect_sweep(const Varied& at) const {
  const double period = 1.0 / at.value;
  const std::string step = "numerics.time_step=" + data::shortest_text(period / 2000.0);
  const Json run = ask({"respond", "case.toml", "--set", step, "--set", at.key + "=" + at.text(),
                        "--duration", data::shortest_text(period), "--output", "history.csv"});
  for (const char* warning : {"grows without end", "with twice the step"})
    if (holds(run["warnings"].dump(), warning)) return;
  (void)ask({"sweep", "case.toml", "--set", step, "--settle", "0", "--periods", "1", "--parameter", axis(at),
             "--output", "sweep.csv"});
  auto section = columns_of(contents("sweep.csv")), history = columns_of(contents("history.csv"));
  for (const auto& [name, scale] :
       {std::pair{"tip_displacement_m", "base_displacement_m"}, {"friction_force_N", "friction_force_N"}}) {
    double most = 1e-6;  // a shaker leaves the base at rest
    for (const std::string& cell : history[scale]) most = std::max(most, std::abs(std::stod(cell)));
    EXPECT_TRUE(within(std::stod(section[name].at(0)), std::stod(history[name].back()),
                       discretisation(0.02 * most, 1, "steps of both")));
  }
}

// The worst frequency of a band is one of it, and no other is worse. With damping a start lasts as many periods at each of them.
void EveryCommand::expect_band(const CaseText& text) const {
  const double hz = text.number("excitation.frequency_hz"), last = 1.3 * hz;
  const auto by_criterion = [&](double at) {
    const double duration = text.number("excitation.duration") * (is_damped(text) ? last / at : 1.0);
    return margin_in(
        ask({"criterion", "case.toml", "--set", "excitation.frequency_hz=" + data::shortest_text(at), "--set",
             "excitation.duration=" + data::shortest_text(duration)}));
  };
  const Json answer = by_design(text, fmt::format("{}:{}", 0.9 * hz, last));
  const double worst = answer["frequency_hz"], margin = answer["margin"]["upper"];
  EXPECT_TRUE(within(margin, by_criterion(worst), bounds_of(3e-6, margin)));
  for (const double share : {0.9, 1.0, 1.1, 1.2, 1.3})
    EXPECT_GE(by_criterion(share * hz), answer["margin"]["lower"].get<double>());
}

STICKSLIP_VERIFIES(EveryCommand, "U1");
TEST_F(EveryCommand, SaysOfAPointWhatCriterionSays) {
  const CaseDomain domain{
      .highest_force = 0.9, .kelvin_voigt = 0.25, .ratio = 0.25, .fixed_direction = 0.0, .units = 0.5};
  std::size_t tried = 0;
  on_random_cases(4, domain, [&](const CaseText& drawn, RandomNumbers&) {
    const Statement& statement = statements[tried++ % statements.size()];
    CaseText text = stated(drawn, statement);
    text.set("numerics.modes", "12");
    SCOPED_TRACE(text.text());
    write("case.toml", text.text());
    const Json said = ask({"criterion", "case.toml"});
    const double amplitude = drawn.number("excitation.amplitude");
    EXPECT_EQ("excitation." + said["stated_as"].get<std::string>(), statement.key);
    EXPECT_TRUE(within(said["amplitude_m"], amplitude, round_off(4, 1, amplitude)));
    expect_points(
        text, {{"excitation.frequency_hz", "", 1.7 * text.number("excitation.frequency_hz")},
               {"beam.length", "", 0.93 * text.number("beam.length")},
               {"friction.static_coefficient", "", 1.2 * text.number("friction.static_coefficient")},
               {"excitation.amplitude", statement.unit, 1.3 * text.number(statement.key) / statement.one}});
    expect_band(text);
  });
}

// One mass, or the matrices of a random structure, with the base or a shaker as the excitation.
TEST_F(EveryCommand, SaysOfAnyStructureTheSame) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    RandomNumbers numbers(seed);
    CaseText text = random_model(numbers, path("."));
    text.set("numerics.modes", "12");
    SCOPED_TRACE(text.text());
    write("case.toml", text.text());
    const std::string amplitude = text.has("excitation.force") ? "excitation.force" : "excitation.amplitude";
    expect_points(text,
                  {{"excitation.frequency_hz", "", 1.7 * text.number("excitation.frequency_hz")},
                   {"friction.static_coefficient", "", 1.2 * text.number("friction.static_coefficient")},
                   {"model.normal_force", "", 0.9 * text.number("model.normal_force")},
                   {amplitude, "", 1.3 * text.number(amplitude)}});
    expect_band(text);
  }
}

// Sines, a sweep or a shock of base and wall. What the modes left out can change is in the bounds of criterion alone.
TEST_F(EveryCommand, SaysOfAnyMotionTheSame) {
  on_random_cases(5, {.shortest = 2.0, .any_motion = 1.0}, [&](CaseText text, RandomNumbers&) {
    text.set("numerics.modes", "12");
    write("case.toml", text.text());
    for (const Varied& at :
         {Varied{"excitation.scale", "", 0.7},
          {"beam.length", "", 0.93 * text.number("beam.length")},
          {"friction.static_coefficient", "", 1.2 * text.number("friction.static_coefficient")}}) {
      const std::string setting = at.key + "=" + at.text();
      SCOPED_TRACE("stickslip criterion case.toml --set " + setting);
      const Json one = ask({"criterion", "case.toml", "--set", setting});
      const double lower = one["margin"]["lower"], upper = one["margin"]["upper"];
      write("plan.csv", at.key + "\n" + at.text() + "\n");
      const double in_table = ask({"criterion", "case.toml", "--plan", "plan.csv"})["cases"][0]["margin"];
      for (const double margin :
           {by_map(at, one), by_uncertainty(text.text(), at)["quantiles"][2]["margin"]["value"].get<double>(),
            in_table}) {
        EXPECT_GE(margin, lower * (1.0 - 1e-6));
        EXPECT_LE(margin, upper * (1.0 + 1e-6));
      }
      EXPECT_TRUE(within(by_python(at), lower, round_off(1, 1, lower)));
    }
  });
}

// A tenth on one key, made as the user would, and better than a tenth on any other.
TEST_F(EveryCommand, MakesItsBestChangeTrue) {
  const CaseDomain many_modes{.highest_force = 0.7,
                              .shortest = 1e3,
                              .longest = 3e3,
                              .lowest_frequency = 70.0,
                              .highest_frequency = 300.0,
                              .kelvin_voigt = 0.0,
                              .ratio = 0.0,
                              .shear = 0.5};
  int tried = 0;
  on_random_cases(8, many_modes, [&](const CaseText& text, RandomNumbers&) {
    write("case.toml", text.text());
    const auto by_criterion = [&](const std::string& key, double factor) {  // nothing where that is no beam
      const Varied at{key, "", factor * text.number(key)};
      const Outcome outcome =
          run_here({"criterion", "case.toml", "--json", "--set", at.key + "=" + at.text()});
      return outcome.status == 0 ? margin_in(Json::parse(outcome.output)) : 0.0;
    };
    const Json best = ask({"criterion", "case.toml"})["best_change"];
    if (best.is_null()) return;  // the modes that are kept are too few
    ++tried;
    const std::string key = best["key"];
    const double margin = best["margin"];
    EXPECT_TRUE(within(margin, by_criterion(key, best["factor"]), bounds_of(1e-9, margin)));
    for (const char* other : {"beam.length", "section.height", "friction.static_coefficient"})
      for (const double factor : {0.9, 1.1})
        EXPECT_LE(by_criterion(other, factor), margin * (1.0 + 1e-9)) << other;
  });
  EXPECT_GT(tried, 2);
  const Json at_rest = ask({"criterion", "paper", "--amplitude", "0"});
  for (const char* key : {"margin", "best_change"}) EXPECT_TRUE(at_rest.at(key).is_null()) << key;
}

// A claim that fails is told with the simplest of its cases.
TEST_F(EveryCommand, IsAskedInTheSimplestCase) {
  RandomNumbers numbers(1);
  const CaseText text = random_case(numbers, {.kelvin_voigt = 1.0, .ratio = 1.0, .moving_wall = 1.0});
  const auto claim = [](const CaseText& of, RandomNumbers&) { EXPECT_FALSE(of.has("damping.kelvin_voigt")); };
  EXPECT_EQ(failures_of(claim, text, numbers).size(), 1u);
  const CaseText least = simplest(claim, text, numbers);
  EXPECT_TRUE(least.has("damping.kelvin_voigt"));
  for (const char* feature : {"damping.ratio", "damping.mass_proportional", "wall.speed", "friction.decay"})
    EXPECT_FALSE(least.has(feature)) << feature;
}

}  // namespace
}  // namespace stickslip::testing
