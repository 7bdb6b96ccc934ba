"""A wheel on the last shaft of a train drives a rack: how fast by rolling, where it stands; refusals."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction as F
from pathlib import Path

import pytest
from support import train_oracle as oracle
from support.scenes import calling

from graphic_tmm.chapters.trains.refusals import scheme_of
from graphic_tmm.chapters.trains.task import PlanetaryTask
from graphic_tmm.chapters.trains.views import planetary_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import StructureError
from graphic_tmm.paper.drawing import Stroke
from graphic_tmm.readers.table import results_of
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

SECTION = """[planetary]
scheme = "ring"
teeth = [{z1}, {z2}, {z3}]
module = "{m} mm"
speed = "{n} rpm"
driving = "1"
satellites = 1
rack = {z}
{behind}
"""


def drawn_of(folder: Path, behind: str, z: int, m: float, n: int, z1: int, z2: int) -> Drawn:
    section = SECTION.format(z1=z1, z2=z2, z3=z1 + 2 * z2, m=m, n=n, z=z, behind=behind)
    scene = read(calling(folder, section, sheet="", head='title = "T"\nlanguage = "en"\n'))
    (board,) = make(scene, exact=True).boards
    return board


def test_the_rack_runs_as_its_wheel_rolls(tmp_path: Path, many: Callable[[int, int], int]) -> None:
    """A point of the pitch line is as fast as one of the pitch circle, whatever pairs lie between."""
    draw = random.Random("rack")
    for _ in range(many(40, 4)):
        z1, z2, z = draw.randint(18, 40), draw.randint(20, 50), draw.randint(17, 60)
        m, n = draw.choice((2.0, 4.0, 5.5)), draw.choice((-1, 1)) * draw.randint(50, 2000)
        rows = [
            [draw.randint(17, 60) for _ in range(draw.randint(2, 3))]
            for _ in range(draw.randint(0, 2))
        ]
        board = drawn_of(tmp_path, f"behind = {rows}" if rows else "", z, m, n, z1, z2)
        found = results_of(board)
        due = oracle.solved("ring", (z1, z2, z1 + 2 * z2), {"1": F(n), "3": F(0)})
        assert due is not None
        turns = due["H"]
        for row in rows:
            turns *= F(row[0], row[-1]) * (-1) ** (len(row) - 1)
        # two pi r in a turn
        speed = float(turns) / 60.0 * math.tau * m * z / 2000.0
        assert found["planetary_v_rack"][0].item() == pytest.approx(speed, rel=1e-9)


def test_its_section_stands_below_the_wheel_with_its_number(tmp_path: Path) -> None:
    """Hatched, touched by the pitch circle of the wheel from above; both numbers are there, and the formula."""
    board = drawn_of(tmp_path, "behind = [[18, 36]]", 20, 4.0, 900, 20, 25)
    view = planetary_views(board, True)[0]
    texts = [label.text for label in view.labels]
    assert {"6", "7"} <= set(texts)
    assert any(text.startswith("v_7 = π·m·z_6·n_5/60") for text in texts)
    assert "n = 900/9 = 100 rpm" in texts
    boxes = [
        [complex(*at[:2]) for at in one.path]
        for one in view.strokes
        if isinstance(one, Stroke) and one.closed and len(one.path) == 4
    ]
    across = [
        (min(z.imag for z in box), max(z.imag for z in box), sum(z.real for z in box) / 4)
        for box in boxes
    ]
    mu = board.scales["planetary"].value
    high = 2.0 * 0.004 * 20 / 2.0 / mu
    (wheel,) = (
        one
        for one in across
        if one[1] - one[0] == pytest.approx(high, abs=1e-6) and one[2] == max(x for *_, x in across)
    )
    (rack,) = (
        one for one in across if one[1] == pytest.approx(wheel[0], abs=1e-9) and one[2] == wheel[2]
    )
    assert rack[0] < rack[1]


def test_the_speed_behind_has_no_sign_whichever_way_it_is_driven(tmp_path: Path) -> None:
    board = drawn_of(tmp_path, "behind = [[18, 36]]", 20, 4.0, -900, 20, 25)
    texts = [label.text for label in planetary_views(board, True)[0].labels]
    assert "n = 900/9 = 100 rpm" in texts


def test_where_no_shaft_is_no_rack_is(tmp_path: Path) -> None:
    order = PlanetaryTask("external", 0.004, 10.0, "H", "1", teeth=(36, 45), rack=20)
    bevel = replace(order, scheme="bevel", teeth=(24, 17, 24), driving="1", fixed="3")
    double = PlanetaryTask("ring", 0.004, (10.0, 4.0), ("1", "3"), "", teeth=(20, 25, 70), rack=20)
    for one in (order, bevel, double):
        with pytest.raises(StructureError) as caught:
            scheme_of(one)
        assert caught.value.keys == ("planetary.rack",)
