#pragma once

/// Why the |f_max| of Sect. 5 come back to three digits and not to five: what each choice of a method does to
/// them, what each given quantity does, and how many of their digits are the problem's own.

#include <string>
#include <vector>

#include "stickslip/analytic/bounds.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// |f_max| at the printed frequencies with one thing changed and all else as the paper states it: Eq. (28)
/// with N = 10, its true maximum over 0 ... 10 s; or finite elements on 20 elements with 1e-4 s and spectral
/// radius 0.9.
struct ForceRow {
  std::string factor;   ///< what is changed: "modes", "sampling step", "elements", ...
  std::string setting;  ///< what it is set to: "12", "5e-3 s"
  bool closed_form{};   ///< Eq. (28); else finite elements
  /// The paper leaves this open: how the maximum is sampled, by which method it was found, the mesh and the
  /// spectral radius. It states N = 10, the step of 1e-4 s and the duration.
  bool left_open{};
  std::vector<double> force;   ///< N, one per frequency
  std::vector<double> change;  ///< of `force` against the row of the same method with nothing changed, %
};

/// What one given quantity does to |f_max|. Young's modulus stands for I as well, the density for A: only E I
/// and rho A enter.
///
/// The derivative is a local one: a relative change of 1/(omega_N T) = 1e-5 turns the free vibrations of the
/// highest mode by a radian after T = 10 s, and another peak of |f| becomes the highest. What a larger change
/// does is in `lowest_change` and `highest_change`. Predicted, from dimensions alone, for the derivatives s
/// of E, rho, P and L: s_E + s_rho + s_P = 1 and s_L = -3 + 2 s_P + 4 s_rho.
struct InputSensitivity {
  std::string input;             ///< "E", "rho", "P", "L", "Omega"
  std::vector<double> relative;  ///< d ln |f_max| / d ln input, one per frequency
  /// Change of |f_max| with the input anywhere within 0.1 %, lowest and highest of 41 values, %.
  std::vector<double> lowest_change, highest_change;
  /// What would follow from reading the input as rounded to its printed digits, not as exact: change of
  /// |f_max| at half a unit of the last digit below and above, %.
  std::vector<double> at_half_digit_below, at_half_digit_above;
};

/// A range of |f_max| and what it leaves of the printed value.
struct ForceRange {
  analytic::Bounds force;  ///< N
  int digits{};            ///< common_digits of both ends
  bool holds_printed{};    ///< to half a unit of the last printed digit
};

/// Digits of one |f_max|: those on which all that the paper leaves open agrees, and those of the problem.
struct ForceDigits {
  double frequency_hz{};
  double printed{}, half_digit{};  ///< N
  ForceRange formula;              ///< Eq. (28) with N = 10, over the ways of sampling
  ForceRange method;               ///< over all rows with left_open, finite elements included
  ForceRange problem;  ///< all modes, continuous time: rigorous but for the tail, which is extrapolated
};

/// One way of sampling Eq. (28).
struct SamplingTrial {
  int modes{};                  ///< N
  double sampling_step{};       ///< s
  std::vector<double> force;    ///< N, one per frequency
  double largest_difference{};  ///< from the printed values, in half units of the last printed digit
  int returned{};               ///< printed values that come back to the digit
};

/// The search for a number of modes and a sampling step that return all four printed values to the digit.
struct SamplingSearch {
  int most_modes{};
  std::vector<double> sampling_steps;  ///< s
  int returning_all{};                 ///< trials with all printed values
  std::vector<int> returning;          ///< trials that return each of them
  SamplingTrial closest;               ///< the smallest largest_difference
  SamplingTrial most_returned;         ///< the most values returned; of those, the closest
};

struct ForceSensitivity {
  std::vector<double> frequency_hz;
  std::vector<ForceRow> rows;
  std::vector<InputSensitivity> inputs;
  std::vector<ForceDigits> digits;
  SamplingSearch search;
};

/// `paper` is the case of data/cases/paper.toml. Uses thread_count() threads; the result does not depend on
/// that.
[[nodiscard]] ForceSensitivity force_sensitivity(const data::Case& paper);

}  // namespace stickslip::studies
