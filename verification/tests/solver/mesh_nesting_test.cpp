// SPDX-License-Identifier: MIT
/// Nested meshes of random beams: the cubic of an element is a cubic on each part of it.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "stickslip/solver/beam_element.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "support/mesh.hpp"
#include "support/random_beams.hpp"
#include "support/requirements.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

using solver::BeamModel;

/// Value and slope of a coarse mesh's functions at the nodes of one `factor` times as fine.
Eigen::MatrixXd interpolant(const BeamModel& coarse, int factor) {
  const int elements = coarse.elements();
  const double l = coarse.beam().length() / elements;
  Eigen::MatrixXd map = Eigen::MatrixXd::Zero(2 * elements * factor, 2 * elements);
  for (int node = 1; node <= elements * factor; ++node) {
    const int element = std::min((node - 1) / factor, elements - 1);
    const double s = static_cast<double>(node) / factor - element;
    const Eigen::RowVector4d value = solver::shape_functions(s, l).transpose();
    const Eigen::RowVector4d slope(6.0 * s * (s - 1.0) / l, 1.0 - 4.0 * s + 3.0 * s * s,
                                   6.0 * s * (1.0 - s) / l, 3.0 * s * s - 2.0 * s);
    for (int i = 0; i < 4; ++i)
      if (const int column = 2 * (element - 1) + i; column >= 0) {
        map(2 * node - 2, column) = value[i];
        map(2 * node - 1, column) = slope[i];
      }
  }
  return map;
}

STICKSLIP_VERIFIES(MeshNesting, "M2");
TEST(MeshNesting, FineMatricesOnCoarseFunctionsAreTheCoarseMatrices) {
  on_random_beams(60, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const int elements = numbers.whole(1, 6);
    const BeamModel coarse(beam, elements);
    for (const int factor : {2, 3}) {
      const BeamModel fine(beam, factor * elements);
      const Eigen::MatrixXd map = interpolant(coarse, factor);
      for (const auto part :
           {&BeamModel::mass, &BeamModel::elastic_stiffness, &BeamModel::geometric_stiffness,
            &BeamModel::stick_stiffness, &BeamModel::slip_stiffness}) {
        const Eigen::MatrixXd large = (fine.*part)(), small = (coarse.*part)();
        const Eigen::MatrixXd nested = map.transpose() * large * map;
        const Eigen::MatrixXd magnitude = map.cwiseAbs().transpose() * large.cwiseAbs() * map.cwiseAbs();
        for (Eigen::Index i = 0; i < small.rows(); ++i)
          for (Eigen::Index j = 0; j < small.cols(); ++j)
            ASSERT_TRUE(within(nested(i, j), small(i, j), round_off(4, 1, magnitude(i, j))));
      }
      const Eigen::VectorXd load = map.transpose() * fine.base_load();
      const Eigen::VectorXd magnitude = map.cwiseAbs().transpose() * fine.base_load().cwiseAbs();
      for (Eigen::Index i = 0; i < load.size(); ++i)
        ASSERT_TRUE(within(load[i], coarse.base_load()[i], round_off(2, 1, magnitude[i])));
    }
  });
}

TEST(MeshNesting, InterpolantOfACoarseModeHasItsValues) {
  on_random_beams(40, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const int elements = numbers.whole(2, 6);
    const BeamModel coarse(beam, elements), fine(beam, 2 * elements);
    const Eigen::MatrixXd map = interpolant(coarse, 2);
    const double x = beam.length() * numbers.uniform(0.0, 1.0);
    for (const auto& mode : solver::stick_modes(coarse, 2 * elements - 1)) {
      EXPECT_TRUE(within(fine.interpolation(x).dot(map * mode.shape), coarse.interpolation(x).dot(mode.shape),
                         round_off(4, 1, mode.shape.cwiseAbs().maxCoeff())));
      // An energy is a sum of products that are up to n^4 times as large.
      const double elastic = elastic_energy(coarse, mode.shape);
      const double kinetic = 0.5 * mode.angular_frequency * mode.angular_frequency;
      EXPECT_TRUE(within(elastic + geometric_energy(coarse, mode.shape), kinetic,
                         round_off(1, std::pow(2.0 * elements, 4), elastic + kinetic)));
    }
  });
}

// Rayleigh-Ritz: of two nested spaces the larger one has the lower frequencies, buckling load and energy of
// an imposed deflection, and the larger compliance.
TEST(MeshNesting, RefinementSoftens) {
  on_random_beams(40, any_force, [](const data::Beam& beam, RandomNumbers& numbers) {
    const int elements = numbers.whole(2, 6);
    const BeamModel coarse(beam, elements);
    const auto modes = solver::stick_modes(coarse, 2 * elements - 1);
    const auto tip_energy = [](const BeamModel& model) {
      const Eigen::VectorXd q = model.unit_tip_deflection();
      return elastic_energy(model, q) + geometric_energy(model, q);
    };
    const auto compliance = [](const BeamModel& model) {
      Eigen::VectorXd load = model.base_load();
      load[model.tip_deflection()] = 0.0;
      return load.dot(with_held_tip(model, model.stick_stiffness()).llt().solve(load));
    };
    for (const int factor : {2, 3}) {
      const BeamModel fine(beam, factor * elements);
      const double slack =
          round_off(1, std::pow(factor * elements, 4) * nearness_of_buckling(beam), 1.0).value;
      const auto finer = solver::stick_modes(fine, 2 * elements - 1);
      for (std::size_t n = 0; n < modes.size(); ++n)
        EXPECT_LT(finer[n].angular_frequency, modes[n].angular_frequency) << n;
      EXPECT_LT(solver::stick_buckling_load(fine), solver::stick_buckling_load(coarse));
      EXPECT_LE(tip_energy(fine),
                tip_energy(coarse) + slack * elastic_energy(coarse, coarse.unit_tip_deflection()));
      EXPECT_GT(compliance(fine), compliance(coarse));
    }
  });
}

}  // namespace
}  // namespace stickslip::testing
