// SPDX-License-Identifier: MIT
/// Claims on where the tip sticks and where it slips, and how: Sect. 3 on parameters, start and Figs. 3 to 5, and what else
/// says so.

#include "paper/measure.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/paper.hpp"
#include "support/paper_case.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

constexpr std::array frequencies{15.0, 25.0, 35.0, 70.0};
constexpr double small = 0.5e-3, large = 1e-3;

// |f_max| of Eq. (28), and the first slip by finite elements.
std::string verdicts_in_words(double hz, double amplitude) {
  const double force = analytic::StickResponse(paper().beam(), excitation(hz, amplitude))
                           .max_abs_friction_force(paper().numerics.duration(), 1e-6)
                           .midpoint();
  const auto slip = solver::first_slip(with(paper(), excitation(hz, amplitude)));
  return fmt::format("{} Hz, {} mm: |f_max| = {:.0f} N, {}", hz, mm(amplitude), force,
                     slip ? fmt::format("first slip at {:.4f} s", *slip) : "no slip in 10 s");
}

// Where the tip sticks and where it slips, by the criterion of the closed form and by finite elements over 10 s.
struct VerdictClaim {
  const char* claim;
  std::vector<std::pair<double, double>> sticking, slipping;  // Hz, m
};

class ClaimOnVerdicts : public ::testing::TestWithParam<VerdictClaim> {};
TEST_P(ClaimOnVerdicts, HoldsByBothImplementations) {
  const auto& [claim, sticking, slipping] = GetParam();
  bool holds = true;
  std::vector<std::string> words;
  for (const auto& [excitations, verdict] : {std::pair{sticking, &both_stick}, {slipping, &both_slip}})
    for (const auto& [hz, amplitude] : excitations) {
      holds &= verdict(hz, amplitude);
      words.push_back(verdicts_in_words(hz, amplitude));
    }
  judge(claim, {.as_printed = holds}, fmt::format("{}", fmt::join(words, "; ")));
}

INSTANTIATE_TEST_SUITE_P(
    Figures4To10, ClaimOnVerdicts,
    ::testing::Values(
        VerdictClaim{"abstract.amplitude-and-frequency", {{35, small}}, {{35, large}, {25, small}}},
        VerdictClaim{"fig4.faster-need-not-slip", {{35, small}}, {{25, small}}},
        VerdictClaim{"fig5.only-15-sticks", {{15, large}}, {{25, large}, {35, large}, {70, large}}},
        VerdictClaim{"fig5.35-additionally",
                     {{15, small}, {15, large}, {35, small}},
                     {{25, small}, {25, large}, {70, small}, {70, large}, {35, large}}},
        VerdictClaim{"fig10.points-a-b-stick", {{15, small}, {35, small}}, {}},
        VerdictClaim{"fig10.points-c-d-slip", {}, {{25, small}, {70, small}}},
        VerdictClaim{
            "fig10.consistent-with-figs3-4", {{15, small}, {35, small}}, {{25, small}, {70, small}}}),
    claim_name<VerdictClaim>);

TEST(Section3, TheTimeStepGivesReasonableResults) {
  // First slips with a tenth of the step, in parts of the period of the excitation.
  data::NumericalChoices fine = paper().numerics.choices();
  fine.time_step *= 0.1;
  fine.duration = 0.5;
  bool verdicts_stay = true;
  const double moved = largest(data::printed_verdicts(), [&](const data::PrintedVerdict& printed) {
    const data::Case at = with(paper(), excitation(printed.frequency_hz, printed.amplitude));
    const auto coarse = solver::first_slip(at),
               refined = solver::first_slip(with(at, data::NumericalSettings(fine)));
    verdicts_stay &= coarse.has_value() == refined.has_value();
    return coarse && refined ? (*coarse - *refined) * printed.frequency_hz : 0.0;
  });
  judge("sect3.time-step", {.as_printed = verdicts_stay && moved < 0.01},
        "a tenth of the step moves first slips by at most {:.2f} % of a period", 100 * moved);
}

