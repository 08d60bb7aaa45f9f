#include "studies/common/input_matrix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "stickslip/data/case_file.hpp"

namespace stickslip::studies {

namespace {

constexpr std::string_view accepted = "accepted: ";

BadInput row_of(std::string_view line, int number) {
  std::array<std::string, 4> cells;
  std::string_view rest = line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto comma = i + 1 < cells.size() ? rest.find(',') : rest.size();
    if (comma == std::string_view::npos)
      throw std::invalid_argument(fmt::format(
          "line {} of the input matrix is '{}', but must be where,item,defect,outcome", number, line));
    cells[i] = rest.substr(0, comma);
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  const std::string& outcome = cells[3];
  const bool is_accepted = outcome.starts_with(accepted) && outcome.size() > accepted.size();
  if (!is_accepted && outcome != "refused")
    throw std::invalid_argument(fmt::format(
        "line {} of the input matrix has the outcome '{}', but must have 'refused' or 'accepted: why'",
        number, outcome));
  return {cells[0], cells[1], cells[2], !is_accepted, is_accepted ? outcome.substr(accepted.size()) : ""};
}

}  // namespace

std::vector<BadInput> parse_input_matrix(std::string_view text) {
  std::vector<BadInput> rows;
  std::istringstream lines{std::string(text)};
  std::string line;
  std::getline(lines, line);  // the names of the columns
  for (int number = 2; std::getline(lines, line); ++number) rows.push_back(row_of(line, number));
  return rows;
}

std::vector<BadInput> input_matrix() {
  std::ifstream stream(STICKSLIP_INPUT_MATRIX);
  if (!stream) throw data::InputError(std::string(STICKSLIP_INPUT_MATRIX) + ": cannot be opened for reading");
  std::ostringstream text;
  text << stream.rdbuf();
  return parse_input_matrix(text.str());
}

std::vector<BadInputCount> count_by_defect(const std::vector<BadInput>& matrix) {
  std::vector<BadInputCount> counts;
  for (const BadInput& row : matrix) {
    auto count = std::ranges::find_if(
        counts, [&](const BadInputCount& c) { return c.where == row.where && c.defect == row.defect; });
    if (count == counts.end()) count = counts.insert(counts.end(), {row.where, row.defect});
    ++(row.is_refused ? count->refused : count->accepted);
  }
  return counts;
}

std::vector<AcceptedCount> count_by_reason(const std::vector<BadInput>& matrix) {
  std::vector<AcceptedCount> counts;
  for (const BadInput& row : matrix) {
    if (row.is_refused) continue;
    auto count = std::ranges::find(counts, row.reason, &AcceptedCount::reason);
    if (count == counts.end()) count = counts.insert(counts.end(), {row.reason});
    ++count->rows;
  }
  std::ranges::stable_sort(counts, std::ranges::greater{}, &AcceptedCount::rows);
  return counts;
}

}  // namespace stickslip::studies
