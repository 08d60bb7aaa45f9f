// SPDX-License-Identifier: MIT
#pragma once

/// One number of a problem that is wrong: the search for it.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "comparison/diagnosis/ranking.hpp"

namespace stickslip::comparison {

/// A number that may be wrong, with what follows from it.
struct FreeNumber {
  std::vector<double> tried;  ///< ascending; the search goes on between them
  std::function<std::optional<std::vector<double>>(double)>
      result;                                   ///< at the values; empty if there is none
  std::function<std::string(double)> sentence;  ///< begins with "like "
};

/// The wrong number that is nearest to the user's values, with those that cannot be told from it.
///
/// Each is fitted by least squares: the nearest of those that are tried, from which Gauss and Newton go on. It is accepted if it is
/// nearer than the reference by required_ratio() of one fitted number among as many as there are, and as near as twice the
/// uncertainty of the values or a hundredth of their difference from the reference.
[[nodiscard]] std::optional<Hypothesis> wrong_number(const ComparedValues& values, double uncertainty,
                                                     const std::vector<FreeNumber>& numbers);

}  // namespace stickslip::comparison
