// SPDX-License-Identifier: MIT
/// What the commands answer: their JSON against their files, options with each method, and digits that are true.

#include <array>

#include "answer.hpp"
#include "case_options.hpp"
#include "stickslip/analytic/amplitude_spectrum.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/reference.hpp"
#include "studies/history/method.hpp"
#include "support/command_line.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

double number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

class Answers : public Drawing {
 protected:
  using Columns = std::map<std::string, Words>;

  // The largest magnitude in a column.
  [[nodiscard]] static double largest(const Words& cells) {
    double most = 0.0;
    for (const std::string& cell : cells) most = std::max(most, std::abs(number(cell)));
    return most;
  }
};

// --- respond

// The undamped beam lets go at 0.05525 s and slides until after 0.0605 s.
STICKSLIP_VERIFIES(Answers, "U1");
TEST_F(Answers, RespondSaysWhatItsFilesHold) {
  for (const studies::Method& method : studies::methods()) {
    SCOPED_TRACE(method.name);
    const bool slips = method.follows_slip();
    const auto answer =
        json("respond --hz 25 --amplitude 1e-3 --duration 0.0605 --every 1 --output history.csv --method " +
             method.name + (slips ? " --events events.csv" : ""));
    auto rows = columns_of(contents("history.csv"));
    auto events = slips ? columns_of(contents("events.csv")) : Columns();
    const Words &times = rows["time_s"], &states = rows["state"];
    EXPECT_EQ(answer["method"], method.name);
    EXPECT_EQ(answer["rows"], times.size());
    EXPECT_DOUBLE_EQ(answer["duration_s"], number(times.back()));
    EXPECT_EQ(answer["largest_friction_force_N"], largest(rows["friction_force_N"]));
    EXPECT_EQ(answer["changes_of_contact"], events["time_s"].size());
    EXPECT_EQ(states.back(), slips ? "slip" : "stick");
    double deflection = 0.0;
    std::optional<double> beyond;  // mu_s P
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double time = number(times[i]);
      deflection = std::max(deflection, std::abs(number(rows["tip_displacement_m"][i]) -
                                                 number(rows["base_displacement_m"][i])));
      if (!beyond && std::abs(number(rows["friction_force_N"][i])) > 300.0) beyond = time;
      const auto before =
          std::ranges::count_if(events["time_s"], [&](const auto& at) { return number(at) < time; });
      const bool is_at_onset = slips && time == number(events["time_s"].at(0));
      const bool has_slip = before > 0 && events["change"][static_cast<std::size_t>(before) - 1] != "capture";
      EXPECT_TRUE(is_at_onset || states[i] == (has_slip ? "slip" : "stick")) << time;
    }
    EXPECT_EQ(answer["largest_deflection_m"], deflection);
    if (!slips) {
      EXPECT_EQ(answer["first_slip_s"], *beyond);
      continue;
    }
    EXPECT_EQ(answer["first_slip_s"], number(events["time_s"].at(0)));
    EXPECT_EQ(events["change"][0], "onset");
    EXPECT_EQ(answer.contains("scheme"), method.name == "fe");
    for (const char* key : {"integration_step_s", "largest_change_on_twice_the_step_m"})
      EXPECT_EQ(answer.contains(key), method.name == "boundary-integral");
  }
  EXPECT_TRUE(json("respond --amplitude 1e-4 --duration 0.02 --output h.csv")["first_slip_s"].is_null());
}

TEST_F(Answers, RespondChoosesItsMethod) {
  const std::string slips = "paper --hz 25 --amplitude 1e-3 --duration ",
                    stiff = "damped --set numerics.modes=40 ";
  for (const auto& [line, method, reason] : std::vector<std::array<std::string, 3>>{
           {"damped", "event-driven", "with damping"},
           {"rough-road", "event-driven", "with damping"},
           {"hong-liu-1", "event-driven", "exact in its modes; "},
           {"paper --hz 35 --amplitude 1e-4", "event-driven", "the contact holds"},
           {slips + "0.06", "boundary-integral", "has all modes"},
           {slips + "2.5", "fe", "boundary-integral would take about 11 s"},
           {slips + "0.06 --set friction.decay=inf", "fe", "integral refuses: friction.decay is inf, "},
           {"damped --set contact.tangential_stiffness=1e6", "fe",
            "refuses: contact.tangential_stiffness is "},
           {"damped --scheme located", "fe", "--scheme is given, which"},
           {"damped --set numerics.elements=10", "fe", "numerics.elements is given"},
           {stiff, "fe", "times as long with 40 modes"},
           {stiff + "--amplitude 1e-4", "event-driven", "the contact holds"}}) {
    const auto answer =
        json("respond " + line + (holds(line, "duration") ? "" : " --duration 0.1") + " --output h.csv");
    EXPECT_EQ(answer["method"], method) << line;
    EXPECT_TRUE(holds(answer["method_reason"].get<std::string>(), reason)) << answer["method_reason"];
  }
  EXPECT_TRUE(json("respond --method fe --output h.csv")["method_reason"].is_null());
  EXPECT_TRUE(holds(run_line("respond damped --duration 0.01 --output h.csv").output, "\nevent-driven: "));
}

