// SPDX-License-Identifier: MIT
/// Somebody's results against reference data: a point has the verdict of its definition, a copy agrees, an error of
/// known size is found where it is, events are aligned at the least cost, and known mistakes are named.

#include "comparison/event_sequence.hpp"
#include "comparison/groups.hpp"
#include "comparison/samples.hpp"
#include "own_copy.hpp"
#include "support/random_beams.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using comparison::Agreement;
using comparison::Comparison;
using comparison::SequenceMatch;
using comparison::TabulatedEvent;
using data::Norm;
using Values = std::vector<double>;
using Remarks = std::vector<std::string>;

constexpr double unlimited = std::numeric_limits<double>::infinity();

// --- single points

// Errors e, half-widths u and tolerances in eighths of a unit that is a power of two: many are equal, none is rounded.
STICKSLIP_VERIFIES(JudgedPoints, "X20");
TEST(JudgedPoints, HaveTheVerdictOfTheirDefinition) {
  struct Measure {
    Norm norm;
    double reference, unit;
  };
  constexpr double scale = 4.0;
  RandomNumbers draw(59);
  const auto eighths = [&] { return draw.whole(0, 4) / 8.0; };
  for (const auto& [norm, reference, unit] :
       {Measure{Norm::relative, -2.0, 2.0}, Measure{Norm::relative, 0.0, scale},
        Measure{Norm::scale, -2.0, scale}, Measure{Norm::range, -2.0, scale},
        Measure{Norm::absolute, -2.0, 1.0}})
    for (int i = 0; i < 500; ++i) {
      Comparison::Quantity found;
      found.norm = norm, found.tolerance = eighths(), found.own_tolerance = eighths();
      found.required_level = draw.whole(0, 1) == 0 ? comparison::strict_level : 1;
      const double limit = comparison::level_limits.at(found.required_level);
      found.series.emplace_back();
      bool differs = false, is_strict = true;
      std::size_t undecided = 0;
      double most = -unlimited, scaled = 0.0;
      std::string where;
      for (const std::string place : {"first", "second", "third"}) {
        const double e = eighths(), u = eighths(), half = 0.5 * u * unit,
                     theirs = reference + (draw.whole(0, 1) == 0 ? e : -e) * unit;
        comparison::judge(found, {0.0, {theirs, half}, comparison::Interpolated{reference, half}}, scale,
                          place);
        const bool is_off = e > found.tolerance + u && (e - u) * unit / scale > limit;
        differs = differs || is_off;
        undecided += !is_off && u > found.tolerance && u * unit / scale > limit ? 1 : 0;
        EXPECT_EQ(found.series.back().allowed.back(),
                  u * unit + std::max(found.tolerance * unit, limit * scale));
        is_strict = is_strict && u <= found.own_tolerance && e <= found.own_tolerance + u;
        scaled = std::max(scaled, (e - u) * unit / scale);
        if (e - u > most) most = e - u, where = place;
      }
      EXPECT_EQ(found.agreement, differs         ? Agreement::differs
                                 : undecided > 0 ? Agreement::undecided
                                                 : Agreement::agrees);
      EXPECT_EQ(found.undecided, undecided);
      EXPECT_EQ(found.is_strict, is_strict);
      EXPECT_EQ(*found.error - *found.uncertainty, most);
      EXPECT_EQ(found.where, where);
      EXPECT_EQ(found.scaled_error, scaled);
    }
}

TEST(JudgedPoints, HaveTheLastLevelNotExceeded) {
  Comparison::Quantity one;
  one.is_strict = false;
  EXPECT_EQ(comparison::level_of(one), 0u);
  one.compared = 1;
  for (const auto& [limit, level] : {std::pair{1e-1, 1u}, {1e-2, 2u}, {1e-3, 3u}})
    for (const bool is_above : {false, true}) {
      one.scaled_error = is_above ? std::nextafter(limit, 1.0) : limit;
      EXPECT_EQ(comparison::level_of(one), is_above ? level - 1 : level);
    }
}

