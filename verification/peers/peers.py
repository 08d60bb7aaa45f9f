#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Runs other codes on the problems of data/reference, lets `stickslip compare` judge them, and writes scoreboard.csv.

    verification/run --peers                                              all of peers.toml that is not up to date
    verification/run --peers -- --code SciPy --problem stick-             some of it
    verification/run --peers -- --code MuJoCo --problem incline --again   the same rows once more

The codes come from Debian 12 and from npm. They are installed in a folder of their own, build/peers/debian (debootstrap,
chroot), so that nothing on this machine changes; that needs root. Every row is written to scoreboard.csv at once, and a run
that was interrupted goes on after it. A row that did not run is tried again, and a row is made again if its driver, its line
in peers.toml or its data set have changed. The others stay, each with the version of the data, the day and the machine that
it is of. What cannot run is a row "not run" with the reason.

The engines of rigid bodies have two rows for each problem: the usual step, and the best of steps each a quarter of the last. All
steps that fit into FIRST_SECONDS of processor time are tried. After them the steps end with one that agrees, or with two in a
row of which none lowers the error by a tenth, or where the next one would take all of them beyond PATIENCE.

`seconds` is processor time of the whole driver, start-up of the interpreter included and compilation not. `cost` is its
ratio to stickslip with default settings on the same problem, measured just before.
"""

import argparse
import base64
import csv
import datetime
import hashlib
import json
import math
import os
import pathlib
import re
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
COLUMNS = ["code", "version", "problem", "settings", "verdict", "level", "quantity", "error", "tolerance", "ratio", "creep",
           "seconds", "cost", "note", "data", "date", "machine", "fingerprint"]
MIRROR = "http://deb.debian.org/debian"
PAGE = ROOT / "reports" / "manual" / "scoreboard.md"
BEGIN, END = "<!-- the matrices: peers.py writes them -->\n", "<!-- end of the matrices -->\n"
SIGNS = {"strict": "●", "1e-3": "◕", "1e-2": "◑", "1e-1": "◔", "none": "○"}
DRIVEN, BUILT = {}, set()  # times and folders of the runs, and what was compiled, in this process
PATIENCE = 120  # seconds of processor time that a driver may take, and all steps of an engine together
FIRST_SECONDS = 4  # of the steps that are tried in any case
PACKAGE = json.loads((ROOT / "data" / "reference" / "datapackage.json").read_text())
RESOURCES = {resource["name"]: resource for resource in PACKAGE["resources"]}


def read(path):
    with path.open() as file:
        return list(csv.DictReader(file))


# The problems of published-problems have rows of their own; which rows of the data set they are.
PUBLISHED = {}
for number, event in enumerate(read(ROOT / "data" / "reference" / RESOURCES["published-problems"]["path"]), 1):
    PUBLISHED.setdefault(event["problem"], []).append(number)

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


def execute(command, what, patience=PATIENCE, may_fail=False):
    """Runs a command silently; the return value is its processor time in seconds."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (patience, patience))

    before = os.times()
    run = subprocess.run(command, capture_output=True, text=True, errors="replace", preexec_fn=limit)
    after = os.times()
    if run.returncode != 0 and not may_fail:
        lines = [line for line in (run.stderr + run.stdout).splitlines() if line.strip() and "ignoring const" not in line]
        lines = lines or [f"exit code {run.returncode}"]
        reason = f"more than {patience} s" if run.returncode in (137, 152, -9, -24) else \
            next((line for line in lines if line.startswith("error:")), lines[-1]).strip()[:120]
        raise CannotRun(f"{what}: {reason}")
    return after.children_user + after.children_system - before.children_user - before.children_system


def enter(output, *command):
    return ["unshare", "--mount", "--pid", "--fork", "--kill-child", "sh", "-c", ENTER, "sh", DEBIAN, ROOT, output, *command]


