# SPDX-License-Identifier: MIT
"""The data sets, and results of a user: a file or columns in memory."""
import collections.abc
import csv
import difflib
import functools
import gzip
import io
import json
import math
import os
import pathlib
import re
import zlib

LARGEST, MOST_COLUMNS = 50_000_000, 10_000  # bytes of a file, and of what it holds compressed; cells of a line
UNPRINTABLE = re.compile("[\0-\x1f\x7f-\x9f\ud800-\udfff\ufffe\uffff]")  # bytes that are no UTF-8 are surrogates


def printable(text):
    """The text on one line, of at most 60 bytes: signs of control, what is no UTF-8 and what XML forbids are replaced."""
    line = UNPRINTABLE.sub("?", str(text))
    start = line.encode()[:60].decode(errors="ignore")
    return line if start == line else start + "..."


class InputError(ValueError):
    """What was given cannot be used. One sentence names the place, the value and what is allowed."""

    def __init__(self, sentence):
        super().__init__(UNPRINTABLE.sub("?", sentence))


@functools.lru_cache(maxsize=None)
def package():
    """The folder of the data and their descriptions by name. In a checkout it is a link to data/reference."""
    folder = pathlib.Path(__file__).resolve().parent / "reference"
    return folder, {one["name"]: one for one in json.loads((folder / "datapackage.json").read_bytes())["resources"]}


def names():
    """The names of all data sets.

    >>> "stick-history" in stickslip.names()
    True
    """
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


def load(name):
    """The data set of this name, a Table. Throws InputError, with the names that are near, for an unknown one.

    >>> history = stickslip.load("stick-history")
    >>> history.units["friction_force"], len(history["time"])
    ('N', 1000)
    """
    if name not in names():
        raise InputError(f"the data set {printable(name)} is unknown{suggestion(printable(name), names())}; stickslip.names() has all")
    return _table(name)


@functools.lru_cache(maxsize=None)
def _table(name):
    folder, resources = package()
    return Table(resources[name], folder / resources[name]["path"])


# --- units: (SI unit, numerator, denominator). Powers of ten divide, so that 25 ms are the double nearest to 0.025.

UNITS = {"rad/s": ("Hz", 1, 2 * math.pi), "1/s": ("Hz", 1, 1), "deg": ("rad", math.pi, 180), "rad": ("rad", 1, 1), "N/mm": ("N/m", 1e3, 1),
         "g": ("m/s^2", 980665, 1e5), "%": ("", 1, 1e2), "1": ("", 1, 1), "-": ("", 1, 1), "g/cm^3": ("kg/m^3", 1e3, 1), "N/m^2": ("Pa", 1, 1),
         "N/mm^2": ("Pa", 1e6, 1), "kN/mm^2": ("Pa", 1e9, 1), "cm^2": ("m^2", 1, 1e4), "mm^2": ("m^2", 1, 1e6), "cm^4": ("m^4", 1, 1e8), "mm^4": ("m^4", 1, 1e12)}
for _si, _prefixes in {"Hz": "mkM", "s": "mun", "m": "cmun", "N": "mkM", "N/m": "kM", "m/s": "cm", "m/s^2": "m", "J": "m", "Pa": "kMG", "kg/m^3": "", "s/m": "",
                       "m^2": "", "m^4": ""}.items():
    for _prefix in ["", *_prefixes]:
        UNITS[_prefix + _si] = (_si, {"k": 1e3, "M": 1e6, "G": 1e9}.get(_prefix, 1), {"c": 1e2, "m": 1e3, "u": 1e6, "n": 1e9}.get(_prefix, 1))


def unit_named(text):
    for sign, plain in (("_per_", "/"), ("\u00b5", "u"), ("\u03bc", "u"), ("\u00b2", "^2"), ("\u00b3", "^3"), ("\u2074", "^4"), ("\u00b0", "deg")):
        text = text.replace(sign, plain, 1)
    return UNITS.get(re.sub(r"(?<=[ms])(?=[234]\Z)", "^", text))


# --- files and columns of a user

