#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs other codes on the problems of data/reference, lets `stickslip compare` judge them, and writes scoreboard.csv.

    verification/run --peers                                     all of peers.toml
    verification/run --peers -- --code SciPy --problem stick-    some of it

The codes come from Debian 12. They are installed in a folder of their own, build/peers/debian (debootstrap, chroot), so
that nothing on this machine changes; that needs root. Every row is kept in build/peers/results.csv, and a run that was
interrupted goes on after it. A row that did not run is tried again, and a row is made again if its driver, its line in
peers.toml or the reference data have changed; delete that file after a change of the program. What cannot run is a row "not run"
with the reason.

`seconds` is processor time of the whole driver, start-up of the interpreter included and compilation not. `cost` is its
ratio to stickslip with default settings on the same problem, measured just before.
"""

import argparse
import csv
import hashlib
import json
import math
import os
import pathlib
import resource
import subprocess
import sys
import tomllib

FOLDER = pathlib.Path(__file__).resolve().parent
ROOT = FOLDER.parents[1]
WORK = ROOT / "build" / "peers"
DEBIAN = WORK / "debian"
PROGRAM = ROOT / "build" / "release" / "bin" / "stickslip"
SCOREBOARD = FOLDER / "scoreboard.csv"
COLUMNS = ["code", "version", "problem", "settings", "verdict", "quantity", "error", "tolerance", "seconds", "cost", "note"]
MIRROR = "http://deb.debian.org/debian"
DRIVEN = {}  # times and folders of the runs of this process
PATIENCE = 120  # seconds of processor time that a driver may take

# Sees the drivers, the data and a folder for results, and leaves nothing mounted when it ends or is killed.
ENTER = """
set -e
mount -t proc proc "$1/proc"
mkdir -p "$1/peers" "$1/data" "$1/out"
mount --bind "$2/verification/peers" "$1/peers"
mount --bind "$2/data" "$1/data"
mount --bind "$3" "$1/out"
root=$1
shift 3
exec chroot "$root" env -i PATH=/usr/bin:/bin:/usr/sbin:/sbin HOME=/tmp LC_ALL=C.UTF-8 OMP_NUM_THREADS=1 \
  OPENBLAS_NUM_THREADS=1 DEBIAN_FRONTEND=noninteractive timeout --foreground 7200 "$@"
"""


class CannotRun(Exception):
    pass


def say(text):
    if sys.stderr.isatty():
        print(text, file=sys.stderr, flush=True)


def execute(command, what):
    """Runs a command silently; the return value is its processor time in seconds."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (PATIENCE, PATIENCE))

    before = os.times()
    run = subprocess.run(command, capture_output=True, text=True, errors="replace", preexec_fn=limit)
    after = os.times()
    if run.returncode != 0:
        lines = [line for line in (run.stderr + run.stdout).splitlines() if line.strip() and "ignoring const" not in line]
        lines = lines or [f"exit code {run.returncode}"]
        reason = f"more than {PATIENCE} s" if run.returncode in (137, 152, -9, -24) else \
            next((line for line in lines if line.startswith("error:")), lines[-1]).strip()[:120]
        raise CannotRun(f"{what}: {reason}")
    return after.children_user + after.children_system - before.children_user - before.children_system


def enter(output, *command):
    return ["unshare", "--mount", "--pid", "--fork", "--kill-child", "sh", "-c", ENTER, "sh", DEBIAN, ROOT, output, *command]


def install(packages):
    """Installs packages of Debian 12 in the folder of the peers; the return value is the version of the first."""
    if not (DEBIAN / ".complete").exists():
        say(f"peers: making {DEBIAN}")
        if os.geteuid() != 0:
            raise CannotRun("only root can make a folder with another Debian and run programs in it")
        execute(["debootstrap", "--variant=minbase", "bookworm", DEBIAN, MIRROR], "debootstrap")
        (DEBIAN / ".complete").touch()
    status = (DEBIAN / "var/lib/dpkg/status").read_text()
    installed = {}
    for entry in status.split("\n\n"):
        fields = dict(line.split(": ", 1) for line in entry.splitlines() if ": " in line and not line.startswith(" "))
        if fields.get("Status") == "install ok installed":
            installed[fields["Package"]] = fields["Version"]
    if not set(packages) <= set(installed):
        say(f"peers: installing {' '.join(packages)}")
        execute(enter(WORK, "apt-get", "--quiet", "update"), "apt-get")
        execute(enter(WORK, "apt-get", "--quiet", "--yes", "--no-install-recommends", "install", *packages), "apt-get")
        return install(packages)
    return installed[packages[0]].split(":")[-1].split("+")[0].split("-")[0]


