// SPDX-License-Identifier: MIT
/// What the commands answer: every field of their JSON, options with each method, and digits that are true.

#include "answer.hpp"
#include "stickslip/analytic/amplitude_spectrum.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/reference.hpp"
#include "support/command_line.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

double number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

class CommandAnswers : public Drawing {
 protected:
  using Table = std::vector<std::vector<std::string>>;

  // The JSON of a run whose rows are in history.csv and whose changes of contact are in events.csv.
  [[nodiscard]] nlohmann::json respond(const std::string& options) const {
    return json("respond " + options + " --output history.csv");
  }
  [[nodiscard]] Table rows() const { return table("history.csv"); }
  [[nodiscard]] Table events() const { return table("events.csv"); }
  [[nodiscard]] std::string with_events() const { return " --events events.csv"; }

  // The numbers of the printed table.
  [[nodiscard]] std::vector<std::string> printed(const std::string& options) const {
    std::istringstream lines(run("modes --digits 17 " + options).output);
    std::vector<std::string> texts;
    std::string line;
    for (int n = 1; std::getline(lines, line);)
      if (line.starts_with(fmt::format("{:>4}  ", n))) {
        texts.push_back(line.substr(6));
        ++n;
      }
    return texts;
  }

  // Of the published package, with more digits than a double holds.
  static std::vector<long double> published(const std::string& state, const std::string& beam) {
    std::vector<long double> values;
    for (const auto& row : csv(contents(data::reference_directory() / ("frequencies/" + state + ".csv"))))
      if (row[0] == beam) values.push_back(std::strtold(row[2].c_str(), nullptr));
    return values;
  }

 private:
  [[nodiscard]] Table table(const std::string& name) const {
    Table all = csv(contents(name));
    all.erase(all.begin());
    return all;
  }
};

// --- respond

STICKSLIP_VERIFIES(CommandAnswers, "U1");
TEST_F(CommandAnswers, RespondSaysInJsonWhatItsRowsHold) {
  for (const std::string method : {"fe", "event-driven", "boundary-integral", "closed-form"}) {
    SCOPED_TRACE(method);
    const bool follows_slip = method != "closed-form";
    const auto answer = respond("paper --hz 25 --amplitude 1e-3 --duration 0.08 --method " + method +
                                (follows_slip ? with_events() : ""));
    const auto history = rows();
    double largest = 0.0;
    for (const auto& row : history) largest = std::max(largest, std::abs(number(row[5])));
    EXPECT_EQ(answer["case"], "paper");
    EXPECT_EQ(answer["method"], method);
    EXPECT_EQ(answer["frequency_hz"], 25.0);
    EXPECT_EQ(answer["amplitude_m"], 1e-3);
    EXPECT_EQ(answer["duration_s"], 0.08);
    EXPECT_EQ(answer["output"], "history.csv");
    EXPECT_EQ(answer["rows"], history.size());
    EXPECT_EQ(answer["largest_friction_force_N"], largest);
    EXPECT_NEAR(answer["first_slip_s"].get<double>(), 0.05525, 1e-4);
    EXPECT_EQ(answer.contains("scheme"), method == "fe");
    EXPECT_EQ(answer.contains("integration_step_s"), method == "boundary-integral");
    EXPECT_EQ(answer.contains("largest_change_on_twice_the_step_m"), method == "boundary-integral");
    if (follows_slip) {
      const auto changes = events();
      ASSERT_FALSE(changes.empty());
      EXPECT_EQ(answer["changes_of_contact"], changes.size());
      EXPECT_EQ(answer["first_slip_s"], number(changes[0][0]));
      EXPECT_EQ(changes[0][1], "onset");
      EXPECT_EQ(std::ranges::count_if(changes, [](const auto& change) { return number(change[0]) < 0.06; }),
                1);
    } else {
      const auto first = std::ranges::find_if(
          history, [](const auto& row) { return std::abs(number(row[5])) > 300.0; });  // mu_s P
      ASSERT_NE(first, history.end());
      EXPECT_EQ(answer["changes_of_contact"], 0);
      EXPECT_EQ(answer["first_slip_s"], number(first->at(0)));
    }
  }
  EXPECT_TRUE(respond("paper --hz 25 --amplitude 1e-4 --duration 0.02")["first_slip_s"].is_null());
}

TEST_F(CommandAnswers, RespondOfAHistoryThatEndsInSlipKeepsTheSlip) {
  // The damped beam lets go at 0.0553 s and is still sliding at 0.0605 s.
  for (const std::string method : {"fe", "event-driven", "boundary-integral"}) {
    const auto answer = respond("damped --duration 0.0605 --method " + method + with_events());
    const auto history = rows(), changes = events();
    ASSERT_EQ(changes.size(), 1u) << method;
    EXPECT_EQ(changes[0][1], "onset");
    EXPECT_NEAR(number(changes[0][0]), 0.05532, 2e-5);
    EXPECT_NEAR(number(changes[0][2]), 0.0, 1e-12);
    EXPECT_EQ(answer["changes_of_contact"], 1);
    EXPECT_EQ(history.back()[6], "slip") << method;
    EXPECT_NEAR(number(history.back()[2]), 4.174e-4, 2e-6) << method;
    EXPECT_NEAR(number(history.back()[4]), 0.1773, 1e-3) << method;
    EXPECT_NEAR(number(history.back()[5]), 275.6, 0.2) << method;
  }
}

TEST_F(CommandAnswers, RespondStartsFromRestByBothMethods) {
  // At rest in space of the base, u_t(x, 0) = 0, the beam first moves with the base: y(L/2) = h. After 10 ms
  // both methods still agree to less than 1 % of what the other start changes.
  const auto midspan = [&](const std::string& method, const std::string& start, std::size_t row) {
    (void)respond(
        "paper --hz 15 --amplitude 0.5e-3 --duration 0.01 --set numerics.modes=40 "
        "--set numerics.elements=40 --method " +
        method + " --initial-velocity " + start);
    return number(rows()[row][3]);
  };
  const double base = 0.5e-3 * std::sin(2.0 * std::numbers::pi * 15.0 * 1e-4);
  for (const std::string method : {"fe", "event-driven"}) {
    EXPECT_NEAR(midspan(method, "zero", 1), base, 1e-3 * base) << method;
    EXPECT_NEAR(midspan(method, "quasi-static", 1), 11.0 / 16.0 * base, 1e-2 * base) << method;  // P = 0
  }
  const double stepped = midspan("fe", "zero", 100);
  const double effect = stepped - midspan("fe", "quasi-static", 100);
  EXPECT_GT(effect, 1.5e-4);
  EXPECT_NEAR(midspan("event-driven", "zero", 100), stepped, 0.01 * effect);
}

