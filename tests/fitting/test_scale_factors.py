"""Scale factors that the largest of what is drawn rules: chosen, named, told as declared."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from support import triangle

from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale, next_standard_length
from graphic_tmm.board.values import Number
from graphic_tmm.fitting.choice import choices
from graphic_tmm.fitting.scales import ScaleFactor
from graphic_tmm.scene.chapter import added
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

SCENE = 'title = "T"\n[[sheet]]\nformat = "A4"\n[triangle]\na = "60 mm"\nb = "50 mm"\n'
MU = Mark(0, "μ", Number, "v", "(m/s)/mm")
LARGE = ScaleFactor(MU, "v_{max}", 0.9, 250.0)


def test_the_largest_takes_its_room_but_where_the_scene_says_otherwise() -> None:
    assert LARGE.value == 0.004
    assert replace(LARGE, largest=0.6, lengths=True).value == 0.0025
    assert replace(LARGE, fixed=0.01).value == 0.01


@pytest.mark.parametrize(
    ("of_mu", "unit"), [("(m/s)/mm", "m/s"), ("m/mm", "m"), ("N/mm", "N"), ("1/mm", "")]
)
def test_the_largest_has_the_unit_of_the_scale_factor(of_mu: str, unit: str) -> None:
    assert replace(LARGE, mu=MU._replace(unit=of_mu)).unit == unit


def test_a_chapter_that_declares_one_has_its_value_and_its_choice(tmp_path: Path) -> None:
    scene = tmp_path / "scene.toml"
    scene.write_text(SCENE, "utf-8")
    with added(triangle.CHAPTER):
        (drawn,) = make(read(scene)).boards
        mu, told = triangle.TRIANGLE.on(drawn).mu, choices(drawn)
    assert drawn.scales["triangle"] == Scale("μ_l", 0.0005, "m/mm")
    step = told.construction.step(told.chosen[mu.slot])
    assert step is not None
    assert step.op == next_standard_length
    assert told.value(mu) == 0.0005
