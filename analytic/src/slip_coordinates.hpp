#pragma once

/// The two sets of coordinates in which a slip phase can be integrated.

#include <memory>
#include <span>
#include <vector>

#include "contact_dynamics.hpp"

namespace stickslip::analytic {

/// Coordinates q of the structure with a free contact, u_c = contact(q).
class SlipCoordinates {
 public:
  virtual ~SlipCoordinates() = default;

  [[nodiscard]] virtual std::size_t size() const = 0;
  /// The highest angular frequency, rad/s, and the mass that makes a velocity of q one of the contact, kg.
  [[nodiscard]] virtual double fastest() const = 0;
  [[nodiscard]] virtual double mass_of(std::size_t coordinate) const = 0;

  /// q_tt under the load factor s and the contact force f; linear in all four arguments.
  virtual void accelerate(std::span<const double> q, std::span<const double> q_t, double s, double f,
                          std::span<double> q_tt) const = 0;
  [[nodiscard]] virtual double contact(std::span<const double> q) const = 0;

  /// From and to the coordinates of the held contact. `force` is f_d.
  virtual void set(const ContactKinematics& state, double t, double force, std::span<double> q,
                   std::span<double> q_t) const = 0;
  [[nodiscard]] virtual ContactKinematics held(std::span<const double> q,
                                               std::span<const double> q_t) const = 0;
};

/// (T, u_c) themselves, or the free modes if the model has them.
[[nodiscard]] std::unique_ptr<SlipCoordinates> make_slip_coordinates(const ContactDynamics& dynamics);

}  // namespace stickslip::analytic
