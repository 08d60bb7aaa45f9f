// SPDX-License-Identifier: MIT
/// Claims of Sect. 3 on Figs. 6 and 7: the critical amplitude and the natural modes.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "stickslip/analytic/stick_modes.hpp"
#include "studies/criterion/critical_amplitude.hpp"
#include "studies/stick/force_maximum.hpp"
#include "studies/stick/frequencies.hpp"
#include "support/claims.hpp"
#include "support/order.hpp"
#include "support/paper_case.hpp"
#include "support/tolerance.hpp"

namespace stickslip::testing {
namespace {

// The critical amplitude without increments, m: mu_s P over |f_max| per unit amplitude.
struct Curve {
  std::vector<double> closed_form, finite_element;
};

Curve curve_at(const std::vector<double>& frequencies_hz) {
  Curve curve;
  for (const auto& point :
       studies::critical_amplitude_curve(paper().beam, paper().friction, paper().numerics, frequencies_hz))
    curve.closed_form.push_back(point.critical_amplitude);
  for (const double hz : frequencies_hz)
    curve.finite_element.push_back(
        1e-3 * friction_limit() /
        solver::max_abs_friction_force(paper().beam, excitation(hz, 1e-3), paper().numerics));
  return curve;
}

TEST(ClaimOnFigure6, TheSearchFindsTheCriticalAmplitudes) {
  // The paper's procedure, at three frequencies that do not take many runs.
  const auto searches = studies::critical_amplitude_searches(paper().beam, paper().friction, paper().numerics,
                                                             {25.0, 70.0, 85.0}, 0.01e-3, 1e-3);
  bool within_an_increment = true;
  int runs = 0;
  for (const auto& search : searches) {
    within_an_increment &= search.agree() && search.searched.has_value();
    runs += search.runs;
  }
  judge("fig6.search", {.as_printed = within_an_increment},
        fmt::format("at 25, 70 and 85 Hz the search ends after {} runs at {:.2f}, {:.2f} and {:.2f} mm, the "
                    "first increments above the {:.4f}, {:.4f} and {:.4f} mm of one linear run each",
                    runs, mm(searches[0].searched.value_or(0)), mm(searches[1].searched.value_or(0)),
                    mm(searches[2].searched.value_or(0)), mm(searches[0].linear), mm(searches[1].linear),
                    mm(searches[2].linear)));
}

TEST(ClaimOnFigure6, CriticalAmplitudeGenerallyDecreasesWithFrequency) {
  const Curve c = curve_at(studies::figure6_frequencies());
  const double closed_form = rank_correlation(c.closed_form),
               finite_element = rank_correlation(c.finite_element);
  const auto falling = falling_steps(c.finite_element);
  judge(
      "fig6.generally-decreases", {.as_printed = closed_form < -0.5 && finite_element < -0.5},
      fmt::format("critical amplitude falls from {:.1f} mm at 5 Hz to {:.3f} mm at 100 Hz; {} of {} steps "
                  "fall, rank correlation with frequency {:.2f} by finite elements and {:.2f} in closed form",
                  mm(c.finite_element.front()), mm(c.finite_element.back()), falling,
                  c.finite_element.size() - 1, finite_element, closed_form));
}

TEST(ClaimOnFigure6, CriticalAmplitudeIsExtremelySmallAt25Hz) {
  const Curve c = curve_at({20.0, 25.0, 30.0});
  const auto is_tiny = [](const std::vector<double>& a) { return 10.0 * a[1] < std::min(a[0], a[2]); };
  judge(
      "fig6.25-extremely-small", {.as_printed = is_tiny(c.closed_form) && is_tiny(c.finite_element)},
      fmt::format("critical amplitude {:.4f} mm at 25 Hz ({:.4f} mm by finite elements), {:.2f} mm at 20 Hz "
                  "and {:.3f} mm at 30 Hz",
                  mm(c.closed_form[1]), mm(c.finite_element[1]), mm(c.closed_form[0]), mm(c.closed_form[2])));
}

TEST(ClaimOnFigure6, CriticalAmplitudeHasADeepValleyAt80Hz) {
  const Curve c = curve_at({75.0, 80.0, 85.0, 90.0});
  const auto is_valley = [](const std::vector<double>& a, std::size_t i) {
    return a[i] < a[i - 1] && a[i] < a[i + 1];
  };
  // Slight: down to no less than half of the lower neighbour.
  const auto is_deep = [](const std::vector<double>& a, std::size_t i) {
    return a[i] < 0.5 * std::min(a[i - 1], a[i + 1]);
  };
  judge("fig6.85-slight-valley",
        {.as_printed =
             is_valley(c.closed_form, 2) && is_valley(c.finite_element, 2) && !is_deep(c.closed_form, 2),
         .instead = is_deep(c.closed_form, 1) && is_deep(c.finite_element, 1)},
        fmt::format("critical amplitude {:.4f}, {:.4f}, {:.4f} and {:.4f} mm at 75, 80, 85 and 90 Hz (finite "
                    "elements {:.4f}, {:.4f}, {:.4f} and {:.4f} mm)",
                    mm(c.closed_form[0]), mm(c.closed_form[1]), mm(c.closed_form[2]), mm(c.closed_form[3]),
                    mm(c.finite_element[0]), mm(c.finite_element[1]), mm(c.finite_element[2]),
                    mm(c.finite_element[3])));
}

TEST(ClaimOnFigure6, SmallAmplitudesAreAt25And80Hz) {
  const auto modes = analytic::stick_modes(paper().beam, 2);
  const auto nearest = [](double hz) {
    const auto grid = studies::figure6_frequencies();
    return *std::ranges::min_element(grid, {}, [hz](double g) { return std::abs(g - hz); });
  };
  const double first = nearest(modes[0].frequency_hz()), second = nearest(modes[1].frequency_hz());
  judge("fig6.next-to-natural-frequencies",
        {.as_printed = first == 25.0 && second == 85.0, .instead = first == 25.0 && second == 80.0},
        fmt::format("of the frequencies of Fig. 6, {:.0f} Hz is closest to the first natural frequency, "
                    "{:.2f} Hz, and {:.0f} Hz to the second, {:.2f} Hz",
                    first, modes[0].frequency_hz(), second, modes[1].frequency_hz()));
}

TEST(ClaimOnFigure6, TipMovesFartherThanBaseNearResonance) {
  const auto largest = [](double hz) {
    solver::BeamSimulation run = run_at(hz, 0.5e-3);
    double tip = 0.0;
    for (int n = 0; n < 10000; ++n) {
      run.step();
      tip = std::max(tip, std::abs(run.tip_displacement()));
    }
    return tip;
  };
  const double near = largest(25.0), away = largest(70.0);
  const auto critical = curve_at({25.0, 70.0}).finite_element;
  judge("fig7.small-tip-motion",
        {.as_printed = near < 0.5e-3 && near < away,
         .instead = critical[0] < 0.1 * critical[1] && near > 0.5e-3},
        fmt::format(
            "excited by 0.5 mm for 1 s, the tip moves by up to {:.2f} mm at 25 Hz and {:.2f} mm at 70 Hz; it "
            "is the critical amplitude that is small near resonance, {:.4f} mm against {:.3f} mm",
            mm(near), mm(away), mm(critical[0]), mm(critical[1])));
}

TEST(ClaimOnFigure7, TheNaturalFrequenciesAre25_0And81_1Hz) {
  const auto modes = analytic::stick_modes(paper().beam, 2);
  const auto study = studies::stick_frequency_study(paper().beam, 2, {10, 20});
  bool holds = true;
  for (std::size_t n = 0; n < 2; ++n)
    for (const double hz : {modes[n].frequency_hz(), study.modes[n].finite_element_hz.back()})
      holds &= is_printed(fmt::format("frequency.stick.{}.figure7", n + 1), hz);
  judge("fig7.frequencies", {.as_printed = holds},
        fmt::format("{:.4f} and {:.4f} Hz in closed form, {:.4f} and {:.4f} Hz on 20 elements",
                    modes[0].frequency_hz(), modes[1].frequency_hz(), study.modes[0].finite_element_hz.back(),
                    study.modes[1].finite_element_hz.back()));
}

TEST(ClaimOnFigure7, ModalAnalysisGivesTheModesOfBothStates) {
  const auto study = studies::mode_shape_study(paper().beam, 3, 20, 101);
  double shapes = 0.0, frequencies = 0.0;
  for (const auto& curve : study.curves) {
    shapes = largest_or_nan({shapes, curve.largest_difference});
    frequencies =
        largest_or_nan({frequencies, std::abs(curve.finite_element_hz / curve.closed_form_hz - 1.0)});
  }
  // (beta l)^4/1440 of a frequency and (beta l)^4/96 of a shape, beta l = 10.2/20 in the third mode.
  judge("fig7.modes", {.as_printed = study.curves.size() == 6 && frequencies < 1e-4 && shapes < 1e-3},
        fmt::format("the first three frequencies of either state agree between 20 elements and the closed "
                    "form to {:.0e}, the shapes to {:.0e} of their largest deflection",
                    frequencies, shapes));
}

}  // namespace
}  // namespace stickslip::testing
