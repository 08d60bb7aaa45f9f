// SPDX-License-Identifier: MIT
/// The event-driven engine against exact solutions of one mass and of held oscillators, beyond those of contact_battery_test.cpp.

#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/contact_dynamics.hpp"
#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/analytic/stick_propagator.hpp"
#include "support/contact_models.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::ContactModel;
using analytic::EventDriven;
using data::ContactChange;
using data::ContactEvent;
using data::ContactState;
using std::numbers::pi;

/// The slip phases add an error of at most `per_step` in each step, and neither friction nor damping lets it
/// grow; `steps` is counted generously at 10 per radian of the fastest motion.
Tolerance accumulated(double per_step, double steps, double scale) {
  return discretisation(per_step * steps * scale, 1.0, "error per step times steps");
}

// One mass.

STICKSLIP_VERIFIES(EventDriven, "D1");
TEST(EventDriven, SeesADipHoweverShallow) {
  // v_s = v0 - F t + A (cos t - 1) has its first minimum where sin t = -F/A with cos t < 0. v0 puts it at
  // `depth`: above zero nothing happens; below, the mass is captured before and let go at the very minimum,
  // where the wall's acceleration is as large as friction can follow.
  const double friction = 1.0, amplitude = 2.0, bottom = pi + std::asin(friction / amplitude);
  const double bend = -amplitude * std::cos(bottom);  // v_s_tt
  for (const double depth : {1e-3, 1e-6, 1e-9, 1e-12, -1e-12, -1e-9, -1e-6, -1e-3}) {
    const double v0 = depth + friction * bottom - amplitude * (std::cos(bottom) - 1.0);
    EventDriven mass(contact_model(
        {.normal_force = 10.0, .friction = coulomb, .wall_acceleration = amplitude, .omega = 1.0}));
    mass.start_slipping({}, {}, 0.0, v0);
    mass.advance_to(bottom + 0.3);
    EXPECT_EQ(mass.state(), data::ContactState::slip);
    EXPECT_GT(mass.sliding_velocity(), 0.0);
    if (depth > 0.0) {
      EXPECT_TRUE(mass.events().empty()) << depth;
      continue;
    }
    ASSERT_EQ(mass.events().size(), 2u) << depth;
    EXPECT_EQ(mass.events()[0].change, ContactChange::capture);
    EXPECT_EQ(mass.events()[1].change, ContactChange::onset);
    EXPECT_LT(mass.events()[0].time, bottom);
    const double t = mass.events()[0].time;
    const double reached = v0 - friction * t + amplitude * (std::cos(t) - 1.0);
    EXPECT_TRUE(within(reached, 0.0, accumulated(1e-12, 10.0 * bottom, 2.0 * v0)));
    EXPECT_TRUE(within(mass.events()[1].time, bottom, round_off(10, bottom, amplitude / bend)));
  }
}

TEST(EventDriven, RestsWhereNothingEverMoves) {
  for (const bool slips : {false, true}) {
    EventDriven mass(contact_model({.normal_force = 10.0, .friction = coulomb}));
    slips ? mass.start_slipping({}, {}, 0.25, 0.0) : mass.start_stuck({}, {}, 0.25);
    mass.advance_to(100.0);
    EXPECT_EQ(mass.state(), data::ContactState::stick);
    // A slip that cannot begin lasts the shortest step, 1e-6/omega, at mu N/m = 1 m/s^2.
    EXPECT_TRUE(within(mass.contact_displacement(), 0.25, discretisation(5e-13, 1.0, "a t^2/2")));
    EXPECT_EQ(mass.friction_force(), 0.0);
  }
}

// Held oscillators: one mode, T_tt + c T_t + omega^2 T = b sin(Omega t) + (wall), the contact never let go.

struct HeldMode {
  double omega{3.0}, damping{}, load_omega{3.0};
  double coupling{0.4}, load{0.7}, wall{}, contact_damping{};
};

ContactModel contact_model(const HeldMode& mode) {
  ContactModel model;
  model.angular_frequency = {mode.omega};
  model.mass_coupling = {mode.coupling};
  model.contact_mass = 1.5;
  model.contact_stiffness = 20.0;
  model.follower = {0.9};
  model.contact_follower = -0.6;
  model.load = {mode.load, -0.2};
  model.load_angular_frequency = mode.load_omega;
  model.wall_amplitude = mode.wall;
  model.normal_force = 1e6;
  model.friction = data::FrictionLaw(coulomb);
  if (mode.damping == 0.0) return model;
  model.damping = analytic::Matrix(2, 2);
  model.damping(0, 0) = mode.damping;
  model.damping(0, 1) = model.damping(1, 0) = mode.contact_damping;
  model.damping(1, 1) = 0.8;
  return model;
}

