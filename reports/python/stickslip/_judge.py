# SPDX-License-Identifier: MIT
"""Judges results against a data set. The rules are those of `stickslip compare`; reports/manual/reference-data.md states them."""
import bisect
import copy
import math
import operator
import re
from collections import Counter, namedtuple
from dataclasses import dataclass, field

from ._data import InputError, Results, load, mappings_of, number, printable

INFINITY = math.inf
RANGE_COVERAGE = 0.9  # the share of a curve that a verdict needs; of a table it needs all rows, or those that are named
LEVELS = ("none", "1e-1", "1e-2", "1e-3", "strict")
LIMITS = {"1e-1": 1e-1, "1e-2": 1e-2, "1e-3": 1e-3, "strict": 0.0}  # the scaled error that a level allows beyond the tolerances
EXIT_STATUS = {"agrees": 0, "differs": 1, "undecided": 3, "partly": 3}


@dataclass
class Quantity:
    """What was found for a compared quantity: of all points the one with the largest error less uncertainty.

    Both are measured by `norm`: relative to the value, to the largest of the column (scale) or to its range, in `unit` (absolute), or
    as a number of rows that differ (word). scaled_error is the largest error beyond the half-width over the largest value, or the
    range, of the column, or the share of words that differ. The level follows from it.
    """
    name: str
    unit: str
    norm: str
    tolerance: float
    own_tolerance: float = 0.0  # of the data set
    required_level: str = "strict"
    verdict: str = "agrees"
    error: float = None
    uncertainty: float = None
    where: str = ""
    compared: int = 0
    undecided: int = 0
    scaled_error: float = 0.0
    is_strict: bool = True
    skipped: Counter = field(default_factory=Counter)
    abscissas: list = field(default_factory=list, repr=False)

    @property
    def level(self):
        """strict: agrees to the tolerance of the data set; else the least of 1e-3, 1e-2 and 1e-1 that the scaled error keeps."""
        scaled = self.error / max(self.compared, 1) if self.norm == "word" else self.scaled_error
        return LEVELS[0 if not self.compared else 4 if self.is_strict else sum(scaled <= LIMITS[one] for one in LEVELS[1:4])]

    def count(self, where):
        """One more that differs, of what is counted."""
        self.where, self.error = self.where if self.error else where, self.error + 1
        self.is_strict = self.error <= self.own_tolerance
        self.verdict = "differs" if self.error > self.tolerance else self.verdict

    def accept_share(self):
        """What is counted agrees as well if the share that is wrong keeps the level that is asked for."""
        if self.required_level != "strict" and self.compared and LEVELS.index(self.level) >= LEVELS.index(self.required_level):
            self.verdict = "undecided" if self.undecided else "agrees"

    def add(self, point, units, where):
        """A point has the abscissa, their value and the reference, each with its half-width; units are those of the norm and the level."""
        abscissa, (theirs, their_width), (reference, width) = point
        if not math.isfinite(reference):
            self.skipped["without a value in the data set"] += 1
            return
        if self.unit == "rad" and self.norm == "absolute":  # right to whole turns
            theirs = reference + math.remainder(theirs - reference, 2 * math.pi)
        distance, unit, limit = abs(theirs - reference), units[0], LIMITS[self.required_level]
        error, uncertainty = distance / unit, (width + their_width) / unit
        scaled = (distance - width - their_width) / units[1]
        self.abscissas.append(abscissa)
        self.compared += 1
        self.scaled_error = max(self.scaled_error, scaled)
        self.is_strict = self.is_strict and uncertainty <= self.own_tolerance and error <= self.own_tolerance + uncertainty
        if error > self.tolerance + uncertainty and scaled > limit:
            self.verdict = "differs"
        elif uncertainty > self.tolerance and (width + their_width) / units[1] > limit:
            self.undecided += 1
            self.verdict = "undecided" if self.verdict == "agrees" else self.verdict
        if self.error is None or error - uncertainty > self.error - self.uncertainty:
            self.error, self.uncertainty, self.where = error, uncertainty, where


def _counted(name, unit="rows", tolerance=0.0):
    return Quantity(name, unit, "word", tolerance, error=0, uncertainty=0.0)


# --- curves given by samples