// --- one wrong value in each column of each data set

// The columns of which the words and numbers tell one curve, sequence or block of a table from another.
std::vector<std::string> block_columns(const data::Resource& resource, const std::string& abscissa) {
  std::vector<std::string> columns = resource.primary_key;
  std::erase_if(columns, [&](const std::string& name) { return name == abscissa || name == "index"; });
  return columns;
}

// The largest |value| or the range of a column, in the block of a row up to the horizon; if that is 0, in all blocks.
double extent_of(const OwnCopy& copy, const data::ComparedValue& value, const std::string& abscissa,
                 std::size_t of_row) {
  const auto& table = copy.reference();
  const auto columns = block_columns(table.resource, abscissa);
  const double horizon = table.resource.comparison->horizon.value_or(unlimited);
  const Values& values = table.column(value.field).values;
  for (const bool everywhere : {false, true}) {
    double least = unlimited, greatest = -unlimited;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (std::isfinite(horizon) && table.column(abscissa).values[row] > horizon) continue;
      if (!everywhere &&
          comparison::label_of(table, columns, row) != comparison::label_of(table, columns, of_row))
        continue;
      least = std::fmin(least, values[row]), greatest = std::fmax(greatest, values[row]);
    }
    const double extent =
        value.norm == Norm::range ? greatest - least : std::max(std::abs(least), std::abs(greatest));
    if (extent > 0.0) return extent;
  }
  return 1.0;
}

// Of a compared point the row of the data set.
std::size_t row_of(const OwnCopy& copy, const Comparison& right, const Comparison::Series& series,
                   std::size_t point) {
  if (right.abscissa.empty()) return static_cast<std::size_t>(series.abscissa[point]) - 1;
  const auto& table = copy.reference();
  const Values& abscissa = table.column(right.abscissa).values;
  const auto columns = block_columns(table.resource, right.abscissa);
  std::size_t row = 0;
  while (abscissa[row] != series.abscissa[point] ||
         (!series.group.empty() && comparison::label_of(table, columns, row) != series.group))
    ++row;
  return row;
}

// Events keep their partners if one is moved by less than a fifth of the distance of two.
double largest_shift(const OwnCopy& copy) {
  Values times = copy.reference().column("time").values;
  double least = unlimited;
  for (std::size_t i = 1; i < times.size(); ++i)
    if (times[i] > times[i - 1]) least = std::min(least, times[i] - times[i - 1]);
  return 0.2 * least;
}

template <class List>
std::size_t index_in(const List& list, RandomNumbers& draw) {
  return static_cast<std::size_t>(draw.whole(0, static_cast<int>(list.size()) - 1));
}

// One value of a copy, moved by a hundredth to a hundred tolerances beyond its half-width.
void expect_error_that_is_made(const OwnCopy& copy, const data::ComparedValue& value, RandomNumbers& draw) {
  const Comparison right = copy.compared();
  const auto before = quantity_of(right, value.field);
  const auto& series = before.series[index_in(before.series, draw)];
  const std::size_t point = index_in(series.abscissa, draw), row = row_of(copy, right, series, point);
  const double reference = series.reference[point], width = series.half_width[point],
               scale = extent_of(copy, value, right.abscissa, row),
               unit = value.norm == Norm::absolute                       ? 1.0
                      : value.norm == Norm::relative && reference != 0.0 ? std::abs(reference)
                                                                         : scale;
  double size = width + value.tolerance * unit * draw.log_uniform(0.01, 100.0);
  if (right.kind == data::ComparisonKind::events && value.field == "time")
    size = std::min(size, largest_shift(copy));
  OwnCopy mine = copy;
  mine[value.field][row] += draw.whole(0, 1) == 0 ? size : -size;
  const auto found = mine.compared(value.field);
  SCOPED_TRACE(fmt::format("{}, {}, row {}: {}", right.name, value.field, row + 1, size / unit));
  const double rounding = (std::abs(reference) + size) / unit;
  EXPECT_TRUE(within(*found.error, size / unit, round_off(2.0, 1.0, rounding)));
  EXPECT_TRUE(within(*found.uncertainty, width / unit, round_off(2.0, 1.0, width / unit)));
  EXPECT_EQ(found.compared, before.compared);
  const double allowed = width + value.tolerance * unit;
  EXPECT_EQ(found.agreement, size > allowed ? Agreement::differs : before.agreement);
  EXPECT_EQ(found.is_strict, before.is_strict && size <= allowed);
  EXPECT_TRUE(
      within(found.scaled_error, (size - width) / scale, round_off(4.0, 1.0, rounding * unit / scale)));
  const auto& changed = found.series[static_cast<std::size_t>(&series - before.series.data())];
  EXPECT_EQ(changed.theirs[point], mine[value.field][row]);
  EXPECT_TRUE(within(changed.allowed[point], allowed, round_off(2.0, 1.0, allowed)));
}

