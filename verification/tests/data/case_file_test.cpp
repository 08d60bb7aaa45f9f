// SPDX-License-Identifier: MIT
/// Case files: the published ones hold the paper's numbers, and unusable input is refused in one sentence
/// that names the place, the key, the value and what is allowed.

#include "stickslip/data/case_file.hpp"
#include "support/input_folder.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

constexpr std::string_view valid_text = R"([beam]
length = 2.0
area = 0.01
second_moment_of_area = 8.25e-6
density = 1000
youngs_modulus = 2e9
axial_force = 500.0
axial_direction = 0.5
shear_stiffness = 6e6
[friction]
static_coefficient = 0.6
kinetic_coefficient = 0.3
decay = 1.0
viscous = 0.1
[excitation]
frequency_hz = 25.0
amplitude = 0.5e-3
duration = 8.0
[numerics]
elements = 20
time_step = 1e-4
spectral_radius = 0.9
velocity_threshold = 1e-4
modes = 10
[damping]
kelvin_voigt = 6.4e-5
ratio = 0.01
[contact]
tangential_stiffness = 1e6
)";

// A line of a valid case. The key of a table's header is empty.
struct Line {
  std::string table, key, text;
  std::size_t number{};

  [[nodiscard]] std::string path() const { return table + "." + key; }
  [[nodiscard]] std::string place() const { return "bar.toml:" + std::to_string(number) + ": "; }
};

std::vector<Line> valid_lines() {
  std::vector<Line> lines;
  std::istringstream stream{std::string(valid_text)};
  std::string table;
  for (std::string text; std::getline(stream, text);) {
    const bool is_header = text.starts_with('[');
    if (is_header) table = text.substr(1, text.size() - 2);
    lines.push_back({table, is_header ? "" : text.substr(0, text.find(' ')), text + "\n", lines.size() + 1});
  }
  return lines;
}

// The text of a case whose line for `path` is replaced.
std::string case_with(const std::string& path, const std::string& replacement) {
  std::string text;
  for (const auto& line : valid_lines()) text += line.path() == path ? replacement : line.text;
  return text;
}

std::string case_without_table(const std::string& table) {
  std::string text;
  for (const auto& line : valid_lines())
    if (line.table != table) text += line.text;
  return text;
}

std::string valid_case() { return std::string(valid_text); }

// The place of `path` in a valid case.
std::string at(const std::string& path) {
  const auto lines = valid_lines();
  return std::ranges::find(lines, path, &Line::path)->place();
}

class CaseFile : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path write(const std::string& text) const {
    return folder_.write("bar.toml", text);
  }

  [[nodiscard]] std::filesystem::path file() const { return folder() / "bar.toml"; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }

  // The sentence that refuses the text, or "accepted".
  [[nodiscard]] std::string error_message(const std::string& text,
                                          const std::vector<data::Override>& overrides = {}) const {
    return error_message_of([&] { static_cast<void>(data::read_case(write(text), overrides)); });
  }

  // What the sentence that refuses an override says behind its place.
  [[nodiscard]] std::string override_error(const std::string& text, const std::string& override) const {
    const std::string sentence = error_message(text, {data::Override::parse(override)});
    const std::string place = "override " + override + ": ";
    if (!sentence.starts_with(place)) return "not at the override: " + sentence;
    return sentence.substr(place.size());
  }

  template <class Action>
  [[nodiscard]] std::string error_message_of(const Action& action) const {
    return folder_.error_message(action);
  }

 private:
  const testing::InputFolder folder_;
};

STICKSLIP_VERIFIES(CaseFile, "P1");
TEST_F(CaseFile, IsReadKeyByKey) {
  const auto problem = data::read_case(write(valid_case()));
  EXPECT_EQ(problem.name, "bar");
  for (const Line& line : valid_lines()) {
    if (line.key.empty()) continue;
    EXPECT_EQ(data::value_of(problem, line.path()), std::stod(line.text.substr(line.text.find('=') + 1)))
        << line.path();
  }
}

TEST_F(CaseFile, MustHoldKeysOrWhatStandsForThem) {
  for (const auto& [key, otherwise] : std::vector<std::pair<std::string, std::string>>{
           {"beam.length", ""},
           {"beam.area", " or the table [section]"},
           {"beam.second_moment_of_area", " or the table [section]"},
           {"beam.density", " or beam.material"},
           {"beam.youngs_modulus", " or beam.material"},
           {"excitation.amplitude",
            " or excitation.velocity_amplitude or excitation.acceleration_amplitude"}})
    EXPECT_EQ(error_message(case_with(key, "")),
              "bar.toml: " + key + " is missing, but a case must hold it" + otherwise);
}

