// SPDX-License-Identifier: MIT
// The time stepper of this project: generalised-alpha, changes of the contact located inside the step. The spring is part of the system.
#include "engine.hpp"

#include "stickslip/solver/stick_slip_integrator.hpp"

namespace solver = stickslip::solver;

class StickSlip {
 public:
  StickSlip(const Problem& problem, double step)
      : run_(system(problem), {.time_step = step, .spectral_radius = 0.9}) {
    const Eigen::VectorXd position = Eigen::VectorXd::Constant(1, problem.position),
                          velocity = Eigen::VectorXd::Constant(1, problem.velocity);
    problem.velocity == 0.0 ? run_.start_stuck(position, velocity) : run_.start_slipping(position, velocity);
  }
  void push(double /*force*/) {}
  void advance() { run_.step(); }
  double position() const { return run_.displacement()[0]; }
  double velocity() const { return run_.velocity()[0]; }

 private:
  static solver::SparseMatrix scalar(double value) {
    return Eigen::MatrixXd::Constant(1, 1, value).sparseView(1.0, 0.0);
  }
  static solver::ContactSystem system(const Problem& problem) {
    const auto none = [](double /*time*/) { return 0.0; };
    return {.mass = scalar(problem.mass),
            .damping = scalar(0.0),
            .stick_stiffness = scalar(problem.stiffness),
            .slip_stiffness = scalar(problem.stiffness),
            .load_shape = Eigen::VectorXd::Constant(1, 1.0),
            .load_history =
                [problem](double time) { return problem.mass * problem.along() + problem.force(time, 0.0); },
            .wall = {none, none, none},
            .normal_force = problem.mass * problem.down(),
            .friction = stickslip::data::FrictionLaw(
                {.static_coefficient = problem.friction, .kinetic_coefficient = problem.friction})};
  }
  solver::StickSlipIntegrator run_;
};

int main(int argc, char** argv) { return run<StickSlip>(argc, argv, 0.001); }