def install(packages, npm="", version="", sha512=""):
    """Installs packages of Debian 12, and one of npm, in the folder of the peers; the return value is the version of the latter or of the first.

    Of npm it is the archive of that version and digest. It is unpacked: nothing in it runs, and nothing that it depends on comes with it.
    """
    if not (DEBIAN / ".complete").exists():
        say(f"peers: making {DEBIAN}")
        if os.geteuid() != 0:
            raise CannotRun("only root can make a folder with another Debian and run programs in it")
        execute(["debootstrap", "--force-check-gpg", "--variant=minbase", "bookworm", DEBIAN, MIRROR], "debootstrap")
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
        return install(packages, npm, version, sha512)
    if npm:
        module = DEBIAN / "node_modules" / npm / "package.json"
        if not module.exists() or json.loads(module.read_text())["version"] != version:
            execute(["npm", "pack", "--silent", "--ignore-scripts", "--pack-destination", WORK, f"{npm}@{version}"], "npm")
            archive = WORK / f"{npm.strip('@').replace('/', '-')}-{version}.tgz"
            if base64.b64encode(hashlib.sha512(archive.read_bytes()).digest()).decode() != sha512:
                raise CannotRun(f"npm: the archive {archive.name} is another one than that of peers.toml")
            module.parent.mkdir(parents=True, exist_ok=True)
            execute(["tar", "-xzf", archive, "-C", module.parent, "--strip-components=1", "--no-same-owner"], "tar")
        return version
    return installed[packages[0]].split(":")[-1].split("+")[0].split("-")[0]


def judge(problem, output):
    """What stickslip says about result.csv: verdict, level, the quantity that fares worst, its error and its tolerance."""
    name = "events.csv" if problem.endswith("-events") else "result.csv"
    rows = PUBLISHED.get(problem)
    command = [PROGRAM, "compare", "published-problems" if rows else problem, output / name, "--quiet", "--json",
               output / "verdict.json", "--package", ROOT / "data" / "reference"]
    if (output / "events.csv").exists() and name == "result.csv":
        command += ["--events", output / "events.csv"]
    if rows:
        command += ["--rows", f"{rows[0]}:{rows[-1]}"]
        if re.search(r"nan|inf", (output / name).read_text().partition("\n")[2].replace(problem, ""), re.IGNORECASE):
            return {"verdict": "differs", "level": "none", "quantity": "position", "error": "inf", "tolerance": "1e-06", "note": "diverges"}
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
    row = {"verdict": verdict["verdict"], "level": verdict["level"], "quantity": worst["quantity"],
           "error": f"{worst['error']:.2g} {unit}".strip(), "tolerance": f"{worst['tolerance']:.2g} {unit}".strip()}
    if problem == "incline-stays":  # the block must not move: its mean velocity from 10 to 100 s
        _, early, late = (float(event["position"]) for event in read(output / name))
        row["creep"] = f"{(late - early) / 90:.2g} m/s"
    return row


def fingerprint(peer, run, problem):
    """Of all that decides about a row; without what only says how it is printed."""
    data = RESOURCES["published-problems" if problem in PUBLISHED else problem]
    digest = hashlib.sha1(json.dumps([peer["code"], peer["packages"], peer.get("npm"), peer.get("build"), peer["command"], run,
                                      problem, data["hash"], data["comparison"]], sort_keys=True).encode())
    for pattern in peer.get("files", ["*"]):
        for path in sorted(p for p in (FOLDER / peer["folder"]).glob(pattern) if p.is_file()):
            digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def drive(peer, run, problem):
    """Runs a driver; returns its processor time and the folder with its results."""
    work = WORK / "out" / peer["code"]
    output = work / problem
    output.mkdir(parents=True, exist_ok=True)
    for old in output.glob("*.csv"):
        old.unlink()
    words = peer["command"] + run["arguments"]
    if not peer["packages"]:
        words = [sys.executable, FOLDER / "stickslip" / "run.py", PROGRAM, problem, output, *run["arguments"]]
        return execute(words, "driver"), output
    if peer.get("build") and peer["build"] not in BUILT:
        here = "here" in peer  # with the libraries of this project
        execute(["sh", "-c", peer["build"].format(root=ROOT, out=work)] if here else enter(work, "sh", "-c", peer["build"]), "build")
        BUILT.add(peer["build"])
    seconds = execute(enter(work, *[word.replace("{problem}", problem) for word in words]), "driver")
    return seconds, output


def driven(peer, run, problem):
    """As drive(), but once in this process: one run of a damped history has its events too."""
    key = peer["code"], *run["arguments"], problem
    if key not in DRIVEN:
        DRIVEN[key] = drive(peer, run, problem)
    return DRIVEN[key]


