"""Indicator diagrams are read off the log: of the scenes and of cylinders drawn at random."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.boards import drawn_of
from support.each import each
from support.flywheels import crank, scene_of
from support.gallery import asking, drawn
from support.graphs import assert_read_off_the_log

from graphic_tmm.chapters.indicator.ink import draw_indicator_ink
from graphic_tmm.chapters.indicator.plan import INDICATOR_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject
from graphic_tmm.scene.read import read

CYLINDERS = asking("indicator")


def assert_indicator(work: Drawn) -> None:
    made, project = INDICATOR_PLAN.on(work).indicator, work.project
    means = {side.mean: side.name for side in made.sides if side.mean is not None}
    names, log = project.names[: project.count], work.construction
    view = draw_indicator_ink(Subject(log, work.reading, "X"), {"": made}, names, means=means)
    assert_read_off_the_log(log, [finished(view)])
    levels = [stroke for stroke in view.strokes if stroke.part == "mean"]
    assert len(levels) == len(means)


@each("name", CYLINDERS)
def test_indicator_diagrams_of_the_scenes(name: str) -> None:
    assert_indicator(drawn(name, exact=True))


@pytest.mark.slow
@each("seed", range(40, 44))
def test_indicator_diagrams_of_cylinders_drawn_at_random(seed: int, tmp_path: Path) -> None:
    path = tmp_path / "machine.toml"
    path.write_text(scene_of(crank(seed), (8, 12, 17, 24)[seed % 4]), encoding="utf-8")
    assert_indicator(drawn_of(read(path), exact=True))
