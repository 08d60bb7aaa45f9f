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

#include "comparison/diagnosis/ranking.hpp"
#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"

namespace stickslip::comparison {

/// The quantities that can be compared, with their abscissas. In the first nine the tip is held or free without friction, and
/// there is no damping; in the next five it is held. The others belong to a run with stick and slip.
enum class Quantity {
  stick_frequency,         ///< Hz, over the mode number 1, 2, ...
  slip_frequency,          ///< Hz, over the mode number
  participation,           ///< C_n of Eq. (25), over the mode number
  quasi_static_shape,      ///< S(x) of Eq. (18), over x in m
  force_maximum,           ///< |f_max| over numerics.duration(), N, over the excitation frequency in Hz
  critical_amplitude,      ///< m, over the excitation frequency in Hz
  stick_force,             ///< f(t) of Eq. (28), N, over t in s
  stick_displacement,      ///< y(L/2, t), m, over t in s
  stick_velocity,          ///< y_t(L/2, t), m/s, over t in s
  steady_amplitude,        ///< of y(L/2), m, over the excitation frequency in Hz
  steady_phase,            ///< of y(L/2) against the base, rad, over the excitation frequency in Hz
  steady_force_amplitude,  ///< of f, N, over the excitation frequency in Hz
  steady_force_phase,      ///< of f against the base, rad, over the excitation frequency in Hz
  heat,                    ///< of a period of the steady vibration, J, over the excitation frequency in Hz
  contact_event,     ///< time in s of the onset or capture number 1, 2, ...; infinite if it does not occur
  tip_displacement,  ///< y(L, t), m, over t in s
  friction_force,    ///< f(t), N, over t in s
  tip_velocity,      ///< y_t(L, t), m/s, over t in s
  midspan_displacement,  ///< y(L/2, t), m, over t in s
  midspan_velocity       ///< y_t(L/2, t), m/s, over t in s
};

inline constexpr auto quantity_names = [] {
  using enum Quantity;
  return std::array<std::pair<Quantity, std::string_view>, 20>{
      {{stick_frequency, "stick frequency"},
       {slip_frequency, "slip frequency"},
       {participation, "participation"},
       {quasi_static_shape, "quasi-static shape"},
       {force_maximum, "force maximum"},
       {critical_amplitude, "critical amplitude"},
       {stick_force, "stick force"},
       {stick_displacement, "stick displacement"},
       {stick_velocity, "stick velocity"},
       {steady_amplitude, "steady amplitude"},
       {steady_phase, "steady phase"},
       {steady_force_amplitude, "steady force amplitude"},
       {steady_force_phase, "steady force phase"},
       {heat, "heat"},
       {contact_event, "contact event"},
       {tip_displacement, "tip displacement"},
       {friction_force, "friction force"},
       {tip_velocity, "tip velocity"},
       {midspan_displacement, "midspan displacement"},
       {midspan_velocity, "midspan velocity"}}};
}();

[[nodiscard]] std::string_view name_of(Quantity quantity);

/// Whether it is a history of a run with stick and slip.
[[nodiscard]] bool is_stick_slip_history(Quantity quantity);

[[nodiscard]] data::Norm measure_of(Quantity quantity);

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

/// One of them. Throws std::invalid_argument if there is none of that name.
[[nodiscard]] const WrongModel& wrong_model_named(std::string_view name);

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

/// The right result of the case with this number multiplied by a factor; empty if there is no such state. Throws what
/// data::with_value() throws for a key that the case does not have.
[[nodiscard]] std::optional<std::vector<double>> result_with(const data::Case& problem, std::string_view key,
                                                             double factor, Quantity quantity,
                                                             const std::vector<double>& abscissa);

/// The result of the case in a run with the friction law times tanh(v_s/width), width in m/s; empty as above.
[[nodiscard]] std::optional<std::vector<double>> result_smoothed_over(const data::Case& problem, double width,
                                                                      Quantity quantity,
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
