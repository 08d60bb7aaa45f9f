// SPDX-License-Identifier: MIT
#include "comparison/diagnosis/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>
#include <utility>

#include "comparison/diagnosis/patterns.hpp"
#include "comparison/diagnosis/wrong_models.hpp"
#include "comparison/diagnosis/wrong_numbers.hpp"
#include "comparison/groups.hpp"
#include "comparison/samples.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/common/parallel.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::comparison {

namespace {

using Series = Comparison::Series;
using Candidates = std::vector<Hypothesis>;
using SeenRows = std::vector<std::pair<double, std::size_t>>;  // a user's value, and the row of the data set

Candidates all_of(std::optional<Hypothesis> found) {
  return found ? Candidates{*std::move(found)} : Candidates{};
}

// The row of `table` whose key is that of a row of another table; columns that one of them lacks do not count.
std::optional<std::size_t> row_like(const data::ReferenceTable& table, const std::vector<std::string>& key,
                                    const std::vector<data::Column>& other, std::size_t other_row) {
  for (std::size_t row = 0; row < table.rows(); ++row)
    if (are_alike(table.columns, row, other, other_row, key)) return row;
  return std::nullopt;
}

// At most `count` of the items, evenly from the first to the last.
template <class Item>
std::vector<Item> spread(const std::vector<Item>& items, std::size_t count) {
  if (items.size() <= count) return items;
  std::vector<Item> kept;
  for (std::size_t i = 0; i < count; ++i) kept.push_back(items[i * (items.size() - 1) / (count - 1)]);
  return kept;
}

bool differs_at(const Series& series, std::size_t i) {
  return !(std::abs(series.theirs[i] - series.reference[i]) <= series.allowed[i]);
}

bool differs(const Series& series) {
  for (std::size_t i = 0; i < series.theirs.size(); ++i)
    if (differs_at(series, i)) return true;
  return false;
}

class Search {
 public:
  Search(const Comparison& comparison, const data::ReferencePackage& package,
         const data::ReferenceTable& reference, const data::UserTable& theirs,
         const std::function<void(double)>& progress)
      : comparison_(comparison),
        package_(package),
        reference_(reference),
        rule_(reference.resource.diagnosis ? &*reference.resource.diagnosis : nullptr),
        theirs_(with_keys_of(reference, theirs, reference.resource.comparison->abscissa)),
        progress_(progress) {}

  [[nodiscard]] std::vector<Diagnosis> run() {
    for (const Comparison::Quantity& quantity : comparison_.quantities) {
      if (reference_.resource.field(quantity.name) == nullptr) continue;  // a count of events or phases
      std::vector<Series> groups = quantity.series;
      if (groups_are_rows() || comparison_.abscissa.empty()) groups = {joined(groups)};
      for (const Series& group : groups)
        if (differs(group) || event_sequences_differ(quantity)) add(quantity, group);
    }
    std::vector<Diagnosis> diagnoses;
    for (MergedFinding& one : merged_) {
      if (one.groups > 1) one.diagnosis.group += fmt::format(" and {} more", one.groups - 1);
      diagnoses.push_back(std::move(one.diagnosis));
    }
    return diagnoses;
  }

 private:
  // What is to be explained: one quantity of one group.
  struct Question {
    const Comparison::Quantity& quantity;
    const Series& group;
    std::optional<data::Case> problem;
    ComparedValues values;

    [[nodiscard]] const data::Beam* beam() const { return problem ? &problem->beam() : nullptr; }
  };

  // What is said of several groups, with the first of them.
  struct MergedFinding {
    std::string key;
    Diagnosis diagnosis;
    int groups = 1;
  };

  // Whether each row of the data set is a case of its own, or a point of one motion.
  [[nodiscard]] bool groups_are_rows() const {
    return comparison_.kind == data::ComparisonKind::table &&
           (rule_ != nullptr ? rule_->case_column.empty()
                             : is_of_one_motion() || !numbers_of_mass(reference_.resource, "").empty());
  }

  [[nodiscard]] bool is_of_timoshenko_beams() const {
    const auto& numbers = reference_.resource.stated.numbers;
    return numbers.contains("shear_coefficient") && numbers.contains("poisson_ratio") &&
           numbers.contains("axial_force");
  }

  // Whether the data set has a steady vibration with damping at each frequency.
  [[nodiscard]] bool is_of_steady_state() const {
    return rule_ == nullptr && reference_.resource.field("heat") != nullptr &&
           !reference_.resource.stated.beam.empty() &&
           reference_.resource.primary_key == std::vector<std::string>{"frequency"};
  }

  // Whether the problem is one motion, of which the data set has times.
  [[nodiscard]] bool is_of_one_motion() const {
    return !reference_.resource.stated.beam.empty() &&
           std::ranges::count(reference_.resource.primary_key, "time") > 0;
  }

  static Series joined(const std::vector<Series>& groups) {
    Series all;
    for (const Series& group : groups)
      for (const auto column :
           {&Series::abscissa, &Series::theirs, &Series::reference, &Series::half_width, &Series::allowed})
        (all.*column).insert((all.*column).end(), (group.*column).begin(), (group.*column).end());
    return all;
  }

  // Whether events are missing or additional, which the wrong models may explain.
  [[nodiscard]] bool event_sequences_differ(const Comparison::Quantity& quantity) const {
    return comparison_.kind == data::ComparisonKind::events &&
           quantity.name == (rule_ != nullptr ? rule_->value : "time") &&
           std::ranges::any_of(comparison_.quantities, [](const Comparison::Quantity& one) {
             return one.name == "sequence" && one.agreement == Agreement::differs;
           });
  }

