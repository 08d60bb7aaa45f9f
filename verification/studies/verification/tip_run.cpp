// SPDX-License-Identifier: MIT
#include "studies/verification/tip_run.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "stickslip/solver/stick_slip_integrator.hpp"

namespace stickslip::studies {

namespace {

std::vector<double> event_times(const std::vector<data::ContactEvent>& events) {
  std::vector<double> times;
  for (const auto& event : events)
    if (event.change == data::ContactChange::onset || event.change == data::ContactChange::capture)
      times.push_back(event.time);
  return times;
}

// The quasi-static shape of the system's own matrices, 1 at the contact.
Eigen::VectorXd quasi_static_shape(const solver::ContactSystem& system) {
  const Eigen::Index c = system.contact;
  Eigen::MatrixXd held(system.stick_stiffness);
  Eigen::VectorXd right_side = -held.col(c);
  held.row(c).setZero();
  held.col(c).setZero();
  held(c, c) = right_side[c] = 1.0;
  return held.ldlt().solve(right_side);
}

// The v in [v_free - reach, v_free + reach] at which v + strength c(v) changes its sign about v_free.
double sliding_velocity(const FrictionRule& law, const data::FrictionLaw& friction, double strength,
                        double free_velocity) {
  const double reach = 2.0 * strength * friction.static_coefficient();
  double low = free_velocity - reach, high = free_velocity + reach;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (middle + strength * law.coefficient(friction, middle) > free_velocity ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

TipRun tip_run(const solver::ContactSystem& system, const solver::PrescribedMotion& base,
               const data::NumericalSettings& numerics, solver::InitialVelocity start, const RunEnd& end) {
  solver::StickSlipIntegrator run(system, {.time_step = numerics.time_step(),
                                           .spectral_radius = numerics.spectral_radius(),
                                           .velocity_threshold = numerics.velocity_threshold()});
  const Eigen::VectorXd shape = quasi_static_shape(system);
  const double velocity = start == solver::InitialVelocity::zero ? 0.0 : system.wall.velocity(0.0);
  run.start_stuck(system.wall.displacement(0.0) * shape, velocity * shape);
  TipRun result{.step = numerics.time_step()};
  const long steps = std::lround(std::ceil(end.time / result.step - 1e-6));
  for (long n = 0; n <= steps; ++n) {
    if (n > 0) run.step();
    result.tip_displacement.push_back(base.displacement(run.time()) + run.displacement()[system.contact]);
    result.friction_force.push_back(-run.friction_force());
    if (run.events().size() >= end.events && event_times(run.events()).size() >= end.events) break;
  }
  result.events = event_times(run.events());
  return result;
}

TipRun tip_run(const solver::ContactSystem& system, const solver::PrescribedMotion& base,
               const data::NumericalSettings& numerics, const FrictionRule& law, const RunEnd& end) {
  constexpr int substeps = 10;
  const double h = numerics.time_step() / substeps;
  const Eigen::Index c = system.contact;
  const Eigen::MatrixXd mass(system.mass), damping(system.damping), stiffness(system.slip_stiffness);
  const Eigen::PartialPivLU<Eigen::MatrixXd> step_matrix(mass + 0.5 * h * damping + 0.25 * h * h * stiffness);
  const Eigen::MatrixXd from_velocity =
      step_matrix.solve(mass - 0.5 * h * damping - 0.25 * h * h * stiffness);
  const Eigen::MatrixXd from_displacement = -h * step_matrix.solve(stiffness);
  const Eigen::VectorXd from_load = h * step_matrix.solve(system.load_shape);
  const Eigen::VectorXd from_force = h * step_matrix.solve(Eigen::VectorXd::Unit(system.mass.rows(), c));
  const double limit = system.friction.static_coefficient() * system.normal_force;
  const double strength = from_force[c] * system.normal_force;

  const Eigen::VectorXd shape = quasi_static_shape(system);
  Eigen::VectorXd q = system.wall.displacement(0.0) * shape;
  Eigen::VectorXd v = system.wall.velocity(0.0) * shape, free(q.size());
  TipRun result{.step = numerics.time_step(),
                .tip_displacement = {base.displacement(0.0) + q[c]},
                .friction_force = {0.0}};
  bool sliding = false;
  const long steps = substeps * std::lround(std::ceil(end.time / result.step - 1e-6));
  for (long n = 0; n < steps && result.events.size() < end.events; ++n) {
    const double now = static_cast<double>(n) * h, next = static_cast<double>(n + 1) * h;
    free.noalias() =
        from_velocity * v + from_displacement * q + system.load_history(0.5 * (now + next)) * from_load;
    const double wall = system.wall.velocity(next), free_velocity = free[c] - wall;
    const double holding = -free_velocity / from_force[c];
    const bool held = law.holds && std::abs(holding) <= limit;
    const double force =
        held ? holding
             : (sliding_velocity(law, system.friction, strength, free_velocity) - free_velocity) /
                   from_force[c];
    if (held == sliding) result.events.push_back(next);
    sliding = !held;
    free += force * from_force;
    q += 0.5 * h * (v + free);
    v.swap(free);
    if ((n + 1) % substeps != 0) continue;
    result.tip_displacement.push_back(base.displacement(next) + q[c]);
    result.friction_force.push_back(-force);
  }
  return result;
}

}  // namespace stickslip::studies
