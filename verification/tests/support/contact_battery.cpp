// SPDX-License-Identifier: MIT
#include "support/contact_battery.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/parameter_name.hpp"

namespace stickslip::testing {
namespace {

using data::ContactChange;
using data::ContactState;
using std::numbers::pi;

/// v = v_0 - a t with a = mu N/m = 1.5 m/s^2: stops at t = v_0/a after v_0^2/(2 a).
ContactProblem coulomb_slider(double side) {
  ContactProblem problem{
      .name = "Slider" + parameter_name(side), .kind = ContactProblemKind::slider, .mass = sliding_mass};
  problem.start = ContactState::slip;
  problem.position = 0.25;
  problem.velocity = 1.3 * side;
  problem.sample_times = {0.0, 0.42, 2.1};
  const double stop = 0.25 + side * 1.3 * 1.3 / 3.0;
  problem.exact.events = {{ContactChange::capture, 1.3 / 1.5, stop}};
  problem.exact.samples = {
      {ContactState::slip, 0.25, 1.3 * side, -3.0 * side},
      {ContactState::slip, 0.25 + side * (1.3 - 0.75 * 0.42) * 0.42, side * (1.3 - 1.5 * 0.42), -3.0 * side},
      {ContactState::stick, stop, 0.0, 0.0}};
  problem.rates = {1.5};
  return problem;
}

/// m = 1 kg, k = 2 N/m, mu N = 1 N: holds up to 0.5 m, that included; beyond, slips at once from u_0 as
/// u = s/2 + (u_0 - s/2) cos(sqrt(2) t), s the sign of u_0.
ContactProblem loaded_spring(double position) {
  ContactProblem problem{.name = "Spring" + parameter_name(position), .kind = ContactProblemKind::spring};
  problem.mass = {.stiffness = 2.0, .normal_force = 10.0, .friction = coulomb};
  problem.position = position;
  problem.sample_times = {0.0, 0.1};
  if (std::abs(position) <= 0.5) {
    problem.exact.samples.assign(2, {ContactState::stick, position, 0.0, 2.0 * position});
    return problem;
  }
  const double side = std::copysign(1.0, position), omega = std::numbers::sqrt2;
  problem.exact.events = {{ContactChange::onset, 0.0, position}};
  for (const double t : problem.sample_times)
    problem.exact.samples.push_back({ContactState::slip,
                                     0.5 * side + (position - 0.5 * side) * std::cos(omega * t),
                                     -omega * (position - 0.5 * side) * std::sin(omega * t), side});
  problem.rates = {0.0};
  return problem;
}

/// m = 1 kg, k = 4 N/m, mu N/k = 0.1 m: each half cycle of pi/2 s takes twice this dead zone off the amplitude. Turning points
/// -0.84, 0.64, -0.44, 0.24 and -0.04 m; the last lies within the dead zone and sticks.
ContactProblem coulomb_oscillator(double side) {
  ContactProblem problem{.name = "Oscillator" + parameter_name(side),
                         .kind = ContactProblemKind::oscillator,
                         .mass = oscillating_mass};
  problem.position = 1.04 * side;
  problem.sample_times = {12.0};
  problem.exact.events = {{ContactChange::onset, 0.0, problem.position}};
  problem.rates = {0.0};
  for (int i = 1; i <= 5; ++i) {
    problem.exact.events.push_back({i < 5 ? ContactChange::reversal : ContactChange::capture, i * pi / 2.0,
                                    side * (i % 2 == 1 ? -1.0 : 1.0) * (1.04 - 0.2 * i)});
    problem.rates.push_back(
        4.0 * (1.14 - 0.2 * i));  // omega^2 times the distance from the middle of the half cycle
  }
  problem.exact.samples = {{ContactState::stick, -0.04 * side, 0.0, -0.16 * side}};
  return problem;
}

ContactProblem plane_that_never_slips() {
  ContactProblem problem{
      .name = "StuckForEver", .kind = ContactProblemKind::plane_below_limit, .mass = shaken_plane(0.99)};
  problem.position = 0.25;
  for (int i = 1; i <= 120; ++i) {
    problem.sample_times.push_back(0.1 * i);
    problem.exact.samples.push_back({ContactState::stick, 0.25, 0.0, 0.99 * std::sin(2.0 * pi * 0.1 * i)});
  }
  return problem;
}

/// Adds the slips of a plane shaken by A sin(omega t), A > 1: from the onset at |A sin| = 1, or from a reversal, in the
/// direction d, v_s = -d (t - s) + A/omega (cos omega t - cos omega s) until its next zero.
void add_slips(ContactProblem& problem, double amplitude, double end) {
  const double omega = 2.0 * pi, first = std::asin(1.0 / amplitude) / omega;
  double position = 0.0, time = first;
  bool stuck = true;
  const auto add = [&](ContactChange change, double rate) {
    problem.exact.events.push_back({change, time, position});
    problem.rates.push_back(std::abs(rate));
  };
  while (time < end) {
    if (stuck) add(ContactChange::onset, amplitude * omega * std::cos(omega * time));
    const double start = time, d = std::sin(omega * start) > 0.0 ? -1.0 : 1.0;
    const auto velocity = [&](double t) {
      return -d * (t - start) + amplitude / omega * (std::cos(omega * t) - std::cos(omega * start));
    };
    double low = start + 1e-3, high = low;
    while (d * velocity(high) > 0.0) low = high, high += 1e-3;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + high);
      (d * velocity(middle) > 0.0 ? low : high) = middle;
    }
    time = low;
    if (time >= end) return;
    const double length = time - start;
    position += -0.5 * d * length * length + amplitude / omega *
                                                 ((std::sin(omega * time) - std::sin(omega * start)) / omega -
                                                  length * std::cos(omega * start));
    const double force = amplitude * std::sin(omega * time);
    stuck = std::abs(force) <= 1.0;
    add(stuck ? ContactChange::capture : ContactChange::reversal, d + force);
    if (stuck) time = first + std::ceil((time - first) * 2.0) / 2.0;
  }
}

