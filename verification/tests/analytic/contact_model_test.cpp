// SPDX-License-Identifier: MIT
/// The beam as a ContactModel: the same as of a mesh, and its damping.

#include <Eigen/Dense>

#include "stickslip/analytic/held_beam.hpp"
#include "studies/verification/finite_element_contact_model.hpp"
#include "support/random_beams.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::HeldStructure;

constexpr double mass_per_length = 10.0;         // rho A, kg/m
constexpr double bending_stiffness = 5e4 / 3.0;  // EI, N m^2
constexpr double length = 2.0;

HeldStructure held_beam(int modes, const data::DampingProperties& damping = {}, double axial_force = 500.0) {
  return analytic::HeldBeam(paper_beam_with_axial_force(axial_force), data::Damping(damping), modes)
      .structure();
}

Eigen::MatrixXd dense(const analytic::Matrix& matrix) {
  Eigen::MatrixXd result(matrix.rows(), matrix.columns());
  for (std::size_t i = 0; i < matrix.rows(); ++i)
    for (std::size_t j = 0; j < matrix.columns(); ++j)
      result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = matrix(i, j);
  return result;
}

/// Of the clamped-free beam without axial force, rad/s.
double cantilever_frequency(std::size_t mode) {
  const double b = std::array{1.875104068711961, 4.694091132974175, 7.854757438237613}[mode];
  return b * b * std::sqrt(bending_stiffness / mass_per_length) / (length * length);
}

/// Kinetic energy is x_t . M x_t/2, x = (T, u_L).
Eigen::MatrixXd mass_matrix(const HeldStructure& model) {
  const auto m = static_cast<Eigen::Index>(model.modes());
  Eigen::MatrixXd mass = Eigen::MatrixXd::Identity(m + 1, m + 1);
  for (Eigen::Index n = 0; n < m; ++n)
    mass(n, m) = mass(m, n) = model.mass_coupling[static_cast<std::size_t>(n)];
  mass(m, m) = model.contact_mass;
  return mass;
}

STICKSLIP_VERIFIES(HeldBeam, "D2");
// Its first modes against the reduction of matrices of finite elements, which shares nothing with them: (beta l)^4/720 of mode 4 on 40
// elements in the energies, with a margin for the couplings, and the more the nearer P is to buckling.
TEST(HeldBeam, IsTheLimitOfMeshes) {
  on_random_beams(6, compression, [](const data::Beam& drawn, RandomNumbers& numbers) {
    data::BeamProperties properties = drawn.properties();
    properties.axial_direction = numbers.uniform(0.0, 1.0);
    const double unit = frequency_unit(drawn);
    const data::Case problem =
        random_problem(numbers, data::Beam(properties), 0.5,
                       {.frequency_hz = unit * numbers.uniform(0.1, 10.0), .amplitude = 1e-3},
                       numbers.log_uniform(1e-4, 1e-2) / unit);
    const analytic::ContactModel closed = analytic::contact_model(problem, 4),
                                 mesh = studies::finite_element_contact_model(problem, 40);
    const double error = std::pow(13.4 / 40.0, 4) / 720.0 * nearness_of_buckling(problem.beam());
    const auto expect = [error](double value, double expected, double scale) {
      EXPECT_TRUE(within(value, expected, discretisation(error * scale, 10.0, "(beta l)^4/720")));
    };
    const double mass = closed.contact_mass, force = closed.load.back(),
                 stiffness = 3.0 * rigidity(problem.beam()) / std::pow(problem.beam().length(), 3);
    expect(mesh.contact_mass, mass, mass);
    expect(mesh.contact_stiffness, closed.contact_stiffness, stiffness);
    expect(mesh.contact_follower, closed.contact_follower, stiffness);
    expect(mesh.load.back(), force, force);
    expect(mesh.damping(mesh.modes(), mesh.modes()), closed.damping(4, 4), closed.damping(4, 4));
    EXPECT_EQ(mesh.wall_amplitude, closed.wall_amplitude);
    for (std::size_t n = 0; n < 4; ++n) {
      // The sign of a mode is anyone's choice.
      const double sign = std::copysign(1.0, mesh.mass_coupling[n] * closed.mass_coupling[n]);
      const double omega = closed.angular_frequency[n], own = closed.damping(n, n);
      expect(mesh.angular_frequency[n], omega, omega);
      expect(sign * mesh.mass_coupling[n], closed.mass_coupling[n], std::sqrt(mass));
      expect(sign * mesh.follower[n], closed.follower[n], omega * std::sqrt(stiffness));
      expect(sign * mesh.load[n], closed.load[n], force / std::sqrt(mass));
      expect(sign * mesh.damping(n, mesh.modes()), closed.damping(n, 4),
             std::sqrt(own * closed.damping(4, 4)));
      for (std::size_t k = 0; k < 4; ++k)
        expect(std::abs(mesh.damping(n, k)), std::abs(closed.damping(n, k)),
               std::sqrt(own * closed.damping(k, k)));
    }
  });
}

