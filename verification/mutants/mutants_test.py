# SPDX-License-Identifier: MIT
"""Tests of the mutation runs themselves: which mistakes are made, how they are known, and what a test log says."""

import subprocess
import sys
import tomllib
import unittest

sys.dont_write_bytecode = True
import mistakes
import mutants

CODE = """
#include <cmath>
namespace a {
constexpr double limit = 1e6;  // 1 of 2
constexpr std::array table{Row{"x", 1, 2.5}};
struct Beam {
  Beam(int n) : nodes_{n + 1}, mass_(2.0) { reserve(n); }
  bool operator<(const Beam& other) const { return mass_ < other.mass_; }
  int nodes_; double mass_;
};
std::function<double(double)> Beam::shape(int n) const { return [n](double x) { return n * x; }; }
double Beam::load(double x, int i) const {
  if (x <= 0.0 || !ready) throw Error(1 + 2);
  std::vector<double> y(3);
  for (int j = 0; j < i; ++j) y[j] = -std::abs(x * j);
  store(x, i);
  store(std::max(i, n));
  return x > 1.0 ? y[0] : "a < b"s;
}
}  // namespace a
"""


def edits(function):
    return {m.edit for m in mistakes.mutants_of("part", "file.cpp", CODE) if m.function == function}


class Mistakes(unittest.TestCase):
    def test_lie_in_functions_tables_and_constants(self):
        functions = {m.function for m in mistakes.mutants_of("part", "file.cpp", CODE)}
        self.assertEqual(functions, {"limit", "table", "Beam::Beam", "Beam::operator<", "Beam::load", "Beam::shape"})

    def test_change_one_operator_number_index_condition_call_or_statement(self):
        self.assertLessEqual({
            "if ( x [<= -> <] 0.0 || !", "if ( x [<= -> >] 0.0 || !", "x <= 0.0 [|| -> &&] ! ready )",
            "<= 0.0 || [! -> ] ready ) throw", "{ if ( [x <= 0.0 || ! ready -> ! ( x <= 0.0 || ! ready )] ) throw Error",
            "return x > [1.0 -> ( 2.0 * 1.0 )] ? y [", "int j = [0 -> 1] ; j <", ") y [ [j -> j + 1] ] = -",
            "j ] = [- -> ] std :: abs", "] = - [std :: abs -> ] ( x *", "; store ( [x , i -> i , x] ) ; store",
            "j ) ; [store ( x , i ) -> ] ; store (", '> 1.0 ? [y [ 0 ] : "a < b" s -> "a < b" s : y [ 0 ]] ; } }',
        }, edits("Beam::load"))

    def test_leave_strings_messages_templates_and_heads_of_loops_alone(self):
        text = " ".join(edits("Beam::load"))
        for absent in ("[1 -> 2] + 2", "[double ->", "\"a [<", "[j < i -> ]", "[++ j -> ]", "[i , n -> n , i]"):
            self.assertNotIn(absent, text)

    def test_are_known_by_tokens_whatever_the_layout(self):
        squeezed = CODE.replace("\n  ", "\n\n\t// moved\n      ")
        ids = [[m.id for m in mistakes.mutants_of("part", "file.cpp", text)] for text in (CODE, squeezed)]
        self.assertEqual(ids[0], ids[1])
        self.assertEqual(len(set(ids[0])), len(ids[0]))

    def test_of_the_catalogue_stand_once_in_their_function(self):
        self.assertIn("x >= 0.0", mistakes.curated_edit(CODE, "Beam::load", "x<=0.0", "x >= 0.0"))
        for function, old in (("Beam::load", "x"), ("Beam::Beam", "x <= 0.0")):
            with self.assertRaises(ValueError):
                mistakes.curated_edit(CODE, function, old, "y")


class Logs(unittest.TestCase):
    def run_of(self, script, seconds=60.0):
        mutants.PATIENCE = seconds
        process = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE)
        try:
            return mutants.watch(process, {"A.b": 0.0, "A.c": 0.0}, True)
        finally:
            process.kill()
            process.communicate()

    def log(self, *lines):
        return "print(" + repr("\n".join(lines)) + ", flush=True);"

    def test_name_the_test_that_failed(self):
        run = self.run_of(self.log("[ RUN      ] A.b", "[       OK ] A.b (7 ms)", "[ RUN      ] A.c",
                                   "[  FAILED  ] A.c, where GetParam() = (1, 2) (3 ms)", "[  FAILED  ] A.c") + "exit(1)")
        self.assertEqual((run.passed, run.failed, run.how), ({"A.b": 0.007}, ["A.c"], "test"))

    def test_count_a_skipped_test_as_finished(self):
        run = self.run_of(self.log("[ RUN      ] A.b", "[  SKIPPED ] A.b (0 ms)", "[  SKIPPED ] 1 test, listed below:"))
        self.assertEqual((run.passed, run.failed), ({"A.b": 0.0}, []))

    def test_name_the_test_that_crashed_or_hung(self):
        begun = self.log("[ RUN      ] A.b", "[       OK ] A.b (0 ms)", "[ RUN      ] A.c")
        run = self.run_of(begun + "import os; os.abort()")
        self.assertEqual((run.failed, run.how), (["A.c"], "crash"))
        run = self.run_of(begun + "import time; time.sleep(60)", 0.5)
        self.assertEqual((run.failed, run.how), (["A.c"], "timeout"))


class Catalogues(unittest.TestCase):
    def test_name_what_the_sources_hold(self):
        _, stale = mistakes.curated_mutants(mutants.ROOT, mutants.FOLDER / "curated.toml")
        self.assertEqual(stale, [])
        made = {mutants.place_of(vars(mutant)) for part in mistakes.PARTS
                for mutant in mistakes.generated_mutants(mutants.ROOT, part, 1)}
        listed = tomllib.loads((mutants.FOLDER / "survivors.toml").read_text())
        for entry in listed["equivalent"] + listed["open"]:
            self.assertIn(mutants.place_of(entry), made)


if __name__ == "__main__":
    unittest.main()
