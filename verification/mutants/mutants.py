#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs the tests against wrong versions of the program, each with one mistake, and counts those that no test notices.

    verification/run --mutants -- --part data --count 30    30 random mistakes in data/
    verification/run --mutants -- --part curated            the engineer's mistakes of curated.toml
    verification/run --mutants -- --part data --survivors   those again that no test has noticed so far

The sources are copied to build/mutants/source and built there once with the preset `mutants`. A mutant changes one
file of the copy: ninja compiles it and links the test programs, and the tests run, those nearest to the file first,
until one fails. Each mutant is a row of build/mutants/results.csv; a run that was interrupted goes on after the last
row, and with that file deleted it begins anew. At the end the row of the part and the seed in
verification/mutants/summary.csv is written.

With --longest 1, tests that take longer than 1 s are left out. That costs a fifth of the time of a survivor, and survivors
can be run again with all tests.

A test that takes ten times as long as usual, and twenty seconds more, counts as one that hangs if it does so twice. On a
busy machine even that may be wrong.

survivors.toml holds the mutants that no test can notice, each with the reason, and those of the last runs that no test
notices yet. mistakes.py makes the mutants.
"""

import argparse
import contextlib
import csv
import fcntl
import hashlib
import json
import os
import pathlib
import re
import resource
import select
import signal
import subprocess
import sys
import time
import tomllib
from dataclasses import dataclass

sys.dont_write_bytecode = True
from mistakes import PARTS, curated_mutants, generated_mutants, part_of

FOLDER = pathlib.Path(__file__).resolve().parent
ROOT = FOLDER.parents[1]
WORK = ROOT / "build" / "mutants"
SOURCE = WORK / "source"
BUILD = SOURCE / "build" / "mutants"
RESULTS = WORK / "results.csv"
COLUMNS = ["id", "part", "seed", "file", "function", "edit", "outcome", "how", "test", "tests_run", "seconds"]
MEMORY = 6 << 30  # bytes that a test program may address
PATIENCE = 20.0  # seconds that a test may take besides ten times as long as usual

# ---------------------------------------------------------------------------------------------------------------------
# The build tree and the tests
# ---------------------------------------------------------------------------------------------------------------------


def copy_sources():
    """Brings the copy of the sources to the state of the working tree; files that are the same keep their time."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=ROOT, check=True,
                            capture_output=True, text=True).stdout.split("\0")
    files = {name for name in listed if name and (ROOT / name).is_file()}
    for name in files:
        target, content = SOURCE / name, (ROOT / name).read_bytes()
        if not target.is_file() or target.read_bytes() != content:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(content)
            target.chmod((ROOT / name).stat().st_mode)
    for path in SOURCE.rglob("*"):
        if path.is_file() and BUILD.parent not in path.parents and str(path.relative_to(SOURCE)) not in files:
            path.unlink()


def limit_resources():
    """For the build as well, which runs the program that a mutant may let hang."""
    for limit, value in ((resource.RLIMIT_AS, MEMORY), (resource.RLIMIT_CPU, 1200), (resource.RLIMIT_CORE, 0)):
        resource.setrlimit(limit, (value, value))


def ninja(jobs, *targets):
    """Builds targets; the return value says whether that worked, and the log what went wrong."""
    with open(WORK / "build.log", "wb") as log:
        command = ["ninja", "-C", BUILD, f"-j{jobs}", *targets]
        return subprocess.run(command, stdout=log, stderr=log, preexec_fn=limit_resources).returncode == 0


def test_programs():
    """The names of the test programs, but for the slow tests."""
    targets = subprocess.run(["ninja", "-C", BUILD, "-t", "targets", "all"], check=True, capture_output=True, text=True)
    programs = re.findall(r"^(bin/stickslip_\w+_tests): ", targets.stdout, re.MULTILINE)
    return sorted(set(programs) - {"bin/stickslip_slow_tests"})


