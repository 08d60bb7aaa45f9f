#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Makes the LaTeX sources of the report from templates.

  render.py tests FOLDER FILE                     GoogleTest's XML files of a folder as one JSON file
  render.py report TEMPLATES DATA VALUES OUTPUT   each TEMPLATES/*.tex, filled in, as OUTPUT/*.tex

Templates are written in Jinja2: << value | filter >>, <% statement %> and <# comment #>. <name> is what the
program wrote to VALUES/<name>.json; to this come the tables of the paper in DATA/paper and what the
mutation runs left in verification/mutants. A template says how many
digits a number has and computes nothing: the filters fixed, sig, sci, compact and plain, and bound for what others stay within;
percent, milli and micro change the unit. A value that is missing, and a number without a filter, is an error that names it.

Exit status: 2 for test results that cannot be used, 1 for any other error.
"""

import collections
import csv
import decimal
import functools
import hashlib
import json
import math
import re
import subprocess
import sys
import tomllib
import traceback
from pathlib import Path
from xml.etree import ElementTree

import jinja2

# ---- Numbers


def finite(value):
    if not math.isfinite(float(value)):
        raise ValueError(f"{value} cannot stand in the report")
    return float(value)


def fixed(value, decimals):
    """
    >>> fixed(0.5, 2), fixed(-0.5, 2), fixed(1999.5, 0), fixed(-0.004, 2)
    ('0.50', '\\\\ensuremath{-0.50}', '2000', '0.00')
    """
    text = f"{finite(value):.{decimals}f}"
    if not text.startswith("-"):
        return text
    return f"\\ensuremath{{{text}}}" if text.strip("-0.") else text[1:]


def exponent_of(value, digits):
    """The decimal exponent of a value once it is rounded to so many significant digits."""
    return int(f"{value:.{digits - 1}e}".partition("e")[2])


def sig(value, digits):
    """Significant digits.

    >>> sig(0.012345, 3), sig(2, 3), sig(30465.4, 3), sig(0, 3), sig(0.09996, 3), sig(9.996, 3)
    ('0.0123', '2.00', '30465', '0', '0.100', '10.0')
    """
    return fixed(value, max(0, digits - 1 - exponent_of(finite(value), digits))) if value else "0"


def sci(value, digits):
    """
    >>> sci(0.4276, 2), sci(-9.96e5, 2), sci(0, 2)
    ('\\\\ensuremath{4.3\\\\times10^{-1}}', '\\\\ensuremath{-1.0\\\\times10^{6}}', '0')
    """
    mantissa, _, exponent = f"{finite(value):.{digits - 1}e}".partition("e")
    return f"\\ensuremath{{{mantissa}\\times10^{{{int(exponent)}}}}}" if value else "0"


def plain(value):
    """As many digits as the number has.

    >>> plain(25.0), plain(-0.5)
    ('25', '\\\\ensuremath{-}0.5')
    """
    return typeset(repr(finite(value)).removesuffix(".0"))


def compact(value, digits):
    """At most so many digits, trailing zeros left out; with a power of ten below 1e-3 and from 1e5 on.

    >>> compact(2.50001, 3), compact(12345.6, 2), compact(2.5e-7, 3), compact(0.0, 2)
    ('2.5', '12000', '\\\\ensuremath{2.5\\\\times10^{-7}}', '0')
    """
    rounded = float(f"{finite(value):.{digits - 1}e}")
    if rounded == 0.0 or 1e-3 <= abs(rounded) < 1e5:
        return plain(rounded)
    return sci(rounded, next(n for n in range(1, digits + 1) if float(f"{rounded:.{n - 1}e}") == rounded))


def bound(value, digits):
    """The same, rounded away from zero: for a number that others stay within, in text and tables alike.

    >>> bound(1.425e-8, 1), bound(0.03, 1), bound(21.4, 2), bound(0.0, 2)
    ('\\\\ensuremath{2\\\\times10^{-8}}', '0.03', '22', '0')
    """
    return compact(float(decimal.Context(digits, decimal.ROUND_UP).create_decimal(repr(finite(value)))), digits)


def order(estimate):
    """An observed order and the half width of its interval, which is rounded up, and infinite through two points.

    >>> order({"order": 1.9996, "half_width": 0.0001}), order({"order": 2.5, "half_width": "inf"})
    ('$2.000\\\\pm0.001$', '2.500')
    """
    text = fixed(estimate["order"], 3)
    half_width = float(estimate["half_width"])
    return f"${text}\\pm{math.ceil(1000.0 * half_width) / 1000.0:.3f}$" if math.isfinite(half_width) else text


# ---- Words

RESERVED = {"\\": r"\textbackslash{}", "^": r"\textasciicircum{}", "~": r"\textasciitilde{}"}
RESERVED |= {character: "\\" + character for character in "#$%&_{}"}


def escape(text):
    """
    >>> escape("50 % of a_b^c")
    '50 \\\\% of a\\\\_b\\\\textasciicircum{}c'
    """
    return "".join(RESERVED.get(character, character) for character in str(text))


def breakable(name):
    """The name of a test or a file, which may be broken before its capitals."""
    return re.sub(r"(?<=\S)(?=[A-Z])|(?<=[./])", r"\\allowbreak{}", escape(name), flags=re.ASCII)


GREEK = {name: "\\" + name for name in "alpha beta gamma epsilon Omega lambda mu rho omega".split()}
GREEK["betabar"] = r"\bar\beta"
# Subscripts or an index, primes, an exponent and an argument.
TAIL = r"(?:(?:_[A-Za-z]+)+|[0-9]*)'*(?:\^-?[0-9]*)?(?:\([xtL0/2,(]*\))?"
# A letter is a symbol where its neighbours show that it is neither a unit nor an article: "u_t", "S(x)", "x = L",
# "A = 0.01", and behind another symbol: "rho A". P, L, I, f and u always are.
LETTER = r"[PLIfu]|[A-Za-z](?=_[A-Za-z]|'|\([xtL0/2,(]*\)| = )|(?<== )[A-Za-z]"
NEXT_LETTER = r"(?!(?<=[0-9)] )x [0-9])(?:E I|[A-Za-z])(?![A-Za-z])"
TOKEN = re.compile(
    r"(?P<times>(?<=[0-9)] )x(?= [0-9]))"
    rf"|(?P<symbols>(?:{'|'.join(GREEK)}|EI|E I|{LETTER})(?![A-Za-z]){TAIL}(?: {NEXT_LETTER}{TAIL})*)"
    r"|(?P<word>[A-Za-z]+)|\^(?P<power>-?[0-9]*)|(?P<relation><=|>=)|(?P<minus>(?<![^ (])-(?=[ 0-9A-Za-z]))"
    r"|(?P<character>.)", re.DOTALL)
SYMBOL = re.compile(r"(E I|[A-Za-z]+)((?:_[A-Za-z]+)+|[0-9]*)('*)(?:\^(-?[0-9]*))?(\(.*?\))?")


def symbol(match):
    name, index, primes, power, argument = match.groups()
    parts = [r"\max" if part == "max" else part if len(part) == 1 else rf"\mathrm{{{part}}}"
             for part in index.split("_")[1:]] or [index]
    return (r"\ensuremath{" + GREEK.get(name, name.replace(" ", "")) + (f"_{{{','.join(parts)}}}" if index else "") +
            primes + (f"^{{{power}}}" if power is not None else "") + (argument or "") + "}")


NOTATION = {
    "times": lambda text: r"\ensuremath{\times}",
    "symbols": lambda text: SYMBOL.sub(symbol, text),
    "word": lambda text: text,
    "power": lambda text: rf"\ensuremath{{^{{{text}}}}}",
    "relation": lambda text: r"\ensuremath{\le}" if text == "<=" else r"\ensuremath{\ge}",
    "minus": lambda text: r"\ensuremath{-}",
    "character": escape,
}


def typeset(text):
    r"""Plain notation as LaTeX.

    >>> print(typeset("omega_n^2 T_n_tt, |f_max| <= mu_s P, P = 500 N, N = 10, N"))
    \ensuremath{\omega_{n}^{2}} \ensuremath{T_{n,\mathrm{tt}}}, |\ensuremath{f_{\max}}| \ensuremath{\le} \ensuremath{\mu_{s}} \ensuremath{P}, \ensuremath{P} = 500 N, \ensuremath{N} = 10, N
    >>> print(typeset("(1/12) x 10^-6 m^4, a box 10 high, E I u''' and u_t(x,0); 5 % & more: E4, stick-slip"))
    (1/12) \ensuremath{\times} 10\ensuremath{^{-6}} m\ensuremath{^{4}}, a box 10 high, \ensuremath{EI} \ensuremath{u'''} and \ensuremath{u_{t}(x,0)}; 5 \% \& more: E4, stick-slip
    """
    return TOKEN.sub(lambda match: NOTATION[match.lastgroup](match[match.lastgroup]), text)


# ---- Tests


def numbers(names, fields):
    return dict(zip(names, map(float, fields), strict=True))


def read_test(case, identity):
    """A test as its XML tells of it: what it serves, its comparison with the largest margin, and for each class of
    tolerances the one that came closest. Its identity is its name for ctest."""
    properties = {item.get("name"): item.get("value") for item in case.iterfind("properties/property")}
    suite = case.get("classname").rpartition("/")[2]
    skipped = case.find("skipped") is not None
    test = {"id": identity, "file": case.get("file"), "line": case.get("line"), "suite": suite, "name": case.get("name"),
            "tolerances": [], "bad_input": [], "accepted_input": {}, "skipped": skipped, "worst": None,
            "passed": case.get("status") == "run" and not skipped and case.find("failure") is None,
            "position": int(properties.get("requirement_position", 0)),
            "comparisons": int(properties.get("comparisons", 0)), "seconds": float(case.get("time", 0))}
    test |= {key: properties.get(key, "") for key in ("requirement", "requirement_text", "source", "claim", "finding")}
    compared = ("computed", "expected", "error", "tolerance", "margin")
    if test["comparisons"]:
        test["worst"] = numbers(compared, (properties[key] for key in compared)) | {"class": properties["class"]}
    for key, value in sorted(properties.items()):
        group, _, what = key.partition(".")
        if group == "bad_input":
            place, _, defect = what.partition(".")
            refused, accepted = map(int, value.split("; "))
            test["bad_input"].append({"place": place, "defect": defect, "refused": refused, "accepted": accepted})
        if group == "accepted_input":
            test["accepted_input"][what] = int(value)
        if group == "tolerances":
            count, *fields, derivation = value.split("; ", 4)
            test["tolerances"].append(numbers(compared[2:], fields) | {"id": identity, "class": what, "count": int(count),
                                                                       "derivation": derivation})
    return test


def read_tests(folder):
    """The tests of a folder by requirement, then suite, then name. No run has ended where its file `commit` is empty."""
    tests, file = [], folder
    try:
        if (folder / "commit").is_file() and not (folder / "commit").read_text().strip():
            return []
        for file in folder.rglob("*.xml"):
            if file.stat().st_size > 50_000_000:
                raise ValueError("is larger than the 50000000 bytes that are allowed")
            identity = str(file.relative_to(folder).with_suffix(""))
            tests += [read_test(case, identity) for case in ElementTree.parse(file).iterfind("testsuite/testcase")]
    except (ElementTree.ParseError, OSError, ValueError) as error:
        raise InputError(f"{file}: {error}") from error
    except KeyError as error:
        raise InputError(f"{file}: the property {error} is missing") from error
    if not tests:
        raise InputError(f"the folder of test results is {folder}, but must hold GoogleTest's XML files")
    return sorted(tests, key=lambda test: (test["position"], test["suite"], test["name"], test["id"]))


def numbers_named(text, kind):
    """The numbers of the paper's equations ("Eq") or figures ("Fig") that a text names.

    >>> sorted(numbers_named("Eqs. (1) to (3), (26); E3", "Eq")), sorted(numbers_named("text on Figs. 4b and 5", "Fig"))
    ([1, 2, 3, 26], [4, 5])
    """
    named = set()
    number = r"\(?([0-9]+)[a-z]*\)?"
    for places in re.finditer(rf"{kind}s?\. ({number}(?:(?:, | and | to ){number})*)", text):
        last = None
        for joint, found in re.findall(rf"(, | and | to )?{number}", places[1]):
            named |= set(range(last, int(found) + 1)) if joint == " to " else {int(found)}
            last = int(found)
    return named


def paper_index(kind, count, tests, claims):
    """What is said of each equation or figure of the paper."""
    for number in range(1, count + 1):
        serving = [test for test in tests if number in numbers_named(test["source"], kind)]
        yield {"number": number, "tests": len(serving),
               "requirements": sorted({test["requirement"] for test in serving}),
               "claims": [claim for claim in claims if number in numbers_named(claim["place"], kind)]}


def requirements_of(stated, tests):
    """The requirements as verification/requirements.toml states them, each with the tests that serve it.

    >>> [(one["name"], len(one["tests"])) for one in requirements_of([["A1", "what", "where"], ["A2", "", ""]], [{"requirement": "A2"}])]
    [('A1', 0), ('A2', 1)]
    """
    return [{"name": name, "text": text, "source": source, "tests": [test for test in tests if test["requirement"] == name]}
            for name, text, source in stated]


INPUT_PLACES = ("case file", "option", "column", "package")


def bad_input_of(tests):
    """How many inputs with each defect are refused and accepted at each place, and how many are accepted for each reason.

    >>> one = {"place": "option", "defect": "zero", "refused": 3, "accepted": 1}
    >>> both = bad_input_of([{"bad_input": [one], "accepted_input": {"nothing moves": 1}}] * 2)
    >>> both["by_defect"]["zero"]["option"], both["by_reason"]
    ({'refused': 6, 'accepted': 2}, [('nothing moves', 2)])
    """
    by_defect, by_reason = {}, collections.Counter()
    for test in tests:
        for count in test.get("bad_input", []):
            places = by_defect.setdefault(count["defect"], {place: {"refused": 0, "accepted": 0} for place in INPUT_PLACES})
            for outcome, total in places[count["place"]].items():
                places[count["place"]][outcome] = total + count[outcome]
        by_reason.update(test.get("accepted_input", {}))
    return {"by_defect": by_defect, "by_reason": by_reason.most_common()}


def distance_from(value, target):
    return abs(value - target)


def largest(values):
    """The largest of the values that there are, or NaN if one of them is.

    >>> largest([1.0, None, "inf"]), largest([1.0, "nan", 2.0])
    (inf, nan)
    """
    numbers = [float(value) for value in values if value is not None]
    return math.nan if any(map(math.isnan, numbers)) else max(numbers)


def product(row, *members):
    """The product of members of a row, each perhaps a member of a member.

    >>> product({"a": {"b": 2.0}, "c": 3.0}, "a.b", "c"), product({"a": None, "c": 3.0}, "a", "c")
    (6.0, None)
    """
    values = [functools.reduce(lambda value, name: value[name], member.split("."), row) for member in members]
    return None if None in values else math.prod(values)


def published_tolerances(package):
    """The tolerance of each compared column of the published data sets, by data set and column."""
    return {one["name"]: {value["field"]: value["tolerance"] for value in one.get("comparison", {}).get("values", [])}
            for one in package["resources"]}


def half_width_shares(folder, package):
    """The largest half-width of each compared column of the published data, in parts of its tolerance."""
    shares = []
    for resource in package["resources"]:
        rows = list(csv.DictReader((folder / resource["path"]).read_text().splitlines()))
        for value in resource.get("comparison", {}).get("values", []):
            name = value["field"]
            pairs = [(float(row[name]), float(row[name + "_radius"])) for row in rows if row[name] and row.get(name + "_radius")]
            column = [one for one, _ in pairs]
            units = {"relative": abs, "scale": lambda _: max(map(abs, column)), "range": lambda _: max(column) - min(column)}
            unit = units.get(value["norm"], lambda _: 1.0)
            shares += [radius / unit(one) / value["tolerance"] for one, radius in pairs if radius]
    return shares


def error_ratio(errors, elements, order):
    """The ratio of the errors on the two finest meshes over what an order predicts.

    >>> error_ratio([5.0, 1.6, 0.1], [1, 2, 4], 4)
    1.0
    """
    return errors[-2] / errors[-1] / (elements[-1] / elements[-2]) ** order


def evaluated(text, environment, known):
    return float(environment.compile_expression(text, undefined_to_none=False)(**known))


def judged(result, environment, known):
    """A result of acceptance.toml with its value and whether that meets the criterion.

    >>> [judged({"value": "a | distance_from(1)", "most": 0.5}, environment_for([]), {"a": a})["passed"] for a in (0.25, 0.5, 1.5, 1.75)]
    [False, True, True, False]
    >>> [judged({"value": "a", "least": 2, "most": 3}, environment_for([]), {"a": a})["passed"] for a in (1.5, 2, 3, 3.5, "nan")]
    [False, True, True, False, False]
    >>> judged({"value": "a", "most": "2 * b"}, environment_for([]), {"a": 3, "b": 1.5})["most"]
    3.0
    """
    value = evaluated(result["value"], environment, known)
    result = result | {limit: evaluated(result[limit], environment, known) for limit in ("least", "most") if isinstance(result.get(limit), str)}
    return result | {"value": value, "value_of": result["value"], "passed": result.get("least", -math.inf) <= value <= result.get("most", math.inf)}


PARTS = ("numerics", "model", "inputs", "measurement")  # of the error of a quantity
FIT = ("yes", "numerics only", "not judged", "no")


def fit_of(parts, most, needed, tests, is_met):
    """Whether a quantity is fit for its use, by the parts of its error, those that it needs, the number of tests that ran and
    whether they and the criteria are met. What is known of the error must be within the need, and it is their sum.

    >>> [fit_of(parts, 5, PARTS[:2], tests, is_met) for parts, tests, is_met in
    ...  (([2, 3], 1, True), ([2, None], 1, True), ([None, 3], 1, True), ([2, 3], 0, True), ([2, 4], 0, True), ([2, 3], 1, False), ([2, math.nan], 1, True))]
    ['yes', 'numerics only', 'not judged', 'not judged', 'no', 'no', 'no']
    """
    known = [part for part in parts if part is not None]
    if not is_met or not (sum(known) <= most):
        return "no"
    if parts[0] is None or not tests:
        return "not judged"
    return "yes" if len(known) == len(needed) else "numerics only"


def argued(quantity, results, requirements, environment, known):
    """A quantity of acceptance.toml with the parts of its error, its results, the numbers of tests of its requirements, and its fit.

    >>> quantity, result = {"id": "a", "use": "code", "requirements": ["A1"], "numerics": "1", "most": 2}, {"quantity": "a", "passed": True}
    >>> tests = [{"passed": True, "skipped": False}]
    >>> cases = [(result, tests), (result | {"passed": False}, tests), (result, tests + [{"passed": False, "skipped": False}]),
    ...          (result | {"quantity": "b", "passed": False}, tests), (result, []), (result, [{"passed": False, "skipped": True}])]
    >>> [argued(quantity, [one], [{"name": "A1", "tests": ran}], environment_for([]), {})["fit"] for one, ran in cases]
    ['yes', 'no', 'no', 'yes', 'not judged', 'not judged']
    >>> argued(quantity | {"use": "beam"}, [result], [{"name": "A1", "tests": tests}], environment_for([]), {})["fit"]
    'numerics only'
    """
    own = [result for result in results if result["quantity"] == quantity["id"]]
    ran = [test for item in requirements if item["name"] in quantity["requirements"] for test in item["tests"] if not test["skipped"]]
    failed = sum(not test["passed"] for test in ran)
    needed = PARTS if quantity["use"] == "beam" else PARTS[:1]
    parts = [evaluated(quantity[part], environment, known) if part in quantity else None for part in needed]
    is_met = all(result["passed"] for result in own) and not failed
    return quantity | {"results": own, "met": sum(result["passed"] for result in own), "tests": len(ran), "failed": failed,
                       "parts": parts, "fit": fit_of(parts, quantity["most"], needed, len(ran), is_met)}


def killed(parts, accepted):
    """The share of the mutants of each part, and of all, that tests notice, of those that are not equivalent, with its 95 % interval
    (Wilson's), and whether it is the share that is accepted.

    >>> run = {"part": "a", "mutants": "12", "equivalent": "2", "survived": "1"}
    >>> [(one["part"], one["of"], one["share"], f"{one['least']:.4f} {one['most']:.4f}", one["accepted"])
    ...  for one in killed([run, run | {"part": "b", "survived": "3"}], {"share": 0.7, "share_of_part": 0.8})]
    [('a', 10, 0.9, '0.5958 0.9821', True), ('b', 10, 0.7, '0.3968 0.8922', False), ('all', 20, 0.8, '0.5840 0.9193', True)]
    """
    if not parts:
        return []
    counts = [(part["part"], int(part["mutants"]) - int(part["equivalent"]), int(part["survived"])) for part in parts]
    counts.append(("all", sum(of for _, of, _ in counts), sum(survived for *_, survived in counts)))
    rates = []
    for part, of, survived in counts:
        share, z = 1.0 - survived / of, 1.959964
        middle = (share + z * z / (2 * of)) / (1 + z * z / of)
        half = z * math.sqrt(share * (1 - share) / of + (z / (2 * of)) ** 2) / (1 + z * z / of)
        rates.append({"part": part, "of": of, "survived": survived, "share": share, "least": middle - half, "most": middle + half,
                      "accepted": share >= accepted["share" if part == "all" else "share_of_part"]})
    return rates


# ---- Speed

SECONDS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}


def shortest_times(run):
    """Of what Google Benchmark wrote, the seconds of the shortest repetition of each benchmark."""
    times = {}
    for timed in run["benchmarks"]:
        if timed["run_type"] == "iteration" and not timed.get("error_occurred"):
            seconds = timed["real_time"] * SECONDS[timed["time_unit"]]
            times[timed["run_name"]] = min(seconds, times.get(timed["run_name"], math.inf))
    return times


def speed_of(run, comparisons):
    """The times of the plain and the fast methods in one run of the benchmarks.

    >>> def timed(name, time, unit="ms"):
    ...     return {"run_type": "iteration", "run_name": name, "real_time": time, "time_unit": unit}
    >>> run = {"context": {"processor": "P"}, "benchmarks": [
    ...     timed("plain", 30.0), timed("plain", 20.0), timed("fast", 4.0),
    ...     timed("elements/20", 100.0, "us"), timed("elements/100", 1.0)]}
    >>> speed = speed_of(run, [{"work": "w", "plain": "p", "plain_benchmark": "plain", "fast": "f", "fast_benchmark": "fast"}])
    >>> speed["comparisons"][0]["ratio"], speed["scale"][0]["seconds_per_element"]
    (5.0, 5e-08)
    """
    times, lines = shortest_times(run), []
    for line in comparisons:
        plain, fast = (times[line[f"{way}_benchmark"]] for way in ("plain", "fast"))
        lines.append(line | {"fast_seconds": fast, "ratio": plain / fast})
    # An iteration of "elements/N" is a hundred steps of N elements.
    per_element = {int(name.partition("/")[2]): seconds for name, seconds in times.items() if name.startswith("elements/")}
    scale = [{"elements": count, "seconds_per_element": seconds / (100 * count)} for count, seconds in per_element.items()]
    return {"processor": run["context"]["processor"], "comparisons": lines, "scale": scale}


# ---- Report


class InputError(Exception):
    """Test results that cannot be used."""


def read_values(templates, data, values):
    """What the templates can name."""
    known = {file.stem: json.loads(file.read_text()) for file in values.glob("*.json")}
    known["studies"] = set(known)
    for file in ("claims", "errata", "printed-numbers"):
        known |= tomllib.loads((data / "paper" / f"{file}.toml").read_text())
    known["printed"] = {number["id"]: number for number in known["number"]}
    known["package"] = json.loads((data / "reference" / "datapackage.json").read_text())
    known["published"] = published_tolerances(known["package"])
    known["half_width_shares"] = half_width_shares(data / "reference", known["package"])
    mutants = templates.parent.parent / "verification" / "mutants"
    known["mutant_runs"] = list(csv.DictReader((mutants / "summary.csv").read_text().splitlines()))
    known["mutants"] = list({run["part"]: run for run in known["mutant_runs"]}.values())  # the last of each part
    known["changed_since"] = changed_since(templates, known["mutants"])
    known |= {"open": [], "equivalent": []} | tomllib.loads((mutants / "survivors.toml").read_text())
    known["history"] = list(csv.DictReader((mutants.parent / "history.csv").read_text().splitlines()))
    known["scoreboard"] = list(csv.DictReader((mutants.parent / "peers" / "scoreboard.csv").read_text().splitlines()))
    benchmarks = mutants.parent / "benchmarks"
    known["speed"] = speed_of(json.loads((benchmarks / "results" / "speed.json").read_text()),
                              tomllib.loads((benchmarks / "comparisons.toml").read_text())["comparison"])
    processors = re.findall(r"^model name.*: (.*)", Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    known["provenance"] = [("Processor", f"{len(processors)} x {processors[0]}" if processors else "unknown"),
                           ("Data", f"SHA-256 {digest_of(data)} of the folder data")]
    stated = tomllib.loads((templates.parent.parent / "verification" / "requirements.toml").read_text())["requirements"]
    known["requirements"] = requirements_of(stated, known["tests"])
    known["bad_input"] = bad_input_of(known["tests"])
    known["tolerances"] = [entry for test in known["tests"] for entry in test["tolerances"]]
    accepted = tomllib.loads((templates.parent.parent / "verification" / "acceptance.toml").read_text())
    expressions = environment_for([])
    known["acceptance"], known["on_the_paper"] = (
        [judged(result, expressions, known) for result in accepted[kind]] for kind in ("result", "paper"))
    known["quantities"] = [argued(quantity, known["acceptance"], known["requirements"], expressions, known) for quantity in accepted["quantity"]]
    known["accepted_mutants"], known["killed"] = accepted["mutants"], killed(known["mutants"], accepted["mutants"])
    known["excluded"] = accepted["excluded"]
    sets = {resource["name"]: resource for resource in known["package"]["resources"]}
    known["guide"] = [step | {"resource": sets[step["set"]]} for step in accepted["guide"]]
    known["indexed"] = lambda kind, count: paper_index(kind, count, known["tests"], known["claim"])
    return known | {"zip": zip}


def changed_since(folder, runs):
    """How many sources outside the tests differ from those of some mutation run; None without git or that history."""
    def changed(commit):
        names = subprocess.run(["git", "diff", "--name-only", commit, "--", ":/*.[ch]pp", ":!/verification/tests"],
                               cwd=folder, check=True, capture_output=True, text=True)
        return len(names.stdout.splitlines())
    try:
        return max((changed(commit) for commit in {run["commit"] for run in runs}), default=None)
    except (OSError, subprocess.CalledProcessError):
        return None


def digest_of(folder):
    """SHA-256 of the names and bytes of all files in a folder."""
    digest = hashlib.sha256()
    for file in sorted(file for file in folder.rglob("*") if file.is_file()):
        digest.update(f"{file.relative_to(folder)}\0".encode() + file.read_bytes())
    return digest.hexdigest()


def shown(value):
    """A number needs a filter, so that its digits are chosen."""
    if isinstance(value, float):
        raise ValueError(f"the number {value} has no filter that says how many digits it is given")
    return value


FILTERS = (fixed, sig, sci, plain, compact, bound, order, escape, breakable, typeset, distance_from, error_ratio, largest, product)


def environment_for(templates):
    """
    >>> units = "<< 1 | percent | plain >>, << 1 | milli | plain >>, << 1 | micro | plain >>"
    >>> environment_for([]).from_string(units).render()
    '100, 1000, 1000000'
    """
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(templates), undefined=jinja2.StrictUndefined, finalize=shown,
        block_start_string="<%", block_end_string="%>", variable_start_string="<<", variable_end_string=">>",
        comment_start_string="<#", comment_end_string="#>", trim_blocks=True, lstrip_blocks=True,
        keep_trailing_newline=True)
    environment.filters |= {function.__name__: function for function in FILTERS}
    environment.filters |= {"log10": math.log10, "percent": lambda value: 100.0 * value, "milli": lambda value: value / 1e-3,
                            "micro": lambda value: value / 1e-6}
    return environment


def write_report(templates, data, values, output):
    environment = environment_for(templates)
    environment.globals |= read_values(templates, data, values)
    for name in environment.list_templates(extensions=["tex"]):
        (output / name).write_text(environment.get_template(name).render())


def place_of(error):
    """"title.tex, line 12: " where a template is to blame."""
    lines = [(Path(frame.filename).name, frame.lineno) for frame in traceback.extract_tb(error.__traceback__)
             if frame.filename.endswith(".tex")]
    if isinstance(error, jinja2.TemplateSyntaxError):
        lines.append((error.name, error.lineno))
    return "{}, line {}: ".format(*lines[-1]) if lines else ""


def main(command, *paths):
    try:
        if command == "tests":
            folder, file = map(Path, paths)
            file.write_text(json.dumps(read_tests(folder)))
        else:
            write_report(*map(Path, paths))
    except InputError as error:
        print(error)
        return 2
    except Exception as error:  # whatever a template does wrong, in one line
        print(f"{place_of(error)}{error}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