  // --- the search for one group

  void add(const Comparison::Quantity& quantity, const Series& group) {
    auto found = finding_of({quantity, group, case_of(group), values_of(quantity, group)});
    if (!found) return;
    found->diagnosis.group = group.group;
    found->diagnosis.quantity = quantity.name;
    found->key = quantity.name + found->key;
    const auto known = std::ranges::find(merged_, found->key, &MergedFinding::key);
    if (known == merged_.end())
      merged_.push_back(*std::move(found));
    else
      ++known->groups;
  }

  [[nodiscard]] std::optional<MergedFinding> finding_of(const Question& question) const {
    auto relation =
        nearest_of({&Search::mass_numbers, &Search::relations, &Search::relations_in_sequence,
                    &Search::single_values, &Search::other_theories, &Search::other_columns,
                    &Search::all_zeros, &Search::data_sets_within_tolerance, &Search::other_places},
                   question);
    // A factor that was fitted and leaves more than the tolerance may be the trace of a wrong number.
    if (relation && !(relation->diagnosis.named.front() == "constant-factor" &&
                      relation->diagnosis.distance > question.quantity.tolerance))
      return relation;
    Diagnosis by_models = diagnose_by_models(question);
    if (relation &&
        !(by_models.finding == Finding::mistaken && by_models.distance < relation->diagnosis.distance))
      return relation;
    if (by_models.finding != Finding::mistaken) {
      if (auto found = nearest_of({&Search::other_data_sets, &Search::growing_errors}, question))
        return found;
      // Events may be missing although the times agree.
      if (by_models.sentence.empty() || !differs(question.group)) return std::nullopt;
    }
    return MergedFinding{.key = question.group.group + by_models.sentence, .diagnosis = by_models};
  }

  // Makes accepted hypotheses.
  using Generator = Candidates (Search::*)(const Question&) const;

  // The nearest one of the first generator that has any.
  [[nodiscard]] std::optional<MergedFinding> nearest_of(std::initializer_list<Generator> generators,
                                                        const Question& question) const {
    for (const Generator generator : generators)
      if (const Candidates found = (this->*generator)(question); !found.empty()) {
        const Hypothesis& nearest = *std::ranges::min_element(found, {}, &Hypothesis::distance);
        return MergedFinding{.key = nearest.sentence, .diagnosis = diagnosis_of(question, nearest)};
      }
    return std::nullopt;
  }

  [[nodiscard]] Diagnosis diagnosis_of(const Question& question, const Hypothesis& found) const {
    Diagnosis diagnosis{.sentence = found.sentence,
                        .finding = Finding::mistaken,
                        .from_reference = found.from_reference,
                        .distance = found.distance,
                        .named = named_by(found, question)};
    if (found.distance > 1e-12) diagnosis.sentence += ", to " + percent(found.distance);
    if (diagnosis.named.size() > 1) diagnosis.sentence += fmt::format(": like '{}'", diagnosis.named.back());
    return diagnosis;
  }

  [[nodiscard]] ComparedValues values_of(const Comparison::Quantity& quantity, const Series& group) const {
    return {.abscissa_name = comparison_.abscissa,
            .abscissa_unit = comparison_.abscissa_unit,
            .unit = quantity.unit,
            .norm = quantity.norm,
            .abscissa = group.abscissa,
            .theirs = group.theirs,
            .reference = group.reference};
  }

  // --- relations of the numbers

  [[nodiscard]] Candidates relations(const Question& question) const {
    auto found = pattern_of(question.values, question.beam(), is_free());
    if (found && found->name == "constant-factor" && is_mode_shape()) {
      found->name = "scaled-shape";
      found->sentence = "MAC = 1: the same shape in another scale or with another sign";
    }
    return all_of(std::move(found));
  }

  // Events by their number. A common factor or shift of the times leaves no pairs that are near in time.
  [[nodiscard]] Candidates relations_in_sequence(const Question& question) const {
    if (!event_sequences_differ(question.quantity)) return {};
    Question in_sequence = question;
    const auto [theirs, right] = rows_in_sequence(question);
    in_sequence.values.theirs = theirs.times;
    in_sequence.values.reference = in_sequence.values.abscissa = right.times;
    return relations(in_sequence);
  }

  // The events of the group in the user's table and in the data set, as many as both have.
  [[nodiscard]] std::pair<MassRows, MassRows> rows_in_sequence(const Question& question) const {
    std::vector<std::string> columns = data::group_columns(reference_.resource);
    std::erase(columns, comparison_.abscissa);
    std::pair<MassRows, MassRows> found;
    const auto add = [](MassRows& to, const std::vector<data::Column>& table, std::size_t row) {
      to.changes.push_back(data::find_column(table, "change")->text[row]);
      to.times.push_back(data::find_column(table, "time")->values[row]);
      if (const auto* position = data::find_column(table, "position"))
        to.positions.push_back(position->values[row]);
    };
    for (const Group& group : groups_of(reference_, theirs_, columns))
      if (group.label == question.group.group)
        for (std::size_t i = 0; i < std::min(group.theirs.size(), group.reference.size()); ++i) {
          add(found.first, theirs_.columns, group.theirs[i]);
          add(found.second, reference_.columns, group.reference[i]);
        }
    return found;
  }

  // --- wrong numbers in the problem of a mass

  [[nodiscard]] Candidates common_factor(const Question& question) const {
    Candidates multiple = relations(question);
    if (multiple.empty()) multiple = relations_in_sequence(question);
    std::erase_if(multiple, [](const Hypothesis& one) { return one.name != "constant-factor"; });
    return multiple;
  }

