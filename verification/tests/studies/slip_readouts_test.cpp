// SPDX-License-Identifier: MIT
/// The read-outs of stick-slip: of motions that are known, and alike by two methods.

#include "studies/analyses/slip_readouts.hpp"

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/reference.hpp"
#include "studies/history/method.hpp"
#include "support/command_line.hpp"
#include "support/structures.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using data::ContactChange, data::ContactState;

// z and f are sines with whole periods in a window; mu N = 1 N, and the wall rests.
studies::SlipReadouts readouts_of_sines(double hz) {
  studies::History history;
  for (int n = 0; n <= 44100; ++n) {
    const double t = n / 44100.0, turn = 2.0 * std::numbers::pi * t;
    history.rows.push_back({.time = t,
                            .tip_displacement = 1e-3 * std::sin(10.0 * turn),
                            .friction_force = 5.0 + 2.0 * std::sin(hz * turn),
                            .state = ContactState::slip});
  }
  return studies::slip_readouts(data::load_case("sdnd100"), history, {});
}

// Slips of 1 ms and 0.1 mm at mu N = 1 N, so many in each of ten seconds; every second one is late by a part of the period.
studies::SlipReadouts readouts_of_slips(int rate, double late) {
  studies::History history;
  const auto row = [&](double time, double y, ContactState state) {
    history.rows.push_back({.time = time, .tip_displacement = y, .friction_force = 1.0, .state = state});
  };
  double y = 0.0;
  row(0.0, y, ContactState::stick);
  for (int n = 0; n < 10 * rate; ++n, y += 1e-4) {
    const double start = (n + 0.5 + (n % 2 == 1 ? late : 0.0)) / rate, end = start + 1e-3;
    history.events.push_back({ContactChange::onset, start, y, 0.0});
    row(0.5 * (start + end), y + 0.5e-4, ContactState::slip);
    history.events.push_back({ContactChange::capture, end, y + 1e-4, 0.0});
    row((n + 1.0) / rate, y + 1e-4, ContactState::stick);
  }
  return studies::slip_readouts(data::load_case("sdnd100"), history, {});
}

STICKSLIP_VERIFIES(SlipReadouts, "W4");
TEST(SlipReadouts, OfSinesAreThoseOfSines) {
  constexpr double quarter = 0.5 * std::numbers::pi, per_row = 2.0 * std::numbers::pi * 10.0 / 44100.0;
  const auto rows = [&](double scale) {
    return discretisation(scale * per_row, 1.0, "a row beside the exact place");
  };
  for (const auto& [hz, weighting] : {std::pair{1000.0, 0.0}, {100.0, -19.1}, {8000.0, -1.1}}) {
    const auto sines = readouts_of_sines(hz);
    EXPECT_TRUE(within(sines.peak_to_peak.value, 2e-3, rows(1e-3 * per_row)));
    EXPECT_TRUE(within(sines.distance_95, 1e-3 * std::sin(0.95 * quarter), rows(1e-3 * 0.1)));
    EXPECT_TRUE(within(sines.distance_99, 1e-3 * std::sin(0.99 * quarter), rows(1e-3 * 0.1)));
    EXPECT_TRUE(within(sines.travel, 0.04, rows(0.04 * per_row)));
    EXPECT_NEAR(sines.slip_share.value, 1.0, 1e-12);
    EXPECT_NEAR(sines.peak_hz, hz, 0.5);
    EXPECT_TRUE(within(sines.peak_force, 2.0, discretisation(2.0 * 8e-4, 1.0, "flat-top window")));
    EXPECT_NEAR(sines.force_level, 20.0 * std::log10(std::sqrt(2.0)), 1e-3);
    EXPECT_NEAR(sines.a_weighted_level - sines.force_level, weighting, 0.06) << hz;  // a table of 0.1 dB
    EXPECT_EQ(sines.sound, "none");
  }
}

