// SPDX-License-Identifier: MIT
/// The models of the experiments against both implementations, and what the comparison found.

#include "validation/models.hpp"
#include "stickslip/analytic/event_driven.hpp"
#include "stickslip/analytic/slip_modes.hpp"
#include "stickslip/data/input_error.hpp"
#include "studies/verification/proposed_rig.hpp"
#include "support/contact_models.hpp"
#include "support/input_folder.hpp"
#include "support/testing.hpp"
#include "validation/study.hpp"

namespace stickslip::testing {
namespace {

using std::numbers::pi;
using validation::Figure;
using validation::Slider;

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr Slider fast_slider{.stiffness = 1002.0, .speed = 4300e-6};

double natural_period(const Slider& slider) { return 2.0 * pi / slider.angular_frequency(); }

// Friction mu_k + excess exp(-decay |v|) with mu_k = 0.3, and a contact spring in N/m.
struct FrictionForm {
  double excess{}, decay{infinite}, contact_stiffness{infinite};
};

constexpr int samples = 200, first_period = 20, last_period = 60;  // a period has 2 pi/omega

data::FrictionCoefficients friction_of(const FrictionForm& form) {
  return {.static_coefficient = 0.3 + form.excess, .kinetic_coefficient = 0.3, .decay = form.decay};
}

// In the frame of the moving end of the spring: the wall moves at V, and the force of the spring is k u.
void add_sample(validation::Record& record, const Slider& slider, double t, double displacement) {
  record.time.push_back(t);
  record.force.push_back(slider.stiffness * displacement / (slider.mass * slider.gravity));
}

validation::Record event_driven_record(const Slider& slider, const FrictionForm& form) {
  analytic::ContactModel model;
  model.contact_mass = slider.moved_mass;
  model.contact_stiffness = slider.stiffness;
  model.load = {0.0};
  model.load_angular_frequency = slider.angular_frequency();
  model.wall_speed = slider.speed;
  model.normal_force = slider.mass * slider.gravity;
  model.friction = data::FrictionLaw(friction_of(form));
  analytic::EventDriven run(model);
  validation::Record record;
  for (int i = first_period * samples; i <= last_period * samples; ++i) {
    run.advance_to(natural_period(slider) * i / samples);
    add_sample(record, slider, run.time(), run.contact_displacement());
  }
  return record;
}

validation::Record time_stepped_record(const Slider& slider, const FrictionForm& form) {
  constexpr int steps = 10;  // for each sample
  const double speed = slider.speed;
  auto system = contact_system(
      {.mass = slider.moved_mass,
       .stiffness = slider.stiffness,
       .normal_force = slider.mass * slider.gravity,
       .friction = friction_of(form)},
      {[=](double t) { return speed * t; }, [=](double) { return speed; }, [](double) { return 0.0; }});
  if (std::isfinite(form.contact_stiffness))
    system.tangential = data::TangentialContact({.tangential_stiffness = form.contact_stiffness});
  solver::StickSlipIntegrator run(
      system, {.time_step = natural_period(slider) / (samples * steps), .spectral_radius = 1.0});
  run.start_stuck(scalar(0.0), scalar(speed));
  validation::Record record;
  for (int i = 0; i <= last_period * samples; ++i) {
    if (i >= first_period * samples) add_sample(record, slider, run.time(), run.displacement()[0]);
    for (int j = 0; j < steps; ++j) run.step();
  }
  return record;
}

double period_of(const validation::Record& record) {
  const auto points = validation::turning_points(record.force, 1e-3);
  const std::size_t last = points.size() - 1 - (points.size() - 1) % 2;
  return (record.time[points.at(last)] - record.time[points.at(0)]) / (0.5 * static_cast<double>(last));
}

// 200 samples a period: turning points to half a sample each, over 39 periods or more.
STICKSLIP_VERIFIES(SliderModel, "K2");
TEST(SliderModel, IsTheMotionOfBothPrograms) {
  for (Slider slider : {fast_slider, Slider{.stiffness = 168.0, .speed = 1100e-6}}) {
    slider.moved_mass = 0.8 * slider.mass;
    const FrictionForm form{.excess = 0.03};
    const validation::Values exact = validation::rigid_slider(slider, 0.3, form.excess);
    for (const auto& record : {event_driven_record(slider, form), time_stepped_record(slider, form)}) {
      EXPECT_TRUE(within(period_of(record), exact.at("period"),
                         discretisation(natural_period(slider) / samples / 39, 2, "a sample in 39 periods")));
      const auto [low, high] = std::ranges::minmax(record.force);
      const double range = exact.at("force_range"), half_a_sample = pi / samples;
      EXPECT_TRUE(within(
          high - low, range,
          discretisation(0.5 * range * half_a_sample * half_a_sample, 5, "the cosine of half a sample")));
    }
  }
}

// Friction that falls with the speed, decay over V, and a contact spring in parts of k.
TEST(SliderModel, KeepsTheNaturalPeriod) {
  const double natural = natural_period(fast_slider);
  for (const double decay : {0.03, 0.3, 3.0, 30.0}) {
    const FrictionForm form{.excess = 0.0312, .decay = decay / fast_slider.speed};
    const double events = period_of(event_driven_record(fast_slider, form));
    EXPECT_GT(events, 0.99 * natural);
    EXPECT_NEAR(period_of(time_stepped_record(fast_slider, form)), events, 1e-4 * events);
  }
  for (const double ratio : {0.5, 2.0, 8.0, 20.0})
    EXPECT_GT(
        period_of(time_stepped_record(fast_slider, {.excess = 0.0312,
                                                    .decay = 3.0 / fast_slider.speed,
                                                    .contact_stiffness = ratio * fast_slider.stiffness})),
        0.96 * natural);
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

STICKSLIP_VERIFIES(StripModel, "K2");
TEST(StripModel, HasFrequenciesOfTheFreeTip) {
  const validation::Strip strip;
  const data::Beam beam({.length = strip.length,
                         .area = 0.05 * strip.height,
                         .second_moment_of_area = 0.05 * std::pow(strip.height, 3) / 12.0,
                         .density = strip.density,
                         .youngs_modulus = strip.modulus,
                         .axial_force = 0.0});
  for (const auto& [quantity, hz] : validation::strip_frequencies(strip))
    EXPECT_NEAR(
        analytic::slip_modes(beam, 4).at(static_cast<std::size_t>(quantity.back() - '1')).frequency_hz(), hz,
        1e-9 * hz);
}

TEST(DamperModel, UncertaintyPropagatesToFirstOrder) {
  const auto sum = [](const std::vector<double>& x) {
    return validation::Values{{"s", 3.0 * x[0] - 4.0 * x[1]}};
  };
  const auto result = validation::propagated(sum, {{1.0, 0.1, 0}, {2.0, 0.1, 0}}).at("s");
  EXPECT_DOUBLE_EQ(result.value, -5.0);
  EXPECT_NEAR(result.uncertainty, 0.5, 1e-12);
}

STICKSLIP_VERIFIES(Predictions, "K2");
TEST(Predictions, LatestEntriesAreWhatTheCodeMakes) {
  const auto recorded = validation::recorded_predictions();  // throws where a row has changed
  EXPECT_TRUE(std::ranges::is_sorted(recorded, {}, &validation::Prediction::entry));
  for (const std::string& sentence : validation::unrecorded_predictions())
    ADD_FAILURE() << sentence << ": a new prediction needs a new entry with its reason";
}

STICKSLIP_VERIFIES(MeasuredComparison, "K3");
TEST(MeasuredComparison, FormOfTheComparison) {
  validation::Comparison one;
  one.predicted = 5.0, one.input_uncertainty = 2.0, one.numerical_uncertainty = 6.0;
  one.measured = 1.0, one.measured_uncertainty = 3.0;
  EXPECT_DOUBLE_EQ(one.error(), 4.0);
  EXPECT_DOUBLE_EQ(one.uncertainty(), 7.0);
  EXPECT_FALSE(one.is_resolved());
  EXPECT_TRUE(one.contains_zero());
  one.predicted = 11.0;
  EXPECT_TRUE(one.is_resolved());
  EXPECT_TRUE(one.contains_zero());
  one.predicted = 16.0;
  EXPECT_FALSE(one.contains_zero());
}

// The fall times of the three records of calibration had been read, too.
TEST(MeasuredComparison, BlindIsWhatWasPredictedBefore) {
  std::map<std::string, std::size_t> blind;
  for (const auto& bias : validation::biases(validation::comparisons())) {
    if (bias.blind) blind[bias.experiment] += bias.points;
    EXPECT_EQ(bias.resolved > 0, bias.resolved_mean != 0.0);
    EXPECT_LE(bias.within, bias.required > 0.0 ? bias.points : 0u) << bias.quantity;
  }
  EXPECT_EQ(blind, (std::map<std::string, std::size_t>{{"friction-damper", 30}, {"paper-slider", 30}}));
}

TEST(MeasuredComparison, NoSetPointIsLeftOut) {
  const auto all = validation::comparisons();
  for (const auto& point : validation::set_points()) {
    const auto rows = std::ranges::count_if(all, [&](const auto& one) { return one.record == point.record; });
    const std::map<std::string, int> predicted{{"paper-slider", 10}, {"friction-damper", 4}, {"strip", 7}};
    const int calibration = point.experiment == "paper-slider" ? 1 : 0;
    EXPECT_EQ(rows, point.role == "calibration" ? calibration : predicted.at(point.experiment))
        << point.record;
  }
}

// Two estimators that share nothing, the cycles between turning points and the autocorrelation, against 2 pi sqrt(m/k) with
// 5 % for k: the published mass and stiffness are refuted at 4300 um/s, the moved mass of the slip at 42 um/s is not.
TEST(MeasuredComparison, HasPeriodsBelowASprings) {
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
    if (one.quantity != "period" || one.form != "lighter") continue;
    EXPECT_TRUE(one.contains_zero()) << one.record;
  }
}

// The raw records are not part of the project: only files with the digests of the table are read.
TEST(MeasuredComparison, HasTheDigestOfEachRecord) {
  const auto table = validation::measured_figures();
  const auto points = validation::set_points();
  for (const auto& point : points) {
    EXPECT_EQ(point.sha256.size(), 64U);
    const auto first = table.lower_bound({point.record, ""});
    EXPECT_TRUE(first != table.end() && first->first.first == point.record) << point.record;
  }
  const InputFolder folder;
  const auto refusal = [&] {
    return folder.error_message([&] { (void)validation::raw_figures(folder.path()); });
  };
  EXPECT_TRUE(holds(refusal(), "holds no folder of an experiment"));
  std::filesystem::create_directories((folder.path() / points.front().file).parent_path());
  folder.write(points.front().file, "another file");
  EXPECT_TRUE(holds(refusal(), "is not the file that records.csv has the digest of"));
  EXPECT_EQ(points.front().experiment, "paper-slider");
  EXPECT_EQ(validation::experiments_without_records(folder.path()),
            (std::vector<std::string>{"friction-damper", "strip"}));
}

STICKSLIP_VERIFIES(ProposedRig, "K3");
TEST(ProposedRig, TellsTheDirectionOfTheForce) {
  const studies::ProposedRig rig = studies::proposed_rig("rig");
  const std::vector accuracies{0.0073, 0.015, 0.032, 0.050, 0.072};  // of theory.md, Sect. 17 (a), at 0.3 m
  for (std::size_t i = 0; i < accuracies.size(); ++i)
    EXPECT_NEAR(rig.frequencies.at(i).accuracy, accuracies[i], 0.03 * accuracies[i]);
  EXPECT_NEAR(rig.frequencies.at(4).held, 31e-3, 0.5e-3);  // at 4 N
  const std::vector amplitudes{7.84e-3, 4.05e-3, 2.34e-3, 1.08e-3,
                               0.52e-3, 0.19e-3, 0.21e-3, 0.18e-3};  // (b)
  for (std::size_t i = 0; i < amplitudes.size(); ++i)
    EXPECT_NEAR(rig.onsets.at(i).critical_amplitude, amplitudes[i], 5.1e-6);
  EXPECT_NEAR(rig.onsets.at(0).critical_amplitude / rig.onsets.at(4).critical_amplitude, 15.0, 0.5);
}

}  // namespace
}  // namespace stickslip::testing
