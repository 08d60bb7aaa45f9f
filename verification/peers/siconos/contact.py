#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Friction problems of data/reference with Siconos: Moreau-Jean time stepping with a relay law.

    contact.py PROBLEM FOLDER STEP ELEMENTS THETA

The normal force is known, so that friction is a relay: lambda in -F Sgn(v), with v the sliding velocity at the end of the
step. The bound F = 500 N mu(|v|) is renewed after each step. The beam has cubic elements and absolute displacements y, so
that the relay sees the tip's velocity itself; the base moves it through F = (M r - b) h'' + C r h' + K r h, where r is 1
for deflections and 0 for rotations.
"""

import csv
import math
import sys

import numpy as np
import siconos.kernel as sk


def steps(M, K, C, v, tip, force, bound, step, number, theta):
    """M v' + C v + K y = force(t) + e_tip lambda; yields (time, y, v, lambda, sticks), bound is a function of the sliding velocity."""
    system = sk.LagrangianLinearTIDS(np.zeros(len(v)), v, M)
    system.setKPtr(K)
    system.setCPtr(C)
    system.setFExtPtr(np.array(force(0.0)))
    H = np.zeros((1, len(v)))
    H[0, tip] = 1.0
    law = sk.RelayNSL(1, -step * bound(0.0), step * bound(0.0))  # impulses
    # The law acts only where H q + offset <= 0, as in unilateral contact: the tip is always in contact.
    interaction = sk.Interaction(law, sk.LagrangianLinearTIR(H, np.array([-1e6])))
    model = sk.NonSmoothDynamicalSystem(0.0, number * step)
    model.insertDynamicalSystem(system)
    model.link(interaction, system)
    simulation = sk.TimeStepping(model, sk.TimeDiscretisation(0.0, step), sk.MoreauJeanOSI(theta), sk.Relay())
    for i in range(1, number + 1):
        system.setFExtPtr(np.array(force((i - 1 + theta) * step)))
        simulation.computeOneStep()
        velocity, friction = np.array(system.velocity()), interaction.lambda_(1)[0] / step
        sticks = abs(friction) < (1 - 1e-9) * law.ub() / step
        yield i * step, np.array(system.q()), velocity, friction, sticks
        law.setLb(-step * bound(velocity[tip]))
        law.setUb(step * bound(velocity[tip]))
        simulation.nextStep()


def slider_power(a, step):
    one, work, before = np.eye(1), 0.0, 0.0
    shaken = steps(one, 0 * one, 0 * one, [0.0], 0, lambda t: [-a * math.sin(2 * math.pi * t)], lambda v: 1.0, step,
                   round(12.0 / step), 0.5)
    for t, _, v, _, _ in shaken:
        work += 10 * (abs(v[0]) + before) / 2 * step if t > 4.0 + step / 2 else 0.0
        before = abs(v[0])
    return work / 8


def beam_history(row, elements, step, theta, problem):
    held, damped = problem == "stick-history", problem.startswith("stick-slip")
    amplitude, omega, eta = (0.5e-3, 30 * math.pi, 0.0) if held else (1e-3, 50 * math.pi, 6.4e-5 if damped else 0.0)
    length, axial = float(row["length"]), float(row["axial_force"])
    mass, stiffness = (float(row[a]) * float(row[b]) for a, b in (("density", "area"), ("youngs_modulus", "second_moment_of_area")))
    n, l = 2 * (elements + 1), length / elements
    M, K0, G, b = np.zeros((n, n)), np.zeros((n, n)), np.zeros((n, n)), np.zeros(n)
    for e in range(elements):
        s = slice(2 * e, 2 * e + 4)
        M[s, s] += mass * l / 420 * np.array([[156, 22*l, 54, -13*l], [22*l, 4*l*l, 13*l, -3*l*l],
                                              [54, 13*l, 156, -22*l], [-13*l, -3*l*l, -22*l, 4*l*l]])
        K0[s, s] += stiffness / l**3 * np.array([[12, 6*l, -12, 6*l], [6*l, 4*l*l, -6*l, 2*l*l],
                                                 [-12, -6*l, 12, -6*l], [6*l, 2*l*l, -6*l, 4*l*l]])
        G[s, s] += np.array([[36, 3*l, -36, 3*l], [3*l, 4*l*l, -3*l, -l*l],
                             [-36, -3*l, 36, -3*l], [3*l, -l*l, -3*l, 4*l*l]]) / (30 * l)
        b[s] += mass * np.array([l / 2, l * l / 12, l / 2, -l * l / 12])
    M, K0, K, b = M[2:, 2:], K0[2:, 2:], (K0 - axial * G)[2:, 2:], b[2:]
    tip, n = n - 4, n - 2
    K[tip, tip + 1] += axial  # the follower force
    C, r = eta * K0, np.arange(n) % 2 == 0
    others = np.delete(np.arange(n), tip)
    v = np.zeros(n)  # (1 + S) h'(0), static shape S(L) = -1
    v[tip] = -1.0
    v[others] = np.linalg.solve(K[np.ix_(others, others)], K[others, tip])
    v = (v + r) * amplitude * omega
    inertia, spring, damper = M @ r - b, K @ r, C @ r

    def force(t):
        h, h1 = amplitude * math.sin(omega * t), amplitude * omega * math.cos(omega * t)
        return spring * h + damper * h1 - inertia * omega**2 * h

    bound = (lambda v: 1e3) if held else (lambda v: axial * (0.3 + 0.3 * math.exp(-abs(v))))
    for t, y, v, friction, stuck in steps(M, K, C, v, tip, force, bound, step, round((1.0 if held else 0.5) / step), theta):
        yield t, y[elements - 2], y[tip], -friction, stuck


def main():
    problem, folder, step = sys.argv[1], sys.argv[2], float(sys.argv[3])
    with open(f"{folder}/result.csv", "w", newline="") as file:
        out = csv.writer(file)
        if problem == "friction-powers":
            out.writerow(["amplitude", "power"])
            out.writerows((a, slider_power(a, step)) for a in (0.99, 1.01, 1.5, 15.0))
            return
        beams = {row["beam"]: row for row in csv.DictReader(open("/data/reference/beams.csv"))}
        sample = {"stick-history": 1e-3, "undamped-history-25": 5e-4}.get(problem, 2e-4)
        out.writerow(["time", "phase", "midspan_displacement", "tip_displacement", "friction_force"])
        changes, sticks = [], True
        history = beam_history(beams["paper"], int(sys.argv[4]), step, float(sys.argv[5]), problem)
        for i, (t, middle, tip, force, stuck) in enumerate(history, 1):
            if stuck != sticks:  # within this step
                changes.append((t - step / 2, "capture" if stuck else "onset", tip))
                sticks = stuck
            if i % round(sample / step) == 0:
                out.writerow([f"{t:.10g}", "stick" if stuck else "slip", middle, tip, force])
    if problem.startswith("stick-slip"):
        for i in range(len(changes) - 2, -1, -1):  # a stick shorter than 2e-5 s counts as slip
            if changes[i][1] == "capture" and changes[i + 1][0] - changes[i][0] < 2e-5:
                del changes[i:i + 2]
        with open(f"{folder}/events.csv", "w", newline="") as file:
            csv.writer(file).writerows([("time", "change", "position"), *changes])


main()
