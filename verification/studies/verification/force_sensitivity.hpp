// SPDX-License-Identifier: MIT
#pragma once

/// Why the computed |f_max| of Sect. 5 agree with the printed values to three digits and not to five: the
/// effect of each choice of the method, and the number of digits that the problem determines.

#include <optional>
#include <string>
#include <vector>

#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// |f_max| at the printed frequencies with one change from the paper's statement. The unchanged methods are
/// Eq. (28) with N = 10, maximum over continuous time from 0 to 10 s; and finite elements with 20 elements,
/// 1e-4 s and spectral radius 0.9.
struct ForceRow {
  std::string factor;          ///< what is changed, such as "modes", "sampling step", "elements"
  std::string setting;         ///< its value, such as "12", "5e-3 s"
  bool closed_form{};          ///< Eq. (28); otherwise finite elements
  std::vector<double> force;   ///< N, one per frequency
  std::vector<double> change;  ///< of `force` from the unchanged row of the same method, %
};
STICKSLIP_MEMBERS(ForceRow, (factor, "-"), (setting, "-"), (closed_form, "1"), (force, "N"), (change, "%"))

/// A range of |f_max|, compared with the printed value.
struct ForceRange {
  analytic::Bounds force;  ///< N
  int digits{};            ///< common_digits of both ends
  bool holds_printed{};    ///< contains the printed value to half a unit of its last digit
};
STICKSLIP_MEMBERS(ForceRange, (force, "N"), (digits, "1"), (holds_printed, "1"))

/// The digits of one |f_max| that do not depend on the sampling, which alone the paper leaves open, and those of the
/// problem itself.
struct ForceDigits {
  double frequency_hz{};
  double printed{}, half_digit{};      ///< N
  ForceRange formula;                  ///< Eq. (28) with N = 10, over the samplings of sampled_forces()
  std::optional<double> printed_step;  ///< s, of sampled_forces()
  ForceRange problem;                  ///< all modes, continuous time; bounds, with an extrapolated tail
};
STICKSLIP_MEMBERS(ForceDigits, (frequency_hz, "Hz"), (printed, "N"), (half_digit, "N"), (formula),
                  (printed_step, "s"), (problem))

struct SamplingTrial {
  int modes{};                ///< N
  double sampling_step{};     ///< s
  std::vector<double> force;  ///< N, one per frequency
  /// Largest difference from the printed values, in half units of their last digit.
  double largest_difference{};
  int returned{};  ///< number of printed values that it reproduces to the last digit
};
STICKSLIP_MEMBERS(SamplingTrial, (modes, "1"), (sampling_step, "s"), (force, "N"), (largest_difference, "1"),
                  (returned, "1"))

/// A search for a number of modes and a sampling step that reproduce all four printed values to the last
/// digit.
struct SamplingSearch {
  int most_modes{};
  std::vector<double> sampling_steps;  ///< s
  int returning_all{};                 ///< number of trials that reproduce all printed values
  SamplingTrial closest;               ///< the trial with the smallest largest_difference
  SamplingTrial most_returned;         ///< the trial that reproduces most values; of several, the closest
  [[nodiscard]] int trials() const { return most_modes * static_cast<int>(sampling_steps.size()); }
};
STICKSLIP_MEMBERS(SamplingSearch, (most_modes, "1"), (sampling_steps, "s"), (returning_all, "1"), (closest),
                  (most_returned), (trials(), "1"))

/// The complete study. The vectors of forces have one entry per frequency.
struct ForceSensitivity {
  std::vector<double> frequency_hz;
  std::vector<ForceRow> rows;
  std::vector<ForceDigits> digits;
  SamplingSearch search;
};
STICKSLIP_MEMBERS(ForceSensitivity, (frequency_hz, "Hz"), (rows), (digits), (search))

/// Runs the study for the case of data/cases/paper.toml. Uses thread_count() threads; the result does not
/// depend on their number.
[[nodiscard]] ForceSensitivity force_sensitivity(const data::Case& paper);

}  // namespace stickslip::studies
