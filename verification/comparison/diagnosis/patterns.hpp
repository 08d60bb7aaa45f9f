// SPDX-License-Identifier: MIT
#pragma once

/// Mistakes that two series of numbers show without a model: a factor, a shift, a constant, zeros, mixed modes,
/// and errors that grow with the mode number.

#include <optional>
#include <vector>

#include "comparison/diagnosis/ranking.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::comparison {

/// The first pattern that explains the difference: a usual or another constant factor or, for angles, another
/// convention; a shift of the values along the abscissa or, for times of events, of the values themselves; a
/// constant that is added; for natural frequencies (Hz over
/// "mode") additional or missing modes, or a mesh of cubic Hermite elements. With the beam, the leading error
/// (beta l)^4/1440 gives the number of elements, and the frequencies on that mesh must agree; and axial
/// frequencies (2k-1)/(4L) sqrt(E/rho) are recognised.
[[nodiscard]] std::optional<Hypothesis> pattern_of(const ComparedValues& values,
                                                   const data::Beam* beam = nullptr, bool is_slip = false);

/// Values that all are below 1e-4 of the largest of the data set.
[[nodiscard]] std::optional<Hypothesis> zeros_of(const ComparedValues& values);

/// A relative error c beta^4 or c beta^2 of natural frequencies, which go with beta^2: one c to 25 % (empirical)
/// over at least three modes that span a factor of three. With `beam` the number of elements is told.
[[nodiscard]] std::optional<Hypothesis> growth_of(const ComparedValues& values, const data::Beam* beam);

/// Frequencies (Hz over "mode") of a beam with other parts of Timoshenko's theory: those that are accepted. Those of the data set
/// are by Euler and Bernoulli or, with `is_timoshenko`, with κ = 5/6 and ν = 0.3. Both are computed on a mesh.
[[nodiscard]] std::vector<Hypothesis> other_beams(const ComparedValues& values, const data::Beam& beam,
                                                  bool is_slip, bool is_timoshenko);

/// κ G A, N.
[[nodiscard]] double shear_stiffness(const data::Beam& beam, double coefficient, double poisson_ratio);

}  // namespace stickslip::comparison
