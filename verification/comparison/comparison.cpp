// SPDX-License-Identifier: MIT
#include "comparison/comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <utility>

#include "comparison/event_sequence.hpp"
#include "stickslip/data/case_file.hpp"

namespace stickslip::studies {

namespace {

using data::ComparisonKind;
using data::InputError;
using data::Norm;
using data::shortest_text;
using Rows = std::vector<std::size_t>;

constexpr double infinity = std::numeric_limits<double>::infinity();

const std::string beyond_horizon = "beyond the horizon";
const std::string outside_range = "outside the range of the data set";
const std::string no_value = "without a value in the data set";
const std::string at_event = "between the two times of an event, or next to it";
const std::string past_last_sample = "between an event and the samples of the phase";
const std::string other_phase = "in another phase";
const std::string after_difference = "after the first event that differs";

// --- comparison of points

// One point of one quantity, in the unit of the quantity.
struct Point {
  double abscissa{}, theirs{}, reference{}, half_width{};
  std::string where;
};

// The divisor that converts an error to the norm of the quantity.
double unit_of(Norm norm, double reference, double scale) {
  switch (norm) {
    case Norm::relative:
      return std::abs(reference);
    case Norm::scale:
    case Norm::range:
      return scale;
    case Norm::absolute:
      break;
  }
  return 1.0;
}

// |x| in a norm. For x = 0 the result is 0 even if the divisor is 0; for other x it is then infinite.
double measured(double x, Norm norm, double reference, double scale) {
  return x == 0.0 ? 0.0 : std::abs(x) / unit_of(norm, reference, scale);
}

// The difference between an error and the uncertainty.
double excess(double error, double uncertainty) {
  return std::isfinite(uncertainty) ? error - uncertainty : -infinity;
}

void skip(Comparison::Quantity& quantity, const std::string& reason) {
  const auto known = std::ranges::find(quantity.skipped, reason, &Comparison::Skipped::reason);
  if (known == quantity.skipped.end())
    quantity.skipped.push_back({reason, 1});
  else
    ++known->points;
}

// Adds the point to the last series and updates the result of the quantity. Returns whether the point
// differs.
bool judge(Comparison::Quantity& quantity, const Point& point, double scale) {
  Comparison::Series& series = quantity.series.back();
  series.abscissa.push_back(point.abscissa);
  series.theirs.push_back(point.theirs);
  series.reference.push_back(point.reference);
  series.half_width.push_back(point.half_width);
  series.allowed.push_back(point.half_width +
                           quantity.tolerance * unit_of(quantity.norm, point.reference, scale));
  ++quantity.compared;

  const double error = measured(point.theirs - point.reference, quantity.norm, point.reference, scale);
  const double uncertainty = measured(point.half_width, quantity.norm, point.reference, scale);
  const bool differs = error > quantity.tolerance + uncertainty;
  const bool undecided = !differs && uncertainty > quantity.tolerance;
  quantity.undecided += undecided ? 1 : 0;
  if (differs)
    quantity.agreement = Agreement::differs;
  else if (undecided && quantity.agreement == Agreement::agrees)
    quantity.agreement = Agreement::undecided;
  if (!quantity.error || excess(error, uncertainty) > excess(*quantity.error, *quantity.uncertainty)) {
    quantity.error = error;
    quantity.uncertainty = uncertainty;
    quantity.where = point.where;
  }
  return differs;
}

// A quantity that counts deviations, such as additional or missing events.
Comparison::Quantity count_of(const std::string& name, const std::string& unit) {
  return {.name = name,
          .unit = unit,
          .norm = Norm::absolute,
          .tolerance = 0.0,
          .error = 0.0,
          .uncertainty = 0.0,
          .where = {},
          .agreement = Agreement::agrees,
          .compared = 0,
          .undecided = 0,
          .skipped = {},
          .series = {}};
}

void count(Comparison::Quantity& quantity, const std::string& where) {
  if (quantity.error == 0.0) quantity.where = where;
  *quantity.error += 1.0;
  quantity.agreement = Agreement::differs;
}

// --- groups of rows

// The rows of one curve or one sequence, in the reference and in the user's table.
struct Group {
  std::string label;
  Rows reference, theirs;
  bool differs{};  // whether its events, its phases or the quantity of the diagnosis differ
};

bool is_same_cell(const data::Column& a, std::size_t i, const data::Column& b, std::size_t j) {
  return a.field.type == data::FieldType::string ? a.text[i] == b.text[j]
                                                 : data::is_same_key(a.values[i], b.values[j]);
}

class Matcher {
 public:
  Matcher(const data::ReferenceTable& reference, const data::UserTable& theirs)
      : reference_(reference), theirs_(theirs) {}

