// SPDX-License-Identifier: MIT
/// Claims of Sect. 3 on parameters, start and Figs. 3 to 5: where the tip sticks, where it slips, and how.

#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/paper.hpp"
#include "studies/verification/contact_histories.hpp"
#include "support/claims.hpp"
#include "support/paper_case.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

constexpr std::array frequencies{15.0, 25.0, 35.0, 70.0};
constexpr double small = 0.5e-3, large = 1e-3;

// |f_max| of Eq. (28), and the first slip by finite elements.
std::string verdicts_in_words(double hz, double amplitude) {
  const double force = analytic::StickResponse(paper().beam, excitation(hz, amplitude))
                           .max_abs_friction_force(paper().numerics.duration(), 1e-6)
                           .midpoint();
  const auto slip = solver::first_slip(with(paper(), excitation(hz, amplitude)));
  return fmt::format("{} Hz, {} mm: |f_max| = {:.0f} N, {}", hz, 1e3 * amplitude, force,
                     slip ? fmt::format("first slip at {:.4f} s", *slip) : "no slip in 10 s");
}

// The largest |f| at any time, however late: the sum of the magnitudes of the sinusoids of which f consists.
double force_bound_for_all_times(double hz, double amplitude) {
  const analytic::StickResponse response(paper().beam, excitation(hz, amplitude), 100,
                                         analytic::SteadyPart::exact);
  double bound = std::abs(response.steady_force_amplitude()) + response.omitted_transient_bound();
  for (const auto& sinusoid : response.transient_force()) bound += std::abs(sinusoid.amplitude);
  return bound;
}

TEST(ClaimOnSection3, TheTimeStepGivesReasonableResults) {
  // First slips with a tenth of the step, in parts of the period of the excitation.
  data::NumericalChoices fine = paper().numerics.choices();
  fine.time_step *= 0.1;
  fine.duration = 0.5;
  double largest = 0.0;
  bool verdicts_stay = true;
  for (const auto& printed : data::printed_verdicts()) {
    const data::Case at = with(paper(), excitation(printed.frequency_hz, printed.amplitude));
    const auto coarse = solver::first_slip(at);
    const auto refined = solver::first_slip(with(at, data::NumericalSettings(fine)));
    verdicts_stay &= coarse.has_value() == refined.has_value();
    if (coarse && refined)
      largest = largest_or_nan({largest, std::abs(*coarse - *refined) * printed.frequency_hz});
  }
  judge("sect3.time-step", {.as_printed = verdicts_stay && largest < 0.01},
        fmt::format("a tenth of the step leaves the eight verdicts of Figs. 4 and 5 as they are and moves "
                    "first slips by at most {:.2f} % of a period",
                    100 * largest));
}

TEST(ClaimOnSection3, TheThresholdMissesStopsOfAStrongDeceleration) {
  // By the letter: the tip stops where the sliding velocity has changed its sign.
  solver::BeamSimulation letter = run_at(25.0, large, {.scheme = solver::ContactScheme::paper});
  int stops = 0, missed = 0;
  double before = 0.0;
  for (int n = 0; n < 3000; ++n) {
    letter.step();
    const double now = letter.sliding_velocity();
    const double threshold = paper().numerics.velocity_threshold();
    if (std::abs(now) <= threshold && std::abs(before) > threshold) ++stops;
    if (now * before < 0.0 && std::min(std::abs(now), std::abs(before)) > threshold) ++stops, ++missed;
    before = now;
  }
  // With changes of sign located, the threshold itself does no harm.
  const auto first_capture = [](double threshold) {
    solver::BeamSimulation run(
        with_value(with(paper(), excitation(25.0, large)), "numerics.velocity_threshold", threshold));
    while (captures(run) == 0) run.step();
    return run.integrator().events().back().time;
  };
  const double with = first_capture(1e-4), without = first_capture(0.0);
  judge("sect3.threshold",
        {.as_printed = missed == 0, .instead = std::abs(with - without) < paper().numerics.time_step()},
        fmt::format("by the letter, {} of {} stops in 0.3 s at 25 Hz and 1 mm are stepped over, for the tip "
                    "decelerates by more than epsilon in a step; with sign changes located, epsilon moves "
                    "the first capture by {:.0e} s",
                    missed, stops, std::abs(with - without)));
}

TEST(ClaimOnSection3, BeamStartsWithTheQuasiStaticVelocity) {
  const double coarse = first_force(16, solver::InitialVelocity::zero),
               fine = first_force(64, solver::InitialVelocity::zero);
  const double quasi_static = first_force(64, solver::InitialVelocity::quasi_static);
  judge("sect3.initial-velocity",
        {.as_printed = fine < 1.1 * coarse && fine <= friction_limit(),
         .instead = quasi_static < 0.01 * friction_limit()},
        fmt::format(
            "from rest relative to the base the reaction in the first millisecond at 15 Hz and 0.5 mm is "
            "{:.0f} N on 16 and {:.0f} N on 64 elements, against Fig. 4a; from S h_t(0) it is {:.2f} N",
            coarse, fine, quasi_static));
}

