#pragma once

#include <Eigen/Core>
#include <memory>

#include "stickslip/solver/stick_slip_integrator.hpp"

namespace stickslip::solver {

// A step of one length: its matrices, factorised when first used.
struct StickSlipIntegrator::StepOperator {
  double length{};
  std::unique_ptr<Cholesky> stick;
  std::unique_ptr<Lu> slip;
  Eigen::VectorXd mobility;  // acceleration of every degree of freedom per unit f_d in a slip step
};

}  // namespace stickslip::solver
