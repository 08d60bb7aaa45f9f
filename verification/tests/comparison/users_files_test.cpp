// SPDX-License-Identifier: MIT
/// Files as other programs write them: words, events that are missing or too many, files that end early, and times
/// that are not those of the data set.

#include "comparison/samples.hpp"
#include "own_copy.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using comparison::Agreement;
using comparison::Comparison;
using comparison::Settings;

bool mentions(const Comparison& comparison, const std::string& part) {
  return std::ranges::any_of(
      comparison.remarks, [&](const std::string& remark) { return remark.find(part) != std::string::npos; });
}

std::string_view level_of(const OwnCopy& mine) { return comparison::level_names.at(mine.compared().level); }

// --- words

STICKSLIP_VERIFIES(ComparedWords, "X20");
TEST(ComparedWords, ThatDifferAreCounted) {
  for (const bool is_named_by_the_rule : {true, false}) {  // all that may stand in a column count
    auto mine = published_copy("classification", {"frequency", "amplitude", "verdict"});
    auto& values = mine.data_set().table.resource.comparison->values;
    if (!is_named_by_the_rule) std::erase_if(values, [](const auto& one) { return one.field == "verdict"; });
    EXPECT_EQ(mine.compared().agreement, Agreement::agrees);
    EXPECT_EQ(mine.compared("verdict").compared, 480u);
    mine.words("verdict")[0] = "stick-slip";
    EXPECT_EQ(level_of(mine), "1e-2");  // the share of the words
    const auto slips = static_cast<double>(std::ranges::count(mine.words("verdict"), "stick-slip")) - 1.0;
    ASSERT_GT(slips, 100.0);
    std::ranges::fill(mine.words("verdict"), "stick");
    const auto verdict = mine.compared("verdict");
    EXPECT_EQ(verdict.error, slips);
    EXPECT_TRUE(verdict.where.ends_with("(stick-slip in the data set)")) << verdict.where;
    EXPECT_EQ(mine.compared(with_tolerance("verdict", slips)).agreement, Agreement::agrees);
    EXPECT_EQ(mine.compared(with_tolerance("verdict", slips - 1.0)).agreement, Agreement::differs);
    // No tolerance of all quantities is one of words. It would be one of the ratio that decides them.
    EXPECT_TRUE(is_named_by_the_rule ||
                mine.compared(with_tolerance("", 1e3)).agreement == Agreement::differs);
    mine.words("verdict")[7] = "slip";
    EXPECT_EQ(mine.error_message(), "mine.csv:9: verdict is 'slip', but must be one of stick, stick-slip");
  }
}

TEST(ComparedWords, CountNotWhereAMeshMayDecideThem) {
  // A point of which the ratio is r counts if |r - 1| > tolerance r + radius; the radii are below 1e-20.
  auto mine = published_copy("classification", {"frequency", "amplitude", "verdict"});
  const auto& ratio = mine.reference().column("force_ratio").values;
  const auto distance = [](double r) { return std::abs(r - 1.0) / r; };
  const auto nearest = std::ranges::min_element(ratio, {}, distance);
  auto& word = mine.words("verdict")[static_cast<std::size_t>(nearest - ratio.begin())];
  word = word == "stick" ? "stick-slip" : "stick";
  const double limit = distance(*nearest);
  ASSERT_GT(limit, 1e-3);
  EXPECT_EQ(mine.compared("verdict").error, 1.0);
  EXPECT_EQ(mine.compared("verdict", with_tolerance("force_ratio", 0.99 * limit)).error, 1.0);
  const auto near = mine.compared("verdict", with_tolerance("force_ratio", 1.01 * limit));
  EXPECT_EQ(near.error, 0.0);
  EXPECT_EQ(near.compared, 479u);
  EXPECT_EQ(skipped_for(near, "too near to the threshold"), 1u);
}

