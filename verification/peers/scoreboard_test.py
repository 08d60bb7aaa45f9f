#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests of scoreboard.csv, of peers.toml, of the problems of the engines, and of how a verdict becomes a row.

  scoreboard_test.py PROGRAM
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

sys.dont_write_bytecode = True
import peers

PEERS = peers.load()
ROWS = peers.read(peers.SCOREBOARD)


class Scoreboard(unittest.TestCase):
    def test_has_the_rows_of_peers_toml_each_with_a_verdict(self):
        wanted = [(p["code"], problem, run["settings"]) for p, run, problem in peers.all_runs(PEERS)]
        self.assertEqual([(row["code"], row["problem"], row["settings"]) for row in ROWS], wanted)
        for row in ROWS:
            with self.subTest(code=row["code"], problem=row["problem"], settings=row["settings"]):
                self.assertEqual(list(row), peers.COLUMNS)
                self.assertIn(row["verdict"], ("agrees", "differs", "undecided", "not run"))
                judged = row["verdict"] != "not run"
                noted = not judged or row["settings"] == "best step" or row["error"] == "inf"
                self.assertEqual([judged, judged, noted], [bool(row[c]) for c in ("error", "seconds", "note")])
                self.assertEqual(row["ratio"], peers.ratio(row))
                self.assertEqual(bool(row["creep"]), judged and row["problem"] == "incline-stays")

    def test_says_of_each_row_which_data_it_is_of(self):
        for row in ROWS:
            with self.subTest(code=row["code"], problem=row["problem"], settings=row["settings"]):
                self.assertRegex(row["data"] + " " + row["date"], r"^1\.\d+\.\d+ 20\d\d-\d\d-\d\d$")
                self.assertEqual(row["level"] in peers.SIGNS, row["verdict"] != "not run")
                self.assertNotEqual(row["machine"], "unknown")

    def test_is_on_the_page_of_the_manual(self):
        page = peers.PAGE.read_text()
        self.assertEqual(peers.page_with(page, ROWS), page)

    def test_is_about_data_sets_and_drivers_that_exist(self):
        for peer, _, problem in peers.all_runs(PEERS):
            self.assertTrue(problem in peers.RESOURCES or problem in peers.PUBLISHED, problem)
            self.assertTrue(any((peers.FOLDER / peer["folder"]).iterdir()), peer["folder"])


class OwnRow(unittest.TestCase):
    def test_comes_out_of_its_driver_as_recorded(self):
        recorded = next(row for row in ROWS if row["code"] == "stickslip" and row["problem"] == "stick-history")
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, peers.FOLDER / "stickslip" / "run.py", peers.PROGRAM, "stick-history", folder], check=True)
            row = peers.judge("stick-history", pathlib.Path(folder))
        self.assertEqual(row, {key: recorded[key] for key in row})


class EngineProblems(unittest.TestCase):
    """The numbers of problems.csv, with what follows from them for the events of the reference."""

    def test_are_those_of_the_reference(self):
        events = peers.read(peers.ROOT / "data" / "reference" / peers.RESOURCES["published-problems"]["path"])
        amplitudes = []
        for row in peers.read(peers.FOLDER / "engines" / "problems.csv"):
            name = row.pop("problem")
            p = {key: float(text) for key, text in row.items()}
            along, down = (p["gravity"] * part / math.hypot(1.0, p["slope"]) for part in (p["slope"], 1.0))
            own = [(e["change"], float(e["time"]), float(e["position"])) for e in events if e["problem"] == name]
            with self.subTest(problem=name):
                if name == "friction-powers":
                    amplitudes.append(-p["amplitude"])
                    self.assertEqual((p["friction"] * p["mass"] * down, p["end"]), (1.0, 12.0))
                    continue
                self.assertGreaterEqual(p["end"], own[-1][1])
                if p["stiffness"] == 0.0:
                    stays = p["velocity"] == 0.0 and along < p["friction"] * down
                    for _, t, x in own:
                        self.assertAlmostEqual(x, p["position"] + p["velocity"] * t + (0 if stays else along - p["friction"] * down) * t * t / 2)
                    continue
                # From rest or from the onset to the next turn or stop: free vibration about -+bound/k, and the forced one.
                bound, omega, rate = p["friction"] * p["mass"] * down, math.sqrt(p["stiffness"] / p["mass"]), p["angular_frequency"]
                start, (_, t, x) = 0.0, own[0]
                if own[0][0] == "onset":
                    self.assertAlmostEqual(p["amplitude"] * math.sin(rate * t), bound)
                    start, (_, t, x) = t, own[1]
                forced = p["amplitude"] / (p["stiffness"] - p["mass"] * rate**2)
                middle = math.copysign(bound / p["stiffness"], p["position"] - x)
                cosine = p["position"] - middle - forced * math.sin(rate * start)
                sine = (p["velocity"] - forced * rate * math.cos(rate * start)) / omega
                phase = omega * (t - start)
                self.assertAlmostEqual(x, middle + cosine * math.cos(phase) + sine * math.sin(phase) + forced * math.sin(rate * t), 12)
        powers = peers.read(peers.ROOT / "data" / "reference" / peers.RESOURCES["friction-powers"]["path"])
        self.assertEqual(amplitudes, [float(row["amplitude"]) for row in powers])


