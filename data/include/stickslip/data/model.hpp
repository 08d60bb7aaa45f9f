// SPDX-License-Identifier: MIT
#pragma once

/// A structure that is no beam: one mass, or the matrices of a finite-element program.

#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace stickslip::data {

/// One entry of a sparse matrix; row and column count from 0.
struct MatrixEntry {
  int row{}, column{};
  double value{};

  bool operator==(const MatrixEntry&) const = default;
};

/// A degree of freedom with its share in a mean or in a load; rows count from 0.
struct WeightedRow {
  int row{};
  double weight{1.0};

  bool operator==(const WeightedRow&) const = default;
};

/// A file that a key of [model] names.
struct ModelFile {
  std::string key;     ///< "model.mass_matrix"
  std::string name;    ///< as the case file has it
  std::string sha256;  ///< of its bytes
};

/// M q̈ + C q̇ + K q = F over all degrees of freedom, those of the base included, in a frame at rest. SI units.
///
/// The entries hold both triangles; entries of one place add. q of the rows `base` is h(t), that of `fixed` 0. The contact is at
/// u_c = Σ w_i q_i with weights of sum 1, and a force f on it is f w_i on each of its rows. Where the excitation is a force,
/// F = F(t) g with the weights g of `load`, and the base rests.
struct StructureMatrices {
  int rows{};
  std::vector<MatrixEntry> mass, stiffness;
  std::vector<MatrixEntry> damping;  ///< empty if none is given
  std::vector<int> base, fixed;
  std::vector<WeightedRow> contact;
  std::vector<WeightedRow> load;  ///< empty if there is none; of one mass, the mass
  std::vector<ModelFile> files;
};

/// What a Model is built from; field names are keys of the table [model]. NaN for what it does not have.
struct ModelProperties {
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();

  double mass{none};          ///< m, kg, > 0
  double stiffness{none};     ///< k, N/m, ≥ 0: a spring from the mass to the base
  double damping{none};       ///< c, N s/m, ≥ 0: a damper from the mass to the base
  double normal_force{none};  ///< N, newton, > 0: it closes the contact and does not change K
};

/// One mass m on a spring and a damper,
///
///     m ÿ + c (ẏ - ḣ) + k (y - h) = f_d,
///
/// or a structure given by its matrices. Cannot be built invalid.
class Model {
 public:
  /// One mass. Throws FieldError.
  explicit Model(const ModelProperties& mass);
  /// Throws FieldError for the normal force. That the matrices fit each other is for their reader to see to.
  Model(double normal_force, std::shared_ptr<const StructureMatrices> matrices);

  [[nodiscard]] bool is_mass() const noexcept;
  [[nodiscard]] double normal_force() const noexcept { return properties_.normal_force; }
  [[nodiscard]] const ModelProperties& properties() const noexcept { return properties_; }
  /// Of one mass: rows of the base and of the mass.
  [[nodiscard]] const StructureMatrices& matrices() const noexcept { return *matrices_; }
  [[nodiscard]] const std::shared_ptr<const StructureMatrices>& shared_matrices() const noexcept {
    return matrices_;
  }
  /// The same matrices of the same files, or equal masses, with the same normal force.
  bool operator==(const Model& other) const noexcept;

 private:
  ModelProperties properties_;
  std::shared_ptr<const StructureMatrices> matrices_;
};

}  // namespace stickslip::data
