// SPDX-License-Identifier: MIT
#pragma once

#include <gsl/gsl_matrix.h>

#include <complex>
#include <string>
#include <tuple>
#include <vector>

namespace stickslip::analytic {

/// lambda, Z and W of a real matrix A with y = Re(Z z), z = W y and A = Re(Z lambda W): one eigenvalue of each complex
/// pair, Z and W row by row. Throws std::runtime_error, naming `structure`, if the eigenvectors are too nearly parallel
/// (a critically damped mode) for nine digits.
[[nodiscard]] std::tuple<std::vector<std::complex<double>>, std::vector<std::complex<double>>,
                         std::vector<std::complex<double>>>
first_order_modes(const gsl_matrix& matrix, const std::string& structure);

}  // namespace stickslip::analytic
