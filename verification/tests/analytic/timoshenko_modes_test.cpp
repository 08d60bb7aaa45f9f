// SPDX-License-Identifier: MIT
/// The stick state of the Timoshenko beam against a spectral discretisation that shares nothing with it, and its limits.

#include <Eigen/Eigenvalues>

#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::TipSupport;
using Values = std::vector<double>;

// A square section of 0.1 m with k = 5/6 and Poisson's ratio 0.3, so that E/(k G) = 3.12.
data::Beam beam_of(double length, double axial_force = 0.0, double axial_direction = 0.0) {
  return data::Beam({.length = length,
                     .area = 0.01,
                     .second_moment_of_area = 1e-4 / 12.0,
                     .density = 1000.0,
                     .youngs_modulus = 2e9,
                     .axial_force = axial_force,
                     .axial_direction = axial_direction,
                     .shear_stiffness = 0.01 * 2e9 / 3.12});
}

const data::Beam slender = beam_of(2.0), stout = beam_of(0.5);

// The same EI and rho A as the slender one, almost without rotary inertia: r^2 = 2e-16.
data::Beam thin(double shear_stiffness, double axial_force = 0.0, double axial_direction = 0.0) {
  return data::Beam({.length = 2.0,
                     .area = 1e10,
                     .second_moment_of_area = 1e-4 / 12.0,
                     .density = 1e-9,
                     .youngs_modulus = 2e9,
                     .axial_force = axial_force,
                     .axial_direction = axial_direction,
                     .shear_stiffness = shear_stiffness});
}

// Legendre's polynomials P_0 ... and their derivatives at x in (-1, 1).
struct Legendre {
  Values value{1.0}, slope{0.0};
  Legendre(int count, double x) {
    for (int k = 1; k < count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      value.push_back(k == 1 ? x : ((2.0 * k - 1.0) * x * value[i - 1] - (k - 1.0) * value[i - 2]) / k);
      slope.push_back((k == 1 ? 0.0 : slope[i - 2]) + (2.0 * k - 1.0) * value[i - 1]);
    }
  }
};

// Rayleigh and Ritz: w = xi (1 - xi)^held sum w_k P_k, phi = xi sum phi_k P_k with `count` terms each, the energies
// int EI phi'^2 + k G A (w' - phi)^2 - P w'^2 and int rho A w^2 + rho I phi^2 by Gauss's rule of 2 count points. Upper bounds.
Values ritz_frequencies(const data::Beam& beam, TipSupport tip, int count) {
  const int points = 2 * count;
  Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(points, points);  // its eigenvalues are Gauss's points
  for (int k = 1; k < points; ++k) jacobi(k, k - 1) = jacobi(k - 1, k) = k / std::sqrt(4.0 * k * k - 1.0);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gauss(jacobi);
  const double length = beam.length(), bending = beam.youngs_modulus() * beam.second_moment_of_area();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * count, 2 * count), mass = stiffness;
  for (int i = 0; i < points; ++i) {
    const double x = gauss.eigenvalues()[i], xi = 0.5 * (1.0 + x);
    const double weight = length * std::pow(gauss.eigenvectors()(0, i), 2);
    const Legendre legendre(count, x);
    Eigen::VectorXd w = Eigen::VectorXd::Zero(2 * count), dw = w, phi = w, dphi = w;
    const double factor = tip == TipSupport::held ? xi * (1.0 - xi) : xi;
    const double slope = tip == TipSupport::held ? 1.0 - 2.0 * xi : 1.0;
    for (int k = 0; k < count; ++k) {
      const double value = legendre.value[static_cast<std::size_t>(k)];
      const double derivative = 2.0 * legendre.slope[static_cast<std::size_t>(k)];
      w[k] = factor * value;
      dw[k] = (slope * value + factor * derivative) / length;
      phi[count + k] = xi * value;
      dphi[count + k] = (value + xi * derivative) / length;
    }
    stiffness += weight * (bending * dphi * dphi.transpose() - beam.axial_force() * dw * dw.transpose() +
                           beam.shear_stiffness() * (dw - phi) * (dw - phi).transpose());
    mass += weight * beam.density() *
            (beam.area() * w * w.transpose() + beam.second_moment_of_area() * phi * phi.transpose());
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(stiffness, mass,
                                                                        Eigen::EigenvaluesOnly);
  Values frequencies;
  for (const double value : eigen.eigenvalues()) frequencies.push_back(std::sqrt(value));
  return frequencies;
}

/// sqrt(k G A/(rho I)), rad/s.
double cutoff_frequency(const data::Beam& beam) {
  return std::sqrt(beam.shear_stiffness() / (beam.density() * beam.second_moment_of_area()));
}