class Verdict(unittest.TestCase):
    def test_is_that_of_the_best_step_within_the_patience(self):
        # A step of h takes 1/(800 h) s: 0.125 s, then 0.5, 2, 8, 32 and 128 s.
        for errors, verdict, best, steps in [([32, 16, 8, 4, 2, 1], "differs", 4, 5),  # gains up to 120 s
                                             ([3, 1, 0.95, 0.97, 0, 0], "differs", 2, 4),  # gains too little
                                             ([3, 2, 1, 0, 0, 0], "agrees", 2, 3)]:  # 4 s are used
            driven = []

            def drive(peer, run, problem):
                driven.append(float(run["arguments"][0]))
                return 0.1 + 1 / (800 * driven[-1]), len(driven) - 1

            with mock.patch.object(peers, "start_up", lambda peer: 0.1), mock.patch.object(peers, "drive", drive), \
                    mock.patch.object(peers, "judge", lambda problem, n: {"verdict": verdict, "error": f"{errors[n]} m"}):
                row = peers.best_of_ladder({}, {"ladder": 0.01, "seconds": [4, 120]}, "sdnd100")
            self.assertEqual(row, {"verdict": verdict, "error": f"{errors[best]} m", "note": f"step {0.01 / 4**best:.2g} s", "seconds": 0.1 + 4**best / 8})
            self.assertEqual(len(driven), steps)

    def test_is_that_it_differs_where_the_run_diverges(self):
        with tempfile.TemporaryDirectory() as name:
            (pathlib.Path(name) / "result.csv").write_text("problem,index,change,time,position\nsdnd100,1,reversal,0.03,-nan\n")
            row = peers.judge("sdnd100", pathlib.Path(name))
        self.assertEqual([row["verdict"], row["level"], row["note"], peers.ratio(row)], ["differs", "none", "diverges", "inf"])

    def test_is_that_of_the_quantity_that_fares_worst(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "stickslip").write_text("#!/bin/sh\ncp " + name + "/said.json " + name + "/verdict.json; exit 1\n")
            (folder / "stickslip").chmod(0o755)
            quantity = {"unit": "s", "norm": "absolute", "compared": 47}
            (folder / "said.json").write_text(json.dumps({"verdict": "differs", "level": "1e-2", "quantities": [
                quantity | {"quantity": "time", "error": 9e-5, "tolerance": 1e-4, "verdict": "agrees"},
                quantity | {"quantity": "position", "unit": "m", "error": 2e-5, "tolerance": 1e-5, "verdict": "differs"}]}))
            program, peers.PROGRAM = peers.PROGRAM, folder / "stickslip"
            try:
                self.assertEqual(peers.judge("stick-slip-events", folder), {
                    "verdict": "differs", "level": "1e-2", "quantity": "position", "error": "2e-05 m", "tolerance": "1e-05 m"})
                # A refusal, and a mistake of the program, which leaves no verdict.
                for ending in ("echo 'result.csv: bad' >&2; exit 2", "echo 'internal error' >&2; exit 1", "exit 1"):
                    with self.subTest(ending=ending):
                        (folder / "stickslip").write_text(f"#!/bin/sh\n{ending}\n")
                        with self.assertRaises(peers.CannotRun):
                            peers.judge("stick-slip-events", folder)
            finally:
                peers.PROGRAM = program


if __name__ == "__main__":
    peers.PROGRAM = pathlib.Path(sys.argv.pop())
    unittest.main()