def judge(problem, output):
    """What stickslip says about result.csv: verdict, the quantity that fares worst, its error and its tolerance."""
    name = "events.csv" if problem.endswith("-events") else "result.csv"
    command = [PROGRAM, "compare", problem, output / name, "--quiet", "--json", output / "verdict.json",
               "--package", ROOT / "data" / "reference"]
    if (output / "events.csv").exists() and name == "result.csv":
        command += ["--events", output / "events.csv"]
    (output / "verdict.json").unlink(missing_ok=True)
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode not in (0, 1, 3) or not (output / "verdict.json").exists():
        said = run.stderr.strip().splitlines() or [f"compare: exit code {run.returncode}"]
        raise CannotRun(said[-1].replace(str(output) + "/", "")[:160])
    verdict = json.loads((output / "verdict.json").read_text())
    compared = [q for q in verdict["quantities"] if q["compared"] > 0 or q["verdict"] == "differs"]
    for quantity in compared:
        quantity["error"] = math.inf if quantity["error"] is None else quantity["error"]
    worst = max(compared, key=lambda q: (q["verdict"] == "differs", q["error"] / (q["tolerance"] or 1e-9)))
    unit = worst["unit"] if worst["norm"] == "absolute" else ""
    return {"verdict": verdict["verdict"], "quantity": worst["quantity"],
            "error": f"{worst['error']:.2g} {unit}".strip(), "tolerance": f"{worst['tolerance']:.2g} {unit}".strip()}


def fingerprint(peer, run):
    """Of all that decides about a row; without what only says how it is printed."""
    digest = hashlib.sha1(json.dumps([peer["packages"], peer.get("build"), peer["command"], run], sort_keys=True).encode())
    files = [ROOT / "data" / "reference" / "datapackage.json"]
    for path in files + sorted(p for p in (FOLDER / peer["folder"]).glob("*") if p.is_file()):
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def drive(peer, run, problem):
    """Runs a driver; returns its processor time and the folder with its results."""
    output = WORK / "out" / peer["code"] / problem
    output.mkdir(parents=True, exist_ok=True)
    for old in output.glob("*.csv"):
        old.unlink()
    words = peer["command"] + run["arguments"]
    if not peer["packages"]:
        words = [sys.executable, FOLDER / "stickslip" / "run.py", PROGRAM, problem, output, *run["arguments"]]
        return execute(words, "driver"), output
    if peer.get("build"):
        execute(enter(output, "sh", "-c", peer["build"]), "build")
    seconds = execute(enter(output, *[word.replace("{problem}", problem) for word in words]), "driver")
    return seconds, output


def driven(peer, run, problem):
    """As drive(), but once in this process: one run of a damped history has its events too."""
    key = fingerprint(peer, run), problem
    if key not in DRIVEN:
        DRIVEN[key] = drive(peer, run, problem)
    return DRIVEN[key]


def row_of(peer, run, problem, ours):
    row = dict.fromkeys(COLUMNS, "") | {"code": peer["code"], "problem": problem, "settings": run["settings"],
                                         "verdict": "not run"}
    try:
        if peer["packages"]:
            row["version"] = install(peer["packages"])
        else:
            row["version"] = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True).stdout.split()[1]
        if "cannot" in run:
            raise CannotRun(run["cannot"])
        seconds, output = driven(peer, run, "stick-slip" if problem.startswith("stick-slip") else problem)
        row |= judge(problem, output)
        row["seconds"], usual = f"{seconds:.2g}", ours(problem)
        row["cost"] = f"{seconds / usual:.2g}" if usual else ""
    except CannotRun as reason:
        row["note"] = str(reason)
    return row


def all_runs(peers):
    return [(peer, run, problem) for peer in peers for run in peer["run"] for problem in run["problems"]]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--code", default="", help="only the code of this name")
    parser.add_argument("--problem", default="", help="only the data sets whose names begin so")
    given = parser.parse_args()
    peers = tomllib.loads((FOLDER / "peers.toml").read_text())["peer"]
    todo = all_runs(peers)
    if given.code and given.code not in {p["code"] for p in peers}:
        parser.error(f"--code is {given.code}, but must be one of {', '.join(p['code'] for p in peers)}")
    WORK.mkdir(parents=True, exist_ok=True)
    store, kept, times = WORK / "results.csv", {}, {}
    if store.exists():
        kept = {row["fingerprint"] + row["problem"]: row for row in csv.DictReader(store.open())
                if row["verdict"] != "not run"}  # what failed is tried again

    def ours(problem):
        """Processor time of stickslip with default settings, mean of three runs; None if it has no such problem."""
        if problem not in times:
            peer, run, _ = next(x for x in todo if not x[0]["packages"] and x[2] == problem)
            times[problem] = None if "cannot" in run else sum(drive(peer, run, problem)[0] for _ in range(3)) / 3
        return times[problem]

    for number, (peer, run, problem) in enumerate(todo, 1):
        key = fingerprint(peer, run)
        chosen = given.code in ("", peer["code"]) and problem.startswith(given.problem)
        if key + problem not in kept and chosen:
            say(f"peers: {number} of {len(todo)}: {peer['code']}, {problem}, {run['settings']}")
            kept[key + problem] = {"fingerprint": key} | row_of(peer, run, problem, ours)
            write(store, ["fingerprint", *COLUMNS], kept.values())
    rows = [kept[key] for peer, run, problem in todo if (key := fingerprint(peer, run) + problem) in kept]
    if len(rows) < len(todo):
        say(f"peers: {len(rows)} of {len(todo)} rows are known; {SCOREBOARD.name} is written when all are")
    else:
        write(SCOREBOARD, COLUMNS, rows)
    return 0


def write(path, columns, rows):
    """All or nothing: an interruption leaves the old file."""
    new = path.with_suffix(".new")
    with new.open("w", newline="") as file:
        writer = csv.DictWriter(file, columns, extrasaction="ignore", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    new.replace(path)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
