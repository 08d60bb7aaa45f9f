// SPDX-License-Identifier: MIT
/// Files as other programs write them, against the published data: words, events that are missing in between,
/// values of zero, files that end early, and times that are not those of the data set.

#include "comparison/event_sequence.hpp"
#include "comparison/samples.hpp"
#include "own_copy.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using comparison::Agreement;
using comparison::Comparison;
using comparison::Settings;
using comparison::TabulatedEvent;

bool mentions(const Comparison& comparison, const std::string& part) {
  return std::ranges::any_of(
      comparison.remarks, [&](const std::string& remark) { return remark.find(part) != std::string::npos; });
}

// --- words

STICKSLIP_VERIFIES(ComparedWords, "X20");
TEST(ComparedWords, ThatDifferAreCounted) {
  auto mine = published_copy("classification", {"frequency", "amplitude", "verdict"});
  EXPECT_EQ(mine.compared().agreement, Agreement::agrees);
  EXPECT_EQ(mine.compared("verdict").compared, 480u);
  const auto slips = std::ranges::count(mine.words("verdict"), "stick-slip");
  ASSERT_GT(slips, 100);
  std::ranges::fill(mine.words("verdict"), "stick");
  const auto verdict = mine.compared("verdict");
  EXPECT_EQ(verdict.agreement, Agreement::differs);
  EXPECT_EQ(verdict.error, static_cast<double>(slips));
  EXPECT_TRUE(verdict.where.ends_with("(stick-slip in the data set)")) << verdict.where;
  EXPECT_EQ(mine.compared("verdict", with_tolerance("verdict", static_cast<double>(slips))).agreement,
            Agreement::agrees);
  mine.words("verdict")[7] = "slip";
  EXPECT_EQ(mine.error_message(), "mine.csv:9: verdict is 'slip', but must be one of stick, stick-slip");
}

TEST(ComparedWords, DoNotCountWhereAMeshMayDecideOtherwise) {
  // A point of which the ratio is r counts if |r - 1| > tolerance r + radius; the radii are below 1e-20.
  const auto right = published_copy("classification");
  const auto& ratio = right.table.column("force_ratio")->values;
  const auto distance = [](double r) { return std::abs(r - 1.0) / r; };
  const auto nearest =
      static_cast<std::size_t>(std::ranges::min_element(ratio, {}, distance) - ratio.begin());
  auto mine = published_copy("classification", {"frequency", "amplitude", "verdict"});
  auto& word = mine.words("verdict")[nearest];
  word = word == "stick" ? "stick-slip" : "stick";
  const double limit = distance(ratio[nearest]);
  ASSERT_GT(limit, 1e-3);
  EXPECT_EQ(mine.compared("verdict").error, 1.0);
  EXPECT_EQ(mine.compared("verdict", with_tolerance("force_ratio", 0.99 * limit)).error, 1.0);
  const auto near = mine.compared("verdict", with_tolerance("force_ratio", 1.01 * limit));
  EXPECT_EQ(near.error, 0.0);
  EXPECT_EQ(near.compared, 479u);
  EXPECT_EQ(skipped_for(near, "too near to the threshold"), 1u);
}

TEST(ComparedWords, AreComparedInEveryTableThatHasThem) {
  auto package = published_package();
  auto& rule = *std::ranges::find(package.resources, "classification", &data::Resource::name)->comparison;
  std::erase_if(rule.values, [](const auto& value) { return value.field == "verdict"; });
  OwnCopy mine(package, "classification");
  EXPECT_EQ(mine.compared("verdict").compared, 480u);
  EXPECT_EQ(mine.compared().agreement, Agreement::agrees);
  mine.words("verdict")[0] = "stick-slip";
  EXPECT_EQ(mine.compared("verdict").error, 1.0);
  EXPECT_EQ(mine.compared().agreement, Agreement::differs);
  EXPECT_EQ(mine.compared("verdict", with_tolerance("", 1e3)).agreement, Agreement::differs);  // has its own
}

