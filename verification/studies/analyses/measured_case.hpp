// SPDX-License-Identifier: MIT
#pragma once

/// A measurement of a beam against its case, in the form of ASME V&V 20 (validation::Comparison).

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "validation/study.hpp"

namespace stickslip::studies {

struct OwnMeasurement {
  std::string quantity;  ///< stick_frequency, slip_frequency or critical_amplitude
  double at{};           ///< number of the mode, from 1; or the excitation frequency, Hz
  double value{};        ///< Hz, m
  double half_width{};   ///< of the interval of 95 %: 2 u_D, ≥ 0
};

/// A table with the columns quantity, at, value and half_width. Throws data::InputError, naming line, column and value, for
/// another column, a quantity that is none of these, and a number that is not allowed.
[[nodiscard]] std::vector<OwnMeasurement> read_measurements(const std::filesystem::path& file);

struct CaseComparison {
  std::vector<validation::Comparison> comparisons;  ///< a row for each measurement
  std::size_t dropped{};                            ///< samples of all rows that are no beam
  bool has_uncertainty{};                           ///< whether the case has a table [uncertainty]
};

/// S is the closed form of the case with all modes; u_num the rounding of a frequency, or half of what the modes that
/// numerics.modes leaves out change with the width of the bounds. u_input is the standard deviation over independent samples of
/// the keys of [uncertainty], those of `stickslip uncertainty`, with numerics.modes. Throws data::InputError for an excitation
/// frequency or a contact that is uncertain, for fewer than two samples that are beams, and what the criterion throws.
[[nodiscard]] CaseComparison compare_with_case(const std::filesystem::path& file,
                                               const std::vector<OwnMeasurement>& measurements,
                                               std::size_t samples,
                                               const std::function<void(double)>& progress = {});

}  // namespace stickslip::studies
