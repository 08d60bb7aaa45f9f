// SPDX-License-Identifier: MIT
/// Observed orders in time.

#include "studies/verification/time_order.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "stickslip/solver/stick_slip_integrator.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/discretisation.hpp"
#include "studies/verification/energy_audit.hpp"
#include "support/contact_models.hpp"
#include "support/order.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

class GeneralizedAlphaOrder : public ::testing::TestWithParam<double> {};

// The errors of one quantity of the study against what the method's equations at one frequency predict.
void expect_second_order(const std::vector<double>& steps, const std::vector<double>& errors,
                         const std::vector<double>& predicted, double constant) {
  std::vector<OrderLevel> levels;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    // Samples in steps of omega h = 3 h miss (omega h)^2/8 of the largest error, here and there with half as
    // much again for what is behind; exp(-16) of it has not decayed.
    const double missed = 1.5 * std::pow(3.0 * steps[i], 2) / 8.0 + 2e-7;
    EXPECT_TRUE(
        within(errors[i], predicted[i],
               discretisation(predicted[i] * missed, 1.0, "between two samples the error is larger")));
    const double leading = constant * steps[i] * steps[i];
    // Unit amplitudes; a step solves for accelerations, of which a displacement is the double sum.
    levels.push_back({.step = steps[i],
                      .error = errors[i],
                      .next_term = 1.5 * std::abs(predicted[i] / leading - 1.0) + missed,
                      .floor = round_off(1, 1.0 / std::pow(3.0 * steps[i], 2), 1.0).value});
  }
  EXPECT_TRUE(order_is(levels, 2.0, constant));
}

STICKSLIP_VERIFIES(GeneralizedAlphaOrder, "F5");
TEST_P(GeneralizedAlphaOrder, IsSecondOrderUnderTimeDependentLoad) {
  const studies::TimeOrderStudy study = studies::time_order_study(GetParam(), {50, 100, 200, 400, 800});
  expect_second_order(study.time_step, study.displacement_error, study.predicted_displacement_error,
                      study.displacement_constant);
  expect_second_order(study.time_step, study.velocity_error, study.predicted_velocity_error,
                      study.velocity_constant);
  expect_second_order(study.time_step, study.reaction_error, study.predicted_reaction_error,
                      study.reaction_constant);
  // What the report prints is the slope of just these levels.
  EXPECT_EQ(study.displacement_order.order, observed_order(study.time_step, study.displacement_error));
  EXPECT_EQ(study.velocity_order.order, observed_order(study.time_step, study.velocity_error));
  EXPECT_EQ(study.reaction_order.order, observed_order(study.time_step, study.reaction_error));
}

INSTANTIATE_TEST_SUITE_P(SpectralRadius, GeneralizedAlphaOrder, ::testing::Values(0.0, 0.5, 0.9, 1.0),
                         NameOfDouble());

STICKSLIP_VERIFIES(ContactLocation, "F6");
// m v_t = -N [mu_m + (mu_s - mu_m) exp(-alpha v)] from v0 stops at
// t = m/(N alpha mu_m) ln[(mu_m exp(alpha v0) + mu_s - mu_m)/mu_s].
TEST(ContactLocation, StopUnderExponentialFrictionIsOfSecondOrder) {
  const data::FrictionCoefficients law{.static_coefficient = 0.6, .kinetic_coefficient = 0.3, .decay = 1.5};
  const double normal_force = 10.0, v0 = 2.0;
  const double exact = std::log((0.3 * std::exp(1.5 * v0) + 0.3) / 0.6) / (normal_force * 1.5 * 0.3);
  for (const double radius : {0.5, 1.0}) {
    std::vector<double> steps, errors;
    for (const double h : {0.04, 0.02, 0.01, 0.005, 0.0025}) {
      solver::StickSlipIntegrator slider(contact_system({.normal_force = normal_force, .friction = law}),
                                         {.time_step = h, .spectral_radius = radius});
      slider.start_slipping(scalar(0.0), scalar(v0));
      while (slider.events().empty() && slider.time() < 2.0 * exact) slider.step();
      ASSERT_FALSE(slider.events().empty()) << "still sliding at " << slider.time() << " s";
      steps.push_back(h);
      errors.push_back(std::abs(slider.events().front().time - exact));
    }
    // The next term: the friction force changes at the rate N alpha (mu_s - mu_m)/m = 4.5/s, and the stop
    // splits its step anywhere. The event is found to round-off.
    EXPECT_TRUE(order_is(order_levels(
                             steps, errors, [](double h) { return 4.5 * h; }, round_off(100, 1, exact).value),
                         2.0))
        << radius;
    EXPECT_LT(errors.back(), 1e-5);
  }
}

