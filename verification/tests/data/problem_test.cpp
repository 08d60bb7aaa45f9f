// SPDX-License-Identifier: MIT
/// The limits of every key, and the edges of what the readers take: sizes, units, characters and names that are nearly right.

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/units.hpp"
#include "support/input_folder.hpp"
#include "support/random_beams.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Interval {
  double low, high;
  bool has_low{}, has_high{};

  [[nodiscard]] bool contains(double x) const {
    return (low < x || (has_low && low == x)) && (x < high || (has_high && x == high));
  }
};
constexpr Interval finite{-infinity, infinity}, positive{0.0, infinity}, not_negative{0.0, infinity, true};

// What a key may be: the magnitudes in a file of what is not 0, and the numbers of a case, here those that fit the others of
// case_for().
struct Rule {
  std::string path, unit;
  double smallest, largest;
  Interval allowed;

  [[nodiscard]] bool has_magnitude(double x) const {
    const double magnitude = std::abs(x);
    return x == 0.0 || !std::isfinite(x) || (smallest <= magnitude && magnitude <= largest);
  }
  [[nodiscard]] bool is_of_the_section() const {
    return path.starts_with("section.") || path == "beam.poissons_ratio";
  }
};

const std::vector<Rule> rules{
    {"beam.length", "m", 1e-9, 1e6, positive},
    {"beam.area", "m^2", 1e-18, 1e12, positive},
    {"beam.second_moment_of_area", "m^4", 1e-36, 1e24, positive},
    {"beam.density", "kg/m^3", 1e-6, 1e9, positive},
    {"beam.youngs_modulus", "Pa", 1e-3, 1e18, positive},
    {"beam.axial_force", "N", 1e-18, 1e18, finite},
    {"beam.axial_direction", "", 1e-9, 1.0, {0.0, 1.0, true, true}},
    {"beam.shear_stiffness", "N", 1e-18, 1e24, not_negative},
    {"beam.poissons_ratio", "", 1e-9, 1.0, {-1.0, 0.5}},
    {"model.mass", "kg", 1e-18, 1e18, positive},
    {"model.stiffness", "N/m", 1e-18, 1e24, not_negative},
    {"model.damping", "N s/m", 1e-18, 1e24, not_negative},
    {"model.normal_force", "N", 1e-18, 1e18, positive},
    {"friction.static_coefficient", "", 1e-9, 1e6, not_negative},
    {"friction.kinetic_coefficient", "", 1e-9, 1e6, {0.0, 0.6, true, true}},  // the static one
    {"friction.decay", "s/m", 1e-15, 1e15, {0.0, infinity, true, true}},
    {"friction.viscous", "s/m", 1e-15, 1e15, not_negative},
    {"excitation.frequency_hz", "Hz", 1e-9, 1e12, positive},
    {"excitation.amplitude", "m", 1e-18, 1e6, not_negative},
    {"excitation.velocity_amplitude", "m/s", 1e-18, 1e18, not_negative},
    {"excitation.acceleration_amplitude", "m/s^2", 1e-18, 1e18, not_negative},
    {"excitation.force", "N", 1e-18, 1e18, not_negative},
    {"excitation.scale", "", 1e-9, 1e9, not_negative},
    {"excitation.constant_force", "N", 1e-18, 1e18, finite},
    {"excitation.duration", "s", 1e-15, 1e15, {1e-4, 1e5, true, true}},  // 1 to 1e9 time steps
    {"numerics.elements", "", 0.0, infinity, {1.0, 100000.0, true, true}},
    {"numerics.time_step", "s", 1e-15, 1e9, {1e-8, 10.0, true, true}},  // 1e-9 to 1 of the duration
    {"numerics.spectral_radius", "", 0.0, infinity, {0.0, 1.0, true, true}},
    {"numerics.velocity_threshold", "m/s", 1e-18, 1e9, not_negative},
    {"numerics.modes", "", 0.0, infinity, {1.0, 200.0, true, true}},
    {"numerics.duration", "s", 1e-15, 1e15, {}},
    {"damping.kelvin_voigt", "s", 1e-18, 1e6, not_negative},
    {"damping.ratio", "", 1e-9, 1.0, {0.0, 1.0, true, false}},
    {"damping.mass_proportional", "1/s", 1e-18, 1e9, not_negative},
    {"contact.tangential_stiffness", "N/m", 1e-18, 1e24, {0.0, infinity, false, true}},
    {"contact.regularisation_velocity", "m/s", 1e-18, 1e9, not_negative},
    {"wall.speed", "m/s", 1e-15, 1e9, finite},
    {"wall.scale", "", 1e-9, 1e9, not_negative},
    {"initial.position", "m", 1e-18, 1e6, finite},
    {"initial.velocity", "m/s", 1e-18, 1e9, finite},
    {"section.width", "m", 1e-9, 1e6, positive},
    {"section.height", "m", 1e-9, 1e6, positive},
    {"section.diameter", "m", 1e-9, 1e6, positive},
    {"section.wall_thickness", "m", 1e-9, 1e6, {0.0, 0.05, false, true}}};  // half of the diameter

