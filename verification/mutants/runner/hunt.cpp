#include "hunt.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

#include "fingerprint.hpp"
#include "stickslip/mutants/mutator.hpp"
#include "stickslip/report/text_file.hpp"
#include "studies/common/parallel.hpp"

namespace stickslip::mutants {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

constexpr const char* not_compiling = "not compiling";
constexpr const char* same_code = "same code";
constexpr const char* built = "built";

// What is remembered of a mutant, in a file beside the folder in which it is built.
class Memory {
 public:
  Memory(const Hunt& hunt, const std::string& name, const ChangedFiles& changed)
      : folder_(hunt.folder / name), file_(hunt.folder / (name + ".json")) {
    report::Fingerprint fingerprint;
    for (const char* component : {"solver", "analytic"})
      fingerprint.add(hunt.workshop.fingerprint(component));
    for (const auto& [changed_file, text] : changed) fingerprint.add(changed_file).add(text);
    const std::string key = fingerprint.text();
    json_ = Json::parse(report::read_text(file_), nullptr, false);
    if (json_.is_discarded()) json_ = Json::object();
    if (json_.value("key", "") != key) {
      // What killed it before is the first to be tried again.
      Json killer = json_.value("killer", Json());
      json_ = {{"key", key}};
      if (killer.is_object())
        json_["killer"] = {{"kind", killer["kind"]}, {"name", killer["name"]}, {"key", ""}};
    }
    const bool is_there = json_.value("outcome", "") != built || fs::exists(libraries());
    if (json_.contains("outcome") && is_there) return;
    switch (hunt.workshop.build(changed, folder_)) {
      case Workshop::Outcome::built:
        json_["outcome"] = built;
        break;
      case Workshop::Outcome::not_compiling:
        json_["outcome"] = not_compiling;
        break;
      case Workshop::Outcome::same_code:
        json_["outcome"] = same_code;
        break;
    }
    save();
  }

  [[nodiscard]] Json& json() { return json_; }
  [[nodiscard]] std::string outcome() const { return json_.at("outcome"); }
  [[nodiscard]] const fs::path& folder() const { return folder_; }
  [[nodiscard]] fs::path libraries() const { return folder_ / "lib"; }

  void save() const { report::replace_text(file_, json_.dump(1)); }

 private:
  fs::path folder_, file_;
  Json json_;
};

std::string fingerprint_of(const TestProgram& program, const std::set<std::string>& tests) {
  report::Fingerprint fingerprint;
  fingerprint.add(program.fingerprint);
  for (const auto& test : tests) fingerprint.add(test);
  return fingerprint.text();
}

using Selection = std::set<std::string> (*)(const TestProgram&);

// The tests of a program that fail, by memory if it has them.
std::vector<std::string> all_killers(Memory& memory, const TestProgram& program, const char* name,
                                     Selection select) {
  const auto tests = select(program);
  const std::string key = fingerprint_of(program, tests);
  Json& known = memory.json()["programs"][program.kind][name];
  if (!known.is_object() || known.at("key") != key) {
    known = {{"key", key},
             {"failing", failing_tests(program, tests, memory.libraries(), memory.folder(), false)}};
    memory.save();
  }
  return known.at("failing");
}

ChangedFiles changed_files(const CuratedMutant& mutant, const fs::path& source_tree) {
  ChangedFiles changed;
  for (const Edit& edit : mutant.edits) {
    const auto place = changed.try_emplace(edit.file, report::read_text(source_tree / edit.file)).first;
    place->second = edited(place->second, edit);
  }
  return changed;
}

// A generated mutant until something kills it.
class Chase {
 public:
  Chase(const Hunt& hunt, Memory& memory) : hunt_(hunt), memory_(memory) {}

  /// The killer; its name is empty if there is none.
  TestName run() {
    if (const TestName known = known_killer(); !known.name.empty()) return known;
    for (const auto select : {quick_tests, longer_tests})
      for (const TestProgram& program : hunt_.programs)
        if (const auto killer = first_killer(program, select(program)); !killer.empty()) {
          memory_.json()["killer"] = {{"kind", program.kind}, {"name", killer}, {"key", program.fingerprint}};
          memory_.save();
          return {program.kind, killer};
        }
    return {};
  }

 private:
  // Killed once, killed for ever, unless the program has changed and the test no longer fails.
  TestName known_killer() {
    if (!memory_.json().contains("killer")) return {};
    Json& killer = memory_.json().at("killer");
    const TestName test{killer.at("kind"), killer.at("name")};
    const auto program = std::ranges::find(hunt_.programs, test.kind, &TestProgram::kind);
    if (killer.at("key") == program->fingerprint) return test;
    const bool is_there = program->seconds.contains(test.name);
    if (is_there &&
        !failing_tests(*program, {test.name}, memory_.libraries(), memory_.folder(), true).empty()) {
      killer["key"] = program->fingerprint;
      memory_.save();
      return test;
    }
    memory_.json().erase("killer");
    return {};
  }

