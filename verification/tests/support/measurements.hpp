// SPDX-License-Identifier: MIT
#pragma once

/// What the engines answer about a random beam, as numbers with dimensions: one list, to which each transformation is applied
/// (transformations_test.cpp).

#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/data/contact_event.hpp"
#include "stickslip/solver/beam_simulation.hpp"
#include "support/random_beams.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {

/// Exponents of the units of length, mass and time.
struct Dimension {
  double length{}, mass{}, time{};
};

struct Quantity {
  double value{};
  Dimension dimension{};
  /// How far it may be off for a similar beam; none: compared bit for bit only.
  std::optional<Tolerance> of_similar{};
  bool is_odd{};  ///< changes its sign with the motion of the base
  double
      condition{};  ///< above 0, of what is proportional to the amplitude: round-off at an amplitude that is no power of two
};

/// A problem, and where and when to look at it.
struct Scene {
  StickSlipProblem problem;
  double x{}, t{};     ///< shares of the length and of the duration
  int elements{};      ///< of a mesh
  double periods{};    ///< of the excitation, the duration of a history
  bool is_mirrored{};  ///< the base moves the other way
  bool
      has_threshold{};  ///< a time stepper captures a tip that still slides at a hundredth of the base's speed
  bool measures_errors{};  ///< Quantity::of_similar is wanted
};

struct Measurement {
  std::string name;
  ForceRange force{};
  bool slips{};                    ///< needs an excitation beyond the critical amplitude
  int beams{}, similar_beams{};    ///< how many are tried in other units, and for similarity
  std::size_t least_quantities{};  ///< of all beams in other units together
  std::function<std::vector<Quantity>(const Scene&)> measure;
  bool is_exact{true};  ///< another unit that is a power of two changes no bit of it
  bool is_exact_in_mass{true};
  bool is_history{};  ///< has a mirror image
  bool is_linear{};   ///< proportional to the amplitude
};

/// For the messages of GoogleTest.
inline void PrintTo(const Measurement& row, std::ostream* stream) { *stream << row.name; }

[[nodiscard]] const std::vector<Measurement>& measurements();

/// Of the closed forms, rad/s.
[[nodiscard]] std::vector<double> stick_frequencies(const data::Beam& beam, int count);

/// A beam whose tip slips: 1.2 to 3 times the critical amplitude over one period, damped by half a percent of critical in its
/// first mode.
[[nodiscard]] StickSlipProblem slipping(const data::Beam& beam, RandomNumbers& numbers);

/// A frequency off resonance and an amplitude of 1e-6 to 1e-2 of the length.
[[nodiscard]] StickSlipProblem off_resonance(const data::Beam& beam, RandomNumbers& numbers);

/// On the mesh of the stepped histories, a hundred steps to the shorter of both periods, of the excitation and of the first mode.
inline constexpr int mesh_elements = 6;
[[nodiscard]] data::NumericalSettings settings(const StickSlipProblem& problem, double periods);

/// The time stepper on a base with any motion, started as a BeamSimulation is.
[[nodiscard]] std::unique_ptr<solver::StickSlipIntegrator> started(
    const StickSlipProblem& problem, const solver::PrescribedMotion& base,
    const solver::IntegratorSettings& settings, solver::TipContact contact = solver::TipContact::friction);

/// The motion, multiplied and delayed.
[[nodiscard]] solver::PrescribedMotion transformed(const solver::PrescribedMotion& motion, double factor,
                                                   double delay = 0.0);

/// The model of the event-driven histories, of four modes.
[[nodiscard]] analytic::ContactModel modal_model(const StickSlipProblem& problem);

/// How far two runs of one problem may differ.
struct Sensitivity {
  std::vector<data::ContactEvent>
      perturbed{};            ///< of the expected run with an amplitude that is larger by a share
  double perturbation{1e-8};  ///< this share
  double error{};             ///< relative error of the data or the steps
  double amplitude{};         ///< measure of positions, m
};

/// The tolerances of the time and the position of each event: `error` times the time plus its slope, and `error` times the slope
/// of the position; slopes are the largest change per share so far in the perturbed run, of positions at least the amplitude.
struct EventTolerances {
  Tolerance time, position;
};
[[nodiscard]] std::vector<EventTolerances> tolerances(const std::vector<data::ContactEvent>& events,
                                                      const Sensitivity& sensitivity);

void expect_same_events(const std::vector<data::ContactEvent>& computed,
                        const std::vector<data::ContactEvent>& expected, const Sensitivity& sensitivity);

/// Relative errors of stepped histories: round-off in the data of the mesh, n^4 times the last digit, and events located to 1e-11
/// of a step; and of event-driven ones: the integrator's tolerance in each of its steps, whose errors have either sign.
inline constexpr double stepped_error = 4.0 * 6 * 6 * 6 * 6 * 0x1p-52 + 1e-11;
inline constexpr double event_driven_error = 1e-12;

}  // namespace stickslip::testing