TEST_F(CaseFile, IsDampedByAnOverrideWithoutATableOfItsOwn) {
  const std::string undamped = case_without_table("damping");
  const auto problem =
      data::read_case(write(undamped), {{"damping.kelvin_voigt", "6.4e-5"}, {"damping.ratio", "0.02"}});
  EXPECT_EQ(problem.damping.kelvin_voigt(), 6.4e-5);
  EXPECT_EQ(problem.damping.ratio(), 0.02);
  EXPECT_EQ(override_error(undamped, "damping.kelvin_voigt=-1"),
            "damping.kelvin_voigt is -1, but must be a finite number of 0 or more (s)");
  EXPECT_EQ(override_error(undamped, "damping.ratio=1"),
            "damping.ratio is 1, but must be a number from 0 to below 1");
  EXPECT_EQ(override_error(undamped, "damping.ration=0.1"),
            "unknown key damping.ration (did you mean damping.ratio?) with the value 0.1 (a float), but "
            "[damping] has the keys kelvin_voigt, ratio");
  EXPECT_TRUE(holds(override_error(undamped, "length=1.8"), "but a case has the tables beam"));
}

TEST_F(CaseFile, TakesAContactThatYieldsInOneWay) {
  const data::Case rigid = data::load_case("paper");
  EXPECT_TRUE(rigid.contact.is_rigid());
  EXPECT_EQ(rigid.contact.tangential_stiffness(), std::numeric_limits<double>::infinity());
  const data::Case sprung = data::load_case("paper", {{"contact.tangential_stiffness", "2 MN/m"}});
  EXPECT_EQ(sprung.contact.tangential_stiffness(), 2e6);
  EXPECT_TRUE(sprung.contact.has_spring() && !sprung.contact.is_smooth());
  const data::Case smooth = data::load_case("paper", {{"contact.regularisation_velocity", "1 mm/s"}});
  EXPECT_EQ(smooth.contact.regularisation_velocity(), 1e-3);
  EXPECT_TRUE(smooth.contact.is_smooth() && !smooth.contact.has_spring());
  EXPECT_TRUE(data::load_case("paper", {{"contact.tangential_stiffness", "inf"}}).contact.is_rigid());
  const std::string rigid_text = case_without_table("contact");
  EXPECT_EQ(
      override_error(rigid_text, "contact.tangential_stiffness=0"),
      "contact.tangential_stiffness is 0, but must be a number above 0 (N/m), or inf for a rigid contact");
  EXPECT_EQ(override_error(rigid_text, "contact.regularisation_velocity=-1"),
            "contact.regularisation_velocity is -1, but must be a finite number of 0 or more (m/s)");
  EXPECT_EQ(
      error_message(rigid_text,
                    {{"contact.tangential_stiffness", "1e6"}, {"contact.regularisation_velocity", "0.1"}}),
      "override contact.regularisation_velocity=0.1: contact.regularisation_velocity is 0.1, but must "
      "be 0 with a finite contact.tangential_stiffness: a spring in series with a smooth law that falls "
      "with the velocity has no motion");
}

// What a record of a map keeps of its case.
TEST_F(CaseFile, IsTheSameAgainFromItsNumbers) {
  const data::Case original = data::load_case("damped", {{"friction.viscous", "0.02"},
                                                         {"damping.ratio", "0.01"},
                                                         {"damping.kelvin_voigt", "1e-5"},
                                                         {"beam.axial_direction", "0.25"},
                                                         {"beam.shear_stiffness", "5e6"},
                                                         {"contact.tangential_stiffness", "1e7"}});
  const auto numbers = data::numbers_of(original);
  EXPECT_EQ(numbers.at("friction.viscous"), 0.02);
  EXPECT_EQ(numbers.at("damping.ratio"), 0.01);
  const data::Case again = data::case_with(original.name, numbers);
  EXPECT_EQ(again.friction.coefficients().viscous, 0.02);
  EXPECT_EQ(again.beam.axial_direction(), 0.25);
  EXPECT_EQ(again.contact.tangential_stiffness(), 1e7);
  EXPECT_EQ(again.beam.shear_stiffness(), 5e6);
  EXPECT_EQ(data::numbers_of(again), numbers);
}

TEST_F(CaseFile, RefusesAMisspeltTable) {
  EXPECT_EQ(
      error_message(valid_case() + "[beem]\nlength = 2\n"),
      "bar.toml:30: unknown table [beem] (did you mean beam?), but a case has the tables beam, friction, "
      "excitation, numerics, damping, contact, wall, section, uncertainty");
}

TEST_F(CaseFile, HoldsAWallThatMovesEitherWay) {
  EXPECT_EQ(data::read_case(write(valid_case())).wall.speed(), 0.0);
  EXPECT_EQ(data::read_case(write(valid_case() + "[wall]\nspeed = '-30 mm/s'\n")).wall.speed(), -0.03);
  EXPECT_EQ(data::numbers_of(data::read_case(file())).at("wall.speed"), -0.03);
}

