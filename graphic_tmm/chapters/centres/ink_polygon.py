"""The polygon of links: its corners are links, its sides centres, numbered as they were found."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

import numpy as np

from graphic_tmm.chapters.centres.network import GUIDE, PIN, WHEEL
from graphic_tmm.chapters.centres.plan import Centres
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
    numbers = [*_numbers(made, corners, on.heights.number)]
    strokes: list[Ink] = []
    for one in made.centres:
        pen = "main" if one.way in (PIN, GUIDE, WHEEL) else "thin"
        strokes.append(line(pen, *(corners[k] for k in one.links)))
    size, labels = on.heights.point, []
    for link, at in corners.items():
        strokes.append(circle("main", at, 1.1, filled=True))
        out = at * (1.0 + (0.9 * size + 1.5) / radius)
        labels.append(Label(str(link), out - 0.5j * size, size, "middle"))
    title = on.title
    return Drawing("centres-polygon", title, tuple(added(strokes, "polygon")), (*labels, *numbers))


def _numbers(made: Centres, corners: dict[int, complex], size: float) -> Iterator[Label]:
    """The numbers of the sides, each beside its own where no other side and no number is near."""
    sides = [tuple(corners[k] for k in one.links) for one in made.centres]
    taken: list[complex] = []
    for number, (a, b) in enumerate(sides, 1):
        others = [side for side in sides if side != (a, b)]
        at = max(_places(a, b, size), key=lambda z: _clear(z, others, taken, size))
        taken.append(at)
        yield Label(str(number), at - 0.5j * size, size, "middle")


def _places(a: complex, b: complex, size: float) -> Iterator[complex]:
    across = 1j * (b - a) / abs(b - a)
    for share in SHARES:
        for side in (1.0, -1.0):
            yield a + share * (b - a) + side * 0.85 * size * across


def _clear(
    at: complex, sides: list[tuple[complex, ...]], taken: list[complex], size: float
) -> float:
    """Return how far a place is from other sides and numbers, as far as that matters."""
    lines = min((_distance(at, *side) for side in sides), default=np.inf)
    numbers = min((abs(at - other) for other in taken), default=np.inf) / 2.2
    return round(min(lines, numbers, 1.1 * size), 6)


def _distance(at: complex, a: complex, b: complex) -> float:
    way = (at - a) / (b - a)
    return abs(at - a - min(max(way.real, 0.0), 1.0) * (b - a))
