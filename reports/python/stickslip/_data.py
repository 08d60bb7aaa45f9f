# SPDX-License-Identifier: MIT
"""The data sets, and results of a user: a file or columns in memory."""
import csv
import difflib
import functools
import gzip
import itertools
import json
import math
import os
import pathlib
import re
import sys
import zlib

LARGEST = 50_000_000  # bytes of a file


class InputError(ValueError):
    """What was given cannot be used. One sentence names the place, the value and what is allowed."""


@functools.lru_cache(maxsize=None)
def package():
    """The folder of the data and their descriptions by name. In a checkout they are those of the repository."""
    here = pathlib.Path(__file__).resolve()
    folder = next(p for p in (here.parent / "reference", here.parents[3] / "data/reference") if p.is_dir())
    return folder, {one["name"]: one for one in json.loads((folder / "datapackage.json").read_bytes())["resources"]}


def names():
    """The names of all data sets."""
    return list(package()[1])


def suggestion(word, known):
    near = difflib.get_close_matches(word, known, 3)
    return f" (did you mean {' or '.join(near)}?)" if near else ""


def array(values):
    """Numbers as a NumPy array where NumPy is installed, else as a list. Words stay a list."""
    try:
        import numpy
    except ImportError:
        return list(values)
    return numpy.array(values) if values and not isinstance(values[0], str) else list(values)


class Table:
    """A data set. table[column] has the numbers (a NumPy array where NumPy is installed) or the words of a column, in SI units.

    name, title, description; problem: what was solved; comparison: how to compare; provenance; columns; units by column;
    half_widths by column, of those that have them: the true value is at most so far from the value; text by column, with all digits.
    """

    def __init__(self, resource, path):
        self.name, self.title, self.description = (resource[key] for key in ("name", "title", "description"))
        self.problem, self.comparison = resource.get("problem"), resource.get("comparison")
        self.provenance, self.key = resource["provenance"], resource["schema"]["primaryKey"]
        fields = resource["schema"]["fields"]
        self.types = {field["name"]: field["type"] for field in fields}
        self.units = {field["name"]: field.get("unit", "") for field in fields}
        self.allowed = {field["name"]: field.get("constraints", {}).get("enum", []) for field in fields}
        with open(path, encoding="utf-8", newline="") as file:
            head, *rows = csv.reader(file)
        self.rows, self.text = len(rows), {name: [row[i] for row in rows] for i, name in enumerate(head)}
        self.cells = {name: text if self.types[name] == "string" else [float(x) if x else math.nan for x in text]
                      for name, text in self.text.items()}
        self.columns = [name for name in head if not name.endswith("_radius")]
        self.half_widths = {name: self[name + "_radius"] for name in head if name + "_radius" in head}

    def __getitem__(self, column):
        return array(self.cells[column])

    def keys(self):
        return self.columns

    def radius(self, column):
        return self.cells.get(column + "_radius") or [0.0] * self.rows

    def __repr__(self):
        return f"<{self.name}: {self.rows} rows of {', '.join(self.columns)}>"


@functools.lru_cache(maxsize=None)
def load(name):
    """The data set of this name, a Table. Throws InputError, with the names that are near, for an unknown one."""
    folder, resources = package()
    if name not in resources:
        raise InputError(f"the data set {name} is unknown{suggestion(name, resources)}; stickslip.names() has all")
    return Table(resources[name], folder / resources[name]["path"])


# --- units: (SI unit, numerator, denominator). Powers of ten divide, so that 25 ms are the double nearest to 0.025.

UNITS = {"rad/s": ("Hz", 1, 2 * math.pi), "deg": ("rad", math.pi, 180), "rad": ("rad", 1, 1), "g": ("m/s^2", 980665, 1e5),
         "%": ("", 1, 1e2), "1": ("", 1, 1), "-": ("", 1, 1), "N/mm": ("N/m", 1e3, 1)}
for _si, _prefixes in {"Hz": "mkM", "s": "mun", "m": "cmun", "N": "mkM", "N/m": "kM", "m/s": "cm", "m/s^2": "m", "J": "m"}.items():
    for _prefix in ["", *_prefixes]:
        UNITS[_prefix + _si] = (_si, {"k": 1e3, "M": 1e6}.get(_prefix, 1), {"c": 1e2, "m": 1e3, "u": 1e6, "n": 1e9}.get(_prefix, 1))


def unit_named(text):
    for sign, plain in {"_per_": "/", "\u00b5": "u", "\u03bc": "u", "\u00b2": "^2", "\u00b0": "deg"}.items():
        text = text.replace(sign, plain, 1)
    return UNITS.get(text)


# --- files and columns of a user

NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([ed][+-]?\d+)?", re.IGNORECASE)
FOREIGN = (b"\x89HDF", b"PK\3\4", b"MATLAB 5.0", b"\x93NUMPY", b"\xff\xfe", b"\xfe\xff", b"PAR1", b"{", b"[{", b"<", b"---", b"*")
OTHER_NAMES = {"phase": "state", "position": "tip_displacement", "time": "t", "t": "time"}  # those of `stickslip respond`


