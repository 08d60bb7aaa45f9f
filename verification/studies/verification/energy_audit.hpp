// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/data/problem.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// The energy balance of one stick-slip history by two methods: event-driven without a mesh, and by time
/// integration on several meshes.
struct EnergyAudit {
  double kelvin_voigt{}, duration{};         ///< s
  int modes{};                               ///< of the event-driven run
  analytic::EventDrivenEnergy event_driven;  ///< at the end
  double event_driven_initial{};             ///< kinetic + potential at t = 0, J
  std::vector<double> time_step;             ///< s
  struct Mesh {
    int elements{};
    std::vector<solver::EnergyBalance> stepped;          ///< at the end, one per time step; spectral radius 1
    OrderEstimate observed_order;                        ///< of |residual| in the time step
    [[nodiscard]] std::vector<double> residual() const;  ///< of each step, J
    [[nodiscard]] std::vector<double> base_work() const;  ///< of each step, J
    [[nodiscard]] double largest_unexplained() const;     ///< max |residual/base_work| over the steps
  };
  std::vector<Mesh> meshes;

  /// The change of the event-driven energy, and the residual of its balance, J.
  [[nodiscard]] double event_driven_change() const {
    return event_driven.kinetic + event_driven.potential - event_driven_initial;
  }
  [[nodiscard]] double event_driven_residual() const {
    return event_driven_change() - event_driven.base_work - event_driven.follower_work +
           event_driven.damping_loss + event_driven.friction_loss;
  }
  /// |residual/base_work| of the event-driven run.
  [[nodiscard]] double event_driven_unexplained() const {
    return std::abs(event_driven_residual() / event_driven.base_work);
  }
};
STICKSLIP_MEMBERS(EnergyAudit::Mesh, (elements, "1"), (stepped), (observed_order), (residual(), "J"),
                  (base_work(), "J"), (largest_unexplained(), "1"))
STICKSLIP_MEMBERS(EnergyAudit, (kelvin_voigt, "s"), (duration, "s"), (modes, "1"), (event_driven),
                  (event_driven_initial, "J"), (time_step, "s"), (meshes), (event_driven_change(), "J"),
                  (event_driven_residual(), "J"), (event_driven_unexplained(), "1"))

/// One event-driven run, and one run per mesh and time step. Predicted residual of the event-driven run: the
/// tolerance of the integrator. Predicted order of the time integration: 2 in h, for the modes that h
/// resolves.
[[nodiscard]] EnergyAudit energy_audit(const data::Case& problem, double duration,
                                       const std::vector<int>& elements, int modes,
                                       const std::vector<double>& time_steps);

/// A stick phase after a slip phase.
struct Plateau {
  double begin{}, end{};      ///< s
  double tip_displacement{};  ///< y(L), m
};
STICKSLIP_MEMBERS(Plateau, (begin, "s"), (end, "s"), (tip_displacement, "m"))

/// The result of one contact scheme.
struct SchemeRun {
  /// The shortest stick phase that counts as a plateau, s.
  static constexpr double shortest_plateau = 2e-3;
  std::optional<double> first_slip;                ///< s
  std::size_t events{};                            ///< number of changes of the contact state
  std::vector<Plateau> plateaus;                   ///< at least shortest_plateau long, begin within 0.2 s
  double largest_tip_displacement{};               ///< max |y(L)| over the steps, m
  solver::EnergyBalance energy;                    ///< at the end
  [[nodiscard]] double relative_residual() const;  ///< energy.residual() over the work of the base
};
STICKSLIP_MEMBERS(SchemeRun, (shortest_plateau, "s"), (first_slip, "s"), (events, "1"), (plateaus),
                  (largest_tip_displacement, "m"), (energy), (relative_residual(), "1"))

/// Runs the case over numerics.duration() by three schemes in this order: with located changes, with
/// changes at the end of the step, and exactly as Sects. 2 and 3 of the paper describe. The rule of switching
/// in the paper's reference [18] (Won & Chung, J. Sound Vib. 419, 42-62, 2018) is not available. Each run has
/// its energy balance. Throws what BeamSimulation throws.
[[nodiscard]] std::vector<SchemeRun> compare_schemes(const data::Case& problem);

}  // namespace stickslip::studies
