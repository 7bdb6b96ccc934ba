"""Loads by the swing of a link, by the travel of any point along a line; the judge is the closed four-bar."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from support.boards import drawn_of
from support.each import each
from support.scenes import written

import graphic_tmm
from graphic_tmm.chapters.forces.load_diagrams import load_views
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.errors import SceneError, TmmError
from graphic_tmm.scene.read import read

Reals = NDArray[np.float64]
STEP, GRID = 1e-5, 400_000
OUT, BACK = ((0.0, 1.0), (100.0, 300.0)), ((0.0, 0.4, 1.0), (4000.0, 900.0, 700.0))


@dataclass(frozen=True)
class FourBar:
    """A crank that turns round, coupler, rocker, frame (m); E on the coupler, the frame turned, its side."""

    a: float
    b: float
    c: float
    d: complex
    e: complex
    side: int
    omega: float

    def points(self, phi: Reals) -> tuple[NDArray[np.complex128], NDArray[np.complex128]]:
        """Return B and E at crank angles (radians)."""
        pin = self.a * np.exp(1j * phi)
        to = self.d - pin
        far = np.abs(to)
        along = (self.b**2 - self.c**2 + far**2) / (2.0 * far)
        high = np.sqrt(self.b**2 - along**2)
        joint = pin + (along + 1j * self.side * high) * to / far
        return joint, pin + self.e * (joint - pin) / self.b

    def swing(self, phi: Reals) -> Reals:
        """Return the direction of the rocker, degrees, from that of the frame on: it never comes to 180°."""
        return np.degrees(np.angle((self.points(phi)[0] - self.d) / -self.d))

    def travel(self, phi: Reals, angle: float) -> Reals:
        """Return how far E stands along a line, m."""
        return (self.points(phi)[1] * np.exp(-1j * np.radians(angle))).real

    def due(self, of: object, phi: Reals, *, start: int) -> Reals:
        """Return the size of a load by a coordinate, from its greatest (1) or least (−1) place."""
        every = of(np.linspace(0.0, 2.0 * np.pi, GRID + 1))  # type: ignore[operator]
        low, high = every.min(), every.max()
        share = (of(phi) - low) / (high - low)  # type: ignore[operator]
        share = 1.0 - share if start > 0 else share
        going = _rate(of, phi) * self.omega * -start >= 0.0
        return np.where(going, np.interp(share, *OUT), np.interp(share, *BACK))

    def text(self, more: str, zero: str = '"17 deg"', row: str = "") -> str:
        way = "counterclockwise" if self.omega > 0 else "clockwise"
        side = "left" if self.side > 0 else "right"
        return (
            'title = "T"\nlanguage = "en"\n[frame]\nO = [0, 0]\n'
            f"C = [{self.d.real!r}, {self.d.imag!r}]\n"
            f"[[link]]\nnumber = 1\npoints = {{ O = [0, 0], A = [{self.a!r}, 0] }}\n"
            f"[[link]]\nnumber = 2\npoints = {{ A = [0, 0], B = [{self.b!r}, 0], "
            f'E = [{self.e.real!r}, {self.e.imag!r}] }}\nside = "{side} of AC"\n'
            f"[[link]]\nnumber = 3\npoints = {{ B = [{self.c!r}, 0], C = [0, 0] }}\n"
            f'[drive]\nlink = 1\nspeed = "{abs(self.omega)} 1/s"\nturns = "{way}"\n'
            f"positions = 16\n{row or f'zero = {zero}'}\n{more}"
            '[forces]\npositions = "all"\nbalance = "moment"\n'
        )


def _rate(of: object, phi: Reals) -> Reals:
    return (of(phi + STEP) - of(phi - STEP)) / (2.0 * STEP)  # type: ignore[operator, no-any-return]


def four_bar(seed: int) -> FourBar:
    """A crank-rocker of random lengths by Grashof's rule."""
    pick = random.Random(seed)
    a = pick.uniform(0.02, 0.3)
    while True:
        b, c, d = (a * pick.uniform(1.3, 5.0) for _ in range(3))
        if 2.0 * max(b, c, d) + a < 0.97 * (b + c + d):
            break
    frame = d * np.exp(1j * pick.uniform(-np.pi, np.pi))
    e = complex(b * pick.uniform(-0.5, 1.5), b * pick.uniform(-1.0, 1.0))
    return FourBar(a, b, c, complex(frame), e, pick.choice((1, -1)), pick.choice((40.0, -40.0)))


