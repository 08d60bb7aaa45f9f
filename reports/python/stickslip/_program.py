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

# What the functions of these names say of themselves. Members of an answer end with their units.
COMMANDS = {
    "cases": """The published cases: `cases`, each with `name`, `title` and `file`.

    >>> len(stickslip.cases()["cases"]) > 20
    True
    """,
    "criterion": """Whether stick-slip occurs: `verdict`, `margin`, `force_max_N`, `critical_amplitude_m`, `problem` (all keys of the case, SI).

    >>> stickslip.criterion("paper", amplitude="4 um")["verdict"]
    'stick'
    """,
    "design": """The `margin` over a band of frequencies (Hz), and the `lengths_m` and `axial_forces_N` that stick.

    >>> stickslip.design("paper", band="25:26")["frequency_hz"]
    25.0
    """,
    "map": """The criterion, or the motion by `quantity`, over two parameters, in SI units: `columns` has an array for each.

    >>> stickslip.map("paper", x="frequency=20:30:2", y="amplitude=1e-4:1e-3:2")["columns"]["state"]
    ['stick', 'stick', 'stick', 'stick-slip']
    """,
    "modes": """Natural frequencies: `frequencies_hz` and `relative_error_estimates`; `count`, `state` ("stick" or "slip").

    >>> [round(f, 3) for f in stickslip.modes("paper", count=2)["frequencies_hz"]]
    [24.972, 81.078]
    """,
    "nvh": """What one hears of a motion: `travel_m`, `slips_per_s`, `friction_power_W`, `force_level_dB` (re 1 N); `duration` in s.

    >>> round(stickslip.nvh("squeak-stand", duration=1)["peak_hz"])
    24
    """,
    "periodic": """A periodic motion: `found`, `period_s`, `tip_peak_to_peak_m`, `multipliers`, `verdict`; `settle` in periods.

    >>> stickslip.periodic("damped", settle=50)["period_s"]
    0.04
    """,
    "respond": """A motion in time: `columns` has `time_s`, `tip_displacement_m`, `friction_force_N` and more as arrays; `duration` in s.

    >>> run = stickslip.respond("damped", duration=0.02)
    >>> round(float(max(run["columns"]["time_s"])), 6)
    0.02
    """,
    "squeal": """Steady sliding on a wall that moves at `speed`, m/s: `modes`, each with `critical_speed_m_per_s`, and `cycle`.

    >>> stickslip.squeal("reed", settle=5)["verdict"]
    'unstable'
    """,
    "sweep": """The motion as one parameter rises and falls, in SI units: `columns` has a section of the motion for each value.

    >>> swept = stickslip.sweep("damped", parameter="amplitude=1e-3:2e-3:2", settle=1, periods=1)
    >>> swept["columns"]["direction"]
    ['up', 'up', 'down', 'down']
    """,
    "uncertainty": """The `probability_of_slip` of a case with the table [uncertainty], with its 95 % interval, and `keys` with their indices.

    >>> stickslip.uncertainty("uncertain", samples=100)["valid_samples"]
    100
    """}
USE = """
    A case is a name, a file, or a dict of tables, {"beam": {"length": 2.0, ...}, ...}, as tomllib reads it, in SI units or with texts as
    "2 mm"; a list of cases gives a list of answers. Options are those of `stickslip NAME --help`, and keys of the case have two
    underscores for their point, as beam__length=1.8. Throws ProgramError with the sentence of the program.
"""



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
            value = getattr(value, "tolist", lambda value=value: value)()  # of NumPy
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


def _toml(value):
    value = getattr(value, "tolist", lambda: value)()
    if isinstance(value, dict):
        return "{" + ", ".join(f"{_toml(str(key))} = {_toml(one)}" for key, one in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(_toml, value)) + "]"
    return "inf" if value is None else repr(value) if isinstance(value, float) else json.dumps(value, ensure_ascii=False)


def _texts(value):
    inner = value.values() if isinstance(value, dict) else value if isinstance(value, (list, tuple)) else ()
    return [value] if isinstance(value, str) else [text for one in inner for text in _texts(one)]


def _case_file(case, folder):
    """The case as a file, with links beside it to the files that it names."""
    for name in {text for text in _texts(case) if not {"..", "/"} & {*pathlib.Path(text).parts} and os.path.isfile(text)}:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).symlink_to(os.path.abspath(name))
    file = folder / "case.toml"
    try:
        file.write_text("".join(f"{_toml(str(table))} = {_toml(keys)}\n" for table, keys in case.items()), encoding="utf-8")
    except TypeError as error:
        raise ProgramError(f"the case cannot be written as TOML ({error})") from None
    return file


def function_of(command):
    def function(*cases, **options):
        return run(command, *cases, **options)
    function.__name__ = function.__qualname__ = command
    function.__doc__ = COMMANDS[command] + USE.replace("NAME", command)
    return function


def run(command, *arguments, **options):
    """The answer of `stickslip COMMAND ARGUMENT... --option value... --json`, a dict. `columns` are those of the CSV file of
    respond, map and sweep, as arrays where NumPy is installed.

    An option is named as that of the program, with _ for -, True for a flag, a list for one that repeats: run("modes", "paper",
    count=5). A key of the case has two underscores for its point: criterion("paper", excitation__amplitude="1 mm"). A case may be a
    dict of tables; a list of cases as the first argument gives a list of answers. Throws ProgramError with the sentence of the program.

    >>> stickslip.run("criterion", "paper", excitation__amplitude="1 mm")["verdict"]
    'stick-slip'
    """
    if arguments and isinstance(arguments[0], (list, tuple)):
        return [run(command, one, *arguments[1:], **options) for one in arguments[0]]
    program = os.environ.get("STICKSLIP_PROGRAM") or shutil.which("stickslip")
    if not program:
        raise ProgramError("the program stickslip is not on the PATH, and STICKSLIP_PROGRAM does not name it")
    with tempfile.TemporaryDirectory() as folder:
        table = pathlib.Path(folder) / "table.csv"
        words = [_case_file(one, pathlib.Path(folder)) if isinstance(one, dict) else one for one in arguments]
        output = ["--output", table] if command in ("respond", "map", "sweep") else []
        try:
            done = subprocess.run([program, command, *map(str, words), *_options(options), "--json", *output],
                                  capture_output=True, text=True, encoding="utf-8")
        except OSError as error:
            raise ProgramError(f"{program}: cannot be run ({error.strerror})") from None
        if done.returncode:
            last = (done.stderr.strip().splitlines() or [f"it ended with status {done.returncode}"])[-1]
            raise ProgramError(last.replace(f"{folder}/", ""), done.returncode)
        answer = json.loads(done.stdout)
        return {**answer, "columns": _columns(table.read_text(encoding="utf-8"))} if output else answer
