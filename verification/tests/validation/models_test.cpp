// SPDX-License-Identifier: MIT
/// The models of the experiments against both implementations, and what the comparison found.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <string>

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/input_error.hpp"
#include "support/requirements.hpp"
#include "validation/forms.hpp"
#include "validation/models.hpp"
#include "validation/rig.hpp"
#include "validation/study.hpp"

namespace stickslip::testing {
namespace {

using std::numbers::pi;
using validation::Figure;
using validation::FrictionForm;
using validation::Slider;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr Slider fast_slider{.stiffness = 1002.0, .speed = 4300e-6};

double natural_period(const Slider& slider) { return 2.0 * pi / slider.angular_frequency(); }

// 200 samples a period: turning points to half a sample each, over 39 periods or more.
STICKSLIP_VERIFIES(SliderModel, "K2");
TEST(SliderModel, ClosedFormIsTheMotionOfBothImplementations) {
  for (Slider slider : {fast_slider, Slider{.stiffness = 168.0, .speed = 1100e-6}}) {
    slider.moved_mass = 0.8 * slider.mass;
    const FrictionForm form{.kinetic = 0.3, .excess = 0.03, .decay = infinite, .contact_stiffness = infinite};
    const validation::Values exact = validation::rigid_slider(slider, form.kinetic, form.excess);
    for (const auto& record :
         {validation::event_driven_record(slider, form), validation::time_stepped_record(slider, form)}) {
      EXPECT_NEAR(validation::period_of(record), exact.at("period"), natural_period(slider) / 200.0 / 20.0);
      const auto [low, high] = std::ranges::minmax(record.force);
      EXPECT_NEAR(high - low, exact.at("force_range"), 1e-3 * exact.at("force_range"));
    }
  }
}

TEST(SliderModel, WeakeningWithSpeedKeepsTheNaturalPeriod) {
  for (const double decay : {0.03, 0.3, 3.0, 30.0}) {  // times 1/V
    const FrictionForm form{
        .kinetic = 0.32, .excess = 0.0312, .decay = decay / fast_slider.speed, .contact_stiffness = infinite};
    const double events = validation::period_of(validation::event_driven_record(fast_slider, form));
    EXPECT_GT(events, 0.99 * natural_period(fast_slider));
    EXPECT_NEAR(validation::period_of(validation::time_stepped_record(fast_slider, form)), events,
                1e-4 * events);
  }
}

TEST(SliderModel, ContactSpringShortensThePeriodLittle) {
  for (const double ratio : {0.5, 2.0, 8.0, 20.0}) {  // of k
    const FrictionForm form{.kinetic = 0.32,
                            .excess = 0.0312,
                            .decay = 3.0 / fast_slider.speed,
                            .contact_stiffness = ratio * fast_slider.stiffness};
    EXPECT_GT(validation::period_of(validation::time_stepped_record(fast_slider, form)),
              0.96 * natural_period(fast_slider));
  }
}

// A period in stick and slip is (2/omega)(pi + D - arctan D), and D >= arctan D: whatever the time at rest makes of mu_s.
TEST(SliderModel, StrengtheningAtRestLengthensThePeriod) {
  for (const double excess : {0.0, 1e-4, 1e-2, 0.3})
    EXPECT_GE(validation::rigid_slider(fast_slider, 0.3, excess).at("period"),
              natural_period(fast_slider) * (1.0 - 1e-12));
}

// Jenkins with play under x = X sin: the force follows the closed loop exactly.
STICKSLIP_VERIFIES(DamperModel, "K2");
TEST(DamperModel, LoopOfASpringWithPlay) {
  constexpr double amplitude = 0.025, force = 9000.0, stiffness = 6e6, play = 3e-3, offset = 200.0;
  validation::Record record;
  double slider = 0.0, last = 0.0;  // the position of zero force in the middle of the play
  for (int i = 0; i <= 1024 * 12; ++i) {
    const double t = i / 1024.0, x = amplitude * std::sin(pi * t), stretch = x - slider;
    double spring = std::copysign(std::max(0.0, std::abs(stretch) - 0.5 * play), stretch) * stiffness;
    if (std::abs(spring) > force) {
      spring = std::copysign(force, spring);
      slider = x - std::copysign(force / stiffness + 0.5 * play, spring);
    }
    last = spring;
    record.time.push_back(t);
    record.displacement.push_back(x);
    record.force.push_back(last + offset);
  }
  const validation::Figures read = validation::read_damper(record);
  const validation::Values exact = validation::damper_loop(amplitude, force, stiffness, play);
  // The displacement moves by up to 0.08 mm between samples, and the play is read at samples.
  EXPECT_NEAR(read.at("slip_force").value, force, 1e-6 * force);
  EXPECT_NEAR(read.at("force_offset").value, offset, 1e-6 * force);
  EXPECT_NEAR(read.at("energy").value, exact.at("energy"), 4e-3 * exact.at("energy"));
  EXPECT_NEAR(read.at("contact_stiffness").value, stiffness, 0.1 * stiffness);
  EXPECT_NEAR(read.at("play").value, play + 0.2 * force / stiffness, 3e-4);
}

TEST(DamperModel, UncertaintyPropagatesToFirstOrder) {
  const auto sum = [](const std::vector<double>& x) {
    return validation::Values{{"s", 3.0 * x[0] - 4.0 * x[1]}};
  };
  const auto result = validation::propagated(sum, {{1.0, 0.1}, {2.0, 0.1}}).at("s");
  EXPECT_DOUBLE_EQ(result.value, -5.0);
  EXPECT_NEAR(result.uncertainty, 0.5, 1e-12);
}

STICKSLIP_VERIFIES(MeasuredComparison, "K3");
TEST(MeasuredComparison, FormOfTheComparison) {
  validation::Comparison one;
  one.prediction = {.record = "",
                    .quantity = "",
                    .form = "",
                    .value = 5.0,
                    .input_uncertainty = 2.0,
                    .numerical_uncertainty = 6.0,
                    .entry = 1};
  one.measured = {1.0, 3.0, 8};
  EXPECT_DOUBLE_EQ(one.error(), 4.0);
  EXPECT_DOUBLE_EQ(one.uncertainty(), 7.0);
  EXPECT_FALSE(one.is_resolved());
  EXPECT_TRUE(one.contains_zero());
  one.prediction.value = 16.0;
  EXPECT_TRUE(one.is_resolved());
  EXPECT_FALSE(one.contains_zero());
}

TEST(MeasuredComparison, NoSetPointIsLeftOut) {
  const auto all = validation::comparisons();
  for (const auto& point : validation::set_points()) {
    const auto rows =
        std::ranges::count_if(all, [&](const auto& one) { return one.prediction.record == point.record; });
    const bool is_slider = point.experiment == "paper-slider";
    EXPECT_EQ(rows, point.role == "calibration" ? (is_slider ? 1 : 0) : (is_slider ? 10 : 4)) << point.record;
  }
}

// Two estimators that share nothing, the cycles between turning points and the autocorrelation, against 2 pi sqrt(m/k) with
// 5 % for k: the published mass and stiffness are refuted at 4300 um/s, the moved mass of the slip at 42 um/s is not.
TEST(MeasuredComparison, PeriodsBelowThatOfMassAndSpring) {
  const auto figures = validation::measured_figures();
  for (const std::string record : {"k168-v4300", "k1002-v4300", "k2254-v4300"}) {
    const double k = std::stod(record.substr(1)),
                 shortest = natural_period({.stiffness = k, .speed = 4300e-6});
    for (const char* quantity : {"period", "second_period"}) {
      const Figure& period = figures.at({record, quantity});
      EXPECT_LT(period.value + 2.0 * std::hypot(period.uncertainty, 0.025 * shortest), shortest)
          << record << " " << quantity;
    }
  }
  for (const auto& one : validation::comparisons()) {
    if (one.prediction.quantity != "period" || one.prediction.form != "lighter") continue;
    EXPECT_TRUE(one.contains_zero()) << one.prediction.record;
  }
}

// The raw records are not part of the project: where a folder is given they are read again; the form of the tables holds always.
TEST(MeasuredComparison, TablesAreThoseOfTheRawRecords) {
  const char* folder = std::getenv("STICKSLIP_MEASUREMENTS");
  RecordProperty("raw_records",
                 folder == nullptr ? "not given: only the form of the tables was checked" : folder);
  const auto table = validation::measured_figures();
  for (const auto& point : validation::set_points()) {
    EXPECT_EQ(point.sha256.size(), 64U);
    EXPECT_TRUE(point.role == "calibration" || point.role == "prediction") << point.role;
    const bool is_slider = point.experiment == "paper-slider";
    EXPECT_TRUE(table.contains({point.record, is_slider ? "period" : "energy"})) << point.record;
    if (folder == nullptr) continue;
    for (const auto& [quantity, figure] : validation::read_raw(point, folder))
      EXPECT_NEAR(table.at({point.record, quantity}).value, figure.value, 1e-5 * std::abs(figure.value))
          << point.record;
  }
}

// A cantilever of E I = 0.35 N m^2 buckles at 9.6 N (0.3 m) under a load of fixed direction and not under one that follows.
STICKSLIP_VERIFIES(ProposedRig, "K3");
TEST(ProposedRig, FrequenciesDecideOnTheDirectionOfTheForce) {
  const data::Beam beam = data::load_case("rig").beam;
  for (const auto& pair : validation::axial_direction_experiment(beam)) {
    EXPECT_GT(pair.following, pair.fixed);
    EXPECT_GT(pair.accuracy, 0.005);
    const double rigidity = beam.youngs_modulus() * beam.second_moment_of_area();
    const double euler = pi * pi / 4.0 * rigidity / (pair.length * pair.length);
    // f^2 of a dead load falls nearly on a line to 0 at Euler's load.
    const double unloaded = 1.8751040687 * 1.8751040687 / (2.0 * pi * pair.length * pair.length) *
                            std::sqrt(rigidity / (beam.density() * beam.area()));
    EXPECT_NEAR(pair.fixed, unloaded * std::sqrt(1.0 - pair.load / euler), 0.02 * unloaded);
  }
}

}  // namespace
}  // namespace stickslip::testing