// --- modes

std::size_t digits_in(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return c >= '0' && c <= '9'; })) -
         (text.starts_with("0.") ? 1 : 0);
}

TEST_F(CommandAnswers, ModesPrintsDigitsOfTheClosedFormThatAreTrue) {
  for (const std::string state : {"stick", "slip"})
    for (const std::string beam : {"paper", "steel-strip", "soft-short", "near-buckling"}) {
      const auto reference = published(state, beam);
      const auto texts = printed(beam + " --count 10 --state " + state);
      const auto answer = json("modes " + beam + " --count 10 --state " + state);
      ASSERT_EQ(texts.size(), 10u);
      ASSERT_EQ(reference.size(), 10u);
      for (std::size_t n = 0; n < 10; ++n) {
        const std::size_t point = texts[n].find('.');
        ASSERT_NE(point, std::string::npos) << texts[n];
        const long double unit = std::pow(10.0L, -static_cast<long double>(texts[n].size() - point - 1));
        const long double error = std::abs(std::strtold(texts[n].c_str(), nullptr) - reference[n]);
        EXPECT_LE(error, 1.5L * unit) << beam << " " << state << " " << n + 1 << ": " << texts[n];
        // As many as the estimate of the relative error leaves: 10^-digits is above it, a tenth of that
        // below.
        const double estimate = answer["relative_error_estimates"][n];
        const auto digits = static_cast<double>(digits_in(texts[n]));
        EXPECT_GE(std::pow(10.0, -digits), estimate);
        EXPECT_LT(std::pow(10.0, -digits - 1.0), estimate);
        EXPECT_LE(
            std::abs(static_cast<long double>(answer["frequencies_hz"][n].get<double>()) / reference[n] -
                     1.0L),
            static_cast<long double>(estimate));
        EXPECT_LT(estimate, beam == "near-buckling" ? 1e-12 : 1e-14) << beam << " " << state << " " << n + 1;
      }
    }
}

TEST_F(CommandAnswers, ModesEstimatesTheMeshErrorToATenth) {
  // The estimate is the leading error; on 40 elements the next one is below 1 % for these modes.
  const std::string shear = " --set beam.shear_stiffness=6.41e6";
  for (const auto& [state, beam] : std::vector<std::pair<std::string, std::string>>{
           {"stick", ""}, {"slip", ""}, {"stick", shear}, {"slip", shear + " --set beam.axial_force=0"}}) {
    const auto exact = json("modes --count 5 --state " + state + beam);
    const auto mesh = json("modes --count 5 --method fe --set numerics.elements=40 --state " + state + beam);
    EXPECT_EQ(mesh["elements"], 40);
    EXPECT_FALSE(exact.contains("elements"));
    EXPECT_EQ(mesh["state"], state);
    EXPECT_EQ(mesh["method"], "fe");
    EXPECT_EQ(exact["method"], "closed-form");
    EXPECT_EQ(exact["case"], "paper");
    for (std::size_t n = 0; n < 5; ++n) {
      const double error =
          mesh["frequencies_hz"][n].get<double>() / exact["frequencies_hz"][n].get<double>() - 1.0;
      EXPECT_NEAR(error / mesh["relative_error_estimates"][n].get<double>(), 1.0, 0.1)
          << state << beam << " " << n + 1;
    }
  }
  EXPECT_TRUE(holds(run("modes --method fe --set numerics.elements=40").output,
                    "\nstick state, 40 finite elements\n"));
  EXPECT_TRUE(holds(run("modes --state slip").output, "\nslip state, closed form\n"));
}

// Without axial force the stick frequencies are as accurate as the data, and b of a clamped-free beam is a root of C =
// 2 b^4 (1/cosh b + cos b). Half the buckling load doubles the error with shear; tension does not.
TEST_F(CommandAnswers, ModesEstimatesTheRoundingOfTheClosedForm) {
  const auto units = [&](const std::string& options) {
    std::vector<double> errors = json("modes --set beam.axial_force=" + options)["relative_error_estimates"];
    for (double& error : errors) error /= 4.0 * std::numeric_limits<double>::epsilon();
    return errors;
  };
  EXPECT_EQ(units("0"), std::vector<double>(3, 1.0));
  const auto slip = units("0 --state slip");
  const std::vector<double> roots{1.8751040687119611, 4.694091132974175, 7.854757438237612};
  for (std::size_t n = 0; n < roots.size(); ++n) {
    const double b = roots[n], shape = 1.0 / std::cosh(b);
    const double slope = b * std::abs(std::sin(b) + shape * std::tanh(b));  // (b/2) dC/db over 2 b^4, times 2
    EXPECT_NEAR(slip[n], 1.0 + 2.0 * (1.0 + shape) / slope, 1e-8) << n + 1;  // a difference of steps of 1e-6
  }
  const std::string shear = " --set beam.shear_stiffness=6.41e6";
  const double load = analytic::stick_buckling_load(
      data::load_case("paper", {{"beam.shear_stiffness", "6.41e6", "--set"}}).beam);
  EXPECT_NEAR(units(fmt::format("{}{}", 0.5 * load, shear))[0], 2.0, 1e-12);
  EXPECT_EQ(units(fmt::format("{}{}", -0.5 * load, shear))[0], 1.0);
}

// --- criterion

// The text of a number that lies between two bounds, with the digits on which they agree and no fewer.
void expect_common_digits(const std::string& text, double lower, double upper) {
  const std::size_t digits = digits_in(text.substr(0, text.find('e'))) -
                             (text.starts_with("0.") ? text.find_first_not_of("0.") - 2 : 0);
  const auto rounded = [](double value, std::size_t count) {
    return fmt::format("{:.{}e}", value, count - 1);
  };
  EXPECT_EQ(rounded(number(text), digits), rounded(lower, digits)) << text;
  EXPECT_EQ(rounded(lower, digits), rounded(upper, digits)) << text;
  EXPECT_NE(rounded(lower, digits + 1), rounded(upper, digits + 1)) << text;
}

