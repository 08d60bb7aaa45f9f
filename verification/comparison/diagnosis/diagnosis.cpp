// SPDX-License-Identifier: MIT
#include "comparison/diagnosis/diagnosis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "comparison/diagnosis/relations.hpp"
#include "comparison/diagnosis/wrong_model_recipes.hpp"
#include "comparison/groups.hpp"
#include "comparison/samples.hpp"
#include "stickslip/data/case_file.hpp"
#include "studies/common/problem_parameter.hpp"

namespace stickslip::comparison {

namespace {

using Series = Comparison::Series;
using SeenRows = std::vector<std::pair<double, std::size_t>>;  // a user's value, and the row of the data set

bool differs(const Series& series) {
  for (std::size_t i = 0; i < series.theirs.size(); ++i)
    if (series.differs_at(i)) return true;
  return false;
}

// --- the problem that a data set states

bool is_force_ratio(const data::Resource& resource) {
  return resource.diagnosis && resource.diagnosis->quantity == "force ratio";
}

Quantity quantity_of_rule(const data::DiagnosisRule& rule) {
  if (rule.quantity == "force ratio") return Quantity::critical_amplitude;
  const auto* const found = std::ranges::find(quantities, rule.quantity, &QuantityProperties::name);
  if (found == quantities.end())
    throw data::InputError(fmt::format("the quantity '{}' of a diagnosis is unknown", rule.quantity));
  return found->quantity;
}

// Empty if the data set has no state of which there are wrong models.
std::optional<State> state_of(const data::Resource& resource) {
  if (resource.diagnosis) return properties_of(quantity_of_rule(*resource.diagnosis)).state;
  const data::StatedProblem& stated = resource.stated;
  if (resource.field("heat") != nullptr && resource.primary_key == std::vector<std::string>{"frequency"} &&
      !stated.beam.empty())
    return State::steady;
  if (!is_of_one_motion(resource)) return std::nullopt;
  const auto damping = stated.numbers.find("damping.kelvin_voigt");
  const bool is_damped = damping != stated.numbers.end() && damping->second != 0.0;
  return stated.tip == "held" && !is_damped ? State::held : State::stick_slip;
}

// The quantity of the wrong models. Of fields it is that in the middle of the beam.
std::optional<Quantity> quantity_of(const data::Resource& resource, const std::string& field) {
  if (resource.diagnosis && field == resource.diagnosis->value) return quantity_of_rule(*resource.diagnosis);
  const auto state = state_of(resource);
  for (const QuantityProperties& one : quantities)
    if (one.state == state && !one.field.empty() && (one.field == field || one.field == "midspan_" + field))
      return one.quantity;
  return std::nullopt;
}

// The case that the data set names for a group, or that of its beam, with the numbers of its problem; empty if there is none.
std::optional<data::Case> case_of(const DeviatingQuantity& deviating) {
  const data::ReferenceTable& reference = deviating.reference;
  const std::string& group = deviating.series.group;
  const data::Resource& resource = reference.resource;
  const data::StatedProblem& stated = resource.stated;
  std::string name = resource.diagnosis ? resource.diagnosis->case_name : stated.beam;
  const std::string column = resource.diagnosis ? resource.diagnosis->case_column : "beam";
  for (std::size_t row = 0; name.empty() && resource.field(column) != nullptr && row < reference.rows();
       ++row)
    if (group.empty() || group_of(reference, deviating.comparison.abscissa, row) == group)
      name = reference.column(column).text[row];
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
      numbers["numerics.spectral_radius"] = 0.9;
      numbers["numerics.velocity_threshold"] = 1e-4;
    }
    return data::case_with(name, numbers);
  } catch (const data::InputError&) {
    return std::nullopt;
  }
}

