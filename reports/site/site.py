#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Makes the evidence site: the ledgers behind the report as static HTML pages that need no network.

  site.py TEMPLATES DATA VALUES FIGURES OUTPUT
  site.py record VALUES                          adds the run behind VALUES to verification/history.csv

TEMPLATES is the folder of the report's templates, DATA that of the data, VALUES what the studies returned and
FIGURES the folder with their CSV and PNG files, which lies beside OUTPUT. Each page but the first is a table. The sources of the tests
are pages as well, so that each test links to its line.
"""

import csv
import decimal
import functools
import json
import math
import re
import shutil
import subprocess
import sys
from collections import namedtuple
from pathlib import Path

import jinja2
import markupsafe

FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER.parent / "report"))
from render import environment_for, plain, read_values, sig  # noqa: E402

Link = namedtuple("Link", "text href")
Number = namedtuple("Number", "text value")
Code = namedtuple("Code", "text")
Image = namedtuple("Image", "href alt")
Verdict = namedtuple("Verdict", "text good")  # shown with a sign and a colour
Mark = namedtuple("Mark", "text kind href title")  # a sign with a number in a cell of a matrix, which leads to its row
Row = namedtuple("Row", "id cells")
Chart = namedtuple("Chart", "title points last")  # points of a line in a box of 200 by 60, and its last value
Table = namedtuple("Table", "title columns rows kind", defaults=[""])
Page = namedtuple("Page", "name title intro columns rows charts tables group", defaults=[(), (), ""])


def number(value, digits=6):
    """
    >>> number(0.000123456789, 3), number(None)
    (Number(text='0.000123', value=0.000123456789), '')
    """
    return "" if value is None else Number(f"{value:.{digits}g}", float(value))


def rounded_up(value, digits=2):
    """As the report gives what others stay within.

    >>> rounded_up(0.0451), rounded_up(-1.5e-8, 1), rounded_up(None)
    (Number(text='0.046', value=0.0451), Number(text='-2e-08', value=-1.5e-08), '')
    """
    return "" if value is None else number(float(decimal.Context(digits, decimal.ROUND_UP).create_decimal(repr(float(value)))), digits)._replace(value=float(value))


def mark(run, href):
    """A run of another code as a cell of the matrix: by its level agreement, agreement to one of 1e-1 to 1e-3, none, or not run."""
    sign, kind = {"strict": ("✓", "use"), "none": ("✗", "avoid"), "": ("–", "none")}.get(run["level"], ("✗", "margin"))
    ratio = float(run["ratio"] or math.nan)
    text = "<0.1" if ratio < 0.1 else f"{ratio:.2g}" if ratio < 10 else f"{ratio:.0f}" if ratio < 1000 else f"{ratio:.0e}".replace("e+0", "e")
    return Mark(f"{sign} {text}" if run["ratio"] else sign, kind, href, f"{run['code']}, {run['problem']}, {run['settings']}: {run['note'] or run['verdict']}")


def words(text):
    return str(text).rstrip(".")


def decided(good):
    return "not judged: no tests have run" if good is None else Verdict("yes" if good else "no", good)


def unlatexed(text):
    r"""The words of a LaTeX text.

    >>> unlatexed(r"At $A_0 = 0.5\unit{mm}$ the \emph{tip} slips~($\fmax > \mu_s P$), 12\,\%")
    'At A_0 = 0.5 mm the tip slips (|f_max| > mu_s P), 12 %'
    """
    for command, word in (("\\fmax", "|f_max|"), ("\\rhoinf", "rho_inf"), ("\\pm", " ± "), ("\\ldots{}", "…"), ("\\infty", "inf")):
        text = text.replace(command, word)
    text = re.sub(r"\\unit{(.*?)}", r" \1", text)
    text = re.sub(r"\\(?:emph|code|textbf|text|mathrm|operatorname|ensuremath|href{.*?}){", "{", text)
    text = re.sub(r"\\(?:times|cdot)", " x ", text).replace("\\,", " ").replace("\\%", "%").replace("~", " ")
    return " ".join(re.sub(r"\\([A-Za-z]+)|[{}$]", r"\1", text).split())


@functools.cache
def lines_of(file):
    return file.read_text().splitlines()


def site_of(**known):
    """A site of these values alone, for the examples."""
    return Site({"tests": []} | {key: value if key != "tests" else [{"claim": ""} | test for test in value]
                                 for key, value in known.items()}, "", None)


def numbered(text):
    r"""The text of the report with the numbers of sections, figures and tables in place of references.

    >>> numbered(r"\section{A}\label{sec:a} \ref{tab:c}, \ref{sec:b} \subsection{B}\label{sec:b} \begin{longtable}\label{tab:c}\end{longtable}")
    '\\section{A}\\label{sec:a} 1, 1.1 \\subsection{B}\\label{sec:b} \\begin{longtable}\\label{tab:c}\\end{longtable}'
    """
    counts, numbers = dict.fromkeys(("section", "subsection", "figure", "table"), 0), {}
    for kind, label in re.findall(r"\\(?:begin{(?:long)?)?(section|subsection|figure|table)\b(?!\*)|\\label{(.*?)}", text):
        if kind:
            counts |= {kind: counts[kind] + 1} | ({"subsection": 0} if kind == "section" else {})
        section, subsection, figure, table = counts.values()
        numbers[label] = {"fig": figure, "tab": table}.get(label[:3], f"{section}.{subsection}" if subsection else section)
    return re.sub(r"\\ref{(.*?)}", lambda reference: str(numbers[reference[1]]), text)


def text_of(templates, known):
    """The sections of the report in LaTeX, and what stands before them."""
    environment = environment_for(templates)
    environment.globals |= known
    frame = environment.get_template("vv-report.tex").render()
    return numbered("".join(environment.get_template(f"{part}.tex").render() for part in re.findall(r"\\input{(.*?)}", frame))), frame


def tables_of(text, frame):
    """The tables of the report in HTML, each below a heading with its number, by pandoc. Its drawings in cells are left out."""
    tables = re.findall(r"\\begin{table}.*?\\end{table}|\\begin{longtable}.*?\\end{longtable}", text, re.DOTALL)
    latex = "\n".join(re.findall(r"^\\newcommand{.*}$", frame, re.MULTILINE))  # the macros of one line
    for number, table in enumerate(tables, 1):
        table = re.sub(r"\\label{.*?}|@{}|\\cmidrule.*?}|\\begin{picture}.*?\\end{picture}%\s*|\\endfirsthead.*?\\endhead", "", table, flags=re.DOTALL)
        table = re.sub(r"L(?={[\d.]+[cm]m})", "p", table).replace(r"p{.8\linewidth}", "l")
        latex += f"\n\\section{{Table {number}}}\\label{{table-{number}}}\n{table}\n"
    html = subprocess.run(["pandoc", "--from=latex", "--to=html5", "--shift-heading-level-by=1"], input=latex,
                          capture_output=True, text=True, check=True).stdout
    if html.count("<caption>") != len(tables):
        raise RuntimeError(f"pandoc made {html.count('<caption>')} tables of {len(tables)}")
    return re.sub("<th[^>]*></th>", "<td></td>", html.replace('href="site/', 'href="'))


def drawings_of(text):
    """Number, name, section, alternative text and caption of each drawing, in the order of the report."""
    drawings = []
    number, section = 0, ""
    for label, figure in re.findall(r"\\label{(sec:.*?)}|\\begin{figure}(.*?)\\end{figure}", text, re.DOTALL):
        section = label or section
        number += not label
        caption = unlatexed(re.sub(r"\\label{.*?}|\\end.*", "", figure.partition("\\caption{")[2]))
        drawings += [(number, name, section, " ".join(alt.split()), caption)
                     for name, alt in re.findall(r"\\drawing(?:\[.*?\])?{([a-z0-9-]+)}\s*{([^}]*)}", figure)]
    return drawings


def boxes_of(text):
    r"""The boxes of the report's first page: kind, head, and words with links to the tables that they name.

    >>> boxes_of(r"\cellcolor{use}\textbf{$\surd$ Use}\newline (a) & b, 5\,\%, Table~3. \\\\[1ex] \cellcolor{use}yes & \\\\")
    [('use', 'Use (a)', Markup('b, 5 %, <a href="tables.html#table-3">Table 3</a>.'))]
    """
    boxes = re.findall(r"\\cellcolor{(\w+)}\\textbf{\$\\\w+\$ (.*?)&(.*?)\\\\", text, re.DOTALL)
    linked = lambda words: markupsafe.Markup(re.sub(r"(Table (\d+))", r'<a href="tables.html#table-\2">\1</a>', str(markupsafe.escape(words))))
    return [(kind, unlatexed(head.replace("\\newline", "")), linked(unlatexed(words))) for kind, head, words in boxes]


def limits_of(figures, drawings):
    """The figure of the front page, a box of 426 by 252 at (46, 10), from the table of the report's figure: amplitudes in mm, log axis."""
    read = lambda name: [line.split(",") for line in (figures / name).read_text().splitlines() if not line.startswith("#")][1:]
    rows = [[float(hz), *(float(f"{1e3 * float(one):.4g}") for one in amplitudes)] for hz, *amplitudes in read("limits.csv")]
    first, last = rows[0][0], rows[-1][0]
    across = lambda hz: round(46 + 426 * (min(hz, last) - first) / (last - first), 1)
    down = lambda mm: round(110.8 - 50.4 * math.log10(max(mm, 1e-3)), 1)
    curves = [(f"curve-{n}", text, " ".join(f"{across(row[0])},{down(row[n])}" for row in rows))
              for n, text in enumerate(("start-up: the criterion", "steady", "start-up, damped", "steady, damped"), 1)]
    alt, caption = next(drawing[3:] for drawing in drawings if drawing[1] == "limits")
    values = {name: float(value) for name, value, _ in read("limits-values.csv")}
    natural = [hz for name, hz in values.items() if name.startswith("natural")]
    bands = [[across(hz * (1 + sign * values["distance"])) for sign in (-1, 1)] for hz in natural]
    return {"curves": curves, "rows": rows, "alt": alt, "caption": caption, "bands": bands, "natural": [across(hz) for hz in natural if hz < last],
            "ticks": [(40, down(10.0 ** n), f"{10.0 ** n:g}") for n in range(-3, 3)] + [(across(hz), 262, hz) for hz in range(20, int(last) + 1, 20)],
            "table": Table("Critical amplitude in mm", ["Hz", *(text for _, text, _ in curves)],
                           [[f"{one:.3g}" for one in row] for row in rows if row[0] % 10 == 0 or row is rows[-1]])}


