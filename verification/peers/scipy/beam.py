#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The problems of data/reference with SciPy: cubic beam elements, linalg.eig, and solve_ivp with its events.

    beam.py PROBLEM FOLDER [--elements N] [--method METHOD] [--rtol R] [--atol A] [--modes N --step H]

Writes FOLDER/result.csv, and FOLDER/events.csv where the tip sticks and slips. The degrees of freedom are those of the
deflection u relative to the base. The friction force f_d on the beam enters as M a + C v + K q = -b h'' + e_tip f_d, in
stick and in slip; K has the term of the follower force, P e_tip theta_tip.
"""

import argparse
import csv
import math

import numpy as np
from scipy import integrate, linalg

REFERENCE = "/data/reference"


class Beam:
    def __init__(self, row, elements):
        self.length, self.force = float(row["length"]), float(row["axial_force"])
        mass = float(row["density"]) * float(row["area"])
        self.stiffness = float(row["youngs_modulus"]) * float(row["second_moment_of_area"])
        n, l = 2 * (elements + 1), self.length / elements
        self.M, self.K0, G, self.b = np.zeros((n, n)), np.zeros((n, n)), np.zeros((n, n)), np.zeros(n)
        m = [[156, 22*l, 54, -13*l], [22*l, 4*l*l, 13*l, -3*l*l], [54, 13*l, 156, -22*l], [-13*l, -3*l*l, -22*l, 4*l*l]]
        k = [[12, 6*l, -12, 6*l], [6*l, 4*l*l, -6*l, 2*l*l], [-12, -6*l, 12, -6*l], [6*l, 2*l*l, -6*l, 4*l*l]]
        g = [[36, 3*l, -36, 3*l], [3*l, 4*l*l, -3*l, -l*l], [-36, -3*l, 36, -3*l], [3*l, -l*l, -3*l, 4*l*l]]
        for e in range(elements):
            s = slice(2 * e, 2 * e + 4)
            self.M[s, s] += mass * l / 420 * np.array(m)
            self.K0[s, s] += self.stiffness / l**3 * np.array(k)
            G[s, s] += np.array(g) / (30 * l)
            self.b[s] += mass * np.array([l / 2, l * l / 12, l / 2, -l * l / 12])
        self.M, self.K0, G, self.b = self.M[2:, 2:], self.K0[2:, 2:], G[2:, 2:], self.b[2:]  # clamped
        self.tip, self.middle = n - 4, elements - 2
        self.K = self.K0 - self.force * G
        self.K[self.tip, self.tip + 1] += self.force
        self.held = np.delete(np.arange(n - 2), self.tip)

    def squares(self, state, inverse):
        free = self.held if state == "stick" else np.arange(len(self.b))
        K, M = self.K[np.ix_(free, free)], self.M[np.ix_(free, free)]
        if inverse:  # as 1/omega^2: rounding then spares the lowest frequencies
            return np.sort(1.0 / linalg.eigvals(M, K).real)
        return linalg.eigh(K, M, eigvals_only=True) if state == "stick" else np.sort(linalg.eigvals(K, M).real)


def frequencies(row, elements, state, extrapolate):
    result = np.sqrt(Beam(row, elements).squares(state, extrapolate)[:10]) / (2 * math.pi)
    if extrapolate:  # the error falls with the fourth power of the element length
        coarse = np.sqrt(Beam(row, elements // 2).squares(state, True)[:10]) / (2 * math.pi)
        result += (result - coarse) / 15
    return result


class Contact:
    """The paper's beam with its wall: mu(v) = 0.3 + 0.3 exp(-|v|), normal force 500 N."""

    def __init__(self, beam, hz, amplitude, eta):
        self.beam, self.omega, self.amplitude, n = beam, 2 * math.pi * hz, amplitude, len(beam.b)
        held, tip, C = beam.held, beam.tip, eta * beam.K0
        inverse = linalg.inv(beam.M)
        # x = (q, v), x' = A x + base h'' + tip f_d
        self.slip = np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ beam.K, -inverse @ C]])
        self.slip_base = np.r_[np.zeros(n), -inverse @ beam.b]
        self.slip_tip = np.r_[np.zeros(n), inverse[:, tip]]
        # In stick f_d is such that the tip has the acceleration -h''.
        row = n + tip
        self.force = -self.slip[row] / self.slip_tip[row]
        self.force_base = (-1.0 - self.slip_base[row]) / self.slip_tip[row]
        self.stick = self.slip + np.outer(self.slip_tip, self.force)
        self.stick_base = self.slip_base + self.slip_tip * self.force_base
        # At rest at the wall: v(0) = S h'(0), where S is the static shape with S(L) = -1.
        shape = np.zeros(n)
        shape[tip] = -1.0
        shape[held] = linalg.solve(beam.K[np.ix_(held, held)], beam.K[held, tip])
        self.start = np.r_[np.zeros(n), shape * self.amplitude * self.omega]

    def base(self, t, derivative=0):
        return self.amplitude * self.omega**derivative * np.sin(self.omega * t + derivative * math.pi / 2)

    def friction(self, v):
        return self.beam.force * (0.3 + 0.3 * np.exp(-np.abs(v)))

    def reaction(self, t, x):
        return self.force @ x + self.force_base * self.base(t, 2)

    def sliding(self, t, x):
        return x[len(self.beam.b) + self.beam.tip] + self.base(t, 1)

    def run(self, times, can_slip=True, **options):
        """Phase by phase with events; returns samples (y at midspan, y at the tip, force -f_d, stick) and the events."""
        limit, samples, events = self.friction(0.0), [], []
        t, x, direction = 0.0, self.start, 0

        def leave(t, x):
            return limit - abs(self.reaction(t, x)) if can_slip else 1.0

        def stop(t, x):
            return direction * self.sliding(t, x)

        leave.terminal = stop.terminal = True
        leave.direction = stop.direction = -1
        while t < times[-1]:
            if direction == 0:
                A, rate, event = self.stick, lambda t, x: self.stick @ x + self.stick_base * self.base(t, 2), leave
            else:
                A, event = self.slip, stop

                def rate(t, x):
                    force = -direction * self.friction(self.sliding(t, x))
                    return self.slip @ x + self.slip_base * self.base(t, 2) + self.slip_tip * force
            if options["method"] in ("Radau", "BDF", "LSODA"):
                options["jac"] = A if options["method"] != "LSODA" else lambda t, x: A
            grid = times[(times >= t)]
            phase = integrate.solve_ivp(rate, (t, times[-1]), x, events=event, t_eval=None, dense_output=True, **options)
            for time_ in grid[grid < phase.t[-1]] if phase.status == 1 else grid:
                state = phase.sol(time_)
                force = -self.reaction(time_, state) if direction == 0 else \
                    direction * self.friction(self.sliding(time_, state))
                base = self.base(time_)
                samples.append((time_, base + state[self.beam.middle], base + state[self.beam.tip], force, direction == 0))
            t, x = phase.t[-1], phase.y[:, -1]
            if phase.status != 1:
                break
            force, before = self.reaction(t, x), direction
            direction = 0 if before != 0 and abs(force) < limit else -int(np.sign(force))
            if (before == 0) != (direction == 0):
                events.append((t, "capture" if direction == 0 else "onset", self.base(t) + x[self.beam.tip]))
        return samples, events


