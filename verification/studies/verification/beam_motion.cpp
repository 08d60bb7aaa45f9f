// SPDX-License-Identifier: MIT
#include "studies/verification/beam_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "stickslip/analytic/stick_response.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/discretisation.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/method.hpp"
#include "studies/verification/contact_histories.hpp"

namespace stickslip::studies {

namespace {

constexpr int closed_form_modes = 60;  // number of modes

void require(bool holds, const char* field, const std::string& value, const char* allowed) {
  if (!holds) throw data::FieldError(field, value, allowed);
}

double sinc(double angle) { return angle == 0.0 ? 1.0 : std::sin(angle) / angle; }

// g_n of Eq. (26): the solution of g'' + w² g = -sin(Ω t) from rest, in a form without 0/0 at resonance.
double modal_coordinate(double omega, double w, double t) {
  const double sum = omega + w;
  return (w * t * std::cos(0.5 * sum * t) * sinc(0.5 * (omega - w) * t) - std::sin(w * t)) / (sum * w);
}

}  // namespace

Sampling snapshots_of(const data::Case& problem, double start, double length, int snapshots, int positions) {
  const double time_step = problem.numerics.time_step();
  require(start >= 0.0, "start", data::shortest_text(start), "at least 0 (s)");
  require(snapshots >= 2, "snapshots", std::to_string(snapshots), "at least 2");
  require(positions >= 2, "positions", std::to_string(positions), "at least 2");
  require(snapshots - 1 <= std::floor(length / time_step * (1.0 + 1e-12)), "snapshots",
          std::to_string(snapshots), "at most one per time step of the window");
  Sampling sampling;
  for (int i = 0; i < snapshots; ++i)
    sampling.times.push_back(std::round((start + length * i / (snapshots - 1)) / time_step) * time_step);
  for (int i = 0; i < positions; ++i)
    sampling.positions.push_back(problem.beam.length() * i / (positions - 1));
  return sampling;
}

double peak(const History& motion) {
  double largest = 0.0;
  for (const HistoryRow& row : motion.rows)
    for (const double y : row.displacement) largest = std::max(largest, std::abs(y));
  return largest;
}

double largest_difference(const History& a, const History& b, double until) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.rows.size() && a.rows[i].time <= until; ++i)
    largest = largest_or_nan({largest, largest_difference(a.rows[i].displacement, b.rows[i].displacement)});
  return largest;
}

double predicted_stick_difference(const data::Case& problem, const Sampling& snapshots, double until) {
  const double omega = angular_frequency(problem.excitation);
  const double step = problem.numerics.time_step();
  const analytic::StickResponse response(problem.beam, problem.excitation, closed_form_modes,
                                         analytic::SteadyPart::exact);
  std::vector<SteppedResponse> stepped;
  for (const auto& mode : response.modes())
    stepped.push_back(stepped_from_rest(problem.numerics.spectral_radius(),
                                        frequency_on_mesh(problem.beam, mode, problem.numerics.elements()),
                                        omega, step));
  double largest = 0.0, largest_motion = 0.0;
  for (const double t : snapshots.times) {
    if (t > until) break;
    for (const double x : snapshots.positions) {
      double sum = 0.0;
      for (std::size_t k = 0; k < stepped.size(); ++k) {
        const auto& mode = response.modes()[k];
        sum += std::abs(mode.shape(x) * omega * omega * mode.participation() *
                        (stepped[k].at(std::lround(t / step), omega * step) -
                         modal_coordinate(omega, mode.angular_frequency(), t)));
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
  const Sampling grid = snapshots_of(problem, start, period, snapshots, positions);
  study.position = grid.positions;
  study.finite_element = finite_element_history(problem, grid);
  constexpr int fine = 128, coarse = 64;  // steps per time step of the finite elements
  data::NumericalChoices choices = problem.numerics.choices();
  choices.modes = closed_form_modes;
  data::Case held = problem;
  held.numerics = data::NumericalSettings(choices);
  study.reference = study.first_slip ? free_mode_history(problem, grid, fine)
                                     : closed_form_history(held, grid, analytic::SteadyPart::exact);
  constexpr double always = std::numeric_limits<double>::infinity();
  const double end_of_stick = study.first_slip.value_or(always);
  study.peak = peak(study.reference);
  if (study.first_slip)
    study.half_width =
        2.0 * largest_difference(study.reference, free_mode_history(problem, grid, coarse), always);
  study.stick_difference = largest_difference(study.finite_element, study.reference, end_of_stick);
  study.predicted_stick_difference = predicted_stick_difference(problem, grid, end_of_stick);
  study.difference = largest_difference(study.finite_element, study.reference, always);
  return study;
}

}  // namespace stickslip::studies
