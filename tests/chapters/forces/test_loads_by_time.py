"""Loads by time over turns, strokes, parts of a turn, against a table read at the time of each position."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from chapters.forces.test_swings import FourBar, four_bar
from support.boards import drawn_of
from support.drives import LEVER
from support.each import each
from support.open_rows import FORCES, STROKES, Stroke, drawn, sizes
from support.scenes import written

import graphic_tmm
from graphic_tmm.chapters.forces.load_diagrams import load_views
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import SceneError, TmmError
from graphic_tmm.page.dense import dense
from graphic_tmm.scene.read import read

Table = list[tuple[float, float]]
OF = replace(four_bar(3), omega=40.0)
TURN = 2.0 * math.pi / 40.0


def at_time(table: Table, t: float) -> float:
    """The size at a time; behind a jump at the jump; nothing outside."""
    near = 1e-9 * table[-1][0]
    there = [size for time, size in table if abs(t - time) < near]
    if there:
        return there[-1]
    for (a, p), (b, q) in pairwise(table):
        if a < t < b:
            return p + (q - p) * (t - a) / (b - a)
    return 0.0


def load(table: Table, more: str = "link = 3", unit: str = "N*m") -> str:
    points = ", ".join(f'["{t!r} s", "{size!r} {unit}"]' for t, size in table)
    return f"[[load]]\n{more}\nby_time = [{points}]\n"


@each("omega", [40.0, -40.0])
def test_two_turns_are_drawn_of_a_table_that_takes_them(omega: float, tmp_path: Path) -> None:
    of = replace(OF, omega=omega)
    table = [(0.0, 5.0), (0.6 * TURN, 90.0), (1.25 * TURN, 20.0), (1.25 * TURN, -60.0)]
    made = drawn(of.text(load([*table, (1.9 * TURN, 0.0)])), tmp_path)
    t = TURN * np.arange(32) / 16
    round_ = [*table, (1.9 * TURN, 0.0), (2.0 * TURN, 5.0)]
    wanted = [at_time(round_, one) for one in t]
    wanted[31] = 2.5 * (31 / 16 - 1.9) / 0.05  # between its last point and the next cycle
    np.testing.assert_allclose(sizes(made), wanted, rtol=1e-8)
    _balanced(of, made, np.array(wanted))


def _balanced(of: FourBar, made: Drawn, moment: np.ndarray) -> None:
    """The balance on the sheet and at any angle, over both turns, is by virtual power."""
    turned = 22.5 * np.arange(32) * np.sign(of.omega)
    phi, step = np.radians(17.0 + turned), 1e-5
    rate = np.radians(of.swing(phi + step) - of.swing(phi - step)) / (2.0 * step)
    needed = -moment * rate
    on_sheet = made.reading[FORCES_PLAN.on(made).first.balance][0]
    np.testing.assert_allclose(on_sheet, needed, rtol=1e-5, atol=1e-6)
    found = graphic_tmm.motion(made.scene, 17.0 + turned, plans=["forces"], exact=True)
    np.testing.assert_allclose(found.balance["M_bal_forces"], needed, rtol=1e-5, atol=1e-6)


@each("told, count", [("0.15708 s", 16), ("0.1572 s", 32), ("0.314159 s", 32), ("0.3141599 s", 32)])
def test_a_time_in_six_digits_is_that_of_the_turn(told: str, count: int, tmp_path: Path) -> None:
    text = OF.text(f'[[load]]\nlink = 3\nby_time = [[0, "7 N*m"], ["{told}", "9 N*m"]]\n')
    assert sizes(drawn(text, tmp_path)).size == count


def test_graphs_of_one_turn_take_no_time_of_two(tmp_path: Path) -> None:
    more = load([(0.0, 1.0), (1.5 * TURN, 2.0)]) + '[diagrams]\npoint = "B"\n'
    with pytest.raises(SceneError, match="by_time: it goes over two turns, and the graphs of"):
        read(written(tmp_path, OF.text(more)))


@each("name", STROKES)
@pytest.mark.slow
def test_an_open_row_has_the_size_of_each_time(name: str, tmp_path: Path) -> None:
    """On the sheet, at any place by `motion`, in every frame of the page."""
    of = STROKES[name]
    table = [(0.1, 4.0), (0.4, 90.0), (0.4, -30.0), (0.8, 70.0), (1.0, 50.0)]
    table = [(share * of.time, size) for share, size in table]
    extra = f'extra = ["{of.outside[0]} {of.unit}", "{of.outside[1]} {of.unit}"]\n'
    ends = f'from = "{of.first} {of.unit}"\nto = "{of.last} {of.unit}"\npositions = 6\n{extra}'
    made = drawn(of.scene(load(table, f"link = {of.link}"), ends), tmp_path)
    places = np.array([*np.linspace(of.first, of.last, 6), *of.outside])
    wanted = [at_time(table, t) for t in of.times(places)]
    assert wanted[6:] == [0.0, 0.0]
    assert wanted[2] == -30.0
    np.testing.assert_allclose(sizes(made), wanted, rtol=1e-7, atol=1e-9)
    between = np.array([*np.linspace(of.first, of.last, 17), *of.outside])
    due = [at_time(table, t) for t in of.times(between)]
    _everywhere(of, made, between, due, tmp_path)
    _framed(of, made, table)


def _everywhere(
    of: Stroke, made: Drawn, places: np.ndarray, due: list[float], folder: Path
) -> None:
    """Compare `motion` with a sheet of the same places whose sizes are listed."""
    order = np.argsort(of.times(places))
    listed = ", ".join(f'"{float(places[k])!r} {of.unit}"' for k in order)
    sized = ", ".join(f'"{float(due[k])!r} N*m"' for k in order)
    more = f"[[load]]\nlink = {of.link}\nby_position = [{sized}]\n"
    folder = folder / "listed"
    folder.mkdir()
    other = drawn(of.scene(more, f"positions = [{listed}]"), folder)
    at = places[order] * (1.0 if of.unit == "deg" else 1e-3)
    told = graphic_tmm.motion(made.scene, at, plans=["forces"], exact=True).balance
    forces = FORCES_PLAN.on(other).first
    for name, mark in zip(sorted(told), (forces.balance, forces.lever.balance), strict=True):
        wanted = other.reading[mark][0]
        largest = np.abs(wanted).max()
        np.testing.assert_allclose(told[name], wanted, rtol=1e-6, atol=1e-7 * largest)


def _framed(of: Stroke, made: Drawn, table: Table) -> None:
    played = dense(made)
    assert played is not None
    (mark,) = FORCES_PLAN.on(made).loads.given
    places: Any = played.angles * (1.0 if of.unit == "deg" else 1e3)
    found = np.asarray(played.given[mark])[0]
    due = np.array([at_time(table, t) for t in of.times(places)])
    jump = np.abs(of.times(places) - 0.4 * of.time) < 1e-9
    assert (~jump).sum() >= 360
    np.testing.assert_allclose(found[~jump], due[~jump], rtol=1e-6, atol=1e-6)


def test_a_table_may_go_on_to_a_place_outside_and_no_farther(tmp_path: Path) -> None:
    of = STROKES["slider"]
    keys = 'from = "250 mm"\nto = "350 mm"\npositions = 6\nextra = ["370 mm"]'
    table = [(0.0, 10.0), (0.24, 130.0)]
    text = of.scene(load(table), keys)
    np.testing.assert_allclose(sizes(drawn(text, tmp_path)), [10, 30, 50, 70, 90, 110, 130])
    for words, last in ((keys.replace('extra = ["370 mm"]', ""), "0.2"), (keys, "0.24")):
        text = of.scene(load([(0.0, 10.0), (0.25, 130.0)]), words)
        with pytest.raises(TmmError, match=f"the last position comes after {last} s, and the"):
            drawn(text, tmp_path)


def test_the_last_position_has_the_time_that_its_fault_tells(tmp_path: Path) -> None:
    """It rounds 0.478260869565 s to 0.478261 s, or a hand does to less."""
    of = STROKES["crank"]
    for told in (0.478261, 0.478258):
        found = sizes(drawn(of.scene(load([(0.0, 10.0), (told, 60.0)])), tmp_path))
        np.testing.assert_allclose(found, [10, 20, 30, 40, 50, 60])


def test_several_drives_go_by_the_first(tmp_path: Path) -> None:
    text = LEVER.replace("C = [0.4, 0]", "C = [0.4, 0]\nD = [0.4, 0.1]").split("[drive]")[0]
    text = text.replace("B = [0.3, 0], C = [0, 0]", "B = [0.3, 0], E = [0, 0]")
    text = text.replace('"left of AC"', '"left of AE"')
    text += "[[link]]\nnumber = 4\npoints = { C = [0, 0], E = [0.05, 0] }\n"
    text += (
        '[[drive]]\nlink = 1\nspeed = "2 rad/s"\nfrom = "20 deg"\nto = "75 deg"\npositions = 6\n'
    )
    text += '[[drive]]\nlink = 4\nspeed = "3 rad/s"\nat = "90 deg"\n'
    whole = math.radians(55.0) / 2.0
    table = [(0.0, 3.0), (0.5 * whole, 80.0), (whole, 30.0)]
    made = drawn(text + load(table) + FORCES, tmp_path)
    wanted = [at_time(table, t) for t in np.linspace(0.0, whole, 6)]
    np.testing.assert_allclose(sizes(made), wanted, rtol=1e-9)


LISTED = ", ".join('"500 mm/s"' for _ in range(6))
EVEN = "speeds and accelerations hold in the positions they are given for and tell no time between"
UNTIMED = {
    "speeds": ('speed = "500.0 mm/s"', f"speed = [{LISTED}]", EVEN),
    "gains": ("positions = 6", 'positions = 6\nacceleration = "1 m/s^2"', EVEN),
    "still": ('"500.0 mm/s"', '"0 m/s"', "what drives stands, so no place has a time"),
    "no ends": ('from = "250.0 mm"\nto = "350.0 mm"\n', "", "write from and to in .drive."),
    "one place": (
        'from = "250.0 mm"\nto = "350.0 mm"\npositions = 6', 'positions = ["250 mm"]', "comes after 0 s",
    ),
}  # fmt: skip


@each("name", UNTIMED)
def test_what_tells_no_time_is_refused(name: str, tmp_path: Path) -> None:
    text = STROKES["slider"].scene(load([(0.0, 1.0), (0.1, 2.0)]))
    old, new, says = UNTIMED[name]
    assert old in text
    with pytest.raises(TmmError, match=says):
        drawn(text.replace(old, new), tmp_path)


@each("name", ["crank back", "rod"])
def test_its_diagram_stands_over_the_time_with_its_positions(name: str, tmp_path: Path) -> None:
    of = STROKES[name]
    table = [(0.3 * of.time, 40.0), (0.7 * of.time, 90.0)]
    made = drawn_of(read(written(tmp_path, of.scene(load(table, f"link = {of.link}")))))
    (view,) = load_views(made, True)
    assert "t, s" in {label.text for label in view.labels}
    told = next(label.text for label in view.labels if label.text.startswith("μ_t"))
    along, up = (float(part.split(" = ")[1].split(" ")[0]) for part in told.split(", "))
    (line,) = (s for s in view.strokes if s.part == "given")
    np.testing.assert_allclose(
        [(x * along, y * up) for x, y, *_ in line.path],
        table,
        rtol=1e-6,  # type: ignore[union-attr]
    )
    dots: dict[int, tuple[float, float]] = {}
    for one in view.strokes:
        if one.position is not None:
            (left, y, *_), (right, *_) = one.path[:2]  # type: ignore[union-attr]
            dots[one.position] = ((left + right) / 2 * along, y * up)
    assert dots.keys() == {2, 3}
    for k, (t, size) in dots.items():
        assert t == pytest.approx(k / 5 * of.time)
        assert size == pytest.approx(at_time(table, t))


def test_the_diagram_of_a_turn_stands_over_the_time_too(tmp_path: Path) -> None:
    made = drawn_of(read(written(tmp_path, OF.text(load([(0.0, 5.0), (0.1, 80.0)])))))
    (view,) = load_views(made, True)
    assert "t, s" in {label.text for label in view.labels}
    assert not [one for one in view.strokes if one.position is not None]