// The case with the values of the columns of a row.
data::Case case_of_row(data::Case problem, const data::ReferenceTable& reference, std::size_t row) {
  for (const auto& [name, parameter] : {std::pair{"frequency", "excitation.frequency_hz"},
                                        {"amplitude", "excitation.amplitude"},
                                        {"length", "beam.length"},
                                        {"axial_force", "beam.axial_force"}})
    if (std::ranges::count(reference.resource.primary_key, name) > 0)
      problem = data::with_value(problem, parameter, reference.column(name).values[row]);
  return problem;
}

// --- what is observed

// The values beside those of the data set, with bounds of their errors and, if each row is a case, the cases.
struct Observation {
  QuantityProperties quantity;
  data::Case problem;
  double latest{};  // s; nothing later was taken
  Series series{};
  std::vector<data::Case> cases{};
};

// At most `count` of the items, evenly from the first to the last.
SeenRows spread(const SeenRows& items, std::size_t count) {
  if (items.size() <= count) return items;
  SeenRows kept;
  for (std::size_t i = 0; i < count; ++i) kept.push_back(items[i * (items.size() - 1) / (count - 1)]);
  return kept;
}

// A user's values at the times of the data set.
SeenRows interpolated(const DeviatingQuantity& deviating, const data::Column& time, double end) {
  const Samples samples{.abscissa = time.values,
                        .values = deviating.theirs.column(deviating.quantity.name)->values,
                        .half_width = std::vector<double>(time.values.size())};
  SeenRows seen;
  if (!std::ranges::is_sorted(samples.abscissa)) return seen;
  const auto& times = deviating.reference.column(time.field.name).values;
  for (std::size_t row = 0; row < times.size(); ++row) {
    if (times[row] < samples.abscissa.front() || times[row] > std::min(end, samples.abscissa.back()))
      continue;
    if (const auto value = comparison::interpolated(samples, times[row]))
      seen.emplace_back(value->value, row);
  }
  return seen;
}

// The rows of the group, of fields those in the middle of the beam.
SeenRows seen_rows(const DeviatingQuantity& deviating, const data::Beam& beam, double latest) {
  const auto& [comparison, package, reference, theirs, quantity, series] = deviating;
  constexpr std::size_t few = 20;
  const double end = std::min(latest, comparison.horizon);
  const data::Column* const time =
      theirs.column(comparison.abscissa_unit == "s" ? comparison.abscissa : "time");
  const data::Column* const place = time == nullptr ? nullptr : theirs.column("x");
  SeenRows seen;
  for (std::size_t row = 0; row < theirs.rows(); ++row) {
    if (time != nullptr && time->values[row] > end) continue;
    if (place != nullptr && !data::is_same_key(place->values[row], 0.5 * beam.length())) continue;
    const auto found = row_like(reference, reference.resource.primary_key, theirs.columns, row);
    if (found && std::isfinite(reference.column(quantity.name).values[*found]) &&
        (series.group.empty() || group_of(reference, comparison.abscissa, *found) == series.group))
      seen.emplace_back(theirs.column(quantity.name)->values[row], *found);
  }
  return time != nullptr && place == nullptr && seen.size() < few ? interpolated(deviating, *time, end)
                                                                  : seen;
}

// Onsets and captures, not reversals, in their sequence.
SeenRows seen_events(const DeviatingQuantity& deviating) {
  const auto rows_of = [](const data::Column& change) {
    Rows rows;
    for (std::size_t row = 0; row < change.text.size(); ++row)
      if (change.text[row] == "onset" || change.text[row] == "capture") rows.push_back(row);
    return rows;
  };
  const Rows theirs = rows_of(*deviating.theirs.column("change")),
             reference = rows_of(deviating.reference.column("change"));
  SeenRows seen;
  for (std::size_t i = 0; i < std::min({theirs.size(), reference.size(), std::size_t{12}}); ++i)
    seen.emplace_back(deviating.theirs.column("time")->values[theirs[i]], reference[i]);
  return seen;
}

