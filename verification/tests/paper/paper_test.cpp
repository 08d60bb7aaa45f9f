// SPDX-License-Identifier: MIT
/// The paper's printed numbers, verdicts and errata, and the figures that the ledger of claims refers to.

#include "stickslip/data/paper.hpp"
#include "paper/measure.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/verification/paper_checks.hpp"
#include "studies/verification/stick_sum.hpp"
#include "support/paper_case.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

STICKSLIP_VERIFIES(PaperCase, "P1");
TEST(PaperCase, IsTheBeamWithTheCorrectedSection) {
  using data::BeamProperties;
  for (const auto member :
       {&BeamProperties::length, &BeamProperties::area, &BeamProperties::second_moment_of_area,
        &BeamProperties::density, &BeamProperties::youngs_modulus, &BeamProperties::axial_force})
    EXPECT_DOUBLE_EQ(paper().beam().properties().*member, paper_beam_properties().*member);
}

STICKSLIP_VERIFIES(PrintedNumbers, "P3");
TEST(PrintedNumbers, AreFoundUnlessErrataSayNot) {
  const auto ledger = errata();
  std::set<std::string> numbers;
  for (const auto& check : studies::printed_checks(paper())) {
    const std::string what = check.printed.id + ", " + check.method;
    EXPECT_TRUE(numbers.insert(check.printed.id).second) << what << ": a number has one verdict";
    const auto erratum = std::ranges::find(ledger, check.printed.erratum, &Erratum::id);
    // The natural frequencies that name E1 are what establishes it.
    if (erratum == ledger.end() || erratum->id == "E1") {
      EXPECT_TRUE(within(check.computed, check.printed.value, reference(check.allowed, check.because), what));
    } else {
      EXPECT_EQ(to_string(check.verdict()), to_string(erratum->verdict))
          << what << ": printed " << check.printed.printed << ", computed " << check.computed;
    }
  }
  for (const auto& printed : data::printed_numbers())
    EXPECT_TRUE(printed.is_given || numbers.contains(printed.id)) << printed.id << " has no check";
}

TEST(PrintedNumbers, HaveTheVerdictOfTheirRange) {
  using enum data::ClaimVerdict;
  const auto verdict = [](double lower, double upper) {
    return studies::verdict_on(2.0, {lower, upper}, 0.125);
  };
  // Both limits belong to what they allow.
  EXPECT_EQ(verdict(1.875, 2.125), holds);
  for (const auto& [lower, upper] : {std::pair{1.875, 2.25}, {2.125, 2.5}, {1.5, 1.875}, {1.5, 2.5}})
    EXPECT_EQ(verdict(lower, upper), not_determined) << lower;
  for (const auto& [lower, upper] : {std::pair{2.25, 2.5}, {1.5, 1.75}})
    EXPECT_EQ(verdict(lower, upper), does_not_hold) << lower;
}

STICKSLIP_VERIFIES(Errata, "V2");
// The largest f of `modes` modes at 15 Hz that start from rest: T' = V h' cancels S h', V = -int U S/int U^2.
double largest_force_from_rest(int modes) {
  auto sum = studies::stick_sum(paper().beam(), modes);
  for (auto& mode : sum.modes) mode.initial_rate = mode.participation - mode.rigid_participation;
  const auto terms =
      studies::sinusoids(sum, data::HarmonicExcitation({15.0, 0.5e-3}), studies::StickReading::force);
  return largest(evenly_spaced(0.0, 10.0, 1e-4), [&](double t) { return studies::value_at(terms, t); });
}

// What the text as printed gives, by other means.
std::optional<std::pair<double, Tolerance>> by_theory(const studies::ErratumEvidence& row) {
  const analytic::StickMode mode = analytic::stick_modes(paper().beam(), 1).front();
  // (c^4 - p c^2 - k)/k at c^2 = -p/2 - root = -b^2 of the mode, with b^2 - a^2 = p and a^2 b^2 = k: 2 (b^2/a^2 - 1), which
  // no P but 0 makes vanish.
  if (row.erratum == "E2")
    return {{2.0 * (std::pow(mode.trigonometric_wave_number() / mode.hyperbolic_wave_number(), 2) - 1.0),
             round_off(20, 1, 1.0)}};
  if (row.erratum == "E4") {
    const int modes = row.quantity.ends_with("20") ? 20 : 10;
    const double force = largest_force_from_rest(modes);
    EXPECT_TRUE(within(force, modes == 10 ? 201.0 : 393.0, reference(0.5, "three digits of E4")));
    return {{force, reference(1e-7 * force, "Simpson's rule")}};
  }
  // Euler's column, to (beta l)^4/720 of 16 elements, beta L = pi/2.
  if (row.erratum == "E8") {
    const double euler = std::pow(std::numbers::pi / 2.0, 2);
    return {{euler, discretisation(euler * std::pow(std::numbers::pi / 32.0, 4) / 720.0, 1.1, "mesh")}};
  }
  // A clamped and pinned beam without P: tan b = tanh b, b = beta L, at beta^4 = rho A omega^2/EI of 25 Hz.
  if (row.erratum == "E9") {
    const data::Beam section = data::load_case("paper-figure14").beam();
    const double b = row.quantity.starts_with("L1") ? 3.9266023120479 : 7.0685827456287;
    const double square =
        50.0 * std::numbers::pi * std::sqrt(section.density() * section.area() / rigidity(section));
    return {{b / std::sqrt(square), reference(1e-10, "the length that a search finds")}};
  }
  return std::nullopt;
}

