// SPDX-License-Identifier: MIT
#pragma once

/// A motion of the beam in time, by whatever method it is computed (method.hpp), and the comparison of its events.

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/data/contact_event.hpp"
#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// The motion at one time. Displacements are absolute, y = h + u.
struct HistoryRow {
  double time{};                  ///< s
  double base_displacement{};     ///< h, m
  double tip_displacement{};      ///< y(L), m
  double midspan_displacement{};  ///< y(L/2), m
  double sliding_velocity{};      ///< v_s, m/s
  double friction_force{};        ///< f of Eq. (28), N
  data::ContactState state{data::ContactState::stick};
  std::vector<double> displacement{};  ///< y at Sampling::positions, m

  // With Sampling::with_reactions. What the base must apply to the structure, positive along y and along the slope y'; what [damping]
  // adds acts between structure and base, so that only its own inertia, friction, loads and supports move the whole.
  double tip_acceleration{};  ///< y_tt(L), m/s²
  double base_reaction{};     ///< N
  double clamp_moment{};      ///< about the clamp of a beam, N m
};

/// A column that a history has where it is asked for.
struct FurtherColumn {
  std::string_view name, heading;  ///< of `respond --columns`, and in the file
  double HistoryRow::*value;
  bool of_beams_alone{};
};
inline constexpr std::array further_columns{
    FurtherColumn{"tip-acceleration", "tip_acceleration_m_per_s2", &HistoryRow::tip_acceleration},
    FurtherColumn{"base-reaction", "base_reaction_N", &HistoryRow::base_reaction},
    FurtherColumn{"clamp-moment", "clamp_moment_N_m", &HistoryRow::clamp_moment, true}};

/// How far the beam is bent at most over rows with the displacement at positions().
struct Bending {
  double deflection{};  ///< the largest |y - h| at the positions, m
  /// The largest ½ ∫ u'² dx, by which the tip of the bent beam draws back from the wall, m: from the chords between the
  /// positions and between every other one, extrapolated. Off by (k L/16)⁴/90 for a wave number k: 0.2 % in mode 3.
  double draw_back{};

  [[nodiscard]] static std::vector<double> positions(double length);  ///< 17 x from clamp to tip, m
  void include(const HistoryRow& row, double length);
};

/// The steady vibration of an undamped beam with its tip held, where it is largest: u(x) at these positions, and no other member.
[[nodiscard]] HistoryRow steady_crest(const data::Case& problem, const std::vector<double>& positions);

struct History {
  std::vector<HistoryRow> rows{};
  std::vector<data::ContactEvent>
      events{};                        ///< all changes of contact; the position is y(L), in the frame at rest
  std::optional<double> first_slip{};  ///< s; closed form: the first row with |f| > μ_s P
  /// Estimated error: the largest change of y(L) over the rows on twice the step of the method, m.
  std::optional<double> step_effect{};
  std::optional<HistoryRow> off_law{};  ///< the first row that hold_to_law() found off the law of its contact
  long rows_off_law{};
};

STICKSLIP_MEMBERS(HistoryRow, (time, "s"), (tip_displacement, "m"), (friction_force, "N"), (state, "-"),
                  (displacement, "m"))
STICKSLIP_MEMBERS(History, (rows), (events))

/// Where a history has rows. Methods in time steps take the step next to a time.
struct Sampling {
  /// From 0 to numerics.duration(), a row each so many steps of numerics.time_step().
  long every{1};
  std::vector<double>
      times{};  ///< if any: rows at these ascending times instead, s; the run ends with the last
  std::vector<double> positions{};  ///< x of HistoryRow::displacement, 0 ... L, m
  long positions_every{1};          ///< finite elements: the time steps that have them
  bool
      with_reactions{};  ///< the further columns, by methods that do not refuse data::Feature::further_columns
  bool with_midspan{
      true};  ///< else midspan_displacement may be 0; the boundary integral takes half the time then
};

/// Receives rows as they come.
using RowSink = std::function<void(const HistoryRow&)>;

/// Beyond flutter or buckling in slip the linear model moves away without end. It is stopped where the tip is this many times the length
/// of the beam and the amplitude of the base away from the base.
inline constexpr double most_deflection = 100.0;

/// Throws data::InputError, naming the time (s), for a deflection y(L) - h (m) beyond that or one that is not finite. `motion`
/// begins the message.
void require_bounded(const data::Case& problem, double deflection, double time,
                     const std::string& motion = "the motion");

/// Hands the row to the sink or, without one, keeps it in the history. Throws as require_bounded().
void add_row(const data::Case& problem, History& history, const RowSink& sink, HistoryRow row);

/// Holds a row of a history that follows the slip to the law of its contact: in stick |f| <= μ_s P and, at a rigid
/// contact, v_s = 0; in slip f = sgn(v_s) μ(|v_s|) P at a rigid contact, and at most that at another; to 1e-9 of μ_s P.
void hold_to_law(const data::Case& problem, History& history, const HistoryRow& row);

