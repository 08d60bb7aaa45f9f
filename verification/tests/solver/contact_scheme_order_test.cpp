// SPDX-License-Identifier: MIT
/// What the location of contact changes is worth: first order without it.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "stickslip/solver/stick_slip_integrator.hpp"
#include "support/contact_models.hpp"
#include "support/order.hpp"
#include "support/parameter_name.hpp"
#include "support/requirements.hpp"

namespace stickslip::testing {
namespace {

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

}  // namespace
}  // namespace stickslip::testing
