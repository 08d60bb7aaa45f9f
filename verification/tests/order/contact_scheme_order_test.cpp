/// What the location of contact changes is worth: second order with it, first order without.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/studies/convergence.hpp"
#include "support/beams.hpp"
#include "support/exact_pair.hpp"
#include "support/parameter_name.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using solver::ContactEvent;
using solver::ContactScheme;
using solver::StickSlipIntegrator;

struct History {
  std::vector<ContactEvent> events;
  Eigen::VectorXd displacement, velocity;  // at the end
};

// Mean errors over all events, and those of the state at the end.
struct Errors {
  double time{}, position{}, displacement{}, velocity{};
};

Errors errors_of(const History& history, const History& reference) {
  Errors errors;
  EXPECT_EQ(history.events.size(), reference.events.size());
  const std::size_t count = std::min(history.events.size(), reference.events.size());
  for (std::size_t i = 0; i < count; ++i) {
    const ContactEvent &event = history.events[i], &expected = reference.events[i];
    EXPECT_EQ(event.kind, expected.kind) << "event " << i << " at " << expected.time << " s";
    errors.time += std::abs(event.time - expected.time) / static_cast<double>(count);
    errors.position += std::abs(event.displacement - expected.displacement) / static_cast<double>(count);
  }
  errors.displacement = (history.displacement - reference.displacement).norm();
  errors.velocity = (history.velocity - reference.velocity).norm();
  return errors;
}

// A change taken at the end of its step is late by a part tau of h that jumps about in (0, h) with h: the
// errors are not smooth in h. Neighbouring numbers of steps sample tau; the mean of tau then has a standard
// deviation of 0.58/sqrt(10) = 0.18 of itself (0.89/sqrt(10) = 0.28 for tau^2) for a single event, and the
// slope over levels a factor of 16 apart one of 0.18 sqrt(2)/ln 16 = 0.09; less for means over events.
//
// What being late costs. After a late reversal friction has pushed the wrong way for tau: an error of first
// order. A late onset lets the contact off a force that is tau too large, but has not moved yet: tau^2. A
// late capture has had the sliding force for the holding force, and the impulse that stops the contact makes
// up for just that: tau^2 too. So without reversals only the times of the changes are of first order.
constexpr int neighbours = 10;

template <typename Run>
std::vector<Errors> mean_errors(const std::vector<int>& levels, const History& reference, Run&& run) {
  std::vector<Errors> means;
  for (const int steps : levels) {
    Errors mean;
    for (int i = 0; i < neighbours; ++i) {
      const Errors errors = errors_of(run(steps + 1 + 13 * i), reference);
      mean.time += errors.time / neighbours;
      mean.position += errors.position / neighbours;
      mean.displacement += errors.displacement / neighbours;
      mean.velocity += errors.velocity / neighbours;
    }
    means.push_back(mean);
  }
  return means;
}

double order_of(double Errors::*error, const std::vector<int>& levels, const std::vector<Errors>& means) {
  std::vector<double> lengths, values;
  for (const int steps : levels) lengths.push_back(1.0 / steps);
  for (const Errors& mean : means) values.push_back(mean.*error);
  return studies::observed_order(lengths, values);
}

struct Orders {
  double time{}, state{};
};

void expect_orders(const Orders& expected, double margin, const std::vector<int>& levels,
                   const std::vector<Errors>& means) {
  EXPECT_TRUE(within(order_of(&Errors::time, levels, means), expected.time, next_terms(margin)));
  EXPECT_TRUE(within(order_of(&Errors::position, levels, means), expected.state, next_terms(margin)));
  EXPECT_TRUE(within(order_of(&Errors::displacement, levels, means), expected.state, next_terms(margin)));
  EXPECT_TRUE(within(order_of(&Errors::velocity, levels, means), expected.state, next_terms(margin)));
}

History history_of(StickSlipIntegrator& integrator, int steps) {
  while (integrator.steps() < steps) integrator.step();
  return {integrator.events(), integrator.displacement(), integrator.velocity()};
}

class ContactSchemeOrder : public ::testing::TestWithParam<double> {};

TEST_P(ContactSchemeOrder, IsOneWithoutLocationAndTwoWithItForTwoMasses) {
  // 23 changes in 12 s, two of them reversals. From 3000 steps on the errors of second order are small.
  const ForcedPair pair;
  const double duration = 12.0;
  ExactPair exact(pair);
  exact.run(duration);
  const History reference{exact.events(), exact.displacement(), exact.velocity()};
  const auto run_with = [&](ContactScheme scheme) {
    return [&, scheme](int steps) {
      StickSlipIntegrator integrator(
          contact_system(pair),
          {.time_step = duration / steps, .spectral_radius = GetParam(), .scheme = scheme});
      integrator.start_stuck(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
      return history_of(integrator, steps);
    };
  };
  const std::vector<int> levels{3000, 6000, 12000, 24000, 48000};
  const auto late = mean_errors(levels, reference, run_with(ContactScheme::end_of_step));
  expect_orders({1.0, 1.0}, 0.2, levels, late);
  // A change is late by h/2 on average, and what follows from it moves it as much again.
  EXPECT_LT(late.back().time, duration / levels.back());
  EXPECT_GT(late.back().time, 0.25 * duration / levels.back());

  const std::vector<int> few{3000, 6000};
  expect_orders({2.0, 2.0}, 0.06, few, mean_errors(few, reference, run_with(ContactScheme::located)));
}

INSTANTIATE_TEST_SUITE_P(SpectralRadius, ContactSchemeOrder, ::testing::Values(0.5, 0.9, 1.0),
                         NameOfDouble());

TEST(ContactSchemeOrderOfTheBeam, IsOneForTheTimesWithoutLocationAndTwoForAllElse) {
  // The damped beam of 10 elements through four slips without a reversal, against a run in steps of 0.4 us,
  // whose own error is (1/10)^2 of that of the finest level. Over levels a factor of 4 apart the mean over
  // seven events has a slope with a standard deviation of 0.18 sqrt(2)/sqrt(7)/ln 4 = 0.07; the state hangs
  // on three captures, 0.28 sqrt(2)/sqrt(3)/ln 4 = 0.16, but more on the smooth error of the method.
  const double duration = 0.12;
  const solver::BeamModel model(paper_beam(), 10);
  const auto base = solver::harmonic_motion(data::HarmonicExcitation({25.0, 1e-3}));
  const solver::ContactSystem system =
      solver::beam_contact_system(model, paper_friction(), base, data::Damping({.kelvin_voigt = 6.4e-5}));
  const auto run_with = [&](ContactScheme scheme) {
    return [&, scheme](int steps) {
      StickSlipIntegrator integrator(
          system, {.time_step = duration / steps, .spectral_radius = 0.9, .scheme = scheme});
      integrator.start_stuck(Eigen::VectorXd::Zero(model.degrees_of_freedom()),
                             -base.velocity(0.0) * model.unit_tip_deflection());
      return history_of(integrator, steps);
    };
  };
  const History reference = run_with(ContactScheme::located)(300000);
  ASSERT_EQ(reference.events.size(), 7u);
  const std::vector<int> levels{8000, 16000, 32000};
  const auto late = mean_errors(levels, reference, run_with(ContactScheme::end_of_step));
  expect_orders({1.0, 2.0}, 0.2, levels, late);
  const auto located = mean_errors(levels, reference, run_with(ContactScheme::located));
  expect_orders({2.0, 2.0}, 0.05, levels, located);
}

}  // namespace
}  // namespace stickslip::testing
