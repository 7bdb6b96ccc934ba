"""The specimen of lines and symbols: every pen of a line, every symbol in its cell, each with its name."""

from __future__ import annotations

import numpy as np
import shapely

from graphic_tmm.chapters.lettering.views import specimen_symbols
from graphic_tmm.paper.drawing import Bezier, Stroke
from graphic_tmm.paper.formats import HEIGHTS
from graphic_tmm.paper.pens import pens
from graphic_tmm.paper.shapes import shape

LINES, SYMBOLS = specimen_symbols("ru", HEIGHTS["A1"])


def test_every_pen_that_draws_lines_is_shown() -> None:
    shown = {s.pen for s in LINES.strokes}
    hiding = {"body", "rod", "over", "paper", "joint", "outline", "pin"}
    assert shown == set(pens("A1")) - hiding
    assert any(isinstance(s, Bezier) for s in LINES.strokes)
    assert len(LINES.labels) == 1 + len({shape(s).centroid.y for s in LINES.strokes})


def test_the_open_line_is_strokes_with_a_gap() -> None:
    """ГОСТ 2.303: strokes of 8 to 20 mm."""
    strokes = sorted(shape(s).bounds for s in LINES.strokes if s.pen == "thick")
    assert len(strokes) == 2
    assert all(8.0 <= right - left <= 20.0 for left, _, right, _ in strokes)
    assert strokes[1][0] - strokes[0][2] > 8.0


def test_the_cam_is_one_smooth_body_on_which_its_roller_lies() -> None:
    """It turns one way, a little at each corner, and has a lift about its pivot; the roller touches it."""
    closed = [s for s in SYMBOLS.strokes if isinstance(s, Stroke) and s.closed]
    profile = max(closed, key=lambda s: len(s.path))
    spots = np.array([complex(x, y) for x, y, _ in profile.path])
    sides = np.roll(spots, -1) - spots
    turns = np.degrees(np.angle(np.roll(sides, -1) / sides))
    assert (turns > 0.0).all()
    assert turns.max() < 10.0
    body = shapely.Polygon([(z.real, z.imag) for z in spots])
    rounds = [shape(s) for s in SYMBOLS.strokes if s.pen == "joint"]
    (pivot,) = (one.centroid for one in rounds if one.centroid.within(body))
    reach = np.abs(spots - complex(pivot.x, pivot.y))
    assert reach.max() > 1.3 * reach.min()
    gaps = [one.centroid.distance(body) - (one.bounds[2] - one.bounds[0]) / 2 for one in rounds]
    assert min(map(abs, gaps)) < 0.05
