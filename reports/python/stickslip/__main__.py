# SPDX-License-Identifier: MIT
"""python3 -m stickslip: lists the data sets and judges results.

Exit status: 0 all agrees; 1 something differs; 2 a file cannot be used; 3 nothing differs, but something is undecided or missing.
"""
import argparse
import csv
import json
import pathlib
import sys
from xml.etree import ElementTree

from ._data import InputError, load, names
from ._judge import judge

COLOURS = {0: "#2e7d32", 1: "#c62828", 2: "#616161", 3: "#b26a00"}


def _mapping(text):
    name, _, value = text.partition("=")
    if not name or not value:
        raise argparse.ArgumentTypeError(f"'{text}' must be REFERENCE=THEIRS or REFERENCE=THEIRS:unit, as in frequency=f1:kHz")
    return name, value


def _tolerance(text):
    name, _, value = text.rpartition("=")
    try:
        return name, float(value)
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' must be a number or QUANTITY=NUMBER, as in frequency=1e-3") from None


def _rows(text):
    rows = []
    for part in text.split(","):
        ends = [int(end) if end.isdigit() else 0 for end in part.split(":")]
        if len(ends) > 2 or not 0 < ends[0] <= ends[-1]:
            raise argparse.ArgumentTypeError(f"'{text}' must be numbers and ranges of them, as in 1:12,15")
        rows += range(ends[0], ends[-1] + 1)
    return rows


def _parser():
    parser = argparse.ArgumentParser("stickslip", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("list", help="the data sets")
    one = commands.add_parser("judge", help="results of your own against a data set")
    one.add_argument("name", nargs="?", metavar="NAME", help="a data set that 'list' names")
    one.add_argument("file", nargs="?", metavar="FILE", help="CSV file with the columns of the data set, - for standard input")
    one.add_argument("--manifest", metavar="FILE",
                     help="CSV file with the columns data_set and file, and events and rows if need be: judges them all")
    one.add_argument("--columns", metavar="A,B,...", help="the names of the columns of FILE, if it has none")
    one.add_argument("--column", action="append", type=_mapping, default=[], metavar="REFERENCE=YOURS[:UNIT]")
    one.add_argument("--tolerance", action="append", type=_tolerance, default=[], metavar="[QUANTITY=]NUMBER")
    one.add_argument("--rows", type=_rows, metavar="1:12,15", help="the rows of the data set that FILE must have")
    one.add_argument("--until", type=float, metavar="S", help="compare nothing later")
    one.add_argument("--events", metavar="FILE", help="changes of contact of the same run")
    for option in ("json", "junit", "badge"):
        one.add_argument("--" + option, metavar="FILE", help="- for standard output")
    one.add_argument("--quiet", action="store_true", help="print no table")
    return parser


def _jobs(options):
    """Name, file, events and rows of what is to be judged."""
    if not options.manifest:
        return [(options.name, options.file, options.events, options.rows)]
    folder = pathlib.Path(options.manifest).parent
    try:
        with open(options.manifest, encoding="utf-8-sig", newline="") as file:
            lines = list(csv.DictReader(file))
            if any(None in line or None in line.values() for line in lines):
                raise csv.Error("a line has fewer or more cells than names")
            jobs = [(one["data_set"], folder / one["file"], folder / one["events"] if one.get("events") else None,
                     _rows(one["rows"]) if one.get("rows") else None) for one in lines]
    except OSError as error:
        raise InputError(f"{options.manifest}: cannot be read ({error.strerror})") from None
    except (UnicodeDecodeError, csv.Error, KeyError, TypeError, argparse.ArgumentTypeError) as error:
        raise InputError(f"{options.manifest}: is no CSV file with the columns data_set and file ({error})") from None
    if not jobs:
        raise InputError(f"{options.manifest}: the manifest has no rows, but must have at least one")
    return jobs


def _junit(results):
    """A suite for each file, with a case for the coverage and for each quantity. What is undecided or refused is an error."""
    root = ElementTree.Element("testsuites", name="stickslip")
    for name, judgement, refusal in results:
        suite = ElementTree.SubElement(root, "testsuite", name=name)
        cases = [("file", "refused", refusal)]
        if judgement is not None:
            is_covered = judgement.coverage >= judgement.required_coverage
            cases = [("coverage", "agrees" if is_covered else "undecided", judgement.conclusion)]
            cases += [(one.name, one.verdict, f"error {one.error} at {one.where}, tolerance {one.tolerance}")
                      for one in judgement.quantities]
        for case, verdict, message in cases:
            test = ElementTree.SubElement(suite, "testcase", classname=name, name=case)
            if verdict != "agrees":
                ElementTree.SubElement(test, "failure" if verdict == "differs" else "error", type=verdict, message=message)
        ElementTree.SubElement(suite, "system-out").text = refusal or str(judgement)
    for node in (root, *root):
        for key, tag in {"tests": "testcase", "failures": "failure", "errors": "error"}.items():
            node.set(key, str(len(list(node.iter(tag)))))
    return ElementTree.tostring(root, encoding="unicode", xml_declaration=True) + "\n"


def _badge(results, status):
    """An SVG image: the name and the verdict with its level, or how many files agree."""
    name, judgement, _ = results[0]
    said = "refused" if judgement is None else judgement.conclusion + (f" ({judgement.level})" if judgement else "")
    label, said = (name, said) if len(results) == 1 else ("stickslip", f"{sum(bool(j) for _, j, _ in results)} of {len(results)} agree")
    left, right = (10 + 7 * len(text) for text in (label, said))
    parts = "".join(f'<rect x="{x}" width="{w}" height="20" fill="{fill}"/><text x="{x + w / 2:g}" y="14" textLength="{w - 10}">{text}'
                    "</text>" for x, w, fill, text in ((0, left, "#444", label), (left, right, COLOURS[status], said)))
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{left + right}" height="20" role="img" aria-label="{label}: {said}">'
            f'<g fill="#fff" text-anchor="middle" font-family="DejaVu Sans,sans-serif" font-size="11">{parts}</g></svg>\n')