/// Case SDND104, with the mean of 10 N |v_s| over 4 <= t <= 12 s from a computation with 40 digits.
ContactProblem plane_that_slips(double amplitude, double friction_power) {
  ContactProblem problem{.name = "Plane" + parameter_name(amplitude),
                         .kind = ContactProblemKind::shaken_plane,
                         .mass = testing::shaken_plane(amplitude)};
  problem.sample_times = {4.0, 12.0};
  add_slips(problem, amplitude, 12.0);
  problem.friction_power = friction_power;
  return problem;
}

ContactProblem pair_of_masses(double position) {
  ContactProblem problem{.name = "TwoMasses" + parameter_name(position),
                         .kind = ContactProblemKind::two_masses};
  problem.position = position;
  problem.sample_times = {12.0};
  ExactPair exact(problem.pair, position);
  exact.run(12.0);
  problem.exact.events = exact.events();
  const double phase = problem.pair.omega * 12.0, wall = problem.pair.wall_amplitude;
  const double velocity = exact.velocity()[1] - wall * problem.pair.omega * std::cos(phase);
  problem.exact.samples = {{exact.stuck() ? ContactState::stick : ContactState::slip,
                            exact.displacement()[1] - wall * std::sin(phase), velocity}};
  return problem;
}

std::vector<ContactProblem> all_problems() {
  std::vector<ContactProblem> problems;
  for (const double side : {-1.0, 1.0}) {
    problems.push_back(coulomb_slider(side));
    problems.push_back(coulomb_oscillator(side));
  }
  for (const double position : {-0.6, -0.5, -0.4, 0.4, 0.5, 0.6}) problems.push_back(loaded_spring(position));
  problems.push_back(plane_that_never_slips());
  problems.push_back(plane_that_slips(1.01, 2.26164121279787e-4));
  problems.push_back(plane_that_slips(1.5, 0.409062451015709));
  problems.push_back(plane_that_slips(15.0, 15.2670995893716));
  for (const double position : {-0.4, -0.1, 0.0, 0.1, 0.4}) problems.push_back(pair_of_masses(position));
  return problems;
}

}  // namespace

const std::vector<ContactProblem>& contact_problems() {
  static const std::vector<ContactProblem> problems = all_problems();
  return problems;
}

}  // namespace stickslip::testing
