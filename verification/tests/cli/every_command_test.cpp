// SPDX-License-Identifier: MIT
/// What every command says of one point of a case is what `criterion` says of it, however the case states the motion of its base.

#include <numbers>

#include "support/command_line.hpp"
#include "support/random_cases.hpp"
#include "support/requirements.hpp"

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
  [[nodiscard]] Json ask(std::vector<std::string> words) const {
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

  [[nodiscard]] double by_criterion(const Varied& at) const {
    return margin_in(ask({"criterion", "case.toml", "--set", at.key + "=" + at.text()}));
  }

  [[nodiscard]] double by_plan(const Varied& at) const {
    write("plan.csv", at.key + "\n" + at.text() + "\n");
    return ask({"criterion", "case.toml", "--plan", "plan.csv"})["cases"][0]["margin"];
  }

  [[nodiscard]] double by_map(const Varied& at) const {
    const std::string x = at.key + "=" + at.text() + ":" + at.text(1.0 + 1e-9) + ":2";
    const Outcome outcome = run_here(
        {"map", "case.toml", "--x", x, "--y", "beam.axial_direction=0:0.5:2", "--output", "-", "--quiet"});
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    return 1.0 / std::stod(csv(outcome.output).at(1).at(2));
  }

  [[nodiscard]] Json by_uncertainty(const std::string& case_text, const Varied& at,
                                    const std::vector<std::string>& more = {}) const {
    const std::string quote = at.unit.empty() ? "" : "'";
    write("uncertain.toml", fmt::format("{0}[uncertainty]\n\"{1}\" = {{ distribution = 'uniform', lower = "
                                        "{2}{3}{2}, upper = {2}{4}{2} }}\n",
                                        case_text, at.key, quote, at.text(), at.text(1.0 + 1e-9)));
    std::vector<std::string> words{"uncertainty", "uncertain.toml", "--samples", "4"};
    words.insert(words.end(), more.begin(), more.end());
    return ask(words);
  }

  [[nodiscard]] Json by_design(const CaseText& text, const std::string& band) const {
    const auto narrow = [&](const char* key) {
      return fmt::format("{0}:{1}", number(text, key), 1.0001 * number(text, key));
    };
    return ask({"design", "case.toml", "--band", band, "--length", narrow("beam.length"), "--force",
                narrow("beam.axial_force")});
  }

  [[nodiscard]] static double number(const CaseText& text, const std::string& key) {
    return data::value_of(text.problem(), key);
  }

  void expect_points(const CaseText& text, const std::vector<Varied>& points) const;
  void expect_band(const CaseText& text) const;
};

// The same motion, stated by the key and with the unit, of one in SI units.
CaseText stated(CaseText text, const std::string& key, const std::string& unit, double one) {
  const double value = data::value_of(text.problem(), key) / one;
  text.erase("excitation.amplitude");
  text.set(unit == "g" ? "excitation.amplitude" : key, "\"" + data::shortest_text(value) + " " + unit + "\"");
  text.set("numerics.modes", "12");
  return text;
}

// Bounds of `design` are 1e-6 wide, of a band with uncertain keys 1e-3 in the middle; the others are sharper.
Tolerance bounds_of(double width, double margin) { return reference(width * margin, "the bounds"); }

void EveryCommand::expect_points(const CaseText& text, const std::vector<Varied>& points) const {
  for (const Varied& at : points) {
    SCOPED_TRACE("stickslip criterion case.toml --set '" + at.key + "=" + at.text() + "'");
    const double expected = by_criterion(at);
    const Tolerance sharp = bounds_of(3e-6, expected);
    const double all_modes =
        ask({"criterion", "case.toml", "--set", at.key + "=" + at.text()})["margin"]["lower"];
    EXPECT_TRUE(within(by_plan(at), all_modes, bounds_of(1e-3, all_modes)));
    EXPECT_TRUE(within(by_map(at), expected, sharp));
    EXPECT_TRUE(within(by_uncertainty(text.text(), at)["quantiles"][2]["margin"]["value"], expected, sharp));
    if (at.key != "excitation.frequency_hz") continue;
    const std::string band = at.text() + ":" + at.text();
    EXPECT_TRUE(within(by_design(text, band)["margin"]["lower"], expected, sharp));
    if (text.has("damping.kelvin_voigt") || text.has("damping.ratio")) continue;
    const Varied friction{"friction.static_coefficient", "", number(text, "friction.static_coefficient")};
    EXPECT_TRUE(within(by_uncertainty(text.text(), friction, {"--band", band})["margin_of_case"], expected,
                       bounds_of(2e-3, expected)));
  }
}

