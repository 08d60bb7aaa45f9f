// SPDX-License-Identifier: MIT
/// Somebody's results against reference data: a copy agrees, an error of known size is found where it is,
/// events and phases are kept apart, and known mistakes are named.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "comparison/comparison.hpp"
#include "comparison/wrong_models.hpp"
#include "own_copy.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/data/case_file.hpp"
#include "support/paper_settings.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using data::InputError;
using studies::Agreement;
using studies::Comparison;
using studies::ComparisonSettings;
using studies::Finding;
using Values = std::vector<double>;

const data::ReferencePackage& package() {
  static const auto fixture = data::load_reference(std::filesystem::path(STICKSLIP_SOURCE_DIRECTORY) /
                                                   "verification/tests/golden/reference");
  return fixture;
}

data::ReferenceTable published_table(const std::string& set) { return data::read_table(package(), set); }

// Somebody who has copied these columns of a data set, or all of them.
data::UserTable copy_of(const std::string& set, const std::vector<std::string>& columns = {},
                        const data::ReferencePackage& from = package()) {
  const auto table = data::read_table(from, set);
  data::UserTable copy{.file = "mine.csv", .columns = {}, .lines = std::vector<std::size_t>(table.rows())};
  std::iota(copy.lines.begin(), copy.lines.end(), 2);
  for (const data::Column& column : table.columns)
    if (columns.empty() || std::ranges::count(columns, column.field.name) > 0) copy.columns.push_back(column);
  return copy;
}

Values& values_of(data::UserTable& table, const std::string& name) {
  return std::ranges::find(table.columns, name, [](const data::Column& c) { return c.field.name; })->values;
}
std::vector<std::string>& words_of(data::UserTable& table, const std::string& name) {
  return std::ranges::find(table.columns, name, [](const data::Column& c) { return c.field.name; })->text;
}

// The table without this row, or with this row twice.
void erase_row(data::UserTable& table, std::size_t row) {
  const auto at = static_cast<std::ptrdiff_t>(row);
  for (data::Column& column : table.columns) {
    column.text.erase(column.text.begin() + at);
    column.values.erase(column.values.begin() + at);
  }
  table.lines.erase(table.lines.begin() + at);
}
void repeat_row(data::UserTable& table, std::size_t row) {
  const auto at = static_cast<std::ptrdiff_t>(row);
  for (data::Column& column : table.columns) {
    column.text.insert(column.text.begin() + at, column.text[row]);
    column.values.insert(column.values.begin() + at, column.values[row]);
  }
  table.lines.insert(table.lines.begin() + at, table.lines[row]);
}
void keep_rows(data::UserTable& table, const std::function<bool(std::size_t)>& keep) {
  for (std::size_t row = table.rows(); row-- > 0;)
    if (!keep(row)) erase_row(table, row);
}

Comparison compare(const std::string& set, const data::UserTable& theirs, ComparisonSettings settings = {}) {
  return studies::compare(package(), set, theirs, settings);
}
Comparison compare_quietly(const std::string& set, const data::UserTable& theirs,
                           ComparisonSettings settings = {}) {
  settings.diagnose = false;
  return studies::compare(package(), set, theirs, settings);
}

Comparison::Quantity quantity(const Comparison& comparison, const std::string& name) {
  return *std::ranges::find(comparison.quantities, name, &Comparison::Quantity::name);
}

std::string error_message(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

// --- copies

STICKSLIP_VERIFIES(ComparedCopy, "X20");
TEST(ComparedCopy, OfEveryDataSetAgreesWithoutError) {
  for (const std::string set : {"stick-frequencies", "quasi-static-shape", "stick-force", "damped-events",
                                "damped-history", "cubic-events", "cubic-history"}) {
    const Comparison comparison = compare(set, copy_of(set));
    EXPECT_EQ(comparison.agreement, Agreement::agrees) << set;
    EXPECT_EQ(comparison.name, set);
    EXPECT_TRUE(comparison.remarks.empty()) << set << ": " << comparison.remarks.front();
    EXPECT_TRUE(comparison.likenesses.empty());
    for (const auto& one : comparison.quantities) {
      EXPECT_EQ(one.error, 0.0) << set << " " << one.name;
      EXPECT_EQ(one.agreement, Agreement::agrees) << set << " " << one.name;
      EXPECT_GT(one.compared, 0u);
      EXPECT_EQ(one.undecided, 0u);
    }
  }
}

TEST(ComparedCopy, HasAllPointsOfItsSeries) {
  // Of equal errors the first is told.
  EXPECT_EQ(quantity(compare("cubic-history", copy_of("cubic-history")), "y").where, "t = 0 s, run = a");
  const Comparison comparison = compare("stick-frequencies", copy_of("stick-frequencies"));
  const auto frequency = quantity(comparison, "frequency");
  EXPECT_EQ(frequency.compared, 12u);
  EXPECT_EQ(frequency.unit, "Hz");
  EXPECT_EQ(comparison.abscissa, "mode");
  ASSERT_EQ(frequency.series.size(), 2u);
  EXPECT_EQ(frequency.series[1].group, "beam = paper-half-stiffness");
  const auto table = published_table("stick-frequencies");
  EXPECT_EQ(frequency.series[0].abscissa, (Values{1, 2, 3, 4, 5, 6}));
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(frequency.series[1].theirs[i], table.column("frequency").values[i + 6]);
    EXPECT_EQ(frequency.series[1].reference[i], table.column("frequency").values[i + 6]);
    EXPECT_EQ(frequency.series[1].half_width[i], table.radius_of("frequency")[i + 6]);
    const double allowed = 1e-6 * frequency.series[1].reference[i];
    EXPECT_TRUE(within(frequency.series[1].allowed[i], allowed, round_off(1.0, 1.0, allowed)));
  }
}

