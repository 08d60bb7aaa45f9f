// SPDX-License-Identifier: MIT
#pragma once

/// What a result that differs may be: hypotheses, and what is said of it.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::comparison {

/// A possible reason of a difference: a relation of the user's values to the reference, another data set, or a wrong
/// model.
struct Hypothesis {
  std::string name{};            ///< such as "constant-factor" or "zero-initial-velocity"
  std::vector<double> values{};  ///< what the user has if it is true; NaN where it says nothing
  int free{};                    ///< numbers in it that were fitted to the user's values
  std::string sentence{};        ///< without a full stop; of a wrong model its mistake
  double distance{};             ///< of the user's values from it, relative
  double from_reference{};       ///< of its values from the reference, relative
};

/// The outcome of a diagnosis.
enum class Finding {
  correct,      ///< within the uncertainty of the reference
  mistaken,     ///< near one of the hypotheses
  unexplained,  ///< neither correct nor near one
  undecided     ///< the reference is uncertain: another mesh has different events
};
inline constexpr std::array<std::string_view, 4> finding_names{"correct", "mistaken", "unexplained",
                                                               "undecided"};

/// What is said of one quantity of one group.
struct Diagnosis {
  std::string group{};     ///< the first of several with the same sentence
  std::string quantity{};  ///< the name of the compared quantity
  std::string sentence{};  ///< such as "like 'dead-load' (...) to 0.3 %, while the reference is 41 % away"
  std::optional<Finding> finding{};  ///< empty if no diagnosis is possible; the sentence gives the reason
  double from_reference{};           ///< distance d of the user's values from the reference, relative
  double uncertainty{};              ///< u, relative
  double required_ratio{};           ///< R
  std::vector<Hypothesis> ranked{};  ///< all wrong models, the nearest first
  /// If mistaken, the hypothesis that is named and those that are indistinguishable from it. If correct, those
  /// that are indistinguishable from the reference.
  std::vector<std::string> named{};
};

}  // namespace stickslip::comparison
