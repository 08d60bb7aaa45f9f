// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "contact_motion.hpp"

namespace stickslip::solver {

/// A ContactScheme: decides when the contact changes.
class ContactDriver {
 public:
  virtual ~ContactDriver() = default;

  /// Takes the motion towards end_time, the end of its grid step: there, or to a change of the contact.
  virtual void advance(ContactMotion& motion, double end_time) const = 0;
};

[[nodiscard]] std::unique_ptr<const ContactDriver> make_driver(const ContactMotion& motion);

}  // namespace stickslip::solver