// At rest in space of the base, u_t(x, 0) = 0, the beam first moves with the base: y(L/2) = h; else with P = 0 by 11/16 of it. After
// 10 ms both methods still agree to less than 1 % of what the other start changes.
TEST_F(Answers, RespondStartsFromRestByBothMethods) {
  const auto midspan = [&](const std::string& method, const std::string& start) {
    auto rows =
        columns_of(run_line("respond --hz 15 --amplitude 0.5e-3 --duration 0.01 --set numerics.modes=40 "
                            "--set numerics.elements=40 --method " +
                            method + " --initial-velocity " + start)
                       .output)["midspan_displacement_m"];
    return std::pair{number(rows.at(1)), number(rows.back())};
  };
  const double base = 0.5e-3 * std::sin(2.0 * std::numbers::pi * 15.0 * 1e-4);
  std::vector<double> late;
  for (const std::string method : {"fe", "event-driven"})
    for (const auto& [start, share, margin] :
         {std::tuple{"zero", 1.0, 1e-3}, {"quasi-static", 11.0 / 16.0, 1e-2}}) {
      const auto [first, last] = midspan(method, start);
      EXPECT_TRUE(
          within(first, share * base, discretisation(margin * base, 1, "P and the time since the start")))
          << method;
      late.push_back(last);
    }
  EXPECT_GT(late[0] - late[1], 1.5e-4);
  EXPECT_TRUE(within(late[2], late[0], discretisation(0.01 * (late[0] - late[1]), 1, "the other start")));
}

// --- modes

// The package has more digits than a double holds. The text has as many as the estimate of the relative error leaves.
TEST_F(Answers, ModesPrintsDigitsThatAreTrue) {
  for (const std::string state : {"stick", "slip"}) {
    auto published = csv(contents(data::reference_directory() / ("frequencies/" + state + ".csv")));
    for (const std::string beam : {"paper", "steel-strip", "soft-short", "near-buckling"}) {
      const std::string command = "modes " + beam + " --count 10 --digits 17 --state " + state;
      const auto answer = json(command);
      std::istringstream text(run_line(command).output);
      std::size_t n = 0;
      for (const auto& row : published) {
        if (row[0] != beam) continue;
        std::string word;
        while (text >> word && word != std::to_string(n + 1)) continue;
        ASSERT_TRUE(text >> word);
        const long double exact = std::strtold(row[2].c_str(), nullptr);
        const double estimate = answer["relative_error_estimates"][n];
        const auto shown = std::ranges::count_if(word, [](char c) { return std::isdigit(c) != 0; }) -
                           (word.starts_with("0.") ? 1 : 0);
        EXPECT_LE(std::abs(std::strtold(word.c_str(), nullptr) - exact),
                  1.5L * std::pow(10.0L, -static_cast<long double>(word.size() - word.find('.') - 1)))
            << beam << word;
        EXPECT_GE(std::pow(10.0, -static_cast<double>(shown)), estimate);
        EXPECT_LT(std::pow(10.0, -static_cast<double>(shown) - 1.0), estimate);
        EXPECT_LE(
            std::abs(static_cast<long double>(answer["frequencies_hz"][n].get<double>()) / exact - 1.0L),
            static_cast<long double>(estimate));
        EXPECT_LT(estimate, beam == "near-buckling" ? 1e-12 : 1e-14) << beam << state;
        ++n;
      }
      EXPECT_EQ(n, 10u);
    }
  }
}

TEST_F(Answers, ModesSaysThatItLeavesOutTheDamping) {
  const auto damped = json("modes damped"), undamped = json("modes paper");
  EXPECT_EQ(damped["undamped"], true);
  EXPECT_FALSE(undamped.contains("undamped"));
  EXPECT_EQ(damped["frequencies_hz"], undamped["frequencies_hz"]);
}

// Without axial force the stick frequencies are as accurate as the data, and b of a clamped-free beam is a root of C =
// 2 b^4 (1/cosh b + cos b). Half the buckling load doubles the error with shear; tension does not.
TEST_F(Answers, ModesEstimatesItsRounding) {
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
      data::load_case("paper", {{"beam.shear_stiffness", "6.41e6", "--set"}}).beam());
  EXPECT_NEAR(units(fmt::format("{}{}", 0.5 * load, shear))[0], 2.0, 1e-12);
  EXPECT_EQ(units(fmt::format("{}{}", -0.5 * load, shear))[0], 1.0);
}

// --- criterion

