// SPDX-License-Identifier: MIT
#pragma once

/// The force that holds the contact of a case while it sticks: the one door from a case to its physics. Shear, damping, a structure of
/// one's own and what each of them costs stay behind it.
///
/// Every force here is per unit of load(): of one sine per unit amplitude of the base displacement, N/m. It is that of the excitation
/// frequency Ω, or of the general motion, and of the duration T of the case.

#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "stickslip/analytic/band_maximum.hpp"
#include "stickslip/analytic/contact_model.hpp"
#include "stickslip/analytic/damped_reaction.hpp"
#include "stickslip/analytic/force_maximum.hpp"
#include "stickslip/analytic/modal_reaction.hpp"
#include "stickslip/data/problem.hpp"

namespace stickslip::analytic {

/// What modes that are left out change of the force at most, N/m. In a Model they have, with the load of its wall, C = δ M + η K and ratios
/// of the held modes,
///
///     T_n_tt + 2 ζ_n ω_n T_n_t + ω_n² T_n = -L_n h_tt + κ δ a_n h_t,      h = sin(Ω t),
///
/// and leave out of the force Σ a_n (T_n_tt + δ T_n_t). An impulse of 1 moves such a mode by no more than 1/ω_n, with a velocity of no more
/// than 1, whatever its damping, and it follows a force sin(Ω t) or cos(Ω t) by no more than 2/(ω_n² - Ω²). So
///
///     |T_n_tt| ≤ |L_n| Ω³ (1/ω_n + 2 Ω/(ω_n² - Ω²)) + κ δ |a_n| Ω (1 + 2 Ω²/(ω_n² - Ω²)),
///
/// T_n_t likewise, and the sums over n follow from α = Σ a_n² and β = Σ (L_n/ω_n)² of HeldStructure::omitted by the inequality of Cauchy
/// and Schwarz: without δ, Ω³ √(α β) (1 + 2 x/(1 - x²)), x = Ω/ω. In the steady vibration it is Ω³ √(α β) x/(1 - x²).
struct OmittedForce {
  double start_up{}, steady{};
};
/// Infinite where Ω is not below the lowest frequency left out. `structure`: of this case.
[[nodiscard]] OmittedForce omitted_force(const data::Case& problem, const HeldStructure& structure);

/// Whether |f_max| is proportional to excitation.scale: of a general motion that moves the base alone.
[[nodiscard]] bool is_proportional_to_scale(const data::Case& problem);

/// What the forces here are multiplied by for those of the case: the amplitude of one sine, m; where is_proportional_to_scale(), the scale;
/// of other general motions 1.
[[nodiscard]] double load(const data::Case& problem);
/// The case with load() = 1, whose forces are those here.
[[nodiscard]] data::Case of_unit_load(const data::Case& problem);

/// The reaction of one case. That of a general motion is motion_reaction(), which knows largest() and exceeds() alone; what asks for more
/// throws what Case::excitation() throws. The largest |f| of a random motion is the one with even odds, RandomReaction::exceeded_with(0.5).
class StickReaction {
 public:
  /// With the first numerics.modes() modes, Eq. (28): ModalReaction, or with damping DampedReaction. The other modes of a Model, and of a
  /// beam whose wall moves with its base, count with their residual mass. Throws what these and held_structure() throw, and
  /// data::FieldError, naming beam.shear_stiffness, for shear together with damping or such a wall.
  explicit StickReaction(const data::Case& problem);
  /// With `modes` modes, the exact steady part and bounds of what is left out (StickResponse::omitted_transient_bound(),
  /// timoshenko_omitted_transient(), OmittedForce or DampedForce, whose conditions hold). The damping matrix of a Model couples
  /// its modes: where some are left out, their bounds are OmittedForce and that of DampedForce together, an estimate.
  StickReaction(const data::Case& problem, int modes);
  /// With these modes of an undamped beam, or of a damped one, those of the case; with those of half as many modes it has the bounds of
  /// what is left out.
  StickReaction(const data::Case& problem, ModalReaction reaction);
  StickReaction(const data::Case& problem, DampedReaction reaction, std::optional<DampedReaction> half = {});

  /// The reaction of another case with the same structure, damping and number of modes, which are not computed again.
  [[nodiscard]] StickReaction of(const data::Case& other) const;