def undamped_in_free_modes(contact, times, modes, step):
    """Modes of the sliding beam, each exact over a step, with the friction of the step's mean sliding velocity."""
    beam, n = contact.beam, len(contact.beam.b)
    inverse_squares, left, right = linalg.eig(beam.M, beam.K, left=True, right=True)
    order = np.argsort(-inverse_squares.real)[:modes]
    w, left, right = np.sqrt(1.0 / inverse_squares.real[order]), left.real[:, order], right.real[:, order]
    left = left / np.einsum("in,ij,jn->n", left, beam.M, right)
    z, z1 = np.zeros(modes), left.T @ beam.M @ contact.start[n:]
    tip, middle, base, hit = right[beam.tip], right[beam.middle], -left.T @ beam.b, left[beam.tip]
    cos, sin, lag = np.cos(w * step), np.sin(w * step), (1 - np.cos(w * step)) / w**2
    mobility, limit = tip @ (hit * lag) / step, contact.friction(0.0)
    every = round((times[1] - times[0]) / step)
    step = (times[1] - times[0]) / every
    samples = [(0.0, 0.0, 0.0)]
    for i in range(round(times[-1] / step)):
        load = base * contact.base((i + 0.5) * step, 2)
        move = contact.base((i + 1) * step) - contact.base(i * step)
        free = (tip @ (z * (cos - 1) + z1 * sin / w + load * lag) + move) / step
        if abs(free) <= mobility * limit:
            force = -free / mobility
        else:
            v = free
            for _ in range(20):
                v = free - math.copysign(mobility * contact.friction(v), free)
            force = -math.copysign(contact.friction(v), free)
        load = load + hit * force
        z, z1 = z * cos + z1 * sin / w + load * lag, z1 * cos - z * w * sin + load * sin / w
        if (i + 1) % every == 0:
            h = contact.base((i + 1) * step)
            samples.append(((i + 1) * step, h + middle @ z, h + tip @ z))
    return samples


