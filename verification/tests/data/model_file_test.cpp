// SPDX-License-Identifier: MIT
/// The table [model]: one mass, and matrices from files.

#include <algorithm>
#include <array>

#include "stickslip/analytic/stick_reaction.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/solver/model_system.hpp"
#include "studies/history/natural_frequencies.hpp"
#include "support/input_folder.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

const std::string
    rest =
        "[friction]\nstatic_coefficient = 0.5\n[excitation]\nfrequency_hz = 20\namplitude = '1 mm'\nduration "
        "= 2.0\n",
    mass = "[model]\nmass = '538 g'\nstiffness = '7 N/mm'\ndamping = 5.7\nnormal_force = 20\n" + rest,
    matrices =
        "[model]\nmass_matrix = 'm.mtx'\nstiffness_matrix = 'k.mtx'\nbase = [1]\ncontact = 3\n"
        "normal_force = '40 N'\n" +
        rest,
    nodes =
        "[model]\nmass_matrix = 'x.mas'\nstiffness_matrix = 'x.sti'\ndofs = 'x.dof'\n"
        "base = { nodes = 'sub/clamp.nam', direction = 'z' }\ncontact = { nodes = [37, 9], direction "
        "= 'z' }\nnormal_force = '40 N'\n" +
        rest;

const std::string banner = "%%MatrixMarket matrix ";
const std::string stiffness = banner +
                              "coordinate real symmetric\n% of a chain\n\n3 3 5\n1 1 1e3\n2 1 -1000\n2 2 "
                              "2000.\n3 2 -1000\n3 3 1000\n";
// The stiffness in other words.
const std::vector<std::string> spellings{
    stiffness,
    banner + "coordinate real symmetric\n3 3 5\n1 2 -1000\n1 1 1000\n2 3 -1000\n2 2 2000\n3 3 1000\n",
    banner +
        "Coordinate Integer General\r\n3 3 8\r\n1 1 1000\r\n1 2 -1000\r\n2 1 -1000\r\n2 2 1500\r\n2 2 "
        "500\r\n2 3 "
        "-1000\r\n3 2 -1000\r\n3 3 1000\r\n",
    banner + "array real symmetric\n3 3\n1000\n-1000\n0\n2000\n-1000\n1000\n",
    banner +
        "array real general\n3 "
        "3\n1000\n-999.999999940395355224609375\n0\n-1000.000000059604644775390625\n2000\n-1000\n0\n-"
        "1000\n1000\n"};

class ModelFile : public ::testing::Test {
 protected:
  ModelFile() {
    write("k.mtx", stiffness);
    write("m.mtx", banner + "coordinate real symmetric\n3 3 2\n2 2 1.5\n3 3 2.5\n");
    std::filesystem::create_directory(folder_.path() / "sub");
    write("sub/clamp.nam",
          "** Names based on clamp\n*NSET,NSET=Nclamp \n1, \n2, \n*ELSET,ELSET=Eclamp\n7,\n");
    write("x.dof", "1.1\n1.3\n2.3\n37.3\n9.1\n9.3\n");
    write("x.sti", "1 1 5.0\n1 2  -1.0\n2 2 7\n3 3 8\n4 4 9\n5 5 10\n6 6 11\n");
    write("x.mas", "1 1 1e-3\n 6 6 0.0e+00\n");
  }

  void write(const std::string& name, const std::string& text) const { (void)folder_.write(name, text); }
  [[nodiscard]] data::Case read(const std::string& text,
                                const std::vector<data::Override>& overrides = {}) const {
    return data::read_case(folder_.write("rig.toml", text), overrides);
  }
  [[nodiscard]] data::StructureMatrices matrices_of(const std::string& text,
                                                    const std::vector<data::Override>& overrides = {}) const {
    return read(text, overrides).model()->matrices();
  }
  [[nodiscard]] std::string refusal(const std::string& text,
                                    const std::vector<data::Override>& overrides = {}) const {
    return folder_.error_message([&] { (void)read(text, overrides); });
  }
  [[nodiscard]] std::string refused(const std::string& text, const std::string& key,
                                    const std::string& value) const {
    std::string sentence = refusal(text, {{key, value, "--set"}});
    return sentence.starts_with("--set: ") ? sentence.substr(7) : sentence;
  }