// A case that has a number at the key.
data::Case case_for(const std::string& path) {
  const std::string common =
      "[friction]\nstatic_coefficient = 0.6\nkinetic_coefficient = 0.3\n[excitation]\n"
      "frequency_hz = 25\namplitude = 1e-3\n[numerics]\ntime_step = 1e-4\n" +
      std::string(path == "wall.scale" ? "[wall]\nsines = [[20, 1e-3]]\n" : "");
  if (!data::key_named(path).is_of(data::StructureKind::beam))
    return data::parse_case("base.toml", "[model]\nmass = 2\nstiffness = 100\nnormal_force = 3\n" + common);
  const std::string section = path == "section.diameter" ? "shape = 'circle'\ndiameter = 0.1\n"
                              : path == "section.wall_thickness"
                                  ? "shape = 'tube'\ndiameter = 0.1\nwall_thickness = 0.01\n"
                                  : "shape = 'rectangle'\nwidth = 0.1\nheight = 0.1\n";
  return data::parse_case(
      "base.toml",
      "[beam]\nlength = 2\nmaterial = 'steel'\naxial_force = 500\n[section]\n" + section + common);
}

// The ends of both ranges with their neighbours, what is not finite, and random numbers within and without.
std::vector<double> values_for(const Rule& rule, bool is_integer, RandomNumbers& numbers) {
  std::vector<double> values;
  for (const double end :
       {0.0, rule.smallest, rule.largest, -rule.smallest, -rule.largest, rule.allowed.low, rule.allowed.high})
    if (std::isfinite(end))
      for (const double to : {-infinity, end, infinity})
        values.push_back(is_integer && to != end ? end + std::copysign(1.0, to)
                                                 : 0.0 + std::nextafter(end, to));
  for (int i = 0; i < 20; ++i) {
    const double size = is_integer ? numbers.whole(1, 1000)
                                   : numbers.log_uniform(1e-3 * std::max(rule.smallest, 1e-30),
                                                         1e3 * std::min(rule.largest, 1e30));
    values.push_back(numbers.whole(0, 3) == 0 ? -size : size);
  }
  if (!is_integer) values.insert(values.end(), {nan, infinity, -infinity});
  return values;
}

STICKSLIP_VERIFIES(KeyAxes, "P1");
TEST(KeyAxes, ConvertToTheUnitOfTheirLabel) {
  for (const data::Key& key : data::case_keys()) {
    if (!holds(std::string(key.axis.label), " / ")) continue;
    std::string unit(key.axis.unit());
    std::erase_if(unit, [](char c) { return c == '(' || c == ')'; });
    const auto one = data::quantity_in("1 " + unit, key.magnitudes.unit);
    ASSERT_TRUE(one.has_value()) << key.path;
    EXPECT_TRUE(within(key.axis.scale * *one, 1.0, round_off(1, 1, 1.0))) << key.path;
  }
}

STICKSLIP_VERIFIES(LimitsOfKeys, "P1");
TEST(LimitsOfKeys, AreThoseOfTheTable) {
  RandomNumbers numbers(59);
  const auto words = std::ranges::count_if(data::case_keys(), [](const data::Key& key) {
    return key.member.is_flag || (key.member.get == nullptr && key.path != "numerics.duration");
  });
  EXPECT_EQ(rules.size() + static_cast<std::size_t>(words), data::case_keys().size());
  for (const Rule& rule : rules) {
    const data::Key& key = data::key_named(rule.path);
    EXPECT_EQ(key.magnitudes.unit, rule.unit) << rule.path;
    const data::Case problem = case_for(rule.path);
    for (const double value : values_for(rule, key.member.is_integer, numbers)) {
      SCOPED_TRACE(rule.path + " = " + data::shortest_text(value));
      const auto too_large =
          error_message_if_any<data::InputError>([&] { data::require_magnitude(rule.path, value, "--x"); });
      EXPECT_EQ(too_large.has_value(), !rule.has_magnitude(value));
      EXPECT_TRUE(!too_large || too_large->starts_with("--x: " + rule.path + " is " +
                                                       data::shortest_text(value) + ", but must be from "));
      const bool is_no_number = std::isnan(value) && rule.is_of_the_section();            // but none
      const bool is_too_thin = rule.is_of_the_section() && value > 0.0 && value < 1e-60;  // I = 0
      if (key.member.set == nullptr || is_no_number || is_too_thin) continue;
      try {
        EXPECT_EQ(data::value_of(data::with_value(problem, rule.path, value), rule.path), value);
        EXPECT_TRUE(rule.allowed.contains(value));
      } catch (const data::FieldError& error) {
        EXPECT_FALSE(rule.allowed.contains(value)) << error.what();
        // Of a step that is too long or too short the duration is named.
        if (rule.path == "numerics.time_step" && error.field() == "excitation.duration") continue;
        EXPECT_EQ(error.field(), rule.path);
        EXPECT_TRUE(std::string(error.what())
                        .starts_with(rule.path + " is " + data::shortest_text(value) + ", but must be "))
            << error.what();
      }
    }
  }
}