class Samples:
    """x increases; y has the half-widths r."""

    def __init__(self, points):
        self.x, self.y, self.r = [list(column) for column in zip(*points)] or ([], [], [])
        self._errors = {}

    def at(self, x, coincidence):
        """The sample at x; None if there is none."""
        i = bisect.bisect_left(self.x, x - coincidence)
        return (self.y[i], self.r[i]) if i < len(self.x) and abs(self.x[i] - x) <= coincidence else None

    def gap(self, x):
        i = bisect.bisect_left(self.x, x)
        return self.x[i] - self.x[i - 1] if 0 < i < len(self.x) else INFINITY

    def _polynomial(self, x, points):
        value = half_width = 0.0
        for i in points:
            weight = math.prod((x - self.x[j]) / (self.x[i] - self.x[j]) for j in points if j != i)
            value, half_width = value + weight * self.y[i], half_width + abs(weight) * self.r[i]
        return value, half_width

    def _nearest(self, x, after, count):
        first = min(max(after - count // 2, 0), len(self.x) - count)
        return self._polynomial(x, range(first, first + count))

    def _error_without(self, i):
        """The error with which the cubic through its four neighbours reproduces a sample."""
        if i not in self._errors:
            first = min(max(i - 2, 0), len(self.x) - 5)
            value, _ = self._polynomial(self.x[i], [j for j in range(first, first + 5) if j != i])
            self._errors[i] = abs(value - self.y[i])
        return self._errors[i]

    def roughness(self, x):
        """The largest of these errors, of the eight samples on either side of x."""
        after = min(max(bisect.bisect_left(self.x, x), 1), len(self.x) - 1)
        near = range(max(after - 8, 1), min(after + 8, len(self.x) - 1))
        return INFINITY if len(self.x) < 5 else max(map(self._error_without, near), default=0.0)

    def interpolated(self, x, most_rough=INFINITY):
        """The cubic through four samples. Its half-width has twice the roughness times 4 s (1 - s) at the place s between two samples."""
        size = len(self.x)
        if size < 3:
            return None
        after = min(max(bisect.bisect_left(self.x, x), 1), size - 1)
        value, half_width = self._nearest(x, after, min(4, size))
        if size < 5:
            return value, half_width + abs(value - self._nearest(x, after, 2)[0])
        place = (x - self.x[after - 1]) / (self.x[after] - self.x[after - 1])
        return value, half_width + 8 * place * (1 - place) * min(most_rough, self.roughness(x))


def _compared_samples(reference, theirs, spacing, coincidence):
    """At the samples of the reference that have samples of the user near by, and at the user's that have none of their own near by."""
    near, points, skipped = 1.01 * spacing, [], Counter()
    for x, *sample in zip(reference.x, reference.y, reference.r):
        value = theirs.at(x, coincidence)
        if value is None and theirs.gap(x) <= near:
            value = theirs.interpolated(x, reference.roughness(x))
        rounded = theirs.at(x, 2**-24 * abs(x))  # a time in single precision may mean that of the reference
        if value is not None:
            points.append((x, (value[0], value[1] + (abs(value[0] - rounded[0]) if rounded else 0.0)), sample))
    for i, x in enumerate(theirs.x):
        if reference.at(x, coincidence):
            continue
        around = [b - a for a, b in zip(theirs.x[max(i - 1, 0):i + 1], theirs.x[max(i, 1):i + 2])]
        is_alone = len(theirs.x) < 3 or any(gap > near for gap in around)
        value = reference.interpolated(x) if is_alone and reference.x[0] < x < reference.x[-1] else None
        if value:
            points.append((x, (theirs.y[i], 0.0), value))
        else:
            skipped["between an event and the samples of the phase" if is_alone else "between the samples of the data set"] += 1
    return sorted(points, key=lambda point: point[0]), skipped


# --- sequences of events

class Event(namedtuple("Event", "change time radius row number")):
    def __str__(self):
        return f"event {self.number} ({self.change} at {self.time:.9g} s)"


def _without_short_phases(events, shortest):
    """Of several phases in a row that are too short, one event is left if they change the contact: in their middle."""
    left, i = [], 0
    while i < len(events):
        event, last, j = events[i], i, i + 1
        while event.change != "reversal" and j < len(events) and events[j].time - events[last].time < shortest:
            last, j = (j if events[j].change != "reversal" else last), j + 1
        if last == i or events[last].change == event.change:
            half = 0.5 * (events[last].time - event.time)
            left.append(event._replace(time=event.time + half, radius=event.radius + half))
        i = last + 1
    return left


def _contact(events, t):
    """0 in stick, +1 or -1 in slip, just after the time t."""
    i, sign = bisect.bisect_right([event.time for event in events], t), 1
    while i > 0 and events[i - 1].change == "reversal":
        sign, i = -sign, i - 1
    return sign if events and (events[0].change != "onset" if i == 0 else events[i - 1].change == "onset") else 0


def _match(reference, theirs, horizon, end, tolerance):
    """The alignment of least cost: pairs of indices, missing, extra, and the numbers of those unreached and beyond the horizon.

    A pair of the same change costs the difference of its times, an event without a partner half the mean distance of the events.
    """
    reference = [event for event in reference if event.time <= horizon + tolerance + event.radius]
    usual, last = (0.5 * reference[-1].time / len(reference) if reference else 1.0), min(horizon, end)

    def leaving(event):
        slack = tolerance + event.radius
        return usual if event.time < last - slack else min(usual, slack) if event.time <= last + slack else 0.0
    costs = {(0, 0): (0.0, 0, "")}
    for i in range(len(reference) + 1):
        for j in range(len(theirs) + 1):
            choices = []
            if i and j and reference[i - 1].change == theirs[j - 1].change:
                choices.append((costs[i - 1, j - 1][0] + abs(reference[i - 1].time - theirs[j - 1].time), 0, "pair"))
            if i:
                choices.append((costs[i - 1, j][0] + leaving(reference[i - 1]), 1, "missing"))
            if j:
                choices.append((costs[i, j - 1][0] + (usual if theirs[j - 1].time <= horizon else 0.0), 2, "extra"))
            costs[i, j] = min(choices, default=costs.get((i, j)))
    pairs, missing, extra, unreached, beyond, i, j = [], [], [], 0, 0, len(reference), len(theirs)
    while i or j:
        step = costs[i, j][2]
        i, j = i - (step != "extra"), j - (step != "missing")
        if step == "missing":
            time, slack = reference[i].time, tolerance + reference[i].radius
            unreached += end < time < horizon - slack
            missing += [i] if time < last - slack else []
        elif (reference[i] if step == "pair" else theirs[j]).time > horizon:
            beyond += 1
        elif step == "pair":
            pairs.append((i, j))
        else:
            extra.append(j)
    return pairs[::-1], missing[::-1], extra[::-1], unreached, beyond


# --- the comparison

class _Comparison:
    def __init__(self, reference, theirs, tolerances, level, until, rows, of_events, their_events):
        self.reference, self.theirs, self.until, self.tolerances, self.level = reference, theirs, until, tolerances, level
        self.of_events, self.their_events = of_events, their_events
        self.rule, self.kind, key = reference.comparison, reference.comparison["kind"], reference.key
        self.own_horizon = self.rule.get("horizon", INFINITY)
        self.horizon = min(self.own_horizon, INFINITY if until is None else until)
        self.remarks, self.coverage, self.required = [], 1.0, 1.0 if self.kind == "table" else RANGE_COVERAGE
        self.needed, self.present = rows or set(range(reference.rows)), []
        if self.kind == "table":
            self.abscissa = next((name for name in reversed(key) if reference.types[name] != "string"), "")
        else:
            self.abscissa = self.rule.get("abscissa", "time")
        self.group_columns = [name for name in key if name != self.abscissa and (self.kind == "table" or name != "index")]
        self.rules = {value["field"]: value for value in self.rule["values"]}
        for name, tolerance in tolerances.items():
            if name and name not in self.rules:
                raise InputError(f"the tolerance of {name} is given, but it must be of one of {', '.join(self.rules)}")
        if until is not None and reference.units.get(self.abscissa) != "s":
            raise InputError(f"a latest time is given, but the data set {reference.name} is not one in time")
        if self.kind == "table":  # the words that may stand in a column are compared
            words = [name for name, allowed in reference.allowed.items() if allowed and name not in key]
            self.rules = {**{name: {"field": name, "norm": "word", "tolerance": 0.0} for name in words}, **self.rules}
        self.quantities = [Quantity(name, reference.units[name] or "", value["norm"], self._tolerance(value), value["tolerance"])
                           if value["norm"] != "word" else _counted(name, tolerance=self._tolerance(value))
                           for name, value in self.rules.items() if name in theirs.cells]
        for quantity in self.quantities:
            quantity.required_level = self._required_level(quantity)
        self.remarks += [f"{name} is not in the file and was not compared" for name in self.rules if name not in theirs.cells]
        self._use_known_keys()
        self._require_order(reference, theirs, self.kind, self.abscissa, self.group_columns)
        if their_events is not None:
            self._require_order(of_events, their_events, "events", "time", [name for name in of_events.key if name != "index"])
        self.groups = self._find_groups()
        if rows and self.kind != "table" and len(self.groups) == 1:
            raise InputError(f"rows are given, but the data set {reference.name} is one sequence or curve")

    def _tolerance(self, value):
        general = value["tolerance"] if value["norm"] == "word" else self.tolerances.get("", value["tolerance"])
        return self.tolerances.get(value["field"], general)

    def _required_level(self, quantity):
        """Of what is counted one tolerance for all says nothing."""
        has_own = quantity.name in self.tolerances or (quantity.norm != "word" and "" in self.tolerances)
        return "strict" if has_own else self.level

    # --- keys and rows

    def _use_known_keys(self):
        """Keys of the user become those of the data set: the only one within 1e-6 (single precision), or the nearest within 1e-9."""
        self.reference = copy.copy(self.reference)
        self.reference.cells = dict(self.reference.cells)
        for name in self.reference.key:
            if name == self.rule.get("abscissa") or name not in self.theirs.cells or self.reference.types[name] == "string":
                continue
            known, cells = [], self.theirs.cells[name]
            for one in sorted(set(self.reference.cells[name])):  # of two beams they may differ in the last digit
                if not known or one - known[-1] > 1e-9 * abs(one):
                    known.append(one)
            self.reference.cells[name] = [known[bisect.bisect_right(known, one) - 1] for one in self.reference.cells[name]]
            for row, key in enumerate(cells):
                near = known[bisect.bisect_left(known, key - 1e-6 * abs(key)):bisect.bisect_right(known, key + 1e-6 * abs(key))]
                same = [one for one in near if len(near) == 1 or abs(one - key) <= 1e-9 * max(abs(one), abs(key))]
                cells[row] = min(same, key=lambda one, key=key: abs(one - key), default=key)

    @staticmethod
    def _label(table, columns, row):
        return ", ".join(f"{name} = {table.text[name][row]}" for name in columns)

    def _find_groups(self):
        """The label, the rows of the reference and those of the user of each curve, sequence or part of a table."""
        groups, columns = {}, self.group_columns
        for row in range(self.reference.rows):
            groups.setdefault(tuple(self.reference.cells[name][row] for name in columns), ([], []))[0].append(row)
        for row in range(self.theirs.rows):
            key = tuple(self.theirs.cells[name][row] for name in columns)
            if key not in groups:
                self._refuse_unknown(columns, row)
            groups[key][1].append(row)
        return [("" if len(groups) == 1 else self._label(self.reference, columns, rows[0]), rows, theirs)
                for rows, theirs in groups.values()]

    def _refuse_unknown(self, columns, row):
        raise InputError(f"{self.theirs.places[row]}: {self._label(self.theirs, columns, row)} is not in the data set "
                         f"{self.reference.name}")

    def _require_order(self, reference, theirs, kind, abscissa, group_columns):
        """The abscissa does not decrease in a curve or a sequence; a key stands once in a table."""
        before, is_table, seen = {}, kind == "table", {}
        numbered = reference.key if is_table or "index" in theirs.cells else []
        for row in range(theirs.rows):
            key = tuple(theirs.cells[name][row] for name in numbered)
            if numbered and kind in ("table", "events") and seen.setdefault(key, row) != row:
                raise InputError(f"{theirs.places[row]}: {self._label(theirs, numbered, row)} stands in "
                                 f"{theirs.places[seen[key]]} already, but must stand once")
            group = tuple(theirs.cells[name][row] for name in group_columns)
            value = 0.0 if is_table else theirs.cells[abscissa][row]
            if value < before.get(group, -INFINITY):
                raise InputError(f"{theirs.places[row]}: {abscissa} is {value:g}, but must not be below {before[group]:g} of "
                                 "the row before")
            before[group] = value

    def _begun(self):
        """The groups of which the results have rows."""
        for label, rows, theirs in self.groups:
            if theirs:
                self.present += rows
                yield label, rows, theirs
            else:
                self.remarks.append(f"{label} is not in the file and was not compared")
                self.coverage = 0.0 if self.needed & set(rows) else self.coverage

    # --- norms

    def _scale(self, name, norm, rows):
        """The largest value or the range in these rows; if that is 0, in the whole column; else 1. Up to the horizon only."""
        for some in (rows, range(self.reference.rows)):
            values = [self.reference.cells[name][row] for row in some
                      if self.kind == "table" or self.reference.cells[self.abscissa][row] <= self.own_horizon]
            values = [value for value in values if math.isfinite(value)] or [0.0]
            extent = max(values) - min(values) if norm == "range" else max(map(abs, values))
            if extent > 0:
                return extent
        return 1.0

    def _units(self, name, norm, rows):
        """The units of the norm and of the level, for each value of the reference."""
        scale, level = self._scale(name, norm, rows), self._scale(name, "range" if norm == "range" else "scale", rows)
        return lambda reference: (abs(reference) if norm == "relative" and reference else 1.0 if norm == "absolute" else scale, level)

    def _skip(self, reason, times=1):
        for quantity in self.quantities:
            quantity.skipped[reason] += times

    def _where(self, label, x):
        return f"{self.abscissa} = {x:.9g} {self.reference.units[self.abscissa]}".rstrip() + (f", {label}" if label else "")

    # --- rows

    def _compare_pairs(self, rows, pairs, where):
        """A pair: row of the reference, row of the user, and the time of an event with its half-width."""
        for quantity in self.quantities:
            name, values, radius = quantity.name, self.reference.cells[quantity.name], self.reference.radius(quantity.name)
            if quantity.norm == "word":
                self._compare_words(quantity, rows, pairs, where)
                continue
            units = self._units(name, quantity.norm, rows)
            for row, their_row, time in pairs:
                theirs = time if time and name == "time" else (self.theirs.cells[name][their_row], 0.0)
                quantity.add((row, theirs, (values[row], radius[row])), units(values[row]), where(row))

    def _compare_words(self, quantity, rows, pairs, where):
        words, deciding = self.reference.cells[quantity.name], self.rules[quantity.name].get("decided_by")
        for row, their_row, _ in pairs:
            theirs = self.theirs.cells[quantity.name][their_row]
            if theirs not in words:
                raise InputError(f"{self.theirs.places[their_row]}: {quantity.name} is '{theirs}', but must be one of "
                                 f"{', '.join(sorted(set(words)))}")
            if deciding:
                name, value = deciding["field"], self.reference.cells[deciding["field"]][row]
                unit = self._units(name, self.rules[name]["norm"], rows)(value)[0]
                near = self._tolerance(self.rules[name]) * unit + self.reference.radius(name)[row]
                if abs(value - deciding["threshold"]) <= near:
                    quantity.skipped["too near to the threshold, where a mesh may decide otherwise"] += 1
                    continue
            quantity.compared += 1
            if theirs != words[row]:
                quantity.count(f"{where(row)} ({words[row]} in the data set)")

    def table(self):
        key = self.reference.key
        known = {tuple(self.reference.cells[name][row] for name in key): row for row in range(self.reference.rows)}
        for _, rows, theirs in self.groups:
            pairs = [(known.get(tuple(self.theirs.cells[name][row] for name in key)), row, None) for row in theirs]
            for row, their_row, _ in pairs:
                if row is None:
                    self._refuse_unknown(key, their_row)
            self._compare_pairs(rows, pairs, lambda row: self._label(self.reference, key, row))
            self.present += [row for row, *_ in pairs]
        missing = [self._label(self.reference, key, row) for row in sorted(set(range(self.reference.rows)) - set(self.present))]
        if missing:
            self.remarks.append(f"{len(missing)} of {self.reference.rows} rows of the data set are not in the file: "
                                + "; ".join(missing[:5]) + (f" and {len(missing) - 5} more" if len(missing) > 5 else ""))
        self.coverage = len(self.needed & set(self.present)) / len(self.needed)

    # --- curves

    def _comparable(self, theirs, first, last, coincidence):
        """The rows of the user up to the horizon and in the range of the data set."""
        rows = []
        for row in theirs:
            x = self.theirs.cells[self.abscissa][row]
            if x > self.horizon:
                self._skip("beyond the horizon")
            elif not first - coincidence <= x <= last + coincidence:
                self._skip("outside the range of the data set")
            else:
                rows.append(row)
        return rows

    def _their_samples(self, quantity, rows, units):
        """Without a second one at the same abscissa."""
        points, x, y = [], self.theirs.cells[self.abscissa], self.theirs.cells[quantity.name]
        for row in rows:
            if not points or points[-1][0] != x[row]:
                points.append((x[row], y[row], 0.0))
            elif self.kind == "curve" and abs(y[row] - points[-1][1]) > max(
                    quantity.tolerance * units(y[row])[0], LIMITS[quantity.required_level] * units(y[row])[1]):
                raise InputError(f"{self.theirs.places[row]}: {self.abscissa} is {x[row]:g} as in the row before, but {quantity.name} is "
                                 f"{points[-1][1]:g} there and {y[row]:g} here")
        return Samples(points)

    def _compare_curves(self, label, rows, theirs, parts_of=lambda rows, theirs, *grid: [(rows, theirs)]):
        """parts_of() splits the rows of both sides into curves that are smooth."""
        x = self.reference.cells[self.abscissa]
        first, last, before = x[rows[0]], x[rows[-1]], [quantity.compared for quantity in self.quantities]
        spacing, coincidence = (last - first) / max(1, len(rows) - 1), 1e-9 * (last - first)
        parts = parts_of(rows, self._comparable(theirs, first, last, coincidence), coincidence)
        for quantity, done in zip(self.quantities, before):
            radius, units = self.reference.radius(quantity.name), self._units(quantity.name, quantity.norm, rows)
            for part, their_part in parts:
                if not their_part:
                    continue
                samples = Samples((x[row], self.reference.cells[quantity.name][row], radius[row]) for row in part)
                points, skipped = _compared_samples(samples, self._their_samples(quantity, their_part, units), spacing, coincidence)
                quantity.skipped += skipped
                for point in points:
                    quantity.add(point, units(point[2][0]), self._where(label, point[0]))
            # The share of the range with points. A point covers a fortieth of the range on either side of it.
            covered, end, latest = 0.0, first, min(last, self.horizon)
            for at in quantity.abscissas[done:]:
                begin = max(end, at - (latest - first) / 40)
                end = max(end, min(latest, at + (latest - first) / 40))
                covered += max(0.0, end - begin)
            self.coverage = min(self.coverage, covered / (latest - first)) if latest > first else self.coverage

    def curve(self):
        for label, rows, theirs in self._begun():
            self._compare_curves(label, rows, theirs)

    # --- events

    @staticmethod
    def _changes(table, rows, allowed=()):
        """The events in these rows, without grazing contacts, which change nothing."""
        allowed, events = ["onset", "capture", "reversal", "graze"] + ["state"] * ("state" in allowed), []
        for row in rows:
            change = table.cells["change"][row]
            if change not in allowed and hasattr(table, "places"):
                raise InputError(f"{table.places[row]}: change is '{change}', but must be one of {', '.join(allowed)}")
            if change != "graze":
                radius = 0.0 if hasattr(table, "places") else table.radius("time")[row]
                events.append(Event(change, table.cells["time"][row], radius, row, len(events) + 1))
        return events

    def _both_changes(self, reference, rows, theirs, their_rows):
        """Without short phases. A data set that leaves them out takes a reversal for one if it has none."""
        shortest = reference.comparison.get("shortest_phase", 0.0)
        events = _without_short_phases(self._changes(reference, rows, reference.allowed["change"]), shortest)
        mine = self._changes(theirs, their_rows, reference.allowed["change"])
        if shortest > 0 and all(event.change != "reversal" for event in events):
            mine = [event for event in mine if event.change != "reversal"]
        return events, _without_short_phases(mine, shortest)

    def _aligned(self, rule, events, theirs, end):
        """The alignment, and the tolerance of a time, s; it may be relative to the latest one that is compared."""
        value = next(value for value in rule["values"] if value["field"] == "time")
        tolerance = self._tolerance(value) if rule is self.rule else value["tolerance"]
        if value["norm"] != "absolute":
            tolerance *= min(self.horizon, events[-1].time) if events else 0.0
        return _match(events, theirs, self.horizon, end, tolerance), tolerance

    def _note(self, sequence, label, found, events, theirs):
        pairs, missing, extra, unreached, _ = found
        sequence.compared += len(pairs) + len(missing) + unreached
        for note in ([f"{events[i]} is missing in the file" for i in missing]
                     + [f"{theirs[j]} of the file is not in the data set" for j in extra]):
            sequence.count(note)
            self.remarks.append((label + ": " if label else "") + note)

    def events(self):
        sequence = _counted("sequence", "events")
        for label, rows, their_rows in self._begun():
            events, theirs = self._both_changes(self.reference, rows, self.theirs, their_rows)
            end = INFINITY if self.until is not None else self.theirs.cells["time"][their_rows[-1]]
            found, _ = self._aligned(self.rule, events, theirs, end)
            pairs, _, extra, unreached, beyond = found
            self._note(sequence, label, found, events, theirs)
            if unreached:
                sequence.undecided, sequence.where = sequence.undecided + unreached, sequence.where or "the end of the file"
                sequence.verdict = "undecided" if sequence.verdict == "agrees" else sequence.verdict
                self.coverage = min(self.coverage, end / [event.time for event in events if event.time <= self.horizon][-1])
                self.remarks.append(f"{label + ': ' if label else ''}the file ends at {end:.9g} s, and the data set has {unreached} more "
                                    "events; --until says how far your run goes")
            named = {event.row: str(event) + (", " + label if label else "") for event in events}
            self._compare_pairs(rows, [(events[i].row, theirs[j].row, (theirs[j].time, theirs[j].radius)) for i, j in pairs],
                                named.__getitem__)
            self._skip("beyond the horizon", beyond)
            self._skip("without an event of the data set", len(extra))
        self.quantities.insert(0, sequence)

    # --- phases

    def phases(self):
        phase, sequence = _counted("phase", "samples"), _counted("sequence", "events")
        for label, rows, their_rows in self._begun():
            known, table = self.their_events is not None, self.of_events
            events, theirs = self._both_changes(table, range(table.rows), self.their_events or table,
                                                range(self.their_events.rows if known else 0))
            end = self.theirs.cells[self.abscissa][their_rows[-1]]
            found, guard = self._aligned(table.comparison, events, theirs, end)
            windows = [(event.time - event.radius, event.time + event.radius) for event in events]
            for i, j in found[0]:
                times = theirs[j].time - theirs[j].radius, theirs[j].time + theirs[j].radius
                windows[i] = min(windows[i][0], times[0]), max(windows[i][1], times[1])
            if known:
                self._note(sequence, label, (*found[:3], 0, 0), events, theirs)  # the coverage of the history tells the rest

            def split(rows, their_rows, coincidence):
                return self._by_phase(label, rows, their_rows, coincidence, events, theirs if known else None, windows, guard, phase)
            self._compare_curves(label, rows, their_rows, split)
        self.quantities[:0] = [sequence] * known + [phase] * ("phase" in self.theirs.cells)

    def _by_phase(self, label, rows, their_rows, coincidence, events, theirs, windows, guard, phase):
        """For each phase the certain rows of the reference, and the user's rows in it that are not next to an event."""
        times, x, their_x = [event.time for event in events], self.reference.cells[self.abscissa], self.theirs.cells[self.abscissa]
        parts = [([], []) for _ in range(len(events) + 1)]
        for row in rows:
            if all(abs(x[row] - event.time) > event.radius for event in events):
                parts[bisect.bisect_right(times, x[row])][0].append(row)
        shortest = min((b - a for a, b in zip(times, times[1:])), default=INFINITY)
        for i, row in enumerate(their_rows):
            t, (samples, chosen) = their_x[row], parts[bisect.bisect_right(times, their_x[row])]
            steps = [their_x[b] - their_x[a] for a, b in zip(their_rows[max(i - 1, 0):i + 1], their_rows[max(i, 1):i + 2])]
            reach = max(guard, min(shortest, max(steps, default=0.0))) if theirs is None else 0.0
            if any(begin - reach <= t <= end + reach for begin, end in windows):
                self._skip("between the two times of an event, or next to it")
            elif theirs is not None and _contact(events, t) != _contact(theirs, t):
                self._skip("in another phase")
            elif not samples or not x[samples[0]] - coincidence <= t <= x[samples[-1]] + coincidence:
                self._skip("between an event and the samples of the phase")
            elif self._is_in_phase(label, row, t, self.reference.cells["phase"][samples[0]], phase):
                chosen.append(row)
            else:
                self._skip("in another phase")
        return parts

    def _is_in_phase(self, label, row, t, word, phase):
        theirs = self.theirs.cells["phase"][row] if "phase" in self.theirs.cells else None
        if theirs not in (None, "stick", "slip"):
            raise InputError(f"{self.theirs.places[row]}: phase is '{theirs}', but must be stick or slip")
        phase.compared += 1
        if theirs not in (None, word):
            phase.count(f"{self._where(label, t)} ({word} in the data set)")
        return theirs in (None, word)

    # --- verdict

    def run(self):
        parts = []
        for group in self.groups if self.kind == "events" and len(self.groups) > 1 else ():
            if group[2]:
                part = copy.deepcopy(self)
                part.groups = [group]
                parts.append(part._judged(group[0]))
        result = self._judged(self.reference.name)
        result.parts, result.level = parts, min((one.level for one in [result, *parts]), key=LEVELS.index)
        if not any(quantity.compared for quantity in self.quantities):
            reasons = ", ".join(f"{n} {reason}" for reason, n in self.quantities[-1].skipped.items())
            raise InputError(f"{self.theirs.name}: none of the {self.theirs.rows} rows can be compared: {reasons}")
        return result

    def _judged(self, name):
        getattr(self, self.kind)()
        for quantity in self.quantities:
            if quantity.norm == "word":
                quantity.required_level = self._required_level(quantity)
                quantity.accept_share()
            if not quantity.compared and quantity.verdict == "agrees":
                quantity.verdict = "undecided"
        verdicts, is_covered = {quantity.verdict for quantity in self.quantities}, self.coverage >= self.required
        verdict = next((one for one in ("differs", "undecided") if one in verdicts), "agrees")
        if verdict == "agrees" and not is_covered:
            verdict = "partly" if len(self.present) < sum(len(rows) for _, rows, _ in self.groups) else "undecided"
        level = min((quantity.level for quantity in self.quantities), key=LEVELS.index) if is_covered else LEVELS[0]
        return Judgement(name, self.reference.title, verdict, level, self.level, self.quantities, self.remarks, self.coverage, self.required,
                         len(self.present), sum(len(rows) for _, rows, _ in self.groups))


@dataclass
class Judgement:
    """What judge() says. The verdict is "agrees", "differs", "undecided" or "partly": what was given agrees, but rows are missing.

    The level is "strict", "1e-3", "1e-2", "1e-1" or "none": the least of its quantities. required_level is the one that was asked for.
    bool() is whether it agrees.
    """
    name: str
    title: str
    verdict: str
    level: str
    required_level: str
    quantities: list
    remarks: list
    coverage: float  # of the rows or of the range, from 0 to 1
    required_coverage: float
    rows: int  # of the data set, that the results have
    all_rows: int
    parts: list = field(default_factory=list)  # the judgements of each of several sequences of events

    def __bool__(self):
        return self.verdict == "agrees"

    @property
    def exit_status(self):
        return EXIT_STATUS[self.verdict]

    @property
    def conclusion(self):
        is_part = self.verdict in ("agrees", "partly") and self.rows < self.all_rows
        at_level = f" at level {self.required_level}" if self.required_level != "strict" and self.verdict != "undecided" else ""
        return (f"agrees in {self.rows} of {self.all_rows} rows" if is_part else self.verdict) + at_level

    def as_dict(self):
        """For JSON."""
        def members(of, hidden=()):
            return {key: None if value in (INFINITY, -INFINITY) or value != value else value  # JSON has finite numbers only
                    for key, value in vars(of).items() if key not in hidden}
        return {**members(self), "conclusion": self.conclusion, "parts": [part.as_dict() for part in self.parts],
                "quantities": [{**members(one, ("abscissas",)), "level": one.level} for one in self.quantities]}

    def __str__(self):
        lines = [("quantity", "norm", "compared", "error", "uncertainty", "tolerance", "level", "verdict", "at")]
        for one in self.quantities:
            numbers = ["-" if x is None else f"{x:.3g}" for x in (one.error, one.uncertainty, one.tolerance)]
            numbers[2] += f" or level {one.required_level}" if one.required_level != "strict" else ""
            lines.append((one.name, one.norm, str(one.compared), *numbers, one.level, one.verdict, one.where))
        widths = [max(map(len, column)) for column in zip(*lines)]
        table = ["  ".join(cell.ljust(width) for cell, width in zip(line, widths)).rstrip() for line in lines]
        skipped = [f"{one.name}: not compared: {n} {reason}" for one in self.quantities for reason, n in one.skipped.items() if n]
        parts = [f"{part.name}: {part.conclusion}, level {part.level}" for part in self.parts]
        return "\n".join([f"{self.name}: {self.title}", "", *table, "", *skipped, *self.remarks, *parts,
                          f"coverage: {100 * self.coverage:.3g} %, at least {100 * self.required_coverage:g} % needed",
                          f"{self.conclusion}, {'reached' if self.required_level != 'strict' else 'level'} {self.level}"])


def _rows_of(rows, reference):
    """The rows, from 0, that numbers or a text such as "1:12,15" name."""
    try:
        if isinstance(rows, str):
            parts = [part.split(":") if re.fullmatch(r"\d{1,18}(:\d{1,18})?", part, re.ASCII) else "0" for part in rows.split(",") if rows]
        else:
            parts = [[operator.index(row)] for row in rows or ()]
    except TypeError:
        parts = ["0"]
    ranges = [range(int(part[0]) - 1, int(part[-1])) for part in parts]
    if not all(0 <= one.start < one.stop <= reference.rows for one in ranges):
        raise InputError(f"the rows are {printable(rows)}, but must be numbers, or ranges of them as in 1:12,15, from 1 to {reference.rows}")
    return {row for one in ranges for row in one}


def level_of(level):
    """The name of a level that is asked for."""
    name = level if isinstance(level, str) else next((one for one, limit in LIMITS.items() if limit and number(level) == limit), None)
    if level is not None and name not in LIMITS:
        raise InputError(f"the level is {printable(level)}, but must be one of {', '.join(LIMITS)}")
    return name or "strict"


def tolerances_of(tolerance):
    """By quantity, "" for all. A text has QUANTITY=NUMBER, or a number, with blanks between several."""
    if not isinstance(tolerance, str):
        return tolerance if isinstance(tolerance, dict) else {} if tolerance is None else {"": tolerance}
    tolerances = {}
    for text in filter(None, tolerance.split(" ")):
        name, equals, value = text.rpartition("=")
        if (equals and not name) or value[:1] == "+" or "d" in value.lower() or number(value) is None:
            raise InputError(f"the tolerance is '{printable(text)}', but must be a number or QUANTITY=NUMBER, as in frequency=1e-3")
        tolerances[name] = number(value)
    return tolerances


def judge(name, data, *, columns=None, tolerance=None, level=None, until=None, rows=None, events=None, mapping=(), is_foreign=False):
    """The Judgement of results: a file (CSV and its relatives, perhaps gzip), or columns in memory.

    data: a path, a mapping of names to sequences (a number or word stands for all rows), a structured array, a table of pandas, or
    rows with their names in `columns`. A name may have a unit ("frequency [kHz]"), else it is that of the data set.
    columns: the names, of data without them; or, here or as `mapping`, {"frequency": "f1:kHz"}, which of them is which.
    tolerance: a number for all quantities, or one for each in a mapping or a text as "frequency=1e-3 power=1e-2".
    level: "1e-2" or 0.01, so "1e-1" and "1e-3": a value agrees as well if its scaled error is at most that; "strict": by tolerances
    alone. until: compare nothing later, s.
    rows: numbers, from 1, of the rows of the data set that were meant, or a text as "1:12,15"; None: all. events: changes of contact
    of the same history. is_foreign: someone else names the file, so that no message shows the names in it.
    A wrong result raises nothing. Throws InputError for what cannot be used.

    >>> judgement = stickslip.judge("stick-frequencies", {"beam": "paper", "mode": [1], "frequency": [24.98]}, rows="1", level="1e-3")
    >>> judgement.conclusion, judgement.level, judgement.quantities[0].where
    ('agrees in 1 of 50 rows at level 1e-3', '1e-3', 'beam = paper, mode = 1')
    """
    reference = load(name)
    if not reference.comparison:
        raise InputError(f"the data set {name} says nothing of how to compare with it")
    of_events = reference.comparison.get("events")
    if events is not None and not of_events:
        raise InputError(f"events are given, but {name} is no history with events of its own")
    table = load(of_events) if of_events else None
    tolerances = tolerances_of(tolerance)
    for what, value in [("tolerance", value) for value in tolerances.values()] + [("latest time", until)] * (until is not None):
        if isinstance(value, str) or number(value) is None or value < 0:
            raise InputError(f"the {what} is {printable(value)}, but must be a finite number that is not negative")
    mapping, names = (columns, None) if isinstance(columns, dict) else (mapping, columns.split(",") if isinstance(columns, str) else columns)
    if not (names is None or isinstance(names, (list, tuple)) and all(isinstance(one, str) for one in names)):
        raise InputError(f"the columns are {printable(names)}, but must be names, or a mapping of names to names")
    mappings = mappings_of(mapping, {**reference.types, **(table.types if events is not None else {})})
    their_events = None if events is None else Results(table, events, None, mappings, is_foreign)
    return _Comparison(reference, Results(reference, data, names, mappings, is_foreign), tolerances, level_of(level), until, _rows_of(rows, reference),
                       table, their_events).run()
