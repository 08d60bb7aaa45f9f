#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""ratios.py STICKSLIP: processor times of pairs of commands, the lesser of two runs each, and their ratio: the table of the developer guide."""
import contextlib
import pathlib
import random
import sys
import tempfile

from calculix import timed

MAP = "map {} --x frequency=10:40:601 --y amplitude=1e-4:1e-3:101 --output o.csv"
DESIGN = "design {} --band 20:30 --length 1:2.5 --force 100:1000"
UNCERTAINTY = "uncertainty {} --samples 1000"
RESPOND = "respond {} --hz 25 --amplitude 1e-3 --duration 10 --method fe --output o.csv"
RANDOM = "map rough-road --set numerics.modes=20 --set numerics.time_step=1e-4 --x scale=2:3:2 --y length=1.9:2:2 --quantity travel-rate --output o.csv"
PAIRS = [(command.format("uncertain"), command.format("uncertain --set damping.ratio=0.02")) for command in (MAP, DESIGN, UNCERTAINTY)] + [
    (RESPOND.format("paper"), RESPOND.format("paper --set damping.kelvin_voigt=6e-5")), (RESPOND.format("paper"), RESPOND.format("paper --set damping.ratio=0.02")),
    ("criterion beam.toml", "criterion model.toml"), (MAP.format("beam.toml"), MAP.format("model.toml")),
    ("respond beam.toml --duration 1 --output o.csv", "respond model.toml --duration 1 --output o.csv"),
    ("criterion road", "criterion hour.toml"), (f"{RANDOM} --duration 100 --transient 10", f"{RANDOM} --duration 10000 --transient 10")]
REST = "[friction]\nstatic_coefficient = 0.6\n[damping]\nratio = 0.02\n[excitation]\n"
SINE = REST + 'frequency_hz = 15\namplitude = "1 mm"\nduration = 10\n'
BEAM = '[beam]\nlength = 2.0\ndensity = 1000.0\nyoungs_modulus = "2 GPa"\naxial_force = 500.0\n[section]\nshape = "rectangle"\nwidth = 0.1\nheight = 0.1\n'
STIFFNESS = ((12, 6, -12, 6), (6, 4, -6, 2), (-12, -6, 12, -6), (6, 2, -6, 4))
MASS = ((156, 22, 54, -13), (22, 4, 13, -3), (54, 13, 156, -22), (-13, -3, -22, 4))


def write_cases(count=500):
    """The beam, its matrices without the axial force, of 1002 rows, and an hour of filtered noise at 1 kHz."""
    h = 2 / count
    for name, numbers, factor in (("k", STIFFNESS, 2e9 * 1e-4 / 12 / h**3), ("m", MASS, 10 * h / 420)):
        sums = {}
        for row, column in ((i, j) for i in range(4) for j in range(i + 1)):
            for node in range(count):
                at = 2 * node + row + 1, 2 * node + column + 1
                sums[at] = sums.get(at, 0) + factor * numbers[row][column] * h ** (row % 2 + column % 2)
        lines = [f"{i} {j} {value!r}\n" for (i, j), value in sums.items()]
        pathlib.Path(f"{name}.mtx").write_text(f"%%MatrixMarket matrix coordinate real symmetric\n{2 * count + 2} {2 * count + 2} {len(lines)}\n" + "".join(lines))
    pathlib.Path("beam.toml").write_text(BEAM + SINE)
    pathlib.Path("model.toml").write_text(
        f'[model]\nstiffness_matrix = "k.mtx"\nmass_matrix = "m.mtx"\nbase = [1]\nfixed = [2]\ncontact = {2 * count + 1}\nnormal_force = 500.0\n' + SINE)
    pathlib.Path("hour.toml").write_text(BEAM + REST + 'file = "hour.csv"\ncolumn = "a"\nquantity = "acceleration"\nunit = "g"\nhigh_pass = "2 Hz"\n')
    random.seed(1)
    value, slow, lines = 0.0, 0.0, ["t,a\n"]
    for i in range(3_600_001):
        slow += 0.2 * (random.gauss(0, 0.5) - slow)
        value += 0.2 * (slow - value)
        lines.append(f"{i / 1000},{value:.5f}\n")
    pathlib.Path("hour.csv").write_text("".join(lines))


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        write_cases()
        print("| command | s | to which it is compared | s | ratio |\n| --- | --- | --- | --- | --- |")
        for pair in PAIRS:
            plain, other = (min(timed(program, *command.split(), "--quiet")[1] for _ in range(2)) for command in pair)
            print(f"| `{pair[1]}` | {other:.2f} | `{pair[0]}` | {plain:.2f} | {other / plain:.2g} |", flush=True)


main()
