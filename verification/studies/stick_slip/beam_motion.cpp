// SPDX-License-Identifier: MIT
#include "studies/stick_slip/beam_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "stickslip/analytic/beam_boundary_integral.hpp"
#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/free_mode_run.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/convergence/convergence.hpp"
#include "studies/convergence/discretisation.hpp"
#include "studies/stick_slip/contact_histories.hpp"
#include "studies/stick_slip/converged_history.hpp"

namespace stickslip::studies {

namespace {

constexpr int closed_form_modes = 60;  // number of modes

void require(bool holds, const char* field, const std::string& value, const char* allowed) {
  if (!holds) throw data::FieldError(field, value, allowed);
}

void require_usable(const MotionGrid& grid, double time_step) {
  require(grid.start >= 0.0, "grid.start", data::shortest_text(grid.start), "at least 0 (s)");
  require(grid.snapshots >= 2, "grid.snapshots", std::to_string(grid.snapshots), "at least 2");
  require(grid.positions >= 2, "grid.positions", std::to_string(grid.positions), "at least 2");
  require(grid.snapshots - 1 <= std::floor(grid.length / time_step * (1.0 + 1e-12)), "grid.snapshots",
          std::to_string(grid.snapshots), "at most one per time step of the window");
}

// The number of whole time steps from 0 to each snapshot of a grid that positions() has accepted.
std::vector<long> snapshot_steps(const MotionGrid& grid, double time_step) {
  std::vector<long> steps;
  for (int i = 0; i < grid.snapshots; ++i)
    steps.push_back(std::lround((grid.start + grid.length * i / (grid.snapshots - 1)) / time_step));
  return steps;
}

std::vector<double> positions(const data::Case& problem, const MotionGrid& grid) {
  require_usable(grid, problem.numerics.time_step());
  std::vector<double> x;
  for (int i = 0; i < grid.positions; ++i) x.push_back(problem.beam.length() * i / (grid.positions - 1));
  return x;
}

double sinc(double angle) { return angle == 0.0 ? 1.0 : std::sin(angle) / angle; }

// g_n of Eq. (26): the solution of g'' + w^2 g = -sin(Omega t) from rest, in a form without 0/0 at resonance.
double modal_coordinate(double omega, double w, double t) {
  const double sum = omega + w;
  return (w * t * std::cos(0.5 * sum * t) * sinc(0.5 * (omega - w) * t) - std::sin(w * t)) / (sum * w);
}

// The motion by the free modes of the continuous beam with exact propagation (analytic::FreeModeRun), without damping.
BeamMotion free_mode_motion(const data::Case& problem, const MotionGrid& grid, int steps_per_time_step) {
  BeamMotion motion{positions(problem, grid), {}};
  const std::vector<long> snapshots = snapshot_steps(grid, problem.numerics.time_step());
  const analytic::TimeGrid steps{problem.numerics.time_step() / steps_per_time_step,
                                 static_cast<std::size_t>(snapshots.back() * steps_per_time_step)};
  const int modes = free_modes_for(problem.beam, steps.time_step);
  const auto shapes = analytic::slip_modes(problem.beam, modes);
  const analytic::StickResponse held(problem.beam, problem.excitation, closed_form_modes,
                                     analytic::SteadyPart::exact);
  const std::vector<double> holding_force =
      analytic::holding_force(problem.beam, problem.excitation, data::Damping(), steps);
  analytic::FreeModeRun run(analytic::free_modes(problem.beam, modes),
                            {problem.beam.axial_force(), problem.friction}, steps.time_step);
  analytic::ContactStep last;
  std::size_t done = 0;
  for (const long snapshot : snapshots) {
    const double t = static_cast<double>(snapshot) * problem.numerics.time_step();
    for (; done < static_cast<std::size_t>(snapshot * steps_per_time_step); ++done)
      last = run.step(holding_force[done]);
    motion.snapshots.push_back({.time = t,
                                .sticks = last.sliding_velocity == 0.0,
                                .friction_force = -last.friction_force,
                                .displacement = {}});
    for (const double x : motion.position) {
      double y = held.absolute_displacement(x, t);
      for (std::size_t k = 0; k < shapes.size(); ++k) y += shapes[k].shape(x) * run.amplitudes()[k];
      motion.snapshots.back().displacement.push_back(y);
    }
  }
  return motion;
}

}  // namespace

BeamMotion finite_element_motion(const data::Case& problem, const MotionGrid& grid) {
  BeamMotion motion{positions(problem, grid), {}};
  solver::BeamSimulation simulation(
      problem.beam, problem.friction, problem.excitation, problem.numerics,
      {.damping = problem.damping, .coordinates = solver::Coordinates::fastest, .wall = problem.wall});
  long done = 0;
  for (const long step : snapshot_steps(grid, problem.numerics.time_step())) {
    for (; done < step; ++done) simulation.step();
    motion.snapshots.push_back({.time = simulation.time(),
                                .sticks = simulation.state() == data::ContactState::stick,
                                .friction_force = simulation.friction_force(),
                                .displacement = {}});
    for (const double x : motion.position)
      motion.snapshots.back().displacement.push_back(simulation.displacement(x));
  }
  return motion;
}

BeamMotion event_driven_motion(const data::Case& problem, const MotionGrid& grid) {
  BeamMotion motion{positions(problem, grid), {}};
  const analytic::BeamContactModel beam(problem.beam, problem.friction, problem.excitation, problem.damping,
                                        problem.numerics.modes(), problem.wall);
  std::vector<std::vector<double>> shapes;
  for (const double x : motion.position) shapes.push_back(beam.shapes(x));
  analytic::EventDriven run(beam.model());
  for (const long step : snapshot_steps(grid, problem.numerics.time_step())) {
    const double t = static_cast<double>(step) * problem.numerics.time_step();
    run.advance_to(t);
    motion.snapshots.push_back({.time = t,
                                .sticks = run.state() == data::ContactState::stick,
                                .friction_force = -run.friction_force(),
                                .displacement = {}});
    for (const auto& shape : shapes)
      motion.snapshots.back().displacement.push_back(analytic::absolute_displacement(shape, run));
  }
  return motion;
}

BeamMotion closed_form_motion(const data::Case& problem, const MotionGrid& grid, int modes) {
  BeamMotion motion{positions(problem, grid), {}};
  const analytic::StickResponse response(problem.beam, problem.excitation, modes,
                                         analytic::SteadyPart::exact);
  for (const long step : snapshot_steps(grid, problem.numerics.time_step())) {
    const double t = static_cast<double>(step) * problem.numerics.time_step();
    motion.snapshots.push_back(
        {.time = t, .sticks = true, .friction_force = response.friction_force(t), .displacement = {}});
    for (const double x : motion.position)
      motion.snapshots.back().displacement.push_back(response.absolute_displacement(x, t));
  }
  return motion;
}

double peak(const BeamMotion& motion) {
  double largest = 0.0;
  for (const auto& snapshot : motion.snapshots)
    for (const double y : snapshot.displacement) largest = std::max(largest, std::abs(y));
  return largest;
}

double largest_difference(const BeamMotion& a, const BeamMotion& b, double until) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.snapshots.size() && a.snapshots[i].time <= until; ++i)
    for (std::size_t k = 0; k < a.position.size(); ++k)
      largest = largest_or_nan(
          {largest, std::abs(a.snapshots[i].displacement[k] - b.snapshots[i].displacement[k])});
  return largest;
}

