// SPDX-License-Identifier: MIT
/// Somebody's results against reference data: a copy agrees, an error of known size is found where it is,
/// events and phases are kept apart, and known mistakes are named.

#include "comparison/diagnosis/wrong_models.hpp"
#include "own_copy.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

using comparison::Agreement;
using comparison::Comparison;
using comparison::Finding;
using comparison::Settings;
using Values = std::vector<double>;

// --- copies

STICKSLIP_VERIFIES(ComparedCopy, "X20");
TEST(ComparedCopy, OfEveryDataSetAgreesWithoutError) {
  for (const std::string set : {"stick-frequencies", "quasi-static-shape", "stick-force", "damped-events",
                                "damped-history", "cubic-events", "cubic-history"}) {
    const Comparison comparison = own_copy(set).diagnosed();
    EXPECT_EQ(comparison.agreement, Agreement::agrees) << set;
    EXPECT_EQ(comparison.name, set);
    EXPECT_TRUE(comparison.remarks.empty()) << set << ": " << comparison.remarks.front();
    EXPECT_TRUE(comparison.diagnoses.empty());
    EXPECT_FALSE(comparison.quantities.empty()) << set;
    for (const auto& one : comparison.quantities) {
      EXPECT_EQ(one.error, 0.0) << set << " " << one.name;
      EXPECT_EQ(one.agreement, Agreement::agrees) << set << " " << one.name;
      EXPECT_GT(one.compared, 0u);
      EXPECT_EQ(one.undecided, 0u);
    }
  }
}

TEST(ComparedCopy, HasAllPointsOfItsSeries) {
  // Of equal errors the first is told.
  EXPECT_EQ(own_copy("cubic-history").compared("y").where, "t = 0 s, run = a");
  const Comparison comparison = own_copy("stick-frequencies").compared();
  const auto frequency = quantity_of(comparison, "frequency");
  EXPECT_EQ(frequency.compared, 12u);
  EXPECT_EQ(frequency.unit, "Hz");
  EXPECT_EQ(comparison.abscissa, "mode");
  ASSERT_EQ(frequency.series.size(), 2u);
  EXPECT_EQ(frequency.series[1].group, "beam = paper-half-stiffness");
  const auto table = own_copy("stick-frequencies").reference();
  EXPECT_EQ(frequency.series[0].abscissa, (Values{1, 2, 3, 4, 5, 6}));
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(frequency.series[1].theirs[i], table.column("frequency").values[i + 6]);
    EXPECT_EQ(frequency.series[1].reference[i], table.column("frequency").values[i + 6]);
    EXPECT_EQ(frequency.series[1].half_width[i], table.radius_of("frequency")[i + 6]);
    const double allowed = 1e-6 * frequency.series[1].reference[i];
    EXPECT_TRUE(within(frequency.series[1].allowed[i], allowed, round_off(1.0, 1.0, allowed)));
  }
}

// --- errors of known size

STICKSLIP_VERIFIES(ComparedTable, "X20");
TEST(ComparedTable, MatchesRowsByKeyInAnyOrderAndNamesThoseThatAreMissing) {
  auto mine = own_copy("stick-frequencies");
  for (auto& column : mine.table.columns) {
    std::ranges::reverse(column.text);
    std::ranges::reverse(column.values);
  }
  EXPECT_EQ(mine.compared("frequency").error, 0.0);
  mine.keep([](std::size_t row) { return row >= 5; });  // all of one beam, and one of the other
  const Comparison comparison = mine.compared();
  EXPECT_EQ(comparison.agreement, Agreement::undecided);
  EXPECT_EQ(quantity_of(comparison, "frequency").compared, 7u);
  ASSERT_EQ(comparison.remarks.size(), 1u);
  EXPECT_EQ(comparison.remarks[0],
            "5 of 12 rows of the data set are not in the file: beam = paper-half-stiffness, mode = 2; beam = "
            "paper-half-stiffness, mode = 3; beam = paper-half-stiffness, mode = 4; beam = "
            "paper-half-stiffness, mode = "
            "5; beam = paper-half-stiffness, mode = 6");
  mine.erase(0);
  EXPECT_TRUE(mine.compared().remarks.at(0).ends_with("mode = 5 and 1 more"));
}

TEST(ComparedTable, SaysOnceWhatSeveralGroupsLookLike) {
  auto mine = own_copy("stick-frequencies");
  for (double& frequency : mine["frequency"]) frequency *= 2.0;
  const auto diagnoses = mine.diagnosed().diagnoses;
  ASSERT_EQ(diagnoses.size(), 1u);
  EXPECT_EQ(diagnoses[0].group, "beam = paper and 1 more");
}

