// SPDX-License-Identifier: MIT
/// Bad input of every kind at every place: each key of a case file, each option of the command line, each
/// column of a compared table, and each column and key of the published package is tried with each defect.
/// Every defect is refused in one sentence, and nothing is written, but for the exceptions listed below; what
/// these accept gives finite numbers.

#include <fnmatch.h>

#include <cstdio>
#include <regex>

#include "command.hpp"
#include "commands.hpp"
#include "comparison/diagnosis/diagnosis.hpp"
#include "stickslip/data/case_file.hpp"
#include "stickslip/data/csv_text.hpp"
#include "stickslip/data/input_text.hpp"
#include "stickslip/data/reference.hpp"
#include "stickslip/data/user_table.hpp"
#include "support/command_line.hpp"
#include "support/requirements.hpp"
#include "support/testing.hpp"

namespace stickslip::testing {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t hundred_megabytes = 100'000'000;

// What stands instead of a good value; those that are not here are no values.
const std::map<std::string, std::string> bad_values{{"wrong type", "two"},
                                                    {"not a number", "nan"},
                                                    {"infinity", "inf"},
                                                    {"negative", "-1"},
                                                    {"zero", "0"},
                                                    {"huge", "1e300"},
                                                    {"denormal", "5e-324"},
                                                    {"not UTF-8", "\xFF\x1B[31m"},
                                                    {"deep nesting", std::string(50'000, '[')}};

std::vector<std::string> all_defects() {
  std::vector<std::string> defects{"missing", "unknown", "duplicate", "100 MB"};
  for (const auto& [defect, value] : bad_values) defects.push_back(defect);
  return defects;
}

// One letter more.
std::string misspelt(const std::string& name) { return name + name.back(); }

void expect_one_sentence(const std::string& sentence) {
  EXPECT_FALSE(sentence.empty());
  EXPECT_LT(sentence.size(), 2100u) << sentence.substr(0, 300);
  EXPECT_TRUE(std::ranges::none_of(sentence, [](char c) {
    return static_cast<unsigned char>(c) < 0x20U || static_cast<unsigned char>(c) >= 0x7FU;
  })) << sentence;
}

// "nan" and "inf" as words.
bool holds_no_number(const std::string& text) {
  std::string word;
  for (const char c : text + " ") {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      word += c;
      continue;
    }
    if (word == "nan" || word == "inf") return true;
    word.clear();
  }
  return false;
}

// --- The product of items and defects

// A defect that is accepted. In `where`, `item` and `defect`, * stands for any text, @(a|b) for either and
// !(a) for anything else. The first row that fits decides; a row without a reason, and no row, mean refused.
struct Exception {
  const char *where, *item, *defect, *reason;
};

constexpr Exception exceptions[] = {
    {"case file", "damping.*", "@(missing|zero)", "the beam has no such damping"},
    {"case file", "beam.axial_direction", "@(missing|zero)", "the axial force follows the tip"},
    {"case file", "beam.shear_stiffness", "@(missing|zero)", "the beam is rigid in shear"},
    {"case file", "beam.poissons_ratio", "missing", "the beam is rigid in shear"},
    {"case file", "beam.poissons_ratio", "zero", "the material does not contract"},
    {"case file", "friction.viscous", "@(missing|zero)", "the friction has no viscous part"},
    {"case file", "contact.tangential_stiffness", "@(missing|infinity)", "the contact is rigid"},
    {"case file", "contact.regularisation_velocity", "@(missing|zero)", "the law is set-valued"},
    {"case file", "wall.speed", "@(missing|zero|negative)", "the wall may rest, or move either way"},
    {"case file", "wall.with_base", "missing", "the wall does not move with the base"},
    {"case file", "model.damping", "@(missing|zero)", "the mass has no damper"},
    {"case file", "model.stiffness", "zero", "the mass has no spring"},
    {"case file", "@(initial.*|excitation.constant_force)", "@(missing|zero|negative)",
     "the mass may start anywhere, and be pushed either way"},
    {"case file", "@(numerics.*|excitation.duration)", "missing", "the program chooses the setting"},
    {"case file", "friction.kinetic_coefficient", "missing", "the friction is that of Coulomb"},
    {"case file", "beam.axial_force", "@(negative|zero)",
     "tension and no force have frequencies; a run needs compression"},
    {"case file", "friction.kinetic_coefficient", "zero", "the sliding tip meets no friction"},
    {"case file", "friction.decay", "@(missing|infinity)", "the coefficient jumps"},
    {"case file", "friction.decay", "zero", "the coefficient is that of rest at every velocity"},
    {"case file", "excitation.@(*amplitude|force|scale)", "zero", "nothing moves"},
    {"case file", "excitation.scale", "missing", "the key has a default"},
    {"case file", "numerics.spectral_radius", "@(denormal|zero)", "the strongest numerical damping there is"},
    {"case file", "numerics.velocity_threshold", "zero", "no velocity counts as none"},

    {"column", "@(* *_radius|* event_distance|*-events index|*-events position|*-history phase)",
     "@(missing|unknown)", "the data set does not need that column"},
    {"column", "damped-history @(tip_displacement|friction_force)", "@(missing|unknown)",
     "the data set does not need that column"},
    {"column", "@(* *_radius|* event_distance)", "@(denormal|huge|negative|zero)",
     "the column is not compared"},
    {"column", "*-events index", "@(huge|negative|zero)", "the column is not compared"},
    {"column", "* @(frequency|shape|friction_force|position|tip_displacement|y)",
     "@(denormal|huge|negative|zero)", "a finite number is compared with the reference"},
    {"column", "cubic-events time", "huge", "a finite number is compared with the reference"},

    {"package text", "*", "@(denormal|huge|infinity|negative|not a number|wrong type|zero)",
     "any word may stand in a table"},
    {"package integer", "*", "@(huge|negative|zero)", "any finite number may stand in a table"},
    {"package radius", "*", "@(denormal|huge|zero)", "any finite number may stand in a table"},
    {"package number", "@(undamped-history-* time|*-fields x)", "zero", ""},  // the key of the first row
    {"package number", "*", "@(denormal|huge|negative|zero)", "any finite number may stand in a table"},
    {"package key",
     "@(profile|licenses/*/name|resources/*/@(profile|format|mediatype|encoding|comparison|diagnosis))",
     "missing", "the key may be missing"},
    {"package key", "resources/*/schema/fields/*/@(description|constraints|constraints/required|class)",
     "missing", "the key may be missing"},
    {"package key", "resources/*/comparison/@(interpolation|horizon)", "missing", "the key may be missing"},
    {"package key", "resources/*/comparison/horizon", "@(denormal|huge)", "any time above 0 may be the last"},
    {"package key", "resources/*/comparison/values/*/tolerance", "@(denormal|huge|zero)",
     "any tolerance of 0 or more may be asked for"},
    {"package key", "resources/*/diagnosis/case", "wrong type", "a case may have that name"},

    {"option", "@(stickslip|reference) --help", "!(unknown)", "help is given"},
    {"option", "* @(CASE|CASES)", "missing", "a case of the paper stands for none"},
    {"option", "criterion CASE", "duplicate", "it takes several cases"},
    {"option", "@(respond|animate|criterion|map|sweep|periodic|nvh) --amplitude", "zero", "nothing moves"},
    {"option", "sweep --settle", "zero", "nothing passes before the section"},
    {"option", "uncertainty --seed", "zero", "any seed will do"},
    {"option",
     "@(criterion --set|uncertainty --set|squeal --set|nvh --set|periodic --set|compare --tolerance|report "
     "--only)",
     "duplicate", "it may be given several times"},
    {"option", "compare --tolerance", "@(denormal|huge|zero)", "any finite tolerance may be asked for"},
    {"option", "compare --until", "@(denormal|huge|zero)",
     "a comparison may end at its start or go on to the end of the data"},
    {"option", "squeal --speed", "negative", "the wall may move either way"},
    {"option", "nvh --transient", "@(denormal|zero)", "nothing is left out"},
    {"option", "respond --from", "@(denormal|zero)", "the rows begin with the history"},
    {"option", "respond --to", "denormal", "the rows end with the start"},
    {"option",
     "@(* --output|respond --events|squeal --map|nvh --audio|compare --json|compare --junit|validate "
     "--predictions)",
     "@(denormal|huge|infinity|negative|not UTF-8|not a number|wrong type|zero)",
     "a file may have that name"},
    {"option", "new FILE",
     "@(unknown|negative|denormal|huge|infinity|not UTF-8|not a number|wrong type|zero)",
     "a file may have that name"},
    {"option", "compare --json", "@(missing|duplicate)", ""},
    {"option", "@(* --json|* --schema|* --quiet|* --states-only|* --dry-run|* --version)", "missing",
     "a flag has no value"},
    {"option", "@(* --json|* --schema|* --quiet|* --states-only|* --dry-run|* --version)", "duplicate",
     "said twice it means the same"},
};

struct BadInput {
  std::string where;   // "case file", "option", "column", "package key" or "package" and the kind of a column
  std::string item;    // "beam.length", "respond --hz", "damped-history time", "resources/*/title"
  std::string defect;  // "not a number"
  std::string reason{};  // why it is accepted, empty if it is refused

  [[nodiscard]] bool is_refused() const { return reason.empty(); }
};

bool fits(const char* pattern, const std::string& text) {
  return ::fnmatch(pattern, text.c_str(), FNM_EXTMATCH | FNM_NOESCAPE) == 0;
}

// The exception that decides, or the end of the list.
const Exception* exception_of(const BadInput& input) {
  return std::ranges::find_if(exceptions, [&](const Exception& row) {
    return fits(row.where, input.where) && fits(row.item, input.item) && fits(row.defect, input.defect);
  });
}

// An item with every defect. The properties of the running test count them for the report.
std::vector<BadInput> spoilt(const std::string& where, const std::string& item) {
  std::vector<BadInput> rows;
  for (const std::string& defect : all_defects()) {
    BadInput row{where, item, defect};
    if (const auto* found = exception_of(row); found != std::end(exceptions)) row.reason = found->reason;
    rows.push_back(row);
  }
  return rows;
}

// Records for the report how many inputs the running test tries: properties bad_input.<place>.<defect> with
// "<refused>; <accepted>" and accepted_input.<reason> with "<accepted>".
void record(const std::vector<BadInput>& rows) {
  std::map<std::string, std::pair<int, int>> counts;
  std::map<std::string, int> reasons;
  for (const BadInput& row : rows) {
    const std::string place = row.where.starts_with("package") ? "package" : row.where;
    auto& [refused, accepted] = counts[place + "." + row.defect];
    ++(row.is_refused() ? refused : accepted);
    if (!row.is_refused()) ++reasons[row.reason];
  }
  for (const auto& [key, count] : counts)
    ::testing::Test::RecordProperty("bad_input." + key, fmt::format("{}; {}", count.first, count.second));
  for (const auto& [reason, count] : reasons)
    ::testing::Test::RecordProperty("accepted_input." + reason, count);
}

// What a refusal says: a sentence that begins so and names the item, but for defects that leave no item to be read.
void expect_refused_or_taken(const BadInput& row, const std::optional<std::string>& sentence,
                             const std::string& begin, const std::string& name, const char* unreadable) {
  EXPECT_EQ(sentence.has_value(), row.is_refused()) << sentence.value_or("");
  if (!sentence) return;
  expect_one_sentence(*sentence);
  EXPECT_TRUE(sentence->starts_with(begin)) << *sentence;
  EXPECT_TRUE(fits(unreadable, row.defect) || holds(*sentence, name));
}

// --- Case files

struct CaseLine {
  std::string table, key, value;
  [[nodiscard]] std::string path() const { return table + "." + key; }
};

// The value of a key: one of these, that of the paper, or one in the middle of the magnitudes that it may have.
std::string good_value(const data::Key& key) {
  static const std::map<std::string_view, std::string> chosen{{"beam.material", "'steel'"},
                                                              {"beam.shear_stiffness", "6e6"},
                                                              {"contact.regularisation_velocity", "0.0"},
                                                              {"numerics.duration", "8.0"},
                                                              {"section.wall_thickness", "0.01"},
                                                              {"wall.with_base", "false"}};
  static const auto numbers = data::numbers_of(data::load_case("paper"));
  if (const auto found = chosen.find(key.path); found != chosen.end()) return found->second;
  const auto number = numbers.find(std::string(key.path));
  const bool has_one = number != numbers.end() && number->second != 0.0 && std::isfinite(number->second);
  return data::shortest_text(has_one ? number->second
                                     : std::sqrt(key.magnitudes.smallest * key.magnitudes.largest));
}

// The keys that the cases leave out, as a pattern: one of the numbers alone, two in which others stand for them, and one of a mass.
#define OF_MOTIONS                                                                                     \
  "*.@(sines|sweep|shock|file|spectrum|seed|column|quantity|unit|rate|high_pass|initial_displacement|" \
  "initial_velocity)|"                                                                                 \
  "wall.scale|wall.*amplitude|"
#define OF_MODELS OF_MOTIONS "model.*|initial.*|excitation.force|excitation.constant_force|damping.ratios|"
constexpr const char* left_out[] = {
    "@(" OF_MODELS
    "section.*|beam.material|beam.poissons_ratio|*.velocity_amplitude|*.acceleration_amplitude|numerics."
    "duration)",
    "@(" OF_MODELS
    "beam.area|beam.second_moment_of_area|beam.density|beam.youngs_modulus|beam.shear_stiffness|*."
    "amplitude|"
    "*.acceleration_amplitude|excitation.duration|section.diameter|section.wall_thickness)",
    "@(" OF_MODELS
    "beam.area|beam.second_moment_of_area|beam.density|beam.youngs_modulus|beam.shear_stiffness|*."
    "amplitude|"
    "*.velocity_amplitude|excitation.duration|section.width|section.height)",
    "@(" OF_MOTIONS
    "beam.*|section.*|damping.*|numerics.elements|numerics.duration|*.*amplitude|model.!(mass|stiffness|"
    "damping|"
    "normal_force))"};

// Keys of files and lists: model_file_test.cpp, general_motion_test.cpp.
bool is_listed(const data::Key& key) {
  return std::ranges::any_of(left_out, [&](const char* keys) { return !fits(keys, std::string(key.path)); });
}

// The first of these cases that holds the key.
std::vector<CaseLine> lines_with(const std::string& path) {
  const auto* const without =
      std::ranges::find_if(left_out, [&](const char* keys) { return !fits(keys, path); });
  std::vector<CaseLine> lines;
  for (const data::Key& key : data::case_keys()) {
    const std::string other(key.path);
    if (fits(*without, other)) continue;
    const std::string shape = without == &left_out[1] ? "'rectangle'" : "'tube'";
    lines.push_back({std::string(key.table()), std::string(key.name()),
                     other == "section.shape" ? shape : good_value(key)});
  }
  return lines;
}

bool is_integer(const CaseLine& line) { return data::key_named(line.path()).member.is_integer; }

std::string defective(const CaseLine& line, const std::string& defect) {
  const auto with = [&](const std::string& key, const std::string& value) {
    return key + " = " + value + "\n";
  };
  if (defect == "missing") return "";
  if (defect == "unknown") return with(misspelt(line.key), line.value);
  if (defect == "duplicate") return with(line.key, line.value) + with(line.key, line.value);
  if (defect == "100 MB") return with(line.key, line.value);
  if (defect == "wrong type") return with(line.key, "'two'");
  if (defect == "huge" && is_integer(line)) return with(line.key, "9223372036854775807");
  return with(line.key, bad_values.at(defect));
}

class CaseFileInput : public CommandLine {
 protected:
  // The number of the defective line.
  [[nodiscard]] int write_case(const BadInput& row) const {
    std::ofstream file(path("case.toml"), std::ios::binary);
    int number = 0, found = 0;
    std::string table;
    for (const CaseLine& line : lines_with(row.item)) {
      if (line.table != table) {
        table = line.table;
        file << "[" << table << "]\n";
        ++number;
      }
      ++number;
      if (line.path() == row.item) found = number;
      file << (line.path() == row.item ? defective(line, row.defect) : line.key + " = " + line.value + "\n");
    }
    file.close();
    if (row.defect == "100 MB") fs::resize_file(path("case.toml"), hundred_megabytes);
    const bool is_seen_below =
        row.defect == "duplicate" || (row.defect == "zero" && row.item == "friction.static_coefficient");
    return is_seen_below ? found + 1 : found;
  }
};

std::vector<BadInput> case_inputs() {
  std::vector<BadInput> rows;
  for (const data::Key& key : data::case_keys())
    if (is_listed(key))
      std::ranges::move(spoilt("case file", std::string(key.path)), std::back_inserter(rows));
  return rows;
}

STICKSLIP_VERIFIES(CaseFileInput, "U2");
TEST_F(CaseFileInput, IsRefusedInOneSentenceOrRead) {
  const auto inputs = case_inputs();
  record(inputs);
  for (const BadInput& row : inputs) {
    SCOPED_TRACE(row.item + ", " + row.defect);
    const int line = write_case(row);
    const auto message =
        error_message_if_any<data::InputError>([&] { (void)data::read_case(path("case.toml")); });
    const bool has_line = row.defect != "missing" && row.defect != "100 MB";
    // What needs a missing key has a line.
    const bool is_needed = row.defect == "missing" && fits("@(section.*|beam.material)", row.item);
    const std::string place = has_line ? fmt::format(":{}: ", line) : is_needed ? ":" : ": ";
    const std::string name = row.defect == "duplicate"         ? row.item.substr(row.item.find('.') + 1)
                             : row.item == "numerics.duration" ? "duration"
                                                               : row.item;
    expect_refused_or_taken(row, message, path("case.toml") + place, name,
                            "@(not UTF-8|deep nesting|100 MB)");
    EXPECT_TRUE(row.defect != "unknown" || holds(message.value_or(""), "did you mean " + row.item + "?"));
    if (message) continue;
    // What is read gives finite numbers: without P of the frequencies alone; a contact that yields takes no jump.
    const std::string rigid = " --set contact.tangential_stiffness=inf";
    const bool is_beam = data::key_named(row.item).is_of(data::StructureKind::beam);
    Words runs{is_beam ? "modes case.toml --count 2" + rigid : "respond case.toml --duration 0.002"};
    if (row.item != "beam.axial_force" && is_beam)
      runs.insert(runs.end(),
                  {"respond case.toml --duration 0.002" + (row.item == "friction.decay" ? rigid : ""),
                   "criterion case.toml --set damping.ratio=0 --set damping.kelvin_voigt=0 --set "
                   "damping.mass_proportional=0 --set excitation.duration=0.1 --set wall.speed=0" +
                       rigid});
    for (const std::string& run : runs) {
      const Outcome outcome = run_line(run);
      EXPECT_EQ(outcome.status, 0) << outcome.errors;
      EXPECT_FALSE(holds_no_number(outcome.output)) << outcome.output;
    }
  }
}

// --- Columns of compared tables

const std::string fixture = STICKSLIP_SOURCE_DIRECTORY "/verification/tests/golden/reference";

const data::ReferencePackage& package() {
  static const auto read = data::load_reference(fixture);
  return read;
}

const data::ReferenceTable& table_of(const std::string& set) {
  static std::map<std::string, data::ReferenceTable> tables;
  if (!tables.contains(set)) tables.emplace(set, data::read_table(package(), set));
  return tables.at(set);
}

using Rows = std::vector<std::vector<std::string>>;

// The header and some rows.
Rows first_rows(const std::string& text) {
  Rows rows = csv(text);
  rows.resize(std::min<std::size_t>(rows.size(), 8));
  return rows;
}

// A column with a defect, a bad value in the third row.
Rows spoilt_rows(Rows rows, const std::string& column, const std::string& defect) {
  const auto& names = rows.front();
  const auto position = static_cast<std::size_t>(std::ranges::find(names, column) - names.begin());
  for (auto& cells : rows) {
    if (defect == "missing") cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(position));
    if (defect == "duplicate") cells.push_back(cells[position]);
  }
  if (defect == "unknown") rows[0][position] = misspelt(column);
  if (bad_values.contains(defect)) rows[3][position] = bad_values.at(defect);
  return rows;
}

std::string text_of(const Rows& rows) {
  std::string text;
  for (const auto& cells : rows) text += fmt::format("{}\n", fmt::join(cells, ","));
  return text;
}

class ColumnInput : public CommandLine {
 protected:
  // The first rows of the data set, the third one defective; returns its line.
  void write_table(const BadInput& row, const std::string& set, const std::string& column) const {
    std::ofstream(path("mine.csv"), std::ios::binary)
        << text_of(spoilt_rows(first_rows(table_of(set).csv), column, row.defect));
    if (row.defect == "100 MB") fs::resize_file(path("mine.csv"), hundred_megabytes);
  }

  void compare(const std::string& set) const {
    const auto reference = comparison::read_reference(package(), set);
    const auto theirs = data::read_user_table(path("mine.csv"), reference.table);
    const auto comparison = comparison::compare(reference, theirs);
    static_cast<void>(comparison::diagnose(comparison, package(), reference.table, theirs));
    for (const auto& quantity : comparison.quantities)
      EXPECT_TRUE(!quantity.error || std::isfinite(*quantity.error)) << quantity.name;
  }
};

// Its columns with every defect.
std::vector<BadInput> column_inputs(const data::Resource& resource) {
  std::vector<BadInput> rows;
  for (const auto& field : resource.fields)
    std::ranges::move(spoilt("column", resource.name + " " + field.name), std::back_inserter(rows));
  return rows;
}

STICKSLIP_VERIFIES(ColumnInput, "U2");
TEST_F(ColumnInput, IsRefusedInOneSentenceOrCompared) {
  std::vector<BadInput> inputs;
  for (const auto& resource : package().resources)
    if (resource.comparison) std::ranges::move(column_inputs(resource), std::back_inserter(inputs));
  record(inputs);
  for (const BadInput& row : inputs) {
    SCOPED_TRACE(row.item + ", " + row.defect);
    const std::size_t space = row.item.find(' ');
    const std::string set = row.item.substr(0, space), column = row.item.substr(space + 1);
    write_table(row, set, column);
    const auto message = error_message_if_any<data::InputError>([&] { compare(set); });
    expect_refused_or_taken(row, message, path("mine.csv"), column, "100 MB");
    EXPECT_TRUE(!message || !bad_values.contains(row.defect) || holds(*message, "mine.csv:4") ||
                holds(*message, " line 4"));
  }
}

std::string identifier(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return text;
}

// --- The published package: every column of its tables, every key of its description. Somebody's copy of it
// is spoilt, and signed again, so that the digests say nothing.

using Description = nlohmann::ordered_json;

Description description_of(const fs::path& folder) {
  return Description::parse(contents(folder / "datapackage.json"));
}

class PackageInput : public CommandLine {
 protected:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
  }

  void enlarge(const std::string& name) const { fs::resize_file(path(name), hundred_megabytes); }

  // The sentence that refuses a package or one of its tables.
  [[nodiscard]] std::optional<std::string> error_message(const std::string& folder,
                                                         std::size_t resource = 0) const {
    return error_message_if_any<data::InputError>([&] {
      const auto package = data::load_reference(path(folder));
      (void)data::read_table(package, package.resources.at(resource).name);
    });
  }
};

// The columns of a published data set with every defect.
std::vector<BadInput> published_inputs(const data::Resource& resource) {
  std::vector<BadInput> rows;
  for (const auto& field : resource.fields) {
    const std::string kind = field.name.ends_with("_radius")          ? "radius"
                             : !field.allowed.empty()                 ? "word"
                             : field.type == data::FieldType::string  ? "text"
                             : field.type == data::FieldType::integer ? "integer"
                                                                      : "number";
    std::ranges::move(spoilt("package " + kind, resource.name + " " + field.name), std::back_inserter(rows));
  }
  return rows;
}

// The published data sets, cut after some rows.
class PublishedColumns : public PackageInput {
 protected:
  void write_signed(const std::string& csv) {
    resource_["bytes"] = csv.size();
    resource_["hash"] = "sha256:" + data::sha256(csv);
    description_["resources"] = {resource_};
    write("datapackage.json", description_.dump());
    write("table.csv", csv);
  }

  void choose(const Description& resource) {
    resource_ = resource;
    rows_ = first_rows(contents(data::reference_directory() / resource_["path"].get<std::string>()));
    resource_["path"] = "table.csv";
    for (const char* key : {"comparison", "diagnosis"}) resource_.erase(key);
    resource_["schema"].erase("foreignKeys");
  }

  void expect_refused_or_read(const std::vector<BadInput>& inputs) {
    const std::string original = text_of(rows_);
    write_signed(original);
    ASSERT_EQ(error_message(""), std::nullopt);
    write("table.csv", original + "\n");
    EXPECT_TRUE(holds(error_message("").value_or(""), "the file has been altered"));
    for (const BadInput& row : inputs) {
      SCOPED_TRACE(row.item + ", " + row.defect);
      const std::string column = row.item.substr(row.item.find(' ') + 1);
      write_signed(text_of(spoilt_rows(rows_, column, row.defect)));
      if (row.defect == "100 MB") enlarge("table.csv");
      expect_refused_or_taken(row, error_message(""),
                              path("table.csv") + (bad_values.contains(row.defect) ? ":4" : ":"), column,
                              "100 MB");
    }
  }

  void expect_missed_in_a_truncated_row() {
    for (std::size_t cells = 0; cells < rows_.front().size(); ++cells) {
      Rows truncated = rows_;
      truncated[3].resize(cells);
      write_signed(text_of(truncated));
      const std::string finding =
          cells == 0 ? std::string("the line is empty or a comment, but must be a row of the table")
                     : fmt::format("the line has {} cells, but must have {} as the line of names has", cells,
                                   rows_.front().size());
      EXPECT_EQ(error_message(""), path("table.csv") + ":4: " + finding);
    }
  }

  Description description_ = description_of(data::reference_directory()), resource_;
  Rows rows_;
};

STICKSLIP_VERIFIES(PublishedColumns, "U2");
TEST_F(PublishedColumns, AreRefusedInASentenceOrRead) {
  const auto published = data::load_reference();
  std::vector<BadInput> all;
  std::set<std::string> seen;  // columns of which a data set before has one alike
  for (const Description& resource : Description(description_["resources"])) {
    SCOPED_TRACE(resource["name"]);
    const std::size_t before = seen.size();
    for (const Description& field : resource["schema"]["fields"])
      seen.insert(field["name"].dump() + field["type"].dump());
    if (seen.size() == before) continue;
    choose(resource);
    const auto inputs = published_inputs(published.resource(resource["name"].get<std::string>()));
    expect_refused_or_read(inputs);
    expect_missed_in_a_truncated_row();
    all.insert(all.end(), inputs.begin(), inputs.end());
  }
  record(all);
}

// A key of a description by its path, in which * stands for the index of an array, and where it stands first.
using Keys = std::vector<std::pair<std::string, Description::json_pointer>>;

void collect_keys(const Description& value, const std::string& path, const Description::json_pointer& at,
                  Keys& keys) {
  if (!value.is_structured() || path.ends_with("/settings") || path.ends_with("/error"))
    return;  // the keys of settings are free, those of error are columns
  for (const auto& [name, member] : value.items()) {
    const std::string below = (path.empty() ? "" : path + "/") + (value.is_array() ? "*" : name);
    const auto there = value.is_array() ? at / std::stoul(name) : at / name;
    if (value.is_object() && std::ranges::find(keys, below, &Keys::value_type::first) == keys.end())
      keys.emplace_back(below, there);
    collect_keys(member, below, there, keys);
  }
}

const Keys& description_keys() {
  static const auto keys = [] {
    Keys found;
    collect_keys(description_of(fixture), "", Description::json_pointer(), found);
    return found;
  }();
  return keys;
}

class PackageKeys : public PackageInput {
 protected:
  [[nodiscard]] static std::string in_double_quotes(const std::string& text) { return "\"" + text + "\""; }

  [[nodiscard]] static std::string bad_member_value(const Description& good, const std::string& defect) {
    const std::string& bad = bad_values.at(defect);
    if (defect == "wrong type") return good.is_string() ? "[2]" : in_double_quotes(bad);
    return defect == "not UTF-8" ? in_double_quotes(bad) : bad;
  }

  // The text of the fixture's description with that defect.
  [[nodiscard]] static std::string spoilt_text(const Description::json_pointer& key,
                                               const std::string& defect) {
    const std::string mark = "spoilt here";
    Description description = description_of(fixture);
    const Description value = description[key];
    const std::string name = key.back();
    if (defect == "missing") {
      description[key.parent_pointer()].erase(name);
      return description.dump();
    }
    description[key] = mark;
    std::string text = description.dump();
    const auto member = [&](const std::string& its_name, const std::string& its_value) {
      return fmt::format("\"{}\":{}", its_name, its_value);
    };
    const std::string good = member(name, value.dump());
    const std::string marked = member(name, in_double_quotes(mark));
    return text.replace(text.find(marked), marked.size(),
                        defect == "unknown"     ? member(misspelt(name), value.dump())
                        : defect == "duplicate" ? good + "," + good
                        : defect == "100 MB"    ? good
                                                : member(name, bad_member_value(value, defect)));
  }
};

STICKSLIP_VERIFIES(PackageKeys, "U2");
TEST_F(PackageKeys, AreRefusedInOneSentenceOrRead) {
  fs::copy(fixture, path("package"), fs::copy_options::recursive);
  std::vector<BadInput> all;
  for (const auto& [item, key] : description_keys()) {
    const std::string name = key.back(), pointer = key.to_string();
    const std::size_t resource = pointer.starts_with("/resources/") ? std::stoul(pointer.substr(11)) : 0;
    for (const BadInput& row : spoilt("package key", item)) {
      SCOPED_TRACE(row.item + ", " + row.defect);
      all.push_back(row);
      write("package/datapackage.json", spoilt_text(key, row.defect));
      if (row.defect == "100 MB") enlarge("package/datapackage.json");
      const auto sentence = error_message("package", resource);
      expect_refused_or_taken(row, sentence, path("package/datapackage.json:"), name,
                              "@(not UTF-8|deep nesting|100 MB|not a number|infinity)");
      EXPECT_TRUE(row.defect != "unknown" || holds(sentence.value_or(""), "did you mean " + name + "?"));
    }
  }
  record(all);
}

// --- Options

// What makes a subcommand run fast; an option that is tried replaces its own. "stickslip" is the program
// alone.
struct Command {
  std::string name;
  std::vector<std::pair<std::string, std::string>> arguments;  // a positional one has no '-'

  [[nodiscard]] std::string words() const { return name == "stickslip" ? "" : name; }
};

void PrintTo(const Command& command, std::ostream* stream) { *stream << command.name; }

std::vector<Command> commands() {
  const std::string set = "stick-frequencies";
  return {{"stickslip", {{"SUBCOMMAND", "cases"}}},
          {"reference", {{"SUBCOMMAND", "list"}}},
          {"new", {{"FILE", "new.toml"}}},
          {"modes", {{"CASE", "paper"}}},
          {"respond", {{"CASE", "paper"}, {"--duration", "0.001"}, {"--output", "out.csv"}}},
          {"animate", {{"CASE", "paper"}, {"--duration", "0.001"}, {"--frames", "2"}, {"--output", "film"}}},
          {"criterion", {{"CASE", "paper"}, {"--set", "excitation.duration=0.1"}}},
          {"map",
           {{"CASE", "paper"},
            {"--x", "length=1.9:2:2"},
            {"--y", "force=400:500:2"},
            {"--duration", "0.1"},
            {"--output", "out.csv"}}},
          {"sweep",
           {{"CASE", "paper"},
            {"--parameter", "friction=0.5:0.6:2"},
            {"--settle", "1"},
            {"--periods", "1"},
            {"--output", "out.csv"}}},
          {"design",
           {{"CASE", "paper"},
            {"--band", "20:20"},
            {"--length", "1.99:2"},
            {"--force", "499:500"},
            {"--duration", "0.1"}}},
          {"uncertainty", {{"CASE", "uncertain"}, {"--samples", "20"}, {"--set", "excitation.duration=0.1"}}},
          {"squeal",
           {{"CASE", "reed"},
            {"--set", "numerics.modes=2"},
            {"--set", "numerics.elements=4"},
            {"--modes", "3"},
            {"--settle", "5"},
            {"--map", "out.csv"},
            {"--speeds", "0.1:0.5"},
            {"--ratios", "0.01:0.02"},
            {"--count", "2"}}},
          {"nvh", {{"CASE", "squeak-stand"}, {"--set", "excitation.duration=1"}, {"--audio", "out.csv"}}},
          {"periodic", {{"CASE", "reed"}, {"--set", "numerics.modes=2"}, {"--settle", "20"}}},
          {"reference list", {{"--package", fixture}}},
          {"reference show", {{"NAME", set}, {"--package", fixture}}},
          {"reference export", {{"NAME", set}, {"--package", fixture}, {"--output", "out.csv"}}},
          {"compare",
           {{"NAME", "damped-history"}, {"FILE", fixture + "/damped/history.csv"}, {"--package", fixture}}},
          {"validate", {{"--output", "out.csv"}}},
          {"report", {{"--only", "fig2"}, {"--output", "report"}}},
          {"cases", {}}};
}

class OptionInput : public Drawing {
 protected:
  void SetUp() override {
    Drawing::SetUp();
    plant_neighbours();
    fs::create_directory("large");
    for (const std::string file : {"large/datapackage.json", "large/results.xml"}) {
      std::ofstream{file};
      fs::resize_file(file, hundred_megabytes);
    }
    install_gnuplot(
        "[ -n \"$output\" ] && echo drawn > \"$output\"; for i in 0001 0002; do echo drawn > frame-$i.png; "
        "done\n");
  }

  // Files of the user whose names are near those of outputs, or of what the program makes on the way.
  [[nodiscard]] static std::vector<std::string> neighbours() {
    std::vector<std::string> all{"film/.unfinished/mine", "report/.unfinished/mine", "new.toml~", "out.csv~"};
    for (const std::string output :
         {"out.csv", ".out.csv", ".new.toml", "film/.motion.csv", "report/.fig2.csv"})
      for (const char* after :
           {".1", ".99", ".20261127", ".stickslip-", ".stickslip-1x", ".swp", ".bak", ".tmp"})
        all.push_back(output + after);
    return all;
  }

  static void plant_neighbours() {
    fs::create_directories("film/.unfinished"), fs::create_directories("report/.unfinished");
    for (const std::string& file : neighbours()) std::ofstream(file) << "mine";
  }

  static void expect_neighbours_untouched(const std::string& command) {
    for (const std::string& file : neighbours()) EXPECT_EQ(contents(file), "mine") << command << ": " << file;
  }

  // The words of the command with its usual arguments, with that case if there is one.
  [[nodiscard]] static std::vector<std::string> usual(const Command& command,
                                                      const std::string& problem = "") {
    std::istringstream name(command.words());
    std::vector<std::string> words{std::istream_iterator<std::string>(name), {}};
    for (const auto& [argument, value] : command.arguments) {
      if (argument.starts_with('-')) words.push_back(argument);
      words.push_back(argument == "CASE" && !problem.empty() ? problem : value);
    }
    return words;
  }

  struct Listed {
    std::string name;
    bool takes_value{};
    std::string type{};  // "INT:1 ... 1000"
  };

  // The program's own list. The help of a command is taken where subcommands follow, since it is the same everywhere.
  [[nodiscard]] static const CLI::App& app_of(const Command& command) {
    static CLI::App program("", "stickslip");
    if (program.get_subcommands(nullptr).empty()) {
      program.option_defaults()->disable_flag_override();
      program.set_version_flag("--version", "");
      for (const auto add_to : cli::all_commands) add_to(program);
      cli::add_quiet_option(program);
    }
    const CLI::App* app = &program;
    for (const std::string& word : words_of(command.words())) app = app->get_subcommand(word);
    return *app;
  }

  [[nodiscard]] static std::vector<Listed> listed(const Command& command) {
    const CLI::App& app = app_of(command);
    std::vector<Listed> options;
    if (!app.get_subcommands([](const CLI::App*) { return true; }).empty())
      options = {{"--help"}, {"SUBCOMMAND", true}};
    for (const CLI::Option* option : app.get_options()) {
      const bool is_positional = option->get_positional();
      const std::string name = is_positional ? option->get_name(true) : "--" + option->get_lnames().front();
      if (name != "--help" && name != "--ask")  // which reads standard input; new_case_test.cpp
        options.push_back(
            {name, is_positional || option->get_items_expected_max() > 0, option->get_type_name()});
    }
    return options;
  }

  // What an option is given. Linux passes no argument beyond 128 KiB to a program, so that 100 kB stand for
  // 100 MB; but what is read can be a file of 100 MB.
  [[nodiscard]] std::vector<std::string> values(const std::string& item, const std::string& defect) const {
    if (bad_values.contains(defect)) return {bad_values.at(defect)};
    if (defect != "100 MB") return {""};
    std::vector<std::string> large{std::string(100'000, '9')};  // also as a number
    const bool is_read = item.ends_with(" CASE") || item == "compare FILE" || item == "compare --events" ||
                         item == "map --from";
    if (is_read) large.push_back("large/datapackage.json");
    if (item.ends_with(" --package") || item == "report --tests") large.push_back("large");
    return large;
  }

  // The words of the command with that defect at that option.
  [[nodiscard]] std::vector<std::string> arguments(const Command& command, const Listed& option,
                                                   const std::string& defect,
                                                   const std::string& value) const {
    std::vector<std::string> words;
    std::string good = "1";
    for (const auto& [name, usual] : command.arguments) {
      if (name == option.name) good = usual;
      if (name == option.name && name != "--set") continue;
      if (option.name == "--from") continue;  // what it excludes
      if (option.name == "--tests" && name == "--only") continue;
      if (name.starts_with('-')) words.push_back(name);
      words.push_back(usual);
    }
    const bool is_positional = !option.name.starts_with('-');
    const bool is_before_subcommand =
        !command.arguments.empty() && command.arguments.front().first == "SUBCOMMAND";
    const auto append = [&](const std::vector<std::string>& more) {
      words.insert(is_before_subcommand ? words.begin() : words.end(), more.begin(), more.end());
    };
    if (option.name == "--from") append({"--figure", "out.svg"});
    const auto give = [&](const std::string& name, const std::string& text) {
      if (is_positional)
        words.insert(option.name == "FILE" && !words.empty() ? words.begin() + 1 : words.begin(), text);
      else if (option.takes_value)
        append({name, text});
      else
        append({name});
    };
    if (defect == "missing") {
      if (!is_positional) append({option.name});
    } else if (defect == "unknown") {
      give(misspelt(option.name), is_positional ? misspelt(good) : good);
    } else if (defect == "duplicate") {
      give(option.name, good);
      give(option.name, good);
    } else if (is_positional) {
      give(option.name, value);
    } else {
      append({option.name + "=" + value});
    }
    std::istringstream name(command.words());
    words.insert(words.begin(), std::istream_iterator<std::string>(name), {});
    return words;
  }

  // The options of a subcommand with every defect.
  [[nodiscard]] std::vector<BadInput> inputs_of(const Command& command) const {
    std::vector<BadInput> rows;
    for (const Listed& option : listed(command))
      std::ranges::move(spoilt("option", command.name + " " + option.name), std::back_inserter(rows));
    return rows;
  }

  void try_all(const Command& command) const {
    const auto options = listed(command);
    const auto folder = files();
    const auto inputs = inputs_of(command);
    record(inputs);
    for (const BadInput& row : inputs) {
      SCOPED_TRACE(row.item + ", " + row.defect);
      const auto option = std::ranges::find(options, row.item.substr(row.item.rfind(' ') + 1), &Listed::name);
      for (const std::string& value : values(row.item, row.defect))
        try_one(row, arguments(command, *option, row.defect, value), folder);
    }
  }

 private:
  void try_one(const BadInput& row, const std::vector<std::string>& words,
               std::vector<std::string> before) const {
    plant_neighbours();
    const Outcome outcome = run_here(words);
    const std::string arguments = fmt::format("{}", fmt::join(words, " "));
    expect_neighbours_untouched(arguments.substr(0, 300));
    // No reference is known as well as such a tolerance asks for, and no sample covers so short a time.
    const bool is_undecided = row.item == "compare --tolerance" || row.item == "compare --until";
    const bool is_tiny =
        row.defect == "denormal" || (row.defect == "zero" && row.item == "compare --tolerance");
    const int taken = is_undecided && is_tiny ? 3 : 0;
    EXPECT_EQ(outcome.status, row.is_refused() ? 2 : taken) << arguments.substr(0, 300) << "\n"
                                                            << outcome.errors.substr(0, 300);
    if (row.is_refused()) {
      expect_error_message(row, arguments, outcome);
      expect_no_new_file(std::move(before));
    } else {
      const bool repeats_a_name = row.reason == "a file may have that name";
      EXPECT_TRUE(repeats_a_name || !holds_no_number(outcome.output)) << outcome.output;
      for (const std::string& name : files())
        if (name != "tools" && name != "large" && name != "stdout" && name != "stderr") fs::remove_all(name);
    }
  }

  void expect_no_new_file(std::vector<std::string> before) const {
    auto after = files();
    std::erase(after, "stdout");
    std::erase(after, "stderr");
    std::erase(before, "stdout");
    std::erase(before, "stderr");
    EXPECT_EQ(after, before);
  }

  void expect_error_message(const BadInput& row, const std::string& arguments, const Outcome& outcome) const {
    EXPECT_EQ(outcome.output, "");
    EXPECT_TRUE(outcome.errors.starts_with("stickslip: ") && outcome.errors.ends_with("\n"))
        << outcome.errors;
    if (!outcome.errors.empty()) expect_one_sentence(outcome.errors.substr(0, outcome.errors.size() - 1));
    // These sentences name a file, a key or a column.
    const bool is_named =
        !fits("@(100 MB|deep nesting|zero)", row.defect) &&
        !fits("* --@(set|package|raw|events|manifest|tests|column*|tolerance|plan)", row.item);
    if (is_named && row.item.find("--") != std::string::npos) {
      EXPECT_TRUE(holds(outcome.errors, row.item.substr(row.item.find("--"))));
    }
    if (arguments.find("large") != std::string::npos) {
      EXPECT_TRUE(holds(outcome.errors, "large/"));
    }
    if (row.defect == "unknown" && row.item.ends_with("SUBCOMMAND")) {
      EXPECT_TRUE(holds(outcome.errors, "did you mean "));
    }
    if (row.defect == "unknown" && row.item.find("--") != std::string::npos) {
      EXPECT_TRUE(holds(outcome.errors, "did you mean " + row.item.substr(row.item.find("--")) + "?"));
    }
  }
};

class OptionsOf : public OptionInput, public ::testing::WithParamInterface<Command> {};

STICKSLIP_VERIFIES(OptionsOf, "U2");
TEST_P(OptionsOf, AreRefusedInOneSentenceOrTaken) { try_all(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Subcommands, OptionsOf, ::testing::ValuesIn(commands()),
                         [](const auto& instance) { return identifier(instance.param.name); });

STICKSLIP_VERIFIES(OptionInput, "U2");
TEST_F(OptionInput, AreListedByHelpWhereTheyAreUsed) {
  for (const Command& command : commands()) {
    const auto options = listed(command);
    for (const auto& [name, value] : command.arguments)
      EXPECT_TRUE(std::ranges::count(options, name, &Listed::name) == 1) << command.name << " " << name;
  }
}

TEST_F(OptionInput, BelongToSubcommandsThatAreTried) {
  std::set<std::string> names{"complete"}, listed_names;  // `complete` takes any words
  for (const Command& command : commands())
    if (!command.words().empty()) names.insert(words_of(command.name).front());
  for (const CLI::App* command : app_of({"stickslip", {}}).get_subcommands(nullptr))
    listed_names.insert(command->get_name());
  EXPECT_EQ(listed_names, names);
}

// Digits with zeros before them are a whole number; nothing else is, but a sign in a case file, and 0x7, which TOML takes.
TEST_F(OptionInput, IsAWholeNumberInDigits) {
  const Words spellings{"7", "007", "+7", "7.0", "0x7", "7e0", " 7", "7 ", ""};
  int tried = 0;
  for (const Command& command : commands()) {
    for (const auto& [name, takes_value, type] : listed(command)) {
      std::smatch limits;
      if (!std::regex_search(type, limits, std::regex("INT:([0-9]+) \\.\\.\\. ([0-9]+)"))) continue;
      SCOPED_TRACE(command.name + " " + name);
      const auto taken = [&, option = name](const std::string& value) {
        return run_here(arguments(command, {option, true}, "", value));
      };
      const Outcome plain = taken("7");
      for (const std::string& spelling : spellings) {
        const Outcome outcome = taken(spelling);
        if (spelling == "7" || spelling == "007") {
          EXPECT_EQ(outcome.errors, plain.errors) << spelling;
          EXPECT_EQ(outcome.output, plain.output) << spelling;
        } else {
          EXPECT_TRUE(holds(outcome.errors, name + " is ")) << spelling;
        }
      }
      // One beyond a limit is refused, and the lower limit is taken where nothing else forbids it.
      const auto sentence = [&, option = name](long beyond) {
        return fmt::format("{} is {}, but must be an integer from {} to {} ", option, beyond, limits.str(1),
                           limits.str(2));
      };
      for (const long beyond : {std::stol(limits[1]) - 1, std::stol(limits[2]) + 1})
        EXPECT_TRUE(holds(taken(std::to_string(beyond)).errors, sentence(beyond)));
      EXPECT_FALSE(holds(taken(limits[1]).errors, "an integer from"));
      tried += plain.status == 0 ? 1 : 0;
    }
  }
  EXPECT_GT(tried, 20);
}

TEST_F(OptionInput, IsAWholeNumberOfACaseFile) {
  for (const data::Key& key : data::case_keys()) {
    if (!key.member.is_integer || key.member.is_flag) continue;
    for (const std::string spelling : {"7", "007", "+7", "7.0", "0x7", "7e0", "'7'", "1_0.5"}) {
      std::optional<double> value;
      const auto message = error_message_if_any<data::InputError>([&] {
        value = data::value_of(data::load_case("paper", {{std::string(key.path), spelling}}), key.path);
      });
      EXPECT_EQ(value.value_or(7.0), 7.0) << spelling;
      EXPECT_EQ(message.has_value(), spelling.find_first_of(".e'") != std::string::npos) << spelling;
    }
  }
}

TEST_F(OptionInput, HasTheLimitsAndDefaultsOfTheHelp) {
  for (const auto& [command, name, type, standard] :
       {std::tuple{"modes", "--count", "INT:1 ... 1000", "3"},
        {"animate", "--frames", "INT:2 ... 9999", "200"},
        {"respond", "--every", "INT:1 ... 1000000000", ""},
        {"sweep", "--settle", "INT:0 ... 1000000", "100"},
        {"sweep", "--periods", "INT:1 ... 100000", "32"},
        {"uncertainty", "--samples", "UINT:1 ... 100000000", "10000"},
        {"uncertainty", "--seed", "UINT:0 ... 1000000000", "1"},
        {"uncertainty", "--threads", "UINT:1 ... 1024", ""},
        {"squeal", "--modes", "INT:1 ... 50", "5"},
        {"squeal", "--settle", "INT:1 ... 100000", "200"},
        {"squeal", "--count", "INT:2 ... 500", "41"},
        {"nvh", "--windows", "INT:2 ... 10000", "10"},
        {"nvh", "--average", "INT:1 ... 100000", "1"},
        {"periodic", "--periods", "INT:1 ... 1000", "1"},
        {"periodic", "--settle", "INT:1 ... 100000", "200"}}) {
    const CLI::Option* option = app_of({command, {}}).get_option(name);
    EXPECT_EQ(option->get_type_name(), type) << command << name;
    EXPECT_EQ(option->get_default_str(), standard) << command << name;
  }
}

// A limit of 1 kB for each file stands for a full disk.
TEST_F(OptionInput, LeavesFilesWhereAnOutputFails) {
  for (const Command& command : commands()) {
    (void)shell(fmt::format("ulimit -f 1; '{}' '{}'", STICKSLIP_PROGRAM, fmt::join(usual(command), "' '")));
    expect_neighbours_untouched(command.name);
  }
}

STICKSLIP_VERIFIES(InputFile, "U2");
class InputFile : public OptionInput {};

// By whatever name: another spelling, a symbolic link, a hard link.
TEST_F(InputFile, IsNoOutputOfTheSameCommand) {
  const std::string results = "beam,mode,frequency\npaper,1,25\n";
  std::vector<std::pair<Words, std::string>> runs{
      {{"criterion", "INPUT", "--output", "out.csv"}, contents(data::find_case("paper"))},
      {{"criterion", "paper", "--plan", "INPUT", "--output", "out.csv"}, "beam.length\n1\n2\n"},
      {{"compare", "stick-frequencies", "INPUT", "--json", "out.csv"}, results},
      {{"compare", "stick-frequencies", "INPUT", "--junit", "out.csv"}, results}};
  for (const Command& command : commands())
    if (const Words words = usual(command, "INPUT");
        std::ranges::count(words, "INPUT") + std::ranges::count(words, "out.csv") == 2)
      runs.emplace_back(words, contents(data::find_case(command.arguments.front().second)));
  EXPECT_EQ(runs.size(), 4u + 5u);  // respond, map, sweep, squeal, nvh
  for (auto& [words, text] : runs) {
    std::ofstream("out.csv", std::ios::binary) << text;
    fs::create_symlink("out.csv", "link.csv"), fs::create_hard_link("out.csv", "hard.csv");
    for (const char* name : {"out.csv", "./out.csv", "link.csv", "hard.csv"}) {
      Words with_name = words;
      std::ranges::replace(with_name, "INPUT", name);
      const Outcome outcome = run_here(with_name);
      EXPECT_EQ(outcome.status, 2) << fmt::format("{}", fmt::join(with_name, " "));
      EXPECT_TRUE(holds(outcome.errors, "out.csv is a file that the command reads, but must be another one"));
      EXPECT_EQ(contents("out.csv"), text);
    }
    for (const char* name : {"out.csv", "link.csv", "hard.csv"}) fs::remove(name);
  }
}

// The name of a file may hold anything, and is the name of its case in every output.
TEST_F(InputFile, MayHaveAnyName) {
  const std::string name = "=x\x1b]0;p\x07\xff,1\n2,\"'<b>&.toml";
  const auto expect_plain = [](const std::string& text) {
    EXPECT_TRUE(std::ranges::none_of(text, [](char c) { return c == '\x7f' || (c >= '\0' && c < '\n'); }))
        << text;
    EXPECT_EQ(text.find_first_of("\r\x1b"), std::string::npos) << text;
    EXPECT_EQ(text.find("&#"), std::string::npos) << text;  // XML 1.0 has no such character
  };
  int tables = 0;
  for (const Command& command : commands()) {
    auto words = usual(command, name);
    if (std::ranges::count(words, name) == 0) continue;
    fs::copy_file(data::find_case(command.arguments.front().second), name,
                  fs::copy_options::overwrite_existing);
    if (command.name == "criterion") words.insert(words.end(), {"--output", "out.csv"});
    for (const char* form : {"", "--json"}) {
      if (*form != '\0') words.emplace_back(form);
      const Outcome outcome = run_here(words);
      EXPECT_EQ(outcome.status, 0) << command.name << outcome.errors;
      if (command.name == "nvh") fs::remove("out.csv");  // a sound, no text
      for (const std::string& text : {outcome.output, outcome.errors, contents("out.csv")})
        expect_plain(text);
    }
    if (!fs::exists("out.csv")) continue;
    const std::string table = contents("out.csv");
    data::CsvReader rows("out.csv", table);
    while (const auto row = rows.next_row()) EXPECT_FALSE(row->front().starts_with('=')) << row->front();
    fs::remove("out.csv"), ++tables;
  }
  EXPECT_EQ(tables, 5);
  std::ofstream(name) << "beam,mode,frequency\npaper,1,25\n";
  const Outcome judged =
      run_here({"compare", "stick-frequencies", name, "--json", "out.json", "--junit", "out.xml"});
  EXPECT_EQ(judged.status, 1) << judged.errors;
  for (const std::string& text : {judged.output, contents("out.json"), contents("out.xml")})
    expect_plain(text);
}

// --- The exceptions

TEST_F(OptionInput, HasNoExceptionThatFitsNothing) {
  std::set<const Exception*> used;
  const auto use = [&](const std::vector<BadInput>& rows) {
    for (const BadInput& row : rows) used.insert(exception_of(row));
  };
  use(case_inputs());
  for (const auto& resource : package().resources)
    if (resource.comparison) use(column_inputs(resource));
  for (const auto& resource : data::load_reference().resources) use(published_inputs(resource));
  for (const auto& [item, pointer] : description_keys()) use(spoilt("package key", item));
  for (const Command& command : commands()) use(inputs_of(command));
  for (const Exception& row : exceptions)
    EXPECT_TRUE(used.contains(&row)) << row.where << ": " << row.item << ", " << row.defect;
}

// --- Warnings of the program: one line each on standard error, the sentences in JSON, the exit status unchanged. Which they are is
// tested in problem_warnings_test.cpp.

STICKSLIP_VERIFIES(Warnings, "U1");
class Warnings : public CommandLine {};

TEST_F(Warnings, AreOneLineEachAndInJson) {
  const std::string output = " --output out.csv",
                    amplitudes = "map --y amplitude=1e-4:2e-4:2 --x friction=0.4:0.6:2 ";
  for (const auto& [command, part] :
       {std::pair{std::string("modes --count 10"), "natural frequency 10 comes out about 40 % too high"},
        {"modes --count 10 --state slip --method fe", "natural frequency 10 comes out about 35 % too high"},
        {"criterion", "next to natural frequency 1"},
        {"respond --method closed-form --hz 25 --amplitude 1e-3 --duration 0.1" + output,
         "|f| exceeds mu_s P = 300 N first at 0.0553 s"},
        {"respond --method fe --hz 15 --duration 0.1 --set numerics.time_step=5e-3" + output,
         "numerics.time_step is 0.005 s"},
        {"respond --set beam.axial_force=84000 --duration 0.002" + output, "the sliding beam flutters"},
        {"respond --method event-driven --set beam.axial_force=84000 --duration 0.002" + output, "flutters"},
        {amplitudes + output, "next to natural frequency 1"},
        {amplitudes + "--hz 300 --duration 0.1" + output, "thick for Euler-Bernoulli"},
        {"design --band 300:300 --duration 0.1 --length 1.99:2 --force 499:500", "thick for Euler-Bernoulli"},
        {"modes --count 2", ""},
        {"criterion --hz 15 --set excitation.duration=0.5", ""},
        {"respond --hz 15 --duration 0.1" + output, ""},
        {"map --x frequency=20:30:2 --y amplitude=1e-4:2e-4:2 --duration 0.1" + output, ""}}) {
    const Outcome outcome = run_line(command + " --json");
    EXPECT_EQ(outcome.status, 0) << outcome.errors;
    const auto answer = nlohmann::json::parse(outcome.output);
    std::string lines;
    for (const auto& warning : answer["warnings"])
      lines += "stickslip: warning: " + warning.get<std::string>() + "\n";
    EXPECT_EQ(outcome.errors, lines);
    EXPECT_EQ(lines.empty(), *part == '\0') << command;
    EXPECT_TRUE(holds(lines, part)) << command;
  }
}

}  // namespace
}  // namespace stickslip::testing