TEST(ComparedWords, OfAnEventDecideOnItsPartner) {
  for (const std::string set : {"published-problems", "single-mass-events"}) {
    auto mine = published_copy(set);
    for (std::string& word : mine.words("change"))
      word = word == "capture" ? "reversal" : word == "reversal" ? "capture" : word;
    EXPECT_EQ(mine.compared("sequence").agreement, Agreement::differs);
  }
  for (const char* word : {"foo", "state"}) {  // "state" is one of published-problems
    auto mine = published_copy("stick-slip-events");
    mine.words("change")[0] = word;
    EXPECT_EQ(mine.error_message(),
              fmt::format("mine.csv:2: change is '{}', but must be one of onset, capture, "
                          "reversal, graze",
                          word));
  }
}

// --- events

STICKSLIP_VERIFIES(ComparedEvents, "X20");
TEST(ComparedEvents, OfManyProblemsHaveAVerdictEach) {
  auto mine = published_copy("published-problems");
  mine.erase(32);
  const Comparison comparison = mine.compared();
  EXPECT_EQ(comparison.agreement, Agreement::differs);
  EXPECT_TRUE(mentions(comparison,
                       "problem = hong-liu-2: event 2 (capture at 0.561845592 s) is missing in the file"));
  EXPECT_EQ(level_of(mine), "none");  // although it is one event of 77
  ASSERT_EQ(comparison.parts.size(), 10u);
  for (const auto& part : comparison.parts) {
    const bool is_whole = part.name != "problem = hong-liu-2";
    EXPECT_EQ(part.agreement, is_whole ? Agreement::agrees : Agreement::differs) << part.name;
    EXPECT_EQ(part.rows, part.all_rows) << part.name;
    EXPECT_EQ(comparison::level_names.at(part.level), is_whole ? "strict" : "none") << part.name;
  }
}

TEST(ComparedEvents, OfSeveralRunsAreKeptApart) {
  auto mine = own_copy("cubic-events", {"run", "index", "change", "time"});
  mine["time"][3] += 3e-7;
  const Comparison comparison = mine.compared();
  EXPECT_EQ(quantity_of(comparison, "time").where, "event 1 (onset at 0.455 s), run = b");
  EXPECT_EQ(comparison.agreement, Agreement::agrees);
  EXPECT_TRUE(mentions(comparison, "position is not in the file and was not compared"));
  mine.erase(3);
  EXPECT_EQ(mine.compared().agreement, Agreement::undecided);
  EXPECT_TRUE(mentions(mine.compared(), "run = b is not in the file and was not compared"));
}

// A second event directly behind one of the file, perhaps with another word.
TEST(ComparedEvents, CountWhatIsTooManyButNoGraze) {
  for (const auto& [set, row, word, error] : {std::tuple{"damped-events", 3u, "capture", 1.0},
                                              {"damped-events", 1u, "graze", 0.0},
                                              {"published-problems", 31u, "reversal", 1.0},
                                              {"stick-slip-events", 1u, "reversal", 0.0}}) {
    auto mine = std::string(set) == "damped-events" ? own_copy(set) : published_copy(set);
    mine.repeat(row);
    mine.words("change")[row + (error > 0.0 ? 1 : 0)] = word;
    const auto sequence = mine.compared("sequence");
    EXPECT_EQ(sequence.error, error) << set << " " << word;
    EXPECT_EQ(mentions(mine.compared(), "of the file is not in the data set"), error > 0.0);
  }
}

TEST(ComparedEvents, MayLieOnEitherSideOfTheHorizon) {
  // They have five events; the sixth lies before the latest time by what it may be late, or by more: an absolute
  // tolerance of a time and its half-width, or a share of the latest time.
  auto five = own_copy("damped-events");
  const double sixth = five["time"][5], radius = five.reference().radius_of("time")[5];
  five.keep_first(5);
  const auto missing = [&](double tolerance, double margin) {
    return *five.compared("sequence", with_tolerance("time", tolerance, sixth + margin)).error;
  };
  EXPECT_EQ(missing(2e-5, 2e-5 + 0.9 * radius), 0.0);
  EXPECT_EQ(missing(2e-5, 2e-5 + 1.1 * radius), 1.0);
  five.data_set().table.resource.comparison->values.front().norm = data::Norm::relative;
  EXPECT_EQ(missing(1e-4, 0.9e-4 * sixth), 0.0);
  EXPECT_EQ(missing(1e-4, 1.1e-4 * sixth), 1.0);
  // An event too many behind the horizon of 0.11 s of the data set, with the time of one before it.
  auto mine = own_copy("damped-events");
  mine["time"][6] = 0.1095;
  EXPECT_EQ(mine.compared().remarks,
            std::vector<std::string>{"event 7 (onset at 0.1095 s) of the file is not in the data set"});
  EXPECT_EQ(skipped_for(mine.compared("time"), "without an event of the data set"), 1u);
}