TEST_F(CommandAnswers, CriterionPrintsWhatItsJsonHolds) {
  // At 0.97 of the buckling load some changes by a tenth leave no stick state.
  for (const std::string options :
       {"paper --hz 15", "paper --hz 25", "paper --hz 35", "paper --hz 59", "paper --hz 70", "paper --hz 71",
        "paper --hz 80.5", "steel-strip", "paper --hz 70 --amplitude 1e-5", "near-buckling"}) {
    SCOPED_TRACE(options);
    const auto answer = json("criterion " + options);
    const std::string table = run("criterion --digits 17 " + options).output;
    const auto cells = [&](const std::string& row) {
      const auto begin = table.find("\n" + row) + 1;
      const std::string line = table.substr(begin, table.find('\n', begin) - begin);
      const std::string right = line.substr(48);
      std::string left = line.substr(28, 20);
      left.erase(left.find_last_not_of(' ') + 1);
      return std::pair{left, right};
    };
    const auto& all = answer["all_modes"];
    const auto [force, force_of_all] = cells("largest |f|");
    expect_common_digits(force, answer["force_max_N"]["lower"], answer["force_max_N"]["upper"]);
    expect_common_digits(force_of_all, all["force_max_N"]["lower"], all["force_max_N"]["upper"]);
    const auto [critical, critical_of_all] = cells("critical amplitude");
    expect_common_digits(critical, answer["critical_amplitude_bounds_m"]["lower"],
                         answer["critical_amplitude_bounds_m"]["upper"]);
    expect_common_digits(critical_of_all, all["critical_amplitude_bounds_m"]["lower"],
                         all["critical_amplitude_bounds_m"]["upper"]);
    EXPECT_EQ(cells("verdict"),
              (std::pair{answer["verdict"].get<std::string>(), all["verdict"].get<std::string>()}));
    const double lower_force = answer["force_max_N"]["lower"], upper_force = answer["force_max_N"]["upper"];
    EXPECT_LE(lower_force, upper_force);
    EXPECT_LE(upper_force - lower_force, 1e-10 * upper_force);
    EXPECT_EQ(number(cells("friction limit").first), answer["friction_limit_N"]);
    if (options.starts_with("paper ")) {
      EXPECT_EQ(answer["friction_limit_N"], 300.0);
    }
    EXPECT_EQ(all["friction_limit_N"], answer["friction_limit_N"]);
    EXPECT_EQ(cells("steady |f|").second,
              fmt::format("{:.7g}{}", answer["steady"]["force_N"].get<double>(),
                          answer["steady"]["reached"] ? "" : ", not reached within 10 s"));
    for (const auto& one : {answer, all}) {
      const double lower = one["force_max_N"]["lower"], upper = one["force_max_N"]["upper"];
      const double amplitude = answer["amplitude_m"], limit = one["friction_limit_N"];
      EXPECT_DOUBLE_EQ(one["critical_amplitude_bounds_m"]["lower"], amplitude * limit / upper);
      EXPECT_DOUBLE_EQ(one["critical_amplitude_bounds_m"]["upper"], amplitude * limit / lower);
      EXPECT_DOUBLE_EQ(one["critical_amplitude_m"], 0.5 * amplitude * limit * (1.0 / lower + 1.0 / upper));
      EXPECT_EQ(one["verdict"], lower > limit ? "stick-slip" : "stick");
    }
  }
}

// The bounds of all modes are apart by twice what the modes that are not kept can add, and by their width, 1e-10.
TEST_F(CommandAnswers, CriterionKeeps200Modes) {
  constexpr int modes = 200;
  const data::Case problem = data::load_case("paper");
  const double omitted = problem.excitation.amplitude() *
                         analytic::StickResponse(
                             problem.beam, data::HarmonicExcitation({.frequency_hz = 35.0, .amplitude = 1.0}),
                             modes, analytic::SteadyPart::exact)
                             .omitted_transient_bound();
  const auto force = json("criterion paper --hz 35")["all_modes"]["force_max_N"];
  const double upper = force["upper"];
  EXPECT_NEAR(upper - force["lower"].get<double>(), 2.0 * omitted, 1e-10 * upper);
  EXPECT_GT(omitted / modes, 1e-10 * upper);  // one mode more or less shows
}

// At a resonance the steady force is that of one mode, over twice its damping ratio; the others are in quadrature to
// it and less than a tenth of it.
TEST_F(CommandAnswers, CriterionWithADampingRatioHasItsSteadyForce) {
  const auto force = [&](const std::string& ratio) {
    return json("criterion --hz 24.971958 --set damping.ratio=" + ratio)["steady"]["force_N"].get<double>();
  };
  EXPECT_NEAR(force("0.005") / force("0.01"), 2.0, 0.01 * 2.0);
}

// --- map

TEST_F(CommandAnswers, MapWritesAValueWhereItHasConvergedOnly) {
  const std::string command =
      "map damped --set numerics.time_step=1e-4 --duration 0.8 --x frequency=24:36:3 --y kinetic=0.2:0.6:2 "
      "--quantity work,sticks,work --output map.csv ";
  const auto answer = json(command);
  EXPECT_EQ(answer["quantities"], nlohmann::json({"work", "sticks"}));
  EXPECT_EQ(answer["tolerance"], 0.05);
  EXPECT_EQ(answer["transient_s"], 0.4);
  int work = 0, sticks = 0, rows = 0;
  for (const auto& row : csv(contents("map.csv"))) {
    if (row.size() != 7 || row[6] == "state") continue;
    ++rows;
    EXPECT_EQ(row[2].empty(), std::stod(row[3]) > 0.05);
    EXPECT_EQ(row[4].empty(), std::stod(row[5]) > 0.05);
    work += row[2].empty() ? 0 : 1;
    sticks += row[4].empty() ? 0 : 1;
  }
  EXPECT_EQ(rows, 6);
  EXPECT_EQ(answer["converged"], (nlohmann::json{{"work", work}, {"sticks", sticks}}));
  EXPECT_LT(std::min(work, sticks), rows);
  EXPECT_TRUE(run(command).output.ends_with(fmt::format("; converged: {} work, {} sticks\n", work, sticks)));
  const auto estimate = json(command + "--dry-run --threads 2");
  EXPECT_EQ(estimate["cells"], 6);
  EXPECT_EQ(estimate["evaluations"], 6);
  EXPECT_GT(estimate["core_hours"], 0.0);
  EXPECT_GT(estimate["speedup"], 0.0);
  EXPECT_EQ(estimate["threads"], 2);
  const double hours = estimate["core_hours"];
  EXPECT_DOUBLE_EQ(hours, 6.0 * estimate["milliseconds_each"].get<double>() / 3.6e6);
  EXPECT_DOUBLE_EQ(estimate["hours"], hours / estimate["speedup"].get<double>());
  for (const auto& [threads, lines] : {std::pair<std::string, int>{"1", 3}, {"2", 4}}) {
    const std::string printed = run(command + "--dry-run --threads " + threads).output;
    EXPECT_TRUE(holds(printed, "\n6 cells, 6 evaluations, of which "));
    EXPECT_EQ(std::ranges::count(printed, '\n'), lines) << printed;
  }
}