  [[nodiscard]] bool matches(const std::vector<std::string>& columns, std::size_t row,
                             std::size_t their_row) const {
    return std::ranges::all_of(columns, [&](const std::string& name) {
      return is_same_cell(reference_.column(name), row, *theirs_.column(name), their_row);
    });
  }

  // For example "beam = paper, mode = 3".
  [[nodiscard]] std::string label(const std::vector<std::string>& columns, std::size_t row) const {
    return label_of(columns, [&](const std::string& name) { return reference_.column(name).text[row]; });
  }

  [[noreturn]] void throw_unknown_row(const std::vector<std::string>& columns, std::size_t their_row) const {
    const auto cell = [&](const std::string& name) { return theirs_.column(name)->text[their_row]; };
    throw InputError(fmt::format("{}: {} is not in the data set {}", theirs_.place(their_row),
                                 label_of(columns, cell), reference_.resource.name));
  }

  [[nodiscard]] std::vector<Group> groups(const std::vector<std::string>& columns) const {
    std::vector<Group> list;
    for (std::size_t row = 0; row < reference_.rows(); ++row) {
      const auto known = std::ranges::find_if(list, [&](const Group& group) {
        return std::ranges::all_of(columns, [&](const std::string& name) {
          const data::Column& column = reference_.column(name);
          return is_same_cell(column, group.reference.front(), column, row);
        });
      });
      if (known == list.end())
        list.push_back({.label = label(columns, row), .reference = {row}, .theirs = {}});
      else
        known->reference.push_back(row);
    }
    if (list.size() == 1) list.front().label.clear();
    for (std::size_t row = 0; row < theirs_.rows(); ++row) {
      const auto group = std::ranges::find_if(
          list, [&](const Group& one) { return matches(columns, one.reference.front(), row); });
      if (group == list.end()) throw_unknown_row(columns, row);
      group->theirs.push_back(row);
    }
    return list;
  }

 private:
  template <class Cell>
  static std::string label_of(const std::vector<std::string>& columns, const Cell& cell) {
    std::string text;
    for (const std::string& name : columns)
      text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, cell(name));
    return text;
  }