// --- errors of known size

STICKSLIP_VERIFIES(ComparedTable, "X20");
TEST(ComparedTable, FindsAnErrorOfKnownSizeWhereItIs) {
  for (const double error : {3e-7, -3e-7, 3e-6, -3e-6, 0.5}) {
    auto mine = copy_of("stick-frequencies");
    values_of(mine, "frequency")[4] *= 1.0 + error;
    const Comparison comparison = compare_quietly("stick-frequencies", mine);
    const auto frequency = quantity(comparison, "frequency");
    // |f (1 + e) - f|/|f|: the sum is off by half an eps of 1, the product by another.
    EXPECT_TRUE(within(*frequency.error, std::abs(error), round_off(1.0, 1.0, 1.0))) << error;
    EXPECT_EQ(frequency.where, "beam = paper, mode = 5");
    EXPECT_EQ(frequency.agreement, std::abs(error) > 1e-6 ? Agreement::differs : Agreement::agrees);
    EXPECT_EQ(comparison.agreement, frequency.agreement);
  }
}

TEST(ComparedTable, MatchesRowsByKeyInAnyOrderAndNamesThoseThatAreMissing) {
  auto mine = copy_of("stick-frequencies");
  for (auto& column : mine.columns) {
    std::ranges::reverse(column.text);
    std::ranges::reverse(column.values);
  }
  EXPECT_EQ(quantity(compare("stick-frequencies", mine), "frequency").error, 0.0);
  keep_rows(mine, [](std::size_t row) { return row >= 5; });  // all of one beam, and one of the other
  const Comparison comparison = compare("stick-frequencies", mine);
  EXPECT_EQ(comparison.agreement, Agreement::agrees);
  EXPECT_EQ(quantity(comparison, "frequency").compared, 7u);
  ASSERT_EQ(comparison.remarks.size(), 1u);
  EXPECT_EQ(comparison.remarks[0],
            "5 of 12 rows of the data set are not in the file: beam = paper-half-stiffness, mode = 2; beam = "
            "paper-half-stiffness, mode = 3; beam = paper-half-stiffness, mode = 4; beam = "
            "paper-half-stiffness, mode = "
            "5; beam = paper-half-stiffness, mode = 6");
  erase_row(mine, 0);
  EXPECT_TRUE(compare("stick-frequencies", mine).remarks.at(0).ends_with("mode = 5 and 1 more"));
}

TEST(ComparedTable, SaysOnceWhatSeveralGroupsLookLike) {
  auto mine = copy_of("stick-frequencies");
  for (double& frequency : values_of(mine, "frequency")) frequency *= 2.0;
  const auto likenesses = compare("stick-frequencies", mine).likenesses;
  ASSERT_EQ(likenesses.size(), 1u);
  EXPECT_EQ(likenesses[0].group, "beam = paper and 1 more");
}

TEST(ComparedTable, RefusesRowsThatTheDataSetLacks) {
  auto mine = copy_of("stick-frequencies");
  values_of(mine, "mode")[2] = 99.0;
  words_of(mine, "mode")[2] = "99";
  EXPECT_EQ(error_message([&] { static_cast<void>(compare("stick-frequencies", mine)); }),
            "mine.csv:4: beam = paper, mode = 99 is not in the data set stick-frequencies");
  mine = copy_of("stick-frequencies");
  words_of(mine, "beam")[0] = "strip";
  EXPECT_EQ(error_message([&] { static_cast<void>(compare("stick-frequencies", mine)); }),
            "mine.csv:2: beam = strip is not in the data set stick-frequencies");
}

STICKSLIP_VERIFIES(ComparedCurve, "X20");
TEST(ComparedCurve, MeasuresErrorsByTheLargestValue) {
  const auto table = published_table("stick-force");
  const auto& force = table.column("friction_force").values;
  const double scale = std::abs(*std::ranges::max_element(force, {}, [](double f) { return std::abs(f); }));
  for (const double error : {5e-4, -2e-3}) {
    auto mine = copy_of("stick-force");
    values_of(mine, "friction_force")[100] += error * scale;
    const auto found = quantity(compare_quietly("stick-force", mine), "friction_force");
    EXPECT_TRUE(within(*found.error, std::abs(error), round_off(1.0, 1.0, 1.0)));
    EXPECT_EQ(found.where, "t = 0.05 s");
    EXPECT_EQ(found.agreement, error > 1e-3 || error < -1e-3 ? Agreement::differs : Agreement::agrees);
    EXPECT_TRUE(within(*found.uncertainty, 1e-9 / scale, round_off(1.0, 1.0, 1e-9 / scale)));
  }
  // With a horizon by the largest one up to it, which here is that at the horizon.
  std::size_t last = 0;
  while (std::abs(force[last]) <= 0.5 * scale) ++last;
  auto early = package();
  std::ranges::find(early.resources, "stick-force", &data::Resource::name)->comparison->horizon =
      table.column("t").values[last];
  auto mine = copy_of("stick-force");
  values_of(mine, "friction_force")[0] += 0.1 * std::abs(force[last]);
  ComparisonSettings quietly;
  quietly.diagnose = false;
  const auto found = quantity(studies::compare(early, "stick-force", mine, quietly), "friction_force");
  EXPECT_TRUE(within(*found.error, 0.1, round_off(2.0, 1.0, 0.1)));
}