  // Each number that is not 0, times usual factors and those from 1/2 to 2.
  template <class Function>
  [[nodiscard]] std::vector<FreeNumber> one_of(const Numbers& numbers, const Function& result_of) const {
    std::vector<double> factors{-1.0, 0.0, 0.1, 0.25, 0.98, 0.99, 1.01, 1.02, 4.0, 10.0};
    for (int k = -18; k <= 18; ++k) factors.push_back(std::exp2(k / 18.0));
    std::ranges::sort(factors);
    std::vector<FreeNumber> free;
    for (const auto& [key, value] : numbers)
      if (value != 0.0)
        free.push_back({factors,
                        [&, key = key](double factor) {
                          Numbers changed = numbers;
                          changed[key] *= factor;
                          return result_of(changed);
                        },
                        [this, key = key, value = value](double factor) {
                          return "like " + wrong_value(key, value, factor);
                        }});
    return free;
  }

  [[nodiscard]] Candidates mass_numbers(const Question& question) const {
    Numbers numbers = numbers_of_mass(reference_.resource, question.group.group);
    if (numbers.empty()) return {};
    const Candidates multiple = common_factor(question);
    if (!multiple.empty() && multiple[0].free == 0) return {};  // a factor that is usual needs no number
    ComparedValues values = question.values;
    values.theirs.clear(), values.reference.clear();
    std::pair<MassRows, MassRows> events;
    std::vector<std::size_t> rows;
    if (comparison_.kind == data::ComparisonKind::events) {
      events = rows_in_sequence(question);
      values.theirs = measured(events.first, events);
      values.reference = measured(events.second, events);
      values.norm = data::Norm::scale;
    } else {
      const double always = std::numeric_limits<double>::infinity();
      for (const auto& [value, row] : seen_of(question.group, question.quantity.name, always, nullptr)) {
        values.theirs.push_back(value);
        values.reference.push_back(reference_.column(question.quantity.name).values[row]);
        rows.push_back(row);
      }
      for (const std::string& column : reference_.resource.primary_key)
        numbers[column] = 1.0;  // times that of the row
    }
    const auto result_of = [&](const Numbers& changed) {
      if (rows.empty()) {
        const auto found = mass_rows(changed, events.first);
        return found ? std::optional(measured(*found, events)) : std::nullopt;
      }
      std::vector<double> all;
      for (const std::size_t row : rows) {
        Numbers own = changed;
        for (const std::string& column : reference_.resource.primary_key)
          own[column] *= reference_.column(column).values[row];
        const auto value = mass_value(own, question.quantity.name);
        if (!value) return std::optional<std::vector<double>>();
        all.push_back(*value);
      }
      return std::optional(all);
    };
    auto found = wrong_number(values, 0.5 * question.quantity.tolerance, one_of(numbers, result_of));
    if (found && !multiple.empty()) found->sentence = multiple[0].sentence + ", " + found->sentence;
    return all_of(std::move(found));
  }

  // The times of changes and the positions, each over the root mean square of the data set.
  static std::vector<double> measured(const MassRows& rows, const std::pair<MassRows, MassRows>& events) {
    const auto& [theirs, right] = events;
    std::vector<double> all;
    for (const auto column : {&MassRows::times, &MassRows::positions}) {
      const bool is_given = column == &MassRows::times && std::ranges::count(right.changes, "state") > 0;
      const std::vector<double> scales = scales_of(data::Norm::scale, right.*column);
      for (std::size_t i = 0; i < (theirs.*column).size() && !is_given && scales[i] > 0.0; ++i)
        all.push_back((rows.*column)[i] / scales[i]);
    }
    return all;
  }

  [[nodiscard]] bool is_mode_shape() const {
    const auto& key = reference_.resource.primary_key;
    return std::ranges::count(key, "mode") + std::ranges::count(key, "x") == 2;
  }

  // The hypothesis, and the wrong models that only multiply the quantity.
  [[nodiscard]] std::vector<std::string> named_by(const Hypothesis& found, const Question& question) const {
    std::vector<std::string> names{found.name};
    const auto quantity = quantity_of(question.quantity.name);
    if (!quantity || (found.name != "constant-factor" && found.name != "scaled-shape")) return names;
    const double halved = *quantity == Quantity::critical_amplitude && !is_force_ratio() ? 2.0 : 0.5;
    for (const auto& [name, factor] : {std::pair{"force-sign", -1.0}, {"peak-to-peak-amplitude", halved}}) {
      const bool is_multiple = std::ranges::equal(found.values, question.values.reference, {}, {},
                                                  [&, factor = factor](double x) { return factor * x; });
      if (is_multiple && std::ranges::count(wrong_model_named(name).changes, *quantity) > 0)
        names.emplace_back(name);
    }
    return names;
  }

  [[nodiscard]] Candidates all_zeros(const Question& question) const {
    // A tip of which the displacement is 0 sticks, and a wrong model may say why.
    return question.quantity.name == "tip_displacement" ? Candidates() : all_of(zeros_of(question.values));
  }

  [[nodiscard]] Candidates growing_errors(const Question& question) const {
    return is_of_timoshenko_beams() ? Candidates() : all_of(growth_of(question.values, question.beam()));
  }

  [[nodiscard]] bool is_free() const { return reference_.resource.stated.tip == "free"; }

  [[nodiscard]] Candidates other_theories(const Question& question) const {
    return question.beam() == nullptr
               ? Candidates()
               : other_beams(question.values, *question.beam(), is_free(), is_of_timoshenko_beams());
  }

  // --- another column, single values

