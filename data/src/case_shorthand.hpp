// SPDX-License-Identifier: MIT
#pragma once

/// Keys of a case file that stand for others: a section by its shape, a material by its name, a shear stiffness by
/// Poisson's ratio, the motion of the base by the amplitude of its velocity or acceleration.

#include <span>
#include <string_view>

#include "case_entry.hpp"

namespace stickslip::data {

/// "section.shape", ...; in the order of the manual.
[[nodiscard]] std::span<const std::string_view> shorthand_keys();

/// Adds what the shorthand stands for. Throws FieldError, naming the shorthand, for a value that it does not allow,
/// InputError if a quantity is given in two ways or a key of a shape is missing.
void expand_shorthand(Entries& entries);

/// Takes out of the entries what the key replaces: of the amplitudes of displacement, velocity and
/// acceleration one alone is given, and the duration and the shear stiffness once.
void erase_alternatives(std::string_view key, Entries& entries);

}  // namespace stickslip::data
