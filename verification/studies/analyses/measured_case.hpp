// SPDX-License-Identifier: MIT
#pragma once

/// A measurement of a beam against its case, in the form of ASME V&V 20 (validation::Comparison).

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "validation/study.hpp"

namespace stickslip::studies {

struct CaseComparison {
  std::vector<validation::Comparison> comparisons;  ///< a row for each measurement
  std::size_t dropped{};                            ///< samples of all rows that are no beam
  bool has_uncertainty{};                           ///< whether the case has a table [uncertainty]
};

/// `measurements` is a table with the columns quantity (stick_frequency, slip_frequency, critical_amplitude), at (number of the
/// mode, from 1; or the excitation frequency, Hz), value (Hz, m) and half_width (of the interval of 95 %: 2 u_D, ≥ 0).
///
/// S is the closed form of the case with all modes; u_num the rounding of a frequency, or half of what the modes that
/// numerics.modes leaves out change with the width of the bounds. u_input is the standard deviation over independent samples of
/// the keys of [uncertainty], those of `stickslip uncertainty`, with numerics.modes. Throws data::InputError, naming line, column
/// and value, for what no such table has; for an excitation frequency or a contact that is uncertain; for fewer than two
/// samples that are beams; and what the criterion throws.
[[nodiscard]] CaseComparison compare_with_case(const std::filesystem::path& case_file,
                                               const std::filesystem::path& measurements, std::size_t samples,
                                               const std::function<void(double)>& progress = {});

}  // namespace stickslip::studies
