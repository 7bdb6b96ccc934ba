"""Readings of a plate on three legs, drawn by hand: right by any of Assur's points; one mistake each."""

from __future__ import annotations

import cmath
import math
import tempfile
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest
from support.plate_by_hand import LENGTHS, SCENE, Spots, Student, laid, turned

from graphic_tmm.checking.check import Checker
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import WRONG, Report
from graphic_tmm.scene.read import read

Change = Callable[[Student], object]
PAIRS = ((2, 4), (2, 5), (4, 5))
LAST = 3


@cache
def checker() -> Checker:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.toml"
        path.write_text(SCENE.format(language="en"), "utf-8")
        return Checker(read(path))


def report(student: Student, kinds: str = "points lengths figures") -> Report:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "readings.csv"
        path.write_text(student.csv(kinds), "utf-8")
        return checker().of(read_readings(path)).report


def wrong(of: Report) -> set[tuple[str, str]]:
    return {(one.taken.plan, one.taken.segment) for one in of.readings if one.verdict == WRONG}


@pytest.mark.parametrize("mu", [(0.002, 0.01, 0.15), (0.001, 0.0125, 0.2)], ids=["coarse", "fine"])
@pytest.mark.parametrize("pair", PAIRS)
def test_a_right_drawing_is_right_by_the_special_point_of_any_legs(
    pair: tuple[int, int], mu: tuple[float, float, float]
) -> None:
    """Measured: none of 36 such drawings has a wrong reading."""
    for kinds in ("points lengths figures", "points", "lengths figures"):
        student = Student(round(1e4 * mu[0]) + sum(pair), mu, pair)
        assert not wrong(report(student, kinds)), kinds


@pytest.mark.parametrize("pair", PAIRS)
def test_who_hands_in_no_special_point_is_right(pair: tuple[int, int]) -> None:
    student = Student(7, pair=pair)
    student.special = False
    assert not wrong(report(student))


def test_another_special_point_is_said_and_its_image_is_not_judged() -> None:
    of = report(Student(7, pair=(4, 5)))
    assert any("w3 is where another pair of legs puts it" in note for note in of.notes)
    assert not any(one.taken.segment == "w3" for one in of.readings)
    assert {one.taken.segment for one in of.readings} >= {"b", "c", "f", "omega3", "epsilon3"}


class Mistake(NamedTuple):
    """A mistake: some of its wrong rows, what is said of it first; none of others is wrong in other plans."""

    change: Change
    rows: set[tuple[str, str]]
    says: str = ""
    pair: tuple[int, int] = (2, 4)


def put(**what: object) -> Change:
    return lambda one: one.__dict__.update(what)


def way(name: str) -> Change:
    """Draw a line along a leg instead of square to it."""
    return put(ways=lambda ways: ways.update({name: 1j * ways[name]}))


def normal(name: str, share: float) -> Change:
    return put(normal=lambda mm: mm.update({name: share * mm[name]}))


def another_place(place: int, at: Spots) -> Spots:
    """Lay the plate in the place that is turned most from the right one."""
    every = laid(math.radians(30.0 * place), LENGTHS)
    return max(every, key=lambda one: abs(cmath.exp(1j * (turned(one) - turned(at))) - 1))


def in_one(change: Callable[[int, Spots], Spots]) -> Change:
    return put(places=lambda place, at: change(place, at) if place == LAST else at)


def mirrored(place: int, at: Spots) -> Spots:
    way = (at["C"] - at["B"]) / abs(at["C"] - at["B"])
    return {**at, "F": at["B"] + way * ((at["F"] - at["B"]) / way).conjugate()}


V, A, P = "velocities", "accelerations", "positions"
MISTAKES = {
    "velocity along the third leg": Mistake(
        way("leg5"), {(V, "f")}, "(pf) was drawn parallel to (EF) instead of square"
    ),
    "velocity along a leg": Mistake(
        way("leg2"), {(V, "w3")}, "(aw3) was drawn parallel to (AB) instead of square"
    ),
    "velocity along W3F": Mistake(
        way("plate"), {(V, "f"), (V, "omega3")}, "(w3f) was drawn parallel to (W3F)"
    ),
    "crank turned the other way": Mistake(
        put(crank_way=-1j), {(V, "a")}, "a has the opposite sense"
    ),
    "plate mirrored in its image": Mistake(
        put(similar=lambda share: share.conjugate()), {(V, "b"), (V, "c")}, "built mirrored for b"
    ),
    "acceleration away from the pivot": Mistake(
        put(out=1.0), {(A, "a")}, "a has the opposite sense"
    ),
    "another place": Mistake(
        put(places=another_place),
        {(P, "B"), (P, "C"), (P, "F")},
        "(BC) was laid in another of its places",
    ),
    "another place in one position": Mistake(
        in_one(another_place),
        {(P, "B"), (P, "C"), (P, "F")},
        "(BC) was laid in another of its places, at position 3 only",
    ),
    "the third leg too long": Mistake(
        put(size={**LENGTHS, "EF": 0.235}),
        {(P, "F")},
        "l_EF, which is given, was taken 1.17",
    ),
    "plate mirrored": Mistake(put(places=mirrored), {(P, "F")}),
    "a leg too long": Mistake(
        put(size={**LENGTHS, "AB": 0.22}), {(P, "B"), (P, "C"), (P, "F"), (V, "omega2")}
    ),
    "ω of the plate the other way": Mistake(
        put(rates=lambda of, place: of.update(omega3=-of["omega3"])),
        {(V, "omega3")},
        "ω_3 has the opposite sense",
    ),
    "ω of the plate the other way, by other legs": Mistake(
        put(rates=lambda of, place: of.update(omega3=-of["omega3"])),
        {(V, "omega3")},
        "ω_3 has the opposite sense",
        (2, 5),
    ),
    "normal one from the special point left out": Mistake(
        normal("n3", 0.0), {(A, "n3")}, "w3n3 was left out"
    ),
    "normal one to the special point left out": Mistake(
        normal("n3b", 0.0), {(A, "n3b")}, "n3b was left out"
    ),
    "normal one to the special point the other way": Mistake(
        normal("n3b", -1.0), {(A, "n3b")}, "n3b has the opposite sense"
    ),
    "normal one of a leg left out": Mistake(normal("n5", 0.0), {(A, "n5")}, "πn5 was left out"),
    "ω of the crank": Mistake(put(omega=12.0), {(V, "pa")}, "ω_1, which is given"),
}


@pytest.mark.parametrize("mistake", MISTAKES.values(), ids=list(MISTAKES))
def test_a_mistake_is_seen_where_it_was_made(mistake: Mistake) -> None:
    student = Student(3, pair=mistake.pair)
    mistake.change(student)
    of = report(student)
    assert wrong(of) >= mistake.rows
    said = of.mistakes[0] if of.mistakes else None
    if mistake.says:
        assert said is not None
        assert mistake.says in said.says
    else:
        assert said is None or said.chance < 0.8, said
