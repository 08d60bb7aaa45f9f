// SPDX-License-Identifier: MIT
#include "stickslip/analytic/stick_reaction.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "beam_constants.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"

namespace stickslip::analytic {
namespace {

double angular_frequency(const data::Case& problem) {
  return 2.0 * std::numbers::pi * problem.excitation().frequency_hz();
}

StickResponse exact_response(const data::Case& problem, int modes) {
  const data::HarmonicExcitation unit(
      {.frequency_hz = problem.excitation().frequency_hz(), .amplitude = 1.0});
  return {problem.beam(), unit, modes, SteadyPart::exact};
}

}  // namespace

StickReaction::StickReaction(const data::Case& problem, Kept kept)
    : kept_(std::make_shared<const Kept>(std::move(kept))),
      omega_(angular_frequency(problem)),
      duration_(problem.numerics.duration()) {}

StickReaction::StickReaction(const data::Case& problem) : StickReaction(problem, kept_of(problem)) {}

StickReaction::StickReaction(const data::Case& problem, int modes)
    : StickReaction(problem, kept_of(problem, modes)) {}

StickReaction::StickReaction(const data::Case& problem, ModalReaction reaction)
    : StickReaction(problem, Kept{.undamped = std::move(reaction), .damped = {}, .half = {}}) {}

StickReaction::Kept StickReaction::kept_of(const data::Case& problem) {
  Kept kept;
  if (problem.damping.is_none())
    kept.undamped = modal_reaction(problem.beam(), problem.numerics.modes());
  else
    kept.damped = damped_reaction(held_structure(problem, problem.numerics.modes()));
  return kept;
}

StickReaction::Kept StickReaction::kept_of(const data::Case& problem, int modes) {
  Kept kept;
  if (!problem.damping.is_none()) {
    kept.damped = damped_reaction(held_structure(problem, modes), SteadyPart::exact);
    kept.half = damped_reaction(held_structure(problem, modes / 2), SteadyPart::exact);
  } else if (problem.has(data::Feature::shear)) {
    const double omega = angular_frequency(problem);
    kept.undamped = timoshenko_reaction(problem.beam(), modes, omega);
    kept.omitted = timoshenko_omitted_transient(timoshenko_reaction(problem.beam(), modes), omega);
  } else {
    const StickResponse response = exact_response(problem, modes);
    kept.undamped = response.reaction();
    kept.omitted = response.omitted_transient_bound();
  }
  return kept;
}

StickReaction StickReaction::of(const data::Case& other) const {
  StickReaction reaction = *this;
  reaction.omega_ = angular_frequency(other);
  reaction.duration_ = other.numerics.duration();
  return reaction;
}

DampedForce StickReaction::damped_force() const {
  return kept_->half ? DampedForce(*kept_->damped, omega_, duration_, *kept_->half)
                     : DampedForce(*kept_->damped, omega_, duration_);
}

Bounds StickReaction::largest(double relative_width) const {
  if (kept_->damped) return damped_force().refined_to(relative_width);
  const Bounds force = ForceMaximum(*kept_->undamped, omega_, duration_).refined_to(relative_width);
  return {std::max(0.0, force.lower - kept_->omitted), force.upper + kept_->omitted};
}

bool StickReaction::exceeds(double limit, double relative_width) const {
  if (kept_->damped) return largest(relative_width).lower > limit;
  return ForceMaximum(*kept_->undamped, omega_, duration_).exceeds(limit);
}

BandMaximum StickReaction::over(const FrequencyBand& band, DampedForcePart part) const {
  if (kept_->damped) return {*kept_->damped, band, duration_, part};
  return {*kept_->undamped, band, duration_};
}

double StickReaction::least_damping_ratio() const {
  if (!kept_->damped) return 0.0;
  double least = 1.0;
  for (const ModalShare& share : kept_->damped->shares)
    least = std::min(least, -share.eigenvalue.real() / std::abs(share.eigenvalue));
  return least;
}

double StickReaction::slowest_decay() const {
  if (!kept_->damped) return 0.0;
  double slowest = std::numeric_limits<double>::infinity();
  for (const ModalShare& share : kept_->damped->shares) slowest = std::min(slowest, -share.eigenvalue.real());
  return slowest;
}

void StickReactions::tabulate(double lowest_load_factor, double highest_load_factor) {
  if (!first_.damping.is_none() || first_.has(data::Feature::shear)) return;
  table_.emplace(lowest_load_factor, highest_load_factor, first_.numerics.modes(),
                 first_.beam().axial_direction());
}

StickReaction StickReactions::of(const data::Case& problem) const {
  const bool has_its_modes = problem.numerics.modes() == first_.numerics.modes();
  if (table_ && has_its_modes && problem.damping.is_none() && table_->holds(problem.beam()))
    return {problem, table_->at(problem.beam())};
  if (!has_its_modes || problem.structure != first_.structure || problem.damping != first_.damping)
    return StickReaction(problem);
  const std::lock_guard lock(guard_);
  if (!common_) common_.emplace(problem);
  return common_->of(problem);
}

ModesOfAll modes_of_all(const data::Case& problem, bool verdict_alone) {
  const bool is_damped = !problem.damping.is_none();
  ModesOfAll modes{.first = is_damped ? 40 : 200, .most = is_damped ? 160 : 800};
  if (verdict_alone && !is_damped) modes.first = std::clamp(4 * problem.numerics.modes(), 40, 200);
  const double omega = angular_frequency(problem);
  for (;; modes.first = std::min(2 * modes.first, modes.most)) {
    const double highest = held_modes(problem, modes.first).back().angular_frequency;
    if (highest >= 4.0 * omega) return modes;
    if (modes.first < modes.most) continue;
    char hz[32];
    std::snprintf(hz, sizeof hz, "%.6g", highest / (8.0 * std::numbers::pi));
    throw data::FieldError("excitation.frequency_hz", problem.excitation().frequency_hz(),
                           "at most " + std::string(hz) + " Hz, a quarter of natural frequency " +
                               std::to_string(modes.most) + " of the stick state");
  }
}

Bounds steady_reaction(const data::Case& problem) {
  const double omega = angular_frequency(problem);
  const auto exactly = [](double force) { return Bounds{std::abs(force), std::abs(force)}; };
  if (problem.damping.is_none()) {
    if (problem.has(data::Feature::shear)) return exactly(timoshenko_steady_force(problem.beam(), omega));
    return exactly(exact_response(problem, modes_of_all(problem).first).steady_force_amplitude());
  }
  if (problem.damping.is_kelvin_voigt()) {
    const data::HarmonicExcitation unit(
        {.frequency_hz = problem.excitation().frequency_hz(), .amplitude = 1.0});
    return exactly(std::abs(
        DampedSteadyState(problem.beam(), unit, problem.damping, TipSupport::held).friction_force()));
  }
  return StickReaction(problem, modes_of_all(problem).first).damped_steady();
}

std::vector<ModalForce> held_modes(const data::Case& problem, int count) {
  return modal_forces(problem.beam(), count);
}

std::vector<FreeVibration> free_vibrations(const data::Case& problem) {
  constexpr int instants = 2048;
  const double omega = angular_frequency(problem);
  const ModalReaction reaction = modal_reaction(problem.beam(), problem.numerics.modes());
  const double span = std::max({problem.numerics.duration(), 1.0 / problem.excitation().frequency_hz(),
                                2.0 * std::numbers::pi / reaction.modes.front().angular_frequency});
  const ForceMaximum force(reaction, omega, span);
  double largest = 0.0;
  for (int i = 1; i <= instants; ++i)
    largest = std::max(largest, std::abs(force.value(std::fmod(i * std::numbers::phi, 1.0) * span)));
  std::vector<FreeVibration> vibrations;
  for (const auto& [natural, coefficient] : reaction.modes)
    vibrations.push_back({natural, std::abs(coefficient * std::pow(omega, 3) /
                                            ((omega - natural) * (omega + natural) * natural)) /
                                       largest});
  return vibrations;
}

double buckling_load(const data::Case& problem) { return stick_buckling_load(problem.beam()); }

bool is_buckled(const data::Case& problem) { return problem.normal_force() >= buckling_load(problem); }

}  // namespace stickslip::analytic