/// Calls `row` with the step of numerics.time_step() and the time (s) of each row, ascending. Returns the step with which
/// the run ends.
long for_each_row(const data::Case& problem, const Sampling& sampling,
                  const std::function<void(long step, double time)>& row);

/// With first_slip as the first of the events.
void set_events(History& history, std::vector<data::ContactEvent> events);

/// The times n `sample` from 0 to `duration`, s.
[[nodiscard]] std::vector<double> sample_times(double duration, double sample);

/// y(L) of each row, m.
[[nodiscard]] std::vector<double> tip_displacements(const History& history);

/// The onsets and captures among the events: between them the tip sticks, or slips.
[[nodiscard]] std::vector<data::ContactEvent> onsets_and_captures(
    const std::vector<data::ContactEvent>& events);

/// The onsets and captures without micro-sticks: a stick phase shorter than `shortest_stick` (s) counts as part of
/// the slip phase around it, so its capture and its onset are removed. Slip phases are never removed, nor is a
/// stick phase at the beginning or at the end of the history.
[[nodiscard]] std::vector<data::ContactEvent> without_micro_sticks(
    const std::vector<data::ContactEvent>& events, double shortest_stick);

/// The first change from slip to stick, if there is one.
[[nodiscard]] std::optional<data::ContactEvent> first_capture(const std::vector<data::ContactEvent>& events);

/// How far events of two histories are apart.
struct EventDifference {
  double time{};      ///< s
  double position{};  ///< m
};
STICKSLIP_MEMBERS(EventDifference, (time, "s"), (position, "m"))

/// The largest differences of the first `count` events of two histories; infinite if their kinds differ or if
/// one history has fewer events.
[[nodiscard]] EventDifference largest_difference(const std::vector<data::ContactEvent>& a,
                                                 const std::vector<data::ContactEvent>& b, std::size_t count);

/// The case with another mesh, time step (s), duration (s) and, if given, spectral radius, and with the velocity threshold
/// 0. Located events do not need a threshold. A capture at |v_s| = ε would be early by ε/|v_s_t|, which
/// is 1e-5 s for the 1e-4 m/s of the paper. Throws data::FieldError.
[[nodiscard]] data::Case refined(const data::Case& problem, int elements, double time_step, double duration,
                                 const std::optional<double>& spectral_radius = std::nullopt);

// How dense the rows of a history must be for the eye and the ear.

/// The number of time steps from row to row: the largest 1, 2 or 5 times a power of ten that leaves at least 100 rows in a
/// period of the excitation, 20 in a period of the first natural frequency of the stick state and 2000 in the time `span` (s); or 1.
/// Throws what modal_forces() throws.
[[nodiscard]] long usual_row_step(const data::Case& problem, double span);

// Amplitude spectra of a history.

struct SpectrumLine {
  double frequency_hz{};
  double tip_displacement{};  ///< amplitude of y(L), m
  double friction_force{};    ///< amplitude of f, N
};

/// The last rows of a history, over which a spectrum is taken.
struct SpectrumWindow {
  std::size_t rows{};
  long periods{};  ///< of the base motion in them; 0 if the base rests
};

/// Those with the whole periods of the base motion in the second half of the duration, `every` time steps apart; with a base
/// that rests, all of that half. Throws data::FieldError, naming excitation.duration, if that has less than two periods, and naming
/// --every, if a period (with a base that rests, the half) has less than two rows or if there are more than four million.
[[nodiscard]] SpectrumWindow spectrum_window(const data::Case& problem, long every);

inline constexpr double allowed_leak = 0.01;
struct Spectrum {
  bool is_flat_top{};
  double
      leak{};  ///< 0 ... 1: how much of the amplitude (root of the share of the squares) is no harmonic of the base
  std::vector<SpectrumLine> lines;
};

/// The spectra of the last values, `row_step` (s) apart. A vibration with the period of the base has its amplitudes as lines
/// of the whole periods. Of any other vibration, as a self-excited one, a number of periods that is not whole would leak: where the lines
/// that are no harmonics of the base hold more than allowed_leak of the amplitude, or the base rests, the values less their
/// weighted mean are multiplied by the flat-top window
///
///     w_n = 1 - 1.90796 cos z + 1.07349 cos 2z - 0.18199 cos 3z,    z = 2 pi n/rows
///
/// (HFT70 of Heinzel, Ruediger & Schilling, Spectrum and spectral density estimation by the discrete Fourier transform, 2002). The
/// highest line of a vibration is then its amplitude to 0.08 %, at its frequency to half a line, and the four lines
/// on each side belong to it as well. Below eight periods of the base harmonics would overlap: these stay as they are.
///
/// Where a value jumps, as the force at a capture, the sum over rows is off: the
/// error of an amplitude is up to the sum of the jumps in a period over the number of rows in it.
[[nodiscard]] Spectrum spectrum_of(const std::vector<double>& tip_displacements,
                                   const std::vector<double>& friction_forces, const SpectrumWindow& window,
                                   double row_step);

}  // namespace stickslip::studies