def objects_of(part):
    """The object files of the sources of a part."""
    objects = []
    for entry in json.loads((BUILD / "compile_commands.json").read_text()):
        output = re.search(r" -o (\S+) -c ", entry["command"])[1]
        if any(entry["file"].startswith(f"{SOURCE / f}/") or output.startswith(f"{f}/") for f in PARTS[part][0]):
            objects.append(output)
    return objects


def contents(files):
    return {file: hashlib.sha1((BUILD / file).read_bytes()).digest() for file in files if (BUILD / file).exists()}


@dataclass
class Test:
    program: str
    name: str
    file: str
    seconds: float = 60.0  # until it is known


@dataclass
class Run:
    passed: dict  # seconds by test, skipped tests as well
    failed: list
    how: str = ""  # "", "test", "crash", "timeout"


def list_tests(program):
    """The tests of a program with the source file of each."""
    output = WORK / "tests.json"
    subprocess.run([BUILD / program, "--gtest_list_tests", f"--gtest_output=json:{output}"], check=True,
                   stdout=subprocess.DEVNULL)
    return [Test(program, f"{suite['name']}.{test['name']}", test["file"])
            for suite in json.loads(output.read_text())["testsuites"] for test in suite["testsuite"]]


def run_tests(program, tests, fail_fast):
    """Runs tests of one program, which is killed when one of them takes too long."""
    flags = WORK / "flags"
    flags.write_text("--gtest_filter=" + ":".join(test.name for test in tests) + "\n--gtest_color=no\n")
    command = [BUILD / program, f"--gtest_flagfile={flags}"] + (["--gtest_fail_fast"] if fail_fast else [])
    usual = {test.name: test.seconds for test in tests}
    process = subprocess.Popen(command, cwd=WORK, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                               stdin=subprocess.DEVNULL, start_new_session=True, preexec_fn=limit_resources)
    try:
        return watch(process, usual, fail_fast)
    finally:
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def run_group(tests):
    """Runs tests of one program until one fails. One that takes too long fails only if it does so a second time, alone."""
    program, passed = tests[0].program, {}
    while tests:
        run = run_tests(program, tests, True)
        passed |= run.passed
        hung = [test for test in tests if test.name in run.failed] if run.how == "timeout" else []
        if hung:
            run = run_tests(program, hung, True)
            passed |= run.passed
        if run.failed or not hung:
            return Run(passed, run.failed, run.how)
        tests = [test for test in tests if test.name not in passed]
    return Run(passed, [])


LINE = re.compile(r"\[( RUN      |       OK |  FAILED  |  SKIPPED )\] ([^\s,]+)(?:,.*?)?(?: \((\d+) ms\))?$")


def watch(process, usual, fail_fast):
    """Follows the log of a test program: each test begins with a line and ends with one."""
    run, running, rest = Run({}, []), "", ""
    deadline = time.monotonic() + 60.0
    while True:
        if not select.select([process.stdout], [], [], max(0.0, deadline - time.monotonic()))[0]:
            return Run(run.passed, run.failed + [running or "before the first test"], "timeout")
        block = os.read(process.stdout.fileno(), 65536).decode(errors="replace")
        *lines, rest = (rest + block).split("\n")
        for mark, name, milliseconds in (m.groups() for m in map(LINE.search, lines) if m):
            if mark == " RUN      ":
                running = name
                deadline = time.monotonic() + PATIENCE + 10.0 * usual[name]
            elif name == running:
                running = ""
                deadline = time.monotonic() + 60.0
                if mark == "  FAILED  ":
                    run.failed.append(name)
                    run.how = "test"
                    if fail_fast:
                        return run
                else:
                    run.passed[name] = int(milliseconds or 0) / 1000.0
        if not block:
            break
    if process.wait() != 0 and not run.failed:
        return Run(run.passed, [running or "outside of the tests"], "crash")
    return run


