"""Readings of instantaneous centres by who crosses Kennedy's lines by hand: right ones, and one mistake each.

The student knows the mechanisms by their loops, in mm on his sheet, and nothing of the package. He goes on with
what he has, so that of a mistake only the rows are his in which it was made; the others follow.
"""

from __future__ import annotations

import math
import random
import re
import tempfile
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest
from support.gallery import SHEETS

from graphic_tmm.checking.check import Checker
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import FINE, WRONG, Report
from graphic_tmm.scene.read import read

Spots = dict[str, complex]
Way = tuple[str, str, str, str]
Change = Callable[["Student"], object]
HEAD = "plan,position,segment,mm,value,unit,x,y"
FAR = "far"
"""The centre of the slider on its guide, at infinity square to it."""
NAMES = {"A": "12", "B": "23", "C": "24", "D": "30", "E": "45"}
SIX_BAR: Mapping[str, Way] = {
    "20": ("12", "10", "23", "30"),
    "40": ("20", "24", "45", FAR),
    "34": ("23", "24", "30", "40"),
    "13": ("12", "23", "10", "30"),
    "14": ("12", "24", "10", "40"),
    "15": ("14", "45", "10", FAR),
    "35": ("13", "15", "30", FAR),
    "25": ("12", "15", "20", FAR),
}
"""Each centre by two lines, through two centres each, in the order in which they are drawn."""
CRANK: Mapping[str, Way] = {"20": ("12", "10", "23", FAR), "13": ("12", "23", "10", FAR)}
SIX_LENGTHS = {
    "AO": ("12", "10"), "AP20": ("12", "20"), "P13O": ("13", "10"), "P13D": ("13", "30"),
    "P14O": ("14", "10"), "P14P40": ("14", "40"), "OP15": ("10", "15"), "DB": ("30", "23"),
    "P40C": ("40", "24"),
}  # fmt: skip
CRANK_LENGTHS = {"AO": ("12", "10"), "AP20": ("12", "20"), "OP13": ("10", "13")}
RATIOS = {
    "u21": ("AO", "AP20", "12", "10", "20"),
    "u31": ("P13O", "P13D", "13", "10", "30"),
    "u41": ("P14O", "P14P40", "14", "10", "40"),
}
"""The lengths of each ratio, and the centres that tell its sign: the common one, outside of both or between."""
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


def meeting(first: tuple[complex, complex], second: tuple[complex, complex]) -> complex:
    """Return where two lines meet, each a point and a direction."""
    (p, u), (q, v) = first, second
    return p + u * ((q - p).conjugate() * v).imag / (u.conjugate() * v).imag


def arcs(p: complex, r: float, q: complex, s: float) -> complex:
    """Return where two arcs meet, to the left of p → q."""
    off = abs(q - p)
    along = (r * r - s * s + off * off) / (2 * off)
    return p + (q - p) / off * complex(along, math.sqrt(r * r - along * along))


def six_bar(angle: float) -> Spots:
    """The pairs of the six-bar of the sheets, m."""
    a, d = 0.1 * complex(math.cos(angle), math.sin(angle)), 0.3 + 0j
    b = arcs(a, 0.28, d, 0.2)
    c = a + (b - a) / 0.28 * complex(0.15, 0.09)
    e = complex(c.real + math.sqrt(0.42**2 - (c.imag + 0.18) ** 2), -0.18)
    return {"10": 0j, "12": a, "30": d, "23": b, "24": c, "45": e}


def slider_crank(angle: float) -> Spots:
    """The pairs of a slider-crank whose guide is 30 mm below the crank's pivot, m."""
    a = 0.09 * complex(math.cos(angle), math.sin(angle))
    b = complex(a.real + math.sqrt(0.26**2 - (a.imag + 0.03) ** 2), -0.03)
    return {"10": 0j, "12": a, "23": b}