// The bounds of all modes are apart by twice what the modes that are not kept can add, and by their width, 1e-10.
TEST_F(Answers, CriterionKeeps200Modes) {
  constexpr int modes = 200;
  const data::Case problem = data::load_case("paper");
  const double omitted =
      problem.excitation().amplitude() *
      analytic::StickResponse(problem.beam(),
                              data::HarmonicExcitation({.frequency_hz = 35.0, .amplitude = 1.0}), modes,
                              analytic::SteadyPart::exact)
          .omitted_transient_bound();
  const auto force = json("criterion paper --hz 35")["all_modes"]["force_max_N"];
  const double upper = force["upper"];
  EXPECT_NEAR(upper - force["lower"].get<double>(), 2.0 * omitted, 1e-10 * upper);
  EXPECT_GT(omitted / modes, 1e-10 * upper);  // one mode more or less shows
}

// --- map

TEST_F(Answers, MapWritesAValueWhereItHasConverged) {
  const std::string command =
      "map damped --set numerics.time_step=1e-4 --duration 0.8 --x frequency=24:36:3 --y kinetic=0.2:0.6:2 "
      "--quantity work,sticks,work --output map.csv ";
  const auto answer = json(command);
  EXPECT_EQ(answer["quantities"], nlohmann::json({"work", "sticks"}));
  EXPECT_EQ(answer["transient_s"], 0.4);
  auto columns = columns_of(contents("map.csv"));
  for (const std::string quantity : {"work", "sticks"}) {
    const auto name = std::ranges::find_if(columns, [&](const auto& column) {
                        return column.first.starts_with(quantity) && !column.first.ends_with("_change");
                      })->first;
    int converged = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      converged += columns[name].at(i).empty() ? 0 : 1;
      EXPECT_EQ(columns[name][i].empty(), number(columns[quantity + "_change"].at(i)) > answer["tolerance"])
          << name;
    }
    EXPECT_EQ(answer["converged"][quantity], converged);
  }
  const auto estimate = json(command + "--dry-run --threads 2");
  const double hours = estimate["core_hours"];
  EXPECT_DOUBLE_EQ(hours, 6.0 * estimate["milliseconds_each"].get<double>() / 3.6e6);
  EXPECT_DOUBLE_EQ(estimate["hours"], hours / estimate["speedup"].get<double>());
  EXPECT_EQ(estimate["threads"], 2);
}

TEST_F(Answers, MapAxesHaveEqualStepsOrRatios) {
  const auto axis = [&](const std::string& text) {
    return columns_of(
        run_line("map paper-figure14 --states-only --duration 0.1 --y friction=0.5:0.6:2 --x frequency=" +
                 text)
            .output)["frequency_Hz"];
  };
  const auto equal = axis("10:20:5"), ratios = axis("10:160:5:log");
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_DOUBLE_EQ(number(equal.at(i)), 10.0 + 2.5 * static_cast<double>(i));
    EXPECT_DOUBLE_EQ(number(ratios.at(i)), 10.0 * std::pow(2.0, i));
  }
}

TEST_F(Answers, MapTakesEveryAxisWithItsColumn) {
  int tried = 0;
  for (const auto& [path, value] : data::numbers_of(data::load_case("damped"))) {
    const data::KeyAxis& axis = data::key_named(path).axis;
    if (axis.name.empty() || value <= 0.0 || !std::isfinite(value)) continue;
    const std::string other = path == "beam.length" ? "force=400:500" : "length=1:1.1";
    const Outcome map =
        run_line(fmt::format("map damped --states-only --duration 0.2 --x {}={}:{}:2 --y {}:2", axis.name,
                             0.9 * value, 0.95 * value, other));
    EXPECT_TRUE(columns_of(map.output).contains(std::string(axis.column))) << path << map.errors;
    ++tried;
  }
  EXPECT_GT(tried, 8);
}

// --- the case

// A beam's problem has no further member.
// The first slip of the bounds is that of the history by events, to the ten digits of the one and the time of the other; what needs a
// sine says so.
TEST_F(Answers, OfAMotionAreThoseOfItsHistory) {
  const std::string louder = " road --set excitation.scale=3";
  const auto held = json("criterion" + louder), quiet = json("criterion road");
  EXPECT_EQ(held["verdict"], "stick-slip");
  EXPECT_EQ(quiet["verdict"], "stick");
  EXPECT_TRUE(quiet["first_slip_s"].is_null());
  EXPECT_TRUE(within(held["force_max_N"]["upper"].get<double>(),
                     3.0 * quiet["force_max_N"]["upper"].get<double>(), reference(1e-4, "1e-7 of 340 N")));
  EXPECT_EQ(held["problem"]["excitation"]["kind"], "record");
  const auto moved =
      json("respond" + louder + " --duration 0.8 --method event-driven --output " + path("h.csv"));
  EXPECT_TRUE(within(moved["first_slip_s"].get<double>(), held["first_slip_s"].get<double>(),
                     round_off(1e3, 1, 0.8)));
  EXPECT_TRUE(holds(run_line("periodic road").errors, "excitation.file is given, but must be left out"));
}

