// SPDX-License-Identifier: MIT
#pragma once

/// The members of a result with their units, listed once beside it: JSON, tables and templates follow from the list.

#include <type_traits>

/// Lists the members of a type, in whose namespace it stands: each with its unit, "1" for a pure number and "-" for a
/// word, or without one if it is described itself. A member function is called:
///
///     STICKSLIP_MEMBERS(Interval, (from, "m"), (to, "m"), (length(), "m"), (error))
#define STICKSLIP_MEMBERS(Type, ...)                                      \
  template <typename Visit>                                               \
  constexpr void visit_members(std::type_identity<Type>, Visit&& visit) { \
    STICKSLIP_EXPAND(STICKSLIP_VISIT_EACH(__VA_ARGS__))                   \
  }
#define STICKSLIP_VISIT(member, ...) \
  visit(#member, "" __VA_ARGS__, [](const auto& value) -> decltype(auto) { return (value.member); });

// The macro cannot name itself, but every round of STICKSLIP_EXPAND lets it go on: for 27 members at most.
#define STICKSLIP_VISIT_EACH(member, ...) \
  STICKSLIP_VISIT member __VA_OPT__(STICKSLIP_VISIT_AGAIN STICKSLIP_PARENTHESES(__VA_ARGS__))
#define STICKSLIP_VISIT_AGAIN() STICKSLIP_VISIT_EACH
#define STICKSLIP_PARENTHESES ()
#define STICKSLIP_EXPAND(...) STICKSLIP_EXPAND_2(STICKSLIP_EXPAND_2(STICKSLIP_EXPAND_2(__VA_ARGS__)))
#define STICKSLIP_EXPAND_2(...) STICKSLIP_EXPAND_1(STICKSLIP_EXPAND_1(STICKSLIP_EXPAND_1(__VA_ARGS__)))
#define STICKSLIP_EXPAND_1(...) STICKSLIP_EXPAND_0(STICKSLIP_EXPAND_0(STICKSLIP_EXPAND_0(__VA_ARGS__)))
#define STICKSLIP_EXPAND_0(...) __VA_ARGS__

namespace stickslip::studies {

/// A type whose members are listed. (clang 14 takes every type for one if a lambda stands here.)
template <typename T>
concept Described = requires {
  visit_members(std::type_identity<T>{}, nullptr);
};

}  // namespace stickslip::studies
