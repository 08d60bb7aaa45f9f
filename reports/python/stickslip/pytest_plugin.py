# SPDX-License-Identifier: MIT
"""pytest: stickslip_agrees(name, data, ...) fails unless results agree with a data set; its arguments are those of judge()."""
import pytest

from ._judge import judge


@pytest.fixture
def stickslip_agrees():
    def agrees(name, data, **options):
        __tracebackhide__ = True
        judgement = judge(name, data, **options)
        if not judgement:
            pytest.fail(str(judgement), pytrace=False)
        return judgement
    return agrees
