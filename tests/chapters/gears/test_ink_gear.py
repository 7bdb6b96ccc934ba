"""The gear pair in ink: outlines on the board's curves, circles, letters that stand clear, views with room."""

from __future__ import annotations

from functools import cache
from itertools import combinations, pairwise

import numpy as np
import pytest
import shapely
from support import gallery
from support.each import each
from support.teeth import Pair, dense, pair, profile

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.gears.ink import draw_gear_ink
from graphic_tmm.chapters.gears.ink_rolling import draw_rolling_ink
from graphic_tmm.chapters.gears.ink_sliding import draw_sliding_ink
from graphic_tmm.chapters.gears.rolling import along_arc
from graphic_tmm.chapters.gears.table import dimension_table, sliding_table
from graphic_tmm.chapters.gears.task import GearTask
from graphic_tmm.paper.drawing import Bezier, Drawing, Sheet, Stroke
from graphic_tmm.paper.formats import HEIGHTS
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.seen import Subject
from graphic_tmm.paper.shapes import box, flat, shape
from graphic_tmm.paper.write.svg import svg

WINDROWER = GearTask(15, 25, 0.008, 0.83, 0.445, stations=(23.5, 47.0, 94.0, 141.0, 164.5))
ORDERS = (
    WINDROWER,
    GearTask(6, 30, 0.008, 0.9, 0.0),
    GearTask(8, 20, 0.008),
    GearTask(20, 200, 0.008, 0.2, -0.2),
    GearTask(6, 60, 0.008),
)
WALL = HEIGHTS["A1"]
VIEWS = ("gear", "rolling 1", "rolling 2", "sliding")


@cache
def drawn(order: GearTask = WINDROWER) -> Pair:
    return pair(order)


def subject(of: Pair) -> Subject:
    return Subject(of.log, of.reading, "X", WALL, "ru")


def view(name: str, order: GearTask = WINDROWER, *, lettered: bool = True) -> Drawing:
    of = drawn(order)
    if name == "gear":
        made = draw_gear_ink(subject(of), of.gear)
    elif name == "sliding":
        made = draw_sliding_ink(subject(of), of.gear)
    else:
        k = int(name[-1]) - 1
        made = draw_rolling_ink(subject(of), of.gear, k)
    return finished(made, lettered)


def main(of: Drawing) -> list[shapely.Geometry]:
    return [shape(s) for s in of.strokes if s.pen == "main"]


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("order", ORDERS)
@each("name", VIEWS)
def test_every_view_can_be_drawn_and_its_letters_stand_clear(name: str, order: GearTask) -> None:
    made = view(name, order)
    boxes = [box(label) for label in made.labels]
    assert all(a.disjoint(b) for a, b in combinations(boxes, 2))
    assert "nan" not in svg(Sheet("s", "X", "A1", 841.0, 594.0, (made,)))


@pytest.mark.slow
@pytest.mark.parametrize("order", ORDERS[:2])
@pytest.mark.parametrize("name", VIEWS)
def test_an_unlettered_view_takes_about_the_room_of_a_lettered_one(
    name: str, order: GearTask
) -> None:
    bare, made = view(name, order, lettered=False), view(name, order)
    assert bare.cell is not None
    room = shapely.box(*bare.cell)
    assert all(room.covers(shape(s)) for s in made.strokes if s.part != "leader")
    assert all(room.buffer(15.0).covers(box(label)) for label in made.labels)


@pytest.mark.slow
@pytest.mark.parametrize("order", ORDERS)
def test_the_outline_is_that_of_the_board(order: GearTask) -> None:
    of = drawn(order)
    lines = main(view("gear", order))
    ink = shapely.union_all(lines)
    for wheel in of.gear.wheels:
        for tooth in wheel.teeth:
            for side in (tooth.right, tooth.left):
                spots = profile(of, side)
                away = shapely.distance(ink, shapely.points(spots.real, spots.imag))
                assert away.max() < 0.02  # eight chords an arc stand for the ink


def test_the_outline_of_a_wheel_is_one_line() -> None:
    ends = []
    for stroke in view("gear").strokes:
        if stroke.pen == "main" and not getattr(stroke, "filled", False):
            curve = isinstance(stroke, Bezier)
            path = stroke.controls if curve else [complex(x, y) for x, y, _ in stroke.path]
            ends += [path[0], path[-1]]
    apart = np.abs(np.array(ends)[:, None] - np.array(ends)[None, :])
    loose = (apart < 1e-3).sum(axis=1) == 1
    assert loose.sum() == 4  # the two ends of each wheel's root