TEST(ComparedWords, OfAnEventDecideWithWhichItIsPaired) {
  for (const std::string set : {"published-problems", "single-mass-events"}) {
    auto mine = published_copy(set);
    EXPECT_EQ(mine.compared().agreement, Agreement::agrees);
    for (std::string& word : mine.words("change"))
      word = word == "capture" ? "reversal" : word == "reversal" ? "capture" : word;
    EXPECT_EQ(mine.compared("sequence").agreement, Agreement::differs);
    mine.words("change")[0] = "foo";
    EXPECT_TRUE(mine.error_message().starts_with(
        "mine.csv:2: change is 'foo', but must be one of onset, capture, reversal, graze"));
  }
  auto stick_slip = published_copy("stick-slip-events");
  stick_slip.words("change")[0] = "state";
  EXPECT_TRUE(stick_slip.error_message().ends_with("one of onset, capture, reversal, graze"));
}

STICKSLIP_VERIFIES(ComparedEvents, "X20");
TEST(ComparedEvents, OfSeveralProblemsHaveAVerdictEach) {
  auto mine = published_copy("published-problems");
  mine.erase(32);
  const Comparison comparison = mine.compared();
  EXPECT_EQ(comparison.agreement, Agreement::differs);
  EXPECT_TRUE(mentions(comparison,
                       "problem = hong-liu-2: event 2 (capture at 0.561845592 s) is missing in the file"));
  EXPECT_EQ(comparison::level_names.at(comparison.level), "none");  // although it is one event of 77
  ASSERT_EQ(comparison.parts.size(), 10u);
  for (const auto& part : comparison.parts) {
    const bool is_whole = part.name != "problem = hong-liu-2";
    EXPECT_EQ(part.agreement, is_whole ? Agreement::agrees : Agreement::differs) << part.name;
    EXPECT_EQ(part.rows, part.all_rows) << part.name;
    EXPECT_EQ(comparison::level_names.at(part.level), is_whole ? "strict" : "none") << part.name;
  }
}

TEST(ComparedEvents, CountAReversalAlsoWhereTheProblemHasNone) {
  auto mine = published_copy("published-problems");
  mine.repeat(31);
  mine.words("change")[32] = "reversal";
  EXPECT_EQ(mine.compared("sequence").error, 1.0);
}

STICKSLIP_VERIFIES(ComparedLevel, "X20");
TEST(ComparedLevel, IsTheLastThatTheErrorDoesNotExceed) {
  const auto level = [](const OwnCopy& mine, const Settings& settings = {}) {
    return comparison::level_names.at(mine.compared(settings).level);
  };
  for (const auto& [error, name] : std::vector<std::pair<double, std::string>>{{0.0, "strict"},
                                                                               {-0.99e-3, "1e-3"},
                                                                               {1.01e-3, "1e-2"},
                                                                               {0.00999, "1e-2"},
                                                                               {-0.0101, "1e-1"},
                                                                               {0.101, "none"}}) {
    auto mine = published_copy("friction-powers");
    mine["power"].front() += error * std::ranges::max(mine["power"]);
    EXPECT_EQ(level(mine, with_tolerance("", 1.0)), name);  // whatever tolerance is asked for
    auto history = published_copy("undamped-history-35");   // by the range, beyond the half-width
    const auto [least, greatest] = std::ranges::minmax(history["tip_displacement"]);
    const double width = history.reference().radius_of("tip_displacement").back();
    history["tip_displacement"].back() += error * (greatest - least) + std::copysign(width, error);
    EXPECT_EQ(level(history), std::abs(error) < 5e-3 ? "strict" : name);
    auto events = published_copy("published-problems");  // of which the first takes 100 s
    for (const std::size_t row : {1u, 2u}) events["time"][row] += 100.0 * error;
    EXPECT_EQ(level(events), name);
  }
  // Of words and events it is the share that is wrong.
  auto words = published_copy("classification"), events = published_copy("stick-slip-events");
  words.words("verdict")[0] = "stick-slip";
  EXPECT_EQ(level(words), "1e-2");
  EXPECT_EQ(level(events.erase(5).erase(5)), "1e-1");
  EXPECT_EQ(level(published_copy("friction-powers").keep_first(2)), "none");
}

STICKSLIP_VERIFIES(ComparedZero, "X20");
TEST(ComparedZero, IsMeasuredByTheLargestOfTheColumn) {
  auto mine = published_copy("friction-powers");
  const double largest = std::ranges::max(mine["power"]);
  for (const double power : {1e-9, 1e-4}) {
    mine["power"][0] = power;  // 0 in the data set
    const auto found = mine.compared("power");
    EXPECT_TRUE(within(*found.error, power / largest, round_off(1.0, 1.0, power / largest)));
    EXPECT_EQ(found.agreement, power / largest > 1e-6 ? Agreement::differs : Agreement::agrees);
  }
}

