// SPDX-License-Identifier: MIT
/// The mobility of the tip of the mesh against that of the beam, without any modes.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <optional>
#include <vector>

#include "stickslip/analytic/tip_mobility.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "support/order.hpp"
#include "support/requirements.hpp"
#include "support/vibration.hpp"

namespace stickslip::testing {
namespace {

using Complex = std::complex<double>;

constexpr double rigidity = 2e9 * 1e-4 / 12.0;  // EI, N m^2

/// s e^T (s^2 M + s C + K_slip)^-1 e, e the tip's deflection.
Complex mesh_mobility(const data::Beam& beam, const data::Damping& damping, int elements, Complex s) {
  const solver::BeamModel model(beam, elements);
  const Eigen::MatrixXcd dynamic =
      s * s * Eigen::MatrixXcd(model.mass().cast<Complex>()) +
      s * Eigen::MatrixXcd(solver::damping_matrix(model, damping).cast<Complex>()) +
      Eigen::MatrixXcd(model.slip_stiffness().cast<Complex>());
  const Eigen::VectorXcd force = Eigen::VectorXcd::Unit(model.degrees_of_freedom(), model.tip_deflection());
  return s * dynamic.partialPivLu().solve(force)[model.tip_deflection()];
}

STICKSLIP_VERIFIES(TipMobilityOrder, "A9");
TEST(TipMobilityOrder, IsFourWithThePredictedConstant) {
  // Of MeshError, with the motion under a unit force at the tip as the dual one, which it is at P = 0: D
  // u'''' = -rho A s^2 u, and with the velocity T(x) per unit force
  //
  //     Y_h - Y = -l^4 s^3 (rho A)^2/(720 D) int T^2 dx,
  //
  // of which the next term is l^2 (2 int T T''/42 + 8 int T'^2/105)/int T^2, with (|r| l)^2/8 more. Other
  // forces have another constant; the size of their next term is taken from the same formula.
  constexpr int n = 200;
  for (const double axial_force : {0.0, 500.0, 5e3, -5e3})
    for (const double eta : {0.0, 1e-4})
      for (const Complex s :
           {Complex(100.0), Complex(60.0, 150.0), Complex(0.0, 120.0), Complex(0.0, 400.0)}) {
        const data::Beam beam = paper_beam_with_axial_force(axial_force);
        const data::Damping damping({.kelvin_voigt = eta});
        const analytic::TipMobility mobility(beam, damping);
        const double step = beam.length() / n;
        std::vector<Complex> velocity;
        for (int i = 0; i <= n; ++i) velocity.push_back(mobility.transfer(step * i, s));
        Complex square = 0.0, slope_square = 0.0;
        for (std::size_t i = 0; i <= n; ++i) {
          square += simpson_weight(static_cast<int>(i), n) * step / 3.0 * std::pow(velocity[i], 2);
          if (i > 0) slope_square += std::pow(velocity[i] - velocity[i - 1], 2) / step;
        }
        // int T T'' = T T'(L) - int T'^2.
        const Complex bend = velocity[n] * (velocity[n] - velocity[n - 1]) / step - slope_square;
        const double next =
            (2.0 / 42.0 * std::abs(bend) + 8.0 / 105.0 * std::abs(slope_square)) / std::abs(square);
        const double constant = std::abs(s * s * s * 100.0 / (720.0 * rigidity * (1.0 + eta * s)) * square);
        const double wave = std::abs(s * std::sqrt(10.0 / rigidity));  // |r|^2
        std::vector<OrderLevel> levels;
        for (const int elements : {8, 12, 16, 24}) {
          const double l = beam.length() / elements;
          const Complex error = mesh_mobility(beam, damping, elements, s) - mobility(s);
          levels.push_back({.step = l,
                            .error = std::abs(error),
                            .next_term = next * l * l * (1.0 + wave * l * l / 8.0),
                            .floor = round_off(1, std::pow(elements, 4), std::abs(mobility(s))).value});
        }
        EXPECT_TRUE(order_is(levels, 4.0, axial_force == 0.0 ? std::optional(constant) : std::nullopt))
            << "P = " << axial_force << ", eta = " << eta << ", s = " << s;
      }
}

}  // namespace
}  // namespace stickslip::testing