  // The values of another compared column, at the same rows.
  [[nodiscard]] Candidates other_columns(const Question& question) const {
    Candidates found;
    for (const Comparison::Quantity& swapped : comparison_.quantities)
      for (const Series& series : groups_are_rows() ? std::vector{joined(swapped.series)} : swapped.series) {
        if (swapped.name == question.quantity.name || series.group != question.group.group ||
            series.abscissa != question.group.abscissa)
          continue;
        // In their own measure: beside larger values in another unit all small ones are alike.
        constexpr double near = 0.01;
        const auto& theirs = question.values.theirs;
        const data::Norm norm = question.values.norm;
        const double own_distance = distance(norm, series.reference, theirs, series.reference);
        if (!(own_distance <= near) || theirs.size() < 3) continue;
        found.push_back({.name = "other-column",
                         .values = series.reference,
                         .sentence = fmt::format("the values are those of {}", swapped.name),
                         .distance = own_distance,
                         .from_reference = distance(norm, question.values.reference, series.reference,
                                                    question.values.reference)});
      }
    return found;
  }

  // At most a twentieth of the values differ, or one, ten times as much as any other. Both numbers are empirical.
  [[nodiscard]] Candidates single_values(const Question& question) const {
    const Series& group = question.group;
    constexpr std::size_t fewest = 4, share = 20;
    constexpr double least_ratio = 10.0;
    const std::size_t size = group.theirs.size();
    double largest = 0.0, least = std::numeric_limits<double>::infinity();
    Rows wrong;
    for (std::size_t i = 0; i < size; ++i) {
      const double error = std::abs(group.theirs[i] - group.reference[i]) / group.allowed[i];
      if (differs_at(group, i)) {
        wrong.push_back(i);
        least = std::min(least, error);
      } else {
        largest = std::max(largest, error);
      }
    }
    const bool are_few = !wrong.empty() && wrong.size() <= std::max<std::size_t>(1, size / share);
    if (size < fewest || !are_few || !(least_ratio * largest <= least)) return {};
    std::string text =
        fmt::format("only {} of {} values differ{}", wrong.size(), size, wrong.size() == 1 ? "s" : "");
    const bool has_place =
        !comparison_.abscissa.empty() && (!groups_are_rows() || reference_.resource.primary_key.size() == 1);
    if (has_place)
      text += fmt::format(", {}at {} = {:.9g}{}{}", wrong.size() == 1 ? "" : "the first ",
                          comparison_.abscissa, group.abscissa[wrong.front()],
                          comparison_.abscissa_unit.empty() ? "" : " ", comparison_.abscissa_unit);
    return {{.name = "single-values", .values = {}, .sentence = text}};
  }

  // --- another data set

  // It must have half of the user's rows, and explain a difference in one of them.
  [[nodiscard]] Candidates other_data_sets(const Question& question) const {
    const auto& [quantity, group, problem, values] = question;
    if (comparison_.abscissa.empty() || comparison_.kind == data::ComparisonKind::events || groups_are_rows())
      return {};
    std::vector<const data::Resource*> others;
    for (const data::Resource& other : package_.resources) {
      const data::Field* field = other.field(quantity.name);
      if (other.name != comparison_.name && field != nullptr && field->unit == quantity.unit &&
          other.comparison && other.comparison->kind == comparison_.kind &&
          other.primary_key == reference_.resource.primary_key)
        others.push_back(&other);
    }
    Candidates found;
    for (const data::Resource* other : others) {
      const auto predicted = at_the_same_rows(data::read_table(package_, other->name), quantity.name, group);
      std::size_t shared = 0;
      bool differs_there = false;
      for (std::size_t i = 0; i < predicted.size(); ++i) {
        if (std::isnan(predicted[i])) continue;
        ++shared;
        differs_there = differs_there || differs_at(group, i);
      }
      if (2 * shared < predicted.size() || !differs_there) continue;
      if (auto one = accepted(values,
                              {.name = "other-data-set",
                               .values = predicted,
                               .sentence = fmt::format("the values are those of {}", other->name)},
                              static_cast<int>(others.size())))
        found.push_back(*std::move(one));
    }
    return found;
  }

  // Beyond the tolerance another data set may be near without being meant, and a wrong model comes first.
  [[nodiscard]] Candidates data_sets_within_tolerance(const Question& question) const {
    Candidates found = other_data_sets(question);
    std::erase_if(found, [&](const Hypothesis& one) { return one.distance > question.quantity.tolerance; });
    return found;
  }

  // The values of another data set in the rows of this group; NaN where it has none.
  [[nodiscard]] std::vector<double> at_the_same_rows(const data::ReferenceTable& other,
                                                     const std::string& field, const Series& group) const {
    std::vector<double> found(group.abscissa.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t row = 0; row < reference_.rows(); ++row) {
      if (!group.group.empty() && label_of(row) != group.group) continue;
      const double x = reference_.column(comparison_.abscissa).values[row];
      const auto at = std::ranges::find_if(group.abscissa, [x](double a) { return data::is_same_key(a, x); });
      if (at == group.abscissa.end()) continue;
      if (const auto there = row_like(other, reference_.resource.primary_key, reference_.columns, row))
        found[static_cast<std::size_t>(at - group.abscissa.begin())] = other.column(field).values[*there];
    }
    return found;
  }

  // As Comparison::Series::group.
  [[nodiscard]] std::string label_of(std::size_t row) const {
    std::vector<std::string> columns = data::group_columns(reference_.resource);
    std::erase(columns, comparison_.abscissa);
    return comparison::label_of(reference_, columns, row);
  }

  // --- the wrong models

