"""Forces of two plates that two links join (class IV) against Newton's and Euler's equations of all links."""

from __future__ import annotations

import cmath
import math
import re
import tomllib
from collections.abc import Callable

import numpy as np
import pytest
from chapters.forces.test_force_sheets import check as check_sheet
from chapters.forces.test_force_sheets import sheet
from chapters.forces.test_plate_forces import judged, rough
from support.boards import drawn_of
from support.free_bodies import Judge
from support.free_forces import Rough, UnsettledError, statics
from support.plates import Reals, followed
from support.sheet_reader import lines
from support.squares import Square, square

import graphic_tmm
from graphic_tmm.chapters.forces.table import force_columns
from graphic_tmm.errors import StructureError

SQUARE = """
title = "Square"
language = "en"
[frame]
O = [0, 0]
D = [0.38, 0.04]
[[link]]
number = 1
points = { O = [0, 0], A = [0.05, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.14, 0.117], E = [0.175, -0.013], S2 = [0.105, 0.035] }
mass = "2 kg"
centre = "S2"
J = 0.006
near = "0 deg"
near_at = "60 deg"
[[link]]
number = 3
points = { D = [0, 0], C = [-0.09, 0.165], F = [-0.12, -0.11], S3 = [-0.07, 0.02] }
mass = "2.4 kg"
centre = "S3"
J = 0.009
[[link]]
number = 4
points = { B = [0, 0], C = [0.13285, 0], S4 = [0.066, 0] }
mass = "0.8 kg"
centre = "S4"
J = 0.002
[[link]]
number = 5
points = { E = [0, 0], F = [0.11662, 0], S5 = [0.058, 0] }
mass = "0.7 kg"
centre = "S5"
J = 0.0015
[drive]
link = 1
speed = 10
positions = 6
from = "40 deg"
to = "80 deg"
accelerations = "all"
[effects]
gravity = true
inertia = true
[[load]]
link = 3
point = "S3"
force = "60 N"
direction = "-70 deg"
[[load]]
link = 4
moment = "-2 N*m"
[[load]]
link = 2
moment = "4 N*m"
[forces]
positions = [2]
"""
_MASSES = r"(number = [45]\npoints = \{ \w = \[0, 0\], \w = \[[0-9.]*, 0\]).*\n.*\n.*\nJ.*\n"
LIGHT = re.sub(_MASSES, r"\1 }\n", SQUARE).replace('[[load]]\nlink = 4\nmoment = "-2 N*m"\n', "")
"""The links that join its plates bear nothing: they hold along their lines only."""
TWO_CRANKS = (
    SQUARE.replace("D = [0.38, 0.04]", "H = [0.42, 0.04]")
    .replace("[drive]", "[[link]]\nnumber = 6\npoints = { H = [0, 0], D = [0.04, 0] }\n[[drive]]")
    .replace(
        "[effects]",
        '[[drive]]\nlink = 6\nspeed = 6\nturns = "clockwise"\nat = "180 deg"\n[effects]',
    )
)
"""The pivot of its second plate is on another crank."""
_LONG = 0.12 + 0.02j
"""From B to C, and 5/6 of what is from E to F, where both links are parallel."""
_AT = cmath.rect(0.05, math.pi / 3) - (0.38 + 0.04j)
_C, _F = (
    [(_AT + own).real, (_AT + own).imag]
    for own in (0.14 + 0.117j + _LONG, 0.175 - 0.013j + 1.2 * _LONG)
)
SHEETS = {"square": SQUARE, "light": LIGHT, "rough": rough(SQUARE)}


def errors(scene: str, one: Square, poses: Reals, friction: float = 0.0) -> float:
    """Return how far reactions and what balances the crank are off those of all links at once.

    Where pins are rough (the coefficient of ``friction``, pins of 10 mm), off those that settle there.
    """
    judge, phi = Judge(tomllib.loads(scene)), one.machine.phi
    places = [
        (one.machine.bodies.place(poses, k, 0j), float(poses[3 * k - 1])) for k in one.machine.links
    ]
    pins = {letter: Rough(friction, 0.01) for letter, *_ in judge.pins} if friction else None
    due = statics(judge, judge.solve([phi], places), rough=pins)
    plans = ("positions", "forces")
    found = graphic_tmm.motion(scene, [math.degrees(phi)], plans=plans, exact=True)
    off = [
        abs(row[0] - due.reactions[int(name[1]), int(name[2])])
        for name, row in found.forces.items()
    ]
    off += [abs(balance[0] - due.drives[0]) for balance in found.balance.values()]
    return float(max(off)) / due.largest


def test_two_plates_bear_in_all_their_places_as_newton_and_euler_say(
    many: Callable[[int, int], int],
) -> None:
    """Whichever of the plates says near which place it is; held by the crank, by the frame, by a dyad."""
    count, judged_places = many(60, 5), 0
    with np.errstate(all="raise"):
        for seed in range(count):
            one = square(seed, before=seed % 2 == 1, loaded=True)
            for k, poses in enumerate(one.places()):
                assert errors(one.place(poses, k % 2), one, poses) <= 1e-8, (seed, k)
                judged_places += 1
    assert judged_places >= 2 * count