TEST(ComparedTable, RefusesRowsThatTheDataSetLacks) {
  auto mine = own_copy("stick-frequencies");
  mine["mode"][2] = 99.0;
  mine.words("mode")[2] = "99";
  EXPECT_EQ(
      mine.error_message(),
      "mine.csv:4: beam = paper, mode = 99 is not in the data set stick-frequencies, where mode must be one "
      "of 1, 2, 3, 4, 5, 6");
  mine = own_copy("stick-frequencies");
  mine.words("beam")[0] = "strip";
  EXPECT_EQ(
      mine.error_message(),
      "mine.csv:2: beam = strip is not in the data set stick-frequencies, where beam must be one of paper, "
      "paper-half-stiffness");
  auto maxima = published_copy("friction-maxima");
  maxima["frequency"][0] = 0.5;
  maxima.words("frequency")[0] = "0.5";
  EXPECT_EQ(
      maxima.error_message(),
      "mine.csv:2: frequency = 0.5 is not in the data set friction-maxima, where frequency must be one of "
      "the 120 from 1 to 120");
  EXPECT_EQ(own_copy("beams").error_message(), "the data set beams says nothing of how to compare with it");
}

STICKSLIP_VERIFIES(ComparedCurve, "X20");
TEST(ComparedCurve, MeasuresErrorsByTheLargestValue) {
  const auto force = own_copy("stick-force")["friction_force"];
  const double scale = std::abs(*std::ranges::max_element(force, {}, [](double f) { return std::abs(f); }));
  for (const double error : {5e-4, -2e-3}) {
    auto mine = own_copy("stick-force");
    mine["friction_force"][100] += error * scale;
    const auto found = mine.compared("friction_force");
    EXPECT_TRUE(within(*found.error, std::abs(error), round_off(1.0, 1.0, 1.0)));
    EXPECT_EQ(found.where, "t = 0.05 s");
    EXPECT_EQ(found.agreement, error > 1e-3 || error < -1e-3 ? Agreement::differs : Agreement::agrees);
    EXPECT_TRUE(within(*found.uncertainty, 1e-9 / scale, round_off(1.0, 1.0, 1e-9 / scale)));
  }
  // With a horizon by the largest one up to it, which here is that at the horizon.
  std::size_t last = 0;
  while (std::abs(force[last]) <= 0.5 * scale) ++last;
  const auto early =
      with_rule("stick-force", [&](auto& rule) { rule.horizon = own_copy("stick-force")["t"][last]; });
  OwnCopy mine(early, "stick-force");
  mine["friction_force"][0] += 0.1 * std::abs(force[last]);
  const auto found = mine.compared("friction_force");
  EXPECT_TRUE(within(*found.error, 0.1, round_off(2.0, 1.0, 0.1)));
}

TEST(ComparedCurve, MeasuresErrorsByTheRangeOfThePublishedColumn) {
  // Of the whole column, however few rows of it a file has.
  const auto with_range =
      with_rule("stick-force", [](auto& rule) { rule.values.front().norm = data::Norm::range; });
  const auto force = own_copy("stick-force")["friction_force"];
  const auto [least, greatest] = std::ranges::minmax(force);
  const double range = greatest - least;
  ASSERT_GT(range, 1.5 * std::max(greatest, -least));
  for (const double error : {9e-4, -2e-3}) {
    OwnCopy mine(with_range, "stick-force");
    mine.keep([](std::size_t row) { return row >= 90 && row < 110; });
    mine["friction_force"][10] += error * range;
    const auto found = mine.compared("friction_force");
    EXPECT_EQ(found.norm, data::Norm::range);
    EXPECT_EQ(found.compared, 20u);
    // The value, up to half the range or more, is rounded when the error is added.
    EXPECT_TRUE(within(*found.error, std::abs(error), round_off(1.0, 1.0, 1.0)));
    EXPECT_EQ(found.where, "t = 0.05 s");
    EXPECT_EQ(found.agreement, error > 0.0 ? Agreement::agrees : Agreement::differs);
    EXPECT_TRUE(within(*found.uncertainty, 1e-9 / range, round_off(1.0, 1.0, 1e-9 / range)));
    EXPECT_TRUE(within(found.series[0].allowed[10], 1e-3 * range + 1e-9, round_off(2.0, 1.0, 1e-3 * range)));
  }
}

