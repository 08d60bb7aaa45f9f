#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Frequencies of beams with shear and rotary inertia with CalculiX: solids of 20 nodes (C3D20R), linear elasticity.

    solid.py timoshenko-STATE-frequencies FOLDER ELEMENTS

ELEMENTS along the beam, with a quarter of the section: deflections are even and stretches odd in the height, both even in
the width, so that bending alone is left. The clamp holds its whole face. A tip in stick has no deflection on its face, and
may rotate.
"""

import csv
import re
import subprocess
import sys

problem, folder, along = sys.argv[1], sys.argv[2], int(sys.argv[3])
state = "stick" if "-stick-" in problem else "slip"
MODES, POISSON = 10, 0.3


def deck(length, height, width, density, modulus):
    counts = [2 * along, 4, 6]  # half elements; y to height/2, z to width/2
    sides = [length, height / 2, width / 2]
    nodes = {}
    for i in range(counts[0] + 1):
        for j in range(counts[1] + 1):
            for k in range(counts[2] + 1):
                if i % 2 + j % 2 + k % 2 < 2:
                    nodes[i, j, k] = len(nodes) + 1
    corners = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)]
    edges = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
    shape = corners + [tuple((a + b) // 2 for a, b in zip(corners[p], corners[q])) for p, q in edges]
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{number}, " + ", ".join(f"{s * p / n:.15g}" for s, p, n in zip(sides, place, counts))
              for place, number in nodes.items()]
    lines.append("*ELEMENT, TYPE=C3D20R, ELSET=BEAM")
    element = 0
    for i in range(0, counts[0], 2):
        for j in range(0, counts[1], 2):
            for k in range(0, counts[2], 2):
                element += 1
                n = [nodes[i + a, j + b, k + c] for a, b, c in shape]
                lines += [f"{element}, " + ", ".join(map(str, n[:15])) + ",", ", ".join(map(str, n[15:]))]
    lines += ["*MATERIAL, NAME=M", "*ELASTIC", f"{modulus:.15g}, {POISSON}", "*DENSITY", f"{density:.15g}",
              "*SOLID SECTION, ELSET=BEAM, MATERIAL=M", "*BOUNDARY"]
    for (i, j, k), number in nodes.items():
        if i == 0:
            lines.append(f"{number}, 1, 3")
            continue
        if j == 0:
            lines.append(f"{number}, 1, 1")
        if j == 0 or k == 0:
            lines.append(f"{number}, 3, 3")
        if i == counts[0] and state == "stick":
            lines.append(f"{number}, 2, 2")
    lines += ["*STEP", "*FREQUENCY", str(MODES), "*END STEP", ""]
    return "\n".join(lines)


with open(f"{folder}/result.csv", "w", newline="") as file:
    out = csv.writer(file)
    out.writerow(["beam", "mode", "frequency"])
    asked = {row["beam"] for row in csv.DictReader(open(f"/data/reference/frequencies/timoshenko-{state}.csv"))}
    for row in csv.DictReader(open("/data/reference/beams.csv")):
        if row["beam"] not in asked:
            continue
        length, area, inertia, density, modulus = (float(row[name]) for name in list(row)[1:6])
        height = (12 * inertia / area) ** 0.5
        with open("/tmp/solid.inp", "w") as file_of_deck:
            file_of_deck.write(deck(length, height, area / height, density, modulus))
        subprocess.run(["ccx", "-i", "solid"], cwd="/tmp", check=True, stdout=subprocess.DEVNULL)
        table = open("/tmp/solid.dat").read().split("E I G E N V A L U E   O U T P U T")[1].split("P A R T I C I P")[0]
        found = [float(f) for f in re.findall(r"^\s*\d+\s+\S+\s+\S+\s+(\S+)\s+\S+\s*$", table, re.MULTILINE)]
        out.writerows((row["beam"], i, f) for i, f in enumerate(found[:MODES], 1))
