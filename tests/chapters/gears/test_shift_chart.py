"""The chart of shifts: pairs inside can mesh, pairs outside cannot, each judged alone with its own shifts."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from random import Random

import pytest
import shapely
from support.boards import in_usual_size

from graphic_tmm.board.bounds import TaskError
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.gears.contact import record_checks, verdicts
from graphic_tmm.chapters.gears.dimensions import calculate_sizes
from graphic_tmm.chapters.gears.refusals import refuse_order
from graphic_tmm.chapters.gears.shift_chart import ADVISED, Chart, chart_of
from graphic_tmm.chapters.gears.task import GearTask
from graphic_tmm.chapters.gears.views import gear_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Stroke
from graphic_tmm.readers.findings import warnings
from graphic_tmm.scene.read import read

PITCH = 0.05
"""More than two cells of the widest chart below: 9 over 240, a corner of a limit lies within."""
PAIRS = [
    GearTask(12, 24, 0.005),
    GearTask(15, 25, 0.008),
    GearTask(20, 80, 0.002),
    GearTask(17, 17, 0.01, alpha=25.0),
    GearTask(14, 30, 0.003, beta=20.0),
    GearTask(24, 36, 0.004, ha=(1.1, 0.9)),
    GearTask(30, -70, 0.004),
    GearTask(35, 54, 0.004, alpha=14.5, ha=(1.2, 0.8), delta_y=0.0),
]


def fails(order: GearTask, x1: float, x2: float) -> set[str]:
    """Which checks a pair of these shifts fails that are no advice."""
    draft = Draft()
    checks = record_checks(draft, calculate_sizes(draft, replace(order, x1=x1, x2=x2)))
    wanted = [mark for check in checks for mark in (check.value, check.least)]
    reading = execute(draft.board.construction(), draft.given, wanted)
    # what cannot be calculated compares false: no pair
    return {one.name for one in verdicts(checks, reading) if not one.holds} - set(ADVISED)


def spots(area: shapely.Geometry, chart: Chart, dice: Random, count: int) -> list[complex]:
    """Shifts in a part of the plane, evenly."""
    found: list[complex] = []
    while len(found) < count:
        at = complex(
            dice.uniform(chart.low.real, chart.high.real),
            dice.uniform(chart.low.imag, chart.high.imag),
        )
        if shapely.contains_xy(area, at.real, at.imag):
            found.append(at)
    return found


@pytest.mark.parametrize("order", PAIRS, ids=str)
def test_pairs_inside_can_mesh_and_pairs_outside_cannot(order: GearTask) -> None:
    chart = chart_of(order)
    assert chart is not None
    dice = Random(str(order))
    shown = shapely.box(chart.low.real, chart.low.imag, chart.high.real, chart.high.imag)
    for at in spots(shapely.buffer(chart.region, -PITCH), chart, dice, 12):
        assert not fails(order, at.real, at.imag), at
    for at in spots(
        shapely.difference(shown, shapely.buffer(chart.region, PITCH)), chart, dice, 12
    ):
        assert fails(order, at.real, at.imag), at


def test_nothing_that_can_mesh_lies_beyond_what_is_shown() -> None:
    chart = chart_of(PAIRS[0])
    assert chart is not None
    for i in range(-5, 6):
        for j in range(-5, 6):
            at = complex(i, j)
            off = at - chart.low, chart.high - at
            if min(one for z in off for one in (z.real, z.imag)) < 0.0:
                assert fails(PAIRS[0], at.real, at.imag), at


def involute(angle: float) -> float:
    return math.tan(angle) - angle


def contact_ratio(z1: int, z2: int, x1: float, x2: float) -> float:
    """By radii in modules, 20°, the clearance kept whole."""
    alpha = math.radians(20.0)
    wanted = involute(alpha) + 2.0 * (x1 + x2) / (z1 + z2) * math.tan(alpha)
    low, high = 0.0, 1.4
    for _ in range(80):
        middle = (low + high) / 2.0
        low, high = (middle, high) if involute(middle) < wanted else (low, middle)
    a_w = (z1 + z2) / 2.0 * math.cos(alpha) / math.cos(low)
    lower = x1 + x2 - (a_w - (z1 + z2) / 2.0)
    ends = 0.0
    for z, x in ((z1, x1), (z2, x2)):
        tip, base = z / 2.0 + 1.0 + x - lower, z / 2.0 * math.cos(alpha)
        ends += math.sqrt(tip**2 - base**2)
    return (ends - a_w * math.sin(low)) / (math.pi * math.cos(alpha))


def test_lines_are_where_the_contact_ratio_has_that_value() -> None:
    chart = chart_of(PAIRS[0])
    assert chart is not None
    found = [one for one in chart.limits if one.value.letter == "ε_{α}"]
    assert [one.least for one in found] == [1.0, 1.2]
    for limit in found:
        for at in (at for path in limit.lines for at in path):
            due = contact_ratio(12, 24, at.real, at.imag)
            # the line goes straight through cells of 0.011: ε bends by less than 2 a unit, 2·0.011²/8 off
            assert due == pytest.approx(limit.least, abs=1e-4)


def test_the_least_shift_is_that_of_the_rack() -> None:
    """x_min = 1 − z·sin²α/2 of wheels without more than the usual rounding."""
    chart = chart_of(PAIRS[0])
    assert chart is not None
    left = next(one for one in chart.limits if one.value.letter == "x_1")
    due = 1.0 - 6.0 * math.sin(math.radians(20.0)) ** 2
    assert all(at.real == pytest.approx(due, abs=1e-9) for path in left.lines for at in path)


SCENE = """title = "T"
language = "en"
[gears]
z1 = {z1}
z2 = {z2}
m = "5 mm"
x1 = {x1}
x2 = 0.4
{more}
[[sheet]]
format = "A1"
"""


def test_shifts_that_are_taken_are_shown_wherever_they_are(tmp_path: Path) -> None:
    """Beside the region, too, with their letters of a helical pair, on both axes and in the caption."""
    more = 'chart = true\nbeta = "20 deg"'
    for x1 in (-1.3, 3.0):
        drawn = drawn_of(tmp_path, 24, 36, more, x1=x1)
        (view,) = (one for one in gear_views(drawn, True) if one.role == "gear-shifts")
        texts = [label.text for label in view.labels]
        assert f"K: x_{{n1}} = {x1:g}, x_{{n2}} = 0.4".replace("-", "−") in texts
        assert {"K", "x_{n1}", "x_{n2}"} <= set(texts)
        (dot,) = (one for one in view.strokes if isinstance(one, Stroke) and one.filled)
        frame = next(one for one in view.strokes if isinstance(one, Stroke) and one.closed)
        xs = [x for x, *_ in frame.path]
        assert min(xs) < min(x for x, *_ in dot.path)
        assert max(x for x, *_ in dot.path) < max(xs)


@pytest.mark.parametrize("more", ["", "chart = true"])
def test_it_is_drawn_where_it_is_asked_for(tmp_path: Path, more: str) -> None:
    drawn = drawn_of(tmp_path, 12, 24, more)
    views = {view.role or view.name: view for view in gear_views(drawn, True)}
    assert ("gear-shifts" in views) is bool(more)
    if more:
        texts = [label.text for label in views["gear-shifts"].labels]
        assert "K: x_1 = 0.5, x_2 = 0.4" in texts
        assert "ε_{α} = 1.2" in texts


def drawn_of(folder: Path, z1: int, z2: int, more: str, x1: float = 0.5) -> Drawn:
    path = folder / "scene.toml"
    path.write_text(SCENE.format(z1=z1, z2=z2, more=more, x1=x1), encoding="utf-8")
    (drawn,) = in_usual_size(read(path), exact=True).boards
    return drawn


def test_teeth_without_any_shifts_are_told(tmp_path: Path) -> None:
    order = GearTask(8, 9, 0.005)
    assert chart_of(order) is None
    for i in range(-3, 11):
        for j in range(-3, 11):
            assert fails(order, i / 5, j / 5)
    drawn = drawn_of(tmp_path, 8, 9, "chart = true")
    assert any("no shifts give" in one for one in warnings(drawn, "en"))
    assert "gear-shifts" not in {view.name for view in gear_views(drawn, True)}


def test_a_wheel_on_a_rack_has_none() -> None:
    order = GearTask(17, "rack", 0.005, x1=0.3, chart=True)
    with pytest.raises(TaskError, match="one shift") as caught:
        refuse_order(order)
    assert caught.value.keys == ("gears.chart",)
