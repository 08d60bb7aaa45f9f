#pragma once

#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/convergence/convergence.hpp"

namespace stickslip::studies {

/// One natural frequency on a sequence of meshes against the closed form.
struct FrequencyConvergence {
  int mode{};
  double closed_form_hz{};
  std::vector<double> finite_element_hz;  ///< one per mesh
  std::vector<double> relative_error;     ///< of the eigenvalue omega^2: (omega_h^2 - omega^2)/omega^2
  std::vector<double> predicted_error;    ///< of the same: leading term l^4/720 ...
  OrderEstimate observed_order;           ///< in the element length
  double leading_constant_ratio{};        ///< error over prediction on the finest mesh: tends to 1
};

struct FrequencyStudy {
  std::vector<int> elements;
  std::vector<FrequencyConvergence> modes;
};

/// Clamped-pinned frequencies; predicted by hermite_eigenvalue_error.
[[nodiscard]] FrequencyStudy stick_frequency_study(const data::Beam& beam, int modes,
                                                   const std::vector<int>& elements);

/// Clamped-free frequencies under the follower load; predicted by (beta l)^4/720, the constant of P = 0.
[[nodiscard]] FrequencyStudy slip_frequency_study(const data::Beam& beam, int modes,
                                                  const std::vector<int>& elements);

/// Beck's flutter load, in units of EI/L^2, by coalescence of the two lowest slip frequencies.
struct FlutterStudy {
  double closed_form{};
  std::vector<int> elements;
  std::vector<double> finite_element;  ///< by bisection for the onset of a complex pair, to 1e-9
  OrderEstimate observed_order;
};
[[nodiscard]] FlutterStudy flutter_study(const data::Beam& beam, const std::vector<int>& elements);

/// Mode shapes of both states for Fig. 7, both implementations, scaled to a largest deflection of 1.
struct ModeShapeStudy {
  struct Curve {
    int mode{};
    bool slip{};
    double closed_form_hz{}, finite_element_hz{};
    std::vector<double> closed_form, finite_element;  ///< at `position`
    double largest_difference{};
  };
  std::vector<double> position;  ///< x/L
  std::vector<Curve> curves;
};
[[nodiscard]] ModeShapeStudy mode_shape_study(const data::Beam& beam, int modes, int elements, int points);

}  // namespace stickslip::studies
