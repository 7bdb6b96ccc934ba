"""The speed of the wheel behind a train, calculated beside the drawing: what is beside moves no mark of it."""

from __future__ import annotations

import math
from pathlib import Path

import pytest
from support.gallery import SHEETS
from support.scenes import edited

from graphic_tmm.chapters.planetary.behind import BEHIND, VIEW
from graphic_tmm.project import record
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

SCENE = SHEETS / "planetary" / "scene.toml"


def test_what_is_calculated_beside_a_drawing_moves_none_of_its_marks() -> None:
    """Its steps come after all others, and no other step uses what they leave."""
    log = record(read(SCENE), "planetary").construction
    beside = [step for step in log.steps if step.it.view == VIEW]
    others = [step for step in log.steps if step.it.view != VIEW]
    assert beside
    assert min(step.it.slot for step in beside) > max(step.it.slot for step in others)
    assert not {step.it for step in beside} & {mark for step in others for mark in step.uses}


def test_where_no_pair_stands_behind_nothing_is_calculated(tmp_path: Path) -> None:
    alone = edited(tmp_path, ("\nbehind", "\n# behind"), name="planetary")
    project = record(read(alone), "planetary")
    assert BEHIND.of(project) is None
    assert project.construction.view(VIEW) is None


def test_the_wheel_behind_turns_as_the_teeth_say() -> None:
    drawn = next(one for one in make(read(SCENE), exact=True).boards if one.board == "planetary")
    found = drawn.reading[BEHIND.on(drawn).speed].item()
    assert found * 30.0 / math.pi == pytest.approx(2888.0 / 7.6, rel=1e-12)
