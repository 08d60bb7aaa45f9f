// SPDX-License-Identifier: MIT
/// Somebody else's CSV files: every spelling that is understood gives the same numbers, and what cannot be
/// used is refused in one sentence that names file, line, column and value.

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
      "beam,mode,frequency/kHz\npaper,1,0.025\npaper,2,0.0815\n",
      "Beam,MODE,Frequency\npaper,1,25\npaper,2,81.5",
      "beam;mode;frequency\npaper;1;25\npaper;2;81.5\n",
      "beam\tmode\tfrequency\npaper\t1\t25\npaper\t2\t81.5\n",
      "beam,mode,frequency\r\npaper,1,25\r\npaper,2,81.5\r\n",
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
    const auto table = read("stick-frequencies", text);
    ASSERT_EQ(table.rows(), 2u) << text;
    EXPECT_EQ(table.column("frequency")->values, (std::vector<double>{25.0, 81.5})) << text;
    EXPECT_EQ(table.column("mode")->values, (std::vector<double>{1.0, 2.0})) << text;
    EXPECT_EQ(table.column("beam")->text, (std::vector<std::string>{"paper", "paper"})) << text;
    EXPECT_EQ(table.column("remark"), nullptr);
    EXPECT_EQ(table.columns.size(), 3u);
  }
}

TEST_F(UserTable, KnowsTheLineOfEachRow) {
  const auto table = read("stick-frequencies", "# a\nbeam,mode,frequency\n\npaper,1,25\n#b\npaper,2,81\n");
  EXPECT_EQ(table.lines, (std::vector<std::size_t>{4, 6}));
  EXPECT_EQ(table.place(1), (folder_.path() / "mine.csv:6").string());
  // The 1 is a number there, and no unit.
  EXPECT_EQ(read("stick-frequencies", "beam,mode,frequency\npaper,1,1\npaper,2,25\n").rows(), 2u);
}

TEST_F(UserTable, ConvertsAUnitWhereverItStands) {
  for (const std::string header :
       {"frequency [kHz]", "frequency (kHz)", "frequency_kHz", "Frequency / kHz", "FREQUENCY_kHz",
        "frequency[kHz]", "\"frequency [kHz]\"", "frequency [ kHz ]"})
    EXPECT_EQ(first("frequency", "stick-frequencies", "beam,mode," + header + "\npaper,1,0.025\n"), 25.0)
        << header;
  const auto mapped = [&](const std::string& header, const std::string& mapping) {
    return first("frequency", "stick-frequencies", "beam,mode," + header + "\npaper,1,0.025,7\n", {mapping});
  };
  for (const std::string mapping : {"frequency=f1:kHz", "frequency = f1 : kHz", "Frequency=F1:kHz"})
    EXPECT_EQ(mapped("f1,f2", mapping), 25.0) << mapping;
  // The unit of the mapping wins over that of the header, and the mapping over the name.
  EXPECT_EQ(mapped("f1_mHz,f2", "frequency=f1_mHz:kHz"), 25.0);
  EXPECT_EQ(mapped("f1 [kHz],f2", "frequency=f1"), 25.0);
  EXPECT_EQ(mapped("f1_kHz,frequency", "frequency=f1"), 25.0);
}

TEST_F(UserTable, DividesByPowersOfTenExactly) {
  const auto table = read("stick-force", "t_ms,friction_force_mN\n9,300\n18,7\n");
  EXPECT_EQ(table.column("t")->values, (std::vector<double>{0.009, 0.018}));
  EXPECT_EQ(table.column("friction_force")->values, (std::vector<double>{0.3, 0.007}));
}

TEST_F(UserTable, NeedsNoIndexThatHasOneValue) {
  data::ReferenceTable reference = data::read_table(package(), "stick-frequencies");
  for (data::Column& column : reference.columns) {
    column.text.resize(1);
    column.values.resize(1);
  }
  reference.resource.fields[1].name = reference.resource.primary_key[1] = "index";
  reference.columns[1].field.name = "index";
  const auto read_frequencies = [&](const std::string& text) {
    return data::read_user_table(folder_.write("mine.csv", text), reference);
  };
  EXPECT_EQ(read_frequencies("frequency\n25\n").column("index")->values, std::vector{1.0});
  EXPECT_EQ(folder_.error_message([&] { static_cast<void>(read_frequencies("frequency\n25\n26\n")); }),
            "mine.csv:3: beam = paper, index = 1 stands in line 2 already, but must stand once");
}