TEST(ComparedCurve, MeasuresErrorsByTheRangeOfThePublishedColumn) {
  // Of the whole column, however few rows of it a file has.
  auto with_range = package();
  auto& rule = *std::ranges::find(with_range.resources, "stick-force", &data::Resource::name)->comparison;
  rule.values.front().norm = data::Norm::range;
  const auto table = published_table("stick-force");
  const auto& force = table.column("friction_force").values;
  const auto [least, greatest] = std::ranges::minmax(force);
  const double range = greatest - least;
  ASSERT_GT(range, 1.5 * std::max(greatest, -least));
  for (const double error : {9e-4, -2e-3}) {
    auto mine = copy_of("stick-force");
    keep_rows(mine, [](std::size_t row) { return row >= 90 && row < 110; });
    values_of(mine, "friction_force")[10] += error * range;
    const auto found =
        quantity(studies::compare(with_range, "stick-force", mine,
                                  {.tolerances = {}, .until = {}, .events = {}, .diagnose = false}),
                 "friction_force");
    EXPECT_EQ(found.norm, data::Norm::range);
    EXPECT_EQ(found.compared, 20u);
    // The value, up to half the range or more, is rounded when the error is added.
    EXPECT_TRUE(within(*found.error, std::abs(error), round_off(1.0, 1.0, 1.0)));
    EXPECT_EQ(found.where, "t = 0.05 s");
    EXPECT_EQ(found.agreement, error > 0.0 ? Agreement::agrees : Agreement::differs);
    EXPECT_TRUE(within(*found.uncertainty, 1e-9 / range, round_off(1.0, 1.0, 1e-9 / range)));
    EXPECT_TRUE(within(found.series[0].allowed[10], 1e-3 * range + 1e-9, round_off(2.0, 1.0, 1e-3 * range)));
  }
}

TEST(ComparedCurve, InterpolatesAnAbscissaBetweenSamplesWithoutStatedInterpolation) {
  auto mine = copy_of("stick-force");
  values_of(mine, "t")[3] += 1e-6;
  words_of(mine, "t")[3] = "0.001501";
  const auto between = quantity(compare("stick-force", mine), "friction_force");
  EXPECT_EQ(between.compared, 161u);
  EXPECT_EQ(skipped_for(between, "between the samples"), 1u);
  EXPECT_GT(*std::ranges::max_element(between.series[0].half_width), 1e-5);  // N; those of the set are 1e-9 N
  values_of(mine, "t")[3] = 0.0015 * (1.0 + 1e-10);
  EXPECT_EQ(compare("stick-force", mine).agreement, Agreement::agrees);
}

// S(x) between the samples: the stated bound is max |S''''| h^4/24 with h = 0.1 m, and holds.
TEST(ComparedCurve, IsInterpolatedWithinTheStatedBound) {
  const analytic::QuasiStaticShape shape(data::load_case("paper").beam);
  const double bound =
      published_table("quasi-static-shape").resource.comparison->interpolation->error.at("shape");
  auto mine = copy_of("quasi-static-shape");
  erase_row(mine, 20);
  for (std::size_t i = 0; i < mine.rows(); ++i) {
    values_of(mine, "x")[i] += 0.037;
    values_of(mine, "shape")[i] = shape.value(values_of(mine, "x")[i]);
  }
  const auto found = quantity(compare("quasi-static-shape", mine), "shape");
  EXPECT_EQ(found.compared, 20u);
  EXPECT_EQ(found.agreement, Agreement::agrees);
  // Max |S| is 1. |(x - x0)(x - x1)(x - x2)(x - x3)| is largest in the outer intervals, where it is nearly
  // h^4.
  EXPECT_TRUE(within(*found.error, 0.0, discretisation(bound, 1.0, "max |S''''| h^4/24")));
  EXPECT_GT(*found.error, 0.1 * bound);
  // The uncertainty is that bound and the amplified half-widths of the samples, 1e-14 each.
  EXPECT_TRUE(within(*found.uncertainty, bound,
                     discretisation(1e-13, 1.0, "Lebesgue constant of four points below 3")));
}

// --- undamped histories, of the package that is published

class ComparedUndamped : public ::testing::TestWithParam<std::string> {
 protected:
  [[nodiscard]] data::UserTable copy() const { return copy_of(GetParam(), {}, published_); }

  [[nodiscard]] Comparison compare_with(const data::UserTable& mine,
                                        const ComparisonSettings& settings = {}) const {
    return studies::compare(published_, GetParam(), mine, settings);
  }

  static double range_of(data::UserTable& table, const std::string& name) {
    const auto [least, greatest] = std::ranges::minmax(values_of(table, name));
    return greatest - least;
  }

 private:
  data::ReferencePackage published_ = data::load_reference();
};