// The deviation is proportional to the scale; what is counted lies below both laws; a change helps as it says; a map has the margin; a seed
// and more samples change the count alone.
TEST_F(Answers, OfASpectrumScaleAndAgree) {
  const std::string half = "criterion rough-road --set excitation.scale=0.5 --samples 100";
  const auto one = json("criterion rough-road --samples 100"), less = json(half),
             other = json(half + " --set excitation.seed=500");
  const double sigma = one["deviation_N"];
  EXPECT_TRUE(within(less["deviation_N"].get<double>(), 0.5 * sigma, round_off(10, 1, sigma)));
  EXPECT_EQ(other["deviation_N"], less["deviation_N"]);
  EXPECT_EQ(one["samples"], 100);
  const auto probability = [](const auto& of, const char* law) {
    return of[fmt::format("probability_{}", law)].template get<double>();
  };
  EXPECT_LE(one["probability_counted"]["lower"].get<double>(), probability(one, "vanmarcke"));
  EXPECT_LE(probability(one, "vanmarcke"), probability(one, "poisson"));
  EXPECT_LT(probability(less, "poisson"), probability(one, "poisson"));
  const auto& best = one["best_change"];
  const std::string key = best["key"];
  const double value = data::value_of(data::load_case("rough-road"), key) * best["factor"].get<double>(),
               margin = one["margin"];
  const auto changed =
      json("criterion rough-road --samples 10 --set " + key + "=" + data::shortest_text(value));
  EXPECT_TRUE(
      within(changed["margin"].get<double>(), best["margin"].get<double>(), reference(1e-9, "rounding")));
  EXPECT_GT(best["margin"].get<double>(), margin);
  (void)json("map rough-road --x scale=1:2:2 --y friction=0.6:0.7:2 --output " + path("map.csv"));
  auto columns = columns_of(contents("map.csv"));
  EXPECT_TRUE(within(std::stod(columns["force_ratio"].at(0)), 1.0 / margin, reference(1e-9, "rounding")));
  EXPECT_TRUE(holds(run_line("criterion rough-road --set damping.ratio=0").errors,
                    "damping.ratio is 0, but must be above 0"));
  EXPECT_TRUE(holds(run_line("criterion road --samples 5").errors,
                    "--samples is 5, but must be left out without a spectrum"));
}

// Variances of base and wall add, also of a wall that moves with the base. There a mass has the read-outs of a shaker with the force -m h_tt;
// with a random wall besides, two methods have the same.
TEST_F(Answers, OfBaseAndWallAtRandomAddUp) {
  const auto variance = [&](const std::string& options) {
    const double deviation = json(
        "criterion rough-road --samples 10 --set wall.spectrum=[[5,1],[100,2]] --set "
        "wall.unit=(m/s^2)^2/Hz" +
        options)["deviation_N"];
    return deviation * deviation;
  };
  for (const std::string carried : {"", " --set wall.with_base=true"}) {
    const double both = variance(carried), base = variance(carried + " --set wall.scale=0"),
                 wall = variance(carried + " --set excitation.scale=0");
    EXPECT_TRUE(within(base + wall, both, reference(1e-11 * both, "quadrature"))) << carried;
    EXPECT_GT(std::min(base, wall), 0.01 * both) << carried;
  }
  const std::string mass =
      "[model]\nmass = 2\nstiffness = 8000\ndamping = 5\nnormal_force = 8\n[friction]\nstatic_coefficient = "
      "0.5\n[excitation]\nduration = 4\n";
  std::ofstream("carried.toml")
      << mass << "spectrum = [[2, 1], [20, 1]]\nunit = '(m/s^2)^2/Hz'\n[wall]\nwith_base = true\n";
  std::ofstream("shaken.toml") << mass << "spectrum = [[2, 4], [20, 4]]\nunit = 'N^2/Hz'\n";
  const std::string random_wall =
      "nvh carried.toml --set wall.spectrum=[[5,1],[30,1]] --set wall.unit=(m/s^2)^2/Hz";
  for (const auto& [one, other, tolerance] :
       {std::tuple{json("nvh carried.toml"), json("nvh shaken.toml"), reference(1e-9, "rounding of events")},
        {json(random_wall), json(random_wall + " --method fe"), reference(1e-6, "time steps; empirical")}}) {
    EXPECT_EQ(one["slips"], other["slips"]);
    EXPECT_GT(one["slips"], 10);
    for (const char* name : {"travel_m", "distance_95_m", "distance_99_m"})
      EXPECT_TRUE(within(other[name].get<double>() / one[name].get<double>(), 1.0, tolerance)) << name;
  }
}