STICKSLIP_VERIFIES(TimoshenkoModes, "A11");
// With the tip held, with axial force of either sign and above the cut-off frequency; with it free, up to there.
TEST(TimoshenkoModes, AreAllOfASpectralMethod) {
  for (const auto& [beam, tip] : {std::pair{slender, TipSupport::free},
                                  {stout, TipSupport::free},
                                  {stout, TipSupport::held},
                                  {beam_of(2.0, 60e3), TipSupport::held},
                                  {beam_of(2.0, -60e3), TipSupport::held},
                                  {beam_of(0.5, 4e5), TipSupport::held}}) {
    const Values ritz = ritz_frequencies(beam, tip, 60), fewer = ritz_frequencies(beam, tip, 56);
    const double cutoff = cutoff_frequency(beam);
    std::size_t count = 0;
    while (ritz[count] < cutoff) ++count;
    ASSERT_GE(count, 3u);
    if (tip == TipSupport::held) {
      count = 30;
    } else {
      EXPECT_THROW((void)analytic::timoshenko_frequencies(beam, tip, static_cast<int>(count) + 1),
                   data::FieldError);
    }
    const Values exact = analytic::timoshenko_frequencies(beam, tip, static_cast<int>(count));
    ASSERT_EQ(exact.size(), count);
    for (std::size_t n = 0; n < exact.size(); ++n) {
      // Round-off of the eigenvalue problem is relative to its largest eigenvalue: half of it in the frequency. What
      // four more terms change is many times what is left.
      const double rounding = 1e-16 * 120.0 * 0.5 * std::pow(ritz.back() / exact[n], 2);
      EXPECT_TRUE(within(exact[n], ritz[n],
                         discretisation((rounding + std::abs(fewer[n] / ritz[n] - 1.0)) * exact[n], 1.0,
                                        "round-off and the difference to fewer terms")))
          << n + 1;
    }
  }
}

TEST(TimoshenkoModes, RefuseWhatHasNoSuchForm) {
  const auto refuses = [](const data::Beam& beam, TipSupport tip, int count) {
    EXPECT_THROW((void)analytic::timoshenko_frequencies(beam, tip, count), data::FieldError);
  };
  refuses(beam_of(2.0, 500.0), TipSupport::free, 1);
  refuses(beam_of(2.0, 90e3), TipSupport::held, 1);
  refuses(thin(0.0), TipSupport::held, 1);
  refuses(slender, TipSupport::held, 0);
  refuses(slender, TipSupport::held, 1001);
  refuses(slender, TipSupport::free, 1000);
  for (const int count : {0, 1001})
    EXPECT_THROW((void)analytic::timoshenko_reaction(slender, count), data::FieldError) << count;
  EXPECT_EQ(analytic::timoshenko_frequencies(slender, TipSupport::held, 1000).size(), 1000U);
  EXPECT_EQ(analytic::timoshenko_reaction(slender, 1000).modes.size(), 1000U);
}

STICKSLIP_VERIFIES(TimoshenkoReaction, "A12");
// Rotary inertia and shear leave (r^2 + s^2) n^2/2 < 1e-12 in the frequencies of twenty modes, and a few times that in the
// shares.
TEST(TimoshenkoReaction, IsEulersWithoutShear) {
  for (const double axial_force : {-3000.0, 0.0, 500.0, 50e3})
    for (const double axial_direction : {0.0, 0.3, 1.0}) {
      const auto rigid = analytic::modal_reaction(thin(0.0, axial_force, axial_direction), 20);
      const data::Beam beam = thin(1e22, axial_force, axial_direction);
      const auto sheared = analytic::timoshenko_reaction(beam, 20);
      EXPECT_TRUE(within(sheared.quasi_static, rigid.quasi_static, round_off(20, 2, rigid.quasi_static)));
      for (std::size_t n = 0; n < 20; ++n) {
        const double exact = rigid.modes[n].coefficient;
        EXPECT_TRUE(within(sheared.modes[n].coefficient, exact,
                           discretisation(1e-12 * exact, 4.0, "(r^2 + s^2) n^2/2")))
            << axial_force << " " << axial_direction << " " << n + 1;
      }
    }
}

// The sum over modes and the steady solution are two formulas of one function: residues at the frequencies and values at rest
// against a value between. 40 modes with the rest as the mean over a circle: 4^-32.
TEST(TimoshenkoReaction, SumsUpToTheSteadyVibration) {
  for (const auto& beam : {beam_of(2.0, 500.0), beam_of(0.5, 4e5, 1.0), beam_of(0.5, -4e5, 0.3)})
    for (const double hz : {3.0, 25.0, 60.0, 700.0}) {
      const double omega = 2.0 * std::numbers::pi * hz;
      const auto reaction = analytic::timoshenko_reaction(beam, 40, omega);
      double sum = reaction.quasi_static, size = std::abs(sum);
      for (const auto& [natural, coefficient] : reaction.modes) {
        const double term = coefficient * omega * omega / ((omega - natural) * (omega + natural));
        sum += term;
        size += std::abs(term);
      }
      EXPECT_TRUE(within(sum, analytic::timoshenko_steady_force(beam, omega), round_off(100, 10, size)))
          << hz;
    }
  const double last = analytic::timoshenko_reaction(slender, 1).modes.back().angular_frequency;
  EXPECT_NO_THROW((void)analytic::timoshenko_reaction(slender, 1, 0.49 * last));
  EXPECT_THROW((void)analytic::timoshenko_reaction(slender, 1, 0.51 * last), data::FieldError);
}

// Of a mode whose share is c, c Omega^3/((omega_n^2 - Omega^2) omega_n) vibrates freely: 1/24 of c at omega_n = 3 and Omega =
// 1. Only the last four modes count, times the number of all.
TEST(TimoshenkoReaction, OmittedPartIsBounded) {
  analytic::ModalReaction reaction{.quasi_static = 1.0, .modes = {{3.0, -2.4}}};
  EXPECT_DOUBLE_EQ(analytic::timoshenko_omitted_transient(reaction, 1.0), 0.1);
  reaction.modes = {{0.5, 1.0}, {3.0, -2.4}, {3.0, 1.2}, {3.0, 0.0}, {3.0, 1.2}};
  EXPECT_DOUBLE_EQ(analytic::timoshenko_omitted_transient(reaction, 1.0), 0.5);
  EXPECT_EQ(analytic::timoshenko_omitted_transient(reaction, 3.0), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace stickslip::testing