STICKSLIP_VERIFIES(ComparedUndamped, "X20");
TEST_P(ComparedUndamped, CopyAgreesAtEverySample) {
  const Comparison comparison = compare_with(copy());
  EXPECT_EQ(comparison.agreement, Agreement::agrees);
  ASSERT_EQ(comparison.quantities.size(), 2u);
  for (const auto& one : comparison.quantities) {
    EXPECT_EQ(one.norm, data::Norm::range);
    EXPECT_EQ(one.error, 0.0);
    EXPECT_EQ(one.compared, 1001u);
    EXPECT_TRUE(one.skipped.empty());
  }
}

TEST_P(ComparedUndamped, OnePerCentOfTheRangeAtOneSampleDiffers) {
  for (const std::string name : {"tip_displacement", "midspan_displacement"})
    for (const double error : {0.004, -0.01}) {
      auto mine = copy();
      const double range = range_of(mine, name);
      values_of(mine, name)[700] += error * range;
      const Comparison comparison = compare_with(mine);
      const auto found = quantity(comparison, name);
      EXPECT_TRUE(within(*found.error, std::abs(error), round_off(1.0, 1.0, 1.0)));
      EXPECT_EQ(found.where, fmt::format("time = {:.9g} s", values_of(mine, "time")[700]));
      EXPECT_EQ(comparison.agreement, error > 0.0 ? Agreement::agrees : Agreement::differs);
    }
}

TEST_P(ComparedUndamped, ShiftByOneSampleDiffers) {
  auto mine = copy();
  for (const std::string name : {"tip_displacement", "midspan_displacement"}) {
    Values& values = values_of(mine, name);
    std::rotate(values.rbegin(), values.rbegin() + 1, values.rend());
    values[0] = 0.0;
  }
  // At least a period of the excitation has a hundred samples, of which each turns it by 2 pi/100.
  for (const auto& one : compare_with(mine).quantities) {
    EXPECT_EQ(one.agreement, Agreement::differs);
    EXPECT_GT(*one.error, 0.02);
  }
}

TEST_P(ComparedUndamped, BelowTheHalfWidthIsUndecided) {
  const Comparison comparison = compare_with(copy(), {.tolerances = {{"", 1e-6}}, .until = {}, .events = {}});
  for (const auto& one : comparison.quantities) EXPECT_EQ(one.agreement, Agreement::undecided) << one.name;
  EXPECT_EQ(comparison.agreement, Agreement::undecided);
}

