#pragma once

/// What the last run of the mutants found: kill-matrix.csv and generated.json in the folder results/.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace stickslip::mutants {

/// A test by its full name, "Suite.Name/parameter", and the kind of the program that holds it: unit, order,
/// paper or cross.
struct TestName {
  std::string kind;
  std::string name;

  auto operator<=>(const TestName&) const = default;
};

/// What a test said of a mutant.
enum class Fate : char { survives, killed, not_run };

/// Which test fails on which curated mutant. Every mutant faces the quick tests; the longer ones only if
/// tests of two kinds have not killed it by then.
struct KillMatrix {
  std::vector<std::string> mutants;      ///< names
  std::vector<TestName> tests;           ///< of each kind the quick ones, then the longer ones
  std::vector<std::vector<Fate>> fates;  ///< fates[test][mutant]
};

/// A generated mutant that compiled to other code than the original.
struct GeneratedResult {
  std::string name, file, kind, was, is;
  int line{};
  std::string killed_by;    ///< a test, or empty: it survived
  std::string killer_kind;  ///< of that test
};

/// A sample of generated mutants.
struct GeneratedSample {
  std::uint64_t seed{};
  int candidates{};     ///< that there are in the sources
  int not_compiling{};  ///< of those drawn
  int same_code{};      ///< of those drawn: the compiler made the same code of them
  std::vector<GeneratedResult> mutants;
};

/// The folder of the record.
[[nodiscard]] std::filesystem::path record_directory();

/// Throw data::InputError, naming the file, for one that is missing or cannot be used.
[[nodiscard]] KillMatrix read_kill_matrix(const std::filesystem::path& folder = record_directory());
[[nodiscard]] GeneratedSample read_generated_sample(const std::filesystem::path& folder = record_directory());

/// Throw std::runtime_error if the file cannot be written. The file appears whole or not at all.
void write(const KillMatrix& matrix, const std::filesystem::path& folder);
void write(const GeneratedSample& sample, const std::filesystem::path& folder);

}  // namespace stickslip::mutants
