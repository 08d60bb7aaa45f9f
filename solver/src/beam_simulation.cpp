#include "stickslip/solver/beam_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace stickslip::solver {

PrescribedMotion harmonic_motion(const data::HarmonicExcitation& excitation) {
  const double amplitude = excitation.amplitude();
  const double omega = 2.0 * std::numbers::pi * excitation.frequency_hz();
  return {.displacement = [=](double t) { return amplitude * std::sin(omega * t); },
          .velocity = [=](double t) { return amplitude * omega * std::cos(omega * t); },
          .acceleration = [=](double t) { return -amplitude * omega * omega * std::sin(omega * t); }};
}

ContactSystem beam_contact_system(const BeamModel& model, const data::FrictionLaw& friction,
                                  const PrescribedMotion& base) {
  const Eigen::Index n = model.degrees_of_freedom();
  return {.mass = model.mass(),
          .damping = SparseMatrix(n, n),
          .stick_stiffness = model.stick_stiffness(),
          .slip_stiffness = model.slip_stiffness(),
          .load_shape = -model.base_load(),
          .load_history = base.acceleration,
          .contact = model.tip_deflection(),
          .wall = {.displacement = [base](double t) { return -base.displacement(t); },
                   .velocity = [base](double t) { return -base.velocity(t); },
                   .acceleration = [base](double t) { return -base.acceleration(t); }},
          .normal_force = std::max(model.beam().axial_force(), 0.0),
          .friction = friction};
}

namespace {

void require_contact(const data::Beam& beam, TipContact contact) {
  if (contact == TipContact::glued || beam.axial_force() > 0.0) return;
  std::ostringstream text;
  text << "beam.axial_force = " << beam.axial_force()
       << " N: must be positive (compression), or there is no contact";
  throw std::domain_error(text.str());
}

BeamModel checked_model(const data::Beam& beam, int elements, TipContact contact) {
  require_contact(beam, contact);
  BeamModel model(beam, elements);
  require_stable_stick_state(model);
  return model;
}

}  // namespace

BeamSimulation::BeamSimulation(const data::Beam& beam, const data::FrictionLaw& friction,
                               const data::HarmonicExcitation& excitation,
                               const data::NumericalSettings& numerics, const BeamRun& run)
    : model_(checked_model(beam, numerics.elements(), run.contact)),
      base_(harmonic_motion(excitation)),
      integrator_(beam_contact_system(model_, friction, base_),
                  {.time_step = numerics.time_step(),
                   .spectral_radius = numerics.spectral_radius(),
                   .velocity_threshold = numerics.velocity_threshold(),
                   .glued = run.contact == TipContact::glued}),
      midspan_(model_.interpolation(0.5 * beam.length())) {
  const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(model_.degrees_of_freedom());
  const Eigen::VectorXd shape = model_.unit_tip_deflection();
  const double tip_velocity = -base_.velocity(0.0);
  integrator_.start_stuck(at_rest,
                          run.initial_velocity == InitialVelocity::zero ? at_rest : tip_velocity * shape);
}

double BeamSimulation::base_displacement() const { return base_.displacement(time()); }

double BeamSimulation::displacement(double x) const {
  return base_displacement() + model_.interpolation(x).dot(integrator_.displacement());
}

double BeamSimulation::tip_displacement() const {
  return base_displacement() + integrator_.displacement()[model_.tip_deflection()];
}

double BeamSimulation::midspan_displacement() const {
  return base_displacement() + midspan_.dot(integrator_.displacement());
}

long step_count(double duration, double time_step) { return std::lround(duration / time_step); }

double max_abs_friction_force(const data::Beam& beam, const data::HarmonicExcitation& excitation,
                              const data::NumericalSettings& numerics) {
  const data::FrictionLaw unused({});
  BeamSimulation simulation(beam, unused, excitation, numerics, {.contact = TipContact::glued});
  double largest = std::abs(simulation.friction_force());
  for (long n = step_count(numerics.duration(), numerics.time_step()); n > 0; --n) {
    simulation.step();
    largest = std::max(largest, std::abs(simulation.friction_force()));
  }
  return largest;
}

std::optional<double> first_slip(const data::Beam& beam, const data::FrictionLaw& friction,
                                 const data::HarmonicExcitation& excitation,
                                 const data::NumericalSettings& numerics) {
  BeamSimulation simulation(beam, friction, excitation, numerics);
  const auto& events = simulation.integrator().events();
  for (long n = step_count(numerics.duration(), numerics.time_step()); n > 0 && events.empty(); --n)
    simulation.step();
  return events.empty() ? std::nullopt : std::optional(events.front().time);
}

}  // namespace stickslip::solver
