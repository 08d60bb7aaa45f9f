// SPDX-License-Identifier: MIT
#pragma once

/// What a result that differs may be, and the one rule by which a hypothesis is accepted.

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "comparison/comparison.hpp"

namespace stickslip::comparison {

/// What is asked of a hypothesis depends on its kind.
enum class Kind { factor, relation, zeros, all_modes, wrong_model };

struct Acceptance {
  Kind kind{};
  double least_ratio{};     ///< of the ratio R
  double most_dimension{};  ///< of the dimension n: neighbouring values are correlated
  double farthest{};        ///< the largest distance, however far the reference is
  /// Distances are measured by its own values, because small factors bring all near zero.
  bool is_in_own_scale{};
};

/// One row for each kind. The numbers are empirical; the rule is that of required_ratio(). The dimension of wrong models is measured.
inline constexpr std::array<Acceptance, 5> acceptances = [] {
  constexpr double any = std::numeric_limits<double>::infinity();
  return std::array<Acceptance, 5>{{{Kind::factor, 100.0, 6.0, any, true},
                                    {Kind::relation, 10.0, 6.0, any, false},
                                    {Kind::zeros, 1e4, 6.0, any, false},
                                    {Kind::all_modes, 3.0, any, any, false},
                                    {Kind::wrong_model, 3.0, any, 0.2, false}}};
}();

/// A possible reason of a difference: a relation of the user's values to the reference, another data set, or a wrong
/// model.
struct Hypothesis {
  std::string name{};  ///< such as "constant-factor" or "zero-initial-velocity"
  Kind kind{Kind::wrong_model};
  std::vector<double> values{};  ///< what the user has if it is true; NaN where it says nothing
  int free{};                    ///< numbers in it that were fitted to the user's values
  std::string sentence{};        ///< without a full stop; of a wrong model its mistake
  double distance{};             ///< of the user's values from it, relative
  double from_reference{};       ///< of its values from the reference, relative
  bool is_accepted{};
};

enum class Finding {
  correct,      ///< within the uncertainty of the reference
  mistaken,     ///< near one of the hypotheses
  unexplained,  ///< neither correct nor near one
  undecided     ///< the reference is uncertain: another mesh has different events
};
inline constexpr std::array<std::string_view, 4> finding_names{"correct", "mistaken", "unexplained",
                                                               "undecided"};

/// What is said of one quantity of one group.
struct Diagnosis {
  std::string group{};     ///< the first of several with the same sentence
  std::string quantity{};  ///< the name of the compared quantity
  std::string sentence{};  ///< such as "like 'dead-load' (...) to 0.3 %, while the reference is 41 % away"
  std::optional<Finding> finding{};  ///< empty if no diagnosis is possible; the sentence gives the reason
  double from_reference{};           ///< distance d of the user's values from the reference, relative
  double distance{};                 ///< of them from what is named, relative
  double uncertainty{};              ///< u, relative
  double required_ratio{};           ///< R of the wrong models; 0 if a relation is named
  std::vector<Hypothesis>
      ranked{};  ///< all wrong models, and the nearest relation of each name; the nearest first
  /// If mistaken, the hypothesis that is named and those that are indistinguishable from it. If correct, those
  /// that are indistinguishable from the reference.
  std::vector<std::string> named{};
};

/// The distance of two results a and b: the root mean square of (a_i - b_i)/s_i. In a relative norm s_i is the
/// reference value, so that all entries have the same weight; else, and where that is 0, s is the root mean square of the
/// reference. Infinite if a result is not finite.
[[nodiscard]] double distance(data::Norm norm, const std::vector<double>& reference,
                              const std::vector<double>& a, const std::vector<double>& b);
[[nodiscard]] std::vector<double> scales_of(data::Norm norm, const std::vector<double>& reference);  ///< s

/// A hypothesis at the distance m from the user's values, which are d from the reference, is accepted if m <= min(d, 1)/R, and m is
/// not beyond the farthest of its kind.
///
/// An unknown error is a deviation in an unrelated direction, with a size of which only the decade is known. It comes
/// within 1/R of the length of a given hypothesis' deviation if two conditions hold. Its direction lies in a cone of
/// half-angle asin(1/R), which contains at most the fraction R^(1-n)/2 of all directions in n dimensions. Its length
/// agrees to 1 ± 1/R, which is the fraction 2/(R ln 10) of the decade. Together this is R^-n/ln 10. Of `tried`
/// hypotheses one is then accepted by accident in at most one of a hundred cases if
///
///     R = (tried/(0.01 ln 10))^(1/n).
///
/// A number that was fitted leaves only the direction to chance, in n - free + 1 dimensions: a cone and its opposite
/// contain at most the fraction R^(free-n) of all directions, so that R = (tried/0.01)^(1/(n-free)). R is infinite if
/// n <= free.
[[nodiscard]] double required_ratio(Kind kind, double tried, double dimension, int free = 0);

/// The hypothesis with its distances, and whether it is accepted as one of so many. It must speak of half of the values, and of
/// one that differs.
[[nodiscard]] Hypothesis judged(data::Norm norm, const Comparison::Series& series, Hypothesis hypothesis,
                                double tried);

/// By which the nearest is chosen: the distance, ten times that if a number was fitted. Below 1e-12 all are alike.
[[nodiscard]] double rank_of(const Hypothesis& hypothesis);

/// The nearest of those that are accepted, the first of several alike; null if there is none.
[[nodiscard]] const Hypothesis* nearest_of(const std::vector<Hypothesis>& hypotheses);

/// The results of the right model and of all wrong models for one quantity.
struct ModelResults {
  data::Norm norm{};  ///< relative for frequencies, maxima, amplitudes and event times, else scale
  std::vector<double> reference;
  double reference_uncertainty{};        ///< as a distance
  std::vector<Hypothesis> wrong_models;  ///< those that have a result for the quantity
};

/// The results with the values `data` of a data set as the reference. With the right result R and the wrong
/// one W, both by this program, the predicted wrong value is data * W/R in a relative norm, else data + W - R. An error
/// that the program makes in R and in W in the same proportion, or by the same amount, cancels. The program's own
/// error, distance(R, data), is taken as the uncertainty of what remains: the error in W is assumed to be at most twice
/// that in R. So R itself need not be accurate, and is no truth.
[[nodiscard]] ModelResults relative_to_data(ModelResults results, const std::vector<double>& data);

/// The wrong model that is nearest to the user's values, which have these bounds of their errors.
///
/// The uncertainty u is the sum of the uncertainties of the values, in the measure of the distances, and of the
/// reference. Values are `correct` if their distance d from the reference is at most u. Otherwise the nearest wrong
/// model with a distance above u from the reference is named if it is accepted. Two models are indistinguishable if
/// their distance is at most 2u, because only then one result can be within u of both. The actual model is therefore in
/// `named` if it is one of the wrong models: it is within u of the values, and so is the nearest one, so that their
/// distance is at most 2u.
///
/// R is that of the K wrong models above u from the reference. n is not the number of entries, because neighbouring entries of a
/// history are correlated. It is the effective dimension of the deviations of these models: K² over the sum of cos² of
/// the angle between all pairs of deviations, each paired with itself as well. A single number, n = 1, identifies a
/// mistake only if the two agree to about four digits. Ten frequencies need less agreement.
///
/// Throws data::InputError for a value or an uncertainty that is not finite and for a negative uncertainty, and
/// std::invalid_argument if there are not as many of them as in the reference.
[[nodiscard]] Diagnosis diagnose(const ModelResults& results, const std::vector<double>& values,
                                 const std::vector<double>& uncertainty);

/// A share with two digits, such as "0.31 %".
[[nodiscard]] std::string percent(double share);

/// The diagnosis in one sentence, such as "like 'zero-initial-velocity' (...) to 0.3 %, while the reference
/// is 41 % away". It names at most three wrong models.
[[nodiscard]] std::string sentence(const Diagnosis& diagnosis);

}  // namespace stickslip::comparison
