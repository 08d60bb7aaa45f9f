// SPDX-License-Identifier: MIT
/// What the location of contact changes is worth: second order with it, first order without.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "stickslip/solver/beam_simulation.hpp"
#include "studies/convergence/convergence.hpp"
#include "support/beams.hpp"
#include "support/contact_models.hpp"
#include "support/order.hpp"
#include "support/parameter_name.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using data::ContactEvent;
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
    EXPECT_EQ(event.change, expected.change) << "event " << i << " at " << expected.time << " s";
    errors.time += std::abs(event.time - expected.time) / static_cast<double>(count);
    errors.position += std::abs(event.position - expected.position) / static_cast<double>(count);
  }
  errors.displacement = (history.displacement - reference.displacement).norm();
  errors.velocity = (history.velocity - reference.velocity).norm();
  return errors;
}

// A change that is taken at the end of its step is late by a time tau between 0 and h. tau is not a smooth function
// of h, and neither are the errors. Runs with neighbouring numbers of steps sample tau: the mean over n of them has
// a standard deviation of 0.58/sqrt(n) of itself (0.89/sqrt(n) for tau^2) for one event, and less for means over
// events.
//
// The error in the motion. Before a late reversal friction has the wrong direction for tau: first order. At a late
// onset the holding force is too large in proportion to tau, for the time tau: tau^2. Before a late capture the
// sliding force acts in place of the holding force, and the impulse that stops the contact makes up for the
// difference: tau^2. So without reversals only the times of the changes are of first order.
constexpr double spread_of_lateness = 0.58, spread_of_its_square = 0.89;

// The reference for a number of steps.
using ReferenceFor = std::function<History(int)>;

template <typename Run>
std::vector<Errors> mean_errors(const std::vector<int>& levels, int neighbours, const ReferenceFor& reference,
                                Run&& run) {
  std::vector<Errors> means;
  for (const int steps : levels) {
    Errors mean;
    for (int i = 0; i < neighbours; ++i) {
      const int count = steps + 1 + 13 * i;
      const Errors errors = errors_of(run(count), reference(count));
      mean.time += errors.time / neighbours;
      mean.position += errors.position / neighbours;
      mean.displacement += errors.displacement / neighbours;
      mean.velocity += errors.velocity / neighbours;
    }
    means.push_back(mean);
  }
  return means;
}

// One of the four errors, with the order and the scatter that are expected of it.
struct Expectation {
  double Errors::*error;
  double order, scatter;
};

template <typename NextTerm>
void expect_orders(const std::vector<Expectation>& expectations, const std::vector<int>& levels,
                   double duration, const std::vector<Errors>& means, NextTerm&& next_term,
                   const Errors& floor) {
  for (const auto& [error, order, scatter] : expectations) {
    std::vector<double> lengths, values;
    for (const int steps : levels) lengths.push_back(duration / steps);
    for (const Errors& mean : means) values.push_back(mean.*error);
    EXPECT_TRUE(order_is(order_levels(lengths, values, next_term, floor.*error, scatter), order));
  }
}

std::vector<Expectation> all_of_order(double order, double scatter) {
  return {{&Errors::time, order, scatter},
          {&Errors::position, order, scatter},
          {&Errors::displacement, order, scatter},
          {&Errors::velocity, order, scatter}};
}

History history_of(StickSlipIntegrator& integrator, int steps) {
  while (integrator.steps() < steps) integrator.step();
  return {integrator.events(), integrator.displacement(), integrator.velocity()};
}

class ContactSchemeOrder : public ::testing::TestWithParam<double> {};

STICKSLIP_VERIFIES(ContactSchemeOrder, "F6");
TEST_P(ContactSchemeOrder, IsOneWithoutLocationForTwoMasses) {
  // 23 changes in 12 s, two of them reversals. Against the located run in the same steps, of second order
  // (ContactHistoryOrder): the smooth error of second order cancels. In the state at the end a single reversal may
  // prevail, whose lateness scatters fully.
  const double duration = 12.0;
  const auto run_with = [&](ContactScheme scheme) {
    return [&, scheme](int steps) {
      StickSlipIntegrator integrator(
          contact_system(ForcedPair{}),
          {.time_step = duration / steps, .spectral_radius = GetParam(), .scheme = scheme});
      integrator.start_stuck(Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero());
      return history_of(integrator, steps);
    };
  };
  const std::vector<int> levels{2000, 4000, 8000, 16000, 32000};
  constexpr int neighbours = 20;
  const auto late =
      mean_errors(levels, neighbours, run_with(ContactScheme::located), run_with(ContactScheme::end_of_step));
  expect_orders(all_of_order(1.0, spread_of_lateness / std::sqrt(neighbours)), levels, duration, late,
                next_term_of_the_pair, {1e-11, 1e-11, 1e-11, 1e-11});
  // A change is late by h/2 on average, and what follows from it moves it as much again.
  EXPECT_LT(late.back().time, duration / levels.back());
  EXPECT_GT(late.back().time, 0.25 * duration / levels.back());
}

INSTANTIATE_TEST_SUITE_P(SpectralRadius, ContactSchemeOrder, ::testing::Values(0.5, 0.9, 1.0),
                         NameOfDouble());

STICKSLIP_VERIFIES(ContactSchemeOrderOfTheBeam, "X9");
TEST(ContactSchemeOrderOfTheBeam, IsOneForUnlocatedTimesElseTwo) {
  // The damped beam of 10 elements through four slips without a reversal, against a run in steps of 0.4 us,
  // whose own error is (1/9.4)^2 of that of the finest level.
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
  const auto reference_for = [&](int) { return reference; };
  const std::vector<int> levels{4000, 8000, 16000, 32000};
  constexpr int neighbours = 10;
  const auto located = mean_errors(levels, 2, reference_for, run_with(ContactScheme::located));
  const double share = std::pow(levels.back() / 300000.0, 2);
  const Errors floor{share * located.back().time, share * located.back().position,
                     share * located.back().displacement, share * located.back().velocity};
  expect_orders(all_of_order(2.0, 0.0), levels, duration, located, next_term_of_the_damped_beam, floor);

  // Times: the mean over seven events. The state hangs on three captures, and on the smooth error besides,
  // which is of second order too.
  const auto late = mean_errors(levels, neighbours, reference_for, run_with(ContactScheme::end_of_step));
  const double of_captures = spread_of_its_square / std::sqrt(3.0 * neighbours);
  expect_orders({{&Errors::time, 1.0, spread_of_lateness / std::sqrt(7.0 * neighbours)},
                 {&Errors::position, 2.0, of_captures},
                 {&Errors::displacement, 2.0, of_captures},
                 {&Errors::velocity, 2.0, of_captures}},
                levels, duration, late, next_term_of_the_damped_beam, floor);
}

}  // namespace
}  // namespace stickslip::testing
