// SPDX-License-Identifier: MIT
#pragma once

/// Which method computes a history, and why.

#include <optional>
#include <set>
#include <string>

#include "stickslip/data/problem.hpp"
#include "studies/history/method.hpp"

namespace stickslip::studies {

/// What a run asks of its method besides the case.
struct MotionRequest {
  std::optional<std::string> method{};  ///< named by the user
  std::set<data::Feature> features{};  ///< slip, for changes of contact, and further columns, where asked for
  solver::RunOptions run{};
  bool of_many_places{};      ///< along the beam, as a film has them
  std::string of_elements{};  ///< what the user gives that finite elements alone have: a key or an option
};

struct MethodChoice {
  const Method* method{};
  std::string reason{};  ///< as a sentence goes on behind the name and a colon; "" of one that is named
};

/// The method that is named, or else
/// - finite elements where MotionRequest::of_elements is given or event-driven refuses the case;
/// - event-driven with damping, for every Model, and where the contact holds without damping (StickReaction::exceeds(), under a spectrum
///   with even odds); but finite elements where slip would take it more than ten times as long (slowness_of_events());
/// - the boundary integral of an undamped beam that slips, for up to most_steps_of_boundary_integral; else finite elements.
///
/// Throws data::FieldError for what that method refuses.
[[nodiscard]] MethodChoice method_for(const data::Case& problem, const MotionRequest& request = {});

inline constexpr double most_steps_of_boundary_integral = 1.5e6;  // about 10 s of one core

/// How many times longer event-driven takes than finite elements while the contact slips, where Kelvin-Voigt damping η makes slip stiff:
/// 0.1 η ω_N² h N with N modes and time steps h; an estimate from measured times, within a factor of two for `damped` with 20 to 40 modes.
[[nodiscard]] double slowness_of_events(const data::Case& problem);

}  // namespace stickslip::studies
