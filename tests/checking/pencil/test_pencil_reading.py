"""A sheet read in pencil: where a plan stands on it, a second look, which points are readings."""

from __future__ import annotations

import functools
from collections.abc import Callable

import numpy as np
import pytest
from support.flat_sheets import FlatSheet, flat_sheet
from support.photographed.rubbed import flat, paper, rubbed
from support.photographed.student import Left, exact

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.checking.pencil.expected import ExpectedLine, ExpectedPlace, View, views
from graphic_tmm.checking.pencil.fitting import fit, robbed
from graphic_tmm.checking.pencil.lines import Track
from graphic_tmm.checking.pencil.points import SEEN, UNSEEN, UNSURE, Spot
from graphic_tmm.checking.pencil.reading import (
    SURELY,
    THERE,
    PhotoPoints,
    Point,
    again,
    questions,
    read_plans,
    readings,
    stood,
)
from graphic_tmm.checking.pencil.web import Pin, Web
from graphic_tmm.paper.ruled import Box

ENDS = (30 + 30j, 100 + 40j, 60 + 80j)


def plan() -> View:
    """Return three vectors from a pole."""
    places = 40 + 50j, *ENDS
    count = len(places)
    return View(
        "velocities",
        tuple(ExpectedPlace(at, ()) for at in places),
        tuple(ExpectedLine(places[0], at, (0, k)) for k, at in enumerate(ENDS, 1)),
        {},
        (np.empty((0, 2), dtype=np.complex128),) * count,
        (None, 0, 0, 0),
        np.zeros((4, count), dtype=np.complex128),
    )


@pytest.mark.parametrize("moved", [0j, 3 - 4j, 28 + 12j])
def test_a_plan_is_found_wherever_it_was_drawn(moved: complex) -> None:
    grey = paper()
    for line in plan().lines:
        grey = rubbed(grey, line.start + moved, line.end + moved)
    shift, cover = stood(flat(grey), plan())
    assert abs(shift - moved) < 1.5  # lines are followed from there
    assert cover > SURELY


def test_a_plan_that_is_nowhere_is_not_taken_for_another() -> None:
    grey = paper()
    for line in plan().lines:
        middle = line.start + 20 + 10j
        grey = rubbed(grey, middle, middle + (line.end - line.start) * np.exp(0.5j))
    assert stood(flat(grey), plan())[1] < THERE


@pytest.mark.turns(2, "sheets")
@pytest.mark.slow
def test_a_plan_of_one_position_has_points_and_lines() -> None:
    made, sheets = exact("lever")
    by = {one.name: one for one in views(made, sheets[0], HANDS["student"])}
    names = {name for place in by["accelerations-4"].places for name in place.names}
    assert {("accelerations", "a", "4"), ("accelerations", "b", "4")} <= names
    assert len(by["accelerations-4"].lines) > 5
    assert all(line.places for line in by["accelerations-4"].lines)


NO_INK = np.empty((0, 2), dtype=np.complex128)
POLE, LEFT, RIGHT = 20 + 20j, 20 + 80j, 110 + 30j


def view(astray: float = 2.0, of: tuple[int | None, ...] = (None, 0, 0)) -> View:
    """Return two points, seen from a pole, and the line between them."""
    random = np.random.default_rng(5)
    scatter = random.normal(0, 1, (60, 3)) + 1j * random.normal(0, 1, (60, 3))
    places = POLE, LEFT, RIGHT
    return View(
        "velocities",
        tuple(ExpectedPlace(at, ()) for at in places),
        (
            ExpectedLine(POLE, LEFT, (0, 1)),
            ExpectedLine(POLE, RIGHT, (0, 2)),
            ExpectedLine(LEFT, RIGHT, (1, 2)),
        ),
        {},
        (NO_INK,) * 3,
        of,
        scatter * np.array([0, astray, astray]),
    )


def test_a_point_that_was_seen_stands_where_it_was_seen() -> None:
    moved = 1.5 - 0.5j
    found = fit(view(), [(), (), ()], {1: Pin(moved, 0.2)})
    assert abs(found.moved[1] - moved) < 0.1
    assert found.spread(1, 1.0) < 0.25 < 1.0 < found.spread(2, 1.0)


def test_of_two_lines_the_one_from_where_the_point_was_seen_is_chosen() -> None:
    one = view()
    near, far = Track(0.2, 0.0, 0.95, 0.1), Track(-3.0, 0.0, 0.9, 0.1)
    assert fit(one, [(), (), (near, far)]).tracks[2] is near
    left = 1j * one.lines[2].way
    assert fit(one, [(), (), (near, far)], {1: Pin(-3.0 * left, 0.2)}).tracks[2] is far


def test_a_line_is_followed_again_from_where_its_points_were_seen() -> None:
    one = view()
    moved = 4.0 + 2.0j  # both points are off together: farther than the line was sought at first
    drawn = rubbed(paper(), LEFT + moved, RIGHT + moved)
    seen = [
        Spot(POLE, 0.1, UNSURE),
        Spot(LEFT + moved, 0.1, SEEN),
        Spot(RIGHT + moved, 0.1, SEEN),
    ]
    found = again(flat(drawn), one, 0j, [(), (), ()], seen).tracks[2]
    assert found is not None
    left = 1j * one.lines[2].way
    aside = (moved / left).real
    assert abs(found.start - aside) < 0.2
    assert abs(found.end - aside) < 0.2
    assert (
        again(flat(drawn), one, 0j, [(), (), ()], [Spot(POLE, 0.1, UNSURE)] * 3).tracks[0] is None
    )


