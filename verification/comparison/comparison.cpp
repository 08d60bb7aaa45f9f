// SPDX-License-Identifier: MIT
#include "comparison/comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>

#include "comparison/event_sequence.hpp"
#include "comparison/groups.hpp"
#include "comparison/samples.hpp"
#include "stickslip/data/input_error.hpp"

namespace stickslip::comparison {

namespace {

using data::ComparisonKind;
using data::InputError;
using data::Norm;
using data::shortest_text;

constexpr double infinity = std::numeric_limits<double>::infinity();

const std::string beyond_horizon = "beyond the horizon";
const std::string outside_range = "outside the range of the data set";
const std::string at_event = "between the two times of an event, or next to it";
const std::string past_last_sample = "between an event and the samples of the phase";
const std::string other_phase = "in another phase";
const std::string not_in_data_set = "without an event of the data set";
const std::string near_threshold = "too near to the threshold, where a mesh may decide otherwise";
const std::string between_samples = "between the samples of the data set, to which they are interpolated";

// --- sequences of events

std::vector<TabulatedEvent> events_of(const data::ReferenceTable& table, const Rows& rows) {
  const auto& change = table.column("change");
  const auto& time = table.column("time");
  const auto radius = table.radius_of("time");
  std::vector<TabulatedEvent> events;
  for (const std::size_t row : rows)
    events.push_back({change.text[row], time.values[row], radius[row], row, events.size() + 1});
  return events;
}

// The events without grazing contacts, because these do not change the phase.
std::vector<TabulatedEvent> events_of(const data::UserTable& table, const Rows& rows) {
  const data::Column& change = *table.column("change");
  std::vector<std::string> changes{"onset", "capture", "reversal", "graze"};
  if (std::ranges::count(change.field.allowed, "state") > 0) changes.emplace_back("state");
  std::vector<TabulatedEvent> events;
  for (const std::size_t row : rows) {
    if (std::ranges::find(changes, change.text[row]) == changes.end())
      throw InputError(fmt::format("{}: change is '{}', but must be one of {}", table.place(row),
                                   change.text[row], fmt::join(changes, ", ")));
    if (change.text[row] != "graze")
      events.push_back({change.text[row], table.column("time")->values[row], 0.0, row, events.size() + 1});
  }
  return events;
}

// The user's events without short phases. A data set that leaves them out and has no reversal takes a reversal for one.
std::vector<TabulatedEvent> comparable_events(const std::vector<TabulatedEvent>& reference,
                                              std::vector<TabulatedEvent> theirs, double shortest_phase) {
  if (shortest_phase > 0.0 && std::ranges::count(reference, "reversal", &TabulatedEvent::change) == 0)
    std::erase_if(theirs, [](const TabulatedEvent& event) { return event.change == "reversal"; });
  return without_short_phases(theirs, shortest_phase);
}

// "1:3,7", of numbers that increase.
std::string ranges_of(const Rows& numbers) {
  std::string text;
  for (std::size_t first = 0, next = 0; first < numbers.size(); first = next) {
    for (next = first + 1; next < numbers.size() && numbers[next] == numbers[next - 1] + 1;) ++next;
    text += fmt::format("{}{}", text.empty() ? "" : ",", numbers[first]);
    if (next > first + 1) text += fmt::format(":{}", numbers[next - 1]);
  }
  return text;
}

// A time interval in which the reference and the user's result are, or may be, in different phases.
struct Window {
  double from{}, to{};
};

// --- the comparison

class Comparer {
 public:
  Comparer(const Reference& reference, const data::UserTable& theirs, const Settings& settings)
      : settings_(settings),
        reference_(reference.table),
        reference_events_(reference.events),
        rule_(rule_of(reference_.resource)),
        theirs_(with_keys_of(reference_, theirs, rule_.abscissa)),
        horizon_(std::min(rule_.horizon.value_or(infinity), settings.until.value_or(infinity))) {}

  [[nodiscard]] Comparison run() {
    result_.name = reference_.resource.name;
    result_.title = reference_.resource.title;
    result_.kind = rule_.kind;
    result_.horizon = horizon_;
    add_quantities();
    choose_abscissa();
    groups_ = groups_of(reference_, theirs_, group_columns_);
    require_known_rows();
    sort_reference();
    std::vector<Comparison> parts;
    for (const Group& group : groups_) {
      if (rule_.kind != ComparisonKind::events || groups_.size() == 1 || group.theirs.empty()) continue;
      Comparer part = *this;
      part.groups_ = {group};
      part.judge_groups();
      part.result_.name = group.label;
      parts.push_back(std::move(part.result_));
    }
    judge_groups();
    require_compared();
    for (const Comparison& part : parts) result_.level = std::min(result_.level, part.level);
    result_.parts = std::move(parts);
    return std::move(result_);
  }

 private:
  void judge_groups() {
    if (rule_.kind == ComparisonKind::table) compare_table();
    if (rule_.kind == ComparisonKind::curve) compare_curves();
    if (rule_.kind == ComparisonKind::events) compare_events();
    if (rule_.kind == ComparisonKind::phases) compare_phases();
    conclude();
  }