def start_up(peer):
    """Processor time of a driver without a problem, which refuses it."""
    work = WORK / "out" / peer["code"]
    return execute(enter(work, *[word.replace("{problem}", "none") for word in peer["command"]]), "driver", may_fail=True)


def best_of_ladder(peer, run, problem):
    """The row of the step that fares best, and its processor time. The patience is with the work, without the start-up."""
    spent, step, best, least, worse = 0.0, run["ladder"], None, math.inf, 0
    start = start_up(peer)
    while True:
        try:
            seconds, output = drive(peer, run | {"arguments": [repr(step)]}, problem)
        except CannotRun:
            if best is None:
                raise
            return best
        row = judge(problem, output)
        error = float(row["error"].split()[0])
        worse = 0 if error < 0.9 * least else worse + 1
        if best is None or error < least:
            best, least = row | {"seconds": seconds, "note": f"step {step:.2g} s"}, error
        work = max(seconds - start, 0.0)
        spent += work
        step /= 4
        ended = best["verdict"] == "agrees" or worse == 2
        if spent + 4 * work > run["seconds"][not ended]:
            return best


def row_of(peer, run, problem, ours):
    row = dict.fromkeys(COLUMNS, "") | {"code": peer["code"], "problem": problem, "settings": run["settings"],
                                         "verdict": "not run"}
    try:
        if peer["packages"]:
            row["version"] = install(peer["packages"], peer.get("npm", ""), **peer.get("npm_archive", {}))
        if peer["code"] == "stickslip":
            row["version"] = subprocess.run([PROGRAM, "--version"], capture_output=True, text=True).stdout.split()[1]
        if "cannot" in run:
            raise CannotRun(run["cannot"])
        if "ladder" in run:
            row |= best_of_ladder(peer, run, problem)
            seconds = row["seconds"]
        else:
            seconds, output = driven(peer, run, "stick-slip" if problem.startswith("stick-slip") else problem)
            row |= judge(problem, output)
        row["seconds"], usual = f"{seconds:.2g}", ours(problem)
        row["cost"] = f"{seconds / usual:.2g}" if usual else ""
    except CannotRun as reason:
        row["note"] = str(reason)
    return row


def engine(entry, problems):
    """An entry [[engine]] of peers.toml as a [[peer]]."""
    driver, step = entry["driver"], entry["step"]
    native = driver.endswith(".cpp")
    peer = entry | {"folder": "engines", "files": [driver, "engine.hpp" if native else "engine.mjs", "problems.csv"],
                    "packages": entry.get("packages", []) + (["g++"] if native else ["nodejs"])}
    start = ["/out/driver"] if native else ["node", "--liftoff-only", f"/peers/engines/{driver}"]
    peer["command"] = [*start, "{problem}", "/out/{problem}"]
    if native and "here" not in entry:
        peer["build"] = f"g++ -O2 -std=c++17 -o /out/driver /peers/engines/{driver} {entry['libraries']}"
    peer["run"] = []
    for problem in problems:
        if problem in entry["cannot"]:
            peer["run"].append({"problems": [problem], "settings": "none", "cannot": entry["cannot"][problem]})
            continue
        peer["run"].append({"problems": [problem], "settings": f"step {entry['printed_step']}", "arguments": [repr(step)]})
        peer["run"].append({"problems": [problem], "settings": "best step", "arguments": [], "ladder": step, "seconds": [FIRST_SECONDS, PATIENCE]})
    return peer


def load():
    """The codes of peers.toml, in its order."""
    said = tomllib.loads((FOLDER / "peers.toml").read_text())
    problems = list(PUBLISHED) + ["friction-powers"]
    return said["peer"] + [engine(said["all_engines"] | one, problems) for one in said["engine"]]


def all_runs(peers):
    return [(peer, run, problem) for peer in peers for run in peer["run"] for problem in run["problems"]]


