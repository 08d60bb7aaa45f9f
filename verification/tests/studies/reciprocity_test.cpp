// SPDX-License-Identifier: MIT
/// Betti's reciprocity of random beams: kept in stick, and lost in slip by what the follower force does.

#include <Eigen/Dense>

#include "stickslip/analytic/beam_contact_model.hpp"
#include "stickslip/analytic/free_mode_run.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "support/measurements.hpp"
#include "support/mesh.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::StickMode;
using solver::BeamModel;
using std::numbers::pi;

// Reciprocity (Betti).

/// (K - omega^2 M)^-1.
Eigen::MatrixXd flexibility(const BeamModel& model, const solver::SparseMatrix& stiffness, double omega) {
  return Eigen::MatrixXd(stiffness - omega * omega * model.mass()).inverse();
}

double random_angular_frequency(RandomNumbers& numbers, const data::Beam& beam) {
  return 2.0 * pi * random_frequency_hz(numbers, stick_frequencies(beam, 4), 0.05);
}

STICKSLIP_VERIFIES(Reciprocity, "M2");
// A force at a, with the tip held, moves b as far as the same force at b moves a.
TEST(Reciprocity, HoldsInStickAtRestAndInVibration) {
  on_random_beams(60, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const int elements = numbers.whole(3, 8);
    const BeamModel model(beam, elements);
    const double a = beam.length() * numbers.uniform(0.1, 0.9), b = beam.length() * numbers.uniform(0.1, 0.9);
    for (const double omega : {0.0, random_angular_frequency(numbers, beam)}) {
      const Eigen::PartialPivLU<Eigen::MatrixXd> solve(
          with_held_tip(model, model.stick_stiffness() - omega * omega * model.mass()));
      const auto at = [&](double x) {
        Eigen::VectorXd row = model.interpolation(x);
        row[model.tip_deflection()] = 0.0;
        return row;
      };
      const double there = at(b).dot(solve.solve(at(a))), back = at(a).dot(solve.solve(at(b)));
      const double scale =
          std::sqrt(std::abs(at(a).dot(solve.solve(at(a))) * at(b).dot(solve.solve(at(b))))) +
          std::abs(there);
      EXPECT_TRUE(
          within(there, back, round_off(1, std::pow(elements, 4) * nearness_of_buckling(beam), scale)));
    }
  });
}

// In slip the follower term P e_w e_theta^T is a rank-one change of the symmetric K - P K_G - omega^2 M,
// whose flexibility is F: by Sherman and Morrison
//
//     G_ab - G_ba = -P (F_aw F_theta b - F_bw F_theta a)/(1 + P F_theta w).
TEST(Reciprocity, LossInSlipIsThatOfTheFollowerForce) {
  on_random_beams(60, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const int elements = numbers.whole(3, 8);
    const BeamModel model(beam, elements);
    const double omega = random_angular_frequency(numbers, beam), force = beam.axial_force();
    const Eigen::MatrixXd g = flexibility(model, model.slip_stiffness(), omega);
    const Eigen::MatrixXd f = flexibility(model, model.stick_stiffness(), omega);
    const Eigen::Index w = model.tip_deflection(), theta = model.tip_rotation();
    double largest = 0.0;
    for (Eigen::Index a = 0; a < g.rows(); a += 2)
      for (Eigen::Index b = 0; b < a; b += 2) {
        const double scale = std::abs(g(a, b)) + std::abs(g(b, a));
        const double predicted =
            -force * (f(a, w) * f(theta, b) - f(b, w) * f(theta, a)) / (1.0 + force * f(theta, w));
        const double parts = std::abs(force) *
                             (std::abs(f(a, w) * f(theta, b)) + std::abs(f(b, w) * f(theta, a))) /
                             std::abs(1.0 + force * f(theta, w));
        EXPECT_TRUE(within(g(a, b) - g(b, a), predicted,
                           round_off(1, std::pow(elements, 4) * nearness_of_buckling(beam), scale + parts)));
        largest = std::max(largest, std::abs(predicted) / scale);
      }
    EXPECT_GT(largest, 1e-4);
  });
}

