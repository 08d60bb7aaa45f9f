// SPDX-License-Identifier: MIT
/// The paper's printed numbers, verdicts and errata, and the figures that the ledger of claims refers to.

#include "stickslip/data/paper.hpp"
#include "stickslip/analytic/stick_modes.hpp"
#include "stickslip/solver/modal_analysis.hpp"
#include "studies/verification/paper_checks.hpp"
#include "studies/verification/stick_sum.hpp"
#include "support/claims.hpp"
#include "support/paper_case.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

STICKSLIP_VERIFIES(PaperCase, "P1");
TEST(PaperCase, IsTheBeamOfSection3WithTheCorrectedSection) {
  const data::BeamProperties expected = paper_beam_properties();
  const data::BeamProperties& read = paper().beam.properties();
  EXPECT_DOUBLE_EQ(read.length, expected.length);
  EXPECT_DOUBLE_EQ(read.area, expected.area);
  EXPECT_DOUBLE_EQ(read.second_moment_of_area, expected.second_moment_of_area);
  EXPECT_DOUBLE_EQ(read.density, expected.density);
  EXPECT_DOUBLE_EQ(read.youngs_modulus, expected.youngs_modulus);
  EXPECT_DOUBLE_EQ(read.axial_force, expected.axial_force);
}

STICKSLIP_VERIFIES(PrintedNumbers, "P3");
TEST(PrintedNumbers, AreReproducedUnlessAnErratumSaysNot) {
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

TEST(PrintedNumbers, HaveTheVerdictOfTheRangeThatIsPossible) {
  using data::ClaimVerdict;
  EXPECT_EQ(studies::verdict_on(2.0, {1.9, 2.1}, 0.11), ClaimVerdict::holds);
  EXPECT_EQ(studies::verdict_on(2.0, {1.9, 2.3}, 0.11), ClaimVerdict::not_determined);
  EXPECT_EQ(studies::verdict_on(2.0, {2.1, 2.3}, 0.11), ClaimVerdict::not_determined);
  EXPECT_EQ(studies::verdict_on(2.0, {2.2, 2.3}, 0.11), ClaimVerdict::does_not_hold);
  EXPECT_EQ(studies::verdict_on(2.0, {1.7, 1.8}, 0.11), ClaimVerdict::does_not_hold);
  // Both limits belong to what they allow.
  EXPECT_EQ(studies::verdict_on(2.0, {1.875, 2.125}, 0.125), ClaimVerdict::holds);
  EXPECT_EQ(studies::verdict_on(2.0, {2.125, 2.5}, 0.125), ClaimVerdict::not_determined);
  EXPECT_EQ(studies::verdict_on(2.0, {1.5, 1.875}, 0.125), ClaimVerdict::not_determined);
}

STICKSLIP_VERIFIES(Errata, "V2");
TEST(Errata, CorrectedTextAgreesWhereThePrintedOneDoesNot) {
  std::set<std::string> judged{"E6", "E7", "E12"};  // of wording
  for (const auto& row : studies::errata_evidence(paper())) {
    EXPECT_TRUE(within(row.corrected, row.reference, reference(row.tolerance, "the row of the ledger"),
                       row.erratum + ", " + row.quantity));
    EXPECT_GT(std::abs(row.as_printed - row.reference), row.tolerance)
        << row.erratum << " " << row.quantity << ": as printed " << row.as_printed << ", reference "
        << row.reference;
    judged.insert(row.erratum);
  }
  for (const auto& erratum : errata()) EXPECT_TRUE(judged.contains(erratum.id)) << erratum.id;
  EXPECT_EQ(judged.size(), errata().size());
}

// What the text as printed would give, by other means.
TEST(Errata, ValuesOfThePrintedTextAreThoseOfTheory) {
  std::set<std::string> with_evidence;
  for (const auto& row : studies::errata_evidence(paper())) {
    with_evidence.insert(row.erratum);
    // (c^4 - p c^2 - k)/k at c^2 = -p/2 - root = -b^2 of the mode, with b^2 - a^2 = p and a^2 b^2 = k: 2 (b^2/a^2 - 1), which
    // no P but 0 makes vanish.
    if (row.erratum == "E2") {
      const analytic::StickMode mode = analytic::stick_modes(paper().beam, 1).front();
      const double ratio = mode.trigonometric_wave_number() / mode.hyperbolic_wave_number();
      EXPECT_TRUE(within(row.as_printed, 2.0 * (ratio * ratio - 1.0), round_off(20, 1, 1.0)));
      EXPECT_GT(row.as_printed, 0.0);
    }
    // Euler's column, to (beta l)^4/720 of 16 elements, beta L = pi/2.
    if (row.erratum == "E8") {
      const double euler = std::pow(std::numbers::pi / 2.0, 2);
      EXPECT_TRUE(within(row.as_printed, euler,
                         discretisation(euler * std::pow(std::numbers::pi / 32.0, 4) / 720.0, 1.1, "mesh")));
    }
    // A clamped and pinned beam without P: tan b = tanh b, b = beta L, at beta^4 = rho A omega^2/EI of 25 Hz.
    if (row.erratum == "E9") {
      const data::Beam section = data::load_case("paper-figure14").beam;
      const double b = row.quantity.starts_with("L1") ? 3.9266023120479 : 7.0685827456287;
      const double beta = std::pow(section.density() * section.area() * std::pow(50.0 * std::numbers::pi, 2) /
                                       (section.youngs_modulus() * section.second_moment_of_area()),
                                   0.25);
      EXPECT_TRUE(within(row.as_printed, b / beta, reference(1e-10, "the length that a search finds")));
    }
    // At rest T' = V h' cancels S h': V = -int U S/int U^2.
    if (row.erratum == "E4") {
      const int modes = row.quantity.ends_with("20") ? 20 : 10;
      auto sum = studies::stick_sum(paper().beam, modes);
      for (auto& mode : sum.modes) mode.initial_rate = mode.participation - mode.rigid_participation;
      const auto terms =
          studies::sinusoids(sum, data::HarmonicExcitation({15.0, 0.5e-3}), studies::StickReading::force);
      double largest = 0.0;
      for (int n = 0; n <= 100'000; ++n)
        largest = std::max(largest, std::abs(studies::value_at(terms, n * 1e-4)));
      EXPECT_NEAR(row.as_printed, largest, 1e-7 * largest) << modes;
      EXPECT_TRUE(within(row.as_printed, modes == 10 ? 201.0 : 393.0, reference(0.5, "three digits of E4")));
    }
  }
  for (const char* erratum : {"E4", "E8", "E9"}) EXPECT_TRUE(with_evidence.contains(erratum)) << erratum;
}

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
    const auto modes = solver::stick_modes(solver::BeamModel(paper().beam, elements), 3);
    return std::round(10.0 * modes.back().angular_frequency / (2.0 * std::numbers::pi)) / 10.0;
  };
  const double printed = data::printed_number("frequency.stick.3").value;
  for (const int elements : {11, 20, 31}) EXPECT_DOUBLE_EQ(rounded(elements), printed) << elements;
  for (const int elements : {10, 32}) EXPECT_NE(rounded(elements), printed) << elements;
}

STICKSLIP_VERIFIES(LedgerOfClaims, "V3");
TEST(LedgerOfClaims, RefersToFiguresAndTablesThatTheReportHas) {
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

class Verdict : public ::testing::TestWithParam<data::PrintedVerdict> {};

STICKSLIP_VERIFIES(Verdict, "V1");
TEST_P(Verdict, IsThePrintedOneByBothImplementations) {
  const auto& printed = GetParam();
  const bool slips = printed.verdict == "stick-slip";
  EXPECT_EQ(criterion_slips(printed.frequency_hz, printed.amplitude), slips)
      << "closed form, Fig. " << printed.figure;
  EXPECT_EQ(finite_elements_slip(printed.frequency_hz, printed.amplitude), slips)
      << "finite elements, Fig. " << printed.figure;
}

INSTANTIATE_TEST_SUITE_P(Figures4And5, Verdict, ::testing::ValuesIn(data::printed_verdicts()),
                         [](const auto& instance) { return "Figure" + instance.param.figure; });

}  // namespace
}  // namespace stickslip::testing
