// SPDX-License-Identifier: MIT
#include "comparison/diagnosis/wrong_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <utility>

#include "studies/common/parallel.hpp"

namespace stickslip::comparison {

namespace {

using Values = std::vector<double>;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Tried {
  double number{}, distance{infinity};
  Values values{};
};

Tried tried(const ComparedValues& values, const FreeNumber& free, double number) {
  Tried one{.number = number};
  try {
    if (auto result = free.result(number)) {
      one.values = *std::move(result);
      one.distance = distance(values.norm, values.reference, values.theirs, one.values);
    }
  } catch (const std::exception&) {  // there is no such state
  }
  return one;
}

// The step from one number to the least squares, by the slope between it and its neighbour.
double step_of(const ComparedValues& values, const Tried& here, const Tried& beside) {
  const Values scales = scales_of(values.norm, values.reference);
  double product = 0.0, square = 0.0;
  for (std::size_t i = 0; i < here.values.size(); ++i) {
    const double slope = (beside.values[i] - here.values[i]) / (beside.number - here.number) / scales[i];
    product += slope * (values.theirs[i] - here.values[i]) / scales[i];
    square += slope * slope;
  }
  return product / square;
}

// From one of the numbers that were tried on, within its neighbours. The slope is that to a neighbour as far away as the
// last step, so that what jitters over shorter distances, such as the largest force, does not mislead it.
Tried refined(const ComparedValues& values, const FreeNumber& free, std::size_t start, double enough) {
  constexpr int most = 16;
  const double from = free.tried[start == 0 ? 0 : start - 1],
               to = free.tried[std::min(start + 1, free.tried.size() - 1)];
  Tried best = tried(values, free, free.tried[start]);
  double width = 0.25 * (to - from);
  for (int runs = 0; runs < most && best.distance > enough; runs += 2) {
    Tried beside = tried(values, free, best.number + width);
    if (!std::isfinite(beside.distance)) {
      width *= -0.25;
      continue;
    }
    const double step = step_of(values, best, beside);
    Tried next = tried(values, free, std::clamp(best.number + step, from, to));
    Tried& nearer = next.distance < beside.distance ? next : beside;
    const double moved = nearer.number - best.number;
    if (nearer.distance < best.distance && moved != 0.0)
      best = std::move(nearer), width = 0.5 * moved;
    else
      width *= -0.25;
  }
  return best;
}

Tried fitted(const ComparedValues& values, double uncertainty, double near, const FreeNumber& free) {
  constexpr double worth_fitting = 0.6, enough = 0.1;
  const double whole = distance(values.norm, values.reference, values.theirs, values.reference);
  std::vector<std::pair<double, std::size_t>> starts;
  for (std::size_t k = 0; k < free.tried.size(); ++k)
    starts.emplace_back(tried(values, free, free.tried[k]).distance, k);
  std::ranges::sort(starts);
  Tried best;
  for (const auto& [distance, k] : {starts[0], starts[1]})
    if (distance < worth_fitting * whole && best.distance > near)
      if (Tried one = refined(values, free, k, enough * uncertainty); one.distance < best.distance)
        best = std::move(one);
  return best;
}

}  // namespace

std::optional<Hypothesis> wrong_number(const ComparedValues& values, double uncertainty,
                                       const std::vector<FreeNumber>& numbers) {
  constexpr double least_ratio = 100.0;
  const double whole = distance(values.norm, values.reference, values.theirs, values.reference);
  const double nearest = std::max(2.0 * uncertainty, whole / least_ratio);
  if (!(whole > uncertainty)) return std::nullopt;  // nothing is to be explained
  const double ratio = required_ratio(values.theirs.size(), 1, static_cast<int>(numbers.size()));
  std::vector<std::optional<Hypothesis>> found(numbers.size());
  studies::in_parallel(numbers.size(), [&](std::size_t i) {
    const Tried best = fitted(values, uncertainty, nearest, numbers[i]);
    if (best.distance <= std::min(nearest, whole / ratio))
      found[i] = Hypothesis{
          .name = "wrong-number",
          .values = best.values,
          .free = 1,
          .sentence = numbers[i].sentence(best.number),
          .distance = best.distance,
          .from_reference = distance(values.norm, values.reference, best.values, values.reference)};
  });
  std::erase(found, std::nullopt);
  std::ranges::sort(found, {}, [](const auto& one) { return one->distance; });
  if (found.empty()) return std::nullopt;
  Hypothesis best = *found.front();
  for (std::size_t i = 1; i < found.size(); ++i)
    if (distance(values.norm, values.reference, found[i]->values, best.values) <= nearest)
      best.sentence += ", or" + found[i]->sentence.substr(4);
  return best;
}

}  // namespace stickslip::comparison