// Reciprocity (Betti). The tip displaced by 1 and a mode: the inertia forces of the mode on sigma do the work
// of the mode's tip reaction on the displacement 1,
//
//     omega_n^2 rho A int U_n sigma dx = EI U_n'''(L) + P U_n'(L),
//
// and the base's load on the mode is that on the mode and sigma apart, int U_n (1 + S) + int U_n sigma. The
// right sides are closed forms, the left ones come from quadrature.
TEST(Reciprocity, HoldsBetweenTheModesAndTheStaticShape) {
  on_random_beams(60, compression, [](const data::Beam& beam, RandomNumbers& numbers) {
    const data::HarmonicExcitation excitation = off_resonance(beam, numbers).excitation;
    const double length = beam.length(), mass = beam.density() * beam.area();
    const analytic::ContactModel model =
        analytic::BeamContactModel(beam, data::FrictionLaw({}), excitation, {}, 8).model();
    const auto modes = analytic::stick_modes(beam, 8);
    const double base = excitation.amplitude() * std::pow(2.0 * pi * excitation.frequency_hz(), 2);
    for (std::size_t n = 0; n < modes.size(); ++n) {
      const StickMode& mode = modes[n];
      const double scale = 1.0 / std::sqrt(mass * mode.norm_squared());
      const double shear = rigidity(beam) * mode.third_derivative(length);
      const double follower = beam.axial_force() * mode.slope(length);
      // sigma is at most of the size of the nearness; the argument bb of a mode is known to bb eps.
      const double bb = mode.trigonometric_wave_number() * length;
      const Tolerance tolerance = round_off(2, bb, std::sqrt(mass * length) * nearness_of_buckling(beam));
      EXPECT_TRUE(within(model.mass_coupling[n],
                         scale * (shear + follower) / std::pow(mode.angular_frequency(), 2), tolerance));
      EXPECT_TRUE(within(model.load[n] / base, scale * mass * mode.load_integral() + model.mass_coupling[n],
                         tolerance));
    }
  });
}

// Without axial force the slip state is its own adjoint; with one, the adjoint differs by the follower force.
TEST(Reciprocity, SlipModesAreSelfAdjointWithoutForce) {
  on_random_beams(50, no_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const double x = beam.length() * numbers.uniform(0.05, 0.95);
    for (const auto& mode : analytic::slip_modes(beam, 8))
      EXPECT_TRUE(within(mode.adjoint_shape(x), mode.shape(x),
                         round_off(1, mode.trigonometric_wave_number() * beam.length(), 1.0)));
  });
  on_random_beams(50, {0.1, 0.95}, [](const data::Beam& beam, RandomNumbers&) {
    const auto mode = analytic::slip_modes(beam, 1).front();
    EXPECT_GT(std::abs(mode.adjoint_shape(0.5 * beam.length()) - mode.shape(0.5 * beam.length())), 1e-2);
  });
}

/// Displacement of the tip by a force at x, and of x by a force at the tip, m/N, in slip at angular frequency
/// omega.
struct Flexibility {
  double of_the_tip{}, of_the_point{};
};

Flexibility flexibility(const data::Beam& beam, int elements, double x, double omega) {
  const solver::BeamModel model(beam, elements);
  const Eigen::MatrixXd dynamic = model.slip_stiffness() - omega * omega * model.mass();
  const Eigen::PartialPivLU<Eigen::MatrixXd> solve(dynamic);
  const Eigen::VectorXd at = model.interpolation(x);
  const Eigen::VectorXd tip = Eigen::VectorXd::Unit(model.degrees_of_freedom(), model.tip_deflection());
  return {tip.dot(solve.solve(at)), at.dot(solve.solve(tip))};
}

// Betti's reciprocity, lost in slip by what the follower force does. By the biorthogonal modes the tip moves
// by sum g_k psi*_k(x)/(omega_k^2 - omega^2) per unit of force at x, and x by the same with psi_k.
TEST(Reciprocity, LossInSlipIsThatOfTheClosedForm) {
  constexpr int elements = 8, modes = 16;
  double largest = 0.0;
  on_random_beams(20, {0.1, 0.9}, [&](const data::Beam& beam, RandomNumbers& numbers) {
    const double x = beam.length() * numbers.whole(2, elements - 1) / elements;
    const auto slip = analytic::slip_modes(beam, modes);
    std::vector<double> natural;
    for (const auto& mode : slip) natural.push_back(mode.angular_frequency());
    const double omega = 2.0 * pi * random_frequency_hz(numbers, natural, 0.1);
    const auto free = analytic::free_modes(beam, modes);
    Flexibility exact, last;
    for (std::size_t k = 0; k < modes; ++k) {
      const double weight = free[k].input / (natural[k] * natural[k] - omega * omega);
      last = {weight * slip[k].adjoint_shape(x), weight * slip[k].shape(x)};
      exact.of_the_tip += last.of_the_tip;
      exact.of_the_point += last.of_the_point;
      last = {weight, weight};
    }
    const Flexibility coarse = flexibility(beam, elements, x, omega);
    const Flexibility fine = flexibility(beam, 2 * elements, x, omega);
    // Shapes of size 1 and more; terms fall as k^-4. The fine mesh is off by a fifteenth of what it differs.
    const double tail = 2.0 * std::abs(last.of_the_tip) * modes / 3.0;
    const auto agrees = [&](double of_fine, double of_coarse, double expected) {
      return within(of_fine, expected,
                    discretisation(std::abs(of_fine - of_coarse) / 15.0 + tail, 2.0, "k^-4 and l^4"));
    };
    EXPECT_TRUE(agrees(fine.of_the_tip, coarse.of_the_tip, exact.of_the_tip));
    EXPECT_TRUE(agrees(fine.of_the_point, coarse.of_the_point, exact.of_the_point));
    largest = largest_or_nan({largest, std::abs(exact.of_the_tip / exact.of_the_point - 1.0)});
  });
  EXPECT_GT(largest, 0.5);
}

}  // namespace
}  // namespace stickslip::testing