TEST_F(CaseFile, RefusesAKeyOutsideEveryTable) {
  EXPECT_EQ(error_message("length = 2\n" + valid_case()),
            "bar.toml:1: unknown key length with the value 2 (an integer), but a case has the tables beam, "
            "friction, excitation, numerics, damping, contact, wall, section, uncertainty");
  EXPECT_EQ(error_message("beam = 3\n"), "bar.toml:1: beam is 3 (an integer), but must be a table");
  EXPECT_EQ(error_message("uncertainty = 3\n" + valid_case()),
            "bar.toml:1: uncertainty is 3 (an integer), but must be a table");
  EXPECT_EQ(error_message("damping = 0.01\n"), "bar.toml:1: damping is 0.01 (a float), but must be a table");
  EXPECT_EQ(error_message("[[beam]]\nlength = 2\n"), "bar.toml:1: beam is an array, but must be a table");
}

TEST_F(CaseFile, RefusesEveryTypeThatIsNotANumber) {
  for (const auto& [value, described] : {std::pair{"'two'", "'two' (a string)"},
                                         {"true", "true (a boolean)"},
                                         {"[2.0]", "an array"},
                                         {"{ m = 2.0 }", "a table"},
                                         {"2018-02-19", "2018-02-19 (a date or time)"}})
    for (const std::string path : {"beam.length", "numerics.modes"})
      EXPECT_TRUE(error_message(case_with(path, path.substr(path.find('.') + 1) + " = " + value + "\n"))
                      .starts_with(at(path) + path + " is " + described + ", but must be a"))
          << path << " " << value;
}

TEST_F(CaseFile, TakesIntegersForNumbersAndNoFloatsForIntegers) {
  EXPECT_EQ(data::read_case(write(case_with("beam.length", "length = 3\n"))).beam.length(), 3.0);
  for (const std::string key : {"elements", "modes"})
    EXPECT_EQ(error_message(case_with("numerics." + key, key + " = 20.0\n")),
              at("numerics." + key) + "numerics." + key + " is 20 (a float), but must be an integer");
}

TEST_F(CaseFile, RefusesAnIntegerThatDoesNotFit) {
  EXPECT_EQ(error_message(case_with("numerics.modes", "modes = 4294967306\n")),
            at("numerics.modes") +
                "numerics.modes is 4294967306, but must be an integer of at most 2147483647 in magnitude");
}

TEST_F(CaseFile, RefusesWhatIsNoText) {
  EXPECT_EQ(error_message(""), "bar.toml: is empty");
  EXPECT_TRUE(error_message("# \xC3\x28\n").starts_with("bar.toml:1: is not valid TOML: "));
  EXPECT_EQ(error_message(valid_case() + std::string(1'000'000, '#')),
            "bar.toml: is larger than the 1000000 bytes that are allowed");
  EXPECT_EQ(error_message_of([&] { static_cast<void>(data::read_case(folder())); }),
            folder().string() + ": is a folder, not a file");
  EXPECT_EQ(error_message_of([&] { static_cast<void>(data::read_case(folder() / "none.toml")); }),
            "none.toml: cannot be opened for reading");
  EXPECT_EQ(error_message_of([] { static_cast<void>(data::read_case("/dev/zero")); }),
            "/dev/zero: is larger than the 1000000 bytes that are allowed");
}

TEST_F(CaseFile, MessagesStayOnOneShortLine) {
  const std::string sentence = error_message(
      case_with("beam.length", "length = \"\"\"line\nline\x7F" + std::string(500, 'x') + "\"\"\"\n"));
  EXPECT_FALSE(holds(sentence, "\n"));
  EXPECT_LT(sentence.size(), 200U);
}

TEST_F(CaseFile, TheLastOverrideOfAKeyWins) {
  const std::vector<data::Override> overrides{
      {"beam.length", "1.8"}, {"beam.area", "0.02"}, {"beam.length", "1.7"}};
  const auto problem = data::read_case(write(valid_case()), overrides);
  EXPECT_EQ(problem.beam.length(), 1.7);
  EXPECT_EQ(problem.beam.area(), 0.02);
}

TEST_F(CaseFile, AnOverrideSuppliesWhatTheFileLacks) {
  EXPECT_EQ(data::read_case(write(case_with("beam.length", "")), {{"beam.length", "1.8"}}).beam.length(),
            1.8);
}

