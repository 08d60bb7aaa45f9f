// SPDX-License-Identifier: MIT
#pragma once

/// The motion y(x,t) of the whole beam by several methods (Fig. 3).

#include <optional>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// The times and positions at which a motion is sampled.
struct MotionGrid {
  double start{};   ///< s
  double length{};  ///< of the window, s
  int snapshots{};  ///< number of times, evenly spaced including both ends; each is rounded to a time step
  int positions{};  ///< number of positions, evenly spaced from clamp to tip, both included
};

/// The deflection of the beam at several times.
struct BeamMotion {
  struct Snapshot {
    double time{};                     ///< s
    bool sticks{};                     ///< otherwise the tip slips
    double friction_force{};           ///< f of Eq. (28), N
    std::vector<double> displacement;  ///< y at each position, m
  };
  std::vector<double> position;  ///< x, m
  std::vector<Snapshot> snapshots;
};
STICKSLIP_MEMBERS(BeamMotion::Snapshot, (time, "s"), (sticks, "1"), (friction_force, "N"),
                  (displacement, "m"))
STICKSLIP_MEMBERS(BeamMotion, (position, "m"), (snapshots))

/// The motion by three methods: finite elements; the event-driven method with numerics.modes() modes of the
/// continuous beam; and the closed form of the stick state, Eq. (27), with the exact steady part. All use the
/// excitation and numerics.time_step() of the problem; the first two also use its damping. They throw
/// data::FieldError, naming the field, if the grid has fewer than two snapshots or positions, begins before 0
/// or has more snapshots than time steps, and what BeamSimulation, BeamContactModel and StickResponse throw.
[[nodiscard]] BeamMotion finite_element_motion(const data::Case& problem, const MotionGrid& grid);
[[nodiscard]] BeamMotion event_driven_motion(const data::Case& problem, const MotionGrid& grid);
[[nodiscard]] BeamMotion closed_form_motion(const data::Case& problem, const MotionGrid& grid, int modes);

/// The largest |y| of a motion, m.
[[nodiscard]] double peak(const BeamMotion& motion);

/// The largest difference (m) of two motions on the same grid over the snapshots up to the time `until` (s).
[[nodiscard]] double largest_difference(const BeamMotion& a, const BeamMotion& b, double until);

/// Predicted bound of the difference (m) between finite elements and closed form in the stick state, over the
/// snapshots up to the time `until` (s). With g_n of Eq. (26), and g_n,h by frequency_on_mesh() and
/// stepped_from_rest(), it is
///
///     max over x, t of A0 sum_n |U_n(x) Omega^2 C_n| |g_n,h(t) - g_n(t)|  +  (Omega h)^2/4 max|y|.
///
/// The sum contains the errors of phase, amplitude and resonance of each of 60 modes. The last term is the error of
/// the steady response of the time integration.
[[nodiscard]] double predicted_stick_difference(const data::Case& problem, const MotionGrid& grid,
                                                double until);

/// One panel of Fig. 3: finite elements compared with a reference without a mesh.
struct BeamMotionStudy {
  double frequency_hz{};
  double amplitude{};  ///< m
  BeamMotion finite_element;
  BeamMotion reference;              ///< closed form if the tip always sticks, otherwise free modes
  double half_width{};               ///< of the reference, m: twice its change when the step is doubled
  std::optional<double> first_slip;  ///< first slip within numerics.duration() by the closed form, s
  double peak{};                     ///< max |y| of the reference, m
  double stick_difference{};         ///< largest difference up to the first slip, m
  double predicted_stick_difference{};
  double difference{};  ///< largest difference over all snapshots, m
  /// Both over the peak.
  [[nodiscard]] double relative_difference() const { return difference / peak; }
  [[nodiscard]] double relative_half_width() const { return half_width / peak; }
};
STICKSLIP_MEMBERS(BeamMotionStudy, (frequency_hz, "Hz"), (amplitude, "m"), (finite_element), (reference),
                  (half_width, "m"), (first_slip, "s"), (peak, "m"), (stick_difference, "m"),
                  (predicted_stick_difference, "m"), (difference, "m"), (relative_difference(), "1"),
                  (relative_half_width(), "1"))

/// Compares one period of the excitation: the first period if the tip sticks throughout numerics.duration(),
/// otherwise the period that begins a quarter of a period before the first slip (but not before t = 0). For
/// undamped problems only.
[[nodiscard]] BeamMotionStudy beam_motion_study(const data::Case& problem, int snapshots, int positions);

}  // namespace stickslip::studies
