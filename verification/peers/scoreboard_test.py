#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests of scoreboard.csv, of peers.toml, and of how a verdict becomes a row."""

import csv
import json
import pathlib
import sys
import tempfile
import tomllib
import unittest

sys.dont_write_bytecode = True
import peers

PEERS = tomllib.loads((peers.FOLDER / "peers.toml").read_text())["peer"]
DATA_SETS = {r["name"] for r in json.loads((peers.ROOT / "data/reference/datapackage.json").read_text())["resources"]}


class Scoreboard(unittest.TestCase):
    def test_has_the_rows_of_peers_toml_each_with_a_verdict(self):
        rows = list(csv.DictReader(peers.SCOREBOARD.open()))
        wanted = [(p["code"], problem, run["settings"]) for p, run, problem in peers.all_runs(PEERS)]
        self.assertEqual([(row["code"], row["problem"], row["settings"]) for row in rows], wanted)
        for row in rows:
            with self.subTest(code=row["code"], problem=row["problem"], settings=row["settings"]):
                self.assertEqual(list(row), peers.COLUMNS)
                self.assertIn(row["verdict"], ("agrees", "differs", "undecided", "not run"))
                judged = row["verdict"] != "not run"
                self.assertEqual([judged, judged, not judged],
                                 [bool(row[c]) for c in ("error", "seconds", "note")])

    def test_is_about_data_sets_and_drivers_that_exist(self):
        for peer, _, problem in peers.all_runs(PEERS):
            self.assertIn(problem, DATA_SETS)
            self.assertTrue(any((peers.FOLDER / peer["folder"]).iterdir()), peer["folder"])


class Verdict(unittest.TestCase):
    def test_is_that_of_the_quantity_that_fares_worst(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            (folder / "stickslip").write_text("#!/bin/sh\ncp " + name + "/said.json " + name + "/verdict.json; exit 1\n")
            (folder / "stickslip").chmod(0o755)
            quantity = {"unit": "s", "norm": "absolute", "compared": 47}
            (folder / "said.json").write_text(json.dumps({"verdict": "differs", "quantities": [
                quantity | {"quantity": "time", "error": 9e-5, "tolerance": 1e-4, "verdict": "agrees"},
                quantity | {"quantity": "position", "unit": "m", "error": 2e-5, "tolerance": 1e-5, "verdict": "differs"}]}))
            program, peers.PROGRAM = peers.PROGRAM, folder / "stickslip"
            try:
                self.assertEqual(peers.judge("stick-slip-events", folder), {
                    "verdict": "differs", "quantity": "position", "error": "2e-05 m", "tolerance": "1e-05 m"})
                # A refusal, and a mistake of the program, which leaves no verdict.
                for ending in ("echo 'result.csv: bad' >&2; exit 2", "echo 'internal error' >&2; exit 1", "exit 1"):
                    with self.subTest(ending=ending):
                        (folder / "stickslip").write_text(f"#!/bin/sh\n{ending}\n")
                        with self.assertRaises(peers.CannotRun):
                            peers.judge("stick-slip-events", folder)
            finally:
                peers.PROGRAM = program


if __name__ == "__main__":
    unittest.main()
