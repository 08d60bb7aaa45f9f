// SPDX-License-Identifier: MIT
#include "comparison/groups.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>

#include "stickslip/data/input_error.hpp"

namespace stickslip::comparison {

namespace {

template <class Cell>
std::string joined_cells(const std::vector<std::string>& columns, const Cell& cell) {
  std::string text;
  for (const std::string& name : columns)
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, cell(name));
  return text;
}

// ", where mode must be one of 1, 2, 3": the first column that leaves no row of the reference.
std::string allowed(const data::ReferenceTable& reference, const data::UserTable& theirs,
                    const std::vector<std::string>& columns, std::size_t their_row) {
  Rows left(reference.rows());
  std::iota(left.begin(), left.end(), std::size_t{0});
  for (const std::string& name : columns) {
    const data::Column& column = reference.column(name);
    std::vector<std::string> values;
    for (const std::size_t row : left)
      if (std::ranges::count(values, column.text[row]) == 0) values.push_back(column.text[row]);
    std::erase_if(left, [&](std::size_t row) {
      return !are_alike(reference.columns, row, theirs.columns, their_row, {name});
    });
    if (!left.empty()) continue;
    constexpr std::size_t most = 12;
    return values.size() <= most ? fmt::format(", where {} must be one of {}", name, fmt::join(values, ", "))
                                 : fmt::format(", where {} must be one of the {} from {} to {}", name,
                                               values.size(), values.front(), values.back());
  }
  return "";
}

}  // namespace

bool are_alike(const std::vector<data::Column>& a, std::size_t i, const std::vector<data::Column>& b,
               std::size_t j, const std::vector<std::string>& names) {
  return std::ranges::all_of(names, [&](const std::string& name) {
    const data::Column *mine = data::find_column(a, name), *theirs = data::find_column(b, name);
    if (mine == nullptr || theirs == nullptr) return true;
    return mine->field.type == data::FieldType::string
               ? mine->text[i] == theirs->text[j]
               : data::is_same_key(mine->values[i], theirs->values[j]);
  });
}

data::UserTable with_keys_of(const data::ReferenceTable& reference, data::UserTable theirs,
                             const std::string& abscissa) {
  constexpr double single_precision = 1e-6;
  for (data::Column& column : theirs.columns) {
    if (column.field.name == abscissa || column.field.type == data::FieldType::string ||
        std::ranges::count(reference.resource.primary_key, column.field.name) == 0)
      continue;
    const auto& values = reference.column(column.field.name).values;
    const std::set<double> keys(values.begin(), values.end());
    for (double& key : column.values) {
      const double reach = single_precision * std::abs(key);
      const auto near = keys.lower_bound(key - reach);
      if (near != keys.end() && *near <= key + reach && keys.upper_bound(key + reach) == std::next(near))
        key = *near;
    }
  }
  return theirs;
}

std::string label_of(const data::ReferenceTable& reference, const std::vector<std::string>& columns,
                     std::size_t row) {
  return joined_cells(columns, [&](const std::string& name) { return reference.column(name).text[row]; });
}

void throw_unknown_row(const data::ReferenceTable& reference, const data::UserTable& theirs,
                       const std::vector<std::string>& columns, std::size_t their_row) {
  const auto cell = [&](const std::string& name) { return theirs.column(name)->text[their_row]; };
  throw data::InputError(fmt::format("{}: {} is not in the data set {}{}", theirs.place(their_row),
                                     joined_cells(columns, cell), reference.resource.name,
                                     allowed(reference, theirs, columns, their_row)));
}

std::vector<Group> groups_of(const data::ReferenceTable& reference, const data::UserTable& theirs,
                             const std::vector<std::string>& columns) {
  std::vector<Group> list;
  for (std::size_t row = 0; row < reference.rows(); ++row) {
    const auto known = std::ranges::find_if(list, [&](const Group& group) {
      return are_alike(reference.columns, group.reference.front(), reference.columns, row, columns);
    });
    if (known == list.end())
      list.push_back({.label = label_of(reference, columns, row), .reference = {row}, .theirs = {}});
    else
      known->reference.push_back(row);
  }
  if (list.size() == 1) list.front().label.clear();
  for (std::size_t row = 0; row < theirs.rows(); ++row) {
    const auto group = std::ranges::find_if(list, [&](const Group& one) {
      return are_alike(reference.columns, one.reference.front(), theirs.columns, row, columns);
    });
    if (group == list.end()) throw_unknown_row(reference, theirs, columns, row);
    group->theirs.push_back(row);
  }
  return list;
}

}  // namespace stickslip::comparison
