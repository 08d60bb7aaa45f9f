// SPDX-License-Identifier: MIT
#include "stickslip/solver/modal_stick_run.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

namespace stickslip::solver {

namespace {

constexpr Eigen::Index block_steps = 64;
constexpr Eigen::Index blocks_at_a_time = 64;  // whose states fit into the cache

}  // namespace

ModalStickRun::ModalStickRun(const data::Case& problem, const RunOptions& options)
    : model_(problem.beam(), problem.numerics.elements()),
      method_(problem.numerics.spectral_radius()),
      h_(problem.numerics.time_step()),
      base_(shifted_motion(problem.motion)),
      basis_(held_tip_basis(model_)) {
  const Eigen::Index count = basis_.modes.cols();
  const Eigen::VectorXd& sigma = basis_.static_shape;
  stiffness_ = (h_ * h_) * basis_.squared_frequencies.array();
  const double share = 1.0 - method_.alpha_f();
  inverse_factor_ = 1.0 / (1.0 - method_.alpha_m() + share * method_.beta() * stiffness_);
  load_ = (h_ * h_) * (basis_.modes.transpose() * (model_.mass() * sigma - model_.base_load())).array();

  // η = 0, and the acceleration with which the method starts (StickSlipIntegrator, "Restart").
  const PrescribedMotion base = base_motion(problem.motion);
  start_ = Modes::Zero(count, 3);
  start_.col(2) = (base.acceleration(0.0) * (1.0 - method_.alpha_m())) * load_ * inverse_factor_;
  if (options.starts_with_the_base) {
    const Eigen::VectorXd tip_alone =
        Eigen::VectorXd::Unit(model_.degrees_of_freedom(), model_.tip_deflection());
    start_.col(1) =
        (-h_ * base.velocity(0.0)) * modal_coordinates(model_, basis_, tip_alone).head(count).array();
  }

  // f = -f_d, f_d = [M q_tt + K_slip q + b h_tt]_w with q_tt eliminated by the other rows: the accelerations
  // of the modes by their own equations, that of the tip is the wall's.
  const Eigen::Index tip = model_.tip_deflection();
  const Eigen::VectorXd mass_row = model_.mass().col(tip);
  const Eigen::VectorXd stiffness_row = SparseMatrix(model_.slip_stiffness().transpose()).col(tip);
  const Eigen::ArrayXd inertia = (basis_.modes.transpose() * mass_row).array();
  force_.modal =
      (inertia * basis_.squared_frequencies.array()).matrix() - basis_.modes.transpose() * stiffness_row;
  force_.of_base = stiffness_row.dot(sigma);
  force_.of_acceleration =
      mass_row.dot(sigma) - model_.base_load()[tip] - (inertia * load_).sum() / (h_ * h_);
}

// One step of all modes under h_tt(t_star) = load.
ModalStickRun::Modes ModalStickRun::stepped(const Modes& state, double load) const {
  const double share = 1.0 - method_.alpha_f(), beta = method_.beta(), gamma = method_.gamma();
  const auto x1 = state.col(0), x2 = state.col(1), x3 = state.col(2);
  Modes next(state.rows(), 3);
  next.col(2) =
      (load * load_ - method_.alpha_m() * x3 - stiffness_ * (x1 + share * x2 + (share * (0.5 - beta)) * x3)) *
      inverse_factor_;
  next.col(1) = x2 + (1.0 - gamma) * x3 + gamma * next.col(2);
  next.col(0) = x1 + x2 + (0.5 - beta) * x3 + beta * next.col(2);
  return next;
}

// T^B and the outputs of a block, as factors of y = (x_1, x_2, x_3, w_k(t)) at its start.
struct ModalStickRun::Block {
  std::array<Modes, 3> of_state;
  std::vector<Modes> of_load;
  Eigen::MatrixXd outputs;
};

// Every mode steps alike, so that one step with x_1 = 1 (or x_2, or x_3) in all of them finds a column of all
// their recurrences at once.
ModalStickRun::Block ModalStickRun::block_of(const Output& output) const {
  const Eigen::Index modes = basis_.modes.cols();
  Block block;
  block.outputs.resize(block_steps, 3 * modes + static_cast<Eigen::Index>(base_.size()));
  for (int part = 0; part < 3; ++part) {
    Modes state = Modes::Zero(modes, 3);
    state.col(part).setOnes();
    for (Eigen::Index j = 0; j < block_steps; ++j) {
      block.outputs.row(j).segment(part * modes, modes) =
          output.modal.transpose().array() * state.col(0).transpose();
      state = stepped(state, 0.0);
    }
    block.of_state[static_cast<std::size_t>(part)] = state;
  }
  for (Eigen::Index column = 3 * modes; const auto& [weight, motion] : base_) {
    Modes state = Modes::Zero(modes, 3);
    for (Eigen::Index j = 0; j < block_steps; ++j) {
      const double t = static_cast<double>(j) * h_;
      block.outputs(j, column) = output.modal.dot(state.col(0).matrix()) +
                                 output.of_base * motion.displacement(t) +
                                 output.of_acceleration * motion.acceleration(t);
      state = stepped(state, motion.acceleration(method_.load_time(t, h_)));
    }
    block.of_load.push_back(state);
    ++column;
  }
  return block;
}

// Calls sink with the outputs at t_0 ... t_steps, some at a time.
template <class Sink>
void ModalStickRun::march(const Output& output, long steps, Sink&& sink) const {
  const Eigen::Index modes = basis_.modes.cols();
  const Block block = block_of(output);
  Modes state = start_;
  Eigen::MatrixXd starts(block.outputs.cols(), blocks_at_a_time), outputs(block_steps, blocks_at_a_time);
  Eigen::Index left = steps + 1;
  for (long first = 0; left > 0;) {
    for (Eigen::Index b = 0; b < blocks_at_a_time; ++b, first += block_steps) {
      starts.col(b).head(3 * modes) = state.matrix().reshaped();
      Modes next = Modes::Zero(modes, 3);
      for (std::size_t k = 0; k < base_.size(); ++k) {
        const double weight = base_[k].weight(static_cast<double>(first) * h_);
        starts(3 * modes + static_cast<Eigen::Index>(k), b) = weight;
        next += weight * block.of_load[k];
      }
      for (int part = 0; part < 3; ++part)
        next += block.of_state[static_cast<std::size_t>(part)].colwise() * state.col(part);
      state.swap(next);
    }
    outputs.noalias() = block.outputs * starts;
    const Eigen::Index count = std::min(left, outputs.size());
    sink(outputs.reshaped().head(count));
    left -= count;
  }
}

std::vector<double> ModalStickRun::history(const Output& output, long steps) const {
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(steps) + 1);
  march(output, steps, [&](const auto& some) { values.insert(values.end(), some.begin(), some.end()); });
  return values;
}

std::vector<double> ModalStickRun::friction_force(long steps) const { return history(force_, steps); }

std::vector<double> ModalStickRun::relative_displacement(double x, long steps) const {
  const Eigen::VectorXd weights = model_.interpolation(x);
  return history({.modal = basis_.modes.transpose() * weights, .of_base = -weights.dot(basis_.static_shape)},
                 steps);
}

double ModalStickRun::max_abs_friction_force(long steps) const {
  double largest = 0.0;
  march(force_, steps, [&](const auto& some) { largest = std::max(largest, some.cwiseAbs().maxCoeff()); });
  return largest;
}

}  // namespace stickslip::solver