def machine():
    names = re.findall(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    return f"{len(names)} x {names[0]}" if names else "unknown"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--code", action="append", default=[], help="only the code of this name; repeatable")
    parser.add_argument("--problem", default="", help="only the problems whose names begin so")
    parser.add_argument("--again", action="store_true", help="also those that are up to date")
    given = parser.parse_args()
    peers = load()
    todo = all_runs(peers)
    for code in given.code:
        if code not in {p["code"] for p in peers}:
            parser.error(f"--code is {code}, but must be one of {', '.join(dict.fromkeys(p['code'] for p in peers))}")
    WORK.mkdir(parents=True, exist_ok=True)
    kept, times = {identity(row): row for row in read(SCOREBOARD)}, {}

    def ours(problem):
        """Processor time of stickslip with its first settings, mean of three runs; None if it has no such problem."""
        if problem not in times:
            found = next(((peer, run) for peer, run, of in todo if peer["code"] == "stickslip" and of == problem and "cannot" not in run), None)
            try:
                times[problem] = sum(drive(*found, problem)[0] for _ in range(3)) / 3 if found else None
            except CannotRun as reason:
                sys.exit(f"peers.py: stickslip cannot run {problem}: {reason}")
        return times[problem]

    for number, (peer, run, problem) in enumerate(todo, 1):
        key, print_ = (peer["code"], problem, run["settings"]), fingerprint(peer, run, problem)
        old = kept.get(key)
        known = old and old["fingerprint"] == print_ and (old["verdict"] != "not run" or "cannot" in run) and not given.again
        if known or peer["code"] not in (given.code or [peer["code"]]) or not problem.startswith(given.problem):
            continue
        say(f"peers: {number} of {len(todo)}: {peer['code']}, {problem}, {run['settings']}")
        kept[key] = row_of(peer, run, problem, ours) | {"data": PACKAGE["version"], "date": str(datetime.date.today()),
                                                        "machine": machine(), "fingerprint": print_}
        rows = [kept[one] for p, r, of in todo if (one := (p["code"], of, r["settings"])) in kept]
        for row in rows:
            row["ratio"] = ratio(row)
        write(SCOREBOARD, COLUMNS, rows)
    write_page()
    return 0


def ratio(row):
    """Error over tolerance, or nothing of a row that did not run."""
    if row["verdict"] == "not run":
        return ""
    error, tolerance = (float(row[column].split()[0]) for column in ("error", "tolerance"))
    return f"{error / tolerance:.2g}" if tolerance > 0 else "inf" if error > 0 else "0"


def matrix(rows, problems):
    """Code by problem, in Markdown: sign of the level and error over tolerance, usual settings first and then the best."""
    creeps = "incline-stays" in problems
    columns = ["code", *problems, *(["creep"] if creeps else []), "data, day"]
    reasons, lines = [], ["| " + " | ".join(columns) + " |", "|" + " --- |" * len(columns)]
    for code in dict.fromkeys(row["code"] for row in rows if row["problem"] in problems):
        own = [row for row in rows if row["code"] == code and row["problem"] in problems]
        cells = []
        for problem in problems:
            those = [row for row in own if row["problem"] == problem]
            ran = [row for row in those if row["verdict"] != "not run"]
            shown = ran[:1] + ([min(ran, key=lambda row: float(row["ratio"]))] if len(ran) > 1 else [])
            cells.append(" → ".join(f"{SIGNS.get(row['level'], '')}\u00a0{row['ratio']}" for row in shown))
            if those and not ran:
                if those[0]["note"] not in reasons:
                    reasons.append(those[0]["note"])
                cells[-1] = f"({reasons.index(those[0]['note']) + 1})"
        creep = " → ".join(dict.fromkeys(row["creep"] for row in own if row["creep"]))
        of = ", ".join(dict.fromkeys(f"{row['data']}, {row['date']}" for row in own))
        lines.append(f"| {code} {own[0]['version']} | " + " | ".join([*cells, *([creep] if creeps else []), of]) + " |")
    return "\n".join(lines) + "\n\n" + "".join(f"({n}) {reason}.\n" for n, reason in enumerate(reasons, 1))


def page_with(text, rows):
    """The page with the matrices of these rows."""
    masses = [*PUBLISHED, "friction-powers"]
    beams = list(dict.fromkeys(row["problem"] for row in rows if row["problem"] not in masses))
    head, tail = text.split(BEGIN)[0], text.split(END)[1]
    return f"{head}{BEGIN}\n{matrix(rows, masses)}\n{matrix(rows, beams)}\n{END}{tail}"


def write_page():
    PAGE.write_text(page_with(PAGE.read_text(), read(SCOREBOARD)))


def identity(row):
    return row["code"], row["problem"], row["settings"]


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