TEST(HeldBeam, DampsEveryFreeMode) {
  // C = sum 2 zeta omega (M x)(M x)^T over x . M x = 1, K x = omega^2 M x is the one symmetric positive
  // matrix with C M^-1 C = 4 zeta^2 K, K the bending stiffness alone.
  const double ratio = 0.02;
  const int modes = 8;
  const HeldStructure model = held_beam(modes, {.ratio = ratio});
  const Eigen::MatrixXd damping = dense(model.damping), mass = mass_matrix(model);
  const Eigen::MatrixXd bending = dense(held_beam(modes, {.kelvin_voigt = 1.0}).damping);
  const Eigen::MatrixXd error = damping * mass.llt().solve(damping) - 4.0 * ratio * ratio * bending;
  // M has the condition number 1/(m_c - a . a) ~ 1e2.
  for (Eigen::Index i = 0; i <= modes; ++i)
    for (Eigen::Index j = 0; j <= modes; ++j)
      EXPECT_TRUE(
          within(error(i, j), 0.0, round_off(9, 100, 4.0 * ratio * ratio * bending.diagonal().maxCoeff())));
  EXPECT_LT((damping - damping.transpose()).cwiseAbs().maxCoeff(),
            round_off(9, 1, damping.cwiseAbs().maxCoeff()).value);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(damping, mass);
  EXPECT_GT(eigen.eigenvalues().minCoeff(), 0.0);
  // The Galerkin frequencies are too high, by a relative error that falls as N^-5 (or, since sigma is the
  // static shape at P and not at 0, as P N^-3 with P L^2/EI = 0.12).
  for (std::size_t i = 0; i < 3; ++i) {
    const double expected = 2.0 * ratio * cantilever_frequency(i);
    EXPECT_TRUE(within(eigen.eigenvalues()[static_cast<Eigen::Index>(i)], expected,
                       discretisation(expected * 0.12 / 512.0, 1.0, "P L^2/EI N^-3")));
  }
}

TEST(HeldBeam, KindsOfDampingAdd) {
  const auto damping = [](const data::DampingProperties& properties) {
    return dense(held_beam(5, properties).damping);
  };
  const Eigen::MatrixXd all = damping({.kelvin_voigt = 1e-4, .ratio = 0.01, .mass_proportional = 3.0});
  const Eigen::MatrixXd sum =
      damping({.kelvin_voigt = 1e-4}) + damping({.ratio = 0.01}) + 3.0 * mass_matrix(held_beam(5));
  EXPECT_LT((all - sum).cwiseAbs().maxCoeff(), round_off(4, 1, sum.cwiseAbs().maxCoeff()).value);
  EXPECT_TRUE(held_beam(5).damping.empty());
}

TEST(HeldBeam, RefusesABuckledBeam) {
  for (const double axial_force : {-100.0, 0.0, 85e3}) {
    SCOPED_TRACE(axial_force);
    expect_error_message<data::InputError>([&] { (void)held_beam(5, {}, axial_force); },
                                           {"beam.axial_force"});
  }
  EXPECT_THROW(held_beam(0), std::invalid_argument);
}

}  // namespace
}  // namespace stickslip::testing
