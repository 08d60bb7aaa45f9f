// SPDX-License-Identifier: MIT
/// Verdicts of a comparison at the edges: an error equal to what is allowed, an uncertainty equal to the
/// tolerance, a time equal to the horizon or to that of an event.

#include "comparison/groups.hpp"
#include "own_copy.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/input_text.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using comparison::Agreement;
using comparison::Settings;

namespace fs = std::filesystem;

double below(double x) { return std::nextafter(x, 0.0); }
double above(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }

// --- error and tolerance

STICKSLIP_VERIFIES(ComparedVerdict, "X20");
TEST(ComparedVerdict, AnErrorEqualToTheToleranceAgrees) {
  auto mine = own_copy("cubic-history");  // its values are exact
  const double reference = mine["y"][10];
  mine["y"][10] += 0.25;
  const double error = mine["y"][10] - reference;
  EXPECT_EQ(mine.compared("y", with_tolerance("y", error)).agreement, Agreement::agrees);
  const auto found = mine.compared("y", with_tolerance("y", below(error)));
  EXPECT_EQ(found.agreement, Agreement::differs);
  EXPECT_EQ(found.error, error);
  EXPECT_EQ(found.undecided, 0u);
}

TEST(ComparedVerdict, ErrorAtTheSumOfBoundsDoesNotDiffer) {
  auto mine = own_copy("damped-events");
  const double radius = mine.reference().radius_of("time")[2], reference = mine["time"][2];
  // An error that is the sum of the radius and a tolerance without rounding.
  double error = 0.0, tolerance = 0.0;
  for (double shift = 2e-7; tolerance == 0.0; shift += 1e-10) {
    error = std::abs(reference + shift - reference);
    if (error - radius + radius == error) {
      tolerance = error - radius;
      mine["time"][2] = reference + shift;
    }
  }
  ASSERT_GT(tolerance, radius);
  double smaller = below(tolerance);
  while (smaller + radius == error) smaller = below(smaller);
  EXPECT_EQ(mine.compared("time", with_tolerance("time", tolerance)).agreement, Agreement::agrees);
  EXPECT_EQ(mine.compared("time", with_tolerance("time", smaller)).agreement, Agreement::differs);
}

TEST(ComparedVerdict, AnUncertaintyEqualToTheToleranceDecides) {
  const auto mine = own_copy("damped-events");
  const auto radii = mine.reference().radius_of("time");
  const double largest = *std::max_element(radii.begin(), radii.begin() + 6);  // within the horizon
  const auto decided = mine.compared("time", with_tolerance("time", largest));
  EXPECT_EQ(decided.agreement, Agreement::agrees);
  EXPECT_EQ(decided.undecided, 0u);
  const auto undecided = mine.compared("time", with_tolerance("time", below(largest)));
  EXPECT_EQ(undecided.agreement, Agreement::undecided);
  EXPECT_EQ(undecided.undecided, 1u);
  EXPECT_EQ(undecided.compared, 6u);
}

TEST(ComparedVerdict, DiffersWinsOverUndecidedInAnyOrder) {
  for (const std::size_t row : {0u, 4u}) {  // before and behind the events that are undecided
    auto mine = own_copy("damped-events");
    mine["time"][row] += 1e-3;
    const auto time = mine.compared("time", with_tolerance("time", 1e-9));
    EXPECT_EQ(time.agreement, Agreement::differs) << row;
    EXPECT_EQ(time.undecided, row == 0 ? 5u : 4u);
    EXPECT_EQ(mine.compared(with_tolerance("time", 1e-9)).agreement, Agreement::differs);
  }
}

TEST(ComparedVerdict, TheErrorThatIsToldExceedsItsUncertaintyMost) {
  // Event 5 is known to 1.7e-8 s, event 1 to 3.4e-10 s: the smaller error of event 1 says more.
  auto mine = own_copy("damped-events");
  mine["time"][0] += 1e-8;
  mine["time"][4] += 2e-8;
  const auto time = mine.compared("time");
  EXPECT_EQ(time.where, "event 1 (onset at 0.0553214408 s)");
  EXPECT_NEAR(*time.error, 1e-8, 1e-16);
  EXPECT_EQ(time.uncertainty, mine.reference().radius_of("time")[0]);
}

