"""A letter is there with what it names: in no picture of a series does one stand alone."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from support.boards import in_usual_size

from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.views import drawing_of
from graphic_tmm.paper.drawing import Bezier, Drawing, Ink, Label
from graphic_tmm.paper.figure import pictures
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.scene.read import read

CASES = Path(__file__).parents[1] / "cases" / "sheets"
TEETH = """
title = "A pair of wheels"
language = "en"
[gears]
z1 = 17
z2 = 29
m = "5 mm"
"""
CAM = """
title = "A cam"
language = "en"
[cam]
stroke = "30 mm"
rise = "120 deg"
upper_dwell = "20 deg"
fall = "120 deg"
law = "cosine"
pressure = "30 deg"
"""
NEAR = 8.0
"""So much nearer a letter may stand to ink of later pictures than to its own, mm; ω₁ stood 12 to 16 nearer."""


def drawings(drawn: Drawn) -> Iterator[Drawing]:
    """The views of a board, each once."""
    for chapter in drawn.project.chapters:
        for place in chapter.places:
            if not place.together:
                yield from (view for view in drawing_of(place.name)(drawn, True) if view.shows)


def spots(stroke: Ink) -> np.ndarray:
    """Places along a stroke, mm."""
    if isinstance(stroke, Bezier):
        return np.array(stroke.controls)
    corners = [complex(x, y) for x, y, _ in stroke.path]
    sides = (np.linspace(a, b, 2 + int(abs(b - a))) for a, b in pairwise(corners))
    return np.concatenate([corners, *sides])


def away(label: Label, ink: np.ndarray) -> float:
    """How far a letter is off ink, mm."""
    wide = letter(label.text, size=label.size, inclined=label.inclined).width
    left = {"start": 0.0, "middle": -wide / 2, "end": -wide}[label.anchor]
    grid = [left + wide * x / 6 + 1j * label.size * y / 3 for x in range(7) for y in range(4)]
    return float(np.abs(ink[:, None] - (label.at + np.array(grid))).min(initial=np.inf))


def alone(drawn: Drawn, view: Drawing) -> Iterator[tuple[int, str]]:
    """The letters of marks that stand nearer to ink of later pictures than to any of theirs."""
    shown = pictures(drawn.construction, view)
    inked = [[spots(stroke) for stroke in one.ink] for one in shown]
    whole = np.concatenate([row for some in inked for row in some])
    there = np.zeros(0, complex)
    for n, (one, some) in enumerate(zip(shown, inked, strict=True)):
        there = np.concatenate([there, *some])
        for label in one.letters:
            if label.of and away(label, there) > away(label, whole) + NEAR:
                yield n, label.text


PLANS = ("positions", "forces", "group", "lever")


@pytest.mark.slow
@pytest.mark.turns(1)
@pytest.mark.parametrize("case", ["upright.toml", "hydraulic.toml"])
def test_no_letter_stands_alone(case: str) -> None:
    (drawn,) = in_usual_size(read(CASES / case), exact=True).boards
    views = [view for view in drawings(drawn) if view.name.startswith(PLANS)]
    assert len(views) > 3
    assert {(view.name, *one) for view in views for one in alone(drawn, view)} == set()


@pytest.mark.parametrize("part", [TEETH, CAM])
def test_an_arrow_of_rotation_comes_with_what_turns(part: str, tmp_path: Path) -> None:
    file = tmp_path / "part.toml"
    file.write_text(part, encoding="utf-8")
    (drawn,) = in_usual_size(read(file), exact=True).boards
    there = {mark.slot for mark in drawn.construction.given}
    views = [view for view in drawings(drawn) if "scheme" not in view.name]
    arrows = [stroke for view in views for stroke in view.strokes if stroke.part == "sense"]
    assert arrows
    assert all(arrow.of for arrow in arrows)
    assert part is CAM or any(not there.issuperset(arrow.of) for arrow in arrows)
