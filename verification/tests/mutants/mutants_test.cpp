/// The catalogues of wrong versions of the models, the operators that make more of them, and the record of
/// what the suite caught. The mutants themselves are built and run by `verification/run --mutants`.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "stickslip/data/case_file.hpp"
#include "stickslip/mutants/mutant.hpp"
#include "stickslip/mutants/mutator.hpp"
#include "stickslip/mutants/record.hpp"
#include "stickslip/mutants/verdict.hpp"
#include "stickslip/report/text_file.hpp"
#include "support/requirements.hpp"

namespace stickslip::mutants {
namespace {

namespace fs = std::filesystem;

const fs::path source_tree = STICKSLIP_SOURCE_DIRECTORY;

// What the operators make of a source, each as the whole text.
std::multimap<std::string, std::string> mutants_of(const std::string& source) {
  std::multimap<std::string, std::string> texts;
  for (const Mutation& mutation : mutations_of(source))
    texts.emplace(mutation.kind, std::string(source).replace(mutation.offset, mutation.original.size(),
                                                             mutation.replacement));
  return texts;
}

std::set<std::string> mutants_of_kind(const std::string& kind, const std::string& source) {
  std::set<std::string> texts;
  const auto all = mutants_of(source);
  const auto [first, last] = all.equal_range(kind);
  for (auto mutant = first; mutant != last; ++mutant) texts.insert(mutant->second);
  return texts;
}

using Texts = std::set<std::string>;

STICKSLIP_VERIFIES(Mutator, "U7");
TEST(Mutator, ExchangesArithmeticOperators) {
  EXPECT_EQ(mutants_of_kind("arithmetic", "x = a + b;"), Texts{"x = a - b;"});
  EXPECT_EQ(mutants_of_kind("arithmetic", "x = a - b * c;"), (Texts{"x = a + b * c;", "x = a - b / c;"}));
  EXPECT_EQ(mutants_of_kind("arithmetic", "x += a;"), Texts{"x -= a;"});
}

TEST(Mutator, ExchangesRelationsAndMovesTheirBounds) {
  EXPECT_EQ(mutants_of_kind("relational", "if (a < b) f();"),
            (Texts{"if (a <= b) f();", "if (a >= b) f();"}));
  EXPECT_EQ(mutants_of_kind("relational", "return a == b;"), Texts{"return a != b;"});
}

TEST(Mutator, TellsTemplatesAndPointersFromOperators) {
  EXPECT_EQ(mutants_of("std::vector<Mode> f(const Beam* beam, Beam&& other);").size(), 0U);
}

TEST(Mutator, LeavesOutSignsAbsoluteValuesAndNegations) {
  EXPECT_EQ(mutants_of_kind("sign", "return -x;"), Texts{"return x;"});
  EXPECT_EQ(mutants_of_kind("sign", "y = a - f(-x);"), Texts{"y = a - f(x);"});
  EXPECT_EQ(mutants_of_kind("sign", "y = std::abs(x);"), Texts{"y = (x);"});
  EXPECT_EQ(mutants_of_kind("logical", "if (!a && b) f();"),
            (Texts{"if (a && b) f();", "if (!a || b) f();"}));
}

TEST(Mutator, ChangesConstantsAndIndices) {
  EXPECT_EQ(mutants_of_kind("constant", "x = 2;"), (Texts{"x = 3;", "x = 1;"}));
  EXPECT_EQ(mutants_of_kind("constant", "x = 0.5;"), Texts{"x = (2.0 * 0.5);"});
  EXPECT_EQ(mutants_of_kind("constant", "x = 1e-12;"), Texts{"x = (2.0 * 1e-12);"});
  EXPECT_EQ(mutants_of_kind("constant", "x = 0.0;"), Texts{"x = 1.0;"});
  EXPECT_EQ(mutants_of_kind("index", "x = a[i];"), Texts{"x = a[i + 1];"});
  EXPECT_TRUE(mutants_of_kind("index", "const auto [a, b] = f([&](int i) { return i; });").empty());
}

TEST(Mutator, NegatesConditionsAndDeletesStatementsButNoDeclarations) {
  EXPECT_EQ(mutants_of_kind("condition", "{ if (a) return b; }"), Texts{"{ if (!(a)) return b; }"});
  EXPECT_EQ(mutants_of_kind("deletion", "{ x = 1; f(); double y = 2; const int z = 3; return y; }"),
            (Texts{"{ ; f(); double y = 2; const int z = 3; return y; }",
                   "{ x = 1; ; double y = 2; const int z = 3; return y; }"}));
  EXPECT_EQ(mutants_of_kind("deletion", "{ if (a) f(); else g(); }"),
            (Texts{"{ if (a) ; else g(); }", "{ if (a) f(); else ; }"}));
}

TEST(Mutator, DeletesTheBodyOfALoopButNothingOfItsHead) {
  EXPECT_EQ(mutants_of_kind("deletion", "{ for (i = a; g(i); next(i)) f(i); }"),
            Texts{"{ for (i = a; g(i); next(i)) ; }"});
}

TEST(Mutator, LeavesCommentsStringsPreprocessorAndStaticAssertionsAlone) {
  EXPECT_TRUE(mutants_of("// a + b\n/* a - b */\n#if A > 1\nstatic_assert(a == b);\n").empty());
  EXPECT_EQ(mutants_of("throw Error(\"a + b\");").size(), 0U);
}

STICKSLIP_VERIFIES(GeneratedMutants, "U7");
TEST(GeneratedMutants, AreInAnOrderThatAChangeElsewhereDoesNotDisturb) {
  const fs::path tree = fs::temp_directory_path() / ("stickslip-mutants-" + std::to_string(::getpid()));
  const auto names = [&](const std::string& text) {
    fs::create_directories(tree / "solver");
    fs::create_directories(tree / "analytic");
    report::write_text(tree / "solver/a.cpp", text);
    std::vector<std::string> found;
    for (const auto& mutant : generated_mutants(tree, 1)) found.push_back(mutant.is);
    return found;
  };
  const auto before = names("x = a + b;\ny = c - d;\n");
  auto after = names("z = 1 * e;\nx = a + b;\ny = c - d;\n");
  fs::remove_all(tree);
  EXPECT_EQ(before.size(), 3U);  // two operators, and the second statement
  std::erase_if(after, [](const std::string& line) { return line.starts_with("z") || line == ";"; });
  auto expected = before;
  std::erase(expected, ";");
  EXPECT_EQ(after, expected);
}

TEST(GeneratedMutants, DependOnTheSeed) {
  const auto first = generated_mutants(source_tree, 1), second = generated_mutants(source_tree, 2);
  ASSERT_EQ(first.size(), second.size());
  EXPECT_NE(first.front().is, second.front().is);
}

STICKSLIP_VERIFIES(CuratedMutants, "U7");
TEST(CuratedMutants, AreManyAndFitTheSources) {
  const auto mutants = curated_mutants();
  EXPECT_GE(mutants.size(), 60U);
  for (const CuratedMutant& mutant : mutants)
    for (const Edit& edit : mutant.edits)
      EXPECT_NO_THROW((void)edited(report::read_text(source_tree / edit.file), edit)) << mutant.name;
}

TEST(CuratedMutants, RefuseAPassageThatDoesNotStandOnce) {
  EXPECT_EQ(edited("a + b", {"f", "+", "-"}), "a - b");
  EXPECT_THROW((void)edited("a + b + c", {"f", "+", "-"}), data::InputError);
  EXPECT_THROW((void)edited("a + b", {"f", "*", "-"}), data::InputError);
}

KillMatrix small_matrix() {
  return {.mutants = {"seen", "seen-by-one", "unseen"},
          .tests = {{"unit", "A.a"}, {"unit", "A.b"}, {"cross", "B.a"}},
          .fates = {{Fate::killed, Fate::killed, Fate::survives},
                    {Fate::killed, Fate::killed, Fate::survives},
                    {Fate::killed, Fate::survives, Fate::not_run}}};
}

STICKSLIP_VERIFIES(KillMatrix, "U7");
TEST(KillMatrix, TellsWhatIsNotKilledByTwoKindsOfTests) {
  const auto sentences = survivors(small_matrix());
  ASSERT_EQ(sentences.size(), 2U);
  EXPECT_TRUE(sentences[0].starts_with("seen-by-one is killed by 2 tests of 1 kinds"));
  EXPECT_TRUE(sentences[1].starts_with("unseen is killed by 0 tests"));
}

TEST(KillMatrix, TellsWhichTestsKillNothing) {
  KillMatrix matrix = small_matrix();
  EXPECT_TRUE(idle_tests(matrix).empty());
  matrix.fates[2] = {Fate::survives, Fate::survives, Fate::not_run};  // has not faced them all
  EXPECT_TRUE(idle_tests(matrix).empty());
  matrix.fates[1] = {Fate::survives, Fate::survives, Fate::survives};
  EXPECT_EQ(idle_tests(matrix), (std::vector<TestName>{{"unit", "A.b"}}));
}

TEST(KillMatrix, AsksOfEveryIdleTestWhatItIsFor) {
  KillMatrix matrix = small_matrix();
  matrix.tests = {{"unit", "Instance/A.a/1"}, {"unit", "A.ab"}, {"cross", "B.a"}};
  matrix.fates = {3, {Fate::survives, Fate::survives, Fate::survives}};
  EXPECT_TRUE(faults({{{"A", "B.a"}, "refuses input"}}, matrix).empty());
  const auto sentences = faults({{{"A.a", "B"}, "refuses input"}}, matrix);
  ASSERT_EQ(sentences.size(), 1U);
  EXPECT_TRUE(sentences[0].starts_with("A.ab kills no curated mutant"));
  matrix.fates[2][1] = Fate::killed;
  const auto superfluous = faults({{{"A", "B", "Ab"}, "refuses input"}}, matrix);
  ASSERT_EQ(superfluous.size(), 2U);
  EXPECT_TRUE(superfluous[0].starts_with("B is said"));
  EXPECT_TRUE(superfluous[1].starts_with("Ab is said"));
}

STICKSLIP_VERIFIES(GeneratedSample, "U7");
TEST(GeneratedSample, IsScoredByWhatIsNeitherKilledNorProvedEquivalent) {
  GeneratedSample sample;
  sample.mutants = {{.name = "1",
                     .file = "f",
                     .kind = "sign",
                     .was = "-a",
                     .is = "a",
                     .line = 1,
                     .killed_by = "A.a",
                     .killer_kind = "unit"},
                    {.name = "2",
                     .file = "f",
                     .kind = "sign",
                     .was = "-b",
                     .is = "b",
                     .line = 2,
                     .killed_by = "",
                     .killer_kind = ""},
                    {.name = "3",
                     .file = "f",
                     .kind = "sign",
                     .was = "-c",
                     .is = "c",
                     .line = 3,
                     .killed_by = "",
                     .killer_kind = ""}};
  const std::vector<Equivalence> proofs{{"f", "-b", "b", "b is zero"}, {"g", "-c", "c", "elsewhere"}};
  const Score result = score(sample, proofs);
  EXPECT_EQ(result.killed, 1);
  EXPECT_EQ(result.equivalent, 1);
  EXPECT_EQ(result.survived, 1);
  EXPECT_DOUBLE_EQ(result.value(), 0.5);
  ASSERT_EQ(survivors(sample, proofs).size(), 1U);
  EXPECT_TRUE(survivors(sample, proofs).front().starts_with("f:3: no test sees 'c' for '-c'"));
}

class MutantRecordFolder : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  const fs::path folder_ = fs::temp_directory_path() / ("stickslip-record-" + std::to_string(::getpid()));
};

STICKSLIP_VERIFIES(MutantRecordFolder, "U7");
TEST_F(MutantRecordFolder, ReturnsWhatWasWritten) {
  const KillMatrix matrix = small_matrix();
  write(matrix, folder_);
  const KillMatrix read = read_kill_matrix(folder_);
  EXPECT_EQ(read.mutants, matrix.mutants);
  EXPECT_EQ(read.tests, matrix.tests);
  EXPECT_EQ(read.fates, matrix.fates);

  GeneratedSample sample{.seed = 3, .candidates = 10, .not_compiling = 2, .same_code = 1, .mutants = {}};
  sample.mutants = {{.name = "1",
                     .file = "f",
                     .kind = "sign",
                     .was = "-a, \"b\"",
                     .is = "a",
                     .line = 7,
                     .killed_by = "A.a",
                     .killer_kind = "unit"}};
  write(sample, folder_);
  const GeneratedSample again = read_generated_sample(folder_);
  EXPECT_EQ(again.seed, 3U);
  EXPECT_EQ(again.candidates, 10);
  EXPECT_EQ(again.not_compiling, 2);
  EXPECT_EQ(again.same_code, 1);
  ASSERT_EQ(again.mutants.size(), 1U);
  EXPECT_EQ(again.mutants[0].was, "-a, \"b\"");
  EXPECT_EQ(again.mutants[0].line, 7);
  EXPECT_EQ(again.mutants[0].killed_by, "A.a");
}

TEST_F(MutantRecordFolder, RefusesWhatCannotBeUsed) {
  EXPECT_THROW((void)read_kill_matrix(folder_), data::InputError);
  EXPECT_THROW((void)read_generated_sample(folder_), data::InputError);
  for (const char* text : {"test,kind,a\n", "kind,test,a\nunit,A.a\n", "kind,test,a\nunit,A.a,2\n"}) {
    report::write_text(folder_ / "kill-matrix.csv", text);
    EXPECT_THROW((void)read_kill_matrix(folder_), data::InputError) << text;
  }
  report::write_text(folder_ / "generated.json", "{\"seed\": 1");
  EXPECT_THROW((void)read_generated_sample(folder_), data::InputError);
}

STICKSLIP_VERIFIES(MutantRecord, "U7");
TEST(MutantRecord, HoldsEveryCuratedMutantKilledByTwoKindsOfTests) {
  const KillMatrix matrix = read_kill_matrix();
  std::vector<std::string> names;
  for (const CuratedMutant& mutant : curated_mutants()) names.push_back(mutant.name);
  EXPECT_EQ(matrix.mutants, names) << "run verification/run --mutants again";
  for (const std::string& sentence : survivors(matrix)) ADD_FAILURE() << sentence;
}

TEST(MutantRecord, HoldsNoTestThatKillsNothingWithoutSayingWhatItIsFor) {
  for (const std::string& sentence : faults(idle_test_ledger(), read_kill_matrix()))
    ADD_FAILURE() << sentence;
}

TEST(MutantRecord, HoldsFourHundredGeneratedMutantsEachKilledOrProvedEquivalent) {
  const GeneratedSample sample = read_generated_sample();
  EXPECT_GE(sample.mutants.size(), 400U);
  for (const std::string& sentence : survivors(sample, equivalences())) ADD_FAILURE() << sentence;
}

TEST(MutantRecord, ProvesNothingEquivalentThatIsKilledOrNoLongerThere) {
  const auto sample = read_generated_sample();
  for (const Equivalence& entry : equivalences()) {
    const auto stands_for = [&](const GeneratedResult& mutant) {
      return mutant.file == entry.file && mutant.was == entry.was && mutant.is == entry.is &&
             mutant.killed_by.empty();
    };
    EXPECT_TRUE(std::ranges::any_of(sample.mutants, stands_for)) << entry.file << ": " << entry.is;
  }
}

}  // namespace
}  // namespace stickslip::mutants