  std::string first_killer(const TestProgram& program, const std::set<std::string>& tests) {
    if (tests.empty()) return "";
    const std::string key = fingerprint_of(program, tests);
    Json& survived = memory_.json()["survived"];
    if (std::ranges::find(survived, Json(key)) != survived.end()) return "";
    const auto failing = failing_tests(program, tests, memory_.libraries(), memory_.folder(), true);
    if (!failing.empty()) return failing.front();
    survived.push_back(key);
    memory_.save();
    return "";
  }

  const Hunt& hunt_;
  Memory& memory_;
};

}  // namespace

KillMatrix hunt_curated(const Hunt& hunt, const std::vector<CuratedMutant>& mutants) {
  std::vector<ChangedFiles> changed;  // all of them now, so that an edit that does not fit is told at once
  for (const CuratedMutant& mutant : mutants) changed.push_back(changed_files(mutant, hunt.source_tree));
  std::vector<std::set<TestName>> killers(mutants.size());
  std::vector<char> has_faced_longer_tests(mutants.size(), 0);
  const auto chase = [&](std::size_t i) {
    Memory memory(hunt, mutants[i].name, changed[i]);
    if (memory.outcome() != built)
      throw std::runtime_error(
          fmt::format("the mutant {} is of no use: {}", mutants[i].name, memory.outcome()));
    std::set<std::string> kinds;
    const auto face = [&](const char* name, Selection select) {
      for (const TestProgram& program : hunt.programs)
        for (const auto& test : all_killers(memory, program, name, select)) {
          killers[i].insert({program.kind, test});
          kinds.insert(program.kind);
        }
    };
    face("quick", quick_tests);
    if (kinds.size() > 1) return;
    face("longer", longer_tests);
    has_faced_longer_tests[i] = 1;
  };
  studies::in_parallel(mutants.size(), chase, hunt.progress, hunt.threads);

  KillMatrix matrix;
  for (const auto& mutant : mutants) matrix.mutants.push_back(mutant.name);
  const auto add_rows = [&](const TestProgram& program, Selection select, bool all_have_faced_it) {
    for (const auto& name : select(program)) {
      const TestName test{program.kind, name};
      matrix.tests.push_back(test);
      auto& row = matrix.fates.emplace_back();
      for (std::size_t i = 0; i < mutants.size(); ++i) {
        const bool has_run = all_have_faced_it || has_faced_longer_tests[i] != 0;
        row.push_back(killers[i].contains(test) ? Fate::killed : has_run ? Fate::survives : Fate::not_run);
      }
    }
  };
  for (const TestProgram& program : hunt.programs) {
    add_rows(program, quick_tests, true);
    add_rows(program, longer_tests, false);
  }
  return matrix;
}

GeneratedSample hunt_generated(const Hunt& hunt, int count, std::uint64_t seed) {
  const auto candidates = generated_mutants(hunt.source_tree, seed);
  GeneratedSample sample{.seed = seed,
                         .candidates = static_cast<int>(candidates.size()),
                         .not_compiling = 0,
                         .same_code = 0,
                         .mutants = {}};
  // Those that drop out are replaced by the next, until there are enough: the sample does not depend on the
  // order in which threads finish.
  for (std::size_t begin = 0; std::ssize(sample.mutants) < count && begin < candidates.size();) {
    const std::size_t missing = static_cast<std::size_t>(count) - sample.mutants.size();
    const std::size_t size = std::min(missing, candidates.size() - begin);
    std::vector<std::string> outcomes(size);
    std::vector<TestName> killers(size);
    const auto chase = [&](std::size_t i) {
      const GeneratedMutant& mutant = candidates[begin + i];
      Memory memory(hunt, mutant.name, {{mutant.file, mutant.text}});
      outcomes[i] = memory.outcome();
      if (outcomes[i] == built) killers[i] = Chase(hunt, memory).run();
    };
    const auto progress = [&](double share) {
      const auto done = static_cast<double>(begin) + share * static_cast<double>(size);
      if (hunt.progress) hunt.progress(done / static_cast<double>(begin + size));
    };
    studies::in_parallel(size, chase, progress, hunt.threads);
    for (std::size_t i = 0; i < size; ++i) {
      const GeneratedMutant& mutant = candidates[begin + i];
      if (outcomes[i] == not_compiling) ++sample.not_compiling;
      if (outcomes[i] == same_code) ++sample.same_code;
      if (outcomes[i] == built)
        sample.mutants.push_back({.name = mutant.name,
                                  .file = mutant.file,
                                  .kind = mutant.kind,
                                  .was = mutant.was,
                                  .is = mutant.is,
                                  .line = mutant.line,
                                  .killed_by = killers[i].name,
                                  .killer_kind = killers[i].kind});
    }
    begin += size;
  }
  return sample;
}

}  // namespace stickslip::mutants