TEST(ComparedCurve, InterpolatesBetweenSamplesByItself) {
  auto mine = own_copy("stick-force");
  mine["t"][3] += 1e-6;
  mine.words("t")[3] = "0.001501";
  const auto between = mine.compared("friction_force");
  EXPECT_EQ(between.compared, 161u);
  EXPECT_EQ(skipped_for(between, "between the samples"), 1u);
  EXPECT_GT(*std::ranges::max_element(between.series[0].half_width), 1e-5);  // N; those of the set are 1e-9 N
  mine["t"][3] = 0.0015 * (1.0 + 1e-10);
  EXPECT_EQ(mine.compared().agreement, Agreement::agrees);
}

// --- events

STICKSLIP_VERIFIES(ComparedEvents, "X20");
TEST(ComparedEvents, NameTheEventThatIsTooMany) {
  auto mine = own_copy("damped-events");
  mine["time"][6] = 0.1095;  // that of 0.11107 s, behind the horizon of 0.11 s, far too early
  Comparison comparison = mine.compared();
  EXPECT_EQ(quantity_of(comparison, "sequence").error, 1.0);
  EXPECT_EQ(comparison.remarks,
            std::vector<std::string>{"event 7 (onset at 0.1095 s) of the file is not in the data set"});
  EXPECT_EQ(skipped_for(quantity_of(comparison, "time"), "without an event of the data set"), 1u);

  mine = own_copy("damped-events");
  mine.repeat(3);  // two captures one after the other
  comparison = mine.compared();
  EXPECT_EQ(quantity_of(comparison, "time").compared, 6u);
  EXPECT_EQ(
      comparison.remarks,
      std::vector<std::string>{"event 4 (capture at 0.0890359755 s) of the file is not in the data set"});
}

TEST(ComparedEvents, MayLieOnEitherSideOfTheHorizon) {
  auto mine = own_copy("damped-events");
  const double sixth = mine["time"][5];
  const auto difference = [](const OwnCopy& copy, double latest) {
    return *copy.compared("sequence", until(latest)).error;
  };
  EXPECT_EQ(difference(mine, sixth + 5e-6), 0.0);
  EXPECT_EQ(difference(mine, sixth - 5e-6), 0.0);
  mine["time"][5] = sixth - 8e-6;  // theirs is before the horizon, the reference's behind
  EXPECT_EQ(difference(mine, sixth - 5e-6), 0.0);
  mine["time"][5] = sixth + 8e-6;  // and the other way round
  EXPECT_EQ(difference(mine, sixth + 5e-6), 0.0);
  mine.keep_first(5);  // not reached
  EXPECT_EQ(difference(mine, sixth + 5e-6), 0.0);
  EXPECT_EQ(difference(mine, sixth + 5e-5), 1.0);
  // A relative tolerance is that share of the latest time.
  const auto relative =
      with_rule("damped-events", [](auto& rule) { rule.values.front().norm = data::Norm::relative; });
  OwnCopy five(relative, "damped-events");
  five.keep_first(5);
  for (const double share : {0.9e-4, 1.1e-4})
    EXPECT_EQ(five.compared("sequence", with_tolerance("time", 1e-4, sixth * (1.0 + share))).error,
              share < 1e-4 ? 0.0 : 1.0);
}

TEST(ComparedEvents, MayBeMissingNearTheLastOne) {
  const auto relative = with_rule("damped-events", [](auto& rule) {
    rule.values.front().norm = data::Norm::relative;
    rule.horizon = std::nullopt;
  });
  OwnCopy mine(relative, "damped-events");
  const auto time = mine["time"];
  mine.keep([](std::size_t row) { return row != 3 && row != 4; });
  // An event so near to the end of the file may lie behind it.
  const double fourth = 1.0 - time[3] / time[6], fifth = 1.0 - time[4] / time[6];
  const auto missing = [&](double tolerance) {
    return *mine.compared("sequence", with_tolerance("time", tolerance)).error;
  };
  EXPECT_EQ(missing(0.99 * fifth), 2.0);
  EXPECT_EQ(missing(1.01 * fifth), 1.0);
  EXPECT_EQ(missing(1.01 * fourth), 0.0);
}

TEST(ComparedEvents, LeaveGrazesOutAndRefuseOtherWords) {
  auto mine = own_copy("damped-events", {"change", "time", "position"});
  mine.repeat(1);
  mine.words("change")[1] = "graze";
  EXPECT_EQ(mine.compared().agreement, Agreement::agrees);
  mine.words("change")[1] = "slip";
  EXPECT_EQ(mine.error_message(),
            "mine.csv:3: change is 'slip', but must be one of onset, capture, reversal, graze");
}

