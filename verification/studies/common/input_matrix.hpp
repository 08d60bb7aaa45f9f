#pragma once

/// The expected outcome of bad input. verification/tests/golden/input-matrix.csv lists each key of a case
/// file, each option of the command line, each column of a compared table, and each column and key of the
/// published package, with the defects that are tested. The tests try each row.

#include <string>
#include <string_view>
#include <vector>

namespace stickslip::studies {

/// One row of the table: an input with a defect, and whether it is refused.
struct BadInput {
  std::string where;   ///< "case file", "option", "column" or "package"
  std::string item;    ///< such as "beam.length", "respond --hz", "resources/*/title"
  std::string defect;  ///< example: "not a number"
  bool is_refused{};
  std::string reason;  ///< why the input is accepted; empty if it is refused
};

/// Reads a table with the columns where,item,defect,outcome. The outcome is "refused" or "accepted: why".
/// Throws std::invalid_argument with the line number for any other line.
[[nodiscard]] std::vector<BadInput> parse_input_matrix(std::string_view text);

/// Reads the rows of input-matrix.csv. Throws data::InputError if the file cannot be read, and what
/// parse_input_matrix() throws.
[[nodiscard]] std::vector<BadInput> input_matrix();

/// The number of rows with the same place and the same defect.
struct BadInputCount {
  std::string where, defect;
  int refused{}, accepted{};
};

/// Counts the rows for each place and defect, in the order of their first appearance, place by place.
[[nodiscard]] std::vector<BadInputCount> count_by_defect(const std::vector<BadInput>& matrix);

/// The number of rows that are accepted for the same reason.
struct AcceptedCount {
  std::string reason;
  int rows{};
};

/// Counts the accepted rows for each reason, the most frequent reason first.
[[nodiscard]] std::vector<AcceptedCount> count_by_reason(const std::vector<BadInput>& matrix);

}  // namespace stickslip::studies