/// T and T_t of the held mode from T(0) = 0.3, T_t(0) = -0.5, by the complex roots of lambda^2 + c lambda +
/// omega^2 = 0; neither critically damped nor in resonance, in long double against the cancellation near it.
struct HeldMotion {
  double amplitude{}, rate{}, acceleration{};
};
HeldMotion exact_motion(const HeldMode& mode, double t) {
  using Real = long double;
  using Complex = std::complex<Real>;
  const Complex i(0.0L, 1.0L);
  const Real c = mode.damping, omega = mode.omega, drive = mode.load_omega;
  // Re(load exp(i Omega t)); the wall moves by W sin(Omega t).
  const Complex load = -i * (static_cast<Real>(mode.load) + mode.coupling * drive * drive * mode.wall) -
                       static_cast<Real>(mode.contact_damping) * drive * static_cast<Real>(mode.wall);
  const Complex steady = load / (omega * omega - drive * drive + i * c * drive);
  const Complex root = std::sqrt(Complex(c * c / 4.0L - omega * omega));
  const Complex first = -c / 2.0L + root, second = -c / 2.0L - root;
  const Complex x0 = 0.3L - steady.real(), v0 = -0.5L - (i * drive * steady).real();
  const Complex a = (v0 - second * x0) / (first - second), b = x0 - a;
  const Complex ea = a * std::exp(first * static_cast<Real>(t));
  const Complex eb = b * std::exp(second * static_cast<Real>(t));
  const Complex es = steady * std::exp(i * drive * static_cast<Real>(t));
  return {static_cast<double>((ea + eb + es).real()),
          static_cast<double>((first * ea + second * eb + i * drive * es).real()),
          static_cast<double>((first * first * ea + second * second * eb - drive * drive * es).real())};
}

void expect_exact_stick(const HeldMode& mode, const std::function<HeldMotion(double)>& exact) {
  const ContactModel model = contact_model(mode);
  EventDriven held(model);
  held.start_stuck({0.3}, {-0.5}, 0.1);
  for (int k = 1; k <= 40; ++k) {
    const double t = 0.37 * k;
    held.advance_to(t);
    const HeldMotion expected = exact(t);
    // In resonance the motion grows as t; phases are good to eps omega t.
    const double scale = 1.0 + t, kappa = 1.0 + std::max(mode.omega, mode.load_omega) * t;
    ASSERT_TRUE(within(held.amplitudes()[0], expected.amplitude, round_off(20, kappa, scale))) << t;
    ASSERT_TRUE(within(held.rates()[0], expected.rate, round_off(20, kappa, mode.omega * scale))) << t;
    // The balance of the contact, every term of it.
    const double drive = mode.load_omega, s = std::sin(drive * t), wall = mode.wall;
    const double u = 0.1 + wall * s, v = wall * drive * std::cos(drive * t), a = -drive * drive * wall * s;
    double force =
        mode.coupling * expected.acceleration + 1.5 * a + 19.4 * u + 0.9 * expected.amplitude + 0.2 * s;
    if (mode.damping != 0.0) force += mode.contact_damping * expected.rate + 0.8 * v;
    ASSERT_TRUE(within(held.friction_force(), force, round_off(40, kappa, 20.0 * scale))) << t;
    ASSERT_TRUE(within(held.contact_displacement(), u, round_off(4, kappa, 1.0)));
    ASSERT_TRUE(within(held.contact_velocity(), v, round_off(4, kappa, 3.0)));
  }
  EXPECT_TRUE(held.events().empty());
}

STICKSLIP_VERIFIES(HeldMode, "D1");
// From far off to within 1e-6 of resonance, and from a thousandth of critical damping to creep.
TEST(HeldMode, FollowsTheClosedForm) {
  std::vector<HeldMode> modes;
  for (const double detuning : {-0.5, -0.01, -1e-6, 1e-6, 1e-3, 0.1, 3.0})
    modes.push_back({.load_omega = 3.0 * (1.0 + detuning), .wall = 0.05});
  for (const double fraction : {1e-3, 0.1, 0.9, 1.2, 5.0})
    for (const double load_omega : {2.0, 3.0, 7.0})
      modes.push_back(
          {.damping = 6.0 * fraction, .load_omega = load_omega, .wall = 0.05, .contact_damping = 0.3});
  for (const HeldMode& mode : modes) {
    SCOPED_TRACE(fmt::format("c = {}, Omega = {}", mode.damping, mode.load_omega));
    expect_exact_stick(mode, [&](double t) { return exact_motion(mode, t); });
  }
}