def unmutated_tests():
    """All tests with the seconds that they take; stops where one fails without a mistake."""
    tests = [test for program in test_programs() for test in list_tests(program)]
    programs = contents(sorted({test.program for test in tests} | {"bin/stickslip"}))
    key, record = hashlib.sha1(b"".join(programs.values())).hexdigest(), WORK / "unmutated.json"
    known = json.loads(record.read_text()) if record.exists() else {}
    if known.get("key") != key:
        known = {"key": key, "seconds": {}}
        for program in sorted({test.program for test in tests}):
            run = run_tests(program, [test for test in tests if test.program == program], False)
            if run.failed:
                sys.exit(f"mutants.py: tests fail without a mistake, see to them first: {', '.join(run.failed)}")
            known["seconds"][program] = run.passed
        record.write_text(json.dumps(known))
    for test in tests:
        test.seconds = known["seconds"][test.program].get(test.name, 0.0)
    return tests


def in_order(tests, mutant, killers):
    """Groups of tests of one program each: former killers, those near to the file, to its part, the others, long ones."""
    stem = pathlib.Path(mutant.file).stem.replace("_command", "")
    hints = PARTS[part_of(mutant.file)][1]

    def distance(test):
        path = str(pathlib.PurePath(test.file)).split("verification/tests/")[-1]
        if test.name in killers:
            return 0
        if stem in path:
            return 1
        return 4 if test.seconds > 5.0 else 2 if any(hint in path for hint in hints) else 3

    groups = {}
    for test in tests:
        groups.setdefault((distance(test), test.program), []).append(test)
    return [groups[key] for key in sorted(groups)]


# ---------------------------------------------------------------------------------------------------------------------
# The run
# ---------------------------------------------------------------------------------------------------------------------


def judge(mutant, tests, unmutated, killers, jobs):
    """Builds a mutant and runs tests until one fails: (outcome, how, killing test, tests run)."""
    path, objects = SOURCE / mutant.file, objects_of(part_of(mutant.file))
    original = path.read_text()
    try:
        path.write_text(mutant.text)
        if not ninja(jobs, *objects):
            return "not compiling", "", "", 0
        if all(unmutated[file] == digest for file, digest in contents(objects).items()):
            return "same code", "", "", 0
        count = 0
        for group in in_order(tests, mutant, killers):
            if not ninja(jobs, group[0].program):
                return "killed", "crash", "the build, which runs the program", count
            run = run_group(group)
            count += len(run.passed) + len(run.failed)
            if run.failed:
                return "killed", run.how, run.failed[0], count
        return "survived", "", "", count
    finally:
        path.write_text(original)


def read_rows():
    """The rows of earlier runs by mutant; the last one of a mutant counts."""
    if not RESULTS.exists():
        return {}
    with open(RESULTS, newline="") as file:
        return {row["id"]: row for row in csv.DictReader(file)}


