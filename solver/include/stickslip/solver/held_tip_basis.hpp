#pragma once

#include <Eigen/Core>

#include "stickslip/solver/beam_model.hpp"
#include "stickslip/solver/contact_system.hpp"
#include "stickslip/solver/stick_slip_integrator.hpp"

namespace stickslip::solver {

/// The coordinates of Craig & Bampton (AIAA J. 6, 1313-1319, 1968) for the beam with its tip as the
/// interface,
///
///     q = Phi eta + sigma w_L,     K_stick phi_n = omega_n^2 M phi_n with w_L = 0,   phi_n^T M phi_n = 1,
///
/// all modes phi_n of the mesh with its tip held, and the static shape sigma of a unit deflection of the tip.
/// The tip's deflection is a coordinate, the last, so that the contact is one in these coordinates too. As
/// K_stick sigma = 0 but at the tip, K_stick is diagonal and M is an arrow:
///
///     M = [I  g; g^T  sigma^T M sigma],   g = Phi^T M sigma,        K_stick = diag(omega^2, sigma^T K_stick
///     sigma),
///
/// and K_slip adds the follower term, the row P e_theta^T [Phi sigma] of the tip.
struct HeldTipBasis {
  Eigen::MatrixXd modes;                ///< Phi, by columns
  Eigen::VectorXd static_shape;         ///< sigma
  Eigen::VectorXd squared_frequencies;  ///< omega_n^2, rad^2/s^2, ascending
};

/// The omega_n^2 are Rayleigh quotients in extended precision: as accurate as double precision can hold for
/// the matrices given, where those of an eigensolver lose the condition number of K_stick. Cost: the cube of
/// the elements. Throws std::domain_error, naming beam.axial_force, if P is at or over the buckling load.
[[nodiscard]] HeldTipBasis held_tip_basis(const BeamModel& model);

/// The coordinates (eta, w_L) of a vector of nodal degrees of freedom: eta = Phi^T M (q - sigma w_L).
[[nodiscard]] Eigen::VectorXd modal_coordinates(const BeamModel& model, const HeldTipBasis& basis,
                                                const Eigen::VectorXd& nodal);

/// The contact system of the beam without damping, in the coordinates of the basis.
[[nodiscard]] ContactSystem modal_contact_system(const BeamModel& model, const HeldTipBasis& basis,
                                                 const data::FrictionLaw& friction,
                                                 const PrescribedMotion& base);

/// The StickSlipIntegrator for a system of that form, with steps that use it: the modes in stick do not know
/// each other, in slip they meet in the contact alone, so that both take a few passes over arrays and no
/// factorisation, whatever the length of the step. Everything else, the location of contact changes for one,
/// is inherited. The numbers are those of the integrator of the finite-element coordinates, up to rounding
/// and what the contact makes of it.
class ModalStickSlipIntegrator final : public StickSlipIntegrator {
 public:
  /// `system` from modal_contact_system(). Throws what StickSlipIntegrator throws, and std::invalid_argument
  /// if the system is damped or not of that form.
  ModalStickSlipIntegrator(ContactSystem system, const IntegratorSettings& settings);

 private:
  // What a step of one length needs, by mode.
  struct Step {
    double length{};
    Eigen::ArrayXd inverse_diagonal;  // 1/[1 - alpha_m + (1 - alpha_f) beta (omega h)^2]
    Eigen::ArrayXd contact_row;       // of the matrix of the step, times inverse_diagonal
    double contact_acceleration{};    // of the contact per unit force on it
  };

  const Kinematics& trial(double end_time) override;
  void stick_step(const Step& step, double end_time);
  void slip_step(const Step& step);
  const Step& step_of(double length);
  void prepare(Step& step, double length) const;

  Eigen::Index modes_;
  Eigen::ArrayXd stiffness_;     // omega^2
  Eigen::ArrayXd coupling_;      // g
  Eigen::ArrayXd follower_row_;  // P e_theta^T Phi
  Eigen::ArrayXd load_;          // p of the modes
  double contact_mass_entry_{}, contact_stiffness_{}, contact_load_{};
  Step full_step_, partial_step_;
  Eigen::ArrayXd alpha_displacement_, residual_;
};

}  // namespace stickslip::solver
