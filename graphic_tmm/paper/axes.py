"""Axes of a diagram that stands by itself, and its letters."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.paper.drawing import Bezier, Drawing, Label, Stroke, Wanted, circle, line
from graphic_tmm.paper.labels import interrupt, leaders, place
from graphic_tmm.paper.symbols.kinematic import arrowhead

OVER = 9.0
"""How far an axis goes on behind what stands on it, mm."""
DOT = 0.5
"""Radius of a point, mm."""


ASIDE = 14.0
"""From the axis of the ordinates to a dimension line, mm."""


ROOM = 8.0
"""Room for letters about it before they have their places, mm; chosen by eye."""


def axes(left: float, right: float, low: float, high: float) -> list[Stroke]:
    """Return thin axes with arrowheads, from ``left`` and ``low`` to `OVER` mm behind ``right``, ``high``."""
    tips = complex(right + OVER, 0), complex(0, high + OVER)
    return [
        line("thin", complex(left, 0), tips[0]),
        line("thin", complex(0, low), tips[1]),
        *arrowhead(tips[0], 1 + 0j, pen="thin"),
        *arrowhead(tips[1], 1j, pen="thin"),
    ]


def finished(
    name: str,
    title: str,
    strokes: Sequence[Stroke | Bezier],
    wanted: Sequence[Wanted],
    lettered: bool,
    cell: tuple[float, float, float, float],
    figures: Sequence[Label] = (),
) -> Drawing:
    """Return a diagram with its letters placed; not ``lettered``: only the room that it will take."""
    if not lettered:
        left, low, right, high = cell
        room = (left - ROOM, low - ROOM, right + OVER + ROOM, high + OVER + ROOM)
        return Drawing(name, title, tuple(strokes), cell=room)
    labels = place(wanted, strokes, figures)
    ink = interrupt([*strokes, *leaders(wanted, labels)], labels)
    return Drawing(name, title, ink, (*labels, *figures))


def largest(values: Reals) -> float:
    """Return the largest of the values that are there, at least 0."""
    return float(np.max(values, initial=0.0, where=np.isfinite(values)))


SIZE = 5.0
"""Sizes of lettering, mm (ГОСТ 2.304)."""


NUMBER = 3.5
"""Sizes of lettering, mm (ГОСТ 2.304)."""


class Spots:
    """The numbers of the log while they are inked: the first ``row`` positions."""

    def __init__(self, construction: Construction, reading: Reading, row: int) -> None:
        self.construction, self.reading, self.row = construction, reading, row

    def all(self, mark: Mark) -> Complexes:
        """Return a mark at the positions of the row, (row,)."""
        return np.broadcast_to(self.reading[mark][0], (self.reading.positions,))[: self.row]

    def one(self, mark: Mark) -> complex:
        """Return a mark that is one place."""
        return complex(self.reading[mark][0, 0])

    def curve(self, mark: Mark) -> Iterator[Bezier]:
        """Yield a curve as cubic arcs in the main pen."""
        for controls in bezier(self.reading[mark]):
            yield Bezier("main", tuple(complex(z) for z in controls), mark.name)

    def dots(self, mark: Mark) -> Iterator[Stroke]:
        """Yield a point at each position at which the mark is there."""
        for z in self.all(mark):
            if np.isfinite(z):
                yield circle("main", complex(z), DOT, filled=True)

    def lines(self, starts: Complexes, ends: Complexes) -> Iterator[Stroke]:
        """Yield thin lines between two rows of places, but for those too short to see."""
        for a, b in zip(starts, ends, strict=True):
            if np.isfinite(a) and np.isfinite(b) and abs(b - a) > 0.3:
                yield line("thin", complex(a), complex(b))