def number(cell, comma=False):
    """The finite number in a cell, perhaps with the exponent of Fortran or a decimal comma; None if there is none."""
    if isinstance(cell, str):
        cell = cell.replace(",", ".") if comma and "." not in cell else cell
        cell = float(cell.lower().replace("d", "e")) if NUMBER.fullmatch(cell) else math.nan
    try:
        return float(cell) if math.isfinite(cell) else None
    except TypeError:
        return None


def _text_of(file, name):
    try:
        if file == "-":
            text = sys.stdin.buffer.read(LARGEST + 1)
        else:
            with open(file, "rb") as stream:
                text = stream.read(LARGEST + 1)
        text = gzip.decompress(text) if text[:2] == b"\x1f\x8b" else text
    except (OSError, EOFError, zlib.error) as error:
        raise InputError(f"{name}: cannot be read ({getattr(error, 'strerror', None) or error})") from None
    if not text or len(text) > LARGEST:
        raise InputError(f"{name}: is {'larger than the %d bytes that are allowed' % LARGEST if text else 'empty'}")
    if text.lstrip(b"\xef\xbb\xbf \t").startswith(FOREIGN) or b"\0" in text:
        raise InputError(f"{name}: is no table in text, in UTF-8, but must be one, as CSV")
    return re.sub('^"?sep=[^\r\n]*', "", text.decode("utf-8", errors="replace").lstrip("\ufeff"))


def _separator(line):
    bare = re.sub('"[^"]*"?', "", line.strip())
    return next((s for s in "\t;, " if s in bare), ",")


def _split(line, separator):
    line = " ".join(line.split()) if separator == " " else line
    return [cell.strip() for cell in next(csv.reader([line], delimiter=separator, skipinitialspace=True, strict=True))]


def _split_names(line):
    """Blanks separate names, but not a name from its unit in brackets."""
    line = re.sub(r"\s+([\[(])", r"\1", line) if _separator(line) == " " else line
    return _split(line, _separator(line))


def _with_units(names, cells, comma):
    """The names with the units of a line below them; None if it has none."""
    bare = [re.sub(r"^\[(.*)\]$|^\((.*)\)$", r"\1\2", cell).strip() for cell in cells]
    are_numbers = any(cell != "1" and number(cell, comma) is not None for cell in bare)
    if are_numbers or len(bare) != len(names) or not any(cell != "1" and unit_named(cell) for cell in bare):
        return None
    return [name if cell in ("", "-", "1") else f"{name} [{cell}]" for name, cell in zip(names, bare)]


def _from_file(file, name, given):
    """Names and columns of a file, whether numbers may have a decimal comma, and the place of each row."""
    lines = [(i, line) for i, line in enumerate(re.split("\r\n|\r|\n", _text_of(file, name)), 1) if line.strip()]
    comments = [line for _, line in itertools.takewhile(lambda one: one[1].lstrip()[0] in "#%", lines)]
    rows = [(i, line) for i, line in lines if line.lstrip()[0] not in "#%"]
    if not rows:
        raise InputError(f"{name}: there is no line with the names of the columns")
    separator, head = _separator(rows[0][1]), rows[0][1]
    comma = separator != ","
    try:
        for at, (i, line) in enumerate(rows):
            rows[at] = i, _split(line, separator)
        above = [_split_names(bare) for bare in (re.sub(r"^[\s#%]*", "", line) for line in comments) if bare]
        are_numbers = [number(cell, comma) is not None for cell in rows[0][1]]
        above = [names for names in above if len(names) == len(are_numbers) <= 2 * sum(are_numbers)]
        if given:
            names = given
        elif above:
            names = (_with_units(above[-2], above[-1], comma) if len(above) > 1 else None) or above[-1]
        elif all(are_numbers):
            raise InputError(f"{name}:{rows[0][0]}: the line is numbers, not the names of the columns (--columns NAME,NAME,... gives "
                             "them)")
        else:
            names, rows = _split_names(head), rows[1:]
            united = rows and _with_units(names, rows[0][1], comma)
            names, rows = (united, rows[1:]) if united else (names, rows)
    except csv.Error:
        raise InputError(f"{name}:{i}: a quote is not closed, or something follows it: {line[:60]}") from None
    foreign = next((one for one in names if "\ufffd" in one), None)
    if foreign:
        raise InputError(f"{name}:{rows[0][0] - 1}: the name of a column, {foreign}, is no text in UTF-8 (Latin-1?), but must be")
    if separator == " " and not given and rows and len(rows[0][1]) == len(names) + 1:
        names = ["", *names]  # R names the rows
    for i, row in rows:
        if len(row) != len(names):
            raise InputError(f"{name}:{i}: the line has {len(row)} cells, but must have {len(names)}, one for each name")
    return names, [[row[k] for _, row in rows] for k in range(len(names))], comma, [f"{name}:{i}" for i, _ in rows]