STICKSLIP_VERIFIES(ComparedTable, "X20");
TEST(ComparedTable, MeasuresARelativeErrorByTheMagnitudeOfTheValue) {
  auto mine = published_copy("participation");
  ASSERT_LT(mine["participation"][0], 0.0);
  mine["participation"][0] *= 1.01;
  const auto found = mine.compared("participation");
  EXPECT_TRUE(within(*found.error, 0.01, round_off(1.0, 1.0, 1.0)));
  EXPECT_EQ(found.agreement, Agreement::differs);
}

TEST(ComparedTable, RowNumberIsTheAbscissaWithoutANumericalKey) {
  EXPECT_EQ(published_copy("critical-loads").compared("flutter_load").series.at(1).abscissa,
            std::vector<double>{2.0});
}

TEST(ComparedAngle, IsTheSameAWholeTurnFurther) {
  auto mine = published_copy("damped-steady-state");
  constexpr double turn = 2.0 * std::numbers::pi;
  for (double& phase : mine["midspan_phase"])
    if (phase < 0.0) phase += turn;
  for (double& phase : mine["force_phase"]) phase -= 3.0 * turn;
  EXPECT_EQ(mine.compared().agreement, Agreement::agrees);
  mine["midspan_phase"][50] += 2e-3;
  const auto phase = mine.compared("midspan_phase");
  EXPECT_EQ(phase.agreement, Agreement::differs);
  EXPECT_TRUE(within(*phase.error, 2e-3, round_off(10.0, 1.0, turn)));
}
STICKSLIP_VERIFIES(ComparedAngle, "X20");

TEST(ComparedSamples, FarBeyondTheDataSetMayBeInAnotherUnit) {
  for (const double factor : {99.0, 1000.0}) {
    auto mine = published_copy("stick-history");
    for (double& time : mine["time"]) time *= factor;
    const auto comparison = mine.compared(with_tolerance("", 1e9));
    EXPECT_EQ(mentions(comparison, "has it another unit?"), factor > 100.0);
  }
  auto events = published_copy("stick-slip-events");
  for (double& time : events["time"]) time *= 1e3;
  EXPECT_TRUE(mentions(events.compared(), "has it another unit?"));
  auto late = published_copy("stick-history");
  late.erase(0);
  for (double& time : late["time"]) time *= 1e3;
  EXPECT_EQ(late.error_message(),
            "mine.csv: none of the 999 rows can be compared: 999 outside the range of the data set; time "
            "goes up to "
            "1000 s in the file and up to 1 s in the data set: has it another unit?");
}

// --- alignment of events

TabulatedEvent event(const std::string& change, double time) { return {change, time, 0.0, 0, 0}; }

