// SPDX-License-Identifier: MIT
/// Case files: what they say is what is read, in every unit; what cannot be used is refused in one sentence that names the
/// place, the key, the value and what is allowed.

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/units.hpp"
#include "support/input_folder.hpp"
#include "support/random_cases.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

const std::string valid = R"([beam]
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
const std::string undamped = valid.substr(0, valid.find("[damping]"));

// The text with another part, which must be there.
std::string with(std::string text, const std::string& part, const std::string& other) {
  return text.replace(text.find(part), part.size(), other);
}

// The numbers that a case states, by their paths.
std::map<std::string, double> stated_numbers(const std::string& text) {
  std::map<std::string, double> numbers;
  std::string table;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const auto equals = line.find(" = ");
    if (line.starts_with('['))
      table = line.substr(1, line.size() - 2);
    else if (const auto number = data::finite_number(line.substr(equals + 3)))
      numbers[table + "." + line.substr(0, equals)] = *number;
  }
  return numbers;
}

// A strip of steel in the units of a workshop.
std::string workshop_case(const std::string& section, const std::string& amplitude = "amplitude = 1e-3\n") {
  return "[beam]\nlength = ' 400 mm '\nmaterial = 'steel'\naxial_force = '0.04 kN'\n[section]\n" + section +
         "[friction]\nstatic_coefficient = '50 %'\n[excitation]\nfrequency_hz = '30 Hz'\n" + amplitude;
}
const std::string strip = "shape = 'rectangle'\nwidth = '30 mm'\nheight = '1.5 mm'\n",
                  circle = "shape = 'circle'\ndiameter = 0.02\n", tube = "shape = 'tube'\ndiameter = 0.02\n",
                  strip_case = workshop_case(strip);

class CaseFile : public ::testing::Test {
 protected:
  void TearDown() override { ::unsetenv("STICKSLIP_DATA"); }

  [[nodiscard]] std::filesystem::path write(const std::string& text) const {
    return folder_.write("bar.toml", text);
  }
  [[nodiscard]] data::Case read(const std::string& text,
                                const std::vector<data::Override>& overrides = {}) const {
    return data::read_case(write(text), overrides);
  }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path(); }

  // The sentence that refuses it, or "accepted".
  template <class Action>
  [[nodiscard]] std::string error_message(const Action& action) const {
    return folder_.error_message([&] { (void)action(); });
  }

 private:
  const InputFolder folder_;
};

STICKSLIP_VERIFIES(CaseFile, "P1");
TEST_F(CaseFile, HoldsWhatItStates) {
  const auto expect_stated = [this](const std::string& text) {
    const data::Case problem = read(text);
    EXPECT_EQ(problem.name, "bar");
    for (const auto& [path, number] : stated_numbers(text))
      EXPECT_EQ(data::value_of(problem, path), number) << path;
    // What a record of a map keeps.
    const auto numbers = data::numbers_of(problem);
    EXPECT_EQ(data::numbers_of(data::case_with("again", numbers)), numbers);
  };
  EXPECT_EQ(stated_numbers(valid).size(), 23U);
  expect_stated(valid);
  on_random_cases(20, {.shear = 0.5, .moving_wall = 0.5, .yielding = 0.5},
                  [&](const CaseText& text, RandomNumbers&) { expect_stated(text.text()); });
}

// A number is divided by the unit and multiplied by it again.
TEST_F(CaseFile, IsTheSameInEveryUnit) {
  const std::string text = valid + "[wall]\nspeed = -0.03\n";
  for (const auto& [key, number] : stated_numbers(text)) {
    const std::string si(data::key_named(key).magnitudes.unit);
    std::istringstream units(si.empty() ? "" : data::units_convertible_to(si));
    for (std::string unit; std::getline(units >> std::ws, unit, ',');) {
      const std::string value = fmt::format("{} {}", number / data::unit_named(unit)->to_si(1.0), unit);
      EXPECT_TRUE(within(data::value_of(read(text, {{key, value}}), key), number, round_off(3, 1, number)))
          << key << " = " << value;
    }
  }
}