def slider_power(a, **options):
    """SDND104: x is the sliding velocity v and the work of 10 N |v|, smooth over the stop; the plane shakes with a sin(2 pi t)."""
    t, x, direction = 0.0, [0.0, 0.0], 0
    while t < 12.0:
        if direction == 0:  # it sticks while the inertia force is below 1 N
            if a <= 1.0:
                break
            if abs(a * math.sin(2 * math.pi * t)) <= 1.0:
                onset = math.asin(1 / a) / (2 * math.pi)
                t = onset + math.ceil(2 * (t - onset)) / 2
            direction = -1 if math.sin(2 * math.pi * t) > 0 else 1
            if t >= 12.0:
                break

        def rate(t, x):
            return [-a * math.sin(2 * math.pi * t) - direction, 10 * direction * x[0] if t >= 4 else 0.0]

        def stop(t, x):
            return direction * x[0]

        stop.terminal, stop.direction = True, -1
        end = 4.0 if t < 4.0 else 12.0
        phase = integrate.solve_ivp(rate, (t, end), x, events=stop, **options)
        t, x = phase.t[-1], phase.y[:, -1]
        if phase.status == 1:
            x[0] = 0.0
            direction = 0
    return x[1] / 8


def write(path, header, rows):
    with open(path, "w", newline="") as file:
        csv.writer(file).writerows([header, *rows])


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("problem")
    parser.add_argument("folder")
    parser.add_argument("--elements", type=int, default=20)
    parser.add_argument("--extrapolate", action="store_true")
    parser.add_argument("--method", default="RK45")
    parser.add_argument("--rtol", type=float, default=1e-3)
    parser.add_argument("--atol", type=float, default=1e-6)
    parser.add_argument("--modes", type=int)
    parser.add_argument("--step", type=float)
    given = parser.parse_args()
    beams = {row["beam"]: row for row in csv.DictReader(open(f"{REFERENCE}/beams.csv"))}
    options = {"method": given.method, "rtol": given.rtol, "atol": given.atol}
    result, paper = f"{given.folder}/result.csv", Beam(beams["paper"], given.elements)
    if given.problem.endswith("-frequencies"):
        state = given.problem.split("-")[0]
        asked = dict.fromkeys(row["beam"] for row in csv.DictReader(open(f"{REFERENCE}/frequencies/{state}.csv")))
        rows = [(name, i + 1, f) for name in asked for i, f in enumerate(
                    frequencies(beams[name], given.elements, state, given.extrapolate))]
        write(result, ["beam", "mode", "frequency"], rows)
    elif given.problem == "friction-powers":
        write(result, ["amplitude", "power"], [(a, slider_power(a, **options)) for a in (0.99, 1.01, 1.5, 15.0)])
    elif given.problem == "stick-history":
        samples, _ = Contact(paper, 15.0, 0.5e-3, 0.0).run(np.arange(1001) * 1e-3, can_slip=False, **options)
        write(result, ["time", "midspan_displacement", "friction_force"], [(s[0], s[1], s[3]) for s in samples[1:]])
    elif given.problem == "undamped-history-25":
        contact, times = Contact(paper, 25.0, 1e-3, 0.0), np.arange(1001) * 5e-4
        samples = undamped_in_free_modes(contact, times, given.modes, given.step) if given.modes else \
            contact.run(times, **options)[0]
        write(result, ["time", "tip_displacement", "midspan_displacement"], [(s[0], s[2], s[1]) for s in samples])
    else:
        samples, events = Contact(paper, 25.0, 1e-3, 6.4e-5).run(np.arange(2501) * 2e-4, **options)
        for i in range(len(events) - 2, -1, -1):  # a stick shorter than 2e-5 s counts as slip
            if events[i][1] == "capture" and events[i + 1][0] - events[i][0] < 2e-5:
                del events[i:i + 2]
        write(result, ["time", "phase", "tip_displacement", "friction_force"],
              [(f"{s[0]:.4f}", "stick" if s[4] else "slip", s[2], s[3]) for s in samples[1:]])
        write(f"{given.folder}/events.csv", ["index", "time", "change", "position"],
              [(i + 1, *event) for i, event in enumerate(events)])


main()
