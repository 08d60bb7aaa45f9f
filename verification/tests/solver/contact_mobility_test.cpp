// SPDX-License-Identifier: MIT
/// The driving-point mobility of a contact at high frequencies and against steps of generalised-alpha. Its order on the mesh:
/// mesh_order_test.cpp.

#include <Eigen/Dense>

#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/contact_mobility.hpp"
#include "stickslip/solver/generalized_alpha.hpp"
#include "support/contact_models.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using Complex = std::complex<double>;

solver::ContactSystem beam_system(int elements, const data::Damping& damping = {}) {
  return solver::beam_contact_system(solver::BeamModel(paper_beam(), elements),
                                     with(paper_problem(25.0, 1e-3), damping));
}

const data::Damping light({.kelvin_voigt = 6.4e-5});

STICKSLIP_VERIFIES(ContactMobility, "X12");
TEST(ContactMobility, IsOfAMassAtHighFrequencies) {
  const solver::ContactSystem system = beam_system(4, light);
  const solver::ContactMobility mobility(system);
  EXPECT_TRUE(
      within(mobility.contact_mass(),
             solver::StickSlipIntegrator(system, {.time_step = 1e-4, .spectral_radius = 0.9}).contact_mass(),
             round_off(20, 10.0, mobility.contact_mass())));
  // Z = m s + c + O(1/s): a tenth of the remainder at ten times s.
  const auto remainder = [&](double s) {
    return std::abs(1.0 / mobility(s) - mobility.contact_mass() * s - mobility.contact_damping());
  };
  EXPECT_TRUE(within(remainder(1e9), 0.1 * remainder(1e8),
                     discretisation(0.1 * remainder(1e8), 0.05, "the next term of the series in 1/s")));
}

STICKSLIP_VERIFIES(SteppedMobility, "X12");
// The sliding velocities at the alpha level after a unit friction force in the first step alone. At |zeta| =
// 1/2 what follows step 80 is below 2^-80.
TEST(SteppedMobility, IsAGeneratingFunction) {
  for (const double spectral_radius : {0.0, 0.5, 0.9, 1.0}) {
    SCOPED_TRACE(spectral_radius);
    for (const data::Damping& damping : {data::Damping(), light}) {
      for (const double h : {1e-5, 1e-4, 1e-3}) {
        const solver::ContactSystem system = beam_system(3, damping);
        const Eigen::MatrixXd mass = system.mass, viscous = system.damping, stiffness = system.slip_stiffness;
        const solver::GeneralizedAlpha method(spectral_radius);
        const Eigen::PartialPivLU<Eigen::MatrixXd> matrix(method.mass_factor() * mass +
                                                          method.damping_factor(h) * viscous +
                                                          method.stiffness_factor(h) * stiffness);
        const Eigen::VectorXd zero = Eigen::VectorXd::Zero(mass.rows());
        solver::Kinematics state{zero, zero, zero}, alpha = state;
        std::vector<double> response;
        for (int n = 0; n < 80; ++n) {
          method.predict(state, h, alpha);
          Eigen::VectorXd residual =
              -mass * alpha.acceleration - viscous * alpha.velocity - stiffness * alpha.displacement;
          if (n == 0) residual[system.contact] += 1.0;
          const Eigen::VectorXd acceleration = matrix.solve(residual);
          response.push_back(alpha.velocity[system.contact] +
                             method.damping_factor(h) * acceleration[system.contact]);
          method.update(state, h, acceleration);
        }
        const solver::ContactMobility mobility(system);
        const double angle = mobility.angular_frequencies().maxCoeff() * h;
        for (const Complex zeta : {Complex(0.5, 0.0), Complex(-0.5, 0.0), std::polar(0.5, 1.0)}) {
          Complex sum = 0.0, size = 0.0;
          for (std::size_t n = response.size(); n-- > 0;) {
            sum = sum * zeta + response[n];
            size = 0.5 * size + std::abs(response[n]);
          }
          // Rounding of the stiffness, 1 + (omega_max h)^2 times the inertia, in each of some ten steps.
          EXPECT_TRUE(within(mobility.discrete(zeta, h, spectral_radius), sum,
                             round_off(64, 1.0 + angle * angle, std::abs(size))));
        }
      }
    }
  }
}

TEST(ContactMobility, HasTheFrequencyOfAMass) {
  for (const double omega : {0.0, 0.5, 3.0}) {
    const solver::ContactMobility mobility(
        contact_system({.mass = 2.0, .stiffness = 2.0 * omega * omega, .normal_force = 1.0}));
    EXPECT_DOUBLE_EQ(mobility.angular_frequencies()[0], omega);
  }
}

TEST(ContactMobility, RefusesWhatItIsNotDefinedFor) {
  solver::ContactSystem system = beam_system(3);
  system.slip_stiffness.coeffRef(0, 0) *= 2.0;
  EXPECT_THROW(solver::ContactMobility{system}, std::invalid_argument);
  system = beam_system(3);
  system.mass *= -1.0;
  EXPECT_THROW(solver::ContactMobility{system}, std::invalid_argument);
  const solver::ContactMobility mobility(beam_system(3));
  EXPECT_THROW((void)mobility.discrete(0.5, 0.0, 0.5), std::invalid_argument);
  EXPECT_THROW((void)mobility.discrete(0.5, 1e-4, 1.5), std::invalid_argument);
}

}  // namespace
}  // namespace stickslip::testing
