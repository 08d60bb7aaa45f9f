// SPDX-License-Identifier: MIT
#include <cmath>
#include <tuple>

#include "validation/study.hpp"

namespace stickslip::validation {

double Comparison::error() const { return prediction.value - measured.value; }

double Comparison::uncertainty() const {
  return std::hypot(measured.uncertainty, prediction.input_uncertainty, prediction.numerical_uncertainty);
}

bool Comparison::is_resolved() const { return std::abs(error()) >= uncertainty(); }

bool Comparison::contains_zero() const { return std::abs(error()) <= 2.0 * uncertainty(); }

std::vector<Comparison> comparisons() {
  const FigureTable figures = measured_figures();
  std::map<std::string, std::string> experiments;
  for (const SetPoint& point : set_points()) experiments[point.record] = point.experiment;
  std::vector<Comparison> all;
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> places;
  for (const Prediction& one : recorded_predictions()) {
    const auto [place, is_new] = places.try_emplace({one.record, one.quantity, one.form}, all.size());
    if (is_new) all.emplace_back();
    all[place->second] = {experiments.at(one.record), one, figures.at({one.record, one.quantity})};
  }
  return all;
}

std::vector<Bias> biases(const std::vector<Comparison>& comparisons) {
  std::vector<Bias> all;
  std::map<std::tuple<std::string, std::string, std::string>, std::vector<const Comparison*>> groups;
  for (const Comparison& one : comparisons)
    groups[{one.experiment, one.prediction.quantity, one.prediction.form}].push_back(&one);
  for (const auto& [key, group] : groups) {
    Bias bias{.experiment = std::get<0>(key),
              .quantity = std::get<1>(key),
              .form = std::get<2>(key),
              .points = group.size()};
    const auto n = static_cast<double>(group.size());
    for (const Comparison* one : group) {
      bias.mean += one->error() / one->measured.value / n;
      if (one->is_resolved()) ++bias.resolved;
      if (!one->contains_zero()) ++bias.beyond;
    }
    for (const Comparison* one : group)
      bias.spread += std::pow(one->error() / one->measured.value - bias.mean, 2) / std::max(1.0, n - 1.0);
    bias.spread = std::sqrt(bias.spread);
    all.push_back(bias);
  }
  return all;
}

}  // namespace stickslip::validation
