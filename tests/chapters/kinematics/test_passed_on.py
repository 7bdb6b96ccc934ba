"""How well a row with ends passes its motion on: by the law of cosines, over the row alone."""

from __future__ import annotations

import math

import pytest
from support.drives import BOOM, LEVER, scene

from graphic_tmm.chapters.kinematics.turning import TURNING
from graphic_tmm.project import record
from graphic_tmm.readers.any_angles.turn import Passed


def _passed(text: str) -> Passed:
    found = TURNING.passed(record(scene(text), wanted=frozenset({"positions"})))
    assert found is not None
    return found


def test_a_boom_is_judged_over_the_row_of_its_rod() -> None:
    """The angle between rod and boom is least where the rod is out: 0.4 and 0.5 m hold it at 0.85 m."""
    found = _passed(BOOM)
    due = math.degrees(math.acos((0.5**2 + 0.85**2 - 0.4**2) / (2 * 0.5 * 0.85)))
    assert found.whole
    assert found.ends
    assert found.least == pytest.approx(due, abs=1e-6)


def test_a_row_that_leaves_the_range_does_not_assemble_whole() -> None:
    found = _passed(BOOM.replace('to = "850 mm"', 'to = "950 mm"'))
    assert not found.whole
    assert found.ends
    assert _passed(LEVER).whole