// The worst frequency of a band is one of it, and no other is worse.
void EveryCommand::expect_band(const CaseText& text) const {
  const double hz = number(text, "excitation.frequency_hz");
  const Json answer = by_design(text, fmt::format("{}:{}", 0.9 * hz, 1.3 * hz));
  const double worst = answer["frequency_hz"], margin = answer["margin"]["upper"];
  EXPECT_TRUE(within(margin, by_criterion({"excitation.frequency_hz", "", worst}), bounds_of(3e-6, margin)));
  for (const double share : {0.9, 1.0, 1.1, 1.2, 1.3})
    EXPECT_GE(by_criterion({"excitation.frequency_hz", "", share * hz}),
              answer["margin"]["lower"].get<double>());
}

STICKSLIP_VERIFIES(EveryCommand, "U1");
TEST_F(EveryCommand, SaysOfAPointWhatCriterionSays) {
  const CaseDomain domain{.highest_force = 0.9, .kelvin_voigt = 0.25, .ratio = 0.25, .fixed_direction = 0.0};
  const std::vector<std::tuple<std::string, std::string, double>> statements{
      {"excitation.amplitude", "mm", 1e-3},
      {"excitation.velocity_amplitude", "m/s", 1.0},
      {"excitation.acceleration_amplitude", "g", 9.80665}};
  on_random_cases(3, domain, [&](const CaseText& drawn, RandomNumbers&) {
    for (const auto& [key, unit, one] : statements) {
      const CaseText text = stated(drawn, key, unit, one);
      SCOPED_TRACE(text.text());
      write("case.toml", text.text());
      const Json said = ask({"criterion", "case.toml"});
      EXPECT_EQ("excitation." + said["stated_as"].get<std::string>(), key);
      EXPECT_TRUE(within(said["amplitude_m"], number(drawn, "excitation.amplitude"),
                         round_off(4, 1, number(drawn, "excitation.amplitude"))));
      expect_points(text,
                    {{"excitation.frequency_hz", "", 1.7 * number(text, "excitation.frequency_hz")},
                     {"beam.length", "", 0.93 * number(text, "beam.length")},
                     {"friction.static_coefficient", "", 1.2 * number(text, "friction.static_coefficient")},
                     {"excitation.amplitude", unit, 1.3 * number(text, key) / one}});
      expect_band(text);
    }
  });
}

// A tenth on one key, made as the user would.
TEST_F(EveryCommand, SaysOfItsBestChangeWhatCriterionSays) {
  const CaseDomain many_modes{.shortest = 1e3,
                              .longest = 3e3,
                              .lowest_frequency = 70.0,
                              .highest_frequency = 300.0,
                              .kelvin_voigt = 0.0,
                              .ratio = 0.0,
                              .shear = 0.5};
  on_random_cases(8, many_modes, [&](const CaseText& text, RandomNumbers&) {
    write("case.toml", text.text());
    const Json best = ask({"criterion", "case.toml"})["best_change"];
    const std::string key = best["key"];
    EXPECT_FALSE(key.starts_with("excitation.")) << key;
    const double margin = best["margin"];
    EXPECT_TRUE(within(margin, by_criterion({key, "", best["factor"].get<double>() * number(text, key)}),
                       bounds_of(1e-9, margin)));
  });
}

}  // namespace
}  // namespace stickslip::testing