TEST(ComparedEvents, OfShortPhasesInARowAreOne) {
  // Their first capture takes 15 us or 0.3 ms, with sticks of 10 us and slips of 5 us.
  for (const std::size_t sticks : {1u, 20u}) {
    auto mine = published_copy("stick-slip-events");
    const double capture = mine["time"][1];
    for (std::size_t i = 0; i < 2 * sticks; ++i) mine.repeat(1);
    for (std::size_t i = 1; i <= 2 * sticks; ++i) {
      mine.words("change")[i + 1] = i % 2 == 1 ? "onset" : "capture";
      mine["time"][i + 1] =
          capture + 1e-5 * static_cast<double>((i + 1) / 2) + 5e-6 * static_cast<double>(i / 2);
    }
    EXPECT_EQ(mine.compared("sequence").error, 0.0);
    EXPECT_EQ(mine.compared("time").agreement, sticks == 1 ? Agreement::agrees : Agreement::undecided);
  }
}

STICKSLIP_VERIFIES(ComparedAngle, "X20");
TEST(ComparedAngle, IsTheSameAWholeTurnFurther) {
  auto mine = published_copy("damped-steady-state");
  for (double& phase : mine["force_phase"]) phase -= 6.0 * std::numbers::pi;
  EXPECT_EQ(mine.compared().agreement, Agreement::agrees);
}

// --- what the file leaves out

STICKSLIP_VERIFIES(ComparedCoverage, "X20");
TEST(ComparedCoverage, OfARangeMustBeNineTenths) {
  // A sample covers a fortieth on either side: 0.875 + 0.025.
  for (const auto& [last, agreement] : std::vector<std::pair<double, Agreement>>{
           {0.4375, Agreement::agrees}, {0.437, Agreement::undecided}, {0.01, Agreement::undecided}}) {
    auto mine = published_copy("undamped-history-25");
    const auto time = mine["time"];
    mine.keep([&, latest = last](std::size_t row) { return time[row] <= latest; });
    const Comparison comparison = mine.compared();
    EXPECT_EQ(comparison.agreement, agreement) << last;
    EXPECT_TRUE(within(comparison.coverage, last / 0.5 + 0.025, round_off(1e4, 1.0, 1.0))) << last;
    EXPECT_EQ(mentions(comparison, fmt::format("the file covers {} % of time from 0 to 0.5 s, but a verdict "
                                               "needs at least 90 %",
                                               last > 0.1 ? 89 : 4)),
              agreement == Agreement::undecided);
    EXPECT_EQ(mine.compared(until(last)).agreement, Agreement::agrees);
    mine["tip_displacement"][5] += 1.0;
    EXPECT_EQ(mine.compared().agreement, Agreement::differs);
  }
  auto three = published_copy("undamped-history-25");
  three.keep([](std::size_t row) { return row == 250 || row == 500 || row == 750; });
  EXPECT_TRUE(within(three.compared().coverage, 0.15, round_off(16.0, 1.0, 1.0)));
  // Of two runs each is told.
  const auto remarks = own_copy("cubic-history").keep_first(31).compared().remarks;
  ASSERT_EQ(remarks.size(), 2u);
  EXPECT_EQ(remarks[0], "run = b is not in the file and was not compared");
  EXPECT_TRUE(holds(remarks[1], "the file covers 33 % of t from 0 to 0.95 s of run = a"));
}

