"""Differences are told no finer than a ruler reads them, wherever they stand; nor are lengths of nothing."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest
from support.boards import in_usual_size
from support.command import printed
from support.found_once import found_once as found_once
from support.readable import texts
from support.scenes import slider_crank, written

from graphic_tmm.chapters.forces.views import force_table
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.views import drawing_of
from graphic_tmm.language.numbers import percent_decimals
from graphic_tmm.readers.columns import Column
from graphic_tmm.readers.rounding import rounded_figures
from graphic_tmm.scene.read import read

PUMP = slider_crank(
    """speed = "12 rad/s"
positions = 12
zero = "10 deg"
[effects]
inertia = true
gravity = false
[[load]]
link = 3
point = "B"
force = "730 N"
[forces]
positions = [3, 7]
limit = "0.000001 %"
[diagrams]
point = "B"
[flywheel]
delta = 0.05
constant = "driving"
[hand]
ruler = {ruler}
[[sheet]]
format = "A1"
place = ["positions", "velocities", "forces", "lever", "force table", "diagrams", "flywheel"]
""",
    of_slider='mass = "12 kg"\ncentre = "B"\n',
)
PERCENT = re.compile(r"[-−]?[\d,.]+(?:·10[⁻\d]+)?(?= %)")


def decimals(figure: str) -> int:
    return len(figure.replace(",", ".").partition(".")[2]) if "·10" not in figure else 99


@pytest.mark.slow
@pytest.mark.turns(1)
@pytest.mark.usefixtures("found_once")
@pytest.mark.parametrize(("ruler", "most"), [('"0.1 mm"', 1), ('"0.5 mm"', 1), ('"exact"', 2)])
def test_no_difference_is_finer_than_the_ruler(tmp_path: Path, ruler: str, most: int) -> None:
    file = written(tmp_path, PUMP.replace("{ruler}", ruler))
    found = json.loads(printed("table", file, "-f", "json"))
    figures = [
        one["value"]
        for one in found["results"].values()
        if isinstance(one, dict) and one["unit"] == "%"
    ]
    for column in found["columns"]:
        if column["unit"] == "%":
            figures += [value for value in column["value"] if value is not None]
    assert len(figures) > 10
    assert [x for x in figures if round(x, most) != x] == []
    rows = [
        line for line in printed("table", file).split("\n") if "│ % │" in re.sub(" +", " ", line)
    ]
    assert len(rows) >= 3
    cells = [cell.strip() for line in rows for cell in line.split("│")[3:]]
    assert max(decimals(cell) for cell in cells if cell[-1:].isdigit()) <= most


def test_what_rounds_to_nothing_is_within_any_limit(tmp_path: Path) -> None:
    drawn = in_usual_size(read(written(tmp_path, PUMP.replace("{ruler}", '"exact"')))).boards[0]
    shown = " ".join(
        texts(
            [
                drawing_of(place.name)(drawn, True)
                for one in drawn.project.chapters
                for place in one.places
                if place.name == "lever"
            ]
        )
    )
    judged = re.findall(r"Δ = [^%]* % [≤>]", shown)
    assert judged
    assert all(one.endswith("≤") for one in judged)
    assert force_table(drawn, True)


def test_steps_tell_differences_as_tables_do(tmp_path: Path) -> None:
    file = written(tmp_path, PUMP.replace("{ruler}", '"exact"'))
    lines = [one for one in printed("steps", file).split("\n") if one.rstrip().endswith("%")]
    assert lines
    assert all(decimals(PERCENT.findall(line)[-1]) <= 2 for line in lines)


def test_a_length_of_nothing_has_no_digits() -> None:
    """An arm of 0.02 mm on paper, μ_l = 0.001 m/mm: 0.00002 m, not 0.0000200."""
    column = Column("forces", "h23", "h_{23}", "m", np.array([[0.02]]), np.array([[2e-5]]))
    (figures,) = rounded_figures([column])
    assert figures.places == 5


def test_a_ruler_tells_so_many_decimals() -> None:
    assert [percent_decimals(one) for one in (0.1, 0.5, 1.0, 0.02, None)] == [1, 1, 0, 2, 2]
    assert Drawn.percent_decimals.fget is not None
