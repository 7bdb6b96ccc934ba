"""Readings of two plates that links join (class IV), drawn by hand: right ones, and one mistake each."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest
from support.gallery import SHEETS
from support.joined_by_hand import Student

from graphic_tmm.checking.check import Checker
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import WRONG, Report
from graphic_tmm.scene.packaged import FILE
from graphic_tmm.scene.read import read


@cache
def checker() -> Checker:
    return Checker(read(SHEETS / "class-four" / FILE))


def report(student: Student) -> Report:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "readings.csv"
        path.write_text(student.csv(), "utf-8")
        return checker().of(read_readings(path)).report


def wrong(of: Report) -> set[tuple[str, str]]:
    return {(one.taken.plan, one.taken.segment) for one in of.readings if one.verdict == WRONG}


@pytest.mark.parametrize("mu", [(0.002, 0.0125, 0.1), (0.001, 0.01, 0.05)], ids=["coarse", "fine"])
@pytest.mark.parametrize("seed", range(3))
def test_a_right_drawing_is_right(seed: int, mu: tuple[float, float, float]) -> None:
    assert not wrong(report(Student(seed, mu)))


class Mistake(NamedTuple):
    """A mistake: some of its wrong rows, what is said of it first."""

    change: Callable[[Student], object]
    rows: set[tuple[str, str]]
    says: str = ""


def put(**what: object) -> Callable[[Student], object]:
    return lambda one: one.__dict__.update(what)


V = "velocities"
MISTAKES = {
    "along the arm": Mistake(put(way_of_plate=1.0), {(V, "aw25"), (V, "pw25")}),
    "the crossing of other lines": Mistake(
        put(crossing=(("A", "B"), ("D", "C"))),
        {(V, "b"), (V, "c")},
        "для W25 вместо (BC) взято (DC)",
    ),
    "mirrored": Mistake(
        put(similar=lambda share: share.conjugate()),
        {(V, "b"), (V, "c")},
        "для b фигура, подобная звену, построена зеркально",
    ),
    "ω the other way": Mistake(
        put(rates=lambda of: of.update(omega5=-of["omega5"])),
        {(V, "omega5")},
        "ω_5 направлено в обратную сторону",
    ),
    "a link too long": Mistake(
        put(fourth=0.155), {(V, "omega4")}, "заданное l_EF взято умноженным на 1,06"
    ),
}


@pytest.mark.parametrize("mistake", MISTAKES.values(), ids=list(MISTAKES))
def test_a_mistake_is_seen_where_it_was_made(mistake: Mistake) -> None:
    student = Student(3)
    mistake.change(student)
    of = report(student)
    assert wrong(of) >= mistake.rows
    if mistake.says:
        assert of.mistakes
        assert mistake.says in of.mistakes[0].says
