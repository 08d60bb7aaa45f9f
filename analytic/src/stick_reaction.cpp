// SPDX-License-Identifier: MIT
#include "stickslip/analytic/stick_reaction.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "beam_constants.hpp"
#include "damped_table.hpp"
#include "stickslip/analytic/damped_steady_state.hpp"
#include "stickslip/analytic/held_motion.hpp"
#include "stickslip/analytic/random_reaction.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/analytic/timoshenko_modes.hpp"

namespace stickslip::analytic {
namespace {

double angular_frequency(const data::Case& problem) {
  return 2.0 * std::numbers::pi * problem.excitation().frequency_hz();
}

StickResponse exact_response(const data::Case& problem, int modes) {
  return {problem.beam(), of_unit_load(problem).excitation(), modes, SteadyPart::exact};
}

Bounds widened(const Bounds& force, double by) { return {std::max(0.0, force.lower - by), force.upper + by}; }

ModalReaction undamped_reaction(const data::Case& problem);

// Of a general motion, with what modes left out can change if it is asked for and known.
Bounds of_motion(const data::Case& problem, int modes, bool with_omitted) {
  const data::Case unit = of_unit_load(problem);
  if (unit.is_random()) {
    const double even = random_reaction(unit, modes).exceeded_with(0.5, unit.numerics.duration());
    return {even, even};
  }
  const MotionReaction found = motion_reaction(unit, modes);
  return with_omitted ? found.largest() : found.of_modes;
}

// Any but an undamped beam on a wall at rest.
bool needs_held_structure(const data::Case& problem) {
  return problem.model() != nullptr || problem.is_damped() || wall_share(problem) != 1.0;
}

// Eq. (28) is that of a beam on a wall at rest.
SteadyPart part_of_truncated(const data::Case& problem) {
  return problem.model() == nullptr && wall_share(problem) == 1.0 ? SteadyPart::modal_sum : SteadyPart::exact;
}

// L_n
double load_share(const HeldStructure& structure, std::size_t n) {
  return structure.participation[n] - structure.wall_share * structure.mass_coupling[n];
}

// What h_tt takes at once: of the modes that are not kept, as residual mass.
double inertia(const HeldStructure& structure) {
  double inertia = structure.wall_share * structure.contact_mass - structure.participation.back();
  for (std::size_t n = 0; n < structure.modes(); ++n)
    inertia += structure.mass_coupling[n] * load_share(structure, n);
  return inertia;
}

}  // namespace

bool is_proportional_to_scale(const data::Case& problem) {
  return problem.general_motion() != nullptr && !problem.contact.wall_motion && problem.constant_force == 0.0;
}

double load(const data::Case& problem) {
  if (!problem.has(data::Feature::general_motion)) return problem.excitation().amplitude();
  return is_proportional_to_scale(problem) ? problem.general_motion()->scale() : 1.0;
}

data::Case of_unit_load(const data::Case& problem) {
  if (!problem.has(data::Feature::general_motion))
    return with(problem, data::HarmonicExcitation(
                             {.frequency_hz = problem.excitation().frequency_hz(), .amplitude = 1.0}));
  return is_proportional_to_scale(problem) ? with(problem, problem.general_motion()->scaled(1.0)) : problem;
}

// With g = Ω³ √(α β), h = κ δ Ω α, ω the lowest frequency left out, x = Ω/ω and q = 1/(1 - x²).
OmittedForce omitted_force(const data::Case& problem, const HeldStructure& structure) {
  const double omega = angular_frequency(problem), delta = problem.damping.mass_proportional();
  const auto& [lowest, contact, load] = structure.omitted;
  const double x = omega / lowest, q = 1.0 / (1.0 - x * x);
  if (!(x < 1.0)) return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  const double g = std::pow(omega, 3) * std::sqrt(contact * load),
               h = structure.wall_share * delta * omega * contact, slow = delta / lowest;
  return {.start_up = (g + slow * h) * (1.0 + 2.0 * x * q) + h * (1.0 + 2.0 * x * x * q) + 2.0 * slow * g * q,
          .steady = (x * q + slow * q) * g + (x * x * q + slow * x * q) * h};
}

StickReaction::StickReaction(const data::Case& problem, Kept kept)
    : kept_(std::make_shared<const Kept>(std::move(kept))),
      omega_(kept_->of_motion ? 0.0 : angular_frequency(problem)),
      duration_(problem.numerics.duration()) {}

StickReaction::StickReaction(const data::Case& problem) : StickReaction(problem, kept_of(problem)) {}

StickReaction::StickReaction(const data::Case& problem, int modes)
    : StickReaction(problem, kept_of(problem, modes)) {}

StickReaction::StickReaction(const data::Case& problem, ModalReaction reaction)
    : StickReaction(problem, Kept{.undamped = std::move(reaction), .damped = {}, .half = {}}) {}

StickReaction::StickReaction(const data::Case& problem, DampedReaction reaction,
                             std::optional<DampedReaction> half)
    : StickReaction(problem, Kept{.undamped = {}, .damped = std::move(reaction), .half = std::move(half)}) {}

StickReaction::Kept StickReaction::kept_of(const data::Case& problem) {
  Kept kept;
  if (problem.has(data::Feature::general_motion)) {
    kept.of_motion = of_motion(problem, problem.numerics.modes(), false);
    return kept;
  }
  if (needs_held_structure(problem))
    kept.damped =
        damped_reaction(held_structure(problem, problem.numerics.modes()), part_of_truncated(problem));
  if (!problem.is_damped()) kept.undamped = undamped_reaction(problem);
  return kept;
}

StickReaction::Kept StickReaction::kept_of(const data::Case& problem, int modes) {
  Kept kept;
  if (problem.has(data::Feature::general_motion)) {
    kept.of_motion = of_motion(problem, modes, true);
  } else if (needs_held_structure(problem)) {
    const HeldStructure structure = held_structure(problem, modes);
    kept.damped = damped_reaction(structure, SteadyPart::exact);
    const bool is_model = problem.model() != nullptr,
               has_more = std::isfinite(structure.omitted.angular_frequency);
    if (is_model && has_more) kept.omitted = omitted_force(problem, structure);
    if (!is_model || (has_more && !problem.model()->matrices().damping.empty()))
      kept.half = damped_reaction(held_structure(problem, modes / 2), SteadyPart::exact);
  } else if (problem.has(data::Feature::shear)) {
    const double omega = angular_frequency(problem);
    kept.undamped = timoshenko_reaction(problem.beam(), modes, omega);
    kept.omitted.start_up = timoshenko_omitted_transient(timoshenko_reaction(problem.beam(), modes), omega);
  } else {
    const StickResponse response = exact_response(problem, modes);
    kept.undamped = response.reaction();
    kept.omitted.start_up = response.omitted_transient_bound();
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
  return largest_against(std::nullopt, relative_width);
}

Bounds StickReaction::largest_against(std::optional<double> limit, double relative_width) const {
  if (kept_->of_motion) return *kept_->of_motion;
  const double by = kept_->omitted.start_up;
  const auto bounds = [&](const auto& force) {
    if (!limit) return force.refined_to(relative_width);
    return force.refined_to(relative_width, std::max(0.0, *limit - by), *limit + by);
  };
  return widened(
      kept_->damped ? bounds(damped_force()) : bounds(ForceMaximum(*kept_->undamped, omega_, duration_)), by);
}

Bounds StickReaction::damped_steady() const {
  return widened(damped_force().steady_bounds(), kept_->omitted.steady);
}

bool StickReaction::exceeds(double limit, double relative_width) const {
  return largest_against(limit, relative_width).lower > limit;
}

BandMaximum StickReaction::over(const FrequencyBand& band, DampedForcePart part) const {
  if (kept_->undamped) return {*kept_->undamped, band, duration_};
  return {*kept_->damped, band, duration_, part};
}

double StickReaction::decay_near(double omega) const {
  if (!kept_->damped) return 0.0;
  const auto nearest = std::ranges::min_element(kept_->damped->shares, {}, [omega](const ModalShare& share) {
    return std::abs(std::abs(share.eigenvalue) - omega);
  });
  return -nearest->eigenvalue.real();
}

double StickReaction::slowest_decay() const {
  if (!kept_->damped) return 0.0;
  double slowest = std::numeric_limits<double>::infinity();
  for (const ModalShare& share : kept_->damped->shares) slowest = std::min(slowest, -share.eigenvalue.real());
  return slowest;
}

void StickReactions::tabulate(std::span<const data::Case> cases, std::size_t structures) {
  constexpr double most_of_buckling = 0.999;  // below which a table keeps its digits
  const double infinite = std::numeric_limits<double>::infinity();
  load_factor_ = damping_ = {infinite, 0.0};
  for (const data::Case& problem : cases) {
    if (problem.model() != nullptr || (first_.is_damped() && !are_alike(problem, first_))) return;
    const auto [z, q] = damped_numbers(problem);
    load_factor_ = {std::min(load_factor_.lower, z), std::max(load_factor_.upper, z)};
    damping_ = {std::min(damping_.lower, q), std::max(damping_.upper, q)};
  }
  const double buckling = buckling_load(first_) / first_.normal_force() * axial_load_factor(first_.beam());
  load_factor_.upper = std::min(load_factor_.upper, most_of_buckling * buckling);
  if (!(load_factor_.lower > 0.0 && load_factor_.lower <= load_factor_.upper) ||
      first_.has(data::Feature::shear))
    return;
  if (first_.is_damped())
    most_points_ = structures / 4;
  else if (!needs_held_structure(first_))
    table_.emplace(load_factor_.lower, load_factor_.upper, first_.numerics.modes(),
                   first_.beam().axial_direction());
}

std::optional<DampedReaction> StickReactions::tabulated(const data::Case& problem, int modes,
                                                        SteadyPart part) const {
  constexpr int most_modes = 40;
  if (most_points_ == 0 || modes > most_modes || !problem.is_damped()) return std::nullopt;
  std::shared_ptr<const DampedReactionTable> table;
  {
    const std::lock_guard lock(guard_);
    const auto [known, is_new] = damped_tables_.try_emplace(std::pair(modes, part));
    if (is_new)
      if (auto made = DampedReactionTable::of(first_, load_factor_, damping_, modes, part, most_points_))
        known->second = std::make_shared<const DampedReactionTable>(std::move(*made));
    table = known->second;
  }
  if (table == nullptr || !table->holds(problem)) return std::nullopt;
  return table->at(problem);
}

StickReaction StickReactions::of(const data::Case& problem, int modes) const {
  if (auto reaction = tabulated(problem, modes, SteadyPart::exact))
    if (auto half = tabulated(problem, modes / 2, SteadyPart::exact))
      return {problem, std::move(*reaction), std::move(half)};
  return {problem, modes};
}

StickReaction StickReactions::of(const data::Case& problem) const {
  if (problem.has(data::Feature::general_motion)) return StickReaction(problem);
  if (table_ && problem.numerics.modes() == first_.numerics.modes() && !needs_held_structure(problem) &&
      table_->holds(problem.beam()))
    return {problem, table_->at(problem.beam())};
  if (auto reaction = tabulated(problem, problem.numerics.modes(), part_of_truncated(problem)))
    return {problem, std::move(*reaction)};
  const auto has_its_modes = [&](const Known& known) {
    return problem.numerics.modes() == known.problem.numerics.modes() &&
           problem.structure == known.problem.structure && problem.damping == known.problem.damping &&
           wall_share(problem) == wall_share(known.problem) &&
           problem.excitation().is_force() == known.problem.excitation().is_force();
  };
  {
    const std::lock_guard lock(guard_);
    if (const auto known = std::ranges::find_if(known_, has_its_modes); known != known_.end())
      return known->reaction.of(problem);
  }
  StickReaction made(problem);
  const std::lock_guard lock(guard_);
  constexpr std::size_t most = 16;
  if (known_.size() == most) known_.pop_front();
  known_.push_back({problem, made});
  return made;
}

ModesOfAll modes_of_all(const data::Case& problem, bool verdict_alone) {
  if (problem.has(data::Feature::general_motion)) {
    const int most = problem.model() != nullptr ? 240 : 160;
    return {.first = std::clamp(problem.numerics.modes(), 40, most), .most = most};
  }
  const bool is_undamped = !needs_held_structure(problem);
  ModesOfAll modes{.first = is_undamped ? 200 : 40, .most = is_undamped ? 800 : 160};
  if (problem.model() != nullptr) modes = {.first = 60, .most = 240};
  if (verdict_alone && is_undamped) modes.first = std::clamp(4 * problem.numerics.modes(), 40, 200);
  const double omega = angular_frequency(problem);
  for (;; modes.first = std::min(2 * modes.first, modes.most)) {
    const auto held = held_modes(problem, modes.first);
    if (const int all = static_cast<int>(held.size()); all < modes.first) return {all, all};
    const double highest = held.back().angular_frequency;
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
  if (!needs_held_structure(problem)) {
    if (problem.has(data::Feature::shear)) return exactly(timoshenko_steady_force(problem.beam(), omega));
    return exactly(exact_response(problem, modes_of_all(problem).first).steady_force_amplitude());
  }
  if (problem.model() == nullptr && wall_share(problem) == 1.0 && problem.damping.is_kelvin_voigt()) {
    return exactly(std::abs(DampedSteadyState(problem.beam(), of_unit_load(problem).excitation(),
                                              problem.damping, TipSupport::held)
                                .friction_force()));
  }
  const Bounds force = StickReaction(problem, modes_of_all(problem).first).damped_steady();
  const double infinite = std::numeric_limits<double>::infinity();
  return std::isfinite(force.upper) ? force : Bounds{infinite, infinite};  // without damping at a frequency
}

std::vector<ModalForce> held_modes(const data::Case& problem, int count) {
  if (problem.model() == nullptr && wall_share(problem) == 1.0) return modal_forces(problem.beam(), count);
  const HeldStructure structure = held_structure(problem, count);
  std::vector<ModalForce> modes;
  for (std::size_t n = 0; n < structure.modes(); ++n) {
    const double omega = structure.angular_frequency[n];
    modes.push_back({omega, (structure.mass_coupling[n] * omega * omega - structure.follower[n]) *
                                load_share(structure, n)});
  }
  return modes;
}

namespace {

ModalReaction undamped_reaction(const data::Case& problem) {
  const int modes = problem.numerics.modes();
  if (problem.model() == nullptr && wall_share(problem) == 1.0) return modal_reaction(problem.beam(), modes);
  const HeldStructure structure = held_structure(problem, modes);
  const double stiffness = structure.contact_stiffness + structure.contact_follower;
  return {.quasi_static = structure.wall_share * stiffness - structure.base_stiffness,
          .modes = held_modes(problem, modes),
          .inertia = -inertia(structure)};
}

}  // namespace

std::vector<FreeVibration> free_vibrations(const data::Case& problem) {
  constexpr int instants = 2048;
  const double omega = angular_frequency(problem);
  const ModalReaction reaction = undamped_reaction(problem);
  if (reaction.modes.empty()) return {};
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

double buckling_load(const data::Case& problem) {
  return problem.model() != nullptr ? std::numeric_limits<double>::infinity()
                                    : stick_buckling_load(problem.beam());
}

bool is_buckled(const data::Case& problem) { return problem.normal_force() >= buckling_load(problem); }

}  // namespace stickslip::analytic
