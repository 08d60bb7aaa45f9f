# SPDX-License-Identifier: MIT
"""python3 -m stickslip: lists the data sets and judges results.

Exit status: 0 all agrees; 1 something differs; 2 a file cannot be used; 3 nothing differs, but something is undecided or missing.
"""
import argparse
import html
import json
import os
import pathlib
import re
import shutil
import sys
from xml.etree import ElementTree

from ._data import BLANKS, InputError, load, names, number, printable, rows_of, unit_named
from ._judge import LEVELS, LIMITS, judge, tolerances_of

COLOURS = {0: "#2e7d32", 1: "#c62828", 2: "#616161", 3: "#b26a00"}


class _Once(argparse.Action):
    def __call__(self, parser, namespace, value, option=None):
        if getattr(namespace, self.dest) is not None:
            parser.error(f"{option} is given twice, but must be given once")
        setattr(namespace, self.dest, value)


def _mapping(text):
    name, _, value = (part.strip(BLANKS) for part in text.partition("="))
    if not name or not value:
        raise argparse.ArgumentTypeError(f"'{text}' must be REFERENCE=THEIRS or REFERENCE=THEIRS:unit, as in frequency=f1:kHz")
    return name, value


def _tolerance(text):
    try:
        (tolerance,) = tolerances_of(text.replace(" ", "_")).items()  # one alone, without blanks
    except ValueError:  # none, several or one that is refused
        raise argparse.ArgumentTypeError(f"'{text}' must be a number or QUANTITY=NUMBER, as in frequency=1e-3") from None
    return tolerance


def _time(text):
    match = re.fullmatch(r"[ \t]*([^ \t+][^ \tdD]*?)[ \t]*([A-Za-z\u00b5\u03bc_]*)[ \t]*", text)
    time, unit = (number(match[1]), unit_named(match[2]) if match[2] else ("s", 1, 1)) if match else (None, None)
    if time is None or time < 0 or not unit or unit[0] != "s":
        raise argparse.ArgumentTypeError(f"'{text}' must be a finite number of 0 or more (s)")
    return time * unit[1] / unit[2]


