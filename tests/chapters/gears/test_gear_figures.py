"""What is told of a gear pair is what was drawn: no figure becomes 0 because a point lies far off."""

from __future__ import annotations

import numpy as np
import pytest
from support.gallery import made

from graphic_tmm.board.values import Length
from graphic_tmm.chapters.gears.task import GEARS


@pytest.mark.parametrize("name", ["gear-pair", "project"])
def test_lengths_of_the_meshing_are_told_as_they_were_drawn(name: str) -> None:
    drawn = next(one for one in made(name).boards if one.board == GEARS)
    marks = [
        step.it
        for step in drawn.construction.steps
        if step.it.view == "gear" and step.it.kind is Length
    ]
    told = {
        mark.name: (float(drawn.reading.figure(mark)[0, 0]), float(drawn.reading[mark][0, 0]))
        for mark in marks
    }
    assert len(told) > 20
    wrong = {
        name: both
        for name, both in told.items()
        if np.isfinite(both[1]) and abs(both[0] - both[1]) > 1e-3 * max(1.0, abs(both[1]))
    }
    assert not wrong