TEST_F(CaseFile, GivesWayToOverrides) {
  const data::Case problem = read(
      with(undamped, "length = 2.0\n", ""),
      {{"beam.length", "1.8"}, {"beam.area", "0.02"}, {"beam.length", "1.7"}, {"damping.ratio", "0.02"}});
  EXPECT_EQ(problem.beam().length(), 1.7);
  EXPECT_EQ(problem.beam().area(), 0.02);
  EXPECT_EQ(problem.damping.ratio(), 0.02);
  EXPECT_EQ(read(with(valid, "length = 2.0", "length = 3")).beam().length(), 3.0);
}

TEST_F(CaseFile, TakesAContactThatYieldsInOneWay) {
  const auto contact = [&](const std::string& key, const std::string& value) {
    return read(undamped, {{"contact." + key, value}}).contact.compliance;
  };
  EXPECT_TRUE(read(undamped).contact.compliance.is_rigid());
  EXPECT_TRUE(contact("tangential_stiffness", "inf").is_rigid());
  const auto spring = contact("tangential_stiffness", "2 MN/m"),
             smooth = contact("regularisation_velocity", "1 mm/s");
  EXPECT_TRUE(spring.has_spring() && !spring.is_smooth() && !spring.is_rigid());
  EXPECT_TRUE(smooth.is_smooth() && !smooth.has_spring() && !smooth.is_rigid());
}

struct Refusal {
  std::string text, sentence;  // how it begins, behind the place of the override if there is one
  std::string override{};
};

const std::vector<Refusal> refusals{
    {"", ": is empty"},
    {"# \xC3\x28\n", ":1: is not valid TOML: "},
    {with(valid, "area = 0.01\n", ""),
     ": beam.area is missing, but a case must hold it or the table [section]"},
    {with(valid, "density = 1000\n", ""),
     ": beam.density is missing, but a case must hold it or beam.material"},
    {with(valid, "amplitude = 0.5e-3\n", ""),
     ": excitation.amplitude is missing, but a case must hold it or excitation.velocity_amplitude or "},
    {valid + "[beem]\nlength = 2\n", ":30: unknown table [beem] (did you mean beam?), but a case has the "},
    {"length = 2\n" + valid, ":1: unknown key length with the value 2 (an integer), but a case has the "},
    {"beam = 3\n", ":1: beam is 3 (an integer), but must be a table"},
    {"uncertainty = 3\n" + valid, ":1: uncertainty is 3 (an integer), but must be a table"},
    {"[[beam]]\nlength = 2\n", ":1: beam is an array, but must be a table"},
    {with(valid, "= 2.0", "= true"), ":2: beam.length is true (a boolean), but must be a number (m)"},
    {with(valid, "= 2.0", "= [2.0]"), ":2: beam.length is an array, but must be a number (m)"},
    {with(valid, "= 2.0", "= { m = 2.0 }"), ":2: beam.length is a table, but must be a number (m)"},
    {with(valid, "= 2.0", "= 2018-02-19"), ":2: beam.length is 2018-02-19 (a date or time), but must be a"},
    {with(valid, "= 2.0", "= \"\"\"line\nline" + std::string(500, 'x') + "\"\"\""),
     ":2: beam.length is '''line?line" + std::string(48, 'x') + "... (a string), but must be a number (m)"},
    {with(valid, "elements = 20", "elements = 20.0"), ":20: numerics.elements is 20 (a float), but must be "},
    {with(valid, "modes = 10", "modes = 4294967306"),
     ":24: numerics.modes is 4294967306, but must be an integer of at most 2147483647 in magnitude"},
    {valid, "beam.length is long, but must be a number (m) or a text of a number and a ", "beam.length=long"},
    {valid, "beam.length is '2' (a string), but must be a number (m) or a text", "beam.length='2'"},
    {valid, "damping.ratio is low, but must be a number", "damping.ratio=low"},
    {valid, "unknown key damping.ration (did you mean damping.ratio?) with the value ", "damping.ration=0.1"},
    {undamped, "damping.kelvin_voigt is -1, but must be a finite number of 0 or ", "damping.kelvin_voigt=-1"},
    {valid, "contact.regularisation_velocity is 0.1, but must be 0 ", "contact.regularisation_velocity=0.1"},
    {valid, "numerics.duration is 1e+16, but must be from 1e-15 to 1e+15 (s) in ", "numerics.duration=1e16"},
    {with(valid, "modes = 10\n", "modes = 10\nduration = 3\n"),
     ":18: excitation.duration is 8 (a float), but must be missing where numerics.duration is given"},
    {with(with(valid, "duration = 8.0\n", ""), "= 1e-4", "= 20"), ": excitation.duration is 10, but must be"},
    {valid, "beam.poissons_ratio is 0.3 (a float), but needs section.shape; ", "beam.poissons_ratio=0.3"},
    {with(strip_case, "material = 'steel'\n", ""),
     "beam.poissons_ratio is 0.3 (a float), but needs beam.youngs_modulus or beam.material; otherwise give ",
     "beam.poissons_ratio=0.3"},
    {with(strip_case, "[beam]\n", "[beam]\npoissons_ratio = 0.3\nshear_stiffness = 7.0\n"),
     ":3: beam.shear_stiffness is 7 (a float), but must be missing where beam.poissons_ratio is given"},
    {strip_case, "beam.material is stel (did you mean steel?), but must be one of ", "beam.material=stel"},
    {strip_case, "beam.area is 3 (an integer), but must be missing where section", "beam.area=3"},
    {with(strip_case, "shape = 'rectangle'\n", ""), ":7: section.shape is missing, but must be one of "},
    {with(strip_case, "height = '1.5 mm'\n", ""), ":6: section.height is missing, but a rectangle must have"},
    {workshop_case(circle + "width = 0.03\n"), ":8: section.width is 0.03 (a float), but a circle does not "},
    {workshop_case(tube + "wall_thickness = 0.011\n"), ":8: section.wall_thickness is 0.011, but must be "},
    {strip_case + "velocity_amplitude = 1\n",
     ":13: excitation.amplitude is 0.001 (a float), but must be missing where excitation.velocity"},
    {with(workshop_case(strip, "velocity_amplitude = 1\n"), "frequency_hz = '30 Hz'\n", ""),
     ": excitation.frequency_hz is missing, but a case must hold it"}};

