#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Stick frequencies with CalculiX: B32R beams, prestressed by the axial force, then *FREQUENCY with PERTURBATION.

    beam.py stick-frequencies FOLDER ELEMENTS SLENDERNESS

CalculiX expands a beam element into solids of 20 nodes: it has shear and rotary inertia, which the reference has not.
SLENDERNESS 0 takes the section of the beam; another number takes a square section with that ratio of length to height,
and the modulus and the density that give the same E I and rho A.
"""

import csv
import math
import re
import subprocess
import sys

folder, elements, slenderness = sys.argv[2], int(sys.argv[3]), float(sys.argv[4])
with open(f"{folder}/result.csv", "w", newline="") as file:
    out = csv.writer(file)
    out.writerow(["beam", "mode", "frequency"])
    asked = {row["beam"] for row in csv.DictReader(open("/data/reference/frequencies/stick.csv"))}
    for row in csv.DictReader(open("/data/reference/beams.csv")):
        if row["beam"] not in asked:
            continue
        length, area, inertia, density, modulus, force = (float(row[name]) for name in list(row)[1:])
        height, width = math.sqrt(12 * inertia / area), area / math.sqrt(12 * inertia / area)
        if slenderness:
            thin = length / slenderness
            modulus, density = modulus * inertia / (thin**4 / 12), density * area / thin**2
            height = width = thin
        last = 2 * elements + 1
        nodes = "".join(f"{i + 1}, {length * i / (2 * elements):.15g}, 0, 0\n" for i in range(last))
        lines = "".join(f"{e + 1}, {2 * e + 1}, {2 * e + 2}, {2 * e + 3}\n" for e in range(elements))
        with open("/tmp/beam.inp", "w") as deck:  # the motion is in the plane 1-2
            deck.write(f"""*NODE, NSET=ALL
{nodes}*ELEMENT, TYPE=B32R, ELSET=BEAM
{lines}*MATERIAL, NAME=M
*ELASTIC
{modulus:.15g}, 0.0
*DENSITY
{density:.15g}
*BEAM SECTION, ELSET=BEAM, MATERIAL=M, SECTION=RECT
{width:.15g}, {height:.15g}
0, 0, 1
*BOUNDARY
1, 1, 6
ALL, 3, 3
{last}, 2, 2
*STEP, NLGEOM
*STATIC
*CLOAD
{last}, 1, {-force:.15g}
*END STEP
*STEP, PERTURBATION
*FREQUENCY
40
*NODE PRINT, NSET=ALL
U
*END STEP
""")
        subprocess.run(["ccx", "-i", "beam"], cwd="/tmp", check=True, stdout=subprocess.DEVNULL)
        text = open("/tmp/beam.dat").read()
        table = text.split("E I G E N V A L U E   O U T P U T")[1].split("P A R T I C I P")[0]
        found = [float(f) for f in re.findall(r"^\s*\d+\s+\S+\s+\S+\s+(\S+)\s+\S+\s*$", table, re.MULTILINE)]
        modes = text.split("displacements (vx,vy,vz)")[1:][-len(found):]
        bending = []  # twist and stretching do not move the axis of the beam sideways
        for frequency, mode in zip(found, modes):
            moved = re.findall(r"^\s*\d+\s+(\S+)\s+(\S+)\s+\S+\s*$", mode, re.MULTILINE)
            along, across = (max(abs(float(u[i])) for u in moved) for i in (0, 1))
            if across > 0.3 / math.sqrt(density * width * height * length) and across > along:
                bending.append(frequency)
        out.writerows((row["beam"], i, f) for i, f in enumerate(bending[:10], 1))
