#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""calculix.py STICKSLIP: the largest force that holds a contact under a record, by *MODAL DYNAMIC of CalculiX and by `criterion`.

A cantilever of 80 C3D20, held at its end by a spring, on a base that moves with the wall: 24 sines of 6 to 60 Hz for 2 s. All damping is
proportional to the mass, so that all of the force is in the spring. Both refine until the force is right to 5e-4: CalculiX the
sampling, between which the record is linear; `criterion`, from samples at 400 Hz, the modes. Adds the processor times to results/speed.json.
"""
import contextlib
import json
import math
import pathlib
import resource
import subprocess
import sys
import tempfile

HELD = "\n[friction]\nstatic_coefficient = 0.6\n[wall]\nwith_base = true\n[damping]\nmass_proportional = 6.0\n"
RECORD = '[excitation]\nfile = "record.csv"\ncolumn = "a"\nquantity = "acceleration"\nunit = "m/s^2"\ninitial_velocity = 0.0\n'
FILES = '[model]\nmass_matrix = "mesh.mas"\nstiffness_matrix = "mesh.sti"\ndofs = "mesh.dof"\nnormal_force = 400.0\n'
MATERIAL = "*MATERIAL, NAME=M\n*ELASTIC\n2.e9, 0.35\n*DENSITY\n1000.\n*SOLID SECTION, ELSET=ALL, MATERIAL=M\n*SPRING, ELSET=K\n3, 3\n1.e6\n"
CORNERS = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)]
EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]


def mesh():
    """The model of CalculiX, the nodes of its clamp, and the node behind the spring."""
    places = [(i, j, k) for i in range(41) for j in range(5) for k in range(5) if i % 2 + j % 2 + k % 2 < 2]
    number = {place: n for n, place in enumerate(places, 1)}
    shape = CORNERS + [tuple((a + b) // 2 for a, b in zip(CORNERS[p], CORNERS[q])) for p, q in EDGES]
    text, end, tip, element = "*NODE\n", len(places) + 1, number[40, 2, 0], 0
    text += "".join(f"{n}, {i / 20}, {j / 40}, {k / 40}\n" for (i, j, k), n in number.items()) + f"{end}, 2, 0.05, -0.01\n"
    for i, j, k in (p for p in places if p[0] < 40 and p[1] < 4 and p[2] < 4 and not any(x % 2 for x in p)):
        nodes, element = [number[i + a, j + b, k + c] for a, b, c in shape], element + 1
        text += f"*ELEMENT, TYPE=C3D20, ELSET=ALL\n{element}, {str(nodes[:10])[1:-1]},\n{str(nodes[10:])[1:-1]}\n"
    text += f"*ELEMENT, TYPE=SPRING2, ELSET=K\n{element + 1}, {tip}, {end}\n*NSET, NSET=ENDS\n{tip}, {end}\n{MATERIAL}"
    return text + f"*BOUNDARY\n{end}, 1, 2\n", [n for place, n in number.items() if place[0] == 0], end


def record(rate):
    rise = [min(1, 5 * i / rate) for i in range(2 * rate + 1)]
    sines = [(2 * math.pi * (6 + 54 * k / 23) / rate, 1.7 * k * k) for k in range(24)]
    return [(i / rate, 1.2 * r * r * (3 - 2 * r) * sum(math.sin(w * i + p) for w, p in sines)) for i, r in enumerate(rise)]


def timed(*command):
    """What a program prints, and its processor time."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return text, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def calculix(model, clamp, end, rate):
    samples = "".join(f"{t:.9g}, {a:.12g}\n" for t, a in record(rate))
    pathlib.Path("modal.inp").write_text(
        model + "".join(f"{n}, 1, 3\n" for n in clamp) + f"{end}, 3, 3\n*AMPLITUDE, NAME=A\n{samples}"
        f"*STEP\n*FREQUENCY, STORAGE=YES\n20\n*END STEP\n*STEP, INC=1000000\n*MODAL DYNAMIC\n{1 / rate}, 2.\n"
        "*MODAL DAMPING, RAYLEIGH\n, , 6., 0.\n*DLOAD, AMPLITUDE=A\nALL, GRAV, 1., 0., 0., -1.\n*NODE PRINT, NSET=ENDS\nRF\n*END STEP\n")
    seconds = timed("ccx", "modal")[1]
    rows = (line.split() for line in pathlib.Path("modal.dat").read_text().splitlines())
    return max(abs(float(row[3])) for row in rows if len(row) == 4 and row[0] == str(end)), seconds


def criterion(program, modes):
    text, seconds = timed(program, "criterion", "case.toml", "--set", f"numerics.modes={modes}", "--json")
    force = json.loads(text)["force_max_N"]
    value = (force["lower"] + force["upper"]) / 2
    return value, (force["upper"] - value) / value, seconds


def main():
    program, results = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(__file__).resolve().parent / "results/speed.json"
    with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
        model, clamp, end = mesh()
        pathlib.Path("mesh.inp").write_text(model + "*STEP\n*FREQUENCY, SOLVER=MATRIXSTORAGE\n*END STEP\n")
        timed("ccx", "mesh")
        pathlib.Path("record.csv").write_text("t,a\n" + "".join(f"{t!r},{a!r}\n" for t, a in record(400)))
        contact = f'base = {{ nodes = {clamp}, direction = "z" }}\ncontact = {{ nodes = [{end}], direction = "z" }}'
        pathlib.Path("case.toml").write_text(FILES + contact + HELD + RECORD)
        exact, times = criterion(program, 160)[0], {}
        for name, run, sizes in (("calculix", lambda n: calculix(model, clamp, end, n), (400, 800, 1600, 3200, 6400)),
                                 ("criterion", lambda n: criterion(program, n), (10, 20, 30, 40))):
            for size in sizes:
                value, *bound, seconds = run(size)
                error = bound[0] if bound else abs(value / exact - 1)
                print(f"{name} {size}: {value:.6g} N, error {error:.1e}, {seconds:.2f} s")
                if error <= 5e-4 and name not in times:
                    times[name] = seconds
    speed = json.loads(results.read_text())
    names = {f"held_record/{name}": seconds for name, seconds in times.items()}
    speed["benchmarks"] = [old for old in speed["benchmarks"] if old["run_name"] not in names] + [
        {"name": name, "run_name": name, "run_type": "iteration", "real_time": round(1e3 * seconds, 1), "time_unit": "ms"}
        for name, seconds in names.items()]
    results.write_text(json.dumps(speed, indent=1) + "\n")


if __name__ == "__main__":
    main()