  // With the words of a table that the rule does not name.
  static data::ComparisonRule rule_of(const data::Resource& resource) {
    if (!resource.comparison)
      throw InputError(fmt::format("the data set {} says nothing of how to compare with it", resource.name));
    data::ComparisonRule rule = *resource.comparison;
    if (rule.kind == ComparisonKind::table)
      for (const data::Field& field : resource.fields)
        if (!field.allowed.empty() && std::ranges::count(resource.primary_key, field.name) == 0 &&
            std::ranges::count(rule.values, field.name, &data::ComparedValue::field) == 0)
          rule.values.push_back({.field = field.name, .norm = Norm::word});
    return rule;
  }

  // --- rows that the file must have

  void require_known_rows() const {
    if (settings_.rows.empty()) return;
    if (rule_.kind != ComparisonKind::table && groups_.size() == 1)
      throw InputError(fmt::format("row numbers are given, but the data set {} is one {}", result_.name,
                                   rule_.kind == ComparisonKind::events ? "sequence" : "curve"));
    for (const auto& [first, last] : settings_.rows)
      if (first < 1 || last < first || last > reference_.rows())
        throw data::FieldError("the range of rows", fmt::format("{}:{}", first, last),
                               fmt::format("within 1:{}", reference_.rows()));
  }

  // How many of these rows the file must have.
  [[nodiscard]] std::size_t needed_of(const Rows& rows) const {
    return static_cast<std::size_t>(std::ranges::count_if(rows, [this](std::size_t row) {
      return settings_.rows.empty() || std::ranges::any_of(settings_.rows, [row](const auto& range) {
               return range.first <= row + 1 && row + 1 <= range.second;
             });
    }));
  }

  // Notes which rows the file has.
  void note_rows(Rows rows) {
    std::ranges::sort(rows);
    for (std::size_t& row : rows) ++row;
    result_.rows = rows.size();
    for (const Group& group : groups_) result_.all_rows += group.reference.size();
    result_.row_numbers = ranges_of(rows);
  }

  // --- compared quantities and tolerances

  [[nodiscard]] double tolerance_of(const data::ComparedValue& value) const {
    double tolerance = value.tolerance;
    // The tolerance of one quantity replaces that for all. Words have only their own.
    for (const std::string& name : {std::string(), value.field})
      if (const auto own = settings_.tolerances.find(name);
          own != settings_.tolerances.end() && (value.norm != Norm::word || !name.empty()))
        tolerance = own->second;
    return tolerance;
  }

  // Of what is counted one tolerance for all says nothing.
  [[nodiscard]] std::size_t required_level_of(const std::string& name, bool is_counted) const {
    const bool has_own =
        settings_.tolerances.contains(name) || (!is_counted && settings_.tolerances.contains(""));
    return has_own ? strict_level : settings_.level;
  }

  void require_known_tolerances() const {
    std::vector<std::string> names;
    for (const data::ComparedValue& value : rule_.values) names.push_back(value.field);
    for (const auto& [quantity, tolerance] : settings_.tolerances) {
      if (!quantity.empty() && std::ranges::find(names, quantity) == names.end())
        throw data::FieldError("the quantity of a tolerance", quantity,
                               fmt::format("one of {}", fmt::join(names, ", ")));
      if (!(tolerance >= 0.0 && std::isfinite(tolerance)))
        throw data::FieldError(quantity.empty() ? "the tolerance" : "the tolerance of " + quantity, tolerance,
                               "a finite number that is not negative");
    }
  }

  void add_quantities() {
    require_known_tolerances();
    for (const data::ComparedValue& value : rule_.values) {
      if (theirs_.column(value.field) == nullptr) {
        result_.remarks.push_back(fmt::format("{} is not in the file and was not compared", value.field));
        continue;
      }
      const bool is_counted = value.norm == Norm::word;
      const std::string unit = is_counted ? "rows" : reference_.resource.field(value.field)->unit;
      Comparison::Quantity quantity = count_of(value.field, unit, value.norm, tolerance_of(value));
      quantity.own_tolerance = value.tolerance;
      quantity.required_level = required_level_of(value.field, is_counted);
      if (!is_counted) quantity.error = quantity.uncertainty = std::nullopt;
      result_.quantities.push_back(std::move(quantity));
    }
  }

  // A data set of the kind table has no abscissa. The last numerical key is used.
  void choose_abscissa() {
    result_.abscissa = rule_.abscissa;
    group_columns_ = data::group_columns(reference_.resource);
    if (rule_.kind == ComparisonKind::events) result_.abscissa = "time";
    if (rule_.kind == ComparisonKind::table) {
      for (const std::string& name : reference_.resource.primary_key)
        if (reference_.resource.field(name)->type != data::FieldType::string) result_.abscissa = name;
      std::erase(group_columns_, result_.abscissa);
    }
    if (!result_.abscissa.empty()) result_.abscissa_unit = reference_.resource.field(result_.abscissa)->unit;
    if (settings_.until && result_.abscissa_unit != "s")
      throw InputError(
          fmt::format("a latest time is given, but the data set {} is not one in time", result_.name));
  }

