# SPDX-License-Identifier: MIT
"""The commands of the program `stickslip`, where it is on the PATH or STICKSLIP_PROGRAM names it."""
import csv
import io
import json
import math
import os
import pathlib
import shutil
import subprocess
import tempfile

from ._data import array, number

COMMANDS = ("cases", "criterion", "design", "map", "modes", "nvh", "periodic", "respond", "squeal", "sweep", "uncertainty")


class ProgramError(RuntimeError):
    """The sentence with which the program refused or failed; `status` is its exit status."""

    def __init__(self, sentence, status=None):
        super().__init__(sentence)
        self.status = status


def _options(options):
    for name, value in options.items():
        if "." in name or "__" in name:
            yield from ("--set", f"{name.replace('__', '.')}={value}")
        elif value is not False and value is not None:
            for one in value if isinstance(value, (list, tuple)) else [value]:
                yield "--" + name.rstrip("_").replace("_", "-")
                if one is not True:
                    yield str(one)


def _columns(text):
    """A map has an empty line between its blocks; an empty cell is no number that was found."""
    rows = [row for row in csv.reader(line for line in io.StringIO(text) if not line.startswith("#")) if row]
    numbers = {name: [number(row[i]) if row[i] else math.nan for row in rows[1:]] for i, name in enumerate(rows[0])}
    return {name: [row[i] for row in rows[1:]] if None in cells else array(cells)
            for i, (name, cells) in enumerate(numbers.items())}


def run(command, *arguments, **options):
    """The answer of `stickslip COMMAND ARGUMENT... --option value... --json`, a dict. `columns` are those of the CSV file of
    respond, map and sweep, as arrays where NumPy is installed.

    An option is named as that of the program, with _ for -, True for a flag, a list for one that repeats: run("modes", "paper",
    count=5). A key of the case has two underscores for its point: criterion("paper", excitation__amplitude="1 mm"). Throws
    ProgramError with the sentence of the program.
    """
    program = os.environ.get("STICKSLIP_PROGRAM") or shutil.which("stickslip")
    if not program:
        raise ProgramError("the program stickslip is not on the PATH, and STICKSLIP_PROGRAM does not name it")
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "table.csv"
        output = ["--output", table] if command in ("respond", "map", "sweep") else []
        try:
            done = subprocess.run([program, command, *map(str, arguments), *_options(options), "--json", *output],
                                  capture_output=True, text=True, encoding="utf-8")
        except OSError as error:
            raise ProgramError(f"{program}: cannot be run ({error.strerror})") from None
        if done.returncode:
            last = (done.stderr.strip().splitlines() or [f"it ended with status {done.returncode}"])[-1]
            raise ProgramError(last, done.returncode)
        answer = json.loads(done.stdout)
        return {**answer, "columns": _columns(table.read_text(encoding="utf-8"))} if output else answer