  [[nodiscard]] bool is_force_ratio() const { return rule_ != nullptr && rule_->quantity == "force ratio"; }

  // The quantity of the wrong models. Of fields it is that in the middle of the beam.
  [[nodiscard]] std::optional<Quantity> quantity_of(const std::string& field) const {
    if (is_force_ratio()) return Quantity::critical_amplitude;
    if (rule_ != nullptr) {
      const auto* const known =
          std::ranges::find(quantity_names, rule_->quantity, &std::pair<Quantity, std::string_view>::second);
      if (known == quantity_names.end())
        throw data::InputError(fmt::format("the quantity '{}' of a diagnosis is unknown", rule_->quantity));
      const Quantity quantity = known->first;
      if (field == rule_->value) return quantity;
      if (field == "friction_force" && quantity == Quantity::stick_displacement) return Quantity::stick_force;
      if (field == "friction_force" && quantity == Quantity::tip_displacement)
        return Quantity::friction_force;
    }
    if (is_of_steady_state())
      for (const auto& [name, quantity] : {std::pair{"midspan_amplitude", Quantity::steady_amplitude},
                                           {"midspan_phase", Quantity::steady_phase},
                                           {"force_amplitude", Quantity::steady_force_amplitude},
                                           {"force_phase", Quantity::steady_force_phase},
                                           {"heat", Quantity::heat}})
        if (field == name) return quantity;
    if (!is_of_one_motion()) return std::nullopt;
    const data::StatedProblem& stated = reference_.resource.stated;
    const auto damping = stated.numbers.find("damping.kelvin_voigt");
    const bool is_held = stated.tip == "held" && (damping == stated.numbers.end() || damping->second == 0.0);
    if (field == "midspan_displacement" || field == "displacement")
      return is_held ? Quantity::stick_displacement : Quantity::midspan_displacement;
    if (field == "midspan_velocity" || field == "velocity")
      return is_held ? Quantity::stick_velocity : Quantity::midspan_velocity;
    if (field == "friction_force") return is_held ? Quantity::stick_force : Quantity::friction_force;
    if (field == "tip_displacement") return Quantity::tip_displacement;
    if (field == "tip_velocity") return Quantity::tip_velocity;
    return std::nullopt;
  }

  // The case that the data set names for a group, or that of its beam, with the numbers of its problem; empty if
  // there is none.
  [[nodiscard]] std::optional<data::Case> case_of(const Series& group) const {
    const data::StatedProblem& stated = reference_.resource.stated;
    std::string name = rule_ == nullptr ? stated.beam : rule_->case_name;
    const std::string column = rule_ == nullptr ? "beam" : rule_->case_column;
    for (std::size_t row = 0;
         name.empty() && reference_.resource.field(column) != nullptr && row < reference_.rows(); ++row)
      if (group.group.empty() || label_of(row) == group.group) name = reference_.column(column).text[row];
    try {
      auto numbers = data::numbers_of(data::load_case(name));
      for (const auto& [key, number] : stated.numbers) numbers[key] = number;
      if (is_of_timoshenko_beams()) {
        numbers["beam.axial_force"] = stated.numbers.at("axial_force");
        numbers["beam.shear_stiffness"] =
            shear_stiffness(data::load_case(name).beam(), stated.numbers.at("shear_coefficient"),
                            stated.numbers.at("poisson_ratio"));
      }
      if (stated.tip == "friction" && numbers["damping.kelvin_voigt"] == 0.0) {
        // Without damping a mesh converges only if its steps damp what they cannot resolve. Over three periods these
        // come within 0.4 % of the published histories.
        numbers["numerics.spectral_radius"] = 0.5;
        numbers["numerics.time_step"] = 1.0 / (1600.0 * numbers["excitation.frequency_hz"]);
      }
      if (numbers["damping.kelvin_voigt"] > 0.0) {
        // The settings of the paper answer in seconds, and find 45 of the 47 changes of contact of `damped`.
        numbers["numerics.elements"] = 20;
        numbers["numerics.time_step"] = 1.0 / (400.0 * numbers["excitation.frequency_hz"]);
        numbers["numerics.spectral_radius"] = 0.9;
        numbers["numerics.velocity_threshold"] = 1e-4;
      }
      return data::case_with(name, numbers);
    } catch (const data::InputError&) {
      return std::nullopt;
    }
  }

  // The values at the node beside the middle, on some mesh. Its effect is that on a run of 20 elements, to the nearest
  // step.
  [[nodiscard]] Candidates other_places(const Question& question) const {
    if (!question.problem || question.quantity.name != "midspan_displacement") return {};
    const data::Case& problem = *question.problem;
    const ComparedValues& values = question.values;
    constexpr int finest = 40;
    constexpr double periods = 5.0;
    const double step = 1.0 / (1600.0 * problem.excitation().frequency_hz());
    const bool is_held = reference_.resource.stated.tip == "held";
    solver::BeamSimulation run(with_value(problem, "numerics.time_step", step),
                               {.is_bonded = is_held, .coordinates = solver::Coordinates::nodal});
    ComparedValues early = values;
    const auto end = std::ranges::upper_bound(values.abscissa, periods / problem.excitation().frequency_hz());
    const auto count = static_cast<std::size_t>(end - values.abscissa.begin());
    for (auto* column : {&early.abscissa, &early.theirs, &early.reference}) column->resize(count);
    std::map<double, std::vector<double>> predicted;  // by x/L
    for (std::size_t i = 0; i < count; ++i) {
      while (run.integrator().time() + 0.5 * step < values.abscissa[i]) run.integrator().step();
      for (int elements = 4; elements <= finest; elements += 2)
        for (const double side : {-1.0, 1.0}) {
          const double place = 0.5 + side / elements;
          predicted[place].push_back(early.reference[i] + run.displacement(place * problem.beam().length()) -
                                     run.midspan_displacement());
        }
    }
    Candidates found;
    for (const auto& [place, here] : predicted)
      if (auto one =
              accepted(early,
                       {.name = "beside-the-middle",
                        .values = here,
                        .sentence = fmt::format("the values are those at x = {:.4g} L, the node beside "
                                                "the middle on {:.0f} elements",
                                                place, 1.0 / std::abs(place - 0.5))},
                       static_cast<int>(predicted.size())))
        found.push_back(*std::move(one));
    return found;
  }

