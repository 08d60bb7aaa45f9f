#pragma once

/// How fast two solutions of one contact problem may separate: a number of the discretisation that is known
/// before any run.
///
/// Let Y be the mobility of the contact (tip_mobility.hpp, contact_mobility.hpp), Z = 1/Y, and v_s = Y (f_d -
/// f_h) (boundary_integral.hpp). The friction law is monotone but for a part with the Lipschitz constant
/// kappa = (mu_s - mu_m) alpha N. Two solutions that differ by dv and df then satisfy, by Parseval's identity
/// with the weight exp(-2 sigma t),
///
///     min over omega of Re Z(sigma + i omega) ||dv||^2  <=  <df, dv>  <=  kappa ||dv||^2.
///
/// Let sigma* be the smallest sigma >= 0 with Re Z(sigma + i omega) >= kappa for all omega. A difference then
/// grows at most like exp(sigma* t). A discretisation with a constant friction force per step has the
/// mobility W(zeta) of its steps; with zeta = exp(-s h) it is a function of s, and omega ends at pi/h.
///
/// What is known of sigma* in closed form:
/// - A finite undamped system with symmetric stiffness, in continuous time: Z - m_c s is passive, and
/// vanishes
///   for |s| -> infinity, so that sigma* = kappa/m_c, m_c the mass that an impulse at the contact meets. For
///   a mass m, with or without a spring, kappa/m; for N free modes with the participation g each,
///   kappa N g; for a mesh it is proportional to 1/l. It grows without bound with the number of modes.
/// - The undamped beam: at high frequencies Y(i omega) = i c (tan x - 1) with the phase x = beta L, so that
///   Re Z/sigma -> (dx/domega)/(c (sin x - cos x)^2). It is 2/g at the poles of Y and 1/g at least, g =
///   4/(rho A L). So sigma* >= 4 kappa/(rho A L), whatever P is.

#include <limits>
#include <vector>

#include "stickslip/analytic/boundary_integral.hpp"
#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/data/problem.hpp"
#include "stickslip/solver/contact_mobility.hpp"

namespace stickslip::studies {

/// kappa = (mu_s - mu_m) alpha N, N s/m.
[[nodiscard]] double weakening(const data::FrictionLaw& friction, double normal_force);

/// A contact as the search for sigma* sees it.
struct ContactDynamics {
  analytic::Mobility mobility;      ///< Y(s), or W(exp(-s h))
  std::vector<double> frequencies;  ///< rad/s, ascending from 0: Re Z is searched from the first to the last
  /// Re Z -> limiting_mass sigma + limiting_damping for omega -> infinity; kg, N s/m.
  double limiting_mass{std::numeric_limits<double>::infinity()};
  double limiting_damping{};
};

/// sigma*, 1/s, to 1e-4 of itself; 0 if it is below 1e-6 of the lowest frequency, infinity if it is above
/// 1000 times the highest. The minimum over omega is searched and not proven: 16 values between neighbouring
/// frequencies, refined about each local minimum that is near to kappa. The limit is taken into account.
[[nodiscard]] double growth_bound(const ContactDynamics& contact, double kappa);

/// Whether sigma* <= sigma: one search, with sigma > 0.
[[nodiscard]] bool grows_at_most(const ContactDynamics& contact, double kappa, double sigma);

/// The beam itself, with the frequencies up to mode 40 and the limit above. Throws what TipMobility throws.
[[nodiscard]] ContactDynamics continuous_contact(const data::Beam& beam, const data::Damping& damping = {});

/// sigma* of the beam itself, 1/s. Throws what TipMobility throws.
[[nodiscard]] double beam_growth_bound(const data::Beam& beam, const data::FrictionLaw& friction,
                                       const data::Damping& damping = {});

/// A ContactSystem in continuous time.
[[nodiscard]] ContactDynamics continuous_contact(const solver::ContactMobility& mobility);

/// A ContactSystem in steps of generalised-alpha.
[[nodiscard]] ContactDynamics stepped_contact(const solver::ContactMobility& mobility, double time_step,
                                              double spectral_radius);

/// The beam in the steps of boundary_integral.hpp.
[[nodiscard]] ContactDynamics stepped_contact(const data::Beam& beam, double time_step, int stages);

/// The matrices of a ContactModel: held modes and, last, the contact. It has no load and a wall at rest.
[[nodiscard]] solver::ContactSystem contact_system(const analytic::ContactModel& model);

/// A ContactModel in continuous time, which is what the event-driven engine computes: in its held modes, or
/// in its free ones if it has them (without damping).
[[nodiscard]] ContactDynamics continuous_contact(const analytic::ContactModel& model);

/// The system with a radiating termination: `mass`, kg, is taken from the contact's degree of freedom and
/// hung on it by a dashpot, N s/m, as one degree of freedom more. Slow motions find the mass in its place;
/// fast ones, which a mesh cannot resolve, work against the dashpot, as they would against the waves that
/// they send into the beam. With a dashpot of kappa, Re Z >= kappa at high frequencies. The base accelerates
/// the mass as it does the contact's own. Precondition: 0 < mass < m_c, or M is no longer positive definite.
[[nodiscard]] solver::ContactSystem with_radiating_contact(const solver::ContactSystem& system, double mass,
                                                           double dashpot);

}  // namespace stickslip::studies
