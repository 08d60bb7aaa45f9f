#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The problems of data/reference with stickslip itself, in the columns of the data sets.

    run.py PROGRAM PROBLEM FOLDER [OPTION...]        the options go to `stickslip modes` or `stickslip respond`
"""

import csv
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]
BEAMS = ("paper", "steel-strip", "soft-short", "near-buckling", "tension")
CASES = {"stick-history": ("paper-figure9", "--duration", "1"),
         "undamped-history-25": ("paper", "--hz", "25", "--amplitude", "1e-3", "--duration", "0.5")}
SAMPLES = {"stick-history": (1000, 1000), "undamped-history-25": (2000, 1000)}  # per second, number


def rows_of(file):
    """The rows of a CSV file of stickslip, which begins with a comment."""
    return csv.DictReader(line for line in open(file) if not line.startswith("#"))


program, problem, folder, options = sys.argv[1], sys.argv[2], sys.argv[3], sys.argv[4:]
with open(f"{folder}/result.csv", "w", newline="") as file:
    out = csv.writer(file)
    if problem.endswith("-frequencies"):
        out.writerow(["beam", "mode", "frequency"])
        shear = {}
        if problem.startswith("timoshenko-"):  # k = 5/6, nu = 0.3
            for row in csv.DictReader(open(ROOT / "data" / "reference" / "beams.csv")):
                stiffness = float(row["area"]) * float(row["youngs_modulus"]) * 5 / 6 / 2.6
                shear[row["beam"]] = ["--set", "beam.axial_force=0", "--set", f"beam.shear_stiffness={stiffness!r}"]
        for beam in ("paper", "steel-strip") if shear else BEAMS:
            command = [program, "modes", beam, "--state", problem.split("-")[-2], "--count", "10", "--json",
                       *shear.get(beam, ()), *options]
            run = subprocess.run(command, check=True, stdout=subprocess.PIPE)
            out.writerows((beam, i, f) for i, f in enumerate(json.loads(run.stdout)["frequencies_hz"], 1))
        sys.exit()
    method = () if "--method" in options else ("--method", "fe")
    command = [program, "respond", *CASES.get(problem, ("damped",)), *method, *options, "--every", "1", "--quiet",
               "--output", f"{folder}/all.csv", "--events", f"{folder}/changes.csv"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    per_second, number = SAMPLES.get(problem, (5000, 2500))
    out.writerow(["time", "phase", "midspan_displacement", "tip_displacement", "friction_force"])
    for row in rows_of(f"{folder}/all.csv"):
        sample = float(row["time_s"]) * per_second
        if abs(sample - round(sample)) < 1e-6 and (sample > 0.5 or problem.startswith("undamped")):
            out.writerow([f"{round(sample) / per_second:.10g}", row["state"].split("-")[0], row["midspan_displacement_m"],
                          row["tip_displacement_m"], row["friction_force_N"]])
if problem.startswith("stick-slip"):
    events = [row for row in rows_of(f"{folder}/changes.csv") if row["change"] != "reversal"]
    for i in range(len(events) - 2, -1, -1):  # a stick shorter than 2e-5 s counts as slip
        if events[i]["change"] == "capture" and float(events[i + 1]["time_s"]) - float(events[i]["time_s"]) < 2e-5:
            del events[i:i + 2]
    with open(f"{folder}/events.csv", "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["time", "change", "position"])
        out.writerows((row["time_s"], row["change"], row["tip_displacement_m"]) for row in events)