  // Puts the reference rows of each curve in the order of the abscissa.
  void sort_reference() {
    if (rule_.abscissa.empty()) return;
    const auto& abscissa = reference_.column(rule_.abscissa).values;
    for (Group& group : groups_)
      std::ranges::sort(group.reference, {}, [&](std::size_t row) { return abscissa[row]; });
  }

  void open_series(const Group& group) {
    for (Comparison::Quantity& quantity : result_.quantities)
      quantity.series.emplace_back().group = group.label;
  }

  // The largest |value| of some rows, or the range of their values. All values up to the horizon of the data
  // set count, also if the comparison ends earlier.
  [[nodiscard]] double extent_of(const std::string& field, Norm norm, const Rows& rows) const {
    const auto& values = reference_.column(field).values;
    const double end = rule_.kind == ComparisonKind::table ? infinity : rule_.horizon.value_or(infinity);
    double least = infinity, greatest = -infinity;
    for (const std::size_t row : rows) {
      if (std::isfinite(end) && reference_.column(result_.abscissa).values[row] > end) continue;
      if (!std::isfinite(values[row])) continue;
      least = std::min(least, values[row]);
      greatest = std::max(greatest, values[row]);
    }
    if (least > greatest) return 0.0;
    return norm == Norm::range ? greatest - least : std::max(std::abs(least), std::abs(greatest));
  }

  // The extent of a group. If that is 0, the extent of the whole column. If that is 0 too, one unit.
  [[nodiscard]] double scale_of(const std::string& field, Norm norm, const Group& group) const {
    Rows all(reference_.rows());
    std::iota(all.begin(), all.end(), std::size_t{0});
    for (const Rows& rows : {group.reference, all})
      if (const double extent = extent_of(field, norm, rows); extent > 0.0) return extent;
    return 1.0;
  }

  void skip_in_all(const std::string& reason) {
    for (Comparison::Quantity& quantity : result_.quantities) skip(quantity, reason);
  }

  // --- kind table

  // A row of the reference and the corresponding row of the user.
  struct Pair {
    std::size_t row{}, their_row{};
    Interpolated their_time{};  // of events
  };

  // Compares the values of pairs of rows at the abscissas of the reference.
  void compare_pairs(const Group& group, const std::vector<Pair>& pairs,
                     const std::function<std::string(const Pair&)>& where) {
    for (Comparison::Quantity& quantity : result_.quantities) {
      if (quantity.norm == Norm::word) {
        compare_words(quantity, group, pairs, where);
        continue;
      }
      const auto& values = reference_.column(quantity.name).values;
      const auto& their_values = theirs_.column(quantity.name)->values;
      const auto radius = reference_.radius_of(quantity.name);
      const double scale = scale_of(quantity.name, quantity.norm, group);
      for (const Pair& pair : pairs) {
        const double abscissa = result_.abscissa.empty()
                                    ? static_cast<double>(pair.row + 1)
                                    : reference_.column(result_.abscissa).values[pair.row];
        const bool is_event_time = rule_.kind == ComparisonKind::events && quantity.name == "time";
        judge(quantity,
              {abscissa, is_event_time ? pair.their_time : Interpolated{their_values[pair.their_row], 0.0},
               Interpolated{values[pair.row], radius[pair.row]}},
              scale, where(pair));
      }
    }
  }

  // Whether the value that decides a word is too near to its threshold for the word to count.
  [[nodiscard]] bool is_near_threshold(const data::ComparedValue& word, std::size_t row,
                                       const Group& group) const {
    if (!word.decided_by) return false;
    const auto& [field, threshold] = *word.decided_by;
    const auto& deciding = *std::ranges::find(rule_.values, field, &data::ComparedValue::field);
    const double value = reference_.column(field).values[row];
    const double unit = unit_of(deciding.norm, value, scale_of(field, deciding.norm, group));
    return std::abs(value - threshold) <= tolerance_of(deciding) * unit + reference_.radius_of(field)[row];
  }

  void compare_words(Comparison::Quantity& quantity, const Group& group, const std::vector<Pair>& pairs,
                     const std::function<std::string(const Pair&)>& where) const {
    const auto& rule = *std::ranges::find(rule_.values, quantity.name, &data::ComparedValue::field);
    const auto& words = reference_.column(quantity.name).text;
    for (const Pair& pair : pairs) {
      const std::string& theirs = theirs_.column(quantity.name)->text[pair.their_row];
      if (std::ranges::find(words, theirs) == words.end())
        throw InputError(fmt::format("{}: {} is '{}', but must be one of {}", theirs_.place(pair.their_row),
                                     quantity.name, theirs,
                                     fmt::join(std::set<std::string>(words.begin(), words.end()), ", ")));
      if (is_near_threshold(rule, pair.row, group)) {
        skip(quantity, near_threshold);
        continue;
      }
      ++quantity.compared;
      if (theirs != words[pair.row])
        count(quantity, fmt::format("{} ({} in the data set)", where(pair), words[pair.row]));
    }
  }

