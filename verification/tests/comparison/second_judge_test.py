#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""second_judge_test.py PROGRAM: both judges, `stickslip compare` and the Python package, say the same of every file.

The files are each data set itself and spoilt copies of it. The program gets a copy of the data without `diagnosis`, which takes
time and decides nothing.
"""
import array
import collections
import csv
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "reports/python"))
import stickslip  # noqa: E402
from stickslip.__main__ import main  # noqa: E402

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
# How a file is written is read by the same code for all data sets: these are tried once for each kind of comparison.
FORMATS = ("without names", "without names, given", "names in a comment", "two columns alone", "single precision", "some rows, as meant",
           "some rows, more meant")
STATUS = {"agrees": 0, "differs": 1, "refused": 2, "undecided": 3}


def text_of(rows, separator=","):
    return "\n".join(separator.join(row) for row in rows) + "\n"


def changed(table, column, change):
    """The rows of the data set, but with the numbers or words of a column changed; change() gets the cell and the number of the row."""
    columns = {**table.text, column: [change(cell, row) for row, cell in enumerate(table.text[column])]}
    return [list(columns), *map(list, zip(*columns.values()))]


def copies(table):
    """Name of the mistake, text of the file, options of both judges."""
    head, *rows = changed(table, next(iter(table.text)), lambda cell, row: cell)
    rule, values = table.comparison, table.comparison["values"]
    first = next(value["field"] for value in values if value["norm"] != "word" and value["field"] != "time")
    peak = max(range(table.rows), key=lambda row: abs(table.cells[first][row]))
    number = lambda change: lambda cell, row: repr(change(float(cell), row)) if cell else cell  # noqa: E731
    yield "copy", text_of([head, *rows]), []
    yield "one value scaled", text_of(changed(table, first, number(lambda x, row: x * (1.3 if row == peak else 1)))), []
    yield "all values scaled by a fifth", text_of(changed(table, first, number(lambda x, row: 1.2 * x))), []
    yield "all values scaled by a 500th", text_of(changed(table, first, number(lambda x, row: 1.002 * x))), []
    yield "sign", text_of(changed(table, first, number(lambda x, row: -x))), []
    yield "a missing row", text_of([head, *rows[:peak], *rows[peak + 1:]]), []
    yield "half", text_of([head, *rows[:table.rows // 2]]), []
    yield "a tenth", text_of([head, *rows[:table.rows // 10 + 1]]), []
    yield "every other row", text_of([head, *rows[::2]]), []
    yield "a row twice", text_of([head, *rows[:3], rows[2], *rows[3:]]), []
    yield "without names", text_of(rows), []
    yield "without names, given", text_of(rows), ["--columns", ",".join(head)]
    yield "two columns alone", text_of([[cell for name, cell in zip(head, row) if name in (*table.key, first, "change", "phase")]
                                        for row in [head, *rows]], ";"), []
    yield "names in a comment", "# " + text_of([head, *rows], "\t"), []
    yield "single precision", text_of([head, *([cell if table.types[name] != "number" or not cell else
                                                repr(array.array("f", [float(cell)])[0]) for name, cell in zip(head, row)]
                                               for row in rows)]), []
    yield "fifteen digits", text_of([head, *([cell if table.types[name] != "number" or not cell else f"{float(cell):.15g}"
                                              for name, cell in zip(head, row)] for row in rows)]), []
    yield "a narrow tolerance", text_of([head, *rows]), ["--tolerance", "1e-9"]
    yield "a wide tolerance", text_of(changed(table, first, number(lambda x, row: 1.02 * x))), ["--tolerance", "0.1"]
    for word in (name for name in ("change", "phase", "verdict") if name in head):
        words = sorted(set(table.text[word]))
        swap = dict(zip(words, words[1:] + words[:1]))
        yield f"{word} interchanged", text_of(changed(table, word, lambda cell, row: swap[cell])), []
        yield f"{word} foreign", text_of(changed(table, word, lambda cell, row: "foo")), []
    if rule["kind"] == "table":
        yield "an unknown row", text_of([head, *rows, [cell if table.types[name] == "string" else "77" for name, cell in
                                                      zip(head, rows[-1])]]), []
        yield "some rows, as meant", text_of([head, *rows[:3]]), ["--rows", "1:3"]
        yield "some rows, more meant", text_of([head, *rows[:3]]), ["--rows", "1,3:5"]
    if "time" in head:
        yield "shifted", text_of(changed(table, "time", number(lambda t, row: t + 3e-4))), []
        yield "slightly shifted", text_of(changed(table, "time", number(lambda t, row: t + 2e-5))), []
        yield "in milliseconds", text_of(changed(table, "time", number(lambda t, row: 1e3 * t))).replace("time", "time [ms]", 1), []
        yield "not in milliseconds", text_of(changed(table, "time", number(lambda t, row: 1e3 * t))), []
    if "time" in head and "x" not in head:
        yield "until", text_of([head, *rows[:table.rows // 2]]), ["--until", repr(0.45 * max(table.cells["time"]))]
    if rule["kind"] in ("curve", "phases"):
        between = [[repr((float(a) + float(b)) / 2) if name not in ("phase",) else a for name, a, b in zip(head, one, other)]
                   for one, other in zip(rows, rows[1:])]
        yield "means of neighbours", text_of([head, *between]), []


class BothJudges(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        shutil.copytree(ROOT / "data/reference", cls.folder / "package")
        cls.description = cls.folder / "package/datapackage.json"
        cls.package = json.loads(cls.description.read_text())

    def verdicts(self, name, text, options):
        """The exit statuses and, if nothing is refused, the verdicts and the levels of both."""
        (self.folder / "mine.csv").write_text(text)
        results = []
        program = [PROGRAM, "compare", "--package", self.folder / "package", "--quiet"]
        for judge in (program, [sys.executable, "-m", "stickslip", "judge"]):
            output = self.folder / "verdict.json"
            output.unlink(missing_ok=True)
            words = [name, str(self.folder / "mine.csv"), "--json", str(output), *options]
            if judge is program:
                done = subprocess.run([*judge, *words], capture_output=True, text=True)
                status, said = done.returncode, done.stderr
            else:
                status, said = main(["judge", "--quiet", *words]), ""
            self.assertNotIn("Traceback", said)
            verdict = json.loads(output.read_text()) if status != 2 else {}
            quantities = {one.get("quantity", one.get("name")): (one["verdict"], one["compared"],
                          None if one["error"] is None else float(f"{one['error']:.6g}"), one["level"])
                          for one in verdict.get("quantities", [])}
            results.append((status, verdict.get("verdict", "refused").replace("partly", "undecided"), verdict.get("level"), quantities,
                            said))
        return results

    def test_say_the_same_of_every_file(self):
        counts, tried = collections.Counter(), set()
        for name in stickslip.names():
            table = stickslip.load(name)
            if not table.comparison:
                continue
            needed = ("beams", name, table.comparison.get("events"))
            hidden = "diagnosis", "problem"  # without which nothing is computed
            resources = [{member: one[member] for member in one if member not in hidden}
                         for one in self.package["resources"] if one["name"] in needed]
            self.description.write_text(json.dumps({**self.package, "resources": resources}))
            for mistake, text, options in copies(table):
                if mistake in FORMATS and (mistake, table.comparison["kind"]) in tried:
                    continue
                tried.add((mistake, table.comparison["kind"]))
                with self.subTest(data_set=name, mistake=mistake):
                    program, python = self.verdicts(name, text, options)
                    counts[python[1]] += 1
                    self.assertEqual(program[:4], python[:4], program[4])
                    self.assertEqual(python[0], STATUS[python[1]])
                    if mistake == "a narrow tolerance" and name.startswith("undamped-history"):
                        self.assertEqual(python[1], "undecided")
                    if mistake == "copy":
                        self.assertEqual(python[1:3], ("agrees", "strict"))
                    if mistake in ("all values scaled by a fifth", "sign") or mistake.endswith("interchanged"):
                        self.assertEqual(python[1], "differs")
        self.assertGreater(min(counts[verdict] for verdict in STATUS), 30, counts)

    def test_say_the_same_of_a_manifest(self):
        shutil.copy(ROOT / "data/reference/frequencies/stick.csv", self.folder / "good.csv")
        manifest = self.folder / "results.csv"
        for rows, status in (("stick-frequencies,good.csv,\n", 0), ("stick-frequencies,good.csv,1:3\nslip-frequencies,good.csv,\n", 1),
                             ("slip-frequencies,good.csv,\nstick-frequencies,none.csv,\n", 2), ("slip-frequencies,good.csv\n", 2)):
            manifest.write_text("data_set,file,rows\n" + rows)
            program = subprocess.run([PROGRAM, "compare", "--manifest", manifest], capture_output=True, text=True)
            self.assertEqual((program.returncode, main(["judge", "--quiet", "--manifest", str(manifest)])), (status, status), rows)


class Package(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def refusal(self, *arguments, **options):
        with self.assertRaises(stickslip.InputError) as refused:
            stickslip.judge(*arguments, **options)
        return str(refused.exception)

    def test_loads_numbers_half_widths_units_and_problem(self):
        table = stickslip.load("stick-frequencies")
        self.assertEqual((table["beam"][0], table.units["frequency"], table.problem["tip"]), ("paper", "Hz", "held"))
        self.assertAlmostEqual(table["frequency"][0], 24.971958095, 8)
        self.assertLess(table.half_widths["frequency"][0], 1e-28)
        with self.assertRaisesRegex(stickslip.InputError, "did you mean stick-frequencies"):
            stickslip.load("stick-freqencies")

    def test_judges_columns_in_memory(self):
        mine = {"beam": "paper", "mode": [1, 2], "frequency [kHz]": [0.024971958095, 0.081077621]}
        judgement = stickslip.judge("stick-frequencies", mine, rows=[1, 2])
        self.assertEqual((judgement.conclusion, judgement.level, bool(judgement)), ("agrees in 2 of 50 rows", "strict", True))
        self.assertEqual(stickslip.judge("stick-frequencies", mine).verdict, "partly")
        off = stickslip.judge("stick-frequencies", [("paper", 1, 25.0)], columns=["beam", "mode", "frequency"], rows=[1])
        self.assertEqual((off.verdict, off.level), ("differs", "1e-3"))
        self.assertAlmostEqual(off.quantities[0].error, 25 / 24.971958095 - 1, 9)
        self.assertEqual(stickslip.judge("stick-history", stickslip.load("stick-history"), until=0.2).verdict, "agrees")

    def test_refuses_in_one_sentence(self):
        mine = {"beam": "paper", "mode": [1, 2], "frequency": [25.0, 81.0]}
        for change, sentence in (({"mode": [1, 1]}, "stands in the data, row 1 already"), ({"mode": [1, 77]}, "is not in the data set"),
                                 ({"frequency": [25.0, float("nan")]}, "must be a finite number"), ({"mode": [1]}, "as many each"),
                                 ({"beam": "pipe"}, "beam = pipe is not in the data set")):
            self.assertIn(sentence, self.refusal("stick-frequencies", {**mine, **change}))
        self.assertIn("names, but need them", self.refusal("stick-frequencies", [[1, 2]]))
        self.assertIn("column frequency is missing", self.refusal("slip-frequencies", {"beam": "paper", "mode": [1]}))
        self.assertIn("says nothing of how to compare", self.refusal("beams", mine))

    def test_writes_junit_and_a_badge(self):
        part = self.folder / "part.csv"
        part.write_text("beam,mode,frequency\npaper,1,24.971958095\n")
        status = main(["judge", "slip-frequencies", str(part), "--quiet", "--junit", str(self.folder / "j.xml"), "--badge",
                       str(self.folder / "b.svg")])
        cases = ElementTree.parse(self.folder / "j.xml").getroot()
        self.assertEqual((status, cases.get("tests"), cases.get("failures"), cases.get("errors")), (1, "2", "1", "1"))
        self.assertIn("slip-frequencies: differs", ElementTree.parse(self.folder / "b.svg").getroot().get("aria-label"))

    def test_runs_the_program(self):
        os.environ["STICKSLIP_PROGRAM"] = str(PROGRAM)
        run = stickslip.respond("damped", duration=0.05, excitation__amplitude="1 mm")
        self.assertEqual(len(run["columns"]["time_s"]), run["rows"])
        self.assertEqual(stickslip.criterion("paper", excitation__amplitude="1 mm")["amplitude_m"], 1e-3)
        with self.assertRaisesRegex(stickslip.ProgramError, "did you mean damped"):
            stickslip.respond("dampd")

    def test_is_a_fixture_of_pytest(self):
        (self.folder / "test_mine.py").write_text(
            "import stickslip\ndef test_good(stickslip_agrees): stickslip_agrees('stick-history', stickslip.load('stick-history'))\n"
            "def test_bad(stickslip_agrees): stickslip_agrees('slip-frequencies', stickslip.load('stick-frequencies'))\n")
        done = subprocess.run([sys.executable, "-m", "pytest", "-p", "stickslip.pytest_plugin", "test_mine.py"], cwd=self.folder,
                              env={**os.environ, "PYTHONPATH": str(ROOT / "reports/python"), "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"},
                              capture_output=True, text=True)
        self.assertIn("1 failed, 1 passed", done.stdout)
        self.assertIn("differs, level", done.stdout)

    def test_is_installed_with_the_data(self):
        subprocess.run([sys.executable, "-c", "import setuptools; setuptools.setup()", "-q", "build", "--build-base", self.folder],
                       cwd=ROOT / "reports/python", check=True, capture_output=True)
        done = subprocess.run([sys.executable, "-I", "-c", f"import sys; sys.path.insert(0, '{self.folder}/lib'); import stickslip; "
                               "print(stickslip.load('stick-history').rows)"], capture_output=True, text=True)
        self.assertEqual(done.stdout, "1000\n", done.stderr)


class Data(unittest.TestCase):
    folder = ROOT / "data/reference"
    package = json.loads((folder / "datapackage.json").read_text())

    def test_is_as_its_schema_says(self):
        import jsonschema
        schema = json.loads((self.folder / "datapackage.schema.json").read_text())
        jsonschema.Draft7Validator(schema).validate(self.package)
        self.package["resources"][1]["comparison"]["values"][0]["norm"] = "relativ"
        self.assertFalse(jsonschema.Draft7Validator(schema).is_valid(self.package))

    def test_has_a_new_version_where_a_table_has_changed(self):
        tables = "".join(resource["name"] + resource["hash"] for resource in self.package["resources"])
        newest = (self.folder / "CHANGELOG.md").read_text().split("\n## ")[1]
        self.assertTrue(newest.startswith(self.package["version"] + ","), newest)
        self.assertIn(hashlib.sha256(tables.encode()).hexdigest(), newest)

    def test_states_a_problem_for_each_word_of_its_column(self):
        for resource in self.package["resources"][1:]:
            problem = resource["problem"]
            for member in problem.values():
                if isinstance(member, dict) and member.get("column") in ("problem", "system"):
                    words = {str(word) for word in stickslip.load(resource["name"])[member["column"]]}
                    self.assertEqual(words, problem.keys() - {member["column"]}, resource["name"])

    def test_is_enough_to_solve_a_problem_or_to_say_why_not(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        copy = pathlib.Path(folder.name) / "copy"
        shutil.copytree(self.folder, copy)

        def example(*names):
            return subprocess.run([sys.executable, "-I", "-S", copy / "example.py", *names], capture_output=True, text=True)
        solved = "stick-frequencies", "stick-history", "stick-velocities", "stick-fields", "damped-stick-history"
        done = example(*stickslip.names())
        self.assertEqual((done.returncode, done.stdout.count(": agrees"), done.stderr.count("that is not solved here\n")),
                         (2, 8, len(stickslip.names()) - len(solved)), done.stderr)
        beams = (copy / "beams.csv").read_text()
        (copy / "beams.csv").write_text(beams.replace(",1000,", ",1001,", 1))  # another density is another beam
        self.assertEqual(example("stick-frequencies").returncode, 1)


if __name__ == "__main__":
    unittest.main()