// --- sweep

// Up and down differ where the smallest or the largest force does by more than 1 % of the largest of them.
TEST_F(CommandAnswers, SweepHasTheSectionOfEachValue) {
  install_gnuplot("cat \"${folder}sweep.csv\" \"${folder}sweep-values.csv\" > $output\n");
  const std::string command =
      "sweep damped --set numerics.time_step=1e-3 --hz 25 --settle 5 --periods 2 "
      "--parameter amplitude=1e-4:5e-4:9 --output sweep.csv ";
  const auto answer = json(command);
  ASSERT_EQ(answer["points"].size(), 18u);
  EXPECT_EQ(answer["points"][0]["direction"], "up");
  EXPECT_EQ(answer["points"][17], nlohmann::json({{"direction", "down"}, {"value", 1e-4}, {"period", 0}}));
  EXPECT_EQ(answer["parameter"], "amplitude=1e-04:5e-04:9");
  EXPECT_EQ(answer["direction"], "both");
  EXPECT_TRUE(answer["figure"].is_null());
  const auto rows = csv(contents("sweep.csv"));
  ASSERT_EQ(rows.size(), 1u + 18u * 2u);
  std::size_t differ = 0;
  for (std::size_t i = 0; i < 9; ++i) {
    const auto force = [&](std::size_t row) { return number(rows[1 + row][4]); };
    const auto up = std::minmax({force(2 * i), force(2 * i + 1)}),
               down = std::minmax({force(34 - 2 * i), force(35 - 2 * i)});
    EXPECT_EQ(rows[1 + 2 * i][0], "up");
    EXPECT_EQ(rows[1 + 34 - 2 * i][0], "down");
    EXPECT_EQ(rows[1 + 2 * i][1], rows[1 + 34 - 2 * i][1]);
    const double largest =
        std::max({std::abs(up.first), std::abs(up.second), std::abs(down.first), std::abs(down.second)});
    if (std::max(std::abs(up.first - down.first), std::abs(up.second - down.second)) > 0.01 * largest)
      ++differ;
  }
  const std::size_t moving = answer["values_with_hysteresis"],
                    resting = answer["values_that_stick_elsewhere"];
  EXPECT_EQ(moving + resting, differ);
  EXPECT_TRUE(holds(
      run(command).output,
      fmt::format("\n18 points written to sweep.csv; hysteresis at {} of 9 values{}\n", moving,
                  resting == 0
                      ? ""
                      : fmt::format("; at {} the tip sticks at another place on the way back", resting))));
  EXPECT_TRUE(holds(run(command + "--direction down --figure sweep.svg").output,
                    "\n9 points written to sweep.csv\n"));
  const std::string drawn = contents("sweep.svg"), table = contents("sweep.csv");
  EXPECT_TRUE(drawn.substr(drawn.find('\n')).starts_with(table.substr(table.find('\n'))));
  EXPECT_TRUE(drawn.ends_with("\nlabel,excitation amplitude A_0 / mm,-\nlabel_scale,1000,1\n")) << drawn;
  // A base that does not move leaves zeros without a sign.
  EXPECT_EQ(csv(run("sweep damped --parameter amplitude=0:1e-4:2 --settle 0 --periods 1").output)[1],
            (std::vector<std::string>{"up", "0", "0", "0", "0", "0"}));
}

// --- respond --spectrum

// In stick the response is a sum of sinusoids; with damping only that of the base is left after some time.
TEST_F(CommandAnswers, RespondHasTheSpectrumOfItsRows) {
  const std::string command =
      "respond damped --set damping.ratio=0.05 --set numerics.time_step=1e-3 --amplitude 1e-4 --hz 25 "
      "--duration 8 "
      "--method event-driven --output run.csv --spectrum spectrum.csv";
  ASSERT_EQ(run(command).status, 0);
  const auto rows = csv(contents("spectrum.csv"));
  ASSERT_EQ(rows.size(), 2002u);  // 4 s at 1 kHz, and a header
  double largest = 0.0;
  const auto history = csv(contents("run.csv"));
  for (std::size_t n = history.size() - 40; n < history.size(); ++n)
    largest = std::max(largest, std::abs(std::stod(history[n][5])));
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const double frequency = std::stod(rows[k][0]), force = std::stod(rows[k][2]);
    EXPECT_DOUBLE_EQ(frequency, static_cast<double>(k - 1) / 4.0);
    if (frequency == 25.0)
      EXPECT_NEAR(force, largest,
                  (1.0 - std::cos(std::numbers::pi / 40.0)) * largest);  // the peak between rows
    else
      EXPECT_LT(force, 1e-3 * largest) << frequency;
  }
}

// A frequency of a base that rests has no effect, and the line is the amplitude of the limit cycle.
TEST_F(CommandAnswers, RespondHasTheLineOfASelfExcitedMotion) {
  std::vector<double> largest;
  for (const int hz : {250, 100}) {
    const auto answer = json(fmt::format(
        "respond reed --set excitation.frequency_hz={} --duration 0.4 --method event-driven --output "
        "run.csv --spectrum spectrum.csv",
        hz));
    EXPECT_EQ(answer["spectrum_window"], "flat-top");
    auto& amplitude = largest.emplace_back();
    for (const auto& row : csv(contents("spectrum.csv")))
      if (row[0].find_first_not_of("0") < row[0].size() && std::isdigit(row[0][0]))
        amplitude = std::max(amplitude, std::stod(row[1]));
  }
  EXPECT_NEAR(largest[1], largest[0], 1e-5 * largest[0]);  // rows at other times
  EXPECT_NEAR(largest[0], 1.9439e-4, 1e-3 * 1.9439e-4);    // least squares with five harmonics; the window
}

