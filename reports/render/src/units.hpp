#pragma once

namespace stickslip::report {

inline constexpr double millimetre = 1e-3;   // m
inline constexpr double millisecond = 1e-3;  // s

}  // namespace stickslip::report