TEST_F(UserTable, NeedsNoKeyThatHasOneValueAndNoNumberOfEvents) {
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
  EXPECT_EQ(first("position", "damped-events", "time_s,change,tip_displacement_m\n0.5,onset,2\n"), 2.0);
}

TEST_F(UserTable, RefusesAColumnThatIsMissing) {
  struct Defect {
    std::string set, text, missing, present;
  };
  for (const auto& [set, text, missing, present] : std::vector<Defect>{
           {"stick-frequencies", "beam,mode\npaper,1\n", "frequency is missing", "beam, mode"},
           {"stick-frequencies", "beam,mode,frequenzy\npaper,1,25\n",
            "frequency is missing (did you mean frequenzy?)", "beam, mode, frequenzy"},
           {"stick-frequencies", "mode,frequency\n1,25\n", "beam is missing", "mode, frequency"},
           {"stick-frequencies", "# a\n# beam mode f\npaper 1 25\n", "frequency is missing", "beam, mode, f"},
           {"stick-force", "friction_force\n1\n", "t is missing", "friction_force"},
           {"damped-events", "time\n1\n", "change is missing", "time"}})
    EXPECT_EQ(error_message(set, text),
              fmt::format("mine.csv:{}: the column {}; the file has {} (--column REFERENCE=THEIRS says which "
                          "is which)",
                          text.starts_with('#') ? 2 : 1, missing, present));
}

TEST_F(UserTable, RefusesAUnitOfAnotherQuantity) {
  for (const auto& [unit, header] : {std::pair{"mm", "beam,mode,frequency [mm]"},
                                     {"THz", "beam,mode,frequency [THz]"},
                                     {"mm", "beam,mode,frequency\n,,mm"},
                                     {"THz", "beam,mode,frequency\n-,-,THz"}})
    EXPECT_EQ(
        error_message("stick-frequencies", fmt::format("{}\npaper,1,25\n", header)),
        fmt::format("mine.csv:1, column 3 (frequency [{0}]): the unit of frequency is '{0}', but must be "
                    "one of Hz, mHz, kHz, MHz, 1/s, rad/s",
                    unit));
}

TEST_F(UserTable, RefusesACellThatIsNoFiniteNumber) {
  const auto expect_refused = [&](const std::string& text, const std::string& cell) {
    EXPECT_EQ(error_message("stick-frequencies", text),
              "mine.csv:2, column 3 (frequency): frequency is '" + cell +
                  "', but must be a finite number that fits a double, as 0.025 or 2.5e-2");
  };
  for (const std::string cell : {"fast", "", "25 Hz", "NaN", "-inf", "1e999"})
    expect_refused("beam,mode,frequency\npaper,1," + cell + "\n", cell);
  expect_refused("beam,mode,frequency\npaper,1,\"25,0\"\n", "25,0");
  expect_refused("beam;mode;frequency\npaper;1;1.025,0\n", "1.025,0");
}

