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
  std::string of_elements{};  ///< a key or an option that the user gives and that finite elements alone have
};

struct MethodChoice {
  const Method* method{};
  std::string reason{};  ///< behind the name and a colon; "" of a method that is named
};

/// The method that is named, or else
/// - finite elements where MotionRequest::of_elements is given or event-driven refuses the case;
/// - event-driven with damping, for every Model, and where the contact holds without damping (StickReaction::exceeds(), under a spectrum
///   with even odds); but finite elements where slip would take it more than about ten times as long;
/// - the boundary integral of an undamped beam that slips, for up to about 10 s of work; else finite elements.
///
/// Throws data::FieldError for what that method refuses.
[[nodiscard]] MethodChoice method_for(const data::Case& problem, const MotionRequest& request = {});

}  // namespace stickslip::studies
