#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "stickslip/studies/impostors.hpp"

namespace stickslip::studies {

namespace {

constexpr double accidental = 0.01;  // of all unrelated errors may be named
constexpr double least_ratio = 3.0;

bool each_counts_alike(Quantity quantity) {
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

// (a - b)/s, entry by entry.
std::vector<double> scaled_difference(const LineUp& line_up, const std::vector<double>& a,
                                      const std::vector<double>& b) {
  const bool alike = each_counts_alike(line_up.quantity);
  const double common = root_mean_square(line_up.truth);
  std::vector<double> difference;
  for (std::size_t i = 0; i < a.size(); ++i)
    difference.push_back((a[i] - b[i]) / (alike ? std::abs(line_up.truth[i]) : common));
  return difference;
}

// K and n of Diagnosis.
struct Field {
  double count{}, dimension{1.0};
};
Field field_of(const LineUp& line_up, double uncertainty) {
  std::vector<std::vector<double>> directions;
  for (const auto& impostor : line_up.impostors) {
    if (!std::isfinite(impostor.from_truth) || impostor.from_truth <= uncertainty) continue;
    directions.push_back(scaled_difference(line_up, impostor.values, line_up.truth));
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
    throw std::invalid_argument(
        fmt::format("observation: {} {}, must be as many as the abscissa has, {}", size, what, expected));
}

void require_usable(const LineUp& line_up, const Observation& observation) {
  if (observation.quantity != line_up.quantity || observation.abscissa != line_up.abscissa)
    throw std::invalid_argument("observation: must have the quantity and the abscissa of the line-up");
  require_same_size("values", observation.values.size(), observation.abscissa.size());
  require_same_size("uncertainties", observation.uncertainty.size(), observation.abscissa.size());
  for (const double value : observation.values)
    if (!std::isfinite(value))
      throw std::invalid_argument(fmt::format("observation: value = {}, must be finite", value));
  for (const double uncertainty : observation.uncertainty)
    if (!(uncertainty >= 0.0 && std::isfinite(uncertainty)))
      throw std::invalid_argument(
          fmt::format("observation: uncertainty = {}, must be finite and not negative", uncertainty));
}

std::string percent(double share) { return fmt::format("{:.2g} %", 100.0 * share); }

const Impostor& impostor_named(const std::string& name) {
  return *std::ranges::find(impostors(), name, &Impostor::name);
}

std::string quoted(const std::vector<std::string>& names) {
  return fmt::format("'{}'", fmt::join(names, "', '"));
}

}  // namespace

double distance(const LineUp& line_up, const std::vector<double>& a, const std::vector<double>& b) {
  const double result = root_mean_square(scaled_difference(line_up, a, b));
  return std::isfinite(result) ? result : std::numeric_limits<double>::infinity();
}

Diagnosis diagnose(const LineUp& line_up, const Observation& observation) {
  require_usable(line_up, observation);
  const auto& uncertainty = observation.uncertainty;
  Diagnosis diagnosis;
  diagnosis.from_truth = distance(line_up, observation.values, line_up.truth);
  diagnosis.uncertainty = line_up.truth_uncertainty +
                          distance(line_up, uncertainty, std::vector<double>(uncertainty.size(), 0.0));
  const Field field = field_of(line_up, diagnosis.uncertainty);
  diagnosis.dimension = field.dimension;
  diagnosis.required_ratio =
      std::max(least_ratio, std::pow(field.count / (accidental * std::log(10.0)), 1.0 / field.dimension));

  for (const auto& impostor : line_up.impostors)
    diagnosis.ranked.push_back(
        {impostor.name, distance(line_up, observation.values, impostor.values), impostor.from_truth});
  std::ranges::stable_sort(diagnosis.ranked, {}, &Suspect::distance);

  const auto name_those_like = [&](const std::vector<double>& model) {
    for (const Suspect& suspect : diagnosis.ranked) {
      const auto member = std::ranges::find(line_up.impostors, suspect.name, &LineUp::Member::name);
      if (distance(line_up, member->values, model) <= 2.0 * diagnosis.uncertainty)
        diagnosis.named.push_back(suspect.name);
    }
  };
  if (!std::isfinite(diagnosis.uncertainty)) {
    diagnosis.finding = Finding::undecided;
    return diagnosis;
  }
  if (diagnosis.from_truth <= diagnosis.uncertainty) {
    diagnosis.finding = Finding::correct;
    name_those_like(line_up.truth);
    return diagnosis;
  }
  diagnosis.finding = Finding::unexplained;
  if (diagnosis.ranked.empty()) return diagnosis;
  const Suspect& nearest = diagnosis.ranked.front();
  if (nearest.distance * diagnosis.required_ratio > diagnosis.from_truth) return diagnosis;
  diagnosis.finding = Finding::mistaken;
  name_those_like(std::ranges::find(line_up.impostors, nearest.name, &LineUp::Member::name)->values);
  return diagnosis;
}

Diagnosis diagnose(const data::Case& problem, const Observation& observation) {
  return diagnose(line_up(problem, observation.quantity, observation.abscissa), observation);
}

std::string sentence(const Diagnosis& diagnosis) {
  const std::string from_truth = percent(diagnosis.from_truth);
  switch (diagnosis.finding) {
    case Finding::correct: {
      std::string text = fmt::format("correct: {} from the truth, within the uncertainty of {}", from_truth,
                                     percent(diagnosis.uncertainty));
      if (!diagnosis.named.empty())
        text += fmt::format("; it could not tell {} from the truth", quoted(diagnosis.named));
      return text;
    }
    case Finding::mistaken: {
      const std::vector<std::string> others(diagnosis.named.begin() + 1, diagnosis.named.end());
      std::string text = fmt::format("like '{}' ({}) to {}, while the truth is {} away",
                                     diagnosis.named.front(), impostor_named(diagnosis.named.front()).mistake,
                                     percent(diagnosis.ranked.front().distance), from_truth);
      if (!others.empty()) text += fmt::format("; it could as well be {}", quoted(others));
      return text;
    }
    case Finding::undecided:
      return fmt::format("undecided: {} from a truth that another mesh and step do not confirm", from_truth);
    case Finding::unexplained:
      break;
  }
  std::string text = fmt::format("wrong by {}, like none of the known mistakes", from_truth);
  if (!diagnosis.ranked.empty())
    text += fmt::format("; the nearest, '{}', is {} away and would have to be within {}",
                        diagnosis.ranked.front().name, percent(diagnosis.ranked.front().distance),
                        percent(diagnosis.from_truth / diagnosis.required_ratio));
  return text;
}

}  // namespace stickslip::studies
