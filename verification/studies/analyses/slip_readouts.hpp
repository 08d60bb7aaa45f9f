// SPDX-License-Identifier: MIT
#pragma once

/// Read-outs of a stick-slip motion: what is measured where parts rub, and what is heard.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "studies/analyses/sampling.hpp"
#include "studies/history/history.hpp"

namespace stickslip::studies {

inline constexpr int least_rows_in_a_period = 20;  ///< and in a window

struct ReadoutOptions {
  double transient{};  ///< left out from the start, s
  int windows{10};     ///< at least 2
};

/// Sums over the rows and events of one window.
struct ReadoutWindow {
  double begin{};                                                          ///< s
  double least{std::numeric_limits<double>::infinity()}, largest{-least};  ///< z of the rows, m
  double travel{};                                                         ///< m
  double slips{};                                                          ///< onsets
  double slipping{};                                                       ///< s
  double work{};                                                           ///< of friction, J
  [[nodiscard]] double range() const { return largest - least; }
};

/// The read-outs from the first row after the transient to the last row, over windows of equal length: an
/// Estimate is a mean over these. Those of a periodic motion are neither normal nor independent; its interval says how far they differ. z is the displacement of the
/// tip relative to the wall; a wall of constant speed leaves its drift in it. Slips begin and end at the onsets and captures of
/// History::events, where z of a rigid contact also turns; a contact that yields slips as its rows say. NaN for what there is none of.
struct SlipReadouts {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  std::vector<ReadoutWindow> windows;
  double window{};  ///< their length, s
  std::size_t rows{};
  double row_step{};        ///< s
  Estimate peak_to_peak{};  ///< max z - min z of the rows of a window, m
  double distance_95{};     ///< 95th percentile of |z - mean z| of the rows, by a line between two of them, m
  double distance_99{};     ///< 99th percentile, m
  double travel{};          ///< Σ |Δz| between rows and events, m
  Estimate travel_rate{};   ///< m/s
  std::size_t slips{};      ///< onsets
  Estimate slip_rate{};     ///< the impulse rate, 1/s
  double slips_per_travel{none};   ///< slips/travel, 1/m
  Estimate slip_share{};           ///< share of the time in slip
  double spacing{none};            ///< mean time from onset to onset, s
  double spacing_variation{none};  ///< its standard deviation over its mean
  /// "squeal" where the slips are regular and fast: spacing_variation < 0.2 and more than 20 in a second, which the ear joins to a
  /// tone; "tick" for other slips, "none" without an onset. A rule of this program, of no standard.
  std::string_view sound{"none"};
  Estimate friction_power{};  ///< Σ f Δz per time, f the mean of both ends: what friction dissipates, W
  double peak_hz{};           ///< of the highest line of the amplitude spectrum of f less its mean, Hz
  double peak_force{};        ///< that line, N: spectrum_of() by the flat-top window, to 0.08 % of a sine
  double force_level{};       ///< 20 lg of the root mean square of f less its mean, dB re 1 N
  double
      a_weighted_level{};  ///< the same, the squares of the lines weighted by a_weighting(), dB re 1 N: up to half the rows in a second
};

/// A-weighting in dB (IEC 61672-1:2013, Annex E): with f1 = 20.60 Hz, f2 = 107.7 Hz, f3 = 737.9 Hz, f4 = 12194 Hz
///
///     A(f) = 20 lg [f4² f⁴/((f² + f1²) √((f² + f2²)(f² + f3²)) (f² + f4²))] + 2.000.
[[nodiscard]] double a_weighting(double hz);

/// The time steps from row to row: the most that leave least_rows_in_a_period in a period of the highest frequency of the motion and of the first
/// natural frequency with the tip held, of one mass with the tip free, in a window and, for the ear, 11025 in a second as long as these are a million. Throws
/// data::FieldError for a transient or a time step that does not leave these, and for more than four million rows.
[[nodiscard]] long readout_row_step(const data::Case& problem, const ReadoutOptions& options);

/// The 95th and the 99th percentile of |z - mean z|, by a line between two of the values; at least one.
[[nodiscard]] std::pair<double, double> distance_percentiles(std::vector<double> values);

/// The read-outs of a history with rows of readout_row_step(). Precondition: at least two rows in a window.
[[nodiscard]] SlipReadouts slip_readouts(const data::Case& problem, const History& history,
                                         const ReadoutOptions& options);

/// The case with the seeds of its spectra and `number` more, which makes realisations that are independent. Throws data::FieldError, naming
/// --average, for a case without a spectrum.
[[nodiscard]] data::Case realisation(const data::Case& problem, std::uint64_t number);

/// The mean of a number over those read-outs that have a finite one, with its interval by Student's t; `none` of fewer than two.
[[nodiscard]] Estimate mean_over(const std::vector<SlipReadouts>& realisations,
                                 const std::function<double(const SlipReadouts&)>& number);

/// A WAV file, 16-bit PCM, one channel, 44.1 kHz: the friction force of these rows less its mean, over its largest modulus, by lines
/// between rows.
[[nodiscard]] std::string force_as_wav(const History& history, double transient);

}  // namespace stickslip::studies
