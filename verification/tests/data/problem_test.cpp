// SPDX-License-Identifier: MIT
/// The problem types: what they accept, what they refuse, and in which words.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "stickslip/data/problem.hpp"
#include "support/beams.hpp"
#include "support/requirements.hpp"

namespace stickslip {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// Builds a problem type with one field replaced.
struct Field {
  std::string name;
  std::function<void(double)> build_with;
};

template <class Type, class Properties>
Field field(std::string name, Properties valid, double Properties::*member) {
  return {std::move(name), [valid, member](double value) mutable {
            valid.*member = value;
            static_cast<void>(Type(valid));
          }};
}

Field beam_field(const std::string& name, double data::BeamProperties::*member) {
  return field<data::Beam>("beam." + name, testing::paper_beam_properties(), member);
}

Field friction_field(const std::string& name, double data::FrictionCoefficients::*member) {
  const data::FrictionCoefficients valid{.static_coefficient = 0.6, .kinetic_coefficient = 0.3, .decay = 1.0};
  return field<data::FrictionLaw>("friction." + name, valid, member);
}

Field excitation_field(const std::string& name, double data::HarmonicMotion::*member) {
  const data::HarmonicMotion valid{.frequency_hz = 25.0, .amplitude = 0.5e-3};
  return field<data::HarmonicExcitation>("excitation." + name, valid, member);
}

Field numerics_field(const std::string& name, double data::NumericalChoices::*member) {
  const std::string table = name == "duration" ? "excitation." : "numerics.";  // where a case file has it
  return field<data::NumericalSettings>(table + name, testing::paper_choices(10.0), member);
}

Field damping_field(const std::string& name, double data::DampingProperties::*member) {
  return field<data::Damping>("damping." + name, data::DampingProperties{}, member);
}

std::vector<Field> positive_fields() {
  return {beam_field("length", &data::BeamProperties::length),
          beam_field("area", &data::BeamProperties::area),
          beam_field("second_moment_of_area", &data::BeamProperties::second_moment_of_area),
          beam_field("density", &data::BeamProperties::density),
          beam_field("youngs_modulus", &data::BeamProperties::youngs_modulus),
          excitation_field("frequency_hz", &data::HarmonicMotion::frequency_hz),
          numerics_field("time_step", &data::NumericalChoices::time_step),
          numerics_field("duration", &data::NumericalChoices::duration)};
}

std::vector<Field> non_negative_fields() {
  return {friction_field("static_coefficient", &data::FrictionCoefficients::static_coefficient),
          friction_field("kinetic_coefficient", &data::FrictionCoefficients::kinetic_coefficient),
          friction_field("decay", &data::FrictionCoefficients::decay),
          friction_field("viscous", &data::FrictionCoefficients::viscous),
          excitation_field("amplitude", &data::HarmonicMotion::amplitude),
          numerics_field("velocity_threshold", &data::NumericalChoices::velocity_threshold),
          damping_field("kelvin_voigt", &data::DampingProperties::kelvin_voigt),
          beam_field("shear_stiffness", &data::BeamProperties::shear_stiffness)};
}

// The sentence of the error, or "accepted".
std::string error_message(const Field& field, double value) {
  try {
    field.build_with(value);
  } catch (const data::FieldError& error) {
    EXPECT_EQ(error.field(), field.name);
    return error.what();
  }
  return "accepted";
}

void expect_refused(const Field& field, double value, const std::string& text, const std::string& allowed) {
  EXPECT_TRUE(
      error_message(field, value).starts_with(field.name + " is " + text + ", but must be " + allowed))
      << error_message(field, value);
}

STICKSLIP_VERIFIES(ProblemTypes, "P1");
TEST(ProblemTypes, RefuseADirectionOutsideZeroToOne) {
  const Field direction = beam_field("axial_direction", &data::BeamProperties::axial_direction);
  const std::string allowed = "a number from 0 (follows the tip) to 1 (keeps its direction)";
  expect_refused(direction, -0.1, "-0.1", allowed);
  expect_refused(direction, 1.5, "1.5", allowed);
  expect_refused(direction, std::nan(""), "nan", allowed);
  for (const double value : {0.0, 0.3, 1.0}) EXPECT_EQ(error_message(direction, value), "accepted");
}

TEST(ProblemTypes, RefuseWhatIsNotPositiveWhereItMustBe) {
  for (const auto& field : positive_fields()) {
    expect_refused(field, -2.5, "-2.5", "a finite number above 0");
    expect_refused(field, 0.0, "0", "a finite number above 0");
  }
}

TEST(ProblemTypes, RefuseWhatIsNegativeWhereItMustNotBe) {
  for (const auto& field : non_negative_fields())
    expect_refused(field, -1e-300, "-1e-300",
                   field.name == "friction.decay" ? "a number of 0 or more" : "a finite number of 0 or more");
}

TEST(ProblemTypes, AcceptZeroWhereItHasAMeaning) {
  EXPECT_NO_THROW(data::FrictionLaw({.static_coefficient = 0.0, .kinetic_coefficient = 0.0, .decay = 0.0}));
  EXPECT_NO_THROW(data::HarmonicExcitation({.frequency_hz = 25.0, .amplitude = 0.0}));
  EXPECT_EQ(
      error_message(numerics_field("velocity_threshold", &data::NumericalChoices::velocity_threshold), 0.0),
      "accepted");
}

TEST(ProblemTypes, RefuseNotANumberAndInfinityEverywhere) {
  auto fields = positive_fields();
  for (const auto& field : non_negative_fields()) fields.push_back(field);
  fields.push_back(beam_field("axial_force", &data::BeamProperties::axial_force));
  for (const auto& field : fields) {
    const bool may_jump = field.name == "friction.decay";
    const std::string allowed =
        may_jump ? "a number of 0 or more (s/m), or inf for a jump" : "a finite number";
    expect_refused(field, nan, "nan", allowed);
    if (!may_jump) expect_refused(field, infinity, "inf", allowed);
    expect_refused(field, -infinity, "-inf", allowed);
  }
}

TEST(ProblemTypes, SayTheUnitOfWhatMustBeFinite) {
  EXPECT_EQ(error_message(beam_field("axial_force", &data::BeamProperties::axial_force), infinity),
            "beam.axial_force is inf, but must be a finite number (N, compression positive)");
}

TEST(ProblemTypes, RefuseAJumpOfFrictionUnlessTheContactIsRigid) {
  const data::FrictionLaw jump(
      {.static_coefficient = 0.3, .kinetic_coefficient = 0.2, .decay = infinity, .viscous = 0.1});
  const Field friction{"friction.decay", [&](double stiffness) {
                         require_usable(jump, data::TangentialContact({.tangential_stiffness = stiffness}));
                       }};
  const Field smooth{"friction.decay", [&](double velocity) {
                       require_usable(jump, data::TangentialContact({.regularisation_velocity = velocity}));
                     }};
  EXPECT_EQ(error_message(friction, infinity), "accepted");
  EXPECT_EQ(
      error_message(friction, 1e6),
      "friction.decay is inf, but must be finite (s/m) with contact.tangential_stiffness: a contact that "
      "moves at rest would never feel friction.static_coefficient");
  EXPECT_EQ(error_message(smooth, 0.01),
            "friction.decay is inf, but must be finite (s/m) with contact.regularisation_velocity: a contact "
            "that moves at rest would never feel friction.static_coefficient");
  EXPECT_EQ(jump.in_slip().static_coefficient(), 0.2);
  EXPECT_EQ(jump.in_slip().viscous(), 0.1);
}

TEST(ProblemTypes, AcceptAnyMagnitudeSinceTheyKnowNoUnits) {
  for (auto fields : {positive_fields(), non_negative_fields()})
    for (const auto& field : fields)
      for (const double value : {1e-300, 1e300}) {
        const bool depends_on_another =
            field.name == "friction.static_coefficient" || field.name == "friction.kinetic_coefficient" ||
            field.name == "numerics.time_step" || field.name == "excitation.duration";
        if (depends_on_another) continue;
        EXPECT_EQ(error_message(field, value), "accepted") << field.name;
      }
}

STICKSLIP_VERIFIES(NumericalSettings, "P1");
TEST(NumericalSettings, RefuseADurationOfMoreThanABillionSteps) {
  const auto duration = numerics_field("duration", &data::NumericalChoices::duration);
  EXPECT_EQ(error_message(duration, 1e5), "accepted");
  expect_refused(duration, 1.1e5, "110000", "at most a billion times numerics.time_step, which is 1e-04");
}

STICKSLIP_VERIFIES(Beam, "P1");
TEST(Beam, AcceptsAnyFiniteAxialForce) {
  for (const double force : {-500.0, 0.0, 1e9})
    EXPECT_EQ(testing::paper_beam_with_axial_force(force).axial_force(), force);
}

STICKSLIP_VERIFIES(FrictionLaw, "P2");
TEST(FrictionLaw, RefusesAKineticAboveTheStaticCoefficient) {
  EXPECT_NO_THROW(data::FrictionLaw({.static_coefficient = 0.3, .kinetic_coefficient = 0.3, .decay = 0.0}));
  expect_refused(friction_field("kinetic_coefficient", &data::FrictionCoefficients::kinetic_coefficient), 0.7,
                 "0.7", "at most friction.static_coefficient, which is 0.6");
}

STICKSLIP_VERIFIES(Damping, "P1");
TEST(Damping, IsNoneByDefaultAndHasARatioBelowCritical) {
  EXPECT_EQ(data::Damping().kelvin_voigt(), 0.0);
  EXPECT_EQ(data::Damping().ratio(), 0.0);
  const auto ratio = damping_field("ratio", &data::DampingProperties::ratio);
  EXPECT_EQ(error_message(ratio, 0.0), "accepted");
  EXPECT_EQ(error_message(ratio, std::nextafter(1.0, 0.0)), "accepted");
  for (const auto& [value, text] :
       {std::pair{1.0, "1"}, {-1e-300, "-1e-300"}, {nan, "nan"}, {infinity, "inf"}})
    expect_refused(ratio, value, text, "a number from 0 to below 1");
}

TEST(NumericalSettings, BoundTheSpectralRadiusByZeroAndOne) {
  const auto radius = numerics_field("spectral_radius", &data::NumericalChoices::spectral_radius);
  EXPECT_EQ(error_message(radius, 0.0), "accepted");
  EXPECT_EQ(error_message(radius, 1.0), "accepted");
  for (const double value : {-1e-9, 1.0 + 1e-9, nan}) EXPECT_NE(error_message(radius, value), "accepted");
  expect_refused(radius, 1.5, "1.5", "a number from 0 to 1");
}

TEST(NumericalSettings, RefuseADurationShorterThanOneStep) {
  const auto duration = numerics_field("duration", &data::NumericalChoices::duration);
  EXPECT_EQ(error_message(duration, 1e-4), "accepted");
  expect_refused(duration, 0.5e-4, "5e-05", "at least numerics.time_step, which is 1e-04");
}

TEST(NumericalSettings, BoundTheNumbersOfElementsAndModes) {
  struct Count {
    std::string name;
    int data::NumericalChoices::*member;
    int most;
  };
  for (const auto& [name, member, most] : {Count{"elements", &data::NumericalChoices::elements, 100000},
                                           Count{"modes", &data::NumericalChoices::modes, 200}}) {
    const Field field{"numerics." + name, [member = member](double value) {
                        auto choices = testing::paper_choices(10.0);
                        choices.*member = static_cast<int>(value);
                        static_cast<void>(data::NumericalSettings(choices));
                      }};
    for (const int accepted : {1, most}) EXPECT_EQ(error_message(field, accepted), "accepted") << name;
    for (const int refused : {0, most + 1})
      EXPECT_EQ(error_message(field, refused), field.name + " is " + std::to_string(refused) +
                                                   ", but must be an integer from 1 to " +
                                                   std::to_string(most));
  }
}

STICKSLIP_VERIFIES(ShortestText, "P1");
TEST(ShortestText, ReadsBackAsTheSameDouble) {
  EXPECT_EQ(data::shortest_text(0.1), "0.1");
  EXPECT_EQ(data::shortest_text(-2.0), "-2");
  for (const double value : {1.0 / 3.0, 1e-4 / 12.0, 5e-324, 1.7976931348623157e308})
    EXPECT_EQ(std::strtod(data::shortest_text(value).c_str(), nullptr), value);
}

}  // namespace
}  // namespace stickslip