  const data::ReferenceTable& reference_;
  const data::UserTable& theirs_;
};

// --- interpolation of the reference

struct Samples {
  std::vector<double> abscissa, values, half_width;
};

struct Interpolated {
  double value{}, half_width{};
};

// The sample at x, or else the interpolation polynomial through the nearest order + 1 samples; empty if there
// are too few samples.
std::optional<Interpolated> value_at(const Samples& samples, double x, double coincidence,
                                     const data::Interpolation* interpolation, double error_bound) {
  const auto& xs = samples.abscissa;
  const auto next = static_cast<std::size_t>(std::ranges::lower_bound(xs, x - coincidence) - xs.begin());
  if (next < xs.size() && std::abs(xs[next] - x) <= coincidence)
    return Interpolated{samples.values[next], samples.half_width[next]};
  if (interpolation == nullptr) return std::nullopt;
  const auto points = static_cast<std::size_t>(interpolation->order) + 1;
  if (xs.size() < points) return std::nullopt;
  const std::size_t first = std::min(next - std::min(next, points / 2), xs.size() - points);
  Interpolated result{.value = 0.0, .half_width = error_bound};
  for (std::size_t i = first; i < first + points; ++i) {
    double weight = 1.0;
    for (std::size_t j = first; j < first + points; ++j)
      if (j != i) weight *= (x - xs[j]) / (xs[i] - xs[j]);
    result.value += weight * samples.values[i];
    result.half_width += std::abs(weight) * samples.half_width[i];
  }
  return result;
}

// --- sequences of events

std::vector<TabulatedEvent> events_of(const data::ReferenceTable& table, const Rows& rows) {
  const auto& change = table.column("change");
  const auto& time = table.column("time");
  const auto radius = table.radius_of("time");
  std::vector<TabulatedEvent> events;
  for (const std::size_t row : rows) events.push_back({change.text[row], time.values[row], radius[row], row});
  return events;
}

// The events without grazing contacts, because these do not change the phase.
std::vector<TabulatedEvent> events_of(const data::UserTable& table, const Rows& rows) {
  constexpr std::array<std::string_view, 4> changes{"onset", "capture", "reversal", "graze"};
  const data::Column& change = *table.column("change");
  std::vector<TabulatedEvent> events;
  for (const std::size_t row : rows) {
    if (std::ranges::find(changes, change.text[row]) == changes.end())
      throw InputError(fmt::format("{}: change is '{}', but must be one of {}", table.place(row),
                                   change.text[row], fmt::join(changes, ", ")));
    if (change.text[row] != "graze")
      events.push_back({change.text[row], table.column("time")->values[row], 0.0, row});
  }
  return events;
}

// A time interval in which the reference and the user's result are, or may be, in different phases.
struct Window {
  double from{}, to{};
};

// --- the comparison

class Comparer {
 public:
  Comparer(const data::ReferencePackage& package, const std::string& name, const data::UserTable& theirs,
           const ComparisonSettings& settings)
      : package_(package),
        theirs_(theirs),
        settings_(settings),
        reference_(data::read_table(package, name)),
        rule_(rule_of(reference_.resource)),
        matcher_(reference_, theirs),
        horizon_(std::min(rule_.horizon.value_or(infinity), settings.until.value_or(infinity))) {}

  [[nodiscard]] Comparison run() {
    result_.name = reference_.resource.name;
    result_.title = reference_.resource.title;
    result_.kind = rule_.kind;
    add_quantities();
    choose_abscissa();
    groups_ = matcher_.groups(group_columns_);
    switch (rule_.kind) {
      case ComparisonKind::table:
        compare_table();
        break;
      case ComparisonKind::curve:
        compare_curves();
        break;
      case ComparisonKind::events:
        compare_events();
        break;
      case ComparisonKind::phases:
        compare_phases();
        break;
    }
    conclude();
    if (settings_.diagnose && result_.agreement == Agreement::differs && reference_.resource.diagnosis)
      diagnose();
    return std::move(result_);
  }

 private:
  static const data::ComparisonRule& rule_of(const data::Resource& resource) {
    if (!resource.comparison)
      throw InputError(fmt::format("the data set {} says nothing of how to compare with it", resource.name));
    return *resource.comparison;
  }

  // --- compared quantities and tolerances

  [[nodiscard]] double tolerance_of(const data::ComparedValue& value) const {
    double tolerance = value.tolerance;
    // The tolerance of one quantity replaces that for all.
    for (const std::string& name : {std::string(), value.field})
      for (const auto& [quantity, replacement] : settings_.tolerances)
        if (quantity == name) tolerance = replacement;
    return tolerance;
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
      result_.quantities.push_back({.name = value.field,
                                    .unit = reference_.resource.field(value.field)->unit,
                                    .norm = value.norm,
                                    .tolerance = tolerance_of(value),
                                    .error = {},
                                    .uncertainty = {},
                                    .where = {},
                                    .agreement = Agreement::agrees,
                                    .compared = 0,
                                    .undecided = 0,
                                    .skipped = {},
                                    .series = {}});
    }
  }

