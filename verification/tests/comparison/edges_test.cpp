// SPDX-License-Identifier: MIT
/// Histories with stick and slip at the times of their events, and keys, rows and times at the edges of what is
/// compared.

#include "comparison/groups.hpp"
#include "own_copy.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using comparison::Agreement;
using comparison::Comparison;
using comparison::Settings;

double below(double x) { return std::nextafter(x, 0.0); }
double above(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }

// --- what is not compared

STICKSLIP_VERIFIES(ComparedRows, "X20");
TEST(ComparedRows, WithoutAPublishedValueAreLeftOut) {
  auto mine = own_copy("stick-frequencies");
  mine.data_set().table.columns.at(2).values[1] = std::nan("");
  const auto frequency = mine.compared("frequency");
  EXPECT_EQ(frequency.compared, mine.reference().rows() - 1);
  EXPECT_EQ(skipped_for(frequency, "without a value in the data set"), 1u);
  EXPECT_EQ(frequency.agreement, Agreement::agrees);
}

TEST(ComparedRows, OfACurveMayStandInAnyOrder) {
  auto mine = own_copy("cubic-history");
  for (data::Column& column : mine.data_set().table.columns) {
    std::swap(column.text[0], column.text[1]);
    std::swap(column.values[0], column.values[1]);
  }
  ASSERT_EQ(mine.reference().column("t").values[0], 0.01);
  const auto y = mine.compared("y");
  EXPECT_EQ(y.compared, own_copy("cubic-history").compared("y").compared);
  EXPECT_EQ(y.error, 0.0);
}

TEST(ComparedRows, AreUndecidedIfNoneIsCompared) {
  // Up to 10 ms there is no event to compare, which is no agreement of the sequences.
  const auto mine = own_copy("damped-history");
  auto settings = with_events(own_copy("damped-events"));
  settings.until = 0.01;
  EXPECT_EQ(mine.compared("sequence", settings).agreement, Agreement::undecided);
  EXPECT_EQ(mine.compared("tip_displacement", settings).agreement, Agreement::agrees);
  EXPECT_EQ(mine.compared(settings).agreement, Agreement::undecided);
}

TEST(ComparedRows, EndWithTheHorizonAndTheRange) {
  auto mine = own_copy("cubic-history");
  const double horizon = mine["t"][40];
  mine["y"][40] += 1.0;
  EXPECT_EQ(mine.compared("y", until(horizon)).agreement, Agreement::differs);
  EXPECT_EQ(mine.compared("y", until(below(horizon))).agreement, Agreement::agrees);
  // No latest time goes beyond that of the data set, 0.11 s.
  auto events = own_copy("damped-events");
  const double sixth = events["time"][5];
  events["time"][6] += 1e-3;
  EXPECT_EQ(events.compared("time", until(0.5)).compared, 6u);
  EXPECT_EQ(events.compared("time", until(sixth)).compared, 6u);
  EXPECT_EQ(events.compared("time", until(below(sixth))).compared, 5u);
  // Places at the ends of the range but for rounding, or beyond them.
  auto shape = own_copy("quasi-static-shape");
  const double length = shape["x"].back();
  for (const auto& [beyond, compared] : {std::pair{0.9e-9, 21u}, {1.1e-9, 19u}}) {
    shape["x"].front() = -beyond * length;
    shape["x"].back() = (1.0 + beyond) * length;
    EXPECT_EQ(shape.compared("shape").compared, compared);
    EXPECT_EQ(skipped_for(shape.compared("shape"), "outside the range"), 21u - compared);
  }
}

// --- keys

STICKSLIP_VERIFIES(ComparedKeys, "X20");
TEST(ComparedKeys, MayHaveSinglePrecision) {
  auto mine = published_copy("length-force");
  for (double& length : mine["length"]) length = static_cast<double>(static_cast<float>(length));
  mine["force_ratio"][3] *= 1.1;
  const auto ratio = mine.compared("force_ratio");
  EXPECT_EQ(ratio.compared, mine.reference().rows());
  EXPECT_EQ(ratio.agreement, Agreement::differs);
  mine["length"][3] *= 1.0 + 2e-6;
  EXPECT_NE(mine.error_message(), "accepted");
}