def test_circles_lie_on_their_radii() -> None:
    of = drawn()
    sizes = of.gear.sizes
    made = view("gear")
    arcs = [s for s in made.strokes if isinstance(s, Stroke) and s.pen in ("thin", "centre")]
    for k, wheel in enumerate(sizes.wheels):
        centre = of.one(of.gear.line.circles[k].centre)
        for mark in (wheel.r, wheel.r_b, wheel.r_w, wheel.r_f, wheel.r_a):
            due = 1000 * of.real(mark) / of.mm
            radii = [
                {round(abs(complex(x, y) - centre), 6) for x, y, _ in s.path}
                for s in arcs
                if any(bulge for *_, bulge in s.path)
            ]
            assert {round(due, 6)} in radii


def test_the_working_line_is_drawn_from_a_to_b() -> None:
    of = drawn()
    ends = {of.one(mark) for mark in of.gear.line.ends}
    (stroke,) = [
        s for s in view("gear").strokes
        if isinstance(s, Stroke) and s.pen == "medium" and len(s.path) == 2
        and not any(b for *_, b in s.path)
    ]  # fmt: skip
    assert {complex(x, y) for x, y, _ in stroke.path} == ends


def test_letters_of_the_meshing() -> None:
    texts = {label.text for label in view("gear").labels}
    assert {
        "O_{1}", "O_{2}", "P", "N_{1}", "N_{2}", "a", "b", "a′", "b′", "α_{w}", "ω_{1}", "ω_{2}",
        "c_{1}", "d_{1}", "c_{2}", "d_{2}", "r_{a1}", "r_{1}", "r_{w1}", "r_{b1}", "r_{f1}",
        "r_{a2}", "r_{2}", "r_{w2}", "r_{b2}", "r_{f2}", "a_{w} = 168,68",
    } == texts  # fmt: skip


def test_a_centre_too_far_is_left_out() -> None:
    far = view("gear", GearTask(20, 200, 0.008, 0.2, -0.2))
    left, low, right, top = bounds(far)
    assert top - low < 450.0
    assert right - left < 450.0
    assert not any(label.text.startswith("a_{w}") for label in far.labels)
    assert "O_{2}" in {label.text for label in far.labels}
    assert "ω_{2}" not in {label.text for label in far.labels}


@pytest.mark.parametrize("k", [0, 1])
def test_the_circles_of_a_rolled_tooth_are_drawn(k: int) -> None:
    of, made = drawn(), view(f"rolling {k + 1}")
    wheel = of.gear.sizes.wheels[k]
    centre = of.one(of.gear.line.circles[k].centre)
    bows = [s for s in made.strokes if isinstance(s, Stroke) and s.path[0][2] and not s.closed]
    radii = {round(abs(complex(*s.path[0][:2]) - centre), 6) for s in bows}
    for mark in (wheel.r_a, wheel.r, wheel.r_b, wheel.r_f):
        assert round(1000 * of.real(mark) / of.mm, 6) in radii


@pytest.mark.parametrize("k", [0, 1])
def test_each_rolled_tangent_touches_the_base_circle_and_ends_on_the_involute(k: int) -> None:
    of = drawn()
    wheel = of.gear.wheels[k]
    centre, base = of.one(wheel.circles.centre), 1000 * of.real(wheel.sizes.r_b) / of.mm
    made, count = view(f"rolling {k + 1}", lettered=False), wheel.roll.count
    lines = {
        tuple(complex(x, y) for x, y, _ in s.path)
        for s in made.strokes
        if isinstance(s, Stroke) and s.pen == "thin" and len(s.path) == 2
    }
    curve = dense(of.reading[wheel.flank])
    pairs = list(zip(of.row(wheel.feet, count), of.row(wheel.points, count), strict=True))
    assert {(complex(a), complex(b)) for a, b in pairs} <= lines
    for foot, end in pairs:
        assert abs(foot - centre) == pytest.approx(base)
        assert abs(((foot - centre).conjugate() * (end - foot)).real) < 1e-9 * base**2
        assert np.abs(curve - end).min() < 1e-9