 private:
  const InputFolder folder_;
};

using Entries = std::vector<data::MatrixEntry>;
const Entries chain{{0, 0, 1e3},  {0, 1, -1e3}, {1, 0, -1e3}, {1, 1, 2e3},
                    {1, 2, -1e3}, {2, 1, -1e3}, {2, 2, 1e3}};

STICKSLIP_VERIFIES(ModelFile, "P1");
TEST_F(ModelFile, HoldsOneMass) {
  const data::Case problem = read(mass);
  const auto& one = problem.model()->properties();
  EXPECT_EQ((std::array{one.mass, one.stiffness, one.damping, one.normal_force}),
            (std::array{0.538, 7e3, 5.7, 20.0}));
  const auto numbers = data::numbers_of(problem);
  EXPECT_EQ(data::numbers_of(data::case_with("again", numbers)), numbers);
  EXPECT_FALSE(numbers.contains("beam.length") || numbers.contains("damping.ratio"));
  EXPECT_TRUE(std::isnan(data::value_of(problem, "beam.length")));  // so no command varies it
  const data::Case changed = data::with_values(problem, {{"model.mass", 2.0}, {"excitation.force", 3.0}});
  EXPECT_EQ(changed.model()->properties().mass, 2.0);
  EXPECT_TRUE(changed.excitation().is_force());
  EXPECT_TRUE(read(mass, {{"wall.with_base", "true"}}).contact.wall.moves_with_base());
}

TEST_F(ModelFile, HoldsMatricesInEverySpelling) {
  for (const std::string& text : spellings) {
    write("k.mtx", text);
    const auto read = matrices_of(matrices);
    EXPECT_EQ(read.rows, 3);
    EXPECT_EQ(read.stiffness, chain) << text;
    EXPECT_EQ(read.mass, (Entries{{1, 1, 1.5}, {2, 2, 2.5}}));
    EXPECT_EQ(read.base, std::vector{0});
    EXPECT_EQ(read.contact, std::vector{data::WeightedRow{2}});
    EXPECT_EQ(read.files.at(1).sha256, data::sha256(text));
  }
  const auto damped = matrices_of(matrices, {{"model.damping_matrix", "m.mtx"}, {"model.units", "mm"}});
  EXPECT_EQ(damped.damping, (Entries{{1, 1, 1.5e3}, {2, 2, 2.5e3}}));
  EXPECT_EQ(damped.stiffness.front().value, 1e6);
  const data::Case first = read(matrices), second = read(matrices, {{"model.normal_force", "40"}});
  EXPECT_EQ(*first.model(), *second.model());  // plans and maps keep one copy
  EXPECT_FALSE(*first.model() == *read(matrices, {{"model.base", "[2]"}}).model());
}

TEST_F(ModelFile, NamesRowsByNodes) {
  const auto made = matrices_of(nodes);
  EXPECT_EQ(made.base, (std::vector{1, 2}));
  EXPECT_EQ(made.fixed, std::vector{0});  // node 1 in x
  EXPECT_EQ(made.contact, (std::vector<data::WeightedRow>{{3, 0.5}, {5, 0.5}}));
  EXPECT_EQ(made.mass, (Entries{{0, 0, 1e-3}}));
  EXPECT_EQ(made.stiffness.size(), 8U);
  const auto loaded =
      matrices_of(nodes, {{"model.load", "{ nodes = 9, direction = ['x', 'z'], weights = [2, -1.0] }"},
                          {"model.contact", "{ rows = [4, 6], weights = [0.25, 0.75] }"},
                          {"excitation.force", "3 N"}});
  EXPECT_EQ(loaded.load, (std::vector<data::WeightedRow>{{4, 2.0}, {5, -1.0}}));
  EXPECT_EQ(loaded.contact, (std::vector<data::WeightedRow>{{3, 0.25}, {5, 0.75}}));
}

