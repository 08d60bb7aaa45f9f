// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/csv_table.hpp"
#include "render/output_folder.hpp"

namespace stickslip::report {

/// What a gnuplot script gets, all of it as `<name>.csv`: tables, and a table of single values if there are
/// any.
struct FigureData {
  struct Table {
    std::string name;  ///< without .csv; the first one is the figure's own
    CsvTable table;
  };
  struct Value {
    std::string name;  ///< the gnuplot variable
    double value{};
    std::string unit;    ///< "-" of a text
    std::string text{};  ///< instead of the value, if there is any
  };
  std::vector<Table> tables;
  std::vector<Value> values;
};

/// How a figure looks: its format, "pdf", "png", "svg" or "tex" (TikZ), and what differs from its script.
struct Look {
  std::string format;
  std::string title{};                                 ///< none if it is empty
  std::optional<std::pair<double, double>> size_cm{};  ///< width and height
  bool is_composed{};                                  ///< its letters shrink with it, down to 5 points
  std::string font{};  ///< "NAME,SIZE", points; "tex" takes the size; empty: that of the style
};

/// "pdf", "png", "svg" or "tex", by the name of the file of --figure. Throws data::InputError for another one.
[[nodiscard]] std::string figure_format(const std::string& figure);

/// The values of a figure as a table with the columns name, value and unit.
/// Throws std::logic_error for a text with a comma or a quotation mark, which gnuplot does not read.
[[nodiscard]] CsvTable values_table(const std::vector<FigureData::Value>& values);

/// Runs figures/<script>.gp once, which makes these drawings in the scratch folder, and returns their paths.
/// `tables` is the folder of its tables as seen from there. Throws as draw() does, and data::FieldError with the smallest size of
/// the same shape that holds all labels if look.size_cm does not, or naming --font where there is no size.
[[nodiscard]] std::vector<std::filesystem::path> draw_in_scratch(const std::string& script, const Look& look,
                                                                 const std::string& tables,
                                                                 const std::vector<std::string>& drawings,
                                                                 OutputFolder& output);

/// The bytes of a drawing by figures/<script>.gp of these tables, whose keys are the names of their files.
[[nodiscard]] std::string drawing_of(const std::string& script, const Look& look,
                                     const std::map<std::string, std::string>& tables);

/// Runs figures/<name>.gp on the tables in the output folder, once for PDF and once for PNG, with size and font of `look`. Throws
/// ToolMissing if there is no gnuplot, std::runtime_error with gnuplot's own words if it fails.
void draw(const std::string& name, Look look, OutputFolder& output);

}  // namespace stickslip::report