def _from_memory(data, given):
    described = getattr(getattr(data, "dtype", None), "names", None)  # of a structured array of NumPy
    if described or hasattr(data, "keys"):
        held = {str(name): data[name] for name in described or data.keys()}
    elif given:
        rows = [list(row) for row in data]
        if any(len(row) != len(given) for row in rows):
            raise InputError(f"the data must have {len(given)} values in each row, as there are names")
        held = {name: [row[i] for row in rows] for i, name in enumerate(given)}
    else:
        raise InputError("the data have no names, but need them, as columns=['time', 'position']")
    single = {name for name, values in held.items() if isinstance(values, (str, int, float))}
    sizes = {len(values) for name, values in held.items() if name not in single} or {1}
    if len(sizes) > 1:
        raise InputError(f"the columns of the data have {min(sizes)} to {max(sizes)} values, but must have as many each")
    size = sizes.pop()
    columns = [[values] * size if name in single else list(values) for name, values in held.items()]
    return list(held), columns, False, [f"the data, row {row + 1}" for row in range(size)]


class Results:
    """The columns of a user that a data set has, in its units: cells and text by column, and the place of each row."""

    def __init__(self, reference, data, columns=None):
        self.reference, self.mappings = reference, columns if isinstance(columns, dict) else {}
        given = columns.split(",") if isinstance(columns, str) else [] if self.mappings else list(columns or [])
        is_file = isinstance(data, (str, os.PathLike))
        self.name = ("standard input" if data == "-" else os.fspath(data)) if is_file else "the data"
        self.names, held, comma, self.places = (
            _from_file(data, self.name, given) if is_file else _from_memory(data, given))
        self.rows, self.cells, self.text = len(self.places), {}, {}
        if not self.rows:
            raise InputError(f"{self.name}: the table has no rows, but must have at least one")
        for name in self.mappings:
            if name not in reference.types:
                raise InputError(f"column {name} is unknown{suggestion(name, reference.types)}, but must be one of "
                                 f"{', '.join(reference.types)}")
        is_events = reference.comparison["kind"] == "events"
        needed = {reference.comparison.get("abscissa"), *(("change", "time") if is_events else ())}
        for name in reference.types:
            found = self._find(name)
            is_constant = len(set(reference.text[name])) == 1
            is_key = name in reference.key and not (is_events and name == "index")
            if found:
                self._read(name, held[found[0]], found[1], comma)
            elif is_key and is_constant:
                self.cells[name], self.text[name] = ([of[name][0]] * self.rows for of in (reference.cells, reference.text))
            elif is_key or name in needed:
                self._missing(name)
        compared = [value["field"] for value in reference.comparison["values"]]
        if not any(name in self.cells for name in compared):
            self._missing(compared[0])

    def _missing(self, name):
        raise InputError(f"{self.name}: the column {name} is missing{suggestion(name, self.names)}; there are {', '.join(self.names)} "
                         "(--column REFERENCE=THEIRS says which is which)")

    def _find(self, name):
        """Where a column stands and its unit; None if it is missing. The unit may follow its name."""
        theirs, _, unit = self.mappings.get(name, name).partition(":")
        found, si = [], self.reference.units[name]
        for wanted in [theirs] if name in self.mappings else [name, OTHER_NAMES.get(name)]:
            if found or not wanted:
                continue
            folded = re.escape(wanted.lower()).replace("_", "[ _-]").replace(r"\ ", "[ _-]").replace(r"\-", "[ _-]")
            form = re.compile(rf"\s*{folded}\s*(?:\[(.*)\]|\((.*)\)| / (.*)|[_/](.*))?", re.IGNORECASE)
            for i, header in enumerate(self.names):
                match = form.fullmatch(header)
                own = match and next((group.strip() for group in match.groups() if group is not None), None)
                if match and (match[4] is None or unit_named(own) or own == si):
                    found.append((i, own))
        if len(found) > 1:
            raise InputError(f"{self.name}: the column {theirs} stands twice")
        if not found:
            return self._missing(theirs) if name in self.mappings else None
        own = unit.strip() or found[0][1]
        factor = (si, 1, 1) if own in (None, si) or self.reference.types[name] == "string" else unit_named(own)
        if not factor or factor[0] != si:
            raise InputError(f"{self.name}: the unit of {name} is '{own}', but must be one of "
                             f"{', '.join([one for one, (of, _, _) in UNITS.items() if of == si] or [si])}")
        return found[0][0], factor

    def _read(self, name, column, factor, comma):
        kind, self.text[name] = self.reference.types[name], [str(cell) for cell in column]
        self.cells[name] = cells = []
        allowed = {"string": "a word", "integer": "an integer", "number": "a finite number, as 0.025 or 2.5e-2"}[kind]
        for place, cell in zip(self.places, column):
            value = number(cell, comma) if kind != "string" else cell if isinstance(cell, str) and cell else None
            if value is None or (kind == "integer" and value != math.floor(value)):
                raise InputError(f"{place}: {name} is '{str(cell)[:60]}', but must be {allowed}")
            cells.append(value if kind == "string" else value * factor[1] / factor[2])