def _table(results):
    lines = [(name, "-" if judgement is None else judgement.level, f"refused: {refusal}" if refusal else judgement.conclusion)
             for name, judgement, refusal in results]
    width = max(len(line[0]) for line in lines)
    return "".join(f"{name:{width}}  {level:6}  {verdict}\n" for name, level, verdict in lines)


def _write(file, text):
    if file == "-":
        sys.stdout.write(text)
        return
    try:
        pathlib.Path(file).write_text(text, encoding="utf-8")
    except OSError as error:
        raise InputError(f"{file}: cannot be written ({error.strerror})") from None


def _judged(options):
    results = []
    for name, file, events, rows in _jobs(options):
        try:
            results.append((name, judge(name, file, events=events, rows=rows, columns=dict(options.column) or options.columns,
                                        tolerance=dict(options.tolerance), until=options.until), None))
        except InputError as error:
            results.append((name, None, str(error)))
    statuses = {2 if judgement is None else judgement.exit_status for _, judgement, _ in results}
    status = next((one for one in (2, 1, 3) if one in statuses), 0)
    if options.junit:
        _write(options.junit, _junit(results))
    if options.badge:
        _write(options.badge, _badge(results, status))
    if not options.manifest and status == 2:
        raise InputError(results[0][2])
    if options.json:
        objects = [{"name": name, "verdict": "refused", "reason": refusal} if judgement is None else judgement.as_dict()
                   for name, judgement, refusal in results]
        _write(options.json, json.dumps(objects if options.manifest else objects[0], indent=1) + "\n")
    if not options.quiet and "-" not in (options.json, options.junit, options.badge):
        print(_table(results) if options.manifest else results[0][1], end="" if options.manifest else "\n")
    return status


def main(arguments=None):
    parser = _parser()
    options = parser.parse_args(arguments)
    try:
        if options.command == "judge":
            if not options.manifest and not options.file:
                parser.error("judge needs NAME and FILE, or --manifest FILE")
            return _judged(options)
        print("\n".join(f"{name:30}  {load(name).title}" for name in names()))
        return 0
    except InputError as error:
        print(f"stickslip: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
