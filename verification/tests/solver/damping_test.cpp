// SPDX-License-Identifier: MIT
/// The damping matrix of the beam, and what it does to a free vibration.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

#include "stickslip/solver/beam_simulation.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/common/convergence.hpp"
#include "support/beams.hpp"
#include "support/contact_models.hpp"
#include "support/error_message.hpp"
#include "support/mesh.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

data::Damping kelvin_voigt(double eta) { return data::Damping({.kelvin_voigt = eta}); }
data::Damping of_critical(double ratio) { return data::Damping({.ratio = ratio}); }

STICKSLIP_VERIFIES(DampingMatrix, "F9");
TEST(DampingMatrix, IsEmptyWithoutDamping) {
  EXPECT_EQ(solver::damping_matrix(solver::BeamModel(paper_beam(), 5), {}).nonZeros(), 0);
}

TEST(DampingMatrix, KelvinVoigtIgnoresTheAxialForce) {
  const Eigen::MatrixXd strained =
      solver::damping_matrix(solver::BeamModel(paper_beam_with_axial_force(4e4), 5), kelvin_voigt(6.4e-5));
  const Eigen::MatrixXd unloaded = solver::BeamModel(paper_beam_with_axial_force(0.0), 5).stick_stiffness();
  EXPECT_EQ((strained - 6.4e-5 * unloaded).cwiseAbs().maxCoeff(), 0.0);
}

TEST(DampingMatrix, ModalDampingIgnoresTheAxialForce) {
  const Eigen::MatrixXd loaded =
      solver::damping_matrix(solver::BeamModel(paper_beam_with_axial_force(4e4), 5), of_critical(0.02));
  const Eigen::MatrixXd unloaded =
      solver::damping_matrix(solver::BeamModel(paper_beam_with_axial_force(0.0), 5), of_critical(0.02));
  EXPECT_EQ((loaded - unloaded).cwiseAbs().maxCoeff(), 0.0);
  EXPECT_LE((loaded - loaded.transpose()).cwiseAbs().maxCoeff(),
            round_off(20, 1, loaded.cwiseAbs().maxCoeff()).value);
}

// Round-off: the matrix is accurate to eps omega_max for every mode. The modes, from an unsymmetric eigenproblem for
// 1/omega^2, are accurate to eps omega_n^2/omega_1^2.
TEST(DampingMatrix, ModalDampingHasTheRatioInEveryFreeTipMode) {
  constexpr double zeta = 0.02;
  const solver::BeamModel model(paper_beam_with_axial_force(0.0), 10);
  const Eigen::MatrixXd damping = solver::damping_matrix(model, of_critical(zeta));
  const auto modes = solver::slip_modes(model, 20);
  const double lowest = modes.front().angular_frequency, highest = modes.back().angular_frequency;
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const double omega = modes[i].angular_frequency;
      EXPECT_TRUE(within(modes[i].shape.dot(damping * modes[j].shape), i == j ? 2.0 * zeta * omega : 0.0,
                         round_off(20, 1, 2.0 * zeta * (highest + omega * std::pow(omega / lowest, 2)))))
          << "modes " << i + 1 << ", " << j + 1;
    }
}

TEST(DampingMatrix, OfARatioKeepsTheLowestModeOnAFineMesh) {
  // Round-off of singular values is relative to omega_max/omega_1 = 26 n^2, here 2.7e5; an eigenproblem of
  // squares would lose its square, 7e10. The frequency of the model itself is known to eps/l^4.
  constexpr double zeta = 0.05;
  const solver::BeamModel model(paper_beam_with_axial_force(0.0), 100);
  const auto mode = solver::slip_modes(model, 1).front();
  const Eigen::VectorXd force = solver::damping_matrix(model, of_critical(zeta)) * mode.shape;
  EXPECT_TRUE(within(mode.shape.dot(force), 2.0 * zeta * mode.angular_frequency,
                     round_off(1, std::pow(100.0, 4), 2.0 * zeta * mode.angular_frequency)));
}

TEST(DampingMatrix, IsTheSumOfBothKinds) {
  const solver::BeamModel model(paper_beam(), 5);
  const Eigen::MatrixXd sum =
      solver::damping_matrix(model, data::Damping({.kelvin_voigt = 6.4e-5, .ratio = 0.02}));
  const Eigen::MatrixXd parts = Eigen::MatrixXd(solver::damping_matrix(model, kelvin_voigt(6.4e-5))) +
                                Eigen::MatrixXd(solver::damping_matrix(model, of_critical(0.02)));
  EXPECT_EQ((sum - parts).cwiseAbs().maxCoeff(), 0.0);
}

TEST(DampingMatrix, OfARatioRefusesMoreThan500Elements) {
  EXPECT_NO_THROW((void)solver::damping_matrix(solver::BeamModel(paper_beam(), 501), kelvin_voigt(1e-5)));
  EXPECT_EQ(
      error_message_of<std::invalid_argument>(
          [] { (void)solver::damping_matrix(solver::BeamModel(paper_beam(), 501), of_critical(0.01)); }),
      "numerics.elements is 501, but must be at most 500 with a damping.ratio above 0, whose matrix is full");
}

}  // namespace
}  // namespace stickslip::testing
