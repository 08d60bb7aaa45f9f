// SPDX-License-Identifier: MIT
/// The edges of what the readers take: magnitudes, sizes, units, characters and names that are nearly right.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/units.hpp"
#include "support/input_folder.hpp"
#include "support/requirements.hpp"

namespace stickslip::testing {
namespace {

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
  struct Spelling {
    std::string name, si;
    double value;
  };
  for (const auto& [name, si, value] : std::vector<Spelling>{{"Hz", "Hz", 1.0},
                                                             {"rad/s", "Hz", 0.5 / std::numbers::pi},
                                                             {"cm^2", "m^2", 1e-4},
                                                             {"mm^2", "m^2", 1e-6},
                                                             {"cm^4", "m^4", 1e-8},
                                                             {"mm^4", "m^4", 1e-12},
                                                             {"kN/m", "N/m", 1e3},
                                                             {"N/mm", "N/m", 1e3},
                                                             {"m/s", "m/s", 1.0},
                                                             {"cm/s", "m/s", 1e-2},
                                                             {"mm/s", "m/s", 1e-3},
                                                             {"m_per_s", "m/s", 1.0},
                                                             {"mm_per_s", "m/s", 1e-3},
                                                             {"m/s^2", "m/s^2", 1.0},
                                                             {"m/s\u00b2", "m/s^2", 1.0},
                                                             {"g/cm\u00b3", "kg/m^3", 1e3},
                                                             {"mm\u2074", "m^4", 1e-12},
                                                             {"mm/s^2", "m/s^2", 1e-3},
                                                             {"Pa", "Pa", 1.0},
                                                             {"kPa", "Pa", 1e3},
                                                             {"MPa", "Pa", 1e6},
                                                             {"GPa", "Pa", 1e9},
                                                             {"rad", "rad", 1.0},
                                                             {"deg", "rad", std::numbers::pi / 180.0},
                                                             {"\u00b0", "rad", std::numbers::pi / 180.0},
                                                             {"J", "J", 1.0},
                                                             {"mJ", "J", 1e-3},
                                                             {"kg/m3", "kg/m^3", 1.0},
                                                             {"mm4", "m^4", 1e-12},
                                                             {"N/mm^2", "Pa", 1e6},
                                                             {"N/mm2", "Pa", 1e6},
                                                             {"1/s", "Hz", 1.0},
                                                             {"%", "", 1e-2}}) {
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
                                            "\ud7ff", "\ue000", "\uffff", "\U00010000", "\U0010ffff"};
  for (const std::string& character : characters)
    EXPECT_EQ(data::printable("a" + character + "b"), "a" + character + "b");
  for (const std::string control : {"\x01", "\x1f", "\x7f", "\xc2\x80", "\xc2\x9f", "\t", "\n"})
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
