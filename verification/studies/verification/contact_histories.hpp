// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"
#include "studies/history/history_convergence.hpp"

namespace stickslip::studies {

/// One panel of Figs. 4 and 5: the converged motion, and whether the tip slips according to both
/// implementations.
struct ContactHistory {
  double frequency_hz{};
  double amplitude{};                         ///< m
  std::optional<ConvergedHistory> converged;  ///< sampled every 2e-4 s; empty if the criterion predicts stick
  std::optional<double> finite_element_slip;  ///< time of the first slip, s
  std::optional<double> closed_form_slip;     ///< first time at which |f| > μ_s P in the closed form, s
  bool criterion_slips{};                     ///< Eqs. (29), (30) over numerics.duration()
  std::string figure{};                       ///< of the paper, such as "4a"
  bool printed_slips{};                       ///< according to the paper
  /// Whether paper, criterion and finite elements have the same verdict.
  [[nodiscard]] bool verdicts_agree() const {
    return printed_slips == criterion_slips && printed_slips == finite_element_slip.has_value();
  }
  /// |finite_element_slip - closed_form_slip|, s, if there are both.
  [[nodiscard]] std::optional<double> first_slip_difference() const;
};
STICKSLIP_MEMBERS(ContactHistory, (frequency_hz, "Hz"), (amplitude, "m"), (converged),
                  (finite_element_slip, "s"), (closed_form_slip, "s"), (criterion_slips, "1"), (figure, "-"),
                  (printed_slips, "1"), (verdicts_agree(), "1"), (first_slip_difference(), "s"))

/// Computes the history of an undamped case over `shown` seconds. The decisions on slip use
/// numerics.duration().
[[nodiscard]] ContactHistory contact_history(const data::Case& problem, double shown);

/// The panels of Figs. 4 and 5, in the paper's order, with the case of data/cases/paper.toml.
[[nodiscard]] std::vector<ContactHistory> contact_histories(const data::Case& paper, double shown);

/// An undamped history with usual settings, compared with the converged one.
struct PracticeRun {
  std::string method{};
  int elements{};
  double time_step{};        ///< s; 0 for event-driven runs
  double spectral_radius{};  ///< of generalised-alpha
  int changes{};             ///< of contact
  double largest_error{};    ///< of y(L) at the times of the history, as a fraction of its range
  std::vector<double> tip_displacement{};  ///< y(L) at the times of the history, m
};
STICKSLIP_MEMBERS(PracticeRun, (method, "-"), (elements, "1"), (time_step, "s"), (spectral_radius, "1"),
                  (changes, "1"), (largest_error, "1"), (tip_displacement, "m"))

/// Runs with usual settings, all with the time step of `numerics` where there is one: the scheme of the
/// paper; located changes with the spectral radii 0.5, 0.9 and 1; and event-driven runs on
/// numerics.elements() and on twice as many elements. The excitation is that of the converged history; the
/// problem is undamped.
[[nodiscard]] std::vector<PracticeRun> usual_practice(data::Case problem, const ConvergedHistory& converged);

/// The first time (s) at which |f| of the closed form with the exact steady part exceeds the limit; empty if
/// there is none within the duration. The search uses steps of 1/2000 of the shorter of the periods of the
/// excitation and of the first mode, and locates the time to 1/20000 of a step.
[[nodiscard]] std::optional<double> closed_form_first_slip(const data::Beam& beam,
                                                           const data::FrictionLaw& friction,
                                                           const data::HarmonicExcitation& excitation,
                                                           double duration);

}  // namespace stickslip::studies
