"""Readings of instantaneous centres by who crosses Kennedy's lines by hand: right ones, one mistake each."""

from __future__ import annotations

import math
import re
import tempfile
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest
from support.centres_by_hand import FAR, SIX_BAR, Student, Way
from support.gallery import SHEETS

from graphic_tmm.checking.check import Checker
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import FINE, WRONG, Report
from graphic_tmm.scene.read import read

Change = Callable[[Student], object]
SLIDER = """
title = "Мгновенные центры"
language = "ru"
frame = { O = [0, 0], x = { through = [0, "-30 mm"], angle = "0 deg" } }
[[link]]
number = 1
points = { O = [0, 0], A = ["90 mm", 0] }
[[link]]
number = 2
points = { A = [0, 0], B = ["260 mm", 0] }
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
[drive]
link = 1
speed = "20 rad/s"
turns = "counterclockwise"
positions = 12
first = 1
zero = "0 deg"
[centres]
positions = [2, 6]
mu_l = "0.002 m/mm"
[hand]
ruler = "0.5 mm"
[[sheet]]
format = "A1"
place = ["given", "positions", "centres"]
"""


@cache
def checker(six: bool) -> Checker:
    if six:
        return Checker(read(SHEETS / "centres-of-six-bar" / "scene.toml"))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "scene.toml"
        path.write_text(SLIDER, "utf-8")
        return Checker(read(path))


def report(student: Student, kinds: str = "points lengths figures") -> Report:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "readings.csv"
        path.write_text(student.csv(kinds), "utf-8")
        return checker(student.six).of(read_readings(path)).report


def bare(segment: str) -> str:
    return re.sub(r"[_{}]", "", segment)


def wrong(of: Report) -> set[str]:
    return {bare(one.taken.segment) for one in of.readings if one.verdict == WRONG}


def following(of: Report) -> set[str]:
    """Return what is off, yet right by the student's own earlier readings."""
    rows = (one for one in of.readings if one.verdict == FINE and one.follows is not None)
    return {bare(one.taken.segment) for one in rows}


@pytest.mark.parametrize("six", [True, False], ids=["six-bar", "slider-crank"])
@pytest.mark.parametrize("mu", [0.002, 0.0025, 0.004])
def test_right_readings_are_accepted_at_any_scale(mu: float, six: bool) -> None:
    """Measured: of 40 such drawings none has a wrong reading."""
    for kinds in ("points lengths figures", "points", "lengths figures"):
        student = Student(round(1e4 * mu), mu, six=six)
        assert not wrong(report(student, kinds)), kinds


class Mistake(NamedTuple):
    """A mistake: which rows are wrong as ``his`` own, some that ``follow``, what is said of it first.

    Of a P_13 that lies on no line of the frame's pivots, what is measured along that line is wrong, too.
    """

    change: Change
    his: str
    follow: str = ""
    says: str = ""
    six: bool = True
    kinds: str = "points lengths figures"


def way(name: str, *through: str) -> Change:
    return lambda one: one.ways.update({name: through})  # type: ignore[dict-item]


def length(name: str, *ends: str) -> Change:
    return lambda one: one.lengths.update({name: ends})  # type: ignore[dict-item]


def put(**what: object) -> Change:
    return lambda one: one.__dict__.update(what)


def times(name: str, by: float) -> Callable[..., object]:
    return lambda of, *more: of.update({name: of[name] * by})


def inverse(name: str) -> Callable[..., object]:
    return lambda of: of.update({name: 1.0 / of[name]})


def speed(name: str, rate: str, of_length: str, mu: float = 0.0025) -> Callable[..., object]:
    return lambda of, mm: of.update({name: abs(of[rate]) * mm[of_length] * mu})


def in_rpm(of: dict[str, float]) -> None:
    of.update({name: of[name] * 30 / math.pi for name in of if name.startswith("omega")})


def exchanged(of: dict[str, float]) -> None:
    of["omega2"], of["omega3"] = of["omega3"], of["omega2"]


def misread(by: float, name: str) -> Callable[..., object]:
    return lambda mm, place: mm.update({name: mm[name] + by})