TEST_F(UserTable, RefusesWhatCannotBeUsedInOneSentence) {
  const std::string header = "beam,mode,frequency\n";
  struct Defect {
    std::string set, text, sentence;
  };
  const std::string frequencies = "stick-frequencies", force = "stick-force", events = "damped-events";
  const std::vector<Defect> defects{
      {frequencies, "", ": is empty"},
      {frequencies, "# nothing\n\n", ":2: there is no line with the names of the columns"},
      {frequencies, header, ":1: the table has no rows, but must have at least one"},
      {frequencies, header + "# none\n", ":2: the table has no rows, but must have at least one"},
      {frequencies, "beam,mode,frequency,frequency_kHz\npaper,1,25,0.025\n",
       ":1, column 4 (frequency_kHz): the column frequency stands twice, in column 3 as 'frequency'"},
      {frequencies, header + "paper,1,25\npaper,2,fast\n",
       ":3, column 3 (frequency): frequency is 'fast', but must be a finite number that fits a double, as "
       "0.025 or 2.5e-2"},
      {frequencies, header + ",kHz\n", ":2: the line has 2 cells, but must have 3 as the line of names has"},
      {frequencies, header + "-,1,kHz\n,1,25\n", ":3, column 1 (beam): beam is '', but must be a word"},
      {frequencies, header + "-,1,kHz\npaper,1.5,25\n",
       ":3, column 2 (mode): mode is '1.5', but must be an integer"},
      {frequencies, "beam,mode,frequency [MHz]\npaper,1,1e308\n",
       ":2, column 3 (frequency [MHz]): frequency is '1e308', but must be a number that is finite in Hz"},
      {frequencies, header + "paper,1.5,25\n", ":2, column 2 (mode): mode is '1.5', but must be an integer"},
      {frequencies, header + ",1,25\n", ":2, column 1 (beam): beam is '', but must be a word"},
      {frequencies, header + "paper,1,25\npaper,2\n",
       ":3: the line has 2 cells, but must have 3 as the line of names has"},
      {frequencies, header + "paper,1,25,7\n",
       ":2: the line has 4 cells, but must have 3 as the line of names has"},
      {frequencies, header + "paper,1,\"25\n", ":2: a quote is not closed, or something follows it"},
      {frequencies, header + "\"paper\"x,1,25\n", ":2: a quote is not closed, or something follows it"},
      {frequencies, header + "paper,1,25\npaper,2,81\npaper,1,26\n",
       ":4: beam = paper, mode = 1 stands in line 2 already, but must stand once"},
      {force, "t,friction_force\n0.002,1\n0.001,2\n",
       ":3, column 1 (t): t is 0.001, but must not be below 0.002 of line 2"},
      {events, "time,change\n0.2,onset\n0.1,capture\n",
       ":3, column 1 (time): time is 0.1, but must not be below 0.2 of line 2"},
      {events, "index,time,change\n1,0.1,onset\n1,0.2,capture\n",
       ":3: index = 1 stands in line 2 already, but must stand once"}};
  for (const auto& [set, text, sentence] : defects)
    EXPECT_EQ(error_message(set, text), "mine.csv" + sentence);
  EXPECT_EQ(error_message("beams", "beam\npaper\n"),
            "the data set beams says nothing of how to compare with it");
}

TEST_F(UserTable, RefusesAnotherFormatThanText) {
  for (const auto& [text, sentence] : std::vector<std::pair<std::string, std::string>>{
           {std::string("\xFF\xFE") + "b", ": is text in UTF-16, but must be in UTF-8"},
           {std::string("\xFE\xFF") + "b", ": is text in UTF-16, but must be in UTF-8"},
           {" {\"beam\": 1}\n", ": is a JSON file, but must be a table in text, as CSV"},
           {"[{\"beam\": 1}]", ": is a JSON file, but must be a table in text, as CSV"},
           {"<?xml version=\"1.0\"?>", ": is an XML or HTML file, but must be a table in text, as CSV"},
           {"beam,mode,frequency [\xB5Hz]\npaper,1,25\n",
            ":1: the name of a column is no text in UTF-8 (Latin-1?), but must be"},
           {"PAR1\x15", ": is a Parquet file, but must be a table in text, as CSV"},
           {"---\nbeam: paper\n", ": is a YAML file, but must be a table in text, as CSV"},
           {"***** ANSYS *****\n",
            ": is an input or output file of a finite-element program, but must be a table in text, as CSV"},
           {std::string("beam\0\n", 6), ": is no text in UTF-8"},
           {"\x89HDF\r\n",
            ": is a file in HDF5 format (as MATLAB's -v7.3), but must be a table in text, as CSV"},
           {"PK\x03\x04", ": is a zip archive (as .xlsx, .ods, .npz), but must be a table in text, as CSV"},
           {"MATLAB 5.0 MAT-file", ": is a MATLAB file, but must be a table in text, as CSV"},
           {"\x93NUMPY", ": is a NumPy file, but must be a table in text, as CSV"},
           {gzip("beam,mode,frequency\npaper,1,25\n").substr(0, 20),
            ": is no complete file in gzip's format"},
           {gzip(std::string(data::limit::table_bytes.most, ' ')),
            ":1: there is no line with the names of the columns"},
           {gzip(std::string(data::limit::table_bytes.most + 1, ' ')),
            ": holds more than the 50000000 bytes that are allowed"}})
    EXPECT_EQ(error_message("stick-frequencies", text), "mine.csv" + sentence);
}

