#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""traceability.py SOURCES RESULTS PROGRAMS: checks a whole run of the tests. Each requirement must be served by a test that
passed, and each claim of the paper judged by one. Results older than their test program do not count."""

import sys
import tomllib
from collections import Counter
from pathlib import Path
from xml.etree import ElementTree


def read_toml(file):
    with open(file, "rb") as stream:
        return tomllib.load(stream)


def passed_tests(results, programs):
    """The properties of each test that passed, by name."""
    for file in results.rglob("*.xml"):
        label = file.relative_to(results).parts[0].split(".")[0]
        program = programs / f"stickslip_{label}_tests"
        if not program.exists() or file.stat().st_mtime < program.stat().st_mtime:
            continue
        for test in ElementTree.parse(file).iter("testcase"):
            if test.get("result") == "completed" and test.find("failure") is None:
                yield {one.get("name"): one.get("value") for one in test.iter("property")}


def main():
    sources, results, programs = map(Path, sys.argv[1:])
    tests = list(passed_tests(results, programs))
    served = {test.get("requirement") for test in tests}
    judged = Counter(test["claim"] for test in tests if "claim" in test)
    faults = [
        f"requirement {identifier} is served by no test that passed"
        for identifier, _, _ in read_toml(sources / "verification/requirements.toml")["requirements"]
        if identifier not in served
    ]
    faults += [
        f"claim {claim['id']} is judged by {judged[claim['id']]} tests that passed, but must be judged by one"
        for claim in read_toml(sources / "data/paper/claims.toml")["claim"]
        if judged[claim["id"]] != 1
    ]
    sys.exit("\n".join(faults) or 0)


main()
