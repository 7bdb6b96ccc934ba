"""Loads by the travel of several sliders, each from its own dead centre; the judge is the closed form."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from support import drives
from support.boards import drawn_of
from support.each import each
from support.scenes import written
from support.stars import Star

import graphic_tmm
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import SceneError, TmmError
from graphic_tmm.scene.read import read

OMEGA = 40.0
STARS = {
    "three plungers": Star((0.0, 120.0, 240.0)),
    "v": Star((135.0, 45.0)),
    "offset": Star((90.0, 0.0), offsets=(0.01, -0.012)),
    "opposed": Star((0.0, 180.0), cranks=(0.0, 180.0)),
    "in line": Star((90.0, 90.0), cranks=(0.0, 120.0)),
    "master rod": Star((90.0,), master=(0.045, 0.02, 0.15, 20.0)),
}
TABLE = "out = [[0, 100], [1, 300]]\nback = [[0, 4000], [0.4, 900], [1, 700]]\n"
OUT, BACK = ((0.0, 1.0), (100.0, 300.0)), ((0.0, 0.4, 1.0), (4000.0, 900.0, 700.0))


def drive(speed: float, more: str = "") -> str:
    way = "counterclockwise" if speed > 0 else "clockwise"
    return f'speed = "{abs(speed)} 1/s"\nturns = "{way}"\npositions = 16\nzero = "17 deg"\n{more}'


def pistons(star: Star) -> str:
    return "BCDE"[: len(star.angles) + bool(star.master)]


def loads(star: Star, more: str = "") -> str:
    every = "".join(
        f'[[load]]\nlink = {2 * k + 3}\npoint = "{p}"\nof = "{p}"\n{TABLE}{more}'
        for k, p in enumerate(pistons(star))
    )
    return every + '[forces]\npositions = "all"\nbalance = "moment"\n'


def sizes(made: Drawn) -> list[np.ndarray]:
    marks = FORCES_PLAN.on(made).loads.given
    return [np.asarray(made.reading[mark][0]) for mark in marks]


def due(star: Star, k: int, phi: np.ndarray, omega: float, *, outer: bool = True) -> np.ndarray:
    """The size of a load, written down by hand."""
    share, going = star.shares(k, phi, outer=outer), star.speed(k, phi, omega)
    away = going < 0 if outer else going > 0
    return np.where(away, np.interp(share, *OUT), np.interp(share, *BACK))


@each("name", STARS)
@each("omega", [OMEGA, -OMEGA])
@pytest.mark.slow
def test_every_slider_is_loaded_from_its_own_dead_centre(
    name: str, omega: float, tmp_path: Path
) -> None:
    star = STARS[name]
    scene = read(written(tmp_path, star.text(drive(omega, loads(star)))))
    made = drawn_of(scene, exact=True)
    turned = np.radians(22.5) * np.arange(16) * np.sign(omega)
    phi = np.radians(17.0) + turned
    moment = np.zeros(16)
    for k, found in enumerate(sizes(made)):
        wanted = due(star, k, phi, omega)
        np.testing.assert_allclose(found, wanted, rtol=1e-8)
        moment += np.abs(star.speed(k, phi, omega)) * wanted / omega
    forces = FORCES_PLAN.on(made)
    for mark in (forces.first.balance, forces.first.lever.balance):
        np.testing.assert_allclose(made.reading[mark][0], moment, rtol=1e-7)


@each("name", ["v", "master rod"])
@each("omega", [OMEGA, -OMEGA])
@each("fast", [False, True])
@pytest.mark.slow
def test_any_angle_has_the_size_that_the_travel_tells_there(
    name: str, omega: float, fast: bool, tmp_path: Path
) -> None:
    star = STARS[name]
    scene = read(written(tmp_path, star.text(drive(omega, loads(star)))))
    at = np.arange(0.0, 360.0, 7.0)
    found = graphic_tmm.motion(scene, at, plans=["forces"], exact=True, fast=fast).balance[
        "M_bal_forces"
    ]
    phi = np.radians(at)
    wanted = sum(
        np.abs(star.speed(k, phi, omega)) * due(star, k, phi, omega) / omega
        for k in range(len(pistons(star)))
    )
    np.testing.assert_allclose(found, wanted, rtol=1e-7, atol=1e-7)


def test_a_travel_may_begin_at_the_end_that_is_named(tmp_path: Path) -> None:
    star = STARS["v"]
    scene = read(written(tmp_path, star.text(drive(OMEGA, loads(star, 'start = "bottom"\n')))))
    made = drawn_of(scene, exact=True)
    phi = np.radians(17.0 + 22.5 * np.arange(16))
    for k, found in enumerate(sizes(made)):
        np.testing.assert_allclose(found, due(star, k, phi, OMEGA, outer=False), rtol=1e-8)


@each("zero", ["17 deg", "outer", "inner"])
@each(
    "angle, start, outer",
    [
        (90.0, "top", True),
        (90.0, "bottom", False),
        (270.0, "top", False),
        (270.0, "bottom", True),
        (0.0, "right", True),
        (0.0, "left", False),
        (180.0, "right", False),
        (180.0, "left", True),
        (135.0, "top", True),
        (135.0, "right", False),
    ],
)
def test_each_end_is_told_by_its_side_wherever_the_row_begins(
    angle: float, start: str, outer: bool, zero: str, tmp_path: Path
) -> None:
    """Where the row begins at that end itself too, and where it begins at the other."""
    begins = {"17 deg": 17.0, "outer": angle, "inner": angle + 180.0}[zero]
    _starts(Star((angle,)), begins, start, outer, tmp_path)


@each("zero, outer", [(17.0, True), (90.0, True), (270.0, False)])
def test_a_travel_begins_where_the_row_does_if_it_turns_back_there(
    zero: float, outer: bool, tmp_path: Path
) -> None:
    _starts(Star((90.0,)), zero, "", outer, tmp_path)


def _starts(star: Star, begins: float, start: str, outer: bool, folder: Path) -> None:
    """Compare the loads of a slider with the judge; its guide is drawn forth, and back."""
    told = loads(star, f'start = "{start}"\n' if start else "")
    text = drive(OMEGA, told).replace("17 deg", f"{begins} deg")
    turned = replace(star, angles=(star.angles[0] + 180.0,)).text(text)
    mirrored = [turned.replace('side = "+"', 'side = "-"')] if begins == 17.0 else []
    for scene in (star.text(text), *mirrored):
        made = drawn_of(read(written(folder, scene)), exact=True)
        _compare(star, made, begins, outer)


def _compare(star: Star, made: Drawn, begins: float, outer: bool) -> None:
    phi = np.radians(begins + 22.5 * np.arange(16))
    moves = np.abs(star.speed(0, phi, OMEGA)) > 1e-3
    assert moves.sum() >= 14
    (found,) = sizes(made)
    wanted = due(star, 0, phi, OMEGA, outer=outer)
    np.testing.assert_allclose(found[moves], wanted[moves], rtol=1e-7)


def test_an_end_that_is_none_is_refused(tmp_path: Path) -> None:
    star = Star((0.0, 90.0))
    scene = read(written(tmp_path, star.text(drive(OMEGA, loads(star, 'start = "left"\n')))))
    with pytest.raises(TmmError, match='C does not turn back there; write one of "bottom", "top"'):
        drawn_of(scene)


def test_a_beginning_needs_a_travel(tmp_path: Path) -> None:
    load = '[[load]]\nlink = 3\npoint = "B"\nforce = 7\nstart = "left"\n[forces]\n'
    with pytest.raises(SceneError, match="the travel of which point begins there"):
        read(written(tmp_path, STARS["v"].text(drive(OMEGA, load))))


def test_a_load_over_two_turns_draws_both(tmp_path: Path) -> None:
    star = STARS["v"]
    load = (
        '[[load]]\nlink = 5\npoint = "C"\ndirection = "225 deg"\n'
        "by_angle = [[0, 0], [360, 4000], [720, 0]]\n"
        '[forces]\npositions = "all"\nbalance = "moment"\n'
    )
    made = drawn_of(read(written(tmp_path, star.text(drive(OMEGA, load)))), exact=True)
    turned = 22.5 * np.arange(32)
    wanted = np.interp(turned, (0.0, 360.0, 720.0), (0.0, 4000.0, 0.0))
    np.testing.assert_allclose(sizes(made)[0], wanted, rtol=1e-12)
    moment = wanted * star.speed(1, np.radians(17.0 + turned), OMEGA) / OMEGA
    found = made.reading[FORCES_PLAN.on(made).first.balance][0]
    np.testing.assert_allclose(found, moment, rtol=1e-6, atol=1e-7)


def test_sizes_by_position_come_again_in_the_second_turn(tmp_path: Path) -> None:
    each_place = [100.0 * (k - 5) for k in range(16)]
    load = (
        '[[load]]\nlink = 5\npoint = "C"\ndirection = "225 deg"\nby_angle = [[0, 0], [720, 1]]\n'
        f'[[load]]\nlink = 3\npoint = "B"\ndirection = "0 deg"\nby_position = {each_place}\n'
        '[forces]\npositions = "all"\n'
    )
    made = drawn_of(read(written(tmp_path, STARS["v"].text(drive(OMEGA, load)))), exact=True)
    np.testing.assert_array_equal(sizes(made)[1], each_place * 2)


def test_graphs_of_one_turn_take_no_load_over_two(tmp_path: Path) -> None:
    load = (
        '[[load]]\nlink = 5\npoint = "C"\nby_angle = [[0, 0], [720, 1]]\n[forces]\n'
        '[diagrams]\npoint = "B"\n'
    )
    with pytest.raises(SceneError, match="it goes over two turns"):
        read(written(tmp_path, STARS["v"].text(drive(OMEGA, load))))


TURNED = (
    '[[load]]\nlink = 3\npoint = "B"\ndirection = "0 deg"\n'
    'by_angle = [[0, "10 N"], [100, "110 N"], [360, "10 N"]]\n[forces]\npositions = "all"\n'
)


@each("text", [drives.RACK, drives.BOOM, drives.SLIDER])
def test_lengths_are_no_angles(text: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError, match="by_angle: what drives slides and has no angle"):
        read(written(tmp_path, text + TURNED))


def test_a_lever_that_turns_in_part_goes_by_its_turn_from_the_first_position(
    tmp_path: Path,
) -> None:
    made = drawn_of(read(written(tmp_path, drives.LEVER + TURNED)), exact=True)
    np.testing.assert_allclose(sizes(made)[0], 10.0 + 11.0 * np.arange(6), rtol=1e-12)