STICKSLIP_VERIFIES(JumpOfFriction, "P1");
TEST(JumpOfFriction, NeedsARigidContact) {
  const data::FrictionLaw jump(
      {.static_coefficient = 0.3, .kinetic_coefficient = 0.2, .decay = infinity, .viscous = 0.1});
  EXPECT_EQ(jump.in_slip().static_coefficient(), 0.2);
  EXPECT_EQ(jump.in_slip().kinetic_coefficient(), 0.2);
  EXPECT_EQ(jump.in_slip().viscous(), 0.1);
  EXPECT_EQ(paper_friction().in_slip().static_coefficient(), 0.6);
  EXPECT_NO_THROW(data::require_usable(jump, data::TangentialContact()));
  for (const auto& [name, contact] :
       {std::pair{"tangential_stiffness", data::ContactProperties{.tangential_stiffness = 1e6}},
        {"regularisation_velocity", {.regularisation_velocity = 0.01}}}) {
    expect_error_message<data::FieldError>(
        [&, &contact = contact] { data::require_usable(jump, data::TangentialContact(contact)); },
        {"friction.decay is inf, but must be finite (s/m) with contact.", name});
    EXPECT_NO_THROW(data::require_usable(paper_friction(), data::TangentialContact(contact)));
  }
}

STICKSLIP_VERIFIES(ShortestText, "P1");
TEST(ShortestText, ReadsBackAsTheSameDouble) {
  EXPECT_EQ(data::shortest_text(0.1), "0.1");
  EXPECT_EQ(data::shortest_text(-2.0), "-2");
  for (const double value : {1.0 / 3.0, 1e-4 / 12.0, 5e-324, 1.7976931348623157e308})
    EXPECT_EQ(std::strtod(data::shortest_text(value).c_str(), nullptr), value);
}

STICKSLIP_VERIFIES(InputLimits, "P1");
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
           {"m/s^2", {{"g", 9.80665}}},
           {"kg", {{"kg", 1.0}, {"t", 1e3}}},
           {"N s/m", {{"N s/m", 1.0}, {"N s/mm", 1e3}}},
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
  EXPECT_EQ(data::units_convertible_to("kg"), "kg, g, t");
  EXPECT_EQ(data::quantity_in("538 g", "kg"), 0.538);
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

TEST(InputLimits, IsShownByCharacters) {
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

TEST(InputLimits, CutOffLongTextsInMessages) {
  EXPECT_EQ(data::printable("abcdef", 6), "abcdef");
  EXPECT_EQ(data::printable("abcdefg", 6), "abcdef...");
  EXPECT_EQ(data::printable("abcde\u00e9", 7), "abcde\u00e9");
  EXPECT_EQ(data::printable("abcde\u00e9", 6), "abcde...");  // no half of a character
  EXPECT_EQ(data::printable(std::string(60, 'a')), std::string(60, 'a'));
  EXPECT_EQ(data::printable(std::string(61, 'a')), std::string(60, 'a').append("..."));
}

TEST(InputLimits, SuggestsNamesOfWhichAThirdDiffers) {
  using Words = std::vector<std::pair<std::string, std::string>>;
  const auto letters = [](std::size_t count) { return std::string(count, 'a'); };
  // Two of six letters replaced, left out, too many of eight, two pairs exchanged; an exchange of three.
  for (const auto& [word, name] : Words{{"abcdef", "abcdef"},
                                        {"abcdxy", "abcdef"},
                                        {"abcd", "abcdef"},
                                        {"abcdefgh", "abcdef"},
                                        {"bacdfe", "abcdef"},
                                        {"bac", "abc"},
                                        {letters(100), letters(99)}})
    EXPECT_EQ(data::suggestion(word, {name}), " (did you mean " + name + "?)") << word;
  // One letter more, and words that are longer than any name.
  for (const auto& [word, name] : Words{{"abcxyz", "abcdef"},
                                        {"abc", "abcdef"},
                                        {"abcdefghij", "abcdef"},
                                        {"bacdfx", "badecf"},
                                        {"ba", "abc"},
                                        {letters(101), letters(100)}})
    EXPECT_EQ(data::suggestion(word, {name}), "") << word;
  EXPECT_EQ(data::suggestion("xbc", {"abcx", "abc", "ab"}), " (did you mean abc?)");
  EXPECT_EQ(data::suggestion("abc", {}), "");
}

}  // namespace
}  // namespace stickslip::testing