def breakable(text):
    """A name that may be broken at its dots and capitals, and nowhere else.

    >>> breakable("a.BigName/b & 1.5")
    Markup('a.<wbr>Big<wbr>Name/<wbr>b &amp; 1.5')
    """
    return markupsafe.Markup(re.sub(r"(?<=[/_:-])(?=\w)|(?<=\.)(?=[A-Za-z])|(?<=[a-z])(?=[A-Z])", "<wbr>", str(markupsafe.escape(text))))


class Site:
    """The pages, each made from the values of the report."""

    def __init__(self, known, text, figures):
        self.known, self.figures = known, figures
        self.drawings = drawings_of(text)
        self.sources = {}  # pages of test sources by file
        self.tests_of_claim = {test["claim"]: test for test in known["tests"] if test["claim"]}

    def test_link(self, test):
        return Link(test["id"], f"tests.html#{test['id']}")

    def source_link(self, test):
        file = Path(test["file"])
        if not file.is_file() or int(test["line"]) > len(lines_of(file)):  # a result of older sources
            return file.name
        name = str(file).split("/verification/")[-1]
        self.sources[file] = f"source/{name}.html"
        return Link(f"{name}:{test['line']}", f"{self.sources[file]}#L{test['line']}")

    def tests(self):
        """
        >>> one = {"id": "a", "requirement": "V1", "comparisons": 2, "file": "nowhere.cpp", "passed": False, "skipped": False,
        ...        "worst": dict(computed=1.0, expected=2.0, error=3.0, tolerance=4.0, margin=0.75) | {"class": "reference"}}
        >>> none = {"worst": None, "comparisons": 0}
        >>> page = site_of(tests=[one, one | none | {"passed": True}, one | none | {"skipped": True}]).tests()
        >>> for row in page.rows:
        ...     print([getattr(cell, "text", cell) for cell in row.cells[1:2] + row.cells[4:11] if cell != ""])
        ['failed', '2', '1', '2', '3', '4', '0.75', 'reference']
        ['passed']
        ['skipped']
        """
        rows = []
        for test in self.known["tests"]:
            worst = test["worst"] or dict.fromkeys(("computed", "expected", "error", "tolerance", "margin"))
            outcome = Verdict("passed", True) if test["passed"] else "skipped" if test["skipped"] else Verdict("failed", False)
            rows.append(Row(test["id"], [
                Link(test["id"], f"#{test['id']}"), outcome, Link(test["requirement"], f"requirements.html#{test['requirement']}"),
                self.source_link(test), number(test["comparisons"] or None), number(worst["computed"]), number(worst["expected"]),
                rounded_up(worst["error"]), number(worst["tolerance"], 2), rounded_up(worst["margin"]), worst.get("class", ""),
                Code(f"ctest --test-dir build/release -R '^{re.escape(test['id'])}$'")]))
        return Page("tests", "Tests", [
            "Each test with the requirement that it serves, its source and the command that runs it.",
            "The numbers belong to the comparison that came closest to its tolerance. The margin is error over tolerance. A margin "
            "above 1 fails. A test without numbers decides by an exception, a sign, a count or equal bits."],
            ["Test", "Outcome", "Requirement", "Source", "Comparisons", "Computed", "Reference", "Error", "Tolerance", "Margin",
             "Class", "Command"], rows)

    def requirements(self):
        """
        >>> test = {"passed": True, "skipped": False, "worst": None}
        >>> tests = [test | {"worst": {"margin": margin}} for margin in (0.25, 0.5)]
        >>> tests += [test, test | {"passed": False}, test | {"passed": False, "skipped": True}]
        >>> item = {"name": "V1", "text": "", "source": "", "tests": tests}
        >>> [cell.text for cell in site_of(requirements=[item]).requirements().rows[0].cells[3:]]
        ['5', '1', '0.5']
        """
        rows = []
        for item in self.known["requirements"]:
            tests = item["tests"]
            margins = [test["worst"]["margin"] for test in tests if test["worst"]]
            failed = sum(not test["passed"] and not test["skipped"] for test in tests)
            rows.append(Row(item["name"], [item["name"], item["text"], item["source"],
                                           Link(str(len(tests) or "none ran"), f"tests.html?q={item['name']}&column=Requirement"),
                                           number(failed if tests else None), rounded_up(max(margins, default=None))]))
        return Page("requirements", "Requirements", [
            "What must hold, where it comes from, how many tests serve it, how many of them failed, and their largest margin."],
            ["Requirement", "What must hold", "Where it comes from", "Tests", "Failed", "Largest margin"], rows)

    def tolerances(self):
        rows = [Row(f"{index}", [Link(entry["id"], f"tests.html#{entry['id']}"), entry["class"], number(entry["count"]),
                                 rounded_up(entry["error"]), number(entry["tolerance"], 2), rounded_up(entry["margin"]),
                                 entry["derivation"]])
                for index, entry in enumerate(self.known["tolerances"])]
        return Page("tolerances", "Tolerances", [
            "Each test and class of tolerance: round-off is a multiple of the machine's accuracy, the length of the computation and "
            "its condition; discretisation is a predicted error times a stated margin; reference is the accuracy of a datum.",
            "A margin above a half may turn by a small change of rounding. A margin below a thousandth says little: the bound is far "
            "from sharp, or two numbers are equal to the last digit."],
            ["Test", "Class", "Comparisons", "Error", "Tolerance", "Margin", "Derivation of the tolerance"], rows)

    def claims(self):
        rows = []
        for claim in self.known["claim"]:
            test = self.tests_of_claim.get(claim["id"])
            erratum = claim.get("erratum", "")
            rows.append(Row(claim["id"], [
                Link(claim["id"], f"#{claim['id']}"), claim["place"], claim["claim"], Verdict(claim["verdict"], claim["verdict"].startswith("holds")), claim["how"],
                test["finding"] if test else "not run", claim.get("correction", ""),
                Link(erratum, f"errata.html#{erratum}") if erratum else "", self.test_link(test) if test else ""]))
        return Page("claims", "Claims of the paper", [
            "Sentences of the paper that can be true or false and can be tested here, in the order of the page, each with the test that "
            "judges it.", "A correction puts a slip of the pen right: a symbol, a sign, a unit or a reference."],
            ["Claim", "Place", "What the paper says", "Verdict", "How it is tested", "What was found", "What holds instead", "Erratum",
             "Test"], rows)

    def errata(self):
        """
        >>> row = {"erratum": "E1", "quantity": "a", "unit": "Hz", "as_printed": 1.0, "corrected": 2.0, "reference": 3.0,
        ...        "tolerance": 4.0, "confirmed": True}
        >>> entry = dict.fromkeys(("place", "printed", "verdict", "holds", "established"), "") | {"id": "E1"}
        >>> evidence = [row, row | {"unit": "1", "confirmed": False}]
        >>> print(site_of(erratum=[entry], errata_evidence=evidence).errata().rows[0].cells[-1])
        a: 1 Hz as printed, 2 corrected, reference 3 +- 4; a: 1 as printed, 2 corrected, reference 3 +- 4 (not confirmed)
        """
        evidence = {}
        for row in self.known["errata_evidence"]:
            unit = "" if row["unit"] == "1" else f" {row['unit']}"
            evidence.setdefault(row["erratum"], []).append(
                f"{row['quantity']}: {row['as_printed']:.6g}{unit} as printed, {row['corrected']:.6g} corrected, reference "
                f"{row['reference']:.6g} +- {row['tolerance']:.2g}" + ("" if row["confirmed"] else " (not confirmed)"))
        rows = [Row(row["id"], [Link(row["id"], f"#{row['id']}"), row["place"], row["printed"], row["verdict"], row["holds"], row["established"],
                                "; ".join(evidence.get(row["id"], []))]) for row in self.known["erratum"]]
        return Page("errata", "Errata", ["Where the text of the paper and a recomputation differ."],
                    ["Erratum", "Place", "Printed", "Verdict", "What holds", "How it was established", "Numbers"], rows)

    def numbers(self):
        """
        >>> printed = {"id": "a", "meaning": "b.", "place": "c", "printed": "0.5", "printed_unit": "mm", "unit": "m"}
        >>> check = {"printed": printed, "computed": 0.25, "allowed": 0.125, "because": "d", "method": "e", "verdict": "holds"}
        >>> [getattr(cell, "text", cell) for cell in site_of(printed_checks=[check]).numbers().rows[0].cells]
        ['a', 'b', 'c', '0.5 mm', '0.25', '0.12', 'd', 'e', 'holds']
        """
        rows = []
        for index, check in enumerate(self.known["printed_checks"]):
            printed = check["printed"]
            unit = printed.get("printed_unit") or printed["unit"]
            rows.append(Row(f"{index}", [printed["id"], words(printed["meaning"]), printed["place"],
                                         f"{printed['printed']}{'' if unit == '1' else ' ' + unit}", number(check["computed"]),
                                         number(check["allowed"], 2), check["because"], check["method"],
                                         check["verdict"]]))
        return Page("numbers", "Printed numbers", ["Numbers that the paper prints, recomputed. What is computed and what is allowed are in SI units."],
                    ["Number", "Meaning", "Place", "Printed", "Computed", "Allowed difference", "Reason", "Method", "Verdict"], rows)

    def paper(self):
        rows = []
        for kind, name, count in (("Eq", "Eq. ({})", 30), ("Fig", "Fig. {}", 14)):
            for item in self.known["indexed"](kind, count):
                rows.append(Row(f"{kind}{item['number']}", [
                    name.format(item["number"]),
                    [Link(one, f"requirements.html#{one}") for one in item["requirements"]], number(item["tests"]),
                    [Link(f"{claim['id']} ({claim['verdict']})", f"claims.html#{claim['id']}") for claim in item["claims"]]]))
        return Page("paper", "Equations and figures of the paper", [
            "Each equation and figure with the requirements that name it, the number of their tests, and the claims about it."],
            ["Place", "Requirements", "Tests", "Claims"], rows)

    def mutants(self):
        entries = [one | {"kind": kind} for kind in ("survivor", "equivalent") for one in self.known["open" if kind == "survivor" else kind]]
        rows = [Row(f"{index}", [one["kind"], Code(one["file"]), Code(one["function"]), Code(one["edit"]), one["why"]])
                for index, one in enumerate(entries)]
        accepted = self.known["accepted_mutants"]
        shares = [[one["part"], one["of"], one["survived"], f"{one['share']:.0%}", f"{one['least']:.0%} to {one['most']:.0%}",
                   f"{accepted['share' if one['part'] == 'all' else 'share_of_part']:.0%}", decided(one["accepted"])] for one in self.known["killed"]]
        return Page("mutants", "Mutants", [
            "A mutant is the program with one mistake. A survivor is one that no test noticed, although one could. An equivalent mutant "
            "changes no result that a test can see; it is not counted. The shares are those of the last recorded run of each part; tests were added after it.",
            "Command: ./verification/run --mutants -- --part data"], ["Kind", "File", "Function", "Change", "Reason"], rows,
            tables=[Table("Share of the mutants that the tests noticed", ["Part", "Mutants", "Survived", "Share", "95 % interval", "Accepted from", "Accepted"],
                          shares)])

    def matrix(self):
        """Codes by problems, with the marks of the usual settings and of the best ones.

        >>> run = {"code": "a", "problem": "p", "settings": "s", "verdict": "differs", "level": "1e-2", "ratio": "30", "note": ""}
        >>> runs = [run, run | {"level": "strict", "ratio": "0.5"}, run | {"code": "b", "level": "", "ratio": ""}, run | {"problem": "q", "ratio": ""}]
        >>> table = site_of(scoreboard=runs).matrix()
        >>> table.columns, [[cell if isinstance(cell, str) else [(mark.text, mark.kind, mark.href) for mark in cell] for cell in row] for row in table.rows]
        (['Code', 'p'], [['a', [('✗ 30', 'margin', '#0'), ('✓ 0.5', 'use', '#1')]], ['b', [('–', 'none', '#2')]]])
        """
        cells = {}
        for index, run in enumerate(self.known["scoreboard"]):
            cells.setdefault(run["code"], {}).setdefault(run["problem"], []).append((float(run["ratio"] or math.inf), index, run))
        columns = dict.fromkeys(problem for row in cells.values() for problem, runs in row.items() if any(run["ratio"] for _, _, run in runs))

        def marks(runs):
            shown = [next((one for one in runs if one[2]["ratio"]), runs[0]), min(runs)]
            return list({index: mark(run, f"#{index}") for _, index, run in shown}.values())

        rows = [[code, *(marks(row[problem]) if problem in row else [] for problem in columns)] for code, row in cells.items()]
        return Table("Error over tolerance", ["Code", *columns], rows, "matrix")

    def runs(self, problem=None):
        """The runs of other codes on the problem of a data set, or of all of them."""
        sets = {resource["name"] for resource in self.known["package"]["resources"]}
        set_of = lambda run: run["problem"] if run["problem"] in sets else "published-problems"
        return ["Code", "Version", "Problem", "Settings", "Verdict", "Level", "Quantity", "Error", "Tolerance", "Ratio", "Creep", "Cost", "Data", "Day",
                "Machine", "Note"], [Row(f"{index}", [
                    one["code"], one["version"], Link(one["problem"], f"data/{set_of(one)}.html"), one["settings"], one["verdict"], one["level"],
                    one["quantity"], one["error"], one["tolerance"], number(float(one["ratio"]) if one["ratio"] else None, 2), one["creep"],
                    number(float(one["cost"]) if one["cost"] else None, 2), one["data"], one["date"], one["machine"], one["note"]])
                                     for index, one in enumerate(self.known["scoreboard"]) if problem in (None, set_of(one))]

    def scoreboard(self):
        return Page("scoreboard", "Other codes", [
            "Other codes on the problems of the reference data, a record of an earlier run. A cell has error over tolerance: usual settings first, then "
            "the best that were found. ✓ on green: agrees within the tolerance. ✗ on yellow: agrees to 1e-1, 1e-2 or 1e-3 (the level). ✗ on red: to none of "
            "them. –: the code or its driver cannot run it; empty: no driver. A problem that no code ran is in the table of all runs only.",
            "The creep is the mean velocity of a block that must not move. The cost is processor time in units of that of this program with its first "
            "settings. Command: ./verification/run --peers"], *self.runs(), tables=[self.matrix()])

    def wrong_models(self):
        columns = ["stick_frequency", "slip_frequency", "force_maximum", "stick_force", "stick_displacement", "first_slip",
                   "tip_displacement"]
        rows = []
        for effect in self.known["wrong_models"]:
            model = effect["wrong_model"]
            changes = [number(None if effect[name] is None else float(effect[name]), 3) for name in columns]
            rows.append(Row(model["name"], [Code(model["name"]), model["mistake"], model["place"], *changes]))
        return Page("wrong-models", "Wrong models", [
            "Mistakes that people make, by name, and what each changes in the damped benchmark, relative to the right value.",
            "Without a number: the model does not define the quantity, or the mistake is not possible in this problem."],
            ["Model", "Mistake", "Place in the paper", "First frequency, stick", "First frequency, slip", "Largest force", "f(t)",
             "y(L/2, t)", "First slip", "y(L, t)"], rows)

    def bad_input(self):
        rows = []
        for defect, places in sorted(self.known["bad_input"]["by_defect"].items()):
            for place, count in places.items():
                rows.append(Row(f"{defect}.{place}".replace(" ", "-"), [defect, place, number(count["refused"]), number(count["accepted"])]))
        reasons = [f"Accepted {count} times: {reason}." for reason, count in self.known["bad_input"]["by_reason"]]
        return Page("bad-input", "Bad input", [
            "Every key of a case file, option, column and key of a data package is tried with every defect. What is refused ends with exit "
            "code 2, one sentence and no file. What is accepted runs and gives finite numbers.", *reasons],
            ["Defect", "Place", "Refused", "Accepted"], rows)

    def figures_page(self):
        rows = []
        for order, name, _, alt, caption in self.drawings:
            tables = [file for file in sorted(self.figures.glob(f"{name}*.csv")) if file.stem == name or file.stem.startswith(f"{name}-")]
            rows.append(Row(name, [number(order), Image(f"../{name}.png", alt), caption, [Link(file.name, f"../{file.name}") for file in tables],
                                   Code(f"stickslip report --only {name} --output figures")]))
        return Page("figures", "Figures", ["The figures of the report, by its numbers, with their captions, data and commands."],
                    ["Figure", "Picture", "Caption", "Data", "Command"], rows)

    def data_sets(self):
        """The list of the data sets, and a page of each."""
        rows, pages = [], []
        levels = {step["set"]: (level, step["can"]) for level, step in enumerate(self.known["guide"], 1)}
        last = (len(levels) + 1, "")
        for one in sorted(self.known["package"]["resources"], key=lambda one: levels.get(one["name"], last)):
            level, can = levels.get(one["name"], last)
            name, made, values = one["name"], one["provenance"], one.get("comparison", {}).get("values", [])
            rows.append(Row(name, [number(level if can else None), can, Link(name, f"data/{name}.html"), one["title"], one["provenance"]["class"],
                                   Link(one["path"], f"data/{one['path']}"), Code(f"stickslip reference show {name}")]))
            facts = {"Problem": Code(json.dumps(one["problem"])) if "problem" in one else "",
                     "Columns": [f"{field['name']}{' in ' + field['unit'] if 'unit' in field else ''}: {field['description']}"
                                 for field in one["schema"]["fields"] if not field["name"].endswith("_radius")],
                     "Tolerances": [f"{value['field']}: {value['tolerance']:g} ({value['norm']})" for value in values],
                     "Uncertainty": f"{made['class']}; {made['method']}", "Checked by": [words(check) for check in made["checks"]],
                     "File": Link(one["path"], f"data/{one['path']}"), "Show it": Code(f"stickslip reference show {name}"),
                     "Judge a file": Code(f"stickslip compare {name} FILE") if values else ""}
            pages.append(Page(f"data/{name}", one["title"], [f"{name}: {one['description']}"], *self.runs(name),
                              tables=[Table("This data set", [], [fact for fact in facts.items() if fact[1]])]))
        return [Page("data", "Reference data", [
            "Which data set for my code? Begin with level 1 and go on to what your code can; the other sets follow. The page of each has its problem, "
            "tolerances, and what other codes reach.",
            "The tolerances are those that are proposed for a comparison: stickslip compare SET FILE, or the Python package, judges by them."],
                     ["Level", "Your code can", "Data set", "Title", "Uncertainty", "File", "Command"], rows), *pages]

    def argument(self):
        rows = []
        for one in self.known["quantities"]:
            rows.append(Row(one["id"], [
                {"beam": "A beam of one's own", "code": "A check of another code"}[one["use"]], one["what"],
                one["needed"], unlatexed(plain(100 * one["most"])),
                *(rounded_up(None if part is None else 100 * part, 1 if (part or 0) < 1e-4 else 2) for part in (one["parts"] + [None] * 3)[:4]),
                Verdict(one["fit"], one["fit"] == "yes") if one["fit"] in ("yes", "no") else one["fit"], one["limits"],
                [Link(name, f"requirements.html#{name}") for name in one["requirements"]],
                Verdict(f"{one['tests'] - one['failed']} of {one['tests']}", not one["failed"]) if one["tests"] else "not run",
                Link(f"{one['met']} of {len(one['results'])}", f"verdicts.html?q={one['id']}&column=Quantity") if one["results"] else "",
                [Code(f"stickslip {command}") for command in one["commands"]]]))
        return Page("argument", "From use to verdict", [
            "What the program is for, which quantities that takes, how accurate each must be, and what is known of its error: numerics, other models, "
            "inputs as they scatter, and the model against measurement. Empty: not known, or not needed. The report has the same table.",
            "Commands that compute nothing: " + "; ".join(f"{name} ({why})" for name, why in self.known["excluded"].items()) + "."],
            ["Use", "Quantity", "Needed for the use", "Need, %", "Numerics, %", "Model, %", "Inputs, %", "Measured, %", "Fit", "Limits", "Requirements", "Tests passed", "Criteria met", "Commands"], rows)

    def verdicts(self):
        """
        >>> one = {"what": "a", "metric": "b", "value": 0.125, "most": 0.5, "basis": "c", "remark": "d", "requirement": "V1", "section": "sec:e",
        ...        "value_of": "e.f | max"}
        >>> site = site_of(acceptance=[one | {"passed": True}], on_the_paper=[one | {"passed": False, "least": 0.25}], studies={"e"}, requirements=[])
        >>> site.drawings = [(1, "g", "sec:e", "", ""), (2, "h", "sec:i", "", "")]
        >>> [[getattr(cell, "text", cell) for cell in row.cells[:1] + row.cells[4:9]] for row in site.verdicts().rows]
        [['paper', '0.125', 'at most 0.5', 'yes', 'c', ''], ['paper', '0.1250', '0.25 to 0.5', 'no', 'c', 'd']]
        >>> [cell[0] for cell in site.verdicts().rows[0].cells[10:]]
        [Link(text='Fig. 1', href='figures.html#g'), Link(text='e', href='../studies/e.json'), Code(text='stickslip report --only g')]
        """
        rows = []
        served = {item["name"]: len(item["tests"]) for item in self.known["requirements"]}
        for index, result in enumerate(self.known["acceptance"] + self.known["on_the_paper"]):
            criterion = f"{result['least']:g} to {result['most']:g}" if "least" in result else f"at most {result['most']:g}"
            requirement = result["requirement"]
            figures = [(number, name) for number, name, section, *_ in self.drawings if section == result["section"]]
            studies = sorted(set(re.findall(r"[a-z_]+", result["value_of"])) & self.known["studies"])
            rows.append(Row(f"{index}", [
                result.get("quantity", "paper"), Link(requirement, f"requirements.html#{requirement}"), result["what"], result["metric"],
                Number(unlatexed(sig(result["value"], 4)), result["value"]) if "least" in result else rounded_up(result["value"], 3), criterion, decided(result["passed"]), result["basis"],
                "" if result["passed"] else result.get("remark", ""),
                Link(str(served.get(requirement, 0)), f"tests.html?q={requirement}&column=Requirement"),
                [Link(f"Fig. {number}", f"figures.html#{name}") for number, name in figures],
                [Link(study.replace("_", " "), f"../studies/{study}.json") for study in studies],
                [Code(f"stickslip report --only {name}") for _, name in figures] or [Code("./reports/generate")]]))
        return Page("verdicts", "Criteria", [
            "Each result with its requirement, value and criterion, the tests of the requirement, the figures of its section, the data that its value "
            "is computed from, and the commands that make them again. Those of the quantity 'paper' judge the paper, not the program."],
            ["Quantity", "Requirement", "Result", "Metric", "Value", "Criterion", "Met", "Basis", "Why not", "Tests", "Figures", "Data", "Command"], rows)

    def sensitivity(self):
        study = self.known["force_sensitivity"]
        rows = [Row(f"{index}", ["Eq. (28)" if row["closed_form"] else "finite elements", row["factor"], row["setting"],
                                 *(number(value, digits) for pair in zip(row["force"], row["change"]) for value, digits in zip(pair, (6, 2)))])
                for index, row in enumerate(study["rows"])]
        return Page("sensitivity", "Sensitivity", [
            "What one change of the method does to the largest friction force at the four excitations of the paper, against the first row of the method.",
            "The paper leaves the sampling open; it states Eq. (28), N = 10 and 10 s."],
            ["Method", "Changed", "Setting", *(head for hz in study["frequency_hz"] for head in (f"{hz:g} Hz, N", f"{hz:g} Hz, change in %"))], rows)

    def speed(self):
        speed = self.known["speed"]
        rows = [Row(f"{index}", [line["work"], line["plain"], line["fast"], number(1e3 * line["fast_seconds"], 2), number(line["ratio"], 2)])
                for index, line in enumerate(speed["comparisons"])]
        scale = ", ".join(f"{1e9 * line['seconds_per_element']:.3g} ns on {line['elements']}" for line in speed["scale"])
        return Page("speed", "Speed", [
            f"Fast ways against plain ones that return the same numbers, a record of one run on {speed['processor']}.",
            f"The plain stick run takes, for a step and element: {scale}."], ["Work", "Plain way", "Fast way", "Fast way, ms", "Plain over fast"], rows)

    def history(self):
        """
        >>> page = site_of(history=[{"commit": "a", "date": "b", "lines": "4"}, {"commit": "c", "date": "d", "lines": "8"}]).history()
        >>> page.charts, page.rows[1].cells
        ([Chart(title='lines', points='0,30 200,0 200,0', last='8')], ['c', 'd', Number(text='8', value=8.0)])
        """
        runs, charts = self.known["history"], []
        columns = list(runs[0])
        for column in columns[2:]:
            values = [(200 * index / (len(runs) - 1), float(run[column])) for index, run in enumerate(runs) if run[column]]
            most = max((value for _, value in values), default=0) or 1
            charts += [Chart(column.replace("_", " "), " ".join(f"{x:.4g},{60 - 60 * value / most:.4g}" for x, value in values + values[-1:]),
                             f"{values[-1][1]:g}")] if values else []
        rows = [Row(f"{index}", [run["commit"], run["date"], *(number(float(run[column])) if run[column] else "" for column in columns[2:])])
                for index, run in enumerate(runs)]
        return Page("history", "History", [
            "What was recorded at some commits. Each line begins at 0; its number is the last one. Empty: not recorded.",
            "The time is that of all tests one after the other, in seconds. A survivor is a mutant that no test noticed.",
            "Command: /usr/bin/python3 reports/site/site.py record build/reports/studies"],
            [column.replace("_", " ").capitalize() for column in columns], rows, charts)

    def pages(self):
        groups = {
            "Use it": [self.argument(), self.wrong_models(), self.speed()],
            "Evidence": [self.verdicts(), self.requirements(), self.tests(), self.tolerances(), self.mutants(), self.bad_input(), self.sensitivity(),
                         self.claims(), self.errata(), self.numbers(), self.paper(), self.history()],
            "Data": [*self.data_sets(), self.figures_page()],
            "Other codes": [self.scoreboard()]}
        return [page._replace(group=group) for group, pages in groups.items() for page in pages]