TEST_F(ModelFile, TakesADampingRatioOfEachMode) {
  const data::Case problem = read(matrices, {{"damping.ratios", "['2 %', 0.03]"}});
  EXPECT_EQ(
      (std::array{problem.damping.ratio_of(1), problem.damping.ratio_of(2), problem.damping.ratio_of(9)}),
      (std::array{0.02, 0.03, 0.03}));
  for (const std::string list : {"[]", "0.02", "[1.5]", "['x']"})
    EXPECT_TRUE(refused(matrices, "damping.ratios", list).starts_with("damping.ratios is ")) << list;
}

TEST_F(ModelFile, RefusesWhatDoesNotGoTogether) {
  for (const auto& [text, key, value, sentence] : std::vector<std::array<std::string, 4>>{
           {mass, "beam.axial_force", "3",
            "is 3 (an integer), but must be left out where [model] is given: its "
            "force is model.normal_force"},
           {mass, "damping.ratio", "0.1",
            "is 0.1 (a float), but must be left out with one mass, whose damper is "},
           {mass, "numerics.elements", "9",
            "is 9 (an integer), but must be left out where the table [model] is "},
           {matrices, "model.mass", "1", "is 1 (an integer), but must be left out: it is for one mass alone"},
           {matrices, "initial.position", "1",
            "is 1 (an integer), but must be left out: it is for one mass "},
           {matrices, "excitation.constant_force", "1",
            "is 1 (an integer), but must be left out: it is for one"},
           {matrices, "excitation.force", "3",
            "is 3, but must be left out without model.load, the rows that "},
           {matrices, "model.load", "2",
            "is given, but must be left out without excitation.force, which acts "},
           {mass, "initial.position", "inf", "is inf, but must be a finite number"},
           {matrices, "model.contact", "1", "is row 1, but must be a row apart from model.base"},
           {matrices, "model.contact", "4", "is row 4, but must be rows from 1 to 3"},
           {matrices, "model.contact", "[2, 3]",
            "is an array, but must be a row from 1, or { rows = [41, 43], "
            "weights = [0.5, 0.5] }, or { nodes = [37], direction = \"z\" }: a "
            "case has one contact"},
           {matrices, "model.contact", "{ rows = [2, 3], weights = [0.5, 0.6] }",
            "is given with weights of sum 1.1"},
           {matrices, "model.contact", "{ rows = [2, 3], weights = [1] }",
            "is given with 1 weights, but must be "
            "given with 2, one for each row"},
           {matrices, "model.contact", "{ rows = [3, 3] }", "is row 3 twice, but must be different rows"},
           {matrices, "model.contact", "{ rows = [3], mode = 1 }", "is given with mode, but must be a row"},
           {matrices, "model.contact", "{ nodes = [3], direction = 'z' }",
            "is given by nodes, but must be given by "
            "rows where model.dofs is missing"},
           {matrices, "model.base", "{ rows = [1], direction = 'z' }",
            "is given with direction and rows, but "},
           {matrices, "model.base", "[0]", "is 0 (an integer), but must be rows from 1, as [1, 2], or "},
           {matrices, "model.fixed", "[1]", "is row 1, but must be a row apart from model.base"},
           {matrices, "model.mass_matrix", "../m.mtx",
            "is ../m.mtx, but must be a file in the folder of the case "},
           {matrices, "model.units", "inch", "is inch, but must be one of m, mm"},
           {nodes, "model.base", "{ nodes = [1, 3], direction = 'z' }",
            "is node 3 in z, but must be a degree of "
            "freedom of model.dofs: *BOUNDARY takes "},
           {nodes, "model.base", "{ nodes = [1], direction = 'w' }",
            "is given with direction 'w' (a string), but "},
           {nodes, "model.contact", "{ nodes = [1], direction = 'x' }",
            "is row 1, but must be a row apart from "
            "the held directions of model.base"}})
    EXPECT_TRUE(refused(text, key, value).starts_with(key + " " + sentence))
        << key << " " << refused(text, key, value);
  const auto lacks = [&](std::string text, const std::string& line) {
    return refusal(text.erase(text.find(line), text.find('\n', text.find(line)) - text.find(line)));
  };
  EXPECT_TRUE(holds(lacks(matrices, "base = "), "model.base is missing, but a case must hold it unless "));
  EXPECT_TRUE(holds(lacks(matrices, "contact = "), "model.contact is missing, but a case must hold it "));
  EXPECT_TRUE(
      holds(lacks(matrices, "stiffness_"), "model.stiffness_matrix is missing, but a case must hold it"));
  EXPECT_TRUE(
      holds(lacks(mass, "mass = "), "model.mass is missing, but a case must hold it or model.mass_matrix"));
  EXPECT_TRUE(
      holds(refusal(matrices + "[damping]\nratio = 0.1\n", {{"model.damping_matrix", "m.mtx"}}),
            "rig.toml:14: damping.ratio is 0.1, but must be left out where model.damping_matrix is given"));
  EXPECT_TRUE(holds(error_message_of<data::InputError>([] {
                      (void)data::load_case("paper", {{"model.normal_force", "3"}});
                    }),
                    "left out with a [beam], whose force is beam.axial_force"));
  EXPECT_TRUE(holds(error_message_of<data::FieldError>(
                        [&] { (void)data::with_value(read(mass), "beam.axial_force", 3.0); }),
                    "its force is model.normal_force"));
}