NUMBER = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([ed][+-]?\d+)?", re.IGNORECASE | re.ASCII)
FOREIGN = (b"\x89HDF", b"PK\3\4", b"MATLAB 5.0", b"\x93NUMPY", b"PAR1", b"{", b"[{", b"<", b"---", b"*")
OTHER_NAMES = {"phase": "state", "position": "tip_displacement", "time": "t", "t": "time"}  # those of `stickslip respond`
BLANKS = " \t"
# A cell at a place of a line, in quotes or not, and what separates it from the next: signs that separate, blanks before, blanks behind quotes.
CELLS = {one: re.compile(rf'{before}*(?:"([^"]*(?:""[^"]*)*)"{behind}|((?!")[^{signs}]*))(?:([{signs}])|\Z)') for one, signs, before, behind in (
    ("\t", "\t", " ", " *"), (";", ";", "[ \t]", "[ \t]*"), (",", ",", "[ \t]", "[ \t]*"), (" ", BLANKS, "[ \t]", ""))}


def number(cell, comma=False):
    """The finite double in a cell; None if there is none, as in one too small, a complex number or a truth value."""
    if isinstance(cell, str):
        cell = cell.replace(",", ".", 1) if comma and "." not in cell else cell
        match = NUMBER.fullmatch(cell)
        cell = float(cell.lower().replace("d", "e")) if match else math.nan
        return cell if math.isfinite(cell) and (cell or not match[1].strip("0.")) else None
    if isinstance(cell, (bool, complex)) or getattr(getattr(cell, "dtype", None), "kind", "") in ("b", "c"):
        return None
    try:
        return float(cell) if math.isfinite(cell) else None
    except (TypeError, ValueError, OverflowError):
        return None


def _text_of(file, name):
    try:
        with open(0 if file == "-" else file, "rb", closefd=file != "-") as stream:
            text = stream.read(LARGEST + 1)
        text = gzip.GzipFile(fileobj=io.BytesIO(text)).read(LARGEST + 1) if text[:2] == b"\x1f\x8b" else text
    except (OSError, EOFError, ValueError, zlib.error) as error:
        raise InputError(f"{name}: cannot be read ({getattr(error, 'strerror', None) or error})") from None
    if not text or len(text) > LARGEST:
        raise InputError(f"{name}: is {'larger than the %d bytes that are allowed' % LARGEST if text else 'empty'}")
    text = text.removeprefix(b"\xef\xbb\xbf")
    if text[:64].lstrip(BLANKS.encode()).startswith(FOREIGN) or text.startswith((b"\xff\xfe", b"\xfe\xff")) or b"\0" in text:
        raise InputError(f"{name}: is no table in text, in UTF-8, but must be one, as CSV")
    return re.sub('^"?sep=[^\r\n]*', "", text.decode(errors="surrogateescape"))


def _separator(line):
    bare = re.sub('"[^"]*"?', "", line.strip(BLANKS))
    return next((s for s in "\t;, " if s in bare), ",")


def _split(line, separator):
    cells, match, line = [], None, line.strip(BLANKS) if separator == " " else line
    while not match or match[3]:
        match = CELLS[separator].match(line, match.end() if match else 0)
        if not match:
            raise csv.Error
        cells.append(match[2].strip(BLANKS) if match[1] is None else match[1].replace('""', '"'))
        if len(cells) > MOST_COLUMNS:
            raise InputError(f"a line has more than the {MOST_COLUMNS} columns that are allowed")
    return cells


def _split_names(line, separator):
    """Blanks separate names, but not a name from its unit in brackets."""
    names = []
    for word in _split(line, separator):
        is_open = names and re.search(r"[\[(]", names[-1]) and not re.search(r"[\])]", names[-1])
        if separator == " " and names and (is_open or word.startswith(("[", "("))):
            word = names.pop() + " " + word
        names.append(word)
    return names


def _with_units(names, cells, comma):
    """The names with the units of a line below them; None if it has none."""
    bare = [cell[1:-1].strip(BLANKS) if (cell[:1], cell[-1:]) in (("[", "]"), ("(", ")")) else cell for cell in cells]
    are_numbers = any(cell != "1" and number(cell, comma) is not None for cell in bare)
    if are_numbers or len(bare) != len(names) or not any(cell != "1" and unit_named(cell) for cell in bare):
        return None
    return [name if cell in ("", "-", "1") else f"{name} [{cell}]" for name, cell in zip(names, bare)]


def _names_above(comments, size, comma):
    """The last comment with as many names as there are cells, or the last but one if the last one holds its units."""
    bare = [line.lstrip(BLANKS + "#%") for line in comments]
    above = [names for names in (_split_names(line, _separator(line)) for line in bare if line) if len(names) == size]
    return (_with_units(above[-2], above[-1], comma) if len(above) > 1 else None) or above[-1] if above else None


