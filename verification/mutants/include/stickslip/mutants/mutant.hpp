#pragma once

/// Wrong versions of the models. A suite is worth what it catches: each mutant is a copy of solver/ or
/// analytic/ with one mistake in it, and some test has to fail.

#include <filesystem>
#include <string>
#include <vector>

namespace stickslip::mutants {

/// A passage of a source file and what stands there instead.
struct Edit {
  std::string file;  ///< relative to the source tree: "solver/src/beam_model.cpp"
  std::string from;  ///< occurs exactly once in the file
  std::string to;
};

/// A mistake that an engineer would make.
struct CuratedMutant {
  std::string name;         ///< "axial-force-sign"
  std::string mistake;      ///< a clause: "the axial force stiffens the beam instead of softening it"
  std::vector<Edit> edits;  ///< at least one, all in the same component
};

/// A generated mutant that no test can kill, with the reason.
struct Equivalence {
  std::string file;
  std::string was;  ///< the line of code, without the spaces around it
  std::string is;   ///< the same with the mistake
  std::string proof;
};

/// Tests that kill no curated mutant, and what they are there for all the same.
struct IdleTests {
  std::vector<std::string> names;  ///< of suites, "Suite", or of tests, "Suite.Name", without parameters
  std::string purpose;             ///< a clause: "checks the suite's own tools, which no mutant changes"
};

/// The folder with the catalogues and the record of the last run.
[[nodiscard]] std::filesystem::path mutants_directory();

/// The catalogue in curated.toml. Throws data::InputError, naming file and line, for one that cannot be used,
/// for a name that stands twice and for edits in more than one component.
[[nodiscard]] std::vector<CuratedMutant> curated_mutants();

/// The ledger in equivalent.toml. Throws data::InputError.
[[nodiscard]] std::vector<Equivalence> equivalences();

/// The ledger in idle.toml. Throws data::InputError.
[[nodiscard]] std::vector<IdleTests> idle_test_ledger();

/// The first folder of a path: "solver" or "analytic".
[[nodiscard]] std::string component_of(const std::string& file);

/// The text with the edit made. Throws data::InputError, naming file and passage, unless it occurs exactly
/// once.
[[nodiscard]] std::string edited(const std::string& text, const Edit& edit);

}  // namespace stickslip::mutants
