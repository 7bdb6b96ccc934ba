"""Drives of all kinds against published figures and closed forms: tasks as a sheet of the book gives them."""

from __future__ import annotations

import cmath
import math
import tomllib
from collections.abc import Callable

import pytest
from support import driven_scenes
from support.free_bodies import Judge, Poses
from support.free_forces import Rough, statics

import graphic_tmm

BOOM = driven_scenes.BOOM.format(drive=driven_scenes.OUT, loaded="")
SLIDER = driven_scenes.SLIDER.format(
    drive='speed = "0.5 m/s"\nfrom = "250 mm"\nto = "350 mm"', loaded=""
)
CRANKS = """
title = "Five-bar"
language = "en"
[frame]
O = [0, 0]
D = [0.3, 0]
[[link]]
number = 1
points = { O = [0, 0], A = [0.1, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.3, 0] }
[[link]]
number = 3
points = { C = [0, 0], B = [0.3, 0] }
side = "left of AC"
[[link]]
number = 4
points = { D = [0, 0], C = [0.1, 0] }
[[drive]]
link = 1
speed = "5 rad/s"
zero = "60 deg"
[[drive]]
link = 4
speed = "10 rad/s"
turns = "clockwise"
at = "120 deg"
"""
NARROW = f'{driven_scenes.NARROW}from = "68 deg"\nto = "78 deg"\npositions = 6\n'


def test_a_cylinder_drives_a_boom() -> None:
    found = graphic_tmm.motion(graphic_tmm.read(BOOM), [0.6], exact=True)
    assert found.omega[1][0] == pytest.approx(0.151186, abs=1e-6)
    assert found.omega[2][0] == pytest.approx(0.094491, abs=1e-6)
    assert found.omega[3][0] == pytest.approx(0.094491, abs=1e-6)
    assert found.epsilon[1][0] == pytest.approx(0.00972, abs=1e-5)
    assert abs(found["C"].velocity[0]) == pytest.approx(0.151186, abs=1e-6)


def test_a_boom_has_its_closed_form_in_every_position() -> None:
    table = graphic_tmm.draw(graphic_tmm.read(BOOM), exact=True).table("velocities")
    for k in range(6):
        length = 0.6 + 0.05 * k
        sine = math.sin(math.acos((0.25 + 0.16 - length * length) / 0.4))
        assert abs(table["omega1"].value[0, k]) == pytest.approx(length * 0.05 / (0.2 * sine))


def test_a_rod_comes_to_its_dead_place_where_the_boom_lies_along_it() -> None:
    """ON and OG in line: at 0.9 m the rod cannot turn the boom any further; none reaches 0.91 m."""
    scene = graphic_tmm.read(BOOM.replace("850 mm", "910 mm"))
    found = graphic_tmm.motion(scene, [0.899999, 0.91], exact=True)
    sine = math.sin(math.acos((0.25 + 0.16 - 0.899999**2) / 0.4))
    assert found.omega[1][0] == pytest.approx(0.899999 * 0.05 / (0.2 * sine), rel=1e-6)
    assert math.isnan(found["N"].place[1].real)
    warnings = graphic_tmm.draw(scene, exact=True).warnings
    assert any("cannot be drawn" in warning and "5" in warning for warning in warnings)


def test_a_slider_drives_a_crank() -> None:
    at = 0.05 + math.sqrt(0.09 - 0.0075)
    found = graphic_tmm.motion(graphic_tmm.read(SLIDER), [at], exact=True)
    assert found["A"].place[0] == pytest.approx(cmath.rect(0.1, math.pi / 3))
    assert found.omega[3][0] == pytest.approx(-4.917479, abs=1e-6)
    assert found.omega[2][0] == pytest.approx(0.856023, abs=1e-6)
    assert found.epsilon[3][0] == pytest.approx(-7.93943, abs=1e-5)


def test_two_cranks_drive_one_point() -> None:
    scene = graphic_tmm.read(CRANKS)
    found = graphic_tmm.motion(scene, [60.0, 90.0], exact=True)
    assert found["B"].velocity[0] == pytest.approx(-0.137047 + 0.145360j, abs=1e-6)
    assert found.omega[2][0] == pytest.approx(-1.046397, abs=1e-6)
    assert found.omega[3][0] == pytest.approx(3.546397, abs=1e-6)
    # while the first turns by 30 degrees the other turns by 60 the other way
    assert found["C"].place[1] == pytest.approx(0.3 + cmath.rect(0.1, math.pi / 3))