TEST_F(Answers, TellTheStructureThatIsNoBeam) {
  const data::Case rig = data::load_case("solid-cantilever"), mass = data::load_case("den-hartog");
  EXPECT_EQ(cli::case_line(rig),
            "solid-cantilever: matrices of 96 rows, 8 of the base, contact rows 84, 87, N = 400 N, which is "
            "not in the "
            "matrices unless they hold it, mu 0.6/0.3\n");
  EXPECT_EQ(cli::case_line(mass),
            "den-hartog: one mass 1 kg, spring 100 N/m, damper 0 N s/m, N = 10 N, mu 0.5/0.5\n");
  const cli::Json problem = cli::problem_json(rig), &structure = problem["structure"];
  EXPECT_EQ(structure["kind"], "matrices");
  EXPECT_EQ(structure["base"], cli::Json({3, 6, 9, 12, 15, 18, 21, 24}));
  EXPECT_EQ(structure["contact"],
            cli::Json({{{"row", 84}, {"weight", 0.5}}, {{"row", 87}, {"weight", 0.5}}}));
  EXPECT_EQ(structure["files"][0], cli::Json({{"key", "model.base"},
                                              {"name", "solid-cantilever.nam"},
                                              {"sha256", rig.model()->matrices().files[0].sha256}}));
  EXPECT_EQ(problem["model"], cli::Json::object({{"normal_force", 400.0}}));
  EXPECT_EQ(cli::problem_json(mass)["structure"], cli::Json::object({{"kind", "mass"}}));
  EXPECT_FALSE(cli::problem_json(mass).contains("damping"));
  const cli::Json beam = cli::problem_json(data::load_case("paper"));
  EXPECT_FALSE(beam.contains("structure") || beam["wall"].contains("with_base"));
  EXPECT_EQ(cli::problem_json(data::load_case(
                "paper", {{"wall.with_base", "true"}, {"damping.ratios", "[0.1]"}}))["damping"]["ratios"],
            cli::Json::array({0.1}));
}

// --- sweep

// Up and down differ where the smallest or the largest force does by more than 1 % of the largest of them.
TEST_F(Answers, SweepHasTheSectionOfEachValue) {
  const std::string command =
      "sweep damped --set numerics.time_step=1e-3 --hz 25 --settle 5 --periods 2 "
      "--parameter amplitude=1e-4:5e-4:9 --output sweep.csv ";
  const auto answer = json(command);
  ASSERT_EQ(answer["points"].size(), 18u);
  EXPECT_EQ(answer["points"][17], nlohmann::json({{"direction", "down"}, {"value", 1e-4}, {"period", 0}}));
  auto columns = columns_of(contents("sweep.csv"));
  std::map<std::string, std::map<std::string, std::vector<double>>> forces;  // by value and direction
  for (std::size_t i = 0; i < 36; ++i)
    forces[columns["amplitude_m"].at(i)][columns["direction"].at(i)].push_back(
        number(columns["friction_force_N"].at(i)));
  ASSERT_EQ(forces.size(), 9u);
  std::size_t differ = 0;
  for (auto& [value, both] : forces) {
    const auto [up, top] = std::ranges::minmax(both.at("up"));
    const auto [down, bottom] = std::ranges::minmax(both.at("down"));
    const double most = std::max({-up, top, -down, bottom});
    differ += std::max(std::abs(up - down), std::abs(top - bottom)) > 0.01 * most ? 1 : 0;
  }
  const std::size_t moving = answer["values_with_hysteresis"],
                    resting = answer["values_that_stick_elsewhere"];
  EXPECT_EQ(moving + resting, differ);
  const std::string told = run_line(command).output;
  EXPECT_TRUE(holds(told, fmt::format("hysteresis at {} of 9 values", moving)));
  EXPECT_TRUE(
      holds(told, resting == 0 ? "values\n" : fmt::format("; at {} the contact sticks at another", resting)));
  install_gnuplot("cat \"${folder}sweep.csv\" \"${folder}sweep-values.csv\" > $output\n");
  EXPECT_TRUE(holds(run_line(command + "--direction down --figure sweep.svg").output,
                    "\n9 points written to sweep.csv\n"));
  const std::string drawn = contents("sweep.svg"), table = contents("sweep.csv");
  EXPECT_TRUE(drawn.substr(drawn.find('\n')).starts_with(table.substr(table.find('\n'))));
  EXPECT_TRUE(drawn.ends_with("\nlabel,excitation amplitude A_0 / mm,-\nlabel_scale,1000,1\n")) << drawn;
  // A base that does not move leaves zeros without a sign.
  EXPECT_EQ(csv(run_line("sweep damped --parameter amplitude=0:1e-4:2 --settle 0 --periods 1").output)[1],
            (Words{"up", "0", "0", "0", "0", "0"}));
}

// --- respond --spectrum

// In stick the response is a sum of sinusoids; with damping only that of the base is left after some time. 4 s at 1 kHz.
TEST_F(Answers, RespondHasTheSpectrumOfItsRows) {
  ASSERT_EQ(
      run_line(
          "respond damped --set damping.ratio=0.05 --set numerics.time_step=1e-3 --amplitude 1e-4 --hz 25 "
          "--duration 8 --method event-driven --output run.csv --spectrum spectrum.csv")
          .status,
      0);
  auto lines = columns_of(contents("spectrum.csv"));
  Words history = columns_of(contents("run.csv"))["friction_force_N"];
  history.erase(history.begin(), history.end() - 40);
  const double most = largest(history);
  ASSERT_EQ(lines["frequency_Hz"].size(), 2001u);
  for (std::size_t k = 0; k < 2001; ++k) {
    const double frequency = number(lines["frequency_Hz"][k]), force = number(lines["friction_force_N"][k]);
    EXPECT_DOUBLE_EQ(frequency, static_cast<double>(k) / 4.0);
    if (frequency == 25.0)
      EXPECT_TRUE(
          within(force, most,
                 discretisation((1.0 - std::cos(std::numbers::pi / 40.0)) * most, 1, "a peak between rows")));
    else
      EXPECT_LT(force, 1e-3 * most) << frequency;
  }
}

