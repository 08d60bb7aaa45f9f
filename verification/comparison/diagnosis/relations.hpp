// SPDX-License-Identifier: MIT
#pragma once

/// Mistakes that the numbers show without a model.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "comparison/diagnosis/hypothesis.hpp"
#include "stickslip/data/user_table.hpp"

namespace stickslip::comparison {

/// What is to be explained: one quantity of one group.
struct DeviatingQuantity {
  const Comparison& comparison;
  const data::ReferencePackage& package;
  const data::ReferenceTable& reference;
  const data::UserTable& theirs;
  const Comparison::Quantity& quantity;
  Comparison::Series series;
};

/// Whether each row of the data set is a case of its own, or a point of one motion.
[[nodiscard]] bool rows_are_cases(const data::Resource& resource);

/// Whether the problem is one motion, of which the data set has times.
[[nodiscard]] bool is_of_one_motion(const data::Resource& resource);

/// The groups of a quantity: one if the rows are cases.
[[nodiscard]] std::vector<Comparison::Series> groups_of(const Comparison& comparison,
                                                        const Comparison::Quantity& quantity,
                                                        const data::Resource& resource);

/// As Comparison::Series::group.
[[nodiscard]] std::string group_of(const data::ReferenceTable& reference, const std::string& abscissa,
                                   std::size_t row);

/// The row of `table` whose key is that of a row of another table; columns that one of them lacks do not count.
[[nodiscard]] std::optional<std::size_t> row_like(const data::ReferenceTable& table,
                                                  const std::vector<std::string>& key,
                                                  const std::vector<data::Column>& other,
                                                  std::size_t other_row);

/// All that was tried, each judged: usual factors and a fitted one, single wrong values, conventions of angles, an added constant, a
/// missing mode, zeros, another column, another data set with the same columns.
[[nodiscard]] std::vector<Hypothesis> relations_of(const DeviatingQuantity& deviating);

/// Whether the nearest that is accepted leaves at most the tolerance.
[[nodiscard]] bool is_explained(const DeviatingQuantity& deviating, const std::vector<Hypothesis>& tried);

}  // namespace stickslip::comparison
