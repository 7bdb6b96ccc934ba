"""What was written down amiss is told as that, not as a construction made so everywhere."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import pytest
from support.gallery import CASES
from support.own_told import kind_of, report_of, with_mistake
from support.own_told import told as compared

from graphic_tmm.checking.check import Checker, check
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import Likely, Taken
from graphic_tmm.scene.read import read

Change = Callable[[Taken], float]


@cache
def checker() -> Checker:
    return Checker(read(CASES / "check" / "six.toml"))


def told(where: tuple[str, str, str], change: Change) -> Likely:
    """Return what is told first of an honest drawing; ``change``: what is written of lengths ``where``."""
    plan, segment, position = where

    def at(one: Taken) -> bool:
        return all(
            wanted in ("", own)
            for wanted, own in zip((plan, segment, position), one.key, strict=True)
        )

    rows = [
        one._replace(mm=change(one)) if one.mm is not None and at(one) else one
        for one in read_readings(CASES / "check" / "honest_six_mm.csv")
    ]
    return checker().of(rows).report.mistakes[0]


def ten_times(one: Taken) -> float:
    return 10.0 * (one.mm or 0.0)


def larger(one: Taken) -> float:
    return round(1.25 * (one.mm or 0.0), 1)


def nothing(one: Taken) -> float:
    return 0.0


@pytest.mark.parametrize(
    ("where", "change", "family", "says"),
    [
        (("", "", "3"), ten_times, "table", "10 times"),
        (("velocities", "", "3"), ten_times, "table", "10 times"),
        (("accelerations", "", "1"), larger, "scale", "another scale"),
        (("velocities", "pc", ""), nothing, "table", "left out"),
    ],
)
@pytest.mark.slow
def test_it_is_told_where_it_was_written(
    where: tuple[str, str, str], change: Change, family: str, says: str
) -> None:
    found = told(where, change)
    assert (found.plan, found.segment, found.position) == where
    assert found.family == family
    assert says in found.says
    assert found.chance >= 0.4


@pytest.mark.turns(1)
@pytest.mark.parametrize("times", [0.87, 1.0, 1.25])
@pytest.mark.slow
def test_a_reversed_diagram_is_told_in_whatever_scale(times: float) -> None:
    """All signs of a are reversed, and it is 1.3, 1.5, 1.9 times as long as due: no scale factor does that."""
    rows = [
        one._replace(mm=times * one.mm) if one.segment == "a" and one.mm is not None else one
        for one in read_readings(CASES / "check" / "reversed_acceleration_diagram_frc.csv")
    ]
    first = check(read(CASES / "check" / "frc.toml"), rows).mistakes[0]
    assert (first.family, first.segment) == ("table", "a")
    assert "opposite signs" in first.says
    assert first.chance >= 0.8


@pytest.mark.parametrize(
    ("axis", "there"),
    [("x", lambda one: one._replace(x=-one.x)), ("y", lambda one: one._replace(y=-one.y))],
)
@pytest.mark.slow
def test_points_of_a_plan_counted_the_other_way_are_told_as_that(
    axis: str, there: Callable[[Taken], Taken]
) -> None:
    """Not as a vector drawn the other way and two positions exchanged, both sure."""
    rows = [
        there(one) if one.plan == "accelerations" and one.x is not None else one
        for one in read_readings(CASES / "check" / "honest_six_points.csv")
    ]
    (first,) = checker().of(rows).report.mistakes
    assert (first.family, first.plan) == ("table", "accelerations")
    assert first.says.startswith(f"the {axis} of the points")


@pytest.mark.parametrize(("name", "turn"), [("copy 0.9", 0), ("copy 0.9", 1), ("copy 1.03", 3)])
def test_a_copy_is_told_by_the_number_that_all_lengths_have(name: str, turn: int) -> None:
    """Also where none of them is wrong by itself."""
    drawing = with_mistake(kind_of(name), turn, 61000)
    report = report_of(drawing)
    assert not isinstance(report, str)
    one = compared(report, drawing)
    assert one.name
    assert one.sure