TEST_F(CaseFile, RefusesAnOverrideThatIsNoSingleTomlValue) {
  const std::string allowed = "but must be a number (m) or a text of a number and a unit: m, cm, mm, um, nm";
  EXPECT_EQ(override_error(valid_case(), "beam.length=long"), "beam.length is long, " + allowed);
  EXPECT_EQ(override_error(valid_case(), "beam.length=mm"), "beam.length is mm, " + allowed);
  EXPECT_EQ(override_error(valid_case(), "damping.ratio=low"), "damping.ratio is low, but must be a number");
  EXPECT_EQ(override_error(valid_case(), "beam.length='2'"), "beam.length is '2' (a string), " + allowed);
  EXPECT_EQ(error_message(valid_case(), {{"beam.length", "1\nbeam.area = 2"}}),
            "override beam.length=1?beam.area = 2: the value has several lines, but must be one TOML value "
            "on one line");
}

// The lines of a case with a section, a material and an acceleration, in the units of a workshop.
std::string workshop_case(const std::string& section, const std::string& amplitude) {
  return "[beam]\nlength = ' 400 mm '\nmaterial = 'steel'\naxial_force = '0.04 kN'\n[section]\n" + section +
         "[friction]\nstatic_coefficient = '50 %'\n[excitation]\nfrequency_hz = '30 Hz'\n" + amplitude;
}

std::string without_line(std::string text, const std::string& beginning) {
  const auto begin = text.find("\n" + beginning);
  return text.erase(begin, text.find('\n', begin + 1) - begin);
}

constexpr const char* strip = "shape = 'rectangle'\nwidth = '30 mm'\nheight = '1.5 mm'\n";
const std::string strip_case = workshop_case(strip, "amplitude = 1e-3\n");

STICKSLIP_VERIFIES(CaseShorthand, "P1");
class CaseShorthand : public CaseFile {};

// Three roundings of 1.1e-16 each in the area, four in the second moment of area.
TEST_F(CaseShorthand, SuppliesSectionMaterialAndCoulombFriction) {
  const auto problem = data::read_case(write(workshop_case(strip, "amplitude = '0.5 mm'\n")));
  EXPECT_EQ(problem.beam.length(), 0.4);
  EXPECT_EQ(problem.beam.axial_force(), 40.0);
  EXPECT_NEAR(problem.beam.area(), 4.5e-5, 4e-16 * 4.5e-5);
  EXPECT_NEAR(problem.beam.second_moment_of_area(), 8.4375e-12, 6e-16 * 8.4375e-12);
  EXPECT_EQ(problem.beam.density(), 7850.0);
  EXPECT_EQ(problem.beam.youngs_modulus(), 2.1e11);
  EXPECT_EQ(problem.friction.static_coefficient(), 0.5);
  EXPECT_EQ(problem.friction.kinetic_coefficient(), 0.5);
  EXPECT_EQ(problem.friction.decay(), 0.0);
  EXPECT_EQ(problem.excitation.amplitude(), 0.5e-3);
}

// A tube whose wall is half of its diameter is a circle; a thin one has the area pi d t and I = A d^2/8, but
// for t/d of itself.
TEST_F(CaseShorthand, KnowsCirclesAndTubes) {
  const auto beam = [&](const std::string& section) {
    return data::read_case(write(workshop_case(section, "amplitude = 1e-3\n"))).beam;
  };
  const data::Beam circle = beam("shape = 'circle'\ndiameter = 0.02\n");
  const data::Beam solid = beam("shape = 'tube'\ndiameter = 0.02\nwall_thickness = 0.01\n");
  const data::Beam thin = beam("shape = 'tube'\ndiameter = 0.02\nwall_thickness = 2e-8\n");
  constexpr double pi = std::numbers::pi;
  EXPECT_NEAR(circle.area(), pi * 1e-4, 1e-15 * circle.area());
  EXPECT_NEAR(circle.second_moment_of_area(), pi / 4.0 * 1e-8, 1e-15 * circle.second_moment_of_area());
  EXPECT_NEAR(solid.area(), circle.area(), 1e-15 * circle.area());
  EXPECT_NEAR(solid.second_moment_of_area(), circle.second_moment_of_area(),
              1e-15 * circle.second_moment_of_area());
  EXPECT_NEAR(thin.area(), pi * 0.02 * 2e-8, 1.1e-6 * thin.area());
  EXPECT_NEAR(thin.second_moment_of_area(), thin.area() * 0.02 * 0.02 / 8.0,
              2.2e-6 * thin.second_moment_of_area());
}

// But for the settings, which are chosen when a file is read.
void expect_same_numbers(const data::Case& problem, const data::Case& expected) {
  const auto numbers = data::numbers_of(problem), others = data::numbers_of(expected);
  ASSERT_EQ(numbers.size(), others.size());
  for (const auto& [path, value] : others) {
    if (path.starts_with("numerics.")) continue;
    EXPECT_DOUBLE_EQ(numbers.at(path), value) << path;
  }
}