  // A data set of the kind table has no abscissa. The abscissa of its diagnosis is used, or else the last
  // numerical key.
  void choose_abscissa() {
    result_.abscissa = rule_.abscissa;
    group_columns_ = data::group_columns(reference_.resource);
    if (rule_.kind == ComparisonKind::events) result_.abscissa = "time";
    if (rule_.kind == ComparisonKind::table) {
      for (const std::string& name : reference_.resource.primary_key)
        if (reference_.resource.field(name)->type != data::FieldType::string) result_.abscissa = name;
      const auto& diagnosis = reference_.resource.diagnosis;
      if (diagnosis && std::ranges::count(reference_.resource.primary_key, diagnosis->abscissa) > 0)
        result_.abscissa = diagnosis->abscissa;
      std::erase(group_columns_, result_.abscissa);
    }
    if (!result_.abscissa.empty()) result_.abscissa_unit = reference_.resource.field(result_.abscissa)->unit;
    if (settings_.until && result_.abscissa_unit != "s")
      throw InputError(
          fmt::format("a latest time is given, but the data set {} is not one in time", result_.name));
  }

  void open_series(const Group& group) {
    for (Comparison::Quantity& quantity : result_.quantities) {
      quantity.series.emplace_back();
      quantity.series.back().group = group.label;
    }
  }

  // The largest |value| of a group, or the range of its values. All values up to the horizon of the data set
  // count, also if the comparison ends earlier.
  [[nodiscard]] double scale_of(const std::string& field, Norm norm, const Group& group) const {
    const auto& values = reference_.column(field).values;
    const double end = rule_.kind == ComparisonKind::table ? infinity : rule_.horizon.value_or(infinity);
    double least = infinity, greatest = -infinity;
    for (const std::size_t row : group.reference) {
      if (std::isfinite(end) && reference_.column(result_.abscissa).values[row] > end) continue;
      if (!std::isfinite(values[row])) continue;
      least = std::min(least, values[row]);
      greatest = std::max(greatest, values[row]);
    }
    if (least > greatest) return 0.0;
    return norm == Norm::range ? greatest - least : std::max(std::abs(least), std::abs(greatest));
  }

  [[nodiscard]] bool is_diagnosed(const std::string& field) const {
    const auto& diagnosis = reference_.resource.diagnosis;
    return diagnosis && diagnosis->value == field;
  }

  // Compares one row of the user with the reference, unless the reference has no value there.
  void judge_at(Comparison::Quantity& quantity, Group& group, std::size_t their_row, double abscissa,
                const std::optional<Interpolated>& reference, double scale, const std::string& where) {
    if (!reference || !std::isfinite(reference->value)) {
      skip(quantity, no_value);
      return;
    }
    const Point point{.abscissa = abscissa,
                      .theirs = theirs_.column(quantity.name)->values[their_row],
                      .reference = reference->value,
                      .half_width = reference->half_width,
                      .where = where};
    if (judge(quantity, point, scale) && is_diagnosed(quantity.name)) group.differs = true;
  }

  void skip_in_all(const std::string& reason) {
    for (Comparison::Quantity& quantity : result_.quantities) skip(quantity, reason);
  }

  // --- kind table

  // A row of the reference and the corresponding row of the user.
  struct Pair {
    std::size_t row{}, their_row{};
  };

  // Compares the values of pairs of rows at the abscissas of the reference.
  void compare_pairs(Group& group, const std::vector<Pair>& pairs,
                     const std::function<std::string(const Pair&)>& where) {
    for (Comparison::Quantity& quantity : result_.quantities) {
      const auto& values = reference_.column(quantity.name).values;
      const auto radius = reference_.radius_of(quantity.name);
      const double scale = scale_of(quantity.name, quantity.norm, group);
      for (const Pair& pair : pairs) {
        const double abscissa = result_.abscissa.empty()
                                    ? static_cast<double>(pair.row + 1)
                                    : reference_.column(result_.abscissa).values[pair.row];
        judge_at(quantity, group, pair.their_row, abscissa, Interpolated{values[pair.row], radius[pair.row]},
                 scale, where(pair));
      }
    }
  }

