"""What a scale factor that its author fixes leaves white is said; a part beside another fits its sheet."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from support import asked
from support.scenes import written

from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.compose import composed
from graphic_tmm.fitting.fit import fitted
from graphic_tmm.readers.findings import warnings
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make, sheets


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