const std::map<std::string, std::vector<std::string>> sections{
    {strip, {"section.width", "section.height"}},
    {"shape = 'circle'\ndiameter = 0.02\n", {"section.diameter"}},
    {"shape = 'tube'\ndiameter = 0.02\nwall_thickness = 2e-3\n",
     {"section.diameter", "section.wall_thickness"}}};

// A case with a changed side is the case of a file with that side.
TEST_F(CaseShorthand, FollowsTheSidesOfTheSection) {
  for (const std::string ratio : {"", "poissons_ratio = 0.3\n", "shear_stiffness = 3e6\n"})
    for (const auto& [section, sides] : sections) {
      const auto file = write("[beam]\n" + ratio + workshop_case(section, "amplitude = 1e-3\n").substr(7));
      const data::Case problem = data::read_case(file);
      std::vector<std::string> keys = sides;
      if (ratio.starts_with("poissons")) keys.emplace_back("beam.poissons_ratio");
      for (const std::string& key : keys) {
        const double value = 1.1 * data::value_of(problem, key);
        data::Case expected = data::read_case(file, {{key, data::shortest_text(value)}});
        if (ratio.starts_with("shear"))  // which the file does not derive from the section
          expected = data::with_value(expected, "beam.shear_stiffness",
                                      3e6 * expected.beam.area() / problem.beam.area());
        expect_same_numbers(data::with_value(problem, key, value), expected);
      }
    }
}

TEST_F(CaseShorthand, TakesTwoSidesAtOnce) {
  const auto file = write(workshop_case(sections.rbegin()->first, "amplitude = 1e-3\n"));
  const std::vector<std::pair<std::string_view, double>> values{{"section.wall_thickness", 0.02},
                                                                {"section.diameter", 0.05}};
  expect_same_numbers(
      data::with_values(data::read_case(file), values),
      data::read_case(file, {{"section.wall_thickness", "0.02"}, {"section.diameter", "0.05"}}));
  EXPECT_EQ(error_message_of(
                [&] { (void)data::with_value(data::read_case(file), "section.wall_thickness", 0.011); }),
            "section.wall_thickness is 0.011, but must be at most half of section.diameter, which is 0.02");
}

TEST_F(CaseShorthand, ForgetsASectionThatIsNotThatOfTheArea) {
  const data::Case problem = data::read_case(write(strip_case), {{"beam.poissons_ratio", "0.3"}});
  EXPECT_EQ(data::value_of(problem, "section.height"), 1.5e-3);
  EXPECT_TRUE(std::isnan(data::value_of(problem, "section.diameter")));
  for (const std::string key : {"beam.area", "beam.second_moment_of_area"}) {
    const data::Case changed = data::with_value(problem, key, 1e-6);
    EXPECT_EQ(data::value_of(changed, key), 1e-6);
    EXPECT_EQ(error_message_of([&] { (void)data::with_value(changed, "section.height", 1e-3); }),
              "section.height is 0.001, but must be left out: the case has no [section] with it");
  }
  const data::Case sheared = data::with_value(problem, "beam.shear_stiffness", 2e6);
  EXPECT_EQ(sheared.beam.shear_stiffness(), 2e6);
  EXPECT_TRUE(std::isnan(data::value_of(sheared, "beam.poissons_ratio")));
  EXPECT_EQ(data::value_of(sheared, "section.height"), 1.5e-3);
  expect_same_numbers(data::case_with("bar", data::numbers_of(problem)), problem);
}

// Each value as it is, and what follows from others only where it is not among them.
TEST_F(CaseShorthand, ChangesOnlyWhatIsNotGiven) {
  const data::Case problem = data::read_case(write(strip_case), {{"beam.shear_stiffness", "3e6"}});
  const double modulus = problem.beam.youngs_modulus();
  const std::vector<std::pair<std::string_view, double>> values{{"beam.youngs_modulus", 2.0 * modulus},
                                                                {"beam.shear_stiffness", 4e6},
                                                                {"friction.static_coefficient", 0.4},
                                                                {"friction.kinetic_coefficient", 0.2}};
  const data::Case changed = data::with_values(problem, values);
  for (const auto& [key, value] : values) EXPECT_EQ(data::value_of(changed, key), value) << key;
  EXPECT_EQ(data::with_value(problem, "beam.youngs_modulus", 2.0 * modulus).beam.shear_stiffness(), 6e6);
  EXPECT_EQ(data::with_value(problem, "friction.static_coefficient", 0.4).friction.kinetic_coefficient(),
            0.4);
  const std::vector<std::pair<std::string_view, double>> rising{{"friction.static_coefficient", 0.4},
                                                                {"friction.kinetic_coefficient", 0.5}};
  EXPECT_THROW((void)data::with_values(problem, rising), data::FieldError);
  EXPECT_THROW((void)data::with_value(problem, "beam.lenght", 1.0), std::invalid_argument);
}