  void compare_table() {
    const auto& key = reference_.resource.primary_key;
    std::vector<std::string> missing;
    for (Group& group : groups_) {
      open_series(group);
      Rows absent = group.reference;
      std::vector<Pair> pairs;
      for (const std::size_t their_row : group.theirs) {
        const auto found = std::ranges::find_if(
            absent, [&](std::size_t row) { return matcher_.matches(key, row, their_row); });
        if (found == absent.end()) matcher_.throw_unknown_row(key, their_row);
        pairs.push_back({*found, their_row});
        absent.erase(found);
      }
      compare_pairs(group, pairs, [&](const Pair& pair) { return matcher_.label(key, pair.row); });
      for (const std::size_t row : absent) missing.push_back(matcher_.label(key, row));
    }
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
    Rows sorted = rows;
    std::ranges::sort(sorted, {}, [&](std::size_t row) { return abscissa[row]; });
    Samples samples;
    for (const std::size_t row : sorted) {
      samples.abscissa.push_back(abscissa[row]);
      samples.values.push_back(values[row]);
      samples.half_width.push_back(radius[row]);
    }
    return samples;
  }

  [[nodiscard]] const data::Interpolation* interpolation() const {
    return rule_.interpolation ? &*rule_.interpolation : nullptr;
  }

  [[nodiscard]] double interpolation_error(const std::string& field) const {
    return rule_.interpolation ? rule_.interpolation->error.at(field) : 0.0;
  }

  // Abscissas with a smaller distance than this are considered equal.
  [[nodiscard]] double coincidence(const Group& group) const {
    constexpr double relative = 1e-9;
    const auto& abscissa = reference_.column(rule_.abscissa).values;
    const auto [least, greatest] =
        std::ranges::minmax(group.reference, {}, [&](std::size_t row) { return abscissa[row]; });
    return relative * std::max(abscissa[greatest] - abscissa[least], std::abs(abscissa[greatest]));
  }

  [[nodiscard]] std::string where_of(const Group& group, double abscissa) const {
    return fmt::format("{} = {:.9g}{}{}{}", rule_.abscissa, abscissa,
                       result_.abscissa_unit.empty() ? "" : " ", result_.abscissa_unit,
                       group.label.empty() ? "" : ", " + group.label);
  }

  // Compares with the sample or with the interpolated value. Throws data::InputError if the data set has no
  // sample at x and defines no interpolation.
  void compare_at(Comparison::Quantity& quantity, Group& group, const Samples& samples, std::size_t their_row,
                  double x, double scale) {
    const auto value =
        value_at(samples, x, coincidence(group), interpolation(), interpolation_error(quantity.name));
    if (!value && !rule_.interpolation)
      throw InputError(fmt::format(
          "{}: {} is {}, but must be one of the {} of the data set {}, between which it does not interpolate",
          theirs_.place(their_row), rule_.abscissa, theirs_.column(rule_.abscissa)->text[their_row],
          group.reference.size(), reference_.resource.name));
    judge_at(quantity, group, their_row, x, value, scale, where_of(group, x));
  }

  // Whether x is before the horizon and in the range of the samples. If not, the point is counted as skipped.
  bool is_comparable(Comparison::Quantity& quantity, const Samples& samples, double x, double margin) {
    if (x > horizon_) {
      skip(quantity, beyond_horizon);
      return false;
    }
    if (x < samples.abscissa.front() - margin || x > samples.abscissa.back() + margin) {
      skip(quantity, outside_range);
      return false;
    }
    return true;
  }

  void compare_curves() {
    for (Group& group : groups_) {
      open_series(group);
      const double margin = coincidence(group);
      for (Comparison::Quantity& quantity : result_.quantities) {
        const Samples samples = samples_of(quantity.name, group.reference);
        const double scale = scale_of(quantity.name, quantity.norm, group);
        for (const std::size_t their_row : group.theirs) {
          const double x = theirs_.column(rule_.abscissa)->values[their_row];
          if (is_comparable(quantity, samples, x, margin))
            compare_at(quantity, group, samples, their_row, x, scale);
        }
      }
    }
  }

  // --- kind events

  // The tolerance of event times, s. The rule may define it relative to the horizon.
  [[nodiscard]] double time_tolerance(const data::ComparisonRule& rule) const {
    for (const data::ComparedValue& value : rule.values) {
      if (value.field != "time") continue;
      const double tolerance = tolerance_of(value);
      return value.norm == Norm::absolute || !std::isfinite(horizon_) ? tolerance : tolerance * horizon_;
    }
    return 0.0;
  }

