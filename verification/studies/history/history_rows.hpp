// SPDX-License-Identifier: MIT
#pragma once

/// How dense the rows of a history must be for the eye and the ear.

#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// The number of time steps from row to row: the largest 1, 2 or 5 times a power of ten that leaves at least 100 rows in a
/// period of the excitation, 20 in a period of the first natural frequency of the stick state and 2000 in the time `span` (s); or 1.
/// Throws what modal_forces() throws.
[[nodiscard]] long usual_row_step(const data::Case& problem, double span);

}  // namespace stickslip::studies
