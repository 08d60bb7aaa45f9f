#include "stickslip/mutants/mutant.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <string_view>

#include "stickslip/data/case_file.hpp"
#include "toml_record.hpp"

namespace stickslip::mutants {

namespace fs = std::filesystem;

namespace {

Edit read_edit(const data::Record& record) {
  Edit edit{.file = record.text("file"), .from = record.text("from"), .to = record.any_text("to")};
  constexpr std::array components{"solver/", "analytic/"};
  if (std::ranges::none_of(components, [&](auto folder) { return edit.file.starts_with(folder); }))
    record.fail("file is " + edit.file + ", but must lie in solver/ or analytic/");
  return edit;
}

CuratedMutant read_mutant(const data::Record& record) {
  CuratedMutant mutant{.name = record.text("name"),
                       .mistake = record.text("mistake"),
                       .edits = record.tables("edit", {"file", "from", "to"}, read_edit)};
  const auto elsewhere = [&](const Edit& edit) {
    return component_of(edit.file) != component_of(mutant.edits.front().file);
  };
  if (std::ranges::any_of(mutant.edits, elsewhere))
    record.fail("edits must all lie in one component, solver/ or analytic/");
  return mutant;
}

}  // namespace

fs::path mutants_directory() { return STICKSLIP_MUTANTS_DIRECTORY; }

std::vector<CuratedMutant> curated_mutants() {
  const fs::path file = mutants_directory() / "curated.toml";
  auto mutants = data::read_all(file, "mutant", {"name", "mistake", "edit"}, read_mutant);
  data::require_unique(file, mutants, &CuratedMutant::name, "name");
  return mutants;
}

std::vector<Equivalence> equivalences() {
  return data::read_all(mutants_directory() / "equivalent.toml", "mutant", {"file", "was", "is", "proof"},
                        [](const data::Record& record) {
                          return Equivalence{.file = record.text("file"),
                                             .was = record.text("was"),
                                             .is = record.text("is"),
                                             .proof = record.text("proof")};
                        });
}

std::vector<IdleTests> idle_test_ledger() {
  return data::read_all(mutants_directory() / "idle.toml", "tests", {"names", "purpose"},
                        [](const data::Record& record) {
                          std::istringstream words(record.text("names"));
                          return IdleTests{.names = {std::istream_iterator<std::string>(words), {}},
                                           .purpose = record.text("purpose")};
                        });
}

std::string component_of(const std::string& file) { return file.substr(0, file.find('/')); }

std::string edited(const std::string& text, const Edit& edit) {
  const std::size_t place = text.find(edit.from);
  const bool once = place != std::string::npos && text.find(edit.from, place + 1) == std::string::npos;
  if (!once)
    throw data::InputError(
        fmt::format("{}: the passage '{}' must stand there exactly once", edit.file, edit.from));
  return std::string(text).replace(place, edit.from.size(), edit.to);
}

}  // namespace stickslip::mutants