TEST(ComparedVerdict, AQuantityOfWhichNothingIsComparedIsUndecided) {
  // Up to 10 ms there is no event to compare, which is no agreement of the sequences.
  const auto mine = own_copy("damped-history");
  auto settings = with_events(own_copy("damped-events"));
  settings.until = 0.01;
  EXPECT_EQ(mine.compared("sequence", settings).agreement, Agreement::undecided);
  EXPECT_EQ(mine.compared("tip_displacement", settings).agreement, Agreement::agrees);
  EXPECT_EQ(mine.compared(settings).agreement, Agreement::undecided);
}

// A package in which a table has another text at one place.
class ComparedPackage : public ::testing::Test {
 protected:
  void SetUp() override { fs::copy(small_package().folder, folder_.path(), fs::copy_options::recursive); }

  [[nodiscard]] data::ReferencePackage with(const std::string& file, const std::string& was,
                                            const std::string& is) const {
    const auto replace = [](std::string& text, const std::string& from, const std::string& to) {
      text.replace(text.find(from), from.size(), to);
    };
    const fs::path table = folder_.path() / file, description = folder_.path() / "datapackage.json";
    constexpr std::size_t most = 1 << 20;
    std::string rows = data::read_bounded(table, most), package = data::read_bounded(description, most);
    const std::string size = std::to_string(rows.size()), digest = data::sha256(rows);
    replace(rows, was, is);
    replace(package, size, std::to_string(rows.size()));
    replace(package, digest, data::sha256(rows));
    std::ofstream(table) << rows;
    std::ofstream(description) << package;
    return data::load_reference(folder_.path());
  }

 private:
  data::TemporaryFolder folder_;
};

STICKSLIP_VERIFIES(ComparedPackage, "X20");
TEST_F(ComparedPackage, WithoutAValueLeavesThatRowOutAndSaysSo) {
  const auto package = with("frequencies/stick.csv", "81.0776217337938678485966312174,1e-27", ",");
  OwnCopy mine(package, "stick-frequencies");
  mine.table = own_copy("stick-frequencies").table;
  const auto frequency = mine.compared("frequency");
  EXPECT_EQ(frequency.compared, mine.reference().rows() - 1);
  EXPECT_EQ(skipped_for(frequency, "without a value in the data set"), 1u);
  EXPECT_EQ(frequency.agreement, Agreement::agrees);
}

TEST_F(ComparedPackage, MayHaveTheRowsOfACurveInAnyOrder) {
  const std::string first = "a,0,stick,1,0.305\n", second = "a,0.01,stick,1.009801,0.295\n";
  const auto package = with("cubic/history.csv", first + second, second + first);
  OwnCopy mine(package, "cubic-history");
  EXPECT_EQ(mine["t"][0], 0.01);
  mine.table = own_copy("cubic-history").table;
  const auto y = mine.compared("y");
  EXPECT_EQ(y.compared, own_copy("cubic-history").compared("y").compared);
  EXPECT_EQ(y.error, 0.0);
}

// --- keys

TEST(ComparedVerdict, AKeyInSinglePrecisionIsThatOfItsRow) {
  auto mine = published_copy("length-force");
  const auto single = [](double x) { return static_cast<double>(static_cast<float>(x)); };
  for (double& length : mine["length"]) length = single(length);
  mine["force_ratio"][3] *= 1.1;
  const auto ratio = mine.compared("force_ratio");
  EXPECT_EQ(ratio.compared, mine.reference().rows());
  EXPECT_EQ(ratio.agreement, Agreement::differs);
  mine["length"][3] *= 1.0 + 2e-6;
  EXPECT_THROW((void)mine.compared(), data::InputError);
}

