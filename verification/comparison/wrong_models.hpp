#pragma once

/// Wrong models of the problem, each with a name and one mistake that people make, and the diagnosis of
/// somebody else's result by them: which mistake does it look like?
///
/// A wrong model is made of public parts put together wrongly: changed inputs, changed factors of the modal
/// sum (28), changed matrices of a ContactSystem, a time stepper or a contact law of its own. Nothing in
/// solver/ or analytic/ is wrong.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stickslip/data/problem.hpp"

namespace stickslip::studies {

/// What can be compared, with its abscissa. In the first eight the tip is held; the last three are of the
/// stick-slip run.
enum class Quantity {
  stick_frequency,     ///< Hz, of the mode number 1, 2, ...
  slip_frequency,      ///< Hz, of the mode number
  participation,       ///< C_n of Eq. (25), of the mode number
  quasi_static_shape,  ///< S(x) of Eq. (18), of x in m
  force_maximum,       ///< |f|_max over numerics.duration(), N, of the excitation frequency in Hz
  critical_amplitude,  ///< m, of the excitation frequency in Hz
  stick_force,         ///< f(t) of Eq. (28), N, of t in s
  stick_displacement,  ///< y(L/2, t), m, of t in s
  contact_event,       ///< time in s of the onset or capture number 1, 2, ...; infinite where there is none
  tip_displacement,    ///< y(L, t), m, of t in s
  friction_force       ///< f(t), N, of t in s
};

inline constexpr std::array all_quantities{
    Quantity::stick_frequency,    Quantity::slip_frequency,     Quantity::participation,
    Quantity::quasi_static_shape, Quantity::force_maximum,      Quantity::critical_amplitude,
    Quantity::stick_force,        Quantity::stick_displacement, Quantity::contact_event,
    Quantity::tip_displacement,   Quantity::friction_force};

/// "stick frequency", "force maximum", ...
[[nodiscard]] std::string_view name_of(Quantity quantity);

/// A wrong model.
struct WrongModel {
  std::string name;     ///< "zero-initial-velocity"
  std::string mistake;  ///< in one clause
  std::string place;    ///< equation or section of the paper that it gets wrong
  std::vector<Quantity> changes;
};

/// All of them: of inputs, equations, start, mesh and time steps, friction.
[[nodiscard]] const std::vector<WrongModel>& wrong_models();

/// What a wrong model returns for a quantity, or nothing if it says nothing about it, or if there is no such
/// mistake in this problem (the other axis of a square section) or no such state (it buckles or flutters).
/// Throws std::invalid_argument for an unknown name, and what reference_result() throws.
[[nodiscard]] std::optional<std::vector<double>> wrong_result(const data::Case& problem,
                                                              std::string_view wrong_model, Quantity quantity,
                                                              const std::vector<double>& abscissa);

/// The right result: closed form with the exact steady part and 60 free vibrations while the tip is held,
/// finite elements with the settings of the case in stick-slip. Throws std::invalid_argument for an abscissa
/// that the quantity does not have (an event that does not happen within numerics.duration() among them), and
/// for forces and motions of a held, damped beam, whose closed form is
/// that of the undamped one; std::domain_error if the beam buckles or flutters.
[[nodiscard]] std::vector<double> reference_result(const data::Case& problem, Quantity quantity,
                                                   const std::vector<double>& abscissa);

/// Somebody's result.
struct Observation {
  Quantity quantity{};
  std::vector<double> abscissa, values;
  std::vector<double> uncertainty;  ///< bounds of the errors of `values`, in their unit
};

/// What everybody says of one quantity at given abscissas.
///
/// Distances are relative, the root of the mean over the entries of ((a_i - b_i)/s_i)^2: for frequencies,
/// maxima, amplitudes and event times s_i is the true value, so that each entry counts alike; for C_n, S and
/// histories it is the root of the mean square of all true values.
struct ModelResults {
  struct Member {
    std::string name;
    std::vector<double> values;
    double from_reference{};  ///< distance
  };
  Quantity quantity{};
  std::vector<double> abscissa;
  std::vector<double> reference;
  /// As a distance. Closed form: 1e-9. Stick-slip: the distance to a run with twice the step and half the
  /// elements, at least three times the error of step (order 2) and mesh (order 4).
  double reference_uncertainty{};
  std::vector<Member> wrong_models;  ///< those that say something
  std::vector<std::string> missing;  ///< the others
};

/// Throws what reference_result() throws, and std::invalid_argument if the reference is 0 everywhere.
[[nodiscard]] ModelResults model_results(const data::Case& problem, Quantity quantity,
                                         const std::vector<double>& abscissa);

/// The distance of two results in the measure of a comparison; infinite if one of them is not finite.
[[nodiscard]] double distance(const ModelResults& model_results, const std::vector<double>& a,
                              const std::vector<double>& b);

enum class Finding {
  correct,      ///< within the uncertainty of the reference
  mistaken,     ///< like one of the wrong models
  unexplained,  ///< neither
  undecided     ///< the reference itself is not known: another mesh has other events
};

/// A wrong model against an observation.
struct Candidate {
  std::string name;
  double distance{};        ///< from the observation
  double from_reference{};  ///< of the wrong model
};

/// Whom an observation looks like.
///
/// With u the uncertainty, the sum of the observation's, in the measure of the distances, and the
/// reference's: an observation is `correct` if its distance d from the reference is at most u. Else the
/// nearest wrong model, at distance m, is named if m <= d/R. Two models are indistinguishable if they are no
/// further than 2u apart: only then may one observation be within u of both. Whoever made the observation is
/// therefore among the `named` ones: within u of it, as the nearest one is, so within 2u of that.
///
/// R. An error like none of the known mistakes is a deviation in an unrelated direction, and of a size of
/// which nothing is known but, say, its decade. It comes within 1/R of its length of a given wrong model's
/// deviation if it points into a cone of half-angle asin(1/R), at most the share R^(1-n)/2 of all directions
/// in n dimensions, and its length agrees to 1 +- 1/R, which is 2/(R ln 10) of the decade: together
/// R^(-n)/ln 10. Of K wrong models further than u from the reference one is named by accident in at most one
/// out of a hundred cases if
///
///     R = (K/(0.01 ln 10))^(1/n),
///
/// but at least 3, so that the nearest wrong model stays clearly nearer than the reference. n is not the
/// number of entries, since neighbours in a history say the same, but the dimension that the wrong models'
/// deviations fill: K^2 / sum over all pairs of cos^2 of the angle between them (their own included). One
/// number, n = 1, names a mistake only if it agrees with it to four digits or so; ten frequencies do better.
struct Diagnosis {
  Finding finding{};
  double from_reference{};        ///< d
  double uncertainty{};           ///< u
  double dimension{};             ///< n
  double required_ratio{};        ///< R
  std::vector<Candidate> ranked;  ///< all wrong models, nearest first
  /// If mistaken, the nearest wrong model and those that cannot be told from it; if correct, those that
  /// cannot be told from the reference.
  std::vector<std::string> named;
};

/// Throws std::invalid_argument if values or uncertainty have another size than the abscissa, none at all, or
/// one that is not finite (an uncertainty must not be negative), or if the comparison is another one's.
[[nodiscard]] Diagnosis diagnose(const ModelResults& model_results, const Observation& observation);
[[nodiscard]] Diagnosis diagnose(const data::Case& problem, const Observation& observation);

/// The diagnosis in a sentence: "like 'zero-initial-velocity' (...) to 0.3 %, while the reference is 41 %
/// away".
[[nodiscard]] std::string sentence(const Diagnosis& diagnosis);

/// What a wrong model changes in one case, relative to the reference; nothing where it says nothing.
struct WrongModelEffect {
  WrongModel wrong_model;
  std::optional<double> stick_frequency, slip_frequency;  ///< first of each state
  std::optional<double> force_maximum;                    ///< at the frequency of the case
  std::optional<double> stick_force, stick_displacement;  ///< distances over the history
  std::optional<double> first_slip;                       ///< time; infinite if it never slips
  std::optional<double> tip_displacement;                 ///< distance over the history
};

struct WrongModelStudy {
  double frequency_hz{}, amplitude{};  ///< of the case
  double stick_duration{};             ///< of the histories of the held beam, s
  double contact_duration{};           ///< of the stick-slip history, s
  double contact_uncertainty{};        ///< reference_uncertainty of tip_displacement
  std::vector<WrongModelEffect> effects;
};

/// Every wrong model on one case: over `stick_duration` the held beam, |f|_max included and without the
/// damping of the case, over `contact_duration` stick-slip. Throws what line_up() throws.
[[nodiscard]] WrongModelStudy wrong_model_study(const data::Case& problem, double stick_duration,
                                                double contact_duration);

}  // namespace stickslip::studies
