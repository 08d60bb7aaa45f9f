// SPDX-License-Identifier: MIT
#pragma once

/// Generates the published reference data in data/reference/. Enclosed values come from ball arithmetic, converged
/// values from the studies.

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/data/reference.hpp"

namespace stickslip::reference {

/// A data set: its description in the package and its rows, with one text per field.
struct DataSet {
  data::Resource resource;
  std::vector<std::vector<std::string>> rows;
};

/// The name of a data set and the function that computes it.
struct Recipe {
  std::string_view name;
  std::function<DataSet()> make;
  bool is_quick{};  ///< computed within about a second
  int position{};   ///< among all, in the package
};

/// The recipes of all data sets, in the order of the package. A recipe throws what its computation throws,
/// and std::runtime_error if a number is less accurate than the published accuracy requires.
[[nodiscard]] const std::vector<Recipe>& recipes();

/// The texts of the files of a package by their names in its folder: datapackage.json and a table for each of
/// `sets`. With the text of a datapackage.json that was made before, the recipes' other data sets keep what it says
/// of them.
[[nodiscard]] std::map<std::string, std::string> package_files(const std::vector<DataSet>& sets,
                                                               const std::string& before = "");

}  // namespace stickslip::reference