// The wrong models are tried for five periods of stick and slip, or three without damping. Later on, small errors grow.
double latest_of(const data::Resource& resource, const data::Case& problem,
                 const QuantityProperties& quantity) {
  if (quantity.state != State::stick_slip || quantity.abscissa != Abscissa::time ||
      resource.stated.tip == "held")
    return std::numeric_limits<double>::infinity();
  return (problem.damping.is_none() ? 3.0 : 5.0) / problem.excitation().frequency_hz();
}

SeenRows seen_of(const DeviatingQuantity& deviating, const Observation& observation) {
  if (observation.quantity.quantity == Quantity::contact_event) return seen_events(deviating);
  const State state = observation.quantity.state;
  const SeenRows seen = seen_rows(deviating, observation.problem.beam(), observation.latest);
  return spread(seen, state == State::largest ? 8 : state == State::steady ? 30 : 400);
}

std::optional<Observation> observed(const DeviatingQuantity& deviating, Quantity quantity) {
  const auto problem = case_of(deviating);
  if (!problem) return std::nullopt;
  const data::ReferenceTable& reference = deviating.reference;
  const Comparison::Quantity& compared = deviating.quantity;
  const Series& series = deviating.series;
  const auto& rule = reference.resource.diagnosis;
  Observation all{.quantity = properties_of(quantity), .problem = *problem};
  all.latest = latest_of(reference.resource, *problem, all.quantity);
  const auto& abscissa = reference.column(rule                                  ? rule->abscissa
                                          : all.quantity.state == State::steady ? "frequency"
                                                                                : "time");
  const auto half_width = reference.radius_of(compared.name);
  const double scale = series.allowed.empty() ? compared.tolerance : series.allowed[0] - series.half_width[0];
  for (auto [value, row] : seen_of(deviating, all)) {
    double right = reference.column(compared.name).values[row], x = abscissa.values[row];
    double uncertainty =
        half_width[row] +
        (compared.norm == data::Norm::relative ? compared.tolerance * std::abs(right) : scale);
    if (quantity == Quantity::contact_event) x = static_cast<double>(all.series.abscissa.size() + 1);
    if (all.quantity.state == State::largest) {
      all.cases.push_back(case_of_row(*problem, reference, row));
      x = all.cases.back().excitation().frequency_hz();
    }
    if (is_force_ratio(reference.resource)) {
      const double amplitude = all.cases.back().excitation().amplitude();
      uncertainty *= amplitude / (right * right);
      value = amplitude / value, right = amplitude / right;
    }
    all.series.abscissa.push_back(x);
    all.series.theirs.push_back(value);
    all.series.reference.push_back(right);
    all.series.allowed.push_back(uncertainty);
  }
  return all.series.abscissa.empty() ? std::nullopt : std::optional(all);
}

// --- the wrong models

// The values of a maximum with all modes, where the data set has some of them.
Hypothesis all_modes(const DeviatingQuantity& deviating, const Observation& seen) {
  const std::string of_all = deviating.comparison.name + "-all-modes";
  Hypothesis one{.name = "all-modes", .kind = Kind::all_modes};
  for (std::size_t i = 0; i < seen.cases.size(); ++i)
    one.values.push_back(
        reference_result(seen.cases[i], seen.quantity.quantity, {seen.series.abscissa[i]}).front());
  one.sentence = fmt::format("like all modes: the data set has {}", seen.problem.numerics.modes());
  if (std::ranges::count(deviating.package.resources, of_all, &data::Resource::name) > 0)
    one.sentence += fmt::format(", and {} has all", of_all);
  return judged(seen.quantity.norm, seen.series, one, 1.0);
}

// A data set that some of many named mistakes change and others do not.
std::string where_told_apart(const Diagnosis& found, const data::ReferencePackage& package,
                             std::string_view quantity) {
  if (found.finding != Finding::mistaken || found.named.size() < 2) return "";
  for (const data::Resource& other : package.resources) {
    if (!other.diagnosis || other.diagnosis->quantity == quantity) continue;
    const auto changed = std::ranges::count_if(found.named, [&](const std::string& name) {
      return std::ranges::count(recipe_of(name).wrong_model.changes, other.diagnosis->quantity,
                                [](Quantity one) { return properties_of(one).name; }) > 0;
    });
    if (changed > 0 && changed < std::ssize(found.named))
      return fmt::format("; the data set {} tells some of them apart", other.name);
  }
  return "";
}