INSTANTIATE_TEST_SUITE_P(DataSets, ComparedUndamped,
                         ::testing::Values("undamped-history-25", "undamped-history-35",
                                           "undamped-history-70", "undamped-history-steel-strip",
                                           "undamped-history-soft-short"),
                         [](const auto& set) {
                           std::string name = set.param.substr(17);
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

// --- verdicts

STICKSLIP_VERIFIES(ComparedVerdict, "X20");
// time_radius of the third event is 8.8e-9 s.
TEST(ComparedVerdict, IsUndecidedWhereTheReferenceIsNotKnownWellEnough) {
  const double radius = published_table("damped-events").radius_of("time")[2], tolerance = 1e-9;
  const ComparisonSettings settings{.tolerances = {{"time", tolerance}}, .until = {}, .events = {}};
  const auto verdict = [&](double error) {
    auto mine = copy_of("damped-events");
    values_of(mine, "time")[2] += error;
    const Comparison comparison = compare_quietly("damped-events", mine, settings);
    EXPECT_EQ(comparison.agreement, quantity(comparison, "time").agreement);
    return quantity(comparison, "time").agreement;
  };
  EXPECT_EQ(verdict(0.0), Agreement::undecided);
  EXPECT_EQ(verdict(0.9 * radius), Agreement::undecided);
  EXPECT_EQ(verdict(radius + 0.9 * tolerance), Agreement::undecided);
  EXPECT_EQ(verdict(radius + 1.1 * tolerance), Agreement::differs);
  EXPECT_EQ(verdict(-(radius + 1.1 * tolerance)), Agreement::differs);
  // Five of the six events within the horizon are known to more than 1e-9 s only.
  const Comparison copy = compare("damped-events", copy_of("damped-events"), settings);
  EXPECT_EQ(quantity(copy, "time").undecided, 5u);
  EXPECT_EQ(quantity(copy, "position").agreement, Agreement::agrees);
}

TEST(ComparedVerdict, NamesTheToleranceThatIsNone) {
  const auto with = [](const std::string& name, double value) {
    return error_message([&] {
      static_cast<void>(compare("stick-frequencies", copy_of("stick-frequencies"),
                                {.tolerances = {{name, value}}, .until = {}, .events = {}}));
    });
  };
  EXPECT_EQ(with("frequenzy", 1.0), "the quantity of a tolerance is frequenzy, but must be one of frequency");
  EXPECT_EQ(with("frequency", -1.0),
            "the tolerance of frequency is -1, but must be a finite number that is not negative");
  EXPECT_EQ(with("", std::nan("")), "the tolerance is nan, but must be a finite number that is not negative");
}

// --- events

STICKSLIP_VERIFIES(ComparedEvents, "X20");
TEST(ComparedEvents, FindAShiftOfKnownSize) {
  for (const double shift : {4e-6, -4e-6, 2e-5}) {
    auto mine = copy_of("damped-events");
    values_of(mine, "time")[3] += shift;
    values_of(mine, "position")[1] += 0.5 * shift;
    const Comparison comparison = compare_quietly("damped-events", mine);
    EXPECT_EQ(quantity(comparison, "sequence").agreement, Agreement::agrees);
    const auto time = quantity(comparison, "time");
    EXPECT_TRUE(within(*time.error, std::abs(shift), round_off(1.0, 1.0, 0.1)));
    EXPECT_EQ(time.where, "event 4 (capture at 0.0890359755 s)");
    EXPECT_EQ(time.agreement, shift > 1e-5 ? Agreement::differs : Agreement::agrees);
    const auto position = quantity(comparison, "position");
    EXPECT_TRUE(within(*position.error, 0.5 * std::abs(shift), round_off(1.0, 1.0, 2e-3)));
    EXPECT_EQ(position.agreement, shift > 1e-5 ? Agreement::differs : Agreement::agrees);
    EXPECT_EQ(time.compared, 6u);
    EXPECT_EQ(skipped_for(time, "beyond the horizon"), 1u);
  }
}

TEST(ComparedEvents, NameTheEventThatIsMissing) {
  auto mine = copy_of("damped-events");
  erase_row(mine, 2);
  Comparison comparison = compare_quietly("damped-events", mine);
  EXPECT_EQ(comparison.agreement, Agreement::differs);
  EXPECT_EQ(quantity(comparison, "sequence").agreement, Agreement::differs);
  EXPECT_EQ(quantity(comparison, "sequence").error, 1.0);
  EXPECT_EQ(quantity(comparison, "time").compared, 5u);
  EXPECT_EQ(quantity(comparison, "time").agreement, Agreement::agrees);
  ASSERT_EQ(comparison.remarks.size(), 1u);
  EXPECT_EQ(comparison.remarks[0], "event 3 (onset at 0.0728921318 s) is missing in the file");

  mine = copy_of("damped-events");
  keep_rows(mine, [](std::size_t row) { return row < 5; });
  comparison = compare_quietly("damped-events", mine, {.tolerances = {}, .until = 0.11, .events = {}});
  EXPECT_EQ(quantity(comparison, "sequence").error, 1.0);
  EXPECT_EQ(comparison.remarks,
            std::vector<std::string>{"event 6 (capture at 0.106894944 s) is missing in the file"});
}

TEST(ComparedEvents, NameTheEventThatIsTooMany) {
  auto mine = copy_of("damped-events");
  values_of(mine, "time")[6] = 0.1095;  // that of 0.11107 s, behind the horizon of 0.11 s, far too early
  Comparison comparison = compare_quietly("damped-events", mine);
  EXPECT_EQ(quantity(comparison, "sequence").error, 1.0);
  EXPECT_EQ(comparison.remarks,
            std::vector<std::string>{"event 7 (onset at 0.1095 s) of the file is not in the data set"});
  EXPECT_EQ(skipped_for(quantity(comparison, "time"), "without an event of the data set"), 1u);

  mine = copy_of("damped-events");
  repeat_row(mine, 3);  // two captures one after the other
  comparison = compare_quietly("damped-events", mine);
  EXPECT_EQ(quantity(comparison, "time").compared, 6u);
  EXPECT_EQ(
      comparison.remarks,
      std::vector<std::string>{"event 4 (capture at 0.0890359755 s) of the file is not in the data set"});
}

TEST(ComparedEvents, MayLieOnEitherSideOfTheHorizon) {
  const double sixth = published_table("damped-events").column("time").values[5];
  const auto difference = [](const data::UserTable& mine, double until) {
    const Comparison comparison =
        compare_quietly("damped-events", mine, {.tolerances = {}, .until = until, .events = {}});
    return *quantity(comparison, "sequence").error;
  };
  auto mine = copy_of("damped-events");
  EXPECT_EQ(difference(mine, sixth + 5e-6), 0.0);
  EXPECT_EQ(difference(mine, sixth - 5e-6), 0.0);
  values_of(mine, "time")[5] = sixth - 8e-6;  // theirs is before the horizon, the reference's behind
  EXPECT_EQ(difference(mine, sixth - 5e-6), 0.0);
  values_of(mine, "time")[5] = sixth + 8e-6;  // and the other way round
  EXPECT_EQ(difference(mine, sixth + 5e-6), 0.0);
  erase_row(mine, 6);
  erase_row(mine, 5);  // not reached
  EXPECT_EQ(difference(mine, sixth + 5e-6), 0.0);
  EXPECT_EQ(difference(mine, sixth + 5e-5), 1.0);
  // A relative tolerance is that share of the latest time.
  auto relative = package();
  std::ranges::find(relative.resources, "damped-events", &data::Resource::name)->comparison->values[0].norm =
      data::Norm::relative;
  for (const double share : {0.9e-4, 1.1e-4}) {
    const ComparisonSettings settings{
        .tolerances = {{"time", 1e-4}}, .until = sixth * (1.0 + share), .events = {}, .diagnose = false};
    const auto sequence = quantity(studies::compare(relative, "damped-events", mine, settings), "sequence");
    EXPECT_EQ(sequence.error, share < 1e-4 ? 0.0 : 1.0);
  }
}

TEST(ComparedEvents, LeaveGrazesOutAndRefuseOtherWords) {
  auto mine = copy_of("damped-events", {"change", "time", "position"});
  repeat_row(mine, 1);
  words_of(mine, "change")[1] = "graze";
  EXPECT_EQ(compare("damped-events", mine).agreement, Agreement::agrees);
  words_of(mine, "change")[1] = "slip";
  EXPECT_EQ(error_message([&] { static_cast<void>(compare("damped-events", mine)); }),
            "mine.csv:3: change is 'slip', but must be one of onset, capture, reversal, graze");
}

TEST(ComparedEvents, OfSeveralRunsAreKeptApart) {
  auto mine = copy_of("cubic-events");
  values_of(mine, "time")[3] += 3e-7;
  values_of(mine, "position")[3] *= 1.0 + 4e-7;  // its scale is that of its run, which has this event only
  const Comparison comparison = compare("cubic-events", mine);
  EXPECT_EQ(quantity(comparison, "time").where, "event 1 (onset at 0.455 s), run = b");
  EXPECT_TRUE(within(*quantity(comparison, "position").error, 4e-7, round_off(1.0, 1.0, 1.0)));
  EXPECT_EQ(comparison.agreement, Agreement::agrees);
  erase_row(mine, 3);
  EXPECT_EQ(compare("cubic-events", mine).remarks,
            std::vector<std::string>{"run = b is not in the file and was not compared"});
}

TEST(ComparedEvents, SayWhatWasNotGiven) {
  const Comparison comparison = compare("damped-events", copy_of("damped-events", {"change", "time"}));
  EXPECT_EQ(comparison.agreement, Agreement::agrees);
  EXPECT_EQ(comparison.remarks, std::vector<std::string>{"position is not in the file and was not compared"});
}

// --- phases

// Samples between those of the reference, with the cubic polynomials of the data set, which a polynomial of
// order 3 reproduces; at 1 m its terms lose some ten eps.
data::UserTable between_samples() {
  auto mine = copy_of("cubic-history");
  keep_rows(mine, [&](std::size_t row) { return (row + 1) % 101 != 0; });
  const auto events = published_table("cubic-events");
  for (std::size_t row = 0; row < mine.rows(); ++row) {
    double& t = values_of(mine, "t")[row];
    t += 0.0042;
    std::size_t phase = 0;
    for (std::size_t event = 0; event < events.rows(); ++event)
      if (events.column("run").text[event] == words_of(mine, "run")[row] &&
          events.column("time").values[event] <= t)
        ++phase;
    const Values factors{1.0, -2.0, 3.0, -4.0};
    const double factor = factors[phase] * (words_of(mine, "run")[row] == "a" ? 1.0 : 2.0);
    values_of(mine, "y")[row] = factor * (1.0 + t - 2.0 * t * t + t * t * t) + static_cast<double>(phase);
    words_of(mine, "phase")[row] = phase == 0 || phase == 3 ? "stick" : "slip";
  }
  return mine;
}

data::UserTable events_of_cubic() { return copy_of("cubic-events"); }

STICKSLIP_VERIFIES(ComparedHistory, "X20");
TEST(ComparedHistory, IsInterpolatedWithinItsPhaseOnly) {
  for (const bool events : {false, true}) {
    ComparisonSettings settings;
    if (events) settings.events = events_of_cubic();
    const Comparison comparison = compare("cubic-history", between_samples(), settings);
    EXPECT_EQ(comparison.agreement, Agreement::agrees);
    const auto y = quantity(comparison, "y");
    // One step over a jump would be an error of 1 m or more.
    EXPECT_TRUE(within(*y.error, 0.0, round_off(4.0, 2.0, 6.0)));
    // Run a has samples at 0.0042, 0.0142, ..., 0.9942 s, run b as well; 0.9442 is the last before 0.95 s.
    EXPECT_EQ(skipped_for(y, "beyond the horizon"), 10u);
    // Events at 0.305, 0.515, 0.805 and 0.455 s: the sample at 0.3042 has none of its phase behind it, and so
    // on.
    const std::size_t at_events = 4;
    EXPECT_EQ(skipped_for(y, "between an event and the samples"), events ? at_events : 0u);
    EXPECT_EQ(skipped_for(y, "between the two times of an event"), events ? 0u : 2u * at_events);
    EXPECT_EQ(y.compared, 190u - (events ? at_events : 2u * at_events));
    EXPECT_EQ(quantity(comparison, "phase").error, 0.0);
  }
}

TEST(ComparedHistory, LeavesOutWhatLiesBetweenTheTwoTimesOfAnEvent) {
  // Their onset is 37 ms late: until then they stick, and far from the reference.
  auto mine = copy_of("cubic-history"), events = events_of_cubic();
  values_of(events, "time")[0] += 0.037;
  std::size_t between = 0;
  for (std::size_t row = 0; row < 101; ++row) {
    const double t = values_of(mine, "t")[row];
    if (t <= 0.305 || t >= 0.342) continue;
    values_of(mine, "y")[row] = 1e3;
    words_of(mine, "phase")[row] = "stick";
    ++between;
  }
  ASSERT_EQ(between, 4u);
  ComparisonSettings settings{.tolerances = {}, .until = {}, .events = events};
  Comparison comparison = compare("cubic-history", mine, settings);
  EXPECT_EQ(quantity(comparison, "y").agreement, Agreement::agrees);
  EXPECT_EQ(skipped_for(quantity(comparison, "y"), "between the two times of an event"), between);
  EXPECT_EQ(comparison.agreement, Agreement::agrees);

  // Without their events they are in another phase, which counts.
  settings.events.reset();
  comparison = compare("cubic-history", mine, settings);
  EXPECT_EQ(comparison.agreement, Agreement::differs);
  EXPECT_EQ(quantity(comparison, "phase").error, 3.0);  // one of the four is within the guard of 10 ms
  EXPECT_EQ(quantity(comparison, "phase").where, "t = 0.32 s, run = a (slip in the data set)");
  EXPECT_EQ(quantity(comparison, "y").agreement, Agreement::agrees);

  values_of(mine, "y")[36] += 1.1e-6;  // at 0.36 s, in the phase again
  comparison = compare("cubic-history", mine, {.tolerances = {}, .until = {}, .events = events});
  EXPECT_EQ(comparison.agreement, Agreement::differs);
  EXPECT_EQ(quantity(comparison, "y").where, "t = 0.36 s, run = a");
}

TEST(ComparedHistory, LeavesOutOneSamplingDistanceAroundAnEventWithoutTheirs) {
  // 0.30 and 0.31 s are next to the onset at 0.305 s, 0.29 and 0.32 s are not.
  for (const std::size_t row : {29u, 30u, 31u, 32u}) {
    auto mine = copy_of("cubic-history");
    values_of(mine, "y")[row] += 1.0;
    const Comparison comparison = compare("cubic-history", mine);
    const bool is_next = row == 30 || row == 31;
    EXPECT_EQ(comparison.agreement, is_next ? Agreement::agrees : Agreement::differs) << row;
    EXPECT_EQ(skipped_for(quantity(comparison, "y"), "between the two times of an event"), 8u);
    EXPECT_EQ(skipped_for(quantity(comparison, "y"), "beyond the horizon"), 10u);
    EXPECT_EQ(quantity(comparison, "y").compared, 202u - 18u);
  }
}

TEST(ComparedHistory, LeavesOutThePhasesThatTheyDoNotHave) {
  auto mine = copy_of("cubic-history"), events = events_of_cubic();
  erase_row(events, 1);  // they have no reversal at 0.515 s
  for (std::size_t row = 52; row < 81; ++row) values_of(mine, "y")[row] = 7.0;  // up to the capture
  const Comparison comparison =
      compare("cubic-history", mine, {.tolerances = {}, .until = {}, .events = events});
  EXPECT_EQ(comparison.agreement, Agreement::differs);
  EXPECT_EQ(quantity(comparison, "sequence").agreement, Agreement::differs);
  EXPECT_EQ(quantity(comparison, "y").error, 0.0);
  EXPECT_EQ(skipped_for(quantity(comparison, "y"), "in another phase"), 29u);  // 0.52, ..., 0.80 s
  ASSERT_GE(comparison.remarks.size(), 1u);
  EXPECT_EQ(comparison.remarks[0], "run = a: event 2 (reversal at 0.515 s) is missing in the file")
      << comparison.remarks[0];
}

TEST(ComparedHistory, RefusesWhatItCannotCompare) {
  auto mine = copy_of("cubic-history");
  words_of(mine, "phase")[7] = "sliding";
  EXPECT_EQ(error_message([&] { static_cast<void>(compare("cubic-history", mine)); }),
            "mine.csv:9: phase is 'sliding', but must be stick or slip");
  mine = copy_of("cubic-history");
  keep_rows(mine, [](std::size_t row) { return row % 101 > 95; });
  EXPECT_EQ(error_message([&] { static_cast<void>(compare("cubic-history", mine)); }),
            "mine.csv: none of the 10 rows can be compared: 10 beyond the horizon");
  EXPECT_EQ(error_message([&] {
              static_cast<void>(compare("stick-frequencies", copy_of("stick-frequencies"),
                                        {.tolerances = {}, .until = 1.0, .events = {}}));
            }),
            "a latest time is given, but the data set stick-frequencies is not one in time");
  EXPECT_EQ(error_message([&] { static_cast<void>(compare("beams", copy_of("beams"))); }),
            "the data set beams says nothing of how to compare with it");
}

// --- whom it looks like

struct Mistake {
  const char* set;
  const char* wrong_model;
  const char* problem;
  studies::Quantity quantity;
  const char* abscissa;
  const char* value;
};

class LikenedTo : public ::testing::TestWithParam<Mistake> {};

STICKSLIP_VERIFIES(LikenedTo, "X20");
TEST_P(LikenedTo, TheMistakeThatWasMade) {
  const auto& [set, wrong_model, problem, what, abscissa, value] = GetParam();
  const std::string name = set;
  const bool counts_events = what == studies::Quantity::contact_event;
  auto mine = counts_events              ? copy_of(name, {"index", "change", "time"})
              : name == "damped-history" ? copy_of(name, {"t", "tip_displacement"})
                                         : copy_of(name);
  if (name == "stick-frequencies") keep_rows(mine, [](std::size_t row) { return row < 6; });
  if (counts_events) keep_rows(mine, [](std::size_t row) { return row < 6; });
  const auto values = studies::wrong_result(with_the_settings_of_the_paper(problem), wrong_model, what,
                                            values_of(mine, abscissa));
  ASSERT_TRUE(values.has_value());
  values_of(mine, value) = *values;
  const Comparison comparison = compare(name, mine);
  EXPECT_EQ(comparison.agreement, Agreement::differs);
  ASSERT_EQ(comparison.likenesses.size(), 1u);
  const auto& likeness = comparison.likenesses.front();
  ASSERT_TRUE(likeness.diagnosis.has_value()) << likeness.sentence;
  EXPECT_EQ(likeness.diagnosis->finding, Finding::mistaken) << likeness.sentence;
  EXPECT_GT(std::ranges::count(likeness.diagnosis->named, wrong_model), 0) << likeness.sentence;
  EXPECT_NE(likeness.sentence.find(wrong_model), std::string::npos) << likeness.sentence;
}

INSTANTIATE_TEST_SUITE_P(
    WrongModels, LikenedTo,
    ::testing::Values(
        Mistake{"stick-frequencies", "second-moment-as-printed", "paper", studies::Quantity::stick_frequency,
                "mode", "frequency"},
        Mistake{"stick-frequencies", "lumped-mass", "paper", studies::Quantity::stick_frequency, "mode",
                "frequency"},
        Mistake{"stick-frequencies", "axial-force-left-out", "paper", studies::Quantity::stick_frequency,
                "mode", "frequency"},
        Mistake{"quasi-static-shape", "tension", "paper", studies::Quantity::quasi_static_shape, "x",
                "shape"},
        Mistake{"stick-force", "zero-initial-velocity", "paper", studies::Quantity::stick_force, "t",
                "friction_force"},
        Mistake{"stick-force", "force-sign", "paper", studies::Quantity::stick_force, "t", "friction_force"},
        Mistake{"stick-force", "dead-load", "paper", studies::Quantity::stick_force, "t", "friction_force"},
        Mistake{"stick-force", "peak-to-peak-amplitude", "paper", studies::Quantity::stick_force, "t",
                "friction_force"},
        Mistake{"damped-events", "damping-left-out", "damped", studies::Quantity::contact_event, "index",
                "time"},
        Mistake{"damped-events", "kinetic-friction-at-once", "damped", studies::Quantity::contact_event,
                "index", "time"},
        Mistake{"damped-history", "one-friction-coefficient", "damped", studies::Quantity::tip_displacement,
                "t", "tip_displacement"},
        Mistake{"damped-history", "regularised-friction", "damped", studies::Quantity::tip_displacement, "t",
                "tip_displacement"}),
    [](const auto& instance) {
      std::string name = std::string(instance.param.set) + "_" + instance.param.wrong_model;
      std::ranges::replace(name, '-', '_');
      return name;
    });

STICKSLIP_VERIFIES(LikenedToNothing, "X20");
TEST(LikenedToNothing, IsNoise) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> error(-1.0, 1.0);
    auto mine = copy_of("stick-frequencies");
    keep_rows(mine, [](std::size_t row) { return row < 6; });
    for (double& value : values_of(mine, "frequency")) value *= 1.0 + 1e-2 * error(generator);
    auto shape = copy_of("quasi-static-shape");
    for (double& value : values_of(shape, "shape")) value += 1e-2 * error(generator);
    for (const auto& [set, table] : {std::pair{"stick-frequencies", mine}, {"quasi-static-shape", shape}}) {
      const Comparison comparison = compare(set, table);
      EXPECT_EQ(comparison.agreement, Agreement::differs);
      ASSERT_EQ(comparison.likenesses.size(), 1u);
      EXPECT_EQ(comparison.likenesses[0].diagnosis.value().finding, Finding::unexplained)
          << comparison.likenesses[0].sentence;
    }
  }
}