TEST_F(Answers, RespondNamesTheWindowOfASpectrum) {
  const std::string spectrum = " --spectrum spectrum.csv --method event-driven --output run.csv --duration ";
  for (const auto& [run, is_flat_top] :
       {std::pair{"reed" + spectrum + "0.1", true}, {"damped --hz 25" + spectrum + "0.2", false}}) {
    EXPECT_EQ(run_line("respond " + run).status, 0);
    EXPECT_EQ(holds(contents("spectrum.csv"), ", flat-top window"), is_flat_top) << run;
  }
}

TEST_F(Answers, UncertaintySaysWhetherTheCaseSlips) {
  const auto line = [](double amplitude) {
    return fmt::format("uncertainty uncertain --samples 5 --amplitude {} --quiet", amplitude);
  };
  const double critical = 1e-4 * json(line(1e-4))["margin_of_case"].get<double>();
  for (const double factor : {0.6, 0.9, 1.1}) {
    const std::string text = run_line(line(factor * critical)).output;
    EXPECT_EQ(holds(text, ": slips\n"), factor > 1.0) << text;
  }
}

// A frequency of a base that rests has no effect, and the line is the amplitude of the limit cycle.
TEST_F(Answers, RespondHasTheLineOfALimitCycle) {
  std::vector<double> amplitudes;
  for (const int hz : {250, 100}) {
    const auto answer =
        json(fmt::format("respond reed --set excitation.frequency_hz={} --duration 0.4 --method event-driven "
                         "--output run.csv --spectrum spectrum.csv",
                         hz));
    EXPECT_EQ(answer["spectrum_window"], "flat-top");
    Words lines = columns_of(contents("spectrum.csv"))["tip_displacement_m"];
    lines.erase(lines.begin());  // the mean
    amplitudes.push_back(largest(lines));
  }
  EXPECT_TRUE(
      within(amplitudes[1], amplitudes[0], discretisation(1e-5 * amplitudes[0], 1, "rows at other times")));
  EXPECT_TRUE(
      within(amplitudes[0], 1.9439e-4, reference(1e-3 * 1.9439e-4, "least squares with five harmonics")));
}