// Every key with every kind of value: input_matrix_test.cpp; the limits of each: problem_test.cpp.
TEST_F(CaseFile, IsRefusedAtItsPlace) {
  for (const auto& [text, sentence, override] : refusals) {
    std::vector<data::Override> overrides;
    if (!override.empty()) overrides.push_back(data::Override::parse(override));
    const std::string message = error_message([&, &text = text] { return read(text, overrides); });
    const std::string place = override.empty() ? "bar.toml" : "override " + override + ": ";
    EXPECT_TRUE(message.starts_with(place + sentence)) << message << "\n" << sentence;
  }
  EXPECT_TRUE(
      error_message([&] {
        return read(valid, {{"beam.length", "1\nbeam.area = 2"}});
      }).starts_with("override beam.length=1?beam.area = 2: the value has several lines, but must be one "));
  for (const char* text : {"beam.length", "beam.length=", "=1.8", "", " = "})
    EXPECT_NE(error_message([&] { return data::Override::parse(text); }), "accepted") << text;
}

TEST_F(CaseFile, IsFoundByNameOrPath) {
  const auto file = write(valid);
  EXPECT_EQ(data::find_case(file.string()), file);
  for (const auto& none : {folder(), folder() / "bar"})
    EXPECT_NE(error_message([&] { return data::find_case(none.string()); }), "accepted") << none;
  EXPECT_EQ(error_message([&] { return data::read_case(folder()); }),
            folder().string() + ": is a folder, not a file");
  EXPECT_EQ(error_message([&] { return data::read_case(folder() / "none.toml"); }),
            "none.toml: cannot be opened for reading");
  EXPECT_TRUE(holds(error_message([] { return data::read_case("/dev/zero"); }),
                    "/dev/zero: is larger than the 1000000"));
  EXPECT_TRUE(holds(
      error_message([] { return data::load_case("papr"); }),
      "case papr is unknown (did you mean paper?), but must be a file or one of contact-leaf, damped, "));
  const std::string name = file.string().substr(0, file.string().rfind(".toml"));
  EXPECT_TRUE(holds(error_message([&] { return data::find_case(name); }), "(did you mean bar.toml?)"));
}

