// SPDX-License-Identifier: MIT
#include "stickslip/solver/beam_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "stickslip/solver/base_motion.hpp"
#include "stickslip/solver/decompositions.hpp"
#include "stickslip/solver/held_tip_basis.hpp"
#include "stickslip/solver/modal_stick_run.hpp"
#include "stickslip/solver/model_system.hpp"

namespace stickslip::solver {

namespace {

// Σ_n 2 ζ ω_n (M φ_n) (M φ_n)ᵀ over all modes of the mesh, tip free and P = 0. With M = L Lᵀ this is
// 2 ζ L (Lᵀ K⁻¹ L)^(-1/2) Lᵀ. With the inverse of K the low modes lose nothing to round-off; the
// highest loses (ω_max/ω_1)² eps, 1e-3 at most_elements.
Eigen::MatrixXd modal_damping(const BeamModel& model, const data::Damping& damping) {
  constexpr int most_elements = 500;
  if (model.elements() > most_elements)
    throw data::FieldError(
        "numerics.elements", model.elements(),
        "at most " + std::to_string(most_elements) + " with a damping.ratio above 0, whose matrix is full");
  const Eigen::MatrixXd root = Eigen::MatrixXd(model.mass()).llt().matrixL();
  const Eigen::LLT<Eigen::MatrixXd> stiffness(Eigen::MatrixXd(model.elastic_stiffness()));
  const Eigen::MatrixXd half = stiffness.matrixL().solve(root);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(Eigen::MatrixXd(half.transpose() * half));
  // The eigenvalues ω^-2 ascend: the last one is that of mode 1.
  Eigen::VectorXd factors = 2.0 * modes.eigenvalues().cwiseSqrt().cwiseInverse();
  for (Eigen::Index n = 0; n < factors.size(); ++n)
    factors[n] *= damping.ratio_of(static_cast<std::size_t>(factors.size() - n));
  const Eigen::MatrixXd shapes = root * modes.eigenvectors();
  return shapes * factors.asDiagonal() * shapes.transpose();
}

}  // namespace

Coordinates fastest_coordinates(int elements, const data::Damping& damping, ContactScheme scheme) {
  const int most_modal_elements = damping.is_none() ? 200 : 100;
  return scheme == ContactScheme::paper || elements > most_modal_elements ? Coordinates::nodal
                                                                          : Coordinates::modal;
}

SparseMatrix damping_matrix(const BeamModel& model, const data::Damping& damping) {
  SparseMatrix matrix(model.degrees_of_freedom(), model.degrees_of_freedom());
  if (damping.kelvin_voigt() > 0.0) matrix = damping.kelvin_voigt() * model.elastic_stiffness();
  if (damping.mass_proportional() > 0.0) matrix += damping.mass_proportional() * model.mass();
  if (damping.has_ratio()) matrix += SparseMatrix(modal_damping(model, damping).sparseView());
  return matrix;
}

ContactSystem beam_contact_system(const BeamModel& model, const data::Case& problem) {
  return beam_contact_system(model, problem, base_motion(problem.motion));
}

ContactSystem beam_contact_system(const BeamModel& model, const data::Case& problem,
                                  const PrescribedMotion& base) {
  return {.mass = model.mass(),
          .damping = damping_matrix(model, problem.damping),
          .stick_stiffness = model.stick_stiffness(),
          .slip_stiffness = model.slip_stiffness(),
          .load_shape = -model.base_load(),
          .load_history = base.acceleration,
          .contact = model.tip_deflection(),
          .wall = wall_motion(problem, base),
          .normal_force = std::max(model.beam().axial_force(), 0.0),
          .friction = problem.contact.friction,
          .tangential = problem.contact.compliance};
}

ContactSystem contact_system(const data::Case& problem, const PrescribedMotion& base) {
  if (problem.model() != nullptr) return model_contact_system(problem, base);
  return beam_contact_system(BeamModel(problem.beam(), problem.numerics.elements()), problem, base);
}

namespace {

void require_contact(const data::Beam& beam, bool is_bonded) {
  if (is_bonded || beam.axial_force() > 0.0) return;
  throw data::FieldError("beam.axial_force", beam.axial_force(),
                         "positive (compression), or there is no contact");
}

ContactScheme scheme_of(const RunOptions& options) { return options.scheme.value_or(ContactScheme::located); }

Coordinates coordinates_of(const data::Case& problem, const RunOptions& options) {
  const ContactScheme scheme = scheme_of(options);
  if (problem.model() != nullptr) return Coordinates::nodal;
  if (!options.coordinates) return fastest_coordinates(problem.numerics.elements(), problem.damping, scheme);
  if (options.coordinates == Coordinates::nodal) return Coordinates::nodal;
  if (scheme == ContactScheme::paper)
    throw std::logic_error(
        "the scheme of the paper overwrites a nodal velocity: it has no modal coordinates");
  return Coordinates::modal;
}

// Whether a ModalStickRun, which takes no damping, has the stick state of a run.
bool has_modal_stick_run(const data::Case& problem, const RunOptions& options) {
  return problem.damping.is_none() && coordinates_of(problem, options) == Coordinates::modal;
}

IntegratorSettings integrator_settings(const data::NumericalSettings& numerics, ContactScheme scheme,
                                       Coordinates coordinates) {
  if (scheme == ContactScheme::paper && numerics.velocity_threshold() == 0.0)
    throw data::FieldError("numerics.velocity_threshold", "0",
                           "above 0 (m/s) with the scheme of the paper, or no slip ever ends");
  return {.time_step = numerics.time_step(),
          .spectral_radius = numerics.spectral_radius(),
          .velocity_threshold = numerics.velocity_threshold(),
          .scheme = scheme,
          .coordinates = coordinates};
}

// The rounding of the tip's position, eps times the base motion, changes the force of the spring. This must stay far
// below the limit of friction.
void require_resolved_spring(const data::TangentialContact& contact, double limit, double amplitude) {
  constexpr double share = 1e-4;
  const double stiffest = share * limit / (std::numeric_limits<double>::epsilon() * amplitude);
  if (!contact.has_spring() || limit == 0.0 || contact.tangential_stiffness() <= stiffest) return;
  throw data::FieldError(
      "contact.tangential_stiffness", contact.tangential_stiffness(),
      "at most " + data::shortest_text(stiffest) +
          " N/m by finite elements, whose rounding would move the force; inf for a rigid contact");
}

// Displacement and velocity of a system that has always been held, under a motion with that period: runs of a period follow each other until
// they end as they began, to 1e-3. The contact is at 0 then.
std::pair<Eigen::VectorXd, Eigen::VectorXd> held_start(ContactSystem system,
                                                       const IntegratorSettings& settings,
                                                       const Eigen::VectorXd& static_shape, double period) {
  constexpr double enough = 1e-3;
  constexpr int most_periods = 1000;
  const Eigen::Index c = system.contact;
  system.normal_force = bonding_force;
  system.tangential = data::TangentialContact();
  const long steps = step_count(period, settings.time_step);
  Eigen::VectorXd velocity = system.wall.velocity(0.0) * static_shape;
  Eigen::VectorXd displacement = Eigen::VectorXd::Zero(velocity.size());
  StickSlipIntegrator run(std::move(system), settings);
  for (int n = 0; n < most_periods; ++n) {
    run.start_stuck(displacement, velocity);
    for (long step = 0; step < steps; ++step) run.step();
    const Eigen::VectorXd before = std::exchange(velocity, run.velocity());
    displacement = run.displacement() - run.displacement()[c] * static_shape;
    if ((velocity - before).norm() <= enough * velocity.norm()) break;
  }
  return {displacement, velocity};
}

BeamModel checked_model(const data::Beam& beam, int elements, bool is_bonded) {
  require_contact(beam, is_bonded);
  BeamModel model(beam, elements);
  require_stable_stick_state(model);
  return model;
}

}  // namespace

BeamSimulation::BeamSimulation(const data::Case& problem, const RunOptions& options) {
  const PrescribedMotion motion = base_motion(problem.motion);
  if (!problem.is_force()) base_ = motion;
  const Coordinates coordinates = coordinates_of(problem, options);
  const IntegratorSettings settings = integrator_settings(problem.numerics, scheme_of(options), coordinates);
  std::optional<ModelMatrices> matrices;
  if (problem.model() != nullptr)
    matrices = model_matrices(*problem.model());
  else
    model_ = checked_model(problem.beam(), problem.numerics.elements(), options.is_bonded);
  ContactSystem system = matrices ? model_contact_system(problem, *matrices, motion)
                                  : beam_contact_system(*model_, problem, motion);
  const Eigen::VectorXd static_shape = matrices ? matrices->static_shape : model_->unit_tip_deflection();
  Eigen::VectorXd velocity = system.wall.velocity(0.0) * static_shape;
  // A structure that moves with the base has u_t = 0 but at the contact.
  if (options.starts_with_the_base)
    velocity = Eigen::VectorXd::Unit(velocity.size(), system.contact) * system.wall.velocity(0.0);
  if (coordinates == Coordinates::modal) {
    const HeldTipBasis basis = held_tip_basis(*model_);
    system = modal_contact_system(*model_, basis, std::move(system), problem.damping.mass_proportional());
    basis_ = basis.matrix();
    velocity = modal_coordinates(*model_, basis, velocity);
  }
  require_resolved_spring(problem.contact.compliance,
                          problem.contact.friction.static_coefficient() * system.normal_force,
                          largest_displacement(problem.motion));
  Eigen::VectorXd displacement = Eigen::VectorXd::Zero(velocity.size());
  if (!options.starts_with_the_base && problem.is_damped() && problem.is_random()) {
    const Eigen::VectorXd shape = coordinates == Coordinates::modal
                                      ? Eigen::VectorXd::Unit(velocity.size(), system.contact)
                                      : static_shape;
    std::tie(displacement, velocity) = held_start(system, settings, shape, problem.numerics.duration());
  }
  if (options.is_bonded) system.normal_force = bonding_force;
  integrator_ = std::make_unique<StickSlipIntegrator>(std::move(system), settings);
  if (model_) midspan_ = weights_at(0.5 * problem.beam().length());
  start(problem, std::move(displacement), std::move(velocity), options.is_bonded);
}

// At rest on the wall, or, one mass, where [initial] says.
void BeamSimulation::start(const data::Case& problem, Eigen::VectorXd displacement, Eigen::VectorXd velocity,
                           bool is_bonded) {
  const auto& [position, absolute] = problem.initial;
  const ContactSystem& system = integrator_->system();
  const double on_the_wall = system.wall.velocity(0.0) + base_.velocity(0.0);
  if (is_bonded || problem.initial == data::InitialState())
    return integrator_->start_stuck(displacement, velocity);
  displacement[system.contact] = position;
  velocity[system.contact] = absolute - base_.velocity(0.0);
  if (absolute == on_the_wall)
    integrator_->start_stuck(displacement, velocity);
  else
    integrator_->start_slipping(displacement, velocity);
}

Eigen::VectorXd BeamSimulation::on_coordinates(const Eigen::VectorXd& nodal) const {
  return basis_.size() > 0 ? basis_.transpose() * nodal : nodal;
}

Eigen::VectorXd BeamSimulation::weights_at(double x) const {
  return on_coordinates(model().interpolation(x));
}

double BeamSimulation::base_displacement() const { return base_.displacement(integrator_->time()); }

double BeamSimulation::displacement(double x) const { return displacement(weights_at(x)); }

double BeamSimulation::displacement(const Eigen::VectorXd& weights) const {
  return base_displacement() + weights.dot(integrator_->displacement());
}

double BeamSimulation::tip_displacement() const {
  return base_displacement() + integrator_->displacement()[integrator_->system().contact];
}

double BeamSimulation::tip_acceleration() const {
  return base_.acceleration(integrator_->time()) + integrator_->contact_acceleration();
}

double BeamSimulation::midspan_displacement() const {
  return model_ ? base_displacement() + midspan_.dot(integrator_->displacement()) : 0.0;
}

long step_count(double duration, double time_step) { return std::lround(duration / time_step); }

double max_abs_friction_force(const data::Case& problem, std::optional<Coordinates> coordinates) {
  const RunOptions options{.is_bonded = true, .coordinates = coordinates};
  const long steps = step_count(problem.numerics.duration(), problem.numerics.time_step());
  if (has_modal_stick_run(problem, options)) return ModalStickRun(problem).max_abs_friction_force(steps);
  BeamSimulation simulation(with(problem, data::FrictionLaw({}), data::TangentialContact(), data::Wall()),
                            options);
  double largest = std::abs(simulation.friction_force());
  for (long n = steps; n > 0; --n) {
    simulation.integrator().step();
    largest = std::max(largest, std::abs(simulation.friction_force()));
  }
  return largest;
}

std::optional<double> first_slip(const data::Case& problem, std::optional<Coordinates> coordinates) {
  const RunOptions options{.coordinates = coordinates};
  // The linear run, tens of times as fast, has the forces of these steps to rounding, far less than this margin.
  constexpr double margin = 1e-6;
  if (problem.contact.compliance.is_rigid() && problem.contact.wall.speed() == 0.0 &&
      has_modal_stick_run(problem, options) &&
      max_abs_friction_force(problem, Coordinates::modal) <
          (1.0 - margin) * problem.contact.friction.static_coefficient() * problem.normal_force())
    return std::nullopt;
  BeamSimulation simulation(problem, options);
  const auto& events = simulation.integrator().events();
  for (long n = step_count(problem.numerics.duration(), problem.numerics.time_step());
       n > 0 && events.empty(); --n)
    simulation.integrator().step();
  return events.empty() ? std::nullopt : std::optional(events.front().time);
}

}  // namespace stickslip::solver