def place(of: Pair, mark: Mark, k: int) -> complex:
    """Where a mark is, or what a length is, at one place of its row."""
    row = of.reading[mark][0]
    return complex(row[k if row.size > 1 else 0])


def test_an_arc_that_dividers_step_off_is_as_long_as_they_are_open() -> None:
    """It begins at the point that is known and ends at the mark; so the string is as long as its arc."""
    of, made = drawn(), view("gear", lettered=False)
    stepped = {step.it.slot: step for step in of.log.steps if step.op is along_arc}
    bows = [s for s in made.rubbed if len(s.of) == 1 and s.of[0] in stepped]
    for bow in bows:
        assert isinstance(bow, Stroke)
        step, k, length = stepped[bow.of[0]], bow.position or 0, 0.0
        for (x, y, bulge), (u, v, _) in pairwise(bow.path):
            half = 2 * np.arctan(bulge)
            length += abs(complex(u - x, v - y)) * half / np.sin(half)
        start, opening, end = (place(of, mark, k) for mark in (*step.uses[::2], step.it))
        ends = [complex(x, y) for x, y, _ in (bow.path[0], bow.path[-1])]
        assert ends == pytest.approx([start, end])
        assert length == pytest.approx(abs(opening))
    assert len(bows) == 2 * (3 + 15 + 13)


def test_the_curves_of_sliding_go_to_one_over_the_limits() -> None:
    of = drawn()
    mu, length = of.real(of.gear.sliding.chart.mu), of.real(of.gear.line.length)
    curves = [flat(s.controls) for s in view("sliding").strokes if isinstance(s, Bezier)]
    assert len(curves) == 2
    for curve, end in zip(curves, (length, 0.0), strict=True):
        assert curve[-1] == pytest.approx(complex(end, 1 / mu))
        assert curve[0].imag == pytest.approx(-of.gear.sliding.floor / mu)
    texts = {label.text for label in view("sliding").labels}
    assert {
        "N_{1}",
        "a",
        "P",
        "b",
        "N_{2}",
        "ϑ_{1}",
        "ϑ_{2}",
        "ϑ",
        "x, мм",
        "1",
        "−1",
        "−4",
    } <= texts


def test_the_table_of_sliding_is_that_of_the_windrower() -> None:
    of = pair(GearTask(15, 25, 0.008, 0.83, 0.445, mu=0.0004217, stations=WINDROWER.stations))
    texts = [label.text for label in sliding_table(of.drawn, "ru", "X", WALL).labels]
    for figure in ("−3,030", "−0,715", "0,442", "0,828", "0,939", "0,752", "0,417", "−0,793",
                   "−4,82", "−15,27", "68,0", "181,4", "−∞"):  # fmt: skip
        assert figure in texts
    texts = [label.text for label in dimension_table(of.drawn, "ru", "X", WALL).labels]
    for figure in ("56,382", "93,969", "168,683", "73,123", "110,043", "16,483", "26,96", "1,158",
                   "1,667", "14,483", "142,3", "41,3", "39,1", "59,6", "400,0"):  # fmt: skip
        assert figure in texts


def test_feet_that_stand_close_are_numbered_by_fives() -> None:
    """At 1:2 the tangents of a tooth stand a millimetre apart: letters of 3.5 mm have no room at each."""
    of = drawn(GearTask(15, 25, 0.008, 0.83, 0.445, mu=0.002))
    made = draw_rolling_ink(subject(of), of.gear, 0)
    feet = [one for one in made.wanted if one.of == (of.gear.wheels[0].feet.slot,)]
    assert {int(one.text) for one in feet} == {5, 10, 15}
    apart = [abs(b.at - a.at) for a, b in pairwise(feet)]
    assert min(apart) > 3.5
    usual = drawn()
    whole = draw_rolling_ink(subject(usual), usual.gear, 0)
    numbers = [one for one in whole.wanted if one.text.isdigit()]
    assert len(numbers) == usual.gear.wheels[0].roll.count


def test_at_the_pitch_point_neither_tooth_slides_whatever_the_ruler_makes_of_it() -> None:
    (work,) = gallery.made("gear-pair").boards
    assert work.scene.ruler is not None
    view = sliding_table(work, "ru", "X", WALL)
    (column,) = (label.at.real for label in view.labels if label.text == "P")
    below = [label.text for label in view.labels if abs(label.at.real - column) < 1.0]
    assert below[0] == "P"
    assert below[2:] == ["0", "0"]