TEST(ComparedVerdict, AKeyNearTwoRowsIsNeither) {
  data::ReferenceTable reference;
  reference.resource.primary_key = {"x"};
  const data::Field x{.name = "x",
                      .type = data::FieldType::number,
                      .unit = {},
                      .description = {},
                      .value_class = {},
                      .required = true,
                      .allowed = {}};
  reference.columns = {{.field = x, .text = {}, .values = {1.0, 1.0 + 0.9e-6, 2.0, -3.0}}};
  data::UserTable theirs;
  theirs.columns = {{.field = x,
                     .text = {},
                     .values = {1.0 + 0.4e-6, 2.0 - 0.9e-6, 2.0 + 2.1e-6, 1.0 - 0.5e-6, -3.0 + 2e-6}}};
  const std::vector<double> expected{1.0 + 0.4e-6, 2.0, 2.0 + 2.1e-6, 1.0, -3.0};
  EXPECT_EQ(comparison::with_keys_of(reference, theirs, "").columns[0].values, expected);
  EXPECT_EQ(comparison::with_keys_of(reference, theirs, "x").columns[0].values, theirs.columns[0].values);
}

// --- horizons

TEST(ComparedVerdict, ATimeEqualToTheHorizonIsCompared) {
  auto mine = own_copy("cubic-history");
  const double horizon = mine["t"][40];
  mine["y"][40] += 1.0;
  EXPECT_EQ(mine.compared("y", until(horizon)).agreement, Agreement::differs);
  EXPECT_EQ(mine.compared("y", until(below(horizon))).agreement, Agreement::agrees);
}

TEST(ComparedVerdict, ALatestTimeBeyondThatOfTheDataSetChangesNothing) {
  auto mine = own_copy("cubic-history");
  mine["y"][97] += 1.0;  // at 0.97 s; the data set is known up to 0.95 s
  for (const double latest : {0.95, 0.98, 2.0}) {
    const auto y = mine.compared("y", until(latest));
    EXPECT_EQ(y.agreement, Agreement::agrees) << latest;
    EXPECT_EQ(skipped_for(y, "beyond the horizon"), 10u) << latest;
  }
  auto events = own_copy("damped-events");
  events["time"][6] += 1e-3;  // at 0.111 s; the data set is known up to 0.11 s
  for (const double latest : {0.11, 0.5}) {
    const auto time = events.compared("time", until(latest));
    EXPECT_EQ(time.compared, 6u) << latest;
    EXPECT_EQ(time.agreement, Agreement::agrees) << latest;
  }
}

TEST(ComparedVerdict, AnEventAtTheLatestTimeIsWithinIt) {
  auto mine = own_copy("damped-events");
  const double sixth = mine["time"][5];
  EXPECT_EQ(mine.compared("time", until(sixth)).compared, 6u);
  EXPECT_EQ(mine.compared("time", until(below(sixth))).compared, 5u);
}

TEST(ComparedVerdict, LatestTimeIsMissedByItsUncertaintyAtMost) {
  // They have five events; the sixth lies before the latest time, by what it may be late or by a little more.
  auto five = own_copy("damped-events");
  const double sixth = five["time"][5], radius = five.reference().radius_of("time")[5];
  five.keep_first(5);
  const auto missing = [&](double margin) {
    return *five.compared("sequence", with_tolerance("time", 2e-5, sixth + margin)).error;
  };
  EXPECT_EQ(missing(2e-5), 0.0);
  EXPECT_EQ(missing(2e-5 + 0.9 * radius), 0.0);
  EXPECT_EQ(missing(2e-5 + 1.1 * radius), 1.0);
}

// --- events and phases

// The samples nearest to the onset at 0.305 s moved to that very time, or next to it.
TEST(ComparedVerdict, ASampleAtTheTimeOfAnEventIsLeftOut) {
  for (const double time : {below(0.305), 0.305, above(0.305)}) {
    auto mine = own_copy("cubic-history");
    mine["t"][30] = time;
    mine["y"][30] = 1e3;  // far from both phases
    const auto y = mine.compared("y", with_events(own_copy("cubic-events")));
    EXPECT_EQ(skipped_for(y, "between the two times"), time == 0.305 ? 1u : 0u) << time;
    // The two others lie in a phase, but next to no sample of it.
    EXPECT_EQ(skipped_for(y, "between an event and the samples"), time == 0.305 ? 0u : 1u) << time;
    EXPECT_EQ(y.agreement, Agreement::agrees);
  }
}

