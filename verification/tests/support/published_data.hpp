// SPDX-License-Identifier: MIT
#pragma once

/// Published data against the data that the code makes now.

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "stickslip/data/reference.hpp"
#include "stickslip/reference/package.hpp"

namespace stickslip::testing {

/// Expects the same cells, but for converged values, which may differ within the sum of their half-widths.
inline void expect_same_data(const data::ReferenceTable& published, const reference::DataSet& made) {
  const data::Resource& resource = made.resource;
  ASSERT_EQ(published.rows(), made.rows.size()) << resource.name;
  ASSERT_EQ(published.columns.size(), resource.fields.size()) << resource.name;
  for (std::size_t column = 0; column < resource.fields.size(); ++column) {
    const data::Field& field = resource.fields[column];
    EXPECT_EQ(published.columns[column].field.name, field.name) << resource.name;
    const bool is_converged = field.value_class == data::ValueClass::converged;
    const bool is_radius = field.name.ends_with("_radius");
    for (std::size_t row = 0; row < made.rows.size(); ++row) {
      const std::string& before = published.columns[column].text[row];
      const std::string& now = made.rows[row][column];
      if (is_radius && resource.provenance.value_class == data::ValueClass::converged) continue;
      if (!is_converged) {
        ASSERT_EQ(before, now) << resource.name << ", " << field.name << ", row " << row + 1;
        continue;
      }
      const double allowed =
          std::stod(published.columns[column + 1].text[row]) + std::stod(made.rows[row][column + 1]);
      ASSERT_LE(std::abs(std::stod(before) - std::stod(now)), allowed)
          << resource.name << ", " << field.name << ", row " << row + 1;
    }
  }
}

}  // namespace stickslip::testing