// (1, 2, 3, 4): X_1 = -2 + 2 i, X_2 = -2. (1, 2, 4): |X_1|^2 = 7.
TEST_F(CommandAnswers, SpectraCountMeanAndHighestFrequencyOnce) {
  const auto even = analytic::amplitude_spectrum({1.0, 2.0, 3.0, 4.0}),
             odd = analytic::amplitude_spectrum({1.0, 2.0, 4.0});
  const std::vector<double> expected_even{2.5, std::sqrt(2.0), 0.5},
      expected_odd{7.0 / 3.0, 2.0 / 3.0 * std::sqrt(7.0)};
  ASSERT_EQ(even.size(), 3u);
  ASSERT_EQ(odd.size(), 2u);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(even[k], expected_even[k], 1e-14);  // round-off
  for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(odd[k], expected_odd[k], 1e-14);
}

// --- design

TEST_F(CommandAnswers, DesignPrintsWhatItsJsonHolds) {
  const std::string command =
      "design paper-figure14 --band 24:26 --length 0.8:1.7 --force 50:1344 --duration 2 --amplitude 1e-3";
  const auto answer = json(command);
  const std::string text = run(command).output;
  EXPECT_EQ(answer["case"], "paper-figure14");
  EXPECT_EQ(answer["band_hz"], nlohmann::json({24.0, 26.0}));
  EXPECT_EQ(answer["amplitude_m"], 1e-3);
  EXPECT_EQ(answer["duration_s"], 2.0);
  EXPECT_EQ(answer["modes"], 10);
  EXPECT_EQ(answer["friction_limit_N"], 300.0);
  EXPECT_GT(answer["evaluations"], 2);
  const auto& margin = answer["margin"];
  const auto& force = answer["force_max_N"];
  EXPECT_DOUBLE_EQ(margin["lower"], 300.0 / force["upper"].get<double>());
  EXPECT_DOUBLE_EQ(margin["upper"], 300.0 / force["lower"].get<double>());
  // The margin at its frequency is that of the criterion.
  const auto criterion = json(fmt::format("criterion paper-figure14 --hz {} --set excitation.duration=2",
                                          answer["frequency_hz"].dump()));
  EXPECT_NEAR(criterion["force_max_N"]["lower"].get<double>(), force["lower"].get<double>(),
              1e-5 * force["lower"].get<double>());
  EXPECT_TRUE(
      text.starts_with("paper-figure14: 2 m, A = 4000 mm^2, I = 1.3333e+05 mm^4, abs, P = 500 N (37.1 % of "
                       "buckling), mu 0.6/0.3\n24 to 26 Hz, 0.001 m, 0 to 2 s, 10 modes\n"))
      << text;
  EXPECT_TRUE(holds(text, ": sticks\n"));
  EXPECT_TRUE(holds(text, "\nnatural frequencies in the band   none\n"));

  // Every end of an interval, with the decimals that its accuracy allows and no fewer.
  for (const std::string kind : {"lengths_m", "axial_forces_N"}) {
    const double accuracy = answer[kind]["accuracy"];
    const int decimals = std::max(0, static_cast<int>(std::ceil(-std::log10(accuracy))));
    EXPECT_LE(0.1 * accuracy, std::pow(10.0, -decimals));
    double before = answer[kind]["intervals"][0]["from"];
    for (const auto& interval : answer[kind]["intervals"]) {
      EXPECT_EQ(interval["from"], before);
      before = interval["to"];
      const bool sticks = interval["state"] == "stick";
      const std::string ends = fmt::format("\n{:<28}{}",
                                           fmt::format("{:.{}f} ... {:.{}f}", interval["from"].get<double>(),
                                                       decimals, interval["to"].get<double>(), decimals),
                                           sticks ? "sticks\n" : "slips");
      EXPECT_TRUE(holds(text, ends));
    }
  }
  EXPECT_EQ(answer["lengths_m"]["intervals"][0]["from"], 0.8);
  EXPECT_EQ(answer["lengths_m"]["intervals"].back()["to"], 1.7);
  EXPECT_EQ(answer["axial_forces_N"]["intervals"].back()["to"], 1344.0);
}

TEST_F(CommandAnswers, DesignOfABandWithAResonanceSlips) {
  const std::string text =
      run("design paper --band 20:90 --length 1.9:2.1 --force 400:600 --duration 1").output;
  for (const char* part : {"\nnatural frequencies in the band   1 at 24.9720, 2 at 81.0776\n", ": slips\n",
                           "slips: natural frequency 1, 2 in the band\n"})
    EXPECT_TRUE(holds(text, part));
}

// The buckling load is 84128 N. The margin is smallest at the end of the band that is nearer to 24.97 Hz.
TEST_F(CommandAnswers, DesignBeyondTheBucklingLoadHasNoStickState) {
  const std::string command = "design paper --band 20:21 --length 1.9:2 --force 400:200000 --duration 0.2";
  const auto answer = json(command);
  const auto& scan = answer["axial_forces_N"];
  EXPECT_GT(answer["margin"]["lower"], 1.5);
  EXPECT_EQ(scan["intervals"].back()["state"], "no stick state");
  EXPECT_NEAR(scan["intervals"].back()["from"], 84128.0, 1.0);
  const std::string text = run(command).output;
  for (const std::string& line :
       {std::string(": sticks\nat / Hz                           21.0000\n"),
        fmt::format("axial force / N at L = 2 m, ends to {:#.2g}\n400 ... ", scan["accuracy"].get<double>()),
        std::string("84128             slips, without a natural frequency in the band\n84128 ... 200000"),
        std::string("no stick state: P is at the buckling load 20.19 EI/L^2 or over it\n")})
    EXPECT_TRUE(holds(text, line));
  expect_refused(
      "design --band 20:30 --length 1e-3:2",
      "excitation.duration is 10, but must be at most 0.0148 s, a hundred million periods of natural "
      "frequency 10");
}

