// SPDX-License-Identifier: MIT
#include "studies/history/spectrum.hpp"

#include <fmt/format.h>

#include <cmath>

#include "stickslip/analytic/amplitude_spectrum.hpp"
#include "stickslip/data/input_error.hpp"

namespace stickslip::studies {

std::size_t spectrum_rows(const data::Case& problem, long every) {
  constexpr double rounding = 1e-9;
  constexpr long long most_rows = 4'000'000;
  const double row_step = static_cast<double>(every) * problem.numerics.time_step(),
               period = 1.0 / problem.excitation.frequency_hz();
  const double periods = std::floor(0.5 * problem.numerics.duration() / period + rounding);
  const auto rows = std::llround(periods * period / row_step);
  if (periods < 1.0)
    throw data::FieldError(
        "excitation.duration", problem.numerics.duration(),
        fmt::format("at least two periods of the base motion, {} s, where --spectrum is given",
                    data::shortest_text(2.0 * period)));
  if (static_cast<double>(rows) < 2.0 * periods)
    throw data::FieldError(
        "--every", static_cast<double>(every),
        "small enough for two rows in a period of the base motion where --spectrum is given");
  if (rows > most_rows)
    throw data::FieldError("--every", static_cast<double>(every),
                           fmt::format("large enough for at most {} rows in a spectrum", most_rows));
  return static_cast<std::size_t>(rows);
}

std::vector<SpectrumLine> spectrum_of(const std::vector<double>& tip_displacements,
                                      const std::vector<double>& friction_forces, std::size_t rows,
                                      double row_step) {
  const auto amplitudes = [rows](const std::vector<double>& values) {
    return analytic::amplitude_spectrum({values.end() - static_cast<std::ptrdiff_t>(rows), values.end()});
  };
  const auto tip = amplitudes(tip_displacements), force = amplitudes(friction_forces);
  std::vector<SpectrumLine> lines;
  for (std::size_t k = 0; k < tip.size(); ++k)
    lines.push_back({static_cast<double>(k) / (static_cast<double>(rows) * row_step), tip[k], force[k]});
  return lines;
}

}  // namespace stickslip::studies
