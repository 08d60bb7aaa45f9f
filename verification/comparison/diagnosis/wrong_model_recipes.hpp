// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "comparison/diagnosis/wrong_models.hpp"
#include "stickslip/solver/base_motion.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/verification/stick_sum.hpp"

namespace stickslip::comparison {

/// How a wrong model is made. Each member that is given replaces a part of the right model; the rest is
/// unchanged.
struct WrongModelRecipe {
  WrongModel wrong_model;
  /// The case that the wrong model computes instead of the given one; empty if it is the same. The friction
  /// force is limited by the axial force of the given case.
  std::function<std::optional<data::Case>(const data::Case&)> inputs{};
  std::function<void(studies::StickSum&, const data::Case&)> equations{};
  /// Changes the matrices and loads of the mesh. Natural frequencies and stick state are then computed on the
  /// mesh, unless `equations` is given. The mesh has 60 elements, or is that of the case if the mistake
  /// depends on the mesh.
  std::function<void(solver::ContactSystem&, const solver::BeamModel&)> mesh{};
  bool depends_on_mesh{};
  /// The row of f = row . q on the mesh of the case in the stick state.
  std::function<Eigen::RowVectorXd(const solver::BeamModel&)> force_row{};
  /// Whether the damping of the steady vibration is multiplied by the first angular frequency over that of the excitation.
  bool is_structural{};
  /// The scheme of the time integration of the modal equations.
  std::function<studies::ModalScheme(const data::Case&)> scheme{};
  /// The motion of the base in stick-slip. The run starts with the quasi-static shape to its displacement.
  std::function<solver::PrescribedMotion(const data::Case&)> base{
      [](const data::Case& problem) { return solver::base_motion(problem.motion); }};
  /// The duration (s) over which |f_max| is searched.
  std::function<double(const data::Case&)> observed_for{};
  studies::Start start{studies::Start::quasi_static};
  std::optional<studies::FrictionRule> law{};
  /// What it makes of a right result.
  std::function<void(const data::Case&, Quantity, const std::vector<double>&, std::vector<double>&)>
      reading{};
  bool is_relative{};           ///< u is given instead of y, also in the steady vibration
  bool knows_stick_slip{true};  ///< false if the mistake is possible in a model of the stick state only
};

[[nodiscard]] const std::vector<WrongModelRecipe>& wrong_model_recipes();

/// One of them. Throws std::invalid_argument if there is none of that name.
[[nodiscard]] const WrongModelRecipe& recipe_of(std::string_view wrong_model);

}  // namespace stickslip::comparison