def table(unit: str) -> str:
    out, back = (
        ", ".join(f'[{x}, "{y} {unit}"]' for x, y in zip(*way, strict=True)) for way in (OUT, BACK)
    )
    return f"out = [{out}]\nback = [{back}]\n"


def loads(angle: float, ends: tuple[str, str] = ("", "")) -> str:
    first, second = (f'start = "{end}"\n' if end else "" for end in ends)
    return (
        f"[[load]]\nlink = 3\nof = 3\n{table('N*m')}{first}"
        f'[[load]]\nlink = 2\npoint = "E"\nof = "E"\nalong = "{angle} deg"\n{table("N")}{second}'
    )


def balance(of: FourBar, moment: Reals, force: Reals, phi: Reals) -> Reals:
    """What balances the crank, by virtual power; the force acts against the velocity of E."""
    turning = np.radians(_rate(of.swing, phi))
    speed = np.abs(_rate(lambda at: of.points(at)[1], phi)) * np.sign(of.omega)
    return force * speed - moment * turning


@pytest.mark.turns(4)
@pytest.mark.parametrize("seed", range(12))
def test_sizes_and_balance_in_a_row_and_at_any_angle(seed: int, tmp_path: Path) -> None:
    of, angle = four_bar(seed), float(random.Random(seed).uniform(-180.0, 180.0))
    scene = read(written(tmp_path, of.text(loads(angle))))
    made = drawn_of(scene, exact=True)
    forces = FORCES_PLAN.on(made)
    phi = np.radians(17.0 + 22.5 * np.arange(16) * np.sign(of.omega))

    def due(at: Reals) -> tuple[Reals, Reals]:
        force = of.due(lambda x: of.travel(x, angle), at, start=-1)
        return of.due(of.swing, at, start=-1), force

    moment, force = due(phi)
    for mark, wanted in zip(forces.loads.given, (moment, force), strict=True):
        np.testing.assert_allclose(made.reading[mark][0], wanted, rtol=1e-8)
    needed = balance(of, moment, force, phi)
    for mark in (forces.first.balance, forces.first.lever.balance):
        np.testing.assert_allclose(
            made.reading[mark][0], needed, rtol=1e-6, atol=1e-7 * np.abs(needed).max()
        )
    at = np.arange(3.0, 360.0, 7.0)
    found = graphic_tmm.motion(scene, at, plans=["forces"], exact=True).balance["M_bal_forces"]
    needed = balance(of, *due(np.radians(at)), np.radians(at))
    np.testing.assert_allclose(found, needed, rtol=1e-6, atol=1e-7 * np.abs(needed).max())


@each("ends", [("clockwise", "left"), ("counterclockwise", "right")])
def test_a_travel_begins_at_the_end_that_is_named(ends: tuple[str, str], tmp_path: Path) -> None:
    of = four_bar(3)
    made = drawn_of(read(written(tmp_path, of.text(loads(0.0, ends)))), exact=True)
    phi = np.radians(17.0 + 22.5 * np.arange(16) * np.sign(of.omega))
    begin = 1 if ends[1] == "right" else -1
    wanted = (
        of.due(of.swing, phi, start=begin),
        of.due(lambda x: of.travel(x, 0.0), phi, start=begin),
    )
    for mark, size in zip(FORCES_PLAN.on(made).loads.given, wanted, strict=True):
        np.testing.assert_allclose(made.reading[mark][0], size, rtol=1e-8)


@each("at", [1, -1])
def test_a_swing_begins_at_the_zero_position_where_it_turns_back(at: int, tmp_path: Path) -> None:
    of = four_bar(5)
    every = np.linspace(0.0, 2.0 * np.pi, GRID + 1)
    places = of.swing(every) * at
    point = complex(of.points(every[[int(np.argmax(places))]])[0][0])
    # nearest the line of the frame, a rocker's pin is farthest along its own motion: by the crank's own angle
    stretched = np.angle(point) if abs(point) > of.b else np.angle(-point)
    zero = float(np.degrees(stretched))
    load = f"[[load]]\nlink = 3\nof = 3\n{table('N*m')}"
    made = drawn_of(read(written(tmp_path, of.text(load, f'"{zero!r} deg"'))), exact=True)
    turned = 22.5 * np.arange(1, 16) * np.sign(of.omega)
    wanted = of.due(of.swing, np.radians(zero + turned), start=at)
    (mark,) = FORCES_PLAN.on(made).loads.given
    np.testing.assert_allclose(made.reading[mark][0][1:], wanted, rtol=1e-7)