TEST(ClaimOnSection3, TheTipIsStuckAtTheStart) {
  double closed_form = 0.0, finite_element = 0.0;
  for (const double hz : frequencies) {
    const solver::BeamSimulation run = run_at(hz, large);
    closed_form = largest_or_nan(
        {closed_form,
         std::abs(analytic::StickResponse(paper().beam, excitation(hz, large)).friction_force(0.0))});
    finite_element = largest_or_nan({finite_element, std::abs(run.friction_force())});
  }
  judge("sect3.stuck-at-start",
        {.as_printed = closed_form < friction_limit() && finite_element < friction_limit()},
        fmt::format("at t = 0, from u_t = S h_t(0), the force is {:.0f} N in closed form and at most {:.0e} "
                    "N in finite elements, below mu_s P",
                    closed_form, finite_element));
}

TEST(ClaimOnSection3, HundredfoldSecondMomentGivesTheFrequencies) {
  data::BeamProperties as_printed = paper_beam_properties();
  as_printed.second_moment_of_area = data::printed_number("parameter.second_moment_of_area").value;
  const auto first = [](const data::Beam& beam) { return analytic::stick_modes(beam, 1)[0].frequency_hz(); };
  const data::PrintedNumber printed = data::printed_number("frequency.stick.1");
  const double wrong = first(data::Beam(as_printed)), right = first(paper().beam);
  judge("sect3.second-moment-of-area",
        {.as_printed = is_printed(printed.id, wrong), .instead = is_printed(printed.id, right)},
        fmt::format("I = (1/12) 10^-6 m^4 gives a first natural frequency of {:.3f} Hz, (1/12) 10^-4 m^4 one "
                    "of {:.3f} Hz; the paper prints {} Hz",
                    wrong, right, printed.printed));
}

void judge_that_the_tip_never_moves(const std::string& claim, double hz) {
  solver::BeamSimulation run = run_at(hz, small);
  double largest = 0.0;
  for (long n = solver::step_count(10.0, paper().numerics.time_step()); n > 0; --n) {
    run.step();
    largest = largest_or_nan({largest, std::abs(run.tip_displacement())});
  }
  judge(claim,
        {.as_printed = run.integrator().events().empty() && largest <= round_off(1, 1, small).value &&
                       !criterion_slips(hz, small)},
        fmt::format("{}; y(L) stays within {:.0e} m", verdicts_in_words(hz, small), largest));
}

TEST(ClaimOnFigure4, TheTipDoesNotMoveAt15Hz) { judge_that_the_tip_never_moves("fig4.15", 15.0); }
TEST(ClaimOnFigure4, TheTipDoesNotMoveAt35Hz) { judge_that_the_tip_never_moves("fig4.35", 35.0); }

TEST(ClaimOnFigure4, TheBeamSticksAtAllTimesAt15And35Hz) {
  const double slow = force_bound_for_all_times(15.0, small), fast = force_bound_for_all_times(35.0, small);
  judge("fig4.stick-at-all-times",
        {.as_printed = slow <= friction_limit() && fast <= friction_limit() && both_stick(15.0, small) &&
                       both_stick(35.0, small)},
        fmt::format("the sinusoids of f add up to at most {:.1f} N at 15 Hz and {:.1f} N at 35 Hz, however "
                    "late, and mu_s P = {:.0f} N; finite elements do not slip in 10 s",
                    slow, fast, friction_limit()));
}

// What the tip does in half a second by finite elements.
struct TipMotion {
  int sticks{};          // stick phases after the first slip
  double range{};        // m
  double stick_share{};  // of the time
  /// Stick phases of 1 ms and more in a period of the excitation, after the first slip.
  double sticks_per_period{};
};
TipMotion tip_motion(double hz, double amplitude) {
  constexpr int steps = 5000;
  solver::BeamSimulation run = run_at(hz, amplitude);
  TipMotion motion;
  double lowest = 0.0, highest = 0.0;
  for (int n = 0; n < steps; ++n) {
    run.step();
    lowest = std::min(lowest, run.tip_displacement());
    highest = std::max(highest, run.tip_displacement());
    motion.stick_share += run.state() == data::ContactState::stick ? 1.0 / steps : 0.0;
  }
  motion.range = highest - lowest;
  const auto& events = run.integrator().events();
  motion.sticks = captures(run);
  int long_sticks = 0;
  for (std::size_t i = 1; i < events.size(); ++i)
    long_sticks +=
        events[i - 1].change == data::ContactChange::capture && events[i].time - events[i - 1].time > 1e-3;
  if (!events.empty()) motion.sticks_per_period = long_sticks / (hz * (run.time() - events.front().time));
  return motion;
}