Diagnosis diagnosed_by_models(const DeviatingQuantity& deviating, const Observation& seen,
                              const std::function<void(double)>& progress) {
  const Quantity quantity = seen.quantity.quantity;
  const std::vector<double>& abscissa = seen.series.abscissa;
  const ModelResults computed = seen.cases.empty() ? model_results(seen.problem, quantity, abscissa, progress)
                                                   : model_results(seen.cases, quantity, abscissa, progress);
  Diagnosis found =
      diagnose(relative_to_data(computed, seen.series.reference), seen.series.theirs, seen.series.allowed);
  if (found.finding == Finding::correct && std::isfinite(seen.latest))
    found.sentence += fmt::format(", up to {:g} s", seen.latest);
  found.sentence += where_told_apart(found, deviating.package, seen.quantity.name);
  return found;
}

// --- the nearest of all hypotheses

bool event_sequences_differ(const DeviatingQuantity& deviating) {
  return deviating.comparison.kind == data::ComparisonKind::events && deviating.quantity.name == "time" &&
         std::ranges::any_of(deviating.comparison.quantities, [](const Comparison::Quantity& one) {
           return one.name == "sequence" && one.agreement == Agreement::differs;
         });
}

// Events by their number, as many as both have. A common factor or delay leaves no pairs that are near in time.
DeviatingQuantity in_sequence(DeviatingQuantity deviating) {
  const auto& [comparison, package, reference, theirs, quantity, series] = deviating;
  std::vector<std::string> columns = data::group_columns(reference.resource);
  std::erase(columns, comparison.abscissa);
  Series all;
  all.group = series.group;
  for (const Group& group : comparison::groups_of(reference, theirs, columns)) {
    if (group.label != series.group) continue;
    for (std::size_t i = 0; i < std::min(group.theirs.size(), group.reference.size()); ++i) {
      all.theirs.push_back(theirs.column("time")->values[group.theirs[i]]);
      all.reference.push_back(reference.column("time").values[group.reference[i]]);
      all.allowed.push_back(quantity.tolerance *
                            unit_of(quantity.norm, all.reference.back(), all.reference.back()));
    }
  }
  all.abscissa = all.reference;
  deviating.series = std::move(all);
  return deviating;
}

// The wrong model that does the same to the quantity; empty if there is none.
std::string namesake_of(const Hypothesis& found, const DeviatingQuantity& deviating,
                        std::optional<Quantity> quantity) {
  if (!quantity || (found.name != "constant-factor" && found.name != "scaled-shape")) return "";
  const bool is_amplitude =
      quantity == Quantity::critical_amplitude && !is_force_ratio(deviating.reference.resource);
  for (const auto& [name, factor] :
       {std::pair{"force-sign", -1.0}, {"peak-to-peak-amplitude", is_amplitude ? 2.0 : 0.5}}) {
    const bool is_multiple = std::ranges::equal(found.values, deviating.series.reference, {}, {},
                                                [f = factor](double value) { return f * value; });
    if (is_multiple && std::ranges::count(recipe_of(name).wrong_model.changes, *quantity) > 0) return name;
  }
  return "";
}

// What follows the sentence of a relation, which groups share.
std::string ending_of(const Diagnosis& one) {
  if (one.finding != Finding::mistaken || one.required_ratio > 0.0) return "";
  return (one.distance > 1e-12 ? ", to " + percent(one.distance) : "") +
         (one.named.size() > 1 ? fmt::format(": like '{}'", one.named.back()) : "");
}

