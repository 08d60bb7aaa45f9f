// SPDX-License-Identifier: MIT
#pragma once

/// Mistakes that two series of numbers show without a model: a factor, a shift, a constant, zeros, mixed modes,
/// and errors that grow with the mode number.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "stickslip/data/reference.hpp"

namespace stickslip::studies {

/// A user's values beside those of the data set.
struct ComparedValues {
  std::string abscissa_name, abscissa_unit, unit;
  data::Norm norm{};
  std::vector<double> abscissa, theirs, reference;
};

/// A relation of the user's values to the reference.
struct Pattern {
  std::string name;      ///< such as "constant-factor"
  std::string sentence;  ///< without a full stop
  double factor{};       ///< of a constant factor, else 0
  double remaining{};  ///< root mean square of what the pattern leaves unexplained, relative to the reference
  double difference{};  ///< the same measure of the whole difference
};

/// The difference that remains must be below that of the reference by this factor before a pattern is named.
///
/// `tried` patterns with `free` fitted numbers and n values: without fitted numbers, R of Diagnosis. A fitted
/// number leaves only the direction of the difference to chance, in n - free + 1 dimensions: a cone of the half-angle
/// asin(1/R) and its opposite contain at most the fraction R^(free-n) of all directions, so that
/// R = (tried/0.01)^(1/(n-free)); and at least 10, which is empirical. Neighbouring values are correlated, so that n counts as at
/// most 6; this is empirical as well. The result is infinite if n <= free.
[[nodiscard]] double required_ratio(std::size_t values, int free, int tried);

/// `predicted` as a pattern, if it is near enough to the user's values. A NaN leaves the value out;
/// at least three must remain.
[[nodiscard]] std::optional<Pattern> accepted(const ComparedValues& values, Pattern pattern,
                                              const std::vector<double>& predicted, int free, int tried);

/// The first pattern that explains the difference: a usual or another constant factor or, for angles, another
/// convention; a shift of the values along the abscissa or, for times of events, of the values themselves; a
/// constant that is added; for natural frequencies (Hz over
/// "mode") additional or missing modes, or a mesh of cubic Hermite elements. With the beam, the leading error
/// (beta l)^4/1440 gives the number of elements, and the frequencies on that mesh must agree; and axial
/// frequencies (2k-1)/(4L) sqrt(E/rho) are recognised.
[[nodiscard]] std::optional<Pattern> pattern_of(const ComparedValues& values,
                                                const data::Beam* beam = nullptr, bool is_slip = false);

/// Values that all are below 1e-4 of the largest of the data set.
[[nodiscard]] std::optional<Pattern> zeros_of(const ComparedValues& values);

/// A relative error c beta^4 or c beta^2 of natural frequencies, which go with beta^2: one c to 25 % (empirical)
/// over at least three modes that span a factor of three. `beam` tells a Timoshenko beam from lumped masses.
[[nodiscard]] std::optional<Pattern> growth_of(const ComparedValues& values, const data::Beam* beam);

}  // namespace stickslip::studies