TEST(HeldMode, GrowsWithTimeAtResonance) {
  // T = 0.3 cos(omega t) - 0.5 sin(omega t)/omega + b/(2 omega^2) (sin(omega t) - omega t cos(omega t)).
  const HeldMode mode{.wall = 0.05};
  const double omega = mode.omega, b = mode.load + mode.coupling * omega * omega * mode.wall;
  expect_exact_stick(mode, [=](double t) -> HeldMotion {
    const double sine = std::sin(omega * t), cosine = std::cos(omega * t), p = b / (2.0 * omega * omega);
    const double amplitude = 0.3 * cosine - 0.5 / omega * sine + p * (sine - omega * t * cosine);
    return {amplitude, -0.3 * omega * sine - 0.5 * cosine + p * omega * omega * t * sine,
            b * sine - omega * omega * amplitude};
  });
}

TEST(HeldMode, RefusesCriticalDamping) {
  EXPECT_THROW(EventDriven(contact_model(HeldMode{.damping = 6.0})), std::runtime_error);
}

// One held mode with a spring between it and the contact: the force is a slow rise with a fast ripple on it.
// In the unit of the limit, f = F sin(Omega t) + ripple, the ripple so high that f crosses the limit several
// times within a cycle of it.
STICKSLIP_VERIFIES(RippledForce, "D1");
TEST(RippledForce, LetsGoAtTheFirstCrossing) {
  for (const double damping : {0.0, 0.4}) {
    SCOPED_TRACE(damping);
    const double limit = 1.0;
    int several = 0;
    for (int phase = 0; phase < 60; ++phase) {
      const HeldMode mode{.omega = 40.0,
                          .damping = damping,
                          .load_omega = 1.0,
                          .coupling = 0.0,
                          .load = 0.0,
                          .wall = 0.08,
                          .contact_damping = damping > 0.0 ? 0.02 : 0.0};
      ContactModel model = contact_model(mode);
      model.normal_force = limit / model.friction.static_coefficient();
      const double ripple = 0.07 * (1.0 + 0.03 * phase), angle = 2.0 * pi * phase / 60.0;
      const std::vector<double> amplitudes{ripple * std::cos(angle)}, rates{40.0 * ripple * std::sin(angle)};

      ContactModel bonded = model;
      bonded.normal_force = 1e6;
      EventDriven held(bonded), sticking(model);
      held.start_stuck(amplitudes, rates);
      // A quiet run before lets the search begin with steps of many cycles.
      sticking.start_stuck({0.0}, {0.0});
      sticking.advance_to(0.6);
      sticking.start_stuck(amplitudes, rates);
      sticking.advance_to(1.5);
      ASSERT_FALSE(sticking.events().empty());
      const double onset = sticking.events().front().time;

      // 4000 samples of the force of the held contact: none before the onset is above the limit.
      int crossings = 0;
      bool above = false;
      for (int k = 1; k <= 4000; ++k) {
        const double t = 1.5 * k / 4000.0;
        held.advance_to(t);
        const bool now = std::abs(held.friction_force()) > limit;
        ASSERT_FALSE(now && t < onset) << phase << ": above the limit at " << t << " s, onset at " << onset;
        crossings += now != above ? 1 : 0;
        above = now;
      }
      several += crossings > 1 ? 1 : 0;
      EventDriven until(bonded);
      until.start_stuck(amplitudes, rates);
      until.advance_to(onset);
      EXPECT_TRUE(within(std::abs(until.friction_force()), limit, round_off(100, 60.0, limit)));
    }
    EXPECT_GT(several, 20) << "the ripple is to cross the limit more than once";
  }
}

