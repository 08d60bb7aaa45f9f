#pragma once

#include "figures.hpp"
#include "stickslip/report/output_folder.hpp"

namespace stickslip::report {

/// Writes the tables of a figure into the output folder.
void write_tables(const FigureData& data, OutputFolder& output);

/// Runs figures/<name>.gp on the tables in the output folder, once for PDF and once for PNG. Throws
/// ToolMissing if there is no gnuplot, std::runtime_error with gnuplot's own words if it fails.
void draw(const std::string& name, const FigureData& data, OutputFolder& output);

}  // namespace stickslip::report