TEST(SlipReadouts, OfSlipsAreTheirNumbers) {
  for (const auto& [rate, late, sound] :
       {std::tuple{30, 0.0, "squeal"}, {30, 0.3, "tick"}, {10, 0.0, "tick"}}) {
    const auto slips = readouts_of_slips(rate, late);
    EXPECT_EQ(slips.slips, 10U * static_cast<unsigned>(rate));
    EXPECT_TRUE(within(slips.travel, 1e-3 * rate, round_off(1000, 1, 0.1)));
    for (const auto& [mean, each] : {std::pair{slips.travel_rate, 1e-4},
                                     {slips.friction_power, 1e-4},
                                     {slips.slip_rate, 1.0},
                                     {slips.slip_share, 1e-3}}) {
      EXPECT_NEAR(mean.value, each * rate, 1e-10 * each * rate);
      EXPECT_NEAR(mean.upper, mean.value, 1e-10 * mean.value);
    }
    EXPECT_NEAR(slips.slips_per_travel, 1e4, 1e-6);
    EXPECT_NEAR(slips.spacing * rate, 1.0, 0.01);
    EXPECT_NEAR(slips.spacing_variation, late, 0.01);
    EXPECT_EQ(slips.sound, sound);
  }
}

// mu N times the travel, of which the set has N times, of a mass on a shaken plane, from 4 to 12 s.
TEST(SlipReadouts, OfAShakenPlaneAreAsPublished) {
  const data::ReferenceTable powers = data::read_table(data::load_reference(), "friction-powers");
  for (std::size_t row = 0; row < powers.rows(); ++row) {
    const double expected = 0.1 * powers.column("power").values[row];
    const data::Case shaken =
        with_value(data::load_case("sdnd104"), "wall.scale", powers.column("amplitude").values[row]);
    const studies::ReadoutOptions options{.transient = 4.0};
    const auto history =
        studies::event_driven().run(shaken, {.every = studies::readout_row_step(shaken, options)}, {}, {});
    EXPECT_TRUE(within(studies::slip_readouts(shaken, history, options).friction_power.value, expected,
                       reference(1e-12 + 1e-6 * expected, "tolerance of the set")));
  }
}

// One wall of constant speed, one that shakes, and a record. Empirical: 0.1 %, and 0.02 dB.
TEST(SlipReadouts, AreAlikeByTwoMethods) {
  for (const std::string name : {"squeak-stand", "sdnd104", "recorded-mass"}) {
    const data::Case problem = with_value(data::load_case(name), "numerics.velocity_threshold", 0.0);
    const auto by = [&](const studies::Method& method) {
      return studies::slip_readouts(
          problem, method.run(problem, {.every = studies::readout_row_step(problem, {})}, {}, {}), {});
    };
    const auto exact = by(studies::event_driven()), steps = by(studies::finite_elements());
    EXPECT_EQ(steps.slips, exact.slips) << name;
    EXPECT_GT(exact.slips, 0U) << name;
    for (const auto& value : {&studies::SlipReadouts::travel, &studies::SlipReadouts::distance_95,
                              &studies::SlipReadouts::distance_99, &studies::SlipReadouts::peak_force})
      EXPECT_NEAR(steps.*value, exact.*value, 1e-3 * exact.*value) << name;
    for (const auto& mean : {&studies::SlipReadouts::slip_share, &studies::SlipReadouts::friction_power})
      EXPECT_NEAR((steps.*mean).value, (exact.*mean).value, 1e-3 * (exact.*mean).value) << name;
    EXPECT_NEAR(steps.a_weighted_level, exact.a_weighted_level, 0.02) << name;
  }
}