STICKSLIP_VERIFIES(EventSequence, "X20");
TEST(EventSequence, IsAlignedWithEventsMissingAndEventsTooMany) {
  const std::vector<TabulatedEvent> reference{event("onset", 1.0),  event("capture", 2.0),
                                              event("onset", 2.01), event("capture", 3.0),
                                              event("onset", 4.0),  event("capture", 5.0)};
  // They miss the stick at 2 s and have one of their own at 4.5 s.
  const std::vector<TabulatedEvent> theirs{event("onset", 1.1),  event("capture", 2.9),
                                           event("onset", 4.1),  event("capture", 4.5),
                                           event("onset", 4.52), event("capture", 5.0)};
  const auto found = comparison::match(reference, theirs, {});
  ASSERT_EQ(found.pairs.size(), 4u);
  EXPECT_EQ(found.pairs[1], (std::pair<std::size_t, std::size_t>(3, 1)));
  EXPECT_EQ(found.missing, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(found.extra, (std::vector<std::size_t>{3, 4}));
  // Their run ends with the second event.
  const auto begin = comparison::match(reference, {theirs[0], theirs[1]}, {.end = 2.9});
  EXPECT_EQ(begin.missing.size(), 2u);
  EXPECT_EQ(begin.unreached, 2u);
}

TEST(EventSequence, TakesEventsAtItsLimitsAsWithinThem) {
  const std::vector<TabulatedEvent> reference{event("onset", 1.0), {"capture", 2.0, 0.02, 0, 0}};
  const auto pairs = [&](double time, const comparison::SequenceLimits& limits) {
    return comparison::match(reference, {event("onset", 1.0), event("capture", time)}, limits).pairs.size();
  };
  // Without partners two events cost 1 s within the limits, and one of them half of it.
  EXPECT_EQ(pairs(2.9, {.horizon = 2.9}), 2u);
  EXPECT_EQ(pairs(2.9, {.horizon = 2.8}), 1u);
  EXPECT_EQ(pairs(1.4, {.end = 1.4}), 1u);
  // An event nearer to the horizon than 0.1 s + 0.02 s costs as much.
  EXPECT_EQ(pairs(2.115, {.horizon = 2.11, .time_tolerance = 0.1}), 2u);
  EXPECT_EQ(pairs(2.125, {.horizon = 2.11, .time_tolerance = 0.1}), 1u);
  EXPECT_EQ(comparison::match({}, {event("onset", 2.0)}, {.horizon = 2.0}).extra.size(), 1u);
  const auto unreached = [&](const comparison::SequenceLimits& limits) {
    return comparison::match(reference, {event("onset", 1.0)}, limits).unreached;
  };
  EXPECT_EQ(unreached({.end = 2.0}), 0u);
  EXPECT_EQ(unreached({.horizon = 2.11, .end = 1.0, .time_tolerance = 0.1}), 0u);
  EXPECT_EQ(unreached({.horizon = 2.13, .end = 1.0, .time_tolerance = 0.1}), 1u);
}

TEST(EventSequence, HasNoPairFartherApartThanTheMeanDistance) {
  const std::vector<TabulatedEvent> reference{event("onset", 1.0), event("capture", 2.0)};  // 1 s
  for (const double shift : {0.99, 1.01}) {
    const auto found = comparison::match(reference, {event("onset", 1.0), event("capture", 2.0 + shift)}, {});
    EXPECT_EQ(found.pairs.size(), shift < 1.0 ? 2u : 1u) << shift;
    EXPECT_EQ(found.missing.size(), shift < 1.0 ? 0u : 1u) << shift;
    EXPECT_EQ(found.extra.size(), shift < 1.0 ? 0u : 1u) << shift;
  }
}

TEST(EventSequence, LeavesShortPhasesOutAndKeepsThoseOfTheLimit) {
  const double limit = 0.125;
  const auto kept = [&](const std::vector<TabulatedEvent>& events) {
    return comparison::without_short_phases(events, limit).size();
  };
  EXPECT_EQ(kept({event("onset", 1.0), event("capture", 2.0), event("onset", 2.1)}), 1u);  // a stick
  EXPECT_EQ(kept({event("onset", 1.0), event("capture", 1.1), event("onset", 2.0)}), 1u);  // a slip
  EXPECT_EQ(kept({event("onset", 1.0), event("reversal", 1.05), event("capture", 1.1)}), 0u);
  EXPECT_EQ(kept({event("onset", 1.0), event("capture", 1.125), event("onset", 2.0)}), 3u);
  EXPECT_EQ(kept({event("reversal", 1.0), event("reversal", 1.1)}), 2u);
  // Short phases in a row between slip and stick are one capture.
  const auto block =
      comparison::without_short_phases({event("onset", 1.0), event("capture", 2.0), event("onset", 2.1),
                                        event("reversal", 2.15), event("capture", 2.2), event("onset", 3.0)},
                                       limit);
  ASSERT_EQ(block.size(), 3u);
  EXPECT_EQ(block[1].change, "capture");
  EXPECT_TRUE(within(block[1].time, 2.1, round_off(2.0, 1.0, 2.1)));
  EXPECT_TRUE(within(block[1].time_radius, 0.1, round_off(2.0, 1.0, 2.1)));
}

TEST(EventSequence, SaysTheContactAtATime) {
  const std::vector<TabulatedEvent> events{event("onset", 1.0), event("reversal", 2.0),
                                           event("capture", 3.0)};
  for (const auto& [t, contact] : std::vector<std::pair<double, int>>{
           {0.5, 0}, {1.0, 1}, {1.5, 1}, {2.0, -1}, {2.5, -1}, {3.0, 0}, {9.0, 0}})
    EXPECT_EQ(comparison::contact_at(events, t), contact) << t;
  EXPECT_EQ(comparison::contact_at({event("capture", 1.0)}, 0.5), 1);
}

// The shortest stick of the data set lasts 0.33 ms.
std::size_t shortest_stick(const OwnCopy& events) {
  const auto& time = events.table.column("time")->values;
  std::size_t shortest = 0;
  for (std::size_t i = 0; i + 1 < time.size(); ++i)
    if (time[i + 1] - time[i] < time[shortest + 1] - time[shortest]) shortest = i;
  return shortest;
}

STICKSLIP_VERIFIES(ComparedEvents, "X20");
TEST(ComparedEvents, WithoutOneShortStickKeepAllOthers) {
  auto mine = published_copy("stick-slip-events");
  const std::size_t stick = shortest_stick(mine);
  ASSERT_EQ(mine.words("change")[stick], "capture");
  mine.keep([&](std::size_t row) { return row != stick && row != stick + 1; });
  const auto comparison = mine.compared();
  EXPECT_EQ(mine.compared("sequence").error, 2.0);
  EXPECT_EQ(mine.compared("time").error, 0.0);
  EXPECT_EQ(mine.compared("time").compared, 45u);
  EXPECT_EQ(comparison.agreement, Agreement::differs);
  ASSERT_EQ(comparison.remarks.size(), 2u);
  EXPECT_TRUE(comparison.remarks[0].ends_with("is missing in the file")) << comparison.remarks[0];
}

TEST(ComparedEvents, OfShortPhasesInARowAreOneEventAtAnUncertainTime) {
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

TEST(ComparedEvents, LeaveReversalsOutThatTheDataSetDoesNotHave) {
  auto mine = published_copy("stick-slip-events");
  mine.repeat(1);
  mine.words("change")[1] = "reversal";
  EXPECT_EQ(mine.compared().agreement, Agreement::agrees);
}

STICKSLIP_VERIFIES(ComparedHistory, "X20");
TEST(ComparedHistory, IsJudgedWithoutEventsWhereSamplesAreRare) {
  // Every 10 ms, with 94 events a second. Two samples are within the shortest phase of 0.33 ms of an event.
  auto mine = published_copy("stick-slip-energy");
  EXPECT_EQ(mine.compared().agreement, Agreement::agrees);
  EXPECT_EQ(mine.compared("friction_loss").compared, 48u);
  for (double& loss : mine["friction_loss"]) loss *= -1.0;
  EXPECT_EQ(mine.compared().agreement, Agreement::differs);
}

TEST(ComparedHistory, LeavesOutTheToleranceOfAnEventWithoutTheirs) {
  // Their onset at 0.0553 s is 50 us late, and they have samples every 10 us.
  auto mine = published_copy("stick-slip-history", {"time", "phase", "tip_displacement"});
  mine.keep([&](std::size_t row) { return row > 275 && row < 281; });
  auto& time = mine["time"];
  const double onset = 0.0553214408237;
  for (std::size_t i = 0; i < time.size(); ++i) time[i] = onset + 1e-5 * static_cast<double>(i + 1);
  std::ranges::fill(mine.words("phase"), "stick");
  EXPECT_TRUE(mine.error_message().find("5 between the two times of an event") != std::string::npos)
      << mine.error_message();
}

// --- coverage

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
    EXPECT_EQ(mentions(comparison, std::string("the file covers ") + (last > 0.1 ? "89" : "4") +
                                       " % of time from 0 to 0.5 s, but a verdict needs at least 90 %"),
              agreement == Agreement::undecided);
    EXPECT_EQ(mine.compared(until(last)).agreement, Agreement::agrees);
    mine["tip_displacement"][5] += 1.0;
    EXPECT_EQ(mine.compared().agreement, Agreement::differs);
  }
}

