"""Sizes are chosen together: the smallest first, none alone; what rules a plan; what an author is told."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from support import asked
from support.mechanisms import sample
from support.scenes import edited, written

from graphic_tmm.chapters.kinematics.scales import ruling
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.compose import composed
from graphic_tmm.fitting.fit import fitted
from graphic_tmm.fitting.search import Search
from graphic_tmm.fitting.sizes import usual
from graphic_tmm.fitting.tried import Mechanism
from graphic_tmm.mechanism.records import Row
from graphic_tmm.readers.findings import warnings
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.studio import make, sheets

PLACES = ("positions", "velocities", "accelerations")


def random_scenes(count: int, seed: int, format: str = "A1") -> list[Scene]:
    order = (SheetOrder(format, PLACES),)
    return [
        Scene(
            f"{k}",
            "T",
            "en",
            one.mechanism,
            Row(8, zero=one.phi, accelerations=("0", "2")),
            sheets=order,
        )
        for k, one in enumerate(sample(count, seed))
    ]


@pytest.mark.parametrize("scene", random_scenes(2, 41), ids=lambda scene: scene.source)
def test_nothing_can_be_lifted_alone_on_the_same_sheets(scene: Scene) -> None:
    search = Search(scene, [Mechanism(scene)])
    sizes = search.sizes()
    most = search.written.count(sizes)
    search.rooms = search.written
    for name in search.own:
        assert search.lifted(sizes, [name], most) == [sizes]


def test_what_nothing_is_drawn_in_does_not_grow(tmp_path: Path) -> None:
    """Where the rod does not reach its guide there is no work of the cycle, and no curve of it."""
    scene = read(edited(tmp_path, ('l  = "0.64 m"', 'l  = "0.25 m"')))
    sizes = Search(scene, [Mechanism(scene)]).sizes()
    begun = usual(scene)
    assert all(size <= 10 * begun[name] for name, size in sizes.items())
    assert sizes["graphs"] == begun["graphs"]


@pytest.mark.turns(1, "sizes")
@pytest.mark.slow
@pytest.mark.parametrize("format", ["A1", "A4"])
def test_random_mechanisms_take_the_sheets_that_were_counted(
    format: str, many: Callable[[int, int], int]
) -> None:
    for scene in random_scenes(many(6, 2), 43, format):
        search = Search(scene, [Mechanism(scene)])
        counted = search.written.count(search.sizes())
        assert len(sheets(scene)[1]) <= counted


def test_one_position_in_ten_does_not_rule_a_plan() -> None:
    lengths = np.array([1.0, 1.1, 0.9, 1.0, 1.2, 1.0, 0.8, 1.0, 1.0, np.nan, 5.0, 1.1])
    most, over = ruling(range(12), lengths)
    assert most == 1.2
    assert list(over) == [10]
    assert over[10] == pytest.approx(5.0 / 1.2)
    # twice as long is no outlier, nor are two positions in twelve
    assert ruling(range(12), np.where(lengths == 5.0, 2.3, lengths))[0] == 2.3
    assert ruling(range(12), np.where(lengths == 0.8, 5.0, lengths))[0] == 5.0
    assert ruling(range(3), np.full(3, np.nan)) == (0.0, {})


def longest(drawn: Drawn, plan: str) -> float:
    return float(getattr(drawn.reach["kinematics"], plan)) / drawn.scales[plan].value


@pytest.mark.turns(1, "sizes")
@pytest.mark.slow
def test_a_fixed_scale_that_leaves_the_sheet_white_is_told_with_one_that_does_not(
    tmp_path: Path,
) -> None:
    def scene(mu: str) -> Scene:
        text = asked.mechanism(
            "slider", 8, [("A1", ("positions",))], language="en", scales=f"[scales]\nmu_l = {mu}"
        )
        return read(written(tmp_path, text))

    small = fitted(scene("0.01"))
    (told,) = [one for one in warnings(small) if "half white" in one]
    value, large = re.findall(r'mu_l = "([^"]+)" would draw the plan (\d+) mm', told)[0]
    found = fitted(scene(f'"{value}"'))
    assert longest(found, "positions") == pytest.approx(float(large), abs=0.5)
    assert longest(found, "positions") > 2 * longest(small, "positions")
    assert len(sheets(found.scene)[1]) == 1


@pytest.mark.turns(1, "sizes")
@pytest.mark.slow
def test_gears_beside_a_train_are_as_large_as_their_sheet_composes(tmp_path: Path) -> None:
    """The sheet of a project: a pair at 2:1 stands on it beside a train whose scale its author gave."""
    text = """\
title = "T"
language = "en"
[gears]
z1 = 15
z2 = 25
m = "8 mm"
x1 = 0.83
x2 = 0.445
[planetary]
scheme = "ring"
module = "8 mm"
speed = "2888 rpm"
driving = "1"
ratio = 4.55
tolerance = "0.3 %"
teeth = [25, "?", "?"]
satellites = 3
behind = [15, 25]
mu_l = "1:5"
[[sheet]]
format = "A1"
place = ["gears", "planetary"]
"""
    drawn = make(read(written(tmp_path, text)), exact=True)
    gear = next(board for board in drawn.boards if board.board == "gears")
    assert gear.scales["gear"].value == pytest.approx(0.0005)
    assert len(composed(drawn.scene, drawn.boards).sheets) == 1
