// SPDX-License-Identifier: MIT
#pragma once

/// What a result that differs from a data set looks like.

#include "comparison/comparison.hpp"

namespace stickslip::studies {

/// Adds to `comparison.likenesses` a sentence for each quantity and group that differs, in this order:
/// - a pattern of the numbers alone (patterns.hpp);
/// - the values of another data set with the same columns, or, beyond the tolerance, after the wrong models;
/// - for y(L/2), the values at the node beside the middle on a mesh of 4 to 40 elements;
/// - for maxima of ten modes, the values of all modes;
/// - the nearest wrong model, if the data set names the case. Its effect is computed by one method with and
///   without the mistake and applied to the values of the data set (relative_to_data()). At most 8 forces
///   over 10 s, 12 events or five periods of stick and slip (three without damping) are taken for it, which keeps a diagnosis within
///   seconds;
/// - an error of natural frequencies that grows with the mode number.
///
/// Groups with the same sentence are joined. Data sets whose rows are cases (the columns frequency,
/// amplitude, length, axial_force) are diagnosed as a whole.
void find_likenesses(Comparison& comparison, const data::ReferencePackage& package,
                     const data::ReferenceTable& reference, const data::UserTable& theirs,
                     const ComparisonSettings& settings);

}  // namespace stickslip::studies
