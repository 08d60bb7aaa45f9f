// SPDX-License-Identifier: MIT
#pragma once

/// Wrong models of the problem, each with a name and one typical mistake, and their results.
///
/// A wrong model combines public parts in a wrong way: changed inputs, changed factors of the modal sum (28),
/// changed matrices of a ContactSystem, or its own time integration or contact law. The code in solver/ and
/// analytic/ is not changed.

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "comparison/diagnosis/hypothesis.hpp"
#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"

namespace stickslip::comparison {

/// The quantities that can be compared.
enum class Quantity {
  stick_frequency,         ///< Hz
  slip_frequency,          ///< Hz
  participation,           ///< C_n of Eq. (25)
  quasi_static_shape,      ///< S(x) of Eq. (18)
  force_maximum,           ///< |f_max| over numerics.duration(), N
  critical_amplitude,      ///< m
  stick_force,             ///< f(t) of Eq. (28), N
  stick_displacement,      ///< y(L/2, t), m
  stick_velocity,          ///< y_t(L/2, t), m/s
  steady_amplitude,        ///< of y(L/2), m
  steady_phase,            ///< of y(L/2) against the base, rad
  steady_force_amplitude,  ///< of f, N
  steady_force_phase,      ///< of f against the base, rad
  heat,                    ///< of a period of the steady vibration, J
  contact_event,           ///< time in s of an onset or capture; infinite if it does not occur
  tip_displacement,        ///< y(L, t), m
  friction_force,          ///< f(t), N
  tip_velocity,            ///< y_t(L, t), m/s
  midspan_displacement,    ///< y(L/2, t), m
  midspan_velocity         ///< y_t(L/2, t), m/s
};

/// The number of a mode or an event from 1, x in m, the frequency of the excitation in Hz, or t in s.
enum class Abscissa { number, place, frequency, time };

/// Of the beam itself, of its largest force, while the tip is held without damping, of the steady vibration with a held tip,
/// or of a run with stick and slip.
enum class State { modal, largest, held, steady, stick_slip };

struct QuantityProperties {
  Quantity quantity{};
  std::string_view name;
  data::Norm norm{};
  Abscissa abscissa{};
  State state{};
  std::string_view field{};  ///< of a data set that has no rule for it
};

inline constexpr std::array<QuantityProperties, 20> quantities = [] {
  using enum Quantity;
  using enum Abscissa;
  using enum State;
  constexpr auto relative = data::Norm::relative, scale = data::Norm::scale;
  return std::array<QuantityProperties, 20>{
      {{stick_frequency, "stick frequency", relative, number, modal},
       {slip_frequency, "slip frequency", relative, number, modal},
       {participation, "participation", scale, number, modal},
       {quasi_static_shape, "quasi-static shape", scale, place, modal},
       {force_maximum, "force maximum", relative, frequency, largest},
       {critical_amplitude, "critical amplitude", relative, frequency, largest},
       {stick_force, "stick force", scale, time, held, "friction_force"},
       {stick_displacement, "stick displacement", scale, time, held, "midspan_displacement"},
       {stick_velocity, "stick velocity", scale, time, held, "midspan_velocity"},
       {steady_amplitude, "steady amplitude", relative, frequency, steady, "midspan_amplitude"},
       {steady_phase, "steady phase", scale, frequency, steady, "midspan_phase"},
       {steady_force_amplitude, "steady force amplitude", relative, frequency, steady, "force_amplitude"},
       {steady_force_phase, "steady force phase", scale, frequency, steady, "force_phase"},
       {heat, "heat", relative, frequency, steady, "heat"},
       {contact_event, "contact event", relative, number, stick_slip},
       {tip_displacement, "tip displacement", scale, time, stick_slip, "tip_displacement"},
       {friction_force, "friction force", scale, time, stick_slip, "friction_force"},
       {tip_velocity, "tip velocity", scale, time, stick_slip, "tip_velocity"},
       {midspan_displacement, "midspan displacement", scale, time, stick_slip, "midspan_displacement"},
       {midspan_velocity, "midspan velocity", scale, time, stick_slip, "midspan_velocity"}}};
}();

[[nodiscard]] const QuantityProperties& properties_of(Quantity quantity);

struct WrongModel {
  std::string name;     ///< such as "zero-initial-velocity"
  std::string mistake;  ///< the mistake, in one clause
  std::string place;    ///< the equation or section of the paper that it concerns
  /// Of the frequencies, participation, quasi_static_shape, force_maximum, critical_amplitude, stick_force,
  /// stick_displacement, contact_event, tip_displacement and friction_force; or another one, if none of these.
  std::vector<Quantity> changes;
};
STICKSLIP_MEMBERS(WrongModel, (name, "-"), (mistake, "-"), (place, "-"))

/// All wrong models: mistakes in inputs, equations, initial conditions, mesh and time steps, and friction.
[[nodiscard]] const std::vector<WrongModel>& wrong_models();

/// The result of a wrong model for a quantity. It is empty if the model does not define the quantity, if the
/// mistake is not possible in this problem (the other axis of a square section), or if there is no such state
/// (the beam buckles or flutters). Throws std::invalid_argument for an unknown name, and what
/// reference_result() throws.
[[nodiscard]] std::optional<std::vector<double>> wrong_result(const data::Case& problem,
                                                              std::string_view wrong_model, Quantity quantity,
                                                              const std::vector<double>& abscissa);

/// The right result: closed form with the exact steady part and 60 free vibrations while the tip is held,
/// finite elements with the settings of the case in stick-slip. Throws std::invalid_argument for an abscissa
/// that the quantity does not have (an event that does not happen within numerics.duration() among them), and
/// for forces and motions of a held, damped beam, whose closed form is
/// that of the undamped one; data::InputError if the beam buckles or flutters.
[[nodiscard]] std::vector<double> reference_result(const data::Case& problem, Quantity quantity,
                                                   const std::vector<double>& abscissa);

/// The results of the right model and of all wrong models. The uncertainty of the reference is 1e-9 in closed form; in
/// stick-slip it is the distance from a run with twice the time step and half the elements, which is at least three
/// times the error of time step (order 2) and mesh (order 4). Throws what reference_result() throws, and
/// data::InputError if the reference is 0 everywhere. `progress` is told the completed fraction.
[[nodiscard]] ModelResults model_results(const data::Case& problem, Quantity quantity,
                                         const std::vector<double>& abscissa,
                                         const std::function<void(double)>& progress = {});

/// The same with a case for each abscissa, for the quantities force_maximum and critical_amplitude.
[[nodiscard]] ModelResults model_results(const std::vector<data::Case>& cases, Quantity quantity,
                                         const std::vector<double>& abscissa,
                                         const std::function<void(double)>& progress = {});

/// The relative changes that a wrong model causes in one case; empty where it does not define the quantity.
struct WrongModelEffect {
  WrongModel wrong_model;
  std::optional<double> stick_frequency, slip_frequency;  ///< first frequency of each state
  std::optional<double> force_maximum;                    ///< at the frequency of the case
  std::optional<double> stick_force, stick_displacement;  ///< distances of the histories
  std::optional<double> first_slip;                       ///< of its time; infinite if it never slips
  std::optional<double> tip_displacement;                 ///< distance of the history
};
STICKSLIP_MEMBERS(WrongModelEffect, (wrong_model), (stick_frequency, "1"), (slip_frequency, "1"),
                  (force_maximum, "1"), (stick_force, "1"), (stick_displacement, "1"), (first_slip, "1"),
                  (tip_displacement, "1"))

/// The effects of all wrong models on one case: over `stick_duration` (s) with the tip held,
/// including |f_max| and without the damping of the case, and over `contact_duration` (s) with stick-slip.
/// Throws what model_results() throws.
[[nodiscard]] std::vector<WrongModelEffect> wrong_model_effects(const data::Case& problem,
                                                                double stick_duration,
                                                                double contact_duration);

}  // namespace stickslip::comparison
