// SPDX-License-Identifier: MIT
#pragma once

/// Motions of the beam by the boundary value problem that they solve: a linear system for four exponentials, which shares no
/// formula with the closed forms.

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>

#include "support/random_beams.hpp"

namespace stickslip::testing {

/// A motion exp(s t) of a beam, D w'''' + P w'' + rho A s^2 w = 0 with D = EI (1 + eta s), in xi = x/L:
///
///     w'''' + z w'' + q w = 0,   z = P L^2/D,   q = rho A s^2 L^4/D,
///
/// and the transposed problem, that of the weight functions v of the form
///
///     B(v, u) = int v'' u'' - z v' u' + q v u dxi + (1 - chi) z v(1) u'(1).
struct BeamWaves {
  using Complex = std::complex<double>;

  Eigen::Array4cd exponent,
      weight;  ///< weight exp(exponent (xi - origin)), which is nowhere above the weight
  Eigen::Array4d origin;
  double condition{};  ///< of the linear system

  /// A derivative in xi.
  [[nodiscard]] Complex operator()(int order, double xi) const {
    return (weight * exponent.pow(order) * (exponent * (xi - origin)).exp()).sum();
  }
  [[nodiscard]] double largest_exponent() const { return exponent.abs().maxCoeff(); }
};

/// int v^(i) u^(j) dxi.
inline std::complex<double> product(const BeamWaves& v, int i, const BeamWaves& u, int j) {
  std::complex<double> sum = 0.0;
  for (int p = 0; p < 4; ++p)
    for (int k = 0; k < 4; ++k) {
      const auto a = v.exponent[p], b = u.exponent[k],
                 at_clamp = std::exp(-a * v.origin[p] - b * u.origin[k]),
                 at_tip = std::exp(a * (1.0 - v.origin[p]) + b * (1.0 - u.origin[k]));
      sum += v.weight[p] * std::pow(a, i) * u.weight[k] * std::pow(b, j) *
             (std::abs(a + b) < 1e-12 ? at_clamp : (at_tip - at_clamp) / (a + b));
    }
  return sum;
}

/// The beam under another axial force of the direction chi.
inline data::Beam directed(const data::Beam& beam, double axial_direction, double axial_force) {
  data::BeamProperties properties = beam.properties();
  properties.axial_direction = axial_direction;
  properties.axial_force = axial_force;
  return data::Beam(properties);
}

/// The paper's beam under P = factor EI/L^2.
inline data::Beam loaded_paper_beam(double factor, double axial_direction) {
  const data::Beam beam = paper_beam_with_load_factor(factor);
  return directed(beam, axial_direction, beam.axial_force());
}

/// chi of 0, 1 or between.
inline double random_direction(RandomNumbers& numbers) {
  return std::clamp(numbers.uniform(-0.5, 1.5), 0.0, 1.0);
}

struct BeamProblem {
  using Complex = std::complex<double>;

  data::Beam beam;
  Complex s;
  double kelvin_voigt{};

  [[nodiscard]] Complex rigidity() const {
    return testing::rigidity(beam) * (1.0 + kelvin_voigt * s);
  }  ///< D
  [[nodiscard]] Complex load() const {
    return beam.axial_force() * std::pow(beam.length(), 2) / rigidity();
  }                                        ///< z
  [[nodiscard]] Complex inertia() const {  ///< q
    return beam.density() * beam.area() * s * s * std::pow(beam.length(), 4) / rigidity();
  }

  /// What a motion has besides w'(0) = 0 and no moment at the tip. A mode is given by its curvature at the clamp alone.
  enum class Given { curvature_at_clamp, force_at_tip, position_of_tip };

  [[nodiscard]] BeamWaves motion(bool is_transposed, Given given, double value = 1.0,
                                 double at_clamp = 0.0) const {
    const Complex z = load(), root = std::sqrt(0.25 * z * z - inertia());
    const Complex first = std::sqrt(root - 0.5 * z), second = std::sqrt(-root - 0.5 * z);
    const double chi = beam.axial_direction();
    BeamWaves waves{
        .exponent = {first, -first, second, -second}, .weight = {}, .origin = {1.0, 0.0, 1.0, 0.0}};
    Eigen::Matrix4cd matrix;
    for (int j = 0; j < 4; ++j) {
      const Complex r = waves.exponent[j];
      const Complex near = std::exp(-r * waves.origin[j]), far = std::exp(r * (1.0 - waves.origin[j]));
      const Complex moment = r * r + (is_transposed ? (1.0 - chi) * z : 0.0);
      const Complex force = -r * r * r - (is_transposed ? 1.0 : chi) * z * r;
      matrix.col(j) << near, r * near, moment * far,
          given == Given::curvature_at_clamp ? r * r * near
                                             : (given == Given::force_at_tip ? force : 1.0) * far;
    }
    // Rows of one size.
    Eigen::Vector4cd right(at_clamp, 0.0, 0.0, value);
    for (int i = 0; i < 4; ++i) {
      const double size = matrix.row(i).cwiseAbs().maxCoeff();
      matrix.row(i) /= size;
      right[i] /= size;
    }
    const Eigen::PartialPivLU<Eigen::Matrix4cd> factors(matrix);
    waves.condition = 1.0 / factors.rcond();
    waves.weight = factors.solve(right).array();
    return waves;
  }
};

}  // namespace stickslip::testing
