// SPDX-License-Identifier: MIT
#include "comparison/likeness.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "comparison/groups.hpp"
#include "comparison/patterns.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::studies {

namespace {

using Likeness = Comparison::Likeness;
using Series = Comparison::Series;
using Found = std::optional<Pattern>;

// A row of the user and the row of the data set with the same key.
struct Pair {
  std::size_t theirs{}, reference{};
};

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

// What is said of several groups, with the first of them.
struct Joined {
  std::string key;
  Likeness likeness;
  int groups = 1;
};

class Search {
 public:
  Search(Comparison& comparison, const data::ReferencePackage& package, const data::ReferenceTable& reference,
         const data::UserTable& theirs, const ComparisonSettings& settings)
      : comparison_(comparison),
        package_(package),
        reference_(reference),
        rule_(reference.resource.diagnosis ? &*reference.resource.diagnosis : nullptr),
        theirs_(theirs),
        settings_(settings) {}

  void run() {
    for (const Comparison::Quantity& quantity : comparison_.quantities) {
      if (reference_.resource.field(quantity.name) == nullptr) continue;  // a count of events or phases
      std::vector<Series> groups = quantity.series;
      if (is_of_rows()) groups = {joined(groups)};
      for (const Series& group : groups)
        if (differs(group) || is_of_other_events(quantity)) add(quantity, group);
    }
    for (Joined& one : joined_) {
      if (one.groups > 1) one.likeness.group += fmt::format(" and {} more", one.groups - 1);
      comparison_.likenesses.push_back(std::move(one.likeness));
    }
  }