TWO = "lengths figures"
MISTAKES: Mapping[str, Mistake] = {
    "P13: O to C for O to D": Mistake(way("13", "12", "23", "10", "24"), "P13 P13O P13D P35", "vB"),
    "P13: A to D, O to B": Mistake(
        way("13", "12", "30", "10", "23"), "P13 P13O", "u31 omega3 vB P35"
    ),
    "P14: A to B for A to C": Mistake(
        way("14", "12", "23", "10", "40"), "P14 P35", "P15 u41 omega4 vC vE"
    ),
    "P14: O to D for O to P40": Mistake(
        way("14", "12", "24", "10", "30"),
        "P14",
        "P15 P14O u41 omega4 vE",
        "for P_14 (OD) was taken instead of (P_13P_34)",
    ),
    "P20: C to D for B to D": Mistake(
        way("20", "12", "10", "24", "30"), "P20", "P40 P34 P14 AP20 u21 omega2"
    ),
    "P34: D to P20 for D to P40": Mistake(way("34", "23", "24", "30", "20"), "P34"),
    "P40: at the pin": Mistake(way("40", "24", "45", "45", FAR), "P40", "P34 P14 P15 P40C u41 vC"),
    "guide taken along": Mistake(
        put(square=1 + 0j),
        "P40 P15 P35",
        "P34 P14 P40C u41 vE",
        "(EP_50) was drawn parallel to (z) instead of square",
    ),
    "guide taken along, lengths": Mistake(
        put(square=1 + 0j), "OP15 P14O P14P40 P40C u41", "omega4 vE", kinds=TWO
    ),
    "P15: O to E for square to the guide": Mistake(
        way("15", "14", "45", "10", "45"), "P15", "P35 P25 OP15 vE"
    ),
    "u31 upside down": Mistake(
        put(ratios=inverse("u31")), "u31", "omega3 vB", "u_31 was calculated as P_13D/P_13O"
    ),
    "u41 upside down": Mistake(
        put(ratios=inverse("u41")), "u41", "omega4 vC", "u_41 was calculated as P_14P_40/P_14O"
    ),
    "u21 without its sign": Mistake(
        put(ratios=times("u21", -1)), "u21", "omega2", "u_21 has the opposite sense"
    ),
    "u31 with the other sign": Mistake(
        put(ratios=times("u31", -1)), "u31", "omega3", "u_31 has the opposite sense"
    ),
    "P14O from D": Mistake(
        length("P14O", "14", "30"), "P14O", "omega4 u41 vC", "P_14O was measured to D instead of O"
    ),
    "P13D from A": Mistake(
        length("P13D", "13", "12"), "P13D", "omega3 u31 vB", "P_13D was measured to A instead of D"
    ),
    "P14P40 from P20": Mistake(
        length("P14P40", "14", "20"),
        "P14P40",
        "omega4 u41 vC",
        "P_14P_40 was measured to P_20 instead of P_40",
    ),
    "P40C to E": Mistake(
        length("P40C", "40", "45"), "P40C", "vC", "P_40C was measured to E instead of C"
    ),
    "AP20 from B": Mistake(
        length("AP20", "23", "20"), "AP20", "omega2 u21", "AP_20 was measured to B instead of A"
    ),
    "P13O from P14": Mistake(
        length("P13O", "14", "10"),
        "P13O",
        "omega3 u31 vB",
        "P_13O was measured to P_14 instead of P_13",
    ),
    "P20 where P14 is, for AP20": Mistake(
        length("AP20", "12", "14"),
        "AP20",
        "omega2 u21",
        "AP_20 was measured to P_14 instead of P_20",
    ),
    "rpm": Mistake(
        put(rates=in_rpm),
        "omega2 omega3 omega4",
        "vB vC",
        "ω_2 was taken 9.549 times as large, in every such step",
    ),
    "omega2 and omega3 exchanged": Mistake(put(rates=exchanged), "omega2 omega3", "vB"),
    "mu twice": Mistake(
        put(found=times("vE", 0.0025)), "vE", says="v_E was calculated as |ω_1·OP_15|·μ_lP²"
    ),
    "mu left out": Mistake(
        put(found=times("vE", 400.0)),
        "vE",
        says="the readings of Instantaneous centres: vE are about 400 times as large as they should be",
    ),
    "mu_v for mu_l": Mistake(
        put(found=speed("vC", "omega4", "P40C", 0.02)),
        "vC",
        says="v_C was calculated with the scale factor μ_v instead of μ_lP",
    ),
    "vC with omega2": Mistake(
        put(found=speed("vC", "omega2", "P40C")),
        "vC",
        says="v_C was calculated with ω_2 instead of ω_4",
    ),
    "vB with P40C": Mistake(put(found=speed("vB", "omega3", "P40C")), "vB"),
    "P14P40 misread by 10 mm": Mistake(put(amiss=misread(10.0, "P14P40")), "P14P40"),
    "P14P40 misread by 40 mm": Mistake(
        put(amiss=misread(40.0, "P14P40")), "P14P40", "omega4 u41 vC"
    ),
    "AP20 misread by 50 mm": Mistake(put(amiss=misread(50.0, "AP20")), "AP20", "omega2 u21"),
    "position 4 for 3": Mistake(
        put(turned={3: 4}),
        "A B C E",
        "P20 P13 P14 u21 u31 vB vE",
        "the crank's angles were counted from 30° further on, at position 3 only",
    ),
    "crank turned the other way": Mistake(
        put(turned={3: 11, 9: 5}),
        "A B C E",
        "P20 P13 P14 u21 u31 vB",
        "the crank was turned the other way",
    ),
    "slider: guide taken along": Mistake(
        put(square=1 + 0j),
        "P20 P13",
        "AP20 u21 omega2 vB",
        "(BP_30) проведено параллельно (x), а не перпендикулярно",
        six=False,
    ),
    "slider: P13 along AO": Mistake(
        way("13", "12", "20", "10", FAR),
        "P13",
        "OP13 vB",
        "для (AB) вместо B взято O",
        six=False,
    ),
    "slider: AP20 from B": Mistake(
        length("AP20", "23", "20"), "AP20", "omega2 u21", "AP_20 измерено до B вместо A", six=False
    ),
    "slider: OP13 to P20": Mistake(
        length("OP13", "20", "13"), "OP13", "vB", "OP_13 измерено до P_20 вместо O", six=False
    ),
    "slider: P13 for P20": Mistake(
        length("AP20", "12", "13"),
        "AP20",
        "omega2 u21",
        "AP_20 измерено до P_13 вместо P_20",
        six=False,
    ),
    "slider: scene's mu for his": Mistake(put(found=times("vB", 0.8)), "vB", six=False),
    "slider: u21 upside down": Mistake(
        put(ratios=inverse("u21")), "u21", "omega2", "u_21 вычислено как AP_20/AO", six=False
    ),
}


