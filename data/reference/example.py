# SPDX-License-Identifier: MIT
"""Sets problems up from the files of this folder alone, solves them by finite elements and compares.

Usage: python3 example.py [DATA_SET...]. The exit status is 1 if a value differs, and 2 if a data set has a problem that is not
solved here; a sentence says why. It needs nothing but the standard library. It solves problems with a held tip and all modes; the
mesh has Hermite elements, the time step is that of Newmark.
"""
import csv
import functools
import json
import math
import pathlib
import sys

FOLDER = pathlib.Path(__file__).resolve().parent
RESOURCES = {r["name"]: r for r in json.loads((FOLDER / "datapackage.json").read_text(encoding="utf-8"))["resources"]}


def rows_of(name):
    with open(FOLDER / RESOURCES[name]["path"], encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


BEAMS = {row["beam"]: row for row in rows_of("beams")}


def value(member, row):
    """A member of a problem: itself, or what its column holds."""
    return row[member["column"]] if isinstance(member, dict) else member


class Mesh:
    """Equal elements. The unknowns are y and y_x of each node, those of the clamp and y of the tip prescribed."""

    def __init__(self, beam, elements):
        length = float(beam["length"]) / elements
        self.rigidity = float(beam["youngs_modulus"]) * float(beam["second_moment_of_area"])
        self.load = float(beam["axial_force"])
        mass = float(beam["density"]) * float(beam["area"]) * length / 420
        a = length
        m = [[156, 22 * a, 54, -13 * a], [4 * a * a, 13 * a, -3 * a * a], [156, -22 * a], [4 * a * a]]
        k = [[12, 6 * a, -12, 6 * a], [4 * a * a, -6 * a, 2 * a * a], [12, -6 * a], [4 * a * a]]
        g = [[36, 3 * a, -36, 3 * a], [4 * a * a, -3 * a, -a * a], [36, -3 * a], [4 * a * a]]
        self.size = 2 * elements + 2
        self.mass = self.assembled(m, mass)
        self.bending = self.assembled(k, self.rigidity / a**3)
        self.geometric = self.assembled(g, 1 / (30 * a))
        self.stiffness = [[e - self.load * s for e, s in zip(*pair)] for pair in zip(self.bending, self.geometric)]
        self.free = [i for i in range(2, self.size) if i != self.size - 2]

    def assembled(self, element, factor):
        """The upper band: band[i][k] is the entry of row i and column i + k."""
        band = [[0.0] * 4 for _ in range(self.size)]
        for first in range(0, self.size - 2, 2):
            for i, row in enumerate(element):
                for k, entry in enumerate(row):
                    band[first + i][k] += factor * entry
        return band

    def solver(self, band):
        """A function that solves for the free unknowns with right-hand side r; the others come out as zero."""
        free = set(self.free)
        band = [[x if i in free and i + k in free else float(k == 0 and i not in free) for k, x in enumerate(row)]
                for i, row in enumerate(band)]
        n, factor = self.size, [[0.0] * 4 for _ in range(self.size)]
        for i in range(n):  # L D L^T, with D in factor[i][0] and L of row i + k in factor[i][k]
            pivot = band[i][0] - sum(factor[i - k][0] * factor[i - k][k] ** 2 for k in range(1, 4) if i >= k)
            factor[i][0] = pivot
            for k in range(1, min(4, n - i)):
                factor[i][k] = (band[i][k] - sum(factor[i - j][0] * factor[i - j][j] * factor[i - j][j + k]
                                                 for j in range(1, 4 - k) if i >= j)) / pivot

        def solve(r):
            x = [r[i] if i in free else 0.0 for i in range(n)] + [0.0] * 3
            for i, (_, a, b, c) in enumerate(factor):
                x[i + 1] -= a * x[i]
                x[i + 2] -= b * x[i]
                x[i + 3] -= c * x[i]
            for i in range(n - 1, -1, -1):
                d, a, b, c = factor[i]
                x[i] = x[i] / d - a * x[i + 1] - b * x[i + 2] - c * x[i + 3]
            return x[:n]

        return solve


def product(band, x):
    y, x = [0.0] * (len(band) + 3), x + [0.0] * 3
    for i, (d, a, b, c) in enumerate(band):
        y[i] += d * x[i] + a * x[i + 1] + b * x[i + 2] + c * x[i + 3]
        y[i + 1] += a * x[i]
        y[i + 2] += b * x[i]
        y[i + 3] += c * x[i]
    return y[:-3]


def dot(x, y):
    return sum(a * b for a, b in zip(x, y))


def frequencies(beam, count, elements=60):
    """Natural frequencies in Hz: inverse iteration, orthogonal to the lower modes."""
    mesh, modes, found = Mesh(beam, elements), [], []
    solve = mesh.solver(mesh.stiffness)
    for n in range(count):
        x = [math.sin((n + 1.25) * math.pi * i / mesh.size) if i in mesh.free else 0.0 for i in range(mesh.size)]
        for _ in range(40):
            for mode in modes:
                share = dot(mode, product(mesh.mass, x))
                x = [a - share * b for a, b in zip(x, mode)]
            x = solve(product(mesh.mass, x))
            norm = math.sqrt(dot(x, product(mesh.mass, x)))
            x = [a / norm for a in x]
        modes.append(x)
        found.append(math.sqrt(dot(x, product(mesh.stiffness, x))) / (2 * math.pi))
    return found


def history(problem, times, elements=20, step=2.5e-5):
    """y, y_t and the force f of the tip on the wall at each time: Newmark's method, average acceleration."""
    mesh = Mesh(BEAMS[problem["beam"]], elements)
    eta, size, tip = problem["damping"]["kelvin_voigt"], mesh.size, mesh.size - 2
    omega, amplitude = 2 * math.pi * problem["excitation"]["frequency_hz"], problem["excitation"]["amplitude"]
    factors = (1.0, step * step / 4, step / 2 * eta)
    solve = mesh.solver([[dot(factors, entries) for entries in zip(*bands)]
                         for bands in zip(mesh.mass, mesh.stiffness, mesh.bending)])

    def forces(y, v, a):
        total = [m + k for m, k in zip(product(mesh.mass, a), product(mesh.stiffness, y))]
        return [s + eta * c for s, c in zip(total, product(mesh.bending, v))] if eta else total

    # The tip is at rest, y = 0, y_t = (1 + S) h_t: 1 + S is the static shape of a unit displacement of the base.
    unit = [1.0 if i == 0 else 0.0 for i in range(size)]
    shape = mesh.solver(mesh.stiffness)([-force for force in product(mesh.stiffness, unit)])
    shape[0] = 1.0
    y, v = [0.0] * size, [amplitude * omega * s for s in shape]
    a = mesh.solver(mesh.mass)([-force for force in forces(y, v, [0.0] * size)])
    states, at = {}, 0
    for time in sorted(times):
        while at * step < time - step / 2:
            at += 1
            phase = omega * at * step
            y = [d + step * r + step * step / 4 * s for d, r, s in zip(y, v, a)]
            v = [r + step / 2 * s for r, s in zip(v, a)]
            a = [0.0] * size
            y[0], v[0] = amplitude * math.sin(phase), amplitude * omega * math.cos(phase)
            a[0] = -amplitude * omega**2 * math.sin(phase)
            rate = solve([-force for force in forces(y, v, a)])
            y = [d + step * step / 4 * s for d, s in zip(y, rate)]
            v = [r + step / 2 * s for r, s in zip(v, rate)]
            a = [s + r for s, r in zip(a, rate)]
        states[time] = y, v, -forces(y, v, a)[tip] - mesh.load * y[tip + 1]  # with the follower force
    return states


def compare(name, results):
    """Prints the largest error of each value that is compared; whether all agree."""
    rows, agree = rows_of(name), True
    for rule in RESOURCES[name]["comparison"]["values"]:
        if rule["field"] not in results[0]:
            continue
        pairs = [(float(row[rule["field"]]), float(row[rule["field"] + "_radius"]), mine[rule["field"]])
                 for row, mine in zip(rows, results) if mine]
        scale = max(abs(reference) for reference, _, _ in pairs)
        errors = [(abs(mine - reference) - radius) / (scale if rule["norm"] == "scale" else abs(reference))
                  for reference, radius, mine in pairs]
        agrees = max(errors) <= rule["tolerance"]
        agree = agree and agrees
        print(f"{name}, {rule['field']}: {len(pairs)} values, largest error {max(errors):.1e}, tolerance "
              f"{rule['tolerance']:.0e}: {'agrees' if agrees else 'differs'}")
    return agree


def obstacle(name):
    """Why the problem of a data set is not solved here; None if it is."""
    problem, compared = RESOURCES[name].get("problem", {}), RESOURCES[name].get("comparison", {"values": []})["values"]
    computed = {"frequency", "midspan_displacement", "midspan_velocity", "friction_force", "displacement", "velocity"}
    reasons = {"says nothing of how to compare": not compared,
               "has no beam with a held tip": problem.get("tip") != "held",
               "has Timoshenko beams": "shear_coefficient" in problem,
               "is a sum of modes": problem.get("modes", "all") != "all",
               "has another excitation in each row": any(isinstance(x, dict) for x in problem.get("excitation", {}).values()),
               "has other values than frequencies and histories": not computed & {rule["field"] for rule in compared}}
    return next((reason for reason, applies in reasons.items() if applies), None)


@functools.lru_cache(maxsize=None)
def states_of(problem):
    """history() of a problem in JSON, at the times of all data sets that have it."""
    same = [name for name, one in RESOURCES.items() if json.dumps(one.get("problem")) == problem and not obstacle(name)]
    return history(json.loads(problem), {float(row["time"]) for name in same for row in rows_of(name)})


def check(name):
    problem, rows = RESOURCES[name]["problem"], rows_of(name)
    if "excitation" not in problem:
        own = {beam: frequencies(BEAMS[beam], 3) for beam in {value(problem["beam"], row) for row in rows}}
        return compare(name, [{"frequency": own[value(problem["beam"], row)][int(row["mode"]) - 1]}
                              if int(row["mode"]) <= 3 else None for row in rows])
    length, states, results = float(BEAMS[problem["beam"]]["length"]), states_of(json.dumps(problem)), []
    for row in rows:
        y, v, force = states[float(row["time"])]
        elements = len(y) // 2 - 1
        node = 2 * round(float(row["x"]) / length * elements) if "x" in row else elements  # the middle
        results.append({"midspan_displacement": y[node], "midspan_velocity": v[node], "friction_force": force,
                        "displacement": y[node], "velocity": v[node]})
    return compare(name, results)


if __name__ == "__main__":
    chosen = sys.argv[1:] or ["stick-frequencies", "stick-history"]
    for name in chosen:
        if name not in RESOURCES:
            sys.exit(f"example.py: the data set {name} is unknown, but must be one of {', '.join(RESOURCES)}")
    refused = [name for name in chosen if obstacle(name)]
    for name in refused:
        print(f"example.py: {name} {obstacle(name)}; that is not solved here", file=sys.stderr)
    results = [check(name) for name in chosen if name not in refused]
    sys.exit(2 if refused else 0 if all(results) else 1)