TEST(LikenedToNothing, IsWhatHasNoCaseOfItsOwnOrNoKnownMistake) {
  auto mine = copy_of("cubic-history");
  values_of(mine, "y")[10] += 1.0;
  EXPECT_TRUE(compare("cubic-history", mine).likenesses.empty());
  mine = copy_of("damped-history");
  for (double& force : values_of(mine, "friction_force")) force += 30.0;
  const Comparison comparison = compare("damped-history", mine);
  EXPECT_EQ(comparison.agreement, Agreement::differs);
  ASSERT_EQ(comparison.likenesses.size(), 1u);  // of the force, not of the displacement
  EXPECT_EQ(comparison.likenesses[0].quantity, "friction_force");
  EXPECT_EQ(comparison.likenesses[0].diagnosis.value().finding, Finding::unexplained)
      << comparison.likenesses[0].sentence;
}

TEST(LikenedToNothing, IsADifferenceThatTheModelsCannotResolve) {
  auto mine = copy_of("damped-history", {"t", "tip_displacement"});
  double sign = 1.0;
  for (double& y : values_of(mine, "tip_displacement")) y *= 1.0 + 1e-4 * (sign = -sign);
  const Comparison comparison = compare(
      "damped-history", mine, {.tolerances = {{"tip_displacement", 1e-5}}, .until = {}, .events = {}});
  EXPECT_EQ(comparison.agreement, Agreement::differs);
  ASSERT_EQ(comparison.likenesses.size(), 1u);
  EXPECT_TRUE(
      comparison.likenesses[0].sentence.starts_with("no diagnosis: the difference of 0.01 % is too small"))
      << comparison.likenesses[0].sentence;
}

}  // namespace
}  // namespace stickslip::testing
