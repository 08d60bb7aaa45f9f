#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""second_judge_test.py PROGRAM: both judges, `stickslip compare` and the Python package, say the same of every file.

The files are each data set itself and spoilt copies of it. The program gets a copy of the data without `diagnosis`, which takes
time and decides nothing.
"""
import array
import collections
import csv
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "reports/python"))
import stickslip  # noqa: E402
from stickslip.__main__ import main  # noqa: E402

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
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
    first = next(value["field"] for value in values if value["norm"] != "word")
    peak = max(range(table.rows), key=lambda row: abs(table.cells[first][row]))
    number = lambda change: lambda cell, row: repr(change(float(cell), row)) if cell else cell  # noqa: E731
    yield "copy", text_of([head, *rows]), []
    yield "one value scaled", text_of(changed(table, first, number(lambda x, row: x * (1.3 if row == peak else 1)))), []
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
        description = cls.folder / "package/datapackage.json"
        package = json.loads(description.read_text())
        for resource in package["resources"]:
            resource.pop("diagnosis", None)
        description.write_text(json.dumps(package))

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
        counts = collections.Counter()
        for name in stickslip.names():
            table = stickslip.load(name)
            if not table.comparison:
                continue
            for mistake, text, options in copies(table):
                with self.subTest(data_set=name, mistake=mistake):
                    program, python = self.verdicts(name, text, options)
                    counts[python[1]] += 1
                    self.assertEqual(program[:4], python[:4], program[4])
                    self.assertEqual(python[0], STATUS[python[1]])
                    if mistake == "copy":
                        self.assertEqual(python[1:3], ("agrees", "strict"))
                    if mistake in ("one value scaled", "sign") or mistake.endswith("interchanged"):
                        self.assertEqual(python[1], "differs")
        self.assertGreater(min(counts[verdict] for verdict in STATUS), 30, counts)
        print(dict(counts), file=sys.stderr)


if __name__ == "__main__":
    unittest.main()