QUICK = {"P40: at the pin", "u21 without its sign", "slider: guide taken along"}
"""One of each kind: a centre, a sign, a guide; the others are slow."""
LEAST_SURE = 0.8


@pytest.mark.parametrize(
    "name",
    [name if name in QUICK else pytest.param(name, marks=pytest.mark.slow) for name in MISTAKES],
)
def test_a_mistake_is_found_where_it_was_made(name: str) -> None:
    """What is wrong is the student's own error, what is found from it follows, and the cause is named."""
    one = MISTAKES[name]
    student = Student(11, six=one.six)
    one.change(student)
    judged = report(student, one.kinds)
    assert wrong(judged) == set(one.his.split())
    assert set(one.follow.split()) <= following(judged)
    sure = [told.says for told in judged.mistakes if told.chance >= LEAST_SURE]
    assert not one.says or one.says in sure[0]


OTHERWISE: Mapping[str, Mapping[str, Way]] = {
    "P14 by P13 and P34": {"14": ("13", "34", "12", "24")},
    "P14 by P13 and P34, over the frame": {"14": ("13", "34", "10", "40")},
    "P34 before P40": {"34": ("23", "24", "30", "40"), "35": ("34", "45", "13", "15")},
    "P35 by P34": {"35": ("13", "15", "34", "45")},
    "P25 by P23 and P35": {"25": ("12", "15", "23", "35")},
    "P25 by P24": {"25": ("24", "45", "12", "15")},
}
"""Centres by other lines than his usual ones, all of centres that are there before."""


@pytest.mark.parametrize("name", OTHERWISE)
def test_a_centre_by_other_lines_is_as_right(name: str) -> None:
    student = Student(5)
    student.ways |= OTHERWISE[name]
    assert not wrong(report(student))


def test_the_order_in_which_centres_are_drawn_is_free() -> None:
    """P_25 before P_15, P_14 by both: measured, of 12 such drawings none has a wrong or doubtful reading."""
    student = Student(5)
    student.ways = {name: SIX_BAR[name] for name in ("20", "13", "40", "34")} | {
        "25": ("24", "45", "20", FAR),
        "15": ("12", "25", "10", FAR),
        "14": ("13", "34", "15", "45"),
        "35": ("15", "13", "34", "45"),
    }
    assert not wrong(report(student))


def test_a_right_centre_by_lines_that_do_not_hold_the_wrong_one_is_right() -> None:
    """P_14 by (AC) and (O P_40) stands where it is due: a wrong P_13 did not enter it."""
    student = Student(11)
    student.ways["13"] = ("12", "30", "10", "23")
    judged = report(student, "points")
    assert "P13" in wrong(judged)
    assert "P14" not in wrong(judged)
