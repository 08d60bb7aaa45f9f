// SPDX-License-Identifier: MIT
#include "validation/forms.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/solver/stick_slip_integrator.hpp"

namespace stickslip::validation {

namespace {

constexpr int samples = 200, first_period = 20, last_period = 60;

// In the frame of the moving end of the spring: the wall moves at V, and the force of the spring is k u.
void add_sample(Record& record, const Slider& slider, double t, double displacement) {
  record.time.push_back(t);
  record.force.push_back(slider.stiffness * displacement / (slider.mass * slider.gravity));
}

data::FrictionLaw law_of(const FrictionForm& form) {
  return data::FrictionLaw({.static_coefficient = form.kinetic + form.excess,
                            .kinetic_coefficient = form.kinetic,
                            .decay = form.decay});
}

}  // namespace

Record event_driven_record(const Slider& slider, const FrictionForm& form) {
  analytic::ContactModel model;
  model.contact_mass = slider.moved_mass;
  model.contact_stiffness = slider.stiffness;
  model.load = {0.0};
  model.load_angular_frequency = slider.angular_frequency();
  model.wall_speed = slider.speed;
  model.normal_force = slider.mass * slider.gravity;
  model.friction = law_of(form);
  analytic::EventDriven run(model);
  run.start_stuck({}, {});
  Record record;
  const double period = 2.0 * std::numbers::pi / slider.angular_frequency();
  for (int i = first_period * samples; i <= last_period * samples; ++i) {
    const double t = period * i / samples;
    run.advance_to(t);
    add_sample(record, slider, t, run.contact_displacement());
  }
  return record;
}

Record time_stepped_record(const Slider& slider, const FrictionForm& form) {
  const auto scalar = [](double value) {
    solver::SparseMatrix matrix(1, 1);
    matrix.insert(0, 0) = value;
    return matrix;
  };
  const double speed = slider.speed, period = 2.0 * std::numbers::pi / slider.angular_frequency();
  constexpr int steps = 10;  // for each sample
  solver::StickSlipIntegrator run(
      {.mass = scalar(slider.moved_mass),
       .damping = scalar(0.0),
       .stick_stiffness = scalar(slider.stiffness),
       .slip_stiffness = scalar(slider.stiffness),
       .load_shape = Eigen::VectorXd::Zero(1),
       .load_history = [](double) { return 0.0; },
       .contact = 0,
       .wall = {[=](double t) { return speed * t; }, [=](double) { return speed; },
                [](double) { return 0.0; }},
       .normal_force = slider.mass * slider.gravity,
       .friction = law_of(form),
       .tangential = std::isinf(form.contact_stiffness)
                         ? data::TangentialContact()
                         : data::TangentialContact({.tangential_stiffness = form.contact_stiffness})},
      {.time_step = period / (samples * steps), .spectral_radius = 1.0});
  run.start_stuck(Eigen::VectorXd::Zero(1), Eigen::VectorXd::Constant(1, speed));
  Record record;
  for (int i = 0; i <= last_period * samples; ++i) {
    if (i >= first_period * samples) add_sample(record, slider, run.time(), run.displacement()[0]);
    for (int j = 0; j < steps; ++j) run.step();
  }
  return record;
}

double period_of(const Record& record) {
  double sum = 0.0;
  const auto cycles = cycles_of(record, 1e-3);
  for (const Cycle& cycle : cycles) sum += cycle.period;
  return cycles.empty() ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(cycles.size());
}

}  // namespace stickslip::validation
