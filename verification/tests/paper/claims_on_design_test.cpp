// SPDX-License-Identifier: MIT
/// Claims of Sect. 5 on Fig. 14: which lengths and axial forces avoid stick-slip.

#include "stickslip/analytic/stick_modes.hpp"
#include "studies/analyses/length_force_map.hpp"
#include "studies/common/problem_parameter.hpp"
#include "support/claims.hpp"
#include "support/paper_case.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

constexpr double printed_axial_force = 500.0;

const data::Case& flat() {
  static const data::Case instance = data::load_case("paper-figure14");
  return instance;
}

bool slips(double length, double axial_force) {
  return studies::criterion_of(with(flat(), flat_beam(length, axial_force)), 1e-3).verdict ==
         analytic::Verdict::stick_slip;
}

double buckling_load(double length) { return analytic::stick_buckling_load(flat_beam(length, 0.0)); }

// L_n at an axial force, m.
double resonance(int mode, double axial_force) {
  return studies::resonance_length(flat_beam(1.0, axial_force), mode, 25.0).value();
}

// The axial force up to which a beam slips from 5 N on, N, to 0.1 %.
double escape_force(double length) {
  double low = 5.0;
  while (slips(length, 1.1 * low)) low *= 1.1;
  double high = 1.1 * low;
  while (high > 1.001 * low) {
    const double middle = std::sqrt(low * high);
    (slips(length, middle) ? low : high) = middle;
  }
  return high;
}

TEST(ClaimOnFigure14, ItsBeamsAreSlender) {
  constexpr double depth = 0.02;
  judge(
      "fig14.slender", {.as_printed = 0.4 / depth >= 10.0 && 2.0 / depth >= 10.0},
      fmt::format("the beams are {:.0f} to {:.0f} times as long as they are deep", 0.4 / depth, 2.0 / depth));
}

// An axis of axial forces from 5 N to just below the buckling load, in equal ratios.
std::vector<double> axial_forces(double length) {
  constexpr int last = 80;
  std::vector<double> forces;
  for (int i = 0; i <= last; ++i)
    forces.push_back(5.0 * std::pow(0.9995 * buckling_load(length) / 5.0, static_cast<double>(i) / last));
  return forces;
}

TEST(ClaimOnFigure14, AboveTheLineThereAreStripsOfStickSlip) {
  const std::vector<double> lengths{0.5, 0.7, 0.84, 1.2, 1.53, 1.8};
  int strips = 0, explained = 0, lengths_with_one_line = 0;
  for (const double length : lengths) {
    const auto forces = axial_forces(length);
    const auto hz = [length](double force, int mode) {
      return analytic::stick_modes(flat_beam(length, force), mode).back().frequency_hz();
    };
    std::vector<bool> slipping;
    for (const double force : forces) slipping.push_back(slips(length, force));
    const int before = strips;
    for (std::size_t i = 1; i < forces.size(); ++i) {
      if (!slipping[i] || slipping[i - 1])
        continue;  // a strip of stick-slip above a stick region begins at i
      ++strips;
      std::size_t end = i;
      while (end + 1 < forces.size() && slipping[end + 1]) ++end;
      const double above = forces[std::min(end + 1, forces.size() - 1)];
      bool resonant = false;
      for (const int mode : {1, 2}) resonant |= hz(forces[i - 1], mode) > 25.0 && hz(above, mode) < 25.0;
      explained += resonant || end + 1 == forces.size() ? 1 : 0;
    }
    lengths_with_one_line += strips == before ? 1 : 0;
  }
  judge("fig14.regions", {.as_printed = strips == 0, .instead = explained == strips},
        fmt::format("above the line {} further strips of stick-slip cross {} lengths from 0.5 to 1.8 m; in "
                    "{} of them a natural frequency, lowered by the axial force, passes 25 Hz, or the "
                    "buckling load is within 0.05 %",
                    strips, lengths.size() - static_cast<std::size_t>(lengths_with_one_line), explained));
}