TEST(ComparedVerdict, ASampleWithinTheUncertaintyOfAnEventIsLeftOut) {
  const auto events = own_copy("damped-events");
  const double time = events.table.column("time")->values[1],
               radius = events.reference().radius_of("time")[1];
  for (const double distance : {-1.1, -0.9, 0.9, 1.1}) {
    auto mine = own_copy("damped-history");
    mine["t"][170] = time + distance * radius;
    const auto tip = mine.compared("tip_displacement", with_events(events));
    EXPECT_EQ(skipped_for(tip, "between the two times"), std::abs(distance) < 1.0 ? 1u : 0u) << distance;
  }
}

TEST(ComparedVerdict, TheTimesOfBothEventsBelongToTheWindow) {
  // Their onset is at a sample, 35 ms late or early; that of the data set is between the rows 30 and 31.
  struct Window {
    std::size_t onset, first, last, beside;
  };
  for (const auto& [onset, first, last, beside] : {Window{34, 31, 34, 35}, Window{27, 27, 30, 26}}) {
    auto mine = own_copy("cubic-history"), events = own_copy("cubic-events");
    events["time"][0] = mine["t"][onset];
    for (std::size_t row = first; row <= last; ++row) mine["y"][row] = 1e3;
    const auto y = mine.compared("y", with_events(events));
    EXPECT_EQ(y.agreement, Agreement::agrees) << onset;
    EXPECT_EQ(skipped_for(y, "between the two times"), 4u) << onset;
    mine["y"][beside] = 1e3;
    EXPECT_EQ(mine.compared("y", with_events(events)).agreement, Agreement::differs) << onset;
  }
}

TEST(ComparedVerdict, ASampleAtAnEventThatTheyDoNotHaveIsLeftOut) {
  auto mine = own_copy("cubic-history"), events = own_copy("cubic-events");
  mine["t"][51] = 0.515;  // the time of the reversal, which they do not have
  for (std::size_t row = 51; row <= 80; ++row) mine["y"][row] = 1e3;
  events.erase(1);
  const auto y = mine.compared("y", with_events(events));
  EXPECT_EQ(y.agreement, Agreement::agrees);
  EXPECT_EQ(mine.compared("sequence", with_events(events)).agreement, Agreement::differs);
  EXPECT_EQ(mine.compared(with_events(events)).remarks.at(0),
            "run = a: event 2 (reversal at 0.515 s) is missing in the file");
  EXPECT_EQ(skipped_for(y, "between the two times"), 1u);
  EXPECT_EQ(skipped_for(y, "in another phase"), 29u);  // 0.52, ..., 0.80 s
}

TEST(ComparedVerdict, LargerDistanceToANeighbourGuardsAnEvent) {
  // Without events of theirs, samples 10 ms before and behind the onset at 0.305 s, whose farther neighbour
  // is a little more or less than 10 ms away.
  for (const bool before : {true, false})
    for (const double distance : {0.0101, 0.0099}) {
      auto mine = own_copy("cubic-history");
      auto& t = mine["t"];
      const std::size_t row = before ? 29 : 31;
      t[30] = before ? 0.3 : 0.31;
      t[row] = before ? 0.295 : 0.315;
      t[before ? 28 : 32] = t[row] + (before ? -distance : distance);
      mine["y"][row] = 1e3;
      const auto y = mine.compared("y", with_tolerance("", 1.0));  // not that of the events
      EXPECT_EQ(y.agreement, distance > 0.01 ? Agreement::agrees : Agreement::differs) << before << distance;
    }
}

