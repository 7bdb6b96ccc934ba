"""A coordinate that is 0 takes no step: points square to an axis are found on its normal."""

from __future__ import annotations

import cmath
from pathlib import Path

import numpy as np
from support.boards import in_usual_size, usual_part

from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.scene.read import read

CASE = Path(__file__).parents[2] / "cases" / "sheets" / "upright.toml"
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


def nothing(drawn: Drawn) -> list[str]:
    """The lengths carried to the board that are 0 in every position."""
    steps = [s for s in drawn.construction.steps if s.op.name in ("to_board", "along_turn")]
    reading = execute(drawn.construction, drawn.given, [step.it for step in steps])
    assert steps
    return [step.it.name for step in steps if np.all(reading[step.it] == 0)]


def test_no_step_of_a_mechanism_lays_off_nothing() -> None:
    drawn = in_usual_size(read(CASE), exact=True).mechanism
    assert drawn is not None
    assert nothing(drawn) == []
    made = KINEMATICS_PLAN.on(drawn)
    mm = 1.0 / drawn.scales["positions"].value
    own = {n: body for n, body in made.positions.bodies.items()}
    at = {
        letter: drawn.reading[mark][0]
        for body in own.values()
        for letter, mark in body.marks.items()
    }
    assert np.allclose(at["B"] - at["O"], -0.300j * mm, atol=1e-9)
    assert np.allclose(at["E"] - at["O"], 0.200 * mm, atol=1e-9)
    for tail, head, point, where in (
        ("O", "A", "S1", 0.020j),
        ("A", "C", "S2", -0.030j),
        ("A", "C", "K", 0.120 + 0.060j),
    ):
        way = at[head] - at[tail]
        assert np.allclose(at[point] - at[tail], where * mm * way / np.abs(way), atol=1e-9)
    assert cmath.isfinite(complex(at["C"][drawn.main]))


def test_the_base_of_a_cam_begins_at_its_origin(tmp_path: Path) -> None:
    file = tmp_path / "cam.toml"
    file.write_text(CAM, encoding="utf-8")
    assert nothing(usual_part("cam", read(file))) == []
