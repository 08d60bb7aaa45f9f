// SPDX-License-Identifier: MIT
/// Claims of Sect. 2: the equations of the stick and slip states and of friction.

#include <Eigen/Dense>

#include "paper/measure.hpp"
#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/solver/beam_model.hpp"
#include "studies/verification/energy_audit.hpp"
#include "studies/verification/frequencies.hpp"
#include "studies/verification/paper_checks.hpp"
#include "support/paper_case.hpp"
#include "support/testing.hpp"
#include "support/vibration.hpp"

namespace stickslip::testing {
namespace {

using analytic::DampedSteadyState;
using analytic::TipSupport;

constexpr double hz = 15.0;  // of the steady states below
constexpr double omega = 2.0 * std::numbers::pi * hz;
constexpr double amplitude = 0.5e-3;

// The undamped steady state in closed form: y(x,t) = Re Y(x) sin(Omega t).
DampedSteadyState closed_form(TipSupport tip) {
  return DampedSteadyState(paper().beam(), excitation(hz, amplitude), data::Damping(), tip);
}

// L^2 u''(L) of it, of A0.
double tip_moment(TipSupport tip) {
  return std::abs(closed_form(tip).derivative(2, length())) * length() * length() / amplitude;
}

// The order in which a quantity of 10, 20 and 40 elements approaches its closed form. Hermite elements: the fourth power
// of the element length; the next term shifts the slope by a few hundredths.
template <class Quantity>
double mesh_order(double exact, Quantity&& quantity) {
  std::vector<double> element_lengths, errors;
  for (const int elements : {10, 20, 40}) {
    element_lengths.push_back(length() / elements);
    errors.push_back(std::abs(quantity(elements) - exact));
  }
  return observed_order(element_lengths, errors);
}
bool is_fourth(double order) { return std::abs(order - 4.0) < 0.15; }

// Of Eq. (11): u(x) of the steady state with a tip that slides without friction.
double sliding_order(double x) {
  return mesh_order(closed_form(TipSupport::free).displacement(x).real() - amplitude, [x](int elements) {
    const solver::BeamModel model(paper().beam(), elements);
    const Eigen::MatrixXd dynamic =
        Eigen::MatrixXd(model.slip_stiffness()) - omega * omega * Eigen::MatrixXd(model.mass());
    return model.interpolation(x).dot(
        dynamic.partialPivLu().solve(omega * omega * amplitude * model.base_load()));
  });
}

// |f| of the steady state with its tip held, N: what the tip's balance asks for on a mesh, and E I u''' in closed form.
double mesh_force(int elements, double axial_direction = 0.0) {
  return finite_element_steady_force(
      with(paper(), excitation(hz, amplitude),
           studies::with(paper().beam(), &data::BeamProperties::axial_direction, axial_direction)),
      elements);
}
double shear_force() { return std::abs(closed_form(TipSupport::held).friction_force()); }

TEST(Section2, TheBeamIsSlender) {
  const double depth = std::sqrt(12.0 * paper().beam().second_moment_of_area() / paper().beam().area());
  judge("sect2.slender", {.as_printed = length() / depth >= 10.0},
        "the beam is {:.3g} times as long as it is deep ({:.3g} m)", length() / depth, depth);
}

TEST(Section2, AxialMotionIsSmall) {
  // What bending shortens the beam by, 1/2 int u_x^2 dx, from chords of a twentieth of the length.
  solver::BeamSimulation run = run_at(25.0, 1e-3);
  const double chord = 0.05 * length();
  double lateral = 0.0, axial = 0.0;
  for (int n = 1; n <= 5000; ++n) {
    run.integrator().step();
    if (n % 10 != 0) continue;
    double shortening = 0.0;
    for (const double x : evenly_spaced(0.0, length() - chord, chord)) {
      const double end = run.displacement(x + chord);
      shortening += 0.5 * std::pow(end - run.displacement(x), 2) / chord;
      lateral = std::max(lateral, std::abs(end - run.base_displacement()));
    }
    axial = largest_or_nan({axial, shortening});
  }
  judge("sect2.axial-motion-neglected", {.as_printed = axial < 0.01 * lateral},
        "{:.2f} mm of deflection shorten the beam by {:.1e} mm", mm(lateral), mm(axial));
}

TEST(Equation1, GovernsTheCompressedBeam) {
  const auto steady = closed_form(TipSupport::held);
  const auto points = evenly_spaced(0.0, length(), 0.1 * length());
  const auto inertia = [&](double x) {
    return mass_per_length() * omega * omega * steady.displacement(x).real();
  };
  const double scale = largest(points, inertia),
               residual = largest(points, [&](double x) {
                 return bending_stiffness() * steady.derivative(4, x).real() +
                        axial_force() * steady.derivative(2, x).real() - inertia(x);
               });
  const double order = mesh_order(shear_force(), [](int elements) { return mesh_force(elements); });
  const double with = analytic::stick_modes(paper().beam(), 1)[0].frequency_hz();
  const double without = analytic::stick_modes(paper_beam_with_axial_force(0.0), 1)[0].frequency_hz();
  judge("eq1",
        {.as_printed = residual <= round_off(100, 1, scale).value && is_fourth(order) && with < without},
        "residual {:.0e} of its terms; order {:.2f}; P lowers the first frequency from {:.2f} to {:.2f} Hz",
        residual / scale, order, without, with);
}

TEST(Equation2, DeflectionAndSlopeVanishAtTheClamp) {
  const double found = largest(std::array{TipSupport::held, TipSupport::free}, [](TipSupport tip) {
    const auto steady = closed_form(tip);
    return std::hypot(std::abs(steady.displacement(0.0) - amplitude),
                      std::abs(steady.derivative(1, 0.0)) * length()) /
           amplitude;
  });
  const bool mesh = solver::BeamModel(paper().beam(), 20).interpolation(0.0).isZero(0.0);
  judge("eq2", {.as_printed = found <= round_off(50, 1, 1.0).value && mesh},
        "u and L u' are {:.0e} of A0 in the closed form and zero in finite elements", found);
}

TEST(Equation3, StuckTipHasNoMoment) {
  solver::BeamSimulation run = run_at(25.0, 1e-3);
  double departure = 0.0, start = 0.0;  // of y(L), which is u + h
  std::size_t phases = 0, events = 0;
  for (int n = 0; n < 3000; ++n) {
    run.integrator().step();
    if (run.integrator().state() != data::ContactState::stick) continue;
    if (phases == 0 || run.integrator().events().size() > events) {
      ++phases;
      events = run.integrator().events().size();
      start = run.tip_displacement();
    }
    departure = largest_or_nan({departure, std::abs(run.tip_displacement() - start)});
  }
  const double moment = tip_moment(TipSupport::held);
  judge("eq3",
        {.as_printed = phases > 2 && departure <= round_off(10, 1, 5e-3).value &&
                       moment <= round_off(50, 1, 10.0).value},
        "in {} stick phases to {:.0e} m; L^2 u''(L) is {:.0e} of A0 in the closed form", phases, departure,
        moment);
}

TEST(Equation4, FrictionIsTheShearForce) {
  const double shear = shear_force(), follower = mesh_force(40), fixed = mesh_force(40, 1.0);
  // Fourth order of the mesh: (beta_1 l)^4/720 = 1.3e-7 in the first mode, amplified by its nearness.
  const auto agrees = [=](double force) { return std::abs(force / shear - 1.0) <= 1e-5; };
  judge("eq4.shear-force",
        {.as_printed = agrees(follower) && agrees(fixed), .with_a_choice = agrees(follower)},
        "E I u''' is {:.4f} N, the force {:.4f} N, with an axial force of fixed direction {:.4f} N", shear,
        follower, fixed);
}

TEST(Equation4, StickContinuesOnlyWithinTheLimit) {
  analytic::EventDriven run(analytic::contact_model(with(paper(), excitation(25.0, 1e-3)), 10));
  const double found = largest(evenly_spaced(5e-5, 0.3, 5e-5), [&](double t) {
    run.advance_to(t);
    return run.state() == data::ContactState::stick ? run.friction_force() : 0.0;
  });
  const auto onsets =
      std::ranges::count(run.events(), data::ContactChange::onset, &data::ContactEvent::change);
  judge("eq4.necessary-condition",
        {.as_printed =
             onsets > 3 && found <= friction_limit() * (1.0 + 1e-9) && found > 0.95 * friction_limit()},
        "before {} onsets the force in stick reaches {:.2f} N of {:.0f} N", onsets, found, friction_limit());
}

TEST(Equation4, StickLastsUpToTheLimit) {
  solver::BeamSimulation run = run_at(25.0, 1e-3);
  const double at_start = std::abs(run.friction_force());
  bool stayed_below = true;
  while (run.integrator().state() == data::ContactState::stick) {
    stayed_below &= std::abs(run.friction_force()) <= friction_limit();
    run.integrator().step();
  }
  const double onset = run.integrator().events().front().time;
  solver::BeamSimulation bonded = run_at(25.0, 1e-3, {.is_bonded = true});
  while (bonded.integrator().time() < onset) bonded.integrator().step();
  const double after = std::abs(bonded.friction_force());
  judge("eq4.until",
        {.as_printed = at_start >= friction_limit(), .corrected = stayed_below && after > friction_limit()},
        "the force begins at {:.0f} N, and the tip sticks until {:.5f} s, when it passes {:.0f} N", at_start,
        onset, friction_limit());
}

TEST(Equation5, SlidingTipHasShearForceAndNoMoment) {
  // The static shape of a unit tip deflection is held by f_d = -E I u''' with u = -S.
  const solver::BeamModel model(paper().beam(), 40);
  const double row = (model.slip_stiffness() * model.unit_tip_deflection())[model.tip_deflection()];
  const double shear =
      bending_stiffness() * analytic::QuasiStaticShape(paper().beam()).third_derivative(length());
  const double order = sliding_order(length());
  judge("eq5",
        {.as_printed = std::abs(row / shear - 1.0) <= 1e-6 &&
                       tip_moment(TipSupport::free) <= round_off(100, 1, 10.0).value && is_fourth(order)},
        "f_d = {:.3f} kN/m by finite elements, {:.3f} kN/m in closed form; sliding with order {:.2f}",
        1e-3 * row, 1e-3 * shear, order);
}

// 0.5 s at 70 Hz and 1 mm by finite elements, with the law of Eq. (7) as it is printed.
double printed_coefficient(double v) { return 0.3 + (0.6 - 0.3) * std::exp(-1.0 * std::abs(v)); }

struct ContactRun {
  int slipping{}, opposing{};                         // steps in slip, and those in which f_d opposes v_s
  double departure{};                                 // largest difference of |f_d| and mu(v_s) P, N
  std::vector<double> static_forces, kinetic_forces;  // |f|, N
};

ContactRun contact_run() {
  solver::BeamSimulation run = run_at(70.0, 1e-3);
  ContactRun found;
  for (int n = 0; n < 5000; ++n) {
    run.integrator().step();
    const double v = run.integrator().sliding_velocity(), on_beam = -run.friction_force();
    const bool sticks = run.integrator().state() == data::ContactState::stick;
    (sticks ? found.static_forces : found.kinetic_forces).push_back(std::abs(on_beam));
    if (sticks || v == 0.0) continue;
    ++found.slipping;
    found.opposing += on_beam * v < 0.0 ? 1 : 0;
    found.departure = largest_or_nan(
        {found.departure, std::abs(std::abs(on_beam) - printed_coefficient(v) * axial_force())});
  }
  return found;
}

TEST(Equation6, FrictionOpposesTheVelocity) {
  const ContactRun run = contact_run();
  judge("eq6",
        {.as_printed = run.slipping > 1000 && run.opposing == run.slipping &&
                       run.departure <= round_off(10, 1, 300.0).value},
        "f_d v_s < 0 in {} of {} slipping steps, and |f_d| is mu(v_s) P to {:.0e} N", run.slipping,
        run.opposing, run.departure);
}

TEST(Equation7, CoefficientDecaysToTheMinimum) {
  const auto mu = [](double v) { return solver::friction_coefficient(paper().contact.friction, v); };
  bool decays = mu(0.0) == 0.6;
  for (const double v : evenly_spaced(0.1, 10.0, 0.1)) decays &= mu(v) < mu(v - 0.1) && mu(-v) == mu(v);
  const double departure =
      largest(evenly_spaced(0.0, 40.0, 0.1), [&](double v) { return mu(v) - printed_coefficient(v); });
  judge("eq7", {.as_printed = decays && departure <= round_off(10, 1, 0.6).value},
        "mu falls from {:.1f} at rest through {:.4f} at 1 m/s to {:.4f} at 10 m/s", mu(0.0), mu(1.0),
        mu(10.0));
}

TEST(Section2, MuSPIsTheRangeOfTheStaticForce) {
  const ContactRun run = contact_run();
  const auto [static_least, static_largest] = std::ranges::minmax(run.static_forces);
  const auto [kinetic_least, kinetic_largest] = std::ranges::minmax(run.kinetic_forces);
  // The kinetic force lies between mu_m P and mu_s P; the tip slides at up to about 1 m/s, mu(1) = 0.41.
  const double limit = friction_limit();
  const bool kinetic = kinetic_least >= 0.5 * limit && kinetic_least < 0.75 * limit &&
                       kinetic_largest <= limit + round_off(1, 1, limit).value;
  judge("sect2.static-force-range",
        {.as_printed = kinetic_least < 0.05 * limit,
         .corrected = kinetic && static_least < 0.05 * limit && static_largest > 0.95 * limit &&
                      static_largest <= limit},
        "|f_s| from {:.1f} to {:.1f} N in stick, |f_d| from {:.1f} N in slip", static_least, static_largest,
        kinetic_least);
}

TEST(Figure2, TheFrictionForceJumpsAtZeroVelocity) {
  const auto force = [](double v) {
    return std::copysign(solver::friction_coefficient(paper().contact.friction, v) * axial_force(), -v);
  };
  const double least = std::numeric_limits<double>::min();
  const double jump = force(-least) - force(least);
  judge("fig2.discontinuity", {.as_printed = std::abs(jump) > friction_limit()}, "f_d jumps by {:.0f} N",
        jump);
}

TEST(Figure2, JumpMakesNumericalDifficulties) {
  data::NumericalChoices choices = paper_choices(0.25);
  choices.elements = 10;
  const auto runs = studies::compare_schemes(
      with(paper_problem(25.0, 1e-3), data::NumericalSettings(choices), light_damping()));
  const auto located = runs.front().plateaus.size(), by_the_letter = runs.back().plateaus.size();
  judge("fig2.numerical-difficulties", {.as_printed = 2 * by_the_letter < located},
        "of {} stick phases of 2 ms and more in 0.2 s of a damped run at 25 Hz and 1 mm it finds {}", located,
        by_the_letter);
}

TEST(Equation8, FrequenciesConvergeOnTheMesh) {
  const auto modes = studies::stick_frequency_study(paper().beam(), 3, {8, 16, 32}).modes;
  const bool holds = std::ranges::all_of(modes, [](const auto& mode) {
    return is_fourth(mode.observed_order.order) && std::abs(mode.leading_constant_ratio - 1.0) < 0.05;
  });
  judge("eq8", {.as_printed = holds},
        "orders {:.2f}, {:.2f} and {:.2f}; on 32 elements the first is {:.0e} too large",
        modes[0].observed_order.order, modes[1].observed_order.order, modes[2].observed_order.order,
        modes[0].relative_error.back());
}

TEST(Equation9, AxialForceIsAFollower) {
  const auto flutter = studies::flutter_study(paper().beam(), {8, 16});
  const double beck = 20.05;  // Beck 1952, in E I/L^2
  const double mesh = flutter.finite_element.back();
  judge("eq9.follower",
        {.as_printed =
             std::abs(mesh / beck - 1.0) < 0.005 && std::abs(flutter.closed_form / beck - 1.0) < 0.005},
        "flutter at {:.3f} E I/L^2 on 16 elements and {:.3f} in closed form", mesh, flutter.closed_form);
}

TEST(Equation10, SolutionDoesNotDependOnTheSplit) {
  // The specified part is a deflection of the tip's node alone in nodal coordinates, and the static shape in modal ones.
  const data::Case problem = paper_problem(hz, amplitude);
  const double by_tip = solver::max_abs_friction_force(problem, solver::Coordinates::nodal),
               by_static_shape = solver::max_abs_friction_force(problem, solver::Coordinates::modal);
  // Condition of the dynamic stiffness: largest over smallest eigenvalue, about (pi elements/3.9)^4.
  judge("eq10",
        {.as_printed = static_cast<bool>(within(by_tip, by_static_shape, round_off(40, 1e5, by_tip)))},
        "|f_max| over 1 s is {:.4f} N by both, to {:.0e}", by_tip, std::abs(by_static_shape / by_tip - 1.0));
}

TEST(Equation11, ItsSolutionIsThatOfEquations1And5) {
  const double order = sliding_order(0.3 * length());
  judge("eq11", {.as_printed = is_fourth(order)}, "u(0.3 L) approaches it with order {:.2f}", order);
}

}  // namespace
}  // namespace stickslip::testing
