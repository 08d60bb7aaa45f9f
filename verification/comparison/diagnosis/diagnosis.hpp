// SPDX-License-Identifier: MIT
#pragma once

/// What a result that differs from a data set may be.

#include <functional>
#include <vector>

#include "comparison/diagnosis/hypothesis.hpp"
#include "stickslip/data/user_table.hpp"

namespace stickslip::comparison {

/// A diagnosis for each quantity and group that differs, by the nearest of all hypotheses that are accepted (hypothesis.hpp):
/// - relations of the numbers (relations.hpp); events are also taken by their number, if some are missing or additional;
/// - for maxima of ten modes, the values of all modes, unless a relation explains the values to the tolerance;
/// - the wrong models (wrong_models.hpp), if the data set names the case. They take seconds, and are not run where one of the
///   others explains the values to the tolerance. The effect of each is computed by one method with and without the mistake and
///   applied to the values of the data set (relative_to_data()). At most 8 forces over 10 s, 30 frequencies, 12 events or five
///   periods of stick and slip (three without damping) are taken. The tolerance counts as the uncertainty of the user's values.
///
/// Where none is accepted, a sentence says so. Groups with the same sentence are joined. Data sets whose rows are cases (the
/// columns frequency, amplitude, length, axial_force) are diagnosed as a whole. `reference` and `theirs` are what was compared;
/// `progress` is told the completed fraction of the wrong models.
[[nodiscard]] std::vector<Diagnosis> diagnose(const Comparison& comparison,
                                              const data::ReferencePackage& package,
                                              const data::ReferenceTable& reference,
                                              const data::UserTable& theirs,
                                              const std::function<void(double)>& progress = {});

}  // namespace stickslip::comparison