TEST(ComparedCoverage, OfThreeRowsIsThreeTwentieths) {
  auto mine = published_copy("undamped-history-25");
  mine.keep([](std::size_t row) { return row == 250 || row == 500 || row == 750; });
  EXPECT_EQ(mine.compared().agreement, Agreement::undecided);
  EXPECT_TRUE(within(mine.compared().coverage, 0.15, round_off(16.0, 1.0, 1.0)));
}

TEST(ComparedCoverage, OfAHistoryThatEndsEarlyIsTooSmall) {
  // The events end there as well, which is no doubt about their sequence.
  auto half = published_copy("stick-slip-history"), events = published_copy("stick-slip-events");
  half.keep_first(1250);
  EXPECT_EQ(half.compared().agreement, Agreement::undecided);
  EXPECT_EQ(half.compared(until(0.25)).agreement, Agreement::agrees);
  const auto time = events["time"];
  events.keep([&](std::size_t row) { return time[row] < 0.25; });
  const auto sequence = half.compared("sequence", with_events(events));
  EXPECT_EQ(sequence.agreement, Agreement::agrees);
  EXPECT_EQ(sequence.undecided, 0u);
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
  EXPECT_TRUE(mentions(comparison, "27 more events"));
  EXPECT_EQ(mine.compared(until(end + 2e-4)).agreement, Agreement::agrees);
  EXPECT_EQ(mine.compared("sequence", until(0.5)).error, 27.0);
  EXPECT_EQ(mine.compared(until(0.5)).agreement, Agreement::differs);
  // The first eight are named.
  EXPECT_EQ(mine.compared(until(0.5)).remarks.size(), 9u);
  EXPECT_EQ(mine.compared(until(0.5)).remarks.back(), "27 events are missing or not in the data set");
  const auto told = [](std::size_t rows, const Settings& settings) {
    return published_copy("stick-slip-events").keep_first(rows).compared(settings).remarks;
  };
  EXPECT_EQ(told(39, until(0.5)).size(), 8u);
  EXPECT_EQ(told(46, {}),
            std::vector<std::string>{"the file ends at 0.487100527 s, and the data set has 1 more event up "
                                     "to 0.490601495 s; --until says how far your run goes"});
}

