// SPDX-License-Identifier: MIT
#pragma once

/// Contact problems, each with its exact answers, for every engine that runs a contact. An engine needs one adapter: how it
/// runs a problem, and by how much its answers may be off (contact_battery_test.cpp).

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "support/contact_models.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {

/// The contact at one time.
struct ContactSample {
  data::ContactState state{};
  double position{};          ///< on the wall, m
  double sliding_velocity{};  ///< m/s
  double friction_force{};    ///< on the system, N
  double way{};               ///< slid since the start, m
};

struct ContactHistory {
  std::vector<data::ContactEvent> events;
  std::vector<ContactSample> samples;  ///< at the times that the problem asks for
};

enum class ContactProblemKind { slider, spring, oscillator, plane_below_limit, shaken_plane, two_masses };

struct ContactProblem {
  std::string name;
  ContactProblemKind kind{};
  SingleMass mass{};  ///< the system, unless it is `pair`
  ForcedPair pair{};
  data::ContactState start{data::ContactState::stick};
  double position{};                   ///< of the contact at the start, m
  double velocity{};                   ///< of a start in slip, m/s
  std::vector<double> sample_times{};  ///< ascending; a run ends at the last one, s
  ContactHistory exact{};
  /// By event, of a single mass: how fast the sliding velocity (m/s^2) or, at an onset, the holding force (N/s) passes its
  /// limit. An error of either, divided by it, is one of time.
  std::vector<double> rates{};
  std::optional<double> friction_power{};  ///< published mean of N |v_s| between the last two samples, W

  [[nodiscard]] bool is_pair() const { return kind == ContactProblemKind::two_masses; }
};

/// Each with its exact history.
[[nodiscard]] const std::vector<ContactProblem>& contact_problems();

/// How far an engine's answers may be off. What has no tolerance is not compared.
struct ContactErrors {
  std::function<Tolerance(std::size_t)> time{}, position{};  ///< of each event
  std::optional<Tolerance> sample_position{}, sample_velocity{}, friction_force{}, friction_power{};
};

struct ContactEngine {
  std::string name;
  std::string requirement;  ///< that its answers serve
  std::function<ContactHistory(const ContactProblem&)> run;
  /// None if the engine cannot run the problem.
  std::function<std::optional<ContactErrors>(const ContactProblem&)> errors;
};

}  // namespace stickslip::testing
