// SPDX-License-Identifier: MIT
#pragma once

/// What a spring or a smooth law in place of the set-valued law of friction does to stick-slip.

#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::testing {

/// A run by the boundary integral, summed up. Per period: mean over the last half of the run, which must hold whole
/// periods of the excitation.
struct ContactSummary {
  /// When the slider first moves, or the set-valued law first slips; with a smooth law, when |v_s| first exceeds the
  /// transition velocity 1.5 v_r: a cubic law of the same slope at rest reaches mu_s N there. s; negative if never.
  double first_slip{};
  double travel{};  ///< path of the slider, or of the tip where there is no spring, per period, m
  double work{};    ///< dissipated by friction per period, J: -int f_d v_s dt less what the spring has stored
  double largest_force{};  ///< max |f|, N
};

/// `step` is the time step, s. Throws what BeamBoundaryIntegral throws.
[[nodiscard]] ContactSummary contact_summary(const data::Case& problem, double step);

/// The setting of a regularisation in a code, on this beam.
struct CodeSetting {
  std::string name;
  data::ContactProperties contact;
};

/// The set-valued law and what codes put in its place, each with the value that their manuals state as default, or an
/// example where they leave it to the user (user guide, "Contact compliance"). An allowed elastic slip g makes k_t = mu_s
/// P/g, a transition velocity v_t the width v_r = v_t/1.5. The size of a face of the contact is 0.1 m, the height of the
/// section of the paper's beam.
[[nodiscard]] std::vector<CodeSetting> code_settings(const data::Case& problem);

/// The error of one quantity of a run against that with the set-valued law, as the regularisation is refined.
struct RegularisationRate {
  std::string quantity;
  double order{};  ///< the slope of log(error) over log(1/k_t) or log(v_r)
};

/// First slip (s), largest distance of the position of the tip on the wall (m), its travel (m) and the mean distance of
/// the friction force (N), over numerics.duration(). The first slip with a smooth law is taken at |v_s| = 10 mm/s here, in
/// both runs.
[[nodiscard]] std::vector<RegularisationRate> regularisation_rates(
    const data::Case& problem, const std::vector<data::ContactProperties>& refined, double step);

}  // namespace stickslip::testing