TEST(ComparedEvents, OfSeveralRunsAreKeptApart) {
  auto mine = own_copy("cubic-events");
  mine["time"][3] += 3e-7;
  mine["position"][3] *= 1.0 + 4e-7;  // its scale is that of its run, which has this event only
  const Comparison comparison = mine.compared();
  EXPECT_EQ(quantity_of(comparison, "time").where, "event 1 (onset at 0.455 s), run = b");
  EXPECT_TRUE(within(*quantity_of(comparison, "position").error, 4e-7, round_off(1.0, 1.0, 1.0)));
  EXPECT_EQ(comparison.agreement, Agreement::agrees);
  mine.erase(3);
  EXPECT_EQ(mine.compared().remarks,
            std::vector<std::string>{"run = b is not in the file and was not compared"});
}

TEST(ComparedEvents, SayWhatWasNotGiven) {
  const Comparison comparison = own_copy("damped-events", {"change", "time"}).compared();
  EXPECT_EQ(comparison.agreement, Agreement::agrees);
  EXPECT_EQ(comparison.remarks, std::vector<std::string>{"position is not in the file and was not compared"});
}

// --- phases

// Samples between those of the reference, with the cubic polynomials of the data set, which a polynomial of
// order 3 reproduces; at 1 m its terms lose some ten eps.
OwnCopy between_samples() {
  auto mine = own_copy("cubic-history");
  mine.keep([&](std::size_t row) { return (row + 1) % 101 != 0; });
  auto events = own_copy("cubic-events");
  for (std::size_t row = 0; row < mine.table.rows(); ++row) {
    double& t = mine["t"][row];
    t += 0.0042;
    std::size_t phase = 0;
    for (std::size_t event = 0; event < events.table.rows(); ++event)
      if (events.words("run")[event] == mine.words("run")[row] && events["time"][event] <= t) ++phase;
    const Values factors{1.0, -2.0, 3.0, -4.0};
    const double factor = factors[phase] * (mine.words("run")[row] == "a" ? 1.0 : 2.0);
    mine["y"][row] = factor * (1.0 + t - 2.0 * t * t + t * t * t) + static_cast<double>(phase);
    mine.words("phase")[row] = phase == 0 || phase == 3 ? "stick" : "slip";
  }
  return mine;
}

STICKSLIP_VERIFIES(ComparedHistory, "X20");
TEST(ComparedHistory, IsInterpolatedWithinItsPhaseOnly) {
  for (const bool events : {false, true}) {
    const Comparison comparison =
        between_samples().compared(events ? with_events(own_copy("cubic-events")) : Settings());
    EXPECT_EQ(comparison.agreement, Agreement::agrees);
    const auto y = quantity_of(comparison, "y");
    // One step over a jump would be an error of 1 m or more.
    EXPECT_TRUE(within(*y.error, 0.0, round_off(4.0, 2.0, 6.0)));
    // Run a has samples at 0.0042, 0.0142, ..., 0.9942 s, run b as well; 0.9442 is the last before 0.95 s.
    EXPECT_EQ(skipped_for(y, "beyond the horizon"), 10u);
    // Events at 0.305, 0.515, 0.805 and 0.455 s: the sample at 0.3042 has none of its phase behind it, and so
    // on.
    const std::size_t at_events = 4;
    EXPECT_EQ(skipped_for(y, "between an event and the samples"), events ? at_events : 0u);
    EXPECT_EQ(skipped_for(y, "between the two times of an event"), events ? 0u : 2u * at_events);
    EXPECT_EQ(y.compared, 190u - (events ? at_events : 2u * at_events));
    EXPECT_EQ(quantity_of(comparison, "phase").error, 0.0);
  }
}

TEST(ComparedHistory, CountsSamplesInAnotherPhase) {
  // They stick up to 0.342 s, 37 ms longer; one of the four samples is within the guard of 10 ms.
  auto mine = own_copy("cubic-history");
  for (std::size_t row = 31; row < 35; ++row) {
    mine["y"][row] = 1e3;
    mine.words("phase")[row] = "stick";
  }
  EXPECT_EQ(mine.compared().agreement, Agreement::differs);
  EXPECT_EQ(mine.compared("phase").error, 3.0);
  EXPECT_EQ(mine.compared("phase").where, "t = 0.32 s, run = a (slip in the data set)");
  EXPECT_EQ(mine.compared("y").agreement, Agreement::agrees);
}