def test_a_dyad_hands_its_reactions_on_to_two_plates(many: Callable[[int, int], int]) -> None:
    for seed in range(100, 100 + many(40, 4)):
        one = square(seed, before=seed % 2 == 1, behind=True, loaded=True)
        try:
            assert errors(one.text, one, one.machine.bodies.start()) <= 1e-8, seed
        except StructureError as error:
            assert "another of its places after a turn" in str(error)  # noqa: PT017


def test_friction_of_two_plates_settles_at_the_judges_equilibrium(
    many: Callable[[int, int], int],
) -> None:
    """Couples in all pins, those of the square among them."""
    refused, count = 0, many(30, 4)
    for seed in range(200, 200 + count):
        one = square(seed, before=seed % 2 == 1, loaded=True)
        text = rough(one.text).replace("f = 0.1", "f = 0.05").replace("passes = 3", "passes = 25")
        try:
            assert errors(text, one, one.machine.bodies.start(), 0.05) <= 1e-8, seed
        except (UnsettledError, StructureError):
            refused += 1
    assert refused <= count // 10


def test_the_square_bears_as_newton_and_euler_say() -> None:
    judged(SQUARE, [40.0, 64.0, 80.0])
    judged(LIGHT, [40.0, 64.0, 80.0])


def test_each_of_two_cranks_under_two_plates_has_its_lever() -> None:
    ways = [40.0, 60.0, 80.0]
    balance = graphic_tmm.motion(TWO_CRANKS, ways, plans="forces", exact=True).balance
    assert len(balance) == 4
    for name in (one for one in balance if one.endswith("lever")):
        groups = "P_bal_forces" if name == "P_bal_lever" else name.removesuffix("_lever")
        np.testing.assert_allclose(balance[groups], balance[name], rtol=1e-9)


@pytest.mark.parametrize("seed", [0, 7])
def test_where_the_plates_end_their_way_nothing_is_told(seed: int) -> None:
    """Up to there forces are right, however large they grow; behind it there are none."""
    one = square(seed, before=seed % 2 == 1, loaded=True)
    rows = followed(one.machine)
    (begin, _), (end, poses) = rows[0], rows[-1]
    assert end - begin < 2 * math.pi
    with np.errstate(all="raise"):
        there = one._replace(machine=one.machine._replace(phi=end))
        assert errors(one.text, there, poses) <= 1e-8
        ways = [math.degrees(begin) - 1.0, math.degrees(end) + 1.0]
        found = graphic_tmm.motion(one.text, ways, plans="forces", exact=True)
    assert np.isnan([*found.forces.values()]).all()
    assert np.isnan([*found.balance.values()]).all()


def test_where_the_joining_links_are_parallel_nothing_is_told() -> None:
    """The special point is nowhere then; a hair beside forces are right."""
    text = (
        SQUARE.replace("C = [-0.09, 0.165], F = [-0.12, -0.11]", f"C = {_C}, F = {_F}")
        .replace("C = [0.13285, 0]", f"C = [{abs(_LONG)!r}, 0]")
        .replace("F = [0.11662, 0]", f"F = [{abs(1.2 * _LONG)!r}, 0]")
    )
    with np.errstate(all="raise"):
        found = graphic_tmm.motion(text, [60.0, 60.001], plans="forces", exact=True)
    assert all(np.isnan(row[0]) and np.isfinite(row[1]) for row in found.forces.values())
    judged(text, [60.001, 61.0])


def test_two_plates_that_bear_nothing_are_told_to_bear_nothing() -> None:
    bare = re.sub(r"^(mass|J|centre) = .*$", "", SQUARE[: SQUARE.index("[effects]")], flags=re.M)
    drawn = drawn_of(graphic_tmm.read(bare + "[forces]\npositions = [2]\n"))
    told = {column.segment: column.value[0, 2] for column in force_columns(drawn)}
    assert told["R12"] == told["R24"] == told["R53"] == told["P_bal_forces"] == 0.0


@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("name", SHEETS)
def test_the_sheet_of_two_plates_is_recomputed_from_itself(name: str, language: str) -> None:
    """Moments about the pins of the links and about the special point, by the arms that are drawn."""
    text = SHEETS[name].replace('language = "en"', f'language = "{language}"')
    drawn = drawn_of(graphic_tmm.read(text))
    assert check_sheet(drawn) >= 20
    (equations,) = (one for name, one in sheet(drawn).items() if name == "equations-2-3-4-5-2")
    headings = [line for line in lines(equations) if line.startswith("ΣM_W23^")]
    assert len(headings) == 2, headings
    figure = sheet(drawn)["group-2-3-4-5-2"]
    assert "W₂₃" in figure.words or "W23" in figure.words, figure.words