void judge_printed_length(const std::string& claim, int mode) {
  const std::string number = fmt::format("figure14.length.{}", mode);
  const double none = resonance(mode, 0.0), at_500 = resonance(mode, printed_axial_force),
               at_1000 = resonance(mode, 1000.0);
  judge(claim,
        {.as_printed = is_printed(number, none) && is_printed(number, at_500) && is_printed(number, at_1000),
         .with_a_choice = is_printed(number, at_500)},
        fmt::format("natural frequency {} is 25 Hz at {:.4f} m without axial force, at {:.4f} m with 500 N "
                    "and at {:.4f} m with 1000 N",
                    mode, none, at_500, at_1000));
}

TEST(ClaimOnFigure14, TheFirstNaturalFrequencyIs25HzAt0_88mAnd500N) { judge_printed_length("fig14.l1", 1); }
TEST(ClaimOnFigure14, TheSecondNaturalFrequencyIs25HzAt1_58mAnd500N) { judge_printed_length("fig14.l2", 2); }

TEST(ClaimOnFigure14, EscapeNearResonanceTakesAHighForce) {
  const double first = resonance(1, printed_axial_force), second = resonance(2, printed_axial_force);
  const double between = 0.5 * (first + second);
  const double at_first = escape_force(first), at_second = escape_force(second),
               reference = escape_force(between);
  judge("fig14.extremely-high", {.as_printed = at_first > 10.0 * reference && at_second > 10.0 * reference},
        fmt::format("stick begins at {:.0f} N for {:.3f} m and at {:.0f} N for {:.3f} m ({:.0f} and {:.0f} % "
                    "of the buckling load), at {:.0f} N for {:.3f} m between them",
                    at_first, first, at_second, second, 100.0 * at_first / buckling_load(first),
                    100.0 * at_second / buckling_load(second), reference, between));
}

TEST(ClaimOnFigure14, LargerForceAvoidsStickSlipNearResonance) {
  // "Inevitable": at every axial force up to the buckling load.
  bool always = true, escapes = true;
  std::vector<double> shares;
  for (const int mode : {1, 2}) {
    const double length = resonance(mode, printed_axial_force), buckling = buckling_load(length);
    const auto forces = axial_forces(length);
    always &= std::ranges::all_of(forces, [length](double force) { return slips(length, force); });
    shares.push_back(100.0 * escape_force(length) / buckling);
    const double force = 0.5 * buckling;
    escapes &= !slips(length, force) && !solver::first_slip(with(flat(), flat_beam(length, force)));
  }
  judge("fig14.inevitable", {.as_printed = always, .instead = escapes},
        fmt::format("at L1 and L2 of P = 500 N the tip sticks from {:.0f} and {:.0f} % of the buckling load "
                    "on; at half of that load both implementations stick at both",
                    shares[0], shares[1]));
}

TEST(ClaimOnFigure14, LengthsOffResonanceAvoidStickSlip) {
  const auto all_are_far = [](double length, const std::vector<double>& others) {
    return std::ranges::all_of(others, [length](double other) { return std::abs(length - other) > 0.1; });
  };
  int far_from_printed = 0, far_from_own = 0, slipping = 0, all = 0;
  for (const double force : {300.0, 500.0, 1000.0, 2000.0, 4000.0, 7000.0}) {
    std::vector<double> own{std::sqrt(buckling_load(1.0) / force)};  // where the beam buckles
    for (const int mode : {1, 2})
      if (const auto length = studies::resonance_length(flat_beam(1.0, force), mode, 25.0))
        own.push_back(*length);
    for (int i = 0; i <= 160; ++i) {
      const double length = 0.4 + 0.01 * i;
      if (force > 0.99 * buckling_load(length)) break;
      ++all;
      if (!slips(length, force)) continue;
      ++slipping;
      far_from_printed += all_are_far(length, {0.88, 1.58}) ? 1 : 0;
      far_from_own += all_are_far(length, own) ? 1 : 0;
    }
  }
  judge("fig14.recommended-lengths", {.as_printed = far_from_printed == 0, .instead = far_from_own == 0},
        fmt::format(
            "of {} beams from 0.4 to 2 m under 300 to 7000 N {} slip; {} of these are farther than 0.1 m "
            "from 0.88 and 1.58 m, {} from the resonance and buckling lengths of their own axial force",
            all, slipping, far_from_printed, far_from_own));
}

}  // namespace
}  // namespace stickslip::testing
