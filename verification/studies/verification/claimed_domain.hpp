// SPDX-License-Identifier: MIT
#pragma once

/// The critical amplitude by the closed form of the paper's model against that by finite elements and in other models, over the
/// box of dimensionless groups that the report claims. The numbers of all cases are in verification/studies/claimed-domain.csv.

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "studies/common/members.hpp"

namespace stickslip::studies {

/// A point of the box, the critical amplitude A_0 there and its relative change in each model, A/A_0 - 1. The axial force follows the
/// tip, the beam is undamped and rigid in shear, and contact and P are constant, except in the model named.
struct DomainCase {
  double index{};              ///< of the Sobol' point, from 1
  double load{};               ///< P over the buckling load of the stick state
  double frequency{};          ///< Ω/ω_1 of the stick state
  double periods{};            ///< duration times ω_1/2π
  double friction{};           ///< μ_s
  double slenderness{};        ///< L √(A/I)
  double damping{};            ///< damping.ratio of the damped beam
  double direction{};          ///< χ of the other direction of the axial force
  double contact_stiffness{};  ///< k_t over 3EI/L³
  double spring{};             ///< stiffness of the spring that presses the tip, over 3EI/L³
  double distance{};           ///< |Ω/ω_n - 1| of the nearest natural frequency of the stick state
  double amplitude{};          ///< A_0/L
  double finite_elements{};    ///< with the mesh, step and spectral radius of the paper's case, tip bonded
  double shear{};              ///< shear and rotary inertia, with_shear()
  double direction_change{}, contact_change{}, damping_change{};
  /// P falls by the spring's stiffness times the largest draw-back, at the instant of the largest force: the most that it can do.
  double draw_back{};
};
STICKSLIP_MEMBERS(DomainCase, (index, "1"), (load, "1"), (frequency, "1"), (periods, "1"), (friction, "1"),
                  (slenderness, "1"), (damping, "1"), (direction, "1"), (contact_stiffness, "1"),
                  (spring, "1"), (distance, "1"), (amplitude, "1"), (finite_elements, "1"), (shear, "1"),
                  (direction_change, "1"), (contact_change, "1"), (damping_change, "1"), (draw_back, "1"))

/// A group of the box: least and greatest value, and the least and the greatest with which the margin holds.
struct DomainGroup {
  std::string name;
  double DomainCase::*value;
  double least, greatest;
  bool is_log;
  double margin_least, margin_greatest;
};
/// The names of the models, and the changes by them.
[[nodiscard]] const std::vector<std::pair<std::string, double DomainCase::*>>& domain_models();
/// In the order of the coordinates of the Sobol' points.
[[nodiscard]] const std::array<DomainGroup, 9>& domain_groups();
inline constexpr double resonance_distance = 0.1;  ///< the least distance with which the margin holds
inline constexpr int domain_cases = 512, domain_corners = 16;

/// Case `index`: points 1 to domain_cases of gsl_qrng_sobol in the box, as many more points 1, 2, ... in the domain of the margin, and then
/// its corners. `paper` gives the flexural rigidity, mass per length, length, mesh, step and modes. The bounds of each amplitude are
/// 1e-6 apart; the modes kept are the same in all models, and the exact steady part is that of the contact that yields alone.
[[nodiscard]] DomainCase domain_case(const data::Case& paper, int index);

/// Whether the margin holds there: in the narrower box and away from resonance.
[[nodiscard]] bool is_in_margin(const DomainCase& one);

/// verification/studies/claimed-domain.csv, next to the folder of the cases.
[[nodiscard]] std::filesystem::path domain_file();
[[nodiscard]] std::vector<DomainCase> read_domain(const std::filesystem::path& file);
[[nodiscard]] std::string domain_text(const std::vector<DomainCase>& cases);
/// Throws std::runtime_error, naming row and column, if two rows differ by more than 1e-4 of the value or 1e-5, whichever is more: six
/// digits are kept, and the bounds are 1e-6 wide.
void require_same(const DomainCase& kept, const DomainCase& computed);
/// `count` different rows, drawn by the text.
[[nodiscard]] std::vector<DomainCase> drawn_rows(std::vector<DomainCase> cases, std::size_t count,
                                                 std::string_view text);

/// Over the points in the box, or over those of the domain of the margin that are away from resonance; the worst with the corners.
struct ModelDeviation {
  std::string model;
  std::size_t cases{};
  double bias{}, spread{};  ///< mean and standard deviation of the relative change
  double worst{};           ///< the largest fall, at least 0
  DomainCase place{};       ///< where
  double unsafe_share{};    ///< of the cases in which it falls by more than 1e-4
};
STICKSLIP_MEMBERS(ModelDeviation, (model, "-"), (cases, "1"), (bias, "1"), (spread, "1"), (worst, "1"),
                  (place), (unsafe_share, "1"))

STICKSLIP_MEMBERS(DomainGroup, (name, "-"), (least, "1"), (greatest, "1"), (margin_least, "1"),
                  (margin_greatest, "1"))

struct ClaimedDomain {
  std::vector<DomainCase> cases;
  std::vector<ModelDeviation> box,
      margin;  ///< by model; the last is all models together, the falls one on top of the other
  std::vector<DomainGroup> groups;
  double distance{resonance_distance};
  int points{domain_cases}, corners{domain_corners};
  std::size_t recomputed{};
};
STICKSLIP_MEMBERS(ClaimedDomain, (cases), (box), (margin), (groups), (distance, "1"), (points, "1"),
                  (corners, "1"), (recomputed, "1"))

/// Computes `count` rows of the file again, drawn by `text`. Throws what require_same() throws.
[[nodiscard]] ClaimedDomain claimed_domain(const data::Case& paper, std::size_t count, std::string_view text);

}  // namespace stickslip::studies
