// SPDX-License-Identifier: MIT
#pragma once

/// The states of the contact and their changes, as both implementations report them.

#include <array>
#include <cstddef>
#include <string_view>

namespace stickslip::data {

enum class ContactState { stick, slip };

enum class ContactChange {
  onset,     ///< stick to slip: |f_d| reached μ_s N
  capture,   ///< slip to stick
  reversal,  ///< slip to slip in the other direction
  graze      ///< the sliding velocity touched zero and goes on in the same direction
};

struct ContactEvent {
  ContactChange change{};
  double time{};               ///< s
  double position{};           ///< of the contact on the wall, u_c - w, m
  double residual_velocity{};  ///< v_s that was left when a time stepper took the event, m/s
};

/// The name of the enumerator: "stick", "onset".
[[nodiscard]] constexpr std::string_view to_string(ContactState state) noexcept {
  return state == ContactState::stick ? "stick" : "slip";
}
[[nodiscard]] constexpr std::string_view to_string(ContactChange change) noexcept {
  constexpr std::array<std::string_view, 4> names{"onset", "capture", "reversal", "graze"};
  return names[static_cast<std::size_t>(change)];
}

}  // namespace stickslip::data
