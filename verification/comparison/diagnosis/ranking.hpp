// SPDX-License-Identifier: MIT
#pragma once

/// When a hypothesis is accepted, and the nearest of many.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "comparison/comparison.hpp"
#include "stickslip/data/reference.hpp"

namespace stickslip::comparison {

/// A user's values beside those of the data set.
struct ComparedValues {
  std::string abscissa_name, abscissa_unit, unit;
  data::Norm norm{};
  std::vector<double> abscissa, theirs, reference;
};

/// The distance of two results a and b: the root mean square of (a_i - b_i)/s_i. In a relative norm s_i is the
/// reference value, so that all entries have the same weight; else, and where that is 0, s is the root mean square of the
/// reference. Infinite if a result is not finite.
[[nodiscard]] double distance(data::Norm norm, const std::vector<double>& reference,
                              const std::vector<double>& a, const std::vector<double>& b);
[[nodiscard]] std::vector<double> scales_of(data::Norm norm, const std::vector<double>& reference);  ///< s

/// A hypothesis at the distance m from the user's values, which are d from the reference, is accepted if m <= d/R.
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
/// n <= free, and at least `least`.
[[nodiscard]] double required_ratio(double tried, double dimension, int free, double least);

/// The same for hypotheses that need no model: neighbouring values are correlated, so that n counts as at most 6, and
/// R is at least 10; both are empirical.
[[nodiscard]] double required_ratio(std::size_t values, int free, int tried);

/// The hypothesis with its distances, if the user's values are near enough to it. At least three of its values must
/// not be NaN.
[[nodiscard]] std::optional<Hypothesis> accepted(const ComparedValues& values, Hypothesis hypothesis,
                                                 int tried);

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
[[nodiscard]] std::vector<double> relative_to_data(data::Norm norm, std::vector<double> wrong,
                                                   const std::vector<double>& right,
                                                   const std::vector<double>& data);
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
/// R is that of required_ratio() with the K wrong models above u from the reference, and at least 3, so that the
/// nearest is clearly nearer than the reference. n is not the number of entries, because neighbouring entries of a
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
