"""Sheets that a student drew in pencil: where points are found, and what is asked for instead of guessed."""

from __future__ import annotations

import functools
from collections.abc import Callable

import numpy as np
import pytest
from support.flat_sheets import FlatSheet, flat_sheet
from support.photographed.student import Left, exact

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.pencil.darkness import Flat
from graphic_tmm.checking.pencil.expected import views
from graphic_tmm.checking.pencil.points import SEEN, UNSEEN, UNSURE
from graphic_tmm.checking.pencil.reading import Found, Point, asked, read_plans, readings
from graphic_tmm.paper.ruled import Box

SHEETS = (("slider-diagrams", 1), ("crank-rocker", 2))


@functools.cache
def read(name: str, number: int, seed: int, left: Left = Left()) -> tuple[FlatSheet, Found]:  # noqa: B008
    drawn = flat_sheet(name, number, seed, left)
    made, sheets = exact(name)
    sheet = sheets[number - 1]
    flat = Flat(drawn.grey, Box(0, 0, sheet.width, sheet.height), drawn.dots)
    return drawn, read_plans(flat, views(made, sheet, HANDS["student"]), {})


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


@pytest.mark.slow
def test_a_plan_that_is_not_there_is_asked_for() -> None:
    sheet, found = read("crank-rocker", 2, 1, Left(plans=1.0))
    assert not found.points
    assert set(found.missing) == {(key[0], key[2]) for key in sheet.paper.points}
    assert asked(found) == (
        "no plan of this sheet is seen in the photograph: is it upright, and is it this sheet (--sheet)?",
    )


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
    assert asked(Found(points, (("accelerations", "2"), ("accelerations", "5")))) == (
        "Velocity plan, position 3: not sure of b, d in the photograph; read them off the paper",
        "Velocity plan, position 3: no c seen in the photograph",
        "Acceleration plan, position 2, 5: not seen in the photograph; if it stands elsewhere on the sheet, "
        "click its pole: --pole accelerations:2=x,y",
    )
    first = asked(Found(points, ()), "ru")[0]
    assert first == "План скоростей, положение 3: на фотографии неясны b, d; снимите их с бумаги"
