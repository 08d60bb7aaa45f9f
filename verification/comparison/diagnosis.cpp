// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "comparison/wrong_models.hpp"

namespace stickslip::studies {

namespace {

// Allowed probability that an unrelated error is assigned to a wrong model.
constexpr double accidental_share = 0.01;
constexpr double least_ratio = 3.0;
constexpr std::size_t most_named = 3;  // in a sentence

bool is_scaled_by_entry(Quantity quantity) {
  switch (quantity) {
    case Quantity::stick_frequency:
    case Quantity::slip_frequency:
    case Quantity::force_maximum:
    case Quantity::critical_amplitude:
    case Quantity::contact_event:
      return true;
    default:
      return false;
  }
}

double root_mean_square(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// (a - b)/s for each entry, s of ModelResults.
std::vector<double> scaled_difference(const ModelResults& model_results, const std::vector<double>& a,
                                      const std::vector<double>& b) {
  const bool by_entry = is_scaled_by_entry(model_results.quantity);
  const double common = root_mean_square(model_results.reference);
  std::vector<double> difference;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference.push_back((a[i] - b[i]) / (by_entry ? std::abs(model_results.reference[i]) : common));
  return difference;
}

// The number K and the dimension n of Diagnosis.
struct Field {
  double count{}, dimension{1.0};
};
Field field_of(const ModelResults& model_results, double uncertainty) {
  std::vector<std::vector<double>> directions;
  for (const auto& wrong_model : model_results.wrong_models) {
    if (!std::isfinite(wrong_model.from_reference) || wrong_model.from_reference <= uncertainty) continue;
    directions.push_back(scaled_difference(model_results, wrong_model.values, model_results.reference));
    const double length = root_mean_square(directions.back());
    for (double& component : directions.back()) component /= length;
  }
  double sum = 0.0;
  for (const auto& a : directions)
    for (const auto& b : directions) {
      double cosine = 0.0;
      for (std::size_t i = 0; i < a.size(); ++i) cosine += a[i] * b[i];
      cosine /= static_cast<double>(a.size());
      sum += cosine * cosine;
    }
  if (directions.empty()) return {};
  const auto count = static_cast<double>(directions.size());
  return {.count = count, .dimension = count * count / sum};
}

void require_same_size(const char* what, std::size_t size, std::size_t expected) {
  if (size != expected)
    throw std::invalid_argument(fmt::format(
        "the observation has {} {}, but must have as many as the abscissa, {}", size, what, expected));
}

void require_usable(const ModelResults& model_results, const Observation& observation) {
  if (observation.quantity != model_results.quantity || observation.abscissa != model_results.abscissa)
    throw std::invalid_argument(
        "the observation has another quantity or abscissa, but must have those of the comparison");
  require_same_size("values", observation.values.size(), observation.abscissa.size());
  require_same_size("uncertainties", observation.uncertainty.size(), observation.abscissa.size());
  for (const double value : observation.values)
    if (!std::isfinite(value)) throw data::FieldError("a value of the observation", value, "finite");
  for (const double uncertainty : observation.uncertainty)
    if (!(uncertainty >= 0.0 && std::isfinite(uncertainty)))
      throw data::FieldError("an uncertainty of the observation", uncertainty, "finite and not negative");
}

// The nearest wrong model that changes something: the others are no explanation. Null if there is none.
const Candidate* nearest_of(const Diagnosis& diagnosis) {
  const auto found = std::ranges::find_if(
      diagnosis.ranked, [&](const Candidate& one) { return one.from_reference > diagnosis.uncertainty; });
  return found == diagnosis.ranked.end() ? nullptr : &*found;
}

std::string quoted(const std::vector<std::string>& names) {
  return fmt::format("'{}'", fmt::join(names, "', '"));
}

}  // namespace

ModelResults relative_to_data(ModelResults result, const std::vector<double>& data) {
  const std::vector<double> right = std::exchange(result.reference, data);
  const bool by_entry = is_scaled_by_entry(result.quantity);
  for (ModelResults::Member& member : result.wrong_models) {
    for (std::size_t i = 0; i < data.size(); ++i)
      member.values[i] =
          by_entry ? data[i] * (member.values[i] / right[i]) : data[i] + (member.values[i] - right[i]);
    member.from_reference = distance(result, member.values, data);
  }
  result.reference_uncertainty = distance(result, right, data);
  return result;
}

double distance(const ModelResults& model_results, const std::vector<double>& a,
                const std::vector<double>& b) {
  const double result = root_mean_square(scaled_difference(model_results, a, b));
  return std::isfinite(result) ? result : std::numeric_limits<double>::infinity();
}

Diagnosis diagnose(const ModelResults& model_results, const Observation& observation) {
  require_usable(model_results, observation);
  const auto& uncertainty = observation.uncertainty;
  Diagnosis diagnosis;
  diagnosis.from_reference = distance(model_results, observation.values, model_results.reference);
  diagnosis.uncertainty = model_results.reference_uncertainty +
                          distance(model_results, uncertainty, std::vector<double>(uncertainty.size(), 0.0));
  const Field field = field_of(model_results, diagnosis.uncertainty);
  diagnosis.required_ratio = std::max(
      least_ratio, std::pow(field.count / (accidental_share * std::log(10.0)), 1.0 / field.dimension));

  for (const auto& wrong_model : model_results.wrong_models)
    diagnosis.ranked.push_back({wrong_model.name,
                                distance(model_results, observation.values, wrong_model.values),
                                wrong_model.from_reference});
  std::ranges::stable_sort(diagnosis.ranked, {}, &Candidate::distance);

  const auto name_indistinguishable_from = [&](const std::vector<double>& model) {
    for (const Candidate& candidate : diagnosis.ranked) {
      const auto member =
          std::ranges::find(model_results.wrong_models, candidate.name, &ModelResults::Member::name);
      if (distance(model_results, member->values, model) <= 2.0 * diagnosis.uncertainty)
        diagnosis.named.push_back(candidate.name);
    }
  };
  if (!std::isfinite(diagnosis.uncertainty)) {
    diagnosis.finding = Finding::undecided;
    return diagnosis;
  }
  if (diagnosis.from_reference <= diagnosis.uncertainty) {
    diagnosis.finding = Finding::correct;
    name_indistinguishable_from(model_results.reference);
    return diagnosis;
  }
  diagnosis.finding = Finding::unexplained;
  const Candidate* const nearest = nearest_of(diagnosis);
  if (nearest == nullptr || nearest->distance * diagnosis.required_ratio > diagnosis.from_reference)
    return diagnosis;
  diagnosis.finding = Finding::mistaken;
  name_indistinguishable_from(
      std::ranges::find(model_results.wrong_models, nearest->name, &ModelResults::Member::name)->values);
  std::erase_if(diagnosis.named, [&](const std::string& name) {
    return std::ranges::find(diagnosis.ranked, name, &Candidate::name)->from_reference <=
           diagnosis.uncertainty;
  });
  return diagnosis;
}

std::string percent(double share) { return fmt::format("{:.2g} %", 100.0 * share); }

std::string sentence(const Diagnosis& diagnosis) {
  const std::string from_reference = percent(diagnosis.from_reference);
  switch (diagnosis.finding) {
    case Finding::correct: {
      std::string text = fmt::format("correct: {} from the reference, within the uncertainty of {}",
                                     from_reference, percent(diagnosis.uncertainty));
      if (diagnosis.named.size() > most_named)
        text += fmt::format("; {} known mistakes cannot be distinguished from the reference",
                            diagnosis.named.size());
      else if (!diagnosis.named.empty())
        text += fmt::format("; {} cannot be distinguished from the reference", quoted(diagnosis.named));
      return text;
    }
    case Finding::mistaken: {
      const std::string& name = diagnosis.named.front();
      const std::vector<std::string> others(diagnosis.named.begin() + 1, diagnosis.named.end());
      const bool are_many = diagnosis.named.size() > most_named;
      std::string text =
          are_many ? fmt::format("like {} known mistakes that cannot be told apart here, the nearest ",
                                 diagnosis.named.size())
                   : "like ";
      text += fmt::format("'{}' ({}) to {}, while the reference is {} away", name,
                          wrong_model_named(name).mistake, percent(nearest_of(diagnosis)->distance),
                          from_reference);
      if (!others.empty() && !are_many) text += fmt::format("; it could as well be {}", quoted(others));
      return text;
    }
    case Finding::undecided:
      return fmt::format("undecided: {} from the reference, which another mesh and step do not confirm",
                         from_reference);
    case Finding::unexplained:
      break;
  }
  std::string text = fmt::format("wrong by {}, not near any known mistake", from_reference);
  if (const Candidate* const nearest = nearest_of(diagnosis))
    text +=
        fmt::format("; the nearest, '{}', is {} away and would have to be within {}", nearest->name,
                    percent(nearest->distance), percent(diagnosis.from_reference / diagnosis.required_ratio));
  return text;
}

}  // namespace stickslip::studies