  void compare_table() {
    const auto& key = reference_.resource.primary_key;
    std::vector<std::string> missing;
    Rows present;
    std::size_t needed = 0;
    for (const Group& group : groups_) {
      open_series(group);
      Rows absent = group.reference;
      std::vector<Pair> pairs;
      for (const std::size_t their_row : group.theirs) {
        const auto found = std::ranges::find_if(absent, [&](std::size_t row) {
          return are_alike(reference_.columns, row, theirs_.columns, their_row, key);
        });
        if (found == absent.end()) throw_unknown_row(reference_, theirs_, key, their_row);
        pairs.push_back({*found, their_row});
        absent.erase(found);
      }
      compare_pairs(group, pairs, [&](const Pair& pair) { return label_of(reference_, key, pair.row); });
      for (const std::size_t row : absent) missing.push_back(label_of(reference_, key, row));
      for (const Pair& pair : pairs) present.push_back(pair.row);
      needed += needed_of(group.reference);
    }
    result_.coverage = static_cast<double>(needed_of(present)) / static_cast<double>(needed);
    note_rows(std::move(present));
    note_missing(std::move(missing));
  }

  void note_missing(std::vector<std::string> labels) {
    if (labels.empty()) return;
    constexpr std::size_t shown = 5;
    const std::size_t rows = labels.size();
    labels.resize(std::min(rows, shown));
    result_.remarks.push_back(fmt::format("{} of {} rows of the data set are not in the file: {}{}", rows,
                                          reference_.rows(), fmt::join(labels, "; "),
                                          rows > shown ? fmt::format(" and {} more", rows - shown) : ""));
  }

  // --- kind curve

  [[nodiscard]] Samples samples_of(const std::string& field, const Rows& rows) const {
    const auto& abscissa = reference_.column(rule_.abscissa).values;
    const auto& values = reference_.column(field).values;
    const auto radius = reference_.radius_of(field);
    Samples samples;
    for (const std::size_t row : rows) {
      samples.abscissa.push_back(abscissa[row]);
      samples.values.push_back(values[row]);
      samples.half_width.push_back(radius[row]);
    }
    return samples;
  }

  // The user's samples, without a second one at the same abscissa.
  [[nodiscard]] Samples their_samples_of(const Comparison::Quantity& quantity, const Rows& rows,
                                         double scale) const {
    const auto& abscissa = theirs_.column(rule_.abscissa)->values;
    const auto& values = theirs_.column(quantity.name)->values;
    Samples samples;
    for (const std::size_t row : rows) {
      if (!samples.abscissa.empty() && samples.abscissa.back() == abscissa[row]) {
        const double step = std::abs(values[row] - samples.values.back());
        if (rule_.kind == ComparisonKind::curve && step > allowed_error(quantity, values[row], scale))
          throw InputError(fmt::format(
              "{}: {} is {} as in the row before, but {} is {} there and {} here; it must be the same to the "
              "tolerance of {:g}",
              theirs_.place(row), rule_.abscissa, theirs_.column(rule_.abscissa)->text[row], quantity.name,
              shortest_text(samples.values.back()), shortest_text(values[row]), quantity.tolerance));
        continue;
      }
      samples.abscissa.push_back(abscissa[row]);
      samples.values.push_back(values[row]);
      samples.half_width.push_back(0.0);
    }
    return samples;
  }

  // The abscissas of a group of the reference.
  struct Grid {
    double first{}, last{};
    double spacing{};      // the mean distance of the samples
    double coincidence{};  // abscissas with a smaller distance are considered equal
  };

  [[nodiscard]] Grid grid_of(const Group& group) const {
    constexpr double relative = 1e-9;
    const auto& abscissa = reference_.column(rule_.abscissa).values;
    const double first = abscissa[group.reference.front()], last = abscissa[group.reference.back()];
    return {.first = first,
            .last = last,
            .spacing = (last - first) / std::max(1.0, static_cast<double>(group.reference.size()) - 1.0),
            .coincidence = relative * (last - first)};
  }

  [[nodiscard]] std::string where_of(const Group& group, double abscissa) const {
    return fmt::format("{} = {:.9g}{}{}{}", rule_.abscissa, abscissa,
                       result_.abscissa_unit.empty() ? "" : " ", result_.abscissa_unit,
                       group.label.empty() ? "" : ", " + group.label);
  }

  void compare_samples(Comparison::Quantity& quantity, const Group& group, const Rows& rows,
                       const Rows& their_rows, const Grid& grid) {
    if (their_rows.empty()) return;
    const double scale = scale_of(quantity.name, quantity.norm, group);
    const Samples reference = samples_of(quantity.name, rows);
    const Samples theirs = their_samples_of(quantity, their_rows, scale);
    const ComparedSamples found =
        rule_.interpolation
            ? by_stated_interpolation(reference, theirs, *rule_.interpolation,
                                      rule_.interpolation->error.at(quantity.name), grid.coincidence)
            : by_own_interpolation(reference, theirs, grid.spacing, grid.coincidence);
    for (std::size_t i = 0; i < found.between; ++i) skip(quantity, between_samples);
    for (std::size_t i = 0; i < found.past_last; ++i) skip(quantity, past_last_sample);
    for (const ComparedSample& point : found.points)
      judge(quantity, point, scale, where_of(group, point.abscissa));
  }

