// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include "comparison/comparison.hpp"
#include "render/csv_table.hpp"
#include "render/drawing.hpp"
#include "stickslip/data/problem.hpp"
#include "studies/analyses/criterion_answer.hpp"
#include "studies/analyses/criterion_map.hpp"
#include "studies/analyses/slip_probability.hpp"

namespace stickslip::report {

/// The column of a key that may be an axis, as CsvTable takes it.
[[nodiscard]] std::string column_of(std::string_view parameter);

/// One row per cell, with a force ratio only where there is a stick state; an empty line where a y ends. A
/// quantity has a column with its value, where that has converged, and one with its change.
[[nodiscard]] CsvTable table_of(const data::Case& problem, const studies::CriterionMap& map);

/// The map drawn by gnuplot (figures/map.gp) from the text of its table, as the bytes of a file. Throws std::runtime_error if gnuplot is
/// missing or fails.
[[nodiscard]] std::string draw(const std::string& table, const studies::CriterionMap& map, const Look& look);

/// The critical amplitude over the frequency, drawn by gnuplot (figures/criterion.gp), as draw() of a map.
[[nodiscard]] std::string draw(const data::Case& problem, const studies::CriticalAmplitudeCurve& curve,
                               const Look& look);

/// The margin of each row of a table of cases, which are counted from 1, drawn by gnuplot (figures/plan.gp), as draw() of a map.
[[nodiscard]] std::string draw(const std::map<std::size_t, double>& margins, const Look& look);

/// The histogram of the margins of the samples, drawn by gnuplot (figures/uncertainty.gp), as draw() of a map.
[[nodiscard]] std::string draw(const studies::SlipUncertainty& result, const Look& look);

/// A comparison drawn by gnuplot (figures/comparison.gp), as the bytes of a file: for each quantity with
/// points the reference with its band and theirs, and below them the difference with what is allowed.
/// Throws std::runtime_error if gnuplot is missing or fails.
[[nodiscard]] std::string draw(const comparison::Comparison& comparison, const Look& look);

}  // namespace stickslip::report
