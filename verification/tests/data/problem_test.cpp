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

// A field with a value, and the beginning of what must be there instead; nothing if it is accepted.
struct Row {
  Field field;
  double value;
  std::string allowed{};
};

STICKSLIP_VERIFIES(ProblemTypes, "P1");
// input_matrix_test.cpp has every key of a case with every defect.
TEST(ProblemTypes, TakeWhatIsAllowedAndRefuseTheRest) {
  const auto beam = [](const std::string& name, double data::BeamProperties::*member) {
    return field<data::Beam>("beam." + name, testing::paper_beam_properties(), member);
  };
  const auto friction = [](const std::string& name, double data::FrictionCoefficients::*member) {
    return field<data::FrictionLaw>("friction." + name, data::FrictionCoefficients{0.6, 0.3, 1.0}, member);
  };
  const auto numerics = [](const std::string& name, double data::NumericalChoices::*member) {
    return field<data::NumericalSettings>(name, testing::paper_choices(10.0), member);
  };
  const Field length = beam("length", &data::BeamProperties::length),
              force = beam("axial_force", &data::BeamProperties::axial_force),
              direction = beam("axial_direction", &data::BeamProperties::axial_direction),
              shear = beam("shear_stiffness", &data::BeamProperties::shear_stiffness),
              kinetic = friction("kinetic_coefficient", &data::FrictionCoefficients::kinetic_coefficient),
              decay = friction("decay", &data::FrictionCoefficients::decay),
              amplitude = field<data::HarmonicExcitation>(
                  "excitation.amplitude", data::HarmonicMotion{25.0, 1e-3}, &data::HarmonicMotion::amplitude),
              step = numerics("numerics.time_step", &data::NumericalChoices::time_step),
              radius = numerics("numerics.spectral_radius", &data::NumericalChoices::spectral_radius),
              threshold =
                  numerics("numerics.velocity_threshold", &data::NumericalChoices::velocity_threshold),
              duration = numerics("excitation.duration", &data::NumericalChoices::duration),
              ratio = field<data::Damping>("damping.ratio", {}, &data::DampingProperties::ratio);
  const std::string positive = "a finite number above 0", not_negative = "a finite number of 0 or more",
                    from_0_to_1 = "a number from 0 to 1", below_1 = "a number from 0 to below 1",
                    jump = "a number of 0 or more (s/m), or inf for a jump",
                    either = "a number from 0 (follows the tip) to 1 (keeps its direction)";
  for (const auto& [tried, value, allowed] :
       std::vector<Row>{{length, -2.5, positive},
                        {length, 0.0, positive},
                        {length, nan, positive},
                        {length, 1e-300},
                        {length, 1e300},
                        {force, infinity, "a finite number (N, compression positive)"},
                        {force, -500.0},
                        {force, 0.0},
                        {force, 1e9},
                        {direction, -0.1, either},
                        {direction, 1.5, either},
                        {direction, nan, either},
                        {direction, 0.0},
                        {direction, 0.3},
                        {direction, 1.0},
                        {shear, -1e-300, not_negative},
                        {shear, infinity, not_negative},
                        {kinetic, -1e-300, not_negative},
                        {kinetic, 0.0},
                        {kinetic, 0.6},
                        {kinetic, 0.7, "at most friction.static_coefficient, which is 0.6"},
                        {decay, -1e-300, jump},
                        {decay, nan, jump},
                        {decay, -infinity, jump},
                        {decay, infinity},
                        {amplitude, -1e-300, not_negative},
                        {amplitude, 0.0},
                        {step, 0.0, positive},
                        {radius, -1e-9, from_0_to_1},
                        {radius, 0.0},
                        {radius, 1.0},
                        {radius, 1.0 + 1e-9, from_0_to_1},
                        {radius, nan, from_0_to_1},
                        {threshold, 0.0},
                        {threshold, -1e-300, not_negative},
                        {duration, 1e-4},
                        {duration, 1e5},
                        {duration, 0.5e-4, "at least numerics.time_step, which is 1e-04"},
                        {duration, 1.1e5, "at most a billion times numerics.time_step, which is 1e-04"},
                        {ratio, 0.0},
                        {ratio, std::nextafter(1.0, 0.0)},
                        {ratio, 1.0, below_1},
                        {ratio, -1e-300, below_1},
                        {ratio, nan, below_1},
                        {ratio, infinity, below_1}}) {
    const std::string sentence = error_message(tried, value);
    EXPECT_TRUE(allowed.empty() ? sentence == "accepted"
                                : sentence.starts_with(tried.name + " is " + data::shortest_text(value) +
                                                       ", but must be " + allowed))
        << tried.name << " " << value << ": " << sentence;
  }
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

TEST(ProblemTypes, BoundTheNumbersOfElementsAndModes) {
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