  // The user's rows of a group up to the horizon and in the range of the reference. The others are counted as
  // skipped.
  [[nodiscard]] Rows comparable_rows(const Group& group, const Grid& grid) {
    const auto& abscissa = theirs_.column(rule_.abscissa)->values;
    warn_if_unit_differs(abscissa[group.theirs.back()], grid.last);
    Rows rows;
    for (const std::size_t row : group.theirs) {
      const double x = abscissa[row];
      if (x > horizon_)
        skip_in_all(beyond_horizon);
      else if (x < grid.first - grid.coincidence || x > grid.last + grid.coincidence)
        skip_in_all(outside_range);
      else
        rows.push_back(row);
    }
    return rows;
  }

  // Says so if the file goes so far that its abscissa may have another unit, such as ms for s.
  void warn_if_unit_differs(double last, double last_reference) {
    constexpr double suspicious = 100.0;
    if (!doubt_.empty() || !(last >= suspicious * last_reference) || !(last_reference > 0.0)) return;
    const std::string& unit = result_.abscissa_unit;
    doubt_ = fmt::format(
        "{0} goes up to {1:g}{2}{3} in the file and up to {4:g}{2}{3} in the data set: has it another unit?",
        result_.abscissa, last, unit.empty() ? "" : " ", unit, last_reference);
    result_.remarks.push_back(doubt_);
  }

  // The groups of which the file has rows. A remark names the others.
  [[nodiscard]] std::vector<Group> begun_groups() {
    std::vector<Group> begun;
    Rows rows;
    for (const Group& group : groups_) {
      if (group.theirs.empty()) {
        result_.remarks.push_back(fmt::format("{} is not in the file and was not compared", group.label));
        if (needed_of(group.reference) > 0) result_.coverage = 0.0;
        continue;
      }
      rows.insert(rows.end(), group.reference.begin(), group.reference.end());
      begun.push_back(group);
    }
    note_rows(std::move(rows));
    return begun;
  }

  // The share of the range of the abscissa, up to the horizon, that has compared points in all quantities. A
  // point covers a fortieth of the range on either side of it.
  void cover_range(const Group& group, const Grid& grid) {
    const double last = std::min(grid.last, horizon_), range = last - grid.first, reach = range / 40.0;
    result_.required_coverage = least_range_coverage;
    if (!(range > 0.0)) return;
    double least = 1.0;
    for (const Comparison::Quantity& quantity : result_.quantities) {
      double covered = 0.0, end = grid.first;
      for (const double x : quantity.series.back().abscissa) {
        const double begin = std::max(end, x - reach);
        end = std::max(end, std::min(last, x + reach));
        covered += std::max(0.0, end - begin);
      }
      least = std::min(least, covered / range);
    }
    result_.coverage = std::min(result_.coverage, least);
    if (least < least_range_coverage)
      result_.remarks.push_back(fmt::format(
          "the file covers {:.0f} % of {} from {:g} to {:g}{}{}{}, but a verdict needs at least {:g} %{}",
          std::floor(100.0 * least), rule_.abscissa, grid.first, last,
          result_.abscissa_unit.empty() ? "" : " " + result_.abscissa_unit, group.label.empty() ? "" : " of ",
          group.label, 100.0 * least_range_coverage,
          result_.abscissa_unit == "s" ? "; --until ends the comparison earlier" : ""));
  }

  void compare_curves() {
    for (const Group& group : begun_groups()) {
      open_series(group);
      const Grid grid = grid_of(group);
      const Rows their_rows = comparable_rows(group, grid);
      for (Comparison::Quantity& quantity : result_.quantities)
        compare_samples(quantity, group, group.reference, their_rows, grid);
      cover_range(group, grid);
    }
  }

  // --- kind events

  // The tolerance of event times, s. The rule may define it relative to the latest time that is compared.
  [[nodiscard]] double time_tolerance(const data::ComparisonRule& rule,
                                      const std::vector<TabulatedEvent>& events) const {
    const double latest = events.empty() ? 0.0 : std::min(horizon_, events.back().time);
    for (const data::ComparedValue& value : rule.values) {
      if (value.field != "time") continue;
      // The user's tolerances belong to the data set that is compared, not to the events of a history.
      const double tolerance = &rule == &rule_ ? tolerance_of(value) : value.tolerance;
      return value.norm == Norm::absolute ? tolerance : tolerance * latest;
    }
    return 0.0;
  }

