// SPDX-License-Identifier: MIT
#include "stickslip/solver/beam_model.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <vector>

#include "constrained.hpp"
#include "stickslip/solver/beam_element.hpp"
#include "stickslip/solver/modal_analysis.hpp"

namespace stickslip::solver {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

// Row of the first degree of freedom of an element's left node; negative at the clamp.
Eigen::Index first_degree_of_freedom(int element) { return 2 * (Eigen::Index{element} - 1); }

void scatter(const ElementMatrix& matrix, int element, Triplets& triplets) {
  const Eigen::Index first = first_degree_of_freedom(element);
  for (Eigen::Index i = 0; i < 4; ++i)
    for (Eigen::Index j = 0; j < 4; ++j)
      if (first + i >= 0 && first + j >= 0)
        triplets.emplace_back(static_cast<int>(first + i), static_cast<int>(first + j), matrix(i, j));
}

SparseMatrix assemble(const ElementMatrix& element_matrix, int elements) {
  Triplets triplets;
  triplets.reserve(16 * static_cast<std::size_t>(elements));
  for (int element = 0; element < elements; ++element) scatter(element_matrix, element, triplets);
  const Eigen::Index size = 2 * Eigen::Index{elements};
  SparseMatrix matrix(size, size);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

Eigen::VectorXd assemble(const ElementVector& element_vector, int elements) {
  Eigen::VectorXd vector = Eigen::VectorXd::Zero(2 * Eigen::Index{elements});
  for (int element = 0; element < elements; ++element)
    for (Eigen::Index i = 0; i < 4; ++i)
      if (const Eigen::Index row = first_degree_of_freedom(element) + i; row >= 0)
        vector[row] += element_vector[i];
  return vector;
}

}  // namespace

BeamModel::BeamModel(const data::Beam& beam, int elements) : beam_(beam), elements_(elements) {
  if (elements < 1) throw data::FieldError("numerics.elements", elements, "at least 1");
  const double element_length = beam.length() / elements;
  const double mass_per_length = beam.density() * beam.area();
  const double flexural_rigidity = beam.youngs_modulus() * beam.second_moment_of_area();
  ElementMatrix mass = consistent_mass(mass_per_length, element_length);
  if (beam.shear_stiffness() > 0.0) {
    shear_parameter_ = 12.0 * flexural_rigidity / (beam.shear_stiffness() * element_length * element_length);
    mass = consistent_mass(mass_per_length, element_length, shear_parameter_) +
           rotary_mass(beam.density() * beam.second_moment_of_area(), element_length, shear_parameter_);
  }
  mass_ = assemble(mass, elements);
  elastic_ = assemble(bending_stiffness(flexural_rigidity, element_length, shear_parameter_), elements);
  geometric_ = assemble(solver::geometric_stiffness(element_length, shear_parameter_), elements);
  base_load_ = mass_per_length * assemble(consistent_load(element_length), elements);

  stick_stiffness_ = elastic_ - beam.axial_force() * geometric_;
  slip_stiffness_ = stick_stiffness_;
  slip_stiffness_.coeffRef(tip_deflection(), tip_rotation()) += follower_force();
  clamp_mass_ = mass.topRows<2>();
  clamp_stiffness_ = (bending_stiffness(flexural_rigidity, element_length, shear_parameter_) -
                      beam.axial_force() * solver::geometric_stiffness(element_length, shear_parameter_))
                         .topRows<2>();
  clamp_load_ = mass_per_length * consistent_load(element_length).head<2>();
}

MotionRow BeamModel::clamp_row(Eigen::Index row) const {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(degrees_of_freedom());
  MotionRow result{zero, zero, zero, {clamp_load_[row], 0.0, 0.0}};
  result.acceleration.head<2>() = clamp_mass_.row(row).tail<2>().transpose();
  result.displacement.head<2>() = clamp_stiffness_.row(row).tail<2>().transpose();
  return result;
}

Eigen::VectorXd BeamModel::interpolation(double x) const {
  if (!(x >= 0.0 && x <= beam_.length()))
    throw data::FieldError("x", x, "on the beam, 0 ... " + data::shortest_text(beam_.length()) + " (m)");
  const double element_length = beam_.length() / elements_;
  const int element = std::min(static_cast<int>(x / element_length), elements_ - 1);
  const ElementVector weights =
      shape_functions(x / element_length - element, element_length, shear_parameter_);
  Eigen::VectorXd row = Eigen::VectorXd::Zero(degrees_of_freedom());
  for (Eigen::Index i = 0; i < 4; ++i)
    if (const Eigen::Index column = first_degree_of_freedom(element) + i; column >= 0)
      row[column] = weights[i];
  return row;
}

Eigen::VectorXd BeamModel::unit_tip_deflection() const {
  require_stable_stick_state(*this);
  // K_ff q_f = -K_fc with q_c = 1: the row of the tip deflection is replaced by that condition.
  const Eigen::Index tip = tip_deflection();
  Eigen::VectorXd right_side = -Eigen::VectorXd(stick_stiffness_.col(tip));
  right_side[tip] = 1.0;
  return Eigen::SimplicialLDLT<SparseMatrix>(constrained(stick_stiffness_, tip)).solve(right_side);
}

void require_stable_stick_state(const BeamModel& model) {
  const SparseMatrix held = constrained(model.stick_stiffness(), model.tip_deflection());
  const std::string mesh = " on " + std::to_string(model.elements()) + " elements";
  // The factorisation takes what is not finite for positive definite.
  if (!held.coeffs().allFinite())
    throw data::FieldError("beam.length", model.beam().length(),
                           "so long (m) that the stiffness is finite" + mesh);
  if (Eigen::SimplicialLLT<SparseMatrix>(held).info() == Eigen::Success) return;
  throw data::FieldError("beam.axial_force", model.beam().axial_force(),
                         "below the buckling load of the stick state, " +
                             data::shortest_text(stick_buckling_load(model)) + " N" + mesh);
}

}  // namespace stickslip::solver