def index_of(pages):
    """What the search over all pages finds: page, address and words of each page's sentences and of each row.

    >>> index_of([Page("a", "A", ["B."], ["C"], [Row("1", ["b", Number("2", 2.0), [Link("c", "d"), Code("e")]])])])
    [['A', 'a.html', 'B.'], ['A', 'a.html#1', 'b; c']]
    """
    def words_of(cell):
        if isinstance(cell, list):
            return [word for one in cell for word in words_of(one)]
        return [] if isinstance(cell, (Number, Code, Image)) or not cell else [str(getattr(cell, "text", cell))]

    stated = lambda page: [*page.intro, *words_of([[table.columns, *map(list, table.rows)] for table in page.tables if not table.kind])]
    return [[page.title, f"{page.name}.html", "; ".join(stated(page))] for page in pages] + [
        [page.title, f"{page.name}.html#{row.id}", "; ".join(words_of(list(row.cells)))] for page in pages for row in page.rows]


def write_site(known, templates, data, figures, output):
    text, frame = text_of(templates, known)
    site = Site(known, text, figures)
    pages = site.pages()
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(FOLDER), autoescape=True, undefined=jinja2.StrictUndefined,
                                     trim_blocks=True, lstrip_blocks=True)
    environment.tests["kind"] = lambda cell, kind: type(cell).__name__.lower() == kind  # as the template shows it
    navigation = {page.group: [] for page in pages}
    for page in pages:
        navigation[page.group] += [Link(page.title, f"{page.name}.html")] if "/" not in page.name else []
    navigation["Use it"].append(Link("Report (PDF)", "../vv-report.pdf"))
    navigation["Data"].append(Link("Tables of the report", "tables.html"))
    environment.globals |= {"navigation": navigation, "environment": known["environment"], "tests": known["tests"],
                            "tested_commit": known["tested_commit"], "provenance": known["provenance"]}
    environment.filters |= {"breakable": breakable}
    shutil.copytree(data / "reference", output / "data")

    def write(name, template, **values):
        (output / name).parent.mkdir(parents=True, exist_ok=True)
        (output / name).write_text(environment.get_template(template).render(root="../" * name.count("/"), **values))

    write("index.html", "index.html", title="Does the tip of a shaken beam slip?", boxes=boxes_of(text), limits=limits_of(figures, site.drawings))
    write("tables.html", "base.html", title="Tables of the report", content=tables_of(text, frame))
    for page in pages:
        write(f"{page.name}.html", "table.html", page=page, title=page.title)
    for file, name in site.sources.items():
        write(name, "source.html", title=name.removeprefix("source/").removesuffix(".html"),
              lines=lines_of(file))
    (output / "search.js").write_text(f"const index = {json.dumps(index_of(pages))};\n{(FOLDER / 'search.js').read_text()}")
    for asset in ("site.css", "site.js", "front.js"):
        shutil.copy(FOLDER / asset, output)


