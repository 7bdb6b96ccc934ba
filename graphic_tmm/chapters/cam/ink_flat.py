"""The condition of convexity of a cam with a flat face, in ink: S over d²S/dφ² and the line at 45°."""

from __future__ import annotations

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.chapters.cam.centre import VIEW
from graphic_tmm.chapters.cam.flat import Convexity
from graphic_tmm.chapters.cam.ink_centre import CentreNames
from graphic_tmm.chapters.cam.ink_numbers import (
    LEAST,
    OVER,
    SIZE,
    SMALL,
    Numbers,
    arrow_axis,
    finished,
    numbered,
    segments,
)
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, arc, circle, line
from graphic_tmm.paper.symbols.dimensions import dimension

BEYOND = 14.0
"""How far the line at 45° goes on behind its ends, mm."""
ANGLE = 14.0
"""Radius of the arc that shows the 45°, mm."""
ASIDE, APART = 12.0, 9.0
"""From the axis to the dimension of a radius, between two of them, mm."""


def draw_convexity_ink(
    reading: Reading, cam: Cam, names: CentreNames, title: str, *, lettered: bool = True
) -> Drawing:
    """Return S over d²S/dφ² with the line at 45° that touches it from below, and the radii cut off."""
    made = cam.centre
    assert isinstance(made, Convexity)
    ink = Numbers(reading, cam)
    spots = np.full(cam.diagrams.turn.positions, np.nan + np.nan * 1j)
    strokes: list[Ink] = []
    for mark, curve, (_, first, last) in zip(
        made.points, made.curves, cam.diagrams.stretches, strict=True
    ):
        part = slice(first, last + 1)
        spots[part] = np.where(np.isfinite(spots[part]), spots[part], ink.all(mark)[part])
        strokes += ink.curve(curve)
        strokes += ink.dots(ink.all(mark)[part])
        own = ink.all(mark)[part]
        strokes += segments(own - own.real, own)
    ends = [ink.one(mark) for mark in made.outline]
    for a, b in zip(ends[1::2], ends[2::2], strict=False):
        if np.isfinite(a) and np.isfinite(b) and abs(b - a) > LEAST:
            strokes.append(line("main", a, b))
    left, right = float(np.nanmin(spots.real)), float(np.nanmax(spots.real))
    top, cut = float(np.nanmax(spots.imag)), ink.one(made.cut)
    low = min(0.0, cut.imag) - OVER
    strokes += arrow_axis(complex(left - OVER), complex(right + OVER))
    strokes += arrow_axis(complex(0, low), complex(0, top + OVER))
    wanted = [
        Wanted(names.up, complex(0, top + OVER), SIZE, 1.5, 1 + 0j),
        Wanted(names.out, complex(right + OVER), SIZE, 1.5, -1j),
    ]
    figures = []
    if np.isfinite(cut):
        limit = reading[made.limit]
        spot, way = complex(limit.at[0, 0]), complex(limit.along[0, 0])
        strokes.append(line("main", spot - BEYOND * way, cut + BEYOND * way))
        strokes.append(arc("thin", cut, ANGLE, 90.0, 45.0))
        wanted.append(Wanted("45°", cut + ANGLE * (-0.38 + 0.92j), SMALL, 0.5, -0.38 + 0.92j))
        strokes.append(circle("main", cut, 0.7, filled=True))
        radius = ink.length(made.radius)
        centre = complex(0, -radius)
        strokes.append(line("centre", complex(0, low), centre - 6j))
        strokes.append(circle("joint", centre, 1.2))
        wanted.append(Wanted("O", centre, SIZE, 1.8, 1 + 0j))
        least = -1j * 1000.0 * ink.length(made.least) / (1000.0 * ink.length(made.mu))
        for end, text, offset in (
            (centre, names.r0, -(ASIDE + APART)),
            (least, names.least, -ASIDE),
        ):
            if abs(end) > LEAST:
                drawn = dimension(end, 0j, offset, text)
                strokes += drawn.strokes
                figures.append(drawn.label)
    wanted += numbered(names.positions, spots, spots - 0.5j * top)
    return finished(VIEW, title, strokes, wanted, figures, lettered)
