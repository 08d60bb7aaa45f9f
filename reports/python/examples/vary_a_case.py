# SPDX-License-Identifier: MIT
"""The margin to slip of a steel strip of several lengths: cases as dicts. Needs the program `stickslip`."""
import stickslip


def strip(length):  # m
    return {"beam": {"length": length, "material": "steel", "axial_force": "20 N"},
            "section": {"shape": "rectangle", "width": "20 mm", "height": "2 mm"},
            "friction": {"static_coefficient": 0.3}, "damping": {"ratio": 0.01},
            "excitation": {"frequency_hz": 25, "amplitude": "0.2 g", "duration": 1}}


lengths = [0.2, 0.3, 0.4]
for length, answer in zip(lengths, stickslip.criterion([strip(length) for length in lengths])):
    print(f"{length} m: {answer['verdict']}, margin {answer['margin']['lower']:.3g}")
