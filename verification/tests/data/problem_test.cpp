// SPDX-License-Identifier: MIT
/// The problem types: what they accept, what they refuse, and in which words.

#include "stickslip/data/problem.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/units.hpp"
#include "support/input_folder.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
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

// --- The edges of what the readers take: magnitudes, sizes, units, characters and names that are nearly right.

STICKSLIP_VERIFIES(InputLimits, "P1");
TEST(InputLimits, OfEachKeyAreAllowedThemselves) {
  struct Limits {
    std::string key;
    double smallest, largest;
  };
  for (const auto& [key, smallest, largest] :
       std::vector<Limits>{{"beam.length", 1e-9, 1e6},
                           {"beam.area", 1e-18, 1e12},
                           {"beam.second_moment_of_area", 1e-36, 1e24},
                           {"beam.density", 1e-6, 1e9},
                           {"beam.youngs_modulus", 1e-3, 1e18},
                           {"beam.axial_force", 1e-18, 1e18},
                           {"beam.axial_direction", 1e-9, 1.0},
                           {"beam.shear_stiffness", 1e-18, 1e24},
                           {"friction.static_coefficient", 1e-9, 1e6},
                           {"friction.kinetic_coefficient", 1e-9, 1e6},
                           {"friction.decay", 1e-15, 1e15},
                           {"friction.viscous", 1e-15, 1e15},
                           {"excitation.frequency_hz", 1e-9, 1e12},
                           {"excitation.amplitude", 1e-18, 1e6},
                           {"numerics.time_step", 1e-15, 1e9},
                           {"numerics.velocity_threshold", 1e-18, 1e9},
                           {"excitation.duration", 1e-15, 1e15},
                           {"damping.kelvin_voigt", 1e-18, 1e6},
                           {"damping.ratio", 1e-9, 1.0},
                           {"contact.tangential_stiffness", 1e-18, 1e24},
                           {"contact.regularisation_velocity", 1e-18, 1e9},
                           {"wall.speed", 1e-15, 1e9}}) {
    for (const double value : {smallest, largest, -smallest, -largest, 0.0})
      EXPECT_NO_THROW(data::require_magnitude(key, value, "--x")) << key;
    const double below = std::nextafter(smallest, 0.0), above = std::nextafter(largest, 1e300);
    for (const double value : {below, above, -below, -above})
      EXPECT_THROW(data::require_magnitude(key, value, "--x"), data::InputError) << key;
  }
}

