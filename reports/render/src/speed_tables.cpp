#include "speed_tables.hpp"

#include <cstddef>
#include <set>

#include "latex_table.hpp"
#include "stickslip/report/latex_text.hpp"

namespace stickslip::report {

namespace {

constexpr double milli = 1e-3, nano = 1e-9, percent = 1e-2;

}  // namespace

std::string speed_rows(const benchmarks::SpeedRecord& record) {
  Rows rows;
  for (const auto& line : record.comparisons)
    rows.add({typeset(line.work), typeset(line.plain), typeset(line.fast),
              compact_number(line.fast_seconds / milli, 2),
              compact_number(line.plain_seconds / line.fast_seconds, 2)});
  return rows.text();
}

std::string load_rows(const benchmarks::SpeedRecord& record) {
  Rows rows;
  std::set<std::string> seen;
  for (const auto& line : record.comparisons)
    if (line.load && seen.insert(line.fast).second)
      rows.add({typeset(line.fast), plain_number(line.load->flops_per_step),
                plain_number(line.load->bytes_per_step),
                compact_number(line.load->share_of_flops / percent, 2),
                compact_number(line.load->share_of_bytes / percent, 2)});
  return rows.text();
}

std::string scale_rows(const benchmarks::SpeedRecord& record) {
  Rows rows;
  for (std::size_t i = 0; i < record.elements.size(); ++i)
    rows.add({plain_number(record.elements[i]), compact_number(record.seconds_per_element[i] / nano, 2),
              compact_number(record.seconds_per_element[i] / record.seconds_per_element[0], 2)});
  return rows.text();
}

}  // namespace stickslip::report