  void note_difference(Comparison::Quantity& sequence, Group& group, const SequenceMatch& found) {
    sequence.compared += found.common + found.missing;
    if (found.difference.empty()) return;
    group.differs = true;
    for (std::size_t i = 0; i < std::max(found.missing, found.extra); ++i) count(sequence, found.difference);
    result_.remarks.push_back(group.label.empty() ? found.difference : group.label + ": " + found.difference);
  }

  void compare_events() {
    Comparison::Quantity sequence = count_of("sequence", "events");
    for (Group& group : groups_) {
      open_series(group);
      const auto events = events_of(reference_, group.reference);
      const auto their_events = events_of(theirs_, group.theirs);
      const SequenceMatch found = match(events, their_events, horizon_, time_tolerance(rule_));
      note_difference(sequence, group, found);
      std::vector<Pair> pairs;
      for (std::size_t i = 0; i < found.common; ++i) pairs.push_back({events[i].row, their_events[i].row});
      compare_pairs(group, pairs, [&](const Pair& pair) {
        const auto event = std::ranges::find(events, pair.row, &TabulatedEvent::row);
        const auto index = static_cast<std::size_t>(event - events.begin());
        return description(index, *event) + (group.label.empty() ? "" : ", " + group.label);
      });
      for (std::size_t i = 0; i < found.beyond; ++i) skip_in_all(beyond_horizon);
      for (std::size_t i = found.common + found.beyond; i < their_events.size(); ++i)
        skip_in_all(after_difference);
    }
    result_.quantities.insert(result_.quantities.begin(), std::move(sequence));
  }

  // --- kind phases