def rows_of(file, name, given=None):
    """Names and rows of a file, whether numbers may have a decimal comma, and the number of the line of each row."""
    lines = [(i, line) for i, line in enumerate(re.split("\r\n|\r|\n", _text_of(file, name)), 1) if line.strip(BLANKS)]
    is_row = [line.lstrip(BLANKS)[0] not in "#%" for _, line in lines]
    if True not in is_row:
        raise InputError(f"{name}: there is no line with the names of the columns")
    first = is_row.index(True)
    separator = _separator(lines[first][1])
    rows, comma, names = [], separator != ",", given
    try:
        for i, line in (line for line, is_one in zip(lines, is_row) if is_one):
            rows.append((i, _split(line, separator)))
        (i, line), cells = lines[first], rows[0][1]
        if names is None and 2 * sum(number(cell, comma) is not None for cell in cells) >= len(cells):
            names = _names_above([line for _, line in lines[:first]], len(cells), comma)
        if names is None:
            names, rows = _split_names(line, separator), rows[1:]
            united = rows and _with_units(names, rows[0][1], comma)
            names, rows = (united, rows[1:]) if united else (names, rows)
    except csv.Error:
        raise InputError(f"{name}:{i}: a quote is not closed, or something follows it") from None
    if given is None and any(re.search("[\x80-\x9f\udc80-\udcff]", one) for one in names):
        raise InputError(f"{name}:{i}: the name of a column is no text in UTF-8 (Latin-1?), but must be")
    if all(number(one, comma) is not None for one in names):
        raise InputError(f"{name}:{i}: the line is numbers, not the names of the columns (--columns NAME,NAME,... gives them)")
    if separator == " " and given is None and rows and len(rows[0][1]) == len(names) + 1:
        names = ["", *names]  # R names the rows
    for i, row in rows:
        if len(row) != len(names):
            raise InputError(f"{name}:{i}: the line has {len(row)} cells, but must have {len(names)}, one for each name")
    if not rows:
        raise InputError(f"{name}: the table has no rows, but must have at least one")
    return names, [row for _, row in rows], comma, [f"{name}:{i}" for i, _ in rows]


def _from_memory(data, given):
    described = getattr(getattr(data, "dtype", None), "names", None)  # of a structured array of NumPy
    if described or hasattr(data, "keys"):
        held = {str(name): data[name] for name in described or data.keys()}
    elif given is not None:
        rows = [list(row) for row in data]
        if any(len(row) != len(given) for row in rows):
            raise InputError(f"the data must have {len(given)} values in each row, as there are names")
        held = {name: [row[i] for row in rows] for i, name in enumerate(given)}
    else:
        raise InputError("the data have no names, but need them, as columns=['time', 'position']")
    if any(isinstance(values, (collections.abc.Set, collections.abc.Iterator)) for values in held.values()):
        raise InputError("a column of the data is a set or a generator, but must be a sequence")
    single = {name for name, values in held.items() if isinstance(values, str) or not hasattr(values, "__len__") or getattr(values, "ndim", 1) == 0}
    sizes = {len(values) for name, values in held.items() if name not in single} or {1}
    if len(sizes) > 1:
        raise InputError(f"the columns of the data have {min(sizes)} to {max(sizes)} values, but must have as many each")
    size = sizes.pop()
    if not size:
        raise InputError("the data have no rows, but must have at least one")
    columns = [[values] * size if name in single else list(values) for name, values in held.items()]
    return list(held), list(zip(*columns)), False, [f"the data, row {row + 1}" for row in range(size)]


def folded(name):
    """As names are compared: in lower case (of ASCII), with an underscore for a blank or a hyphen."""
    return re.sub("[A-Z]", lambda letter: letter[0].lower(), name.strip(BLANKS)).replace(" ", "_").replace("-", "_")


def _header(text, name):
    """In a list the unit that a header states if it is of this name, None if it states none; nothing if it is of another name."""
    if folded(text) == folded(name):
        return [None]
    for form in (r"(.*)\[(.*)\]", r"(.*)\((.*)\)", "(.*?) / (.*)"):
        match = re.fullmatch(form, text)
        if match and folded(match[1]) == folded(name):
            return [match[2].strip(BLANKS)]
        if match:
            break
    unit = text[len(name) + 1:]
    is_behind = text[len(name):len(name) + 1] in ("_", "/") and folded(text[:len(name)]) == folded(name) and unit_named(unit)
    return [unit] if is_behind else []


