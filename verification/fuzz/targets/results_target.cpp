// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/user_table.hpp"
#include "target.hpp"

namespace stickslip::fuzz {

namespace {

std::vector<data::ReferenceTable> comparable_tables() {
  const data::ReferencePackage package = data::load_reference();
  std::vector<data::ReferenceTable> tables;
  for (const data::Resource& resource : package.resources)
    if (resource.comparison) tables.push_back(data::read_table(package, resource.name));
  return tables;
}

void require_whole(const data::UserTable& table) {
  if (table.rows() == 0) throw Violation("a table without rows is accepted");
  for (const data::Column& column : table.columns) {
    if (column.values.size() != table.rows() || column.text.size() != table.rows())
      throw Violation("the column " + column.field.name + " does not have one cell for each row");
    const bool is_number = column.field.type != data::FieldType::string;
    if (is_number && !std::ranges::all_of(column.values, [](double value) { return std::isfinite(value); }))
      throw Violation("the column " + column.field.name + " has a number that is not finite");
  }
}

}  // namespace

void read_results(Bytes bytes) {
  static const std::vector<data::ReferenceTable> tables = comparable_tables();
  static MemoryFile file;
  if (bytes.empty()) return;
  const data::ReferenceTable& reference = tables[bytes.front() % tables.size()];
  const auto parts = split(bytes.subspan(1));
  allow_input_errors([&] {
    std::vector<data::ColumnMapping> mappings;
    for (std::size_t i = 1; i < parts.size(); ++i) mappings.push_back(data::ColumnMapping::parse(parts[i]));
    data::require_known_columns(mappings, {&reference});
    require_whole(data::read_user_table(file.with(parts.front()), reference, mappings));
  });
}

}  // namespace stickslip::fuzz