// Where the contact has been held before, whether by modes or by elements, which repeat a period until that changes 1e-3 and begin with an error
// of that times the decay over a period, 0.41. The mesh shares its frequencies to 1e-6, and a history of 2 s.
TEST(SlipReadouts, OfASpectrumBeginStationary) {
  const data::Case problem = data::load_case("rough-road", {{"excitation.duration", "2"}});
  const auto rows = [&](const studies::Method& method) {
    return method.run(problem, {.every = 2000}, {}, {}).rows;
  };
  const auto elements = rows(studies::finite_elements()), modes = rows(studies::event_driven());
  double bent = 0.0;
  for (const auto& row : modes)
    bent = std::max(bent, std::abs(row.midspan_displacement - row.base_displacement));
  EXPECT_GT(std::abs(modes.front().midspan_displacement - modes.front().base_displacement), 0.1 * bent);
  for (std::size_t i = 0; i < modes.size(); ++i)
    EXPECT_TRUE(within(elements[i].midspan_displacement, modes[i].midspan_displacement,
                       discretisation(1e-3 * bent, 1.0, "held for a finite time")))
        << i;
  for (const auto* method : {&studies::finite_elements(), &studies::event_driven()}) {
    const auto row = method->run(problem, {.times = {0.0}}, {.starts_with_the_base = true}, {}).rows.front();
    EXPECT_NEAR(row.midspan_displacement, row.base_displacement, 1e-15) << method->name;  // undeformed
  }
  const data::Case other =
      data::load_case("rough-road", {{"damping.ratio", "0"}, {"damping.kelvin_voigt", "1e-5"}});
  EXPECT_THROW(studies::boundary_integral().require(other), data::FieldError);
}

class NvhAverage : public CommandLine {};

// With two values a and b Student's t of 95 % has half the width 12.7062 |a - b|/2.
STICKSLIP_VERIFIES(NvhAverage, "W4");
TEST_F(NvhAverage, IsThatOfTheSeedsOneByOne) {
  const std::string nvh = "nvh random.toml --duration 2 --average ",
                    text = contents(data::find_case("rough-road"));
  const auto with_seed = [&](const std::string& seed, int count) {
    const std::string line = "seed = 1\n";
    std::ofstream("random.toml") << std::string(text).replace(text.find(line), line.size(),
                                                              "seed = " + seed + "\nscale = 3\n");
    return json(nvh + std::to_string(count));
  };
  const auto both = with_seed("7", 2), first = with_seed("7", 1), second = with_seed("8", 1);
  EXPECT_EQ(both["realisations"], 2);
  for (const std::string key : {"travel_m", "slips", "distance_95_m", "a_weighted_level_dB", "slip_share"}) {
    const auto number = [&](const nlohmann::json& of) {
      return of[key].is_object() ? of[key]["value"].get<double>() : of[key].get<double>();
    };
    const double a = number(first), b = number(second), half = 12.7062047361747 * std::abs(a - b) / 2.0;
    EXPECT_NE(a, b) << key;
    EXPECT_NEAR(number(both), 0.5 * (a + b), 1e-12 * std::abs(a + b)) << key;
    EXPECT_NEAR(both[key]["upper"], 0.5 * (a + b) + half, 1e-10 * half) << key;
  }
}

// What no realisation or one alone has, has no mean.
TEST(SlipReadouts, AreAveragedWhereThereAreTwo) {
  std::vector<studies::SlipReadouts> runs(3);
  runs[1].spacing = 2.0;
  const auto mean = [&] { return studies::mean_over(runs, std::mem_fn(&studies::SlipReadouts::spacing)); };
  EXPECT_TRUE(std::isnan(mean().value));
  runs[2].spacing = 3.0;
  EXPECT_EQ(mean().value, 2.5);
}

// Where a slip begins, a contact of constant force in each step may slide every other step: a slip of one step is none.
studies::History without_single_steps(studies::History history, double step) {
  std::vector<data::ContactEvent> events;
  for (const data::ContactEvent& event : history.events)
    if (event.change == ContactChange::capture && !events.empty() &&
        event.time - events.back().time < 1.5 * step)
      events.pop_back();
    else
      events.push_back(event);
  history.events = std::move(events);
  return history;
}