// --- what it looks like

STICKSLIP_VERIFIES(DiagnosisOfMistake, "X20");
TEST(DiagnosisOfMistake, TheMistakeThatWasMade) {
  for (const auto& [set, wrong_model, problem] :
       {std::tuple{"stick-frequencies", "second-moment-as-printed", "paper"},
        {"stick-frequencies", "lumped-mass", "paper"},
        {"stick-frequencies", "axial-force-left-out", "paper"},
        {"quasi-static-shape", "tension", "paper"},
        {"stick-force", "zero-initial-velocity", "paper"},
        {"stick-force", "start-from-rest", "paper"},
        {"stick-force", "force-sign", "paper"},
        {"stick-force", "dead-load", "paper"},
        {"stick-force", "peak-to-peak-amplitude", "paper"},
        {"damped-events", "damping-left-out", "damped"},
        {"damped-events", "kinetic-friction-at-once", "damped"},
        {"damped-history", "one-friction-coefficient", "damped"},
        {"damped-history", "regularised-friction", "damped"},
        {"damped-history", "widely-regularised-friction", "damped"}}) {
    SCOPED_TRACE(wrong_model);
    const data::DiagnosisRule& rule = *small_package().resource(set).diagnosis;
    const auto what = std::ranges::find(comparison::quantity_names, rule.quantity, [](const auto& named) {
                        return named.second;
                      })->first;
    auto mine = own_copy(set, {"beam", "change", rule.abscissa, rule.value});
    if (std::string(set) == "stick-frequencies" || what == comparison::Quantity::contact_event)
      mine.keep_first(6);
    const auto values = comparison::wrong_result(with_the_settings_of_the_paper(problem), wrong_model, what,
                                                 mine[rule.abscissa]);
    ASSERT_TRUE(values.has_value());
    mine[rule.value] = *values;
    const Comparison comparison = mine.diagnosed();
    EXPECT_EQ(comparison.agreement, Agreement::differs);
    ASSERT_EQ(comparison.diagnoses.size(), 1u);
    const auto& diagnosis = comparison.diagnoses.front();
    EXPECT_EQ(diagnosis.finding, Finding::mistaken) << diagnosis.sentence;
    EXPECT_GT(std::ranges::count(diagnosis.named, wrong_model), 0) << diagnosis.sentence;
    EXPECT_TRUE(holds(diagnosis.sentence, wrong_model));
  }
}

STICKSLIP_VERIFIES(DiagnosisOfNothing, "X20");
TEST(DiagnosisOfNothing, IsWhatHasNoCaseOfItsOwnOrNoKnownMistake) {
  auto curve = own_copy("cubic-history");
  for (std::size_t row = 0; row < curve["y"].size(); ++row) curve["y"][row] += row % 2 == 0 ? 1.0 : -1.0;
  EXPECT_TRUE(curve.diagnosed().diagnoses.at(0).sentence.starts_with("no diagnosis: no factor"));
  auto mine = own_copy("damped-history");
  for (std::size_t row = 0; row < mine.table.rows(); ++row)
    mine["friction_force"][row] += row % 2 == 0 ? 30.0 : -30.0;
  const Comparison comparison = mine.diagnosed();
  EXPECT_EQ(comparison.agreement, Agreement::differs);
  ASSERT_EQ(comparison.diagnoses.size(), 1u);  // of the force, not of the displacement
  EXPECT_EQ(comparison.diagnoses[0].quantity, "friction_force");
  EXPECT_EQ(comparison.diagnoses[0].finding, Finding::unexplained) << comparison.diagnoses[0].sentence;
}

TEST(DiagnosisOfNothing, IsADifferenceThatTheModelsCannotResolve) {
  auto mine = own_copy("damped-history", {"t", "tip_displacement"});
  double sign = 1.0;
  for (double& y : mine["tip_displacement"]) y *= 1.0 + 1e-4 * (sign = -sign);
  const Comparison comparison = mine.diagnosed(with_tolerance("tip_displacement", 1e-5));
  EXPECT_EQ(comparison.agreement, Agreement::differs);
  ASSERT_EQ(comparison.diagnoses.size(), 1u);
  EXPECT_EQ(comparison.diagnoses[0].sentence,
            "no diagnosis: the difference of 0.01 % up to 0.2 s is too small to be assigned to a mistake");
}

}  // namespace
}  // namespace stickslip::testing