double predicted_stick_difference(const data::Case& problem, const MotionGrid& grid, double until) {
  const double omega = angular_frequency(problem.excitation);
  const double step = problem.numerics.time_step();
  const analytic::StickResponse response(problem.beam, problem.excitation, closed_form_modes,
                                         analytic::SteadyPart::exact);
  std::vector<SteppedResponse> stepped;
  for (const auto& mode : response.modes())
    stepped.push_back(stepped_from_rest(problem.numerics.spectral_radius(),
                                        frequency_on_mesh(problem.beam, mode, problem.numerics.elements()),
                                        omega, step));
  const std::vector<double> position = positions(problem, grid);
  double largest = 0.0, largest_motion = 0.0;
  for (const long n : snapshot_steps(grid, step)) {
    const double t = static_cast<double>(n) * step;
    if (t > until) break;
    for (const double x : position) {
      double sum = 0.0;
      for (std::size_t k = 0; k < stepped.size(); ++k) {
        const auto& mode = response.modes()[k];
        sum +=
            std::abs(mode.shape(x) * omega * omega * mode.participation() *
                     (stepped[k].at(n, omega * step) - modal_coordinate(omega, mode.angular_frequency(), t)));
      }
      largest = std::max(largest, problem.excitation.amplitude() * sum);
      largest_motion = std::max(largest_motion, std::abs(response.absolute_displacement(x, t)));
    }
  }
  return largest + 0.25 * omega * omega * step * step * largest_motion;
}

BeamMotionStudy beam_motion_study(const data::Case& problem, int snapshots, int positions) {
  BeamMotionStudy study;
  study.frequency_hz = problem.excitation.frequency_hz();
  study.amplitude = problem.excitation.amplitude();
  study.first_slip =
      closed_form_first_slip(problem.beam, problem.friction, problem.excitation, problem.numerics.duration());
  const double period = 1.0 / study.frequency_hz;
  const double start = study.first_slip ? std::max(0.0, *study.first_slip - 0.25 * period) : 0.0;
  const MotionGrid grid{start, period, snapshots, positions};
  study.finite_element = finite_element_motion(problem, grid);
  constexpr int fine = 128, coarse = 64;  // steps per time step of the finite elements
  study.reference = study.first_slip ? free_mode_motion(problem, grid, fine)
                                     : closed_form_motion(problem, grid, closed_form_modes);
  constexpr double always = std::numeric_limits<double>::infinity();
  const double end_of_stick = study.first_slip.value_or(always);
  study.peak = peak(study.reference);
  if (study.first_slip)
    study.half_width =
        2.0 * largest_difference(study.reference, free_mode_motion(problem, grid, coarse), always);
  study.stick_difference = largest_difference(study.finite_element, study.reference, end_of_stick);
  study.predicted_stick_difference = predicted_stick_difference(problem, grid, end_of_stick);
  study.difference = largest_difference(study.finite_element, study.reference, always);
  return study;
}

}  // namespace stickslip::studies
