// SPDX-License-Identifier: MIT
#include "stickslip/analytic/beam_boundary_integral.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "arguments.hpp"
#include "beam_constants.hpp"
#include "gsl_handles.hpp"
#include "special_functions.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/held_beam.hpp"
#include "stickslip/analytic/held_motion.hpp"
#include "stickslip/analytic/stick_propagator.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/analytic/tip_mobility.hpp"

namespace stickslip::analytic {
namespace {

constexpr int undamped_modes = 200, damped_modes = 40;
constexpr std::size_t most_steps = std::size_t{1} << 26;

void require_usable(const data::Damping& damping, const TimeGrid& grid) {
  require_kelvin_voigt(damping);
  require_positive("time_step", grid.time_step);
  if (grid.steps < 1 || grid.steps > most_steps)
    throw data::FieldError("steps", static_cast<double>(grid.steps), "1 ... " + std::to_string(most_steps));
}

/// The contact held by more friction than any case has.
ContactModel bonded(ContactModel model) {
  model.normal_force = 1e18;
  model.friction = data::FrictionLaw({.static_coefficient = 1.0, .kinetic_coefficient = 0.0, .decay = 0.0});
  return model;
}

/// Adds amplitude sin(ω t), its mean over each step, to the values. The phase is turned from step to step
/// and set anew often enough to stay at round-off.
void add_sinusoid(double amplitude, double omega, double h, std::vector<double>& values) {
  constexpr std::size_t block = 1024;
  const double mean = amplitude * sinc(0.5 * omega * h);
  const double turn_cos = std::cos(omega * h), turn_sin = std::sin(omega * h);
  for (std::size_t first = 0; first < values.size(); first += block) {
    const double phase = omega * (static_cast<double>(first) + 0.5) * h;
    double sine = mean * std::sin(phase), cosine = mean * std::cos(phase);
    for (std::size_t n = first; n < std::min(first + block, values.size()); ++n) {
      values[n] += sine;
      const double next = sine * turn_cos + cosine * turn_sin;
      cosine = cosine * turn_cos - sine * turn_sin;
      sine = next;
    }
  }
}

/// f_h = -A0 [s sin(Ω t) + sum c_n φ_n(t)] with the two sinusoids of φ_n apart, but for a mode so near to Ω
/// that they cancel. Its φ_n is taken in the middle of the step.
std::vector<double> undamped_holding_force(const data::Beam& beam, const data::HarmonicExcitation& excitation,
                                           const TimeGrid& grid) {
  const StickResponse response(beam, excitation, undamped_modes, SteadyPart::exact);
  const ModalReaction reaction = response.reaction();
  const double omega = 2.0 * std::numbers::pi * excitation.frequency_hz(), h = grid.time_step;
  std::vector<double> values(grid.steps);
  double at_omega = reaction.quasi_static;
  for (const auto& [natural, coefficient] : reaction.modes) {
    const double difference = omega - natural, share = coefficient * omega / (difference * (omega + natural));
    if (std::abs(difference) < 1e-3 * omega) {
      for (std::size_t n = 0; n < values.size(); ++n) {
        const double t = (static_cast<double>(n) + 0.5) * h;
        const double phi = omega * omega * modal_coordinate(omega, natural, t, std::sin(omega * t));
        values[n] -= excitation.amplitude() * coefficient * phi;
      }
      continue;
    }
    at_omega += share * omega;
    add_sinusoid(excitation.amplitude() * share * omega * omega / natural, natural, h, values);
  }
  add_sinusoid(-excitation.amplitude() * at_omega, omega, h, values);
  return values;
}

/// In the middle of each step, by a cubic spline through instants that are H = 1e-3/ω_1 apart or, if that is longer,
/// a step. A free vibration ω_n is off by (ω_n H)⁴/384 at most. As its amplitude falls as ω_n⁻², that is
/// 1e-7 of the force where ω_n H is about 4, and less elsewhere.
/// The spline has no curvature at its ends. That leaves 0.046 H² |f''| there, and 0.27 times as much in each interval
/// from there.
std::vector<double> damped_holding_force(const data::Beam& beam, const data::HarmonicExcitation& excitation,
                                         const data::Damping& damping, const TimeGrid& grid) {
  const StatusInsteadOfAbort guard;
  const ContactModel model =
      bonded(contact_model(HeldBeam(beam, damping, damped_modes).structure(), excitation));
  const ContactDynamics dynamics(model);
  StickPropagator held(dynamics);
  held.begin(0.0, {std::vector<double>(dynamics.modes()), std::vector<double>(dynamics.modes())});
  const double duration = static_cast<double>(grid.steps) * grid.time_step;
  const double spacing = std::max(grid.time_step, 1e-3 / model.angular_frequency.front());
  std::vector<double> time, force;
  for (std::size_t n = 0; time.size() < 4 || time.back() < duration; ++n) {
    time.push_back(static_cast<double>(n) * spacing);
    force.push_back(held.force(time.back()));
  }
  const auto spline = owned(gsl_spline_alloc(gsl_interp_cspline, time.size()));
  require_success(gsl_spline_init(spline.get(), time.data(), force.data(), time.size()), "holding force");
  std::vector<double> values(grid.steps);
  for (std::size_t n = 0; n < values.size(); ++n)
    values[n] = gsl_spline_eval(spline.get(), (static_cast<double>(n) + 0.5) * grid.time_step, nullptr);
  return values;
}

/// y(x, t_n) of the beam in these modes with its contact held.
std::vector<double> bonded_displacement(const HeldBeam& beam, ContactModel model, const TimeGrid& grid,
                                        double x, std::size_t every) {
  const std::vector<double> shapes = beam.shapes(x);
  EventDriven run(bonded(std::move(model)));
  std::vector<double> values;
  for (std::size_t n = 0; n <= grid.steps; n += every) {
    run.advance_to(static_cast<double>(n) * grid.time_step);
    values.push_back(absolute_displacement(shapes, run));
  }
  return values;
}

HeldBeam beam_under_motion(const data::Case& problem) {
  return {problem.beam(), problem.damping, problem.is_damped() ? damped_modes : undamped_modes};
}

}  // namespace

std::vector<double> holding_force(const ContactModel& model, const TimeGrid& grid) {
  HeldMotion motion(model);
  std::vector<double> values(grid.steps);
  for (std::size_t n = 0; n < values.size(); ++n)
    values[n] = motion.force((static_cast<double>(n) + 0.5) * grid.time_step);
  return values;
}

std::vector<double> holding_force(const data::Beam& beam, const data::HarmonicExcitation& excitation,
                                  const data::Damping& damping, const TimeGrid& grid) {
  require_usable(damping, grid);
  if (damping.kelvin_voigt() == 0.0) return undamped_holding_force(beam, excitation, grid);
  return damped_holding_force(beam, excitation, damping, grid);
}

std::vector<double> held_displacement(const data::Beam& beam, const data::HarmonicExcitation& excitation,
                                      const data::Damping& damping, const TimeGrid& grid, double x,
                                      std::size_t every) {
  require_usable(damping, grid);
  std::vector<double> values;
  const auto sample = [&](const auto& displacement) {
    for (std::size_t n = 0; n <= grid.steps; n += every)
      values.push_back(displacement(static_cast<double>(n) * grid.time_step));
  };
  if (damping.kelvin_voigt() == 0.0) {
    const StickResponse response(beam, excitation, undamped_modes, SteadyPart::exact);
    sample(response.absolute_displacement(x));
  } else {
    const HeldBeam held(beam, damping, damped_modes);
    return bonded_displacement(held, contact_model(held.structure(), excitation), grid, x, every);
  }
  return values;
}

BeamBoundaryIntegral::BeamBoundaryIntegral(const data::Case& problem, const TimeGrid& grid, int stages)
    : problem_(problem), grid_(grid), stages_(stages) {
  const data::Beam& beam = problem.beam();
  require_compression(beam);
  const ContactLaw law{beam.axial_force(), problem.contact.friction, problem.contact.compliance,
                       grid.time_step};
  require_unique_step(law, 0.0);  // what is refused without the weights, which take long
  const TipMobility mobility(beam, problem.damping);
  if (problem.has(data::Feature::general_motion)) {
    require_usable(problem.damping, grid);
    holding_force_ = holding_force(contact_model(beam_under_motion(problem).structure(), problem), grid);
  } else {
    holding_force_ = holding_force(beam, problem.excitation(), problem.damping, grid);
  }
  steps_ = contact_steps(mobility_weights(mobility, grid.time_step, grid.steps, stages), law, holding_force_);
}

std::vector<double> BeamBoundaryIntegral::tip_displacement(std::size_t every) const {
  return contact_positions(steps_, grid_.time_step, every);
}

std::vector<double> BeamBoundaryIntegral::displacement(double x, std::size_t every) const {
  const TipMobility mobility(problem_.beam(), problem_.damping);
  const auto transfer = [&](std::complex<double> s) { return mobility.transfer(x, s); };
  std::vector<double> force;
  force.reserve(steps_.size());
  for (std::size_t n = 0; n < steps_.size(); ++n)
    force.push_back(steps_[n].friction_force - holding_force_[n]);
  const std::vector<double> velocity =
      convolution(mobility_weights(transfer, grid_.time_step, grid_.steps, stages_), force);
  std::vector<double> values;
  if (problem_.has(data::Feature::general_motion)) {
    const HeldBeam held = beam_under_motion(problem_);
    values = bonded_displacement(held, contact_model(held.structure(), problem_), grid_, x, every);
  } else {
    values = held_displacement(problem_.beam(), problem_.excitation(), problem_.damping, grid_, x, every);
  }
  double position = 0.0;
  for (std::size_t n = 1; n <= velocity.size(); ++n) {
    position += grid_.time_step * velocity[n - 1];
    if (n % every == 0) values[n / every] += position;
  }
  return values;
}

}  // namespace stickslip::analytic
