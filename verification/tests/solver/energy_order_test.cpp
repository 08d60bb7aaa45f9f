// SPDX-License-Identifier: MIT
/// The residual of the energy balance: of second order, with the coefficient that method and rule predict.

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/energy_balance.hpp"
#include "studies/common/convergence.hpp"
#include "studies/verification/energy_audit.hpp"
#include "support/beams.hpp"
#include "support/contact_models.hpp"
#include "support/order.hpp"
#include "support/parameter_name.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using solver::EnergyRecorder;
using solver::StickSlipIntegrator;

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
  const data::Case damped{.name = "damped",
                          .beam = paper_beam(),
                          .friction = paper_friction(),
                          .excitation = data::HarmonicExcitation({25.0, 1e-3}),
                          .numerics = data::NumericalSettings(paper_choices(0.5)),
                          .damping = data::Damping({.kelvin_voigt = 6.4e-5})};
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
    // within steps of a change: as for EnergyResidualOfTheBeam.
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