// A beam of four elements with 2 % of damping on Coulomb's friction: the shortest of 93 slips lasts 0.26 ms, the shortest stick 0.13 ms. From event
// to event the motion is exact; time steps have order 2, the boundary integral order 1 or better.
TEST(SlipReadouts, OfFortySinesAreAlikeByThree) {
  constexpr double step = 2e-5;
  data::Case problem = with_values(data::load_case("paper"), {{"excitation.duration", 1.5},
                                                              {"numerics.time_step", step},
                                                              {"numerics.velocity_threshold", 0.0},
                                                              {"numerics.modes", 7.0},
                                                              {"damping.ratio", 0.02},
                                                              {"friction.static_coefficient", 0.3},
                                                              {"friction.kinetic_coefficient", 0.3}});
  problem = with_matrices(problem, beam_matrices(problem.beam(), 4));
  problem.structure = data::Model(180.0, problem.model()->shared_matrices());
  RandomNumbers numbers(40);
  std::vector<data::Sine> sines(40);
  for (data::Sine& sine : sines)
    sine = {numbers.uniform(5.0, 100.0), 1.0, data::AmplitudeOf::acceleration,
            numbers.uniform(0.0, 2.0 * std::numbers::pi)};
  problem.motion = data::GeneralMotion(sines, 1.5);
  const long every = studies::readout_row_step(problem, {});
  const auto of = [&](const studies::History& history) {
    return studies::slip_readouts(problem, history, {});
  };
  const auto by_elements = [&](long coarser) {
    return of(studies::finite_elements().run(
        with_value(problem, "numerics.time_step", step * static_cast<double>(coarser)),
        {.every = every / coarser}, {}, {}));
  };
  const auto by_integral = [&](int finer) {
    return of(without_single_steps(studies::boundary_integral_history(problem, {.every = every}, finer),
                                   step / finer));
  };
  const auto exact = of(studies::event_driven().run(problem, {.every = every}, {}, {}));
  EXPECT_EQ(every, 4);
  EXPECT_EQ(exact.slips, 93U);
  for (const auto& [coarse, fine, share] :
       {std::tuple{by_elements(2), by_elements(1), 1.0 / 3.0}, {by_integral(1), by_integral(2), 1.0}}) {
    EXPECT_EQ(fine.slips, exact.slips);
    for (const auto& value : {&studies::SlipReadouts::travel, &studies::SlipReadouts::distance_95,
                              &studies::SlipReadouts::distance_99}) {
      const double change = std::abs(fine.*value - coarse.*value);
      EXPECT_TRUE(within(fine.*value, exact.*value, discretisation(share * change, 2.0, "Richardson")));
      EXPECT_NEAR(fine.*value, exact.*value, 1e-3 * exact.*value);
    }
  }
}

class SlipSound : public CommandLine {};

// The spacing of slips is the period of the limit cycle that shooting finds; the force of stick is v t k, over 5 s.
STICKSLIP_VERIFIES(SlipSound, "W4");
TEST_F(SlipSound, OfTheStandIsThatOfItsLimitCycle) {
  const auto answer = json("nvh squeak-stand --transient 0.5 --audio squeak.wav");
  EXPECT_EQ(answer["sound"], "squeal");
  EXPECT_EQ(answer["method"], "event-driven");
  const double period = json("squeal squeak-stand")["cycle"]["period_s"];
  EXPECT_NEAR(answer["spacing_s"], period, 1e-8 * period);
  EXPECT_NEAR(answer["slips"], 4.5 / period, 1.0);
  const std::string wav = contents("squeak.wav");
  const auto number = [&](std::size_t at, std::size_t bytes) {
    std::size_t value = 0;
    for (std::size_t i = bytes; i-- > 0;) value = 256 * value + static_cast<unsigned char>(wav.at(at + i));
    return value;
  };
  EXPECT_EQ(wav.substr(0, 4) + wav.substr(8, 8) + wav.substr(36, 4), "RIFFWAVEfmt data");
  EXPECT_EQ(wav.substr(16, 20), std::string("\x10\0\0\0\1\0\1\0\x44\xac\0\0\x88\x58\1\0\2\0\x10\0", 20));
  EXPECT_EQ(number(4, 4), wav.size() - 8);
  EXPECT_EQ(number(40, 4), wav.size() - 44);
  const double row_step = answer["row_step_s"], rows = answer["rows"];
  EXPECT_NEAR(static_cast<double>(number(40, 4)) / 2.0, 1.0 + 44100.0 * row_step * (rows - 1.0), 1.0);
  int largest = 0;
  for (std::size_t at = 44; at < wav.size(); at += 2)
    largest = std::max(largest, std::abs(static_cast<std::int16_t>(number(at, 2))));
  EXPECT_GT(largest, 32000);  // a line between rows may cut the peak
}

}  // namespace
}  // namespace stickslip::testing