STICKSLIP_VERIFIES(ComparedCopy, "X20");
TEST(ComparedCopy, HasTheErrorOfItsOnlyWrongValue) {
  RandomNumbers draw(20180219);
  for (const data::ReferencePackage* package : {&small_package(), &published_package()})
    for (const data::Resource& resource : package->resources) {
      if (!resource.comparison) continue;
      const OwnCopy copy(*package, resource.name);
      for (const data::ComparedValue& value : resource.comparison->values)
        for (int i = 0; i < 3 && value.norm != Norm::word; ++i) expect_error_that_is_made(copy, value, draw);
    }
}

TEST(ComparedCopy, OfEveryDataSetAgreesWithoutError) {
  for (const data::ReferencePackage* package : {&small_package(), &published_package()})
    for (const data::Resource& resource : package->resources) {
      if (!resource.comparison) continue;
      const Comparison comparison = OwnCopy(*package, resource.name).compared();
      EXPECT_EQ(comparison.agreement, Agreement::agrees) << resource.name;
      EXPECT_EQ(comparison.remarks, Remarks()) << resource.name;
      for (const auto& one : comparison.quantities) {
        EXPECT_EQ(one.error, 0.0) << resource.name << " " << one.name;
        EXPECT_GT(one.compared, 0u);
      }
    }
  // Of equal errors the first is told.
  EXPECT_EQ(own_copy("cubic-history").compared("y").where, "t = 0 s, run = a");
}

// --- rows

STICKSLIP_VERIFIES(ComparedTable, "X20");
TEST(ComparedTable, MatchesRowsByKeyAndNamesTheRest) {
  auto mine = own_copy("stick-frequencies");
  for (auto& column : mine.table.columns) {
    std::ranges::reverse(column.text);
    std::ranges::reverse(column.values);
  }
  const auto all = mine.compared("frequency");
  EXPECT_EQ(all.error, 0.0);
  ASSERT_EQ(all.series.size(), 2u);
  EXPECT_EQ(all.series[1].group, "beam = paper-half-stiffness");
  mine.keep([](std::size_t row) { return row >= 5; });  // all of one beam, and one of the other
  const Comparison comparison = mine.compared();
  EXPECT_EQ(comparison.agreement, Agreement::undecided);
  EXPECT_EQ(quantity_of(comparison, "frequency").compared, 7u);
  ASSERT_EQ(comparison.remarks.size(), 1u);
  EXPECT_TRUE(comparison.remarks[0].starts_with("5 of 12 rows of the data set are not in the file: "));
  for (int mode = 2; mode <= 6; ++mode)
    EXPECT_TRUE(holds(comparison.remarks[0], fmt::format("beam = paper-half-stiffness, mode = {}", mode)));
  mine.erase(0);
  EXPECT_TRUE(mine.compared().remarks.at(0).ends_with("mode = 5 and 1 more"));
}

