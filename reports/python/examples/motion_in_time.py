# SPDX-License-Identifier: MIT
"""A motion in time as arrays: how long the tip sticks, and its largest displacement. Needs the program `stickslip`."""
import stickslip

run = stickslip.respond("damped", duration=0.2, method="event-driven")
columns = run["columns"]
share = sum(state == "stick" for state in columns["state"]) / len(columns["state"])
print(f"{len(columns['time_s'])} rows, {100 * share:.0f} % of them in stick")
print(f"largest displacement {1e3 * max(map(abs, columns['tip_displacement_m'])):.3g} mm, {run['changes_of_contact']} changes of contact")
