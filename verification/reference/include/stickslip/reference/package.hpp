#pragma once

/// Makes the published reference data, data/reference/: each number with the half-width of its uncertainty,
/// each data set with its provenance. What is enclosed comes from ball arithmetic, what is converged from
/// the studies.

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/data/reference.hpp"

namespace stickslip::reference {

/// A data set: what the package says of it, and its rows, a text for each field.
struct DataSet {
  data::Resource resource;
  std::vector<std::vector<std::string>> rows;
};

/// One data set and how to make it.
struct Recipe {
  std::string_view name;
  std::function<DataSet()> make;
  bool is_quick{};  ///< takes less than a second or so
};

/// All of them, in the order of the package. Making one throws what its computation throws, and
/// std::runtime_error if a number does not come out as sharp as it is to be published.
[[nodiscard]] const std::vector<Recipe>& recipes();

/// The CSV file of a data set.
[[nodiscard]] std::string csv_of(const DataSet& set);

/// The files of a package by their names in its folder, datapackage.json among them.
[[nodiscard]] std::map<std::string, std::string> package_files(const std::vector<DataSet>& sets);

}  // namespace stickslip::reference
