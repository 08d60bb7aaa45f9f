// SPDX-License-Identifier: MIT
/// The stick state of the Timoshenko beam against a spectral discretisation that shares nothing with it, a published
/// table and its limits.

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

double s_squared(const data::Beam& beam) {
  return beam.youngs_modulus() * beam.second_moment_of_area() /
         (beam.shear_stiffness() * beam.length() * beam.length());
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
TEST(TimoshenkoModes, AreAllThoseOfASpectralDiscretisation) {
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

// J. Lee, W. W. Schultz, J. Sound Vib. 269, 609-621 (2004): sqrt(omega L^2 sqrt(rho A/EI)) of the clamped-clamped beam with
// k = 5/6 and Poisson's ratio 0.3. The article was not at hand: the values are quoted, and not checked against it. Half
// of an antisymmetric mode is a clamped-pinned one. Of h/L = 0.2 the last two are above the cut-off frequency.
TEST(TimoshenkoModes, AreThoseOfAPublishedTable) {
  struct Column {
    double height;
    Values printed;  // to six digits
  };
  for (const auto& [height, printed] : {Column{0.1, {7.33122, 12.1454, 16.1487, 19.5723, 22.5735}},
                                        Column{0.2, {6.41794, 9.90372, 12.6402, 13.4567, 14.9383}}}) {
    const data::Beam half({.length = 0.5,
                           .area = height,
                           .second_moment_of_area = std::pow(height, 3) / 12.0,
                           .density = 1.0,
                           .youngs_modulus = 1.0,
                           .axial_force = 0.0,
                           .shear_stiffness = height / 3.12});
    const Values found = analytic::timoshenko_frequencies(half, TipSupport::held, 5);
    for (std::size_t i = 0; i < printed.size(); ++i)
      EXPECT_TRUE(within(std::sqrt(found[i] * std::sqrt(12.0) / height), printed[i],
                         reference(printed[i] < 10.0 ? 1e-5 : 1e-4, "the last printed digit")))
          << height << " " << i;
    EXPECT_EQ(found[3] > cutoff_frequency(half), height == 0.2);
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

// A shear beam, s^2 = 400 and r^2 = 1e-9: the clamp of the sections is lost in rounding, and omega = n pi sqrt(K/(rho A))/L.
TEST(TimoshenkoModes, AreThoseOfAStringWhereShearIsAll) {
  const data::Beam string({.length = 1.0,
                           .area = 1e9,
                           .second_moment_of_area = 1.0,
                           .density = 1e-9,
                           .youngs_modulus = 1.0,
                           .axial_force = 0.0,
                           .shear_stiffness = 1.0 / 400.0});
  const Values found = analytic::timoshenko_frequencies(string, TipSupport::held, 20);
  for (std::size_t n = 0; n < 20; ++n) {
    const double exact = (static_cast<double>(n) + 1.0) * std::numbers::pi / 20.0;
    EXPECT_TRUE(within(found[n], exact, discretisation(exact / 400.0, 1.0, "the bending stiffness, 1/s^2")));
  }
}

STICKSLIP_VERIFIES(TimoshenkoReaction, "A12");
// Rotary inertia and shear leave (r^2 + s^2) n^2/2 < 1e-12 in the frequencies of twenty modes, and a few times that in the
// shares.
TEST(TimoshenkoReaction, IsEulerBernoulliWithoutShear) {
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

// A tip force bends by L^3/(3 EI) and shears by L/(k G A).
TEST(TimoshenkoReaction, IsAtRestThatOfBendingAndShearInSeries) {
  const double length = stout.length();
  const double compliance =
      std::pow(length, 3) / (3.0 * stout.youngs_modulus() * stout.second_moment_of_area()) +
      length / stout.shear_stiffness();
  EXPECT_TRUE(within(analytic::timoshenko_reaction(stout, 1).quasi_static, 1.0 / compliance,
                     round_off(10, 1, 1.0 / compliance)));
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
TEST(TimoshenkoReaction, OmittedPartIsBoundedByTheLastFourModes) {
  analytic::ModalReaction reaction{.quasi_static = 1.0, .modes = {{3.0, -2.4}}};
  EXPECT_DOUBLE_EQ(analytic::timoshenko_omitted_transient(reaction, 1.0), 0.1);
  reaction.modes = {{0.5, 1.0}, {3.0, -2.4}, {3.0, 1.2}, {3.0, 0.0}, {3.0, 1.2}};
  EXPECT_DOUBLE_EQ(analytic::timoshenko_omitted_transient(reaction, 1.0), 0.5);
  EXPECT_EQ(analytic::timoshenko_omitted_transient(reaction, 3.0), std::numeric_limits<double>::infinity());
}

// P_cr = EI/L^2 n^2/(1 + s^2 n^2) with pi < n < 4.4934, which is n without shear; at it the lowest frequency is 0.
TEST(TimoshenkoReaction, EndsAtABucklingLoadThatShearLowers) {
  const double unit = stout.youngs_modulus() * stout.second_moment_of_area() / 0.25, s2 = s_squared(stout);
  const double load = analytic::stick_buckling_load(stout), pi2 = std::pow(std::numbers::pi, 2);
  EXPECT_LT(load, 20.190728557 * unit / (1.0 + 20.190728557 * s2));
  EXPECT_GT(load, pi2 * unit / (1.0 + pi2 * s2));
  const auto first = [](double force) {
    return std::pow(analytic::timoshenko_frequencies(beam_of(0.5, force), TipSupport::held, 1).front(), 2);
  };
  // omega^2 falls almost in a straight line, to 0 at the load.
  EXPECT_TRUE(within(first((1.0 - 1e-6) * load) / first((1.0 - 2e-6) * load), 0.5,
                     discretisation(1e-6, 10.0, "curvature, and rounding over 1e-6")));
}

}  // namespace
}  // namespace stickslip::testing
