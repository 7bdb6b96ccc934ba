"""How far a guide is used: where on it the stone stands over the whole turn of the crank, real lengths."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction, Figure
from graphic_tmm.chapters.kinematics.figures import rigid
from graphic_tmm.chapters.kinematics.survey import Survey
from graphic_tmm.paper.arithmetic import extremes
from graphic_tmm.paper.traced import value_at

VIEW = "positions"


class Reach(NamedTuple):
    """The part of a guide that is used: along it, from its link's point of number ``anchor`` on, m or mm."""

    anchor: int
    low: float
    high: float

    def times(self, factor: float) -> Reach:
        """Return the reach in another unit of length."""
        return Reach(self.anchor, self.low * factor, self.high * factor)

    def longer(self, by: float) -> Reach:
        """Return the reach, longer at both ends."""
        return Reach(self.anchor, self.low - by, self.high + by)

    def near(self, part: Reach, room: float) -> Reach:
        """Return the reach, or ``part`` of it where the whole goes too far beyond: by ``room``, or half of it.

        Where two guides become parallel the stone goes to infinity, and no sheet holds its path.
        """
        room = max(room, (part.high - part.low) / 2)
        low = self.low if self.low >= part.low - room else part.low
        high = self.high if self.high <= part.high + room else part.high
        return Reach(self.anchor, min(low, part.low), max(high, part.high))


def guides(construction: Construction) -> tuple[Figure, ...]:
    """Return the guides of the plan of positions in the order in which they were told."""
    return tuple(f for f in construction.figures if f.view == VIEW and f.kind == "guide")


def reaches(survey: Survey, ends: tuple[float, float] | None) -> tuple[Reach, ...]:
    """Return how far every guide of `guides` is used (m), over a turn or between the ends of a row."""
    log = survey.construction
    found = guides(log)
    wanted = [mark for guide in found for mark in (*guide.marks, *rigid(log.figures, guide.name))]
    if not found:
        return ()
    reading = survey.whole(wanted, ends)[1]
    return tuple(reach_of(log, reading, guide) for guide in found)


def reach_of(
    log: Construction,
    reading: Reading,
    guide: Figure,
    anchor: int | None = None,
    index: int | None = None,
) -> Reach:
    """Return the reach of a guide over the positions of a reading that can be drawn, mm of the drawing.

    ``anchor``: the point it is told from; the one nearest to the guide if it is left out; ``index``: the only
    position, if not all.
    """
    at, line, *side = guide.marks
    way = reading[line].along * (reading[side[0]] if side else 1.0)
    stone = reading[at]
    own = [(stone - reading[mark]) * np.conj(way) for mark in rigid(log.figures, guide.name)]
    defined = np.isfinite(sum(own))[0]
    there = np.flatnonzero(defined)
    if index is not None:
        there = there[there == min(index, defined.size - 1)]
    if not there.size:
        return Reach(anchor or 0, 0.0, 0.0)
    first = int(there[0])
    if anchor is None:
        anchor = min(range(len(own)), key=lambda k: abs(complex(value_at(own[k], first)).imag))
    return Reach(anchor, *extremes(own[anchor], [int(k) for k in there]))