TEST_F(CommandAnswers, DesignTakesItsRangesFromTheCase) {
  const auto answer = json("design paper --band 30:31 --duration 0.1");
  EXPECT_EQ(answer["lengths_m"]["intervals"][0]["from"], 1.0);
  EXPECT_EQ(answer["lengths_m"]["intervals"].back()["to"], 4.0);
  EXPECT_EQ(answer["axial_forces_N"]["intervals"][0]["from"], 50.0);
  EXPECT_EQ(answer["axial_forces_N"]["intervals"].back()["to"], 5000.0);
}

// --- lists and limits

TEST_F(CommandAnswers, CasesAreAlignedAndComplete) {
  const auto cases = json("cases")["cases"];
  ASSERT_GE(cases.size(), 4u);
  std::size_t width = 0;
  for (const auto& listing : cases) width = std::max(width, listing["name"].get<std::string>().size());
  std::string expected;
  for (const auto& listing : cases) {
    EXPECT_TRUE(std::filesystem::exists(listing["file"].get<std::string>())) << listing;
    expected += fmt::format("{:<{}}  {}\n", listing["name"].get<std::string>(), width,
                            listing["title"].get<std::string>());
  }
  EXPECT_EQ(run("cases").output, expected);
}

TEST_F(CommandAnswers, LimitsThemselvesAreAllowed) {
  EXPECT_EQ(json("modes --count 1000")["frequencies_hz"].size(), 1000u);
  expect_refused("modes --count 1001", "is 1001, but must be an integer from 1 to 1000");
  EXPECT_EQ(json("modes --count 1")["frequencies_hz"].size(), 1u);
  EXPECT_EQ(run("respond --duration 0.001 --every 1000000000").status, 0);
  expect_refused("respond --every 1000000001", "is 1000000001, but must be an integer from 1 to 1000000000");
  const std::string map = "map paper-figure14 --states-only --duration 0.1 --y amplitude=1e-4:1e-3:2 ";
  EXPECT_EQ(run(map + "--x length=0.5:1:2").status, 0);
  EXPECT_EQ(csv(run(map + "--x length=0.5:1:2000").output).size(), 1u + 2u * 2001u);
  expect_refused(map + "--x length=0.5:1:2001", "COUNT is '2001', but must be an integer from 2 to 2000");
  EXPECT_EQ(run(map + "--threads 1024 --x length=0.5:1:2").status, 0);
  expect_refused(map + "--threads 1025 --x length=0.5:1:2", "is 1025, but must be an integer from 1 to 1024");
}

TEST_F(CommandAnswers, HelpNamesTheLimitsAndTheDefaultsOfNumbers) {
  const std::map<std::string, std::vector<std::string>> options{
      {"modes", {"--count INT:1 ... 1000=3"}},
      {"animate", {"--frames INT:2 ... 9999=200"}},
      {"sweep", {"--settle INT:0 ... 1000000=100", "--periods INT:1 ... 100000=32"}},
      {"uncertainty", {"--samples UINT:1 ... 100000000=10000", "--seed UINT:0 ... 1000000000=1"}},
      {"squeal", {"--modes INT:1 ... 50=5", "--settle INT:1 ... 100000=200", "--count INT:2 ... 500=41"}},
      {"periodic", {"--periods INT:1 ... 1000=1", "--settle INT:1 ... 100000=200"}}};
  for (const auto& [command, entries] : options) {
    std::string help = run(command + " --help").output;
    std::ranges::replace(help, '\n', ' ');
    for (const std::string& entry : entries) EXPECT_TRUE(holds(help, "  " + entry + " ")) << command;
  }
}

TEST_F(CommandAnswers, MapAxesHaveEqualStepsOrRatios) {
  const auto axis = [&](const std::string& text) {
    std::vector<double> values;
    for (const auto& row :
         csv(run("map paper-figure14 --states-only --duration 0.1 --y friction=0.5:0.6:2 --x " + text)
                 .output))
      if (row.size() == 3 && row[1] == "0.5") values.push_back(number(row[0]));
    return values;
  };
  const auto equal = axis("frequency=10:20:5"), ratios = axis("frequency=10:160:5:log");
  ASSERT_EQ(equal.size(), 5u);
  ASSERT_EQ(ratios.size(), 5u);
  for (int i = 0; i < 5; ++i) {
    EXPECT_DOUBLE_EQ(equal[static_cast<std::size_t>(i)], 10.0 + 2.5 * i);
    EXPECT_DOUBLE_EQ(ratios[static_cast<std::size_t>(i)], 10.0 * std::pow(2.0, i));
  }
}

// --- A wall that moves

TEST_F(CommandAnswers, CommandsThatNeedAWallAtRestSaySo) {
  const std::string part = "wall.speed is 0.3, but must be 0 here";
  for (const std::string& command : std::vector<std::string>{
           "criterion reed", "map reed --output map.csv", "map reed --quantity work --output map.csv",
           "sweep reed --parameter amplitude=1e-4:1e-3:3", "design reed --band 20:30 --set damping.ratio=0",
           "uncertainty uncertain --set wall.speed=0.3",
           "respond reed --method boundary-integral --set damping.ratio=0",
           "respond reed --method closed-form --set damping.ratio=0"})
    expect_refused(command, part);
}

TEST_F(CommandAnswers, OptionsThatWouldChangeNothingAreRefused) {
  for (const std::string command :
       {"map paper --y length=1:2:2 --x ", "map paper --x length=1:2:2 --y ", "sweep paper --parameter "}) {
    const std::string option = command.substr(command.size() - (command.front() == 'm' ? 4 : 12));
    expect_refused(command + "frequency=20:30:2 --hz 25",
                   "--hz is given, but " + option + "varies excitation.frequency_hz");
    expect_refused(command + "amplitude=1e-4:1e-3:2 --amplitude 1e-3",
                   "--amplitude is given, but " + option + "varies excitation.amplitude");
  }
}

