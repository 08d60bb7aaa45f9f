// SPDX-License-Identifier: MIT
/// What moves the printed |f_max|, against what theory says of each factor.

#include "studies/verification/force_sensitivity.hpp"

#include "stickslip/analytic/stick_response.hpp"
#include "stickslip/data/atomic_file.hpp"
#include "stickslip/data/case_file.hpp"
#include "studies/common/convergence.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using analytic::StickResponse;

const studies::ForceSensitivity& study() {
  static const studies::ForceSensitivity result = studies::force_sensitivity(data::load_case("paper"));
  return result;
}

const studies::ForceRow& row(const std::string& factor, const std::string& setting) {
  const auto& rows = study().rows;
  const auto found = std::ranges::find_if(
      rows, [&](const auto& r) { return r.factor == factor && r.setting.starts_with(setting); });
  if (found == rows.end()) throw std::runtime_error("no row " + factor + ", " + setting);
  return *found;
}

const studies::ForceRow& closed_form() { return row("closed form", "N = 10"); }

data::HarmonicExcitation excitation(std::size_t i) {
  return data::HarmonicExcitation({study().frequency_hz[i], 0.5e-3});
}

constexpr double ten_seconds = 10.0;

void rows_are_those_of_their_settings() {
  auto unloaded = paper_beam_properties();
  unloaded.axial_force = 0.0;
  for (std::size_t i = 0; i < study().frequency_hz.size(); ++i) {
    const auto expect_row = [i](const studies::ForceRow& of, int modes, double duration,
                                const data::Beam& beam = paper_beam(),
                                analytic::SteadyPart part = analytic::SteadyPart::modal_sum) {
      const StickResponse response(beam, excitation(i), modes, part);
      EXPECT_NEAR(of.force[i], response.max_abs_friction_force(duration).midpoint(), 1e-9 * of.force[i])
          << of.factor << ' ' << of.setting;
    };
    for (const int modes : {5, 8, 12, 20, 50})
      expect_row(row("modes", std::to_string(modes)), modes, ten_seconds);
    expect_row(row("modes", "all"), 100, ten_seconds, paper_beam(), analytic::SteadyPart::exact);
    expect_row(row("duration", "5 s"), 10, 5.0);
    expect_row(row("duration", "20 s"), 10, 20.0);
    expect_row(row("axial force", "0 N"), 10, ten_seconds, data::Beam(unloaded));
    const StickResponse response(paper_beam(), excitation(i), 10);
    for (const double step : {1e-4, 1e-3, 5e-3})
      EXPECT_EQ(row("sampling step", fmt::format("{:g} s", step)).force[i],
                response.sampled_max_abs_friction_force(ten_seconds, step).lower);
  }
}

void changes_are_those_from_the_unchanged_row_of_the_method() {
  for (const auto& changed : study().rows)
    for (std::size_t i = 0; i < study().frequency_hz.size(); ++i) {
      const auto& unchanged = changed.closed_form ? closed_form() : row("finite elements", "20");
      const double ratio = changed.force[i] / unchanged.force[i];
      EXPECT_NEAR(changed.change[i], 100.0 * (ratio - 1.0), 1e-12 * ratio) << changed.factor;
      EXPECT_TRUE(changed.closed_form || changed.factor == "finite elements" || ratio != 1.0)
          << changed.setting;
    }
  EXPECT_FALSE(row("elements", "40").closed_form);
}

// What E6 says of the samplings: that one step returns a printed value, at 25 Hz.
void ranges_are_those_of_the_samplings() {
  for (std::size_t i = 0; i < study().digits.size(); ++i) {
    const studies::ForceDigits& digits = study().digits[i];
    const StickResponse response(paper_beam(), excitation(i), 10);
    EXPECT_EQ(digits.formula.force.upper, closed_form().force[i]);  // which no sample exceeds
    for (const double step : {1e-4, 2e-3, 1e-2})
      EXPECT_GE(response.sampled_max_abs_friction_force(ten_seconds, step).lower, digits.formula.force.lower);
    if (digits.printed_step) {
      EXPECT_NEAR(response.sampled_max_abs_friction_force(ten_seconds, *digits.printed_step).lower,
                  digits.printed, digits.half_digit);
    }
    EXPECT_EQ(digits.printed_step.has_value(), digits.frequency_hz == 25.0);
    EXPECT_NEAR(digits.printed_step.value_or(1.8e-3), 1.8e-3, 1e-12);
    EXPECT_TRUE(digits.formula.holds_printed) << digits.frequency_hz;
    EXPECT_FALSE(digits.problem.holds_printed) << digits.frequency_hz;
    EXPECT_LE(digits.formula.digits, 2) << digits.frequency_hz;
    EXPECT_GE(digits.problem.digits, 5) << digits.frequency_hz;
  }
}