TEST_F(ModelFile, RefusesFilesInOneSentence) {
  const std::string symmetric = banner + "coordinate real symmetric\n";
  for (const auto& [text, sentence] : std::vector<std::pair<std::string, std::string>>{
           {"", "k.mtx: is empty"},
           {symmetric + "3 3 1\n1 1\n", "k.mtx:3: holds 2 words, but must hold 3: row, column, value"},
           {symmetric + "3 3 1\n1 1 2,5\n", "k.mtx:3: holds 4 words, but must hold 3: row, column, value"},
           {symmetric + "3 3 2\n1 1 2\n", "k.mtx: has 1 entries, but must have 2 as it says"},
           {symmetric + "3 3 1\n1 1 2\n2 2 2\n", "k.mtx: has more entries, but must have 1 as it says"},
           {symmetric + "3 3 1\n4 1 2\n", "k.mtx:3: row is 4, but must be an integer from 1 to 3"},
           {symmetric + "3 3 1\n1 1 nan\n", "k.mtx:3: value is nan, but must be a finite number"},
           {symmetric + "3 2 1\n1 1 1\n", "k.mtx:2: the matrix has 3 rows and 2 columns, but must be square"},
           {symmetric + "4 4 1\n1 1 1\n", "m.mtx: has 3 rows, but must have 4 as k.mtx"},
           {symmetric + "2000000000 2000000000 1\n1 1 1\n",
            "k.mtx: has 1 entries, but must have 1 as it says"},
           {symmetric + "3 3 2\n1 2 1\n3 2 1\n",
            "k.mtx: has entries above and below the diagonal, but of a "},
           {symmetric, "k.mtx:1: ends, but must go on with the numbers of rows and columns"},
           {banner + "coordinate complex general\n3 3 0\n",
            "k.mtx:1: begins with complex as word 4, but must have"},
           {banner + "array real general\n3 3\n1 2 3\n", "k.mtx: has 3 entries, but must have 9 as it says"},
           {banner + "coordinate real general\n3 3 2\n1 1 1\n1 2 1\n",
            "k.mtx: has entries above the diagonal alone, but must hold both triangles or be called "
            "symmetric"},
           {banner + "coordinate real general\n3 3 2\n1 2 1\n2 1 1.1\n",
            "k.mtx: entry 1 2 is 1 and entry 2 1 is 1.1, but the matrix must be symmetric to 1e-9 of its "
            "largest"},
           {std::string("PK\3\4\0", 5), "k.mtx: holds bytes of 0, but must be a text"},
           {"1 1 5.0\n",
            "k.mtx:1: begins with 1, but must begin with %%MatrixMarket where model.dofs is missing"}}) {
    write("k.mtx", text);
    EXPECT_TRUE(refusal(matrices).starts_with(sentence)) << refusal(matrices);
  }
  write("x.sti", "7 7 1.0\n");
  EXPECT_EQ(refusal(nodes), "x.sti:1: row is 7, but must be an integer from 1 to 6");
  write("x.sti", "6 6 1.0\n");
  write("sub/clamp.nam", "*NSET,NSET=A\n1\n*NSET,NSET=B\n2\n");
  EXPECT_EQ(refusal(nodes), "sub/clamp.nam:3: begins a second set of nodes, but there must be one");
  write("x.dof", "1.1\n13\n");
  EXPECT_EQ(refusal(nodes), "x.dof:2: is 13, but must be a node and its direction, as 37.3");
  EXPECT_EQ(refused(nodes, "model.dofs", "none.dof"), "none.dof: cannot be opened for reading");
}