// The beam of the paper without settings. Its natural frequency 11 is 2028.94 Hz.
TEST_F(CommandAnswers, SettingsFollowFromTheHighestFrequency) {
  const auto at_the_end = json("criterion uncertain --hz 2040 --set excitation.duration=0.1");
  const int modes = at_the_end["modes"];
  EXPECT_GT(modes, 11);
  const auto design = json(
      "design uncertain --band 2020:2040 --amplitude 1e-6 --duration 0.1 --length 1.99:2 --force 499:500");
  EXPECT_EQ(design["modes"], modes);
  ASSERT_EQ(design["natural_frequencies_in_band"].size(), 1u);
  EXPECT_EQ(design["natural_frequencies_in_band"][0]["mode"], 11);
  EXPECT_NEAR(design["natural_frequencies_in_band"][0]["frequency_hz"], 2028.94, 0.005);
  const std::string uncertainty = "uncertainty uncertain --samples 5 --set excitation.duration=0.1 --band ";
  EXPECT_TRUE(holds(run(uncertainty + "2020:2040").output, fmt::format(", {} modes; 5 samples", modes)));
  for (const auto& [command, hz] :
       {std::pair{"map uncertain --x frequency=30:2040:2 --y amplitude=1e-6:1e-5:2 --duration 0.1 ", 2040},
        {"sweep uncertain --parameter frequency=500:600:2 --settle 0 --periods 1 ", 600}}) {
    const auto settings =
        json(fmt::format("respond uncertain --hz {} --duration 0.1 --every 1000 --output h.csv "
                         "--method closed-form",
                         hz))["problem"]["numerics"];
    const std::string answer = run(command).output;
    EXPECT_NE(answer, "");
    EXPECT_EQ(answer, run(fmt::format("{} --set numerics.modes={} --set numerics.time_step={}", command,
                                      settings["modes"].get<int>(), settings["time_step"].get<double>()))
                          .output);
  }
}

// Not those at the frequency of the case, on which the answer does not depend.
TEST_F(CommandAnswers, WarningsOfABandAreThoseOfADesign) {
  const std::string band = " uncertain --band 24.9:30 --set excitation.duration=0.1 ";
  const auto warnings = json("uncertainty" + band + "--samples 5")["warnings"];
  EXPECT_EQ(warnings, json("design" + band + "--length 1.99:2 --force 499:500")["warnings"]);
  EXPECT_EQ(json("uncertainty" + band + "--samples 5 --set excitation.frequency_hz=300")["warnings"],
            warnings);
}

TEST_F(CommandAnswers, MissingFigureScriptsAreToldBeforeTheWork) {
  ::setenv("STICKSLIP_REPORTS", path("").c_str(), 1);
  expect_refused("respond paper --duration 0.01 --output h.csv --figure a.svg",
                 "must hold the folders figures, report and site");
  ::unsetenv("STICKSLIP_REPORTS");
  EXPECT_FALSE(std::filesystem::exists("h.csv"));
}

TEST_F(CommandAnswers, MapColumnsHaveNameAndUnitOfTheirParameter) {
  const auto has = [&](const std::string& axes, const std::string& names) {
    return run("map damped --duration 0.2 " + axes).output.find("\n" + names) != std::string::npos;
  };
  EXPECT_TRUE(has("--x direction=0:1:2 --y kelvin-voigt=1e-5:2e-5:2", "axial_direction,kelvin_voigt_s,"));
  EXPECT_TRUE(has("--x stiffness=1e9:2e9:2 --y length=1:2:2", "youngs_modulus_Pa,length_m,"));
  EXPECT_TRUE(
      has("--quantity travel --x decay=1:2:2 --y kinetic=0.3:0.4:2", "decay_s_per_m,kinetic_coefficient,"));
}

TEST_F(CommandAnswers, ReferenceShowsHowEachColumnIsCompared) {
  const std::string table = run("reference show classification").output;
  EXPECT_TRUE(holds(table, "  force_ratio         1        enclosed   |f|_max/(mu_s P)\n"));
  EXPECT_TRUE(holds(table, "\n  verdict: word by word\n"));
  EXPECT_TRUE(holds(run("reference show single-mass-events").output,
                    "comparison: events\n"
                    "  time: uncertainty 2.5e-31 to 1.2e-30 s, tolerance 1e-06 (scale)\n"
                    "  position: uncertainty 3e-36 to 3.3e-31 m, tolerance 1e-06 (scale)\n\n"));
  EXPECT_TRUE(holds(run("reference show stick-slip-events").output, ", tolerance 8e-05 s (absolute)\n"));
}

TEST_F(CommandAnswers, SquealNamesTheGrowingModeAndItsCriticalSpeed) {
  const std::string settings = " --set numerics.modes=4 --set numerics.elements=12 --settle 100";
  const auto answer = json("squeal reed" + settings);
  EXPECT_EQ(answer["verdict"], "unstable");
  EXPECT_EQ(answer["modes"].size(), 5U);
  const auto& mode = answer["modes"][0];
  EXPECT_GT(mode["root"]["growth_per_s"], 0.0);
  EXPECT_LT(answer["modes"][1]["root"]["growth_per_s"], 0.0);
  // A growth g moves the frequency by less than g^2/(2 omega^2) of it, 94.8 1/s against 1575.4 1/s.
  const double free = mode["frequency_hz"];
  EXPECT_NEAR(mode["root"]["frequency_hz"], free, 2e-3 * free);
  EXPECT_EQ(mode["unstable_at_every_speed"], false);
  const double speed = mode["critical_speed_m_per_s"];
  EXPECT_EQ(json("squeal reed --speed " + fmt::format("{}", 1.01 * speed) + settings)["verdict"], "stable");
  EXPECT_EQ(json("squeal reed --speed " + fmt::format("{}", 0.99 * speed) + settings)["verdict"], "unstable");
  EXPECT_TRUE(answer["cycle"]["found"]);
  EXPECT_EQ(answer["cycle"]["multipliers"].size(), 10U);
  EXPECT_EQ(json("periodic reed" + settings)["period_s"], answer["cycle"]["period_s"]);

  const std::string undamped =
      "squeal reed --set damping.ratio=0 --set numerics.modes=2 --set numerics.elements=4 --settle 1";
  const auto never = json(undamped)["modes"][0];
  EXPECT_TRUE(never["critical_speed_m_per_s"].is_null());
  EXPECT_EQ(never["unstable_at_every_speed"], true);
  const std::string text = run(undamped).output;
  EXPECT_TRUE(holds(text, "\nsteady sliding                    closed form         finite elements\n"));
  EXPECT_TRUE(holds(text, " every speed\n"));
}