TEST(ComparedCoverage, OfATableIsThatOfTheRowsThatTheFileMustHave) {
  using Ranges = std::vector<std::pair<std::size_t, std::size_t>>;
  auto mine = published_copy("classification"), problem = published_copy("published-problems");
  mine.keep([](std::size_t row) { return row < 48 || row == 50; });
  problem.keep([](std::size_t row) { return row >= 9 && row < 13; });
  const auto needing = [](const Ranges& rows) {
    return Settings{.tolerances = {}, .until = {}, .rows = rows};
  };
  const auto decides = [&](const OwnCopy& copy, const Ranges& rows) {
    return copy.compared(needing(rows)).agreement != Agreement::undecided;
  };
  for (const Ranges& rows : {Ranges{{1, 48}}, {{3, 4}, {51, 51}}}) EXPECT_TRUE(decides(mine, rows));
  for (const Ranges& rows : {Ranges{}, {{1, 49}}, {{1, 48}, {50, 50}}}) EXPECT_FALSE(decides(mine, rows));
  const Comparison part = mine.compared();
  EXPECT_TRUE(within(part.coverage, 49.0 / 480.0, round_off(1.0, 1.0, 1.0)));
  EXPECT_EQ(part.row_numbers, "1:48,51");
  mine["force_ratio"][48] *= 1.1;  // which is not asked for
  EXPECT_EQ(mine.compared(needing({{1, 48}})).agreement, Agreement::differs);
  for (const auto& [first, last] : Ranges{{0, 3}, {4, 3}, {1, 481}})
    EXPECT_EQ(mine.error_message(needing({{first, last}})),
              fmt::format("the range of rows is {}:{}, but must be within 1:480", first, last));
  EXPECT_EQ(published_copy("stick-history").error_message(needing({{1, 3}})),
            "row numbers are given, but the data set stick-history is one curve");
  EXPECT_TRUE(decides(problem, {{10, 13}}));
  for (const Ranges& rows : {Ranges{}, {{9, 13}}}) EXPECT_FALSE(decides(problem, rows));
}

// --- times between those of the data set

comparison::Samples sampled(std::size_t size, double step, const std::function<double(double)>& curve) {
  comparison::Samples samples;
  for (std::size_t i = 0; i < size; ++i) {
    samples.abscissa.push_back(step * static_cast<double>(i));
    samples.values.push_back(curve(samples.abscissa.back()));
    samples.half_width.push_back(0.0);
  }
  return samples;
}