// Shear coefficients of Cowper (1966): at nu = 0 those of a rectangle, a circle and a thin tube are 5/6, 6/7 and 1/2; at
// nu = 0.3 the same formulas by hand. A tube whose wall is half of its diameter is a circle.
TEST_F(CaseShorthand, SuppliesTheShearStiffnessOfPoissonsRatio) {
  const auto coefficient = [&](const std::string& section, const std::string& ratio) {
    const data::Beam beam =
        data::read_case(write(workshop_case(section, "amplitude = 1e-3\n")), {{"beam.poissons_ratio", ratio}})
            .beam;
    const double shear_modulus = beam.youngs_modulus() / (2.0 + 2.0 * std::stod(ratio));
    return beam.shear_stiffness() / (shear_modulus * beam.area());
  };
  const std::string circle = "shape = 'circle'\ndiameter = 0.02\n",
                    tube = "shape = 'tube'\ndiameter = 0.02\n";
  EXPECT_NEAR(coefficient(strip, "0.0"), 5.0 / 6.0, 1e-15);
  EXPECT_NEAR(coefficient(strip, "0.3"), 13.0 / 15.3, 1e-15);
  EXPECT_NEAR(coefficient(circle, "0.0"), 6.0 / 7.0, 1e-15);
  EXPECT_NEAR(coefficient(circle, "0.3"), 7.8 / 8.8, 1e-15);
  EXPECT_NEAR(coefficient(tube + "wall_thickness = 0.01\n", "0.3"), 7.8 / 8.8, 1e-15);
  // (2 t/d)^2 of itself.
  EXPECT_NEAR(coefficient(tube + "wall_thickness = 1e-7\n", "0.0"), 0.5, 1e-9);
  EXPECT_NEAR(coefficient(tube + "wall_thickness = 1e-7\n", "0.3"), 2.6 / 4.9, 1e-9);
}

TEST_F(CaseShorthand, RefusesAmbiguousPoissonsRatio) {
  EXPECT_EQ(override_error(strip_case, "beam.poissons_ratio=0.5"),
            "beam.poissons_ratio is 0.5, but must be a number above -1 and below 0.5");
  EXPECT_EQ(override_error(strip_case, "beam.poissons_ratio=-1"),
            "beam.poissons_ratio is -1, but must be a number above -1 and below 0.5");
  EXPECT_EQ(override_error(strip_case, "beam.poissons_ratio=1e-10"),
            "beam.poissons_ratio is 1e-10, but must be from 1e-09 to 1 in magnitude");
  EXPECT_EQ(override_error(without_line(strip_case, "material"), "beam.poissons_ratio=0.3"),
            "beam.poissons_ratio is 0.3 (a float), but needs beam.youngs_modulus or beam.material; otherwise "
            "give beam.shear_stiffness");
  EXPECT_EQ(override_error(valid_case(), "beam.poissons_ratio=0.3"),
            "beam.poissons_ratio is 0.3 (a float), but needs section.shape; otherwise give "
            "beam.shear_stiffness");
  // The later of two overrides counts, in a file both are too many.
  EXPECT_EQ(
      data::read_case(write(strip_case), {{"beam.poissons_ratio", "0.3"}, {"beam.shear_stiffness", "7.0"}})
          .beam.shear_stiffness(),
      7.0);
  EXPECT_EQ(
      error_message("[beam]\npoissons_ratio = 0.3\nshear_stiffness = 7.0\n" + strip_case.substr(7)),
      "bar.toml:3: beam.shear_stiffness is 7 (a float), but must be missing where beam.poissons_ratio is "
      "given");
}

// h = A0 sin(Omega t) with Omega = 60 pi rad/s.
TEST_F(CaseShorthand, TakesTheAmplitudeOfVelocityOrAcceleration) {
  const auto amplitude = [&](const std::string& line, const std::vector<data::Override>& overrides = {}) {
    return data::read_case(write(workshop_case(strip, line)), overrides).excitation.amplitude();
  };
  constexpr double omega = 60.0 * std::numbers::pi;
  EXPECT_NEAR(amplitude("velocity_amplitude = '94 mm/s'\n"), 0.094 / omega, 1e-18);
  EXPECT_EQ(amplitude("velocity_amplitude = 0\n"), 0.0);
  EXPECT_NEAR(amplitude("acceleration_amplitude = '2 g'\n"), 2.0 * 9.80665 / (omega * omega), 1e-18);
  EXPECT_EQ(amplitude("acceleration_amplitude = '2 g'\n", {{"excitation.amplitude", "1e-3"}}), 1e-3);
  EXPECT_NEAR(amplitude("amplitude = 1e-3\n", {{"excitation.velocity_amplitude", "94mm/s"}}), 0.094 / omega,
              1e-18);
}