void numbers_of_the_erratum_are_those_of_the_study() {
  const std::string text = data::read_text(data::data_directory() / "paper" / "errata.toml");
  const auto numbers = [](const std::string& pattern, const auto& value) {
    return fmt::format(fmt::runtime(pattern), value(0), value(1), value(2), value(3));
  };
  const auto lower = [](std::size_t i) { return study().digits[i].formula.force.lower; };
  const auto upper = [](std::size_t i) { return study().digits[i].formula.force.upper; };
  const std::vector<double>& sampled = row("sampling step", "0.0001 s").force;
  for (const std::string& sentence :
       {numbers("{:.2f}, {:.1f}, {:.1f} and {:.1f} N with all modes",
                [](std::size_t i) { return study().digits[i].problem.force.midpoint(); }),
        numbers("10 modes every 10^-4 s give {:.3f}, {:.1f}, {:.3f} and {:.2f} N",
                [&](std::size_t i) { return sampled[i]; }),
        fmt::format(
            "the ranges are {:.1f} to {:.2f}, {:.0f} to {:.0f}, {:.1f} to {:.2f} and {:.1f} to {:.1f} N",
            lower(0), upper(0), lower(1), upper(1), lower(2), upper(2), lower(3), upper(3)),
        numbers(
            "come back to {:.1f}, {:.1f}, {:.2f} and {:.2f} %",
            [&](std::size_t i) { return 100.0 * std::abs(sampled[i] / study().digits[i].printed - 1.0); }),
        fmt::format("moves by {:.2f} % for a newton of P", -row("axial force", "501 N").change[1]),
        fmt::format("({:.0f} N with 5 x 10^-3 s)", row("sampling step", "0.005 s").force[1]),
        fmt::format("of {} numbers of modes and sampling steps", study().search.trials())})
    EXPECT_TRUE(holds(text, sentence));
}

void no_trial_returns_all_printed_digits() {
  const studies::SamplingSearch& search = study().search;
  EXPECT_EQ(search.returning_all, 0);
  EXPECT_LT(search.most_returned.returned, 4);
  EXPECT_LE(search.closest.largest_difference, search.most_returned.largest_difference);
  // Round steps, ascending, and then of 1000, 10 000 and 100 000 points.
  const auto points = search.sampling_steps.end() - 3;
  EXPECT_TRUE(std::is_sorted(search.sampling_steps.begin(), points, std::less_equal<>()));
  for (const auto& [place, count] : {std::pair{0, 1e3}, {1, 1e4}, {2, 1e5}})
    EXPECT_DOUBLE_EQ(points[place], ten_seconds / (count - 1.0));
  for (const auto* trial : {&search.closest, &search.most_returned}) {
    int returned = 0;
    double largest = 0.0;
    for (std::size_t i = 0; i < trial->force.size(); ++i) {
      const auto& digits = study().digits[i];
      const double difference = std::abs(trial->force[i] - digits.printed) / digits.half_digit;
      returned += difference <= 1.0 ? 1 : 0;
      largest = std::max(largest, difference);
    }
    EXPECT_EQ(trial->returned, returned);
    EXPECT_EQ(trial->largest_difference, largest);
    for (std::size_t i = 0; i < study().frequency_hz.size(); ++i) {
      const double again = StickResponse(paper_beam(), excitation(i), trial->modes)
                               .sampled_max_abs_friction_force(ten_seconds, trial->sampling_step)
                               .lower;
      // A million complex multiplications; the steady part and mode 1 cancel by 1000 at 25 Hz.
      EXPECT_TRUE(within(trial->force[i], again, round_off(1e6, 1.0, again)));
    }
  }
}

STICKSLIP_VERIFIES(ForceSensitivity, "X14");
// One test, for every test is a process of its own and the study takes seconds.
TEST(ForceSensitivity, IsThatOfTheory) {
  ASSERT_EQ(study().frequency_hz, (std::vector{15.0, 25.0, 35.0, 70.0}));
  rows_are_those_of_their_settings();
  changes_are_those_from_the_unchanged_row_of_the_method();
  ranges_are_those_of_the_samplings();
  numbers_of_the_erratum_are_those_of_the_study();
  no_trial_returns_all_printed_digits();
}

STICKSLIP_VERIFIES(CommonDigits, "X14");
TEST(CommonDigits, AreThoseBothEndsRoundTo) {
  EXPECT_EQ(studies::common_digits({40.204, 40.532}), 1);
  EXPECT_EQ(studies::common_digits({40.51, 40.53}), 3);
  EXPECT_EQ(studies::common_digits({40.5, 40.5}), 15);
  EXPECT_EQ(studies::common_digits({1.0, 9.0}), 0);
  EXPECT_EQ(studies::common_digits({99.96, 100.04}), 3);
}

}  // namespace
}  // namespace stickslip::testing
