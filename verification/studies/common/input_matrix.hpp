#pragma once

/// What becomes of bad input: every key of a case file, every option of the command line, every column of a
/// compared table, every column and key of the published package, each with every defect, as
/// verification/tests/golden/input-matrix.csv has it. The tests try each row.

#include <string>
#include <string_view>
#include <vector>

namespace stickslip::studies {

struct BadInput {
  std::string where;   ///< "case file", "option", "column" or "package"
  std::string item;    ///< "beam.length", "respond --hz", "damped-history time", "resources/*/title"
  std::string defect;  ///< "not a number"
  bool is_refused{};
  std::string reason;  ///< why it is accepted, empty if it is refused
};

/// The rows of a table whose lines read where,item,defect,outcome, an outcome being "refused" or "accepted:
/// why". Throws std::invalid_argument, naming the line, for one that does not.
[[nodiscard]] std::vector<BadInput> parse_input_matrix(std::string_view text);

/// The rows of the file. Throws data::InputError if it cannot be read, and what parse_input_matrix() throws.
[[nodiscard]] std::vector<BadInput> input_matrix();

/// Rows of one place and one defect.
struct BadInputCount {
  std::string where, defect;
  int refused{}, accepted{};
};

/// In the order of first appearance, place by place.
[[nodiscard]] std::vector<BadInputCount> count_by_defect(const std::vector<BadInput>& matrix);

struct AcceptedCount {
  std::string reason;
  int rows{};
};

/// Most frequent first.
[[nodiscard]] std::vector<AcceptedCount> count_by_reason(const std::vector<BadInput>& matrix);

}  // namespace stickslip::studies
