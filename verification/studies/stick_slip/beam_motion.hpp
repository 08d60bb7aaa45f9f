#pragma once

/// The motion of the whole beam, y(x,t), by either implementation (Fig. 3).

#include <optional>
#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// Where and when a motion is sampled.
struct MotionGrid {
  double start{};   ///< s
  double length{};  ///< of the window, s
  int snapshots{};  ///< evenly over the window, its ends included; each at the nearest time step
  int positions{};  ///< evenly from the clamp to the tip, both included
};

/// Snapshots of the beam.
struct BeamMotion {
  struct Snapshot {
    double time{};                     ///< s
    bool sticks{};                     ///< else the tip slips
    double friction_force{};           ///< f of Eq. (28), N
    std::vector<double> displacement;  ///< y at each position, m
  };
  std::vector<double> position;  ///< x, m
  std::vector<Snapshot> snapshots;
};

/// By finite elements; event by event in numerics.modes() modes of the continuous beam; by the closed form of
/// the stick state, Eq. (27), exact steady part. All three use excitation and numerics.time_step() of the
/// problem for the times; the first two its damping. Throw std::invalid_argument, naming it, if the grid has
/// less than two snapshots or positions, begins before 0 or has more snapshots than its window has steps; and
/// what BeamSimulation, BeamContactModel and StickResponse throw.
[[nodiscard]] BeamMotion finite_element_motion(const data::Case& problem, const MotionGrid& grid);
[[nodiscard]] BeamMotion event_driven_motion(const data::Case& problem, const MotionGrid& grid);
[[nodiscard]] BeamMotion closed_form_motion(const data::Case& problem, const MotionGrid& grid, int modes);

/// By the free modes of the continuous beam, propagated exactly (analytic::FreeModeRun), with so many steps
/// in a numerics.time_step(). Undamped: the damping of the problem is not used. The times, and what is
/// thrown, as above.
[[nodiscard]] BeamMotion free_mode_motion(const data::Case& problem, const MotionGrid& grid,
                                          int steps_per_time_step);

/// Largest |y| of a motion, m.
[[nodiscard]] double peak(const BeamMotion& motion);

/// Largest difference of two motions on the same grid over the snapshots up to a time, m.
[[nodiscard]] double largest_difference(const BeamMotion& a, const BeamMotion& b, double until);

/// What finite elements may differ by from the closed form in the stick state, over the snapshots of the grid
/// up to a time, m: with g_n of Eq. (26), and its like by frequency_on_mesh() and stepped_from_rest(),
///
///     max over x, t of A0 sum_n |U_n(x) Omega^2 C_n| |g_n,h(t) - g_n(t)|  +  (Omega h)^2/4 max|y|,
///
/// phase, amplitude and resonance of every mode, and the steady response of the time-stepping method.
[[nodiscard]] double predicted_stick_difference(const data::Case& problem, const MotionGrid& grid,
                                                double until, int modes);

/// One panel of Fig. 3: finite elements against a reference without a mesh.
struct BeamMotionStudy {
  double frequency_hz{};
  double amplitude{};  ///< m
  double window{};     ///< begin of the period drawn, s
  BeamMotion finite_element;
  BeamMotion reference;              ///< closed form if the tip sticks throughout, else free modes
  double half_width{};               ///< of the reference, m: twice its change on twice the step
  std::optional<double> first_slip;  ///< of the reference within the window, s
  double peak{};                     ///< max |y| of the reference, m
  double stick_difference{};         ///< largest difference up to the first slip, m
  double predicted_stick_difference{};
  double difference{};  ///< largest difference of all snapshots, m
};

/// One period of the excitation: the first one if the tip sticks throughout numerics.duration(), else from a
/// quarter of a period before the first slip (or from 0, if that is later). Undamped problems only.
[[nodiscard]] BeamMotionStudy beam_motion_study(const data::Case& problem, int snapshots, int positions);

}  // namespace stickslip::studies
