// SPDX-License-Identifier: MIT
/// The table [uncertainty] of a case file: what it says is read, anything else refused in one sentence.

#include "stickslip/data/uncertainty.hpp"
#include "stickslip/data/case_file.hpp"
#include "support/input_folder.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

class UncertaintyTable : public ::testing::Test {
 protected:
  // The paper's case, without its static coefficient if so asked, and the table.
  [[nodiscard]] std::filesystem::path write(const std::string& table,
                                            bool without_coefficient = false) const {
    std::ifstream paper(data::find_case("paper"));
    std::string text;
    for (std::string line; std::getline(paper, line);)
      if (!without_coefficient || !line.starts_with("static")) text += line + '\n';
    return folder_.write("bar.toml", text + "[uncertainty]\n" + table);
  }

  // Both readers refuse it.
  [[nodiscard]] std::string error_message(const std::string& table) const {
    const auto file = write(table);
    EXPECT_THROW((void)data::read_case(file), data::InputError);
    return folder_.error_message([&] { (void)data::read_uncertainty(file); });
  }

  const InputFolder folder_;
};

const std::string normal = R"({ distribution = "normal", mean = 0.55, standard_deviation = 0.05 })";
const std::string mu = "\"friction.static_coefficient\" = " + normal + "\n";

STICKSLIP_VERIFIES(UncertaintyTable, "P7");
TEST_F(UncertaintyTable, ReadsEveryField) {
  folder_.write("e.csv", "E_Pa,n\n2.1e9,1\n1.9e9,2\n");
  const auto read = data::read_uncertainty(
      write(mu + R"("beam.length" = { distribution = "uniform", lower = "1900 mm", upper = 2 }
"beam.area" = { distribution = "lognormal", mean = 0.01, standard_deviation = 1e-4 }
"beam.axial_force" = { distribution = "triangular", lower = 400, mode = 500, upper = 700 }
"beam.density" = { distribution = "triangular", lower = 1000, mode = 1000, upper = 1300 }
"beam.shear_stiffness" = { distribution = "triangular", lower = 1e6, mode = 4e6, upper = 4e6 }
"beam.youngs_modulus" = { distribution = "samples", file = "e.csv", column = "E_Pa" }
"excitation.amplitude" = { distribution = "uniform", lower = "1 g", upper = "2 g" }
correlation = [["beam.length", "beam.area", 0.25]]
)"));
  ASSERT_EQ(read.keys.size(), 8u);
  const auto of = [&](const std::string& key) {
    return std::ranges::find(read.keys, key, &data::UncertainKey::key)->distribution;
  };
  EXPECT_EQ(of("friction.static_coefficient").mean, 0.55);
  EXPECT_EQ(of("friction.static_coefficient").standard_deviation, 0.05);
  EXPECT_EQ(of("beam.length").upper, 2.0);
  EXPECT_EQ(of("excitation.acceleration_amplitude").upper, 19.6133);
  EXPECT_EQ(of("beam.length").mean_value(), 1.95);
  EXPECT_EQ(of("beam.area").kind, data::DistributionKind::lognormal);
  EXPECT_DOUBLE_EQ(of("beam.axial_force").mean_value(), 1600.0 / 3.0);
  EXPECT_EQ(of("beam.density").mean_value(), 1100.0);
  EXPECT_EQ(of("beam.shear_stiffness").mean_value(), 3e6);
  EXPECT_EQ(of("beam.youngs_modulus").samples, (std::vector{1.9e9, 2.1e9}));
  EXPECT_EQ(of("beam.youngs_modulus").mean_value(), 2e9);
  EXPECT_EQ(std::ranges::count(read.correlation, 0.25), 2);
  EXPECT_EQ(std::ranges::count(read.correlation, 1.0), 8);
  EXPECT_TRUE(data::read_uncertainty(data::find_case("paper")).keys.empty());
}

// The mean of a key that is missing elsewhere is also what a shorthand is computed from, but does not contradict it.
TEST_F(UncertaintyTable, SuppliesTheMean) {
  EXPECT_EQ(data::read_case(write(mu)).contact.friction.static_coefficient(), 0.6);
  EXPECT_EQ(data::read_case(write(mu, true)).contact.friction.static_coefficient(), 0.55);
  const auto read = [&](const std::string& beam, const std::string& excitation, const std::string& friction,
                        const std::string& key) {
    const data::Case problem = data::read_case(folder_.write(
        "bar.toml", "[beam]\nlength = 0.4\naxial_force = 40\n" + beam +
                        "[section]\nshape = 'rectangle'\nwidth = 0.03\nheight = 1.5e-3\n[excitation]\n" +
                        excitation + "[friction]\nstatic_coefficient = 0.5\n" + friction +
                        "[uncertainty]\n\"" + key +
                        "\" = { distribution = 'normal', mean = 0.25, standard_deviation = 0.01 }\n"));
    return data::numbers_of(problem);
  };
  const std::string steel = "material = 'steel'\n", elastic = "density = 7850\npoissons_ratio = 0.0\n",
                    motion = "frequency_hz = 30\namplitude = 1e-3\n";
  EXPECT_EQ(read(steel, "velocity_amplitude = 0.1\n", "", "excitation.frequency_hz")
                .at("excitation.velocity_amplitude"),
            0.1);
  const double shear = 5.0 / 6.0 * 4.5e-5 * 0.25 / 2.0;  // k A E/2
  EXPECT_TRUE(within(read(elastic, motion, "", "beam.youngs_modulus").at("beam.shear_stiffness"), shear,
                     round_off(6, 1, shear)));
  EXPECT_EQ(
      read(steel, motion, "decay = 1.0\n", "friction.kinetic_coefficient").at("friction.kinetic_coefficient"),
      0.25);
  EXPECT_EQ(read(steel, motion, "", "beam.density").at("beam.density"), 7850.0);
}

TEST_F(UncertaintyTable, TakesSamplesInAnyUnit) {
  const auto samples = [&](const std::string& text, const std::string& column) {
    folder_.write("l.csv", text);
    const auto file =
        write("\"beam.length\" = { distribution = 'samples', file = 'l.csv', column = '" + column + "' }\n");
    return data::read_uncertainty(file).keys.front().distribution.samples;
  };
  const std::vector millimetres{0.4, 0.5}, metres{400.0, 500.0};
  for (const std::string head : {"L [mm]", "L (mm)", "L / mm", "L_mm"})
    EXPECT_EQ(samples(fmt::format("\"{}\"\n500\n400\n", head), head), millimetres) << head;
  EXPECT_EQ(samples("L [mm]\n500\n400\n", "L"), millimetres);
  EXPECT_EQ(samples("L,n\nmm,1\n500,1\n400,2\n", "L"), millimetres);
  for (const std::string head : {"L", "L [m]", "L_m", "L_s", "L_max"})
    EXPECT_EQ(samples(fmt::format("\"{}\"\n500\n400\n", head), head), metres) << head;
}

struct Refusal {
  std::string kind, rest, sentence;  // how it begins, from what is wrong with the distribution on
};
const std::vector<Refusal> refused_distributions{
    {"norml", "", ".distribution is 'norml' (a string) (did you mean normal?), but must be one of normal, "},
    {"samples", ", file = 1, column = 'L'",
     ".file is 1 (an integer), but must be a string that is not empty"},
    {"normal", ", mean = 2", ".standard_deviation is missing, but must be a finite number"},
    {"normal", ", mean = '2 s'", ".mean is '2 s' (a string), but must be a number (m) or a text of a number"},
    {"normal", ", mean = 2, standard_deviation = 0",
     ".standard_deviation is 0 (an integer), but must be above 0"},
    {"normal", ", mean = nan, standard_deviation = 1", ".mean is nan (a float), but must be a finite number"},
    {"lognormal", ", mean = 0, standard_deviation = 1", ".mean is 0 (an integer), but must be above 0 for "},
    {"uniform", ", lower = 2, upper = 2", ".upper is 2 (an integer), but must be above lower"},
    {"triangular", ", lower = 2, mode = 2, upper = 2", ".upper is 2 (an integer), but must be above lower"},
    {"triangular", ", lower = 1, mode = 4, upper = 3",
     ".mode is 4 (an integer), but must be from lower to upper"},
    {"uniform", ", lower = 1, upper = 1e9",
     ": beam.length is 1e+09, but must be from 1e-09 to 1e+06 (m) in "}};

TEST_F(UncertaintyTable, IsRefusedAtItsPlace) {
  for (const auto& [name, text] : {std::pair{"m", "M\n1\n2\n"},
                                   {"s", "L [s]\n1\n2\n"},
                                   {"x", "L [x]\n1\n2\n"},
                                   {"one", "L\n1\n"},
                                   {"large", "L\n1\n1e9\n"},
                                   {"word", "L,M\n1,1\nlong,2\n"}})
    folder_.write(name, text);
  std::vector<Refusal> distributions = refused_distributions;
  for (const auto& [file, sentence] : std::vector<std::pair<std::string, std::string>>{
           {"m", ".column is L, but must be a column of m"},
           {"s", ".column is L [s], but must be a column in one of m, cm, mm, um, nm"},
           {"x", ".column is L [x], but must be a column in one of m, cm, mm, um, nm"},
           {"one", "one: has 1 rows, but must have at least 2"},
           {"large", ": beam.length is 1e+09, but must be from 1e-09 to 1e+06 (m) in magnitude"},
           {"word", "word:3, column 1 (L): is no finite number, but must be one"},
           {"/etc/passwd", ".file is /etc/passwd, but must be a path inside the folder of the case"},
           {"../l.csv", ".file is ../l.csv, but must be a path inside the folder of the case"},
           {"a/../../l.csv", ".file is a/../../l.csv, but must be a path inside the folder of the case"},
           {"-", ".file is -, but must be a path inside the folder of the case"}})
    distributions.push_back({"samples", ", column = 'L', file = '" + file + "'", sentence});
  std::vector<std::pair<std::string, std::string>> refusals{
      {"", ":26: uncertainty has no distribution, but must have one or more"},
      {"\"beam.length\" = 1",
       ":27: uncertainty.\"beam.length\" is 1 (an integer), but must be a table with a "},
      {"\"beam.lenght\" = " + normal,
       ":27: unknown key uncertainty.beam.lenght (did you mean beam.length?), but "},
      {"\"numerics.modes\" = " + normal,
       ":27: unknown key uncertainty.numerics.modes, but must be \"correlation"},
      {"beam.length = " + normal,
       ":27: unknown key uncertainty.beam, but the key of a case must stand in quotes"},
      {"\"beam.length\" = { distribution = 'uniform', lower = 1, uper = 2 }",
       ":27: unknown key uncertainty.\"beam.length\".uper (did you mean upper?), but uniform has the keys "
       "lower, upper"}};
  for (const auto& [kind, rest, sentence] : distributions) {
    const bool is_of_the_case = sentence.starts_with('.') || sentence.starts_with(':');
    refusals.emplace_back("\"beam.length\" = { distribution = '" + kind + "'" + rest + " }\n",
                          (is_of_the_case ? ":27" : "") +
                              std::string(sentence.starts_with('.') ? ": uncertainty.\"beam.length\"" : "") +
                              sentence);
  }
  for (const auto& [table, sentence] : refusals) {
    const std::string message = error_message(table),
                      expected = (sentence.starts_with(':') ? "bar.toml" : "") + sentence;
    EXPECT_TRUE(message.starts_with(expected)) << message << "\n" << expected;
  }
}

TEST_F(UncertaintyTable, RefusesCorrelationsAtTheirPlace) {
  const std::string keys =
      mu + "\"beam.length\" = { distribution = 'uniform', lower = 1, upper = 2 }\n" +
      "\"beam.area\" = { distribution = 'uniform', lower = 1, upper = 2 }\ncorrelation = ";
  const std::string all_of_three =
      "[['beam.length', 'beam.area', 0.9], ['beam.area', 'friction.static_coefficient', 0.9], "
      "['beam.length', 'friction.static_coefficient', -0.9]]";
  for (const auto& [rows, sentence] : std::vector<std::pair<std::string, std::string>>{
           {"0.5", "is 0.5 (a float), but must be an array of rows"},
           {"[1]", "has a row that is 1 (an integer)"},
           {"[['beam.length', 'beam.area']]", "has a row that is an array of another"},
           {"[['beam.length', 'beam.width', 0.1]]", "names 'beam.width' (a string), which"},
           {"[['beam.length', 'beam.length', 0.1]]", "names beam.length twice"},
           {"[['beam.length', 'beam.area', 1]]", "has the coefficient 1"},
           {"[['beam.length', 'beam.area', -2]]", "has the coefficient -2"},
           {"[['beam.length', 'beam.area', 0], ['beam.area', 'beam.length', 0.1]]",
            "has two rows of beam.area and "},
           {all_of_three, "is contradictory, but must be a positive definite matrix"}})
    EXPECT_TRUE(
        error_message(keys + rows + "\n").starts_with("bar.toml:30: uncertainty.correlation " + sentence));
  // At the edge of what is positive definite.
  EXPECT_TRUE(data::cholesky_factor({1e-12}, 1).empty());
  EXPECT_EQ(data::cholesky_factor({1.5e-12}, 1).size(), 1u);
}

}  // namespace
}  // namespace stickslip::testing
