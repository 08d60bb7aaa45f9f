// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>

#include "stickslip/data/problem.hpp"
#include "stickslip/solver/beam_model.hpp"
#include "stickslip/solver/stick_slip_integrator.hpp"

namespace stickslip::solver {

/// What a run of a case may do differently from the paper's.
struct RunOptions {
  bool is_bonded{};  ///< the tip never slips: the linear stick state for all time
  /// u_t(x,0) = 0 for x < L, as printed in Sect. 3: an impulsive reaction that grows with the mesh. Else u_t(x,0) = S(x) h_t(0),
  /// the quasi-static start with S from the mesh: what Eq. (26) of the paper assumes (erratum E4).
  bool starts_with_the_base{};
  std::optional<ContactScheme> scheme{};     ///< else located
  std::optional<Coordinates> coordinates{};  ///< else fastest_coordinates()
};

/// Modal on at most 200 elements, with damping on 100, whose modes cost less than some ten thousand steps; nodal elsewhere, and
/// for ContactScheme::paper, which overwrites the velocity of one node.
[[nodiscard]] Coordinates fastest_coordinates(int elements, const data::Damping& damping,
                                              ContactScheme scheme = ContactScheme::located);

/// The damping of the beam on its mesh, symmetric, the same matrix in stick and slip:
///
///     C = η K + Σ_n 2 ζ ω_n (M φ_n) (M φ_n)ᵀ,
///     K φ_n = ω_n² M φ_n,  φ_nᵀ M φ_n = 1,
///
/// with the elastic K, which the axial force does not change, and all modes φ_n of the mesh with its tip
/// free and P = 0: each has the fraction ζ of critical damping, and η ω_n/2 besides. (The sum is
/// 2 ζ M (M⁻¹ K)^(1/2).)
///
/// A stick mode ψ has less than ζ. At P = 0, with |φ_nᵀ M ψ|² as weights, which add up to 1, its
/// frequency is the root of the mean of ω_n² and its ratio ζ times the mean of ω_n over that
/// root: less than 1 by Jensen's inequality; 0.78, 0.86 and 0.90 in the first three.
///
/// Throws data::FieldError, naming numerics.elements, for damping.ratio > 0 on more than 500 elements:
/// that matrix is full.
[[nodiscard]] SparseMatrix damping_matrix(const BeamModel& model, const data::Damping& damping);

/// The beam of a case on the mesh of `model`, as a system with one contact at the tip. In coordinates that move
/// with the base the wall moves by V t - h(t) and the load is -b h_tt. The normal force is P, or zero in tension.
/// Throws what damping_matrix() throws.
[[nodiscard]] ContactSystem beam_contact_system(const BeamModel& model, const data::Case& problem);
/// The same on a base that moves by h(t) = `base` instead of the case's motion.
[[nodiscard]] ContactSystem beam_contact_system(const BeamModel& model, const data::Case& problem,
                                                const PrescribedMotion& base);

/// The structure of a case on a base that moves by h(t) = `base`: the beam on numerics.elements, or the model. Throws what
/// damping_matrix() and model_matrices() throw.
[[nodiscard]] ContactSystem contact_system(const data::Case& problem, const PrescribedMotion& base);

/// The structure of a case in time steps: a beam by finite elements, a model by its matrices. Started with its contact, the tip of a
/// beam, at rest on the wall, or as `initial` of the case says; integrator() steps it through time. Displacements are absolute
/// (y = h + u). Where spectra alone move base and wall of a damped structure, its contact has been held before, so that the motion begins
/// stationary, to 1e-3. friction_force() has the sign of Eq. (28), f = EI u'''(L) + χ P u'(L) = -f_d.
class BeamSimulation {
 public:
  /// Of the numerics, uses elements, time_step, spectral_radius and velocity_threshold. Throws what damping_matrix()
  /// throws, and data::FieldError
  ///
  ///   - naming beam.axial_force, if P is at or over the buckling load, or if P ≤ 0 unless the tip is bonded;
  ///   - if ContactScheme::paper has no velocity threshold;
  ///   - if a contact that is not rigid has a jump of the friction law, another scheme than located, a bonded tip,
  ///     or a spring that rounding would load by more than 1e-4 of the limit.
  ///
  /// Throws std::logic_error for Coordinates::modal with ContactScheme::paper.
  explicit BeamSimulation(const data::Case& problem, const RunOptions& options = {});

  [[nodiscard]] double base_displacement() const;     ///< h, m; 0 where the excitation is a force
  [[nodiscard]] double displacement(double x) const;  ///< y(x) of a beam, m
  /// The same, of weights_at(x).
  [[nodiscard]] double displacement(const Eigen::VectorXd& weights) const;
  /// Of the coordinates of the integrator in the deflection of a beam at x.
  [[nodiscard]] Eigen::VectorXd weights_at(double x) const;
  [[nodiscard]] double tip_displacement() const;      ///< y(L) of a beam, y of the contact of a model, m
  [[nodiscard]] double tip_acceleration() const;      ///< y_tt there, m/s²; not without mass at the contact
  [[nodiscard]] double midspan_displacement() const;  ///< y(L/2) of a beam, m; else 0
  [[nodiscard]] double friction_force() const { return -integrator_->friction_force(); }  ///< f, N
  /// Of a beam.
  [[nodiscard]] const BeamModel& model() const { return model_.value(); }
  /// Of weights on the nodes of a beam those on the coordinates of the integrator.
  [[nodiscard]] Eigen::VectorXd on_coordinates(const Eigen::VectorXd& nodal) const;
  [[nodiscard]] const PrescribedMotion& base() const noexcept { return base_; }  ///< h; at rest under a force
  /// Of the beam's ContactSystem: time, steps, events. Its sliding velocity is v_s = y_t(L) - V.
  [[nodiscard]] StickSlipIntegrator& integrator() noexcept { return *integrator_; }
  [[nodiscard]] const StickSlipIntegrator& integrator() const noexcept { return *integrator_; }

 private:
  void start(const data::Case& problem, Eigen::VectorXd displacement, Eigen::VectorXd velocity,
             bool is_bonded);

  std::optional<BeamModel> model_;  // of a beam
  PrescribedMotion base_;           // in m; at rest where the excitation is a force
  std::unique_ptr<StickSlipIntegrator> integrator_;
  Eigen::MatrixXd basis_;  // of modal coordinates, q = basis_ z; else empty
  Eigen::VectorXd midspan_;
};

/// The number of whole steps in a duration: round(duration / time_step).
[[nodiscard]] long step_count(double duration, double time_step);

/// max |f| over the grid times 0 ... duration with the tip bonded, N: finite-element |f_max| of Eqs. (29), (30).
/// In modal coordinates by ModalStickRun. Uses neither the friction law nor the contact nor the speed of the wall.
[[nodiscard]] double max_abs_friction_force(const data::Case& problem,
                                            std::optional<Coordinates> coordinates = {});

/// The time of the first slip, s, or nothing if the tip stays stuck for numerics.duration().
[[nodiscard]] std::optional<double> first_slip(const data::Case& problem,
                                               std::optional<Coordinates> coordinates = {});

}  // namespace stickslip::solver