TEST(ComparedCoverage, OfEventsEndsWithTheLastOne) {
  auto mine = published_copy("stick-slip-events");
  const double end = mine["time"][19], last = mine["time"].back();
  mine.keep_first(20);
  const Comparison comparison = mine.compared();
  EXPECT_EQ(comparison.agreement, Agreement::undecided);
  EXPECT_TRUE(within(comparison.coverage, end / last, round_off(1.0, 1.0, 1.0)));
  const auto sequence = mine.compared("sequence");
  EXPECT_EQ(sequence.agreement, Agreement::undecided);
  EXPECT_EQ(sequence.undecided, 27u);
  EXPECT_EQ(sequence.compared, 47u);
  EXPECT_EQ(sequence.where, "the end of the file");
  EXPECT_TRUE(mentions(comparison, "27 more events up to"));
  EXPECT_EQ(mine.compared(until(end + 2e-4)).agreement, Agreement::agrees);
  EXPECT_EQ(mine.compared(until(0.5)).agreement, Agreement::differs);
  EXPECT_EQ(mine.compared("sequence", until(0.5)).error, 27.0);
  // The first eight are named.
  const auto told = [](std::size_t rows) {
    return published_copy("stick-slip-events").keep_first(rows).compared(until(0.5)).remarks;
  };
  EXPECT_EQ(told(39).size(), 8u);
  EXPECT_EQ(told(38).size(), 9u);
  EXPECT_EQ(told(20).back(), "27 events are missing or not in the data set");
  const Comparison but_one = published_copy("stick-slip-events").keep_first(46).compared();
  EXPECT_TRUE(mentions(but_one, "1 more event up to"));
  EXPECT_EQ(but_one.agreement, Agreement::undecided);
  // The events of a history that ends early are no doubt about their sequence.
  auto half = published_copy("stick-slip-history"), events = published_copy("stick-slip-events");
  half.keep_first(1250);
  events.keep([&, time = events["time"]](std::size_t row) { return time[row] < 0.25; });
  EXPECT_EQ(half.compared().agreement, Agreement::undecided);
  EXPECT_EQ(half.compared(until(0.25)).agreement, Agreement::agrees);
  EXPECT_EQ(half.compared("sequence", with_events(events)).agreement, Agreement::agrees);
}

TEST(ComparedCoverage, OfATableIsThatOfNeededRows) {
  using Ranges = std::vector<std::pair<std::size_t, std::size_t>>;
  auto mine = published_copy("classification"), problem = published_copy("published-problems");
  mine.keep([](std::size_t row) { return row < 48 || row == 50; });
  problem.keep([](std::size_t row) { return row >= 9 && row < 13; });
  const auto needing = [](const Ranges& rows) {
    return Settings{.tolerances = {}, .until = {}, .rows = rows};
  };
  for (const auto& [copy, rows, decides] :
       std::vector<std::tuple<const OwnCopy*, Ranges, bool>>{{&mine, {{1, 48}}, true},
                                                             {&mine, {{3, 4}, {51, 51}}, true},
                                                             {&mine, {}, false},
                                                             {&mine, {{1, 49}}, false},
                                                             {&mine, {{1, 48}, {50, 50}}, false},
                                                             {&problem, {{10, 13}}, true},
                                                             {&problem, {}, false},
                                                             {&problem, {{9, 13}}, false}})
    EXPECT_EQ(copy->compared(needing(rows)).agreement, decides ? Agreement::agrees : Agreement::undecided);
  const Comparison part = mine.compared();
  EXPECT_TRUE(within(part.coverage, 49.0 / 480.0, round_off(1.0, 1.0, 1.0)));
  EXPECT_EQ(part.row_numbers, "1:48,51");
  EXPECT_EQ(level_of(mine), "none");
  mine["force_ratio"][48] *= 1.1;  // which is not asked for
  EXPECT_EQ(mine.compared(needing({{1, 48}})).agreement, Agreement::differs);
  for (const auto& [first, last] : Ranges{{0, 3}, {4, 3}, {1, 481}})
    EXPECT_EQ(mine.error_message(needing({{first, last}})),
              fmt::format("the range of rows is {}:{}, but must be within 1:480", first, last));
  EXPECT_EQ(published_copy("stick-history").error_message(needing({{1, 3}})),
            "row numbers are given, but the data set stick-history is one curve");
}

