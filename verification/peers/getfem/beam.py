#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The problems of data/reference with GetFEM: its Hermite element, its weak forms and its theta-method in time.

    beam.py PROBLEM FOLDER ELEMENTS STEP THETA

Friction is an augmented Lagrangian: the multiplier `lam` is the friction force on the beam, and the projection of
lam - r v on the admissible forces is lam itself. The follower force is a term at the tip, so that K is not symmetric.
"""

import csv
import math
import sys

import getfem as gf
import numpy as np
from scipy.linalg import eigvals

TIP, CLAMP = 1, 2


def beam_mesh(row, elements):
    length = float(row["length"])
    mesh = gf.Mesh("cartesian", np.linspace(0.0, length, elements + 1))
    for region, x in ((TIP, length), (CLAMP, 0.0)):
        mesh.set_region(region, mesh.faces_from_pid(mesh.pid_from_coords(np.array([[x]]))))
    field = gf.MeshFem(mesh, 1)
    field.set_fem(gf.Fem("FEM_HERMITE(1)"))
    numbers = {"EI": float(row["youngs_modulus"]) * float(row["second_moment_of_area"]),
               "rhoA": float(row["density"]) * float(row["area"]), "P": float(row["axial_force"])}
    return mesh, field, gf.MeshIm(mesh, gf.Integ("IM_GAUSS1D(7)")), numbers


STIFFNESS = "EI*Hess_u:Hess_Test_u - P*Grad_u.Grad_Test_u"
FOLLOWER = "P*(Grad_u.Normal)*Test_u"


def frequencies(row, elements, state):
    _, field, integration, numbers = beam_mesh(row, elements)
    md = gf.Model("real")
    md.add_fem_variable("u", field)
    for name, value in numbers.items():
        md.add_initialized_data(name, value)
    K = gf.asm_generic(integration, 2, STIFFNESS, -1, md)
    M = gf.asm_generic(integration, 2, "rhoA*u*Test_u", -1, md)
    K = K.full() + gf.asm_generic(integration, 2, FOLLOWER, TIP, md).full()
    points = field.basic_dof_nodes()[0]
    at_clamp = np.flatnonzero(np.isclose(points, 0.0))  # deflection and slope
    at_tip = np.flatnonzero(np.isclose(points, points.max()))
    left_out = list(at_clamp) + ([at_tip[0]] if state == "stick" else [])
    free = np.setdiff1d(np.arange(field.nbdof()), left_out)
    # As 1/omega^2: rounding then spares the lowest frequencies.
    squares = np.sort(1.0 / eigvals(M.full()[np.ix_(free, free)], K[np.ix_(free, free)]).real)
    return np.sqrt(squares[:10]) / (2 * math.pi)


def history(row, elements, step, theta, problem):
    """Samples (time, y at midspan, y at the tip, friction force -lam, sliding velocity), one a step."""
    held, damped = problem == "stick-history", problem.startswith("stick-slip")
    amplitude, omega, eta = (0.5e-3, 30 * math.pi, 0.0) if held else (1e-3, 50 * math.pi, 6.4e-5 if damped else 0.0)
    _, field, integration, numbers = beam_mesh(row, elements)
    points = field.basic_dof_nodes()[0]
    clamp, (tip, slope) = (np.flatnonzero(np.isclose(points, x)) for x in (0.0, points.max()))
    middle = np.flatnonzero(np.isclose(points, points.max() / 2))[0]

    md = gf.Model("real")
    md.add_fem_variable("u", field)
    md.add_variable("lam", 1)
    md.add_variable("clamping", 2)
    for name, value in (numbers | {"eta": eta, "h1": amplitude * omega, "h2": 0.0, "r": 1e3}).items():
        md.add_initialized_data(name, value)
    md.add_theta_method_for_second_order("u", theta)
    md.add_nonlinear_term(integration, STIFFNESS + " + eta*EI*Hess_Dot_u:Hess_Test_u + rhoA*(Dot2_u + h2)*Test_u")
    md.add_nonlinear_term(integration, FOLLOWER + " - lam*Test_u", TIP)
    if held:
        md.add_nonlinear_term(integration, "(Dot_u + h1)*Test_lam", TIP)
    else:
        bound = "(P*(0.3 + 0.3*exp(-abs(Dot_u + h1))))"
        md.add_nonlinear_term(integration, f"(lam - max(-{bound}, min({bound}, lam - r*(Dot_u + h1))))/r*Test_lam", TIP)
    rows = gf.Spmat("empty", 2, field.nbdof())
    for i, j in enumerate(clamp):
        rows[i, int(j)] = 1.0
    md.add_constraint_with_multipliers("u", "clamping", rows, np.zeros(2))

    K = gf.asm_generic(integration, 2, STIFFNESS, -1, md).full()  # v(0) = S h'(0), static shape with S(L) = -1
    first = md.interval_of_variable("u")[0]
    K = K[first:first + field.nbdof(), first:first + field.nbdof()]
    K[tip, slope] += numbers["P"]
    free = np.setdiff1d(np.arange(field.nbdof()), [*clamp, tip])
    velocity = np.zeros(field.nbdof())
    velocity[tip] = -1.0
    velocity[free] = np.linalg.solve(K[np.ix_(free, free)], K[free, tip])
    md.set_variable("Previous_u", np.zeros(field.nbdof()))
    md.set_variable("Previous_Dot_u", velocity * amplitude * omega)
    md.set_variable("Previous_Dot2_u", np.zeros(field.nbdof()))
    md.set_time_step(step)
    duration = 1.0 if held else 0.5
    for i in range(1, round(duration / step) + 1):
        t = i * step
        h = amplitude * math.sin(omega * t)
        md.set_variable("h1", amplitude * omega * math.cos(omega * t))
        md.set_variable("h2", -omega**2 * h)
        md.solve("max_res", 1e-9, "max_iter", 50)
        u, v = md.variable("u"), md.variable("Dot_u")
        yield t, h + u[middle], h + u[tip], -md.variable("lam")[0], v[tip] + md.variable("h1")[0]
        md.shift_variables_for_time_integration()


def main():
    problem, folder = sys.argv[1:3]
    elements, step, theta = int(sys.argv[3]), float(sys.argv[4]), float(sys.argv[5])
    beams = {row["beam"]: row for row in csv.DictReader(open("/data/reference/beams.csv"))}
    with open(f"{folder}/result.csv", "w", newline="") as file:
        out = csv.writer(file)
        if problem.endswith("-frequencies"):
            out.writerow(["beam", "mode", "frequency"])
            state = problem.split("-")[0]
            for name in dict.fromkeys(row["beam"] for row in csv.DictReader(open(f"/data/reference/frequencies/{state}.csv"))):
                fine = frequencies(beams[name], elements, state)
                if step > 0:  # extrapolation
                    fine += (fine - frequencies(beams[name], elements // 2, state)) / 15
                out.writerows((name, i + 1, f) for i, f in enumerate(fine))
            return
        sample = {"stick-history": 1e-3, "undamped-history-25": 5e-4}.get(problem, 2e-4)
        out.writerow(["time", "phase", "midspan_displacement", "tip_displacement", "friction_force"])
        changes, sticks = [], True
        for i, (t, middle, tip, force, sliding) in enumerate(history(beams["paper"], elements, step, theta, problem), 1):
            stuck = abs(sliding) < 1e-9
            if stuck != sticks:  # between this step and the last: at half of the step
                changes.append((t - step / 2, "capture" if stuck else "onset", tip))
                sticks = stuck
            if i % round(sample / step) == 0:
                out.writerow([f"{t:.10g}", "stick" if stuck else "slip", middle, tip, force])
    if problem.startswith("stick-slip"):
        with open(f"{folder}/events.csv", "w", newline="") as file:
            csv.writer(file).writerows([("time", "change", "position"), *changes])


main()
