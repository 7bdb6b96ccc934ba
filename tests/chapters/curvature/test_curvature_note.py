"""What a note concludes of curvature: its numbers stand in the log, in both languages; nothing of nothing."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from chapters.curvature.test_curvature_sheets import slider
from support.notes import looked_up, spoken

import graphic_tmm
from graphic_tmm.chapters.curvature.record import CURVATURE_PLAN
from graphic_tmm.chapters.curvature.table import off_name
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.note.document import Number, Runs, Text
from graphic_tmm.note.section_chapter import page_of
from graphic_tmm.readers.table import results_of
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.studio import make

CHAPTER = next(one for one in chapters() if one.name == "curvature")


def concluded(drawn: Drawn) -> list[Runs]:
    return [*page_of(drawn, CHAPTER, drawn.scene.language).concludes()]


def words(one: Runs) -> str:
    return "".join(run.text for run in one if isinstance(run, Text))


@pytest.mark.parametrize("language", ["en", "ru"])
def test_radii_circles_and_balls_point(language: str) -> None:
    made = spoken("coupler-curvature", language)
    drawn = made.boards[0]
    radius, circles, ball = concluded(drawn)
    start = {"en": "In position 1 ", "ru": "В положении 1 "}[language]
    for one, count in ((radius, 3), (circles, 2), (ball, 2)):
        assert words(one).startswith(start)
        numbers = [run for run in one if isinstance(run, Number)]
        assert len(numbers) == count
        for number in numbers:
            assert number.value == pytest.approx(looked_up(made, number), rel=1e-12)
    plans, bobillier, off = (run.value for run in radius if isinstance(run, Number))
    assert off >= 100.0 * abs(bobillier - plans) / plans - 0.051
    away, size = (run.value for run in circles if isinstance(run, Number))
    assert away == pytest.approx(size, rel=2e-3)  # 0.1 mm of 101 mm


def result(scene: dict[str, Any]) -> tuple[Drawn, float]:
    made: DrawnScene = make(graphic_tmm.read(scene))
    drawn = made.boards[0]
    (path,) = CURVATURE_PLAN.on(drawn).paths
    return drawn, float(results_of(drawn)[off_name(path)][0][0])


def test_of_an_exact_hand_both_radii_are_one() -> None:
    scene = {**slider(points=["K"], positions=[1, 2], circles=False), "hand": {"ruler": "exact"}}
    drawn, off = result(scene)
    assert off == 0.0
    assert len(concluded(drawn)) == 1


def test_where_nothing_is_drawn_nothing_is_concluded() -> None:
    """At a dead centre Q is nowhere: the construction is left out there, its sentence too."""
    drawn = make(graphic_tmm.read("coupler-curvature")).boards[0]
    made = CURVATURE_PLAN.on(drawn)
    nowhere: dict[Any, Any] = {one.mu: {} for one in made.figures}
    bare = replace(drawn, reach={**drawn.reach, "curvature": nowhere})
    assert concluded(bare) == []
    assert off_name(made.paths[0]) not in results_of(bare)
    assert np.isfinite(results_of(drawn)[off_name(made.paths[0])][0][0])