  // Counts the events without a partner and names the first of them.
  void note_difference(Comparison::Quantity& sequence, const Group& group, const SequenceMatch& found,
                       const std::vector<TabulatedEvent>& events,
                       const std::vector<TabulatedEvent>& their_events) {
    constexpr std::size_t shown = 8;
    const std::string prefix = group.label.empty() ? "" : group.label + ": ";
    std::size_t notes = 0;
    const auto note = [&](const std::string& sentence) {
      count(sequence, sentence);
      if (++notes <= shown) result_.remarks.push_back(prefix + sentence);
    };
    sequence.compared += found.pairs.size() + found.missing.size() + found.unreached;
    for (const std::size_t i : found.missing)
      note(fmt::format("{} is missing in the file", description(events[i])));
    for (const std::size_t i : found.extra)
      note(fmt::format("{} of the file is not in the data set", description(their_events[i])));
    if (notes > shown)
      result_.remarks.push_back(prefix + fmt::format("{} events are missing or not in the data set", notes));
    if (found.unreached == 0) return;
    sequence.undecided += found.unreached;
    if (sequence.agreement == Agreement::agrees) sequence.agreement = Agreement::undecided;
    if (sequence.where.empty()) sequence.where = "the end of the file";
  }

  // The user's run ends with its last event, unless a latest time is given.
  void note_unreached(const Group& group, const SequenceMatch& found,
                      const std::vector<TabulatedEvent>& events, double end) {
    result_.required_coverage = least_range_coverage;
    if (found.unreached == 0) return;
    const auto last = std::ranges::upper_bound(events, horizon_, {}, &TabulatedEvent::time) - 1;
    result_.coverage = std::min(result_.coverage, end / last->time);
    result_.remarks.push_back(fmt::format(
        "{}the file ends at {:.9g} s, and the data set has {} more event{} up to {:.9g} s; --until says how "
        "far your run goes",
        group.label.empty() ? "" : group.label + ": ", end, found.unreached, found.unreached == 1 ? "" : "s",
        last->time));
  }

  void compare_events() {
    Comparison::Quantity sequence = count_of("sequence", "events");
    for (const Group& group : begun_groups()) {
      open_series(group);
      const auto events = without_short_phases(events_of(reference_, group.reference), rule_.shortest_phase);
      const auto their_events =
          comparable_events(events, events_of(theirs_, group.theirs), rule_.shortest_phase);
      const double last = theirs_.column("time")->values[group.theirs.back()];
      warn_if_unit_differs(last, reference_.column("time").values[group.reference.back()]);
      const double end = settings_.until ? infinity : last;
      const SequenceMatch found = match(events, their_events, {horizon_, end, time_tolerance(rule_, events)});
      note_difference(sequence, group, found, events, their_events);
      note_unreached(group, found, events, end);
      std::vector<Pair> pairs;
      for (const auto& [i, j] : found.pairs)
        pairs.push_back(
            {events[i].row, their_events[j].row, {their_events[j].time, their_events[j].time_radius}});
      compare_pairs(group, pairs, [&](const Pair& pair) {
        return description(*std::ranges::find(events, pair.row, &TabulatedEvent::row)) +
               (group.label.empty() ? "" : ", " + group.label);
      });
      for (std::size_t i = 0; i < found.beyond; ++i) skip_in_all(beyond_horizon);
      for (std::size_t i = 0; i < found.extra.size(); ++i) skip_in_all(not_in_data_set);
    }
    result_.quantities.insert(result_.quantities.begin(), std::move(sequence));
  }

  // --- kind phases

  // The events that belong to a group of a history, from a table of events with the same columns.
  template <class Table>
  [[nodiscard]] std::vector<TabulatedEvent> events_in(const Table& table, const Group& group) const {
    Rows rows;
    for (std::size_t row = 0; row < table.rows(); ++row)
      if (are_alike(reference_.columns, group.reference.front(), table.columns, row, group_columns_))
        rows.push_back(row);
    return events_of(table, rows);
  }

  // The number of events up to the time t. Samples with the same number are in the same phase.
  static std::size_t phase_number(const std::vector<TabulatedEvent>& events, double t) {
    return static_cast<std::size_t>(std::ranges::upper_bound(events, t, {}, &TabulatedEvent::time) -
                                    events.begin());
  }

  // The larger of the distances to the two neighbouring samples.
  [[nodiscard]] double sampling_distance(const Rows& rows, std::size_t index) const {
    const auto& t = theirs_.column(rule_.abscissa)->values;
    double distance = 0.0;
    if (index > 0) distance = t[rows[index]] - t[rows[index - 1]];
    if (index + 1 < rows.size()) distance = std::max(distance, t[rows[index + 1]] - t[rows[index]]);
    return distance;
  }

  // The events of a group of a history. The user's are unknown if their file is not given.
  struct Events {
    std::vector<TabulatedEvent> reference;
    std::optional<std::vector<TabulatedEvent>> theirs;
    std::vector<Window> windows;  // around the events, in which the phases may differ
    double guard{};             // how far an event of the user may be from that of the reference, if unknown
    double shortest{infinity};  // distance of two events of the reference
  };

