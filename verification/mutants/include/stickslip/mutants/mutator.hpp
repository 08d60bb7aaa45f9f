#pragma once

/// Mutants by operators: small changes of one token or statement of C++ source, without knowledge of what it
/// means. They ask the suite about every line, where the curated ones ask about what is known to go wrong.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace stickslip::mutants {

/// One change of a source text.
struct Mutation {
  std::string kind;  ///< arithmetic, relational, logical, sign, constant, index, condition or deletion
  std::size_t offset{};
  std::string original;  ///< what stands at the offset
  std::string replacement;
};

/// Every change that the operators make of a C++ source in the style of this project (binary operators have
/// spaces around them, brackets of templates have none):
///
///     arithmetic   + for -, * for / and the other way round, also in compound assignments
///     relational   < for <=, < for >=, == for !=, and so on
///     logical      && for ||, a negation left out
///     sign         a unary minus left out, an absolute value left out
///     constant     an integer plus or minus one; twice the value, or one for zero, of a floating-point
///     number index        the neighbour above in a subscript condition    an if negated deletion     a
///     statement left out that is neither a declaration nor returns a value
///
/// Comments, preprocessor lines, strings and static assertions stay as they are.
[[nodiscard]] std::vector<Mutation> mutations_of(std::string_view source);

/// A mutation in its file.
struct GeneratedMutant {
  std::string file;  ///< relative to the source tree
  int line{};
  std::string kind;
  std::string was;   ///< the line of code, without the spaces around it
  std::string is;    ///< the same with the mistake
  std::string text;  ///< the whole file with the mistake

  /// 16 hexadecimal digits: the hash of seed, file, was, is and the number of such lines before.
  std::string name;
};

/// All mutants of solver/ and analytic/ in the source tree, in the order in which a sample takes them: that
/// of their names. A change of one line leaves the names, and so the order, of all others as they were.
[[nodiscard]] std::vector<GeneratedMutant> generated_mutants(const std::filesystem::path& source_tree,
                                                             std::uint64_t seed);

}  // namespace stickslip::mutants