  /// Bounds of max |f| over 0 ≤ t ≤ T: ForceMaximum or DampedForce, widened by what is left out. Throws what refined_to() throws.
  [[nodiscard]] Bounds largest(double relative_width = 1e-10) const;
  /// The same with less work: the bounds may be wide where they leave no doubt on which side of the limit, N/m, max |f| is, and an upper one
  /// says nothing where the lower one is above it.
  [[nodiscard]] Bounds largest_against(std::optional<double> limit, double relative_width = 1e-10) const;
  /// Whether max |f| exceeds the limit, N/m: largest(relative_width).lower > limit, with fewer evaluations.
  [[nodiscard]] bool exceeds(double limit, double relative_width = 1e-10) const;
  /// The search for the largest max |f| over a band of frequencies.
  [[nodiscard]] BandMaximum over(const FrequencyBand& band,
                                 DampedForcePart part = DampedForcePart::start_up) const;
  /// Bounds of the amplitude of the steady part of a damped case (DampedForce::steady_bounds()).
  [[nodiscard]] Bounds damped_steady() const;
  /// 1/s, of the free vibration with the |λ| next to ω, rad/s; 0 without damping.
  [[nodiscard]] double decay_near(double omega) const;
  /// 1/s, of the free vibration of the kept modes that decays least; 0 without damping, infinite without modes.
  [[nodiscard]] double slowest_decay() const;

 private:
  struct Kept {
    std::optional<ModalReaction> undamped;
    std::optional<DampedReaction> damped, half;  // half as many modes of it, for what is left out
    OmittedForce omitted{};                      // besides that
    std::optional<Bounds> of_motion{};           // in place of all that
  };
  StickReaction(const data::Case& problem, Kept kept);
  [[nodiscard]] static Kept kept_of(const data::Case& problem);
  [[nodiscard]] static Kept kept_of(const data::Case& problem, int modes);
  [[nodiscard]] DampedForce damped_force() const;

  std::shared_ptr<const Kept> kept_;
  double omega_{}, duration_{};
};

class DampedReactionTable;

/// The reactions of many cases. They share the modes of the latest ones where they can, or take them from a table.
class StickReactions {
 public:
  explicit StickReactions(const data::Case& first) : first_(first) {}

  /// From now on the modes of beams are interpolated (ModalReactionTable, DampedReactionTable) where the load factor P L²/EI and the
  /// damping are in the range of these cases, and up to 0.999 of the buckling load, if that takes less than a fourth of so many structures.
  /// Those of other beams are computed as before.
  void tabulate(std::span<const data::Case> cases, std::size_t structures);

  /// StickReaction(problem). Throws what that throws.
  [[nodiscard]] StickReaction of(const data::Case& problem) const;
  /// StickReaction(problem, modes), from tables for up to 40 damped modes.
  [[nodiscard]] StickReaction of(const data::Case& problem, int modes) const;

 private:
  [[nodiscard]] std::optional<DampedReaction> tabulated(const data::Case& problem, int modes,
                                                        SteadyPart part) const;

  data::Case first_;
  std::optional<ModalReactionTable> table_;
  Bounds load_factor_{}, damping_{};  // the range
  std::size_t most_points_{};         // of a table of damped reactions
  mutable std::mutex guard_;
  mutable std::map<std::pair<int, SteadyPart>, std::shared_ptr<const DampedReactionTable>> damped_tables_;
  struct Known {
    data::Case problem;
    StickReaction reaction;
  };
  mutable std::deque<Known> known_;
};

/// How many modes StickReaction needs for the force of all modes, and how many it may have. Beyond, they would be beyond the closed
/// form, or lose the slow vibrations in the rounding of the fast ones.
struct ModesOfAll {
  int first{}, most{};
};
/// Under a general motion 40 (or numerics.modes) to 160 modes, of a Model 240. Of one sine 200 to 800; with damping, which couples them, or a wall that moves with the base 40 to 160; of a Model 60 to 240, or all there are; the first is doubled until the highest mode is at 4 Ω or above. Where a
/// verdict alone counts, undamped ones begin with 40 or 4 numerics.modes. Throws data::FieldError, naming
/// excitation.frequency_hz, where the most are too few.
[[nodiscard]] ModesOfAll modes_of_all(const data::Case& problem, bool verdict_alone = false);

/// The amplitude of f in the steady vibration, with all modes: exact, but for bounds where modes are coupled by damping that is not
/// Kelvin-Voigt's alone. Infinite without damping at a natural frequency.
[[nodiscard]] Bounds steady_reaction(const data::Case& problem);

/// The frequencies of the first `count` modes with their shares in the reaction, undamped, ascending. A Model may have fewer, one mass none.
[[nodiscard]] std::vector<ModalForce> held_modes(const data::Case& problem, int count);

/// One free vibration of the undamped structure with its contact held.
struct FreeVibration {
  double angular_frequency{};  ///< rad/s
  double share{};              ///< its amplitude over the largest |f| of 2048 instants
};
/// Those of the first numerics.modes() modes.
[[nodiscard]] std::vector<FreeVibration> free_vibrations(const data::Case& problem);

/// The axial force at which the held beam buckles, N (stick_buckling_load()), infinite for a Model, and whether that of the case is so large or larger.
[[nodiscard]] double buckling_load(const data::Case& problem);
[[nodiscard]] bool is_buckled(const data::Case& problem);

}  // namespace stickslip::analytic
