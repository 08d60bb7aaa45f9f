// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/convergence.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// One natural frequency on a sequence of meshes, compared with the closed form.
struct FrequencyConvergence {
  int mode{};
  double closed_form_hz{};
  std::vector<double> finite_element_hz;  ///< one per mesh
  std::vector<double> relative_error;     ///< of the eigenvalue ω²: (ω_h² - ω²)/ω²
  std::vector<double> predicted_error;    ///< of the eigenvalue, leading term of order l⁴
  OrderEstimate observed_order;           ///< in the element length
  double leading_constant_ratio{};        ///< error over predicted error on the finest mesh; tends to 1
};
STICKSLIP_MEMBERS(FrequencyConvergence, (mode, "1"), (closed_form_hz, "Hz"), (finite_element_hz, "Hz"),
                  (relative_error, "1"), (predicted_error, "1"), (observed_order),
                  (leading_constant_ratio, "1"))

/// The convergence of several natural frequencies on the same meshes.
struct FrequencyStudy {
  std::string state;  ///< "stick" or "slip"
  std::vector<int> elements;
  std::vector<double> element_length;  ///< m
  std::vector<FrequencyConvergence> modes;
};
STICKSLIP_MEMBERS(FrequencyStudy, (state, "-"), (elements, "1"), (element_length, "m"), (modes))

/// Clamped-pinned frequencies (stick state). The error is predicted by hermite_eigenvalue_error().
[[nodiscard]] FrequencyStudy stick_frequency_study(const data::Beam& beam, int modes,
                                                   const std::vector<int>& elements);

/// Clamped-free frequencies under the follower load (slip state). The error is predicted by (β l)⁴/720,
/// which is the leading term at P = 0.
[[nodiscard]] FrequencyStudy slip_frequency_study(const data::Beam& beam, int modes,
                                                  const std::vector<int>& elements);

/// Beck's flutter load in units of EI/L², at which the two lowest slip frequencies coalesce.
struct FlutterStudy {
  double closed_form{};
  std::vector<int> elements;
  std::vector<double> finite_element;  ///< onset of a complex pair by bisection, to 1e-9
  OrderEstimate observed_order;
  [[nodiscard]] std::vector<double> relative_error() const;  ///< of `finite_element`
};
STICKSLIP_MEMBERS(FlutterStudy, (closed_form, "1"), (elements, "1"), (finite_element, "1"), (observed_order),
                  (relative_error(), "1"))
[[nodiscard]] FlutterStudy flutter_study(const data::Beam& beam, const std::vector<int>& elements);

/// Mode shapes of both states for Fig. 7 by both implementations, scaled to a largest deflection of 1.
struct ModeShapeStudy {
  struct Curve {
    int mode{};
    bool slip{};
    double closed_form_hz{}, finite_element_hz{};
    std::vector<double> closed_form, finite_element;  ///< at `position`
    double largest_difference{};
    [[nodiscard]] const char* state() const { return slip ? "slip" : "stick"; }
    [[nodiscard]] double relative_error() const { return finite_element_hz / closed_form_hz - 1.0; }
  };
  std::vector<double> position;  ///< x/L
  std::vector<Curve> curves;
};
STICKSLIP_MEMBERS(ModeShapeStudy::Curve, (mode, "1"), (slip, "1"), (closed_form_hz, "Hz"),
                  (finite_element_hz, "Hz"), (closed_form, "1"), (finite_element, "1"),
                  (largest_difference, "1"), (state(), "-"), (relative_error(), "1"))
STICKSLIP_MEMBERS(ModeShapeStudy, (position, "1"), (curves))
[[nodiscard]] ModeShapeStudy mode_shape_study(const data::Beam& beam, int modes, int elements, int points);

}  // namespace stickslip::studies