// Two modes and the tip have three roots; without a damping ratio the modes are those of the continuous beam.
TEST_F(CommandAnswers, SquealHasAsManyModesAsItsModel) {
  const std::string reed = "squeal reed --set numerics.modes=2 --set numerics.elements=4 --settle 1 --modes ";
  const auto modes = json(reed + "3")["modes"];
  ASSERT_EQ(modes.size(), 3u);
  EXPECT_GT(modes[2]["frequency_hz"], modes[1]["frequency_hz"]);
  expect_refused(reed + "4",
                 "--modes is 4, but must be at most 3 with a damping.ratio: one more than numerics.modes");
  EXPECT_EQ(json(reed + "4 --set damping.ratio=0")["modes"].size(), 4u);
  expect_refused("squeal reed --map a.csv --speeds 0.1:1 --ratios 0.01:2",
                 "--ratios: damping.ratio is 2, but must be from 1e-09 to 1 in magnitude");
}

// Below the critical speed of 1 % of damping a disturbance grows, slowly at 0.2 % below it, and above it none does.
TEST_F(CommandAnswers, SquealMapsTheGrowthOverSpeedsAndRatios) {
  install_gnuplot("cat \"${folder}squeal.csv\" > $output\n");
  const std::string reed =
      "squeal reed --set numerics.modes=2 --set numerics.elements=4 --settle 1 --modes 3 ";
  const double critical = json(reed)["modes"][0]["critical_speed_m_per_s"];
  const std::string text = run(reed +
                               fmt::format("--speeds {}:{} --ratios 0.01:0.03 --count 3 --map - ",
                                           0.998 * critical, 1.004 * critical) +
                               "--figure map.svg")
                               .output;
  EXPECT_TRUE(holds(text, contents("map.svg").substr(contents("map.svg").find('\n'))));
  const auto rows = csv(text);
  ASSERT_EQ(rows.size(), 1u + 3u * 4u) << text;
  for (std::size_t i = 0; i < 9; ++i) {
    const auto& row = rows[1 + i + i / 3];
    EXPECT_NEAR(number(row[0]), (0.998 + 0.003 * static_cast<double>(i % 3)) * critical, 1e-15);
    EXPECT_NEAR(number(row[1]), 0.01 * static_cast<double>(1 + i / 3), 1e-17);
    EXPECT_EQ(row[3], i == 0 ? "unstable" : "stable") << i;
    // Eigenvalues of the model against roots of its mobility, rounded at 3e4 1/s.
    const auto at = json(reed + "--speed " + row[0] + " --set damping.ratio=" + row[1])["modes"][0]["root"];
    EXPECT_NEAR(number(row[2]), at["growth_per_s"], 1e-7) << i;
    if (i % 3 == 2) {
      EXPECT_TRUE(rows[2 + i + i / 3].empty());
    }
  }
}

TEST_F(CommandAnswers, PeriodicSaysWhatItFindsOrWhyNot) {
  const auto damped = json("periodic damped --set numerics.modes=5 --settle 50");
  EXPECT_EQ(damped["forced"], true);
  EXPECT_DOUBLE_EQ(damped["period_s"], 1.0 / 25.0);
  EXPECT_DOUBLE_EQ(damped["frequency_hz"], 25.0);
  EXPECT_EQ(damped["verdict"], "unstable");
  // On a fast wall the tip slides all the time, and goes with the base.
  const std::string fast = "periodic reed --set wall.speed=1.5 --set numerics.modes=2 ";
  const std::string sliding = run(fast + "--amplitude 1e-5 --hz 100 --periods 2").output;
  EXPECT_TRUE(holds(sliding,
                    "mu 0.5/0.3\na periodic motion, without stick\n\n"
                    "period / s                        0.02\n"
                    "frequency / Hz                    50\n"))
      << sliding;
  EXPECT_TRUE(holds(sliding, "\nchanges of contact                0\n"));
  EXPECT_TRUE(holds(run(fast).output, "mu 0.5/0.3\nthe tip slides steadily\n"));
  const auto stuck = json("periodic paper --hz 15 --amplitude 1e-5 --settle 5");
  EXPECT_EQ(stuck["found"], false);
  EXPECT_EQ(stuck["reason"], "the tip sticks");
}

}  // namespace
}  // namespace stickslip::testing

// Numbers in text: the digits that hold, and no others.
namespace stickslip::cli {
namespace {

STICKSLIP_VERIFIES(NumberText, "U1");
TEST(NumberText, HasAsManyDigitsAsTheErrorLeaves) {
  EXPECT_EQ(digits_that_hold(1.1e-3), 2);
  EXPECT_EQ(digits_that_hold(0.9e-3), 3);
  EXPECT_EQ(digits_that_hold(0.5), 1);
  EXPECT_EQ(digits_that_hold(20.0), 1);
  EXPECT_EQ(digits_that_hold(0.0), 15);  // an epsilon is 2.2e-16
}

TEST(NumberText, KeepsTrailingZerosAndAddsNoPoint) {
  EXPECT_EQ(significant(25.0, 4), "25.00");
  EXPECT_EQ(significant(25.0, 3), "25.0");
  EXPECT_EQ(significant(25.0, 2), "25");
  EXPECT_EQ(significant(90.0, 2), "90");
  EXPECT_EQ(significant(25.0, 1), "2e+01");  // to even
  EXPECT_EQ(significant(0.00065856789, 5), "0.00065857");
  EXPECT_EQ(significant(1.5e-7, 3), "1.50e-07");
}

TEST(NumberText, OfBoundsIsWhatBothRoundTo) {
  EXPECT_EQ(common_digits({2.0, 2.0}), "2");
  EXPECT_EQ(common_digits({1.2344, 1.2346}), "1.23");  // 1.234 and 1.235
  EXPECT_EQ(common_digits({1.23441, 1.23449}), "1.234");
  EXPECT_EQ(common_digits({1.1, 1.3}), "1");
  EXPECT_EQ(common_digits({1.4, 1.6}), "1.4 ... 1.6");
}

}  // namespace
}  // namespace stickslip::cli
