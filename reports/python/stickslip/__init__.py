# SPDX-License-Identifier: MIT
"""Reference data for the stick-slip vibration of beams, and a judge of results, in Python alone.

load(name) gives a data set, judge(name, data_or_file) says whether results agree with it. criterion(), respond(), modes() and the
other names of COMMANDS run the program `stickslip`, where it is installed. reports/manual/python.md of the project has examples.
"""
from ._data import InputError, Table, load, names
from ._judge import Judgement, Quantity, judge
from ._program import COMMANDS, ProgramError, function_of, run

__version__ = "0.3.0"

__all__ = ["InputError", "Judgement", "ProgramError", "Quantity", "Table", "judge", "load", "names", "run", *COMMANDS]
globals().update({name: function_of(name) for name in COMMANDS})
