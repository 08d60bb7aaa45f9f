#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/data/paper.hpp"
#include "test_results.hpp"

namespace stickslip::report {

inline constexpr int paper_equations = 30, paper_figures = 14;

/// The numbers of the paper's equations ("Eq") or figures ("Fig") that a text names: "Eqs. (1) to (3), (26)"
/// gives 1, 2, 3 and 26, "Figs. 4b and 5" 4 and 5.
[[nodiscard]] std::set<int> numbers_named(std::string_view text, std::string_view kind);

/// Rows, one for each equation and figure of the paper: item, requirements that name it and how many tests
/// they have, claims about it by verdict, and the figure of this report that repeats it.
[[nodiscard]] std::string paper_index_rows(const std::vector<TestResult>& tests,
                                           const std::vector<data::Claim>& claims);

}  // namespace stickslip::report
