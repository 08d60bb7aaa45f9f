// SPDX-License-Identifier: MIT
#pragma once

#include "render/criterion_map.hpp"
#include "render/figures.hpp"

namespace stickslip::report {

/// The table and the values of figures/map.gp.
[[nodiscard]] FigureData figure_of(const data::Case& problem, const studies::CriterionMap& map);

}  // namespace stickslip::report