SOURCES = r"\.(cpp|hpp|cmake|tex|gp|py|sh|html|js|css|in)$|CMakeLists.txt$|/run$|generate$"


def record(known, root):
    """Adds a row to verification/history.csv, in its columns."""
    git = lambda *arguments: subprocess.run(["git", *arguments], cwd=root, capture_output=True, text=True, check=True).stdout.split()
    tests = known["tests"]
    total = lambda key: sum(int(part[key]) for part in known["mutants"])
    run = {"commit": known["environment"]["commit"], "date": known["environment"]["date"].partition(" ")[0], "tests": len(tests),
           "failed": sum(not test["passed"] and not test["skipped"] for test in tests), "seconds": round(sum(test["seconds"] for test in tests)),
           "criteria": len(known["acceptance"]), "criteria_met": sum(result["passed"] for result in known["acceptance"]),
           "mutants": total("mutants"), "survivors": total("survived"),
           "lines": sum(len(lines_of(root / file)) for file in git("ls-files") if re.search(SOURCES, file))}
    with open(root / "verification" / "history.csv", "a") as file:
        csv.DictWriter(file, known["history"][0], lineterminator="\n").writerow(run)


def main(templates, data, values, figures, output):
    write_site(read_values(templates, data, values), templates, data, figures, output)


if __name__ == "__main__":
    if sys.argv[1] == "record":
        root = FOLDER.parent.parent
        record(read_values(FOLDER.parent / "report", root / "data", Path(sys.argv[2])), root)
    else:
        main(*map(Path, sys.argv[1:]))