TEST(ComparedTable, RefusesRowsThatTheDataSetLacks) {
  struct Row {
    OwnCopy copy;
    std::string column, word, place, allowed;
  };
  for (auto& [copy, column, word, place, allowed] : std::vector<Row>{
           {own_copy("stick-frequencies"), "mode", "99", "mine.csv:2: beam = paper, mode = 99 is not in",
            "where mode must be one of 1, 2, 3, 4, 5, 6"},
           {own_copy("stick-frequencies"), "beam", "strip", "mine.csv:2: beam = strip is not in",
            "where beam must be one of paper, paper-half-stiffness"},
           {published_copy("friction-maxima"), "frequency", "0.5", "mine.csv:2: frequency = 0.5 is not in",
            "where frequency must be one of the 120 from 1 to 120"}}) {
    copy.words(column)[0] = word;
    if (column != "beam") copy[column][0] = std::stod(word);
    EXPECT_TRUE(copy.error_message().starts_with(place)) << copy.error_message();
    EXPECT_TRUE(copy.error_message().ends_with(allowed)) << copy.error_message();
  }
  EXPECT_EQ(own_copy("beams").error_message(), "the data set beams says nothing of how to compare with it");
}

TEST(ComparedTable, SaysOnceWhatTwoGroupsLookLike) {
  auto mine = own_copy("stick-frequencies");
  EXPECT_TRUE(mine.diagnosed().empty());
  for (double& frequency : mine["frequency"]) frequency *= 2.0;
  const auto diagnoses = mine.diagnosed();
  ASSERT_EQ(diagnoses.size(), 1u);
  EXPECT_EQ(diagnoses[0].group, "beam = paper and 1 more");
}

// --- the alignment of two sequences of events

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;
using Events = std::vector<TabulatedEvent>;

// All alignments of the events from i and j on that keep the order and pair events of a kind.
std::vector<Pairs> alignments(const Events& reference, const Events& theirs, std::size_t from_i = 0,
                              std::size_t from_j = 0) {
  std::vector<Pairs> all{{}};
  for (std::size_t i = from_i; i < reference.size(); ++i)
    for (std::size_t j = from_j; j < theirs.size(); ++j) {
      if (reference[i].change != theirs[j].change) continue;
      for (Pairs further : alignments(reference, theirs, i + 1, j + 1)) {
        further.insert(further.begin(), {i, j});
        all.push_back(further);
      }
    }
  return all;
}

// The cost of an alignment, and what it says of each event.
std::pair<double, SequenceMatch> judged_alignment(const Events& reference, const Events& theirs,
                                                  const comparison::SequenceLimits& limits,
                                                  const Pairs& pairs) {
  const double usual = reference.empty()
                           ? 1.0
                           : 0.5 * reference.back().time / static_cast<double>(reference.size()),
               last = std::min(limits.horizon, limits.end);
  double cost = 0.0;
  SequenceMatch match;
  for (const auto& [i, j] : pairs) {
    cost += std::abs(reference[i].time - theirs[j].time);
    if (reference[i].time > limits.horizon)
      ++match.beyond;
    else
      match.pairs.emplace_back(i, j);
  }
  for (std::size_t i = 0; i < reference.size(); ++i) {
    if (std::ranges::count(pairs, i, &Pairs::value_type::first) > 0) continue;
    const double slack = limits.time_tolerance + reference[i].time_radius, time = reference[i].time;
    const bool is_inside = time < last - slack, is_near = !is_inside && time <= last + slack;
    cost += is_inside ? usual : is_near ? std::min(usual, slack) : 0.0;
    if (is_inside) match.missing.push_back(i);
    if (time > limits.end && time < limits.horizon - slack) ++match.unreached;
  }
  for (std::size_t j = 0; j < theirs.size(); ++j) {
    if (std::ranges::count(pairs, j, &Pairs::value_type::second) > 0) continue;
    const bool is_beyond = theirs[j].time > limits.horizon;
    cost += is_beyond ? 0.0 : usual;
    match.beyond += is_beyond ? 1 : 0;
    if (!is_beyond) match.extra.push_back(j);
  }
  return {cost, match};
}