TEST(ComparedKeys, NearTwoRowsAreThoseOfNeither) {
  data::ReferenceTable reference;
  reference.resource.primary_key = {"x"};
  data::Field x;
  x.name = "x", x.type = data::FieldType::number;
  reference.columns = {{.field = x, .text = {}, .values = {1.0, 1.0 + 0.9e-6, 2.0, -3.0}}};
  data::UserTable theirs;
  theirs.columns = {{.field = x,
                     .text = {},
                     .values = {1.0 + 0.4e-6, 2.0 - 0.9e-6, 2.0 + 2.1e-6, 1.0 - 0.5e-6, -3.0 + 2e-6}}};
  const std::vector<double> expected{1.0 + 0.4e-6, 2.0, 2.0 + 2.1e-6, 1.0, -3.0};
  EXPECT_EQ(comparison::with_keys_of(reference, theirs, "").columns[0].values, expected);
  EXPECT_EQ(comparison::with_keys_of(reference, theirs, "x").columns[0].values, theirs.columns[0].values);
}

// --- events and phases

// Samples between those of the reference, with the cubic polynomials of the data set, which a polynomial of
// order 3 reproduces; at 1 m its terms lose some ten eps.
OwnCopy between_samples() {
  auto mine = own_copy("cubic-history");
  mine.keep([&](std::size_t row) { return (row + 1) % 101 != 0; });
  auto events = own_copy("cubic-events");
  for (std::size_t row = 0; row < mine.table.rows(); ++row) {
    double& t = mine["t"][row];
    t += 0.0042;
    std::size_t phase = 0;
    for (std::size_t event = 0; event < events.table.rows(); ++event)
      if (events.words("run")[event] == mine.words("run")[row] && events["time"][event] <= t) ++phase;
    const double factor =
        std::array{1.0, -2.0, 3.0, -4.0}.at(phase) * (mine.words("run")[row] == "a" ? 1.0 : 2.0);
    mine["y"][row] = factor * (1.0 + t - 2.0 * t * t + t * t * t) + static_cast<double>(phase);
    mine.words("phase")[row] = phase == 0 || phase == 3 ? "stick" : "slip";
  }
  return mine;
}

STICKSLIP_VERIFIES(ComparedHistory, "X20");
TEST(ComparedHistory, IsInterpolatedInItsPhaseOnly) {
  for (const bool events : {false, true}) {
    const Comparison comparison =
        between_samples().compared(events ? with_events(own_copy("cubic-events")) : Settings());
    EXPECT_EQ(comparison.agreement, Agreement::agrees);
    const auto y = quantity_of(comparison, "y");
    // One step over a jump would be an error of 1 m or more.
    EXPECT_TRUE(within(*y.error, 0.0, round_off(4.0, 2.0, 6.0)));
    // Run a has samples at 0.0042, 0.0142, ..., 0.9942 s, run b as well; 0.9442 is the last before 0.95 s.
    EXPECT_EQ(skipped_for(y, "beyond the horizon"), 10u);
    // Events at 0.305, 0.515, 0.805 and 0.455 s: the sample at 0.3042 has none of its phase behind it, and so on.
    EXPECT_EQ(skipped_for(y, "between an event and the samples"), events ? 4u : 0u);
    EXPECT_EQ(skipped_for(y, "between the two times of an event"), events ? 0u : 8u);
    EXPECT_EQ(y.compared, events ? 186u : 182u);
    EXPECT_EQ(quantity_of(comparison, "phase").error, 0.0);
  }
}

TEST(ComparedHistory, CountsSamplesInAnotherPhase) {
  // They stick up to 0.342 s, 37 ms longer; one of the four samples is within the guard of 10 ms.
  auto mine = own_copy("cubic-history");
  for (std::size_t row = 31; row < 35; ++row) {
    mine["y"][row] = 1e3;
    mine.words("phase")[row] = "stick";
  }
  EXPECT_EQ(mine.compared().agreement, Agreement::differs);
  EXPECT_EQ(mine.compared("phase").error, 3.0);
  EXPECT_EQ(mine.compared("phase").where, "t = 0.32 s, run = a (slip in the data set)");
  EXPECT_EQ(mine.compared("y").agreement, Agreement::agrees);
}

