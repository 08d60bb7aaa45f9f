// SPDX-License-Identifier: MIT
#include "studies/paper/agreement.hpp"

#include <cmath>

namespace stickslip::studies {

Differences differences_from(const std::vector<CheckedResult>& results, const std::string& reference) {
  Differences differences;
  double sum = 0.0, squares = 0.0;
  for (const CheckedResult& result : results) {
    if (result.reference != reference || result.known_erratum) continue;
    const double difference = result.relative_difference();
    ++differences.count;
    sum += difference;
    squares += difference * difference;
  }
  const auto count = static_cast<double>(differences.count);
  differences.bias = sum / count;
  differences.spread = std::sqrt((squares - count * differences.bias * differences.bias) / (count - 1.0));
  return differences;
}

Agreement agreement(const std::vector<PrintedCheck>& printed, const SolutionVerification& verification) {
  Agreement found;
  for (const auto& check : printed)
    found.results.push_back({.what = check.printed.id + " by " + check.method,
                             .reference = "printed",
                             .known_erratum = !check.agrees(),
                             .computed = check.computed,
                             .expected = check.printed.value});
  for (const auto& result : verification.results)
    found.results.push_back({.what = result.quantity,
                             .reference = "mesh-free",
                             .computed = result.levels.front().value,
                             .expected = result.reference});
  found.printed = differences_from(found.results, "printed");
  found.exact = differences_from(found.results, "mesh-free");
  return found;
}

}  // namespace stickslip::studies
