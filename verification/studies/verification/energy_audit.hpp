// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <vector>

#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/data/problem.hpp"
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

}  // namespace stickslip::studies
