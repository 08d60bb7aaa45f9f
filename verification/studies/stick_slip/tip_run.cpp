// SPDX-License-Identifier: MIT
#include "studies/stick_slip/tip_run.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <memory>

#include "stickslip/solver/stick_slip_integrator.hpp"

namespace stickslip::studies {

namespace {

std::vector<double> event_times(const std::vector<solver::ContactEvent>& events) {
  std::vector<double> times;
  for (const auto& event : events)
    if (event.kind == solver::ContactEvent::Kind::onset || event.kind == solver::ContactEvent::Kind::capture)
      times.push_back(event.time);
  return times;
}

// The quasi-static shape of the system's own matrices, with the initial velocity of the base.
Eigen::VectorXd initial_velocity(const solver::ContactSystem& system) {
  const Eigen::Index c = system.contact;
  Eigen::MatrixXd held(system.stick_stiffness);
  Eigen::VectorXd right_side = -held.col(c);
  held.row(c).setZero();
  held.col(c).setZero();
  held(c, c) = right_side[c] = 1.0;
  return system.wall.velocity(0.0) * held.ldlt().solve(right_side);
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

TipRun tip_run(const solver::BeamModel& mesh, const solver::ContactSystem& system, const data::Case& problem,
               solver::InitialVelocity start, const RunEnd& end) {
  const auto& numerics = problem.numerics;
  const solver::PrescribedMotion base = solver::harmonic_motion(problem.excitation);
  solver::StickSlipIntegrator run(system, {.time_step = numerics.time_step(),
                                           .spectral_radius = numerics.spectral_radius(),
                                           .velocity_threshold = numerics.velocity_threshold()});
  const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(mesh.degrees_of_freedom());
  run.start_stuck(at_rest, start == solver::InitialVelocity::zero ? at_rest : initial_velocity(system));
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

TipRun tip_run(const solver::BeamModel& mesh, const solver::ContactSystem& system, const data::Case& problem,
               const FrictionRule& law, const RunEnd& end) {
  constexpr int substeps = 10;
  const double h = problem.numerics.time_step() / substeps;
  const Eigen::Index c = system.contact;
  const Eigen::MatrixXd mass(system.mass), damping(system.damping), stiffness(system.slip_stiffness);
  const Eigen::PartialPivLU<Eigen::MatrixXd> step_matrix(mass + 0.5 * h * damping + 0.25 * h * h * stiffness);
  const Eigen::MatrixXd from_velocity =
      step_matrix.solve(mass - 0.5 * h * damping - 0.25 * h * h * stiffness);
  const Eigen::MatrixXd from_displacement = -h * step_matrix.solve(stiffness);
  const Eigen::VectorXd from_load = h * step_matrix.solve(system.load_shape);
  const Eigen::VectorXd from_force =
      h * step_matrix.solve(Eigen::VectorXd::Unit(mesh.degrees_of_freedom(), c));
  const double limit = system.friction.static_coefficient() * system.normal_force;
  const double strength = from_force[c] * system.normal_force;

  Eigen::VectorXd q = Eigen::VectorXd::Zero(mesh.degrees_of_freedom());
  Eigen::VectorXd v = initial_velocity(system), free(q.size());
  const solver::PrescribedMotion base = solver::harmonic_motion(problem.excitation);
  TipRun result{.step = problem.numerics.time_step(), .tip_displacement = {0.0}, .friction_force = {0.0}};
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
