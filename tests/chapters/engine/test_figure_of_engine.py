"""Force triangles and rotating vectors are read off the log, in every position."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.boards import drawn_of
from support.each import each
from support.engines import SCENE
from support.gallery import asking, drawn
from support.graphs import assert_read_off_the_log

from graphic_tmm.chapters.engine.ink import draw_rotating, draw_triangles
from graphic_tmm.chapters.engine.plan import ENGINE_PLAN
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject
from graphic_tmm.scene.read import read

ENGINES = asking("engine")


def triangles(work: Drawn) -> list[Drawing]:
    made, plans = ENGINE_PLAN.on(work), KINEMATICS_PLAN.on(work)
    pivot = plans.positions.point(plans.structure.origin)
    log, reading, rows = work.construction, work.reading, range(work.project.count)
    on = Subject(log, reading, "X")
    return [finished(draw_triangles(on, made, pivot, k, 40.0)) for k in rows]


def rotating(work: Drawn) -> list[Drawing]:
    made, log, reading = ENGINE_PLAN.on(work), work.construction, work.reading
    rows = range(work.project.count)
    on = Subject(log, reading, "X")
    return [finished(draw_rotating(on, made, k, 40.0)) for k in rows]


def assert_engine(work: Drawn) -> None:
    assert_read_off_the_log(work.construction, triangles(work))
    assert_read_off_the_log(work.construction, rotating(work))


@each("name", ENGINES)
def test_engines_of_the_scenes(name: str) -> None:
    assert_engine(drawn(name, exact=True))


@pytest.mark.slow
@each("crank", ["0.05", "0.1", "0.19"])
def test_upright_engines_with_other_cranks(crank: str, tmp_path: Path) -> None:
    path = tmp_path / "upright.toml"
    path.write_text(SCENE.replace('"100 mm"', crank), encoding="utf-8")
    assert_engine(drawn_of(read(path), exact=True))