// A cantilever of two C3D20 elements, written by ccx 2.20. Its mass is 20 kg, in three directions.
class CalculixFile : public ::testing::Test {
 protected:
  const std::string folder = STICKSLIP_SOURCE_DIRECTORY "/data/cases/";
  const data::Case problem = data::read_case(folder + "solid-cantilever.toml");
  const data::StructureMatrices& made = problem.model()->matrices();
};

STICKSLIP_VERIFIES(CalculixFile, "P1");
TEST_F(CalculixFile, HoldsTheStructure) {
  EXPECT_EQ(made.rows, 96);
  EXPECT_EQ(made.base.size(), 8U);
  EXPECT_EQ(made.fixed.size(), 16U);
  EXPECT_EQ(made.contact, (std::vector<data::WeightedRow>{{83, 0.5}, {86, 0.5}}));
  double sum = 0.0;
  std::vector<double> moved(static_cast<std::size_t>(made.rows));  // as a rigid body
  for (const auto& entry : made.mass) sum += entry.value;
  for (const auto& entry : made.stiffness) moved.at(static_cast<std::size_t>(entry.row)) += entry.value;
  EXPECT_TRUE(within(sum, 60.0, round_off(1e3, 1.0, 60.0)));
  for (const double force : moved)
    EXPECT_TRUE(within(force, 0.0, round_off(1e3, 1.0, made.stiffness.front().value)));
}

// To the seven digits that ccx prints.
TEST_F(CalculixFile, HasTheFrequenciesOfCalculix) {
  const data::Case node = data::read_case(folder + "solid-cantilever.toml",
                                          {{"model.contact", "{ nodes = [28], direction = 'z' }"}});
  const auto held = analytic::TipSupport::held;
  const std::string text =
      data::read_table_text(STICKSLIP_SOURCE_DIRECTORY "/verification/tests/data/calculix-frequencies.csv");
  using Frequencies =
      std::vector<studies::EstimatedFrequency> (*)(const data::Case&, analytic::TipSupport, int);
  for (const Frequencies frequencies :
       {Frequencies{studies::closed_form_frequencies}, Frequencies{studies::mesh_frequencies}}) {
    const std::array computed{frequencies(problem, analytic::TipSupport::free, 8), frequencies(node, held, 8),
                              frequencies(problem, held, 8)};
    data::CsvReader csv("frequencies.csv", text);
    std::size_t mode = 0;
    for (; const auto row = csv.next_row(); ++mode)
      for (std::size_t i = 0; i < computed.size(); ++i) {
        const double printed = csv.number((*row)[i]).value();
        const auto& [hz, error] = computed.at(i).at(mode);
        EXPECT_TRUE(within(hz / printed, 1.0, reference(1e-6 + error, "seven digits and estimate")))
            << printed;
      }
    EXPECT_EQ(mode, 8U);
  }
}

// 20 of 71 modes with their residual mass, against all rows.
TEST_F(CalculixFile, NeedsTwentyModes) {
  for (const char* hz : {"5", "25", "50", "120"}) {
    const data::Case at =
        data::read_case(folder + "solid-cantilever.toml", {{"excitation.frequency_hz", hz}});
    const double rows = solver::steady_reaction_of(at);
    const analytic::Bounds modes = analytic::steady_reaction(at);
    const double bound = 0.5 * (modes.upper - modes.lower);
    EXPECT_LE(bound, 1e-5 * rows) << hz;  // the accuracy asked for
    EXPECT_TRUE(within(modes.midpoint(), rows,
                       discretisation(bound + 1e-7 * rows, 1.0, "bound; eps at a condition of 1e8")))
        << hz;
  }
}

}  // namespace
}  // namespace stickslip::testing