TEST(ComparedVerdict, AreInAnotherPhaseAfterAMissingEvent) {
  auto mine = own_copy("cubic-history"), events = own_copy("cubic-events");
  events.erase(2);  // they have no capture at 0.805 s
  const Settings settings = with_events(events);
  EXPECT_EQ(mine.compared("sequence", settings).error, 1.0);
  EXPECT_EQ(mine.compared("sequence", settings).compared, 4u);
  for (std::size_t row = 81; row <= 95; ++row) mine["y"][row] = 1e3;
  EXPECT_EQ(mine.compared("y", settings).agreement, Agreement::agrees);
  EXPECT_EQ(skipped_for(mine.compared("y", settings), "in another phase"), 15u);
  mine["y"][80] = 1e3;
  EXPECT_EQ(mine.compared("y", settings).agreement, Agreement::differs);
}

TEST(ComparedVerdict, BetweenSamplesTheHalfWidthsAreThoseOfTheWeights) {
  // The cubic through four samples has the weights -1/16, 9/16, 9/16, -1/16 half-way: 5/4 in all.
  auto mine = own_copy("damped-history");
  const auto t = mine["t"];
  mine["t"][20] = 0.5 * (t[20] + t[21]);
  mine["t"].back() = t.back();
  mine["tip_displacement"][20] = 0.5 * (mine["tip_displacement"][20] + mine["tip_displacement"][21]);
  mine["t"][21] = 0.75 * t[21] + 0.25 * t[22];
  const auto tip = mine.compared("tip_displacement");
  const auto half_width = mine.reference().radius_of("tip_displacement")[20];
  const double error = mine.reference().resource.comparison->interpolation->error.at("tip_displacement");
  EXPECT_EQ(tip.series[0].half_width[19], half_width);
  EXPECT_NEAR(tip.series[0].half_width[20], error + 1.25 * half_width, 1e-6 * half_width);
  // A quarter of the way: 7/128, 105/128, 35/128, 5/128 with signs.
  EXPECT_NEAR(tip.series[0].half_width[21], error + 152.0 / 128.0 * half_width, 1e-6 * half_width);
}

TEST(ComparedVerdict, PhasesAreCountedOnceForAllQuantities) {
  auto mine = own_copy("damped-history");
  ASSERT_EQ(mine.compared().quantities.size(), 3u);
  EXPECT_EQ(mine.compared("phase").compared, mine.compared("tip_displacement").compared);
  EXPECT_EQ(mine.compared("friction_force").compared, mine.compared("tip_displacement").compared);
  mine.table.columns.erase(
      std::ranges::find(mine.table.columns, "phase", [](const auto& column) { return column.field.name; }));
  EXPECT_EQ(mine.compared().quantities.size(), 2u);
}

TEST(ComparedVerdict, TheRangeOfACurveIncludesItsEnds) {
  auto mine = own_copy("quasi-static-shape");
  const double length = mine["x"].back();
  mine["x"].front() = -0.9e-9 * length;
  mine["x"].back() = (1.0 + 0.9e-9) * length;
  EXPECT_EQ(mine.compared("shape").compared, 21u);  // the same places, but for rounding
  mine["x"].front() = -1.1e-9 * length;
  mine["x"].back() = (1.0 + 1.1e-9) * length;
  EXPECT_EQ(mine.compared("shape").compared, 19u);
  EXPECT_EQ(skipped_for(mine.compared("shape"), "outside the range"), 2u);
  EXPECT_EQ(mine.compared("shape").agreement, Agreement::agrees);
}

TEST(ComparedVerdict, ARangeThatIsNotCoveredIsTold) {
  // A sample covers a fortieth on either side: 1.05 m of 2 m, and 0.29 s + 0.02375 s of 0.95 s.
  const auto told = [](const std::string& set, std::size_t rows) {
    return own_copy(set).keep_first(rows).compared().remarks;
  };
  EXPECT_EQ(
      told("quasi-static-shape", 11),
      std::vector<std::string>{"the file covers 52 % of x from 0 to 2 m, but a verdict needs at least 90 %"});
  EXPECT_EQ(told("cubic-history", 31),
            (std::vector<std::string>{"run = b is not in the file and was not compared",
                                      "the file covers 33 % of t from 0 to 0.95 s of run = a, but a verdict "
                                      "needs at least 90 %; --until ends the comparison earlier"}));
}

}  // namespace
}  // namespace stickslip::testing