TEST_F(CaseFile, IsFoundInTheFolderOfTheEnvironment) {
  ::setenv("STICKSLIP_DATA", folder().c_str(), 1);
  EXPECT_TRUE(holds(error_message([] { return data::list_cases(); }), "STICKSLIP_DATA must name"));
  std::filesystem::create_directory(folder() / "cases");
  std::ofstream(folder() / "cases" / "mine.toml") << "\n# A beam of my own\n#\n" << valid;
  EXPECT_EQ(data::list_cases(), (std::map<std::string, std::string>{{"mine", "A beam of my own"}}));
  EXPECT_EQ(data::load_case("mine").beam().second_moment_of_area(), 8.25e-6);
  ::setenv("STICKSLIP_DATA", "", 1);
  EXPECT_EQ(data::load_case("paper").name, "paper");
}

STICKSLIP_VERIFIES(CaseShorthand, "P1");
class CaseShorthand : public CaseFile {
 protected:
  // With some settings, which follow from other numbers where a file states none.
  static void expect_same_numbers(const data::Case& problem, const data::Case& expected) {
    const auto numbers = data::numbers_of(problem);
    for (const auto& [path, value] : data::numbers_of(expected))
      if (!path.starts_with("numerics.")) {
        ASSERT_TRUE(numbers.contains(path)) << path;
        EXPECT_DOUBLE_EQ(numbers.at(path), value) << path;
      }
    EXPECT_EQ(numbers.size(), data::numbers_of(expected).size());
  }

  [[nodiscard]] data::Beam beam(const std::string& section, const std::string& poissons_ratio = "0.0") const {
    return read(workshop_case(section), {{"beam.poissons_ratio", poissons_ratio}}).beam();
  }
};

TEST_F(CaseShorthand, SuppliesMaterialAndFriction) {
  const data::Case problem = read(strip_case);
  EXPECT_EQ(problem.beam().length(), 0.4);
  EXPECT_EQ(problem.beam().axial_force(), 40.0);
  EXPECT_EQ(problem.beam().density(), 7850.0);
  EXPECT_EQ(problem.beam().youngs_modulus(), 2.1e11);
  EXPECT_EQ(problem.contact.friction.static_coefficient(), 0.5);
  EXPECT_EQ(problem.contact.friction.kinetic_coefficient(), 0.5);
  EXPECT_EQ(problem.contact.friction.decay(), 0.0);
  EXPECT_EQ(problem.numerics.duration(), 10.0);
  const auto materials = data::list_materials();
  EXPECT_GE(materials.size(), 10U);
  for (const data::Material& material : materials) {
    EXPECT_FALSE(material.source.empty());
    const data::Beam beam = read(strip_case, {{"beam.material", material.name}}).beam();
    EXPECT_EQ(beam.density(), material.density);
    EXPECT_EQ(beam.youngs_modulus(), material.youngs_modulus);
  }
}

// A, I and the shear coefficient k of Cowper (1966), which at nu = 0 is 5/6, 6/7 and, of a thin tube, 1/2. A tube whose wall is
// half of its diameter is a circle; a thin one has the area pi d t and I = A d^2/8, to t/d and 2 t/d of themselves, and k, whose error
// is (2 t/d)^2.
TEST_F(CaseShorthand, SuppliesAreasAndShearStiffness) {
  constexpr double pi = std::numbers::pi, thin = 1e-7;
  const Tolerance exact = round_off(10, 1, 1);
  struct Row {
    std::string section, poissons_ratio;
    double area, second_moment, coefficient;
    Tolerance tolerance;
  };
  const auto thin_tube = fmt::format("{}wall_thickness = {}\n", tube, thin);
  const auto of_the_wall = discretisation(2.0 * thin / 0.02, 2.0, "t/d");
  for (const auto& [section, ratio, area, second_moment, coefficient, tolerance] : std::vector<Row>{
           {strip, "0.0", 4.5e-5, 8.4375e-12, 5.0 / 6.0, exact},
           {strip, "0.3", 4.5e-5, 8.4375e-12, 13.0 / 15.3, exact},
           {circle, "0.0", pi * 1e-4, pi / 4.0 * 1e-8, 6.0 / 7.0, exact},
           {circle, "0.3", pi * 1e-4, pi / 4.0 * 1e-8, 7.8 / 8.8, exact},
           {tube + "wall_thickness = 0.01\n", "0.3", pi * 1e-4, pi / 4.0 * 1e-8, 7.8 / 8.8, exact},
           {thin_tube, "0.0", pi * 0.02 * thin, pi * 1e-6 * thin, 0.5, of_the_wall},
           {thin_tube, "0.3", pi * 0.02 * thin, pi * 1e-6 * thin, 2.6 / 4.9, of_the_wall}}) {
    const data::Beam made = beam(section, ratio);
    const double shear_modulus = made.youngs_modulus() / (2.0 + 2.0 * std::stod(ratio));
    EXPECT_TRUE(within(made.area() / area, 1.0, tolerance)) << section;
    EXPECT_TRUE(within(made.second_moment_of_area() / second_moment, 1.0, tolerance)) << section;
    EXPECT_TRUE(within(made.shear_stiffness() / (shear_modulus * made.area() * coefficient), 1.0, tolerance))
        << section;
  }
  // The later of two overrides counts.
  EXPECT_EQ(read(strip_case, {{"beam.poissons_ratio", "0.3"}, {"beam.shear_stiffness", "7.0"}})
                .beam()
                .shear_stiffness(),
            7.0);
}

