// SPDX-License-Identifier: MIT
#pragma once

/// Wrong models of the problem, each with a name and one typical mistake, and the diagnosis of a user's
/// result: the search for the wrong model that is nearest to it.
///
/// A wrong model combines public parts in a wrong way: changed inputs, changed factors of the modal sum (28),
/// changed matrices of a ContactSystem, or its own time integration or contact law. The code in solver/ and
/// analytic/ is not changed.

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// The quantities that can be compared, with their abscissas. In the first eight the tip is held or free
/// without friction; the last three belong to the stick-slip run.
enum class Quantity {
  stick_frequency,     ///< Hz, over the mode number 1, 2, ...
  slip_frequency,      ///< Hz, over the mode number
  participation,       ///< C_n of Eq. (25), over the mode number
  quasi_static_shape,  ///< S(x) of Eq. (18), over x in m
  force_maximum,       ///< |f_max| over numerics.duration(), N, over the excitation frequency in Hz
  critical_amplitude,  ///< m, over the excitation frequency in Hz
  stick_force,         ///< f(t) of Eq. (28), N, over t in s
  stick_displacement,  ///< y(L/2, t), m, over t in s
  contact_event,       ///< time in s of the onset or capture number 1, 2, ...; infinite if it does not occur
  tip_displacement,    ///< y(L, t), m, over t in s
  friction_force       ///< f(t), N, over t in s
};

inline constexpr std::array all_quantities{
    Quantity::stick_frequency,    Quantity::slip_frequency,     Quantity::participation,
    Quantity::quasi_static_shape, Quantity::force_maximum,      Quantity::critical_amplitude,
    Quantity::stick_force,        Quantity::stick_displacement, Quantity::contact_event,
    Quantity::tip_displacement,   Quantity::friction_force};

/// The name of a quantity, such as "stick frequency" or "force maximum".
[[nodiscard]] std::string_view name_of(Quantity quantity);

