// SPDX-License-Identifier: MIT
#include "studies/analyses/squeal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/steady_sliding.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/sliding_stability.hpp"
#include "studies/analyses/contact_response.hpp"
#include "studies/common/bisection.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/natural_frequencies.hpp"

namespace stickslip::studies {

namespace {

using Complex = std::complex<double>;

void require_moving_wall(const data::Case& problem) {
  if (problem.contact.wall.speed() != 0.0) return;
  throw data::FieldError("wall.speed", "0", "other than 0 (m/s), or nothing slides steadily");
}

void require_dense_mesh(const data::Case& problem) {
  constexpr int most_elements = 200;
  const data::NumericalSettings& numerics = problem.numerics;
  if (problem.model() != nullptr) {
    if (problem.model()->matrices().rows <= 2 * most_elements) return;
    throw data::FieldError("model.stiffness_matrix",
                           fmt::format("of {} rows", problem.model()->matrices().rows),
                           "of at most 400 rows here: the eigenvalues of sliding take full matrices");
  }
  if (numerics.elements() <= most_elements) return;
  throw data::FieldError("numerics.elements", numerics.elements(),
                         "at most 200 here: the eigenvalues of sliding take full matrices");
}

// The slip state as it slides, on a base at rest.
solver::ContactSystem mesh_of(const data::Case& problem) { return solver::contact_system(problem, {}); }

SquealMode mode_of(const data::Case& problem, const analytic::SlidingMode& mode,
                   const std::vector<Complex>& eigenvalues) {
  const double ratio = -mode.free_root.real() / std::abs(mode.free_root);
  const bool holds = std::abs(ratio) > 1e-12;  // what rounding leaves of an undamped mode holds nothing
  SquealMode result{.frequency_hz = mode.free_root.imag() / (2.0 * std::numbers::pi),
                    .damping_ratio = holds ? ratio : 0.0,
                    .one_mode_slope = holds ? mode.one_mode_slope : 0.0,
                    .critical_slope = {},
                    .critical_speed = {},
                    .root = mode.root,
                    .finite_element_root = {}};
  if (mode.hopf) {
    result.critical_slope = holds ? mode.hopf->slope : 0.0;
    result.critical_speed =
        analytic::speed_of_slope(problem.contact.friction, problem.normal_force(), *result.critical_slope);
  }
  if (mode.root)
    result.finite_element_root =
        *std::ranges::min_element(eigenvalues, {}, [&](Complex s) { return std::abs(s - *mode.root); });
  return result;
}

// Returns the largest real root, if there is one. A pair of them counts as one mode.
std::optional<Complex> judge(const std::vector<Complex>& eigenvalues, Squeal& squeal) {
  int halves = 0;
  std::optional<Complex> real_root;
  for (const Complex s : eigenvalues) {
    if (std::abs(s) > two_pi * squeal.resolved_hz) {
      squeal.unresolved_mode_grows |= grows(s);
      continue;
    }
    halves += s.imag() == 0.0 ? 1 : 2;
    if (s.real() > squeal.fastest.real()) squeal.fastest = s;
    if (s.imag() == 0.0 && (!real_root || s.real() > real_root->real())) real_root = s;
  }
  squeal.resolved_modes = halves / 2;
  return real_root;
}

// The eigenvalue of slip at the axial force that grows most in a period.
Complex fastest_slip(const data::Case& problem, double axial_force) {
  const auto eigenvalues = solver::sliding_eigenvalues(
      mesh_of(with_values(problem, {{"beam.axial_force", axial_force}, {"numerics.elements", 10.0}})),
      -problem.contact.friction.viscous() * axial_force);
  return *std::ranges::max_element(eigenvalues, {}, [](Complex s) { return s.real() / std::abs(s); });
}

}  // namespace

std::optional<SlipInstability> slip_instability(const data::Case& problem) {
  constexpr int steps = 32;
  double load = problem.normal_force();
  if (problem.model() != nullptr || load <= 0.0)
    return std::nullopt;  // the force of a model does not change it
  const Complex root = fastest_slip(problem, load);
  if (!grows(root)) return std::nullopt;
  const double step = load / steps;
  double stable = load - step;
  while (stable > 0.5 * step && grows(fastest_slip(problem, stable))) load = stable, stable -= step;
  const auto is_stable_at = [&](double force) { return !grows(fastest_slip(problem, force)); };
  return SlipInstability{root, bracketed(stable, load, is_stable_at, 1.5e-6 * step).second};
}

double resolved_frequency(const data::Case& problem) {
  if (problem.model() != nullptr) return std::numeric_limits<double>::infinity();
  constexpr double allowed_error = 0.01;
  const double element = problem.beam().length() / problem.numerics.elements();
  return std::sqrt(allowed_error / mesh_frequency_error(problem.beam(), 1.0, element)) / two_pi;
}

Squeal squeal_of(const data::Case& problem, int modes) {
  require_moving_wall(problem);
  require_dense_mesh(problem);
  const analytic::ContactModel model = response_model(problem);
  std::vector<double> frequencies;
  for (const auto& [hz, error] : closed_form_frequencies(problem, analytic::TipSupport::free, modes))
    frequencies.push_back(two_pi * hz);
  const auto steady = analytic::steady_sliding(problem);
  Squeal squeal{.speed = problem.contact.wall.speed(),
                .slope = analytic::falling_slope(problem.contact.friction, problem.normal_force(),
                                                 problem.contact.wall.speed()),
                .friction_force = steady.friction_force,
                .tip_displacement = steady.tip_displacement,
                .finite_element_displacement = {},
                .all_modes = problem.model() == nullptr && problem.damping.is_kelvin_voigt(),
                .modes = {},
                .resolved_modes = 0,
                .resolved_hz = resolved_frequency(problem),
                .fastest = {-std::numeric_limits<double>::infinity(), 0.0},
                .unresolved_mode_grows = false};
  const solver::ContactSystem mesh = mesh_of(problem);
  squeal.finite_element_displacement = solver::steady_contact_displacement(mesh, steady.friction_force);
  const auto eigenvalues = solver::sliding_eigenvalues(mesh, solver::falling_slope(mesh));
  const auto real_root = judge(eigenvalues, squeal);
  if (problem.model() != nullptr)  // its rows are all there is
    squeal.resolved_hz =
        std::abs(*std::ranges::max_element(eigenvalues, {}, [](Complex s) { return std::abs(s); })) / two_pi;
  const analytic::Mobility mobility = analytic::contact_mobility(problem, model);
  for (const auto& mode : analytic::sliding_modes(mobility, frequencies, squeal.slope))
    squeal.modes.push_back(mode_of(problem, mode, eigenvalues));
  if (!squeal.modes.empty() && !squeal.modes.front().root)
    squeal.modes.front().finite_element_root = real_root;
  return squeal;
}

std::vector<double> sliding_growths(const data::Case& problem, const std::vector<double>& speeds,
                                    double damping_ratio) {
  const analytic::ContactModel model = response_model(with_value(problem, "damping.ratio", damping_ratio));
  std::vector<double> growths;
  for (const double speed : speeds) {
    const double slope = analytic::falling_slope(problem.contact.friction, problem.normal_force(), speed);
    growths.push_back(analytic::sliding_eigenvalues(model, slope).front().real());
  }
  return growths;
}

namespace {

using Quantity = double (*)(const analytic::EventDriven&);

// The largest values of quantities in a period: of samples, then twice of samples next to each largest one, which leaves
// (3e-4)² of its curvature.
std::array<double, 3> largest(const analytic::ContactModel& model, const analytic::PeriodicMotion& motion,
                              const std::array<Quantity, 3>& quantities) {
  std::array<double, 3> from{}, to{}, at{}, values{};
  to.fill(motion.period);
  values.fill(-std::numeric_limits<double>::infinity());
  for (const int samples : {1000, 60, 60}) {
    std::multimap<double, std::size_t> times;  // with the quantity
    for (std::size_t k = 0; k < quantities.size(); ++k)
      for (int i = 0; i <= samples; ++i)
        times.emplace(std::lerp(from[k], to[k], static_cast<double>(i) / samples), k);
    analytic::EventDriven run(model);
    analytic::start(run, model, motion.start);
    for (const auto& [time, k] : times) {
      run.advance_to(time);
      if (const double now = quantities[k](run); now > values[k]) values[k] = now, at[k] = time;
    }
    for (std::size_t k = 0; k < quantities.size(); ++k) {
      const double step = (to[k] - from[k]) / samples;
      from[k] = std::max(0.0, at[k] - step);
      to[k] = std::min(motion.period, at[k] + step);
    }
  }
  return values;
}

double stick_share_of(const analytic::PeriodicMotion& motion) {
  bool sticks = motion.start.phase == data::ContactState::stick;
  double before = 0.0, sticking = 0.0;
  for (const auto& event : motion.events) {
    if (sticks) sticking += event.time - before;
    if (event.change != data::ContactChange::graze) sticks = event.change == data::ContactChange::capture;
    before = event.time;
  }
  return (sticking + (sticks ? motion.period - before : 0.0)) / motion.period;
}

// What a reader asks of one period.
void measure(const analytic::ContactModel& model, const analytic::PeriodicMotion& motion, Cycle& cycle) {
  constexpr Quantity tip = [](const analytic::EventDriven& run) {
    return run.contact_displacement() + run.base_displacement();
  };
  const auto [highest, deepest, fastest] =
      largest(model, motion,
              {tip, [](const auto& run) { return -tip(run); },
               [](const auto& run) { return std::abs(run.sliding_velocity()); }});
  cycle.peak_to_peak = highest + deepest;
  cycle.largest_sliding = fastest;
  cycle.stick_share = stick_share_of(motion);
}

}  // namespace

Cycle cycle_of(const data::Case& problem, int periods, int settle) {
  const analytic::ContactModel model = response_model(problem);
  Cycle cycle{.search = {},
              .forced = problem.excitation().amplitude() > 0.0,
              .peak_to_peak = {},
              .largest_sliding = {},
              .stick_share = {}};
  if (cycle.forced) {
    cycle.search = analytic::forced_motion(model, periods, settle);
  } else {
    if (problem.contact.wall.speed() == 0.0)
      throw data::FieldError("excitation.amplitude", "0", "above 0 (m) where wall.speed is 0: nothing moves");
    const double period = 1.0 / closed_form_frequencies(problem, analytic::TipSupport::free, 1).front().hz;
    cycle.search = analytic::self_excited_motion(model, settle * period, period / 200.0);
  }
  if (cycle.search.motion) measure(model, *cycle.search.motion, cycle);
  return cycle;
}

Cycle limit_cycle_of(const data::Case& problem, int settle) {
  data::Case still = problem;
  still.motion =
      data::HarmonicExcitation({.frequency_hz = problem.excitation().frequency_hz(), .amplitude = 0.0});
  return cycle_of(still, 1, settle);
}

bool is_stable(const Cycle& cycle) {
  return std::ranges::all_of(cycle.search.motion->multipliers, [&](Complex multiplier) {
    // The multiplier 1 of a shift in time is known to the accuracy of the motion.
    const bool is_shift = !cycle.forced && std::abs(multiplier - 1.0) < 1e-6;
    return std::abs(multiplier) <= 1.0 || is_shift;
  });
}

}  // namespace stickslip::studies
