// SPDX-License-Identifier: MIT
#include "comparison/groups.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <set>

#include "stickslip/data/case_file.hpp"

namespace stickslip::studies {

namespace {

template <class Cell>
std::string label_of(const std::vector<std::string>& columns, const Cell& cell) {
  std::string text;
  for (const std::string& name : columns)
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", name, cell(name));
  return text;
}

const data::Column* column_of(const std::vector<data::Column>& columns, const std::string& name) {
  const auto found = std::ranges::find(
      columns, name, [](const data::Column& one) -> const auto& { return one.field.name; });
  return found == columns.end() ? nullptr : &*found;
}

}  // namespace

bool are_alike(const std::vector<data::Column>& a, std::size_t i, const std::vector<data::Column>& b,
               std::size_t j, const std::vector<std::string>& names) {
  return std::ranges::all_of(names, [&](const std::string& name) {
    const data::Column *mine = column_of(a, name), *theirs = column_of(b, name);
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

std::string Matcher::label(const std::vector<std::string>& columns, std::size_t row) const {
  return label_of(columns, [&](const std::string& name) { return reference_.column(name).text[row]; });
}

void Matcher::throw_unknown_row(const std::vector<std::string>& columns, std::size_t their_row) const {
  const auto cell = [&](const std::string& name) { return theirs_.column(name)->text[their_row]; };
  throw data::InputError(fmt::format("{}: {} is not in the data set {}{}", theirs_.place(their_row),
                                     label_of(columns, cell), reference_.resource.name,
                                     allowed(columns, their_row)));
}

// ", where mode must be one of 1, 2, 3": the first column that leaves no row of the reference.
std::string Matcher::allowed(const std::vector<std::string>& columns, std::size_t their_row) const {
  Rows left(reference_.rows());
  std::iota(left.begin(), left.end(), std::size_t{0});
  for (const std::string& name : columns) {
    const data::Column& column = reference_.column(name);
    std::vector<std::string> values;
    for (const std::size_t row : left)
      if (std::ranges::count(values, column.text[row]) == 0) values.push_back(column.text[row]);
    std::erase_if(left, [&](std::size_t row) {
      return !are_alike(reference_.columns, row, theirs_.columns, their_row, {name});
    });
    if (!left.empty()) continue;
    constexpr std::size_t most = 12;
    return values.size() <= most ? fmt::format(", where {} must be one of {}", name, fmt::join(values, ", "))
                                 : fmt::format(", where {} must be one of the {} from {} to {}", name,
                                               values.size(), values.front(), values.back());
  }
  return "";
}

std::vector<Group> Matcher::groups(const std::vector<std::string>& columns) const {
  std::vector<Group> list;
  for (std::size_t row = 0; row < reference_.rows(); ++row) {
    const auto known = std::ranges::find_if(list, [&](const Group& group) {
      return are_alike(reference_.columns, group.reference.front(), reference_.columns, row, columns);
    });
    if (known == list.end())
      list.push_back({.label = label(columns, row), .reference = {row}, .theirs = {}});
    else
      known->reference.push_back(row);
  }
  if (list.size() == 1) list.front().label.clear();
  for (std::size_t row = 0; row < theirs_.rows(); ++row) {
    const auto group = std::ranges::find_if(list, [&](const Group& one) {
      return are_alike(reference_.columns, one.reference.front(), theirs_.columns, row, columns);
    });
    if (group == list.end()) throw_unknown_row(columns, row);
    group->theirs.push_back(row);
  }
  return list;
}

}  // namespace stickslip::studies
