// SPDX-License-Identifier: MIT
#pragma once

/// A bound of the rate at which two solutions of one contact problem may separate (theory.md, Section 11). It
/// follows from the discretised system and is known before any run.
///
/// Let Y be the mobility of the contact (tip_mobility.hpp, contact_mobility.hpp), Z = 1/Y, and κ the
/// Lipschitz constant of the falling part of the friction law. σ* is the smallest σ ≥ 0 with
/// Re Z(σ + i ω) ≥ κ for all ω. The difference of two solutions grows at most like
/// exp(σ* t). For a discretisation with a constant friction force per step, Y is replaced by the mobility
/// W(ζ) of the steps. With ζ = exp(-s h) it is a function of s, and the range of ω ends at π/h.
///
/// Known values of σ* in closed form:
/// - A finite undamped system with symmetric stiffness, in continuous time: σ* = κ/m_c, where m_c is the
///   effective mass for an impulse at the contact, because Z - m_c s is passive and vanishes for |s| -> infinity.
///   For a mass m, with or without a spring, σ* = κ/m. For N free modes with the participation g each,
///   σ* = κ N g. For a mesh, σ* is proportional to 1/l.
/// - The undamped beam: at high frequencies Y(i ω) = i c (tan x - 1) with the phase x = β L, so that
///   Re Z/σ -> (dx/domega)/(c (sin x - cos x)²). This is 2/g at the poles of Y and at least 1/g, with g
///   = 4/(ρ A L). Hence σ* ≥ 4 κ/(ρ A L) for any P.

#include <limits>
#include <vector>

#include "stickslip/analytic/boundary_integral.hpp"
#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/data/problem.hpp"
#include "stickslip/solver/contact_mobility.hpp"

namespace stickslip::studies {

/// The Lipschitz constant κ = (μ_s - μ_m) α N of the falling part of the friction law, N s/m.
[[nodiscard]] double weakening(const data::FrictionLaw& friction, double normal_force);

/// A contact as the search for σ* sees it.
struct LinearContact {
  analytic::Mobility mobility;      ///< Y(s), or W(exp(-s h))
  std::vector<double> frequencies;  ///< rad/s, ascending from 0; Re Z is searched from the first to the last
  /// Re Z -> limiting_mass σ + limiting_damping for ω -> infinity; kg, N s/m.
  double limiting_mass{std::numeric_limits<double>::infinity()};
  double limiting_damping{};
};

/// σ*, 1/s, to 1e-4 of itself; 0 if it is below 1e-6 of the lowest frequency, infinity if it is above
/// 1000 times the highest. The minimum over ω is searched and not proven: 16 values between neighbouring
/// frequencies, refined about each local minimum that is near to κ. The limit is taken into account.
[[nodiscard]] double growth_bound(const LinearContact& contact, double kappa);

/// Whether σ* ≤ σ: one search, with σ > 0.
[[nodiscard]] bool grows_at_most(const LinearContact& contact, double kappa, double sigma);

/// The damped beam of a case itself, with the frequencies up to mode 40 and the limit above. Throws what TipMobility throws.
[[nodiscard]] LinearContact continuous_contact(const data::Case& problem);

/// σ* of the continuous beam, 1/s. Throws what TipMobility throws.
[[nodiscard]] double beam_growth_bound(const data::Case& problem);

/// A ContactSystem in continuous time.
[[nodiscard]] LinearContact continuous_contact(const solver::ContactMobility& mobility);

/// A ContactSystem in steps of generalised-alpha.
[[nodiscard]] LinearContact stepped_contact(const solver::ContactMobility& mobility, double time_step,
                                            double spectral_radius);

/// The beam in the steps of boundary_integral.hpp.
[[nodiscard]] LinearContact stepped_contact(const data::Beam& beam, double time_step, int stages);

/// The matrices of a ContactModel: the held modes and, as the last degree of freedom, the contact. The result
/// has no load, and its wall is at rest.
[[nodiscard]] solver::ContactSystem contact_system(const analytic::ContactModel& model);

/// A ContactModel in continuous time, which is what the event-driven engine computes.
[[nodiscard]] LinearContact continuous_contact(const analytic::ContactModel& model);

/// The system with a radiating termination: `mass` (kg) is taken from the degree of freedom of the contact
/// and attached to it by a dashpot (N s/m) as an additional degree of freedom. In slow motions this mass
/// moves with the contact. In fast motions, which a mesh cannot resolve, the dashpot dissipates energy, as
/// the beam does by the waves that travel away from the contact. With a dashpot of κ, Re Z ≥ κ at
/// high frequencies. The base acceleration loads the additional mass like the mass of the contact.
/// Precondition: 0 < mass < m_c, so that M remains positive definite.
[[nodiscard]] solver::ContactSystem with_radiating_contact(const solver::ContactSystem& system, double mass,
                                                           double dashpot);

}  // namespace stickslip::studies
