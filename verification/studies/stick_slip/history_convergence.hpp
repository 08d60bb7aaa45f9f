#pragma once

/// Do undamped histories of generalised-alpha converge to that of the beam, and does the bound of their
/// growth (contact_growth.hpp) say so beforehand?

#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/convergence/convergence.hpp"
#include "studies/stick_slip/converged_history.hpp"

namespace stickslip::studies {

/// The relative change of the amplitude whose growth is observed, up to this share of the range of y(L).
inline constexpr double perturbation = 1e-9, observed_until = 0.1;

/// One run, in modal coordinates, with located changes and without a velocity threshold.
struct HistoryRun {
  int elements{};
  double time_step{};  ///< h, s
  double spectral_radius{};
  double highest_angle{};    ///< omega_max h, omega_max the highest frequency of the mesh
  double growth_bound{};     ///< sigma* of mesh and step, 1/s
  double observed_growth{};  ///< of the effect of a perturbation, 1/s; 0 unless it is asked for
  double error{};            ///< largest difference of y(L) to the converged history, as a share of its range
  int changes{};             ///< of contact
};

/// The observed growth is the slope of the logarithm of the largest difference in each period of the load,
/// from the first slip to a tenth of the range, or 0 if there are fewer than three periods. `time_step` is
/// shortened to divide the spacing of the reference. With a radiating_share > 0 that share of the mass rho A
/// l of an element, l its length, hangs on the tip by a dashpot of kappa (with_radiating_contact()). Throws
/// what solver::BeamSimulation throws.
[[nodiscard]] HistoryRun history_run(const data::Case& problem, const ConvergedHistory& reference,
                                     int elements, double time_step, double spectral_radius,
                                     bool observe_growth, double radiating_share = 0.0);

/// How the step follows the mesh.
struct StepRule {
  std::string name{};
  double angle{};      ///< omega_max h; or 0 for a fixed step
  double time_step{};  ///< h, s, if the angle is 0
  double spectral_radius{};
  double radiating_share{};  ///< see history_run()
};

/// The time step of a rule, s.
[[nodiscard]] double time_step_of(const StepRule& rule, const data::Beam& beam, int elements);

/// omega_max h with which the spectral radius 0 takes from a mesh the growth that the beam does not have.
inline constexpr double filtering_angle = 2.445;

/// omega_max l^2 sqrt(rho A/EI) of a uniform mesh of elements of length l, P = 0: 59.792 on 5
/// elements, 59.878 from 20 on (computed).
inline constexpr double highest_frequency_factor = 59.88;

/// Runs of one rule on several meshes, and the order in l in which their errors fall. The growth is observed
/// on meshes of at most `observed_elements`.
struct HistoryRefinement {
  StepRule rule;
  double frequency_hz{};
  std::vector<HistoryRun> runs;
  OrderEstimate order;  ///< empirical: no theory of the order is known
};
[[nodiscard]] HistoryRefinement history_refinement(const data::Case& problem,
                                                   const ConvergedHistory& reference, const StepRule& rule,
                                                   const std::vector<int>& elements, int observed_elements);

}  // namespace stickslip::studies
