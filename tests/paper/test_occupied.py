"""Ink over a frame: as long as it is, whatever the size of the drawing and wherever its lines run."""

from __future__ import annotations

import cmath
import math
import random
import tracemalloc

import numpy as np
import pytest
import shapely
from support.each import each

from graphic_tmm.paper.drawing import Drawing, Wanted, circle, line
from graphic_tmm.paper.labels import finished, place
from graphic_tmm.paper.occupied import CELL, MOST, Raster
from graphic_tmm.paper.shapes import box, shape

NOWHERE = (complex(math.nan, 0), complex(0, math.inf), complex(-math.inf, math.nan), 1e300 + 0j)
SIZES = (1e-3, 1e-1, 1.0, 1e2, 1e4, 1e6, 1e9)


@each("seed", range(10))
def test_a_box_holds_as_much_of_the_lines_as_geometry_says(seed: int) -> None:
    chance = random.Random(seed)

    def spot(reach: float) -> complex:
        return complex(chance.uniform(-reach, reach), chance.uniform(-reach, reach))

    lines = [[spot(300), spot(300), spot(300)] for _ in range(10)]
    raster = Raster([*lines, *([z, 0j] for z in NOWHERE)], (-60.0, -50.0, 60.0, 50.0))
    ink = shapely.MultiLineString([[(z.real, z.imag) for z in points] for points in lines])
    for _ in range(10):
        x, y, w, h = (
            *(chance.uniform(-50, 20) for _ in "xy"),
            *(chance.uniform(8, 30) for _ in "wh"),
        )
        (found,) = raster.length(*(np.array([v]) for v in (x, y, x + w, y + h)))
        due = ink.intersection(shapely.box(x, y, x + w, y + h)).length
        assert abs(found - due) <= 2 * math.sqrt(2) * CELL * len(lines) * 2


@pytest.mark.turns(1)
@pytest.mark.parametrize("size", SIZES)
def test_a_raster_is_bounded_whatever_it_is_to_hold(size: float) -> None:
    corners = [cmath.rect(size, k) for k in range(20)]
    for frame in ((-size, -size, size, size), (0.0, 0.0, size, 0.0), (0.0, 0.0, 1.0, size)):
        raster = Raster([corners], frame)
        assert raster.wide * raster.high <= 3 * MOST + 1
        whole = [np.array([v]) for v in frame]
        assert np.isfinite(raster.length(*whole)).all()


@pytest.mark.parametrize("size", SIZES)
def test_letters_find_places_in_drawings_of_any_size(size: float) -> None:
    """A plan of which one line and one letter are far away, and some lines are nowhere."""
    pins = [cmath.rect(10.0, k) for k in range(6)]
    ink = [
        circle("main", 0j, 10.0),
        line("main", 0j, size + 0j, size * 1j),
        *(line("thin", 0j, z) for z in NOWHERE[:3]),
    ]
    wanted = [Wanted(f"A_{k}", z, 3.5, toward=z) for k, z in enumerate([*pins, size + 1j * size])]
    tracemalloc.start()
    labels = place(wanted, ink)
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert most < 400e6
    near = [box(one) for one in labels[:6]]
    assert all(a.disjoint(b) for k, a in enumerate(near) for b in near[:k])
    assert all(one.centroid.distance(shapely.Point(0, 0)) < 40 for one in near)
    if size < 1e4:  # the squares are as fine as on any sheet
        assert not any(one.intersects(shape(k)) for one in near for k in ink[:2])


def test_a_letter_that_is_wanted_nowhere_is_left_out() -> None:
    wanted = tuple(Wanted("A", z, 3.5) for z in (0j, *NOWHERE[:3]))
    view = Drawing("v", "V", (line("main", 0j, 5j),), wanted=wanted)
    for lettered in (True, False):
        made = finished(view, lettered)
        assert not made.wanted
        assert len(made.labels) == lettered
    assert finished(view._replace(wanted=wanted[1:])) == view._replace(wanted=())