 private:
  // Whether each row of the data set is a case of its own.
  [[nodiscard]] bool is_of_rows() const {
    return comparison_.kind == data::ComparisonKind::table && rule_ != nullptr && rule_->case_column.empty();
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
  [[nodiscard]] bool is_of_other_events(const Comparison::Quantity& quantity) const {
    return comparison_.kind == data::ComparisonKind::events && rule_ != nullptr &&
           quantity.name == rule_->value &&
           std::ranges::any_of(comparison_.quantities, [](const Comparison::Quantity& one) {
             return one.name == "sequence" && one.agreement == Agreement::differs;
           });
  }

  // --- the search for one group

  void add(const Comparison::Quantity& quantity, const Series& group) {
    Likeness likeness{.group = group.group, .quantity = quantity.name, .sentence = {}, .diagnosis = {}};
    const ComparedValues values = values_of(quantity, group);
    const auto problem = case_of(group);
    const data::Beam* beam = problem ? &problem->beam : nullptr;
    Found found = pattern(values, beam);
    if (!found && is_of_other_events(quantity)) found = pattern(in_sequence(quantity, values), beam);
    if (!found) found = other_column(quantity, values, group);
    // A tip of which the displacement is 0 sticks, and a wrong model may say why.
    if (!found && quantity.name != "tip_displacement") found = zeros_of(values);
    // Another data set may be near without being meant: beyond the tolerance a wrong model comes first.
    const Found other = found ? Found() : other_values(quantity, values, group);
    if (other && other->remaining <= quantity.tolerance) found = other;
    if (!found && problem && quantity.name == "midspan_displacement")
      found = beside_the_middle(values, *problem);
    std::string key;
    if (!found) {
      const bool is_said = problem && diagnose_by_models(likeness, quantity, group, *problem);
      if (!likeness.diagnosis || likeness.diagnosis->finding == Finding::unexplained)
        found = other ? other : growth_of(values, beam);
      if (!found && !(likeness.diagnosis && likeness.diagnosis->finding == Finding::mistaken))
        found = single_values(group);
      // Events may be missing although the times agree.
      const bool is_of_interest =
          differs(group) || (likeness.diagnosis && likeness.diagnosis->finding == Finding::mistaken);
      if (!found && !(is_said && is_of_interest)) return;
      key = likeness.group + likeness.sentence;
    }
    if (found) {
      key = found->sentence;
      describe(likeness, *found);
    }
    const auto known = std::ranges::find(joined_, quantity.name + key, &Joined::key);
    if (known == joined_.end())
      joined_.push_back({.key = quantity.name + key, .likeness = likeness});
    else
      ++known->groups;
  }

  void describe(Likeness& likeness, const Pattern& found) const {
    likeness.sentence = found.sentence;
    if (found.remaining > 1e-12) likeness.sentence += ", to " + percent(found.remaining);
    likeness.diagnosis = Diagnosis{.finding = Finding::mistaken,
                                   .from_reference = found.difference,
                                   .named = named_by(found, likeness.quantity)};
    if (likeness.diagnosis->named.size() > 1)
      likeness.sentence += fmt::format(": like '{}'", likeness.diagnosis->named.back());
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

  // Events by their number. A common factor or shift of the times leaves no pairs that are near in time.
  [[nodiscard]] ComparedValues in_sequence(const Comparison::Quantity& quantity,
                                           ComparedValues values) const {
    values.theirs = theirs_.column(quantity.name)->values;
    values.reference = reference_.column(quantity.name).values;
    const std::size_t count = std::min(values.theirs.size(), values.reference.size());
    values.theirs.resize(count);
    values.reference.resize(count);
    values.abscissa = values.reference;
    return values;
  }

  [[nodiscard]] Found pattern(const ComparedValues& values, const data::Beam* beam) const {
    Found found =
        pattern_of(values, beam, rule_ != nullptr && rule_->quantity == name_of(Quantity::slip_frequency));
    if (found && found->factor != 0.0 && is_mode_shape()) {
      found->name = "scaled-shape";
      found->sentence = "MAC = 1: the same shape in another scale or with another sign";
    }
    return found;
  }

  [[nodiscard]] bool is_mode_shape() const {
    const auto& key = reference_.resource.primary_key;
    return std::ranges::count(key, "mode") + std::ranges::count(key, "x") == 2;
  }

  // The wrong models that only multiply the quantity.
  [[nodiscard]] std::vector<std::string> named_by(const Pattern& found, const std::string& field) const {
    std::vector<std::string> names{found.name};
    const auto quantity = quantity_of(field);
    if (found.factor == 0.0 || !quantity) return names;
    const double halved = *quantity == Quantity::critical_amplitude && !is_force_ratio() ? 2.0 : 0.5;
    for (const auto& [name, factor] : {std::pair{"force-sign", -1.0}, {"peak-to-peak-amplitude", halved}}) {
      if (found.factor == factor && std::ranges::count(wrong_model_named(name).changes, *quantity) > 0)
        names.emplace_back(name);
    }
    return names;
  }

  // --- another column, single values

  // The values of another compared column, at the same rows.
  [[nodiscard]] Found other_column(const Comparison::Quantity& quantity, const ComparedValues& values,
                                   const Series& group) const {
    for (const Comparison::Quantity& other : comparison_.quantities)
      for (const Series& series : other.series) {
        if (other.name == quantity.name || series.group != group.group || series.abscissa != group.abscissa)
          continue;
        if (auto found = accepted(
                values,
                {.name = "other-column", .sentence = fmt::format("the values are those of {}", other.name)},
                series.reference, 0, static_cast<int>(comparison_.quantities.size())))
          return found;
      }
    return {};
  }

  // At most a twentieth of the values differ, or one, ten times as much as any other. Both numbers are empirical.
  [[nodiscard]] Found single_values(const Series& group) const {
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
    Pattern pattern{.name = "single-values",
                    .sentence = fmt::format("only {} of {} values differ{}", wrong.size(), size,
                                            wrong.size() == 1 ? "s" : "")};
    const bool has_place =
        !comparison_.abscissa.empty() && (!is_of_rows() || reference_.resource.primary_key.size() == 1);
    if (has_place)
      pattern.sentence +=
          fmt::format(", {}at {} = {:.9g}{}{}", wrong.size() == 1 ? "" : "the first ", comparison_.abscissa,
                      group.abscissa[wrong.front()], comparison_.abscissa_unit.empty() ? "" : " ",
                      comparison_.abscissa_unit);
    return pattern;
  }

  // --- another data set

  // It must have half of the user's rows, and explain a difference in one of them.
  [[nodiscard]] Found other_values(const Comparison::Quantity& quantity, const ComparedValues& values,
                                   const Series& group) const {
    if (comparison_.abscissa.empty() || comparison_.kind == data::ComparisonKind::events || is_of_rows())
      return {};
    const auto& key = reference_.resource.primary_key;
    std::vector<data::ReferenceTable> tables;
    for (const data::Resource& other : package_.resources) {
      const data::Field* field = other.field(quantity.name);
      if (other.name != comparison_.name && field != nullptr && field->unit == quantity.unit &&
          other.comparison && other.comparison->kind == comparison_.kind && other.primary_key == key)
        tables.push_back(data::read_table(package_, other.name));
    }
    for (const data::ReferenceTable& table : tables) {
      const auto predicted = at_the_same_rows(table, quantity.name, group);
      std::size_t shared = 0;
      bool differs_there = false;
      for (std::size_t i = 0; i < predicted.size(); ++i) {
        if (std::isnan(predicted[i])) continue;
        ++shared;
        differs_there = differs_there || differs_at(group, i);
      }
      if (2 * shared < predicted.size() || !differs_there) continue;
      if (auto found = accepted(values,
                                {.name = "other-data-set",
                                 .sentence = fmt::format("the values are those of {}", table.resource.name)},
                                predicted, 0, static_cast<int>(tables.size())))
        return found;
    }
    return {};
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
    return Matcher(reference_, theirs_).label(columns, row);
  }

  // --- the wrong models

  [[nodiscard]] bool is_force_ratio() const { return rule_ != nullptr && rule_->quantity == "force ratio"; }

  // The quantity of the wrong models; that of f beside y in a history as well.
  [[nodiscard]] std::optional<Quantity> quantity_of(const std::string& field) const {
    if (rule_ == nullptr) return std::nullopt;
    if (is_force_ratio()) return Quantity::critical_amplitude;
    const auto* const known = std::ranges::find(all_quantities, rule_->quantity, name_of);
    if (known == all_quantities.end())
      throw data::InputError(fmt::format("the quantity '{}' of a diagnosis is unknown", rule_->quantity));
    if (field == rule_->value) return *known;
    if (field != "friction_force") return std::nullopt;
    if (*known == Quantity::stick_displacement) return Quantity::stick_force;
    if (*known == Quantity::tip_displacement) return Quantity::friction_force;
    return std::nullopt;
  }

  // The case that the data set names for a group, or that of its beam, with the numbers of its problem; empty if
  // there is none.
  [[nodiscard]] std::optional<data::Case> case_of(const Series& group) const {
    const data::StatedProblem& stated = reference_.resource.stated;
    std::string name = rule_ == nullptr ? stated.beam : rule_->case_name;
    for (std::size_t row = 0; rule_ != nullptr && name.empty() && row < reference_.rows(); ++row)
      if (group.group.empty() || label_of(row) == group.group)
        name = reference_.column(rule_->case_column).text[row];
    try {
      auto numbers = data::numbers_of(data::load_case(name));
      for (const auto& [key, number] : stated.numbers) numbers[key] = number;
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
        numbers["numerics.velocity_threshold"] = 1e-4;
      }
      return data::case_with(name, numbers);
    } catch (const data::InputError&) {
      return std::nullopt;
    }
  }

  // The values at the node beside the middle, on some mesh. Its effect is that on a run of 20 elements, to the nearest
  // step.
  [[nodiscard]] Found beside_the_middle(const ComparedValues& values, const data::Case& problem) const {
    constexpr int finest = 40;
    constexpr double periods = 5.0;
    data::NumericalChoices choices = problem.numerics.choices();
    choices.time_step = 1.0 / (1600.0 * problem.excitation.frequency_hz());
    const bool is_held = reference_.resource.stated.tip == "held";
    solver::BeamSimulation run(
        problem.beam, problem.friction, problem.excitation, data::NumericalSettings(choices),
        {.contact = is_held ? solver::TipContact::bonded : solver::TipContact::friction,
         .damping = problem.damping});
    ComparedValues early = values;
    const auto end = std::ranges::upper_bound(values.abscissa, periods / problem.excitation.frequency_hz());
    const auto count = static_cast<std::size_t>(end - values.abscissa.begin());
    for (auto* column : {&early.abscissa, &early.theirs, &early.reference}) column->resize(count);
    std::map<double, std::vector<double>> predicted;  // by x/L
    for (std::size_t i = 0; i < count; ++i) {
      while (run.time() + 0.5 * choices.time_step < values.abscissa[i]) run.step();
      for (int elements = 4; elements <= finest; elements += 2)
        for (const double side : {-1.0, 1.0}) {
          const double place = 0.5 + side / elements;
          predicted[place].push_back(early.reference[i] + run.displacement(place * problem.beam.length()) -
                                     run.midspan_displacement());
        }
    }
    Found best;
    for (const auto& [place, here] : predicted)
      if (auto found =
              accepted(early,
                       {.name = "beside-the-middle",
                        .sentence = fmt::format("the values are those at x = {:.4g} L, the node beside the "
                                                "middle on {:.0f} elements",
                                                place, 1.0 / std::abs(place - 0.5))},
                       here, 0, static_cast<int>(predicted.size()));
          found && (!best || found->remaining < best->remaining))
        best = found;
    return best;
  }

  // The case with the values of the columns of a row.
  [[nodiscard]] data::Case case_of_row(data::Case problem, std::size_t row) const {
    for (const auto& [name, parameter] : {std::pair{"frequency", "excitation.frequency_hz"},
                                          {"amplitude", "excitation.amplitude"},
                                          {"length", "beam.length"},
                                          {"axial_force", "beam.axial_force"}})
      if (std::ranges::count(reference_.resource.primary_key, name) > 0)
        problem = with_value(problem, parameter, reference_.column(name).values[row]);
    return problem;
  }

  // What is observed, with the truth and, if each row is a case, the cases.
  struct Observed {
    Observation observation;
    std::vector<double> truth;
    std::vector<data::Case> cases;
  };

  [[nodiscard]] std::vector<Pair> pairs_of(const Series& group, const std::string& field,
                                           double latest) const {
    std::vector<Pair> pairs;
    const double end = std::min(
        {latest, reference_.resource.comparison->horizon.value_or(latest), settings_.until.value_or(latest)});
    const data::Column* time =
        comparison_.abscissa_unit == "s" ? theirs_.column(comparison_.abscissa) : nullptr;
    for (std::size_t row = 0; row < theirs_.rows(); ++row) {
      if (time != nullptr && time->values[row] > end) continue;
      const auto found = row_like(reference_, reference_.resource.primary_key, theirs_.columns, row);
      if (!found || !std::isfinite(reference_.column(field).values[*found])) continue;
      if (group.group.empty() || label_of(*found) == group.group) pairs.push_back({row, *found});
    }
    return pairs;
  }

  // Onsets and captures, not reversals, in their sequence.
  [[nodiscard]] std::vector<Pair> pairs_of_events() const {
    const auto rows_of = [](const data::Column& change) {
      Rows rows;
      for (std::size_t row = 0; row < change.text.size(); ++row)
        if (change.text[row] == "onset" || change.text[row] == "capture") rows.push_back(row);
      return rows;
    };
    const Rows theirs = rows_of(*theirs_.column("change")), reference = rows_of(reference_.column("change"));
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < std::min({theirs.size(), reference.size(), std::size_t{12}}); ++i)
      pairs.push_back({theirs[i], reference[i]});
    return pairs;
  }