TEST(Section3, ThresholdMissesFastStops) {
  // By the letter: the tip stops where the sliding velocity has changed its sign.
  solver::BeamSimulation letter = run_at(25.0, large, {.scheme = solver::ContactScheme::paper});
  int stops = 0, missed = 0;
  double before = 0.0;
  for (int n = 0; n < 3000; ++n) {
    letter.integrator().step();
    const double now = letter.integrator().sliding_velocity();
    const double threshold = paper().numerics.velocity_threshold();
    if (std::abs(now) <= threshold && std::abs(before) > threshold) ++stops;
    if (now * before < 0.0 && std::min(std::abs(now), std::abs(before)) > threshold) ++stops, ++missed;
    before = now;
  }
  // With changes of sign located, the threshold itself does no harm.
  const auto first_capture = [](double threshold) {
    solver::BeamSimulation run(
        with_value(with(paper(), excitation(25.0, large)), "numerics.velocity_threshold", threshold));
    while (captures(run) == 0) run.integrator().step();
    return run.integrator().events().back().time;
  };
  const double moved = std::abs(first_capture(1e-4) - first_capture(0.0));
  judge("sect3.threshold", {.as_printed = missed == 0, .instead = moved < paper().numerics.time_step()},
        "{} of {} stops are stepped over; with sign changes located, epsilon moves the first by {:.0e} s",
        missed, stops, moved);
}

TEST(Section3, TheTipIsStuckAtTheStart) {
  const double closed_form = largest(frequencies, [](double hz) {
    return analytic::StickResponse(paper().beam(), excitation(hz, large)).friction_force(0.0);
  });
  const double mesh = largest(frequencies, [](double hz) { return run_at(hz, large).friction_force(); });
  judge("sect3.stuck-at-start", {.as_printed = std::max(closed_form, mesh) < friction_limit()},
        "{:.0f} N in closed form and at most {:.0e} N by finite elements", closed_form, mesh);
}

// What the tip does by finite elements.
struct TipMotion {
  int sticks{};                     // stick phases after the first slip
  double lowest{}, highest{};       // m
  double stick_share{};             // of the time
  double long_sticks_per_period{};  // stick phases of 1 ms and more, after the first slip

  [[nodiscard]] double range() const { return highest - lowest; }
};
TipMotion tip_motion(double hz, double amplitude, double duration = 0.5) {
  solver::BeamSimulation run = run_at(hz, amplitude);
  const long steps = solver::step_count(duration, paper().numerics.time_step());
  TipMotion motion;
  for (long n = 0; n < steps; ++n) {
    run.integrator().step();
    motion.lowest = std::min(motion.lowest, run.tip_displacement());
    motion.highest = std::max(motion.highest, run.tip_displacement());
    motion.stick_share +=
        run.integrator().state() == data::ContactState::stick ? 1.0 / static_cast<double>(steps) : 0.0;
  }
  const auto& events = run.integrator().events();
  motion.sticks = captures(run);
  int long_sticks = 0;
  for (std::size_t i = 1; i < events.size(); ++i)
    long_sticks +=
        events[i - 1].change == data::ContactChange::capture && events[i].time - events[i - 1].time > 1e-3;
  if (!events.empty())
    motion.long_sticks_per_period = long_sticks / (hz * (run.integrator().time() - events.front().time));
  return motion;
}

// The largest |f| at any time, however late: the sum of the magnitudes of the sinusoids of which f consists.
double force_bound_for_all_times(double hz) {
  const analytic::StickResponse response(paper().beam(), excitation(hz, small), 100,
                                         analytic::SteadyPart::exact);
  double bound = std::abs(response.steady_force_amplitude()) + response.omitted_transient_bound();
  for (const auto& sinusoid : response.transient_force()) bound += std::abs(sinusoid.amplitude);
  return bound;
}