// The rows that nobody compares because of an event, and one beside them. Run a has its onset at 0.305 s, its reversal at
// 0.515 s and its capture at 0.805 s, and samples every 10 ms.
TEST(ComparedHistory, LeavesOutWhatIsNearAnEvent) {
  struct Uncertain {
    std::function<void(OwnCopy& history, OwnCopy& events)> spoil;
    std::size_t first, last, beside;
    std::string reason;
    std::size_t skipped;
    bool has_events{true};
  };
  const auto sample_at = [](std::size_t row, double time) {
    return [=](OwnCopy& history, OwnCopy&) { history["t"][row] = time; };
  };
  const auto onset_at_sample = [](std::size_t row) {
    return [=](OwnCopy& history, OwnCopy& events) { events["time"][0] = history["t"][row]; };
  };
  // Without their events two samples at each of the four are left out, and the farther neighbour of a sample is as far as
  // an event may be: more or less than 10 ms.
  const auto before = [](double distance) {
    return [=](OwnCopy& history, OwnCopy&) {
      auto& t = history["t"];
      t[30] = 0.3, t[29] = 0.295, t[28] = t[29] - distance;
    };
  };
  const auto behind = [](double distance) {
    return [=](OwnCopy& history, OwnCopy&) {
      auto& t = history["t"];
      t[30] = 0.31, t[31] = 0.315, t[32] = t[31] + distance;
    };
  };
  const std::string between = "between the two times", past = "between an event and the samples",
                    other = "in another phase";
  for (const auto& [spoil, first, last, beside, reason, skipped, has_events] :
       std::vector<Uncertain>{{sample_at(30, 0.305), 30, 30, 31, between, 1},
                              {sample_at(30, below(0.305)), 30, 30, 29, past, 1},
                              {sample_at(30, above(0.305)), 30, 30, 31, past, 1},
                              {onset_at_sample(34), 31, 34, 35, between, 4},
                              {onset_at_sample(27), 27, 30, 26, between, 4},
                              {[](OwnCopy&history, OwnCopy&events) {
                                 history["t"][51] = 0.515;
                                 events.erase(1);
                               },
                               51, 80, 50, other, 29},
                              {[](OwnCopy&, OwnCopy&events) { events.erase(2); }, 81, 95, 80, other, 15},
                              {before(0.0101), 29, 30, 28, between, 9, false},
                              {before(0.0099), 30, 30, 29, between, 8, false},
                              {behind(0.0101), 30, 31, 32, between, 9, false},
                              {behind(0.0099), 30, 30, 31, between, 8, false}}) {
    auto history = own_copy("cubic-history"), events = own_copy("cubic-events");
    spoil(history, events);
    // The tolerance of the values is not that of the events.
    const Settings settings = has_events ? with_events(events) : with_tolerance("", 1.0);
    SCOPED_TRACE(fmt::format("rows {} to {}", first, last));
    for (std::size_t row = first; row <= last; ++row) history["y"][row] = 1e3;
    const auto y = history.compared("y", settings);
    EXPECT_EQ(y.agreement, Agreement::agrees);
    EXPECT_EQ(skipped_for(y, reason), skipped);
    history["y"][beside] = 1e3;
    EXPECT_EQ(history.compared("y", settings).agreement, Agreement::differs);
  }
}

TEST(ComparedHistory, LeavesOutTheRadiusOfAnEvent) {
  const auto events = own_copy("damped-events");
  const double time = events.table.column("time")->values[1],
               radius = events.reference().radius_of("time")[1];
  for (const double distance : {-1.1, -0.9, 0.9, 1.1}) {
    auto mine = own_copy("damped-history");
    mine["t"][170] = time + distance * radius;
    const auto tip = mine.compared("tip_displacement", with_events(events));
    EXPECT_EQ(skipped_for(tip, "between the two times"), std::abs(distance) < 1.0 ? 1u : 0u) << distance;
  }
  // No sample of the data set in it stands for the phase behind it.
  auto mine = own_copy("damped-history");
  auto& columns = mine.data_set().events->columns;
  std::ranges::find(columns, "time_radius", [](const auto& column) { return column.field.name; })->values[1] =
      5e-4;
  const auto past_last = [&] {
    return skipped_for(mine.compared("tip_displacement", with_events(events)),
                       "between an event and the samples");
  };
  const std::size_t before = past_last();
  *std::ranges::upper_bound(mine["t"], time + 5e-4) = time + 5.001e-4;
  EXPECT_EQ(past_last(), before + 1);
}

TEST(ComparedHistory, IsAsUncertainAsItsWeights) {
  // The cubic through four samples has the weights -1/16, 9/16, 9/16, -1/16 half-way, 5/4 in all; a quarter of the way
  // 7/128, 105/128, 35/128, 5/128 with signs.
  auto mine = own_copy("damped-history");
  const auto t = mine["t"];
  mine["t"][20] = 0.5 * (t[20] + t[21]);
  mine["t"][21] = 0.75 * t[21] + 0.25 * t[22];
  const auto half_width = mine.compared("tip_displacement").series[0].half_width;
  const double sample = mine.reference().radius_of("tip_displacement")[20],
               error = mine.reference().resource.comparison->interpolation->error.at("tip_displacement");
  EXPECT_EQ(half_width[19], sample);
  // Times of 8 ms are rounded beside steps of 0.4 ms.
  EXPECT_TRUE(within(half_width[20], error + 1.25 * sample, round_off(10.0, 20.0, sample)));
  EXPECT_TRUE(within(half_width[21], error + 152.0 / 128.0 * sample, round_off(10.0, 20.0, sample)));
}

}  // namespace
}  // namespace stickslip::testing