TEST(InputLimits, MayHaveAsManyBytesAsAreAllowed) {
  const InputFolder folder;
  const auto file = folder.write("x", std::string(100'000, 'x'));
  EXPECT_EQ(data::read_bounded(file, 100'000).size(), 100'000u);
  EXPECT_EQ(data::read_bounded(file, 100'001).size(), 100'000u);
  EXPECT_THROW((void)data::read_bounded(file, 99'999), data::InputError);
}

TEST(InputLimits, HasTheUnitsOfEveryQuantity) {
  constexpr double pi = std::numbers::pi;
  using Units = std::vector<std::pair<std::string, double>>;
  for (const auto& [si, units] : std::vector<std::pair<std::string, Units>>{
           {"Hz", {{"Hz", 1.0}, {"mHz", 1e-3}, {"kHz", 1e3}, {"MHz", 1e6}, {"1/s", 1.0}}},
           {"Hz", {{"rad/s", 0.5 / pi}, {"rad_per_s", 0.5 / pi}}},
           {"s", {{"s", 1.0}, {"ms", 1e-3}, {"us", 1e-6}, {"\u00b5s", 1e-6}, {"ns", 1e-9}}},
           {"m", {{"m", 1.0}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}, {"nm", 1e-9}}},
           {"m", {{"\u00b5m", 1e-6}, {"\u03bcm", 1e-6}}},
           {"m^2", {{"cm^2", 1e-4}, {"mm^2", 1e-6}}},
           {"m^4", {{"cm^4", 1e-8}, {"mm^4", 1e-12}, {"mm4", 1e-12}, {"mm\u2074", 1e-12}}},
           {"kg/m^3", {{"kg/m3", 1.0}, {"g/cm\u00b3", 1e3}}},
           {"N", {{"N", 1.0}, {"mN", 1e-3}, {"kN", 1e3}, {"MN", 1e6}}},
           {"N/m", {{"kN/m", 1e3}, {"N/mm", 1e3}}},
           {"m/s", {{"m/s", 1.0}, {"cm/s", 1e-2}, {"mm/s", 1e-3}, {"m_per_s", 1.0}, {"mm_per_s", 1e-3}}},
           {"m/s^2", {{"m/s^2", 1.0}, {"m/s\u00b2", 1.0}, {"mm/s^2", 1e-3}}},
           {"Pa", {{"Pa", 1.0}, {"kPa", 1e3}, {"MPa", 1e6}, {"GPa", 1e9}, {"N/mm^2", 1e6}, {"N/mm2", 1e6}}},
           {"rad", {{"rad", 1.0}, {"deg", pi / 180.0}, {"\u00b0", pi / 180.0}}},
           {"J", {{"J", 1.0}, {"mJ", 1e-3}}},
           {"", {{"1", 1.0}, {"-", 1.0}, {"%", 1e-2}}}})
    for (const auto& [name, value] : units) {
      const auto unit = data::unit_named(name);
      ASSERT_TRUE(unit.has_value()) << name;
      EXPECT_EQ(unit->si, si) << name;
      EXPECT_DOUBLE_EQ(unit->to_si(1.0), value) << name;
    }
  EXPECT_FALSE(data::unit_named("hz").has_value());
  EXPECT_EQ(data::units_convertible_to("m/s"), "m/s, cm/s, mm/s");
  EXPECT_EQ(data::units_convertible_to("J"), "J, mJ");
  EXPECT_EQ(data::units_convertible_to("N/m"), "N/m, kN/m, MN/m, N/mm");
  EXPECT_EQ(data::units_convertible_to("kg"), "kg");
}

TEST(InputLimits, MayHaveASignBeforeAFiniteNumber) {
  EXPECT_EQ(data::finite_number("+2.5"), 2.5);
  EXPECT_EQ(data::finite_number("-2.5"), -2.5);
  EXPECT_EQ(data::finite_number("0"), 0.0);
  EXPECT_EQ(data::finite_number("1.7976931348623157e308"), std::numeric_limits<double>::max());
  for (const std::string text :
       {"", "+", "++1", "+-1", "-+1", "1 ", " 1", "1e", "inf", "nan", "1e309", "0x1p1x"})
    EXPECT_FALSE(data::finite_number(text).has_value()) << text;
}

TEST(InputLimits, IsShownInMessagesCharacterByCharacter) {
  const std::vector<std::string> characters{" ",      "~",      "\u00a0", "\u07ff",     "\u0800",
                                            "\ud7ff", "\ue000", "\ufffd", "\U00010000", "\U0010ffff"};
  for (const std::string& character : characters)
    EXPECT_EQ(data::printable("a" + character + "b"), "a" + character + "b");
  for (const std::string control :
       {"\x01", "\x1f", "\x7f", "\xc2\x80", "\xc2\x9f", "\t", "\n", "\ufffe", "\uffff"})
    EXPECT_EQ(data::printable("a" + control + "b"), "a?b");
  // Overlong forms, surrogates, what lies beyond U+10FFFF, and what is cut off: a mark for each byte.
  for (const std::string none :
       {"\x80", "\xbf", "\xc0\x80", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xf0\x8f\xbf\xbf",
        "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xc2", "\xe1\x80", "\xf1\x80\x80", "\xe1\x80z"}) {
    std::string expected = "a";
    for (const char byte : none) expected += byte == 'z' ? 'z' : '?';
    EXPECT_EQ(data::printable("a" + none), expected);
  }
}

TEST(InputLimits, IsCutOffInMessagesWhereItIsTooLong) {
  EXPECT_EQ(data::printable("abcdef", 6), "abcdef");
  EXPECT_EQ(data::printable("abcdefg", 6), "abcdef...");
  EXPECT_EQ(data::printable("abcde\u00e9", 7), "abcde\u00e9");
  EXPECT_EQ(data::printable("abcde\u00e9", 6), "abcde...");  // no half of a character
  EXPECT_EQ(data::printable(std::string(60, 'a')), std::string(60, 'a'));
  EXPECT_EQ(data::printable(std::string(61, 'a')), std::string(60, 'a').append("..."));
}

TEST(InputLimits, SuggestsNamesOfWhichAThirdDiffers) {
  const auto is_near = [](const std::string& word, const std::string& name) {
    return !data::suggestion(word, {name}).empty();
  };
  EXPECT_TRUE(is_near("abcdef", "abcdef"));
  EXPECT_TRUE(is_near("abcdxy", "abcdef"));   // two of six replaced
  EXPECT_FALSE(is_near("abcxyz", "abcdef"));  // three of six
  EXPECT_TRUE(is_near("abcd", "abcdef"));     // two of six left out
  EXPECT_FALSE(is_near("abc", "abcdef"));
  EXPECT_TRUE(is_near("abcdefgh", "abcdef"));  // two of eight too many
  EXPECT_FALSE(is_near("abcdefghij", "abcdef"));
  EXPECT_TRUE(is_near("bacdfe", "abcdef"));  // two pairs exchanged
  EXPECT_FALSE(is_near("bacdfx", "badecf"));
  EXPECT_FALSE(is_near("ba", "abc"));  // an exchange and a letter, of three
  EXPECT_TRUE(is_near("bac", "abc"));
  EXPECT_EQ(data::suggestion("xbc", {"abcx", "abc", "ab"}), " (did you mean abc?)");
  EXPECT_EQ(data::suggestion("abc", {}), "");
  EXPECT_TRUE(is_near(std::string(100, 'a'), std::string(99, 'a')));
  EXPECT_FALSE(is_near(std::string(101, 'a'), std::string(100, 'a')));  // nothing is as long
}

}  // namespace
}  // namespace stickslip::testing