class Student:
    """Who draws the centres of a mechanism in his μ; what he mistakes is set from outside."""

    def __init__(self, seed: int, mu: float = 0.0025, *, six: bool = True) -> None:
        self.chance, self.mu, self.six = random.Random(seed), mu, six
        self.places = (3, 9) if six else (2, 6)
        self.omega = 10.0 if six else 20.0
        self.ways = dict(SIX_BAR if six else CRANK)
        self.lengths = dict(SIX_LENGTHS if six else CRANK_LENGTHS)
        self.square = 1j
        """The direction of the lines to the centre at infinity."""
        self.turned: Mapping[int, int] = {}
        """The positions in which he draws instead of those that are due."""
        self.amiss: Callable[[dict[str, float], int], object] = lambda mm, place: None
        self.found: Callable[[dict[str, float], dict[str, float]], object] = lambda of, mm: None
        self.ratios: Callable[[dict[str, float]], object] = lambda of: None
        self.rates: Callable[[dict[str, float]], object] = lambda of: None
        self.slip, self.ruler = 0.15, 0.1

    def pricked(self, spot: complex) -> complex:
        return spot + complex(self.chance.gauss(0, self.slip), self.chance.gauss(0, self.slip))

    def line(self, at: Spots, first: str, second: str) -> tuple[complex, complex]:
        if FAR in (first, second):
            return at[first if second == FAR else second], self.square
        return at[first], at[second] - at[first]

    def centres(self, place: int) -> Spots:
        angle = math.radians(30.0 * (self.turned.get(place, place) - 1))
        pairs = (six_bar if self.six else slider_crank)(angle)
        at = {name: self.pricked(spot / self.mu) if spot else spot for name, spot in pairs.items()}
        for name, (a, b, c, d) in self.ways.items():
            at[name] = self.pricked(meeting(self.line(at, a, b), self.line(at, c, d)))
        return at

    def read(self, length: float) -> float:
        return round(round(length / self.ruler) * self.ruler, 3)

    def figures(self, at: Spots, mm: dict[str, float]) -> dict[str, float]:
        """Return ratios, ω, 1/s, and velocities, m/s, as he calculates them of his lengths."""
        of: dict[str, float] = {}
        for name, (above, below, common, one, other) in RATIOS.items():
            if above in mm and below in mm:
                aside = ((at[one] - at[common]).conjugate() * (at[other] - at[common])).real
                of[name] = math.copysign(mm[above] / mm[below], aside)
        self.ratios(of)
        of |= {f"omega{name[1]}": u * self.omega for name, u in [*of.items()]}
        self.rates(of)
        if self.six:
            of["vE"] = self.omega * mm["OP15"] * self.mu
            of["vB"] = abs(of["omega3"]) * mm["DB"] * self.mu
            of["vC"] = abs(of["omega4"]) * mm["P40C"] * self.mu
        else:
            of["vB"] = self.omega * mm["OP13"] * self.mu
        self.found(of, mm)
        return of

    def csv(self, kinds: str = "points lengths figures") -> str:
        rows = [HEAD, f"centres,,μ_lP,,{self.mu},m/mm,,"]
        for place in self.places:
            at = self.centres(place)
            mm = {k: self.read(abs(at[a] - at[b])) for k, (a, b) in self.lengths.items()}
            self.amiss(mm, place)
            if "points" in kinds:
                spots = {name: at[pair] for name, pair in NAMES.items() if pair in at}
                spots |= {f"P{name}": at[name] for name in self.ways}
                for name, spot in spots.items():
                    x, y = self.read(spot.real), self.read(spot.imag)
                    rows.append(f"centres,{place},{name},,,,{x},{y}")
            if "lengths" in kinds:
                rows += [f"centres,{place},{name},{length},,,," for name, length in mm.items()]
            if "figures" in kinds:
                for name, value in self.figures(at, mm).items():
                    unit = {"u": "1", "o": "1/s", "v": "m/s"}[name[0]]
                    rows.append(f"centres,{place},{name},,{value:.4g},{unit},,")
        return "\n".join(rows) + "\n"


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
    """A mistake: which rows are ``his`` own, some that ``follow``, a pattern of what is said first."""

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
    return lambda one: [setattr(one, name, value) for name, value in what.items()]


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
    "P13: O to C for O to D": Mistake(way("13", "12", "23", "10", "24"), "P13"),
    "P13: A to D, O to B": Mistake(way("13", "12", "30", "10", "23"), "P13"),
    "P14: A to B for A to C": Mistake(way("14", "12", "23", "10", "40"), "P14"),
    "P14: O to D for O to P40": Mistake(way("14", "12", "24", "10", "30"), "P14"),
    "P20: C to D for B to D": Mistake(way("20", "12", "10", "24", "30"), "P20"),
    "P34: D to P20 for D to P40": Mistake(way("34", "23", "24", "30", "20"), "P34"),
    "P40: at the pin": Mistake(way("40", "24", "45", "45", FAR), "P40"),
    "guide taken along": Mistake(put(square=1 + 0j), "P40 P15 P35 P25"),
    "guide taken along, lengths": Mistake(put(square=1 + 0j), "", kinds=TWO),
    "P15: O to E for square to the guide": Mistake(way("15", "14", "45", "10", "45"), "P15"),
    "u31 upside down": Mistake(put(ratios=inverse("u31")), "u31"),
    "u41 upside down": Mistake(put(ratios=inverse("u41")), "u41"),
    "u21 without its sign": Mistake(put(ratios=times("u21", -1)), "u21"),
    "u31 with the other sign": Mistake(put(ratios=times("u31", -1)), "u31"),
    "P14O from D": Mistake(length("P14O", "14", "30"), "P14O"),
    "P13D from A": Mistake(length("P13D", "13", "12"), "P13D"),
    "P14P40 from P20": Mistake(length("P14P40", "14", "20"), "P14P40"),
    "P40C to E": Mistake(length("P40C", "40", "45"), "P40C"),
    "AP20 from B": Mistake(length("AP20", "23", "20"), "AP20"),
    "P13O from P14": Mistake(length("P13O", "14", "10"), "P13O"),
    "P20 where P14 is, for AP20": Mistake(length("AP20", "12", "14"), "AP20"),
    "rpm": Mistake(put(rates=in_rpm), "omega2 omega3 omega4"),
    "omega2 and omega3 exchanged": Mistake(put(rates=exchanged), "omega2 omega3"),
    "mu twice": Mistake(put(found=times("vE", 0.0025)), "vE"),
    "mu left out": Mistake(put(found=times("vE", 400.0)), "vE"),
    "mu_v for mu_l": Mistake(put(found=speed("vC", "omega4", "P40C", 0.02)), "vC"),
    "vC with omega2": Mistake(put(found=speed("vC", "omega2", "P40C")), "vC"),
    "vB with P40C": Mistake(put(found=speed("vB", "omega3", "P40C")), "vB"),
    "P14P40 misread by 10 mm": Mistake(put(amiss=misread(10.0, "P14P40")), "P14P40"),
    "AP20 misread by 50 mm": Mistake(put(amiss=misread(50.0, "AP20")), "AP20"),
    "position 4 for 3": Mistake(put(turned={3: 4}), "A B C E"),
    "crank turned the other way": Mistake(put(turned={3: 11, 9: 5}), "A B C E"),
    "slider: guide taken along": Mistake(put(square=1 + 0j), "P20 P13", six=False),
    "slider: P13 along AO": Mistake(way("13", "12", "20", "10", FAR), "P13", six=False),
    "slider: AP20 from B": Mistake(length("AP20", "23", "20"), "AP20", six=False),
    "slider: OP13 to P20": Mistake(length("OP13", "20", "13"), "OP13", six=False),
    "slider: P13 for P20": Mistake(length("AP20", "12", "13"), "AP20", six=False),
    "slider: scene's mu for his": Mistake(put(found=times("vB", 0.8)), "vB", six=False),
    "slider: u21 upside down": Mistake(put(ratios=inverse("u21")), "u21", six=False),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_a_mistake_is_found_where_it_was_made(name: str) -> None:
    one = MISTAKES[name]
    student = Student(11, six=one.six)
    one.change(student)
    judged = report(student, one.kinds)
    assert wrong(judged) == set(one.his.split())
    assert set(one.follow.split()) <= following(judged)
    if one.says:
        assert re.search(one.says, judged.mistakes[0].says)
        assert judged.mistakes[0].chance >= SURE
