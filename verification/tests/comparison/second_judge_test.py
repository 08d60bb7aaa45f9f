#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""second_judge_test.py PROGRAM: both judges, `stickslip compare` and the Python package, say the same of every file.

The files are spoilt copies of a data set of each kind, the cases of the grammar in reports/manual/reference-data.md, and random
files: STICKSLIP_FUZZ="COUNT SEED" in the environment asks for more of these. They are to have the same verdict, numbers, place,
counts and level. The program gets a copy of the data without `diagnosis`, which takes time and decides nothing.
"""
import array
import collections
import contextlib
import doctest
import gzip
import hashlib
import io
import json
import math
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import textwrap
import tracemalloc
import unittest
import unittest.mock
from xml.etree import ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "reports/python"))
import stickslip  # noqa: E402
from stickslip.__main__ import main  # noqa: E402

PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()
STATUS = {"agrees": 0, "differs": 1, "refused": 2, "undecided": 3}

# The grammar by cases: the exit status, the text, and the options beside --rows 1:1 of stick-frequencies; f stands for the frequency.
F = "24.97195809267067"
HEAD = "beam,mode,frequency\n"
READINGS = [
    (0, HEAD + "paper,1,f\n"), (0, "\ufeff" + HEAD + "paper,1,f"), (2, "\ufeff\ufeff" + HEAD + "paper,1,f"), (0, "\t " + HEAD + " \t \n paper \t, 1,\tf \n"),
    (2, HEAD + "paper,1,\u00a0f"), (2, HEAD + "paper,1,f\u00a0"), (2, HEAD + "paper,1\x0b,f"), (2, HEAD + "\x0c\npaper,1,f"), (2, HEAD + "\u00a0\npaper,1,f"),
    (2, "\u00a0" + HEAD + "paper,1,f"), (0, HEAD + "# a\n %b\n\npaper,1,f\r\r"), (0, HEAD.replace("\n", "\r\n") + "paper,1,f\r\n"), (2, HEAD + "paper,1,f\x85"),
    (0, "sep=;\nbeam;mode;frequency\npaper;1;24,97195809267067"), (0, '"sep=,"\n' + HEAD + "paper,1,f"), (2, " sep=,\n" + HEAD + "paper,1,f"),
    (0, "beam\tmode\tfrequency\n\"paper\" \t1\tf"), (0, " beam  mode frequency \n\tpaper 1\t\tf "), (2, "beam|mode|frequency\npaper|1|f"),
    (0, HEAD + '"paper" ,"1", "f"\n'), (0, HEAD + '\t"paper"\t,1,f'), (2, HEAD + '"paper,1,f'), (2, HEAD + '"pap"er,1,f'),
    (0, '"beam",mode,frequency,"a""b, c"\npaper,1,f,"""x"""'), (2, HEAD + 'pap"er,1,f'), (0, HEAD.strip() + ',n\npaper,1,f,a"b"'),
    (0, HEAD.strip() + ",n\npaper,1,f," + 200000 * "9"), (0, HEAD.strip() + f',n\npaper,1,f,"{140000 * "x"}"'), (0, HEAD + "paper,1.0,+2497.195809267067e-2"),
    (0, HEAD + "paper,+1e0,.2497195809267067D+02"), (0, HEAD + "paper,1.,f"), (2, HEAD + "paper,1,1e-400"), (1, HEAD + "paper,1,5e-324"), (1, HEAD + "paper,1,0e-400"),
    (2, HEAD + "paper,1,1e400"), (2, HEAD + "paper,1,nan"), (2, HEAD + "paper,1,inf"), (2, HEAD + "paper,1,0x1p3"), (2, HEAD + "paper,1,1_0"), (2, HEAD + "paper,1,--1"),
    (2, HEAD + "paper,1,+-1"), (2, HEAD + "paper,1,f+0j"), (2, HEAD + "paper,\u0661,f"), (2, HEAD + "paper,1,\u0662\u0664"), (2, HEAD + "paper,1,\uff12\uff14"),
    (2, HEAD + "paper,1,"), (2, HEAD + 'paper,1,"24,9"'), (2, HEAD + "paper,1.5,f"), (2, HEAD + "paper,1,1e,"), (2, "beam,mode,frequency [MHz]\npaper,1,1e308"),
    (0, "beam,mode,frequency [kHz]\npaper,1,0.02497195809267067"), (0, "beam,mode,FREQUENCY_kHz\npaper,1,0.02497195809267067"), (0, "beam,mode,frequency / 1/s\npaper,1,f"),
    (0, "beam,mode,frequency\n-,1,(Hz)\npaper,1,f"), (2, "beam,mode,frequency []\npaper,1,f"), (2, "beam,mode,frequency [THz]\npaper,1,f"),
    (0, "# beam mode frequency [Hz]\npaper 1 f"), (0, "# beam mode frequency\n# - - Hz\npaper 1 f"), (0, "#\n% beam;mode;frequency\npaper,1,f"),
    (2, "# beam mode\npaper 1 f"), (2, "paper,1,f"), (2, "1,2,3\n4,5,6"), (2, HEAD), (2, ""), (2, "# a"), (2, HEAD + "paper,1"), (2, HEAD + "paper,1,f,2"),
    (0, '"beam" "mode" "frequency"\n"1" "paper" 1 f'), (2, "beam,mode,frequency,frequency_Hz\npaper,1,f,f"), (2, HEAD + "p\x01,1,f"), (2, HEAD + 61 * "p" + ",1,f"),
    (2, "{}"), (2, "  ---\n" + HEAD), (2, HEAD + "\0"), (2, "\udcff\udcfe" + HEAD), (2, "beam,mode,frequency,\udce9\npaper,1,f,1"), (0, HEAD + "# \udce9\npaper,1,f"),
    (0, "beam,mode,frequency,\ufffd\npaper,1,f,1"), (2, "BEAM,\u017f,mode,\u017frequency\npaper,1,1,f"),
    *[(status, "paper,1,f,9", "--columns", names) for status, names in ( (0, "beam,mode,frequency,"), (0, "beam, mode ,frequency [Hz],-"), (2, "beam,mode,frequency"), (1, "beam,mode,,frequency"), (2, ""), (2, "1,2,3,4"))],
    (0, "paper,1,f", "--columns", "beam,mode,g", "--column", "frequency=g"), (2, "paper,1,f", "--columns", "beam,mode,g", "--columns", "beam,mode,frequency"),
    *[(status, "beam,mode,g [mHz],h:i\npaper,1,24971.95809267067,f", "--column", text) for status, text in ( (0, "frequency=g"), (0, " Frequency = G "), (0, "frequency=h:i:Hz"), (2, "frequency=h:i"), (2, "frequency=g:kN"), (2, "frequency=j"), (2, "=g"), (2, "frequency="), (2, "frequencies=g"), (2, "frequency=:Hz"))],
    (2, HEAD + "paper,1,f", "--column", "mode=mode", "--column", "mode=mode"),
    *[(status, HEAD + "paper,1,24.98", "--tolerance", text) for status, text in ( (0, "1e-3"), (0, "frequency=.01"), (1, "0"), (2, "+1"), (2, "1d0"), (2, "1e-400"), (2, "1_0"), (2, "=1"), (2, " 1"), (2, "nan"), (2, "inf"), (2, "-1"), (2, "mode=1"), (2, "\u0661"), (2, "frequency"), (2, ""))],
    *[(status, HEAD + "paper,1,f", "--until", text) for status, text in ((2, "1"), (2, "0"))],
]
MANIFESTS = [
    (0, "data_set,file,rows\nS,good.csv,1:50"), (0, "data_set;file\nS;good.csv"), (0, "# mine\nfile,data_set\n good.csv , S\n"), (0, "\ufeffdata_set,file\nS,a/good.csv"),
    (0, "data_set,file,tolerance\nS,good.csv,1"), (0, "data_set,file,tolerance,level\nS,good.csv, 1  frequency=0.1 ,"), (2, "data_set,file,tolerance\nS,good.csv,mode=1"),
    *[(2, f"data_set,file,tolerance\nS,good.csv,{text}") for text in ("x", "frequency=+1", "=1", "1_0", "frequency =1")],
    *[(status, f"data_set,file,rows,level,tolerance\nS,mesh.csv,1:10,{level}") for status, level in (
        (1, ","), (1, "strict,"), (1, "1e-3,"), (0, "1e-2,"), (0, "1e-1,"), (1, "1e-2,frequency=1e-3"), (1, "1e-2,1e-3"), (0, "strict,1e-2"), (2, "0.01,"), (2, "none,"))],
    (1, "data_set,file,rows,level\nS,mesh.csv,1:10,1e-2\nS,mesh.csv,1:10,\n"), (2, "data_set,file,levels\nS,good.csv,1e-2"), (2, "data_set,file,row\nS,good.csv,1:3"), (2, "data_set,file,file\nS,good.csv,good.csv"), (2, "data_set,file\n"),
    (2, "data_set\nS"), (2, "data_set,file\nS,"), (2, "data_set,file\nS,good.csv,1"), (2, "data_set,file\nS,-"), (2, "data_set,file\nS,/etc/passwd"),
    (2, "data_set,file\nS,a/../good.csv"), (2, "data_set,file,events\nS,good.csv,../e.csv"), (2, "data_set,file\nS,secret.csv"),
    *[(2, f"data_set,file,rows\nS,good.csv,{rows}") for rows in ("\u00b2", "0", "3:1", "1:99999999999", "1:", "1:2:3", "+1", "1e0", 30 * "9", "1:51")],
    (1, "data_set,file,rows\nS,good.csv,1:3\nslip-frequencies,good.csv,"), (2, "data_set,file\nslip-frequencies,good.csv\nS,none.csv"),
]


def text_of(rows, separator=","):
    return "\n".join(separator.join(row) for row in rows) + "\n"


def changed(table, column, change):
    """The rows of the data set, but with the numbers or words of a column changed; change() gets the cell and the number of the row."""
    columns = {**table.text, column: [change(cell, row) for row, cell in enumerate(table.text[column])]}
    return [list(columns), *map(list, zip(*columns.values()))]


def copies(table):
    """Name of the mistake, text of the file, options of both judges."""
    head, *rows = changed(table, next(iter(table.text)), lambda cell, row: cell)
    kind, values = table.comparison["kind"], table.comparison["values"]
    first = next(value["field"] for value in values if value["norm"] != "word" and value["field"] != "time")
    scaled = lambda factor: text_of(changed(table, first, lambda cell, row: cell and repr(factor * float(cell))))  # noqa: E731
    everything = text_of([head, *rows])
    yield "copy", everything, []
    yield "all values scaled by a fifth", scaled(1.2), []
    yield "sign", scaled(-1), []
    yield "a narrow tolerance", everything, ["--tolerance", "1e-9"]
    yield "a wide tolerance", scaled(1.02), ["--tolerance", "0.1"]
    yield "a fiftieth at level 1e-1", scaled(1.02), ["--level", "1e-1"]
    yield "a fiftieth at level 1e-2", scaled(1.02), ["--level", "1e-2"]
    yield "a fiftieth at level 1e-1, but for a tolerance", scaled(1.02), ["--level", "1e-1", "--tolerance", "1e-9"]
    yield "single precision", text_of([head, *([cell if table.types[name] != "number" or not cell else repr(array.array("f", [float(cell)])[0])
                                                for name, cell in zip(head, row)] for row in rows)]), []
    for word in (name for name in ("change", "phase", "verdict") if name in head):
        words = sorted(set(table.text[word]))
        swap = dict(zip(words, words[1:] + words[:1]))
        yield f"{word} interchanged", text_of(changed(table, word, lambda cell, row: swap[cell])), []
        yield f"one {word} changed, at level 1e-1", text_of(changed(table, word, lambda cell, row: swap[cell] if row == 2 else cell)), ["--level", "1e-1"]
        yield f"{word} foreign", text_of(changed(table, word, lambda cell, row: "foo")), []
    for level in ("1e-1", "1e-3") if kind in ("curve", "phases") else ():
        yield f"every sixth row, at level {level}", text_of([head, *rows[::6]]), ["--level", level]
    if kind == "table":
        yield "an unknown row", text_of([head, *rows, [cell if table.types[name] == "string" else "77" for name, cell in zip(head, rows[-1])]]), []
        yield "some rows, as meant", text_of([head, *rows[:3]]), ["--rows", "1:3"]
        yield "some rows, more meant", text_of([head, *rows[:3]]), ["--rows", "1,3:5"]
    if "time" in head and "x" not in head:
        yield "until", text_of([head, *rows[:table.rows // 2]]), ["--until", repr(0.45 * max(table.cells["time"]))]


def compared(*words):
    """The exit status of the program and what it says."""
    done = subprocess.run([PROGRAM, "compare", *words], capture_output=True, text=True, errors="replace")
    return done.returncode, done.stdout + done.stderr


def judged(*words):
    """Those of the Python judge."""
    with contextlib.redirect_stdout(io.StringIO()) as output, contextlib.redirect_stderr(output):
        try:
            return main(["judge", *words]), output.getvalue()
        except SystemExit as end:
            return end.code, output.getvalue()


def random_cell(draw, cell):
    """A cell, perhaps of another value, perhaps in another spelling."""
    try:
        value = float(cell) * draw.choice([1] * 9 + [1 + 1e-7, 1.002, 1.3, -1, 0, 1e-310, 1e308, 2**0.5])
    except (ValueError, OverflowError):
        return draw.choice([cell] * 30 + [cell.upper(), cell + "x", "", cell.replace("1", "\u0661")])
    text = draw.choice([cell, cell, repr(value), f"{value:.8g}", f"{value:.17e}"])
    return draw.choice([text] * 60 + ["+" + text, text.replace("e", "D"), text.replace(".", ","), "1e-400", "nan", "-inf", text + "0" * 400, "\u00a0" + text,
                                      text + " ", "\uff11" + text, text + "e", "0x1", "1_0", text.rstrip("0")])


def random_copy(draw, table):
    """Names and rows of a data set with results that are somewhat wrong: other values and words, times between or later, rows that are missing or too many."""
    head, *rows = changed(table, next(iter(table.text)), lambda cell, row: cell)
    free = [i for i, name in enumerate(head) if table.types[name] == "number" and name not in table.key and not name.endswith("_radius")]
    for i in draw.sample(free, draw.choice([0, 1, len(free)])):
        factor, share = 1 + draw.choice([-2, 1, 1, -1]) * 10 ** draw.uniform(-8, 0), draw.choice([1, 0.1, 2 / len(rows)])
        for row in rows:
            row[i] = repr(float(row[i]) * factor) if row[i] and draw.random() < share else row[i]
    for word in ({"change", "phase", "verdict"} & {*head} if draw.random() < 0.2 else ()):
        draw.choice(rows)[head.index(word)] = draw.choice(table.text[word])
    if "time" in head and draw.random() < 0.3:
        time, shift = head.index("time"), draw.choice([-1, 1]) * 10 ** draw.uniform(-7, -2)
        first = 0 if table.comparison["kind"] == "events" else draw.randrange(len(rows))
        for row in rows[first:]:
            row[time] = repr(float(row[time]) + abs(shift))
    elif table.comparison.get("abscissa") and draw.random() < 0.3:
        rows = [[repr((float(x) + float(y)) / 2) if name != "phase" else x for name, x, y in zip(head, one, other)] for one, other in zip(rows, rows[1:])]
    first, last = sorted(draw.sample(range(len(rows) + 1), 2)) if draw.random() < 0.2 else (0, len(rows))
    keep, every = draw.choice([1, 1, draw.random(), 1 - 2 / len(rows)]), draw.choice([1, 1, 1, 2, 3])
    rows = [row for row in rows[first:last:every] if draw.random() < keep]
    for _ in range(draw.choice([0, 0, 0, 0, 1, 2]) if rows else 0):
        at = draw.randrange(len(rows))
        rows.insert(at, list(rows[at]))
    return head, rows


def random_file(draw, table, events_file):
    """A wrong copy in some format, often with some mistakes in numbers, names, lines and bytes, and options."""
    head, rows = random_copy(draw, table)
    options, events = [], table.comparison.get("events")
    if events and draw.random() < 0.6:
        names, changes = random_copy(draw, stickslip.load(events))
        events_file.write_text(text_of([names, *changes]))
        options = ["--events", str(events_file)]
    if draw.random() < 0.6:
        return text_of([head, *rows], draw.choice(",,;\t")).encode(), options or draw.choice([[]] * 3 + [["--tolerance", repr(10 ** draw.uniform(-9, 0))], ["--level", draw.choice(["1e-1", "1e-2", "1e-3"])]])
    share = draw.choice([0, 0, 0, 2, 4, 30]) / table.rows / len(head)
    rows = [[random_cell(draw, cell) if draw.random() < share else cell for cell in row] for row in rows]
    head = [draw.choice([name] * 100 + [name.upper(), name.replace("_", draw.choice("- ")), f"{name} [{table.units[name]}]", f"{name}_mm", f"{name} / ms",
                                       f" {name} ", f'"{name}"', f"{name} (kHz)", name[:-1], f"{name} []"]) for name in head]
    columns = draw.sample(range(len(head)), len(head)) if draw.random() < 0.2 else range(len(head))
    separator, quote = draw.choice(",,,;\t "), draw.random() < 0.2
    lines = [separator.join(f'"{row[i]}"' if quote and draw.random() < 0.5 else row[i] for i in columns) for row in [head, *rows]]
    extra = ["# a comment", "%", "", " \t", "\u00a0", "# " + lines[0], lines[-1], '"', "sep=;", "-,1,kHz", "\x0c"]
    for _ in range(draw.choice([0] * 6 + [1, 2])):
        lines.insert(draw.choice([0, 1, draw.randrange(len(lines) + 1)]), draw.choice(extra))
    text = (draw.choice([""] * 9 + ["\ufeff", "\ufeff", "\ufeff\ufeff", "sep=;\n"]) + draw.choice(["\n", "\n", "\r\n", "\r"]).join(lines)).encode()
    for _ in range(draw.choice([0] * 8 + [1, 3])):
        at = draw.randrange(len(text) + 1)
        text = text[:at] + draw.choice([b",", b'"', b"\n", b" ", b"\t", b"\xff", b"\xc2\xa0", b"\0", b"e", b"9", b"-", b";", b"#", b""]) + text[at + draw.choice([0, 1, 2]):]
    packed = gzip.compress(text)
    text = draw.choice([text] * 60 + [packed, packed, packed[:-9], packed + b"\0", text[:len(text) // 2]])
    return text, options or draw.choice([[]] * 12 + [
        ["--rows", draw.choice(["1:3", f"1:{max(len(rows), 1)}", "2", "1,3:4", "\u00b2", "1:99999999999", "0"])],
        ["--tolerance", draw.choice(["1e-3", "1e-400", "1e-30", "0.5", "=1", "1_0", "nan"])],
        ["--level", draw.choice(["1e-1", "1e-2", "1e-3", "strict", "none", "0.01", "1e-4"])], ["--level", "1e-2"],
        ["--until", draw.choice(["0", "0.1", "10 ms", "nan", "1e9", "-1"])], ["--columns", ",".join(head)],
        ["--column", f"{draw.choice([*table.types])}={draw.choice(head)}{draw.choice(['', ':ms', ' : Hz'])}"]])


def essence(one):
    """What both judges must say of a file, of numbers six digits."""
    def digits(x):
        return None if x is None else float(f"{x:.6g}")
    if one["verdict"] == "refused":
        return "refused"
    quantities = {q.get("quantity", q.get("name")): (
        q["verdict"], q["level"], q["compared"], q["undecided"], digits(q["error"]), digits(q["uncertainty"]), q["where"],
        sorted(filter(None, q["skipped"].values() if isinstance(q["skipped"], dict) else (reason["points"] for reason in q["skipped"]))))
        for q in one["quantities"]}
    rows = (one["rows"]["compared"], one["rows"]["of"]) if isinstance(one["rows"], dict) else (one["rows"], one["all_rows"])
    return (one["verdict"].replace("partly", "undecided"), one["level"], one["required_level"], digits(one["coverage"]), rows, quantities,
            [(part.get("name", part.get("data_set")), part["level"]) for part in one["parts"]])


class BothJudges(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        shutil.copytree(ROOT / "data/reference", cls.folder / "package")
        cls.description = cls.folder / "package/datapackage.json"
        cls.package = json.loads(cls.description.read_text())
        cls.described = None

    def describe(self, name):
        """The program gets a package of what it needs for a data set, without that from which it would compute."""
        if name != self.described:
            needed, hidden = ("beams", name, stickslip.load(name).comparison.get("events")), ("diagnosis", "problem")
            resources = [{member: one[member] for member in one if member not in hidden}
                         for one in self.package["resources"] if one["name"] in needed]
            self.description.write_text(json.dumps({**self.package, "resources": resources}))
            type(self).described = name

    def run_both(self, name, *words):
        """The exit status of both judges, and the objects of both."""
        self.describe(name)
        output, all_said = self.folder / "verdict.json", []
        for judge in (compared, judged):
            output.unlink(missing_ok=True)
            status, said = judge(*words, f"--json={output}", "--quiet", *(["--package", str(self.folder / "package")] if judge is compared else []))
            self.assertNotIn("mistake in stickslip", said)
            all_said.append((status, json.loads(output.read_text()) if output.exists() else {"verdict": "refused"}))
        (status, _), (other, _) = all_said
        self.assertEqual(status, other, words)
        return status, *(one for _, one in all_said)

    def verdicts(self, name, files):
        """The verdict of each file (text, options), which both judges must say. Those without other options are in one manifest."""
        verdicts, together = {}, []
        for i, (text, options) in enumerate(files):
            (self.folder / f"{i}.csv").write_bytes(text if isinstance(text, bytes) else text.encode(errors="surrogateescape"))
            columns = dict(zip(options[::2], options[1::2]))
            if columns.keys() <= {"--events", "--rows"}:
                together.append((i, f'{name},{i}.csv,{pathlib.Path(columns.get("--events", "")).name},"{columns.get("--rows", "")}"\n'))
            else:
                status, program, python = self.run_both(name, name, str(self.folder / f"{i}.csv"), *options)
                with self.subTest(data_set=name, file=i, options=options, text=text[:300]):
                    self.assertEqual(essence(program), essence(python))
                verdicts[i] = python["verdict"].replace("partly", "undecided"), python
                self.assertEqual(status, STATUS[verdicts[i][0]])
        if together:
            (self.folder / "all.csv").write_text("data_set,file,events,rows\n" + "".join(line for _, line in together))
            _, *answers = self.run_both(name, "--manifest", str(self.folder / "all.csv"))
            for (i, _), program, python in zip(together, *answers):
                with self.subTest(data_set=name, file=i, text=files[i][0][:300]):
                    self.assertEqual(essence(program), essence(python))
                verdicts[i] = python["verdict"].replace("partly", "undecided"), python
        return [verdicts[i] for i in range(len(files))]

    def test_say_the_same_of_every_mistake(self):
        """Of each kind of comparison with each kind of norm in the least data set that has it."""
        counts, tried = collections.Counter(), set()
        for resource in sorted(self.package["resources"], key=lambda one: one["bytes"]):
            table = stickslip.load(resource["name"])
            kind = table.comparison and (table.comparison["kind"], *sorted({value["norm"] for value in table.comparison["values"]}))
            if not kind or kind in tried:
                continue
            tried.add(kind)
            names, *files = zip(*copies(table))
            for mistake, (verdict, said) in zip(names, self.verdicts(table.name, list(zip(*files)))):
                with self.subTest(data_set=table.name, mistake=mistake):
                    counts[verdict] += 1
                    if mistake == "copy":
                        self.assertEqual((verdict, said["level"]), ("agrees", "strict"))
                    if mistake in ("all values scaled by a fifth", "sign") or mistake.endswith("interchanged"):
                        self.assertEqual(verdict, "differs")
        self.assertGreater(min(counts[verdict] for verdict in STATUS), 9, counts)

    def test_read_by_one_grammar(self):
        files = [(status, re.sub(r"(?<=[,; \t\"])f(?=[\s,+\"\u00a0]|\Z)", F, text), ["--rows", "1:1", *options]) for status, text, *options in READINGS]
        for (status, text, options), (verdict, _) in zip(files, self.verdicts("stick-frequencies", [file[1:] for file in files])):
            self.assertEqual(STATUS[verdict], status, f"{text[:80]} {options}")
        times = ((0, "200 ms"), (0, ".2"), (0, "\t0.2s "), (0, "2e5us"), (2, "0"), (2, "nan"), (2, "inf"), (2, "-5"), (2, "+1"), (2, "1_0"), (2, "1e-400"),
                 (2, "0.2 m"), (2, "2d-1"), (2, "\u0661"), (2, ""))
        copy = next(copies(stickslip.load("damped-stick-history")))[1]
        for (status, text), (verdict, _) in zip(times, self.verdicts("damped-stick-history", [(copy, ["--until", text]) for _, text in times])):
            self.assertEqual(STATUS[verdict], status, text)

    def test_read_random_files_alike(self):
        count, seed = map(int, os.environ.get("STICKSLIP_FUZZ", "160 59").split())
        kinds, counts = collections.defaultdict(list), collections.Counter()
        for one in self.package["resources"]:
            if one["bytes"] < 14000 and stickslip.load(one["name"]).comparison:
                kinds[stickslip.load(one["name"]).comparison["kind"]].append(one["name"])
        for names in kinds.values():
            for name in names:
                files = [random_file(random.Random(f"{seed} {name} {j}"), stickslip.load(name), self.folder / f"events{j}.csv")
                         for j in range(count // len(kinds) // len(names) + 1)]
                counts.update(verdict for verdict, _ in self.verdicts(name, files))
        print(f"random files, seed {seed}: {dict(counts)}", file=sys.stderr)

    @staticmethod
    def write_mesh(path):
        """Ten frequencies with the error of 20 Hermite elements, (k h)^4/1440 with k h = mode pi/20."""
        table = stickslip.load("stick-frequencies")
        rows = [(table["beam"][i], str(table["mode"][i]), repr(float(table["frequency"][i] * (1 + (table["mode"][i] * math.pi / 20)**4 / 1440))))
                for i in range(10)]
        path.write_text(text_of([("beam", "mode", "frequency"), *rows]))

    def test_judge_by_a_level(self):
        mesh = self.folder / "mesh.csv"
        self.write_mesh(mesh)
        self.describe("stick-frequencies")
        for level, status in ("1e-1", 0), ("1e-2", 0), ("1e-3", 1), ("strict", 1), ("none", 2), ("0.01", 2), ("", 2):
            both = [judge("stick-frequencies", str(mesh), "--rows=1:10", f"--level={level}", *package)
                    for judge, package in ((compared, ["--package", str(self.folder / "package")]), (judged, []))]
            self.assertEqual([one for one, _ in both], [status, status], f"{level}: {both}")
            for _, said in both if level in ("1e-2", "1e-3") else ():
                self.assertRegex(said, f"(agrees in 10 of 50 rows|differs) at level {level}")
        for half_width, verdict in (0.005, "agrees"), (0.02, "undecided"):
            one = stickslip.Quantity("f", "", "scale", 1e-6, 1e-6, "1e-2")
            one.add((0, (1.0, 0.0), (1.0, half_width)), (1.0, 1.0), "here")
            self.assertEqual((one.verdict, one.undecided), (verdict, int(verdict == "undecided")))
        agrees = stickslip.judge("stick-frequencies", mesh, rows="1:10", level=0.01)
        self.assertEqual((bool(agrees), agrees.level, agrees.required_level), (True, "1e-2", "1e-2"))
        self.assertIn("at level 1e-2 (1e-2)", judged("stick-frequencies", str(mesh), "--rows=1:10", "--level=1e-2", "--badge=-")[1])

    def test_say_the_same_of_a_manifest(self):
        (self.folder / "m/a").mkdir(parents=True)
        manifest = self.folder / "m/results.csv"
        for place in ("good.csv", "a/good.csv"):
            shutil.copy(ROOT / "data/reference/frequencies/stick.csv", manifest.parent / place)
        self.write_mesh(manifest.parent / "mesh.csv")
        (manifest.parent / "secret.csv").write_text("hunter2:x\n")
        for status, text in MANIFESTS:
            manifest.write_text(re.sub(r"\bS\b", "stick-frequencies", text))
            said = [judge("--manifest", str(manifest)) for judge in (compared, judged)]
            self.assertEqual([one for one, _ in said], [status, status], f"{text} {said}")
            self.assertNotIn("hunter2", str(said))
        manifest.write_text("data_set,file,rows,level\nstick-frequencies,mesh.csv,1:10,\nstick-frequencies,good.csv,,strict\n")
        for status, *options in (1,), (0, "--level=1e-2"), (1, "--level=1e-3"), (1, "--level=1e-2", "--tolerance=1e-3"):
            self.assertEqual([judge("--manifest", str(manifest), *options)[0] for judge in (compared, judged)], [status, status], options)
        self.assertIn("2 of 2 agree at level 1e-2", judged("--manifest", str(manifest), "--level=1e-2", "--badge=-")[1])
        for option in ("--rows=1:3", "--until=1", "--column=frequency=f", "--columns=a", "--events=e.csv"):
            self.assertEqual((compared("--manifest", str(manifest), option)[0], judged("--manifest", str(manifest), option)[0]), (2, 2))


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
        wide = stickslip.judge("stick-frequencies", {"beam": "paper", "mode": [1], "frequency": [25]}, rows="1:1", tolerance="1e-9 frequency=2e-3")
        self.assertEqual((wide.verdict, wide.quantities[0].tolerance), ("agrees", 2e-3))

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

    def test_writes_nothing_harmful(self):
        part, bad = self.folder / "part.csv", self.folder / "bad"
        part.write_text("beam,mode,participation\npaper,1,1.7e308\n")
        script = '"><script>&\x1b\ufffe'
        self.assertEqual(judged(script, str(part), f"--junit={bad}.xml", f"--badge={bad}.svg")[0], 2)
        for name in ("bad.xml", "bad.svg"):
            self.assertIn("script", ElementTree.tostring(ElementTree.parse(self.folder / name).getroot(), encoding="unicode"))
        self.assertEqual(judged("participation", str(part), f"--json={bad}.json")[0], 1)
        constants = []
        json.loads((self.folder / "bad.json").read_text(), parse_constant=constants.append)
        self.assertEqual(constants, [])
        kept = self.folder / "kept"
        kept.write_text("old")
        kept.chmod(0o600)
        link = self.folder / "link"
        link.symlink_to("kept")
        with unittest.mock.patch("os.replace", side_effect=OSError(28, "No space")):
            self.assertEqual(judged("participation", str(part), f"--json={kept}")[0], 2)
        self.assertEqual((kept.read_text(), sorted(os.listdir(self.folder))),
                         ("old", ["bad.json", "bad.svg", "bad.xml", "kept", "link", "part.csv"]))
        judged("participation", str(part), f"--json={link}")
        self.assertEqual((kept.read_text()[0], link.is_symlink(), kept.stat().st_mode & 0o777), ("{", True, 0o600))
        for options in ([f"--json={part}"], [f"--json={bad}", f"--junit={bad}"], ["--rows=1", "--rows=2"], ["--row=1"]):
            self.assertEqual(judged("participation", str(part), *options)[0], 2, options)
        self.assertEqual(json.loads(judged("participation", str(part), "--json", "-")[1])["verdict"], "differs")
        with unittest.mock.patch("stickslip.__main__.judge", side_effect=KeyError("x")):
            self.assertRegex(str(judged("participation", str(part))), "1, .*mistake in stickslip itself")

    def test_takes_no_more_memory_than_is_allowed(self):
        (self.folder / "bomb.gz").write_bytes(gzip.compress(bytes(10**6)) * 300)
        tracemalloc.start()
        self.assertIn("larger than the 50000000 bytes", self.refusal("stick-frequencies", self.folder / "bomb.gz"))
        mine = {"beam": "paper", "mode": [1], "frequency": [1]}
        self.assertIn("the rows are", self.refusal("stick-frequencies", mine, rows="1:99999999999"))
        self.assertLess(tracemalloc.get_traced_memory()[1], 2.2e8)
        tracemalloc.stop()

    def test_refuses_arguments_of_another_type(self):
        mine = {"beam": "paper", "mode": [1], "frequency": [24.971958095]}
        for options in ({"rows": [1.5]}, {"rows": ["1"]}, {"rows": 1}, {"rows": "1:"}, {"tolerance": True}, {"tolerance": "frequency=x"}, {"tolerance": "mode=1e-3"}, {"tolerance": 10**400}, {"level": "0.01"}, {"level": 0.02}, {"level": [1]},
                        {"tolerance": math.nan}, {"until": "1"}, {"until": 0}, {"columns": 5}, {"columns": {"frequency": 1}}, {"columns": {"f": "g"}}):
            self.refusal("stick-frequencies", mine, **options)
        for change in (24.97 + 1j, [24.97 + 0j], [True], {24.97}, (x for x in [24.97]), [None], [10**400], [float("inf")], []):
            self.refusal("stick-frequencies", {**mine, "frequency": change}, rows=[1])
        for data in (5, None, "a\0b", [1], object()):
            self.refusal("stick-frequencies", data, columns=["beam", "mode", "frequency"])
        self.refusal(["stick-frequencies"], mine)
        history = stickslip.load("stick-history")
        self.assertIn("none of the", self.refusal("stick-history", history, until=0))
        try:
            import numpy
        except ImportError:
            return
        self.refusal("stick-frequencies", {**mine, "frequency": numpy.array([24.97 + 1j])})
        self.assertTrue(stickslip.judge("stick-frequencies", {**mine, "frequency": numpy.array(24.971958095)}, rows="1"))

    def test_is_the_program(self):
        os.environ["STICKSLIP_PROGRAM"] = str(PROGRAM)
        axes = {"x": "frequency=20:30:2", "y": "amplitude=1e-4:1e-3:2"}
        calls = {"cases": ([], {}), "criterion": (["paper"], {"excitation__amplitude": "1 mm"}), "design": (["paper"], {"band": "25:26"}),
                 "map": (["damped"], {**axes, "quantity": "travel,period"}), "modes": (["paper"], {"count": 2}),
                 "nvh": (["squeak-stand"], {"duration": 1}),
                 "periodic": (["damped"], {"settle": 1}), "respond": (["damped"], {"duration": 0.02, "method": "event-driven"}),
                 "squeal": (["reed"], {"settle": 5}), "sweep": (["damped"], {"parameter": "amplitude=1e-3:2e-3:2", "settle": 1}),
                 "uncertainty": (["uncertain"], {"samples": 100})}
        self.assertEqual(sorted(calls), sorted(stickslip._program.COMMANDS))
        table = self.folder / "table.csv"
        for command, (arguments, options) in calls.items():
            with self.subTest(command=command):
                words = [word for name, value in options.items()
                         for word in (["--set", f"{name.replace('__', '.')}={value}"] if "__" in name else [f"--{name}", str(value)])]
                has_table = command in ("respond", "map", "sweep")
                done = subprocess.run([PROGRAM, command, *arguments, *words, "--json", *(["--output", table] if has_table else [])],
                                      capture_output=True, text=True, check=True)
                mine = getattr(stickslip, command)(*arguments, **options)
                columns = mine.pop("columns", None)
                paths = {"command": "", "output": ""}
                self.assertEqual({**mine, **paths}, {**json.loads(done.stdout), **paths})
                if has_table:
                    head, *rows = [line.split(",") for line in table.read_text().splitlines() if line and not line.startswith("#")]
                    self.assertEqual([*columns], head)
                    for i, (name, cells) in enumerate(columns.items()):
                        self.assertEqual([str(cell) if isinstance(cell, str) else f"{cell:.12g}" for cell in cells],
                                         [row[i] if isinstance(cells[0], str) else f"{float(row[i] or 'nan'):.12g}" for row in rows], name)
        with self.assertRaisesRegex(stickslip.ProgramError, "did you mean damped"):
            stickslip.respond("dampd")

    def test_is_an_action_that_takes_no_code_of_the_workspace(self):
        text = (ROOT / ".github/actions/judge/action.yml").read_text()
        script = textwrap.dedent(text.split("run: |\n")[1])
        for name in ("csv.py", "json.py", "stickslip.py", "sitecustomize.py"):
            (self.folder / name).write_text("print('of the workspace'); raise SystemExit(0)\n")
        (self.folder / "-m.csv").write_text(HEAD + f"paper,1,{F}\npaper,2,81.1\n")
        given = {"PACKAGE": str(ROOT / "reports/python"), "DATA_SET": "stick-frequencies", "FILE": "-m.csv", "MANIFEST": "", "JUNIT": "j.xml", "BADGE": "",
                 "PYTHONPATH": str(self.folder)}
        for options, status in (("", 1), ("--rows 1:2\n--tolerance 1\n--json out.json\n", 0), ("--row 1", 2)):
            done = subprocess.run(["bash", "--noprofile", "--norc", "-eo", "pipefail", "-c", script], cwd=self.folder, capture_output=True, text=True,
                                  env={**os.environ, **given, "OPTIONS": options})
            self.assertEqual((done.returncode, "workspace" in done.stdout), (status, False), done.stdout + done.stderr)
        (self.folder / "m.csv").write_text("data_set,file\nstick-frequencies,-m.csv\n")
        given.update(DATA_SET="", FILE="", MANIFEST="m.csv", OPTIONS="--tolerance 1")
        self.assertEqual(subprocess.run(["bash", "-ec", script], cwd=self.folder, capture_output=True, env={**os.environ, **given}).returncode, 3)
        self.assertTrue((self.folder / "out.json").exists() and (self.folder / "j.xml").exists())
        self.assertEqual(set(re.findall(r"\$\{\{ inputs.([a-z-]+)", text)), set(re.findall(r"^  ([a-z-]+):$", text.split("runs:")[0], re.MULTILINE)))

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
        """A copy of the folder alone, by Debian's pip and in a bare environment, both without network and as the program tells its version."""
        shutil.copytree(ROOT / "reports/python", self.folder / "copy")  # what links lead to
        (self.folder / "copy/stickslip/left-over.txt").write_text("no part of the package")
        pip = "-m", "pip", "--isolated", "--disable-pip-version-check", "install", "--quiet", "--no-index"
        environment = {**os.environ, "PYTHONPATH": "", "HOME": str(self.folder)}
        subprocess.run([sys.executable, "-m", "venv", self.folder / "bare"], check=True, env=environment)
        bare = self.folder / "bare/bin/python"
        for python, *options in ((sys.executable, "--no-build-isolation", "--break-system-packages", f"--target={self.folder}/target"), (bare,)):
            subprocess.run([python, *pip, *options, self.folder / "copy"], check=True, capture_output=True, env=environment)
        subprocess.run([bare, *pip, "--force-reinstall", self.built_sdist()], check=True, capture_output=True, env=environment)
        version = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True, check=True).stdout.split()[1]
        script = ("import importlib.metadata as m, stickslip; print(stickslip.load('stick-history').rows, stickslip.__version__, m.version('stickslip'), "
                  "[p.value for p in m.distribution('stickslip').entry_points])")
        for python, path in ((sys.executable, self.folder / "target"), (bare, self.folder)):
            done = subprocess.run([python, "-I", "-c", f"import sys; sys.path.insert(0, '{path}'); {script}"], capture_output=True, text=True)
            self.assertEqual(done.stdout, f"1000 {version} {version} ['stickslip.pytest_plugin']\n", done.stderr)
        self.assertFalse((self.folder / "target/stickslip/left-over.txt").exists())

    def built_sdist(self):
        script = "import build_backend, sys; print(build_backend.build_sdist(sys.argv[1]))"
        done = subprocess.run([sys.executable, "-c", script, self.folder], cwd=self.folder / "copy", capture_output=True, text=True, check=True)
        return self.folder / done.stdout.strip()

    def test_has_examples_that_run(self):
        os.environ["STICKSLIP_PROGRAM"] = str(PROGRAM)
        for name in stickslip.__all__:
            if not isinstance(getattr(stickslip, name), type):
                with self.subTest(name=name):
                    (test,) = doctest.DocTestFinder(exclude_empty=False).find(getattr(stickslip, name), name, globs={"stickslip": stickslip})
                    said = io.StringIO()
                    tried = doctest.DocTestRunner().run(test, out=said.write)
                    self.assertTrue(tried.attempted and not tried.failed, said.getvalue())
        self.assertTrue(stickslip.respond.__doc__.startswith("A motion in time") and stickslip.respond.__name__ == "respond")
        said = {one.name: subprocess.run([sys.executable, one], capture_output=True, text=True, check=True, env={
            **os.environ, "PYTHONPATH": str(ROOT / "reports/python")}).stdout for one in (ROOT / "reports/python/examples").glob("*.py")}
        self.assertIn("agrees in 10 of 50 rows at level 1e-2, reached 1e-2", said["judge_my_code.py"])
        self.assertRegex(said["vary_a_case.py"], r"0.2 m: stick, margin \d+.\d\n0.3 m: stick, .*\n0.4 m: stick")
        self.assertRegex(said["motion_in_time.py"], "2001 rows, [0-9]+ % of them in stick\nlargest displacement .* mm, [0-9]+ changes")

    def test_takes_cases_as_dicts(self):
        os.environ["STICKSLIP_PROGRAM"] = str(PROGRAM)
        mass = {"model": {"mass": "2 kg", "stiffness": array.array("d", [8.0])[0], "normal_force": 10}, "friction": {"static_coefficient": 0.3, "kinetic_coefficient": 0.2,
                "decay": math.inf}, "excitation": {"frequency_hz": 1, "amplitude": "1 mm", "duration": 1}, "wall": {"with_base": False}}
        one, two = stickslip.criterion([mass, {**mass, "friction": {"static_coefficient": 0.6}}])
        self.assertEqual((one["problem"]["model"]["mass"], 2 * one["friction_limit_N"], two["friction_limit_N"]), (2, 6, 6))
        self.assertIsNone(one["problem"]["friction"]["decay"])
        with contextlib.chdir(self.folder):
            pathlib.Path("a").mkdir()
            pathlib.Path("a/r.csv").write_text("t,w\n" + "".join(f"{i / 100},{math.sin(i / 5)}\n" for i in range(100)))
            moved = {**mass, "excitation": {"file": "a/r.csv", "column": "w", "quantity": "displacement", "unit": "mm"}}
            self.assertEqual(stickslip.criterion(moved, excitation__scale=2)["problem"]["excitation"]["scale"], 2)
        for case, sentence in (({**mass, "wal": {}}, "^stickslip: case.toml:.*unknown table"), ({"model": {"mass": {1}}}, "cannot be written")):
            with self.assertRaisesRegex(stickslip.ProgramError, sentence):
                stickslip.criterion(case)


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