  // The case with the values of the columns of a row.
  [[nodiscard]] data::Case case_of_row(data::Case problem, std::size_t row) const {
    for (const auto& [name, parameter] : {std::pair{"frequency", "excitation.frequency_hz"},
                                          {"amplitude", "excitation.amplitude"},
                                          {"length", "beam.length"},
                                          {"axial_force", "beam.axial_force"}})
      if (std::ranges::count(reference_.resource.primary_key, name) > 0)
        problem = data::with_value(problem, parameter, reference_.column(name).values[row]);
    return problem;
  }

  // What is observed, with the truth and, if each row is a case, the cases.
  struct Observed {
    std::vector<double> abscissa, values, uncertainty, truth;
    std::vector<data::Case> cases;
  };

  [[nodiscard]] SeenRows seen_of(const Series& group, const std::string& field, double latest,
                                 const data::Beam* beam) const {
    SeenRows seen;
    const double end = std::min(latest, comparison_.horizon);
    const data::Column* time = theirs_.column(name_of_time());
    const bool has_points = time != nullptr && reference_.resource.field("x") != nullptr;
    const std::vector<double>& values = theirs_.column(field)->values;
    for (std::size_t row = 0; row < theirs_.rows(); ++row) {
      if (time != nullptr && time->values[row] > end) continue;
      if (has_points && !data::is_same_key(theirs_.column("x")->values[row], 0.5 * beam->length())) continue;
      const auto found = row_like(reference_, reference_.resource.primary_key, theirs_.columns, row);
      if (!found || !std::isfinite(reference_.column(field).values[*found])) continue;
      if (group.group.empty() || label_of(*found) == group.group) seen.emplace_back(values[row], *found);
    }
    constexpr std::size_t few = 20;
    return time != nullptr && !has_points && seen.size() < few ? interpolated(field, end) : seen;
  }

  [[nodiscard]] std::string name_of_time() const {
    return comparison_.abscissa_unit == "s" ? comparison_.abscissa : "time";
  }

  // A user's values at the times of the data set.
  [[nodiscard]] SeenRows interpolated(const std::string& field, double end) const {
    const Samples samples{.abscissa = theirs_.column(name_of_time())->values,
                          .values = theirs_.column(field)->values,
                          .half_width = std::vector<double>(theirs_.rows())};
    SeenRows seen;
    if (!std::ranges::is_sorted(samples.abscissa)) return seen;
    for (std::size_t row = 0; row < reference_.rows(); ++row) {
      const double t = reference_.column(name_of_time()).values[row];
      if (t < samples.abscissa.front() || t > std::min(end, samples.abscissa.back())) continue;
      if (const auto value = comparison::interpolated(samples, t)) seen.emplace_back(value->value, row);
    }
    return seen;
  }

  // Onsets and captures, not reversals, in their sequence.
  [[nodiscard]] SeenRows seen_events() const {
    const auto rows_of = [](const data::Column& change) {
      Rows rows;
      for (std::size_t row = 0; row < change.text.size(); ++row)
        if (change.text[row] == "onset" || change.text[row] == "capture") rows.push_back(row);
      return rows;
    };
    const Rows theirs = rows_of(*theirs_.column("change")), reference = rows_of(reference_.column("change"));
    SeenRows seen;
    for (std::size_t i = 0; i < std::min({theirs.size(), reference.size(), std::size_t{12}}); ++i)
      seen.emplace_back(theirs_.column("time")->values[theirs[i]], reference[i]);
    return seen;
  }

  // The wrong models are tried up to this time: five periods of stick and slip, or three without damping. Later on,
  // small errors grow.
  [[nodiscard]] double end_of(Quantity quantity, const data::Case& problem) const {
    const bool is_history = is_stick_slip_history(quantity) && reference_.resource.stated.tip != "held";
    const double periods = problem.damping.is_none() ? 3.0 : 5.0;
    return is_history ? periods / problem.excitation().frequency_hz()
                      : std::numeric_limits<double>::infinity();
  }