void judge_that_the_tip_never_moves(const std::string& claim, double hz) {
  const TipMotion motion = tip_motion(hz, small, 10.0);
  judge(claim, {.as_printed = motion.range() <= round_off(1, 1, small).value && both_stick(hz, small)},
        "{}; y(L) stays within {:.0e} m", verdicts_in_words(hz, small), motion.range());
}

TEST(Figure4, TheTipDoesNotMoveAt15Hz) { judge_that_the_tip_never_moves("fig4.15", 15.0); }
TEST(Figure4, TheTipDoesNotMoveAt35Hz) { judge_that_the_tip_never_moves("fig4.35", 35.0); }

TEST(Figure4, TheBeamSticksAtAllTimesAt15And35Hz) {
  const double slow = force_bound_for_all_times(15.0), fast = force_bound_for_all_times(35.0);
  judge("fig4.stick-at-all-times",
        {.as_printed =
             std::max(slow, fast) <= friction_limit() && both_stick(15.0, small) && both_stick(35.0, small)},
        "at most {:.1f} N at 15 Hz and {:.1f} N at 35 Hz at any time, and mu_s P = {:.0f} N", slow, fast,
        friction_limit());
}

void judge_that_the_tip_sticks_and_slips(const std::string& claim, double hz) {
  const TipMotion motion = tip_motion(hz, small);
  judge(claim,
        {.as_printed = motion.sticks > 2 && motion.range() > 0.1 * small && criterion_slips(hz, small)},
        "{}; in 0.5 s the tip sticks {} times again and covers {:.2f} mm", verdicts_in_words(hz, small),
        motion.sticks, mm(motion.range()));
}

TEST(Figure4, TheTipSticksAndSlipsAt25Hz) { judge_that_the_tip_sticks_and_slips("fig4.25", 25.0); }
TEST(Figure4, TheTipSticksAndSlipsAt70Hz) { judge_that_the_tip_sticks_and_slips("fig4.70", 70.0); }

TEST(Figure5, ThePatternsAreVarious) {
  const auto differ = [](const TipMotion& x, const TipMotion& y) {
    const auto apart = [](double p, double q) { return std::max(p, q) > 1.5 * std::min(p, q); };
    return apart(x.range(), y.range()) || apart(x.stick_share, y.stick_share) ||
           apart(x.long_sticks_per_period, y.long_sticks_per_period);
  };
  const TipMotion a = tip_motion(25.0, large), b = tip_motion(35.0, large), c = tip_motion(70.0, large);
  judge("fig5.various-patterns", {.as_printed = differ(a, b) && differ(b, c) && differ(a, c)},
        "at 25, 35 and 70 Hz the tip covers {:.2f}, {:.2f} and {:.2f} mm, sticks for {:.0f}, {:.0f} and "
        "{:.0f} % of the time and {:.1f}, {:.1f} and {:.1f} times a period for 1 ms and more",
        mm(a.range()), mm(b.range()), mm(c.range()), 100 * a.stick_share, 100 * b.stick_share,
        100 * c.stick_share, a.long_sticks_per_period, b.long_sticks_per_period, c.long_sticks_per_period);
}

TEST(Figure5, LargerAmplitudesSlipMoreReadily) {
  // Along each frequency the verdict may change once, from stick to slip.
  int changes = 0, returns = 0;
  for (const double hz : frequencies) {
    bool before = false;
    for (const double amplitude : evenly_spaced(0.2e-3, 2e-3, 0.2e-3)) {
      const bool now = finite_elements_slip(hz, amplitude);
      changes += !before && now ? 1 : 0;
      returns += before && !now ? 1 : 0;
      before = now;
    }
  }
  judge("fig5.larger-amplitude", {.as_printed = changes > 0 && returns == 0},
        "the verdict changes {} times from stick to slip and {} times back", changes, returns);
}

}  // namespace
}  // namespace stickslip::testing