// A case with a changed side is the case of a file with that side.
TEST_F(CaseShorthand, FollowsTheSidesOfTheSection) {
  using Names = std::vector<std::string>;
  for (const std::string ratio : {"", "poissons_ratio = 0.3\n", "shear_stiffness = 3e6\n"})
    for (const auto& [section, sides] :
         {std::pair{strip, Names{"width", "height"}},
          {circle, Names{"diameter"}},
          {tube + "wall_thickness = 2e-3\n", Names{"diameter", "wall_thickness"}}}) {
      const std::string text = with(workshop_case(section), "[beam]\n", "[beam]\n" + ratio);
      const data::Case problem = read(text);
      Names keys;
      for (const std::string& side : sides) keys.push_back("section." + side);
      if (ratio.starts_with("poissons")) keys.emplace_back("beam.poissons_ratio");
      for (const std::string& key : keys) {
        const double value = 1.1 * data::value_of(problem, key);
        data::Case expected = read(text, {{key, data::shortest_text(value)}});
        if (ratio.starts_with("shear"))  // which the file does not derive from the section
          expected = data::with_value(expected, "beam.shear_stiffness",
                                      3e6 * expected.beam().area() / problem.beam().area());
        expect_same_numbers(data::with_value(problem, key, value), expected);
      }
    }
}

TEST_F(CaseShorthand, TakesTwoSidesAtOnce) {
  const std::string text = workshop_case(tube + "wall_thickness = 2e-3\n");
  expect_same_numbers(
      data::with_values(read(text), {{"section.wall_thickness", 0.02}, {"section.diameter", 0.05}}),
      read(text, {{"section.wall_thickness", "0.02"}, {"section.diameter", "0.05"}}));
}

TEST_F(CaseShorthand, IsForgottenWithANumberOfItsOwn) {
  const data::Case problem = read(strip_case, {{"beam.poissons_ratio", "0.3"}});
  EXPECT_EQ(data::value_of(problem, "section.height"), 1.5e-3);
  EXPECT_TRUE(std::isnan(data::value_of(problem, "section.diameter")));
  for (const std::string key : {"beam.area", "beam.second_moment_of_area"}) {
    const data::Case changed = data::with_value(problem, key, 1e-6);
    EXPECT_EQ(data::value_of(changed, key), 1e-6);
    EXPECT_EQ(error_message([&] { return data::with_value(changed, "section.height", 1e-3); }),
              "section.height is 0.001, but must be left out: the case has no [section] with it");
  }
  const data::Case sheared = data::with_value(problem, "beam.shear_stiffness", 2e6);
  EXPECT_EQ(sheared.beam().shear_stiffness(), 2e6);
  EXPECT_TRUE(std::isnan(data::value_of(sheared, "beam.poissons_ratio")));
  EXPECT_EQ(data::value_of(sheared, "section.height"), 1.5e-3);
  EXPECT_THROW((void)data::with_value(problem, "beam.lenght", 1.0), std::invalid_argument);
}