  // The interval of a pair extends from one time to the other.
  static std::vector<Window> windows_between(const Events& events, const SequenceMatch& found) {
    std::vector<Window> windows;
    for (const TabulatedEvent& event : events.reference)
      windows.push_back({event.time - event.time_radius, event.time + event.time_radius});
    for (const auto& [i, j] : found.pairs) {
      const TabulatedEvent& theirs = (*events.theirs)[j];
      windows[i].from = std::min(windows[i].from, theirs.time - theirs.time_radius);
      windows[i].to = std::max(windows[i].to, theirs.time + theirs.time_radius);
    }
    return windows;
  }

  // The samples in the phase with this number, without samples that may be on the other side of an event.
  [[nodiscard]] Rows rows_in_phase(const Group& group, const std::vector<TabulatedEvent>& events,
                                   std::size_t phase) const {
    const auto& abscissa = reference_.column(rule_.abscissa).values;
    Rows rows;
    for (const std::size_t row : group.reference) {
      const double t = abscissa[row];
      const bool is_certain = std::ranges::none_of(
          events, [t](const TabulatedEvent& event) { return std::abs(t - event.time) <= event.time_radius; });
      if (is_certain && phase_number(events, t) == phase) rows.push_back(row);
    }
    return rows;
  }

  [[nodiscard]] std::string their_phase(std::size_t their_row) const {
    const data::Column* column = theirs_.column("phase");
    if (column == nullptr) return "";
    const std::string& word = column->text[their_row];
    if (word != "stick" && word != "slip")
      throw InputError(
          fmt::format("{}: phase is '{}', but must be stick or slip", theirs_.place(their_row), word));
    return word;
  }

  [[nodiscard]] Events find_events(const data::ReferenceTable& table, const Group& group,
                                   Comparison::Quantity& sequence) {
    const data::ComparisonRule& rule = *table.resource.comparison;
    Events events;
    events.reference = without_short_phases(events_in(table, group), rule.shortest_phase);
    events.guard = time_tolerance(rule, events.reference);
    SequenceMatch found;
    if (settings_.events) {
      events.theirs =
          comparable_events(events.reference, events_in(*settings_.events, group), rule.shortest_phase);
      const double end = theirs_.column(rule_.abscissa)->values[group.theirs.back()];
      found = match(events.reference, *events.theirs, {horizon_, end, events.guard});
      found.unreached = 0;  // the coverage of the history tells it
      note_difference(sequence, group, found, events.reference, *events.theirs);
    }
    for (std::size_t i = 1; i < events.reference.size(); ++i)
      events.shortest = std::min(events.shortest, events.reference[i].time - events.reference[i - 1].time);
    events.windows = windows_between(events, found);
    return events;
  }

  void compare_phases() {
    const data::ReferenceTable& table = reference_events_.value();
    Comparison::Quantity phase = count_of("phase", "samples"), sequence = count_of("sequence", "events");
    for (const Group& group : begun_groups()) {
      open_series(group);
      const Events events = find_events(table, group, sequence);
      const Grid grid = grid_of(group);
      std::vector<Rows> rows;
      for (std::size_t number = 0; number <= events.reference.size(); ++number)
        rows.push_back(rows_in_phase(group, events.reference, number));
      const auto their_rows = their_rows_by_phase(group, grid, events, rows, phase);
      for (Comparison::Quantity& quantity : result_.quantities)
        for (std::size_t number = 0; number < rows.size(); ++number)
          compare_samples(quantity, group, rows[number], their_rows[number], grid);
      cover_range(group, grid);
    }
    if (theirs_.column("phase") != nullptr)
      result_.quantities.insert(result_.quantities.begin(), std::move(phase));
    if (settings_.events) result_.quantities.insert(result_.quantities.begin(), std::move(sequence));
  }

  // The user's rows in each phase of the reference, without those in another phase or near to an event.
  [[nodiscard]] std::vector<Rows> their_rows_by_phase(const Group& group, const Grid& grid,
                                                      const Events& events, const std::vector<Rows>& rows,
                                                      Comparison::Quantity& phase) {
    const auto &abscissa = reference_.column(rule_.abscissa).values,
               &times = theirs_.column(rule_.abscissa)->values;
    const Rows comparable = comparable_rows(group, grid);
    std::vector<Rows> by_phase(rows.size());
    for (std::size_t i = 0; i < comparable.size(); ++i) {
      const std::size_t their_row = comparable[i];
      const double t = times[their_row];
      // Their steps may be as long as their sampling distance, but not longer than the shortest phase.
      const double step = std::min(events.shortest, sampling_distance(comparable, i));
      const double guard = events.theirs ? 0.0 : std::max(events.guard, step);
      const bool is_at_event = std::ranges::any_of(events.windows, [&](const Window& window) {
        return t >= window.from - guard && t <= window.to + guard;
      });
      if (is_at_event) {
        skip_in_all(at_event);
        continue;
      }
      if (events.theirs && contact_at(events.reference, t) != contact_at(*events.theirs, t)) {
        skip_in_all(other_phase);
        continue;
      }
      const std::size_t number = phase_number(events.reference, t);
      const Rows& samples = rows[number];
      if (samples.empty() || t < abscissa[samples.front()] - grid.coincidence ||
          t > abscissa[samples.back()] + grid.coincidence) {
        skip_in_all(past_last_sample);
        continue;
      }
      if (is_in_phase(group, their_row, t, reference_.column("phase").text[samples.front()], phase))
        by_phase[number].push_back(their_row);
      else
        skip_in_all(other_phase);
    }
    return by_phase;
  }

