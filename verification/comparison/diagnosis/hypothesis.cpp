// SPDX-License-Identifier: MIT
#include "comparison/diagnosis/hypothesis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "stickslip/data/input_error.hpp"

namespace stickslip::comparison {

namespace {

using Values = std::vector<double>;

// Allowed probability that an unrelated error is assigned to a hypothesis.
constexpr double accidental_share = 0.01;
constexpr std::size_t most_named = 3;  // in a sentence

const Acceptance& acceptance_of(Kind kind) {
  return *std::ranges::find(acceptances, kind, &Acceptance::kind);
}

bool is_near(const Hypothesis& one, double whole, double ratio) {
  return one.distance * ratio <= std::min(whole, 1.0) && one.distance <= acceptance_of(one.kind).farthest;
}

double root_mean_square(const Values& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

Values scaled_difference(data::Norm norm, const Values& reference, const Values& a, const Values& b) {
  const Values scales = scales_of(norm, reference);
  Values difference;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference.push_back(a[i] == b[i] ? 0.0 : (a[i] - b[i]) / scales[i]);
  return difference;
}

// The R of the wrong models that change more than the uncertainty.
double ratio_for(const ModelResults& results, double uncertainty) {
  std::vector<Values> directions;
  for (const Hypothesis& one : results.wrong_models) {
    if (!std::isfinite(one.from_reference) || one.from_reference <= uncertainty) continue;
    directions.push_back(scaled_difference(results.norm, results.reference, one.values, results.reference));
    const double length = root_mean_square(directions.back());
    for (double& component : directions.back()) component /= length;
  }
  if (directions.empty()) return required_ratio(Kind::wrong_model, 0.0, 1.0);
  double sum = 0.0;
  for (const auto& a : directions)
    for (const auto& b : directions) {
      double cosine = 0.0;
      for (std::size_t i = 0; i < a.size(); ++i) cosine += a[i] * b[i];
      cosine /= static_cast<double>(a.size());
      sum += cosine * cosine;
    }
  const auto count = static_cast<double>(directions.size());
  return required_ratio(Kind::wrong_model, count, count * count / sum);
}

void require_usable(const ModelResults& results, const Values& values, const Values& uncertainty) {
  for (const std::size_t size : {values.size(), uncertainty.size()})
    if (size != results.reference.size())
      throw std::invalid_argument(fmt::format("there are {} values or uncertainties, but must be {}", size,
                                              results.reference.size()));
  for (const double value : values)
    if (!std::isfinite(value)) throw data::FieldError("a value", value, "finite");
  for (const double bound : uncertainty)
    if (!(bound >= 0.0 && std::isfinite(bound)))
      throw data::FieldError("an uncertainty", bound, "finite and not negative");
}

// The nearest wrong model that changes something: the others are no explanation. Null if there is none.
const Hypothesis* nearest_model_of(const Diagnosis& diagnosis) {
  const auto found = std::ranges::find_if(
      diagnosis.ranked, [&](const Hypothesis& one) { return one.from_reference > diagnosis.uncertainty; });
  return found == diagnosis.ranked.end() ? nullptr : &*found;
}

std::string quoted(const std::vector<std::string>& names) {
  return fmt::format("'{}'", fmt::join(names, "', '"));
}

}  // namespace

Values scales_of(data::Norm norm, const Values& reference) {
  const double common = root_mean_square(reference);
  Values scales(reference.size(), common);
  if (norm == data::Norm::relative)
    std::ranges::transform(reference, scales.begin(),
                           [=](double value) { return value == 0.0 ? common : std::abs(value); });
  return scales;
}

double distance(data::Norm norm, const Values& reference, const Values& a, const Values& b) {
  const double result = root_mean_square(scaled_difference(norm, reference, a, b));
  return std::isfinite(result) ? result : std::numeric_limits<double>::infinity();
}

double required_ratio(Kind kind, double tried, double dimension, int free) {
  const Acceptance& asked = acceptance_of(kind);
  const double n = std::min(dimension, asked.most_dimension) - free;
  if (n <= 0.0) return std::numeric_limits<double>::infinity();
  const double choices = tried / (accidental_share * (free == 0 ? std::numbers::ln10 : 1.0));
  return std::max(asked.least_ratio, std::pow(choices, 1.0 / n));
}

Hypothesis judged(data::Norm norm, const Comparison::Series& series, Hypothesis one, double tried) {
  Values theirs, reference, expected;
  bool explains = false;
  for (std::size_t i = 0; i < one.values.size(); ++i) {
    if (std::isnan(one.values[i])) continue;
    theirs.push_back(series.theirs[i]);
    reference.push_back(series.reference[i]);
    expected.push_back(one.values[i]);
    explains = explains || series.differs_at(i);
  }
  const auto& scale = acceptance_of(one.kind).is_in_own_scale ? expected : reference;
  one.distance = distance(norm, scale, theirs, expected);
  one.from_reference = distance(norm, reference, expected, reference);
  const double whole = distance(norm, reference, theirs, reference);
  const double ratio = required_ratio(one.kind, tried, static_cast<double>(expected.size()), one.free);
  one.is_accepted = explains && 2 * expected.size() >= series.theirs.size() && is_near(one, whole, ratio);
  return one;
}

double rank_of(const Hypothesis& one) {
  constexpr double round_off = 1e-12, fitted = 10.0;
  return std::max(one.distance, round_off) * (one.free > 0 ? fitted : 1.0);
}

const Hypothesis* nearest_of(const std::vector<Hypothesis>& hypotheses) {
  const Hypothesis* nearest = nullptr;
  for (const Hypothesis& one : hypotheses)
    if (one.is_accepted && (nearest == nullptr || rank_of(one) < rank_of(*nearest))) nearest = &one;
  return nearest;
}

ModelResults relative_to_data(ModelResults results, const Values& data) {
  const Values right = std::exchange(results.reference, data);
  for (Hypothesis& one : results.wrong_models) {
    for (std::size_t i = 0; i < data.size(); ++i)
      one.values[i] = results.norm == data::Norm::relative ? data[i] * (one.values[i] / right[i])
                                                           : data[i] + (one.values[i] - right[i]);
    one.from_reference = distance(results.norm, data, one.values, data);
  }
  results.reference_uncertainty = distance(results.norm, data, right, data);
  return results;
}

Diagnosis diagnose(const ModelResults& results, const Values& values, const Values& uncertainty) {
  require_usable(results, values, uncertainty);
  const auto& [norm, reference, reference_uncertainty, wrong_models] = results;
  Diagnosis diagnosis;
  diagnosis.from_reference = distance(norm, reference, values, reference);
  diagnosis.uncertainty =
      reference_uncertainty + distance(norm, reference, uncertainty, Values(uncertainty.size(), 0.0));
  diagnosis.required_ratio = ratio_for(results, diagnosis.uncertainty);
  diagnosis.ranked = wrong_models;
  for (Hypothesis& one : diagnosis.ranked) one.distance = distance(norm, reference, values, one.values);
  std::ranges::stable_sort(diagnosis.ranked, {}, &Hypothesis::distance);

  const auto name_indistinguishable_from = [&, norm = norm, &reference = reference](const Values& model,
                                                                                    double least_change) {
    for (const Hypothesis& one : diagnosis.ranked)
      if (one.from_reference > least_change &&
          distance(norm, reference, one.values, model) <= 2.0 * diagnosis.uncertainty)
        diagnosis.named.push_back(one.name);
  };
  if (!std::isfinite(diagnosis.uncertainty)) {
    diagnosis.finding = Finding::undecided;
  } else if (diagnosis.from_reference <= diagnosis.uncertainty) {
    diagnosis.finding = Finding::correct;
    name_indistinguishable_from(reference, -1.0);
  } else if (const Hypothesis* const nearest = nearest_model_of(diagnosis);
             nearest != nullptr && is_near(*nearest, diagnosis.from_reference, diagnosis.required_ratio)) {
    diagnosis.distance = nearest->distance;
    diagnosis.finding = Finding::mistaken;
    name_indistinguishable_from(nearest->values, diagnosis.uncertainty);
  } else {
    diagnosis.finding = Finding::unexplained;
  }
  diagnosis.sentence = sentence(diagnosis);
  return diagnosis;
}

std::string percent(double share) { return fmt::format("{:.2g} %", 100.0 * share); }

std::string sentence(const Diagnosis& diagnosis) {
  const std::string from_reference = percent(diagnosis.from_reference);
  switch (diagnosis.finding.value()) {
    case Finding::correct:
      return fmt::format("no diagnosis: the difference of {} is too small to be assigned to a mistake",
                         from_reference);
    case Finding::mistaken: {
      const Hypothesis& nearest = *nearest_model_of(diagnosis);
      const std::vector<std::string> others(diagnosis.named.begin() + 1, diagnosis.named.end());
      const bool are_many = diagnosis.named.size() > most_named;
      std::string text =
          are_many ? fmt::format("like {} known mistakes that cannot be told apart here, the nearest ",
                                 diagnosis.named.size())
                   : "like ";
      text += fmt::format("'{}' ({}) to {}, while the reference is {} away", nearest.name, nearest.sentence,
                          percent(nearest.distance), from_reference);
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
  if (const Hypothesis* const nearest = nearest_model_of(diagnosis))
    text +=
        fmt::format("; the nearest, '{}', is {} away and would have to be within {}", nearest->name,
                    percent(nearest->distance), percent(diagnosis.from_reference / diagnosis.required_ratio));
  return text;
}

}  // namespace stickslip::comparison
