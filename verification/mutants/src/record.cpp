#include "stickslip/mutants/record.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "stickslip/data/case_file.hpp"
#include "stickslip/mutants/mutant.hpp"
#include "stickslip/report/text_file.hpp"

namespace stickslip::mutants {

namespace fs = std::filesystem;

namespace {

constexpr const char* matrix_name = "kill-matrix.csv";
constexpr std::string_view fate_letters = "01-";  // in the order of Fate
constexpr const char* sample_name = "generated.json";

std::string text_of(const fs::path& file) {
  std::string text = report::read_text(file);
  if (text.empty()) throw data::InputError(file.string() + ": is missing or empty");
  return text;
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

}  // namespace

fs::path record_directory() { return mutants_directory() / "results"; }

KillMatrix read_kill_matrix(const fs::path& folder) {
  const fs::path file = folder / matrix_name;
  std::istringstream stream(text_of(file));
  KillMatrix matrix;
  std::string line;
  std::getline(stream, line);
  matrix.mutants = fields_of(line);
  if (matrix.mutants.size() < 3 || matrix.mutants[0] != "kind" || matrix.mutants[1] != "test")
    throw data::InputError(file.string() + ":1: must read 'kind,test,' and the names of the mutants");
  matrix.mutants.erase(matrix.mutants.begin(), matrix.mutants.begin() + 2);
  for (int number = 2; std::getline(stream, line); ++number) {
    const auto fields = fields_of(line);
    if (fields.size() != matrix.mutants.size() + 2)
      throw data::InputError(fmt::format("{}:{}: has {} fields, but must have {}", file.string(), number,
                                         fields.size(), matrix.mutants.size() + 2));
    matrix.tests.push_back({fields[0], fields[1]});
    auto& row = matrix.fates.emplace_back();
    for (std::size_t i = 2; i < fields.size(); ++i) {
      if (fields[i].size() != 1 || fate_letters.find(fields[i]) == std::string_view::npos)
        throw data::InputError(
            fmt::format("{}:{}: has '{}' where 0, 1 or - is expected", file.string(), number, fields[i]));
      row.push_back(static_cast<Fate>(fate_letters.find(fields[i])));
    }
  }
  return matrix;
}

void write(const KillMatrix& matrix, const fs::path& folder) {
  std::string text = "kind,test";
  for (const auto& mutant : matrix.mutants) text += ',' + mutant;
  for (std::size_t test = 0; test < matrix.tests.size(); ++test) {
    text += fmt::format("\n{},{}", matrix.tests[test].kind, matrix.tests[test].name);
    for (const Fate fate : matrix.fates[test]) {
      text += ',';
      text += fate_letters[static_cast<std::size_t>(fate)];
    }
  }
  report::replace_text(folder / matrix_name, text + '\n');
}

GeneratedSample read_generated_sample(const fs::path& folder) {
  const fs::path file = folder / sample_name;
  try {
    const auto json = nlohmann::json::parse(text_of(file));
    GeneratedSample sample{.seed = json.at("seed"),
                           .candidates = json.at("candidates"),
                           .not_compiling = json.at("not_compiling"),
                           .same_code = json.at("same_code"),
                           .mutants = {}};
    for (const auto& mutant : json.at("mutants"))
      sample.mutants.push_back({.name = mutant.at("name"),
                                .file = mutant.at("file"),
                                .kind = mutant.at("kind"),
                                .was = mutant.at("was"),
                                .is = mutant.at("is"),
                                .line = mutant.at("line"),
                                .killed_by = mutant.at("killed_by"),
                                .killer_kind = mutant.at("killer_kind")});
    return sample;
  } catch (const nlohmann::json::exception& error) {
    throw data::InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
}

void write(const GeneratedSample& sample, const fs::path& folder) {
  nlohmann::ordered_json mutants = nlohmann::ordered_json::array();
  for (const auto& mutant : sample.mutants)
    mutants.push_back({{"name", mutant.name},
                       {"file", mutant.file},
                       {"line", mutant.line},
                       {"kind", mutant.kind},
                       {"was", mutant.was},
                       {"is", mutant.is},
                       {"killed_by", mutant.killed_by},
                       {"killer_kind", mutant.killer_kind}});
  const nlohmann::ordered_json json{{"seed", sample.seed},
                                    {"candidates", sample.candidates},
                                    {"not_compiling", sample.not_compiling},
                                    {"same_code", sample.same_code},
                                    {"mutants", mutants}};
  report::replace_text(folder / sample_name, json.dump(1) + '\n');
}

}  // namespace stickslip::mutants
