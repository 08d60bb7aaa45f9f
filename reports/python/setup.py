# SPDX-License-Identifier: MIT
"""Copies the reference data of the repository into the package while it is built."""
import pathlib
import shutil

from setuptools import setup
from setuptools.command.build_py import build_py

DATA = pathlib.Path(__file__).resolve().parents[2] / "data/reference"


class BuildWithData(build_py):
    def run(self):
        super().run()
        if not self.editable_mode:
            shutil.copytree(DATA, pathlib.Path(self.build_lib) / "stickslip/reference", dirs_exist_ok=True)


setup(cmdclass={"build_py": BuildWithData})