  // The wrong models are tried up to this time: five periods of stick and slip, or three without damping. Later on,
  // small errors grow.
  static double end_of(Quantity quantity, const data::Case& problem) {
    const bool is_history = quantity == Quantity::tip_displacement || quantity == Quantity::friction_force;
    const double periods = is_damped(problem) ? 5.0 : 3.0;
    return is_history ? periods / problem.excitation.frequency_hz() : std::numeric_limits<double>::infinity();
  }

  [[nodiscard]] Observed observed(const Comparison::Quantity& compared, Quantity quantity,
                                  const Series& group, const data::Case& problem) const {
    const bool is_event = quantity == Quantity::contact_event;
    const bool is_slow = quantity == Quantity::force_maximum || quantity == Quantity::critical_amplitude;
    const auto pairs =
        spread(is_event ? pairs_of_events() : pairs_of(group, compared.name, end_of(quantity, problem)),
               is_slow ? 8 : 400);
    const data::Column &values = *theirs_.column(compared.name), &truth = reference_.column(compared.name);
    const auto half_width = reference_.radius_of(compared.name);
    const double scale = group.allowed.empty() ? compared.tolerance : group.allowed[0] - group.half_width[0];
    Observed result{.observation = {.quantity = quantity, .abscissa = {}, .values = {}, .uncertainty = {}},
                    .truth = {},
                    .cases = {}};
    for (const auto& [row, reference_row] : pairs) {
      double value = values.values[row], right = truth.values[reference_row];
      double uncertainty =
          half_width[reference_row] +
          (compared.norm == data::Norm::relative ? compared.tolerance * std::abs(right) : scale);
      if (is_slow) result.cases.push_back(case_of_row(problem, reference_row));
      if (is_force_ratio()) {
        const double amplitude = result.cases.back().excitation.amplitude();
        uncertainty *= amplitude / (right * right);
        value = amplitude / value, right = amplitude / right;
      }
      result.observation.abscissa.push_back(is_event ? static_cast<double>(result.truth.size() + 1)
                                            : is_slow
                                                ? result.cases.back().excitation.frequency_hz()
                                                : reference_.column(rule_->abscissa).values[reference_row]);
      result.observation.values.push_back(value);
      result.observation.uncertainty.push_back(uncertainty);
      result.truth.push_back(right);
    }
    return result;
  }

