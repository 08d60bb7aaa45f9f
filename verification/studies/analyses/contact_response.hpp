// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "stickslip/analytic/modal_contact_run.hpp"
#include "stickslip/data/problem.hpp"
#include "studies/common/problem_parameter.hpp"
#include "studies/history/history.hpp"

namespace stickslip::studies {

/// Numbers that say something about a whole motion.
struct MotionValues {
  double slip_share{};     ///< share of the time in slip
  double peak_speed{};     ///< largest sliding speed, m/s
  double rms_speed{};      ///< root of the mean square of the sliding speed over all the time, m/s
  double travel{};         ///< distance slid in a period of the base motion, m
  double work{};           ///< energy that friction dissipates in a period, J
  double largest_force{};  ///< largest |f|, N
  double sticks{};         ///< number of times in a period that the tip comes to stick
  double period{};  ///< of the motion in periods of the base motion, 1 ... 16; 0 if none of these is found
  double travel_rate{};       ///< distance slid, m/s
  double power{};             ///< that friction dissipates, W
  double slip_rate{};         ///< slips, 1/s: how often the tip begins to slip
  double slips_per_travel{};  ///< their number over the distance slid, 1/m; 0 without one
  double peak_to_peak{};      ///< max z - min z of the displacement z of the tip on the wall, m
  double
      distance_95{};  ///< 95th percentile of |z - mean z|, m; of at least 32 values in a period, at most 2^21
  double distance_99{};  ///< 99th percentile, m
};

struct MotionQuantity {
  std::string_view name;          ///< "peak-speed", as map --quantity takes it
  std::string_view column, unit;  ///< of a table
  std::string_view label;         ///< of a figure
  double MotionValues::*value;
  bool is_of_a_period{};  ///< so that it needs a base motion of one sine
};

inline constexpr std::array motion_quantities{
    MotionQuantity{"slip-share", "slip_share", "1", "share of the time in slip", &MotionValues::slip_share},
    MotionQuantity{"peak-speed", "peak_speed_m_per_s", "m/s", "largest sliding speed / (m/s)",
                   &MotionValues::peak_speed},
    MotionQuantity{"rms-speed", "rms_speed_m_per_s", "m/s", "rms sliding speed / (m/s)",
                   &MotionValues::rms_speed},
    MotionQuantity{"travel", "travel_m", "m", "travel in a period / m", &MotionValues::travel, true},
    MotionQuantity{"work", "work_J", "J", "work of friction in a period / J", &MotionValues::work, true},
    MotionQuantity{"largest-force", "largest_force_N", "N", "largest |f| / N", &MotionValues::largest_force},
    MotionQuantity{"sticks", "sticks", "1", "sticks in a period", &MotionValues::sticks, true},
    MotionQuantity{"period", "period", "1", "period of the motion", &MotionValues::period, true},
    MotionQuantity{"travel-rate", "travel_m_per_s", "m/s", "travel / (m/s)", &MotionValues::travel_rate},
    MotionQuantity{"power", "power_W", "W", "power of friction / W", &MotionValues::power},
    MotionQuantity{"slip-rate", "slips_per_s", "1/s", "slips / (1/s)", &MotionValues::slip_rate},
    MotionQuantity{"slips-per-travel", "slips_per_m", "1/m", "slips over travel / (1/m)",
                   &MotionValues::slips_per_travel},
    MotionQuantity{"peak-to-peak", "peak_to_peak_m", "m", "peak to peak of tip on wall / m",
                   &MotionValues::peak_to_peak},
    MotionQuantity{"distance-95", "distance_95_m", "m", "95 % of |distance from mean| / m",
                   &MotionValues::distance_95},
    MotionQuantity{"distance-99", "distance_99_m", "m", "99 % of |distance from mean| / m",
                   &MotionValues::distance_99}};

/// The quantity with this name. Throws std::invalid_argument if there is none.
[[nodiscard]] const MotionQuantity& motion_quantity(std::string_view name);

/// A quantity with its convergence check.
struct ResponseValue {
  double value{};
  /// The spread of four values over the largest of them, 0 ... 1: of the record, of each half of it, and of the
  /// record with twice the time step. The spread of a share of slip includes one step for each slip, and that of a number of slips or sticks
  /// those that ModalContactRun::may_hide_stick(). For a period 0 if all four are found and the same, else 1. 1 if the motion is not
  /// finite.
  double change{};
};

struct ContactResponse {
  bool slips{};  ///< after the transient
  MotionValues values, changes;