TEST(Errata, CorrectedTextAgreesPrintedDoesNot) {
  std::set<std::string> judged{"E6", "E7", "E12"}, by_other_means;  // of wording
  for (const auto& row : studies::errata_evidence(paper())) {
    SCOPED_TRACE(row.erratum + ", " + row.quantity);
    EXPECT_TRUE(within(row.corrected, row.reference, reference(row.tolerance, "the row of the ledger")));
    EXPECT_GT(std::abs(row.as_printed - row.reference), row.tolerance);
    judged.insert(row.erratum);
    if (const auto theory = by_theory(row)) {
      EXPECT_TRUE(within(row.as_printed, theory->first, theory->second));
      by_other_means.insert(row.erratum);
    }
  }
  for (const auto& erratum : errata()) EXPECT_TRUE(judged.contains(erratum.id)) << erratum.id;
  EXPECT_EQ(judged.size(), errata().size());
  EXPECT_EQ(by_other_means, (std::set<std::string>{"E2", "E4", "E8", "E9"}));
}

// A claim that its erratum decides: where the corrected text agrees, the claim holds so.
struct ErratumClaim {
  const char *claim, *erratum, *quantity;
  std::optional<bool> Evidence::*corrected_text;
};

class ClaimOnErrata : public ::testing::TestWithParam<ErratumClaim> {};
TEST_P(ClaimOnErrata, IsDecidedByItsEvidence) {
  const auto& [claim, erratum, quantity, corrected_text] = GetParam();
  Evidence evidence{.as_printed = true};
  evidence.*corrected_text = true;
  std::vector<std::string> words;
  for (const auto& row : studies::errata_evidence(paper())) {
    if (row.erratum != erratum || !row.quantity.starts_with(quantity)) continue;
    evidence.as_printed &= std::abs(row.as_printed - row.reference) <= row.tolerance;
    *(evidence.*corrected_text) &= std::abs(row.corrected - row.reference) <= row.tolerance;
    words.push_back(fmt::format("{}, {}: {:.5g} as printed, {:.5g} corrected, {:.5g} to agree with",
                                row.quantity, row.unit, row.as_printed, row.corrected, row.reference));
  }
  judge(claim, evidence, "{}", fmt::join(words, "; "));
}

INSTANTIATE_TEST_SUITE_P(Paper, ClaimOnErrata,
                         ::testing::ValuesIn(std::vector<ErratumClaim>{
                             {"sect3.second-moment-of-area", "E1", "", &Evidence::instead},
                             {"eq23.wave-numbers", "E2", "", &Evidence::corrected},
                             {"eq24", "E3", "", &Evidence::corrected},
                             {"sect3.initial-velocity", "E4", "", &Evidence::instead},
                             {"fig13.third-natural-frequency", "E5", "", &Evidence::instead},
                             {"fig14.l1", "E9", "L1", &Evidence::with_a_choice},
                             {"fig14.l2", "E9", "L2", &Evidence::with_a_choice},
                             {"eq28.proportional-to-rigidity", "E11", "", &Evidence::instead},
                             {"eq9.f", "E13", "", &Evidence::corrected}}),
                         claim_name<ErratumClaim>);

TEST(Errata, E1PrintedSectionBucklesAtHalfStiffness) {
  data::BeamProperties printed = paper_beam_properties();
  printed.second_moment_of_area = data::printed_number("parameter.second_moment_of_area").value;
  EXPECT_NO_THROW((void)analytic::stick_modes(data::Beam(printed), 1));
  printed.youngs_modulus *= 0.5;
  EXPECT_THROW((void)analytic::stick_modes(data::Beam(printed), 1), data::InputError);
}

// The printed 169.3 Hz is what 11 to 31 elements round to. With the leading term 1277 Hz/n^4 of the error, the ends of
// the range, 169.25 and 169.35 Hz, are reached at n = 31.6 and 10.6.
TEST(Errata, E5IsMetByElevenToThirtyOneElements) {
  const auto rounded = [](int elements) {
    const auto modes = solver::stick_modes(solver::BeamModel(paper().beam(), elements), 3);
    return std::round(10.0 * modes.back().angular_frequency / (2.0 * std::numbers::pi)) / 10.0;
  };
  const double printed = data::printed_number("frequency.stick.3").value;
  for (const int elements : {11, 20, 31}) EXPECT_DOUBLE_EQ(rounded(elements), printed) << elements;
  for (const int elements : {10, 32}) EXPECT_NE(rounded(elements), printed) << elements;
}

STICKSLIP_VERIFIES(LedgerOfClaims, "V3");
TEST(LedgerOfClaims, RefersToFiguresOfTheReport) {
  std::string latex;
  for (const auto& file :
       std::filesystem::recursive_directory_iterator(STICKSLIP_SOURCE_DIRECTORY "/reports/report"))
    if (file.path().extension() == ".tex") {
      std::ifstream stream(file.path());
      latex.append(std::istreambuf_iterator<char>(stream), {});
    }
  for (const auto& claim : claims())
    EXPECT_TRUE(claim.figure.empty() || latex.find("\\label{" + claim.figure + "}") != std::string::npos)
        << claim.id << " refers to " << claim.figure;
}

STICKSLIP_VERIFIES(Verdicts, "V1");
TEST(Verdicts, AreThoseOfBothImplementations) {
  EXPECT_EQ(data::printed_verdicts().size(), 8u);
  for (const auto& [hz, amplitude, verdict, figure] : data::printed_verdicts())
    EXPECT_TRUE(verdict == "stick-slip" ? both_slip(hz, amplitude) : both_stick(hz, amplitude))
        << "Fig. " << figure;
}

}  // namespace
}  // namespace stickslip::testing