TEST(ComparedCoverage, AtRareSamplesGoesUpToEvents) {
  // Every 10 ms, with 94 events a second. Two samples are within the shortest phase of 0.33 ms of an event.
  auto energy = published_copy("stick-slip-energy");
  EXPECT_EQ(energy.compared().agreement, Agreement::agrees);
  EXPECT_EQ(energy.compared("friction_loss").compared, 48u);
  // Their onset at 0.0553 s is 50 us late, and they have samples every 10 us.
  auto mine = published_copy("stick-slip-history", {"time", "phase", "tip_displacement"});
  mine.keep_first(5);
  for (std::size_t i = 0; i < 5; ++i) mine["time"][i] = 0.0553214408237 + 1e-5 * static_cast<double>(i + 1);
  std::ranges::fill(mine.words("phase"), "stick");
  EXPECT_TRUE(holds(mine.error_message(), "5 between the two times of an event"));
}

// --- times between those of the data set

STICKSLIP_VERIFIES(ComparedSamples, "X20");
TEST(ComparedSamples, FarBeyondMayBeInAnotherUnit) {
  for (const double factor : {99.0, 1000.0}) {
    auto mine = published_copy("stick-history");
    for (double& time : mine["time"]) time *= factor;
    EXPECT_EQ(mentions(mine.compared(with_tolerance("", 1e9)), "has it another unit?"), factor > 100.0);
  }
  auto late = published_copy("stick-history");
  late.erase(0);
  for (double& time : late["time"]) time *= 1e3;
  EXPECT_EQ(late.error_message(),
            "mine.csv: none of the 999 rows can be compared: 999 outside the range of the data set; time "
            "goes up to "
            "1000 s in the file and up to 1 s in the data set: has it another unit?");
}

comparison::Samples sampled(std::size_t size, double step, const std::function<double(double)>& curve) {
  comparison::Samples samples;
  for (std::size_t i = 0; i < size; ++i) {
    samples.abscissa.push_back(step * static_cast<double>(i));
    samples.values.push_back(curve(samples.abscissa.back()));
    samples.half_width.push_back(0.0);
  }
  return samples;
}

TEST(ComparedSamples, OfAQuarticHaveTheCubicsError) {
  const auto quartic = [](std::size_t size) {
    return sampled(size, 1.0, [](double x) { return x * x * x * x; });
  };
  const auto width = [&](std::size_t size, double x, double most_rough = 1e9) {
    return comparison::interpolated(quartic(size), x, most_rough)->half_width;
  };
  // The product of the distances to them: 2 1 1 2, and 1 1 2 3 beside an end.
  const auto rounding = round_off(20.0, 3.0, std::pow(39.0, 4));
  for (const auto& [x, error] : std::vector<std::pair<double, double>>{
           {0.5, 6.0}, {8.5, 6.0}, {9.5, 4.0}, {29.5, 4.0}, {30.5, 6.0}, {38.5, 6.0}}) {
    EXPECT_TRUE(within(comparison::roughness_at(quartic(40), x), error, rounding)) << x;
    EXPECT_TRUE(within(width(40, x), 2.0 * error, rounding)) << x;
  }
  // Its value is below the quartic by the product of the distances, 1.5 0.5 0.5 1.5.
  EXPECT_TRUE(within(comparison::interpolated(quartic(40), 9.5)->value, std::pow(9.5, 4) - 0.5625, rounding));
  EXPECT_TRUE(within(width(40, 20.25), 6.0, rounding));
  EXPECT_EQ(width(40, 20.25, 1.0), 1.5);
  EXPECT_TRUE(within(width(5, 1.5), 12.0, rounding));
  // Fewer samples: the cubic or the parabola against the straight line.
  EXPECT_TRUE(std::isinf(comparison::roughness_at(quartic(4), 1.5)));
  EXPECT_TRUE(within(width(4, 1.5), 4.0, rounding));
  EXPECT_TRUE(within(width(3, 0.5), 1.75, rounding));
  EXPECT_FALSE(comparison::interpolated(quartic(2), 0.5).has_value());
  const data::Interpolation cubic{.order = 3, .error = {}};
  EXPECT_TRUE(within(comparison::interpolated(quartic(4), 1.5, cubic, 0.25)->value, 4.5, rounding));
  EXPECT_FALSE(comparison::interpolated(quartic(3), 1.5, cubic, 0.25).has_value());
}

