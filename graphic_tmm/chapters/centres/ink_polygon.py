"""The polygon of links: its corners are links, its sides centres, numbered as they were found."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence

import shapely

from graphic_tmm.chapters.centres.network import GUIDE, PIN, WHEEL
from graphic_tmm.chapters.centres.record import Centres
from graphic_tmm.paper.arithmetic import coordinates
from graphic_tmm.paper.drawing import Drawing, Ink, Label, circle, line
from graphic_tmm.paper.figure import added
from graphic_tmm.paper.seen import Subject

LEAST, A_LINK = 26.0, 6.5
"""The radius of the polygon, mm, at least; so much for each link."""
SHARES = (0.5, 0.4, 0.6, 0.33, 0.67, 0.26, 0.74, 0.2, 0.8)
"""Where on its side the number of a side may stand."""


def draw_polygon(on: Subject, made: Centres) -> Drawing:
    """Return the polygon of links; sides of pairs are heavy, those of further centres thin."""
    links = [*sorted(k for k in made.links if k != made.frame), made.frame]
    radius = max(LEAST, A_LINK * len(links))
    turn = math.tau / len(links)
    corners = {k: cmath.rect(radius, math.pi / 2 - n * turn) for n, k in enumerate(links)}
    strokes: list[Ink] = []
    for one in made.centres:
        pen = "main" if one.way in (PIN, GUIDE, WHEEL) else "thin"
        strokes.append(line(pen, *(corners[k] for k in one.links)))
    size, labels = on.heights.point, list[Label]()
    for link, at in corners.items():
        strokes.append(circle("main", at, 1.1, filled=True))
        out = at * (1.0 + (0.9 * size + 1.5) / radius)
        labels.append(Label(str(link), out - 0.5j * size, size, "middle"))
    sides = [tuple(corners[k] for k in one.links) for one in made.centres]
    labels += _numbers(sides, on.heights.number)
    return Drawing("centres-polygon", on.title, tuple(added(strokes, "polygon")), tuple(labels))


def _numbers(sides: Sequence[Sequence[complex]], size: float) -> Iterator[Label]:
    """The numbers of the sides, each beside its own where no other side and no number is near."""
    lines = [shapely.LineString(coordinates(side)) for side in sides]
    there: list[shapely.Point] = []

    def clear(spot: complex) -> float:
        at = shapely.Point(*coordinates([spot]))
        off = min((at.distance(one) for one in there), default=math.inf) / 2.2
        return round(min(at.distance(others), off, 1.1 * size), 6)

    for number, (a, b) in enumerate(sides, 1):
        others = shapely.MultiLineString([one for k, one in enumerate(lines, 1) if k != number])
        aside = 0.85j * size * (b - a) / abs(b - a)
        tried = [a + share * (b - a) + side * aside for share in SHARES for side in (1, -1)]
        at = max(tried, key=clear)
        there.append(shapely.Point(*coordinates([at])))
        yield Label(str(number), at - 0.5j * size, size, "middle")