// Adds the nearest of each name to the list.
void add_ranked(std::vector<Hypothesis>& ranked, const std::vector<Hypothesis>& relations) {
  ranked.insert(ranked.end(), relations.begin(), relations.end());
  std::ranges::stable_sort(ranked, {}, rank_of);
  std::vector<Hypothesis> nearest;
  for (Hypothesis& one : ranked)
    if (std::ranges::count(nearest, one.name, &Hypothesis::name) == 0) nearest.push_back(std::move(one));
  ranked = std::move(nearest);
}

Diagnosis diagnosed(const DeviatingQuantity& deviating, const std::function<void(double)>& progress) {
  std::vector<Hypothesis> tried = relations_of(deviating);
  if (event_sequences_differ(deviating))
    for (Hypothesis& one : relations_of(in_sequence(deviating))) tried.push_back(std::move(one));
  const auto quantity = quantity_of(deviating.reference.resource, deviating.quantity.name);
  Diagnosis by_models;
  try {
    const auto seen =
        quantity && !is_explained(deviating, tried) ? observed(deviating, *quantity) : std::nullopt;
    if (seen && !seen->cases.empty()) tried.push_back(all_modes(deviating, *seen));
    if (seen && !is_explained(deviating, tried)) by_models = diagnosed_by_models(deviating, *seen, progress);
  } catch (const data::InputError& error) {  // there is no such state
    by_models.sentence = fmt::format("no diagnosis: {}", error.what());
  }
  const Hypothesis* const nearest = nearest_of(tried);
  Diagnosis found = std::move(by_models);
  if (nearest != nullptr && !(found.finding == Finding::mistaken && found.distance < rank_of(*nearest))) {
    found = {.sentence = nearest->sentence,
             .finding = Finding::mistaken,
             .from_reference = nearest->from_reference,
             .distance = nearest->distance,
             .ranked = std::move(found.ranked),
             .named = {nearest->name}};
    const std::string namesake = namesake_of(*nearest, deviating, quantity);
    if (!namesake.empty()) found.named.push_back(namesake);
  }
  if (found.sentence.empty())
    found.sentence =
        "no diagnosis: no factor, constant, other column or other data set explains it, and no known mistake "
        "concerns it";
  // Events may be missing although the times agree.
  if (found.finding != Finding::mistaken && !differs(deviating.series)) found.sentence.clear();
  add_ranked(found.ranked, tried);
  return found;
}

}  // namespace

std::vector<Diagnosis> diagnose(const Comparison& comparison, const data::ReferencePackage& package,
                                const data::ReferenceTable& reference, const data::UserTable& theirs,
                                const std::function<void(double)>& progress) {
  if (comparison.agreement != Agreement::differs) return {};
  const data::Resource& resource = reference.resource;
  const data::UserTable with_keys = with_keys_of(reference, theirs, resource.comparison->abscissa);
  std::vector<std::pair<Diagnosis, int>> found;
  for (const Comparison::Quantity& quantity : comparison.quantities) {
    if (resource.field(quantity.name) == nullptr) continue;  // a count of events or phases
    for (const Series& series : groups_of(comparison, quantity, resource)) {
      const DeviatingQuantity deviating{comparison, package, reference, with_keys, quantity, series};
      if (!differs(series) && !event_sequences_differ(deviating)) continue;
      Diagnosis one = diagnosed(deviating, progress);
      one.group = series.group, one.quantity = quantity.name;
      const auto known = std::ranges::find_if(found, [&](const auto& other) {
        return other.first.quantity == one.quantity && other.first.sentence == one.sentence;
      });
      if (known != found.end())
        ++known->second;
      else if (!one.sentence.empty())
        found.emplace_back(std::move(one), 1);
    }
  }
  std::vector<Diagnosis> diagnoses;
  for (auto& [one, groups] : found) {
    one.sentence += ending_of(one);
    if (groups > 1) one.group += fmt::format(" and {} more", groups - 1);
    diagnoses.push_back(std::move(one));
  }
  return diagnoses;
}

}  // namespace stickslip::comparison
