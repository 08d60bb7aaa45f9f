#pragma once

/// Numbers and plain text as LaTeX.

#include <string>
#include <string_view>

namespace stickslip::report {

/// Fixed notation with this many decimals: (-0.5, 2) is "\ensuremath{-0.50}". A value that rounds to zero has
/// no sign. All three throw std::invalid_argument unless the value is finite.
[[nodiscard]] std::string fixed(double value, int decimals);

/// Fixed notation with at least this many significant digits; digits before the decimal point all stay:
/// (0.012345, 3) is "0.0123", (30465.4, 3) is "30465".
[[nodiscard]] std::string significant(double value, int digits);

/// A mantissa with this many significant digits and a power of ten: (4.276e-1, 2) is
/// "\ensuremath{4.3\times10^{-1}}"; zero is "0".
[[nodiscard]] std::string scientific(double value, int digits);

/// Escapes the ten characters that LaTeX reserves.
[[nodiscard]] std::string escape(std::string_view text);

/// Plain-text notation typeset, the rest escaped: "10^-6 m^4", "rho A", "omega_n", "|f_max| <= mu_s P" and
/// "1 x 2" become superscripts, Greek letters, subscripts, relations and a multiplication sign.
[[nodiscard]] std::string typeset(std::string_view text);

}  // namespace stickslip::report