TEST(ComparedSamples, AreComparedWhereTheyAreAlone) {
  const auto reference = sampled(11, 1.0, [](double x) { return x; });
  const auto compared = [&](const std::vector<double>& x) {
    return comparison::by_own_interpolation(reference, {x, x, std::vector(x.size(), 0.0)}, 1.0, 1e-9);
  };
  struct Expected {
    std::vector<double> theirs, points;
    std::size_t between, past_last;
  };
  for (const auto& [theirs, points, between, past_last] :
       {Expected{{4.4, 4.8, 5.2}, {5.0}, 3, 0},
        Expected{{4.8, 5.2}, {4.8, 5.2}, 0, 0},  // too few to interpolate
        Expected{{1.5, 6.2, 6.6, 7.1, 7.4}, {1.5, 6.2, 7.0}, 3, 0}, Expected{{10.5, 12.0, 14.0}, {}, 0, 3}}) {
    const auto found = compared(theirs);
    std::vector<double> abscissa;
    for (const auto& point : found.points) abscissa.push_back(point.abscissa);
    EXPECT_EQ(abscissa, points) << theirs[0];
    EXPECT_EQ(found.between, between) << theirs[0];
    EXPECT_EQ(found.past_last, past_last) << theirs[0];
  }
  // Values of the right times beside times that are rounded to single precision: the difference is uncertain.
  auto rounded = reference;
  for (double& x : rounded.abscissa) x *= 1.0 + 0x1p-25;
  const auto points = comparison::by_own_interpolation(reference, rounded, 1.0, 1e-12).points;
  EXPECT_EQ(points.size(), 11u);
  for (const auto& [x, value, known] : points)
    EXPECT_TRUE(within(value.half_width, 0x1p-25 * x, round_off(40.0, 3.0, 10.0))) << x;
}

// The polynomials of the data set, of order 3 in each phase, at other times. Interpolation reproduces them but for some
// ten eps.
TEST(ComparedSamples, AreInterpolatedToThePublished) {
  // At 0.01, ..., 0.29 s of the data set, or at their 15 or 10 samples up to 0.283 s or 0.273 s.
  for (const auto& [step, count] :
       std::vector<std::pair<std::size_t, std::size_t>>{{1, 29}, {2, 15}, {3, 10}}) {
    auto mine = own_copy("cubic-history");
    mine.data_set().table.resource.comparison->interpolation.reset();
    auto& t = mine["t"];
    mine.keep([&, every = step](std::size_t row) { return row < 31 && row % every == 0; });
    for (std::size_t i = 0; i < t.size(); ++i) {
      t[i] += 0.003;  // run a sticks up to 0.305 s, y = 1 + t - 2 t^2 + t^3
      mine["y"][i] = 1.0 + t[i] - 2.0 * t[i] * t[i] + t[i] * t[i] * t[i];
    }
    const auto settings = with_tolerance("y", 0.01, 0.31);
    const auto y = mine.compared("y", settings);
    EXPECT_EQ(y.compared, count) << step;
    EXPECT_TRUE(within(*y.error, 0.0, round_off(10.0, 4.0, 2.0)));
    mine["y"][4] += 0.5;
    EXPECT_EQ(mine.compared("y", settings).agreement, Agreement::differs) << step;
  }
}

TEST(ComparedSamples, MayStandTwiceAtATime) {
  auto curve = published_copy("undamped-history-25");
  curve.repeat(100);
  EXPECT_EQ(curve.compared().agreement, Agreement::agrees);
  curve["tip_displacement"][101] += 0.5;
  EXPECT_TRUE(curve.error_message().starts_with("mine.csv:102: time is 0.05 as in the row before, but "))
      << curve.error_message();
  auto history = published_copy("stick-slip-history");
  history.repeat(276);
  EXPECT_EQ(history.compared().agreement, Agreement::agrees);
}

}  // namespace
}  // namespace stickslip::testing
