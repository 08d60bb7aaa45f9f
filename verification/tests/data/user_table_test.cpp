// SPDX-License-Identifier: MIT
/// Somebody else's CSV files: every spelling that is understood gives the same numbers, and what cannot be
/// used is refused in one sentence that names file, line, column and value. second_judge_test.py asks another reader.

#include <zlib.h>

#include "stickslip/data/case_file.hpp"
#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/user_table.hpp"
#include "support/input_folder.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

const data::ReferencePackage& package() {
  static const auto fixture = data::load_reference(std::filesystem::path(STICKSLIP_SOURCE_DIRECTORY) /
                                                   "verification/tests/golden/reference");
  return fixture;
}

const std::string frequencies = "stick-frequencies", header = "beam,mode,frequency\n";

std::string gzip(const std::string& text) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string plain = text, packed(deflateBound(&stream, plain.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(plain.data());
  stream.avail_in = static_cast<uInt>(plain.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

class UserTable : public ::testing::Test {
 protected:
  [[nodiscard]] data::UserTable read(const std::string& set, const std::string& text,
                                     const std::vector<std::string>& mappings = {},
                                     const std::vector<std::string>& names = {}) const {
    std::vector<data::ColumnMapping> parsed;
    for (const std::string& mapping : mappings) parsed.push_back(data::ColumnMapping::parse(mapping));
    return data::read_user_table(folder_.write("mine.csv", text), data::read_table(package(), set), parsed,
                                 names);
  }

  // The first number of a column.
  [[nodiscard]] double first(const std::string& column, const std::string& set, const std::string& text,
                             const std::vector<std::string>& mappings = {}) const {
    return read(set, text, mappings).column(column)->values[0];
  }

  [[nodiscard]] std::string error_message(const std::string& set, const std::string& text,
                                          const std::vector<std::string>& mappings = {}) const {
    return folder_.error_message([&] { static_cast<void>(read(set, text, mappings)); });
  }

  const InputFolder folder_;
};

STICKSLIP_VERIFIES(UserTable, "P5");
TEST_F(UserTable, IsTheSameHoweverItIsSpelled) {
  const std::vector<std::string> spellings{
      "beam,mode,frequency\npaper,1,25\npaper,2,81.5\n",
      "mode,frequency,beam\n1,25,paper\n2,81.5,paper\n",
      "sep=;\nbeam;mode;frequency\npaper;1;25\npaper;2;81.5\n",
      "\"sep=,\"\r\nbeam,mode,frequency\r\npaper,1,25\r\npaper,2,81.5\r\n",
      "Beam,MODE,Frequency\npaper,1,25\npaper,2,81.5",
      "beam\tmode\tfrequency\npaper\t1\t25\npaper\t2\t81.5\n",
      "\xEF\xBB\xBF"
      "beam,mode,frequency\npaper,1,25\npaper,2,81.5\n",
      "# by hand\n\nbeam,mode,frequency\n# the first\npaper,1,25\n\n  # and the second\npaper,2,81.5\n",
      " beam , mode,  frequency\n paper ,1 , 25\npaper,2,81.5  \n",
      "\"beam\",\"mode\",\"frequency\"\n\"paper\",\"1\",\"25\"\n\"paper\" , 2,81.5\n",
      "beam,mode,frequency\npaper,1.0,+2.5e+1\npaper,2,8.15E1\n",
      "beam,mode,frequency,remark\npaper,1,25,\"a, \"\"b\"\"\"\npaper,2,81.5,\n",
      "beam;mode;frequency;remark\npaper;1;25;a,b\npaper;2;81.5;c\n",
      "beam,mode,frequency,\"a; b\"\npaper,1,25,a\npaper,2,81.5,b\n",
      "beam,mode,frequency\rpaper,1,25\rpaper,2,81.5\r",
      "  beam   mode  frequency\n paper  1\t 2.5d+01 \n paper  2  8.15D+01\n",
      "# beam mode frequency\npaper 1 2.5e+01\npaper 2 8.15e+01\n",
      "# made today\n#beam,mode,frequency\n# - - -\n# end\npaper,1,25\npaper,2,81.5\n",
      "# made by hand\n# beam mode frequency\npaper 1 25\npaper 2 81.5\n",
      "# beam mode frequency\n# - - kHz\npaper 1 0.025\npaper 2 0.0815\n",
      "beam mode frequency [kHz]\npaper 1 0.025\npaper 2 0.0815\n",
      "beam mode frequency ( kHz )\npaper 1 0.025\npaper 2 0.0815\n",
      "beam,mode,frequency\n,,[kHz]\npaper,1,0.025\npaper,2,0.0815\n",
      "beam,mode,frequency\n,,(kHz)\npaper,1,0.025\npaper,2,0.0815\n",
      "% by hand\nbeam;mode;frequency\n-;1;kHz\npaper;1;0,025\npaper;2;0,0815\n",
      "\"beam\" \"mode\" \"frequency\"\n\"1\" \"paper\" 1 25\n\"2\" \"paper\" 2 81.5\n",
      gzip("beam,mode,frequency\npaper,1,25\npaper,2,81.5\n"),
      gzip("beam,mode,frequency\npaper,1,") + gzip("25\npaper,2,81.5\n")};
  for (const std::string& text : spellings) {
    const auto table = read(frequencies, text);
    ASSERT_EQ(table.rows(), 2u) << text;
    EXPECT_EQ(table.column("frequency")->values, (std::vector<double>{25.0, 81.5})) << text;
    EXPECT_EQ(table.column("mode")->values, (std::vector<double>{1.0, 2.0})) << text;
    EXPECT_EQ(table.column("beam")->text, (std::vector<std::string>{"paper", "paper"})) << text;
    EXPECT_EQ(table.column("remark"), nullptr);
    EXPECT_EQ(table.columns.size(), 3u);
  }
}

TEST_F(UserTable, ConvertsAUnitWhereverItStands) {
  for (const std::string name :
       {"frequency [kHz]", "frequency (kHz)", "frequency_kHz", "frequency/kHz", "Frequency / kHz",
        "frequency[kHz]", "\"frequency [kHz]\"", "frequency [ kHz ]"})
    EXPECT_EQ(first("frequency", frequencies, "beam,mode," + name + "\npaper,1,0.025\n"), 25.0) << name;
  // The unit of a mapping counts more than that of the header, and the mapping more than the name.
  for (const auto& [names, mapping] : {std::pair{"f1,f2", "frequency=f1:kHz"},
                                       {"f1,f2", " Frequency = F1 : kHz"},
                                       {"f1_mHz,f2", "frequency=f1_mHz:kHz"},
                                       {"f1 [kHz],f2", "frequency=f1"},
                                       {"f1_kHz,frequency", "frequency=f1"}})
    EXPECT_EQ(
        first("frequency", frequencies, fmt::format("beam,mode,{}\npaper,1,0.025,7\n", names), {mapping}),
        25.0)
        << names << " " << mapping;
  EXPECT_EQ(first("frequency", frequencies, header + "paper,1,1\n"), 1.0);  // a number, no unit
  // Powers of ten divide, to the nearest number.
  const auto table = read("stick-force", "t_ms,friction_force_mN\n9,300\n18,7\n");
  EXPECT_EQ(table.column("t")->values, (std::vector<double>{0.009, 0.018}));
  EXPECT_EQ(table.column("friction_force")->values, (std::vector<double>{0.3, 0.007}));
}

TEST_F(UserTable, NeedsNoKeyThatHasOneValue) {
  data::ReferenceTable reference = data::read_table(package(), frequencies);
  for (data::Column& column : reference.columns) {
    column.text.resize(1);
    column.values.resize(1);
  }
  reference.resource.fields[1].name = reference.resource.primary_key[1] = "index";
  reference.columns[1].field.name = "index";
  const auto read_one = [&](const std::string& text) {
    return data::read_user_table(folder_.write("mine.csv", text), reference);
  };
  EXPECT_EQ(read_one("frequency\n25\n").column("index")->values, std::vector{1.0});
  EXPECT_EQ(folder_.error_message([&] { (void)read_one("frequency\n25\n26\n"); }),
            "mine.csv:3: beam = paper, index = 1 stands in line 2 already, but must stand once");
}

TEST_F(UserTable, NeedsNoNumberOfEvents) {
  const auto events = read("damped-events", "time [ms],change\n55,onset\n68,capture\n");
  EXPECT_EQ(events.column("index"), nullptr);
  EXPECT_EQ(events.column("time")->values, (std::vector<double>{0.055, 0.068}));
  EXPECT_EQ(events.column("change")->text, (std::vector<std::string>{"onset", "capture"}));
  EXPECT_EQ(read("damped-events", "time,change\n0.1,onset\n0.1,capture\n").rows(), 2u);    // may coincide
  EXPECT_EQ(read("damped-events", "# time change\n0.1 onset\n0.2 capture\n").rows(), 2u);  // half are numbers
  EXPECT_EQ(read("stick-force", "t,friction_force\n0,1\n0.001,2\n0.001,3\n").rows(), 3u);
}

TEST_F(UserTable, KnowsTheColumnsOfOwnHistories) {
  const auto history = read("damped-history", "time_s,tip_displacement_m,state\n0.5,1,stick\n");
  EXPECT_EQ(history.column("t")->values[0], 0.5);
  EXPECT_EQ(history.column("phase")->text[0], "stick");
  EXPECT_EQ(
      read("damped-history", "t,phase,state,tip_displacement\n0,slip,stick,1\n").column("phase")->text[0],
      "slip");
  EXPECT_EQ(first("time", "damped-events", "t [ms],change\n500,onset\n"), 0.5);
  EXPECT_EQ(first("position", "damped-events", "time_s,change,tip_displacement_m\n0.5,onset,2\n"), 2.0);
}

struct Refusal {
  std::string text, sentence;  // how it begins
  std::string set{frequencies};
  std::vector<std::string> mappings{};
};
const std::vector<Refusal> refusals{
    {"", ": is empty"},
    {"# nothing\n\n", ":2: there is no line with the names of the columns"},
    {header, ":1: the table has no rows, but must have at least one"},
    {"1.607 2 25\n7.231 3 81.5\n", ":1: the line is numbers, not the names of the columns (--columns NAME,"},
    {"1 2 25\n3 4 5\n", ":1: the line is numbers", frequencies, {"beam=1", "mode=2", "frequency=25"}},
    {"beam,mode\npaper,1\n", ":1: the column frequency is missing; the file has beam, mode (--column "},
    {"# a\n# beam mode f\npaper 1 25\n", ":2: the column frequency is missing; the file has beam, mode, f"},
    {"beam,mode,f\np,1,2\n", ":1: the column g (for frequency) is missing", frequencies, {"frequency=g:Hz"}},
    {"beam,mode,f\np,1,2\n",
     ":1, column 3 (f): the unit of frequency is 'x'",
     frequencies,
     {"frequency=f:x"}},
    {"beam,mode,frequency [mm]\np,1,2\n", ":1, column 3 (frequency [mm]): the unit of frequency is 'mm'"},
    {"beam,mode,frequency [THz]\np,1,2\n", ":1, column 3 (frequency [THz]): the unit of frequency is 'THz'"},
    {header + ",,mm\np,1,2\n", ":1, column 3 (frequency [mm]): the unit of frequency is 'mm'"},
    {header + "p,1,25 Hz\n", ":2, column 3 (frequency): frequency is '25 Hz', but must be a finite"},
    {header + "p,1,\"25,0\"\n", ":2, column 3 (frequency): frequency is '25,0', but must be a finite"},
    {"beam;mode;frequency\np;1;1.025,0\n", ":2, column 3 (frequency): frequency is '1.025,0', but must be"},
    {header + "-,1,kHz\n,1,25\n", ":3, column 1 (beam): beam is '', but must be a word"},
    {header + "-,1,kHz\np,1.5,25\n", ":3, column 2 (mode): mode is '1.5', but must be an integer"},
    {"beam,mode,frequency_MHz\np,1,1e308\n",
     ":2, column 3 (frequency_MHz): frequency is '1e308', but must be a"},
    {header + ",kHz\n", ":2: the line has 2 cells, but must have 3 as the line of names has"},
    {header + "p,1,25,7\n", ":2: the line has 4 cells, but must have 3 as the line of names has"},
    {header + "p,1,\"25\n", ":2: a quote is not closed, or something follows it"},
    {header + "\"p\"x,1,25\n", ":2: a quote is not closed, or something follows it"},
    {header + "p,1,2\np,2,3\np,1,4\n",
     ":4: beam = p, mode = 1 stands in line 2 already, but must stand once"},
    {"t,friction_force\n0.2,1\n0.1,2\n", ":3, column 1 (t): t is 0.1, but must not be below 0.2",
     "stick-force"},
    {"time,change\n2,onset\n1,capture\n", ":3, column 1 (time): time is 1, but must not be", "damped-events"},
    {"index,time,change\n1,1,onset\n1,2,capture\n", ":3: index = 1 stands in line 2 already",
     "damped-events"},
    // Other formats than text, by how they begin.
    {"beam,mode,frequency [\xB5Hz]\np,1,25\n", ":1: the name of a column is no text in UTF-8 (Latin-1?)"},
    {"\xFF\xFE?", ": is text in UTF-16, but must be in UTF-8"},
    {"\xFE\xFF?", ": is text in UTF-16, but must be in UTF-8"},
    {std::string("beam\0\n", 6), ": is no text in UTF-8"},
    {" {\"beam\": 1}\n", ": is a JSON file, but must be a table in text, as CSV"},
    {"[{\"beam\": 1}]", ": is a JSON file"},
    {"<?xml version=\"1.0\"?>", ": is an XML or HTML file"},
    {"PAR1\x15", ": is a Parquet file"},
    {"---\nbeam: paper\n", ": is a YAML file"},
    {"***** ANSYS *****\n", ": is an input or output file of a finite-element program"},
    {"\x89HDF\r\n", ": is a file in HDF5 format"},
    {"PK\x03\x04", ": is a zip archive"},
    {"MATLAB 5.0 MAT-file", ": is a MATLAB file"},
    {"\x93NUMPY", ": is a NumPy file"},
    {gzip(header).substr(0, 20), ": is no complete file in gzip's format"},
    {"beam\npaper\n", "the data set beams says nothing of how to compare with it", "beams"}};

TEST_F(UserTable, IsRefusedAtItsPlace) {
  for (const auto& [text, sentence, set, mappings] : refusals) {
    const std::string message = error_message(set, text, mappings);
    EXPECT_TRUE(message.starts_with((sentence.starts_with(':') ? "mine.csv" : "") + sentence))
        << message << "\n"
        << sentence;
  }
}

TEST_F(UserTable, MayBeLargeOnceDecompressed) {
  const std::string million = gzip(std::string(1'000'000, ' '));
  std::string packed;
  for (std::size_t size = 0; size < data::limit::table_bytes.most; size += 1'000'000) packed += million;
  EXPECT_EQ(data::read_table_text(folder_.write("mine.csv", packed)).size(), data::limit::table_bytes.most);
  EXPECT_EQ(folder_.error_message(
                [&] { (void)data::read_table_text(folder_.write("mine.csv", packed + gzip(" "))); }),
            "mine.csv: holds more than the 50000000 bytes that are allowed");
}

TEST_F(UserTable, TakesTheNamesThatAreGiven) {
  const std::string words = "paper,1,25\npaper,2,81.5\n";
  for (const auto& [text, names] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {words, {"beam", "mode", "frequency"}},
           {"# by hand\n0 paper 1 0.025 0\n0 paper 2 0.0815 0\n",
            {"-", "beam", "mode", "frequency [kHz]", "-"}}}) {
    const auto table = read(frequencies, text, {}, names);
    EXPECT_EQ(table.column("frequency")->values, (std::vector<double>{25.0, 81.5}));
    EXPECT_EQ(table.column("mode")->values, (std::vector<double>{1.0, 2.0}));
  }
  EXPECT_EQ(folder_.error_message([&] {
    (void)read(frequencies, words, {}, {"beam", "mode", "frequency", "-"});
  }),
            "mine.csv:1: the line has 3 cells, but must have 4, one for each name");
}

STICKSLIP_VERIFIES(ColumnMapping, "P5");
TEST(ColumnMapping, NamesTheirsAndTheUnit) {
  const auto mapping = data::ColumnMapping::parse(" frequency = f 1 : rad/s ");
  EXPECT_EQ(mapping.reference, "frequency");
  EXPECT_EQ(mapping.theirs, "f 1");
  EXPECT_EQ(mapping.unit, "rad/s");
  EXPECT_EQ(data::ColumnMapping::parse("a=b").unit, "");
  EXPECT_EQ(data::ColumnMapping::parse("a=b:1:kHz").theirs, "b:1");
  for (const char* text : {"", "=", "a", "a=", "=b", "a=:kHz", " = "})
    EXPECT_THROW((void)data::ColumnMapping::parse(text), data::InputError) << text;
}

TEST(ColumnMapping, MustBeOfAColumnThatThereIs) {
  const auto history = data::read_table(package(), "damped-history"),
             events = data::read_table(package(), "damped-events");
  const auto require_known = [&](const std::vector<std::string>& texts) {
    std::vector<data::ColumnMapping> mappings;
    for (const std::string& text : texts) mappings.push_back(data::ColumnMapping::parse(text));
    data::require_known_columns(mappings, {&history, &events});
  };
  EXPECT_NO_THROW(require_known({"T=time", "position=y"}));
  expect_error_message<data::InputError>(
      [&] { require_known({"positon=y"}); },
      {"column positon is unknown (did you mean position?), but must be one of t, "});
  expect_error_message<data::InputError>(
      [&] {
        require_known({"Time=a", "time=b"});
      },
      {"column Time is given 2 times, but must be given once"});
}

}  // namespace
}  // namespace stickslip::testing