  [[nodiscard]] Observed observed(const Comparison::Quantity& compared, Quantity quantity,
                                  const Series& group, const data::Case& problem) const {
    const bool is_event = quantity == Quantity::contact_event;
    const bool is_slow = quantity == Quantity::force_maximum || quantity == Quantity::critical_amplitude;
    const auto seen = spread(
        is_event ? seen_events() : seen_of(group, compared.name, end_of(quantity, problem), &problem.beam()),
        is_slow                ? 8
        : is_of_steady_state() ? 30
                               : 400);
    const data::Column& truth = reference_.column(compared.name);
    const auto half_width = reference_.radius_of(compared.name);
    const double scale = group.allowed.empty() ? compared.tolerance : group.allowed[0] - group.half_width[0];
    Observed result;
    for (auto [value, reference_row] : seen) {
      double right = truth.values[reference_row];
      double uncertainty =
          half_width[reference_row] +
          (compared.norm == data::Norm::relative ? compared.tolerance * std::abs(right) : scale);
      if (is_slow) result.cases.push_back(case_of_row(problem, reference_row));
      if (is_force_ratio()) {
        const double amplitude = result.cases.back().excitation().amplitude();
        uncertainty *= amplitude / (right * right);
        value = amplitude / value, right = amplitude / right;
      }
      result.abscissa.push_back(is_event             ? static_cast<double>(result.truth.size() + 1)
                                : is_slow            ? result.cases.back().excitation().frequency_hz()
                                : is_of_one_motion() ? reference_.column("time").values[reference_row]
                                : is_of_steady_state()
                                    ? reference_.column("frequency").values[reference_row]
                                    : reference_.column(rule_->abscissa).values[reference_row]);
      result.values.push_back(value);
      result.uncertainty.push_back(uncertainty);
      result.truth.push_back(right);
    }
    return result;
  }

  // The number of a case that is wrong, or the width of a smooth law of friction. A beam with E I or rho A is the same,
  // whichever of the two is wrong.
  [[nodiscard]] std::optional<Hypothesis> number_of(const Question& question, Quantity quantity,
                                                    const Observed& seen, const std::vector<double>& right,
                                                    double uncertainty) const {
    static const std::vector<double> factors{0.5,  0.63, 0.8,  0.9, 0.96, 0.98, 0.99,
                                             1.01, 1.02, 1.04, 1.1, 1.25, 1.6,  2.0};
    static const std::vector<double> decades{0.1, 0.2, 0.5, 0.8, 0.9, 0.98, 1.02, 1.1, 1.25, 2.0, 5.0, 10.0};
    static const std::vector<double> widths{1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3};
    const data::Case& problem = *question.problem;
    ComparedValues values = question.values;
    values.norm = measure_of(quantity), values.theirs = seen.values, values.reference = seen.truth;
    const auto relative = [&](std::optional<std::vector<double>> result) {
      if (result) *result = comparison::relative_to_data(values.norm, *result, right, seen.truth);
      return result;
    };
    std::vector<FreeNumber> numbers;
    const auto add = [&](const std::vector<double>& tried, const std::vector<std::string>& keys) {
      if (value_of(problem, keys[0]) == 0.0) return;
      numbers.push_back({tried,
                         [&, keys](double factor) {
                           return relative(result_with(problem, keys[0], factor, quantity, seen));
                         },
                         [&, keys](double factor) {
                           std::string text;
                           for (const std::string& key : keys)
                             text += (text.empty() ? "like " : ", or ") +
                                     wrong_value(key, value_of(problem, key), factor);
                           return text;
                         }});
    };
    add(factors, {"excitation.amplitude"});
    add(factors, {"beam.youngs_modulus", "beam.second_moment_of_area"});
    add(factors, {"beam.density", "beam.area"});
    for (const char* key : {"beam.axial_force", "beam.length"}) add(factors, {key});
    if (!has_column_of("excitation.frequency_hz")) add(factors, {"excitation.frequency_hz"});
    if (seen.cases.empty()) {
      for (const char* key : {"friction.static_coefficient", "friction.kinetic_coefficient"})
        add(factors, {key});
      for (const char* key : {"friction.decay", "damping.kelvin_voigt"}) add(decades, {key});
    }
    if (is_stick_slip_history(quantity))
      numbers.push_back({widths,
                         [&](double width) {
                           return relative(result_smoothed_over(problem, width, quantity, seen.abscissa));
                         },
                         [](double width) {
                           return fmt::format("like a law of friction that is smoothed over {:.2g} mm/s",
                                              1e3 * width);
                         }});
    return wrong_number(values, uncertainty, numbers);
  }

  // Each wrong model takes longer in all cases than the search for a number. One that leaves at most a hundredth needs
  // no model.
  [[nodiscard]] std::optional<Hypothesis> number_of_cases(const Question& question, Quantity quantity,
                                                          const Observed& seen) const {
    std::vector<double> right;
    for (std::size_t i = 0; i < seen.cases.size(); ++i)
      right.push_back(reference_result(seen.cases[i], quantity, {seen.abscissa[i]}).front());
    if (right.empty()) return std::nullopt;
    constexpr double least_ratio = 100.0;
    const data::Norm norm = measure_of(quantity);
    const double uncertainty =
        distance(norm, seen.truth, right, seen.truth) +
        distance(norm, seen.truth, seen.uncertainty, std::vector<double>(right.size()));
    auto number = number_of(question, quantity, seen, right, uncertainty);
    const double whole = distance(norm, seen.truth, seen.values, seen.truth);
    return number && least_ratio * number->distance <= whole ? number : std::nullopt;
  }

  // Whether each row has its own value of this number.
  [[nodiscard]] bool has_column_of(const std::string& key) const {
    return std::ranges::any_of(reference_.resource.primary_key, [&](const std::string& column) {
      return key == column || key.find("." + column) != std::string::npos;
    });
  }

  [[nodiscard]] std::string wrong_value(const std::string& key, double value, double factor) const {
    return has_column_of(key) ? fmt::format("{} times {:.4g}", key, factor)
                              : fmt::format("{} = {:.4g} instead of {:.6g}", key, factor * value, value);
  }

