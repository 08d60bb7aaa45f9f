// SPDX-License-Identifier: MIT
#pragma once

/// Amplitude spectra of a history.

#include <cstddef>
#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

struct SpectrumLine {
  double frequency_hz{};
  double tip_displacement{};  ///< amplitude of y(L), m
  double friction_force{};    ///< amplitude of f, N
};

/// The number of last rows, `every` time steps apart, that hold the whole periods of the base motion in the second half of
/// the duration. Throws data::FieldError, naming excitation.duration, if that has less than two periods, and naming
/// --every, if a period has less than two rows or if there are more than four million.
[[nodiscard]] std::size_t spectrum_rows(const data::Case& problem, long every);

/// The spectra of the last `rows` values, `row_step` (s) apart. Where a value jumps, as the force at a capture, the sum over rows is off: the
/// error of an amplitude is up to the sum of the jumps in a period over the number of rows in it.
[[nodiscard]] std::vector<SpectrumLine> spectrum_of(const std::vector<double>& tip_displacements,
                                                    const std::vector<double>& friction_forces,
                                                    std::size_t rows, double row_step);

}  // namespace stickslip::studies
