#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""case_schema_test.py PROGRAM: the JSON Schema of a case file, `stickslip cases --schema`, allows what the program reads and names what it names."""
import copy
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest

import jsonschema

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = pathlib.Path(sys.argv.pop(1)).resolve()


def run(*words):
    done = subprocess.run([PROGRAM, *words], capture_output=True, text=True)
    return done.returncode, done.stdout + done.stderr


class CaseSchema(unittest.TestCase):
    schema = json.loads(run("cases", "--schema")[1])
    judge = jsonschema.Draft7Validator(schema)
    cases = {file.stem: tomllib.loads(file.read_text()) for file in (ROOT / "data/cases").glob("*.toml")}

    def tables(self):
        return {name: table["properties"] for name, table in self.schema["properties"].items()}

    def test_allows_each_published_case_and_template(self):
        jsonschema.Draft7Validator.check_schema(self.schema)
        with tempfile.TemporaryDirectory() as folder:
            for model in ([], ["--model", "mass"], ["--model", "matrices"]):
                file = pathlib.Path(folder) / ("-".join(["case", *model]) + ".toml")
                self.assertEqual(run("new", str(file), *model)[0], 0)
                self.cases[file.stem] = tomllib.loads(file.read_text())
        self.assertGreater(len(self.cases), 20)
        for name, case in self.cases.items():
            with self.subTest(case=name):
                self.judge.validate(case)

    def test_has_the_tables_keys_and_words_of_the_program(self):
        def listed(after, *words):
            said = run("criterion", *words)[1]
            match = re.search(after + r" ([^;\n]*?)\n", said)
            self.assertTrue(match, said)
            return sorted(re.split(r", | or | and ", match[1]))
        unknown = pathlib.Path(tempfile.mkdtemp()) / "case.toml"
        self.addCleanup(lambda: (unknown.unlink(), unknown.parent.rmdir()))
        unknown.write_text("[beams]\n")
        self.assertEqual(listed("has the tables", str(unknown)), sorted(self.tables()))
        for name, keys in self.tables().items():
            if name != "uncertainty":
                self.assertEqual(listed("has the keys", "paper", "--set", f"{name}.foo=1"), sorted(keys))
        motion = self.tables()["excitation"]
        for words, path, *more in ((self.tables()["beam"]["material"], "beam.material='foo'"), (self.tables()["section"]["shape"], "section.shape='foo'"),
                                   (motion["quantity"], "excitation.quantity='foo'", "recorded-mass"),
                                   (motion["shock"]["properties"]["shape"], "excitation.shock={shape='foo', duration=1}", "sdnd106")):
            self.assertEqual(listed("must be one of", *(more or ["paper"]), "--set", path), sorted(words["enum"]))
        unknown.write_text('[uncertainty]\n"beam.length" = { distribution = "foo" }\n')
        words = self.tables()["uncertainty"]["beam.length"]["properties"]["distribution"]["enum"]
        self.assertEqual(listed("must be one of", str(unknown)), sorted(words))

    def test_refuses_a_wrong_type_of_each_key_as_the_program_does(self):
        for name, keys in self.tables().items():
            for key, of in keys.items():
                wrong = "1.5" if of.get("type") in ("boolean", "integer", "string") or "enum" in of else "true"
                case = copy.deepcopy(self.cases["paper"])
                case.setdefault(name, {})[key] = json.loads(wrong)
                self.assertFalse(self.judge.is_valid(case), f"{name}.{key}")
                if name == "uncertainty":
                    continue
                status, said = run("criterion", "paper", "--set", f"{name}.{key}={wrong}")
                self.assertEqual((status, "must be true or false" in said), (2, of.get("type") == "boolean"), said)
                self.assertEqual("must be an integer" in said, name == "numerics" and of.get("type") == "integer", said)
        for wrong in ({"beam": {"lenght": 1}}, {"beams": {}}, {"beam": {"length": "long"}}, {"beam": 1}):
            self.assertFalse(self.judge.is_valid(wrong), wrong)


if __name__ == "__main__":
    unittest.main()