STICKSLIP_VERIFIES(ComparedSamples, "X20");
TEST(ComparedSamples, AreInterpolatedWithinTheEstimatedError) {
  const double h = 0.1;
  const auto sine = sampled(21, h, [](double x) { return std::sin(x); });
  for (double x = h + 0.013; x < 19.0 * h; x += 0.017) {
    const auto found = comparison::interpolated(sine, x);
    // The largest of |(x - x0)(x - x1)(x - x2)(x - x3)|/24 between the two in the middle is 3/128 h^4.
    EXPECT_TRUE(within(found->value, std::sin(x),
                       discretisation(3.0 / 128.0 * std::pow(h, 4), 1.0, "3/128 h^4 max |f''''|")));
    EXPECT_GE(found->half_width, std::abs(found->value - std::sin(x)));
    EXPECT_LE(found->half_width, 2.0 * std::pow(h, 4) / 4.0);  // at the second sample 1 1 2 3 h^4/24
  }
  EXPECT_FALSE(comparison::interpolated({{0.0, 1.0}, {0.0, 1.0}, {0.0, 0.0}}, 0.5).has_value());
}

TEST(ComparedSamples, OfAQuarticHaveTheErrorOfTheCubic) {
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

TEST(ComparedSamples, MayHaveTimesOfSinglePrecision) {
  for (const std::string set : {"stick-history", "stick-slip-history", "undamped-history-25",
                                "undamped-history-steel-strip", "undamped-history-soft-short"}) {
    auto mine = published_copy(set);
    for (double& t : mine["time"]) t = static_cast<double>(static_cast<float>(t));
    const Comparison comparison = mine.compared();
    EXPECT_EQ(comparison.agreement, Agreement::agrees) << set;
    EXPECT_FALSE(comparison.quantities.empty()) << set;
    for (const auto& one : comparison.quantities)
      EXPECT_LE(*one.error, 1e-3 * one.tolerance) << set << " " << one.name;
    for (auto& column : mine.table.columns)
      if (column.field.name.ends_with("displacement")) column.values[mine.table.rows() / 2] += 1.0;
    EXPECT_EQ(mine.compared().agreement, Agreement::differs) << set;
  }
}

// The polynomials of the data set, of order 3 in each phase, at other times: in the middle between those of the
// data set, or at a third of them. Interpolation reproduces them but for some ten eps.
TEST(ComparedSamples, BetweenThoseOfTheDataSetAreComparedWithThem) {
  const auto package = with_rule("cubic-history", [](auto& rule) { rule.interpolation.reset(); });
  // At 0.01, ..., 0.29 s of the data set, or at their 15 or 10 samples up to 0.283 s or 0.273 s.
  for (const auto& [step, count] :
       std::vector<std::pair<std::size_t, std::size_t>>{{1, 29}, {2, 15}, {3, 10}})
    for (const double error : {0.0, 0.5}) {
      OwnCopy mine(package, "cubic-history");
      auto& t = mine["t"];
      mine.keep([&, every = step](std::size_t row) { return row < 31 && row % every == 0; });
      for (std::size_t i = 0; i < t.size(); ++i) {
        t[i] += 0.003;  // run a sticks up to 0.305 s, y = 1 + t - 2 t^2 + t^3
        mine["y"][i] = 1.0 + t[i] - 2.0 * t[i] * t[i] + t[i] * t[i] * t[i];
      }
      mine["y"][4] += error;
      const auto y = mine.compared("y", with_tolerance("y", 0.01, 0.31));
      EXPECT_EQ(y.agreement, error > 0.0 ? Agreement::differs : Agreement::agrees) << step;
      EXPECT_EQ(y.compared, count) << step;
      if (error == 0.0) {
        EXPECT_TRUE(within(*y.error, 0.0, round_off(10.0, 4.0, 2.0)));
      }
    }
}

TEST(ComparedSamples, MayStandTwiceAtATime) {
  auto curve = published_copy("undamped-history-25");
  curve.repeat(100);
  EXPECT_EQ(curve.compared().agreement, Agreement::agrees);
  EXPECT_EQ(curve.compared(with_tolerance("", 0.0)).agreement, Agreement::undecided);
  curve["tip_displacement"][101] += 0.5;
  EXPECT_TRUE(
      curve.error_message().starts_with("mine.csv:102: time is 0.05 as in the row before, but "
                                        "tip_displacement is "))
      << curve.error_message();
  auto history = published_copy("stick-slip-history");
  history.repeat(276);
  EXPECT_EQ(history.compared().agreement, Agreement::agrees);
}

}  // namespace
}  // namespace stickslip::testing
