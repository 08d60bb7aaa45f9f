#include "stickslip/solver/held_tip_basis.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/modal_analysis.hpp"

namespace stickslip::solver {

namespace {

// x^T A x in extended precision: the stiffness of low modes is a small difference of large terms.
long double quadratic_form(const SparseMatrix& matrix, const Eigen::VectorXd& x) {
  long double sum = 0.0L;
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column)
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
      sum += static_cast<long double>(x[entry.row()]) * entry.value() * x[column];
  return sum;
}

void require_modal_form(const ContactSystem& system) {
  const Eigen::Index last = system.mass.rows() - 1;
  const auto couples_modes = [last](const SparseMatrix& matrix) {
    for (Eigen::Index column = 0; column < last; ++column)
      for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry)
        if (entry.row() != column && entry.row() != last && entry.value() != 0.0) return true;
    return false;
  };
  if (system.contact != last || system.damping.nonZeros() > 0 || couples_modes(system.mass) ||
      couples_modes(system.slip_stiffness))
    throw std::invalid_argument(
        "the system must be undamped, with modes that meet in its last coordinate alone, the contact");
}

}  // namespace

HeldTipBasis held_tip_basis(const BeamModel& model) {
  HeldTipBasis basis;
  basis.static_shape = model.unit_tip_deflection();
  const Eigen::Index count = model.degrees_of_freedom() - 1;
  basis.modes.resize(model.degrees_of_freedom(), count);
  basis.squared_frequencies.resize(count);
  if (count == 0) return basis;
  const std::vector<FiniteElementMode> modes = stick_modes(model, static_cast<int>(count));
  for (Eigen::Index n = 0; n < count; ++n) {
    const Eigen::VectorXd& shape = modes[static_cast<std::size_t>(n)].shape;
    basis.modes.col(n) = shape;
    basis.squared_frequencies[n] = static_cast<double>(quadratic_form(model.stick_stiffness(), shape) /
                                                       quadratic_form(model.mass(), shape));
  }
  return basis;
}

Eigen::VectorXd modal_coordinates(const BeamModel& model, const HeldTipBasis& basis,
                                  const Eigen::VectorXd& nodal) {
  const double tip = nodal[model.tip_deflection()];
  Eigen::VectorXd coordinates(nodal.size());
  coordinates << basis.modes.transpose() * (model.mass() * (nodal - tip * basis.static_shape)), tip;
  return coordinates;
}

ContactSystem modal_contact_system(const BeamModel& model, const HeldTipBasis& basis,
                                   const data::FrictionLaw& friction, const PrescribedMotion& base) {
  const ContactSystem full = beam_contact_system(model, friction, base);
  const Eigen::Index modes = basis.modes.cols(), tip = modes;
  const Eigen::VectorXd &sigma = basis.static_shape, inertia = model.mass() * sigma;
  const Eigen::VectorXd coupling = basis.modes.transpose() * inertia;
  const Eigen::VectorXd rotations = basis.modes.row(model.tip_rotation()).transpose();
  const double axial_force = model.beam().axial_force();

  SparseMatrix mass(modes + 1, modes + 1), stick(modes + 1, modes + 1), slip(modes + 1, modes + 1);
  for (Eigen::Index n = 0; n < modes; ++n) {
    mass.insert(n, n) = 1.0;
    mass.insert(tip, n) = mass.insert(n, tip) = coupling[n];
    stick.insert(n, n) = slip.insert(n, n) = basis.squared_frequencies[n];
    slip.insert(tip, n) = axial_force * rotations[n];
  }
  mass.insert(tip, tip) = sigma.dot(inertia);
  stick.insert(tip, tip) = sigma.dot(model.stick_stiffness() * sigma);
  slip.insert(tip, tip) = stick.coeff(tip, tip) + axial_force * sigma[model.tip_rotation()];
  for (SparseMatrix* matrix : {&mass, &stick, &slip}) matrix->makeCompressed();

  ContactSystem system = full;
  system.mass = mass;
  system.damping = SparseMatrix(modes + 1, modes + 1);
  system.stick_stiffness = stick;
  system.slip_stiffness = slip;
  system.load_shape.resize(modes + 1);
  system.load_shape << basis.modes.transpose() * full.load_shape, sigma.dot(full.load_shape);
  system.contact = tip;
  return system;
}

ModalStickSlipIntegrator::ModalStickSlipIntegrator(ContactSystem system, const IntegratorSettings& settings)
    : StickSlipIntegrator(std::move(system), settings), modes_(this->system().mass.rows() - 1) {
  const ContactSystem& s = this->system();
  require_modal_form(s);
  const Eigen::Index c = s.contact;
  stiffness_ = Eigen::VectorXd(s.stick_stiffness.diagonal()).head(modes_).array();
  coupling_ = Eigen::VectorXd(s.mass.col(c)).head(modes_).array();
  follower_row_ = Eigen::VectorXd(SparseMatrix(s.slip_stiffness.transpose()).col(c)).head(modes_).array();
  load_ = s.load_shape.head(modes_).array();
  contact_mass_entry_ = s.mass.coeff(c, c);
  contact_stiffness_ = s.slip_stiffness.coeff(c, c);
  contact_load_ = s.load_shape[c];
  prepare(full_step_, settings.time_step);
}