@pytest.mark.parametrize("seed", [3, 5, 8])
def test_a_row_that_ends_before_its_end_has_the_stroke_of_the_mechanism(
    seed: int, tmp_path: Path
) -> None:
    of = four_bar(seed)
    row = f'from = "17 deg"\nto = "{17.0 + math.copysign(60.0, of.omega)} deg"'
    made = drawn_of(read(written(tmp_path, of.text(loads(20.0), row=row))), exact=True)
    phi = np.radians(17.0 + np.linspace(0.0, math.copysign(60.0, of.omega), 16))
    wanted = (
        of.due(of.swing, phi, start=-1),
        of.due(lambda x: of.travel(x, 20.0), phi, start=-1),
    )
    for mark, size in zip(FORCES_PLAN.on(made).loads.given, wanted, strict=True):
        np.testing.assert_allclose(made.reading[mark][0], size, rtol=1e-8)


def test_a_stroke_ends_where_the_crank_comes_to(tmp_path: Path) -> None:
    """The shortest link is the coupler: its crank stands in two stretches of a turn, and leaves neither."""
    of = FourBar(0.25, 0.1, 0.24, 0.2 + 0j, 0.37 - 0.33j, 1, 10.0)
    angle, row = 17.0, 'from = "270 deg"\nto = "320 deg"'
    load = f'[[load]]\nlink = 2\npoint = "E"\nof = "E"\nalong = "{angle} deg"\n{table("N")}'
    made = drawn_of(read(written(tmp_path, of.text(load, row=row))), exact=True)
    phi = np.radians(np.linspace(270.0, 320.0, 16))
    every = of.travel(
        np.radians(np.linspace(262.48, 325.98, GRID + 1)), angle
    )  # but for 0.01° the whole stretch
    share = (of.travel(phi, angle) - every.min()) / np.ptp(every)
    going = _rate(lambda x: of.travel(x, angle), phi) > 0.0
    wanted = np.where(going, np.interp(share, *OUT), np.interp(share, *BACK))
    (mark,) = FORCES_PLAN.on(made).loads.given
    np.testing.assert_allclose(made.reading[mark][0], wanted, rtol=1e-8)


@each("second", ['of = "B"\nalong = 20', 'of = "B"\nalong = 80\nstart = "top"', "of = 3"])
@pytest.mark.slow
def test_loads_go_by_one_point_in_several_ways(second: str, tmp_path: Path) -> None:
    """The end of each stroke has a letter of its own."""
    of = four_bar(3)
    keys = 'of = "B"\nalong = 0', second
    text = "".join(f"[[load]]\nlink = 3\n{key}\n{table('N*m')}" for key in keys)
    made = drawn_of(read(written(tmp_path, of.text(text))), exact=True)
    both = [made.reading[mark][0] for mark in FORCES_PLAN.on(made).loads.given]
    for key, size in zip(keys, both, strict=True):
        alone = drawn_of(
            read(written(tmp_path, of.text(f"[[load]]\nlink = 3\n{key}\n{table('N*m')}"))),
            exact=True,
        )
        (mark,) = FORCES_PLAN.on(alone).loads.given
        np.testing.assert_array_equal(size, alone.reading[mark][0])


@each("to", ["330 deg", "720 deg", "-350 deg"])
def test_no_swing_is_wider_than_a_protractor(to: str, tmp_path: Path) -> None:
    of = replace(four_bar(3), omega=-40.0 if to.startswith("-") else 40.0)
    row = f'from = "0 deg"\nto = "{to}"'
    load = f"[[load]]\nlink = 1\nof = 1\n{table('N*m')}"
    with pytest.raises(TmmError, match=r"link 1 turns by .* and a protractor reads 315° at most"):
        drawn_of(read(written(tmp_path, of.text(load, row=row))))


PUSHED = """title = "T"
language = "en"
[frame]
O = [0, 0]
x = {{ through = [0, 0], angle = 0 }}
[[link]]
number = 1
points = {{ O = [0, 0], A = [0.2, 0] }}
[[link]]
number = 2
points = {{ A = [0, 0], B = [0.5, 0] }}
side = "left of OB"
[[link]]
number = 3
points = {{ B = [0, 0] }}
slides = {{ on = "frame", along = "x" }}
[drive]
link = 3
speed = "0.1 m/s"
from = "{first} mm"
to = "{last} mm"
positions = 8
[[load]]
link = 1
{keys}
{table}
[forces]
positions = "all"
"""


