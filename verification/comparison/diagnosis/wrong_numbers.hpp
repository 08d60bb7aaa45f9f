// SPDX-License-Identifier: MIT
#pragma once

/// One number of a problem that is wrong: the search for it, and the problems of masses with friction in the reference data as
/// functions of the numbers that state them.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "comparison/diagnosis/ranking.hpp"
#include "stickslip/analytic/contact_model.hpp"

namespace stickslip::comparison {

/// A number that may be wrong, with what follows from it.
struct FreeNumber {
  std::vector<double> tried;  ///< ascending; the search goes on between them
  std::function<std::optional<std::vector<double>>(double)>
      result;                                   ///< at the values; empty if there is none
  std::function<std::string(double)> sentence;  ///< begins with "like "
};

/// The wrong number that is nearest to the user's values, with those that cannot be told from it.
///
/// Each is fitted by least squares: the nearest of those that are tried, from which Gauss and Newton go on. It is accepted if it is
/// nearer than the reference by required_ratio() of one fitted number among as many as there are, and as near as twice the
/// uncertainty of the values or a hundredth of their difference from the reference.
[[nodiscard]] std::optional<Hypothesis> wrong_number(const ComparedValues& values, double uncertainty,
                                                     const std::vector<FreeNumber>& numbers);

/// By the keys of the problem, such as "force.amplitude"; data/reference/README.md has the equations.
using Numbers = std::map<std::string, double>;

/// The numbers that state the problem of a mass, for a group such as "problem = sdnd100" its own; empty for a beam.
[[nodiscard]] Numbers numbers_of_mass(const data::Resource& resource, const std::string& group);

/// One mass on a wall, a block on an incline, or a mass from which another one hangs on a spring, x2 = x1 + F/k +
/// T/sqrt(m2), while F = `pull` (N) acts on the contact.
[[nodiscard]] analytic::ContactModel mass_model(const Numbers& numbers, double pull = 0.0);

/// Whether a contact with this position (m) and velocity (m/s) rests, and friction can hold it.
[[nodiscard]] bool is_held(const analytic::ContactModel& model, double position, double velocity);

/// Changes of contact, or states at given times.
struct MassRows {
  std::vector<std::string> changes;
  std::vector<double> times, positions;
};

/// As many changes as there are in `seen`, or the states at its times. Empty if they are others or too few up to twice
/// its last time.
[[nodiscard]] std::optional<MassRows> mass_rows(const Numbers& numbers, const MassRows& seen);

/// The value of a row with its own numbers: "power" or "stops"; empty for another name, and for times that are none.
[[nodiscard]] std::optional<double> mass_value(const Numbers& numbers, const std::string& name);

}  // namespace stickslip::comparison
