// SPDX-License-Identifier: MIT
#pragma once

/// What a result that differs from a data set may be.

#include <functional>
#include <vector>

#include "comparison/comparison.hpp"

namespace stickslip::comparison {

/// A diagnosis for each quantity and group that differs. These are asked in turn until a hypothesis is accepted
/// (ranking.hpp), and of several the nearest is named:
/// - one number in the problem of a mass (wrong_numbers.hpp), unless a usual factor says it all;
/// - a relation of the numbers alone (patterns.hpp), single values, another column, zeros; a factor that was fitted and leaves
///   more than the tolerance only if no model is nearer;
/// - frequencies of a beam with other parts of Timoshenko's theory;
/// - another data set with the same columns, to the tolerance;
/// - for y(L/2), the values at the node beside the middle on a mesh of 4 to 40 elements;
/// - for maxima of ten modes, the values of all modes;
/// - the nearest wrong model, if the data set names the case. Its effect is computed by one method with and
///   without the mistake and applied to the values of the data set (relative_to_data()). At most 8 forces
///   over 10 s, 12 events or five periods of stick and slip (three without damping) are taken for it, which keeps a
///   diagnosis within seconds. The tolerance counts as the uncertainty of the user's values. Where no model is near, and of
///   forces over 10 s before the models, one number of the problem is fitted, or the width of a smooth law of friction;
/// - another data set, beyond the tolerance;
/// - an error of natural frequencies that grows with the mode number.
///
/// Where none is accepted and no wrong model concerns the quantity, a sentence says so. Those that need no model come first,
/// because models take seconds. Groups with the same sentence are joined. Data sets whose rows are cases (the columns frequency, amplitude, length, axial_force) are diagnosed as a whole.
/// `reference` and `theirs` are what was compared; `progress` is told the completed fraction of the wrong models.
[[nodiscard]] std::vector<Diagnosis> diagnose(const Comparison& comparison,
                                              const data::ReferencePackage& package,
                                              const data::ReferenceTable& reference,
                                              const data::UserTable& theirs,
                                              const std::function<void(double)>& progress = {});

}  // namespace stickslip::comparison