@each("way", [1, -1])
@each("keys", ["of = 1", 'of = 1\nstart = "counterclockwise"', 'of = "B"\nalong = 0', 'of = "B"'])
def test_a_stroke_that_goes_one_way_is_that_of_its_row(way: int, keys: str, tmp_path: Path) -> None:
    """A slider drives a crank: neither turns back, so shares are of the row from one end to the other."""
    far = np.linspace(0.4, 0.6, 8)[::way]
    text = PUSHED.format(
        first=1000.0 * far[0], last=1000.0 * far[-1], keys=keys, table=table("N*m")
    )
    made = drawn_of(read(written(tmp_path, text)), exact=True)
    turned = np.arccos((0.04 + far**2 - 0.25) / (0.4 * far))
    gone = far if "B" in keys else turned
    share = (gone - gone[0]) / (gone[-1] - gone[0])
    wanted = np.interp(share, *OUT)
    if "start" in keys and turned[0] < turned[-1]:
        wanted = np.interp(1.0 - share, *BACK)
    (mark,) = FORCES_PLAN.on(made).loads.given
    np.testing.assert_allclose(made.reading[mark][0], wanted, rtol=1e-8)


def test_a_load_by_time_is_that_at_the_turns_of_an_even_crank(tmp_path: Path) -> None:
    of = four_bar(3)
    load = (
        '[[load]]\nlink = 3\nby_time = [[0, "5 N*m"], ["0.05 s", "90 N*m"], ["120 ms", "20 N*m"]]\n'
    )
    scene = read(written(tmp_path, of.text(load)))
    made = drawn_of(scene, exact=True)
    (mark,) = FORCES_PLAN.on(made).loads.given
    whole = 2.0 * math.pi / abs(of.omega)
    passed = np.arange(16) * whole / 16
    wanted = np.interp(passed, [0.0, 0.05, 0.12, whole], [5.0, 90.0, 20.0, 5.0])
    np.testing.assert_allclose(made.reading[mark][0], wanted, rtol=1e-8)
    moment = FORCES_PLAN.on(made).first.balance
    phi = np.radians(17.0 + 22.5 * np.arange(16) * np.sign(of.omega))
    needed = -wanted * np.radians(_rate(of.swing, phi))
    np.testing.assert_allclose(made.reading[moment][0], needed, rtol=1e-5, atol=1e-6)


UNTIMED = {
    'speed = "40.0 1/s"': (
        'speed = "40.0 1/s"\nacceleration = "3 rad/s2"',
        "tell no time between two",
    ),
    'speed = "40.0 1/s"\n': ("speed = 0\n", "what drives stands"),
    '"0.05 s"': ('"0.4 s"', "two turns take 0.314159 s, and the table goes on"),
}


@each("told", UNTIMED)
def test_time_wants_an_even_crank(told: str, tmp_path: Path) -> None:
    of = replace(four_bar(3), omega=40.0)
    text = of.text('[[load]]\nlink = 3\nby_time = [[0, "5 N*m"], ["0.05 s", "90 N*m"]]\n')
    with pytest.raises(SceneError, match=UNTIMED[told][1]):
        read(written(tmp_path, text.replace(told, UNTIMED[told][0])))


def test_its_diagram_stands_over_the_angle(tmp_path: Path) -> None:
    of = four_bar(3)
    made = drawn_of(read(written(tmp_path, of.text(loads(30.0)))))
    swing, travel = load_views(made, True)
    assert "ψ_3, °" in {label.text for label in swing.labels}
    assert "S, m" in {label.text for label in travel.labels}


WRONG = {
    "of = 1": "link 1 turns by 360°, and a protractor reads 315° at most",
    "of = 0": "link 0 is the frame",
    "of = 7": "there is no link 7",
    'of = "E"': "point E does not slide along a straight guide of the frame",
    'of = 3\nalong = "3 deg"': "the swing of a link has no line",
    'of = 3\nstart = "left"': 'link 3 does not turn back there; write one of "clockwise"',
    'of = "E"\nalong = 0\nstart = "top"': 'E does not turn back there; write one of "left"',
    'of = "E"\nalong = 0\nstart = "clockwise"': 'E does not turn back there; write one of "left"',
    'force = 3\npoint = "E"\nalong = 0': "the travel of which point goes along that line",
}


@each("keys", WRONG)
def test_what_has_no_travel_is_refused(keys: str, tmp_path: Path) -> None:
    more = "" if "force" in keys else table("N*m")
    text = four_bar(3).text(f"[[load]]\nlink = 2\n{keys}\n{more}")
    with pytest.raises((SceneError, TmmError), match=WRONG[keys]):
        drawn_of(read(written(tmp_path, text)))
