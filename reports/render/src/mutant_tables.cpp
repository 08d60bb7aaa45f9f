#include "mutant_tables.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <filesystem>
#include <sstream>
#include <vector>

#include "latex_table.hpp"
#include "stickslip/data/input_error.hpp"
#include "stickslip/report/latex_text.hpp"
#include "stickslip/report/report.hpp"
#include "stickslip/report/text_file.hpp"

namespace stickslip::report {

namespace {

std::filesystem::path in_mutants(const std::string& name) {
  return templates_directory().parent_path() / "verification" / "mutants" / name;
}

std::string text_at(const toml::table& entry, std::string_view key) {
  return entry[key].value_or(std::string());
}

}  // namespace

std::string mutant_rows() {
  std::istringstream lines(read_text(in_mutants("summary.csv")));
  std::string line;
  std::getline(lines, line);  // the names of the columns
  Rows rows;
  while (std::getline(lines, line)) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(escape(cell));
    rows.add(cells);
  }
  return rows.text();
}

std::string equivalent_mutant_rows() {
  try {
    const toml::table survivors = toml::parse_file(in_mutants("survivors.toml").string());
    Rows rows;
    if (const toml::array* list = survivors["equivalent"].as_array())
      for (const toml::node& node : *list)
        if (const toml::table* entry = node.as_table()) {
          rows.add({fmt::format("{}, {}", breakable(text_at(*entry, "file")),
                                breakable(text_at(*entry, "function"))),
                    fmt::format("\\code{{{}}}", escape(text_at(*entry, "edit"))),
                    typeset(text_at(*entry, "why"))});
          rows.space();
        }
    return rows.text();
  } catch (const toml::parse_error& error) {
    throw data::InputError(fmt::format("survivors.toml: {}", error.description()));
  }
}

}  // namespace stickslip::report