  // Compares the phase of a row with that of the reference, if the file has one.
  [[nodiscard]] bool is_in_phase(const Group& group, std::size_t their_row, double t, const std::string& word,
                                 Comparison::Quantity& phase) {
    const std::string their_word = their_phase(their_row);
    if (their_word.empty()) return true;
    ++phase.compared;
    if (their_word == word) return true;
    count(phase, fmt::format("{} ({} in the data set)", where_of(group, t), word));
    return false;
  }

  // --- result

  void conclude() {
    const bool is_covered = result_.coverage >= result_.required_coverage;
    if (!is_covered) result_.agreement = Agreement::undecided;
    result_.level = is_covered ? strict_level : 0;
    result_.required_level = settings_.level;
    for (Comparison::Quantity& quantity : result_.quantities) {
      std::erase_if(quantity.series,
                    [](const Comparison::Series& series) { return series.abscissa.empty(); });
      if (quantity.compared == 0 && quantity.agreement == Agreement::agrees)
        quantity.agreement = Agreement::undecided;
      const bool is_counted = quantity.series.empty() && quantity.compared > 0;
      if (is_counted) quantity.scaled_error = *quantity.error / static_cast<double>(quantity.compared);
      quantity.level = level_of(quantity);
      if (is_counted) accept_share(quantity);
      result_.level = std::min(result_.level, quantity.level);
      if (quantity.agreement == Agreement::differs)
        result_.agreement = Agreement::differs;
      else if (quantity.agreement == Agreement::undecided && result_.agreement == Agreement::agrees)
        result_.agreement = Agreement::undecided;
    }
  }

  // What is counted agrees as well if the share that is wrong keeps the level that is asked for.
  void accept_share(Comparison::Quantity& quantity) const {
    quantity.required_level = required_level_of(quantity.name, true);
    if (quantity.required_level < strict_level && quantity.level >= quantity.required_level)
      quantity.agreement = quantity.undecided > 0 ? Agreement::undecided : Agreement::agrees;
  }

  void require_compared() const {
    if (std::ranges::any_of(result_.quantities, [](const auto& quantity) { return quantity.compared > 0; }))
      return;
    std::string reasons;
    for (const auto& [reason, points] : result_.quantities.back().skipped)
      reasons += fmt::format("{}{} {}", reasons.empty() ? ": " : ", ", points, reason);
    throw InputError(fmt::format("{}: none of the {} rows can be compared{}{}{}", theirs_.file.string(),
                                 theirs_.rows(), reasons, doubt_.empty() ? "" : "; ", doubt_));
  }

  const Settings& settings_;
  const data::ReferenceTable& reference_;
  const std::optional<data::ReferenceTable>& reference_events_;
  const data::ComparisonRule rule_;
  const data::UserTable theirs_;
  const double horizon_;
  std::vector<std::string> group_columns_;
  std::vector<Group> groups_;
  std::string doubt_;  // about the unit of the abscissa
  Comparison result_;
};

}  // namespace

Reference read_reference(const data::ReferencePackage& package, const std::string& name) {
  Reference reference{.table = data::read_table(package, name)};
  if (const auto& rule = reference.table.resource.comparison; rule && rule->kind == ComparisonKind::phases)
    reference.events = data::read_table(package, rule->events);
  return reference;
}

Reference own_run(const std::filesystem::path& file, bool is_quoted) {
  data::ReferenceTable table;
  data::Resource& resource = table.resource;
  resource.name = file.string();
  resource.title = "a run of one's own";
  resource.primary_key = {"time"};
  data::ComparisonRule& rule = resource.comparison.emplace();
  rule.kind = ComparisonKind::curve;
  rule.abscissa = "time";
  const auto add = [&](const std::string& name, const std::string& unit) {
    data::Field& field = table.columns.emplace_back().field;
    field.name = name;
    field.type = data::FieldType::number;
    field.unit = unit;
    resource.fields.push_back(field);
  };
  add("time", "s");
  for (const std::string name : {"tip_displacement", "midspan_displacement"}) {
    add(name, "m");
    rule.values.push_back({name, data::Norm::range, 0.01});
  }
  const data::UserTable run = data::read_user_table(file, table, {}, {}, is_quoted);
  std::erase_if(rule.values,
                [&](const data::ComparedValue& value) { return run.column(value.field) == nullptr; });
  table.columns = run.columns;
  return {.table = table};
}

Comparison compare(const Reference& reference, const data::UserTable& theirs, const Settings& settings) {
  return Comparer(reference, theirs, settings).run();
}

}  // namespace stickslip::comparison
