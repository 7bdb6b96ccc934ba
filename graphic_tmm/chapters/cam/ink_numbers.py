"""What the views of a cam are inked with: its numbers, lines between points, grouped numbers of positions."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Complexes
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.paper.drawing import Bezier, Drawing, Ink, Label, Wanted, circle, line
from graphic_tmm.paper.labels import interrupt, leaders, place
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.symbols.kinematic import arrowhead

OVER = 9.0
"""How far an axis goes on behind what stands on it, mm."""
DOT, LEAST = 0.4, 0.3
"""Radius of a point, the shortest line that is drawn, mm."""
ROOM = 10.0
"""Room for letters about it before they have their places, mm; chosen by eye."""
SIZE, SMALL, NUMBER = 5.0, 3.5, 2.5
"""Sizes of lettering, mm (ГОСТ 2.304)."""


class Numbers:
    """The numbers of a cam's log while it is inked."""

    def __init__(self, reading: Reading, cam: Cam) -> None:
        self.reading, self.cam = reading, cam

    def all(self, mark: Mark) -> Complexes:
        """The places of a point in all positions."""
        return np.broadcast_to(self.reading[mark][0], (self.cam.diagrams.turn.positions,))

    def one(self, mark: Mark) -> complex:
        """The place of a point that does not vary."""
        return complex(self.reading[mark][0, 0])

    def length(self, mark: Mark) -> float:
        """A number or a length that does not vary."""
        return float(self.reading[mark][0, 0])

    def curve(self, mark: Mark, pen: str = "main") -> list[Ink]:
        """A curve as it was drawn."""
        runs = bezier(self.reading[mark])
        return [Bezier(pen, tuple(complex(z) for z in run), mark.name) for run in runs]

    def dots(self, spots: Complexes) -> list[Ink]:
        """Points of a curve."""
        return [circle("main", complex(z), DOT, filled=True) for z in spots if np.isfinite(z)]


def directions(spots: Complexes) -> Complexes:
    """Return the directions of complex numbers; NaN where there is none."""
    size = np.abs(spots)
    there = size > 0.0
    return np.asarray(np.where(there, spots / np.where(there, size, 1.0), np.nan))


def segments(starts: Complexes, ends: Complexes, pen: str = "thin") -> list[Ink]:
    """Return the lines between points that are both there, and apart."""
    rows = np.broadcast_arrays(starts, ends)
    return [
        line(pen, complex(a), complex(b))
        for a, b in zip(*rows, strict=True)
        if np.isfinite(a) and np.isfinite(b) and abs(b - a) > LEAST
    ]


def arrow_axis(start: complex, end: complex) -> list[Ink]:
    """Return an axis with its arrow at ``end``."""
    return [line("thin", start, end), *arrowhead(end, end - start, pen="thin")]


def finished(
    name: str,
    title: str,
    strokes: Sequence[Ink],
    wanted: Sequence[Wanted],
    figures: Sequence[Label],
    lettered: bool,
) -> Drawing:
    """Return a drawing with its letters in their places, or, unlettered, with room for them."""
    if not lettered:
        bare = Drawing(name, title, tuple(strokes), tuple(figures))
        left, low, right, high = bounds(bare)
        return bare._replace(cell=(left - ROOM, low - ROOM, right + ROOM, high + ROOM))
    labels = place(wanted, strokes, figures)
    ready = interrupt([*strokes, *leaders(wanted, labels)], [*labels, *figures])
    return Drawing(name, title, ready, (*labels, *figures))


def numbered(
    names: Sequence[str], spots: Complexes, toward: Complexes, *, radius: float = 0.8
) -> list[Wanted]:
    """Return the numbers of positions at their points; positions that coincide share one label."""
    groups: list[tuple[complex, complex, list[str]]] = []
    for name, spot, way in zip(names, spots, np.broadcast_to(toward, spots.shape), strict=True):
        if not np.isfinite(spot):
            continue
        near = next((texts for z, _, texts in groups if abs(z - spot) < 1.0), None)
        if near is None:
            groups.append((complex(spot), complex(way), [name]))
        else:
            near.append(name)
    return [Wanted(", ".join(texts), z, NUMBER, radius, way) for z, way, texts in groups]