  [[nodiscard]] ResponseValue operator[](const MotionQuantity& quantity) const {
    return {values.*quantity.value, changes.*quantity.value};
  }
};

/// How a response is cut into periods of the base motion, of a general one into those of its highest frequency.
struct ResponseGrid {
  int steps_per_period{};
  int transient{};  ///< periods that do not count
  int recorded{};   ///< periods that do, an even number
};

/// An even number, at least 32, such that the step is at most numerics.time_step. Throws data::FieldError,
/// naming that, for more than 2e8.
[[nodiscard]] int steps_per_period(const data::Case& problem);

/// Throws as steps_per_period(), and data::FieldError, naming excitation.duration, unless that holds the
/// transient (s) and two more periods.
[[nodiscard]] ResponseGrid response_grid(const data::Case& problem, double transient);

/// The model of the beam with numerics.modes() modes of the held tip. Throws what
/// analytic::HeldBeam throws.
[[nodiscard]] analytic::ContactModel response_model(const data::Case& problem);

/// Runs a case from the quasi-static start by analytic::ModalContactRun, twice. The period is that of the
/// amplitudes of all modes at the ends of the periods of the base motion (period_of()). `modes`, if given, are those
/// of response_model(). Throws what response_grid(), response_model() and ModalContactRun throw.
[[nodiscard]] ContactResponse contact_response(const data::Case& problem, double transient,
                                               const analytic::ContactModes* modes = nullptr);

/// The smallest p from 1 to 16 such that each sample is the same as the one p later, to 1e-3 of the largest
/// norm of all samples and, for p > 1, to 1e-2 of the largest difference of two successive ones: a free
/// vibration that has not decayed yet may come back after some periods, but not so exactly. 0 if there is none,
/// or if there are fewer than 2 p samples.
[[nodiscard]] int period_of(std::span<const std::vector<std::complex<double>>> samples);

struct SweepPoint {
  bool up{};
  double value{};
  /// The Poincare section: the tip at the begin of each period of the base motion, h = 0 and h_t > 0; y(L), v_s and the
  /// mean f over the step before.
  std::vector<HistoryRow> section;
  int period{};  ///< as of period_of()
  bool slips{};  ///< in the periods of the section
};

enum class SweepDirection { up, down, both };

/// A quasi-static sweep by analytic::ModalContactRun.
struct SweepTask {
  data::Case problem;
  std::string_view parameter;  ///< the path of its key
  std::vector<double> values;  ///< ascending, SI units
  SweepDirection direction{};
  int settle{};   ///< periods of the base motion that pass at each value
  int periods{};  ///< periods after those, at which the section is taken
};

/// Follows the motion over the values of one parameter, up, down, or up and then down. The first value starts
/// quasi-statically, each other one from the end of the one before, between two periods: the amplitudes of the
/// held modes, their rates, the position of the tip on the wall and its sliding velocity go on. What up and
/// down differ in is hysteresis. `progress`, if given, receives the share done. Throws data::FieldError for a
/// value that its field refuses, and what response_model() and ModalContactRun throw.
[[nodiscard]] std::vector<SweepPoint> parameter_sweep(const SweepTask& task,
                                                      const std::function<void(double)>& progress = {});

/// At how many values up and down have other sections, by more than 1 % of the larger |f| in the smallest or the largest f.
struct Hysteresis {
  std::size_t moving{};   ///< the tip slips, up, down or both
  std::size_t resting{};  ///< it sticks both times, at another place
};
[[nodiscard]] Hysteresis hysteresis_of(const std::vector<SweepPoint>& points);

}  // namespace stickslip::studies
