"""Two lines that meet, each drawn in the direction of the other, as a drawing made by hand shows it."""

from __future__ import annotations

import pytest
from support.own_student.machines import MACHINES
from support.own_student.mistakes import KINDS
from support.own_student.student import student
from support.own_told import report_of

ALONG = next(kind for kind in KINDS if kind.name == "t along the link")


@pytest.mark.turns(1)
@pytest.mark.parametrize("seed", [93000, 93001])
@pytest.mark.slow
def test_directions_of_two_lines_that_meet_are_exchanged(seed: int) -> None:
    """The velocity along the lever is drawn across it, that across it along it."""
    drawing = student(MACHINES["six"], seed, ALONG, way="mm and rates", mu=None, mu_rows=True)
    first, *_ = report_of(drawing).mistakes
    assert first.kind == "mistake"
    assert "the directions of (pa3) and (aa3) were exchanged" in " ".join((first.says, *first.like))
