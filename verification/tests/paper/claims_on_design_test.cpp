// SPDX-License-Identifier: MIT
/// Claims of Sect. 5 on Fig. 14: which lengths and axial forces avoid stick-slip.

#include "paper/measure.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "studies/analyses/length_force_map.hpp"
#include "studies/common/problem_parameter.hpp"
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
  return analytic::evaluate_criterion(with(flat(), flat_beam(length, axial_force)), 1e-3).verdict ==
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

TEST(Figure14, ItsBeamsAreSlender) {
  const double depth = std::sqrt(12.0 * flat().beam().second_moment_of_area() / flat().beam().area());
  judge("fig14.slender", {.as_printed = 0.4 / depth >= 10.0 && 2.0 / depth >= 10.0},
        "the beams are {:.0f} to {:.0f} times as long as they are deep", 0.4 / depth, 2.0 / depth);
}

// An axis of axial forces from 5 N to just below the buckling load, in equal ratios.
std::vector<double> axial_forces(double length) {
  std::vector<double> forces = evenly_spaced(0.0, 1.0, 1.0 / 80);
  for (double& force : forces) force = 5.0 * std::pow(0.9995 * buckling_load(length) / 5.0, force);
  return forces;
}

TEST(Figure14, StripsOfSlipAreAboveTheLine) {
  int strips = 0, explained = 0;
  for (const double length : {0.5, 0.7, 0.84, 1.2, 1.53, 1.8}) {
    const auto forces = axial_forces(length);
    const auto is_below_25_hz = [length](double force, int mode) {
      return analytic::stick_modes(flat_beam(length, force), mode).back().frequency_hz() < 25.0;
    };
    for (std::size_t i = 1; i < forces.size(); ++i) {
      if (!slips(length, forces[i]) || slips(length, forces[i - 1])) continue;
      std::size_t end = i + 1;  // of a strip of stick-slip above a stick region
      while (end < forces.size() && slips(length, forces[end])) ++end;
      ++strips;
      const bool reaches_buckling = end == forces.size();
      const auto is_passed = [&](int mode) {
        return !is_below_25_hz(forces[i - 1], mode) && is_below_25_hz(forces[end], mode);
      };
      explained += reaches_buckling || is_passed(1) || is_passed(2) ? 1 : 0;
    }
  }
  judge("fig14.regions", {.as_printed = strips == 0, .instead = explained == strips},
        "{} strips; in {} of them a natural frequency passes 25 Hz, or the beam is about to buckle", strips,
        explained);
}

TEST(Figure14, EscapeNearResonanceTakesAHighForce) {
  const double first = resonance(1, printed_axial_force), second = resonance(2, printed_axial_force);
  const double between = 0.5 * (first + second);
  const double at_first = escape_force(first), at_second = escape_force(second),
               usual = escape_force(between);
  judge("fig14.extremely-high", {.as_printed = std::min(at_first, at_second) > 10.0 * usual},
        "{:.0f} N for {:.3f} m and {:.0f} N for {:.3f} m, {:.0f} N for {:.3f} m between them", at_first,
        first, at_second, second, usual, between);
}

TEST(Figure14, LargerForceAvoidsItNearResonance) {
  // "Inevitable": at every axial force up to the buckling load.
  bool always = true, escapes = true;
  std::vector<double> shares;
  for (const int mode : {1, 2}) {
    const double length = resonance(mode, printed_axial_force), buckling = buckling_load(length),
                 half = 0.5 * buckling;
    always &=
        std::ranges::all_of(axial_forces(length), [length](double force) { return slips(length, force); });
    escapes &= !slips(length, half) && !solver::first_slip(with(flat(), flat_beam(length, half)));
    shares.push_back(100.0 * escape_force(length) / buckling);
  }
  judge("fig14.inevitable", {.as_printed = always, .instead = escapes},
        "stick from {:.0f} % of the buckling load on; at half of it both implementations stick",
        fmt::join(shares, " and "));
}

TEST(Figure14, LengthsOffResonanceAvoidStickSlip) {
  const auto is_far = [](double length, const std::vector<double>& others) {
    return std::ranges::all_of(others, [length](double other) { return std::abs(length - other) > 0.1; });
  };
  int far_from_printed = 0, far_from_own = 0, slipping = 0;
  for (const double force : {300.0, 500.0, 1000.0, 2000.0, 4000.0, 7000.0}) {
    std::vector<double> own{std::sqrt(buckling_load(1.0) / force)};  // where the beam buckles
    for (const int mode : {1, 2})
      if (const auto length = studies::resonance_length(flat_beam(1.0, force), mode, 25.0))
        own.push_back(*length);
    for (const double length : evenly_spaced(0.4, 2.0, 0.01)) {
      if (force > 0.99 * buckling_load(length) || !slips(length, force)) continue;
      ++slipping;
      far_from_printed += is_far(length, {0.88, 1.58}) ? 1 : 0;
      far_from_own += is_far(length, own) ? 1 : 0;
    }
  }
  judge("fig14.recommended-lengths", {.as_printed = far_from_printed == 0, .instead = far_from_own == 0},
        "{} slip, {} of them far from 0.88 and 1.58 m, {} far from the lengths of their own axial force",
        slipping, far_from_printed, far_from_own);
}

}  // namespace
}  // namespace stickslip::testing