void judge_that_the_tip_sticks_and_slips(const std::string& claim, double hz) {
  const TipMotion motion = tip_motion(hz, small);
  judge(claim, {.as_printed = motion.sticks > 2 && motion.range > 0.1 * small && criterion_slips(hz, small)},
        fmt::format("{}; in 0.5 s the tip sticks {} times again and covers {:.2f} mm",
                    verdicts_in_words(hz, small), motion.sticks, 1e3 * motion.range));
}

TEST(ClaimOnFigure4, TheTipSticksAndSlipsAt25Hz) { judge_that_the_tip_sticks_and_slips("fig4.25", 25.0); }
TEST(ClaimOnFigure4, TheTipSticksAndSlipsAt70Hz) { judge_that_the_tip_sticks_and_slips("fig4.70", 70.0); }

TEST(ClaimOnFigure4, TheFasterExcitationNeedNotSlip) {
  judge("fig4.faster-need-not-slip", {.as_printed = both_slip(25.0, small) && both_stick(35.0, small)},
        verdicts_in_words(25.0, small) + "; " + verdicts_in_words(35.0, small));
}

TEST(ClaimOnFigure5, TheTipSticksAt15HzOnly) {
  bool others_slip = true;
  for (const double hz : {25.0, 35.0, 70.0}) others_slip &= both_slip(hz, large);
  judge("fig5.only-15-sticks", {.as_printed = both_stick(15.0, large) && others_slip},
        verdicts_in_words(15.0, large) + "; " + verdicts_in_words(25.0, large) + "; " +
            verdicts_in_words(35.0, large) + "; " + verdicts_in_words(70.0, large));
}

TEST(ClaimOnFigure5, ThePatternsAreVarious) {
  const TipMotion a = tip_motion(25.0, large), b = tip_motion(35.0, large), c = tip_motion(70.0, large);
  const auto differ = [](const TipMotion& x, const TipMotion& y) {
    const auto apart = [](double p, double q) { return std::max(p, q) > 1.5 * std::min(p, q); };
    return apart(x.range, y.range) || apart(x.stick_share, y.stick_share) ||
           apart(x.sticks_per_period, y.sticks_per_period);
  };
  judge("fig5.various-patterns", {.as_printed = differ(a, b) && differ(b, c) && differ(a, c)},
        fmt::format(
            "in 0.5 s at 25, 35 and 70 Hz the tip covers {:.2f}, {:.2f} and {:.2f} mm, sticks for {:.0f}, "
            "{:.0f} and {:.0f} % of the time and {:.1f}, {:.1f} and {:.1f} times a period for 1 ms and more",
            1e3 * a.range, 1e3 * b.range, 1e3 * c.range, 100 * a.stick_share, 100 * b.stick_share,
            100 * c.stick_share, a.sticks_per_period, b.sticks_per_period, c.sticks_per_period));
}

TEST(ClaimOnFigure5, StickSlipAdditionallyOccursAt35Hz) {
  bool unchanged_elsewhere = true;
  for (const double hz : {15.0, 25.0, 70.0})
    unchanged_elsewhere &=
        (both_stick(hz, small) && both_stick(hz, large)) || (both_slip(hz, small) && both_slip(hz, large));
  judge("fig5.35-additionally",
        {.as_printed = unchanged_elsewhere && both_stick(35.0, small) && both_slip(35.0, large)},
        verdicts_in_words(35.0, small) + "; " + verdicts_in_words(35.0, large) +
            "; the other three frequencies keep their verdicts");
}

TEST(ClaimOnFigure5, LargerAmplitudesSlipMoreReadily) {
  // Along each frequency the verdict may change once, from stick to slip.
  int changes = 0, returns = 0;
  for (const double hz : frequencies) {
    bool before = false;
    for (int i = 1; i <= 10; ++i) {
      const bool now = finite_elements_slip(hz, 0.2e-3 * i);
      changes += !before && now ? 1 : 0;
      returns += before && !now ? 1 : 0;
      before = now;
    }
  }
  judge("fig5.larger-amplitude", {.as_printed = changes > 0 && returns == 0},
        fmt::format("from 0.2 to 2 mm at the four frequencies, finite elements change {} times from stick to "
                    "slip and {} times back as the amplitude grows",
                    changes, returns));
}

}  // namespace
}  // namespace stickslip::testing