TEST(EventDriven, SeesAPeakOfTheForceHoweverShallow) {
  // f = A sin(2 pi t) against 1, A = 1 + depth: from wherever it starts to look, the mass lets go if A > 1 and not if
  // A < 1. The round-off of f moves the time by its share of the slope with which f passes 1, 2 pi sqrt(A^2 - 1).
  for (const double depth : {14.0, 0.5, 1e-2, 1e-3, 1e-6, 1e-9, 1e-12, -1e-12, -1e-9, -1e-6, -1e-3})
    for (const double until : {0.0, 0.1, 0.2, 0.24}) {
      const double amplitude = 1.0 + depth;
      EventDriven mass(contact_model(shaken_plane(amplitude)));
      mass.advance_to(until);
      mass.advance_to(0.3);
      ASSERT_EQ(mass.events().empty(), depth < 0.0) << depth << ", " << until;
      if (depth < 0.0) continue;
      EXPECT_EQ(mass.events().front().change, ContactChange::onset);
      EXPECT_EQ(mass.events().front().position, 0.0);
      const double slope = 2.0 * pi * std::sqrt(amplitude * amplitude - 1.0);
      EXPECT_TRUE(within(mass.events().front().time, std::asin(1.0 / amplitude) / (2.0 * pi),
                         round_off(10, 1, amplitude / slope)))
          << depth << ", " << until;
    }
}

// The beam.

STICKSLIP_VERIFIES(EventDrivenBeam, "D3");
TEST(EventDrivenBeam, IgnoresTheTimesAskedFor) {
  const ContactModel model = analytic::contact_model(with(paper_problem(25.0, 1e-3), light_damping()), 10);
  EventDriven once(model, {.keep_energy_balance = true}), often(model, {.keep_energy_balance = true});
  once.advance_to(0.2);
  for (int k = 1; k <= 1000; ++k) often.advance_to(0.2e-3 * k);
  ASSERT_GT(once.events().size(), 10u);
  ASSERT_EQ(often.events().size(), once.events().size());
  // Rounding of the onsets, eps of the time, carried through the phases after it.
  for (std::size_t i = 0; i < once.events().size(); ++i) {
    const ContactEvent &event = often.events()[i], &expected = once.events()[i];
    EXPECT_EQ(event.change, expected.change) << i;
    EXPECT_TRUE(within(event.time, expected.time, round_off(100, 100, 0.1))) << i;
    EXPECT_TRUE(within(event.position, expected.position, round_off(100, 100, 2e-3))) << i;
  }
  EXPECT_TRUE(within(often.contact_displacement(), once.contact_displacement(), round_off(100, 100, 2e-3)));
  EXPECT_TRUE(
      within(often.energy_balance().base_work, once.energy_balance().base_work, round_off(1000, 10, 10.0)));
}

// Bad input.

TEST(EventDriven, RefusesUnusableModels) {
  const double nan = std::nan("");
  const auto refuses = [](const char* part, const std::function<void(ContactModel&)>& spoil) {
    ContactModel model = contact_model(ForcedPair{});
    spoil(model);
    expect_error_message<std::invalid_argument>([&] { EventDriven run(model); }, {part});
  };
  for (const double omega : {0.0, -1.0, nan}) {
    refuses("angular_frequency is", [=](auto& m) { m.angular_frequency[0] = omega; });
    refuses("load_angular_frequency is", [=](auto& m) { m.load_angular_frequency = omega; });
  }
  refuses("mass_coupling is 2", [](auto& m) { m.mass_coupling.push_back(0.0); });
  refuses("follower is 0", [](auto& m) { m.follower.clear(); });
  refuses("load is 1", [](auto& m) { m.load.pop_back(); });
  refuses("damping", [](auto& m) { m.damping = analytic::Matrix(1, 2); });
  refuses("damping's rows is 1", [](auto& m) { m.damping = analytic::Matrix(2, 1); });
  refuses("contact_mass", [](auto& m) { m.contact_mass = 0.1; });
  refuses("model.mass_matrix", [](auto& m) { m.contact_mass = m.mass_coupling[0] * m.mass_coupling[0]; });
  refuses("normal_force", [](auto& m) { m.normal_force = -1.0; });
  for (const auto& [name, member] : {std::pair{"normal_force", &ContactModel::normal_force},
                                     {"contact_stiffness", &ContactModel::contact_stiffness},
                                     {"contact_follower", &ContactModel::contact_follower},
                                     {"wall_amplitude", &ContactModel::wall_amplitude}})
    refuses(name, [nan, member = member](auto& m) { m.*member = nan; });
  refuses("load is nan", [=](auto& m) { m.load[0] = nan; });
  refuses("follower is nan", [=](auto& m) { m.follower[0] = nan; });
  refuses("damping is nan", [=](auto& m) { m.damping(0, 1) = nan; });
}