def mappings_of(columns, types):
    """Of {"frequency": "f1:kHz"} or pairs of these: the name and the unit of theirs by the folded name."""
    mappings, known = {}, {folded(name) for name in types}
    try:
        pairs = [(str(reference), str(theirs)) for reference, theirs in (columns.items() if isinstance(columns, dict) else columns)]
    except (TypeError, ValueError):
        raise InputError(f"the mapping of columns is {printable(columns)}, but must be a mapping of names to names") from None
    for reference, theirs in pairs:
        name, colon, unit = theirs.rpartition(":")
        name = (name if colon else theirs).strip(BLANKS)
        if not name:
            raise InputError(f"the column {reference} is '{theirs}', but must be THEIRS or THEIRS:unit, as in f1:kHz")
        if folded(reference) in mappings:
            raise InputError(f"column {reference} is given twice, but must be given once")
        if folded(reference) not in known:
            raise InputError(f"column {reference} is unknown{suggestion(reference, types)}, but must be one of {', '.join(types)}")
        mappings[folded(reference)] = name, unit.strip(BLANKS) if colon else ""
    return mappings


class Results:
    """The columns of a user that a data set has, in its units: cells and text by column, and the place of each row. For `names`, `mappings`
    and `is_foreign` see judge()."""

    def __init__(self, reference, data, names, mappings, is_foreign):
        self.reference, self.mappings, self.is_foreign = reference, mappings, is_foreign
        is_file = isinstance(data, (str, os.PathLike))
        self.name = ("standard input" if data == "-" else os.fspath(data)) if is_file else "the data"
        try:
            self.names, rows, comma, self.places = (rows_of(data, self.name, names) if is_file else _from_memory(data, names))
        except (TypeError, LookupError) as error:
            raise error if is_file else InputError(f"the data cannot be read as columns ({error})") from None
        self.rows, self.cells, self.text = len(self.places), {}, {}
        is_events = reference.comparison["kind"] == "events"
        needed = {reference.comparison.get("abscissa"), *(("change", "time") if is_events else ())}
        for name in reference.types:
            found = self._find(name)
            is_constant = len(set(reference.text[name])) == 1
            is_key = name in reference.key and not (is_events and name == "index")
            if found:
                self._read(name, [row[found[0]] for row in rows], found[1], comma)
            elif is_key and is_constant and name not in needed:
                self.cells[name], self.text[name] = ([of[name][0]] * self.rows for of in (reference.cells, reference.text))
            elif is_key or name in needed:
                self._missing(name)
        compared = [value["field"] for value in reference.comparison["values"]]
        if not any(name in self.cells for name in compared):
            self._missing(compared[0])

    def _missing(self, name):
        there = "" if self.is_foreign else f"{suggestion(name, self.names)}; there are {', '.join(map(printable, self.names))}"
        raise InputError(f"{self.name}: the column {name} is missing{there} (--column REFERENCE=THEIRS says which is which)")

    def _find(self, name):
        """Where a column stands and its unit; None if it is missing. The unit may follow its name."""
        theirs, unit = self.mappings.get(folded(name), (name, ""))
        found, si = [], self.reference.units[name]
        for wanted in [theirs] if folded(name) in self.mappings else [name, OTHER_NAMES.get(name)]:
            if not found and wanted:
                found = [(i, own) for i, header in enumerate(self.names) for own in _header(header, wanted)]
        if len(found) > 1:
            raise InputError(f"{self.name}: the column {theirs} stands twice")
        if not found:
            return self._missing(theirs) if folded(name) in self.mappings else None
        own = unit or found[0][1]
        factor = (si, 1, 1) if own in (None, si) or self.reference.types[name] == "string" else unit_named(own)
        if not factor or factor[0] != si:
            raise InputError(f"{self.name}: the unit of {name} is '{printable(own)}', but must be one of "
                             f"{', '.join([one for one, (of, _, _) in UNITS.items() if of == si] or [si])}")
        return found[0][0], factor

    def _read(self, name, column, factor, comma):
        kind, self.text[name] = self.reference.types[name], [str(cell) for cell in column]
        self.cells[name] = cells = []
        allowed = {"string": "a word", "integer": "an integer", "number": "a finite number that fits a double, as 0.025 or 2.5e-2"}[kind]
        for place, cell in zip(self.places, column):
            if kind == "string":
                value, is_allowed = cell, isinstance(cell, str) and cell and cell == printable(cell)
            else:
                value = number(cell, comma)
                is_allowed = value is not None and not (kind == "integer" and value != math.floor(value))
                value = value * factor[1] / factor[2] if is_allowed else value
            if not is_allowed or value == math.inf or value == -math.inf:
                raise InputError(f"{place}: {name} is '{printable(cell)}', but must be {allowed}")
            cells.append(value)
