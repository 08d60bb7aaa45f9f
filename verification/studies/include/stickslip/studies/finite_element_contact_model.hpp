#pragma once

#include <Eigen/Core>

#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/data/problem.hpp"
#include "stickslip/solver/beam_model.hpp"
#include "stickslip/solver/contact_system.hpp"

namespace stickslip::studies {

/// A harmonic excitation of a ContactSystem: load_history(t) = sin(Omega t), wall w(t) = W sin(Omega t), as
/// an event-driven run needs them in closed form.
struct HarmonicDrive {
  double load_amplitude{1.0};       ///< load_history(t) = load_amplitude sin(Omega t)
  double load_angular_frequency{};  ///< Omega, rad/s
  double wall_amplitude{};          ///< W, m
};

/// A ContactSystem in all the modes of its held contact: the very same semi-discrete system, without loss,
/// for the event-driven method.
///
/// With c the contact and f the other degrees of freedom, sigma = (-K_ff^-1 K_fc, 1) the static shape and Phi
/// the modes of (K_ff - omega^2 M_ff) Phi = 0, Phi^T M_ff Phi = I,
///
///     q = sigma q_c + (Phi T, 0),     T = Phi^T M_ff (q_f - sigma_f q_c).
class HeldModes {
 public:
  /// Dense: meant for some hundred degrees of freedom. Throws std::invalid_argument if M_ff or K_ff is not
  /// positive definite.
  explicit HeldModes(const solver::ContactSystem& system);

  /// The system in these modes, driven as `drive` says.
  [[nodiscard]] analytic::ContactModel model(const HarmonicDrive& drive) const;

  /// The mode amplitudes T of displacements q (or T_t of velocities).
  [[nodiscard]] Eigen::VectorXd amplitudes(const Eigen::VectorXd& q) const;
  /// q of T and q_c.
  [[nodiscard]] Eigen::VectorXd displacement(const Eigen::VectorXd& amplitudes, double contact) const;

 private:
  solver::ContactSystem system_;
  Eigen::VectorXd angular_frequency_;
  Eigen::MatrixXd basis_;       // columns Phi (zero at c), then sigma: q = basis (T, q_c)
  Eigen::MatrixXd projection_;  // Phi^T M with the row of c left out: T = projection (q - sigma q_c)
};

/// The beam on `model`'s mesh as an event-driven run takes it.
[[nodiscard]] analytic::ContactModel finite_element_contact_model(const solver::BeamModel& model,
                                                                  const data::FrictionLaw& friction,
                                                                  const data::HarmonicExcitation& excitation,
                                                                  const data::Damping& damping);

}  // namespace stickslip::studies