TEST(EventDriven, RefusesUnusableStarts) {
  const ContactModel model = contact_model(ForcedPair{});
  for (const double tolerance : {0.0, -1e-9, 1e-15, std::nextafter(1e-3, 1.0), std::nan("")})
    EXPECT_THROW(EventDriven(model, {.tolerance = tolerance}), std::invalid_argument) << tolerance;
  EXPECT_NO_THROW(EventDriven(model, {.tolerance = 1e-3}));
  const double nan = std::nan("");
  const std::function<void(EventDriven&)> unusable[] = {
      [](auto& run) {
        run.start_stuck({0.0, 0.0}, {});
      },
      [=](auto& run) { run.start_stuck({nan}, {}); },
      [=](auto& run) { run.start_stuck({}, {}, nan); },
      [](auto& run) {
        run.start_slipping({}, {0.0, 0.0}, 0.0, 0.0);
      },
      [=](auto& run) { run.start_slipping({}, {}, 0.0, nan); },
      [](auto& run) { run.advance_to(0.4); },
      [=](auto& run) { run.advance_to(nan); },
      [](auto& run) { run.advance_to(std::numeric_limits<double>::infinity()); }};
  for (const auto& action : unusable) {
    EventDriven run(model);
    run.advance_to(0.5);
    EXPECT_THROW(action(run), std::invalid_argument);
    EXPECT_THROW((void)run.energy_balance(), std::logic_error);
  }
}

// --- A stick phase between its samples: what the search for the onset rests on

using analytic::ContactDynamics;
using analytic::StickPropagator;

// Three modes under a load in the middle of them, with every coupling that a model can have.
ContactModel three_modes(bool damped) {
  ContactModel model{{.angular_frequency = {2.0, 5.0, 11.0},
                      .mass_coupling = {0.4, -0.3, 0.2},
                      .contact_mass = 1.5,
                      .contact_stiffness = 20.0,
                      .follower = {0.9, -0.7, 0.5},
                      .contact_follower = -0.6,
                      .damping = {},
                      .participation = {},
                      .drag = {}},
                     {0.7, 0.4, -0.3, -0.2}};
  model.load_angular_frequency = 3.0;
  model.wall_amplitude = 0.3;
  model.normal_force = 1e6;
  if (!damped) return model;
  model.damping = analytic::Matrix(4, 4);
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      model.damping(i, j) = (i == j ? 0.4 : 0.1) + 0.05 * static_cast<double>(i + j);
  return model;
}

STICKSLIP_VERIFIES(StickPropagator, "D1");
TEST(StickPropagator, KnowsTheBendOfItsForce) {
  for (const bool damped : {false, true}) {
    const double start = 0.7;
    const ContactDynamics dynamics(three_modes(damped));
    StickPropagator phase(dynamics);
    phase.begin(start, {{0.3, -0.2, 0.1},
                        {-0.5, 0.4, 1.0},
                        0.1 + dynamics.wall_displacement(start),
                        dynamics.wall_velocity(start)});
    // Central differences: h^2/6 of the third derivative, (11/s)^3 of a force of 30 N, and eps of it over h.
    const auto slope = [&](double t, double h) {
      return (phase.force(t + h) - phase.force(t - h)) / (2.0 * h);
    };
    const auto bend = [&](double t, double h) {
      return std::abs(phase.force(t + h) - 2.0 * phase.force(t) + phase.force(t - h)) / (h * h);
    };
    double sum_of_bounds = 0.0, sum_of_bends = 0.0;
    for (int k = 1; k <= 40; ++k) {
      const double t = start + 0.13 * k;
      EXPECT_TRUE(within(phase.force_rate(t), slope(t, 1e-4),
                         discretisation(1e-8 / 6.0 * std::pow(11.0, 3) * 30.0, 1.0, "h^2/6 f_ttt")))
          << t;
      for (const double length : {0.01, 0.2}) {
        double largest = 0.0;
        for (int i = 0; i <= 20; ++i) largest = std::max(largest, bend(t + length * i / 20.0, 1e-3));
        EXPECT_GE(phase.curvature_bound(t, length), largest * (1.0 - 1e-4)) << t;
      }
      sum_of_bounds += phase.curvature_bound(t, 0.0);
      sum_of_bends += bend(t, 1e-3);
    }
    // Moduli are added for the parts of f, which do not peak together: some times too much, but no decade.
    EXPECT_LT(sum_of_bounds, 10.0 * sum_of_bends);
  }
}

}  // namespace
}  // namespace stickslip::testing