constexpr double sliding_time = 0.4;

// Velocity of a unit mass after that time, v_t = -N mu(v - w_t), by the classical Runge-Kutta method: 4000
// steps of (4 pi h)^4 < 1e-11 relative error.
double velocity_by_runge_kutta(const data::FrictionLaw& law, double normal_force,
                               const solver::PrescribedMotion& wall, double v0) {
  const auto rate = [&](double t, double v) {
    return -normal_force * solver::friction_coefficient(law, v - wall.velocity(t));
  };
  const int steps = 4000;
  const double h = sliding_time / steps;
  double v = v0;
  for (int n = 0; n < steps; ++n) {
    const double t = n * h;
    const double k1 = rate(t, v), k2 = rate(t + 0.5 * h, v + 0.5 * h * k1);
    const double k3 = rate(t + 0.5 * h, v + 0.5 * h * k2), k4 = rate(t + h, v + h * k3);
    v += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return v;
}

STICKSLIP_VERIFIES(SlipOrder, "F6");
TEST(SlipOrder, IsTwoUnderWeakeningFrictionOnAMovingWall) {
  // The wall's velocity of amplitude 0.24 m/s moves mu - mu_m by a third; the mass always runs ahead of it.
  // 0.4 s are 0.8 of the wall's period: over whole ones the leading errors nearly cancel.
  const data::FrictionCoefficients law{.static_coefficient = 0.6, .kinetic_coefficient = 0.3, .decay = 1.5};
  const double normal_force = 2.0, v0 = 2.0;
  const solver::PrescribedMotion wall = shaken(3.0, 2.0);
  const double exact = velocity_by_runge_kutta(data::FrictionLaw(law), normal_force, wall, v0);
  for (const double radius : {0.0, 0.5, 0.9, 1.0}) {
    std::vector<double> lengths, errors;
    for (const int steps : {100, 200, 400, 800}) {
      solver::StickSlipIntegrator slider(
          contact_system({.normal_force = normal_force, .friction = law}, wall),
          {.time_step = sliding_time / steps, .spectral_radius = radius});
      slider.start_slipping(scalar(0.0), scalar(v0));
      while (slider.steps() < steps) slider.step();
      ASSERT_TRUE(slider.events().empty());
      lengths.push_back(sliding_time / steps);
      errors.push_back(std::abs(slider.velocity()[0] - exact));
    }
    // The next term: omega h with the wall's omega = 4 pi/s. The reference is good to 1e-11 of its change.
    EXPECT_TRUE(order_is(order_levels(
                             lengths, errors, [](double h) { return 12.6 * h; }, 1e-11 * (v0 - exact)),
                         2.0))
        << radius;
  }
}

STICKSLIP_VERIFIES(NumericalOscillation, "F5");
// With d = alpha_f - alpha_m the frequency falls by the share (omega h)^2 (1/12 + 3 d^2/8), and the decay rate is
// omega (omega h)^3 d^3/2. The next terms are (omega h)^2 times numbers up to 2.
TEST(NumericalOscillation, OfAShortStepHasTheLeadingErrorsOfTheory) {
  constexpr double omega = 3.0, angle = 1e-3;
  for (const double radius : {0.0, 0.5, 0.9, 1.0}) {
    const double d = (1.0 - radius) / (1.0 + radius);
    const auto numerical = studies::generalized_alpha_oscillation(radius, omega, angle / omega);
    const double rounding = round_off(10, 1.0 / (angle * angle), 1.0).value;
    EXPECT_TRUE(within((1.0 - numerical.angular_frequency / omega) / (angle * angle),
                       1.0 / 12.0 + 3.0 * d * d / 8.0,
                       discretisation(angle * angle + rounding, 3.0, "next term, and rounding")))
        << radius;
    EXPECT_TRUE(within(numerical.decay_rate / omega / std::pow(angle, 3), std::pow(d, 3) / 2.0,
                       discretisation(angle * angle + rounding, 3.0, "next term, and rounding")))
        << radius;
    for (const double tiny : {1e-160, 1e-12, 1e-8, 1e-6})
      EXPECT_TRUE(within(
          studies::generalized_alpha_oscillation(radius, omega, tiny / omega).angular_frequency, omega,
          discretisation(omega * tiny * tiny + round_off(4, 1, omega).value, 1.0, "error, and rounding")))
          << radius << ' ' << tiny;
  }
}

struct HistoryErrors {
  double time{}, position{}, displacement{}, velocity{};
};

// Largest errors over all events, and those of the state at the end; every event must be there, in its order.
HistoryErrors history_errors(const ForcedPair& pair, const ExactPair& exact, double duration, int steps,
                             double spectral_radius) {
  solver::StickSlipIntegrator integrator(contact_system(pair),
                                         {.time_step = duration / steps, .spectral_radius = spectral_radius});
  integrator.start_stuck(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
  while (integrator.steps() < steps) integrator.step();
  const auto& events = integrator.events();
  HistoryErrors errors;
  EXPECT_EQ(events.size(), exact.events().size());
  for (std::size_t i = 0; i < std::min(events.size(), exact.events().size()); ++i) {
    const data::ContactEvent& expected = exact.events()[i];
    EXPECT_EQ(events[i].change, expected.change) << "event " << i << " at " << expected.time << " s";
    errors.time = largest_or_nan({errors.time, std::abs(events[i].time - expected.time)});
    errors.position = largest_or_nan({errors.position, std::abs(events[i].position - expected.position)});
  }
  errors.displacement = (integrator.displacement() - exact.displacement()).norm();
  errors.velocity = (integrator.velocity() - exact.velocity()).norm();
  return errors;
}

class ContactHistoryOrder : public ::testing::TestWithParam<double> {};

STICKSLIP_VERIFIES(ContactHistoryOrder, "F6");
TEST_P(ContactHistoryOrder, IsTwoThroughOnsetsCapturesAndReversals) {
  // Two coupled, damped masses under a load on a moving wall, with an unsymmetric slip state: 23 events in 12
  // s. The errors are differences to the exact solution, so that an order of 2 leaves no limit but zero.
  const ForcedPair pair;
  const double duration = 12.0;
  ExactPair exact(pair);
  exact.run(duration);
  for (const auto kind :
       {data::ContactChange::onset, data::ContactChange::capture, data::ContactChange::reversal})
    ASSERT_GE(std::count_if(exact.events().begin(), exact.events().end(),
                            [kind](const auto& event) { return event.change == kind; }),
              2);
  std::vector<double> lengths, times, positions, displacements, velocities;
  for (const int steps : {1000, 2000, 4000, 8000}) {
    const HistoryErrors errors = history_errors(pair, exact, duration, steps, GetParam());
    lengths.push_back(duration / steps);
    times.push_back(errors.time);
    positions.push_back(errors.position);
    displacements.push_back(errors.displacement);
    velocities.push_back(errors.velocity);
  }
  // The ends of the exact phases are known to 1e-12 s and less.
  for (const std::vector<double>& errors : {times, positions, displacements, velocities})
    EXPECT_TRUE(order_is(order_levels(lengths, errors, next_term_of_the_pair, 1e-11), 2.0));
}

INSTANTIATE_TEST_SUITE_P(SpectralRadius, ContactHistoryOrder, ::testing::Values(0.0, 0.5, 0.9, 1.0),
                         NameOfDouble());

// --- What the location of contact changes is worth: first order without it

using solver::ContactScheme;
using solver::StickSlipIntegrator;

constexpr double end_time = 12.0;

std::unique_ptr<StickSlipIntegrator> run_of(ContactScheme scheme, double spectral_radius, int steps) {
  auto integrator = std::make_unique<StickSlipIntegrator>(
      contact_system(ForcedPair{}),
      solver::IntegratorSettings{
          .time_step = end_time / steps, .spectral_radius = spectral_radius, .scheme = scheme});
  integrator->start_stuck(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
  while (integrator->steps() < steps) integrator->step();
  return integrator;
}

// Mean differences over all events in time and position, and those of displacement and velocity at the end.
std::array<double, 4> differences(const StickSlipIntegrator& late, const StickSlipIntegrator& located) {
  std::array<double, 4> errors{};
  EXPECT_EQ(late.events().size(), located.events().size());
  const std::size_t count = std::min(late.events().size(), located.events().size());
  for (std::size_t i = 0; i < count; ++i) {
    const data::ContactEvent &event = late.events()[i], &expected = located.events()[i];
    EXPECT_EQ(event.change, expected.change) << "event " << i << " at " << expected.time << " s";
    errors[0] += std::abs(event.time - expected.time) / static_cast<double>(count);
    errors[1] += std::abs(event.position - expected.position) / static_cast<double>(count);
  }
  errors[2] = (late.displacement() - located.displacement()).norm();
  errors[3] = (late.velocity() - located.velocity()).norm();
  return errors;
}

class ContactSchemeOrder : public ::testing::TestWithParam<double> {};

STICKSLIP_VERIFIES(ContactSchemeOrder, "F6");
// A change that is taken at the end of its step is late by a time between 0 and h, which is not a smooth function of h.
// Runs with neighbouring numbers of steps sample it: the mean over n of them has a standard deviation of 0.58/sqrt(n)
// of itself. Before a late reversal friction has the wrong direction for that time: first order. The other changes
// leave second order in the motion.
TEST_P(ContactSchemeOrder, IsOneWithoutLocationForTwoMasses) {
  // 23 changes in 12 s, two of them reversals. Against the located run in the same steps, of second order
  // (ContactHistoryOrder): the smooth error of second order cancels. In the state at the end a single reversal may
  // prevail, whose lateness scatters fully.
  const std::vector<int> levels{2000, 4000, 8000, 16000};
  constexpr int neighbours = 20;
  std::vector<double> lengths;
  std::array<std::vector<double>, 4> means;
  for (const int level : levels) {
    lengths.push_back(end_time / level);
    for (auto& mean : means) mean.push_back(0.0);
    for (int i = 0; i < neighbours; ++i) {
      const int steps = level + 1 + 13 * i;
      const auto errors = differences(*run_of(ContactScheme::end_of_step, GetParam(), steps),
                                      *run_of(ContactScheme::located, GetParam(), steps));
      for (std::size_t k = 0; k < errors.size(); ++k) means[k].back() += errors[k] / neighbours;
    }
  }
  for (const auto& mean : means)
    EXPECT_TRUE(order_is(
        order_levels(lengths, mean, next_term_of_the_pair, 1e-11, 0.58 / std::sqrt(neighbours)), 1.0));
  // A change is late by h/2 on average, and what follows from it moves it as much again.
  EXPECT_LT(means[0].back(), lengths.back());
  EXPECT_GT(means[0].back(), 0.25 * lengths.back());
}

INSTANTIATE_TEST_SUITE_P(SpectralRadius, ContactSchemeOrder, ::testing::Values(0.5, 0.9, 1.0),
                         NameOfDouble());

// --- The residual of the energy balance

using solver::EnergyRecorder;

// The residual over h^2 as h goes to zero, along the exact motion of a ForcedPair.
//
// Generalised-alpha. With d = alpha_f - alpha_m, what the method computes solves, up to h^4, in each phase
//
//     q_t = v + h^2 k_1 v_tt,   M v_t = f + h^2 (k_2 M v_ttt - k_3 F_tt),
//     k_1 = 1/12 + d^2/4,   k_2 = 1/12 + d^2/2,   k_3 = alpha_f (1 - alpha_f)/2,
//
// f the balance and F its load (Taylor series of the four equations of the method; the coefficients are those
// of the trapezoidal rule and of the midpoint load at d = 0). Along it the energy changes by h^2 times
// int (K q).k_1 v_tt + (M v).(k_2 v_ttt - k_3 M^-1 F_tt) dt more than the powers say.
//
// Rule. The trapezoidal rule adds h^2/12 [P_t] of each phase to the works, P = dE/dt; the mean velocity takes
// h^2/4 int a.C a off the damping loss.
//
// Restarts. The method's acceleration belongs to d h before its time. A restart at the time itself, or a step
// of another length, is off by d h a_t, and so is v by d^2/2 h^2 a_t once that has decayed. A change that
// splits a step as theta : 1 - theta moves v by d^2/2 h^2 [(1 - tau) a_t after it - tau a_t before it] with
// tau = theta (1 - theta)/(1 - alpha_m), 1/(6 (1 - alpha_m)) on average.
class ResidualPrediction {
 public:
  ResidualPrediction(const ForcedPair& pair, double spectral_radius, double duration)
      : pair_(pair), method_(spectral_radius) {
    ExactPair(pair).run(duration, [this](const ExactPair& now) { visit(now); });
    end_phase();
  }

  [[nodiscard]] double coefficient() const { return coefficient_; }
  /// How far the tau of all changes can move it from their average.
  [[nodiscard]] double scatter() const { return scatter_; }

 private:
  struct Sample {
    double time{};
    double density{};     // of the integral over a phase
    double power_rate{};  // P_t = d^2 E/dt^2
    double restart{};     // d^2/2 times the power of a_t as a velocity
  };

  void visit(const ExactPair& now) {
    const Sample sample = sample_of(now);
    if (!last_) {
      begin_phase(sample, 0.0);
    } else if (sample.time == last_->time) {
      const double mean_tau = 1.0 / (6.0 * (1.0 - method_.alpha_m()));
      coefficient_ -= mean_tau * last_->restart;
      scatter_ += mean_tau * (std::abs(last_->restart) + std::abs(sample.restart));
      end_phase();
      begin_phase(sample, mean_tau);
    } else {
      coefficient_ += 0.5 * (sample.time - last_->time) * (last_->density + sample.density);
    }
    last_ = sample;
  }

  void begin_phase(const Sample& sample, double tau) {
    phase_start_power_rate_ = sample.power_rate;
    coefficient_ += (1.0 - tau) * sample.restart;
  }

  void end_phase() { coefficient_ -= (last_->power_rate - phase_start_power_rate_) / 12.0; }

  [[nodiscard]] Sample sample_of(const ExactPair& now) const {
    const double d = method_.alpha_f() - method_.alpha_m();
    const double k_1 = 1.0 / 12.0 + d * d / 4.0, k_2 = 1.0 / 12.0 + d * d / 2.0;
    const double k_3 = 0.5 * method_.alpha_f() * (1.0 - method_.alpha_f());
    const Eigen::Vector2d v = now.velocity(), a = now.velocity_derivative(1);
    const Eigen::Vector2d spring = pair_.stick_stiffness * now.displacement(), momentum = pair_.mass * v;
    Eigen::Vector2d v_tt = now.velocity_derivative(2), v_ttt = now.velocity_derivative(3);
    Eigen::Vector2d load_tt = -pair_.omega * pair_.omega * std::sin(pair_.omega * now.time()) * pair_.load;

    Sample sample{.time = now.time()};
    sample.power_rate =
        v.dot(pair_.stick_stiffness * v) + a.dot(spring) + a.dot(pair_.mass * a) + momentum.dot(v_tt);
    sample.density = -0.25 * a.dot(pair_.damping * a);
    if (now.stuck()) {
      // The first mass alone is integrated, less the static shape sigma of the wall's motion, whose inertia
      // and damping belong to the load; the contact is exact.
      const Eigen::Vector2d sigma(-pair_.stick_stiffness(0, 1) / pair_.stick_stiffness(0, 0), 1.0);
      load_tt -= v_ttt[1] * pair_.mass * sigma + v_tt[1] * pair_.damping * sigma;
      const Eigen::Vector2d free(1.0, 0.0);
      v_tt = (v_tt - v_tt[1] * sigma).cwiseProduct(free);
      v_ttt = (v_ttt - v_ttt[1] * sigma).cwiseProduct(free);
      load_tt = load_tt[0] / pair_.mass(0, 0) * free;
    } else {
      load_tt = pair_.mass.inverse() * load_tt;
    }
    sample.density += k_1 * spring.dot(v_tt) + momentum.dot(k_2 * v_ttt - k_3 * load_tt);
    sample.restart = 0.5 * d * d * momentum.dot(v_tt);
    return sample;
  }

  ForcedPair pair_;
  solver::GeneralizedAlpha method_;
  std::optional<Sample> last_;
  double phase_start_power_rate_{};
  double coefficient_{}, scatter_{};
};

double residual(const ForcedPair& pair, double duration, int steps, double spectral_radius) {
  StickSlipIntegrator integrator(contact_system(pair),
                                 {.time_step = duration / steps, .spectral_radius = spectral_radius});
  integrator.start_stuck(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
  EnergyRecorder recorder(integrator);
  integrator.observe([&recorder](const StickSlipIntegrator& now) { recorder.record(now); });
  while (integrator.steps() < steps) integrator.step();
  return recorder.balance().residual();
}

class EnergyResidual : public ::testing::TestWithParam<double> {};

STICKSLIP_VERIFIES(EnergyResidual, "F8");
TEST_P(EnergyResidual, IsOfSecondOrderThroughAllChanges) {
  const ForcedPair pair;
  const double duration = 12.0;
  const ResidualPrediction prediction(pair, GetParam(), duration);
  const double coefficient = std::abs(prediction.coefficient());
  std::vector<OrderLevel> levels;
  for (const int steps : {2000, 4000, 8000, 16000}) {
    const double h = duration / steps;
    const double balance = residual(pair, duration, steps, GetParam());
    EXPECT_GT(balance * prediction.coefficient(), 0.0);
    // Where the changes split the steps does not tend to anything with h.
    levels.push_back({.step = h,
                      .error = std::abs(balance),
                      .next_term = next_term_of_the_pair(h) + prediction.scatter() / coefficient,
                      .floor = round_off(steps, 1, pair.friction_limit()).value});
  }
  EXPECT_TRUE(order_is(levels, 2.0, coefficient));
}

INSTANTIATE_TEST_SUITE_P(SpectralRadius, EnergyResidual, ::testing::Values(0.0, 0.5, 0.9, 1.0),
                         NameOfDouble());

STICKSLIP_VERIFIES(EnergyAudit, "F8");
TEST(EnergyAudit, KeepsOneEventDrivenRunBesideEveryMesh) {
  const data::Case damped = damped_problem(25.0);
  const std::vector<double> steps{5e-6, 2.5e-6, 1.25e-6};
  const auto audit = studies::energy_audit(damped, 0.12, {6, 10}, 14, steps);
  EXPECT_EQ(audit.time_step, steps);
  EXPECT_EQ(audit.kelvin_voigt, 6.4e-5);
  EXPECT_EQ(audit.modes, 14);
  ASSERT_EQ(audit.meshes.size(), 2u);

  // Each mesh has the balance that it has alone, and the event-driven run does not know of the meshes.
  const auto alone = studies::energy_audit(damped, 0.12, {10}, 14, steps);
  EXPECT_EQ(alone.meshes.front().elements, audit.meshes.back().elements);
  EXPECT_EQ(alone.event_driven.base_work, audit.event_driven.base_work);
  for (std::size_t i = 0; i < steps.size(); ++i)
    EXPECT_EQ(alone.meshes.front().stepped[i].residual(), audit.meshes.back().stepped[i].residual());

  // 1e-12 a step of the state, in each of a few thousand, of the turnover of the balance.
  const analytic::EventDrivenEnergy& exact = audit.event_driven;
  EXPECT_TRUE(within(audit.event_driven_residual(), 0.0,
                     discretisation(1e-12 * 1e4 * exact.base_work, 1.0, "tolerance of the integrator")));
  for (const auto& mesh : audit.meshes) {
    // The next term is omega h = 0.15 of the first for the highest mode of 10 elements, which is damped away
    // within steps of a change: as for EnergyResidual.
    EXPECT_TRUE(within(mesh.observed_order.order, 2.0, discretisation(0.1, 1.0, "next term omega h")))
        << mesh.elements;
    EXPECT_EQ(mesh.observed_order.levels, 3);
    ASSERT_EQ(mesh.stepped.size(), steps.size());
    // What a mesh costs: (beta l)^4/720 of the stiffness of the waves that matter, beta l = 10.2/6 of mode 3.
    const double cost = std::pow(10.2 / mesh.elements, 4) / 720.0;
    EXPECT_TRUE(within(mesh.stepped.back().friction_loss, exact.friction_loss,
                       discretisation(cost * exact.friction_loss, 2.0, "mode 3 on the mesh")));
    EXPECT_TRUE(within(mesh.stepped.back().base_work, exact.base_work,
                       discretisation(cost * exact.base_work, 2.0, "mode 3 on the mesh")));
  }
}

}  // namespace
}  // namespace stickslip::testing