// Each value as it is, and what follows from others only where it is not among them.
TEST_F(CaseShorthand, ChangesOnlyWhatIsNotGiven) {
  const data::Case problem = read(strip_case, {{"beam.shear_stiffness", "3e6"}});
  const double modulus = 2.0 * problem.beam().youngs_modulus();
  const std::vector<std::pair<std::string_view, double>> values{{"beam.youngs_modulus", modulus},
                                                                {"beam.shear_stiffness", 4e6},
                                                                {"friction.static_coefficient", 0.4},
                                                                {"friction.kinetic_coefficient", 0.2}};
  const data::Case changed = data::with_values(problem, values);
  for (const auto& [key, value] : values) EXPECT_EQ(data::value_of(changed, key), value) << key;
  EXPECT_EQ(data::with_value(problem, "beam.youngs_modulus", modulus).beam().shear_stiffness(), 6e6);
  const auto with_static = [&](double value) {
    return data::with_value(problem, "friction.static_coefficient", value)
        .contact.friction.kinetic_coefficient();
  };
  EXPECT_EQ(with_static(0.4), 0.4);
  EXPECT_EQ(with_static(0.6), 0.5);
}

// h = A0 sin(Omega t) with Omega = 60 pi rad/s.
TEST_F(CaseShorthand, TakesVelocityOrAcceleration) {
  const auto amplitude = [&](const std::string& line, const std::vector<data::Override>& overrides = {}) {
    return read(workshop_case(strip, line), overrides).excitation().amplitude();
  };
  constexpr double omega = 60.0 * std::numbers::pi;
  const auto is_near = [](double computed, double expected) {
    return within(computed, expected, round_off(4, 1, expected));
  };
  EXPECT_TRUE(is_near(amplitude("velocity_amplitude = '94 mm/s'\n"), 0.094 / omega));
  EXPECT_EQ(amplitude("velocity_amplitude = 0\n"), 0.0);
  EXPECT_TRUE(is_near(amplitude("acceleration_amplitude = '2 g'\n"), 2.0 * 9.80665 / (omega * omega)));
  EXPECT_EQ(amplitude("acceleration_amplitude = '2 g'\n", {{"excitation.amplitude", "1e-3"}}), 1e-3);
  EXPECT_TRUE(
      is_near(amplitude("amplitude = 1e-3\n", {{"excitation.velocity_amplitude", "94mm/s"}}), 0.094 / omega));
}

TEST_F(CaseShorthand, TakesTheDurationFromEitherTable) {
  const std::string older =
      with(with(valid, "modes = 10\n", "modes = 10\nduration = 3\n"), "duration = 8.0\n", "");
  EXPECT_EQ(read(older).numerics.duration(), 3.0);
  for (const std::string key : {"excitation.duration", "numerics.duration"})
    for (const std::string& text : {older, valid})
      EXPECT_EQ(read(text, {{key, "2000 ms"}}).numerics.duration(), 2.0) << key;
}

STICKSLIP_VERIFIES(PublishedCases, "P1");
TEST(PublishedCases, DifferFromThePaperWhereTheySay) {
  const std::map<std::string, std::map<std::string, double>> cases{
      {"paper-half-stiffness", {{"beam.youngs_modulus", 1e9}}},
      {"paper-figure14",
       {{"beam.area", 0.2 * 0.02},
        {"beam.second_moment_of_area", 0.2 * 0.02 * 0.02 * 0.02 / 12.0},
        {"excitation.amplitude", 1e-3}}},
      // zeta = eta omega/2 = 0.5 % at 24.972 Hz, to two digits.
      {"damped",
       {{"damping.kelvin_voigt", 6.4e-5}, {"excitation.amplitude", 1e-3}, {"excitation.duration", 0.5}}}};
  for (const auto& [name, changes] : cases) {
    auto expected = data::numbers_of(data::load_case("paper"));
    for (const auto& [key, value] : changes) expected.at(key) = value;
    for (const auto& [key, value] : data::numbers_of(data::load_case(name))) {
      if (name == "damped" && key.starts_with("numerics.")) continue;
      EXPECT_DOUBLE_EQ(value, expected.at(key)) << name << " " << key;
    }
  }
}

TEST(PublishedCases, AreListedWithATitleAndAllLoad) {
  const auto cases = data::list_cases();
  ASSERT_GE(cases.size(), 4U);
  for (const auto& [name, title] : cases) {
    EXPECT_FALSE(title.empty()) << name;
    EXPECT_NO_THROW((void)data::load_case(name)) << name;
  }
}

}  // namespace
}  // namespace stickslip::testing