  // The right result with this number multiplied; of several cases in each of them.
  static std::optional<std::vector<double>> result_with(const data::Case& problem, std::string_view key,
                                                        double factor, Quantity quantity,
                                                        const Observed& seen) {
    if (seen.cases.empty()) return comparison::result_with(problem, key, factor, quantity, seen.abscissa);
    std::vector<double> all;
    for (std::size_t i = 0; i < seen.cases.size(); ++i) {
      const double hz = seen.abscissa[i] * (key == "excitation.frequency_hz" ? factor : 1.0);
      const auto one = comparison::result_with(seen.cases[i], key, factor, quantity, {hz});
      if (!one) return std::nullopt;
      all.push_back(one->front());
    }
    return all;
  }

  static std::string up_to(double time) {
    return std::isfinite(time) ? fmt::format(" up to {:g} s", time) : "";
  }

  // The nearest wrong model, or the reason why there is none; no sentence where there is nothing to say. A model that is
  // farther away than this may be near by accident, and a number that is wrong nearer.
  [[nodiscard]] Diagnosis diagnose_by_models(const Question& question) const {
    constexpr double rough = 5e-3;
    const auto& [compared, group, problem, values] = question;
    const auto quantity = quantity_of(compared.name);
    if (!problem || !quantity) return {};
    try {
      const Observed seen = observed(compared, *quantity, group, *problem);
      if (seen.truth.empty()) return {};
      if (is_of_all_modes(seen, *quantity)) return all_modes(question);
      if (const auto number = number_of_cases(question, *quantity, seen))
        return diagnosis_of(question, *number);
      const ModelResults computed = seen.cases.empty()
                                        ? model_results(*problem, *quantity, seen.abscissa, progress_)
                                        : model_results(seen.cases, *quantity, seen.abscissa, progress_);
      Diagnosis found =
          comparison::diagnose(relative_to_data(computed, seen.truth), seen.values, seen.uncertainty);
      const double nearest =
          found.ranked.empty() ? std::numeric_limits<double>::infinity() : found.ranked.front().distance;
      found.distance = nearest;
      const bool is_rough = found.finding == Finding::mistaken && nearest > rough;
      if (found.finding == Finding::unexplained || is_rough)
        if (const auto number = number_of(question, *quantity, seen, computed.reference, found.uncertainty);
            number && number->distance < nearest)
          return diagnosis_of(question, *number);
      if (found.finding == Finding::correct)
        found.sentence =
            fmt::format("no diagnosis: the difference of {}{} is too small to be assigned to a mistake",
                        percent(found.from_reference), up_to(end_of(*quantity, *problem)));
      else
        found.sentence += where_told_apart(found, *quantity);
      return found;
    } catch (const data::InputError& error) {  // there is no such state
      return {.sentence = fmt::format("no diagnosis: {}", error.what())};
    }
  }

  [[nodiscard]] Diagnosis all_modes(const Question& question) const {
    Diagnosis diagnosis{
        .sentence = fmt::format("like all modes: the data set has {}", question.problem->numerics.modes()),
        .finding = Finding::mistaken,
        .named = {"all-modes"}};
    const std::string of_all = comparison_.name + "-all-modes";
    if (std::ranges::count(package_.resources, of_all, &data::Resource::name) > 0)
      diagnosis.sentence += fmt::format(", and {} has all", of_all);
    return diagnosis;
  }

  // Whether the values of a maximum are three times nearer to those of all modes than to the data set. Three
  // is empirical.
  static bool is_of_all_modes(const Observed& seen, Quantity quantity) {
    constexpr double ratio = 3.0;
    double all_modes = 0.0, data_set = 0.0;
    for (std::size_t i = 0; i < seen.cases.size(); ++i) {
      const double right = reference_result(seen.cases[i], quantity, {seen.abscissa[i]}).front();
      all_modes += std::pow(seen.values[i] / right - 1.0, 2);
      data_set += std::pow(seen.values[i] / seen.truth[i] - 1.0, 2);
    }
    return ratio * std::sqrt(all_modes) < std::sqrt(data_set);
  }

  // A data set that some of many named mistakes change and others do not.
  [[nodiscard]] std::string where_told_apart(const Diagnosis& found, Quantity quantity) const {
    if (found.finding != Finding::mistaken || found.named.size() < 2) return "";
    for (const data::Resource& other : package_.resources) {
      if (!other.diagnosis || other.diagnosis->quantity == name_of(quantity)) continue;
      const auto changed = std::ranges::count_if(found.named, [&](const std::string& name) {
        return std::ranges::count(wrong_model_named(name).changes, other.diagnosis->quantity, name_of) > 0;
      });
      if (changed > 0 && changed < std::ssize(found.named))
        return fmt::format("; the data set {} tells some of them apart", other.name);
    }
    return "";
  }

  const Comparison& comparison_;
  const data::ReferencePackage& package_;
  const data::ReferenceTable& reference_;
  const data::DiagnosisRule* rule_;
  const data::UserTable theirs_;
  const std::function<void(double)>& progress_;
  std::vector<MergedFinding> merged_;
};

}  // namespace

std::vector<Diagnosis> diagnose(const Comparison& comparison, const data::ReferencePackage& package,
                                const data::ReferenceTable& reference, const data::UserTable& theirs,
                                const std::function<void(double)>& progress) {
  if (comparison.agreement != Agreement::differs) return {};
  auto found = Search(comparison, package, reference, theirs, progress).run();
  for (const Comparison::Quantity& quantity : comparison.quantities)
    if (quantity.agreement == Agreement::differs && !quantity.series.empty() &&
        std::ranges::count(found, quantity.name, &Diagnosis::quantity) == 0)
      found.push_back({.quantity = quantity.name,
                       .sentence = "no diagnosis: no factor, constant, shift, other column or other data set "
                                   "explains it, and no known mistake concerns it"});
  return found;
}

}  // namespace stickslip::comparison