def append_row(row):
    is_new = not RESULTS.exists()
    with open(RESULTS, "a", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        if is_new:
            writer.writeheader()
        writer.writerow(row)


def show(text):
    """One line of progress on a terminal, nothing in a pipe."""
    if sys.stderr.isatty():
        print(f"\r\033[K{text[:os.get_terminal_size(2).columns - 1]}", end="", file=sys.stderr, flush=True)


def face_tests(mutants, count, tests, unmutated, again, jobs):
    """Judges mutants until `count` of them have been built; those judged before are not built again."""
    rows, why, chosen, built = read_rows(), reasons(), [], 0
    for mutant in mutants:
        if built == count:
            break
        row = rows.get(mutant.id)
        if row is None or again and row["outcome"] == "survived" and place_of(row) not in why:
            show(f"{built + 1}/{count} {mutant.file} {mutant.function}: {mutant.edit}")
            killers = {r["test"] for r in rows.values() if r["file"] == mutant.file and r["test"]}
            began = time.monotonic()
            outcome, how, test, tests_run = judge(mutant, tests, unmutated, killers, jobs)
            row = dict(zip(COLUMNS, [mutant.id, mutant.part, mutant.seed, mutant.file, mutant.function, mutant.edit, outcome,
                                     how, test, tests_run, f"{time.monotonic() - began:.0f}"]))
            append_row(row)
            rows[mutant.id] = row
        chosen.append(row)
        built += row["outcome"] in ("killed", "survived")
    show("")
    return chosen


def place_of(entry):
    return entry["file"], entry["function"], entry["edit"]


def reasons():
    """Why a mutant changes nothing that a test could notice, by its place."""
    file = FOLDER / "survivors.toml"
    entries = tomllib.loads(file.read_text()).get("equivalent", []) if file.exists() else []
    return {place_of(entry): entry["why"] for entry in entries}


def summarise(part, seed, longest, rows):
    """Prints what survived and writes the row of the part in the summary."""
    why = reasons()
    survived = [row for row in rows if row["outcome"] == "survived"]
    open_ones = [row for row in survived if place_of(row) not in why]
    for row in open_ones:
        print(f"survived: {row['file']}, {row['function']}: {row['edit']}")
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True).stdout.strip()
    outcomes = [row["outcome"] for row in rows]
    new = {"part": part, "seed": seed, "not_compiling": outcomes.count("not compiling"),
           "same_code": outcomes.count("same code"), "mutants": outcomes.count("killed") + len(survived),
           "killed": outcomes.count("killed"), "equivalent": len(survived) - len(open_ones), "survived": len(open_ones),
           "longest_test": f"{longest:g}" if longest else "", "commit": commit}
    file = FOLDER / "summary.csv"
    runs = [row for row in csv.DictReader(file.open(newline="")) if (row["part"], row["seed"]) != (part, str(seed))]
    with open(file, "w", newline="") as stream:
        writer = csv.DictWriter(stream, list(new), lineterminator="\n")
        writer.writeheader()
        writer.writerows([*runs, new])
    print(f"{part}: {new['mutants']} mutants, {new['killed']} killed, {new['equivalent']} equivalent, "
          f"{new['survived']} survived ({new['not_compiling']} more did not compile, {new['same_code']} were the same code)")


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--part", action="append", choices=[*PARTS, "curated"], help="what to change (default: all parts)")
    parser.add_argument("--count", type=int, default=30, help="mutants of each part (default 30)")
    parser.add_argument("--seed", type=int, default=1, help="which mutants are drawn (default 1)")
    parser.add_argument("--longest", type=float, metavar="S", help="leave out tests that take longer than S seconds")
    parser.add_argument("--survivors", action="store_true", help="run those again that survived earlier and are not equivalent")
    parser.add_argument("--list", action="store_true", help="only print the mutants that would be drawn")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="compilers at a time")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    os.nice(10)
    WORK.mkdir(parents=True, exist_ok=True)
    lock = open(WORK / "lock", "w")
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        sys.exit("mutants.py: another run is at work in build/mutants")
    copy_sources()
    tests, unmutated = [], {}
    if not arguments.list:
        subprocess.run(["cmake", "--preset", "mutants"], cwd=SOURCE, check=True, stdout=subprocess.DEVNULL)
        if not ninja(arguments.jobs, *test_programs()):
            sys.exit(f"mutants.py: the unmutated sources do not build, see {WORK / 'build.log'}")
        tests = [test for test in unmutated_tests() if arguments.longest is None or test.seconds <= arguments.longest]
        unmutated = contents(file for part in PARTS for file in objects_of(part))
    for part in arguments.part or [*PARTS, "curated"]:
        if part == "curated":
            mutants, stale = curated_mutants(SOURCE, FOLDER / "curated.toml")
        else:
            mutants, stale = generated_mutants(SOURCE, part, arguments.seed), []
        print("\n".join(stale), end="\n" if stale else "")
        if arguments.list:
            for mutant in mutants[:arguments.count]:
                print(f"{mutant.id} {mutant.file}, {mutant.function}: {mutant.edit}")
            continue
        count = len(mutants) if part == "curated" else arguments.count
        rows = face_tests(mutants, count, tests, unmutated, arguments.survivors, arguments.jobs)
        summarise(part, "" if part == "curated" else arguments.seed, arguments.longest, rows)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