/// A wrong model.
struct WrongModel {
  std::string name;     ///< such as "zero-initial-velocity"
  std::string mistake;  ///< the mistake, in one clause
  std::string place;    ///< the equation or section of the paper that it concerns
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

/// A user's result.
struct Observation {
  Quantity quantity{};
  std::vector<double> abscissa, values;
  std::vector<double> uncertainty;  ///< bounds of the errors of `values`, in the same unit
};

/// The results of the right model and of all wrong models for one quantity at given abscissas.
///
/// The distance of two results a and b is the root mean square of (a_i - b_i)/s_i over the entries. For
/// frequencies, maxima, amplitudes and event times, s_i is the reference value, so that all entries have the
/// same weight. For C_n, S and histories, s is the root mean square of all reference values.
struct ModelResults {
  struct Member {
    std::string name;
    std::vector<double> values;
    double from_reference{};  ///< distance from the reference
  };
  Quantity quantity{};
  std::vector<double> abscissa;
  std::vector<double> reference;
  /// The uncertainty of the reference, as a distance. Closed form: 1e-9. Stick-slip: the distance from a run
  /// with twice the time step and half the elements, which is at least three times the error of time step
  /// (order 2) and mesh (order 4).
  double reference_uncertainty{};
  std::vector<Member> wrong_models;  ///< those that have a result for the quantity
};

/// Computes these results. Throws what reference_result() throws, and data::InputError if the reference
/// is 0 everywhere. `progress` is told the completed fraction.
[[nodiscard]] ModelResults model_results(const data::Case& problem, Quantity quantity,
                                         const std::vector<double>& abscissa,
                                         const std::function<void(double)>& progress = {});

/// The same with a case for each abscissa, for the quantities force_maximum and critical_amplitude.
[[nodiscard]] ModelResults model_results(const std::vector<data::Case>& cases, Quantity quantity,
                                         const std::vector<double>& abscissa,
                                         const std::function<void(double)>& progress = {});

/// The results with the values `data` of a data set as the reference. With the right result R and the wrong
/// one W, both by this program, the predicted wrong value is data * W/R for quantities whose entries have the
/// same weight, else data + W - R. An error that the program makes in R and in W in the same proportion, or by
/// the same amount, cancels. The program's own error, distance(R, data), is taken as the uncertainty of what remains: the
/// error in W is assumed to be at most twice that in R. So R itself need not be accurate, and is no truth.
[[nodiscard]] ModelResults relative_to_data(ModelResults result, const std::vector<double>& data);

/// The distance of two results as defined at ModelResults; infinite if a result is not finite.
[[nodiscard]] double distance(const ModelResults& model_results, const std::vector<double>& a,
                              const std::vector<double>& b);

/// The outcome of a diagnosis.
enum class Finding {
  correct,      ///< within the uncertainty of the reference
  mistaken,     ///< near one of the wrong models
  unexplained,  ///< neither correct nor near a wrong model
  undecided     ///< the reference is uncertain: another mesh has different events
};

/// A wrong model and its distances.
struct Candidate {
  std::string name;
  double distance{};        ///< from the observation
  double from_reference{};  ///< distance of the wrong model from the reference
};

/// The wrong model that is nearest to an observation.
///
/// The uncertainty u is the sum of the uncertainties of the observation, in the measure of the distances, and
/// of the reference. An observation is `correct` if its distance d from the reference is at most u. Otherwise
/// the nearest wrong model with a distance above u from the reference, at the distance m, is named if m <= d/R. Two models are indistinguishable if
/// their distance is at most 2u, because only then one observation can be within u of both. The actual model
/// of the observation is therefore in `named` if it is one of the wrong models: it is within u of the
/// observation, and so is the nearest one, so that their distance is at most 2u.
///
/// Choice of R: an unknown error is a deviation in an unrelated direction, with a size of which only the
/// decade is known. It comes within 1/R of the length of a given wrong model's deviation if two conditions
/// hold. Its direction lies in a cone of half-angle asin(1/R), which contains at most the fraction R^(1-n)/2
/// of all directions in n dimensions. Its length agrees to 1 +- 1/R, which is the fraction 2/(R ln 10) of the
/// decade. Together this is R^(-n)/ln 10. Among K wrong models with a distance above u from the reference,
/// one is then named by accident in at most one of a hundred cases if
///
///     R = (K/(0.01 ln 10))^(1/n).
///
/// R is at least 3, so that the nearest wrong model is clearly nearer than the reference. n is not the number
/// of entries, because neighbouring entries of a history are correlated. It is the effective dimension of the
/// deviations of the wrong models: K^2 over the sum of cos^2 of the angle between all pairs of deviations,
/// each paired with itself as well. A single number, n = 1, identifies a mistake only if the two agree to
/// about four digits. Ten frequencies need less agreement.
struct Diagnosis {
  Finding finding{};
  double from_reference{};          ///< d, relative
  double uncertainty{};             ///< u, relative
  double required_ratio{};          ///< R
  std::vector<Candidate> ranked{};  ///< all wrong models, the nearest first
  /// If mistaken, the nearest wrong model and those that are indistinguishable from it. If correct, those
  /// that are indistinguishable from the reference.
  std::vector<std::string> named{};
};

/// Diagnoses an observation. Throws data::InputError for a value or an uncertainty that is not finite and for a
/// negative uncertainty, and std::invalid_argument if values or uncertainties differ in number from the
/// abscissas, or quantity or abscissas from those of `model_results`.
[[nodiscard]] Diagnosis diagnose(const ModelResults& model_results, const Observation& observation);

/// A share with two digits, such as "0.31 %".
[[nodiscard]] std::string percent(double share);

/// The diagnosis in one sentence, such as "like 'zero-initial-velocity' (...) to 0.3 %, while the reference
/// is 41 % away". It names at most three wrong models.
[[nodiscard]] std::string sentence(const Diagnosis& diagnosis);

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

}  // namespace stickslip::studies