TEST_F(UserTable, WithoutALineOfNamesNeedsThem) {
  const std::string numbers = "1.607 2 25\n7.231 3 81.5\n", words = "paper,1,25\npaper,2,81.5\n";
  for (const auto& [text, mappings] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {numbers, {}}, {numbers, {"beam=1.607", "mode=2", "frequency=25"}}, {words, {}}})
    EXPECT_EQ(
        error_message("stick-frequencies", text, mappings),
        "mine.csv:1: the line is numbers, not the names of the columns (--columns NAME,NAME,... gives them)");
  for (const auto& [text, names] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {words, {"beam", "mode", "frequency"}},
           {"# by hand\n0 paper 1 0.025 0\n0 paper 2 0.0815 0\n",
            {"-", "beam", "mode", "frequency [kHz]", "-"}}}) {
    const auto table = read("stick-frequencies", text, {}, names);
    EXPECT_EQ(table.column("frequency")->values, (std::vector<double>{25.0, 81.5}));
    EXPECT_EQ(table.column("mode")->values, (std::vector<double>{1.0, 2.0}));
  }
  const auto too_many = [&] {
    static_cast<void>(read("stick-frequencies", words, {}, {"beam", "mode", "frequency", "-"}));
  };
  EXPECT_EQ(folder_.error_message(too_many),
            "mine.csv:1: the line has 3 cells, but must have 4, one for each name");
}

TEST_F(UserTable, RefusesAFileThatIsNone) {
  const auto table = data::read_table(package(), "stick-force");
  for (const auto& none : {folder_.path() / "mine.csv", folder_.path()})
    EXPECT_THROW(static_cast<void>(data::read_user_table(none, table)), data::InputError) << none;
}

TEST_F(UserTable, RefusesAMappingToNothing) {
  const auto message = [&](const std::string& mapping) {
    return error_message("stick-frequencies", "beam,mode,f\npaper,1,25\n", {mapping});
  };
  EXPECT_EQ(message("frequency=g:kHz"),
            "mine.csv:1: the column g (for frequency) is missing; the file has beam, mode, f (--column "
            "REFERENCE=THEIRS says which is which)");
  EXPECT_EQ(message("frequency=f:furlong"),
            "mine.csv:1, column 3 (f): the unit of frequency is 'furlong', but must be one of Hz, mHz, kHz, "
            "MHz, 1/s, rad/s");
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
    EXPECT_THROW(static_cast<void>(data::ColumnMapping::parse(text)), data::InputError) << text;
}

TEST(ColumnMapping, MustBeOfAColumnThatThereIs) {
  const auto history = data::read_table(package(), "damped-history"),
             events = data::read_table(package(), "damped-events");
  const auto known = [&](const std::string& text) {
    data::require_known_columns({data::ColumnMapping::parse(text)}, {&history, &events});
  };
  EXPECT_NO_THROW(known("T=time"));
  EXPECT_NO_THROW(known("position=y"));
  const std::string message = error_message_of<data::InputError>([&] { known("positon=y"); });
  EXPECT_TRUE(
      message.starts_with("column positon is unknown (did you mean position?), but must be one of t, "))
      << message;
  EXPECT_EQ(error_message_of<data::InputError>([&] {
              data::require_known_columns(
                  {data::ColumnMapping::parse("Time=a"), data::ColumnMapping::parse("time=b")}, {&events});
            }),
            "column Time is given 2 times, but must be given once");
}

}  // namespace
}  // namespace stickslip::testing
