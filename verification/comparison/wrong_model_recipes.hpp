#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "comparison/wrong_models.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "studies/stick/stick_sum.hpp"
#include "studies/stick_slip/tip_run.hpp"

namespace stickslip::studies {

/// How a wrong model is made: whatever is given replaces the right thing, nothing else does.
struct WrongModelRecipe {
  WrongModel wrong_model;
  /// The case that it takes for the one given, or nothing if that is the same. The friction force is limited
  /// by the axial force of the one given.
  std::function<std::optional<data::Case>(const data::Case&)> inputs{};
  /// The closed form of the stick state.
  std::function<void(StickSum&, const data::Case&)> equations{};
  /// The matrices and loads of the mesh, from which it then takes whatever it changes of natural frequencies
  /// and stick state, unless it has equations for that: on 60 elements, or on the mesh of the case if the
  /// mistake depends on it.
  std::function<void(solver::ContactSystem&, const solver::BeamModel&)> mesh{};
  bool depends_on_mesh{};
  /// f = row . q of the case's mesh in the stick state.
  std::function<Eigen::RowVectorXd(const solver::BeamModel&)> force_row{};
  /// The time integration of the modal equations.
  std::function<ModalScheme(const data::Case&)> scheme{};
  /// For how long it looks for |f|_max, s.
  std::function<double(const data::Case&)> observed_for{};
  solver::InitialVelocity start{solver::InitialVelocity::quasi_static};
  std::optional<ContactLaw> law{};
  /// What it makes of a right result.
  std::function<void(const data::Case&, Quantity, const std::vector<double>&, std::vector<double>&)>
      reading{};
  bool knows_stick_slip{true};  ///< false for mistakes that only a model of the stick state can make
};

[[nodiscard]] const std::vector<WrongModelRecipe>& wrong_model_recipes();

[[nodiscard]] data::Case with_elements(const data::Case& problem, int elements);

}  // namespace stickslip::studies
