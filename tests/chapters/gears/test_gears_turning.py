"""Two wheels that turn on the page: their flanks touch at every angle and never cut, laid there by shapely."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import shapely
from support.gallery import SHEETS
from support.turned import inside, laid, picture

from graphic_tmm.page.turning import Shift

HEAD = 'title = "T"\nlanguage = "en"\n[gears]\nm = "5 mm"\n'
CASES = {
    "pair": str(SHEETS / "gear-pair"),
    "ring": str(SHEETS / "ring-gear"),
    "undercut": HEAD + "z1 = 12\nz2 = 30\nx1 = 0.3\nx2 = 0\n",
    "many": HEAD + "z1 = 25\nz2 = 38\nx1 = 0.1\nx2 = -0.1\n",
}
NEAR = 0.01
"""Flanks are drawn through points by the French curve, mm."""


@pytest.mark.parametrize("case", CASES)
def test_flanks_touch_and_never_cut(tmp_path: Path, case: str) -> None:
    shown = picture(tmp_path, CASES[case])
    first, second = (body for body in shown.bodies if body.copies > 1)
    assert first.copies < second.copies
    pitch = 360.0 / first.copies
    for turn in (*np.linspace(0.0, pitch, 6)[1:], 100.3):
        one, other = (inside(laid(body, turn)) for body in (first, second))
        for wheel, body in ((one, first), (other, second)):
            assert wheel.geom_type == "Polygon", "an outline goes once round"
            assert wheel.contains(shapely.Point(body.centre.real, body.centre.imag))
        apart = shapely.difference(one, other) if case == "ring" else one.intersection(other)
        assert apart.buffer(-NEAR).area == 0.0, turn
        edge = one.boundary
        shapely.prepare(edge)
        assert shapely.dwithin(edge, other.boundary, NEAR), turn


@pytest.mark.parametrize(("case", "sense"), [("pair", -1), ("ring", 1)])
def test_a_pair_turns_by_its_teeth(tmp_path: Path, case: str, sense: int) -> None:
    """Of two wheels with outer teeth one turns against the other; the bands on flanks go with their wheels."""
    shown = picture(tmp_path, CASES[case])
    wheels = [body for body in shown.bodies if body.copies > 1]
    rates = [body.moves[0][1] for body in wheels]
    assert abs(rates[0]) == 1.0
    assert rates[1] / rates[0] == pytest.approx(sense * wheels[0].copies / wheels[1].copies)
    bands = [body for body in shown.bodies if body.copies == 1]
    assert [band.moves for band in bands] == [wheel.moves for wheel in wheels]
    for band, wheel in zip(bands, wheels, strict=True):
        flanks = laid(wheel, 77.0)
        assert laid(band, 77.0).distance(flanks) < NEAR


@pytest.mark.parametrize("more", ["", "x1 = 0.4\n", 'beta = "20 deg"\nha = [1.0, 0.9]\n'])
def test_a_rack_runs_on_and_its_flanks_touch(tmp_path: Path, more: str) -> None:
    shown = picture(tmp_path, HEAD + f'z1 = 20\nz2 = "rack"\n{more}')
    wheel, rack = max(shown.bodies, key=lambda one: one.copies), shown.bodies[2]
    assert wheel.moves[0].angle == -1.0
    (move,) = rack.moves
    assert isinstance(move, Shift)
    for turn in (0.0, 3.7, 11.0, 100.3, 251.9, 360.0):
        one, other = inside(laid(wheel, turn)), laid(rack, turn)
        left, right = other.bounds[0], other.bounds[2]
        assert left < wheel.centre.real < right
        joined = shapely.line_merge(shapely.set_precision(other, 1e-4))
        assert joined.geom_type == "LineString", "the teeth go on in one line"
        above = shapely.Polygon([*joined.coords, (right, 1e4), (left, 1e4)])
        assert above.is_valid
        assert one.intersection(above).buffer(-NEAR).area == 0.0, turn
        assert shapely.dwithin(one.boundary, other, NEAR), turn
    (_, way) = shown.values
    assert way.course * 360.0 == pytest.approx(
        np.pi * 20 * 5 / (np.cos(np.pi / 9) if "beta" in more else 1)
    )


def test_what_is_constructed_stands(tmp_path: Path) -> None:
    shown = picture(tmp_path, CASES["pair"])
    assert {"tooth", "hatching"}.isdisjoint(stroke.part for stroke in shown.stands.strokes)
    assert len(shown.stands.strokes) > 20