  // The events that belong to a group of a history, from a table of events with the same columns.
  template <class Table>
  [[nodiscard]] std::vector<TabulatedEvent> events_in(const Table& table, const Group& group) const {
    Rows rows;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const bool belongs = std::ranges::all_of(group_columns_, [&](const std::string& name) {
        const data::Column* column = column_of(table, name);
        return column == nullptr ||
               is_same_cell(reference_.column(name), group.reference.front(), *column, row);
      });
      if (belongs) rows.push_back(row);
    }
    return events_of(table, rows);
  }
  static const data::Column* column_of(const data::UserTable& table, const std::string& name) {
    return table.column(name);
  }
  static const data::Column* column_of(const data::ReferenceTable& table, const std::string& name) {
    return table.resource.field(name) == nullptr ? nullptr : &table.column(name);
  }

  // The number of events up to the time t. Samples with the same number are in the same phase.
  static std::size_t phase_number(const std::vector<TabulatedEvent>& events, double t) {
    return static_cast<std::size_t>(
        std::ranges::count_if(events, [t](const TabulatedEvent& event) { return event.time <= t; }));
  }

  // The larger of the distances to the two neighbouring samples.
  [[nodiscard]] double sampling_distance(const Group& group, std::size_t index) const {
    const auto& t = theirs_.column(rule_.abscissa)->values;
    double distance = 0.0;
    if (index > 0) distance = t[group.theirs[index]] - t[group.theirs[index - 1]];
    if (index + 1 < group.theirs.size())
      distance = std::max(distance, t[group.theirs[index + 1]] - t[group.theirs[index]]);
    return distance;
  }

  // The intervals around the events of the reference in which the phases may differ. If the user's event
  // times are known, an interval extends to them.
  static std::vector<Window> windows_between(const std::vector<TabulatedEvent>& events,
                                             const std::vector<TabulatedEvent>& theirs, std::size_t common) {
    std::vector<Window> windows;
    for (std::size_t i = 0; i < events.size(); ++i) {
      Window window{events[i].time - events[i].time_radius, events[i].time + events[i].time_radius};
      if (i < common) window = {std::min(window.from, theirs[i].time), std::max(window.to, theirs[i].time)};
      windows.push_back(window);
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

  void compare_phases() {
    const data::ReferenceTable table = data::read_table(package_, rule_.events);
    Comparison::Quantity phase = count_of("phase", "samples"), sequence = count_of("sequence", "events");
    for (Group& group : groups_) {
      open_series(group);
      const auto events = events_in(table, group);
      std::vector<TabulatedEvent> their_events;
      SequenceMatch found;
      if (settings_.events) {
        their_events = events_in(*settings_.events, group);
        found = match(events, their_events, horizon_, time_tolerance(*table.resource.comparison));
        note_difference(sequence, group, found);
      }
      compare_phases_of(group, events, windows_between(events, their_events, found.common), found.until,
                        phase);
    }
    if (theirs_.column("phase") != nullptr)
      result_.quantities.insert(result_.quantities.begin(), std::move(phase));
    if (settings_.events) result_.quantities.insert(result_.quantities.begin(), std::move(sequence));
  }

  void compare_phases_of(Group& group, const std::vector<TabulatedEvent>& events,
                         const std::vector<Window>& windows, double first_difference,
                         Comparison::Quantity& phase) {
    const double margin = coincidence(group);
    const std::size_t phases = events.size() + 1;
    std::vector<Rows> rows;
    for (std::size_t number = 0; number < phases; ++number)
      rows.push_back(rows_in_phase(group, events, number));
    for (Comparison::Quantity& quantity : result_.quantities) {
      const bool is_first = &quantity == &result_.quantities.front();
      const double scale = scale_of(quantity.name, quantity.norm, group);
      const Samples all = samples_of(quantity.name, group.reference);
      std::vector<Samples> samples;
      for (const Rows& one : rows) samples.push_back(samples_of(quantity.name, one));
      for (std::size_t i = 0; i < group.theirs.size(); ++i) {
        const std::size_t their_row = group.theirs[i];
        const double t = theirs_.column(rule_.abscissa)->values[their_row];
        if (!is_comparable(quantity, all, t, margin)) continue;
        if (t >= first_difference) {
          skip(quantity, after_difference);
          continue;
        }
        const double guard = settings_.events ? 0.0 : sampling_distance(group, i);
        if (std::ranges::any_of(windows, [&](const Window& window) {
              return t >= window.from - guard && t <= window.to + guard;
            })) {
          skip(quantity, at_event);
          continue;
        }
        const std::size_t number = phase_number(events, t);
        const Samples& of_phase = samples[number];
        if (of_phase.abscissa.empty() || t < of_phase.abscissa.front() - margin ||
            t > of_phase.abscissa.back() + margin) {
          skip(quantity, past_last_sample);
          continue;
        }
        const std::string& word = reference_.column("phase").text[rows[number].front()];
        const std::string their_word = their_phase(their_row);
        if (!their_word.empty() && is_first) ++phase.compared;
        if (!their_word.empty() && their_word != word) {
          skip(quantity, other_phase);
          group.differs = true;
          if (is_first) count(phase, fmt::format("{} ({} in the data set)", where_of(group, t), word));
          continue;
        }
        compare_at(quantity, group, of_phase, their_row, t, scale);
      }
    }
  }

  // --- result

  void conclude() {
    bool compared = false;
    for (Comparison::Quantity& quantity : result_.quantities) {
      std::erase_if(quantity.series,
                    [](const Comparison::Series& series) { return series.abscissa.empty(); });
      if (quantity.compared == 0 && quantity.agreement == Agreement::agrees)
        quantity.agreement = Agreement::undecided;
      compared = compared || quantity.compared > 0;
      if (quantity.agreement == Agreement::differs)
        result_.agreement = Agreement::differs;
      else if (quantity.agreement == Agreement::undecided && result_.agreement == Agreement::agrees)
        result_.agreement = Agreement::undecided;
    }
    if (compared) return;
    std::string reasons;
    for (const auto& [reason, points] : result_.quantities.back().skipped)
      reasons += fmt::format("{}{} {}", reasons.empty() ? ": " : ", ", points, reason);
    throw InputError(fmt::format("{}: none of the {} rows can be compared{}", theirs_.file.string(),
                                 theirs_.rows(), reasons));
  }

  // --- diagnosis

  static Quantity quantity_named(const std::string& name) {
    for (const Quantity quantity : all_quantities)
      if (name_of(quantity) == name) return quantity;
    throw InputError(fmt::format("the quantity '{}' of a diagnosis is unknown", name));
  }

  // The user's values up to the horizon. The tolerance is taken as their uncertainty.
  [[nodiscard]] Observation observation_of(const Group& group, Quantity quantity) const {
    const data::DiagnosisRule& rule = *reference_.resource.diagnosis;
    const auto compared = std::ranges::find(rule_.values, rule.value, &data::ComparedValue::field);
    const double scale = scale_of(rule.value, compared->norm, group), tolerance = tolerance_of(*compared);
    const auto& values = theirs_.column(rule.value)->values;
    Observation observation{.quantity = quantity, .abscissa = {}, .values = {}, .uncertainty = {}};
    const auto add = [&](double abscissa, double value) {
      observation.abscissa.push_back(abscissa);
      observation.values.push_back(value);
      observation.uncertainty.push_back(tolerance * unit_of(compared->norm, value, scale));
    };
    if (quantity == Quantity::contact_event) {
      // Onsets and captures are counted, reversals are not.
      const auto counts = [](const TabulatedEvent& event) { return event.change != "reversal"; };
      const auto most = std::ranges::count_if(events_of(reference_, group.reference), counts);
      for (const TabulatedEvent& event : events_of(theirs_, group.theirs))
        if (counts(event) && event.time <= horizon_ && std::ssize(observation.values) < most)
          add(static_cast<double>(observation.values.size() + 1), event.time);
      return observation;
    }
    const auto& abscissa = theirs_.column(rule.abscissa)->values;
    for (const std::size_t row : group.theirs)
      if (rule_.kind == ComparisonKind::table || abscissa[row] <= horizon_) add(abscissa[row], values[row]);
    return observation;
  }

  [[nodiscard]] Comparison::Likeness likeness_of(const Group& group, Quantity quantity) const {
    const data::DiagnosisRule& rule = *reference_.resource.diagnosis;
    const std::string name = rule.case_column.empty()
                                 ? rule.case_name
                                 : reference_.column(rule.case_column).text[group.reference.front()];
    Comparison::Likeness likeness{.group = group.label, .sentence = {}, .diagnosis = {}};
    try {
      const Diagnosis found = studies::diagnose(data::load_case(name), observation_of(group, quantity));
      likeness.sentence = found.finding == Finding::correct
                              ? "no diagnosis: the difference is too small to be assigned to a mistake (" +
                                    sentence(found) + ")"
                              : sentence(found);
      likeness.diagnosis = found;
    } catch (const data::InputError& error) {  // the case is unknown or has no such state
      likeness.sentence = fmt::format("no diagnosis: {}", error.what());
    }
    return likeness;
  }

  void diagnose() {
    const data::DiagnosisRule& rule = *reference_.resource.diagnosis;
    const Quantity quantity = quantity_named(rule.quantity);
    const bool is_compared = std::ranges::count(rule_.values, rule.value, &data::ComparedValue::field) > 0;
    if (!is_compared || theirs_.column(rule.value) == nullptr) return;
    for (const Group& group : groups_)
      if (group.differs) result_.likenesses.push_back(likeness_of(group, quantity));
  }

  const data::ReferencePackage& package_;
  const data::UserTable& theirs_;
  const ComparisonSettings& settings_;
  const data::ReferenceTable reference_;
  const data::ComparisonRule& rule_;
  const Matcher matcher_;
  const double horizon_;
  std::vector<std::string> group_columns_;
  std::vector<Group> groups_;
  Comparison result_;
};

}  // namespace

std::string_view to_string(Agreement agreement) noexcept {
  switch (agreement) {
    case Agreement::agrees:
      return "agrees";
    case Agreement::differs:
      return "differs";
    case Agreement::undecided:
      break;
  }
  return "undecided";
}

Comparison compare(const data::ReferencePackage& package, const std::string& name,
                   const data::UserTable& theirs, const ComparisonSettings& settings) {
  return Comparer(package, name, theirs, settings).run();
}

}  // namespace stickslip::studies