// (1, 2, 3, 4): X_1 = -2 + 2 i, X_2 = -2. (1, 2, 4): |X_1|^2 = 7.
TEST_F(Answers, SpectraCountMeanAndHighestOnce) {
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

// Intervals that follow each other from end to end.
TEST_F(Answers, DesignFindsWhereItSlips) {
  const std::string design =
      "design paper-figure14 --band 24:26 --length 0.8:1.7 --force 50:1344 --duration 2 --amplitude 1e-3";
  const auto answer = json(design);
  const std::string text = run_line(design).output;
  EXPECT_GT(answer["evaluations"], 2);
  for (const auto& [kind, option, from, to] :
       {std::tuple{"lengths_m", "--length", 0.8, 1.7}, {"axial_forces_N", "--force", 50.0, 1344.0}}) {
    const auto intervals = answer[kind]["intervals"];
    EXPECT_EQ(intervals[0]["from"], from);
    EXPECT_EQ(intervals.back()["to"], to);
    EXPECT_GT(intervals.size(), 1u);
    // The text has the decimals that the accuracy allows, and no more.
    const int decimals =
        std::max(0, static_cast<int>(std::ceil(-std::log10(answer[kind]["accuracy"].get<double>()))));
    EXPECT_TRUE(holds(
        text, fmt::format("\n{1:.{0}f} ... {2:.{0}f} ", decimals, from, intervals[0]["to"].get<double>())));
    for (std::size_t i = 1; i < intervals.size(); ++i)
      EXPECT_EQ(intervals[i]["from"], intervals[i - 1]["to"]);
  }
}

// The buckling load is 84128 N. The margin is smallest at the end of the band that is nearer to 24.97 Hz.
TEST_F(Answers, DesignSaysWhyItSlips) {
  const std::string buckled = "design paper --band 20:21 --length 1.9:2 --force 400:200000 --duration 0.2";
  const auto scan = json(buckled)["axial_forces_N"];
  EXPECT_EQ(scan["intervals"].back()["state"], "no stick state");
  EXPECT_NEAR(scan["intervals"].back()["from"], 84128.0, 1.0);
  const std::string resonant = "design paper --band 20:90 --length 1.9:2.1 --force 400:600 --duration 1";
  for (const auto& [command, part] :
       {std::pair{buckled, ": sticks\nat / Hz                           21.0000\n"},
        {buckled, " slips, without a natural frequency in the band\n84128 ... 200000"},
        {buckled, "no stick state: P is at the buckling load 20.19 EI/L^2 or over it\n"},
        {resonant, "\nnatural frequencies in the band   1 at 24.9720, 2 at 81.0776\n"},
        {resonant, ": slips\n"},
        {resonant, "slips: natural frequency 1, 2 in the band\n"}})
    EXPECT_TRUE(holds(run_line(command).output, part));
}

TEST_F(Answers, DesignTakesItsRangesFromTheCase) {
  const auto answer = json("design paper --band 30:31 --duration 0.1");
  EXPECT_EQ(answer["lengths_m"]["intervals"][0]["from"], 1.0);
  EXPECT_EQ(answer["lengths_m"]["intervals"].back()["to"], 4.0);
  EXPECT_EQ(answer["axial_forces_N"]["intervals"][0]["from"], 50.0);
  EXPECT_EQ(answer["axial_forces_N"]["intervals"].back()["to"], 5000.0);
}

// --- lists, settings and warnings

TEST_F(Answers, CasesAreListedWithTheirFiles) {
  const std::string text = run_line("cases").output;
  const auto cases = json("cases")["cases"];
  EXPECT_EQ(std::ranges::count(text, '\n'), cases.size());
  for (const auto& listing : cases) {
    EXPECT_TRUE(std::filesystem::exists(listing["file"].get<std::string>())) << listing;
    EXPECT_TRUE(holds("\n" + text, "\n" + listing["name"].get<std::string>() + " "));
    EXPECT_TRUE(holds(text, "  " + listing["title"].get<std::string>() + "\n"));
  }
}

// The beam of the paper without settings. Its natural frequency 11 is 2028.94 Hz.
TEST_F(Answers, SettingsFollowFromTheHighestFrequency) {
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
  EXPECT_TRUE(holds(run_line(uncertainty + "2020:2040").output, fmt::format(", {} modes; 5 samples", modes)));
  for (const auto& [command, hz] :
       {std::pair{"map uncertain --x frequency=30:2040:2 --y amplitude=1e-6:1e-5:2 --duration 0.1 ", 2040},
        {"sweep uncertain --parameter frequency=500:600:2 --settle 0 --periods 1 ", 600}}) {
    const auto settings =
        json(fmt::format("respond uncertain --hz {} --duration 0.1 --every 1000 --output h.csv "
                         "--method closed-form",
                         hz))["problem"]["numerics"];
    const std::string answer = run_line(command).output;
    EXPECT_NE(answer, "");
    EXPECT_EQ(answer, run_line(fmt::format("{} --set numerics.modes={} --set numerics.time_step={}", command,
                                           settings["modes"].get<int>(), settings["time_step"].get<double>()))
                          .output);
  }
}

// Not those at the frequency of the case, on which the answer does not depend.
TEST_F(Answers, WarningsOfABandAreThoseOfADesign) {
  const std::string band = " uncertain --band 24.9:30 --set excitation.duration=0.1 ";
  const auto warnings = json("design" + band + "--length 1.99:2 --force 499:500")["warnings"];
  for (const char* hz : {"", "--set excitation.frequency_hz=300"})
    EXPECT_EQ(json("uncertainty" + band + "--samples 5 " + hz)["warnings"], warnings);
}

TEST_F(Answers, MissingScriptsAreToldBeforeTheWork) {
  ::setenv("STICKSLIP_REPORTS", path("").c_str(), 1);
  expect_refused("respond paper --duration 0.01 --output h.csv --figure a.svg",
                 "must hold the folders figures, report and site");
  ::unsetenv("STICKSLIP_REPORTS");
  EXPECT_FALSE(std::filesystem::exists("h.csv"));
}

TEST_F(Answers, ReferenceShowsHowEachColumnIsCompared) {
  for (const auto& [name, part] :
       {std::pair{"classification", "  force_ratio         1        enclosed   |f|_max/(mu_s P)\n"},
        {"classification", "\n  verdict: word by word\n"},
        {"single-mass-events", "  time: uncertainty 2.5e-31 to 1.2e-30 s, tolerance 1e-06 (scale)\n"},
        {"stick-slip-events", ", tolerance 8e-05 s (absolute)\n"}})
    EXPECT_TRUE(holds(run_line(std::string("reference show ") + name).output, part));
}

// --- a wall that moves

TEST_F(Answers, SquealNamesTheModeAndItsCriticalSpeed) {
  const std::string settings = " --set numerics.modes=4 --set numerics.elements=12 --settle 100";
  const auto answer = json("squeal reed" + settings);
  const auto& mode = answer["modes"][0];
  EXPECT_GT(mode["root"]["growth_per_s"], 0.0);
  EXPECT_LT(answer["modes"][1]["root"]["growth_per_s"], 0.0);
  // A growth g moves the frequency by less than g^2/(2 omega^2) of it, 94.8 1/s against 1575.4 1/s.
  const double free = mode["frequency_hz"], speed = mode["critical_speed_m_per_s"];
  EXPECT_NEAR(mode["root"]["frequency_hz"], free, 2e-3 * free);
  for (const double share : {0.99, 1.01})
    EXPECT_EQ(json(fmt::format("squeal reed --speed {}{}", share * speed, settings))["verdict"],
              share > 1.0 ? "stable" : "unstable");
  EXPECT_TRUE(answer["cycle"]["found"]);
  EXPECT_EQ(answer["cycle"]["multipliers"].size(), 10U);
  EXPECT_EQ(json("periodic reed" + settings)["period_s"], answer["cycle"]["period_s"]);
  const auto never =
      json("squeal reed --set damping.ratio=0 --set numerics.modes=2 --set numerics.elements=4 --settle 1")
          ["modes"][0];
  EXPECT_TRUE(never["critical_speed_m_per_s"].is_null());
  EXPECT_EQ(never["unstable_at_every_speed"], true);
  EXPECT_EQ(mode["unstable_at_every_speed"], false);
}

// Two modes and the tip have three roots; without a damping ratio the modes are those of the continuous beam.
TEST_F(Answers, SquealHasAsManyModesAsItsModel) {
  const std::string reed = "squeal reed --set numerics.modes=2 --set numerics.elements=4 --settle 1 --modes ";
  const auto modes = json(reed + "3")["modes"];
  ASSERT_EQ(modes.size(), 3u);
  EXPECT_GT(modes[2]["frequency_hz"], modes[1]["frequency_hz"]);
  expect_refused(reed + "4", "--modes is 4, but must be at most 3");
  EXPECT_EQ(json(reed + "4 --set damping.ratio=0")["modes"].size(), 4u);
}

// Below the critical speed of 1 % of damping a disturbance grows, slowly at 0.2 % below it, and above it none does.
TEST_F(Answers, SquealMapsTheGrowth) {
  install_gnuplot("cat \"${folder}squeal.csv\" > $output\n");
  const std::string reed =
      "squeal reed --set numerics.modes=2 --set numerics.elements=4 --settle 1 --modes 3 ";
  const double critical = json(reed)["modes"][0]["critical_speed_m_per_s"];
  const std::string text =
      run_line(reed + fmt::format("--speeds {}:{} --ratios 0.01:0.03 --count 3 --map - --figure map.svg",
                                  0.998 * critical, 1.004 * critical))
          .output;
  EXPECT_EQ(csv(text), csv(contents("map.svg")));
  auto map = columns_of(text);
  for (std::size_t i = 0; i < 9; ++i) {
    const std::string &speed = map["speed"].at(i), &ratio = map["damping_ratio"].at(i);
    EXPECT_NEAR(number(speed), (0.998 + 0.003 * static_cast<double>(i % 3)) * critical, 1e-15);
    EXPECT_NEAR(number(ratio), 0.01 * static_cast<double>(1 + i / 3), 1e-17);
    EXPECT_EQ(map["state"].at(i), i == 0 ? "unstable" : "stable") << i;
    // Eigenvalues of the model against roots of its mobility, rounded at 3e4 1/s.
    const auto at = json(reed + "--speed " + speed + " --set damping.ratio=" + ratio)["modes"][0]["root"];
    EXPECT_NEAR(number(map["growth"].at(i)), at["growth_per_s"], 1e-7) << i;
  }
}

TEST_F(Answers, PeriodicSaysWhatItFindsOrWhyNot) {
  const auto damped = json("periodic damped --set numerics.modes=5 --settle 50");
  EXPECT_EQ(damped["forced"], true);
  EXPECT_DOUBLE_EQ(damped["frequency_hz"], 25.0);
  EXPECT_DOUBLE_EQ(damped["period_s"], 1.0 / 25.0);
  EXPECT_EQ(damped["verdict"], "unstable");
  // On a fast wall the tip slides all the time, and goes with the base.
  const std::string fast = "periodic reed --set wall.speed=1.5 --set numerics.modes=2 ";
  const auto sliding = json(fast + "--amplitude 1e-5 --hz 100 --periods 2");
  EXPECT_DOUBLE_EQ(sliding["period_s"], 0.02);
  EXPECT_EQ(sliding["stick_share"], 0.0);
  EXPECT_TRUE(sliding["changes_of_contact"].empty());
  EXPECT_EQ(json(fast)["reason"], "the contact slides steadily");
  EXPECT_EQ(json("periodic paper --hz 15 --amplitude 1e-5 --settle 5")["reason"], "the contact sticks");
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

TEST(NumberText, OfBoundsIsWhatBothRoundToOrBoth) {
  EXPECT_EQ(common_digits({2.0, 2.0}), "2");
  EXPECT_EQ(common_digits({1.2344, 1.2346}), "1.23");  // 1.234 and 1.235
  EXPECT_EQ(common_digits({1.23441, 1.23449}), "1.234");
  EXPECT_EQ(common_digits({1.1, 1.3}), "1.100 ... 1.300");  // fewer than three say too little
}

}  // namespace
}  // namespace stickslip::cli