// Of all alignments; times in eighths of a second often lie on a limit.
STICKSLIP_VERIFIES(EventSequence, "X20");
TEST(EventSequence, IsAlignedAtTheLeastCost) {
  RandomNumbers draw(7);
  const auto eighths = [&](int most) { return draw.whole(0, most) / 8.0; };
  const auto events = [&] {
    Events list(static_cast<std::size_t>(draw.whole(0, 4)));
    for (TabulatedEvent& event : list)
      event = {draw.whole(0, 1) == 0 ? "onset" : "capture", 0.125 + eighths(15), eighths(1), 0, 0};
    std::ranges::sort(list, {}, &TabulatedEvent::time);
    return list;
  };
  const auto members = [](const SequenceMatch& match) {
    return std::tuple(match.pairs, match.missing, match.extra, match.unreached, match.beyond);
  };
  for (int i = 0; i < 4000; ++i) {
    const comparison::SequenceLimits limits{.horizon = draw.whole(0, 1) == 0 ? unlimited : eighths(20),
                                            .end = draw.whole(0, 1) == 0 ? unlimited : eighths(20),
                                            .time_tolerance = eighths(2)};
    const Events all = events(), theirs = events();
    Events reference = all;
    std::erase_if(reference, [&](const TabulatedEvent& event) {
      return event.time > limits.horizon + limits.time_tolerance + event.time_radius;
    });
    double least = unlimited;
    std::vector<std::pair<double, SequenceMatch>> judged;
    for (const Pairs& pairs : alignments(reference, theirs))
      judged.push_back(judged_alignment(reference, theirs, limits, pairs)),
          least = std::min(least, judged.back().first);
    const auto found = members(comparison::match(all, theirs, limits));
    EXPECT_TRUE(std::ranges::any_of(judged,
                                    [&](const auto& one) {
                                      return one.first <= least + round_off(8.0, 1.0, 2.0).value &&
                                             members(one.second) == found;
                                    }))
        << "draw " << i;
  }
}

TEST(EventSequence, LosesItsShortPhases) {
  const double limit = 0.125;
  const auto left = [&](const Events& events) {
    return comparison::without_short_phases(events, limit).size();
  };
  const auto event = [](const char* change, double time) { return TabulatedEvent{change, time, 0.0, 0, 0}; };
  EXPECT_EQ(left({event("onset", 1.0), event("capture", 2.0), event("onset", 2.1)}), 1u);  // a stick
  EXPECT_EQ(left({event("onset", 1.0), event("capture", 1.1), event("onset", 2.0)}), 1u);  // a slip
  EXPECT_EQ(left({event("onset", 1.0), event("reversal", 1.05), event("capture", 1.1)}), 0u);
  EXPECT_EQ(left({event("onset", 1.0), event("capture", 1.125), event("onset", 2.0)}), 3u);
  EXPECT_EQ(left({event("reversal", 1.0), event("reversal", 1.1)}), 2u);
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
  const Events events{{"onset", 1.0, 0.0, 0, 0}, {"reversal", 2.0, 0.0, 0, 0}, {"capture", 3.0, 0.0, 0, 0}};
  for (const auto& [t, contact] : std::vector<std::pair<double, int>>{
           {0.5, 0}, {1.0, 1}, {1.5, 1}, {2.0, -1}, {2.5, -1}, {3.0, 0}, {9.0, 0}})
    EXPECT_EQ(comparison::contact_at(events, t), contact) << t;
  EXPECT_EQ(comparison::contact_at({events[2]}, 0.5), 1);
}

}  // namespace
}  // namespace stickslip::testing