def _parser():
    parser = argparse.ArgumentParser("stickslip", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("list", help="the data sets")
    one = commands.add_parser("judge", allow_abbrev=False, help="results of your own against a data set")
    one.add_argument("name", nargs="?", metavar="NAME", help="a data set that 'list' names")
    one.add_argument("file", nargs="?", metavar="FILE", help="CSV file with the columns of the data set, - for standard input")
    once = {"action": _Once, "metavar": "FILE"}
    one.add_argument("--manifest", **once, help="CSV file with the columns data_set and file, and events, rows, tolerance and "
                     "level if need be: judges them all")
    one.add_argument("--columns", **{**once, "metavar": "A,B,..."}, help="the names of the columns of FILE, if it has none")
    one.add_argument("--column", action="append", type=_mapping, default=[], metavar="REFERENCE=YOURS[:UNIT]")
    one.add_argument("--tolerance", action="append", type=_tolerance, default=[], metavar="[QUANTITY=]NUMBER")
    one.add_argument("--level", action=_Once, choices=LIMITS, help="agree as well with a scaled error of at most this; strict: by tolerances alone")
    one.add_argument("--rows", **{**once, "metavar": "1:12,15"}, help="the rows of the data set that FILE must have")
    one.add_argument("--until", type=_time, **{**once, "metavar": "S"}, help="compare nothing later")
    one.add_argument("--events", **once, help="changes of contact of the same run")
    for option in ("json", "junit", "badge"):
        one.add_argument("--" + option, **once, help="- for standard output")
    one.add_argument("--quiet", action="store_true", help="print no table")
    return parser


def _jobs(options):
    """Name, file, events, rows, tolerance and level of what is to be judged. The files of a manifest are in its folder or below."""
    if not options.manifest:
        return [(options.name, options.file, options.events, options.rows, "", options.level)]
    folder, known, jobs = pathlib.Path(options.manifest).parent, ("data_set", "file", "events", "rows", "tolerance", "level"), []
    columns, rows, _, places = rows_of(options.manifest, options.manifest)
    for column in columns:
        if column not in known or columns.count(column) > 1:
            raise InputError(f"a column of the manifest is {printable(column)}, but must be one of {', '.join(known)}, and stand once")
    for cells, place in zip(rows, places):
        job = {**dict.fromkeys(known, ""), **dict(zip(columns, cells))}
        if not job["data_set"] or not job["file"]:
            raise InputError(f"{place}: data_set or file is empty, but must be a name")
        for column in ("file", "events"):
            if job[column] == "-" or job[column].startswith("/") or ".." in job[column].split("/"):
                raise InputError(f"{place}: {column} is {printable(job[column])}, but must be a path inside the folder of the manifest")
        jobs.append((job["data_set"], folder / job["file"], folder / job["events"] if job["events"] else None, job["rows"], job["tolerance"],
                     job["level"] or options.level))
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
            cases += [(one.name, one.verdict, f"error {one.error} at {one.where}, tolerance {one.tolerance}, level {one.required_level}")
                      for one in judgement.quantities]
        for case, verdict, message in cases:
            test = ElementTree.SubElement(suite, "testcase", classname=name, name=case)
            if verdict != "agrees":
                ElementTree.SubElement(test, "failure" if verdict == "differs" else "error", type=verdict, message=message)
        ElementTree.SubElement(suite, "system-out").text = refusal or str(judgement)
    for node in (root, *root):
        for key, tag in {"tests": "testcase", "failures": "failure", "errors": "error"}.items():
            node.set(key, str(len(list(node.iter(tag)))))
    return ElementTree.tostring(root, encoding="utf-8", xml_declaration=True).decode() + "\n"


def _badge(results, status):
    """An SVG image: the name and the verdict with its level, or how many files agree, at the least level that is asked for."""
    name, judgement, _ = results[0]
    said = "refused" if judgement is None else judgement.conclusion + (f" ({judgement.level})" if judgement else "")
    if len(results) > 1:
        level = min((j.required_level for _, j, _ in results if j is not None), key=LEVELS.index, default="strict")
        name, said = "stickslip", f"{sum(bool(j) for _, j, _ in results)} of {len(results)} agree" + (f" at level {level}" if level != "strict" else "")
    label = name
    left, right = (10 + 7 * len(text) for text in (label, said))
    label, said = html.escape(label), html.escape(said)
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
    """Writes beside the file and renames, so that nothing half-written stands there. A link is followed, the mode is kept."""
    if file == "-":
        sys.stdout.write(text)
        return
    made = False
    try:
        target = pathlib.Path(os.path.realpath(file))
        is_device = target.exists() and not target.is_file()
        beside = target if is_device else target.with_name(f".{target.name}.stickslip-{os.getpid()}")
        with open(beside, "w" if is_device else "x", encoding="utf-8", newline="\n") as stream:
            made = not is_device
            stream.write(text)
        if made and target.exists():
            shutil.copymode(target, beside)
        if made:
            os.replace(beside, target)
    except OSError as error:
        raise InputError(f"{file}: cannot be written ({error.strerror})") from None
    finally:
        if made:
            beside.unlink(missing_ok=True)


def _judged(options):
    results = []
    for name, file, events, rows, tolerance, level in _jobs(options):
        try:
            judgement = judge(name, file, columns=options.columns, mapping=options.column, until=options.until, level=level,
                              tolerance={**dict(options.tolerance), **tolerances_of(tolerance)}, rows=rows, events=events, is_foreign=bool(options.manifest))
            results.append((printable(name), judgement, None))
        except InputError as error:
            results.append((printable(name), None, str(error)))
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


def _run(arguments):
    parser = _parser()
    options = parser.parse_args(arguments)
    if options.command == "judge":
        single = [name for name in ("name", "file", "events", "columns", "column", "rows", "until") if getattr(options, name) not in (None, [])]
        if options.manifest and single:
            parser.error(f"{single[0]} is given, but --manifest excludes it")
        if not options.manifest and not (options.name and options.file):
            parser.error("judge needs NAME and FILE, or --manifest FILE")
        inputs, outputs = ([file if file == "-" else os.path.realpath(file) for file in files if file] for files in (
            (options.file, options.events, options.manifest), (options.json, options.junit, options.badge)))
        if len({*outputs}) < len(outputs) or {*inputs} & {*outputs} - {"-"} or inputs == ["-", "-"]:
            parser.error("two of the files are one, but an output must be a file of its own, and one input alone can be -")
        return _judged(options)
    print("\n".join(f"{name:30}  {load(name).title}" for name in names()))
    return 0


def main(arguments=None):
    status, sentence = 2, ""
    sys.stdout, sys.stderr = (one or open(os.devnull, encoding="utf-8") for one in (sys.stdout, sys.stderr))  # nobody can write to a closed one
    if hasattr(sys.stdout, "reconfigure"):
        sys.stdout.reconfigure(errors="backslashreplace")
    try:
        try:
            status = _run(arguments)
        finally:
            sys.stdout.flush()
    except InputError as error:
        sentence = str(error)
    except OSError as error:
        sentence = f"standard output: cannot be written ({error.strerror or 'it is closed'})"
        sys.stdout = open(os.devnull, "w", encoding="utf-8")  # Python flushes it again at the end
    except MemoryError:
        sentence = "the memory does not suffice"
    except Exception as error:  # pylint: disable=broad-except
        status, sentence = 1, f"{type(error).__name__}: {printable(error)}. This is a mistake in stickslip itself, not in the input"
    if sentence:
        try:
            print(f"stickslip: {sentence}", file=sys.stderr)
        except OSError:
            pass
    return status


if __name__ == "__main__":
    sys.exit(main())