  static std::string up_to(double time) {
    return std::isfinite(time) ? fmt::format(" up to {:g} s", time) : "";
  }

  // Whether there is a diagnosis, or a reason why there is none.
  bool diagnose_by_models(Likeness& likeness, const Comparison::Quantity& compared, const Series& group,
                          const data::Case& problem) {
    const auto quantity = quantity_of(compared.name);
    if (!quantity) return false;
    try {
      const Observed seen = observed(compared, *quantity, group, problem);
      if (seen.truth.empty()) return false;
      if (is_of_all_modes(seen)) {
        likeness.sentence = fmt::format("like all modes: the data set has {}", problem.numerics.modes());
        const std::string of_all = comparison_.name + "-all-modes";
        if (std::ranges::count(package_.resources, of_all, &data::Resource::name) > 0)
          likeness.sentence += fmt::format(", and {} has all", of_all);
        likeness.diagnosis = Diagnosis{.finding = Finding::mistaken, .named = {"all-modes"}};
        return true;
      }
      const auto& [what, abscissa, values, uncertainty] = seen.observation;
      const ModelResults computed = seen.cases.empty()
                                        ? model_results(problem, what, abscissa, settings_.progress)
                                        : model_results(seen.cases, what, abscissa, settings_.progress);
      const Diagnosis found = studies::diagnose(relative_to_data(computed, seen.truth), seen.observation);
      likeness.sentence =
          found.finding == Finding::correct
              ? fmt::format("no diagnosis: the difference of {}{} is too small to be assigned to a mistake",
                            percent(found.from_reference), up_to(end_of(*quantity, problem)))
              : sentence(found) + where_told_apart(found, *quantity);
      likeness.diagnosis = found;
    } catch (const data::InputError& error) {  // there is no such state
      likeness.sentence = fmt::format("no diagnosis: {}", error.what());
    }
    return true;
  }

  // Whether the values of a maximum are three times nearer to those of all modes than to the data set. Three
  // is empirical.
  static bool is_of_all_modes(const Observed& seen) {
    constexpr double ratio = 3.0;
    double all_modes = 0.0, data_set = 0.0;
    for (std::size_t i = 0; i < seen.cases.size(); ++i) {
      const auto& [quantity, abscissa, values, uncertainty] = seen.observation;
      const double right = reference_result(seen.cases[i], quantity, {abscissa[i]}).front();
      all_modes += std::pow(values[i] / right - 1.0, 2);
      data_set += std::pow(values[i] / seen.truth[i] - 1.0, 2);
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

  Comparison& comparison_;
  const data::ReferencePackage& package_;
  const data::ReferenceTable& reference_;
  const data::DiagnosisRule* rule_;
  const data::UserTable& theirs_;
  const ComparisonSettings& settings_;
  std::vector<Joined> joined_;
};

}  // namespace

void find_likenesses(Comparison& comparison, const data::ReferencePackage& package,
                     const data::ReferenceTable& reference, const data::UserTable& theirs,
                     const ComparisonSettings& settings) {
  Search(comparison, package, reference, theirs, settings).run();
}

}  // namespace stickslip::studies