def test_a_line_that_has_anothers_pencil_is_doubted_by_how_far_they_should_be_apart() -> None:
    at = [POLE, 90 + 24j, 90 + 20j]
    one = view()._replace(
        places=tuple(ExpectedPlace(z, ()) for z in at),
        lines=(ExpectedLine(POLE, at[1], (0, 1)), ExpectedLine(POLE, at[2], (0, 2))),
    )
    mine = Track(0.0, -4.0, 1.0, 0.1)  # the upper line lies where the lower one should be
    own = Track(0.0, 0.0, 1.0, 0.1)
    doubts = robbed(Web(one, {}), [(mine,), (own,)], [mine, None])
    assert set(doubts) == {0}
    assert abs(doubts[0][1]) > 3.5
    assert robbed(Web(one, {}), [(mine,), (own._replace(covered=0.4),)], [mine, None]) == {}
    fan = one._replace(of=(None, 0, 1))
    assert robbed(Web(fan, {}), [(mine,), (own,)], [mine, None]) == {}


SHEETS = (("slider-diagrams", 1), ("crank-rocker", 2))


@functools.cache
def read(name: str, number: int, seed: int, left: Left = Left()) -> tuple[FlatSheet, PhotoPoints]:  # noqa: B008
    drawn = flat_sheet(name, number, seed, left)
    made, sheets = exact(name)
    sheet = sheets[number - 1]
    flat = Flat(drawn.grey, Box(0, 0, sheet.width, sheet.height), drawn.dots)
    return drawn, read_plans(flat, views(made, sheet, HANDS["student"]), {})


@pytest.mark.turns(2, "sheets")
@pytest.mark.slow
def test_what_is_seen_is_where_the_student_drew_it(many: Callable[[int, int], int]) -> None:
    """With ``--measured`` of three students' drawings of a sheet."""
    off, drawn = [], 0
    for name, number in SHEETS:
        for seed in (0, 2, 3)[: many(3, 1)]:
            sheet, found = read(name, number, seed)
            due = sheet.paper.points
            drawn += sum(one.drawn for one in due.values())
            off += [
                abs(one.at - due[one.name].sheet)
                for one in found.points
                if one.how == SEEN and due[one.name].drawn
            ]
    assert len(off) > 0.3 * drawn
    assert np.quantile(off, 0.75) < 0.4
    assert np.mean(np.array(off) > 1.0) <= 0.01


@pytest.mark.turns(2, "sheets")
@pytest.mark.slow
def test_a_plan_that_is_not_there_is_asked_for() -> None:
    sheet, found = read("crank-rocker", 2, 1, Left(plans=1.0))
    assert not found.points
    assert set(found.missing) == {(key[0], key[2]) for key in sheet.paper.points}
    assert questions(found) == (
        "no plan of this sheet is seen in the photograph: is it upright, and is it this sheet (--sheet)?",
    )


@pytest.mark.turns(2, "sheets")
@pytest.mark.slow
def test_a_plan_that_stands_elsewhere_is_found_by_its_pole() -> None:
    drawn = flat_sheet("crank-rocker", 2, 3)
    made, sheets = exact("crank-rocker")
    sheet = sheets[1]
    moved = np.roll(drawn.grey, (40 * drawn.dots, -15 * drawn.dots), (0, 1))
    flat = Flat(moved, Box(0, 0, sheet.width, sheet.height), drawn.dots)
    due = views(made, sheet, HANDS["student"])
    pole = drawn.paper.poles["velocities", "0"] - 15 - 40j
    found = read_plans(flat, due, {("velocities", "0"): pole + 1 - 1j})
    off = [
        abs(one.spot - drawn.paper.points[one.name].spot) for one in found.points if one.how == SEEN
    ]
    assert len(off) >= 6
    assert np.median(off) < 0.4


def point(letter: str, how: str, position: str = "3", plan: str = "velocities") -> Point:
    return Point((plan, letter, position), 5 + 5j, 1.2345 - 2.0j, how, 5 + 5j)


def test_only_what_is_seen_is_a_reading() -> None:
    taken = readings([point("a", SEEN), point("b", UNSURE), point("c", UNSEEN)])
    assert [(one.key, one.x, one.y, one.line) for one in taken] == [
        (("velocities", "a", "3"), 1.23, -2.0, 2)
    ]


def test_what_is_not_seen_is_asked_for_by_name() -> None:
    points = (point("a", SEEN), point("b", UNSURE), point("c", UNSEEN), point("d", UNSURE))
    assert questions(PhotoPoints(points, (("accelerations", "2"), ("accelerations", "5")))) == (
        "Velocity plan, position 3: not sure of b, d in the photograph; read them off the paper",
        "Velocity plan, position 3: no c seen in the photograph",
        "Acceleration plan, position 2, 5: not seen in the photograph; if it stands elsewhere on the sheet, "
        "click its pole: --pole accelerations:2=x,y",
    )
    first = questions(PhotoPoints(points, ()), "ru")[0]
    assert first == "План скоростей, положение 3: на фотографии неясны b, d; снимите их с бумаги"