void ModalStickSlipIntegrator::prepare(Step& step, double length) const {
  const double mass = method().mass_factor(), stiffness = method().stiffness_factor(length);
  step.length = length;
  step.inverse_diagonal = 1.0 / (mass + stiffness * stiffness_);
  step.contact_row = (mass * coupling_ + stiffness * follower_row_) * step.inverse_diagonal;
  step.contact_acceleration = 1.0 / (mass * contact_mass_entry_ + stiffness * contact_stiffness_ -
                                     mass * (step.contact_row * coupling_).sum());
}

const ModalStickSlipIntegrator::Step& ModalStickSlipIntegrator::step_of(double length) {
  // The end of a step is n h and not a sum, so that a whole step's length is h only up to round-off.
  if (std::abs(length - full_step_.length) <= 1e-9 * full_step_.length) return full_step_;
  if (partial_step_.length != length) prepare(partial_step_, length);
  return partial_step_;
}

const Kinematics& ModalStickSlipIntegrator::trial(double end_time) {
  const Step& step = step_of(end_time - time());
  if (state() == ContactState::stick)
    stick_step(step, end_time);
  else
    slip_step(step);
  return trial_;
}

// The contact moves with the wall; each mode follows under the load and the inertia of that motion.
void ModalStickSlipIntegrator::stick_step(const Step& step, double end_time) {
  const double h = step.length, share = 1.0 - method().alpha_f(), beta = method().beta(),
               gamma = method().gamma();
  const double load_time = method().load_time(time(), h);
  const double load = system().load_history(load_time), wall = system().wall.acceleration(load_time);
  const auto q = now_.displacement.head(modes_).array(), v = now_.velocity.head(modes_).array(),
             a = now_.acceleration.head(modes_).array();
  auto new_a = trial_.acceleration.head(modes_).array();
  new_a = (load * load_ - wall * coupling_ - method().alpha_m() * a -
           stiffness_ * (q + (share * h) * v + (share * h * h * (0.5 - beta)) * a)) *
          step.inverse_diagonal;
  trial_.displacement.head(modes_).array() = q + h * v + (h * h * (0.5 - beta)) * a + (h * h * beta) * new_a;
  trial_.velocity.head(modes_).array() = v + (h * (1.0 - gamma)) * a + (h * gamma) * new_a;
  trial_.displacement[modes_] = wall_offset() + system().wall.displacement(end_time);
  trial_.velocity[modes_] = system().wall.velocity(end_time);
  trial_.acceleration[modes_] = system().wall.acceleration(end_time);
}

// The modes with the contact's acceleration eliminated, then that from its own row, friction included.
void ModalStickSlipIntegrator::slip_step(const Step& step) {
  const double h = step.length, share = 1.0 - method().alpha_f(), beta = method().beta(),
               gamma = method().gamma();
  const double load_time = method().load_time(time(), h), load = system().load_history(load_time);
  const auto q = now_.displacement.head(modes_).array(), v = now_.velocity.head(modes_).array(),
             a = now_.acceleration.head(modes_).array();
  const double qc = now_.displacement[modes_], vc = now_.velocity[modes_], ac = now_.acceleration[modes_];
  const double alpha_ac = method().alpha_m() * ac;
  const double alpha_qc = qc + (share * h) * vc + (share * h * h * (0.5 - beta)) * ac;

  alpha_displacement_ = q + (share * h) * v + (share * h * h * (0.5 - beta)) * a;
  residual_ = load * load_ - method().alpha_m() * a - alpha_ac * coupling_ - stiffness_ * alpha_displacement_;
  const double contact_residual = load * contact_load_ - method().alpha_m() * (coupling_ * a).sum() -
                                  alpha_ac * contact_mass_entry_ - contact_stiffness_ * alpha_qc -
                                  (follower_row_ * alpha_displacement_).sum() -
                                  (step.contact_row * residual_).sum();
  const double free_acceleration = contact_residual * step.contact_acceleration;
  const double velocity_factor = method().damping_factor(h);
  const double free_velocity = vc + (share * h * (1.0 - gamma)) * ac + velocity_factor * free_acceleration -
                               system().wall.velocity(load_time);
  const double friction = alpha_level_friction(free_velocity, velocity_factor * step.contact_acceleration);
  const double new_ac = free_acceleration + friction * step.contact_acceleration;

  auto new_a = trial_.acceleration.head(modes_).array();
  new_a = (residual_ - (method().mass_factor() * new_ac) * coupling_) * step.inverse_diagonal;
  trial_.acceleration[modes_] = new_ac;
  trial_.displacement = now_.displacement + h * now_.velocity + (h * h * (0.5 - beta)) * now_.acceleration +
                        (h * h * beta) * trial_.acceleration;
  trial_.velocity =
      now_.velocity + (h * (1.0 - gamma)) * now_.acceleration + (h * gamma) * trial_.acceleration;
}

}  // namespace stickslip::solver