TEST_F(CaseShorthand, IsRefusedWhereItIsIncompleteOrGivenTwice) {
  const auto message = [&](const std::string& section) {
    return error_message(workshop_case(section, "amplitude = 1e-3\n"));
  };
  EXPECT_EQ(message("width = 0.03\n"),
            "bar.toml:6: section.shape is missing, but must be one of rectangle, circle, tube");
  EXPECT_EQ(message("shape = 'rectangle'\nwidth = 0.03\n"),
            "bar.toml:6: section.height is missing, but a rectangle must have it");
  EXPECT_EQ(message("shape = 'circle'\ndiameter = 0.03\nwidth = 0.03\n"),
            "bar.toml:8: section.width is 0.03 (a float), but a circle does not have it");
  EXPECT_EQ(message("shape = 'tube'\ndiameter = 0.03\nwall_thickness = 0.02\n"),
            "bar.toml:8: section.wall_thickness is 0.02, but must be at most half of section.diameter, which "
            "is 0.03");
  EXPECT_EQ(message("shape = 'square'\n"),
            "bar.toml:6: section.shape is 'square' (a string), but must be one of rectangle, circle, tube");
}

TEST_F(CaseShorthand, IsRefusedAsAnOverrideWithoutAMeaning) {
  const std::vector<std::pair<std::string, std::string>> overrides{
      {"section.height=-1 mm", "section.height is -0.001, but must be a finite number above 0 (m)"},
      {"section.height=inf", "section.height is inf, but must be a finite number above 0 (m)"},
      {"section.width=1e7", "section.width is 1e+07, but must be from 1e-09 to 1e+06 (m) in magnitude"},
      {"section.shape=3", "section.shape is 3 (an integer), but must be one of rectangle, circle, tube"},
      {"beam.area=3", "beam.area is 3 (an integer), but must be missing where section.shape is given"},
      {"beam.material=stel",
       "beam.material is stel (did you mean steel?), but must be one of steel, stainless-steel, aluminium, "
       "titanium, glass, abs, pp, pa6, pom, natural-rubber, pmma, softwood"},
      {"beam.length=3 s",
       "beam.length is 3 s, but must be a number (m) or a text of a number and a unit: m, cm, mm, um, nm"}};
  for (const auto& [override, sentence] : overrides)
    EXPECT_EQ(override_error(strip_case, override), sentence);
}

TEST_F(CaseShorthand, IsRefusedWithTwoAmplitudesOrWithoutAFrequency) {
  const auto message = [&](const std::string& amplitude) {
    return error_message(workshop_case(strip, amplitude + "\n"));
  };
  EXPECT_EQ(message("velocity_amplitude = 1\namplitude = 1"),
            "bar.toml:14: excitation.amplitude is 1 (an integer), but must be missing where "
            "excitation.velocity_amplitude is given");
  EXPECT_EQ(error_message(without_line(workshop_case(strip, "velocity_amplitude = 1\n"), "frequency_hz")),
            "bar.toml: excitation.frequency_hz is missing, but a case must hold it");
}

TEST_F(CaseShorthand, TakesTheDurationFromOneTableOnly) {
  EXPECT_EQ(data::read_case(write(case_with("excitation.duration", ""))).numerics.duration(), 10.0);
  const std::string older = "modes = 10\nduration = 3\n";
  EXPECT_EQ(error_message(case_with("numerics.modes", older)),
            "bar.toml:18: excitation.duration is 8 (a float), but must be missing where numerics.duration is "
            "given");
  const auto file = write(case_with("numerics.modes", older));
  EXPECT_EQ(data::read_case(file, {{"excitation.duration", "2 s"}}).numerics.duration(), 2.0);
  EXPECT_EQ(data::read_case(file, {{"numerics.duration", "2000 ms"}}).numerics.duration(), 2.0);
  EXPECT_EQ(override_error(valid_case(), "numerics.duration=1e16"),
            "numerics.duration is 1e+16, but must be from 1e-15 to 1e+15 (s) in magnitude");
  EXPECT_EQ(error_message(case_with("excitation.duration", ""), {{"numerics.time_step", "20"}}),
            "bar.toml: excitation.duration is 10, but must be at least numerics.time_step, which is 20");
}

TEST_F(CaseShorthand, HasAMaterialOnlyWithASource) {
  const auto materials = data::list_materials();
  EXPECT_FALSE(materials.empty());
  for (const auto& material : materials) {
    EXPECT_FALSE(material.source.empty());
    const auto file = write(strip_case);
    EXPECT_EQ(data::read_case(file, {{"beam.material", material.name}}).beam.density(), material.density);
  }
}