def test_a_crank_that_others_follow_comes_not_back_after_a_turn() -> None:
    """At 400° the second, 1.4 times as fast, stands where it does not at 40°."""
    text = CRANKS.replace('zero = "60 deg"', 'from = "300 deg"\nto = "420 deg"')
    text = text.replace("10 rad/s", "7 rad/s")
    found = graphic_tmm.motion(graphic_tmm.read(text), [400.0], exact=True)
    assert found["C"].place[0] == pytest.approx(0.3 + cmath.rect(0.1, math.radians(120 - 140)))


def test_a_narrow_range_is_a_row_of_its_own() -> None:
    sheet = graphic_tmm.draw(graphic_tmm.read(NARROW), exact=True)
    table = sheet.table("velocities")
    assert table.positions == tuple("012345")
    assert not any("cannot be drawn" in warning for warning in sheet.warnings)
    found = graphic_tmm.motion(graphic_tmm.read(NARROW), [68.0, 78.0], exact=True)
    for k in (0, 1):
        assert abs(found["E"].place[k] - found["D"].place[k]) == pytest.approx(5.476532)


ROUGH = """[effects]
gravity = true
friction = true
[friction]
f = 0.1
radius = "10 mm"
passes = 20
[forces]
"""


@pytest.mark.parametrize("ends", [("600 mm", "850 mm"), ("850 mm", "600 mm")])
def test_friction_of_a_driven_rod(ends: tuple[str, str]) -> None:
    """In pins O, N, G and along the cylinder, running out and in."""
    text = BOOM.replace("side =", 'mass = "40 kg"\ncentre = "C"\nJ = 0\nside =', 1) + ROUGH
    text = text.replace('"600 mm"', f'"{ends[0]}"', 1).replace('to = "850 mm"', f'to = "{ends[1]}"')

    def poses(length: float) -> Poses:
        turn = math.acos((0.25 + 0.16 - length**2) / 0.4)
        n = cmath.rect(0.5, turn)
        along = cmath.phase(n - 0.4)
        return [(0j, turn), (0.4 + 0j, along), (n, along)]

    rubbed(text, places(ends, 6), poses, "ONGz")


@pytest.mark.parametrize("ends", [("250 mm", "350 mm"), ("350 mm", "250 mm")])
def test_friction_of_a_slider_that_drives(ends: tuple[str, str]) -> None:
    """In pins O, A, B and along the guide, forth and back."""
    load = '[[load]]\nlink = 3\nmoment = "10 N*m"\n'
    text = SLIDER.replace('"250 mm"', f'"{ends[0]}"', 1).replace(
        'to = "350 mm"', f'to = "{ends[1]}"'
    )

    def poses(x: float) -> Poses:
        a = cmath.rect(0.1, math.acos((x * x + 0.01 - 0.09) / (0.2 * x)))
        return [(x + 0j, 0.0), (a, cmath.phase(x - a)), (0j, cmath.phase(a))]

    rubbed(text + "positions = 5\n" + load + ROUGH, places(ends, 5), poses, "OABx")


def places(ends: tuple[str, str], count: int) -> list[float]:
    """The places of a row, m, between ends in whole millimetres."""
    first, last = (float(end.removesuffix(" mm")) / 1e3 for end in ends)
    return [first + (last - first) * k / (count - 1) for k in range(count)]


def rubbed(text: str, row: list[float], poses: Callable[[float], Poses], names: str) -> None:
    """Compare what balances a drive, by groups and on the lever, with the judge of all links at once."""
    judge, rough = Judge(tomllib.loads(text)), {name: Rough(0.1, 0.01) for name in names}
    table = graphic_tmm.draw(graphic_tmm.read(text), exact=True).table("forces")
    for k, at in enumerate(row):
        state = judge.solve([at], poses(at))
        due = statics(judge, state, rough=rough)
        assert abs(due.power) < 1e-14
        (balance,) = due.drives
        assert abs(balance - statics(judge, state).drives[0]) > 1.0
        for name in ("forces", "lever"):
            value = table[f"P_bal_{name}"].value[0, k]
            assert value == pytest.approx(balance, abs=1e-8 * due.largest), (k, name)