STICKSLIP_VERIFIES(Override, "P1");
TEST(Override, IsSplitAtTheFirstEqualsSign) {
  const auto override = data::Override::parse(" beam.length = 1.8 ");
  EXPECT_EQ(override.key, "beam.length");
  EXPECT_EQ(override.value, "1.8");
}

TEST(Override, IsRefusedWithoutBothSides) {
  for (const std::string text : {"beam.length", "beam.length=", "=1.8", "", " = "})
    EXPECT_THROW(static_cast<void>(data::Override::parse(text)), data::InputError) << text;
}

STICKSLIP_VERIFIES(PublishedCases, "P1");
TEST(PublishedCases, DifferFromThePaperWhereTheySay) {
  const std::map<std::string, std::map<std::string, double>> cases{
      {"paper-half-stiffness", {{"beam.youngs_modulus", 1e9}}},
      {"paper-figure14",
       {{"beam.area", 0.2 * 0.02},
        {"beam.second_moment_of_area", 0.2 * 0.02 * 0.02 * 0.02 / 12.0},
        {"excitation.amplitude", 1e-3}}}};
  for (const auto& [name, changes] : cases) {
    auto expected = data::numbers_of(data::load_case("paper"));
    for (const auto& [key, value] : changes) expected.at(key) = value;
    const auto numbers = data::numbers_of(data::load_case(name));
    ASSERT_EQ(numbers.size(), expected.size());
    for (const auto& [key, value] : expected) EXPECT_DOUBLE_EQ(numbers.at(key), value) << name << " " << key;
  }
}

TEST(PublishedCases, DampedHasHalfAPercentInTheFirstStickMode) {
  const auto problem = data::load_case("damped");
  expect_same_numbers(problem, data::load_case("paper", {{"damping.kelvin_voigt", "6.4e-5"},
                                                         {"excitation.amplitude", "1e-3"},
                                                         {"excitation.duration", "0.5"}}));
  // zeta = eta omega/2 with 24.972 Hz, to the two digits of eta.
  EXPECT_TRUE(testing::within(0.5 * problem.damping.kelvin_voigt() * 2.0 * std::numbers::pi * 24.972, 0.005,
                              testing::reference(0.005 * 0.05 / 6.4, "6.4e-5 s, two digits")));
}

TEST(PublishedCases, AreListedWithATitleAndAllLoad) {
  const auto cases = data::list_cases();
  ASSERT_GE(cases.size(), 4U);
  for (const auto& [name, title] : cases) {
    EXPECT_FALSE(title.empty()) << name;
    EXPECT_NO_THROW(static_cast<void>(data::load_case(name))) << name;
  }
}

TEST_F(CaseFile, IsFoundByPath) {
  static_cast<void>(write(valid_case()));
  EXPECT_EQ(data::find_case(file().string()), file());
  for (const auto& none : {folder(), folder() / "bar"})
    EXPECT_THROW(static_cast<void>(data::find_case(none.string())), data::InputError) << none;
}

TEST_F(CaseFile, OfAMisspeltNameIsRefusedWithTheNamesThereAre) {
  EXPECT_EQ(error_message_of([] { static_cast<void>(data::load_case("papr")); }),
            "case papr is unknown (did you mean paper?), but must be a file or one of damped, near-buckling, "
            "paper, paper-figure14, paper-figure9, paper-half-stiffness, reed, rig, soft-short, steel-strip, "
            "tension, uncertain");
}

// Points STICKSLIP_DATA elsewhere while it lives.
class DataFolder {
 public:
  explicit DataFolder(const std::string& folder) { ::setenv("STICKSLIP_DATA", folder.c_str(), 1); }
  ~DataFolder() { ::unsetenv("STICKSLIP_DATA"); }
  DataFolder(const DataFolder&) = delete;
  DataFolder& operator=(const DataFolder&) = delete;
};

TEST_F(CaseFile, IsFoundInTheFolderThatTheEnvironmentNames) {
  std::filesystem::create_directory(folder() / "cases");
  std::ofstream(folder() / "cases" / "mine.toml") << "\n# A beam of my own\n#\n" << valid_case();
  const DataFolder chosen(folder().string());
  EXPECT_EQ(data::list_cases(), (std::map<std::string, std::string>{{"mine", "A beam of my own"}}));
  EXPECT_EQ(data::load_case("mine").beam.second_moment_of_area(), 8.25e-6);
}

TEST_F(CaseFile, IsFoundInTheUsualFolderByDefault) {
  const DataFolder chosen("");
  EXPECT_EQ(data::load_case("paper").name, "paper");
}

TEST_F(CaseFile, AFolderWithoutCasesIsRefused) {
  const DataFolder chosen(folder().string());
  EXPECT_TRUE(
      holds(error_message_of([] { static_cast<void>(data::list_cases()); }), "STICKSLIP_DATA must name"));
}

}  // namespace
}  // namespace stickslip::testing
